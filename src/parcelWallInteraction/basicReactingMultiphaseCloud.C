/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.

Description
    Registers our cloud function objects and wall models for
    basicReactingMultiphaseCloud.
\*---------------------------------------------------------------------------*/

#include "basicReactingMultiphaseCloud.H"
#include "parcelWallFunctions.H"
#include "parcelWallModels.H"

makeParcelWallFunctions(basicReactingMultiphaseCloud);
makeParcelWallModels(basicReactingMultiphaseCloud);
