/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.

Description
    Registers our drag forces for basicKinematicCloud.
\*---------------------------------------------------------------------------*/

#include "basicKinematicCloud.H"
#include "dragForces.H"

makeParcelDragForces(basicKinematicCloud);
