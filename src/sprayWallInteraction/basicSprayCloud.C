/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.

Description
    Registers our cloud function objects and wall models for basicSprayCloud.
    A library of its own: others need not load that of the sprays.
\*---------------------------------------------------------------------------*/

#include "basicSprayCloud.H"
#include "parcelWallFunctions.H"
#include "parcelWallModels.H"

makeParcelWallFunctions(basicSprayCloud);
makeParcelWallModels(basicSprayCloud);
