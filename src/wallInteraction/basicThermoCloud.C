/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.

Description
    Registers our cloud function objects for basicThermoCloud.
\*---------------------------------------------------------------------------*/

#include "basicThermoCloud.H"
#include "DispersedPhase.H"
#include "ImpactRecords.H"
#include "SurfaceImpact.H"

makeCloudFunctionObjectType(DispersedPhase, basicThermoCloud);
makeCloudFunctionObjectType(ImpactRecords, basicThermoCloud);
makeCloudFunctionObjectType(SurfaceImpact, basicThermoCloud);
