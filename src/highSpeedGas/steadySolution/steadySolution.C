/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "steadySolution.H"
#include "ImplicitGaussSeidel.H"
#include "NewtonKrylov.H"
#include "reducedRankExtrapolation.H"
#include "RungeKutta.H"
#include <memory>

Foam::steadySolution::steadySolution
(
    gasEquations& equations,
    const settings& s
)
:
    equations_(equations),
    settings_(s),
    iterations_(0),
    reported_(0),
    eddyChange_(equations.turbulent() ? GREAT : 0)
{}


bool Foam::steadySolution::gasSteady() const
{
    // Small imbalances of many cells of one sign may add up
    return
        imbalance_.value() <= settings_.residual
     && mag(imbalance_.massBalance) <= settings_.residual
     && mag(imbalance_.enthalpyBalance) <= settings_.residual
     && (
            imbalance_.ofWalls() <= maxOfWalls
         || (
                imbalance_.ofWalls() <= mostOfWalls
             && imbalance_.value() <= 1e-3*settings_.residual
            )
        );
}


bool Foam::steadySolution::steady() const
{
    return gasSteady() && eddyChange_ <= settings_.residual;
}


void Foam::steadySolution::iterated()
{
    iterations_++;
    if (equations_.turbulent())
    {
        eddyChange_ = equations_.relaxTurbulence();
    }
}


void Foam::steadySolution::followed(const label nRates)
{
    // Eddies that change once for a step of a hundred rates would have the gas
    // solved anew for each small change of theirs. They are given a share of
    // the time, or what leaves a tenth of their change.
    const label nMost = max(label(1), nRates/5);
    scalar most = 0;
    for (label n = 0; n < nMost && iterations_ < settings_.maxIterations; n++)
    {
        iterated();
        most = max(most, eddyChange_);
        if (eddyChange_ <= max(0.1*most, settings_.residual))
        {
            break;
        }
    }
    if (equations_.turbulent())
    {
        equations_.computeRate();
    }
}


bool Foam::steadySolution::finished()
{
    imbalance_ = equations_.imbalance(settings_.residual);
    if (steady() && equations_.calm())
    {
        // No cell stays at first order
        equations_.computeRate();
        imbalance_ = equations_.imbalance(settings_.residual);
    }
    return steady() || iterations_ >= settings_.maxIterations;
}


void Foam::steadySolution::report(const char* method, const scalar Co) const
{
    if (iterations_/settings_.reportEvery > reported_/settings_.reportEvery)
    {
        // Time enough for a shock of the start to pass, and early enough for a
        // user to stop a run that cannot end well
        const label patience = 1000;
        if (reported_ < patience && iterations_ >= patience)
        {
            equations_.reportShockedInlets(true);
        }
        reported_ = iterations_;
        const label k = imbalance_.worst();
        Info<< "Gas: iteration " << iterations_ << ", " << method
            << ", Courant number " << Co << ", imbalance of " << imbalance_
            << ", most of " << gasImbalance::names[k] << " in the cell at "
            << imbalance_.place[k];
        if (imbalance_.value() <= settings_.residual)
        {
            Info<< ", balance of mass " << imbalance_.massBalance
                << ", of total enthalpy " << imbalance_.enthalpyBalance;
        }
        if (equations_.turbulent())
        {
            Info<< ", change of eddies " << eddyChange_;
        }
        Info<< endl;
    }
}


void Foam::steadySolution::integrateExplicitly()
{
    RungeKutta integrator(equations_, settings_.stages);
    do
    {
        integrator.localStep(settings_.maxCo);
        iterated();
        equations_.computeRate();
        report("explicit", settings_.maxCo);
    }
    while (!finished());
}


void Foam::steadySolution::approach
(
    ImplicitGaussSeidel& implicit,
    const scalar largestCo,
    const scalar until
)
{
    // An impulsive start needs the first steps to be short. The march is left
    // to Newton's method near the steady state, and where it no longer comes
    // nearer.
    const label patience = 50;
    scalar reference = GREAT;
    scalar Co = min(scalar(1), largestCo);
    reducedRankExtrapolation slowModes(equations_);
    label nJudged = 0;

    // Sweeps need all the damping there is
    equations_.muffle(false);

    for (label i = 1; ; i++)
    {
        Co = min(largestCo, implicit.localStep(Co) ? 1.1*Co : 0.5*Co);
        if (Co < 1e-3*min(settings_.maxCo, scalar(1)))
        {
            equations_.reportInvalidCells();
        }
        iterated();

        if (finished())
        {
            return;
        }
        report("Gauss-Seidel", Co);
        if (Co == largestCo)
        {
            slowModes.follow(imbalance_.mean);
        }

        if (imbalance_.value() < until)
        {
            return;
        }
        // (while steps grow there is none to be seen)
        if ((Co == largestCo || i > patience) && nJudged++ % patience == 0)
        {
            if (imbalance_.mean > 0.8*reference)
            {
                return;
            }
            reference = imbalance_.mean;
        }
    }
}


bool Foam::steadySolution::converge(NewtonKrylov& newton)
{
    // A product costs about as much as an iteration of the sweeps, which lead
    // away from a state that is nearly steady. Where the gas waits for its
    // eddies neither method is to blame.
    const label patience = equations_.turbulent() ? 1000 : 500;
    const label maxUnsolved = 4;
    const label maxAlike = 10;
    const scalar firstCo = 10;
    label nUnsolved = 0;
    scalar best = GREAT;
    label bestProducts = newton.nProducts();

    // Near the steady state short steps would lead away from it first
    scalar Co = max(firstCo, min(scalar(1000), 1e-3/imbalance_.mean));
    label nAlike = 0;

    equations_.calm();
    while (Co > 0.01)
    {
        // The eddies may need more time than a gas that is at rest by far
        if (gasSteady() && imbalance_.value() < 0.1*settings_.residual)
        {
            iterated();
            equations_.computeRate();
            if (finished())
            {
                return true;
            }
            report("eddies", Co);
            continue;
        }

        const scalar before = newton.norm();
        const label products = newton.nProducts();

        // A steady state that is none in time is only reached by long steps
        // whose linear equations are solved: with too few vectors the gas
        // wanders before it. Steps no longer than those of the sweeps are not
        // worth as much.
        const scalar share =
            newton.step(Co, Co > settings_.maxCo ? 100 : 60);
        followed(newton.nProducts() - products);
        if (finished())
        {
            return true;
        }
        report("Newton", Co);

        // Where a shock runs across the cells as it likes, one of its modes
        // may hardly decay, and the linear equations are out of reach at the
        // Courant numbers that would pay, those beyond the sweeps' own. The
        // sweeps damp that mode, at a sixtieth of the cost of such a step.
        if (!newton.solved() && Co <= settings_.maxCo)
        {
            if (++nUnsolved == maxUnsolved)
            {
                return false;
            }
        }

        // The step grows as the residual falls, but no faster than twofold,
        // nor further than the linear equations can be solved. It stays where
        // they are solved badly but well enough: a steady state that is none
        // in time is only reached by long steps. On the way to a steady state
        // shocks cross cells, and the residual goes up and down by the time
        // that takes: steps are shortened where it rises by half.
        const bool headway = share == 1 && newton.norm() < 0.9*before;
        const scalar small = max(scalar(20), 0.1/newton.norm());
        const scalar ratio = before/newton.norm();
        Co *=
            share == 0 ? 0.25
          : !newton.solved() ? (headway ? 1.0 : 0.5)
          : share == 1
          ? max(max(0.5, min(ratio, 2.0)), min(scalar(2), small/Co))
          : ratio < 0.67 ? 0.7
          : max(scalar(1), min(scalar(1.1), small/Co));

        // Long steps may lead to and fro between states that are all as far
        // from the steady one: a few short ones lead out of that
        nAlike = newton.norm() < 2*best ? nAlike + 1 : 0;
        if (newton.norm() < 0.7*best)
        {
            best = newton.norm();
            bestProducts = newton.nProducts();
            nAlike = 0;
        }
        else if (newton.nProducts() - bestProducts > patience)
        {
            return false;
        }
        else if (nAlike == maxAlike)
        {
            Co = min(Co, firstCo);
            nAlike = 0;
        }
    }
    return true;
}


void Foam::steadySolution::reportEnd(const scalar gain) const
{
    Info<< "Gas: balance of mass " << imbalance_.massBalance
        << ", of total enthalpy " << imbalance_.enthalpyBalance
        << " of what flows in" << endl;
    if (!equations_.open() && mag(gain) > 1e-4)
    {
        WarningInFunction
            << "No boundary condition lets gas in or out, but on the way to"
            << " the steady state its mass has changed by " << 100*gain
            << " %, and with it the pressure: no steady equation says how much"
            << " gas there is." << nl
            << "    Where that matters march in time ('mode transient;')"
            << endl;
    }
    if (mag(imbalance_.lostMass) > 1e-4)
    {
        WarningInFunction
            << 100*mag(imbalance_.lostMass)
            << " % of the mass that flows in is "
            << (imbalance_.lostMass > 0 ? "lost" : "gained")
            << " between the sides of non-conformal patches (cyclicAMI), which"
            << " hand over values, not fluxes" << endl;
    }
    if (steady())
    {
        Info<< "Gas: steady after " << iterations_
            << " iterations, imbalance of " << imbalance_ << endl;
        if (imbalance_.ofWalls() > maxOfWalls)
        {
            WarningInFunction
                << "Heat or motion may still spread in the gas: ";
            imbalance_.writeOfWalls(Info);
            Info<< ". A smaller residual takes it further" << endl;
        }
    }
    else
    {
        const label k = imbalance_.worst();
        WarningInFunction
            << "The gas is not steady after " << iterations_
            << " iterations: in " << imbalance_.nAbove
            << " cells the imbalance is above " << settings_.residual
            << ", most in the equation of " << gasImbalance::names[k]
            << " of cell " << imbalance_.cell[k] << " at "
            << imbalance_.place[k] << " (rank " << imbalance_.rank[k]
            << "), " << imbalance_.largest[k] << "; the balance of mass is "
            << imbalance_.massBalance << ", that of total enthalpy "
            << imbalance_.enthalpyBalance << " of what flows in";
        if (imbalance_.ofWalls() > maxOfWalls)
        {
            imbalance_.writeOfWalls(Info<< "; ");
        }
        if (equations_.turbulent())
        {
            Info<< "; the eddy viscosity changes by " << eddyChange_
                << " of the viscosity in an iteration";
        }
        if (equations_.nCutEddies() > 0)
        {
            Info<< "; the turbulence model gives " << equations_.nCutEddies()
                << " cells an eddy viscosity beyond that of eddies as fast as"
                << " sound and a tenth of the mesh in size: look at its values"
                << " at the start and where the gas comes in";
        }
        Info<< endl;
    }
}


void Foam::steadySolution::setSchemes()
{
    // Flat shocks would be felt where they meet a layer of friction: it would
    // come off a plate before a ramp far too late. There they help on the way
    // alone.
    const bool flat = !equations_.sticks();
    equations_.flattenShocks(flat);
    equations_.muffle(true);
    if (!flat)
    {
        // Whose stripes of entropy would decide on the heat flux
        equations_.surroundShocks();
    }

    // Small differences between cells pass the limiter: at a stagnation point
    // pressure and velocity are level on one side of a cell. Those within a
    // layer of friction are to be limited as in time.
    equations_.smoothLimiter(flat ? 1e-2 : 1e-3);
}


void Foam::steadySolution::judge()
{
    setSchemes();
    equations_.computeRate();
    imbalance_ = equations_.imbalance(settings_.residual);
}


bool Foam::steadySolution::solve(const bool near)
{
    const scalar massBefore = equations_.mass();
    Info<< "Gas: looking for the steady state" << endl;
    setSchemes();
    if (!near)
    {
        equations_.beginFromStream();
    }

    if (settings_.implicit)
    {
        // Four symmetric sweeps: more buy fewer steps, but not fewer
        // operations
        ImplicitGaussSeidel implicit(equations_, 4);
        std::unique_ptr<NewtonKrylov> newton;
        scalar Co = settings_.maxCo;

        // Where Newton's method takes over. Where shocks have far to go it is
        // slower than sweeps
        const scalar handOver = near ? 1e-2 : 1e-3;

        // A march from far away begins with first-order fluxes. Subsonic gas
        // has no shocks to bring to their places
        equations_.computeRate();
        if
        (
            !finished()
         && (
                (imbalance_.value() > 0.05 && equations_.largestMach(true) > 1)
             || equations_.subsonicOutlet()
            )
        )
        {
            equations_.flattenShocks(true);
            if (!near)
            {
                equations_.roughen(true);
                approach(implicit, Co, handOver);
                equations_.roughen(false);
                equations_.computeRate();
            }
            if (!finished())
            {
                approach(implicit, Co, handOver);
            }
            equations_.flattenShocks(!equations_.sticks());
            equations_.muffle(true);
            equations_.computeRate();
        }
        while (!finished())
        {
            if (!newton)
            {
                newton.reset(new NewtonKrylov(equations_));
            }
            if (!converge(*newton))
            {
                approach(implicit, settings_.maxCo, 0);
            }
            else if (!finished())
            {
                // Shorter steps may lead to where Newton's method succeeds
                Co = max(Co/3, min(scalar(2), settings_.maxCo));
                approach(implicit, Co, handOver);
            }
            equations_.muffle(true);
            equations_.computeRate();
        }
    }
    else
    {
        integrateExplicitly();
    }

    reportEnd(equations_.mass()/massBefore - 1);
    return steady();
}
