/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.

Description
    Makes basicKinematicCollidingCloud selectable in constant/parcelClouds.
\*---------------------------------------------------------------------------*/

#include "basicKinematicCollidingCloud.H"
#include "kinematicParcelCloud.H"

makeKinematicParcelCloud(basicKinematicCollidingCloud);
