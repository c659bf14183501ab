/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "foamCompat.H"
#include "meshTools.H"
#include "spinningParcelForces.H"

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
Foam::scalar Foam::SpinningParcel<ParcelType>::curvedPath::timeAt
(
    const vector& aim,
    const scalar share,
    const scalar last
) const
{
    // The progress towards the aim is a cubic: Newton's method kept within
    // the interval that holds the root
    const scalar scale = 1/magSqr(aim);
    const scalar p0 = scale*(start & aim);
    const scalar pm = scale*(whole & aim);
    const scalar p1 = scale*(end & aim);

    scalar low = 0, high = last, t = share*last;
    for (label i = 0; i < 20; ++i)
    {
        const scalar f =
            t*(p0*sqr(1 - t) + pm*t*(3 - 2*t) - p1*t*(1 - t)) - share;
        if (f > 0)
        {
            high = t;
        }
        else
        {
            low = t;
        }
        const scalar df =
            p0*(1 - t)*(1 - 3*t) + 6*pm*t*(1 - t) + p1*t*(3*t - 2);
        scalar next = mag(df) > 1e-6 ? t - f/df : 0.5*(low + high);
        if (!(next >= low && next <= high))
        {
            next = 0.5*(low + high);
        }
        if (mag(next - t) < 1e-15)
        {
            return next;
        }
        t = next;
    }
    return t;
}


template<class ParcelType>
Foam::scalar Foam::SpinningParcel<ParcelType>::continuationError
(
    const impact::gasState& there,
    const impact::gasState& thought,
    const impact::gasState& begin,
    const impact::motionState& state,
    const impact::particleMotion::outcome& o,
    const scalar t
)
{
    const scalar material =
        mag(there.rho/thought.rho - 1)
      + mag(there.mu/thought.mu - 1)
      + mag(there.T/thought.T - 1);

    const auto part =
        [t, material]
        (
            const scalar k,
            const impact::vector3& difference,
            const impact::vector3& slip,
            const scalar scale
        )
        {
            return
                min(scalar(1), 0.5*k*t)
               *(impact::mag(difference) + material*impact::mag(slip))/scale;
        };

    return max
    (
        part(o.k, there.u - thought.u, begin.u - state.v, o.vScale),
        part
        (
            o.kSpin,
            there.spin - thought.spin,
            begin.spin - state.omega,
            o.spinScale
        )
    );
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
    const scalar tolerance = motion.tolerance();
    const bool coupled = cloud.solution().coupled();
    auto& statistics = cloud.statistics();
    const polyMesh& mesh = p.mesh();
    const bool reduced = mesh.nSolutionD() != 3;

    // A part of the evaluations is kept for exponential steps without error
    // control, three each and three more where a face cuts one, with which a
    // parcel can still stop at the tetrahedra. The last but one may be cut
    // once, the last one stops at nothing but a face.
    const label kept = 27;
    const label last = 15;
    const label veryLast = 12;
    label left = maxForces;
    label stalls = 0;
    label hits = 0;
    scalar hTry = GREAT;

    // Sub-steps that end with the tetrahedron from the start, after a cut
    bool byTetrahedra = false;

    force.parcel(p, ttd);

    while (ttd.keepParticle && !ttd.switchProcessor && p.stepFraction() < 1)
    {
        const scalar begin = p.stepFraction();
        scalar t = (1 - begin)*trackTime;
        vector s(Zero);

        force.place(p);
        const point start = force.tet().start();

        if (p.active())
        {
            const place from(p);
            const vector U0 = p.U();
            const vector omega0 = omega_;
            vector deviation(Zero);
            if (reduced)
            {
                point centre = start;
                meshTools::constrainToMeshCentre(mesh, centre);
                deviation = start - centre;
            }
            const impact::motionState state
            {
                {0, 0, 0},
                toCore(U0),
                toCore(omega0)
            };
            const impact::gasState& gas = force.here();
            const scalar gasSpeed = mag(fromCore(gas.u));
            const scalar gasSpin = mag(fromCore(gas.spin));

            // Not far beyond the cell: the gas is not known there. The very last
            // step goes as far as it may, through gas like that around: the
            // continuation of a shock would turn the parcel back.
            const bool final = left < last;
            scalar hMax = t;
            if (left < veryLast)
            {
                force.hold();
            }
            else
            {
                hMax = min
                (
                    hMax,
                    1.5*cloud.cellLengthScale()[p.cell()]
                   /max(max(mag(U0), gasSpeed), ROOTVSMALL)
                );
            }
            if (!final && (byTetrahedra || left < kept + 7))
            {
                hMax *= min
                (
                    scalar(1),
                    1.02*force.tet().exit(toCore(hMax*U0)) + 1e-3
                );
            }
            vector U1, omega1;
            bool again = true;
            while (again)
            {
                again = false;
                const auto o = motion.step
                (
                    force,
                    state,
                    gasSpeed,
                    gasSpin,
                    hMax,
                    hTry,
                    max(left - kept, label(3))
                );
                force.done();
                left -= o.nForce;
                statistics.nForces += o.nForce;
                hTry = o.hNext;

                s = fromCore(o.state.x);
                const curvedPath path{o.h*U0, s, o.h*fromCore(o.state.v)};
                const scalar accuracy = tolerance*o.h*o.vScale;

                // Part of the step that is taken, and where it leads
                scalar tau = 1;
                vector aim = s;
                bool cut = true;
                while (cut && !again)
                {
                    cut = false;

                    // Track along the chord, and where that meets a face aim
                    // at the point of the curved path at that time, until the
                    // two agree
                    for (label i = 0; ; ++i)
                    {
                        const vector way = aim - deviation;
                        if (force.tet().moveInside(p, way))
                        {
                            break;
                        }
                        const scalar share =
                            1 - p.trackToFace(way, tau*o.h/trackTime);

                        if
                        (
                            !p.onFace()
                         || magSqr(aim) < ROOTVSMALL*ROOTVSMALL
                        )
                        {
                            break;
                        }
                        if ((U0 & aim) < 0 && left >= last)
                        {
                            // The path turns back: follow its first part
                            again = true;
                            hMax = min
                            (
                                0.25*o.h,
                                magSqr(U0)
                               /max(mag(U0 & fromCore(o.a)), ROOTVSMALL)
                            );
                            break;
                        }

                        tau = path.timeAt(aim, share, tau);
                        const vector there = path(tau);
                        aim *= share;
                        if
                        (
                            i == 4
                         || final
                         || mag(there - aim) <= accuracy
                        )
                        {
                            break;
                        }
                        aim = there;
                        from.restore(p);
                    }

                    if
                    (
                        !again
                     && left >= veryLast
                     && (p.tetFace() != from.tetFace || p.tetPt() != from.tetPt)
                    )
                    {
                        const impact::vector3 end = toCore(aim);
                        const scalar error = continuationError
                        (
                            force.gas().at(p),
                            force.tet()(end),
                            gas,
                            state,
                            o,
                            tau*o.h
                        )/tolerance;
                        byTetrahedra = error > (byTetrahedra ? 0.1 : 1);
                        if (error > 1)
                        {
                            tau *=
                                min
                                (
                                    max
                                    (
                                        0.9/sqrt(error),
                                        1.02*force.tet().exit(end)
                                    ),
                                    0.8
                                );
                            aim = path(tau);
                            cut = true;
                            ++statistics.nCuts;
                        }
                    }

                    if (cut || again)
                    {
                        from.restore(p);
                    }
                }

                t = tau*o.h;
                U1 = fromCore(o.state.v);
                omega1 = fromCore(o.state.omega);
                if (tau < 1 && !again)
                {
                    // Velocity and spin then: a parabola through both ends
                    // where that is accurate, another step where not
                    const vector a0 = o.h*fromCore(o.a);
                    const vector alpha0 = o.h*fromCore(o.alpha);
                    const vector dU = U1 - U0 - a0;
                    const vector dOmega = omega1 - omega0 - alpha0;
                    U1 = U0 + tau*a0 + sqr(tau)*dU;
                    omega1 = omega0 + tau*alpha0 + sqr(tau)*dOmega;

                    const scalar cubic = sqr(tau)*(1 - tau)/tolerance;
                    const auto size =
                        [](const vector& d, const vector& a)
                        {
                            const scalar magD = mag(d);
                            const scalar magA = mag(a);
                            return magD < magA ? magD*magD/magA : magD;
                        };
                    if
                    (
                        cubic*size(dU, a0) > o.vScale
                     || cubic*size(dOmega, alpha0) > o.spinScale
                    )
                    {
                        const place arrived(p);
                        from.restore(p);
                        const auto part = motion.step
                        (
                            force,
                            state,
                            gasSpeed,
                            gasSpin,
                            t,
                            t,
                            max(left - kept, label(3))
                        );
                        force.done();
                        arrived.restore(p);
                        left -= part.nForce;
                        statistics.nForces += part.nForce;
                        if (part.h == t)
                        {
                            U1 = fromCore(part.state.v);
                            omega1 = fromCore(part.state.omega);
                        }
                    }
                }
                statistics.nForced += o.forced;
            }

            p.stepFraction() =
                p.onFace() || t < (1 - begin)*trackTime
              ? begin + t/trackTime
              : 1;

            if (reduced)
            {
                meshTools::constrainDirection(mesh, mesh.solutionD(), U1);
            }
            const scalar mass = p.mass();
            if (coupled)
            {
                const vector impulse = t*force.external(mass, p.rho());
                const scalar massEff = force.massEff(mass);
                p.U() = U1;
                omega_ = omega1;
                giveToGas(cloud, massEff, U0, omega0, impulse, true);
            }
            else
            {
                p.U() = U1;
                omega_ = omega1;
            }

            // A parcel pressed against a wall, or on an edge, may hit again
            // and again in next to no time: then a tenth of the step passes
            // where it is
            stalls = t < 1e-9*trackTime ? stalls + 1 : 0;
            hits += p.onBoundaryFace();
            if (stalls > 20 || hits > 50)
            {
                stalls = 0;
                hits = 0;
                const scalar pause =
                    min((1 - p.stepFraction())*trackTime, 0.1*trackTime);
                force.place(p);
                const impact::motionRate rate = force
                (
                    impact::motionState
                    {
                        {0, 0, 0},
                        toCore(p.U()),
                        toCore(omega_)
                    }
                );
                force.done();
                --left;
                ++statistics.nForces;
                const scalar acting = pause/(1 + pause*rate.k);
                const vector impulse = acting*force.external(mass, p.rho());
                const scalar massEff = force.massEff(mass);
                const vector U2 = p.U();
                const vector omega2 = omega_;
                p.U() += acting*fromCore(rate.a);
                omega_ += pause/(1 + pause*rate.kSpin)*fromCore(rate.alpha);
                if (coupled)
                {
                    giveToGas(cloud, massEff, U2, omega2, impulse, true);
                }
                p.stepFraction() =
                    pause < (1 - p.stepFraction())*trackTime
                  ? p.stepFraction() + pause/trackTime
                  : 1;
                t += pause;
                ++statistics.nPauses;
            }
            ++statistics.nSteps;
        }
        else
        {
            p.stepFraction() = 1;
        }

        p.age() += t;

        if (p.active() && p.onFace())
        {
            foamCompat::postFace(cloud.functions(), p, ttd);
        }

        foamCompat::postMove(cloud.functions(), p, t, start, ttd);

        if (p.active() && p.onFace() && ttd.keepParticle)
        {
            p.hitFace(s, cloud, ttd);

            // Nothing is carried from cell to cell, so that a face between
            // two ranks is like any other
            statistics.mostForces =
                max(statistics.mostForces, scalar(maxForces - left));
            left = maxForces;
            hTry = GREAT;
            byTetrahedra = false;
        }
    }
    statistics.mostForces =
        max(statistics.mostForces, scalar(maxForces - left));

    return ttd.keepParticle;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

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
    if (cloud.coreForce())
    {
        return moveEmbedded(cloud, td, trackTime, *cloud.coreForce());
    }
    return moveEmbedded(cloud, td, trackTime, *cloud.listedForce());
}
