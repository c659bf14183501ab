/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.

Description
    Registers our cloud function objects for basicReactingCloud.
\*---------------------------------------------------------------------------*/

#include "basicReactingCloud.H"
#include "DispersedPhase.H"
#include "ImpactRecords.H"
#include "SurfaceImpact.H"

makeCloudFunctionObjectType(DispersedPhase, basicReactingCloud);
makeCloudFunctionObjectType(ImpactRecords, basicReactingCloud);
makeCloudFunctionObjectType(SurfaceImpact, basicReactingCloud);
