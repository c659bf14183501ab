/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.

Description
    Force and heat on a sphere from the molecules of a cell: against the drag
    of Schaaf and Chambre and against quadratures of the free-molecular heat,
    and the relaxation in long steps.
\*---------------------------------------------------------------------------*/

#include "sphereTransfer.H"
#include "elementary.H"
#include "maxwellian.H"

#include <gtest/gtest.h>
#include <cmath>

using namespace impact;

namespace
{
    const double k = maxwellian::boltzmann;

    //- The sequence of van der Corput: even, for a low error
    double radicalInverse(unsigned i, unsigned base)
    {
        double f = 1, x = 0;
        for (; i; i /= base)
        {
            f /= base;
            x += f*(i % base);
        }
        return x;
    }

    //- An equilibrium gas of one species, evenly sampled, in pairs of opposite
    //  thermal velocities
    struct sample
    {
        std::vector<double> u, v, w, e;
        std::vector<std::int32_t> kind;

        sample(int n, double speed, double T, double mass, int zeta)
        {
            const double c = std::sqrt(k*T/mass);
            for (int i = 0; i < n/2; ++i)
            {
                const double r =
                    c*std::sqrt(-2*std::log(1 - radicalInverse(i, 2)
                        - 0.5/n));
                const double z = c*std::sqrt(-2*std::log(1 -
                    radicalInverse(i, 3) - 0.5/n))
                    *std::cos(2*M_PI*radicalInverse(i, 5));
                const double a = 2*M_PI*radicalInverse(i, 7);
                for (const double sign : {-1., 1.})
                {
                    u.push_back(speed + sign*r*std::cos(a));
                    v.push_back(sign*r*std::sin(a));
                    w.push_back(sign*z);
                    e.push_back(0.5*zeta*k*T);
                    kind.push_back(0);
                }
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

    //- Mean of a power of the relative speed over c0 in a gas that streams
    //  with the speed ratio s, by the midpoint rule
    double meanPower(double s, int power)
    {
        const int n = 200000;
        const double end = s + 8;
        double sum = 0;
        for (int i = 0; i < n; ++i)
        {
            const double x = (i + 0.5)*end/n;
            sum += std::pow(x, power + 1)
               *(std::exp(-(x - s)*(x - s)) - std::exp(-(x + s)*(x + s)));
        }
        return sum*end/n/(s*std::sqrt(M_PI));
    }
}


TEST(sphereTransfer, dragIsThatOfSchaafAndChambre)
{
    const double m = 46.5e-27, T = 900, R = 1.5e-6, n = 1e21;
    const double c0 = std::sqrt(2*k*T/m);
    for (const double s : {0.1, 0.3, 1., 3., 10.})
    {
        for (const double a : {0., 0.6, 1.})
        {
            const double Tp = 2200;
            sphereTransfer transfer({{m, 4e-10, 0.74, 2}}, a, 900);
            sample gas(400000, s*c0, T, m, 2);
            transfer.gather(gas.molecules());
            const auto r = transfer.on
            (
                {{0, 0, 0}, Tp, R, 1e-14}, n/gas.u.size()
            );
            const double cD =
                (2*s*s + 1)/(std::sqrt(M_PI)*s*s*s)*std::exp(-s*s)
              + (4*s*s*s*s + 4*s*s - 1)/(2*s*s*s*s)*std::erf(s)
              + a*2*std::sqrt(M_PI)/(3*s)*std::sqrt(Tp/T);
            const double exact =
                0.5*n*m*s*s*c0*c0*M_PI*R*R*cD;
            EXPECT_NEAR(r.force.x/exact, 1, 1e-3) << s << ' ' << a;
            EXPECT_NEAR(r.force.y/exact, 0, 1e-3);
            EXPECT_NEAR(r.force.z/exact, 0, 1e-3);

            // Mean flux of energy onto the sphere less what goes out
            const double flux = n*c0*M_PI*R*R;
            const double heat = a*flux
               *(
                    k*T*meanPower(s, 3)
                  + meanPower(s, 1)*(k*T - 3*k*Tp)
                );
            const double scale = flux
               *(k*T*meanPower(s, 3) + meanPower(s, 1)*(k*T + 3*k*Tp));
            EXPECT_NEAR
            (
                (r.heating - r.coolingRate*Tp)/scale, heat/scale, 5e-4
            ) << s << ' ' << a;
        }
    }
}


TEST(sphereTransfer, aMixtureIsTheSumOfItsSpecies)
{
    const std::vector<cellCollisions::species> two =
        {{3.3e-27, 2.9e-10, 0.67, 2}, {46.5e-27, 4e-10, 0.74, 0}};
    std::vector<double> u, v, w, e;
    std::vector<std::int32_t> kind;
    counterRandom rnd(3);
    for (int i = 0; i < 37; ++i)
    {
        u.push_back(500 + 900*rnd.normal());
        v.push_back(900*rnd.normal());
        w.push_back(900*rnd.normal());
        e.push_back(1e-20*rnd.uniform());
        kind.push_back(i % 3 == 0);
    }
    const double a = 0.7, R = 3e-6, T = 600, density = 4e18;
    const vector3 p{100, -50, 20};
    vector3 F{0, 0, 0};
    double Q = 0;
    for (int i = 0; i < 37; ++i)
    {
        const double m = two[kind[i]].mass;
        const int z = two[kind[i]].internalDegreesOfFreedom;
        const vector3 ur = vector3{u[i], v[i], w[i]} - p;
        const double c = mag(ur);
        F = F + (M_PI*R*R*density*(m*c + a/3*std::sqrt(2*M_PI*m*k*T)))*ur;
        Q += M_PI*R*R*density*a*c
           *(0.5*m*c*c + (z ? e[i] : 0) - (2 + 0.5*z)*k*T);
    }
    sphereTransfer transfer(two, a, 900);
    transfer.gather
    ({
        37, nullptr, nullptr, nullptr, u.data(), v.data(), w.data(), e.data(),
        kind.data()
    });
    const auto r = transfer.on({p, T, R, 1e-14}, density);
    EXPECT_NEAR(r.force.x, F.x, 1e-12*mag(F));
    EXPECT_NEAR(r.force.y, F.y, 1e-12*mag(F));
    EXPECT_NEAR(r.force.z, F.z, 1e-12*mag(F));
    EXPECT_NEAR((r.heating - r.coolingRate*T)/Q, 1, 1e-11);
}


TEST(sphereTransfer, aLongStepEndsAtTheGas)
{
    const double m = 66e-27, T = 300, density = 1e24/4000;
    sphereTransfer transfer({{m, 4e-10, 0.8, 0}}, 1, 900);
    sample gas(4000, 200, T, m, 0);
    transfer.gather(gas.molecules());
    const auto rates = [&](const sphereTransfer::sphere& at)
    {
        return transfer.on(at, density);
    };
    for (const double Tp : {3., 300., 30000.})
    {
        sphereTransfer::sphere s{{0, 0, 0}, Tp, 1e-6, 1e-14};
        const auto r = rates(s);

        // Short: the derivative
        const double dt = 1e-6*s.mass/r.dragRate;
        sphereTransfer::sphere brief = s;
        transfer.follow(brief, r, density, dt, rates);
        EXPECT_NEAR(brief.velocity.x/(r.force.x*dt/s.mass), 1, 1e-5);
        const double heat = r.heating - r.coolingRate*Tp;
        EXPECT_NEAR((brief.temperature - Tp)/(heat*dt/s.mass/900), 1, 1e-5);

        // Long: at the gas
        transfer.follow(s, r, density, 1e6*s.mass/r.dragRate, rates);
        EXPECT_NEAR(s.velocity.x, 200, 2);
        EXPECT_NEAR(s.temperature, 300, 6);
    }
}


TEST(sphereTransfer, aStepOfAnyLengthIsManyShortOnes)
{
    // With fast spheres that spin, hot and cold: the heat of friction comes
    // and goes within the step
    const double m = 46.5e-27, T = 300, density = 1e22/1000;
    sphereTransfer transfer({{m, 4e-10, 0.74, 2}}, 1, 900);
    sample gas(1000, 0, T, m, 2);
    transfer.gather(gas.molecules());
    const auto rates = [&](const sphereTransfer::sphere& at)
    {
        return transfer.on(at, density);
    };
    for (const double slip : {50., 500., 2000.})
    {
        for (const double Tp : {10., 300., 3000.})
        {
            for (const double length : {0.01, 0.1, 1., 10.})
            {
                sphereTransfer::sphere s
                {
                    {slip, 0, 0}, Tp, 5e-9, 1.4e-21, {0, 0, 1e10}
                };
                sphereTransfer::sphere exact = s;
                const auto r = rates(s);
                const double dt = length*s.mass/r.dragRate;
                double hottest = Tp, coldest = Tp;
                const int n = 1000;
                for (int i = 0; i < n; ++i)
                {
                    transfer.advance
                    (
                        exact, rates(exact),
                        transfer.onSpin(exact, density), dt/n
                    );
                    hottest = std::fmax(hottest, exact.temperature);
                    coldest = std::fmin(coldest, exact.temperature);
                }
                transfer.follow(s, r, density, dt, rates);
                const auto where = ::testing::Message()
                    << slip << " m/s " << Tp << " K " << length;
                EXPECT_NEAR(s.velocity.x, exact.velocity.x, 2e-3*slip)
                    << where;
                EXPECT_NEAR(s.velocity.y, exact.velocity.y, 2e-3*slip)
                    << where;
                EXPECT_NEAR(s.omega.z, exact.omega.z, 2e-3*1e10) << where;
                EXPECT_NEAR
                (
                    s.temperature, exact.temperature,
                    0.02*(hottest - coldest) + 1e-4*Tp
                ) << where;
            }
        }
    }
}


TEST(sphereTransfer, neverGivesMoreHeatThanThereIs)
{
    // The temperature of the gas is lost in the rounding of the sphere's
    const double m = 66e-27;
    sphereTransfer transfer({{m, 4e-10, 0.8, 0}}, 1, 900);
    for (const double T : {1e-3, 1., 300.})
    {
        sample gas(50, 0, T, m, 0);
        transfer.gather(gas.molecules());
        for (const double Tp : {300., 1e9, 1e15, 1e20})
        {
            sphereTransfer::sphere s{{0, 0, 0}, Tp, 1e-6, 1e-14};
            const auto r = transfer.on(s, 1e24/gas.u.size());
            const double relaxation = s.mass*900/r.coolingRate;
            for (const double steps : {1., 30., 37., 40., 700., 1e6})
            {
                sphereTransfer::sphere hot = s;
                transfer.advance(hot, r, steps*relaxation);
                EXPECT_GT(hot.temperature, 0.3*T) << T << ' ' << Tp;
            }
        }
    }
}


TEST(sphereTransfer, refusesBadInput)
{
    const std::vector<cellCollisions::species> gas = {{66e-27, 4e-10, .8, 0}};
    EXPECT_THROW(sphereTransfer(gas, -0.1, 900), std::invalid_argument);
    EXPECT_THROW(sphereTransfer(gas, 1.1, 900), std::invalid_argument);
    EXPECT_THROW(sphereTransfer(gas, 1, 0), std::invalid_argument);
}
