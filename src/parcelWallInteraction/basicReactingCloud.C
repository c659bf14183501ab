/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.

Description
    Registers our cloud function objects and wall models for
    basicReactingCloud.
\*---------------------------------------------------------------------------*/

#include "basicReactingCloud.H"
#include "parcelWallFunctions.H"
#include "parcelWallModels.H"

makeParcelWallFunctions(basicReactingCloud);
makeParcelWallModels(basicReactingCloud);
