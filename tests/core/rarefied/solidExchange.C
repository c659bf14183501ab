/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.

Description
    Molecules and spheres in a cell: balances to round-off, mean rates on the
    gas against those on the spheres, equilibrium, and the hard cases.
\*---------------------------------------------------------------------------*/

#include "solidExchange.H"
#include "maxwellian.H"

#include <gtest/gtest.h>
#include <algorithm>
#include <cmath>

using namespace impact;

namespace
{
    typedef solidExchange::mode mode;
    const double k = maxwellian::boltzmann;
    const std::vector<cellCollisions::species> kinds =
        {{3.34e-27, 2.92e-10, 0.67, 2}, {46.5e-27, 4.17e-10, 0.74, 2}};
    const double diameter = 3e-6;

    struct cell
    {
        std::vector<double> u, v, w, e;
        std::vector<std::int32_t> kind;
        std::vector<double> up, vp, wp, T, number;
        std::vector<std::int32_t> group;

        cell
        (
            int n, double speed, double Tg, int np, double Tp, double N,
            unsigned key = 1
        )
        {
            counterRandom rnd(17, key);
            for (int i = 0; i < n; ++i)
            {
                const int s = i % 2;
                const double c = std::sqrt(k*Tg/kinds[s].mass);
                u.push_back(speed + c*rnd.normal());
                v.push_back(c*rnd.normal());
                w.push_back(c*rnd.normal());
                e.push_back(k*Tg*maxwellian::internalEnergy(2, rnd));
                kind.push_back(s);
            }
            up.assign(np, 0);
            vp.assign(np, 0);
            wp.assign(np, 0);
            T.assign(np, Tp);
            number.assign(np, N);
            group.assign(np, 0);
        }

        cellCollisions::molecules gas()
        {
            return
            {
                int(u.size()), nullptr, nullptr, nullptr, u.data(), v.data(),
                w.data(), e.data(), kind.data()
            };
        }

        solidExchange::spheres solids()
        {
            return
            {
                int(up.size()), up.data(), vp.data(), wp.data(), T.data(),
                number.data(), group.data()
            };
        }
    };

    solidExchange make
    (
        mode m, double a = 1, double d = diameter, double heat = 900
    )
    {
        return solidExchange
        (
            kinds, {2700, heat, a}, {d}, m, sphereReflection::law::exact, 7
        );
    }

    //- Sizes of momentum and energy, for tolerances
    double scale(const solidExchange& x, cell& c, double weight)
    {
        return weight*x.of(c.gas()).energy + x.of(c.solids()).energy;
    }
}


TEST(solidExchange, momentumAndEnergyAreKept)
{
    const double weight = 1e12, V = 1e-9;
    for (const mode m : {mode::perCell, mode::perCollision})
    {
        for (const double a : {0., 0.5, 1.})
        {
            // Hot spheres in a cold gas and the reverse, T ratio 100; mass
            // loading 0.01 to 10
            for (const double Tg : {30., 300., 3000.})
            {
                for (const double N : {0.05, 5., 50.})
                {
                    auto exchange = make(m, a);
                    cell c(40, 900, Tg, 5, 9e4/Tg, N);
                    solidExchange::counts counts;
                    balance ledger;
                    for (int step = 0; step < 20; ++step)
                    {
                        const balance g0 = exchange.of(c.gas());
                        const balance s0 = exchange.of(c.solids());
                        const balance l0 = ledger;
                        exchange.exchange
                        (
                            c.gas(), c.solids(), weight, V, 1e-4, ledger, 0,
                            step, counts
                        );
                        const balance g1 = exchange.of(c.gas());
                        const balance s1 = exchange.of(c.solids());
                        const double E = scale(exchange, c, weight);
                        EXPECT_NEAR
                        (
                            (weight*(g1.energy - g0.energy) + s1.energy
                          - s0.energy + ledger.energy - l0.energy)/E,
                            0, 1e-13
                        );
                        const vector3 P =
                            weight*(g1.momentum - g0.momentum)
                          + s1.momentum - s0.momentum
                          + ledger.momentum - l0.momentum;
                        EXPECT_LT
                        (
                            mag(P),
                            1e-12*(weight*mag(g0.momentum)
                          + mag(s1.momentum) + mag(l0.momentum))
                        );
                        for (const double T : c.T)
                        {
                            EXPECT_GT(T, 0);
                        }
                    }
                    EXPECT_TRUE(counts.collisions > 0 || N < 1);
                }
            }
        }
    }
}


TEST(solidExchange, theGasLosesOnAverageWhatSpheresTake)
{
    // Steps so short that one does not change the state; the sums over many
    // cells of both phases against each other
    const double weight = 1e8, V = 1e-9, dt = 4e-8;
    for (const double a : {0., 1.})
    {
        auto exchange = make(mode::perCell, a);
        balance solids, gas;
        double P2 = 0, E2 = 0;
        solidExchange::counts counts;
        const int n = 8000;
        for (int i = 0; i < n; ++i)
        {
            cell c(100, 1500, 1000, 20, 2200, 1e3, i);
            c.up.assign(20, -300);
            balance ledger;
            const auto g = exchange.exchange
            (
                c.gas(), c.solids(), weight, V, dt, ledger, i, 0, counts
            );
            solids += g.solids;
            gas += g.gas;
            const balance sum = {g.solids.momentum + g.gas.momentum,
                g.solids.energy + g.gas.energy};
            P2 += sum.momentum.x*sum.momentum.x;
            E2 += sum.energy*sum.energy;
        }
        EXPECT_GT(counts.collisions, 5000);
        EXPECT_NEAR
        (
            solids.momentum.x + gas.momentum.x, 0, 4*std::sqrt(P2)
        );
        EXPECT_NEAR(solids.energy + gas.energy, 0, 4*std::sqrt(E2));

        // The errors are small enough to mean something
        EXPECT_LT(std::sqrt(P2), 0.03*std::fabs(solids.momentum.x));
        EXPECT_LT(std::sqrt(E2), 0.05*std::fabs(solids.energy));
    }
}


TEST(solidExchange, trialsLeaveTheMeanAndTheNumberOfCollisions)
{
    const double weight = 1e8, V = 1e-9, dt = 4e-8;
    double scatter[2], number[2];
    for (const int trials : {1, 100})
    {
        auto exchange = make(mode::perCell, 1);
        exchange.setTrials(trials);
        double solids = 0, sampled = 0, square = 0;
        solidExchange::counts counts;
        for (int i = 0; i < 2000; ++i)
        {
            cell c(100, 1500, 1000, 20, 2200, 1e3, i);
            balance ledger;
            const auto g = exchange.exchange
            (
                c.gas(), c.solids(), weight, V, dt, ledger, i, 0, counts
            );
            if (trials == 1)
            {
                EXPECT_EQ(g.sampled.energy, g.gas.energy);
                EXPECT_EQ(g.sampled.momentum.x, g.gas.momentum.x);
            }
            solids += g.solids.energy;
            sampled += g.sampled.energy;
            const double both = g.solids.energy + g.sampled.energy;
            square += both*both;
        }
        EXPECT_NEAR(solids + sampled, 0, 4*std::sqrt(square)) << trials;
        scatter[trials > 1] = std::sqrt(square)/std::fabs(solids);
        number[trials > 1] = double(counts.collisions);
    }
    // A hundred times the collisions, a tenth of the scatter
    EXPECT_NEAR(scatter[1]/scatter[0], 0.1, 0.03);
    EXPECT_GT(number[0], 1000);
    EXPECT_NEAR(number[1]/number[0], 1, 4*std::sqrt(2/number[0]));
    EXPECT_THROW(make(mode::perCell).setTrials(0), std::invalid_argument);
    EXPECT_THROW(make(mode::perCollision).setTrials(2), std::invalid_argument);
}


TEST(solidExchange, perCollisionTakesTheSameOnAverage)
{
    const double weight = 1e8, V = 1e-9, dt = 4e-8;
    balance mean[2];
    double P2 = 0, E2 = 0;
    for (const mode m : {mode::none, mode::perCollision})
    {
        auto exchange = make(m, 0.8);
        solidExchange::counts counts;
        for (int i = 0; i < 8000; ++i)
        {
            cell c(100, 1500, 1000, 20, 1500, 1e3, i);
            balance ledger;
            const auto g = exchange.exchange
            (
                c.gas(), c.solids(), weight, V, dt, ledger, i, 0, counts
            );
            mean[m == mode::none] += g.solids;
            if (m == mode::perCollision)
            {
                P2 += g.solids.momentum.x*g.solids.momentum.x;
                E2 += g.solids.energy*g.solids.energy;
            }
            else
            {
                EXPECT_EQ(counts.candidates, 0);
            }
        }
    }
    EXPECT_NEAR(mean[0].momentum.x, mean[1].momentum.x, 4*std::sqrt(P2));
    EXPECT_NEAR(mean[0].energy, mean[1].energy, 4*std::sqrt(E2));
    EXPECT_LT(std::sqrt(P2), 0.03*mean[1].momentum.x);
}


TEST(solidExchange, aClosedCellComesToOneTemperature)
{
    // Heat capacities of the same size, hot small spheres at rest in a cold
    // gas that streams. The end is that of momentum and energy.
    const double weight = 1e9, V = 1e-9, d = 1e-7, N = 1e3;
    for (const mode m : {mode::perCell, mode::perCollision})
    {
        auto exchange = make(m, 1, d, 900);
        cell c(400, 300, 300, 60, 1500, N);
        const double mp = exchange.sizeOf(0).mass;
        balance ledger;
        solidExchange::counts counts;
        const balance all = {weight*exchange.of(c.gas()).momentum,
            weight*exchange.of(c.gas()).energy
          + exchange.of(c.solids()).energy};
        double mass = 60*N*mp;
        for (const int s : c.kind)
        {
            mass += weight*kinds[s].mass;
        }
        const double thermal =
            all.energy - 0.5*dot(all.momentum, all.momentum)/mass;
        const double T =
            thermal/(60*N*mp*900 + 400*weight*2.5*k
          + (m == mode::perCollision ? 60*1.5*weight*k : 0));

        const int n = 4000;
        double Ts = 0, Tg = 0, us = 0;
        for (int step = 0; step < n; ++step)
        {
            exchange.exchange
            (
                c.gas(), c.solids(), weight, V, 3e-4, ledger, 0, step, counts
            );
            if (step >= n/2)
            {
                const balance g = exchange.of(c.gas());
                double M = 0;
                for (const int s : c.kind)
                {
                    M += kinds[s].mass;
                }
                Tg += (g.energy - 0.5*dot(g.momentum, g.momentum)/M)
                    /(400*2.5*k)/(n/2);
                for (int j = 0; j < 60; ++j)
                {
                    Ts += c.T[j]/60/(n/2);
                    us += c.up[j]/60/(n/2);
                }
            }
        }
        EXPECT_NEAR(Ts/T, 1, 0.02) << int(m);
        EXPECT_NEAR(Tg/T, 1, 0.02) << int(m);
        EXPECT_NEAR(us/(all.momentum.x/mass), 1, 0.03) << int(m);
    }
}


TEST(solidExchange, spheresTooLightToBeBodiesAreSparedTheNoise)
{
    // Heat capacity of a simulated sphere over that of k for a simulated
    // molecule
    const double weight = 1e9, V = 1e-9, d = 3e-9, Tg = 400, Tp = 2000;
    auto exchange = make(mode::perCollision, 1, d);
    const double mass = exchange.sizeOf(0).mass;
    for (const double ratio : {1e-6, 0.03, 1., 9.9, 11.})
    {
        const double N = ratio*weight*k/(900*mass);
        const bool light = ratio < solidExchange::minCapacity;
        cell c(60, 300, Tg, 4, Tp, N);
        solidExchange::counts counts;
        balance ledger;
        const double E0 = scale(exchange, c, weight);
        const vector3 P0 = weight*exchange.of(c.gas()).momentum
          + exchange.of(c.solids()).momentum;
        double minTemperature = Tp;
        const int steps = 400;
        for (int step = 0; step < steps; ++step)
        {
            exchange.exchange
            (
                c.gas(), c.solids(), weight, V, 1e-6, ledger, 0, step, counts
            );
            minTemperature = std::min
            (
                minTemperature, *std::min_element(c.T.begin(), c.T.end())
            );
        }
        EXPECT_EQ(counts.light, light ? 4*steps : 0) << ratio;
        EXPECT_GT(minTemperature, 0.1*Tg) << ratio;
        EXPECT_NEAR
        (
            (scale(exchange, c, weight) + ledger.energy)/E0, 1, 1e-11
        );
        const vector3 P = weight*exchange.of(c.gas()).momentum
          + exchange.of(c.solids()).momentum + ledger.momentum;
        EXPECT_LT(mag(P - P0), 1e-11*mag(P0));
    }
    EXPECT_NEAR
    (
        exchange.minNumber(0, weight)*mass*900/(weight*k),
        std::max(10., 900*46.5e-27/k), 1e-9
    );
}


TEST(solidExchange, hardCasesAreFiniteAndKept)
{
    for (const mode m : {mode::perCell, mode::perCollision, mode::none})
    {
        for (const int n : {0, 1, 2, 5})
        {
            // One sphere heavier than all gas of its cell, and a step far
            // longer than the relaxation
            for (const double N : {1e-10, 1., 1e4})
            {
                auto exchange = make(m, 1, 1e-6);
                cell c(n, 1000, 300, 1, 30000, N);
                solidExchange::counts counts;
                balance ledger;
                const double weight = m == mode::none ? 1e10 : 1;
                const balance before = {
                    weight*exchange.of(c.gas()).momentum
                  + exchange.of(c.solids()).momentum,
                    weight*exchange.of(c.gas()).energy
                  + exchange.of(c.solids()).energy};
                for (int step = 0; step < 50; ++step)
                {
                    exchange.exchange
                    (
                        c.gas(), c.solids(), weight, 1e-12, 1e-7, ledger, 0,
                        step, counts
                    );
                }
                const balance after = {
                    weight*exchange.of(c.gas()).momentum
                  + exchange.of(c.solids()).momentum + ledger.momentum,
                    weight*exchange.of(c.gas()).energy
                  + exchange.of(c.solids()).energy + ledger.energy};
                EXPECT_TRUE(std::isfinite(after.energy));
                EXPECT_GT(c.T[0], 0);
                if (m != mode::none)
                {
                    EXPECT_NEAR(after.energy/before.energy, 1, 1e-12);
                }
            }
        }
    }
}


TEST(solidExchange, aLedgerIsReturnedToTheNextGas)
{
    auto exchange = make(mode::perCell);
    cell one(1, 500, 300, 1, 2000, 1e4);
    solidExchange::counts counts;
    balance ledger;
    for (int step = 0; step < 20; ++step)
    {
        exchange.exchange
        (
            one.gas(), one.solids(), 1e8, 1e-9, 1e-6, ledger, 0, step, counts
        );
    }
    EXPECT_FALSE(ledger.isZero());
    EXPECT_EQ(counts.holding, 20);

    cell next(2000, 500, 300, 0, 300, 1);
    const balance before = exchange.of(next.gas());
    const balance owed = ledger;
    exchange.exchange
    (
        next.gas(), next.solids(), 1e8, 1e-9, 1e-6, ledger, 0, 20, counts
    );
    EXPECT_TRUE(ledger.isZero());
    const balance after = exchange.of(next.gas());
    EXPECT_NEAR
    (
        1e8*(after.energy - before.energy), owed.energy,
        1e-12*1e8*before.energy
    );
}


TEST(solidExchange, aStepOfSomeRelaxationsIsManyShortOnes)
{
    // Of 10 nm, and free-molecular also where a law for all Knudsen numbers
    // says so
    for (const bool corrected : {false, true})
    {
        cell one(1000, 500, 300, 1, 400, 1), many(1000, 500, 300, 1, 400, 1);
        const auto fly = [&](cell& c, double time, int n)
        {
            auto exchange = make(mode::none, 1, 1e-8);
            if (corrected)
            {
                exchange.correct(273, "singhDrag", "kavanau");
            }
            solidExchange::counts counts;
            balance ledger;
            for (int i = 0; i < n; ++i)
            {
                exchange.exchange
                (
                    c.gas(), c.solids(), 1e19, 1, time/n, ledger, 0, i, counts
                );
            }
        };
        for (const double time : {3e-5, 1e-3})
        {
            one.up[0] = many.up[0] = 0;
            one.T[0] = many.T[0] = 400;
            fly(one, time, 1);
            fly(many, time, 1000);
            EXPECT_NEAR(one.up[0], many.up[0], 2) << corrected << ' ' << time;
            EXPECT_NEAR(one.T[0], many.T[0], 1) << corrected << ' ' << time;
        }
        EXPECT_NEAR(one.up[0], 500, 30);
    }
}


TEST(solidExchange, refusesBadInput)
{
    // More hits in a step than anyone can wait for
    auto exchange = make(mode::perCell);
    cell c(10, 0, 300, 1, 300, 1e20);
    solidExchange::counts counts;
    balance ledger;
    EXPECT_THROW
    (
        exchange.exchange
        (
            c.gas(), c.solids(), 1, 1e-9, 1e-6, ledger, 0, 0, counts
        ),
        std::invalid_argument
    );
    const auto law = sphereReflection::law::exact;
    EXPECT_THROW
    (
        solidExchange(kinds, {0, 900, 1}, {1e-6}, mode::none, law, 1),
        std::invalid_argument
    );
    EXPECT_THROW
    (
        solidExchange(kinds, {2700, 900, 1}, {-1e-6}, mode::none, law, 1),
        std::invalid_argument
    );
}


TEST(solidExchange, followsDragAndHeatLawsAtAllKnudsenNumbers)
{
    // Force and heat on a sphere in a cell of many molecules against the laws,
    // with the state and the viscosity of the gas that made the molecules:
    // nitrogen, from free-molecular flow to continuum
    const std::vector<cellCollisions::species> nitrogen = {kinds[1]};
    const double T = 300, speed = 200, Tp = 700, d = 2e-4, Tref = 273;
    const double gamma = 1.4, Pr = 4*gamma/(9*gamma - 5);
    const double m = nitrogen[0].mass, omega = nitrogen[0].omega;
    const double a = std::sqrt(gamma*k*T/m), M = speed/a;
    const double mu = 15*std::sqrt(M_PI*m*k*Tref)
       /(
            2*M_PI*std::pow(nitrogen[0].diameter, 2)
           *(5 - 2*omega)*(7 - 2*omega)
        )*std::pow(T/Tref, omega);

    // Bird's 1.656e-5 Pa s at 273 K, to the three digits of the diameter
    EXPECT_NEAR(mu/(1.656e-5*std::pow(T/Tref, omega)), 1, 0.0024);

    const int n = 400000;
    std::vector<double> u, v, w, e;
    const std::vector<std::int32_t> kind(n, 0);
    const double c = std::sqrt(k*T/m);
    for (int i = 0; i < n; ++i)
    {
        counterRandom rnd(23, i);
        u.push_back(speed + c*rnd.normal());
        v.push_back(c*rnd.normal());
        w.push_back(c*rnd.normal());
        e.push_back(k*T*maxwellian::internalEnergy(2, rnd));
    }
    const cellCollisions::molecules gas =
    {
        n, nullptr, nullptr, nullptr, u.data(), v.data(), w.data(), e.data(),
        kind.data()
    };
    const double weight = 1, dt = 1e-9;
    for (const std::string& drag : knudsenCorrection::dragLaws())
    {
        dragLaw::coefficients dc;
        dc.gamma = gamma;
        const auto Cd = dragLaw::New(drag, dc);
        heatLaw::coefficients hc;
        hc.gamma = gamma;
        hc.Pr = Pr;
        const auto Nu = heatLaw::New("kavanau", hc);
        double first = 0, last = 0;
        for (const double Kn : {1e-3, 0.1, 1., 10., 1e4})
        {
            // Kn = sqrt(pi gamma/2) M/Re
            const double K = Kn/std::sqrt(0.5*M_PI*gamma);
            const double rho = mu/(K*d*a);
            // As it is, corrected, and corrected in a gas that is simulated a
            // hundred times thinner, for as many times as long
            double rate[3], heat[3];
            for (const int corrected : {0, 1, 2})
            {
                const double scale = corrected == 2 ? 100 : 1;
                solidExchange x
                (
                    nitrogen, {2700, 900, 1}, {d}, mode::none,
                    sphereReflection::law::exact, 7
                );
                if (corrected)
                {
                    x.correct(Tref, drag, "kavanau", scale);
                }
                double up = 0, vp = 0, wp = 0, Ts = Tp, number = 1;
                const std::int32_t group = 0;
                solidExchange::counts counts;
                balance ledger;
                x.exchange
                (
                    gas, {1, &up, &vp, &wp, &Ts, &number, &group}, weight,
                    scale*weight*n*m/rho, scale*dt, ledger, 0, 0, counts
                );
                const double mass = x.sizeOf(0).mass;
                rate[corrected] = mass*up/dt;
                heat[corrected] = mass*900*(Ts - Tp)/dt;
            }
            const auto q = (*Nu)(M/K, K);
            const double wanted =
                M_PI/8*d*mu*speed*Cd->CdRe(M/K, K, Tp/T);
            const double wantedHeat = M_PI*d*q.Nu
               *(gamma/(gamma - 1)*k/m*mu/Pr)*(q.TawOverT*T - Tp);
            EXPECT_NEAR(rate[1]/wanted, 1, 0.01) << drag << ' ' << Kn;
            EXPECT_NEAR(heat[1]/wantedHeat, 1, 0.01) << Kn;
            EXPECT_NEAR(rate[2]/rate[1], 1, 1e-3) << drag << ' ' << Kn;
            EXPECT_NEAR(heat[2]/heat[1], 1, 1e-3) << drag << ' ' << Kn;
            last = rate[1]/rate[0];
            first = first > 0 ? first : last;
        }
        // Far from it in continuum, and as it is in free-molecular flow,
        // where the other two laws do not know the temperature of the sphere
        EXPECT_LT(first, 0.1) << drag;
        EXPECT_NEAR(last, 1, drag == "singhDrag" ? 2e-3 : 0.16) << drag;
    }
}


TEST(solidExchange, keepsBalancesWhenCorrected)
{
    for (const mode m : {mode::perCell, mode::none})
    {
        auto exchange = make(m, 1, 2e-4);
        exchange.correct(273, "lothDrag", "kavanau");
        cell c(200, 900, 600, 3, 2000, 5);
        solidExchange::counts counts;
        balance ledger;
        const double weight = 1e16, V = 1e-6;
        for (int step = 0; step < 20; ++step)
        {
            const balance g0 = exchange.of(c.gas());
            const balance s0 = exchange.of(c.solids());
            const balance l0 = ledger;
            const double magnitude = scale(exchange, c, weight);
            exchange.exchange
            (
                c.gas(), c.solids(), weight, V, 1e-6, ledger, 0, step, counts
            );
            balance change = weight*(exchange.of(c.gas()) - g0);
            change += exchange.of(c.solids()) - s0;
            change += ledger - l0;
            if (m == mode::perCell)
            {
                EXPECT_LT(std::fabs(change.energy), 1e-12*magnitude);
                EXPECT_LT(mag(change.momentum), 1e-12*magnitude/900);
            }
        }
        // It was far from free-molecular
        EXPECT_LT(counts.minForce, 0.5);
        EXPECT_GT(counts.minForce, 0);
        EXPECT_EQ(counts.collisions > 0, m == mode::perCell);
    }
    EXPECT_THROW
    (
        make(mode::perCollision).correct(273, "lothDrag", "kavanau"),
        std::invalid_argument
    );
    EXPECT_THROW
    (
        make(mode::perCell, 0.9).correct(273, "lothDrag", "kavanau"),
        std::invalid_argument
    );
    EXPECT_THROW
    (
        make(mode::perCell).correct(273, "haiderLevenspielDrag", "kavanau"),
        std::invalid_argument
    );
    EXPECT_THROW
    (
        make(mode::perCell).correct(273, "lothDrag", "ranzMarshall"),
        std::invalid_argument
    );
    EXPECT_THROW
    (
        make(mode::perCell).correct(0, "lothDrag", "kavanau"),
        std::invalid_argument
    );
    EXPECT_THROW
    (
        make(mode::perCell).correct(273, "lothDrag", "kavanau", 0),
        std::invalid_argument
    );
}
