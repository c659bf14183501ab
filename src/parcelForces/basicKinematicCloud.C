/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.

Description
    Registers our particle forces for basicKinematicCloud.
\*---------------------------------------------------------------------------*/

#include "basicKinematicCloud.H"
#include "HendersonDragForce.H"

makeParticleForceModelType(HendersonDragForce, basicKinematicCloud);
