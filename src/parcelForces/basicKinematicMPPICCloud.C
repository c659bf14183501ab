/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.

Description
    Registers our drag forces for basicKinematicMPPICCloud.
\*---------------------------------------------------------------------------*/

#include "basicKinematicMPPICCloud.H"
#include "dragForces.H"

makeParcelDragForces(basicKinematicMPPICCloud);
