/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "gasEquations.H"

void Foam::gasEquations::validateTurbulence()
{
    turbulence_.validate();
    if (turbulent())
    {
        turbulence_.take(eddyViscosity_, eddyDiffusivity_);
    }
}


void Foam::gasEquations::correctTurbulence()
{
    turbulence_.correct();
    if (turbulent())
    {
        turbulence_.take(eddyViscosity_, eddyDiffusivity_);
    }
}
