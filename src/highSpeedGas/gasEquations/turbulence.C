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

    // On the way to a steady state a model can find eddies where there is no
    // flow yet: k and epsilon that both fall towards zero leave any quotient.
    // No flow has a hundred thousand times the viscosity; as long as some cell
    // would, the gas is not steady.
    scalar largest = 0;
    for (label s = 0; s < geometry_.nSlots(); s++)
    {
        const double mu = eos_.viscosity(primitive[s*nVar_ + 1]);
        const double most = 1e5*mu;
        if (eddyViscosity_[s] > most)
        {
            eddyDiffusivity_[s] *= most/eddyViscosity_[s];
            eddyViscosity_[s] = most;
            largest = 1;
        }
        else if (s < geometry_.nCells())
        {
            const double sum = mu + max(eddyViscosity_[s], before[s]);
            largest = max(largest, mag(eddyViscosity_[s] - before[s])/sum);
        }
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
