/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

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

    // Three evaluations are kept for the crossing of a face
    const label allowance = maxForces - 4;
    label left = allowance;
    label stalls = 0;
    scalar hTry = GREAT;

    force.parcel(p, ttd);

    while (ttd.keepParticle && !ttd.switchProcessor && p.stepFraction() < 1)
    {
        const point start = p.position();
        const scalar begin = p.stepFraction();
        scalar t = (1 - begin)*trackTime;
        vector s(Zero);

        if (p.active())
        {
            const place from(p);
            const vector U0 = p.U();
            const vector omega0 = omega_;
            const vector deviation = p.deviationFromMeshCentre();
            const impact::motionState state
            {
                {0, 0, 0},
                toCore(U0),
                toCore(omega0)
            };
            force.place(p);
            const impact::gasState& gas = force.here();
            const scalar gasSpeed = mag(fromCore(gas.u));
            const scalar gasSpin = mag(fromCore(gas.spin));

            // Not far beyond the cell: the gas is not known there
            scalar hMax = min
            (
                t,
                1.5*cloud.cellLengthScale()[p.cell()]
               /max(max(mag(U0), gasSpeed), ROOTVSMALL)
            );
            vector U1, omega1;
            while (true)
            {
                const auto o = motion.step
                (
                    force,
                    state,
                    gasSpeed,
                    gasSpin,
                    hMax,
                    hTry,
                    max(left, label(3))
                );
                force.done();
                left -= o.nForce;
                statistics.nForces += o.nForce;
                hTry = o.hNext;

                s = fromCore(o.state.x);
                U1 = fromCore(o.state.v);
                omega1 = fromCore(o.state.omega);
                t = o.h;
                impact::vector3 end = o.state.x;

                // Track along the chord to the end of the path, and where
                // that meets a face aim at the point of the curved path at
                // that time, until the two agree
                const curvedPath path{o.h*U0, s, o.h*U1};
                const bool moves = magSqr(s) > ROOTVSMALL*ROOTVSMALL;
                const scalar accuracy = tolerance*o.h*o.vScale;
                vector aim = s;
                scalar tau = 1;
                bool back = false;
                for (label i = 0; ; ++i)
                {
                    const scalar share =
                        1
                      - p.trackToFace(aim - deviation, tau*o.h/trackTime);

                    if (!p.onFace() || !moves)
                    {
                        break;
                    }
                    if ((U0 & aim) < 0 && left >= 10)
                    {
                        back = true;
                        break;
                    }

                    tau = path.timeAt(aim, share, tau);
                    const vector there = path(tau);
                    aim *= share;
                    if (i == 4 || mag(there - aim) <= accuracy)
                    {
                        break;
                    }
                    aim = there;
                    from.restore(p);
                }
                if (back)
                {
                    // The path turns back: follow its first part
                    from.restore(p);
                    hMax = 0.25*o.h;
                    continue;
                }

                if (tau < 1)
                {
                    t = tau*o.h;
                    end = toCore(aim);

                    // Velocity and spin then: a parabola through both ends
                    // where that is accurate, another step where not
                    const vector a0 = o.h*fromCore(o.a);
                    const vector alpha0 = o.h*fromCore(o.alpha);
                    const vector dU = U1 - U0 - a0;
                    const vector dOmega = omega1 - omega0 - alpha0;
                    const scalar cubic = sqr(tau)*(1 - tau)/tolerance;
                    const scalar missing = max
                    (
                        cubic*mag(dU)
                       *min(scalar(1), mag(dU)/(mag(a0) + ROOTVSMALL))/o.vScale,
                        cubic*mag(dOmega)
                       *min(scalar(1), mag(dOmega)/(mag(alpha0) + ROOTVSMALL))
                       /o.spinScale
                    );
                    bool parabola = true;
                    if (missing > 1)
                    {
                        const place arrived(p);
                        from.restore(p);
                        const auto again = motion.step
                        (
                            force,
                            state,
                            gasSpeed,
                            gasSpin,
                            t,
                            t,
                            max(left, label(3))
                        );
                        force.done();
                        arrived.restore(p);
                        left -= again.nForce;
                        statistics.nForces += again.nForce;
                        if (again.h == t)
                        {
                            U1 = fromCore(again.state.v);
                            omega1 = fromCore(again.state.omega);
                            parabola = false;
                        }
                    }
                    if (parabola)
                    {
                        U1 = U0 + tau*a0 + sqr(tau)*dU;
                        omega1 = omega0 + tau*alpha0 + sqr(tau)*dOmega;
                    }
                }

                if
                (
                    (p.tetFace() != from.tetFace || p.tetPt() != from.tetPt)
                 && left >= 10
                )
                {
                    // Gas in the tetrahedron of arrival against the
                    // continuation, as the error that half the difference
                    // over the whole time makes
                    const impact::gasState there = force.gas().at(p);
                    const impact::gasState thought = force.tet()(end);
                    const scalar relaxed = min(scalar(1), 0.5*o.k*t);
                    const scalar spinRelaxed = min(scalar(1), 0.5*o.kSpin*t);
                    const scalar material =
                        mag(there.rho/thought.rho - 1)
                      + mag(there.mu/thought.mu - 1)
                      + mag(there.T/thought.T - 1);
                    const scalar slip = mag(fromCore(gas.u) - U0);
                    const scalar spinSlip = mag(fromCore(gas.spin) - omega0);
                    const scalar error = max
                    (
                        relaxed
                       *(
                            mag(fromCore(there.u - thought.u))
                          + material*slip
                        )/o.vScale,
                        spinRelaxed
                       *(
                            mag(fromCore(there.spin - thought.spin))
                          + material*spinSlip
                        )/o.spinScale
                    )/tolerance;

                    if (error > 1)
                    {
                        from.restore(p);
                        hMax =
                            t*min
                            (
                                max
                                (
                                    0.9/sqrt(error),
                                    1.02*force.tet().exit(end)
                                ),
                                0.8
                            );
                        ++statistics.nCuts;
                        continue;
                    }
                }

                statistics.nForced += o.forced;
                break;
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
            // and again in no time: then time passes where it is
            stalls = t < 1e-9*trackTime ? stalls + 1 : 0;
            if (stalls > 20)
            {
                stalls = 0;
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
                ++statistics.nForces;
                p.U() += pause/(1 + pause*rate.k)*fromCore(rate.a);
                omega_ += pause/(1 + pause*rate.kSpin)*fromCore(rate.alpha);
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
            cloud.functions().postFace(p, ttd.keepParticle);
        }

        cloud.functions().postMove(p, t, start, ttd.keepParticle);

        if (p.active() && p.onFace() && ttd.keepParticle)
        {
            p.hitFace(s, cloud, ttd);
            left = allowance;
        }
    }

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
