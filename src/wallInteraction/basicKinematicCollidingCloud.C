/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.

Description
    Registers our cloud function objects for basicKinematicCollidingCloud.
\*---------------------------------------------------------------------------*/

#include "basicKinematicCollidingCloud.H"
#include "ImpactRecords.H"

makeCloudFunctionObjectType(ImpactRecords, basicKinematicCollidingCloud);
