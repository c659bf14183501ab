/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.

Description
    Registers the stock patch interaction, dispersion, stochastic collision
    and surface film models, and our wall models, for basicSpinningCloud.
\*---------------------------------------------------------------------------*/

#include "basicSpinningCloud.H"
#include "NoDispersion.H"
#include "makeParcelPatchInteractionModels.H"
#include "makeParcelStochasticCollisionModels.H"
#include "makeParcelSurfaceFilmModels.H"
#include "noPackingModels.H"
#include "parcelWallModels.H"
#include "StochasticDispersion.H"

makeDispersionModel(basicSpinningCloud);
makeDispersionModelType(NoDispersion, basicSpinningCloud);
makeDispersionModelType(StochasticDispersion, basicSpinningCloud);
makeParcelPatchInteractionModels(basicSpinningCloud);
makeParcelStochasticCollisionModels(basicSpinningCloud);
makeParcelSurfaceFilmModels(basicSpinningCloud);
makeNoPackingModels(basicSpinningCloud);
makeParcelWallModels(basicSpinningCloud);
