/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.

Description
    Registers the stock particle forces and ours for basicSpinningCloud.
\*---------------------------------------------------------------------------*/

#include "basicSpinningCloud.H"
#include "HendersonDragForce.H"
#include "MagnusForce.H"
#include "makeParcelForces.H"

makeParcelForces(basicSpinningCloud);
makeParticleForceModelType(HendersonDragForce, basicSpinningCloud);
makeParticleForceModelType(MagnusForce, basicSpinningCloud);
