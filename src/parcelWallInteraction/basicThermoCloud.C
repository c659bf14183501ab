/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.

Description
    Registers our cloud function objects and wall models for
    basicThermoCloud.
\*---------------------------------------------------------------------------*/

#include "basicThermoCloud.H"
#include "parcelWallFunctions.H"
#include "parcelWallModels.H"

makeParcelWallFunctions(basicThermoCloud);
makeParcelWallModels(basicThermoCloud);
