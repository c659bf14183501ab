/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.

Description
    Registers our drag forces for basicReactingCloud.
\*---------------------------------------------------------------------------*/

#include "basicReactingCloud.H"
#include "dragForces.H"

makeParcelDragForces(basicReactingCloud);
