/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "solidParticles.H"
#include "solidWalls.H"
#include "checked.H"
#include "coreVector.H"
#include "presentFile.H"
#include "processorTime.H"
#include "drawPurpose.H"

namespace Foam
{
    defineTypeNameAndDebug(solidParticles, 0);
}


// * * * * * * * * * * * * * * * * Boundaries  * * * * * * * * * * * * * * * //

class Foam::solidParticles::boundaries
{
    solidParticles& solids_;
    solidFields* const fields_;
    const volVectorField* const boundaryU_;

    //- The one that meets a wall
    solidParcel parcel_;


public:

    explicit boundaries(solidParticles& solids)
    :
        solids_(solids),
        fields_
        (
            solids.fields_.valid() && solids.fields_->samplingNow()
          ? &solids.fields_() : nullptr
        ),
        boundaryU_(solids.gas_.boundaryU()),
        parcel_(solids.mesh_)
    {}

    void leave(const label i, const label boundaryFacei)
    {
        solids_.count(solids_.tally_[left], i);
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
        const label,
        const scalar timeLeft
    )
    {
        solidArray& particles = solids_.particles_;
        solidData& data = particles.payload();
        const auto& face = solids_.cells_.boundary()[boundaryFacei];
        const label group = data.group[i];
        const vector Uw
        (
            boundaryU_
          ? boundaryU_->boundaryField()[face.patch][face.patchFace]
          : vector(Zero)
        );
        const polyPatch& patch = solids_.mesh_.boundaryMesh()[face.patch];
        parcel_.active(true);
        parcel_.cell() = solids_.cells_.meshCell(particles.cell(i));
        parcel_.face() = patch.start() + face.patchFace;
        parcel_.stepFraction() =
            1 - timeLeft/solids_.mesh_.time().deltaTValue();
        parcel_.position() = fromCore(particles.position(i));
        parcel_.U() = fromCore(particles.velocity(i));
        parcel_.d() = solids_.groups_[group].diameter;
        parcel_.rho() = solids_.material_.density;
        parcel_.nParticle() = data.nParticle[i];
        parcel_.temperature() = data.T[i];
        if (data.spins)
        {
            parcel_.omega() = fromCore(data.omega[i]);
        }
        parcel_.origProc() = data.origProc[i];
        parcel_.origId() = data.origId[i];
        ++solids_.hits_;
        if (fields_)
        {
            fields_->addHit
            (
                boundaryFacei, group, data.nParticle[i],
                magSqr(parcel_.U() - Uw), data.T[i]
            );
        }

        switch (solids_.walls_->meet(parcel_, face.patch, fromCore(n), Uw))
        {
            case solidWalls::stays:
            {
                solids_.count(solids_.tally_[stuck], i);
                solids_.count(solids_.deposits_[face.patch], i);
                return false;
            }
            case solidWalls::leaves:
            {
                solids_.count(solids_.tally_[escaped], i);
                return false;
            }
            case solidWalls::rebounds:
            {
                break;
            }
        }
        particles.setVelocity(i, toCore(parcel_.U()));
        if (data.spins)
        {
            data.omega[i] = toCore(parcel_.omega());
        }
        return true;
    }
};


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::solidParticles::sumOverProcessors(impact::balance& b)
{
    vector P = fromCore(b.momentum);
    reduce(P, sumOp<vector>());
    reduce(b.energy, sumOp<scalar>());
    b.momentum = toCore(P);
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
        particles_.payload().group.data() + first,
        particles_.payload().spins
      ? particles_.payload().omega.data() + first : nullptr
    };
}


void Foam::solidParticles::count
(
    tally& t,
    const label i,
    const label sign
) const
{
    const solidData& data = particles_.payload();
    t.simulators += sign;
    t.number += sign*data.nParticle[i];
    t.mass += sign*data.nParticle[i]*groups_[data.group[i]].mass;
}


void Foam::solidParticles::name(const label first)
{
    solidData& data = particles_.payload();
    for (label i = first; i < particles_.size(); ++i)
    {
        data.origProc[i] = Pstream::myProcNo();
        data.origId[i] = nNamed_++;
        if (nNamed_ == labelMax)
        {
            FatalErrorInFunction
                << "This processor has put in " << nNamed_ << " simulated solid"
                << " particles, as many as can be told apart" << nl
                << "Set a larger realPerSimulator, or fewer simulators"
                << exit(FatalError);
        }
    }
}


void Foam::solidParticles::takeBack
(
    const std::vector<std::unique_ptr<solidParcel>>& released
)
{
    solidData& data = particles_.payload();
    for (const auto& p : released)
    {
        const impact::vector3 x = toCore(p->position());
        const label i = particles_.append
        (
            cells_.locate(p->cell(), x), x, toCore(p->U())
        );
        data.T[i] = p->temperature();
        data.nParticle[i] = p->nParticle();
        if (data.spins)
        {
            data.omega[i] = toCore(p->omega());
        }
        data.origProc[i] = p->origProc();
        data.origId[i] = p->origId();

        // Each group is a class of its own on the wall
        label group = 0;
        forAll(groups_, g)
        {
            const auto off = [&](const label k)
            {
                return mag(groups_[k].diameter - p->d());
            };
            group = off(g) < off(group) ? g : group;
        }
        data.group[i] = group;
        count(tally_[stuck], i, -1);
        count(deposits_[mesh_.boundaryMesh().whichPatch(p->face())], i, -1);
    }
    if (released.size())
    {
        particles_.update();
    }
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
        const auto gas = gas_.weight()*exchange_->of(gas_.moleculesOf(celli));
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
    sumOverProcessors(a.all);
    reduce(a.momentumScale, sumOp<scalar>());
    reduce(a.energyScale, sumOp<scalar>());
    return a;
}


std::uint64_t Foam::solidParticles::stream(const std::uint64_t purpose) const
{
    return (purpose << 60) | (std::uint64_t(Pstream::myProcNo()) << 40);
}


void Foam::solidParticles::exchangeInBusyCells()
{
    const processorTime timer(exchangeTime_);
    const scalar deltaT = mesh_.time().deltaTValue();
    const std::uint64_t key = stream(impact::drawPurpose::exchange);
    const std::uint32_t step = mesh_.time().timeIndex();
    const scalarField& V = cells_.volumes();
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
                    gas_.moleculesOf(celli), spheresOf(celli), gas_.weight(),
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
    particles_(cells),
    reportEvery_
    (
        getNumber<label>(properties_, "reportEvery", validRange::count, 10)
    ),
    deposits_(mesh.boundaryMesh().size())
{
    refuseOthers
    (
        properties_,
        {
            "material", "groups", "accommodation", "exchange", "deflection",
            "knudsenCorrection", "rotation", "realPerSimulator", "fills",
            "inflows", "walls", "cloudFunctions", "sampling", "interface",
            "reportEvery", "randomSeed"
        }
    );
    seed_ = getNumber<label>(properties_, "randomSeed", validRange::seed, 1);

    Info<< "Solid particles" << nl;
    readGroups();
    readExchange();
    readRotation();
    inflow_.reset(new solidInflow(properties_, cells, gas, groups_));
    readParticles();
    readTallies();
    readWalls();
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
            new solidFields
            (
                getBlock(properties_, "sampling"), mesh, cells.volumes(), mass
            )
        );
        checked
        (
            getBlock(properties_, "sampling"),
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
            new solidInterface(getBlock(properties_, "interface"), mesh)
        );
    }
    describe();
    warnOfLargeParticles();
}


Foam::solidParticles::~solidParticles() = default;


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::solidParticles::move()
{
    const processorTime timer(moveTime_);
    const scalar deltaT = mesh_.time().deltaTValue();
    const label before = particles_.size();
    inflow_->enter
    (
        particles_, deltaT, seed_, stream(impact::drawPurpose::entering),
        mesh_.time().timeIndex()
    );
    name(before);
    ownSteps_ += particles_.size();
    for (label i = before; i < particles_.size(); ++i)
    {
        count(tally_[entered], i);
    }
    if (interface_.valid())
    {
        interface_->beginStep();
    }
    cloud_->beginStep();
    boundaries boundary(*this);
    particles_.move(deltaT, boundary);
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

    exchangeInBusyCells();
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
    takeBack(cloud_->endStep(particles_.size(), reportNow()));
    if (reportNow())
    {
        report();
    }
}
