/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.

Description
    Registers our cloud function objects for basicReactingMultiphaseCloud.
\*---------------------------------------------------------------------------*/

#include "basicReactingMultiphaseCloud.H"
#include "DispersedPhase.H"
#include "ImpactRecords.H"
#include "SurfaceImpact.H"

makeCloudFunctionObjectType(DispersedPhase, basicReactingMultiphaseCloud);
makeCloudFunctionObjectType(ImpactRecords, basicReactingMultiphaseCloud);
makeCloudFunctionObjectType(SurfaceImpact, basicReactingMultiphaseCloud);
