/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.

Description
    Makes basicKinematicCloud selectable in constant/parcelClouds.
\*---------------------------------------------------------------------------*/

#include "basicKinematicCloud.H"
#include "kinematicParcelCloud.H"

makeKinematicParcelCloud(basicKinematicCloud);
