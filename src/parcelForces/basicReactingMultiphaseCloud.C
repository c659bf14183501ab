/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.

Description
    Registers our particle forces for basicReactingMultiphaseCloud.
\*---------------------------------------------------------------------------*/

#include "basicReactingMultiphaseCloud.H"
#include "HendersonDragForce.H"

makeParticleForceModelType(HendersonDragForce, basicReactingMultiphaseCloud);
