/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.

Description
    Registers our injection models for basicKinematicCollidingCloud.
\*---------------------------------------------------------------------------*/

#include "basicKinematicCollidingCloud.H"
#include "CrossSectionInjection.H"
#include "RakeInjection.H"

makeInjectionModelType(CrossSectionInjection, basicKinematicCollidingCloud);
makeInjectionModelType(RakeInjection, basicKinematicCollidingCloud);
