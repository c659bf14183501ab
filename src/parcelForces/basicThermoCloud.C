/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.

Description
    Registers our drag forces for basicThermoCloud.
\*---------------------------------------------------------------------------*/

#include "basicThermoCloud.H"
#include "dragForces.H"

makeParcelDragForces(basicThermoCloud);
