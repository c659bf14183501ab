/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.

Description
    Registers our particle forces for basicThermoCloud.
\*---------------------------------------------------------------------------*/

#include "basicThermoCloud.H"
#include "HendersonDragForce.H"

makeParticleForceModelType(HendersonDragForce, basicThermoCloud);
