/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.

Description
    Registers our cloud function objects and wall models for
    basicReactingMultiphaseCloud.
\*---------------------------------------------------------------------------*/

#include "basicReactingMultiphaseCloud.H"
#include "ImpactRecords.H"
#include "parcelWallModels.H"

makeCloudFunctionObjectType(ImpactRecords, basicReactingMultiphaseCloud);
makeParcelWallModels(basicReactingMultiphaseCloud);
