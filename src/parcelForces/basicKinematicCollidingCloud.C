/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.

Description
    Registers our drag forces for basicKinematicCollidingCloud.
\*---------------------------------------------------------------------------*/

#include "basicKinematicCollidingCloud.H"
#include "dragForces.H"

makeParcelDragForces(basicKinematicCollidingCloud);
