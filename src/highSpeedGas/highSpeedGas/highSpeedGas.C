/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "highSpeedGas.H"
#include "checked.H"
#include "processorTime.H"
#include "runSummary.H"
#include "shockAlignment.H"
#include "steadyFeedback.H"
#include "steadySolution.H"
#include "localIOdictionary.H"
#include "presentFile.H"
#include "sigFpe.H"

const Foam::Enum<Foam::highSpeedGas::modeType>
Foam::highSpeedGas::modeNames
({
    {modeType::transient, "transient"},
    {modeType::steady, "steady"},
    {modeType::frozen, "frozen"}
});


void Foam::highSpeedGas::refuseWhatIsNotSolved() const
{
    const Time& time = mesh_.time();

    // Whether a file is there and says something, and that
    auto contents = [&](const word& name, const fileName& folder)
    {
        IOobject io
        (
            name, folder, mesh_, IOobject::READ_IF_PRESENT,
            IOobject::NO_WRITE, false
        );
        isPresent<IOdictionary>(io);    // or refused, without a header
        return localIOdictionary(io);
    };

    const localIOdictionary motion
    (
        contents("dynamicMeshDict", time.constant())
    );
    const word dynamicMesh
    (
        motion.getOrDefault<word>
        (
            "dynamicFvMesh",
            motion.getOrDefault<word>
            (
                "solver", motion.empty() ? "staticFvMesh" : "(none)"
            )
        )
    );
    if (dynamicMesh != "staticFvMesh")
    {
        FatalIOErrorInFunction(motion)
            << "Entry dynamicFvMesh is " << dynamicMesh << ": the gas is"
            << " solved on meshes at rest." << nl
            << "Valid: staticFvMesh, or no file constant/dynamicMeshDict"
            << exit(FatalIOError);
    }

    for (const word name : {"fvOptions", "MRFProperties"})
    {
        for
        (
            const fileName& folder :
            {fileName(time.constant()), fileName(time.system())}
        )
        {
            const localIOdictionary sources(contents(name, folder));
            for (const entry& e : sources)
            {
                if (e.isDict() && e.dict().getOrDefault("active", true))
                {
                    FatalIOErrorInFunction(sources)
                        << "Entry " << e.keyword() << ": the gas takes no"
                        << " sources or rotating zones from " << name << '.'
                        << nl << "Set 'active no;' in it, or remove it"
                        << exit(FatalIOError);
                }
            }
        }
    }

    const localIOdictionary radiation
    (
        contents("radiationProperties", time.constant())
    );
    if
    (
        radiation.getOrDefault("radiation", true)
     && radiation.getOrDefault<word>("radiationModel", "none") != "none"
    )
    {
        FatalIOErrorInFunction(radiation)
            << "Entry radiationModel is "
            << radiation.get<word>("radiationModel")
            << ": the gas does not radiate." << nl
            << "Valid: none, or 'radiation off;'" << exit(FatalIOError);
    }
}


void Foam::highSpeedGas::refuseTimeScheme() const
{
    const dictionary& schemes = mesh_.schemesDict().subDict("ddtSchemes");
    static const wordHashSet local
    {
        "localEuler", "SLTS", "CoEuler", "steadyState"
    };

    for (const entry& e : schemes)
    {
        if (e.isDict())
        {
            continue;
        }
        const word name(e.stream());
        if (local.found(name) && mode_ == modeType::transient)
        {
            FatalIOErrorInFunction(schemes)
                << "Entry " << e.keyword() << " is " << name
                << ", which leads to a steady state, but the gas is marched"
                << " in time." << nl
                << "For a steady state set 'mode steady;' in the block"
                << " highSpeedGas of system/fvSolution; for a flow in time"
                << " set Euler" << exit(FatalIOError);
        }
    }
}


void Foam::highSpeedGas::readSettings()
{
    const dictionary& solution = mesh_.solutionDict();
    const dictionary* found = findBlockAmongOthers(solution, "highSpeedGas");
    const dictionary& d = found ? *found : dictionary::null;

    refuseOthers
    (
        d,
        {
            "mode", "scheme", "maxCo", "residual", "maxIterations",
            "reportEvery", "viscous", "feedback"
        }
    );

    mode_ = modeNames
    [
        getWord(d, "mode", {"transient", "steady", "frozen"})
    ];
    refuseTimeScheme();

    const bool steady = mode_ == modeType::steady;
    const wordList schemes
    (
        mode_ == modeType::transient
      ? wordList({"Euler", "RK2", "RK3"})
      : wordList({"Euler", "RK2", "RK3", "implicit"})
    );
    const label i = schemes.find
    (
        getWordOf(d, "scheme", steady ? "implicit" : "RK3", schemes)
    );
    implicit_ = i == 3;
    stages_ = implicit_ ? 3 : i + 1;

    const dictionary& control = mesh_.time().controlDict();
    adjustsTimeStep_ =
        mode_ == modeType::transient
     && control.getOrDefault("adjustTimeStep", false);

    maxCo_ = getNumber
    (
        d, "maxCo", implicit_ ? "(0, 1e9]" : "(0, 1]",
        scalar(implicit_ ? 100 : adjustsTimeStep_ ? 1 : 0.5)
    );
    stepCo_ = getNumber(control, "maxCo", "(0, 1e300]", scalar(0.5));
    residual_ = getNumber(d, "residual", "(0, 1)", scalar(1e-6));
    maxIterations_ =
        getNumber<label>(d, "maxIterations", validRange::count, 10000);
    reportEvery_ = getNumber<label>(d, "reportEvery", validRange::count, 100);
    viscous_ = d.getOrDefault
    (
        "viscous", gasEquations::hasViscosity(*thermo_)
    );
}


void Foam::highSpeedGas::checkGas(const fvMesh& mesh)
{
    // The stock models divide by some of these numbers before they look
    static const List<Tuple2<word, string>> ranges
    {
        {"molWeight", "[0.1, 1e6] kg/kmol, lighter than hydrogen to polymers"},
        {"Cp", "(0, 1e9) J/(kg K)"},
        {"Cv", "(0, 1e9) J/(kg K)"},
        {"mu", "[0, 1e3] Pa s, no gas"},
        {"Pr", "(0, 1e6]"},
        {"As", "(0, 1] kg/(m s K^0.5), about 1e-6 for gases"},
        {"Ts", "[0, 1e5] K"}
    };
    IOobject io
    (
        basicThermo::dictName, mesh.time().constant(), mesh,
        IOobject::MUST_READ, IOobject::NO_WRITE, false
    );
    if (!isPresent<IOdictionary>(io))
    {
        return;     // the stock reader says so
    }
    const IOdictionary properties(io);
    const dictionary& gas = properties.subOrEmptyDict("mixture");
    for (const entry& e : gas)
    {
        if (!e.isDict())
        {
            continue;
        }
        for (const Tuple2<word, string>& range : ranges)
        {
            const ITstream* is =
                e.dict().found(range.first())
             && !e.dict().isDict(range.first())
              ? &e.dict().lookup(range.first()) : nullptr;
            if (is && is->size() && (*is)[0].isNumber())
            {
                checkNumber
                (
                    e.dict(), range.first(), (*is)[0].number(), range.second()
                );
            }
        }
    }
}


Foam::autoPtr<Foam::fluidThermo> Foam::highSpeedGas::readThermo
(
    const fvMesh& mesh
)
{
    for (const word name : {"p", "T"})
    {
        checkPositive(mesh, name);
    }
    checkGas(mesh);
    return fluidThermo::New(mesh);
}


void Foam::highSpeedGas::checkPositive(const fvMesh& mesh, const word& name)
{
    const localIOdictionary file
    (
        IOobject
        (
            name,
            mesh.time().timeName(),
            mesh,
            IOobject::MUST_READ,
            IOobject::NO_WRITE,
            false
        ),
        volScalarField::typeName
    );

    const sigFpe::ignore untrapped;     // A NaN must be looked at
    auto check = [&](const dictionary& d, const word& key, const label size)
    {
        const scalarField values(key, d, size);
        forAll(values, i)
        {
            if (!(values[i] > 0 && values[i] < GREAT))
            {
                FatalIOErrorInFunction(d)
                    << "Entry " << key << " of " << name << " in "
                    << d.dictName() << " holds " << name << " = " << values[i]
                    << " at index " << i
                    << "; pressure and temperature must be positive (> 0)"
                    << " and finite" << exit(FatalIOError);
            }
        }
    };

    check(file, "internalField", mesh.nCells());

    const dictionary& boundary = file.subDict("boundaryField");
    for (const fvPatch& patch : mesh.boundary())
    {
        const dictionary* d =
            boundary.findDict(patch.name(), keyType::REGEX);
        const word type(d ? d->getOrDefault<word>("type", "") : "");
        if (type == "fixedValue")
        {
            check(*d, "value", patch.size());
        }
    }
}


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
    steady_(false),
    cpuTime_(0)
{
    refuseWhatIsNotSolved();
    readSettings();

    // Written by this solver: the fields are taken as they are
    const bool restarts = state_.typeHeaderOk<IOdictionary>(false);
    steady_ =
        mode_ == modeType::steady
     && state_.getOrDefault<scalar>("imbalance", GREAT) <= residual_;

    const sigFpe::ignore untrapped;     // A NaN must be looked at
    setEquations(restarts);
    equations_->validateTurbulence();
    if (mode_ == modeType::steady)
    {
        equations_->turbulence().checkSteady();
    }

    Info<< "Gas: mode " << modeNames[mode_]
        << (steady_ ? ", steady since an earlier run" : "") << endl;
}


Foam::highSpeedGas::~highSpeedGas() = default;


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
    if (!adjustsTimeStep_)
    {
        return;
    }

    const scalar stable = timeIntegrator_->centralStep(stepCo_);
    const scalar largest =
        runTime.controlDict().getOrDefault<scalar>("maxDeltaT", GREAT);

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


bool Foam::highSpeedGas::findSteadyState
(
    const scalar residual,
    const bool near
)
{
    steadySolution solution
    (
        *equations_,
        {implicit_, stages_, maxCo_, residual, maxIterations_, reportEvery_}
    );
    const bool steady = solution.solve(near);
    state_.set("imbalance", solution.imbalance().value());
    state_.set("iterations", solution.iterations());
    return steady;
}


void Foam::highSpeedGas::report(const bool steady) const
{
    equations_->reportInletShocks(steady);
    if (steady)
    {
        equations_->reportStagnation();
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
            mode_ == modeType::steady, restarts
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

    label round = 0;
    findSteadyState(max(residual_, 1e-2), false);
    publish();
    while (!alignment.follows(thermo_->p()) && round < alignment.rounds())
    {
        alignment.move(thermo_->p(), thermo_->T(), U_);
        setEquations(false);
        findSteadyState
        (
            max(residual_, alignment.inDoubt() ? 1e-3 : 1e-4), true
        );
        publish();
        round++;
    }
    alignment.report();
    report(findSteadyState(residual_, true));
    publish();
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

        if (mode_ == modeType::steady)
        {
            bool steady;
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
            }
            report(steady);
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
        equations_->warnOfWallHeat();
    }
    return true;
}


void Foam::highSpeedGas::receive
(
    const vectorField& momentum,
    const scalarField& energy
)
{
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
    if (feedback_.valid())
    {
        feedback_->warnUnlessAtRest();
    }
}
