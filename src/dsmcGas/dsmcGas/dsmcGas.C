/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "dsmcGas.H"
#include "checked.H"
#include "lagrangianFile.H"
#include "maxwellian.H"
#include "presentFile.H"
#include "runSummary.H"
#include "wallPolyPatch.H"
#include "wordRes.H"

#include <ctime>

namespace Foam
{
    defineTypeNameAndDebug(dsmcGas, 0);

    // Files of the stock cloud and the class they name
    static const word cloudName("dsmc");
    static const word cloudHeader("Cloud<dsmcParcel>");

    // What random numbers are drawn for: the highest bits of their stream
    enum purpose : std::uint64_t
    {
        forCollisions = 1,
        forInflow = 2,
        forWalls = 3
    };

    // A count, in full
    static int64_t whole(const scalar count)
    {
        return int64_t(count + 0.5);
    }

    // Processor time since the last call
    static scalar lap(clock_t& since)
    {
        const clock_t now = std::clock();
        const scalar time = scalar(now - since)/CLOCKS_PER_SEC;
        since = now;
        return time;
    }
}


// * * * * * * * * * * * * * * * * Boundaries  * * * * * * * * * * * * * * * //

class Foam::dsmcGas::boundaries
{
    dsmcGas& gas_;
    gasFields* const fields_[2];
    const std::uint64_t stream_;
    const std::uint32_t step_;

public:

    label hits;
    label left;

    boundaries(dsmcGas& gas, const bool sampling)
    :
        gas_(gas),
        fields_
        {
            gas.instantaneous_.valid() ? &gas.instantaneous_() : nullptr,
            sampling ? &gas.means_() : nullptr
        },
        stream_(gas.stream(forWalls)),
        step_(gas.mesh_.time().timeIndex()),
        hits(0),
        left(0)
    {}

    void leave(const label, const label)
    {
        ++left;
    }

    bool hitWall
    (
        const label i,
        const label boundaryFacei,
        const impact::vector3& normal,
        const label nHits
    );
};


bool Foam::dsmcGas::boundaries::hitWall
(
    const label i,
    const label boundaryFacei,
    const impact::vector3& n,
    const label nHits
)
{
    using namespace impact;

    ++hits;
    moleculeArray& molecules = gas_.molecules_;
    const convexCells::boundaryFace& face =
        gas_.cells_.boundary()[boundaryFacei];
    const auto& kind = gas_.species_[molecules.payload().typeId[i]];
    double& Ei = molecules.payload().Ei[i];

    const vector3 before = molecules.velocity(i);
    const double EiBefore = Ei;
    vector3 after;

    counterRandom rnd
    (
        gas_.seed_,
        stream_ + std::uint64_t(i),
        step_ ^ (std::uint32_t(nHits) << 24)
    );
    const double fraction = gas_.diffuseFraction_[face.patch];
    if (fraction > 0 && rnd.uniform() < fraction)
    {
        const scalar T =
            gas_.boundaryT_->boundaryField()[face.patch][face.patchFace];
        const vector& U =
            gas_.boundaryU_->boundaryField()[face.patch][face.patchFace];
        const double c = maxwellian::mostProbableSpeed(T, kind.mass);
        after = maxwellian::crossingVelocity
        (
            -n, {U.x(), U.y(), U.z()}, c, 0, rnd
        );
        Ei = maxwellian::boltzmann*T
            *maxwellian::internalEnergy(kind.internalDegreesOfFreedom, rnd);
    }
    else
    {
        after = before - 2*dot(before, n)*n;
    }
    molecules.setVelocity(i, after);

    for (gasFields* fields : fields_)
    {
        if (fields)
        {
            const double zeta = kind.internalDegreesOfFreedom;
            fields->addHit
            (
                boundaryFacei,
                n,
                {kind.mass, zeta, before, EiBefore},
                {kind.mass, zeta, after, Ei}
            );
        }
    }
    return true;
}


// * * * * * * * * * * * * * * * * * Events  * * * * * * * * * * * * * * * * //

void Foam::dsmcGas::events::add(const events& e)
{
    steps += e.steps;
    entered += e.entered;
    left += e.left;
    hits += e.hits;
    candidates += e.candidates;
    collisions += e.collisions;
    moleculeSteps += e.moleculeSteps;
}


void Foam::dsmcGas::events::sumOverProcessors()
{
    for
    (
        scalar* value :
        {&entered, &left, &hits, &candidates, &collisions, &moleculeSteps}
    )
    {
        reduce(*value, sumOp<scalar>());
    }
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::dsmcGas::checkEntries() const
{
    // Ours, those of the stock program, and its models' coefficients
    refuseOthers
    (
        properties_,
        {
            "wallDiffuseFractions", "sampling", "reportEvery", "randomSeed",
            "nEquivalentParticles", "typeIdList", "moleculeProperties",
            "BinaryCollisionModel", "WallInteractionModel",
            "InflowBoundaryModel", "VariableHardSphereCoeffs",
            "LarsenBorgnakkeVariableHardSphereCoeffs", "NoBinaryCollisionCoeffs",
            "MixedDiffuseSpecularCoeffs", "MaxwellianThermalCoeffs",
            "SpecularReflectionCoeffs", "FreeStreamCoeffs",
            "NoInflowCoeffs"
        }
    );
}


void Foam::dsmcGas::readSpecies()
{
    weight_ =
        getNumber(properties_, "nEquivalentParticles", "[1e-30, 1e30]");
    seed_ = getNumber<label>(properties_, "randomSeed", validRange::seed, 1);

    names_ = properties_.get<wordList>("typeIdList");
    if (names_.empty())
    {
        FatalIOErrorInFunction(properties_)
            << "Entry typeIdList is empty: name at least one species"
            << exit(FatalIOError);
    }
    const dictionary& all = properties_.subDict("moleculeProperties");
    forAll(names_, i)
    {
        const word& name = names_[i];
        if (names_.find(name) != i)
        {
            refuse(properties_, "typeIdList", name, "a list of different names");
        }
        if (!all.isDict(name))
        {
            FatalIOErrorInFunction(all)
                << "Species " << name << " of typeIdList has no"
                << " sub-dictionary here" << nl
                << "Species found: " << all.toc() << exit(FatalIOError);
        }
        const dictionary& d = all.subDict(name);
        refuseOthers
        (
            d, {"mass", "diameter", "omega", "internalDegreesOfFreedom"}
        );
        species_.push_back
        (
            {
                getNumber(d, "mass", "[1e-28, 1e-20] kg, of a molecule"),
                getNumber(d, "diameter", "[1e-12, 1e-7] m, of a molecule"),
                d.get<scalar>("omega"),
                int(d.get<label>("internalDegreesOfFreedom"))
            }
        );
        // One by one, so that a message has the name of the species
        try
        {
            impact::cellCollisions({species_.back()}, 273, 0, 0);
        }
        catch (const std::invalid_argument& e)
        {
            FatalIOErrorInFunction(d)
                << "Entry " << e.what() << " (species " << name << ')'
                << exit(FatalIOError);
        }
    }
}


void Foam::dsmcGas::readCollisions()
{
    const word model
    (
        getWordOf
        (
            properties_, "BinaryCollisionModel", "",
            {"LarsenBorgnakkeVariableHardSphere", "VariableHardSphere", "none"}
        )
    );
    const bool exchange = model == "LarsenBorgnakkeVariableHardSphere";
    const word exchangeCoeffs("LarsenBorgnakkeVariableHardSphereCoeffs");
    const word elasticCoeffs("VariableHardSphereCoeffs");

    // Those of the model that is not chosen may stay, but not misspelt
    refuseOthers(properties_.subOrEmptyDict(elasticCoeffs), {"Tref"});
    refuseOthers
    (
        properties_.subOrEmptyDict(exchangeCoeffs),
        {"Tref", "relaxationCollisionNumber"}
    );
    if (model == "none")
    {
        return;
    }
    const dictionary& coeffs =
        properties_.subDict(exchange ? exchangeCoeffs : elasticCoeffs);
    const scalar Tref = getNumber(coeffs, "Tref", validRange::temperature);
    referenceTemperature_ = Tref;
    const scalar Z =
        exchange
      ? getNumber(coeffs, "relaxationCollisionNumber", "[1, 1e12]") : 0;
    checked
    (
        coeffs,
        [&]
        {
            collisions_.reset
            (
                new impact::cellCollisions(species_, Tref, Z, seed_)
            );
            return true;
        }
    );
}


void Foam::dsmcGas::readWalls()
{
    const auto present = [&](const word& name)
    {
        return IOobject
        (
            name,
            mesh_.time().timeName(),
            mesh_,
            IOobject::MUST_READ,
            IOobject::AUTO_WRITE
        );
    };
    IOobject T = present("boundaryT");
    IOobject U = present("boundaryU");
    if (isPresent<volScalarField>(T, false))
    {
        boundaryT_.reset(new volScalarField(T, mesh_));
    }
    if (isPresent<volVectorField>(U, false))
    {
        boundaryU_.reset(new volVectorField(U, mesh_));
    }

    const word model
    (
        getWordOf
        (
            properties_, "WallInteractionModel", "",
            {"MaxwellianThermal", "MixedDiffuseSpecular", "SpecularReflection"}
        )
    );
    scalar fraction = 0;
    if (model == "MaxwellianThermal")
    {
        fraction = 1;
    }
    else if (model == "MixedDiffuseSpecular")
    {
        const dictionary& coeffs = properties_.subDict(model + "Coeffs");
        refuseOthers(coeffs, {"diffuseFraction"});
        fraction = getNumber(coeffs, "diffuseFraction", validRange::share);
    }

    const polyBoundaryMesh& patches = mesh_.boundaryMesh();
    wordList walls;
    forAll(patches, patchi)
    {
        if (isA<wallPolyPatch>(patches[patchi]))
        {
            walls.append(patches[patchi].name());
        }
    }
    diffuseFraction_.setSize(patches.size(), 0);
    forAll(patches, patchi)
    {
        if (walls.found(patches[patchi].name()))
        {
            diffuseFraction_[patchi] = fraction;
        }
    }
    const dictionary* block = findBlock(properties_, "wallDiffuseFractions");
    const dictionary own(block ? *block : dictionary());
    for (const entry& e : own)
    {
        const scalar value = getNumber(own, e.keyword(), validRange::share);
        bool found = false;
        forAll(patches, patchi)
        {
            const word& name = patches[patchi].name();
            if (walls.found(name) && wordRe(e.keyword()).match(name))
            {
                diffuseFraction_[patchi] = value;
                found = true;
            }
        }
        if (!found)
        {
            unknownWord(own, "wall", e.keyword(), walls);
        }
    }

    forAll(patches, patchi)
    {
        if (diffuseFraction_[patchi] == 0)
        {
            continue;
        }
        const polyPatch& patch = patches[patchi];
        if (!boundaryT_.valid() || !boundaryU_.valid())
        {
            FatalIOErrorInFunction(properties_)
                << "The diffuse wall " << patch.name() << " needs the fields"
                << " boundaryT and boundaryU in " << mesh_.time().timePath()
                << exit(FatalIOError);
        }
        const scalarField& wallT = boundaryT_->boundaryField()[patchi];
        const vectorField& wallU = boundaryU_->boundaryField()[patchi];
        forAll(patch, i)
        {
            if (!within(wallT[i], validRange::temperature))
            {
                refuse
                (
                    dictionary(boundaryT_->objectPath()),
                    "boundaryT of the diffuse wall " + patch.name(), wallT[i],
                    validRange::temperature
                );
            }
            const vector n = normalised(patch.faceAreas()[i]);
            if
            (
                !(cmptMax(cmptMag(wallU[i])) < 3e8)
             || mag(wallU[i] & n) > 1e-6*mag(wallU[i])
            )
            {
                refuse
                (
                    dictionary(boundaryU_->objectPath()),
                    "boundaryU of the diffuse wall " + patch.name(), wallU[i],
                    "a velocity along the wall, whose normal is ", n,
                    ", less than 3e8 m/s"
                );
            }
        }
    }
}


void Foam::dsmcGas::readMolecules()
{
    const bool found = lagrangianFile::read(mesh_, cloudName, molecules_);
    nStart_ = returnReduce(molecules_.size(), sumOp<label>());
    if (!returnReduce(found || inflow_->active(), orOp<bool>()))
    {
        FatalErrorInFunction
            << "No molecules in "
            << mesh_.time().timePath()/"lagrangian"/cloudName
            << " and no inflow. Run dsmcInitialise first"
            << exit(FatalError);
    }
    for (label i = 0; i < molecules_.size(); ++i)
    {
        const label typeId = molecules_.payload().typeId[i];
        if (typeId < 0 || typeId >= names_.size())
        {
            FatalErrorInFunction
                << "Molecule " << i << " has typeId " << typeId
                << ". Valid range: 0 <= typeId < " << names_.size()
                << ", the number of species" << exit(FatalError);
        }
    }
}


void Foam::dsmcGas::makeBoxes()
{
    boxes_.resize(mesh_.nCells());
    forAll(mesh_.cells(), celli)
    {
        const boundBox box(mesh_.points(), mesh_.cellPoints()[celli], false);
        for (direction d = 0; d < 3; ++d)
        {
            boxes_[celli].corner[d] = box.min()[d];
            boxes_[celli].perWidth[d] =
                cells_.moving()[d] == 0 ? 0 : 1/box.span()[d];
        }
    }
}


void Foam::dsmcGas::readSampling()
{
    reportEvery_ =
        getNumber<label>(properties_, "reportEvery", validRange::count, 10);

    const dictionary* functions =
        mesh_.time().controlDict().findDict("functions");
    if (functions && !functions->empty())
    {
        instantaneous_.reset(new gasFields(mesh_, species_, weight_, ""));
    }

    if (const dictionary* sampling = findBlock(properties_, "sampling"))
    {
        refuseOthers(*sampling, {"start", "every"});
        samplingStart_ =
            getNumber(*sampling, "start", validRange::time, scalar(0));
        samplingEvery_ =
            getNumber<label>(*sampling, "every", validRange::count, 1);
        means_.reset(new gasFields(mesh_, species_, weight_, "Mean"));
    }
}


void Foam::dsmcGas::findMaxima()
{
    if (!collisions_.valid())
    {
        return;
    }

    // dsmcInitialise starts at the most probable speed
    const scalar T = stateOfAll().temperature;
    const scalar start = collisions_->startingSigmaCMax(T > 0 ? T : 300);
    sigmaTcRMax_.primitiveFieldRef() =
        max(sigmaTcRMax_.primitiveField(), start);
    sigmaTcRMax_.correctBoundaryConditions();
}


Foam::dsmcGas::state Foam::dsmcGas::stateOfAll() const
{
    state s;
    s.count.setSize(names_.size(), 0);
    scalar energy = 0;
    vector momentum(Zero);
    for (label i = 0; i < molecules_.size(); ++i)
    {
        const label typeId = molecules_.payload().typeId[i];
        const scalar m = species_[typeId].mass;
        const impact::vector3 u = molecules_.velocity(i);
        ++s.count[typeId];
        s.mass += m;
        momentum += m*vector(u.x, u.y, u.z);
        energy += 0.5*m*dot(u, u);
    }
    reduce(s.count, sumOp<scalarField>());
    reduce(momentum, sumOp<vector>());
    reduce(s.mass, sumOp<scalar>());
    reduce(energy, sumOp<scalar>());
    const scalar n = sum(s.count);
    if (n > 0)
    {
        s.velocity = momentum/s.mass;
        s.temperature =
            2*max(energy - 0.5*magSqr(momentum)/s.mass, scalar(0))
           /(3*impact::maxwellian::boltzmann*n);
    }
    return s;
}


void Foam::dsmcGas::describe() const
{
    const state whole = stateOfAll();
    const scalar T = whole.temperature;
    const scalarField& count = whole.count;
    const label n = nStart_;
    const scalar density = n*weight_/gSum(mesh_.V());

    Info<< "Gas" << nl
        << "    species: " << flatOutput(names_) << nl
        << "    simulated molecules: " << n << ", each for " << weight_
        << " real ones" << nl;
    if (!n)
    {
        Info<< "    the domain is empty at the start" << nl << endl;
        return;
    }

    Info<< "    number density: " << density << " 1/m^3, temperature: " << T
        << " K, mean velocity: " << whole.velocity << " m/s" << nl
        << "    molecules per cell: "
        << scalar(n)/returnReduce(mesh_.nCells(), sumOp<label>()) << nl;

    // Means over pairs at equilibrium: of |c| and of sigma |c|
    scalar rate = 0, speed = 0;
    if (collisions_.valid() && T > 0)
    {
        forAll(names_, p)
        {
            const scalar share = count[p]/n;
            speed += share*impact::maxwellian::meanSpeed(T, species_[p].mass);
            forAll(names_, q)
            {
                rate += share*count[q]/n*density
                   *collisions_->equilibriumSigmaC(p, q, T);
            }
        }
        scalar width = 0;
        forAll(mesh_.cells(), celli)
        {
            for (direction d = 0; d < 3; ++d)
            {
                const scalar perWidth = boxes_[celli].perWidth[d];
                width = max(width, perWidth > 0 ? 1/perWidth : 0);
            }
        }
        reduce(width, maxOp<scalar>());
        const scalar deltaT = mesh_.time().deltaTValue();
        Info<< "    mean free path: " << speed/rate
            << " m, greatest cell width: " << width << " m" << nl
            << "    mean collision time: " << 1/rate << " s, time step: "
            << deltaT << " s" << nl;
        if (width > speed/rate || deltaT*rate > 1)
        {
            Info<< "    (accurate transport needs cells and steps below these"
                << " lengths and times)" << nl;
        }
    }
    Info<< endl;
}


std::uint64_t Foam::dsmcGas::stream(const std::uint64_t purpose) const
{
    // 4 bits of purpose, 20 of processor, 40 of what the purpose counts
    return (purpose << 60) | (std::uint64_t(Pstream::myProcNo()) << 40);
}


bool Foam::dsmcGas::samplingNow() const
{
    return
        means_.valid()
     && mesh_.time().value()
      > samplingStart_ - 0.5*mesh_.time().deltaTValue()
     && mesh_.time().timeIndex() % samplingEvery_ == 0;
}


void Foam::dsmcGas::report()
{
    events e = recent_;
    e.sumOverProcessors();
    total_.add(e);
    recent_ = events();

    label n = molecules_.size();
    scalar energy = 0, internal = 0, mass = 0;
    vector momentum(Zero);
    for (label i = 0; i < n; ++i)
    {
        const scalar m = species_[molecules_.payload().typeId[i]].mass;
        const impact::vector3 u = molecules_.velocity(i);
        mass += m;
        momentum += m*vector(u.x, u.y, u.z);
        energy += 0.5*m*dot(u, u);
        internal += molecules_.payload().Ei[i];
    }
    reduce(n, sumOp<label>());
    reduce(mass, sumOp<scalar>());
    reduce(momentum, sumOp<vector>());
    reduce(energy, sumOp<scalar>());
    reduce(internal, sumOp<scalar>());

    Info<< "Time = " << mesh_.time().timeName() << nl
        << "    molecules: " << n;
    if (e.entered || e.left)
    {
        Info<< " (+" << whole(e.entered) << " entered, -" << whole(e.left)
            << " left)";
    }
    Info<< nl;
    if (collisions_.valid())
    {
        Info<< "    collisions per step: " << e.collisions/e.steps
            << ", accepted "
            << 100*e.collisions/max(e.candidates, scalar(1))
            << " % of the candidates" << nl;
    }
    if (e.hits)
    {
        Info<< "    wall hits per step: " << e.hits/e.steps << nl;
    }
    Info<< "    mass: " << weight_*mass << " kg, momentum: "
        << weight_*momentum << " kg m/s" << nl
        << "    energy: " << weight_*(energy + internal) << " J, of it "
        << weight_*internal << " J internal" << nl << endl;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dsmcGas::dsmcGas(const fvMesh& mesh, const convexCells& cells)
:
    regIOobject
    (
        IOobject
        (
            typeName,
            mesh.time().timeName(),
            mesh,
            IOobject::NO_READ,
            IOobject::AUTO_WRITE
        )
    ),
    mesh_(mesh),
    properties_
    (
        IOobject
        (
            "dsmcProperties",
            mesh.time().constant(),
            mesh,
            IOobject::MUST_READ,
            IOobject::NO_WRITE
        )
    ),
    weight_(0),
    seed_(0),
    cells_(cells),
    molecules_(cells_),
    sigmaTcRMax_
    (
        IOobject
        (
            "dsmcSigmaTcRMax",
            mesh.time().timeName(),
            mesh,
            IOobject::READ_IF_PRESENT,
            IOobject::AUTO_WRITE
        ),
        mesh,
        dimensionedScalar(dimVolume/dimTime, Zero),
        "zeroGradient"
    ),
    samplingStart_(0),
    samplingEvery_(1),
    reportEvery_(10),
    nStart_(0),
    moveTime_(0),
    collideTime_(0),
    sampleTime_(0)
{
    checkEntries();
    readSpecies();
    readCollisions();
    readWalls();
    inflow_.reset
    (
        new freeStream
        (
            properties_,
            cells_,
            names_,
            species_,
            weight_,
            boundaryT_.valid() ? &boundaryT_() : nullptr,
            boundaryU_.valid() ? &boundaryU_() : nullptr
        )
    );
    makeBoxes();
    readMolecules();
    if (mesh.time().startTimeIndex() == 0)
    {
        findMaxima();
    }
    readSampling();
    describe();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::dsmcGas::move()
{
    const scalar deltaT = mesh_.time().deltaTValue();
    clock_t since = std::clock();

    recent_.steps += 1;
    recent_.entered += inflow_->enter
    (
        molecules_,
        deltaT,
        seed_,
        stream(forInflow),
        mesh_.time().timeIndex()
    );
    recent_.moleculeSteps += molecules_.size();

    if (instantaneous_.valid())
    {
        instantaneous_->reset();
    }
    boundaries boundary(*this, samplingNow());
    molecules_.move(deltaT, boundary);
    recent_.hits += boundary.hits;
    recent_.left += boundary.left;
    moveTime_ += lap(since);
}


void Foam::dsmcGas::collide()
{
    if (!collisions_.valid())
    {
        return;
    }

    clock_t since = std::clock();
    const scalar deltaT = mesh_.time().deltaTValue();
    const std::uint64_t key = stream(forCollisions);
    const std::uint32_t step = mesh_.time().timeIndex();
    const scalarField& V = mesh_.V();
    scalarField& sigmaCMax = sigmaTcRMax_.primitiveFieldRef();

    impact::cellCollisions::counts counts;
    for (label celli = 0; celli < mesh_.nCells(); ++celli)
    {
        const label first = molecules_.begin(celli);
        const impact::cellCollisions::molecules gas =
        {
            molecules_.begin(celli + 1) - first,
            molecules_.x() + first,
            molecules_.y() + first,
            molecules_.z() + first,
            molecules_.u() + first,
            molecules_.v() + first,
            molecules_.w() + first,
            molecules_.payload().Ei.data() + first,
            molecules_.payload().typeId.data() + first
        };
        collisions_->collide
        (
            gas,
            boxes_[celli],
            weight_*deltaT/V[celli],
            sigmaCMax[celli],
            key + celli,
            step,
            counts
        );
    }
    recent_.candidates += counts.candidates;
    recent_.collisions += counts.collisions;
    collideTime_ += lap(since);
}


void Foam::dsmcGas::record()
{
    clock_t since = std::clock();
    const scalar deltaT = mesh_.time().deltaTValue();
    if (instantaneous_.valid())
    {
        instantaneous_->addStep(molecules_, deltaT);
        instantaneous_->update();
    }
    if (samplingNow())
    {
        means_->addStep(molecules_, deltaT);
    }
    if (means_.valid() && mesh_.time().writeTime())
    {
        means_->update();
    }
    sampleTime_ += lap(since);

    const label step = mesh_.time().timeIndex();
    if
    (
        mesh_.time().writeTime()
     || step == mesh_.time().startTimeIndex() + 1
     || step % reportEvery_ == 0
    )
    {
        report();
    }
}


void Foam::dsmcGas::account(runSummary& summary) const
{
    events e = recent_;
    e.sumOverProcessors();
    e.add(total_);
    const label n = returnReduce(molecules_.size(), sumOp<label>());
    const label lost = returnReduce(molecules_.nLost(), sumOp<label>());
    const scalar time =
        returnReduce(moveTime_ + collideTime_ + sampleTime_, sumOp<scalar>());

    Info<< "Molecules: " << nStart_ << " at the start + "
        << whole(e.entered) << " entered - " << whole(e.left) << " left - "
        << lost << " lost = " << n
        << " now" << nl;
    if (nStart_ + e.entered - e.left - lost != n)
    {
        FatalErrorInFunction
            << "The balance of molecules does not close"
            << exit(FatalError);
    }
    Info<< "Collisions: " << whole(e.collisions) << " in " << whole(e.steps)
        << " steps, " << e.moleculeSteps/max(time, SMALL)
        << " molecule-steps per CPU s" << nl << endl;

    summary.part("gas, moving", moveTime_);
    summary.part("gas, colliding", collideTime_);
    summary.part("gas, sampling", sampleTime_);
    summary.particles
    (
        {
            "molecules", scalar(nStart_), e.entered, scalar(n), true, e.left, 0
        }
    );
}


bool Foam::dsmcGas::writeObject(FOAM_COMPAT_WRITE_ARGS_UNUSED) const
{
    lagrangianFile::write
    (
        mesh_,
        cloudName,
        cloudHeader,
        const_cast<moleculeArray&>(molecules_)
    );
    if (means_.valid())
    {
        means_->writeState();
    }
    return true;
}
