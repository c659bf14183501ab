/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "steadySolution.H"
#include "ImplicitGaussSeidel.H"
#include "RungeKutta.H"

Foam::steadySolution::steadySolution
(
    gasEquations& equations,
    const settings& s
)
:
    equations_(equations),
    settings_(s),
    imbalance_(GREAT),
    iterations_(0)
{}


bool Foam::steadySolution::solve()
{
    Info<< "Gas: marching to a steady state" << endl;

    // Four symmetric sweeps: more buy fewer steps, but not fewer operations
    ImplicitGaussSeidel implicit(equations_, 4);
    RungeKutta march(equations_, settings_.stages);

    // An impulsive start needs the first steps to be short. Where the march
    // makes no headway, the steps are too long for the approximations of its
    // left-hand side, and are halved.
    const label patience = settings_.implicit ? 200 : 2000;
    scalar largestCo = settings_.maxCo;
    scalar Co = min(scalar(1), settings_.maxCo);
    scalar best = GREAT;
    label bestIteration = 0;
    label setbacks = 0;

    imbalance_ = GREAT;
    iterations_ = 0;

    while
    (
        iterations_ < settings_.maxIterations
     && imbalance_ > settings_.residual
    )
    {
        if (settings_.implicit)
        {
            Co = min(largestCo, implicit.localStep(Co) ? 1.1*Co : 0.5*Co);
            if (Co < 1e-3*min(settings_.maxCo, scalar(1)))
            {
                equations_.reportTrouble();
            }
        }
        else
        {
            march.localStep(settings_.maxCo);
        }
        iterations_++;

        imbalance_ = equations_.imbalance();
        if (imbalance_ < 0.7*best)
        {
            best = imbalance_;
            bestIteration = iterations_;
        }
        else if (iterations_ - bestIteration >= patience)
        {
            setbacks++;
            if (setbacks == 3)
            {
                // What was held before may bear the marks of the unrest
                Info<< "Gas: taking the shocks to first order, so that they"
                    << " come to rest" << endl;
                equations_.roughenShocks();
                equations_.holdShocks(false);
            }
            else
            {
                equations_.holdShocks(true);
            }
            largestCo = max
            (
                min(settings_.maxCo, scalar(1)),
                0.5*min(Co, largestCo)
            );
            bestIteration = iterations_;
        }
        if (iterations_ % settings_.reportEvery == 0)
        {
            Info<< "Gas: iteration " << iterations_ << ", imbalance "
                << imbalance_;
            if (settings_.implicit)
            {
                Info<< ", Courant number " << Co;
            }
            Info<< endl;
        }
    }

    if (imbalance_ > settings_.residual)
    {
        WarningInFunction
            << "The gas is not steady after " << iterations_
            << " iterations: imbalance " << imbalance_
            << ", wanted " << settings_.residual << endl;
    }
    else
    {
        Info<< "Gas: steady after " << iterations_
            << " iterations, imbalance " << imbalance_ << endl;
    }

    return imbalance_ <= settings_.residual;
}
