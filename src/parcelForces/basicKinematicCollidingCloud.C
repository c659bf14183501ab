/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.

Description
    Registers our particle forces for basicKinematicCollidingCloud.
\*---------------------------------------------------------------------------*/

#include "basicKinematicCollidingCloud.H"
#include "HendersonDragForce.H"

makeParticleForceModelType(HendersonDragForce, basicKinematicCollidingCloud);
