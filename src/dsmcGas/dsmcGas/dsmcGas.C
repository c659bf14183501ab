/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "dsmcGas.H"
#include "checked.H"
#include "maxwellian.H"
#include "processorTime.H"
#include "drawPurpose.H"
#include "maxwellWall.H"

namespace Foam
{
    defineTypeNameAndDebug(dsmcGas, 0);
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
        stream_(gas.stream(impact::drawPurpose::walls)),
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
        const label nHits,
        const scalar
    );
};


bool Foam::dsmcGas::boundaries::hitWall
(
    const label i,
    const label boundaryFacei,
    const impact::vector3& n,
    const label nHits,
    const scalar
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
    if (maxwellWall::isDiffuse(gas_.diffuseFraction_[face.patch], rnd))
    {
        const scalar T =
            gas_.boundaryT_->boundaryField()[face.patch][face.patchFace];
        const vector& U =
            gas_.boundaryU_->boundaryField()[face.patch][face.patchFace];
        after = maxwellWall::diffuse
        (
            n, {U.x(), U.y(), U.z()}, T, kind.mass,
            kind.internalDegreesOfFreedom, Ei, rnd
        );
    }
    else
    {
        after = maxwellWall::specular(n, before);
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
    const processorTime timer(moveTime_);
    const scalar deltaT = mesh_.time().deltaTValue();

    recent_.steps += 1;
    recent_.entered += inflow_->enter
    (
        molecules_,
        deltaT,
        seed_,
        stream(impact::drawPurpose::inflow),
        mesh_.time().timeIndex()
    );
    recent_.moleculeSteps += molecules_.size();
    ownSteps_ += molecules_.size();

    if (instantaneous_.valid())
    {
        instantaneous_->reset();
    }
    boundaries boundary(*this, samplingNow());
    molecules_.move(deltaT, boundary);
    recent_.hits += boundary.hits;
    recent_.left += boundary.left;
}


void Foam::dsmcGas::collide()
{
    if (!collisions_.valid())
    {
        return;
    }

    const processorTime timer(collideTime_);
    const scalar deltaT = mesh_.time().deltaTValue();
    const std::uint64_t key = stream(impact::drawPurpose::collisions);
    const std::uint32_t step = mesh_.time().timeIndex();
    const scalarField& V = cells_.volumes();
    scalarField& sigmaCMax = sigmaTcRMax_.primitiveFieldRef();

    impact::cellCollisions::counts counts;
    for (label celli = 0; celli < mesh_.nCells(); ++celli)
    {
        collisions_->collide
        (
            moleculesOf(celli),
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
}


void Foam::dsmcGas::sample()
{
    const processorTime timer(sampleTime_);
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
}


void Foam::dsmcGas::record()
{
    sample();
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
