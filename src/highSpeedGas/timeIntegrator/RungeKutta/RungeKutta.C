/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "RungeKutta.H"

Foam::RungeKutta::RungeKutta(gasEquations& gas, const int stages)
:
    gas_(gas),
    stages_(stages),
    next_(gas.conserved.size()),
    step_(gas.geometry().nCells()),
    deltaT_(0)
{}


void Foam::RungeKutta::stage(const double share)
{
    const int nVar = gas_.nVar();
    const label nCells = gas_.geometry().nCells();
    const double* __restrict volume = gas_.geometry().volume.data();
    const double* __restrict rate = gas_.rate.data();
    const double* __restrict present = gas_.conserved.data();

    for (label c = 0; c < nCells; c++)
    {
        const double s = step_[c]/volume[c];
        for (int k = 0; k < nVar; k++)
        {
            const label i = c*nVar + k;
            next_[i] =
                share*old_[i] + (1 - share)*(present[i] + s*rate[i]);
        }
    }
}


bool Foam::RungeKutta::attempt()
{
    // Shares of the old state in each stage
    static const double shares[3][3] =
    {
        {0, 0, 0}, {0, 0.5, 0}, {0, 0.75, 1.0/3}
    };

    old_ = gas_.conserved;
    if (stepMass_.valid())
    {
        stepMass_() == dimensionedScalar(dimMass, Zero);
    }

    for (int k = 0; k < stages_; k++)
    {
        bool accepted = false;

        // Each repetition takes more cells to the robust flux
        for (int repeat = 0; repeat < 4 && !accepted; repeat++)
        {
            gas_.computeRate();
            stage(shares[stages_ - 1][k]);
            accepted = gas_.accept(next_) == 0;
        }

        if (!accepted)
        {
            gas_.conserved = old_;
            gas_.restore(old_);
            gas_.correctBoundary();
            return false;
        }

        if (stepMass_.valid())
        {
            const dimensionedScalar dt("dt", dimTime, deltaT_);
            const scalar share = 1 - shares[stages_ - 1][k];
            stepMass_() == share*(stepMass_() + dt*gas_.massFlux());
        }
        gas_.conserved.swap(next_);
        gas_.correctBoundary();
    }

    return true;
}


Foam::scalar Foam::RungeKutta::stableStep(const scalar Co)
{
    gas_.spectralRadius(lambda_);
    scalar largest = GREAT;
    for (label c = 0; c < gas_.geometry().nCells(); c++)
    {
        largest = min(largest, 2*gas_.geometry().volume[c]/lambda_[c]);
    }
    return Co*returnReduce(largest, minOp<scalar>());
}


Foam::scalar Foam::RungeKutta::centralStep(const scalar Co)
{
    gas_.centralRadius(lambda_);
    scalar largest = GREAT;
    for (label c = 0; c < gas_.geometry().nCells(); c++)
    {
        largest = min(largest, 2*gas_.geometry().volume[c]/lambda_[c]);
    }
    return Co*returnReduce(largest, minOp<scalar>());
}


Foam::label Foam::RungeKutta::advance
(
    const scalar deltaT,
    const scalar maxCo
)
{
    scalar left = deltaT;
    label nSteps = 0;
    scalar caution = 1;

    if (gas_.turbulent())
    {
        if (!mass_.valid())
        {
            const dimensionedScalar dt("dt", dimTime, deltaT);
            mass_.reset(new surfaceScalarField("mass", dt*gas_.massFlux()));
            stepMass_.reset(new surfaceScalarField("stepMass", mass_()));
        }
        mass_() == dimensionedScalar(dimMass, Zero);
    }

    while (left > 0)
    {
        const scalar stable = caution*stableStep(maxCo);

        // Time lengthens a step by up to 1 % to meet a write time
        const scalar n = max(scalar(1), ceil(left/stable - 0.02));
        const scalar dt = n > 1 ? left/n : left;

        std::fill(step_.begin(), step_.end(), dt);
        deltaT_ = dt;
        if (attempt())
        {
            if (mass_.valid())
            {
                mass_() == mass_() + stepMass_();
            }
            left = n > 1 ? left - dt : 0;
            caution = min(1.0, 2*caution);
            nSteps++;
        }
        else
        {
            caution *= 0.5;
            if (caution < 1e-6)
            {
                gas_.reportInvalidCells();
            }
        }
        gas_.calm();
    }

    if (mass_.valid())
    {
        gas_.massFlux() == mass_()/dimensionedScalar("dt", dimTime, deltaT);
    }
    return nSteps;
}


void Foam::RungeKutta::localStep(const scalar Co)
{
    gas_.spectralRadius(lambda_);
    scalar caution = 1;

    do
    {
        for (label c = 0; c < gas_.geometry().nCells(); c++)
        {
            step_[c] = caution*Co*2*gas_.geometry().volume[c]/lambda_[c];
        }
        if (attempt())
        {
            break;
        }
        caution *= 0.5;
        if (caution < 1e-6)
        {
            gas_.reportInvalidCells();
        }
    }
    while (true);

    gas_.calm();
}
