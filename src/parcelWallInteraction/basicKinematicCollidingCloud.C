/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.

Description
    Registers our cloud function objects and wall models for
    basicKinematicCollidingCloud.
\*---------------------------------------------------------------------------*/

#include "basicKinematicCollidingCloud.H"
#include "parcelWallFunctions.H"
#include "parcelWallModels.H"

makeParcelWallFunctions(basicKinematicCollidingCloud);
makeParcelWallModels(basicKinematicCollidingCloud);
