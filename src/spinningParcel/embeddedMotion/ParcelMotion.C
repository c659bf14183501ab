/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "ParcelMotion.H"
#include "curvedPath.H"
#include "foamCompat.H"
#include "meshTools.H"
#include "tetPlace.H"
#include "wedgePolyPatch.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

template<class CloudType, class Force>
typename Foam::ParcelMotion<CloudType, Force>::State
Foam::ParcelMotion<CloudType, Force>::now() const
{
    State state;
    state.x = impact::vector3{0, 0, 0};
    state.v = toCore(p_.U());
    state.omega = toCore(p_.omega());
    if constexpr (heated)
    {
        state.h = force_.heat().material().h(p_.temperature());
    }
    return state;
}


template<class CloudType, class Force>
const Foam::cellGas::field&
Foam::ParcelMotion<CloudType, Force>::placeForce()
{
    if (Force::places)
    {
        tetPlace::put(p_, cells_, x_, cell_, -1);
    }
    const cellGas::field& gas =
        face_ >= 0 ? along_ : cloud_.gas().at(cell_, store_);
    if (eddies_)
    {
        meetEddy(gas);
        force_.eddy(toCore(p_.UTurb()));
    }
    force_.place(gas, x_);
    return gas;
}


template<class CloudType, class Force>
void Foam::ParcelMotion<CloudType, Force>::meetEddy(const cellGas::field& gas)
{
    const label celli = cells_.meshCell(cell_);
    if (!eddies_->over(celli, p_.tTurb()))
    {
        return;
    }
    force_.eddy({0, 0, 0});
    force_.place(gas, x_);
    const State state = now();
    const impact::vector3 w = force_.here().u - state.v;
    const scalar rate = force_(state).k;
    force_.done();
    eddies_->next
    (
        celli,
        p_.origProc(),
        p_.origId(),
        w,
        rate,
        p_.UTurb(),
        p_.tTurb(),
        p_.nEddies()
    );
    left_ = stepToFace::maxForces;
}


template<class CloudType, class Force>
typename Foam::ParcelMotion<CloudType, Force>::outcome
Foam::ParcelMotion<CloudType, Force>::substep
(
    const State& begin,
    const scalar hMax,
    const scalar hTry
)
{
    const outcome o = cloud_.embedded().step
    (
        force_,
        begin,
        impact::mag(force_.here().u),
        impact::mag(force_.here().spin),
        hMax,
        hTry,
        max(left_ - stepToFace::kept, label(3))
    );
    left_ -= o.nForce;
    hTry_ = o.hNext;
    cloud_.statistics().nForces += o.nForce;
    return o;
}


template<class CloudType, class Force>
typename Foam::ParcelMotion<CloudType, Force>::outcome
Foam::ParcelMotion<CloudType, Force>::step(const State& begin)
{
    const cellGas::field& gas = placeForce();
    label ahead = -1;
    const scalar exit = cells_.exitTime
    (
        cell_, x_, impact::multiply(moving_, begin.v), remaining(), ahead
    );
    const impact::vector3& u = force_.here().u;
    scalar hMax = stepToFace::longest
    (
        eddies_ ? min(remaining(), p_.tTurb()) : remaining(),
        exit, gas.length, mag(p_.U()), impact::mag(u)
    );
    if (face_ >= 0)
    {
        hMax = min(hMax, faceSlide::longest(gas, begin.v, u));
    }
    const outcome o = substep(begin, hMax, hTry_);
    ++cloud_.statistics().nSteps;
    cloud_.statistics().nForced += o.forced;
    return o;
}


template<class CloudType, class Force>
typename Foam::ParcelMotion<CloudType, Force>::arrival
Foam::ParcelMotion<CloudType, Force>::follow
(
    const State& begin,
    const outcome& o
)
{
    const curvedPath path
    (
        x_,
        impact::multiply(moving_, o.state.x),
        o.h*impact::multiply(moving_, begin.v),
        o.h*impact::multiply(moving_, o.state.v)
    );
    arrival a;
    a.place = -1;
    const scalar tau = path.exit(cells_, cell_, 0, 1, a.place);
    a.t = tau*o.h;
    a.state = o.state;
    a.state.x = path(tau);
    if (tau < 1)
    {
        // A parabola where that is accurate, another step where not
        if
        (
           !stepToFace::onParabola(cloud_.embedded(), begin, o, tau, a.state)
        )
        {
            const outcome again = substep(begin, a.t, a.t);
            cloud_.statistics().nForced += again.forced && !o.forced;
            a.t = again.h;
            a.state = again.state;
        }
        if (a.t < tau*o.h)
        {
            a.place = -1;
        }
        a.state.x = impact::multiply(moving_, a.state.x);
    }
    force_.done();
    x_ = x_ + a.state.x;
    if (a.place >= 0)
    {
        stepToFace::ontoFace
            (cells_, a.place, moving_, begin, o, x_, a.state, a.t);
    }
    return a;
}


template<class CloudType, class Force>
void Foam::ParcelMotion<CloudType, Force>::become
(
    const State& end,
    const scalar k,
    const scalar t,
    const scalar acting
)
{
    const vector U0 = p_.U();
    const vector omega0 = p_.omega();
    p_.U() = fromCore(end.v);
    meshTools::constrainDirection
        (cells_.mesh(), cells_.mesh().solutionD(), p_.U());
    p_.omega() = fromCore(end.omega);
    scalar heat = 0;
    if constexpr (heated)
    {
        const scalar T0 = p_.temperature();
        p_.temperature() = force_.heat().material().T(end.h);
        heat = p_.takeHeat(cloud_, force_.heat(), T0, k, t);
    }
    if (cloud_.solution().coupled())
    {
        const scalar mass = p_.mass();
        p_.giveToGas
        (
            cloud_, mass, U0, omega0,
            acting*force_.external(mass, p_.rho(), toCore(U0)), heat, true
        );
    }
}


template<class CloudType, class Force>
bool Foam::ParcelMotion<CloudType, Force>::slide
(
    const label place,
    const label behind,
    const scalar k,
    State& state
)
{
    const label before = face_;
    face_ = -1;
    const impact::vector3 n = cells_.normal(place);
    const scalar across = impact::dot(n, state.v);
    cellGas::field here, there, along;
    const cellGas::field& a = cloud_.gas().at(cell_, here);
    if (!faceSlide::near(across, k, a.length))
    {
        return false;
    }
    const cellGas::field* b =
        behind < 0
      ? cloud_.gas().beyond(-1 - behind) : &cloud_.gas().at(behind, there);
    if (!b)
    {
        return false;
    }

    // At the place itself
    State atFace = state;
    atFace.x = impact::vector3{0, 0, 0};
    atFace.v = state.v - across*n;
    const bool holds =
        faceSlide::holds(n, a, *b, x_, atFace, force_, along);
    force_.done();
    if (!holds)
    {
        return false;
    }
    state.v = atFace.v;
    x_ = x_ - cells_.heightAbove(place, x_)*n;
    cloud_.statistics().nSlides += before != place;
    face_ = place;
    along_ = along;
    return true;
}


template<class CloudType, class Force>
bool Foam::ParcelMotion<CloudType, Force>::stuck
(
    const scalar t,
    const label patchi
)
{
    stalls_ = t < 1e-9*trackTime_ ? stalls_ + 1 : 0;

    // Near the axis a wedge is met again and again on a straight way, and a
    // step may lead through many periods
    if (patchi >= 0)
    {
        const polyPatch& patch = cells_.mesh().boundaryMesh()[patchi];
        hits_ += !patch.coupled() && !isA<wedgePolyPatch>(patch);
    }
    if (stalls_ <= 20 && hits_ <= 50)
    {
        return false;
    }
    stalls_ = 0;
    hits_ = 0;
    return true;
}


template<class CloudType, class Force>
Foam::scalar Foam::ParcelMotion<CloudType, Force>::rest(const label wall)
{
    scalar pause = min(remaining(), 0.1*trackTime_);
    placeForce();
    State state = now();
    if (wall >= 0)
    {
        // Slide, a trace off the wall, no further than its cell goes; along
        // the edge if it lies on two
        impact::vector3 off = cells_.normal(wall);
        impact::vector3 slip = state.v - impact::dot(state.v, off)*off;
        label ahead = -1;
        const auto leaves = [&]()
        {
            slip =
                impact::multiply(moving_, slip) - 1e-9*impact::mag(state.v)*off;
            return cells_.exitTime(cell_, x_, slip, pause, ahead);
        };
        scalar end = leaves();
        if
        (
            end <= 1e-3*pause && ahead >= 0 && ahead != wall
         && cells_.behind(ahead, x_) < 0
        )
        {
            const impact::vector3 other = cells_.normal(ahead);
            const impact::vector3 edge = impact::cross(off, other);
            slip =
                impact::dot(state.v, edge)
               /max(impact::dot(edge, edge), SMALL)*edge;
            off = off + other;
            end = leaves();
        }
        pause = end > 1e-3*pause ? min(end, pause) : pause;
        x_ = x_ + min(end, pause)*slip;
    }
    const auto rate = force_(state);
    force_.done();
    --left_;
    ++cloud_.statistics().nForces;
    ++cloud_.statistics().nPauses;
    cloud_.statistics().time += pause;
    const scalar acting = pause/(1 + pause*rate.k);
    state.v = state.v + acting*rate.a;
    state.omega = state.omega + pause/(1 + pause*rate.kSpin)*rate.alpha;
    if constexpr (heated)
    {
        state.h += pause/(1 + pause*rate.kHeat)*rate.hDot;
    }
    become(state, heatRelaxation(rate), pause, acting);
    p_.stepFraction() =
        pause < remaining() ? p_.stepFraction() + pause/trackTime_ : 1;
    return pause;
}


template<class CloudType, class Force>
bool Foam::ParcelMotion<CloudType, Force>::tell
(
    const impact::vector3& start,
    const scalar t,
    const label place,
    const bool between
)
{
    tetPlace::put(p_, cells_, x_, cell_, between ? -1 : place);
    if (p_.onFace())
    {
        foamCompat::postFace(cloud_.functions(), p_, td_);
    }

    // It is where its flight says, and a way begins where the last one has
    // ended, to the last bit: who counts crossings of a plane that faces lie
    // in would miss some
    p_.setFlight({x_, cell_});
    foamCompat::postMove(cloud_.functions(), p_, t, fromCore(start), td_);
    p_.setFlight({});
    return td_.keepParticle;
}


template<class CloudType, class Force>
void Foam::ParcelMotion<CloudType, Force>::enter
(
    const label celli,
    const label place,
    const bool between
)
{
    // Some tetrahedron of the next cell, for whoever asks
    cell_ = celli;
    p_.cell() = cells_.meshCell(celli);
    if (!between)
    {
        p_.tetFace() = cells_.meshFace(place);
        p_.tetPt() = 1;
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

template<class CloudType, class Force>
Foam::ParcelMotion<CloudType, Force>::ParcelMotion
(
    CloudType& cloud,
    trackingData& td,
    Force& force,
    parcelType& p,
    const scalar trackTime
)
:
    cloud_(cloud),
    td_(td),
    force_(force),
    p_(p),
    trackTime_(trackTime),
    cells_(cloud.cells()),
    moving_(toCore(cells_.moving())),
    watched_(cloud.watched()),
    eddies_(cloud.eddies())
{
    p.locate(cells_, x_, cell_);
    p.setFlight({});
    const typename parcelType::begun before(cloud.takeBegun(p));
    left_ -= before.nForces;
    hTry_ = before.hTry;
    if (before.share > 0)
    {
        p.stepFraction() = before.share;
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

template<class CloudType, class Force>
bool Foam::ParcelMotion<CloudType, Force>::move()
{
    td_.switchProcessor = false;
    td_.keepParticle = true;
    force_.parcel(p_, td_);
    scalar& maxForces = cloud_.statistics().maxForces;

    while (td_.keepParticle && !td_.switchProcessor && p_.stepFraction() < 1)
    {
        if (!p_.active())
        {
            p_.stepFraction() = 1;
            p_.age() += trackTime_;
            break;
        }

        const impact::vector3 start = x_;
        const State begin = now();
        const outcome o = step(begin);
        arrival a = follow(begin, o);
        cloud_.statistics().time += a.t;
        cloud_.statistics().forcedTime += o.forced ? a.t : 0;

        // Along a face, to another part of the mesh cell, another mesh cell,
        // or the boundary
        const label face = a.place >= 0 ? a.place : face_;
        const label behind = face < 0 ? cell_ : cells_.behind(face, x_);
        const bool slides = face >= 0 && slide(face, behind, o.k, a.state);
        const label place = slides ? -1 : a.place;
        const label next = place < 0 ? cell_ : behind;
        const bool between = place >= 0 && cells_.meshFace(place) < 0;
        const bool bounded = next < 0;
        become(a.state, heatRelaxation(o), a.t, a.t);
        p_.stepFraction() =
            a.place >= 0 || a.t < remaining()
          ? min(p_.stepFraction() + a.t/trackTime_, 1.0)
          : 1;

        const label patchi =
            bounded ? cells_.boundary()[-1 - next].patch : -1;
        const bool atWall =
            bounded && !cells_.mesh().boundaryMesh()[patchi].coupled();
        const scalar t =
            stuck(a.t, patchi) ? a.t + rest(atWall ? a.place : -1) : a.t;
        if (eddies_)
        {
            p_.tTurb() -= t;
        }
        p_.age() += t;
        if ((watched_ || bounded) && !tell(start, t, place, between))
        {
            break;
        }

        if (bounded)
        {
            if (cells_.boundary()[-1 - next].kind == convexCells::processor)
            {
                p_.setFlight({x_, parcelType::flight::passed});
            }
            p_.hitFace(fromCore(x_ - start), cloud_, td_);
            if (td_.keepParticle && !td_.switchProcessor)
            {
                p_.locate(cells_, x_, cell_);
            }
        }
        else if (place >= 0)
        {
            enter(next, place, between);
        }
        if (a.place >= 0)
        {
            // Nothing is carried from cell to cell, so that a face between two
            // ranks is like any other
            maxForces =
                max(maxForces, scalar(stepToFace::maxForces - left_));
            left_ = stepToFace::maxForces;
            hTry_ = GREAT;
        }
    }
    maxForces = max(maxForces, scalar(stepToFace::maxForces - left_));

    if (td_.keepParticle && !td_.switchProcessor && p_.stepFraction() >= 1)
    {
        p_.setFlight({x_, cell_});
        if (watched_)
        {
            p_.settle(cells_);
        }
    }
    return td_.keepParticle;
}
