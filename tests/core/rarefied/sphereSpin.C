/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.

Description
    Spheres that spin in a gas of molecules: torque, lift and heat against
    those of an equilibrium gas and against reflections followed one by one,
    balances to round-off, mean rates on the gas, equipartition, stiff steps.
\*---------------------------------------------------------------------------*/

#include "solidExchange.H"
#include "maxwellian.H"
#include "sphereState.H"

#include <gtest/gtest.h>
#include <algorithm>
#include <cmath>

using namespace impact;

namespace
{
    typedef solidExchange::mode mode;
    const double k = maxwellian::boltzmann;
    const double m = 46.5e-27;
    const std::vector<cellCollisions::species> nitrogen =
        {{m, 4.17e-10, 0.74, 2}};

    struct gasOfCell
    {
        std::vector<double> u, v, w, e;
        std::vector<std::int32_t> kind;

        void add(const vector3& c, double internal)
        {
            u.push_back(c.x);
            v.push_back(c.y);
            w.push_back(c.z);
            e.push_back(internal);
            kind.push_back(0);
        }

        //- In equilibrium, streaming along x
        gasOfCell(int n, double speed, double T, unsigned key)
        {
            counterRandom rnd(29, key);
            const double c = std::sqrt(k*T/m);
            for (int i = 0; i < n; ++i)
            {
                const double x = rnd.normal(), y = rnd.normal();
                add
                (
                    {speed + c*x, c*y, c*rnd.normal()},
                    k*T*maxwellian::internalEnergy(2, rnd)
                );
            }
        }

        //- Of given velocities
        explicit gasOfCell(const std::vector<vector3>& velocities)
        {
            for (const vector3& c : velocities)
            {
                add(c, 0);
            }
        }

        cellCollisions::molecules molecules()
        {
            return
            {
                int(u.size()), nullptr, nullptr, nullptr, u.data(), v.data(),
                w.data(), e.data(), kind.data()
            };
        }
    };

    struct spheresOfCell
    {
        std::vector<double> u, v, w, T, number;
        std::vector<std::int32_t> group;
        std::vector<vector3> omega;

        spheresOfCell(int n, double Tp, double N, const vector3& spin)
        :
            u(n, 0), v(n, 0), w(n, 0), T(n, Tp), number(n, N), group(n, 0),
            omega(n, spin)
        {}

        solidExchange::spheres all()
        {
            return
            {
                int(u.size()), u.data(), v.data(), w.data(), T.data(),
                number.data(), group.data(), omega.data()
            };
        }
    };

    solidExchange make(mode exchange, double a, double d, double heat = 900)
    {
        solidExchange x
        (
            nitrogen, {2700, heat, a}, {d}, exchange,
            sphereReflection::law::exact, 7
        );
        x.rotate();
        return x;
    }

    //- What one molecule leaves on a sphere that reflects it diffusely
    struct left
    {
        vector3 momentum, angular;
        double energy;
    };

    //- u relative to the centre; drawn as the surface has it, not as the core
    left reflect
    (
        const vector3& u,
        double R,
        const vector3& omega,
        double T,
        counterRandom& rnd
    )
    {
        // A point of the half that is seen, hit with the cosine
        vector3 n;
        double cosine;
        do
        {
            n = {rnd.normal(), rnd.normal(), rnd.normal()};
            n = (1/mag(n))*n;
            cosine = -dot(n, u)/mag(u);
        }
        while (!(rnd.uniform() < cosine));
        const double c = std::sqrt(k*T/m);
        vector3 out{c*rnd.normal(), c*rnd.normal(), c*rnd.normal()};
        out = out
          + (c*std::sqrt(-2*std::log(rnd.uniform())) - dot(out, n))*n
          + R*cross(omega, n);
        const vector3 p = m*(u - out);
        const double internal = 0.5*2*k*T;
        return
        {
            p, R*cross(n, p), 0.5*m*(dot(u, u) - dot(out, out)) - internal
        };
    }

    void expectNear
    (
        const vector3& a,
        const vector3& b,
        double tolerance,
        const char* what
    )
    {
        for (int i = 0; i < 3; ++i)
        {
            EXPECT_NEAR(a[i], b[i], tolerance) << what << ' ' << i;
        }
    }
}


TEST(sphereSpin, inEquilibriumTheTorqueIsEpsteinsAndTheLiftBorgs)
{
    const double T = 600, R = 1.5e-6, n = 1e21, a = 0.7;
    const double mean = std::sqrt(8*k*T/(M_PI*m));
    const vector3 omega{2e5, -1e5, 3e5};
    for (const double speed : {0., 300., 3000.})
    {
        const int N = 400000;
        gasOfCell gas(N, speed, T, unsigned(speed));
        sphereTransfer transfer(nitrogen, a, 900);
        transfer.gather(gas.molecules());
        const sphereTransfer::sphere s{{0, 0, 0}, T, R, 1e-14, omega};
        const auto q = transfer.onSpin(s, n/N);
        const double area = M_PI*R*R*n*m*a;

        // U of the sphere relative to the gas is -speed
        const vector3 lift = cross(omega, q.lift);
        const vector3 exact =
            -2./3*area*R*cross(omega, vector3{-speed, 0, 0});
        const double noise = std::sqrt(k*T/m/N);
        expectNear(lift, exact, 5*2./3*area*R*noise*mag(omega), "lift");

        // Of the mean speed, isotropic at rest. 0.43 of it is its scatter
        const vector3 torque = -q.damp(omega);
        if (speed == 0)
        {
            expectNear
            (
                torque, -2./3*area*R*R*mean*omega,
                5*0.43*area*R*R*mean/std::sqrt(N)*mag(omega), "torque"
            );
        }
        if (speed == 3000)
        {
            // Nearly a beam: e along x, 1 + O(1/s^2) of its speed
            const vector3 beam =
                -area*R*R*speed*vector3{0.5*omega.x, 0.75*omega.y,
                    0.75*omega.z};
            for (int i = 0; i < 3; ++i)
            {
                EXPECT_NEAR(torque[i]/beam[i], 1, 0.04);
            }
        }
    }
}


TEST(sphereSpin, ratesAreThoseOfReflectionsOneByOne)
{
    const double R = 1.5e-6, T = 500, density = 1e10, M = 1e-14;
    const vector3 omega{2e8, -3e8, 5e8};       // surface at some 900 m/s
    sphereTransfer transfer(nitrogen, 1, 900);
    unsigned key = 0;
    for
    (
        const vector3& u :
        {vector3{700, 0, 0}, vector3{-300, 900, 500}, vector3{0, -50, 2500}}
    )
    {
        const int N = 400000;
        vector3 force{0, 0, 0}, torque{0, 0, 0};
        double heat = 0, force2 = 0, torque2 = 0, heat2 = 0;
        counterRandom rnd(31, ++key);
        for (int i = 0; i < N; ++i)
        {
            const left l = reflect(u, R, omega, T, rnd);
            force = force + l.momentum;
            torque = torque + l.angular;
            heat += l.energy;
            force2 += dot(l.momentum, l.momentum);
            torque2 += dot(l.angular, l.angular);
            heat2 += l.energy*l.energy;
        }
        const double rate = M_PI*R*R*mag(u)*density;
        const double perSample = 5*rate/N;

        gasOfCell gas({u});
        transfer.gather(gas.molecules());
        const sphereTransfer::sphere s{{0, 0, 0}, T, R, M, omega};
        const auto r = transfer.on(s, density);
        const auto q = transfer.onSpin(s, density);
        expectNear
        (
            r.force + cross(omega, q.lift), (rate/N)*force,
            perSample*std::sqrt(force2), "force"
        );
        expectNear
        (
            -q.damp(omega), (rate/N)*torque, perSample*std::sqrt(torque2),
            "torque"
        );

        // Of all energy that comes in, half of the work of the torque is what
        // heat gives to the molecules
        const double lost = dot(q.damp(omega), omega);
        EXPECT_NEAR
        (
            r.heating - r.coolingRate*T - 0.5*lost, rate/N*heat,
            perSample*std::sqrt(heat2)
        );

        // What the tolerances must tell from nothing
        EXPECT_LT(perSample*std::sqrt(force2), 0.1*mag(cross(omega, q.lift)));
        EXPECT_LT(perSample*std::sqrt(heat2), 0.2*lost);

        // A short step is these rates
        const double dt = 1e-6*M/r.dragRate;
        sphereTransfer::sphere after = s;
        transfer.advance(after, r, q, dt);
        const vector3 F = r.force + cross(omega, q.lift);
        expectNear((M/dt)*after.velocity, F, 1e-5*mag(F), "acceleration");
        const vector3 turn = (M*sphereInertia(R)/dt)*(after.omega - omega);
        expectNear(turn, -q.damp(omega), 1e-5*mag(q.damp(omega)), "turning");
        EXPECT_NEAR
        (
            (after.temperature - T)*M*900/dt
           /(r.heating - r.coolingRate*T + 0.5*lost),
            1, 1e-4
        );
    }
}


TEST(sphereSpin, decaysInAnyStepAsTheLawSays)
{
    const double R = 1e-7, M = 2700*M_PI*4/3*R*R*R, density = 1e18;
    const vector3 omega{1e6, 2e6, -1e6};

    // Isotropic: exactly, in steps of any length
    sphereTransfer transfer(nitrogen, 1, 900);
    gasOfCell even
    ({
        {500, 0, 0}, {-500, 0, 0}, {0, 500, 0}, {0, -500, 0}, {0, 0, 500},
        {0, 0, -500}
    });
    transfer.gather(even.molecules());
    const sphereTransfer::sphere s{{0, 0, 0}, 400, R, M, omega};
    const auto r = transfer.on(s, density);
    const auto q = transfer.onSpin(s, density);
    const double rate =
        2./3*M_PI*R*R*R*R*density*6*m*500/(M*sphereInertia(R));
    for (const double t : {1e-3, 0.5, 3., 50., 1e6})
    {
        sphereTransfer::sphere after = s;
        transfer.advance(after, r, q, t/rate);
        expectNear
        (
            after.omega, std::exp(-t)*omega, 1e-12*mag(omega)*std::exp(-t),
            "spin"
        );
    }

    // A beam: along it with 3/4 of the mean rate, across with 9/8. Steps of
    // some relaxation times: nearer than the neglected third order, no
    // reversal, no growth
    gasOfCell beam({{0, 0, 800}});
    transfer.gather(beam.molecules());
    const auto rb = transfer.on(s, density);
    const auto qb = transfer.onSpin(s, density);
    const double across =
        0.75*M_PI*R*R*R*R*density*m*800/(M*sphereInertia(R));
    for (const double t : {0.01, 0.3, 1., 4., 20., 1e3, 1e9})
    {
        sphereTransfer::sphere after = s;
        transfer.advance(after, rb, qb, t/across);
        const vector3 exact
        {
            std::exp(-t)*omega.x, std::exp(-t)*omega.y,
            std::exp(-2./3*t)*omega.z
        };
        const double d = 2./9*t;
        const double third = d*d*d/6*std::exp(-2./3*t);
        expectNear(after.omega, exact, (third + 1e-15)*mag(omega), "spin");
        EXPECT_GE(after.omega.x, 0);
        EXPECT_LE(mag(after.omega), mag(omega)*std::exp(-2./3*t) + 1e-300);
        EXPECT_TRUE(std::isfinite(mag(after.velocity)));
        EXPECT_GT(after.temperature, 0);
    }
}


TEST(sphereSpin, theLiftTurnsTheVelocityStablyInAnyStep)
{
    // So light and fast that the lift turns the velocity far round while the
    // drag stops it
    const double R = 1e-6, M = 1e-16, density = 1e17;
    const vector3 omega{0, 1e9, 3e9}, start{0, 40, 30};
    sphereTransfer transfer(nitrogen, 1, 900);
    gasOfCell gas(2000, 200, 300, 3);
    transfer.gather(gas.molecules());
    sphereTransfer::sphere s{start, 300, R, M, omega};
    const auto r = transfer.on(s, density);
    auto q = transfer.onSpin(s, density);
    const double dragTime = M/r.dragRate;
    EXPECT_GT(q.lag*mag(omega)*dragTime/M, 2);

    // With a spin that stays, one step against many small ones of the
    // differential equation
    for (double& x : q.damping)
    {
        x = 0;
    }
    for (const double t : {0.1, 1., 3.})
    {
        sphereTransfer::sphere one = s;
        transfer.advance(one, r, q, t*dragTime);
        vector3 dv{0, 0, 0};
        const int n = 100000;
        const auto slope = [&](const vector3& x)
        {
            return (1/M)*(r.force - r.dragRate*x
              + cross(omega, q.lift - q.lag*x));
        };
        for (int i = 0; i < n; ++i)
        {
            const double h = t*dragTime/n;
            dv = dv + h*slope(dv + (0.5*h)*slope(dv));
        }
        expectNear(one.velocity - start, dv, 1e-7*mag(dv), "velocity");
        EXPECT_EQ(one.omega.z, omega.z);
    }

    const auto run = [&](double time, int steps)
    {
        sphereTransfer::sphere x = s;
        for (int i = 0; i < steps; ++i)
        {
            transfer.advance
            (
                x, transfer.on(x, density), transfer.onSpin(x, density),
                time/steps
            );
        }
        return x;
    };
    for (const double t : {1., 1e2, 1e6, 1e12})
    {
        const auto x = run(t*dragTime, 20);
        EXPECT_TRUE(std::isfinite(mag(x.velocity)) && mag(x.velocity) < 1e3);
        EXPECT_LT(mag(x.omega), mag(omega));
        EXPECT_GT(x.temperature, 100);
    }

    // At the end as the gas
    const auto x = run(1e6*dragTime, 50);
    EXPECT_NEAR(x.velocity.x, 200, 20);
    EXPECT_NEAR(x.velocity.y, 0, 20);
    EXPECT_EQ(mag(x.omega), 0);
}


TEST(sphereSpin, momentumAndEnergyAreKeptInEveryMode)
{
    for (const mode x : {mode::perCell, mode::perCollision})
    {
        for (const double a : {0., 0.5, 1.})
        {
            for (const double N : {0.05, 5., 50.})
            {
                for (const double spin : {0., 1e5, 3e8})
                {
                    auto exchange = make(x, a, 3e-6);
                    gasOfCell gas(40, 900, 300, 5);
                    spheresOfCell solids(5, 500, N, {spin, 0, -spin});
                    const double weight = 1e12;
                    solidExchange::counts counts;
                    balance ledger;
                    for (int step = 0; step < 20; ++step)
                    {
                        const auto sum = [&]
                        {
                            balance b = weight*exchange.of(gas.molecules());
                            b += exchange.of(solids.all());
                            b += ledger;
                            return b;
                        };
                        const balance before = sum();
                        const balance s0 = exchange.of(solids.all());
                        const auto g = exchange.exchange
                        (
                            gas.molecules(), solids.all(), weight, 1e-9, 1e-4,
                            ledger, 0, step, counts
                        );
                        const balance after = sum();
                        const double E = mag(before.momentum)*900
                          + std::fabs(before.energy) + std::fabs(s0.energy);
                        EXPECT_NEAR((after.energy - before.energy)/E, 0, 1e-13);
                        EXPECT_LT
                        (
                            mag(after.momentum - before.momentum)*900/E, 1e-13
                        );
                        EXPECT_NEAR
                        (
                            (exchange.of(solids.all()).energy - s0.energy
                          - g.solids.energy)/E, 0, 1e-13
                        );
                    }
                    EXPECT_TRUE(counts.collisions > 0 || N < 1);
                    for (const double T : solids.T)
                    {
                        EXPECT_GT(T, 0);
                    }

                    // Bodies alone take up a spin, from diffuse reflections
                    double turned = 0;
                    for (const vector3& w : solids.omega)
                    {
                        turned += mag(w);
                    }
                    const bool bodies = x == mode::perCollision && N > 1;
                    EXPECT_TRUE
                    (
                        spin > 0 || (turned > 0) == (bodies && a > 0)
                    );
                }
            }
        }
    }
}


TEST(sphereSpin, theGasLosesOnAverageWhatSpinningSpheresTake)
{
    // Surfaces as fast as the molecules: lift and the work of the torque are
    // large beside the scatter
    const double weight = 1e8, V = 1e-9, dt = 4e-8;
    const vector3 spin{0, 0, 6e8};
    balance taken[2];
    for (const mode x : {mode::perCell, mode::perCollision})
    {
        auto exchange = make(x, 1, 3e-6);
        balance solids, gas;
        vector3 turned{0, 0, 0};
        double P2 = 0, E2 = 0;
        solidExchange::counts counts;
        for (int i = 0; i < 8000; ++i)
        {
            gasOfCell cell(100, 1500, 1000, i);
            spheresOfCell s(20, 1000, 1e3, spin);
            balance ledger;
            const auto g = exchange.exchange
            (
                cell.molecules(), s.all(), weight, V, dt, ledger, i, 0, counts
            );
            solids += g.solids;
            gas += g.gas;
            const balance sum = x == mode::perCell
              ? balance{g.solids.momentum + g.gas.momentum,
                    g.solids.energy + g.gas.energy}
              : g.solids;
            P2 += dot(sum.momentum, sum.momentum);
            E2 += sum.energy*sum.energy;
            for (const vector3& w : s.omega)
            {
                turned = turned + (w - spin);
            }
        }
        taken[x == mode::perCollision] = solids;
        if (x == mode::perCell)
        {
            expectNear
            (
                solids.momentum, -gas.momentum, 4*std::sqrt(P2), "momentum"
            );
            EXPECT_NEAR(solids.energy, -gas.energy, 4*std::sqrt(E2));
        }
        else
        {
            expectNear
            (
                solids.momentum, taken[0].momentum, 4*std::sqrt(P2), "mean"
            );
            EXPECT_NEAR(solids.energy, taken[0].energy, 4*std::sqrt(E2));
        }

        // The lift, across the stream and the spin, and the spin lost
        const double area = M_PI*2.25e-12;
        const double flow = 8000*20*1e3*(100*weight*m/V)*dt;
        EXPECT_NEAR
        (
            solids.momentum.y/(2./3*area*1.5e-6*spin.z*1500*flow), 1,
            x == mode::perCell ? 0.01 : 0.1
        );
        const double most = 0.75*area*1.5e-6*1.5e-6*spin.z*1700*flow
           /(1e3*exchange.sizeOf(0).mass*sphereInertia(1.5e-6));
        EXPECT_LT(turned.z, -0.8*most);
        EXPECT_GT(turned.z, -most);
        EXPECT_LT(std::sqrt(P2), 0.1*solids.momentum.y);
    }
}


TEST(sphereSpin, bodiesComeToShareTheEnergyOfTheGas)
{
    // Spheres of perCollision in a closed cell: as much energy in the three
    // components of the spin as in those of the velocity, 3/2 W k T each
    const double weight = 1e9, V = 1e-9, d = 1e-7, N = 1e3;
    auto exchange = make(mode::perCollision, 0.8, d);
    gasOfCell gas(400, 0, 600, 9);
    spheresOfCell solids(60, 600, N, {0, 0, 0});
    const double share = N*exchange.sizeOf(0).mass;
    solidExchange::counts counts;
    balance ledger;
    double motion = 0, spin = 0, T = 0;
    const int steps = 6000;
    for (int step = 0; step < steps; ++step)
    {
        exchange.exchange
        (
            gas.molecules(), solids.all(), weight, V, 3e-4, ledger, 0, step,
            counts
        );
        if (step >= steps/3)
        {
            for (int j = 0; j < 60; ++j)
            {
                const vector3 v{solids.u[j], solids.v[j], solids.w[j]};
                motion += 0.5*share*dot(v, v);
                spin += share*sphereRotationalEnergy(0.5*d, solids.omega[j]);
                T += solids.T[j];
            }
        }
    }
    EXPECT_EQ(counts.light, 0);
    const double kT = 1.5*weight*k*T;
    EXPECT_NEAR(motion/kT, 1, 0.05);
    EXPECT_NEAR(spin/kT, 1, 0.05);
}


TEST(sphereSpin, withoutAnySpinThereIsNothingOfIt)
{
    // perCell: the same bits as if the spin were not followed
    for (const bool rotates : {false, true})
    {
        static std::vector<double> first;
        solidExchange exchange
        (
            nitrogen, {2700, 900, 0.8}, {3e-6}, mode::perCell,
            sphereReflection::law::exact, 7
        );
        if (rotates)
        {
            exchange.rotate();
        }
        gasOfCell gas(60, 900, 300, 2);
        spheresOfCell solids(5, 500, 10, {0, 0, 0});
        solidExchange::counts counts;
        balance ledger;
        for (int step = 0; step < 10; ++step)
        {
            exchange.exchange
            (
                gas.molecules(), solids.all(), 1e12, 1e-9, 1e-4, ledger, 0,
                step, counts
            );
        }
        EXPECT_GT(counts.collisions, 10);
        std::vector<double> now = solids.u;
        now.insert(now.end(), gas.u.begin(), gas.u.end());
        now.insert(now.end(), gas.e.begin(), gas.e.end());
        if (rotates)
        {
            EXPECT_EQ(now, first);
        }
        first = now;
    }
}


TEST(sphereSpin, refusesWhatKnowsNoSpin)
{
    const solidExchange::material metal{2700, 900, 1};
    solidExchange fit
    (
        nitrogen, metal, {1e-6}, mode::perCell,
        sphereReflection::law::polynomial, 1
    );
    EXPECT_NE(fit.whyNoSpin().find("deflection"), std::string::npos);
    EXPECT_THROW(fit.rotate(), std::invalid_argument);
    solidExchange corrected
    (
        nitrogen, metal, {1e-6}, mode::perCell, sphereReflection::law::exact, 1
    );
    EXPECT_EQ(corrected.whyNoSpin(), "");
    corrected.correct(273, "lothDrag", "kavanau");
    EXPECT_NE(corrected.whyNoSpin().find("knudsen"), std::string::npos);
    EXPECT_THROW(corrected.rotate(), std::invalid_argument);
}
