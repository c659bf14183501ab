/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.

Description
    Registers the stock particle forces and ours for basicSpinningCloud.
\*---------------------------------------------------------------------------*/

#include "basicSpinningCloud.H"
#include "MagnusForce.H"
#include "dragForces.H"
#include "makeParcelForces.H"

makeParcelForces(basicSpinningCloud);
makeParcelDragForces(basicSpinningCloud);
makeParticleForceModelType(MagnusForce, basicSpinningCloud);
