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


Foam::scalar Foam::gasEquations::relaxTurbulence()
{
    publish();
    const std::vector<double> before(eddyViscosity_);
    turbulence_.correct(false);
    turbulence_.take(eddyViscosity_, eddyDiffusivity_);

    scalar largest = 0;
    for (label c = 0; c < geometry_.nCells(); c++)
    {
        const double mu =
            eos_.viscosity(primitive[c*nVar_ + 1])
          + max(eddyViscosity_[c], before[c]);
        largest = max(largest, mag(eddyViscosity_[c] - before[c])/mu);
    }
    return returnReduce(largest, maxOp<scalar>());
}


void Foam::gasEquations::correctTurbulence()
{
    turbulence_.correct();
    if (turbulent())
    {
        turbulence_.take(eddyViscosity_, eddyDiffusivity_);
    }
}
