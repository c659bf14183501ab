/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.

Description
    Registers our drag forces for basicSprayCloud. A library of its own:
    others need not load that of the sprays.
\*---------------------------------------------------------------------------*/

#include "basicSprayCloud.H"
#include "dragForces.H"

makeParcelDragForces(basicSprayCloud);
