/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.

Description
    Registers our drag forces for basicReactingMultiphaseCloud.
\*---------------------------------------------------------------------------*/

#include "basicReactingMultiphaseCloud.H"
#include "dragForces.H"

makeParcelDragForces(basicReactingMultiphaseCloud);
