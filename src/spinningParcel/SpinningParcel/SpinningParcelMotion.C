/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "foamCompat.H"
#include "meshTools.H"
#include "curvedPath.H"
#include "spinningParcelForces.H"
#include "tetPlace.H"

// * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * * * //

template<class ParcelType>
Foam::SpinningParcel<ParcelType>::place::place(const particle& p)
:
    coordinates(p.coordinates()),
    cell(p.cell()),
    tetFace(p.tetFace()),
    tetPt(p.tetPt()),
    face(p.face()),
    stepFraction(p.stepFraction())
{}


template<class ParcelType>
void Foam::SpinningParcel<ParcelType>::place::restore(particle& p) const
{
    const_cast<barycentric&>(p.coordinates()) = coordinates;
    p.cell() = cell;
    p.tetFace() = tetFace;
    p.tetPt() = tetPt;
    p.face() = face;
    p.stepFraction() = stepFraction;
}


template<class ParcelType>
template<class State>
bool Foam::SpinningParcel<ParcelType>::onParabola
(
    const impact::particleMotion& motion,
    const State& state,
    const impact::particleMotion::result<State>& o,
    const scalar tau,
    State& end
)
{
    const impact::vector3 a0 = o.h*o.a;
    const impact::vector3 alpha0 = o.h*o.alpha;
    const impact::vector3 dU = o.state.v - state.v - a0;
    const impact::vector3 dOmega = o.state.omega - state.omega - alpha0;
    end.v = state.v + tau*a0 + sqr(tau)*dU;
    end.omega = state.omega + tau*alpha0 + sqr(tau)*dOmega;

    const scalar cubic = sqr(tau)*(1 - tau)/motion.tolerance();
    const auto size =
        [](const impact::vector3& d, const impact::vector3& a)
        {
            const scalar magD = impact::mag(d);
            const scalar magA = impact::mag(a);
            return magD < magA ? magD*magD/magA : magD;
        };
    bool accurate =
        cubic*size(dU, a0) <= o.vScale
     && cubic*size(dOmega, alpha0) <= o.spinScale;
    if constexpr (impact::particleMotion::thermal<State>)
    {
        const scalar h0 = o.h*o.hDot;
        const scalar dh = o.state.h - state.h - h0;
        end.h = state.h + tau*h0 + sqr(tau)*dh;
        const scalar most =
            mag(dh) < mag(h0) ? sqr(dh)/mag(h0) : mag(dh);
        accurate = accurate && cubic*most <= o.hScale;
    }
    return accurate;
}


template<class ParcelType>
template<class Force, class State>
Foam::scalar Foam::SpinningParcel<ParcelType>::partOfStep
(
    const Force& force,
    const impact::particleMotion& motion,
    const State& state,
    const impact::particleMotion::result<State>& o,
    const scalar tau,
    label& left,
    bool& forced,
    scalar& hTry,
    State& end
)
{
    const scalar t = tau*o.h;
    const auto part = motion.step
    (
        force,
        state,
        impact::mag(force.here().u),
        impact::mag(force.here().spin),
        t,
        t,
        max(left - kept, label(3))
    );
    left -= part.nForce;
    forced = forced || part.forced;
    hTry = part.hNext;
    end = part.state;
    return part.h;
}


template<class ParcelType>
template<class State>
void Foam::SpinningParcel<ParcelType>::ontoFace
(
    const convexCells& cells,
    const label place,
    const impact::vector3& moving,
    const State& state,
    const impact::particleMotion::result<State>& o,
    impact::vector3& x,
    State& end,
    scalar& t
)
{
    const impact::vector3 v = impact::multiply(moving, end.v);
    const scalar late =
        cells.heightAbove(place, x)
       /max(impact::dot(cells.normal(place), v), ROOTVSMALL);
    if (late == 0 || mag(late) >= 0.1*t)
    {
        return;
    }
    const scalar share = late/t;
    x = x - late*v;
    end.v = end.v - share*(2*(end.v - state.v) - t*o.a);
    end.omega = end.omega - share*(2*(end.omega - state.omega) - t*o.alpha);
    if constexpr (impact::particleMotion::thermal<State>)
    {
        end.h -= share*(2*(end.h - state.h) - t*o.hDot);
    }
    t -= late;
}


template<class ParcelType>
template<class TrackCloudType, class Force>
bool Foam::SpinningParcel<ParcelType>::moveEmbedded
(
    TrackCloudType& cloud,
    trackingData& td,
    const scalar trackTime,
    Force& force
)
{
    typedef typename TrackCloudType::parcelType parcelType;
    parcelType& p = static_cast<parcelType&>(*this);
    typename parcelType::trackingData& ttd =
        static_cast<typename parcelType::trackingData&>(td);

    ttd.switchProcessor = false;
    ttd.keepParticle = true;

    const impact::particleMotion& motion = cloud.embedded();
    const convexCells& cells = cloud.cells();
    const cellGas& gas = cloud.gas();
    const bool coupled = cloud.solution().coupled();
    auto& statistics = cloud.statistics();
    const polyMesh& mesh = p.mesh();
    const bool reduced = mesh.nSolutionD() != 3;
    const impact::vector3 moving(toCore(cells.moving()));

    // The parcel has to be where it says while somebody looks at it
    const bool watched = cloud.watched();

    impact::vector3 x{0, 0, 0};
    label celli = -1;
    locate(cells, x, celli);
    flight_.cell = -1;
    if (flight_.begun > 0)
    {
        p.stepFraction() = flight_.begun;
        flight_.begun = 0;
    }

    // The gas of the cell, if it has to be put together
    cellGas::field store;

    label left = maxForces - flight_.nForces;
    flight_.nForces = 0;
    label stalls = 0;
    label hits = 0;
    scalar hTry = flight_.hTry;
    flight_.hTry = GREAT;

    force.parcel(p, ttd);

    while (ttd.keepParticle && !ttd.switchProcessor && p.stepFraction() < 1)
    {
        if (!p.active())
        {
            p.stepFraction() = 1;
            p.age() += trackTime;
            break;
        }

        const scalar begin = p.stepFraction();
        const scalar remaining = (1 - begin)*trackTime;
        const impact::vector3 start = x;
        const vector U0 = p.U();
        const vector omega0 = omega_;
        typedef typename std::remove_reference_t<Force>::state State;
        constexpr bool heated = impact::particleMotion::thermal<State>;
        const scalar T0 = T_;
        State state;
        state.x = impact::vector3{0, 0, 0};
        state.v = toCore(U0);
        state.omega = toCore(omega0);
        if constexpr (heated)
        {
            state.h = force.heat().material().h(T0);
        }

        if (Force::places)
        {
            tetPlace::put(p, cells, x, celli, -1);
        }
        const cellGas::field& here = gas.at(celli, store);
        force.place(here, x);

        label ahead = -1;
        const impact::vector3 way = impact::multiply(moving, state.v);
        const scalar exit = cells.exitTime(celli, x, way, remaining, ahead);
        const scalar gasSpeed = impact::mag(force.here().u);
        const scalar hMax =
            longestStep(remaining, exit, here.length, mag(U0), gasSpeed);
        const auto o = motion.step
        (
            force,
            state,
            gasSpeed,
            impact::mag(force.here().spin),
            hMax,
            hTry,
            max(left - kept, label(3))
        );
        left -= o.nForce;
        statistics.nForces += o.nForce;
        statistics.nForced += o.forced;
        hTry = o.hNext;

        // Along the curved way until it meets a face
        const curvedPath path
        (
            x,
            impact::multiply(moving, o.state.x),
            o.h*way,
            o.h*impact::multiply(moving, o.state.v)
        );
        label place = -1;
        const scalar tau = path.exit(cells, celli, 0, 1, place);
        scalar t = tau*o.h;
        State end = o.state;
        end.x = path(tau);
        if (tau < 1)
        {
            // A parabola where that is accurate, another step where not
            if (!onParabola(motion, state, o, tau, end))
            {
                const label before = left;
                bool forced = o.forced;
                t = partOfStep
                (
                    force, motion, state, o, tau, left, forced, hTry, end
                );
                statistics.nForces += before - left;
                statistics.nForced += forced && !o.forced;
            }
            if (t < tau*o.h)
            {
                place = -1;
            }
            end.x = impact::multiply(moving, end.x);
        }
        force.done();
        x = x + end.x;
        if (place >= 0)
        {
            ontoFace(cells, place, moving, state, o, x, end, t);
        }

        p.stepFraction() =
            place >= 0 || t < remaining ? min(begin + t/trackTime, 1.0) : 1;
        p.U() = fromCore(end.v);
        if (reduced)
        {
            meshTools::constrainDirection(mesh, mesh.solutionD(), p.U());
        }
        omega_ = fromCore(end.omega);
        const scalar mass = p.mass();
        scalar heat = 0;
        if constexpr (heated)
        {
            T_ = force.heat().material().T(end.h);
            heat = takeHeat(cloud, force.heat(), T0, o.kHeat, t);
        }
        if (coupled)
        {
            giveToGas
            (
                cloud, force.massEff(mass), U0, omega0,
                t*force.external(mass, p.rho()), heat, true
            );
        }
        ++statistics.nSteps;

        // Another part of the mesh cell, another mesh cell, or the boundary
        const label next =
            place < 0 ? celli : cells.behind(place, x);
        const bool bounded = place >= 0 && next < 0;
        const bool between = place >= 0 && cells.meshFace(place) < 0;

        // A parcel pressed against a wall, or on an edge, may hit again and
        // again in next to no time: then a tenth of the step passes where it
        // is
        stalls = t < 1e-9*trackTime ? stalls + 1 : 0;
        if (bounded)
        {
            // Near the axis a wedge is met again and again on a straight way
            const label patchi = cells.boundary()[-1 - next].patch;
            hits += !isA<wedgePolyPatch>(mesh.boundaryMesh()[patchi]);
        }
        if (stalls > 20 || hits > 50)
        {
            stalls = 0;
            hits = 0;
            const scalar pause =
                min((1 - p.stepFraction())*trackTime, 0.1*trackTime);
            if (Force::places)
            {
                tetPlace::put(p, cells, x, celli, -1);
            }
            force.place(gas.at(celli, store), x);
            const vector U2 = p.U();
            const vector omega2 = omega_;
            [[maybe_unused]] const scalar T2 = T_;
            State rest = state;
            rest.v = toCore(U2);
            rest.omega = toCore(omega2);
            if constexpr (heated)
            {
                rest.h = force.heat().material().h(T2);
            }
            const auto rate = force(rest);
            force.done();
            --left;
            ++statistics.nForces;
            const scalar acting = pause/(1 + pause*rate.k);
            p.U() += acting*fromCore(rate.a);
            omega_ += pause/(1 + pause*rate.kSpin)*fromCore(rate.alpha);
            heat = 0;
            if constexpr (heated)
            {
                const scalar during = pause/(1 + pause*rate.kHeat);
                T_ = force.heat().material().T(rest.h + during*rate.hDot);
                heat = takeHeat(cloud, force.heat(), T2, rate.kHeat, pause);
            }
            if (coupled)
            {
                giveToGas
                (
                    cloud, force.massEff(mass), U2, omega2,
                    acting*force.external(mass, p.rho()), heat, true
                );
            }
            p.stepFraction() =
                pause < (1 - p.stepFraction())*trackTime
              ? p.stepFraction() + pause/trackTime
              : 1;
            t += pause;
            ++statistics.nPauses;
        }

        p.age() += t;

        if (watched || bounded)
        {
            tetPlace::put(p, cells, x, celli, between ? -1 : place);
            if (p.onFace())
            {
                foamCompat::postFace(cloud.functions(), p, ttd);
            }
            foamCompat::postMove
                (cloud.functions(), p, t, fromCore(start), ttd);
            if (!ttd.keepParticle)
            {
                break;
            }
        }

        if (bounded)
        {
            p.hitFace(fromCore(x - start), cloud, ttd);
            if (ttd.keepParticle && !ttd.switchProcessor)
            {
                locate(cells, x, celli);
            }
        }
        else if (place >= 0)
        {
            // Some tetrahedron of the next cell, for whoever asks
            celli = next;
            p.cell() = cells.meshCell(celli);
            if (!between)
            {
                p.tetFace() = cells.meshFace(place);
                p.tetPt() = 1;
            }
        }

        if (place >= 0)
        {
            // Nothing is carried from cell to cell, so that a face between two
            // ranks is like any other
            statistics.mostForces =
                max(statistics.mostForces, scalar(maxForces - left));
            left = maxForces;
            hTry = GREAT;
        }
    }
    statistics.mostForces =
        max(statistics.mostForces, scalar(maxForces - left));

    if (ttd.keepParticle && !ttd.switchProcessor && p.stepFraction() >= 1)
    {
        flight_.x = x;
        flight_.cell = celli;
        if (watched)
        {
            land(cells);
        }
    }

    return ttd.keepParticle;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

template<class ParcelType>
void Foam::SpinningParcel<ParcelType>::locate
(
    const convexCells& cells,
    impact::vector3& x,
    label& celli
) const
{
    if (flight_.cell >= 0)
    {
        x = flight_.x;
        celli = flight_.cell;
        return;
    }
    const polyMesh& mesh = cells.mesh();
    point at = ParcelType::position();
    if (mesh.nSolutionD() != 3)
    {
        meshTools::constrainToMeshCentre(mesh, at);
    }
    x = toCore(at);
    celli = cells.locate(this->cell(), x);
}


template<class ParcelType>
void Foam::SpinningParcel<ParcelType>::settle(const convexCells& cells)
{
    if (flight_.cell >= 0)
    {
        tetPlace::put(*this, cells, flight_.x, flight_.cell, -1);
    }
}


template<class ParcelType>
template<class TrackCloudType>
bool Foam::SpinningParcel<ParcelType>::move
(
    TrackCloudType& cloud,
    trackingData& td,
    const scalar trackTime
)
{
    if (!cloud.embeddedMotion())
    {
        return ParcelType::move(cloud, td, trackTime);
    }
    if (cloud.solution().coupled() && !cloud.inMotion())
    {
        // The gas is that of the exchange only in the step of all parcels
        return true;
    }
    return cloud.withForce
    (
        [&](auto& force)
        {
            return moveEmbedded(cloud, td, trackTime, force);
        }
    );
}
