/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.

Description
    Registers our cloud function objects for basicKinematicMPPICCloud.
\*---------------------------------------------------------------------------*/

#include "basicKinematicMPPICCloud.H"
#include "DispersedPhase.H"
#include "ImpactRecords.H"
#include "SurfaceImpact.H"

makeCloudFunctionObjectType(DispersedPhase, basicKinematicMPPICCloud);
makeCloudFunctionObjectType(ImpactRecords, basicKinematicMPPICCloud);
makeCloudFunctionObjectType(SurfaceImpact, basicKinematicMPPICCloud);
