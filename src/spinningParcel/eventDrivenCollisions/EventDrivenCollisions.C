/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "EventDrivenCollisions.H"
#include "NoDispersion.H"
#include "checked.H"
#include "coupledPolyPatch.H"
#include "cyclicAMIPolyPatch.H"
#include "meshTools.H"

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
        FatalIOErrorInFunction(dict)
            << "Entry 'collisions', value eventDriven, is outside the valid"
            << " range (off) of a mesh with cyclic patches other than pairs"
            << " of planes normal to a coordinate axis at the ends of the"
            << " domain" << exit(FatalIOError);
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
    const auto refuse = [&](const char* entry, const word& value,
        const char* range)
    {
        FatalIOErrorInFunction(dict_)
            << "Entry '" << entry << "', value " << value
            << ", is outside the valid range " << range
            << " of collisions eventDriven" << exit(FatalIOError);
    };
    if
    (
        !isA<NoDispersion<typename CloudType::kinematicCloudType>>
            (cloud_.dispersion())
    )
    {
        refuse("dispersionModel", cloud_.dispersion().modelType(), "(none)");
    }
    if (cloud_.solution().cellValueSourceCorrection())
    {
        refuse("cellValueSourceCorrection", "on", "(off)");
    }
    if (cloud_.solution().steadyState())
    {
        refuse("transient", "no", "(yes)");
    }
    if (cloud_.mesh().dynamic())
    {
        refuse("collisions", "eventDriven", "(off, on a moving mesh)");
    }
    if (Pstream::parRun())
    {
        refuse("collisions", "eventDriven", "(off, on several ranks)");
    }
    const label n = cloud_.mesh().nGeometricD();
    if (dimension_ != n || n < 2)
    {
        FatalIOErrorInFunction(dict_)
            << "Entry 'dimension', value " << dimension_
            << ", is outside the valid range of this mesh, which has " << n
            << " dimensions. A thin three-dimensional slab needs a mesh of"
            << " that thickness between cyclic patches"
            << exit(FatalIOError);
    }
    if (!(slabThickness_ > 0))
    {
        FatalIOErrorInFunction(dict_)
            << "Entry 'slabThickness', value " << slabThickness_
            << ", is outside the valid range (0, inf)" << exit(FatalIOError);
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
    flights_.reserve(cloud_.size());
    for (parcelType& p : cloud_)
    {
        p.stepFraction() = 0;
        if (p.active())
        {
            checkNumber(p);
            flights_.emplace_back(p);
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
    if (nParcels_ < 0 || cloud_.size() <= nParcels_)
    {
        return;
    }

    // Injected parcels stand at the end of the list. Others matter near them
    // only, or at the ends of a period
    struct member
    {
        parcelType* parcel;
        bool injected;
    };
    std::vector<member> members;
    boundBox near;
    scalar largest = 0;
    label n = 0;
    for (parcelType& p : cloud_)
    {
        largest = max(largest, p.d());
        if (n++ >= nParcels_)
        {
            near.add(p.position());
        }
    }
    const vector margin(2*largest*vector::one);
    near = boundBox(near.min() - margin, near.max() + margin);
    const bool* periodic = step_.grid().domain().periodic;
    const bool all = periodic[0] || periodic[1] || periodic[2];
    n = 0;
    for (parcelType& p : cloud_)
    {
        const bool injected = n++ >= nParcels_;
        if (injected || all || near.contains(p.position()))
        {
            members.push_back({&p, injected});
        }
    }

    // Moving a pair apart may bring one of them upon a third
    for (label sweep = 0; sweep < (separate_ ? 20 : 1); ++sweep)
    {
        impact::sweptGrid grid(step_.grid().domain());
        grid.resize(members.size());
        for (std::size_t i = 0; i < members.size(); ++i)
        {
            const point x = members[i].parcel->position();
            const scalar r = 0.5*members[i].parcel->d();
            for (int k = 0; k < 3; ++k)
            {
                grid.box(i).low[k] = x[k] - r;
                grid.box(i).high[k] = x[k] + r;
            }
        }
        grid.build();

        std::vector<char> removed(members.size(), 0);
        label nOverlaps = 0;
        const auto treat =
            [&](std::int32_t i, std::int32_t j, const std::int32_t image)
            {
                if (!members[i].injected && !members[j].injected)
                {
                    return;
                }
                parcelType& a = *members[i].parcel;
                parcelType& b = *members[j].parcel;
                const vector s = solved
                (
                    b.position() - a.position()
                  + (
                        image == impact::sweptGrid::noImage
                      ? vector(Zero)
                      : fromCore(grid.shift(image))
                    )
                );
                const scalar sigma = 0.5*(a.d() + b.d());
                const scalar overlap = sigma - mag(s);
                if (overlap <= 1e-12*sigma || removed[i] || removed[j])
                {
                    return;
                }
                ++nOverlaps;
                if (!separate_)
                {
                    // The later of the two goes
                    removed[members[j].injected && j > i ? j : i] = 1;
                    return;
                }
                vector along(Zero);
                along[directions_.x() > 0 ? 0 : 1] = 1;
                const vector e = mag(s) > 1e-9*sigma ? s/mag(s) : along;
                const scalar share = b.mass()/(a.mass() + b.mass());
                const scalar way = (1 + 1e-9)*overlap;
                a.track(-share*way*e, 0);
                b.track((1 - share)*way*e, 0);
                a.face() = -1;
                b.face() = -1;
            };
        grid.pairs(treat);

        if (sweep == 0)
        {
            report_.overlappingInjection += nOverlaps;
        }
        if (!separate_)
        {
            for (std::size_t i = 0; i < members.size(); ++i)
            {
                if (removed[i])
                {
                    cloud_.deleteParticle(*members[i].parcel);
                }
            }
        }
        if (nOverlaps == 0)
        {
            break;
        }
    }
}


template<class CloudType>
void Foam::EventDrivenCollisions<CloudType>::plan
(
    flight& f,
    const scalar t
)
{
    parcelType& p = *f.parcel;
    f.resting = false;
    f.boundary = false;
    f.end = deltaT_;
    f.firstRecord = planned_.size();
    f.path.x = toCore(solved(p.position()));
    f.path.v = toCore(solved(p.U()));
    f.path.a = impact::vector3{0, 0, 0};
    f.path.start = t;
    f.start = typename plannedCloud::state(p);
    if (p.stepFraction() < 1)
    {
        p.move(planned_, *td_, deltaT_);
        f.boundary = td_->switchProcessor;
        f.end = p.stepFraction() < 1 ? p.stepFraction()*deltaT_ : deltaT_;

        // Round-off of positions must not look like an acceleration
        const scalar h = f.end - t;
        const point end = solved(p.position());
        const vector bend =
            end - fromCore(f.path.x) - h*fromCore(f.path.v);
        if
        (
            cmptMax(cmptMag(bend)) > 1e-14*cmptMax(cmptMag(end))
         && h > 1e-9*deltaT_
        )
        {
            f.path.a = toCore(2/sqr(h)*bend);
        }
    }
    f.lastRecord = planned_.size();
}


template<class CloudType>
void Foam::EventDrivenCollisions<CloudType>::stay
(
    flight& f,
    const scalar t
)
{
    f.path.x = toCore(solved(f.parcel->position()));
    f.path.v = impact::vector3{0, 0, 0};
    f.path.a = impact::vector3{0, 0, 0};
    f.path.start = t;
    f.start = typename plannedCloud::state(*f.parcel);
    f.firstRecord = f.lastRecord = planned_.size();
}


template<class CloudType>
void Foam::EventDrivenCollisions<CloudType>::rest
(
    flight& f,
    const scalar t
)
{
    parcelType& p = *f.parcel;
    const scalar pause = min(0.1*deltaT_, deltaT_ - t);

    // What is left of the velocity towards or off the wall goes. A little
    // off it, so that the tracking does not meet the face again at once
    if (p.onBoundaryFace())
    {
        vector n = p.mesh().faceAreas()[p.face()];
        n /= mag(n);
        p.U() -= (p.U() & n)*n;
        p.U() -= 1e-6*mag(p.U())*n;
    }

    // In a corner it stays
    const typename plannedCloud::state here(p);
    const scalar share = 1 - p.track(pause*p.U(), 0);
    here.restore(p);
    if (share < 1e-6)
    {
        p.U() = Zero;
    }

    f.boundary = false;
    f.resting = true;
    f.end = share < 1e-6 ? t + pause : t + share*pause;
    stay(f, t);
    f.path.v = toCore(solved(p.U()));
    ++cloud_.statistics().nPauses;
}


template<class CloudType>
void Foam::EventDrivenCollisions<CloudType>::endRest
(
    flight& f,
    const scalar t
)
{
    parcelType& p = *f.parcel;
    const scalar pause = t - f.path.start;
    f.resting = false;
    if (pause > 0)
    {
        const point from = p.position();
        td_->keepParticle = true;
        p.track(pause*p.U(), 0);
        p.face() = -1;
        p.setCellValues(cloud_, *td_);
        p.calc(cloud_, *td_, pause);
        p.age() += pause;
        cloud_.functions().postMove
            (p, pause, from, td_->keepParticle);
        f.keep = f.keep && td_->keepParticle;
    }
    p.stepFraction() = t < deltaT_ ? t/deltaT_ : 1;
}


template<class CloudType>
bool Foam::EventDrivenCollisions<CloudType>::arrive
(
    flight& f,
    const scalar t
)
{
    parcelType& p = *f.parcel;
    if (f.resting)
    {
        endRest(f, t);
        return true;
    }

    const scalar begin = f.path.start;
    f.start.restore(p);
    bool hit = false;
    if (t - begin > 1e-14*deltaT_)
    {
        const label first = planned_.size();
        p.stepFraction() = 0;
        p.move(planned_, *td_, t - begin);
        hit = td_->switchProcessor;
        planned_.rescale(first, begin/deltaT_, (t - begin)/deltaT_);
        f.keep = planned_.replay(p, first, planned_.size()) && f.keep;
    }
    if (!hit)
    {
        // From where the integration leads to the parabola
        p.track
        (
            solved(fromCore(f.path.position(t)) - p.position()),
            0
        );
        hit =
            p.onBoundaryFace()
         && (p.U() & p.mesh().faceAreas()[p.face()]) > 0;
    }
    p.stepFraction() = t < deltaT_ ? t/deltaT_ : 1;
    if (hit)
    {
        // Its boundary event is due, and comes first
        f.boundary = true;
        f.end = t;
        stay(f, t);
    }
    return !hit;
}


template<class CloudType>
impact::collidingSphere Foam::EventDrivenCollisions<CloudType>::sphere
(
    const flight& f
) const
{
    const parcelType& p = *f.parcel;
    return {toCore(p.U()), toCore(p.omega()), p.mass(), 0.5*p.d()};
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
                    dict.lookupOrDefault<scalar>("restitution", 0.9),
                    dict.lookupOrDefault<scalar>("friction", 0.2),
                    cloud.rotation(),
                    dict.lookupOrDefault<scalar>("tangentialRestitution", 0)
                );
            }
        )
    ),
    duration_
    (
        checked
        (
            dict,
            [&]
            {
                const scalar t =
                    dict.lookupOrDefault<scalar>("contactDuration", 1e-9);
                if (t == 0)
                {
                    throw std::invalid_argument
                    (
                        "contactDuration 0: valid range (0, inf)"
                    );
                }
                return impact::contactDuration(t);
            }
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
    dict.readIfPresent("slabThickness", slabThickness_);
    checkCloud();

    Info<< "Selecting parcel collisions eventDriven: " << dimension_
        << " dimensions, restitution " << law_.restitution()
        << ", friction " << law_.friction()
        << ", contact duration " << duration_.value() << " s" << endl;

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

    admitInjected();
    collect();
    for (flight& f : flights_)
    {
        plan(f, 0);
    }

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

    for (flight& f : flights_)
    {
        if
        (
            f.parcel
         && !(
                planned_.replay(*f.parcel, f.firstRecord, f.lastRecord)
             && f.keep
            )
        )
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
    flight& a = flights_[i];
    flight& b = flights_[j];
    const double pull = impact::mag(a.path.a) + impact::mag(b.path.a);
    const bool aThere = arrive(a, t);
    const bool bThere = arrive(b, t);
    if (aThere && bThere)
    {
        const impact::collidingSphere first = sphere(a);
        const impact::collidingSphere second = sphere(b);
        const impact::vector3 n = (1/impact::mag(separation))*separation;
        const double approach = impact::dot(n, first.v - second.v);
        const bool elastic =
            duration_.elastic(a.recent, t, approach, pull)
         || duration_.elastic(b.recent, t, approach, pull);
        const impact::pairCollision out =
            law_.collide(first, second, n, elastic);
        if (approach > 0)
        {
            duration_.count(a.recent, t);
            duration_.count(b.recent, t);
            ++report_.pairEvents;
            report_.restitutionLoss += out.restitutionLoss;
            report_.frictionLoss += out.frictionLoss;
        }
        a.parcel->U() = fromCore(out.v1);
        b.parcel->U() = fromCore(out.v2);
        if (law_.spin())
        {
            a.parcel->omega() = fromCore(out.omega1);
            b.parcel->omega() = fromCore(out.omega2);
        }
    }
    if (aThere)
    {
        plan(a, t);
    }
    if (bThere)
    {
        plan(b, t);
    }
}


template<class CloudType>
bool Foam::EventDrivenCollisions<CloudType>::hitWall
(
    const std::int32_t i,
    const double t
)
{
    flight& f = flights_[i];
    parcelType& p = *f.parcel;
    if (f.resting)
    {
        endRest(f, t);
        plan(f, t);
        return true;
    }

    f.keep = planned_.replay(p, f.firstRecord, f.lastRecord) && f.keep;
    td_->keepParticle = true;
    td_->switchProcessor = false;
    p.hitFace(p.U(), cloud_, *td_);
    if (!td_->keepParticle || !f.keep)
    {
        cloud_.deleteParticle(p);
        f.parcel = nullptr;
        return false;
    }

    // A parcel that is pressed against a wall does not bounce for ever
    if (t - f.firstHit >= duration_.value())
    {
        f.firstHit = t;
        f.hits = 0;
    }
    if (++f.hits > 8)
    {
        rest(f, t);
    }
    else
    {
        plan(f, t);
    }
    return true;
}


template<class CloudType>
void Foam::EventDrivenCollisions<CloudType>::info()
{
    FixedList<scalar, 5> step;
    step[0] = report_.pairEvents;
    step[1] = report_.wallEvents;
    step[2] = report_.restitutionLoss;
    step[3] = report_.frictionLoss;
    step[4] = report_.overlappingInjection;
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
    if (totals_[4] > 0)
    {
        Info<< "    Injections upon others          = " << step[4]
            << "; in all " << totals_[4]
            << (separate_ ? ", separated" : ", refused") << nl;
    }
}
