/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.

Description
    Registers our cloud function objects for basicReactingCloud.
\*---------------------------------------------------------------------------*/

#include "basicReactingCloud.H"
#include "ImpactRecords.H"

makeCloudFunctionObjectType(ImpactRecords, basicReactingCloud);
