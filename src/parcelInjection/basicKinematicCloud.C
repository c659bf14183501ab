/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.

Description
    Registers our injection models for basicKinematicCloud.
\*---------------------------------------------------------------------------*/

#include "basicKinematicCloud.H"
#include "CrossSectionInjection.H"
#include "RakeInjection.H"

makeInjectionModelType(CrossSectionInjection, basicKinematicCloud);
makeInjectionModelType(RakeInjection, basicKinematicCloud);
