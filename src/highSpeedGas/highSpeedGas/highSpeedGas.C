/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "highSpeedGas.H"
#include "checked.H"
#include "gasEntropy.H"
#include "processorTime.H"
#include "runSummary.H"
#include "shockAlignment.H"
#include "steadyFeedback.H"
#include "steadySolution.H"
#include "sigFpe.H"
#include "totalEnthalpy.H"

const Foam::Enum<Foam::highSpeedGas::modeType>
Foam::highSpeedGas::modeNames
({
    {modeType::transient, "transient"},
    {modeType::steady, "steady"},
    {modeType::frozen, "frozen"}
});


Foam::highSpeedGas::highSpeedGas(const fvMesh& mesh)
:
    mesh_(mesh),
    thermo_(readThermo(mesh)),
    U_
    (
        IOobject
        (
            "U",
            mesh.time().timeName(),
            mesh,
            IOobject::MUST_READ,
            IOobject::AUTO_WRITE
        ),
        mesh
    ),
    rho_
    (
        IOobject
        (
            "rho",
            mesh.time().timeName(),
            mesh,
            IOobject::NO_READ,
            IOobject::AUTO_WRITE
        ),
        mesh,
        dimensionedScalar("one", dimDensity, 1)
    ),
    phi_
    (
        IOobject("phi", mesh.time().timeName(), mesh),
        mesh,
        dimensionedScalar(dimMass/dimTime, Zero)
    ),
    Ma_
    (
        IOobject
        (
            "Ma",
            mesh.time().timeName(),
            mesh,
            IOobject::NO_READ,
            IOobject::AUTO_WRITE
        ),
        mesh,
        dimensionedScalar(dimless, Zero)
    ),
    state_
    (
        IOobject
        (
            "highSpeedGas",
            mesh.time().timeName(),
            "uniform",
            mesh.time(),
            IOobject::READ_IF_PRESENT,
            IOobject::AUTO_WRITE
        )
    ),
    leastEntropy_(-GREAT),
    steady_(false),
    cpuTime_(0)
{
    refuseWhatIsNotSolved();
    readSettings();

    // Written by this solver: the fields are taken as they are
    const bool restarts = state_.typeHeaderOk<IOdictionary>(false);
    const sigFpe::ignore untrapped;     // A NaN must be looked at
    setEquations(restarts);
    equations_->validateTurbulence();
    if (mode_ == modeType::steady)
    {
        equations_->turbulence().checkSteady();
        steady_ = isStillSteady();
    }
    else if (mode_ == modeType::transient)
    {
        state_.remove("imbalance");
        leastEntropy_ = gasEntropy(*equations_, phi_).least(true);
    }

    Info<< "Gas: mode " << modeNames[mode_]
        << (steady_ ? ", steady since an earlier run" : "")
        << (steady_ && equations_->turbulent() ? ", eddies as read" : "")
        << endl;
}


Foam::highSpeedGas::~highSpeedGas() = default;


bool Foam::highSpeedGas::isStillSteady()
{
    if (state_.getOrDefault<scalar>("imbalance", GREAT) > residual_)
    {
        return false;
    }
    const dictionary* entries =
        findBlockAmongOthers(mesh_.solutionDict(), "highSpeedGas");
    if (entries && entries->found("feedback"))
    {
        return true;    // expectParticles() looks, with the sources
    }
    return inBalance();
}


bool Foam::highSpeedGas::inBalance()
{
    // The values in the file are those of the conditions of an earlier run,
    // and what this one goes on with if they are the same
    equations_->keepBoundary();
    equations_->settleBoundary();
    steadySolution solution(solutionTo(residual_));
    solution.judge();

    // What a file with six digits may take; what walls give is hidden by them
    const scalar ofDigits = 1e-4;
    const bool exact =
        mesh_.time().writeFormat() == IOstream::BINARY
     || IOstream::defaultPrecision() >= 12;
    const scalar ofWalls = exact ? solution.imbalance().ofWalls() : 0;
    const scalar maxOfWalls = 0.1;
    if
    (
        solution.imbalance().value() <= max(ofDigits, residual_)
     && ofWalls <= maxOfWalls
    )
    {
        equations_->restoreBoundary();
        equations_->readFields(true);
        publish(true);
        return true;
    }
    const label k = solution.imbalance().worst();
    Info<< "Gas: not steady any more: with the mesh, the conditions and the"
        << " schemes of this run the imbalance of " << gasImbalance::names[k]
        << " is " << solution.imbalance().largest[k] << " in the cell at "
        << solution.imbalance().place[k];
    if (ofWalls > maxOfWalls)
    {
        solution.imbalance().writeOfWalls(Info<< ", and ");
    }
    Info<< endl;
    return false;
}


void Foam::highSpeedGas::setDeltaT(Time& runTime)
{
    if (frozen() || mode_ == modeType::steady)
    {
        return;
    }
    if (runTime.writeTime())
    {
        // Go on from what is written, so that a restart goes the same way
        const sigFpe::ignore untrapped;
        equations_->readFields(true);
        equations_->validateTurbulence();
    }
    // (which may change while the run goes on)
    const dictionary& control = runTime.controlDict();
    if (!control.getOrDefault("adjustTimeStep", false))
    {
        return;
    }

    const scalar stable = timeIntegrator_->centralStep(largestCo(control));
    const scalar largest = control.getOrDefault<scalar>("maxDeltaT", GREAT);

    // After a sudden rise of the stable step the flow may need some steps to
    // show why it was small
    const scalar grown =
        runTime.timeIndex() > runTime.startTimeIndex()
      ? 1.2*runTime.deltaTValue()
      : GREAT;
    runTime.setDeltaT(min(stable, min(largest, grown)));
}


void Foam::highSpeedGas::publish(const bool asWritten)
{
    equations_->publish(asWritten);

    const gasMesh& geometry = equations_->geometry();
    std::vector<double> a;
    equations_->soundSpeed(a);
    forAll(Ma_, celli)
    {
        Ma_[celli] = mag(U_[celli])/a[geometry.cellOf[celli]];
    }

    for (const gasMesh::patchRange& patch : geometry.patches())
    {
        const label slot =
            geometry.nCells() + patch.start - geometry.nInternal();
        fvPatchScalarField& Mp = Ma_.boundaryFieldRef()[patch.patchi];
        const fvPatchVectorField& Up = U_.boundaryField()[patch.patchi];
        forAll(Mp, i)
        {
            Mp[i] = mag(Up[i])/a[slot + i];
        }
    }
    for (fvPatchScalarField& Mp : Ma_.boundaryFieldRef())
    {
        if (Mp.type() == "wedge")
        {
            Mp.evaluate();
        }
    }
}


Foam::steadySolution Foam::highSpeedGas::solutionTo(const scalar residual)
{
    return steadySolution
    (
        *equations_,
        {implicit_, stages_, maxCo_, residual, maxIterations_, reportEvery_}
    );
}


bool Foam::highSpeedGas::findSteadyState
(
    const scalar residual,
    const bool near
)
{
    steadySolution solution(solutionTo(residual));
    const bool steady = solution.solve(near);
    state_.set("imbalance", solution.imbalance().value());
    state_.set("iterations", solution.iterations());
    return steady;
}


void Foam::highSpeedGas::report(const bool steady) const
{
    equations_->reportOpenPatches(steady);
    if (steady)
    {
        equations_->reportStagnation();
        if (!feedback_.valid())
        {
            gasEntropy(*equations_, phi_).reportExpansion();
            totalEnthalpy(*equations_, phi_).report();
        }
    }
}


void Foam::highSpeedGas::setEquations(const bool restarts)
{
    timeIntegrator_.clear();
    equations_.clear();
    equations_.reset
    (
        new gasEquations
        (
            mesh_, *thermo_, U_, rho_, phi_, viscous_,
            mode_ == modeType::transient, mode_ == modeType::steady, restarts
        )
    );
    timeIntegrator_.reset(new RungeKutta(*equations_, stages_));
    publish(restarts);
}


void Foam::highSpeedGas::align(shockAlignment& alignment)
{
    if (mode_ != modeType::steady)
    {
        FatalIOErrorInFunction(mesh_.solutionDict())
            << "A mesh is moved to the shock of a steady gas." << nl
            << "Set 'mode steady;' in the block highSpeedGas"
            << exit(FatalIOError);
    }

    equations_->turbulence().refuseEddies
    (
        "no turbulence is taken from mesh to mesh. Move the mesh with a"
        " laminar gas, and go on with eddies on it"
    );
    alignment.checkInflow(U_, sqrt(thermo_->gamma()/thermo_->psi()));

    const processorTime timer(cpuTime_);

    // The shock stands long before the last cell is at rest, and longer where
    // the mesh will have to move again
    const sigFpe::ignore untrapped;

    const auto approach = [&](const scalar imbalance, const bool near)
    {
        if (!findSteadyState(max(residual_, imbalance), near))
        {
            FatalErrorInFunction
                << "The gas has not come near a steady state (an imbalance of"
                << ' ' << imbalance << ") after " << maxIterations_
                << " iterations (maxIterations): there is no shock at rest"
                << " that a mesh could follow" << nl
                << "Layers can follow the detached shock of a blunt body. Look"
                << " at the flow on the mesh as it was, and where the warning"
                << " above says: at sharp edges layers may be too coarse"
                << exit(FatalError);
        }
        publish();
    };

    label round = 0;
    approach(1e-2, false);
    while (!alignment.follows(thermo_->p()) && round < alignment.rounds())
    {
        alignment.move(thermo_->p(), thermo_->T(), U_);
        setEquations(false);
        approach
        (
            alignment.inDoubt() ? 1e-3 : min(1e-4, 2*alignment.tolerance()),
            true
        );
        round++;
    }
    alignment.report();
    const bool steady = findSteadyState(residual_, true);
    publish();
    report(steady);
}


void Foam::highSpeedGas::expectParticles(const bool act)
{
    const dictionary* found =
        findBlockAmongOthers(mesh_.solutionDict(), "highSpeedGas");
    const dictionary& d = found ? *found : dictionary::null;
    const dictionary* feedback = d.findDict("feedback");
    if (feedback && (!act || mode_ != modeType::steady))
    {
        FatalIOErrorInFunction(*feedback)
            << "Block feedback is for clouds that act on a steady gas: "
            << (act ? "the mode is " : "no cloud says 'coupled yes;'")
            << (act ? modeNames[mode_] : word::null) << nl
            << "Valid: no block feedback" << exit(FatalIOError);
    }
    if (act)
    {
        leastEntropy_ = -GREAT;
    }
    if (act && mode_ == modeType::frozen)
    {
        refuse
        (
            d, "mode", "frozen", "transient or steady with a cloud that acts"
            " on the gas"
        );
    }
    if (act && mode_ == modeType::steady)
    {
        if (!feedback)
        {
            FatalIOErrorInFunction(d)
                << "A cloud acts on the gas, which is steady: how they come"
                << " to rest together must be said." << nl
                << "Add to the block highSpeedGas, with times that particles"
                << " need to cross the domain:" << nl
                << "    feedback { delay <s>; window <s>; }"
                << exit(FatalIOError);
        }
        feedback_.reset(new steadyFeedback(*equations_, state_, *feedback));
        const sigFpe::ignore untrapped;
        if (steady_ && !inBalance())
        {
            steady_ = false;
            feedback_->beginAnew();
        }
    }
}


bool Foam::highSpeedGas::solve()
{
    const bool roundEnds = feedback_.valid() && feedback_->roundEnds();
    if (frozen() && !roundEnds)
    {
        if (feedback_.valid())
        {
            feedback_->beginStep();
        }
        return false;
    }

    const processorTime timer(cpuTime_);

    {
        // A floating-point exception would end the run before it can say
        // where: what a step makes of the state is looked at before it is
        // accepted
        const sigFpe::ignore untrapped;

        bool steady = false;
        if (mode_ == modeType::steady)
        {
            if (roundEnds)
            {
                const std::vector<double> before(equations_->primitive);
                feedback_->endRound();
                steady = findSteadyState(residual_, true);
                feedback_->compare(before, steady);
            }
            else
            {
                steady = findSteadyState(residual_, false);
                if (feedback_.valid())
                {
                    feedback_->takeFelt();
                }
            }
            if (feedback_.valid())
            {
                feedback_->beginStep();
            }
            steady_ = true;
        }
        else
        {
            equations_->storeOldTime();
            const label n =
                timeIntegrator_->advance(mesh_.time().deltaTValue(), maxCo_);
            if (n > 1)
            {
                Info<< "Gas: " << n << " steps" << endl;
            }
        }
        publish();
        if (leastEntropy_ > -GREAT)
        {
            // (what comes in may change)
            leastEntropy_ =
                min(leastEntropy_, gasEntropy(*equations_, phi_).least(false));
        }
        if (mode_ == modeType::steady)
        {
            report(steady);
        }
        if (feedback_.valid())
        {
            // Go on from what may be written, so that a restart goes the
            // same way
            equations_->readFields(true);
            publish(true);
        }
    }
    if (mode_ == modeType::transient)
    {
        equations_->correctTurbulence();
    }
    if (mode_ == modeType::steady || mesh_.time().writeTime())
    {
        equations_->warnOfSlowGas();
        equations_->warnOfWallHeat();
    }
    return true;
}


void Foam::highSpeedGas::warnOfSwirl(const vectorField& momentum)
{
    const gasMesh& geometry = equations_->geometry();
    if (!geometry.inSection() || warnedOfSwirl_)
    {
        return;
    }
    // Of single steps the noise of few particles is as large
    const scalar around = gSum(momentum.component(geometry.turning()));
    swirl_.around += around;
    swirl_.squares += sqr(around);
    swirl_.all += gSumMag(momentum);
    if
    (
        mag(swirl_.around) > 0.1*swirl_.all
     && mag(swirl_.around) > 4*std::sqrt(swirl_.squares)
    )
    {
        warnedOfSwirl_ = true;
        WarningInFunction
            << "Particles give the gas momentum about the axis of the wedge, "
            << 100*mag(swirl_.around)/swirl_.all << " % of all, but it is"
            << " solved without swirl and does not take it up." << nl
            << "    Begin with some: a millionth of the speed in one cell of"
            << " the field U is enough" << endl;
    }
}


void Foam::highSpeedGas::receive
(
    const vectorField& momentum,
    const scalarField& energy
)
{
    warnOfSwirl(momentum);
    if (feedback_.valid())
    {
        feedback_->receive(momentum, energy);
        return;
    }
    const processorTime timer(cpuTime_);
    const sigFpe::ignore untrapped;

    equations_->receive(momentum, energy);
    publish();
}


void Foam::highSpeedGas::account(runSummary& summary) const
{
    summary.part("gas", cpuTime_);
    gasEntropy(*equations_, phi_).reportLoss(leastEntropy_);
    if (mode_ == modeType::transient)
    {
        equations_->reportOpenPatches(false);
    }
    if (feedback_.valid())
    {
        feedback_->warnUnlessAtRest();
    }
}
