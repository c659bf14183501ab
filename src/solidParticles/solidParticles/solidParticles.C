/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "solidParticles.H"
#include "coreVector.H"
#include "lagrangianFile.H"
#include "processorPolyPatch.H"
#include "runSummary.H"
#include "sizeGroups.H"
#include "checked.H"
#include "presentFile.H"

#include <ctime>

namespace Foam
{
    defineTypeNameAndDebug(solidParticles, 0);

    static const word cloudName("solids");
    static const word cloudHeader("Cloud<passiveParticle>");
    static const word stateName("solidParticlesState");
    static const word ledgerNames[] =
        {"solidLedgerMomentum", "solidLedgerEnergy"};
    static const char* const fateNames[] =
        {"initial", "entered", "left", "stuck", "escaped"};

    // What random numbers are drawn for: the highest bits of their stream.
    // The gas has 1 to 3.
    enum solidPurpose : std::uint64_t
    {
        forExchange = 4,
        forEntering = 5
    };

    static scalar lapTime(clock_t& since)
    {
        const clock_t now = std::clock();
        const scalar time = scalar(now - since)/CLOCKS_PER_SEC;
        since = now;
        return time;
    }

    static void sumUp(impact::balance& b)
    {
        vector P = fromCore(b.momentum);
        reduce(P, sumOp<vector>());
        reduce(b.energy, sumOp<scalar>());
        b.momentum = toCore(P);
    }
}


// * * * * * * * * * * * * * * * * Boundaries  * * * * * * * * * * * * * * * //

class Foam::solidParticles::boundaries
{
    solidParticles& solids_;
    solidFields* const fields_;
    const volVectorField* const boundaryU_;

    void count(tally& t, const label i) const
    {
        const solidData& data = solids_.particles_.payload();
        ++t.simulators;
        t.number += data.nParticle[i];
        t.mass += data.nParticle[i]*solids_.groups_[data.group[i]].mass;
    }


public:

    explicit boundaries(solidParticles& solids)
    :
        solids_(solids),
        fields_
        (
            solids.fields_.valid() && solids.fields_->samplingNow()
          ? &solids.fields_() : nullptr
        ),
        boundaryU_(solids.gas_.boundaryU())
    {}

    void leave(const label i, const label boundaryFacei)
    {
        count(solids_.tally_[left], i);
        if (solids_.interface_.valid())
        {
            const solidArray& particles = solids_.particles_;
            const solidData& data = particles.payload();
            solids_.interface_->add
            (
                solids_.cells_.boundary()[boundaryFacei].patch,
                particles.position(i),
                particles.velocity(i),
                data.T[i],
                solids_.groups_[data.group[i]].diameter,
                data.nParticle[i]
            );
        }
    }

    bool hitWall
    (
        const label i,
        const label boundaryFacei,
        const impact::vector3& n,
        const label
    )
    {
        solidArray& particles = solids_.particles_;
        const solidData& data = particles.payload();
        const auto& face = solids_.cells_.boundary()[boundaryFacei];
        const label group = data.group[i];
        const impact::vector3 wall =
            boundaryU_
          ? toCore
            (
                boundaryU_->boundaryField()[face.patch][face.patchFace]
            )
          : impact::vector3{0, 0, 0};
        const impact::vector3 relative = particles.velocity(i) - wall;
        ++solids_.hits_;
        if (fields_)
        {
            fields_->addHit
            (
                boundaryFacei, group, data.nParticle[i],
                dot(relative, relative), data.T[i]
            );
        }

        const solidWalls::kind what = solids_.walls_->kindOf(face.patch);
        if (what == solidWalls::stick)
        {
            count(solids_.tally_[stuck], i);
            count(solids_.deposits_[face.patch], i);
            return false;
        }
        if (what == solidWalls::escape)
        {
            count(solids_.tally_[escaped], i);
            return false;
        }
        particles.setVelocity
        (
            i,
            wall + solids_.walls_->rebound
            (
                face.patch, n, 0.5*solids_.groups_[group].diameter, relative
            )
        );
        return true;
    }
};


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::solidParticles::readGroups()
{
    const dictionary& d = properties_.subDict("groups");
    const word type(getWordOf(d, "type", "", {"list", "lognormal"}));
    std::vector<impact::sizeGroups::group> sizes;
    if (type == "list")
    {
        refuseOthers(d, {"type", "diameters", "massFractions"});
        const scalarList diameters
        (
            getNumbers(d, "diameters", validRange::diameter)
        );
        const scalarList fractions
        (
            getNumbers(d, "massFractions", validRange::number)
        );
        sizes = checked
        (
            d,
            [&]
            {
                return impact::sizeGroups::list
                (
                    {diameters.begin(), diameters.end()},
                    {fractions.begin(), fractions.end()}
                );
            }
        );
    }
    else
    {
        refuseOthers
        (
            d, {"type", "radius", "deviation", "weighting", "classes"}
        );
        const word weighting
        (
            getWordOf(d, "weighting", "", {"number", "mass"})
        );
        const scalar radius = getNumber(d, "radius", validRange::diameter);
        const scalar deviation = getNumber(d, "deviation", "(1, 100]");
        const label classes = getNumber<label>(d, "classes", "[1, 100]");
        sizes = checked
        (
            d,
            [&]
            {
                return impact::sizeGroups::lognormal
                (
                    radius, deviation,
                    weighting == "mass"
                  ? impact::sizeGroups::weighting::mass
                  : impact::sizeGroups::weighting::number,
                    classes
                );
            }
        );
    }
    for (const auto& size : sizes)
    {
        groups_.append({size.diameter, 0, size.massFraction});
    }
}


void Foam::solidParticles::readExchange()
{
    typedef impact::solidExchange law;
    const dictionary& material = properties_.subDict("material");
    refuseOthers(material, {"density", "specificHeat"});
    const law::material m =
    {
        getNumber(material, "density", validRange::density),
        getNumber(material, "specificHeat", "(0, 1e9) J/(kg K)"),
        getNumber(properties_, "accommodation", validRange::share)
    };
    const word mode
    (
        getWord(properties_, "exchange", {"perCell", "perCollision", "none"})
    );
    const word deflection
    (
        getWord(properties_, "deflection", {"exact", "polynomial"})
    );
    std::vector<double> diameters;
    for (const auto& group : groups_)
    {
        diameters.push_back(group.diameter);
    }
    exchange_ = checked
    (
        properties_,
        [&]
        {
            return autoPtr<law>
            (
                new law
                (
                    gas_.species(), m, diameters,
                    mode == "perCell" ? law::mode::perCell
                  : mode == "perCollision" ? law::mode::perCollision
                  : law::mode::none,
                    deflection == "exact"
                  ? impact::sphereReflection::law::exact
                  : impact::sphereReflection::law::polynomial,
                    seed_
                )
            );
        }
    );
    forAll(groups_, g)
    {
        groups_[g].mass = exchange_->sizeOf(g).mass;
    }
    readCorrection();
    if (exchange_->twoWay())
    {
        ledger_.resize(mesh_.nCells());
        readLedger();
    }
}


void Foam::solidParticles::readCorrection()
{
    const word name("knudsenCorrection");
    if (!properties_.isDict(name))
    {
        getWord(properties_, name, {"off"});
        return;
    }
    const dictionary& dict = properties_.subDict(name);
    refuseOthers(dict, {"drag", "heat", "densityScale"});
    const auto law = [&]
    (
        const word& entry,
        const std::vector<std::string>& names
    )
    {
        wordList words(names.size());
        forAll(words, i)
        {
            words[i] = names[i];
        }
        return getWordOf(dict, entry, "", words);
    };
    const word drag(law("drag", impact::knudsenCorrection::dragLaws()));
    const word heat(law("heat", impact::knudsenCorrection::heatLaws()));
    const scalar densityScale =
        getNumber(dict, "densityScale", "(0, 1e12]", scalar(1));
    if (!(gas_.referenceTemperature() > 0))
    {
        FatalIOErrorInFunction(dict)
            << "A gas without collisions between its molecules has no"
            << " viscosity: its Knudsen number is infinite"
            << exit(FatalIOError);
    }
    checked
    (
        properties_,
        [&]
        {
            exchange_->correct
            (
                gas_.referenceTemperature(), drag, heat, densityScale
            );
            return true;
        }
    );
    Info<< "    exchange corrected for the Knudsen number by " << drag
        << " and " << heat;
    if (densityScale != 1)
    {
        Info<< ", in a gas " << densityScale << " times as dense";
    }
    Info<< endl;
}


void Foam::solidParticles::readLedger()
{
    const auto present = [&](const label k)
    {
        return IOobject
        (
            ledgerNames[k],
            mesh_.time().timeName(),
            mesh_,
            IOobject::MUST_READ,
            IOobject::NO_WRITE
        );
    };
    IOobject P = present(0);
    IOobject E = present(1);
    if
    (
        P.typeHeaderOk<volVectorField>(true)
     && E.typeHeaderOk<volScalarField>(true)
    )
    {
        const volVectorField momentum(P, mesh_);
        const volScalarField energy(E, mesh_);
        forAll(energy, i)
        {
            ledger_[i].momentum = toCore(momentum[i]);
            ledger_[i].energy = energy[i];
            nHolding_ += !ledger_[i].isZero();
        }
    }
}


void Foam::solidParticles::readParticles()
{
    const bool found = lagrangianFile::read(mesh_, cloudName, particles_);
    if (!found)
    {
        inflow_->fill(particles_, seed_);
    }
    const solidData& data = particles_.payload();
    for (label i = 0; i < particles_.size(); ++i)
    {
        if
        (
            data.group[i] < 0 || data.group[i] >= groups_.size()
         || !(data.nParticle[i] > 0) || !(data.T[i] >= 0)
        )
        {
            FatalErrorInFunction
                << "Solid particle " << i << " of "
                << mesh_.time().timePath()/"lagrangian"/cloudName
                << " has group " << data.group[i] << ", nParticle "
                << data.nParticle[i] << ", T " << data.T[i]
                << ". Valid range: 0 <= group < " << groups_.size()
                << ", nParticle > 0, T >= 0" << exit(FatalError);
        }
        tally& t = tally_[initial];
        ++t.simulators;
        t.number += data.nParticle[i];
        t.mass += data.nParticle[i]*groups_[data.group[i]].mass;
    }
}


void Foam::solidParticles::readTallies()
{
    IOdictionary state
    (
        IOobject
        (
            stateName,
            mesh_.time().timeName(),
            "uniform",
            mesh_,
            IOobject::READ_IF_PRESENT,
            IOobject::NO_WRITE,
            false
        )
    );
    if (!state.found("initial"))
    {
        return;
    }

    // The state has the sums over processors: the master goes on with them
    const bool mine = Pstream::master();
    const auto restore = [&](const dictionary& d, tally& t)
    {
        t = tally();
        if (mine)
        {
            t.simulators = d.get<label>("simulators");
            t.number = d.get<scalar>("number");
            t.mass = d.get<scalar>("mass");
        }
    };
    for (label k = 0; k < nFates; ++k)
    {
        restore(state.subDict(fateNames[k]), tally_[k]);
    }
    label balance = 0;
    for (label k = 0; k < nFates; ++k)
    {
        const label n = nSimulators(fate(k));
        balance += k <= entered ? n : -n;
    }
    nLostBefore_ = balance - returnReduce(particles_.size(), sumOp<label>());
    hits_ = mine ? state.get<label>("hits") : 0;
    const dictionary& deposits = state.subDict("deposits");
    for (const entry& e : deposits)
    {
        const label patchi = mesh_.boundaryMesh().findPatchID(e.keyword());
        if (patchi >= 0)
        {
            restore(deposits.subDict(e.keyword()), deposits_[patchi]);
        }
    }
}


Foam::label Foam::solidParticles::nSimulators(const fate k) const
{
    return returnReduce(tally_[k].simulators, sumOp<label>());
}


void Foam::solidParticles::warnOfLargeParticles() const
{
    scalar d = 0;
    for (const auto& group : groups_)
    {
        d = max(d, group.diameter);
    }
    const scalar least = Foam::cbrt(gMin(mesh_.V()));
    label nSmall = 0;
    for (const scalar V : mesh_.V())
    {
        nSmall += d > Foam::cbrt(V);
    }
    reduce(nSmall, sumOp<label>());
    if (nSmall)
    {
        WarningInFunction
            << "The largest particles have a diameter of " << d
            << " m. " << nSmall << " of "
            << returnReduce(mesh_.nCells(), sumOp<label>())
            << " cells are smaller, the smallest has a width of " << least
            << " m (cube root of its volume)." << nl
            << "    Forces are those of the molecules of one cell: they need"
            << " particles far smaller than their cells" << endl;
    }
}


void Foam::solidParticles::warnOfLightParticles()
{
    scalarList least;
    forAll(groups_, g)
    {
        least.append(exchange_->leastNumber(g, gas_.weight()));
    }
    label nLight = 0;
    const solidData& data = particles_.payload();
    for (label i = 0; i < particles_.size(); ++i)
    {
        nLight += data.nParticle[i] < least[data.group[i]];
    }
    reduce(nLight, sumOp<label>());
    warnedOfLight_ = true;
    WarningInFunction
        << nLight << " of " << returnReduce(particles_.size(), sumOp<label>())
        << " simulated particles stand for so few real ones that a collision"
        << " with a simulated molecule, which stands for " << gas_.weight()
        << " real ones, could take nearly all of their heat." << nl
        << "    They exchange momentum and energy as with exchange perCell."
        << nl << "    Real particles for a simulated one that perCollision"
        << " needs, by group: " << flatOutput(least) << nl << endl;
}


void Foam::solidParticles::describe() const
{
    const label n = returnReduce(particles_.size(), sumOp<label>());
    Info<< "    " << groups_.size() << " groups, diameters (m), mass fractions"
        << ":" << nl;
    for (const auto& group : groups_)
    {
        Info<< "        " << group.diameter << "  " << group.massFraction
            << nl;
    }
    Info<< "    simulated particles: " << n << nl << endl;
}


bool Foam::solidParticles::reportNow() const
{
    const label step = mesh_.time().timeIndex();
    return
        mesh_.time().writeTime()
     || step == mesh_.time().startTimeIndex() + 1
     || step % reportEvery_ == 0;
}


impact::solidExchange::spheres Foam::solidParticles::spheresOf
(
    const label celli
)
{
    const label first = particles_.begin(celli);
    return
    {
        particles_.begin(celli + 1) - first,
        particles_.u() + first,
        particles_.v() + first,
        particles_.w() + first,
        particles_.payload().T.data() + first,
        particles_.payload().nParticle.data() + first,
        particles_.payload().group.data() + first
    };
}


impact::cellCollisions::molecules Foam::solidParticles::moleculesOf
(
    const label celli
)
{
    moleculeArray& molecules = gas_.molecules();
    const label first = molecules.begin(celli);
    return
    {
        molecules.begin(celli + 1) - first,
        molecules.x() + first,
        molecules.y() + first,
        molecules.z() + first,
        molecules.u() + first,
        molecules.v() + first,
        molecules.w() + first,
        molecules.payload().Ei.data() + first,
        molecules.payload().typeId.data() + first
    };
}


void Foam::solidParticles::findBusyCells()
{
    busy_.clear();
    if (!particles_.size() && !nHolding_)
    {
        return;
    }
    for (label celli = 0; celli < mesh_.nCells(); ++celli)
    {
        if
        (
            particles_.begin(celli) != particles_.begin(celli + 1)
         || (!ledger_.empty() && !ledger_[celli].isZero())
        )
        {
            busy_.push_back(celli);
        }
    }
}


Foam::solidParticles::contents Foam::solidParticles::contentsOfBusyCells()
{
    contents a;
    for (const label celli : busy_)
    {
        const auto gas = gas_.weight()*exchange_->of(moleculesOf(celli));
        const auto solids = exchange_->of(spheresOf(celli));
        a.all += gas;
        a.all += solids;
        if (!ledger_.empty())
        {
            a.all += ledger_[celli];
        }
        a.momentumScale += mag(gas.momentum) + mag(solids.momentum);
        a.energyScale += gas.energy + solids.energy;
    }
    sumUp(a.all);
    reduce(a.momentumScale, sumOp<scalar>());
    reduce(a.energyScale, sumOp<scalar>());
    return a;
}


std::uint64_t Foam::solidParticles::stream(const std::uint64_t purpose) const
{
    return (purpose << 60) | (std::uint64_t(Pstream::myProcNo()) << 40);
}


void Foam::solidParticles::report()
{
    impact::solidExchange::counts c = counts_;
    for
    (
        std::int64_t* value :
        {
            &c.pairs, &c.candidates, &c.collisions, &c.beyond, &c.holding,
            &c.light
        }
    )
    {
        scalar x = *value;
        reduce(x, sumOp<scalar>());
        *value = std::int64_t(x + 0.5);
    }
    reduce(c.greatestHits, maxOp<scalar>());
    reduce(c.leastForce, minOp<scalar>());
    impact::solidExchange::gains g = gains_;
    sumUp(g.solids);
    sumUp(g.gas);

    tally now;
    const solidData& data = particles_.payload();
    for (label i = 0; i < particles_.size(); ++i)
    {
        now.number += data.nParticle[i];
        now.mass += data.nParticle[i]*groups_[data.group[i]].mass;
    }
    now.simulators = returnReduce(particles_.size(), sumOp<label>());
    reduce(now.number, sumOp<scalar>());
    reduce(now.mass, sumOp<scalar>());

    if (c.light && !warnedOfLight_)
    {
        warnOfLightParticles();
    }
    const scalar perTime = 1/duration_;
    Info<< "    solid particles: " << now.simulators << " for " << now.number
        << " real ones, " << now.mass << " kg" << nl
        << "    solids gain: " << perTime*fromCore(g.solids.momentum)
        << " N, " << perTime*g.solids.energy << " W" << nl;
    if (c.leastForce < 1)
    {
        Info<< "    least force over the free-molecular one: "
            << c.leastForce << nl;
    }
    if (exchange_->twoWay())
    {
        Info<< "    gas gains by collisions: "
            << perTime*fromCore(g.gas.momentum) << " N, "
            << perTime*g.gas.energy << " W" << nl
            << "    collisions with solids: " << c.collisions << " of "
            << c.candidates << " candidates; greatest number of hits of a"
            << " molecule in a step: " << c.greatestHits << nl;
        if (c.light)
        {
            Info<< "    particles that exchange by the cell, in the steps: "
                << c.light << nl;
        }
        if (c.beyond)
        {
            Info<< "    " << c.beyond << " of them beyond the greatest relative"
                << " speed, which collisions have changed" << nl;
        }
        if (!ledger_.empty())
        {
            impact::balance owed;
            if (nHolding_)
            {
                for (const impact::balance& b : ledger_)
                {
                    owed += b;
                }
            }
            sumUp(owed);
            Info<< "    ledger: " << fromCore(owed.momentum) << " kg m/s, "
                << owed.energy << " J; cells with an entry in the steps: "
                << c.holding << nl;
        }
        Info<< "    gas + solids + ledger change in this step by: "
            << momentumError_ << " of momentum, " << energyError_
            << " of energy" << nl;
    }
    Info<< endl;

    counts_ = impact::solidExchange::counts();
    gains_ = impact::solidExchange::gains();
    duration_ = 0;
}


void Foam::solidParticles::writeLedger() const
{
    if (!returnReduce(nHolding_, sumOp<label>()))
    {
        return;
    }
    volVectorField momentum
    (
        IOobject(ledgerNames[0], mesh_.time().timeName(), mesh_),
        mesh_,
        dimensionedVector(dimMass*dimVelocity, Zero),
        "zeroGradient"
    );
    volScalarField energy
    (
        IOobject(ledgerNames[1], mesh_.time().timeName(), mesh_),
        mesh_,
        dimensionedScalar(dimEnergy, Zero),
        "zeroGradient"
    );
    forAll(energy, i)
    {
        momentum[i] = fromCore(ledger_[i].momentum);
        energy[i] = ledger_[i].energy;
    }
    momentum.write();
    energy.write();
}


void Foam::solidParticles::writeTallies() const
{
    IOdictionary state
    (
        IOobject
        (
            stateName,
            mesh_.time().timeName(),
            "uniform",
            mesh_,
            IOobject::NO_READ,
            IOobject::NO_WRITE,
            false
        )
    );
    const auto sums = [](tally t)
    {
        dictionary d;
        d.add("simulators", returnReduce(t.simulators, sumOp<label>()));
        d.add("number", returnReduce(t.number, sumOp<scalar>()));
        d.add("mass", returnReduce(t.mass, sumOp<scalar>()));
        return d;
    };
    for (label k = 0; k < nFates; ++k)
    {
        state.add(fateNames[k], sums(tally_[k]));
    }
    state.add("hits", returnReduce(hits_, sumOp<label>()));
    dictionary deposits;
    const polyBoundaryMesh& patches = mesh_.boundaryMesh();
    forAll(patches, patchi)
    {
        if (!isA<processorPolyPatch>(patches[patchi]))
        {
            deposits.add(patches[patchi].name(), sums(deposits_[patchi]));
        }
    }
    state.add("deposits", deposits);

    // A restart goes on with the same bits, whatever writePrecision is
    const unsigned precision = IOstream::defaultPrecision(17);
    state.regIOobject::write();
    IOstream::defaultPrecision(precision);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::autoPtr<Foam::solidParticles> Foam::solidParticles::New
(
    const fvMesh& mesh,
    const convexCells& cells,
    dsmcGas& gas
)
{
    IOobject file
    (
        "solidParticleProperties",
        mesh.time().constant(),
        mesh,
        IOobject::MUST_READ,
        IOobject::NO_WRITE,
        false
    );
    if (!isPresent<IOdictionary>(file))
    {
        Info<< "Solid particles: none (there is no file"
            << " constant/solidParticleProperties)" << nl << endl;
        return autoPtr<solidParticles>();
    }
    return autoPtr<solidParticles>(new solidParticles(mesh, cells, gas));
}


Foam::solidParticles::solidParticles
(
    const fvMesh& mesh,
    const convexCells& cells,
    dsmcGas& gas
)
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
    cells_(cells),
    gas_(gas),
    properties_
    (
        IOobject
        (
            "solidParticleProperties",
            mesh.time().constant(),
            mesh,
            IOobject::MUST_READ,
            IOobject::NO_WRITE
        )
    ),
    seed_(0),
    particles_(cells),
    nHolding_(0),
    reportEvery_
    (
        getNumber<label>(properties_, "reportEvery", validRange::count, 10)
    ),
    hits_(0),
    nLostBefore_(0),
    nStart_(0),
    deposits_(mesh.boundaryMesh().size()),
    duration_(0),
    momentumError_(0),
    energyError_(0),
    moveTime_(0),
    exchangeTime_(0),
    warnedOfLight_(false)
{
    refuseOthers
    (
        properties_,
        {
            "material", "groups", "accommodation", "exchange", "deflection",
            "knudsenCorrection", "realPerSimulator", "fills", "inflows",
            "walls", "sampling", "interface", "reportEvery", "randomSeed"
        }
    );
    seed_ = getNumber<label>(properties_, "randomSeed", validRange::seed, 1);

    Info<< "Solid particles" << nl;
    readGroups();
    readExchange();
    walls_.reset(new solidWalls(properties_, mesh));
    inflow_.reset(new solidInflow(properties_, cells, gas, groups_));
    readParticles();
    readTallies();
    nStart_ = returnReduce(particles_.size(), sumOp<label>());
    for (label k = 0; k < nFates; ++k)
    {
        before_[k] = nSimulators(fate(k));
    }
    if (properties_.found("sampling"))
    {
        scalarList mass;
        for (const auto& group : groups_)
        {
            mass.append(group.mass);
        }
        fields_.reset
        (
            new solidFields(properties_.subDict("sampling"), mesh, mass)
        );
        checked
        (
            properties_.subDict("sampling"),
            [&]
            {
                exchange_->setTrials(fields_->trials());
                return true;
            }
        );
    }
    if (properties_.found("interface"))
    {
        interface_.reset
        (
            new solidInterface(properties_.subDict("interface"), mesh)
        );
    }
    describe();
    warnOfLargeParticles();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::solidParticles::move()
{
    clock_t since = std::clock();
    const scalar deltaT = mesh_.time().deltaTValue();
    const label before = particles_.size();
    inflow_->enter
    (
        particles_, deltaT, seed_, stream(forEntering),
        mesh_.time().timeIndex()
    );
    const solidData& data = particles_.payload();
    for (label i = before; i < particles_.size(); ++i)
    {
        tally& t = tally_[entered];
        ++t.simulators;
        t.number += data.nParticle[i];
        t.mass += data.nParticle[i]*groups_[data.group[i]].mass;
    }
    if (interface_.valid())
    {
        interface_->beginStep();
    }
    boundaries boundary(*this);
    particles_.move(deltaT, boundary);
    moveTime_ += lapTime(since);
}


void Foam::solidParticles::exchange()
{
    findBusyCells();
    const bool checks = exchange_->twoWay() && reportNow();
    contents before;
    if (checks)
    {
        before = contentsOfBusyCells();
    }

    clock_t since = std::clock();
    const scalar deltaT = mesh_.time().deltaTValue();
    const std::uint64_t key = stream(forExchange);
    const std::uint32_t step = mesh_.time().timeIndex();
    const scalarField& V = mesh_.V();
    const bool samples =
        fields_.valid() && fields_->exchangeAsked() && fields_->samplingNow();
    impact::balance none;
    nHolding_ = 0;
    for (const label celli : busy_)
    {
        impact::balance& ledger = ledger_.empty() ? none : ledger_[celli];
        const auto g = checked
        (
            properties_,
            [&]
            {
                return exchange_->exchange
                (
                    moleculesOf(celli), spheresOf(celli), gas_.weight(),
                    V[celli], deltaT, ledger, key + celli, step, counts_
                );
            }
        );
        nHolding_ += !ledger.isZero();
        gains_.solids += g.solids;
        gains_.gas += g.gas;
        if (samples)
        {
            fields_->addGains(celli, g);
        }
    }
    duration_ += deltaT;
    exchangeTime_ += lapTime(since);

    if (checks)
    {
        const contents after = contentsOfBusyCells();
        const impact::balance change = after.all - before.all;
        momentumError_ =
            mag(change.momentum)/max(after.momentumScale, VSMALL);
        energyError_ = mag(change.energy)/max(after.energyScale, VSMALL);
    }
}


void Foam::solidParticles::record()
{
    if (fields_.valid())
    {
        if (fields_->samplingNow())
        {
            fields_->addStep(particles_);
        }
        if (mesh_.time().writeTime())
        {
            fields_->update();
        }
    }
    if (reportNow())
    {
        report();
    }
}


void Foam::solidParticles::account(runSummary& summary) const
{
    const auto sums = [](tally t)
    {
        reduce(t.simulators, sumOp<label>());
        reduce(t.number, sumOp<scalar>());
        reduce(t.mass, sumOp<scalar>());
        return t;
    };
    Info<< "Solid particles (simulated, real, kg)" << nl;
    label balance = 0;
    for (label k = 0; k < nFates; ++k)
    {
        const tally t = sums(tally_[k]);
        Info<< "    " << fateNames[k] << ": " << t.simulators << "  "
            << t.number << "  " << t.mass << nl;
        balance += k <= entered ? t.simulators : -t.simulators;
    }
    const label n = returnReduce(particles_.size(), sumOp<label>());
    const label lost =
        nLostBefore_ + returnReduce(particles_.nLost(), sumOp<label>());
    Info<< "    lost: " << lost << ", now: " << n << nl
        << "    wall hits: " << returnReduce(hits_, sumOp<label>()) << nl;
    const polyBoundaryMesh& patches = mesh_.boundaryMesh();
    forAll(patches, patchi)
    {
        if (isA<processorPolyPatch>(patches[patchi]))
        {
            break;
        }
        const tally t = sums(deposits_[patchi]);
        if (t.simulators)
        {
            Info<< "    deposited on " << patches[patchi].name() << ": "
                << t.simulators << "  " << t.number << "  " << t.mass << nl;
        }
    }
    Info<< endl;
    if (interface_.valid())
    {
        interface_->info();
    }
    if (balance - lost != n)
    {
        FatalErrorInFunction
            << "The balance of solid particles does not close"
            << exit(FatalError);
    }

    const auto inThisRun = [&](const fate k)
    {
        return scalar(nSimulators(k) - before_[k]);
    };
    summary.part("solids, moving", moveTime_);
    summary.part("solids, exchange", exchangeTime_);
    summary.particles
    (
        {
            "solids", scalar(nStart_), inThisRun(entered), scalar(n), true,
            inThisRun(left) + inThisRun(escaped), inThisRun(stuck)
        }
    );
}


bool Foam::solidParticles::writeObject(FOAM_COMPAT_WRITE_ARGS_UNUSED) const
{
    lagrangianFile::write
    (
        mesh_,
        cloudName,
        cloudHeader,
        const_cast<solidArray&>(particles_)
    );
    scalarField d(particles_.size());
    forAll(d, i)
    {
        d[i] = groups_[particles_.payload().group[i]].diameter;
    }
    lagrangianFile::writeField<scalar>(mesh_, cloudName, "d", d);
    if (!ledger_.empty())
    {
        writeLedger();
    }
    writeTallies();
    if (fields_.valid())
    {
        fields_->writeState();
    }
    if (interface_.valid())
    {
        interface_->write();
    }
    return true;
}
