/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.

Description
    Registers our cloud function objects and wall models for
    basicKinematicCollidingCloud.
\*---------------------------------------------------------------------------*/

#include "basicKinematicCollidingCloud.H"
#include "ImpactRecords.H"
#include "parcelWallModels.H"

makeCloudFunctionObjectType(ImpactRecords, basicKinematicCollidingCloud);
makeParcelWallModels(basicKinematicCollidingCloud);
