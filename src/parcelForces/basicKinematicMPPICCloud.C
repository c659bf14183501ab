/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.

Description
    Registers our particle forces for basicKinematicMPPICCloud.
\*---------------------------------------------------------------------------*/

#include "basicKinematicMPPICCloud.H"
#include "HendersonDragForce.H"

makeParticleForceModelType(HendersonDragForce, basicKinematicMPPICCloud);
