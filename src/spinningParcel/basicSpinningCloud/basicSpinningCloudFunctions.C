/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.

Description
    Registers the stock cloud functions and ours for basicSpinningCloud.
\*---------------------------------------------------------------------------*/

#include "basicSpinningCloud.H"
#include "makeParcelCloudFunctionObjects.H"
#include "parcelWallFunctions.H"

makeParcelCloudFunctionObjects(basicSpinningCloud);
makeParcelWallFunctions(basicSpinningCloud);
