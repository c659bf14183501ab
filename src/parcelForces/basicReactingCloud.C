/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.

Description
    Registers our particle forces for basicReactingCloud.
\*---------------------------------------------------------------------------*/

#include "basicReactingCloud.H"
#include "HendersonDragForce.H"

makeParticleForceModelType(HendersonDragForce, basicReactingCloud);
