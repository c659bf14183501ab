/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.

Description
    Registers our cloud function objects and wall models for
    basicKinematicMPPICCloud.
\*---------------------------------------------------------------------------*/

#include "basicKinematicMPPICCloud.H"
#include "parcelWallFunctions.H"
#include "parcelWallModels.H"

makeParcelWallFunctions(basicKinematicMPPICCloud);
makeParcelWallModels(basicKinematicMPPICCloud);
