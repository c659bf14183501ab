/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.

Description
    Makes the cloud of spinning parcels selectable in constant/parcelClouds.
\*---------------------------------------------------------------------------*/

#include "basicSpinningCloud.H"
#include "Cloud.H"
#include "kinematicParcelCloud.H"

namespace Foam
{
    defineTemplateTypeNameAndDebug(Cloud<basicSpinningParcel>, 0);
}

makeKinematicParcelCloud(spinningKinematicCloud);
