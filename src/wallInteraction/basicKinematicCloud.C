/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.

Description
    Registers our cloud function objects for basicKinematicCloud.
\*---------------------------------------------------------------------------*/

#include "basicKinematicCloud.H"
#include "DispersedPhase.H"
#include "ImpactRecords.H"
#include "SurfaceImpact.H"

makeCloudFunctionObjectType(DispersedPhase, basicKinematicCloud);
makeCloudFunctionObjectType(ImpactRecords, basicKinematicCloud);
makeCloudFunctionObjectType(SurfaceImpact, basicKinematicCloud);
