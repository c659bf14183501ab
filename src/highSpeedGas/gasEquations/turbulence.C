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
    // flow yet: k and epsilon that both fall towards zero leave any quotient
    const scalar size = 0.1*mesh_.bounds().mag();
    std::vector<double> a;
    soundSpeed(a);
    scalar largest = 0;
    nCutEddies_ = 0;
    for (label s = 0; s < geometry_.nSlots(); s++)
    {
        const double p = primitive[s*nVar_];
        const double T = primitive[s*nVar_ + 1];
        const double most = p/(eos_.R*T)*a[s]*size;
        const bool inside = s < geometry_.nCells();
        if (eddyViscosity_[s] > most)
        {
            eddyDiffusivity_[s] *= most/eddyViscosity_[s];
            eddyViscosity_[s] = most;
            largest = 1;
            nCutEddies_ += inside;
        }
        else if (inside)
        {
            const double sum =
                eos_.viscosity(T) + max(eddyViscosity_[s], before[s]);
            largest = max(largest, mag(eddyViscosity_[s] - before[s])/sum);
        }
    }
    reduce(nCutEddies_, sumOp<label>());
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
