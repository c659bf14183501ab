/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "EventDrivenCollisions.H"
#include "NoDispersion.H"
#include "checked.H"
#include "wedgePolyPatch.H"
#include "coupledPolyPatch.H"
#include "cyclicAMIPolyPatch.H"
#include "meshTools.H"
#include "vicinity.H"

#include <algorithm>
#include <limits>
#include <tuple>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

template<class CloudType>
impact::collisionDomain Foam::EventDrivenCollisions<CloudType>::domain
(
    const dictionary& dict,
    const polyMesh& mesh
)
{
    const boundBox& box = mesh.bounds();
    Vector<label> periodic(Zero);
    bool valid = true;
    for (const polyPatch& pp : mesh.boundaryMesh())
    {
        valid = valid && !isA<cyclicAMIPolyPatch>(pp);
        if (!isA<coupledPolyPatch>(pp) || pp.empty())
        {
            continue;
        }
        const coupledPolyPatch& cpp = refCast<const coupledPolyPatch>(pp);
        valid = valid && cpp.parallel();
        if (cpp.parallel() && cpp.separated())
        {
            const vector s(cpp.separation()[0]);
            label axis = 0;
            for (label k = 1; k < 3; ++k)
            {
                axis = mag(s[k]) > mag(s[axis]) ? k : axis;
            }
            periodic[axis] = 1;
            valid =
                valid
             && mag(mag(s[axis]) - mag(s)) <= 1e-9*mag(s)
             && mag(mag(s) - box.span()[axis]) <= 1e-9*mag(s);
        }
    }
    reduce(periodic, maxOp<Vector<label>>());
    reduce(valid, andOp<bool>());
    if (!valid)
    {
        refuse
        (
            dict, "collisions", "eventDriven", "off on a mesh with cyclic"
            " patches other than pairs of planes normal to a coordinate axis"
            " at the ends of the domain"
        );
    }

    impact::collisionDomain domain;
    domain.low = toCore(box.min());
    domain.high = toCore(box.max());
    for (label k = 0; k < 3; ++k)
    {
        domain.periodic[k] = periodic[k];
    }
    return domain;
}


template<class CloudType>
void Foam::EventDrivenCollisions<CloudType>::checkCloud() const
{
    const auto refuseHere =
        [&](const char* entry, const word& value, const char* range)
        {
            refuse
            (
                dict_, entry, value, range, " with collisions eventDriven"
            );
        };
    if
    (
        !isA<NoDispersion<typename CloudType::kinematicCloudType>>
            (cloud_.dispersion())
    )
    {
        refuseHere("dispersionModel", cloud_.dispersion().modelType(), "none");
    }
    if (cloud_.solution().cellValueSourceCorrection())
    {
        refuseHere("cellValueSourceCorrection", "on", "off");
    }
    if (cloud_.solution().steadyState())
    {
        refuseHere("transient", "no", "yes");
    }
    if (cloud_.mesh().dynamic())
    {
        refuseHere("collisions", "eventDriven", "off on a moving mesh");
    }
    const label n = cloud_.mesh().nGeometricD();
    if (dimension_ != n || n < 2)
    {
        refuse
        (
            dict_, "dimension", dimension_, "2 or 3, that of this mesh: ", n,
            ". A thin three-dimensional slab needs a mesh of that thickness"
            " between cyclic patches"
        );
    }

    if (dimension_ == 2)
    {
        checkThickness();
    }
}


template<class CloudType>
void Foam::EventDrivenCollisions<CloudType>::checkThickness() const
{
    // The number of real particles of a parcel refers to one thickness, and
    // parcels meet as circles in a plane: in a wedge neither holds
    const polyMesh& mesh = cloud_.mesh();
    bool even = true;
    for (const polyPatch& patch : mesh.boundaryMesh())
    {
        even = even && !isA<wedgePolyPatch>(patch);
    }
    const boundBox& box = mesh.bounds();
    for (direction k = 0; k < 3; ++k)
    {
        if (mesh.geometricD()[k] != 1)
        {
            const scalar tolerance = 1e-6*box.span()[k];
            for (const point& p : mesh.points())
            {
                even =
                    even
                 && (
                        p[k] - box.min()[k] < tolerance
                     || box.max()[k] - p[k] < tolerance
                    );
            }
        }
    }
    if (!returnReduce(even, andOp<bool>()))
    {
        refuse
        (
            dict_, "collisions", "eventDriven", "off on a wedge or another"
            " mesh of varying thickness. Collisions need a plane mesh of one"
            " thickness or three dimensions"
        );
    }
}


template<class CloudType>
void Foam::EventDrivenCollisions<CloudType>::checkNumber
(
    const parcelType& p
) const
{
    const scalar n = p.nParticle();
    const scalar slab = slabThickness_/p.d();
    if
    (
        mag(n - 1) > 1e-6
     && (dimension_ != 2 || mag(n - slab) > 1e-6*slab)
    )
    {
        FatalIOErrorInFunction(dict_)
            << "A parcel of nParticle " << n << " and diameter " << p.d()
            << " m, at " << p.position() << ": the valid range of nParticle"
            << " with collisions is 1";
        if (dimension_ == 2)
        {
            FatalIOError<< " or slabThickness/d = " << slab;
        }
        FatalIOError<< exit(FatalIOError);
    }
}


template<class CloudType>
void Foam::EventDrivenCollisions<CloudType>::collect()
{
    flights_.clear();
    grow(flights_, cloud_.size());
    label n = 0;
    for (parcelType& p : cloud_)
    {
        const bool injected = n++ >= nParcels_;
        p.stepFraction() = 0;
        if (p.active())
        {
            checkNumber(p);
            flights_.emplace_back(p);
            flight& f = flights_.back();
            f.injected = injected;
            f.x = p.position();
            f.placed = true;
        }
        else if (!p.move(cloud_, *td_, deltaT_))
        {
            cloud_.deleteParticle(p);
        }
    }
}


template<class CloudType>
void Foam::EventDrivenCollisions<CloudType>::admitInjected()
{
    scalar largest = 0;
    bool any = false;
    for (const flight& f : flights_)
    {
        largest = max(largest, f.parcel->d());
        any = any || f.injected;
    }
    reduce(any, orOp<bool>());
    if (!any)
    {
        return;
    }
    reduce(largest, maxOp<scalar>());

    // Others matter near new parcels only, or at the ends of a period
    const bool* periodic = step_.grid().domain().periodic;
    const bool all = periodic[0] || periodic[1] || periodic[2];
    vicinity ofNew(bounds_, directions_);
    for (const flight& f : flights_)
    {
        if (f.injected)
        {
            ofNew.add(f.x, 2*largest);
        }
    }
    ofNew.reduce();

    struct member
    {
        std::uint64_t identity;
        vector x;
        scalar d, mass;
        label rank, slot;
        bool injected;
    };
    struct pair
    {
        std::int32_t i, j, image;
    };

    // Moving a pair apart may bring one of them upon a third
    for (label sweep = 0; sweep < (separate_ ? 20 : 1); ++sweep)
    {
        std::vector<member> members;
        for (std::size_t i = 0; i < flights_.size(); ++i)
        {
            const flight& f = flights_[i];
            if (!f.parcel)
            {
                continue;
            }
            const parcelType& p = *f.parcel;
            const point x = f.placed ? f.x : p.position();
            if (f.injected || all || ofNew.near(x))
            {
                members.push_back
                ({
                    identityOf(p), x, p.d(), p.mass(), Pstream::myProcNo(),
                    label(i), f.injected
                });
            }
        }
        gather(members);

        label nOverlaps = 0;
        if (Pstream::master())
        {
            impact::sweptGrid grid(step_.grid().domain());
            grid.resize(members.size());
            for (std::size_t i = 0; i < members.size(); ++i)
            {
                const scalar r = 0.5*members[i].d;
                for (int k = 0; k < 3; ++k)
                {
                    grid.box(i).low[k] = members[i].x[k] - r;
                    grid.box(i).high[k] = members[i].x[k] + r;
                }
            }
            grid.build();

            // In the order of the identities, on any number of ranks
            std::vector<pair> pairs;
            grid.pairs
            (
                [&](std::int32_t i, std::int32_t j, std::int32_t image)
                {
                    if (!members[i].injected && !members[j].injected)
                    {
                        return;
                    }
                    if (members[j].identity < members[i].identity)
                    {
                        std::swap(i, j);
                        image = 2*impact::sweptGrid::noImage - image;
                    }
                    pairs.push_back({i, j, image});
                }
            );
            std::sort
            (
                pairs.begin(), pairs.end(),
                [&](const pair& a, const pair& b)
                {
                    const auto key = [&](const pair& c)
                    {
                        return std::make_tuple
                        (
                            members[c.i].identity, members[c.j].identity,
                            c.image
                        );
                    };
                    return key(a) < key(b);
                }
            );

            std::vector<char> removed(members.size(), 0);
            const auto displaced = [&](member& a, const vector& way)
            {
                course c;
                c.rank = a.rank;
                c.slot = a.slot;
                c.next = -1;
                mission m(DISPLACE, 0);
                m.way = way;
                m.injected = a.injected;
                fly(c, m);
                a.rank = c.rank;
                a.slot = c.slot;
                a.x = m.way;
            };
            for (const pair& c : pairs)
            {
                member& a = members[c.i];
                member& b = members[c.j];
                const vector s = solved
                (
                    b.x - a.x
                  + (
                        c.image == impact::sweptGrid::noImage
                      ? vector(Zero)
                      : fromCore(grid.shift(c.image))
                    )
                );
                const scalar sigma = 0.5*(a.d + b.d);
                const scalar overlap = sigma - mag(s);
                if (overlap <= 1e-12*sigma || removed[c.i] || removed[c.j])
                {
                    continue;
                }
                ++nOverlaps;
                if (!separate_)
                {
                    // The later of the two goes
                    const std::int32_t late = b.injected ? c.j : c.i;
                    removed[late] = 1;
                    request r
                    {
                        COMMIT, members[late].slot, -1, 0, mission(PLAN, 0)
                    };
                    ask(members[late].rank, r);
                    continue;
                }
                vector along(Zero);
                along[directions_.x() > 0 ? 0 : 1] = 1;
                const vector e = mag(s) > 1e-9*sigma ? s/mag(s) : along;
                const scalar share = b.mass/(a.mass + b.mass);
                const scalar way = (1 + 1e-9)*overlap;
                displaced(a, -share*way*e);
                displaced(b, (1 - share)*way*e);
            }
            dismiss();
            if (sweep == 0)
            {
                report_.overlappingInjection = nOverlaps;
            }
        }
        else
        {
            serve();
        }
        Pstream::scatter(nOverlaps);
        if (nOverlaps == 0)
        {
            break;
        }
    }
}


template<class CloudType>
bool Foam::EventDrivenCollisions<CloudType>::proceed(flight& f, mission& m)
{
    if (m.setU)
    {
        f.parcel->U() = m.U;
        if (law_.spin())
        {
            f.parcel->omega() = m.omega;
        }
        m.setU = false;
    }
    switch (m.kind)
    {
        case PLAN: return plan(f, m);
        case ARRIVE: return arrive(f, m);
        case REST: return rest(f, m);
        case END_REST: return endRest(f, m);
        case HOLD:
            if (mag(f.parcel->U()) <= m.slow)
            {
                return hold(f, m);
            }
            m.kind = m.free;
            return m.kind == REST ? rest(f, m) : plan(f, m);
        case DISPLACE: return displace(f, m);
    }
    return true;
}


template<class CloudType>
bool Foam::EventDrivenCollisions<CloudType>::plan(flight& f, mission& m)
{
    parcelType& p = *f.parcel;
    bool moves = m.begun;
    f.firstRecord = planned_.size();
    if (!m.begun)
    {
        m.begun = true;
        m.resting = false;
        m.boundary = false;
        m.end = deltaT_;
        m.path.x = toCore(solved(f.placed ? f.x : p.position()));
        m.path.v = toCore(solved(p.U()));
        m.path.a = impact::vector3{0, 0, 0};
        m.path.start = m.t;
        f.placed = false;
        f.start = typename plannedCloud::state(p);
    }
    if (p.stepFraction() < 1)
    {
        moves = true;
        p.move(planned_, *td_, deltaT_);
        f.lastRecord = planned_.size();
        if (td_->switchProcessor && atPass(p))
        {
            return false;
        }
        m.boundary = td_->switchProcessor;
    }
    f.lastRecord = planned_.size();
    if (moves)
    {
        m.end = p.stepFraction() < 1 ? p.stepFraction()*deltaT_ : deltaT_;

        // Round-off of positions must not look like an acceleration
        const scalar h = m.end - m.path.start;
        const point end = solved(p.position());
        const vector bend =
            end - fromCore(m.path.x) - h*fromCore(m.path.v);
        if
        (
            cmptMax(cmptMag(bend)) > 1e-14*cmptMax(cmptMag(end))
         && h > 1e-9*deltaT_
        )
        {
            m.path.a = toCore(2/sqr(h)*bend);
        }
        if (h > 1e-9*deltaT_)
        {
            // The bend of a short way is the error of its ends
            m.pull = mag(solved(p.U()) - fromCore(m.path.v))/h;
        }
    }
    return true;
}


template<class CloudType>
void Foam::EventDrivenCollisions<CloudType>::stay(flight& f, mission& m)
{
    m.path.x = toCore(solved(f.parcel->position()));
    m.path.v = impact::vector3{0, 0, 0};
    m.path.a = impact::vector3{0, 0, 0};
    m.path.start = m.t;
    f.start = typename plannedCloud::state(*f.parcel);
    f.firstRecord = f.lastRecord = planned_.size();
}


template<class CloudType>
bool Foam::EventDrivenCollisions<CloudType>::rest(flight& f, mission& m)
{
    parcelType& p = *f.parcel;
    const scalar pause = min(restShare*deltaT_, deltaT_ - m.t);
    const bool home = !m.begun;
    if (home)
    {
        // What is left of the velocity towards or off the wall goes. A
        // little off it, so that the tracking does not meet the face again
        // at once
        if (p.onBoundaryFace() && !atPass(p))
        {
            vector n = p.mesh().faceAreas()[p.face()];
            n /= mag(n);
            p.U() -= (p.U() & n)*n;
            p.U() -= 1e-6*mag(p.U())*n;
        }
        m.begun = true;
        m.boundary = false;
        m.resting = true;
        stay(f, m);
        m.path.v = toCore(solved(p.U()));
        m.way = pause*p.U();
        ++cloud_.statistics().nPauses;
    }

    m.left *= p.track(m.left*m.way, 0);
    if (m.left > 0 && atPass(p) && m.hops < maxHops)
    {
        return false;
    }
    if (home)
    {
        f.start.restore(p);
    }

    // In a corner it stays
    const scalar share = 1 - m.left;
    m.halt = share*pause < min(duration_.value(), 0.1*pause);

    // Not beyond the step by round-off, or it would not end in it
    m.end = min(m.t + (m.halt ? pause : share*pause), deltaT_);
    if (m.halt)
    {
        m.path.v = impact::vector3{0, 0, 0};
        if (home)
        {
            p.U() = Zero;
        }
    }
    return true;
}


template<class CloudType>
bool Foam::EventDrivenCollisions<CloudType>::endRest(flight& f, mission& m)
{
    parcelType& p = *f.parcel;
    const scalar pause = m.t - m.path.start;
    if (pause > 0)
    {
        if (!m.begun)
        {
            m.begun = true;
            m.way = p.position();
        }
        m.left *= p.track(m.left*pause*p.U(), 0);
        if (m.left > 0 && atPass(p) && m.hops < maxHops)
        {
            return false;
        }
        td_->keepParticle = true;
        p.face() = -1;
        p.setCellValues(cloud_, *td_);
        const vector before = p.U();
        p.calc(cloud_, *td_, pause);
        if (pause > 1e-9*deltaT_)
        {
            m.pull = mag(solved(p.U() - before))/pause;
        }
        p.age() += pause;
        foamCompat::postMove(cloud_.functions(), p, pause, m.way, *td_);
        f.keep = f.keep && td_->keepParticle;
    }
    m.resting = false;
    p.stepFraction() = m.t < deltaT_ ? m.t/deltaT_ : 1;
    return true;
}


template<class CloudType>
bool Foam::EventDrivenCollisions<CloudType>::arrive(flight& f, mission& m)
{
    parcelType& p = *f.parcel;
    const scalar begin = m.path.start;
    const scalar time = m.t - begin;
    bool hit = false;
    if (!m.begun)
    {
        m.begun = true;
        f.start.restore(p);
        m.settling = time <= 1e-14*deltaT_;
        if (!m.settling)
        {
            p.stepFraction() = 0;
        }
    }
    if (!m.settling)
    {
        f.firstRecord = planned_.size();
        if (p.stepFraction() < 1)
        {
            p.move(planned_, *td_, time);
            hit = td_->switchProcessor;
        }
        f.lastRecord = planned_.size();
        planned_.rescale(f.firstRecord, begin/deltaT_, time/deltaT_);
        act(f);
        if (hit && atPass(p))
        {
            return false;
        }
        m.settling = true;
    }

    // From where the integration leads to the parabola, along a wall if there
    // is one: another parcel is where the parabola does not lead
    const auto away = [&]()
    {
        return solved(fromCore(m.path.position(m.t)) - p.position());
    };
    p.track(away(), 0);
    if (p.onBoundaryFace() && !atPass(p))
    {
        vector n = p.mesh().faceAreas()[p.face()];
        n /= mag(n);
        vector way = away();
        way -= max(way & n, scalar(0))*n;
        if (mag(way) > 0)
        {
            p.track(way - 1e-6*mag(way)*n, 0);
        }
    }
    if (atPass(p) && m.hops < maxHops)
    {
        return false;
    }
    hit =
        p.onBoundaryFace()
     && !atPass(p)
     && (p.U() & p.mesh().faceAreas()[p.face()]) > 0;
    p.stepFraction() = m.t < deltaT_ ? m.t/deltaT_ : 1;
    m.boundary = hit;
    if (hit)
    {
        // Its boundary event is due, and comes first
        m.end = m.t;
        stay(f, m);
    }
    return true;
}


template<class CloudType>
bool Foam::EventDrivenCollisions<CloudType>::displace(flight& f, mission& m)
{
    parcelType& p = *f.parcel;
    if (magSqr(m.way) > 0)
    {
        m.left *= p.track(m.left*m.way, 0);
        if (m.left > 0 && atPass(p) && m.hops < maxHops)
        {
            return false;
        }
        p.face() = -1;
        f.placed = false;
    }
    m.way = p.position();
    return true;
}


template<class CloudType>
bool Foam::EventDrivenCollisions<CloudType>::hold(flight& f, mission& m)
{
    parcelType& p = *f.parcel;
    m.energy = 0.5*p.mass()*magSqr(p.U());
    p.U() = Zero;
    m.begun = true;
    m.boundary = false;
    m.resting = false;
    m.end = deltaT_;
    stay(f, m);
    p.age() += deltaT_ - m.t;
    p.stepFraction() = 1;
    return true;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

template<class CloudType>
Foam::EventDrivenCollisions<CloudType>::EventDrivenCollisions
(
    CloudType& cloud,
    const dictionary& dict
)
:
    cloud_(cloud),
    dict_(dict),
    law_
    (
        checked
        (
            dict,
            [&]
            {
                return impact::pairLaw
                (
                    getNumber
                    (
                        dict, "restitution", validRange::share, scalar(0.9)
                    ),
                    getNumber
                    (
                        dict, "friction", validRange::friction, scalar(0.2)
                    ),
                    cloud.rotation(),
                    getNumber
                    (
                        dict, "tangentialRestitution", "[-1, 1]", scalar(0)
                    )
                );
            }
        )
    ),
    restingLaw_(0, law_.friction(), law_.spin(), law_.tangentialRestitution()),
    duration_
    (
        getNumber
        (
            dict, "contactDuration", validRange::duration, scalar(1e-9)
        )
    ),
    dimension_
    (
        dict.lookupOrDefault<label>("dimension", cloud.mesh().nGeometricD())
    ),
    slabThickness_(1),
    separate_
    (
        getWord(dict, "overlappingInjection", {"refuse", "separate"})
     == "separate"
    ),
    step_(domain(dict, cloud.mesh()), duration_, maxEvents),
    planned_(cloud),
    bounds_(cloud.mesh().bounds()),
    directions_(vector::one),
    nParcels_(-1),
    td_(nullptr),
    deltaT_(0),
    totals_(scalar(0)),
    deepest_(0)
{
    const polyMesh& mesh = cloud.mesh();
    for (label k = 0; k < 3; ++k)
    {
        if (mesh.geometricD()[k] != 1)
        {
            directions_[k] = 0;
            slabThickness_ = mesh.bounds().span()[k];
        }
    }
    refuseOthers
    (
        dict,
        {
            "type", "restitution", "friction", "tangentialRestitution",
            "contactDuration", "dimension", "slabThickness",
            "overlappingInjection"
        }
    );
    slabThickness_ =
        getNumber(dict, "slabThickness", validRange::length, slabThickness_);
    checkCloud();
    setPasses();

    Info<< "Selecting parcel collisions eventDriven: " << dimension_
        << " dimensions, restitution " << law_.restitution()
        << ", friction " << law_.friction()
        << ", contact duration " << duration_.value() << " s" << endl;
    if (Pstream::parRun())
    {
        Info<< "    Events are ordered by the master for all "
            << Pstream::nProcs() << " ranks: the halo is the whole domain"
            << endl;
    }

    nParcels_ = cloud.size();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

template<class CloudType>
void Foam::EventDrivenCollisions<CloudType>::motion(trackingData& td)
{
    td.part() = trackingData::tpLinearTrack;
    td_ = &td;
    deltaT_ = cloud_.solution().trackTime();
    report_ = report();
    planned_.clear();

    collect();
    admitInjected();
    planAll();

    if (Pstream::master())
    {
        std::string failure;
        try
        {
            const impact::collisionCounts counts = step_.run(*this, deltaT_);
            report_.wallEvents = counts.wallEvents;
            report_.deepestOverlap = counts.deepestOverlap;
        }
        catch (const std::runtime_error& error)
        {
            failure = error.what();
        }
        catch (const std::invalid_argument& error)
        {
            failure = error.what();
        }
        if (!failure.empty())
        {
            FatalErrorInFunction
                << "Cloud " << cloud_.name() << ": " << failure
                << exit(FatalError);
        }
        commitAll();
        dismiss();
    }
    else
    {
        serve();
    }

    for (flight& f : flights_)
    {
        if (!f.parcel)
        {
            continue;
        }
        if (f.guest)
        {
            delete f.parcel;
            continue;
        }
        act(f);
        if (!f.keep)
        {
            cloud_.deleteParticle(*f.parcel);
        }
    }
    nParcels_ = cloud_.size();
}


template<class CloudType>
void Foam::EventDrivenCollisions<CloudType>::collide
(
    const std::int32_t i,
    const std::int32_t j,
    const impact::vector3& separation,
    const double t
)
{
    course& a = courses_[i];
    course& b = courses_[j];
    const double pull = a.pull + b.pull;
    bool resting = false;
    const auto arrival = [&](course& c)
    {
        mission m(c.resting ? END_REST : ARRIVE, t);
        m.path = c.path;
        if (c.held)
        {
            m.mass = std::numeric_limits<scalar>::infinity();
            return m;
        }
        fly(c, m);
        return m;
    };
    mission aThen = arrival(a);
    mission bThen = arrival(b);
    const auto go = [&](course& c, mission& then)
    {
        if (c.held)
        {
            return;
        }
        if (then.boundary)
        {
            ++c.events;
            adoptPlan(c, then);
            return;
        }
        mission m = next(c, resting ? REST : PLAN, resting, t, pull);
        m.U = then.U;
        m.omega = then.omega;
        m.setU = true;
        fly(c, m);
        adoptPlan(c, m);
    };
    if (!aThen.boundary && !bThen.boundary)
    {
        const impact::collidingSphere first
        {
            toCore(aThen.U), toCore(aThen.omega), aThen.mass, a.radius
        };
        const impact::collidingSphere second
        {
            toCore(bThen.U), toCore(bThen.omega), bThen.mass, b.radius
        };
        const impact::vector3 n = (1/impact::mag(separation))*separation;
        const double approach = impact::dot(n, first.v - second.v);
        resting =
            a.held || b.held
         || (
                approach <= atRest(pull)
             && (duration_.rests(a.recent, t) || duration_.rests(b.recent, t))
            );
        const bool elastic = !resting
         && (
                duration_.elastic(a.recent, t, approach, pull)
             || duration_.elastic(b.recent, t, approach, pull)
            );
        const impact::pairCollision out =
            (resting ? restingLaw_ : law_).collide(first, second, n, elastic);

        // Forces that press may not have made a speed yet
        const bool slow = duration_.slow(approach, pull);
        duration_.count(a.recent, t, slow);
        duration_.count(b.recent, t, slow);
        if (approach > 0)
        {
            ++report_.pairEvents;
            report_.rankPairs += a.rank != b.rank;
            report_.restitutionLoss += out.restitutionLoss;
            report_.frictionLoss += out.frictionLoss;
        }
        aThen.U = fromCore(out.v1);
        bThen.U = fromCore(out.v2);
        if (law_.spin())
        {
            aThen.omega = fromCore(out.omega1);
            bThen.omega = fromCore(out.omega2);
        }
    }
    go(a, aThen);
    go(b, bThen);
}


template<class CloudType>
bool Foam::EventDrivenCollisions<CloudType>::hitWall
(
    const std::int32_t i,
    const double t
)
{
    course& c = courses_[i];
    if (c.resting)
    {
        mission m(END_REST, t);
        m.path = c.path;
        fly(c, m);
        c.pull = m.pull >= 0 ? m.pull : c.pull;
        mission then = next(c, PLAN, true, t, c.pull);
        fly(c, then);
        adoptPlan(c, then);
        return true;
    }

    // A parcel that is pressed against a wall does not bounce for ever
    if (t - c.firstHit >= duration_.value())
    {
        c.firstHit = t;
        c.hits = 0;
    }
    const bool rests = ++c.hits > 8;
    mission m = next(c, rests ? REST : PLAN, rests, t, c.pull);
    const leg last = commitLegs(c, m.keep);
    c.rank = last.rank;
    c.slot = last.slot;
    c.next = -1;
    request r{HIT, c.slot, -1, 0, m};
    response done = ask(c.rank, r);
    if (done.gone)
    {
        return false;
    }
    follow(c, m, done);
    adoptPlan(c, m);
    return true;
}


template<class CloudType>
void Foam::EventDrivenCollisions<CloudType>::info()
{
    FixedList<scalar, 9> step;
    step[0] = report_.pairEvents;
    step[1] = report_.wallEvents;
    step[2] = report_.restitutionLoss;
    step[3] = report_.frictionLoss;
    step[4] = report_.overlappingInjection;
    step[5] = report_.rankPairs;
    step[6] = report_.handOvers;
    step[7] = report_.held;
    step[8] = report_.heldEnergy;
    forAll(step, i)
    {
        reduce(step[i], sumOp<scalar>());
        totals_[i] += step[i];
    }
    const scalar overlap =
        returnReduce(report_.deepestOverlap, maxOp<scalar>());
    deepest_ = max(deepest_, overlap);
    const auto line =
        [&](const char* text, const label i)
        {
            Info<< text << step[i] << ", " << step[i + 1]
                << "; in all " << totals_[i] << ", " << totals_[i + 1]
                << nl;
        };
    line("    Pair, boundary events           = ", 0);
    Info<< "    Deepest overlap                 = " << overlap
        << "; in all " << deepest_ << nl;
    line("    Lost to restitution, friction   = ", 2);
    if (totals_[7] > 0)
    {
        line("    Held parcels, their energy      = ", 7);
    }
    if (Pstream::parRun())
    {
        line("    Pairs, hand-overs between ranks = ", 5);
    }
    if (totals_[4] > 0)
    {
        Info<< "    Injections upon others          = " << step[4]
            << "; in all " << totals_[4]
            << (separate_ ? ", separated" : ", refused") << nl;
    }
}
