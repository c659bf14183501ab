/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.

Description
    Registers the stock injection models and ours for basicSpinningCloud.
\*---------------------------------------------------------------------------*/

#include "basicSpinningCloud.H"
#include "CrossSectionInjection.H"
#include "RakeInjection.H"
#include "makeParcelInjectionModels.H"

makeParcelInjectionModels(basicSpinningCloud);
makeInjectionModelType(CrossSectionInjection, basicSpinningCloud);
makeInjectionModelType(RakeInjection, basicSpinningCloud);
