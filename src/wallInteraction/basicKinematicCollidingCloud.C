/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.

Description
    Registers our cloud function objects for basicKinematicCollidingCloud.
\*---------------------------------------------------------------------------*/

#include "basicKinematicCollidingCloud.H"
#include "DispersedPhase.H"
#include "ImpactRecords.H"
#include "SurfaceImpact.H"

makeCloudFunctionObjectType(DispersedPhase, basicKinematicCollidingCloud);
makeCloudFunctionObjectType(ImpactRecords, basicKinematicCollidingCloud);
makeCloudFunctionObjectType(SurfaceImpact, basicKinematicCollidingCloud);
