/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "JkrAdhesion.H"
#include "writtenState.H"
#include "counterRandom.H"
#include "scatteringEntries.H"
#include "stockCloudEntries.H"
#include "withheldOutput.H"

namespace Foam
{

//- What parcels of certain kinds have of their own: a past that is to be
//  forgotten, a density that follows from the temperature
namespace parcelKind
{

template<class Parcel>
auto forgetForces(Parcel& p, int)
 -> decltype(p.f() = vector(Zero), p.torque() = vector(Zero), void())
{
    p.f() = vector(Zero);
    p.torque() = vector(Zero);
    p.collisionRecords() = std::decay_t<decltype(p.collisionRecords())>();
}

template<class Parcel>
void forgetForces(Parcel&, long)
{}


template<class Parcel>
auto setInitialMass(Parcel& p, int) -> decltype(p.mass0() = 0, void())
{
    p.mass0() = p.mass();
}

template<class Parcel>
void setInitialMass(Parcel&, long)
{}


//- The density of a droplet follows from its temperature: it keeps the mass
template<class Parcel>
auto setSize(Parcel& p, const scalar d, const scalar rho, int)
 -> decltype(p.liquidCore(), void())
{
    p.d() = d*cbrt(rho/p.rho());
}

template<class Parcel>
void setSize(Parcel& p, const scalar d, const scalar rho, long)
{
    p.d() = d;
    p.rho() = rho;
}

} // End namespace parcelKind

} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

template<class CloudType>
int Foam::JkrAdhesion<CloudType>::partner(parcelType& p, const label item)
{
    if (!(layer_.state().coverage(item) > 0))
    {
        return -1;
    }
    const impact::impactKey key
    (
        keys_(p, this->owner().db().time().timeIndex())
    );
    impact::counterRandom random
    (
        key.seed, key.stream, impact::drawPurpose::partner
    );
    return layer_.state().partner(item, random.uniform());
}


template<class CloudType>
Foam::wallLayer::strikeType Foam::JkrAdhesion<CloudType>::strike
(
    const parcelType& p,
    const polyPatch& pp,
    const int sizeClass
) const
{
    return
    {
        pp.index(),
        pp.whichFace(p.face()),
        sizeClass,
        p.origProc(),
        p.origId(),
        p.currentTimeFraction(),
        p.nParticle()
    };
}


template<class CloudType>
std::unique_ptr<Foam::particle> Foam::JkrAdhesion<CloudType>::released
(
    const parcelType& p,
    const wallHit& hit,
    const impact::sphereState& s,
    scalar& energy
) const
{
    auto q = std::make_unique<parcelType>(p);
    vector V(fromCore(s.V));
    this->reduceDimensions(V);
    q->U() = V + hit.Uw;
    q->active(true);
    q->age() = 0;
    q->tTurb() = 0;
    q->UTurb() = vector(Zero);
    parcelKind::forgetForces(*q, 0);
    if constexpr (parcelSpin::countsImpacts<parcelType>)
    {
        q->nImpacts() = 0;
    }

    // Until its size is known: a sphere's spin, in place of what it has
    parcelSpin::set(*q, this->spins() ? fromCore(s.omega) : vector(Zero));
    energy = impact::translationalEnergy(toCore(V));
    this->lift(*q);
    return q;
}


template<class CloudType>
void Foam::JkrAdhesion<CloudType>::add(wallLayer::release& r)
{
    parcelType* p = static_cast<parcelType*>(r.parcel.release());
    const vector omega(parcelSpin::get(*p));
    parcelKind::setSize(*p, r.d, r.rho, 0);
    p->dTarget() = p->d();
    p->nParticle() = r.number;
    p->origProc() = wallLayer::releasedProc;
    p->origId() = r.identity;
    parcelSpin::set(*p, omega);
    parcelKind::setInitialMass(*p, 0);

    wallCounters& counters = wallCounters::New(this->owner());
    counters.release();
    wallCounters::counts& c = counters.of(r.patch);
    const scalar mass = r.number*p->mass();
    c[wallCounters::special + detachedParticles] += r.number;
    c[wallCounters::special + detachedMass] += mass;
    c[wallCounters::special + detachedEnergy] += mass
       *(
            r.energy
          + impact::sphereRotationalEnergy(0.5*r.d, toCore(omega))
        );
    this->owner().addParticle(p);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

template<class CloudType>
Foam::JkrAdhesion<CloudType>::JkrAdhesion
(
    const dictionary& dict,
    CloudType& owner
)
:
    ParcelWallModel<CloudType>
    (
        dict,
        owner,
        typeName,
        {
            "rebounded", "hits on adhered particles",
            "detached particles", "detached mass", "energy of the detached"
        },
        {"seed", "sizeClasses"}
    ),
    wallOf_(this->patches().size(), -1),
    layer_
    (
        wallLayer::New
        (
            owner,
            owner.mesh(),
            [&]()
            {
                const scalarList bounds
                (
                    getList
                    (
                        this->coeffDict(), "sizeClasses",
                        validRange::diameter, scalarList()
                    )
                );
                return std::vector<double>(bounds.begin(), bounds.end());
            }(),
            this->coeffDict()
        )
    ),
    keys_(scatteringEntries::getSeed(this->coeffDict()))
{
    stockCloudEntries::refuseSteady(owner, typeName);
    const fileName casePath(owner.db().time().globalPath());
    forAll(wallOf_, i)
    {
        if (this->fate(i) == ParcelWallModel<CloudType>::fateType::rebound)
        {
            wallOf_[i] = label(walls_.size());
            walls_.push_back
            (
                adhesionEntries::wall
                (
                    wallPatches::law(this->patches()[i]), casePath
                )
            );
        }
    }
    layer_.nReleased() = max
    (
        layer_.nReleased(),
        this->template getModelProperty<label>("nReleased")
    );

    if (this->nested())
    {
        // Before the report of what it counts
        auto& functions = owner.functions();
        const label n = functions.size();
        functions.append(new JkrAdhesionStep<CloudType>(owner, *this));
        labelList oldToNew(n + 1);
        forAll(oldToNew, i)
        {
            oldToNew[i] = i < n ? i + 1 : 0;
        }
        functions.reorder(oldToNew);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

template<class CloudType>
bool Foam::JkrAdhesion<CloudType>::correct
(
    parcelType& p,
    const polyPatch& pp,
    bool& keepParticle
)
{
    typedef impact::adhesiveRebound law;

    wallHit hit;
    if (!this->arrive(p, pp, keepParticle, hit))
    {
        return hit.handled;
    }

    const law& wall = walls_[wallOf_[hit.setting]];
    const law::sphere sphere = {p.d(), p.rho()};
    impact::sphereState s = {hit.V0, toCore(hit.omega0)};
    impact::sphereState s2;
    hit.rotation0 = impact::sphereRotationalEnergy(hit.radius, s.omega);

    const label item = layer_.item(pp.index(), pp.whichFace(p.face()));
    const int met = wall.hasLayer() ? partner(p, item) : -1;
    law::outcome out;
    try
    {
        if (met < 0)
        {
            out = wall.rebound(hit.n, sphere, s);
        }
        else
        {
            const impact::adheredParticles::particle mean =
                layer_.state().meanOf(item, met);
            out = wall.rebound
            (
                hit.n, sphere, s, {mean.diameter, mean.density}, s2
            );
            this->special(pp, onAdhered) += 1;
            undecided_ += !out.decided;
        }
    }
    catch (const std::invalid_argument& error)
    {
        FatalErrorInFunction
            << typeName << ", patch " << pp.name() << ", parcel ("
            << p.origProc() << ' ' << p.origId() << ") of diameter " << p.d()
            << " m at a normal speed of " << -dot(hit.V0, hit.n) << " m/s: "
            << error.what() << "; with 'outside hold;' the last alpha is kept"
            << exit(FatalError);
    }

    deepest_ = max(deepest_, out.overlap);
    if (out.detached)
    {
        scalar energy;
        auto parcel = released(p, hit, s2, energy);
        layer_.detach(strike(p, pp, met), std::move(parcel), energy);
    }
    if (out.captured)
    {
        layer_.deposit
        (
            strike(p, pp, layer_.state().classOf(p.d())), p.d(), p.mass()
        );
        this->capture(p, pp, hit, keepParticle);
        return true;
    }
    hit.V1 = s.V;
    hit.omega1 = s.omega;
    hit.rotation1 = impact::sphereRotationalEnergy(hit.radius, s.omega);
    this->special(pp, rebounded) += 1;
    this->leave(p, pp, hit);
    return true;
}


template<class CloudType>
void Foam::JkrAdhesion<CloudType>::endStep()
{
    for (wallLayer::release& r : layer_.settle())
    {
        add(r);
    }
    if (this->owner().db().time().writeTime())
    {
        layer_.write();
        writtenState::addParcels
        (
            this->owner().mesh(), this->owner(), this->owner().size()
        );
        this->setModelProperty("nReleased", layer_.nReleased());
    }
}


template<class CloudType>
void Foam::JkrAdhesion<CloudType>::report(Ostream& os) const
{
    if (withheldOutput::now())
    {
        return;
    }
    forAll(this->patches().ofPatch(), patchi)
    {
        const label i = this->patches().of(patchi);
        if (i >= 0 && wallOf_[i] >= 0)
        {
            layer_.report(os, patchi, typeName);
        }
    }

    const scalar deepest =
        warned_ ? 0 : returnReduce(deepest_, maxOp<scalar>());
    if (deepest > 0.1)
    {
        warned_ = true;
        WarningInFunction
            << typeName << ": the overlap of an impact is " << deepest
            << " of the particle's radius (of R* on an adhered particle)."
            << " The theory holds for a contact that is small against the"
            << " sphere (overlap below 0.1), and most materials yield before"
            << endl;
    }

    if (!warnedOfChains_ && returnReduce(undecided_, sumOp<scalar>()) > 0)
    {
        warnedOfChains_ = true;
        WarningInFunction
            << typeName << ": an impact on an adhered particle was not over"
            << " after the most steps of its integration: a particle that"
            << " could still leave counts as staying. Give both contacts an"
            << " alpha > 0, which lets the motion decay" << endl;
    }
}


template<class CloudType>
void Foam::JkrAdhesion<CloudType>::info(FOAM_COMPAT_INFO_ARGS)
{
    if (this->nested())
    {
        return;
    }
    endStep();
    ParcelWallModel<CloudType>::info(FOAM_COMPAT_INFO_PASS);
    report(FOAM_COMPAT_INFO_STREAM);
}
