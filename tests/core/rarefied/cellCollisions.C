/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.

Description
    Collisions in one cell against kinetic theory: rates of a gas and of a
    mixture (Bird 1994, eq. (4.64) and (4.78)), conservation, equipartition and
    the rate of rotational relaxation, and the sub-cells.
\*---------------------------------------------------------------------------*/

#include "cellCollisions.H"
#include "maxwellian.H"

#include <gtest/gtest.h>
#include <cmath>
#include <string>

using namespace impact;

namespace
{
    const double k = maxwellian::boltzmann;
    const cellCollisions::species argon{66.3e-27, 4.17e-10, 0.81, 0};
    const cellCollisions::species helium{6.65e-27, 2.33e-10, 0.66, 0};
    const cellCollisions::species nitrogen{46.5e-27, 4.17e-10, 0.74, 2};
    const cellCollisions::species methane{26.63e-27, 4.83e-10, 0.84, 3};

    //- A cell of 1 mm with molecules in equilibrium
    struct cell
    {
        std::vector<cellCollisions::species> species;
        std::vector<double> x, y, z, u, v, w, Ei;
        std::vector<std::int32_t> typeId;
        cellCollisions::box box{{0, 0, 0}, {1000, 1000, 1000}};
        double volume = 1e-9;

        cell
        (
            const std::vector<cellCollisions::species>& gas,
            const std::vector<int>& numbers,
            double T,
            double internalT
        )
        :
            species(gas)
        {
            counterRandom rnd(99);
            for (std::size_t s = 0; s < gas.size(); ++s)
            {
                const double c = std::sqrt(k*T/gas[s].mass);
                for (int i = 0; i < numbers[s]; ++i)
                {
                    x.push_back(1e-3*rnd.uniform());
                    y.push_back(1e-3*rnd.uniform());
                    z.push_back(1e-3*rnd.uniform());
                    u.push_back(c*rnd.normal());
                    v.push_back(c*rnd.normal());
                    w.push_back(c*rnd.normal());
                    Ei.push_back
                    (
                        k*internalT*maxwellian::internalEnergy
                        (
                            gas[s].internalDegreesOfFreedom, rnd
                        )
                    );
                    typeId.push_back(s);
                }
            }
        }

        int size() const
        {
            return int(x.size());
        }

        cellCollisions::molecules molecules()
        {
            return
            {
                size(), x.data(), y.data(), z.data(), u.data(), v.data(),
                w.data(), Ei.data(), typeId.data()
            };
        }

        double kinetic() const
        {
            double sum = 0;
            for (int i = 0; i < size(); ++i)
            {
                sum += 0.5*species[typeId[i]].mass
                    *(u[i]*u[i] + v[i]*v[i] + w[i]*w[i]);
            }
            return sum;
        }

        double internal() const
        {
            double sum = 0;
            for (const double e : Ei)
            {
                sum += e;
            }
            return sum;
        }

        double momentum(const std::vector<double>& a) const
        {
            double sum = 0;
            for (int i = 0; i < size(); ++i)
            {
                sum += species[typeId[i]].mass*a[i];
            }
            return sum;
        }
    };

    std::string refusal
    (
        const cellCollisions::species& s, double Tref, double Z
    )
    {
        try
        {
            cellCollisions({s}, Tref, Z, 1);
        }
        catch (const std::invalid_argument& e)
        {
            return e.what();
        }
        return "";
    }
}


TEST(cellCollisions, meanCrossSectionIsThatOfKineticTheory)
{
    // Bird (4.64): 4 d^2 n sqrt(pi k Tref/m) (T/Tref)^(1 - omega)
    const cellCollisions c({argon, helium}, 273, 0, 1);
    for (const double T : {50., 273., 4000.})
    {
        const double exact = 4*argon.diameter*argon.diameter
            *std::sqrt(M_PI*k*273/argon.mass)
            *std::pow(T/273, 1 - argon.omega);
        EXPECT_NEAR(c.equilibriumSigmaC(0, 0, T)/exact, 1, 1e-12);

        // Bird (4.78): 2 sqrt(pi) d^2 (T/Tref)^(1 - omega) sqrt(2kTref/m_r)
        const double d = 0.5*(argon.diameter + helium.diameter);
        const double omega = 0.5*(argon.omega + helium.omega);
        const double m =
            argon.mass*helium.mass/(argon.mass + helium.mass);
        const double mixed = 2*std::sqrt(M_PI)*d*d
            *std::pow(T/273, 1 - omega)*std::sqrt(2*k*273/m);
        EXPECT_NEAR(c.equilibriumSigmaC(0, 1, T)/mixed, 1, 1e-12);
        EXPECT_NEAR(c.equilibriumSigmaC(1, 0, T)/mixed, 1, 1e-12);
    }
}


TEST(cellCollisions, startsAboveNextToAllPairs)
{
    cell gas({argon, helium}, {500, 500}, 400, 0);
    const cellCollisions c(gas.species, 273, 0, 1);
    const double start = c.startingSigmaCMax(400);
    int above = 0, below = 0;
    for (int i = 0; i < gas.size(); ++i)
    {
        for (int j = 0; j < i; ++j)
        {
            const double c2 = std::pow(gas.u[i] - gas.u[j], 2)
                + std::pow(gas.v[i] - gas.v[j], 2)
                + std::pow(gas.w[i] - gas.w[j], 2);
            const double sc = c.sigmaC(gas.typeId[i], gas.typeId[j], c2);
            above += sc > start;
            below += sc < 0.4*start;
        }
    }

    // Nor so far above that most candidates are in vain
    EXPECT_LT(above, 1e-3*gas.size()*gas.size()/2);
    EXPECT_LT(below, 0.5*gas.size()*gas.size()/2);
}


TEST(cellCollisions, rateOfAMixtureIsThatOfKineticTheory)
{
    cell gas({argon, helium}, {600, 400}, 500, 0);
    cellCollisions c(gas.species, 273, 0, 3);

    // Temperature from the energy relative to the mean motion
    double energy = gas.kinetic();
    double mass = 0;
    for (const int s : gas.typeId)
    {
        mass += gas.species[s].mass;
    }
    for (const auto* a : {&gas.u, &gas.v, &gas.w})
    {
        energy -= 0.5*std::pow(gas.momentum(*a), 2)/mass;
    }
    const double T = 2*energy/(3*k*(gas.size() - 1));

    const double weight = 5e9, dt = 5e-8;
    const double rate = weight*dt/gas.volume;
    double perStep = 0;
    const int numbers[2] = {600, 400};
    for (int p = 0; p < 2; ++p)
    {
        for (int q = 0; q < 2; ++q)
        {
            perStep += 0.5*numbers[p]*(numbers[q] - (p == q))*rate
                *c.equilibriumSigmaC(p, q, T);
        }
    }

    // The whole cell is one place: partners must not be special neighbours
    gas.box = {{0, 0, 0}, {0, 0, 0}};
    double sigmaCMax = 5e-16;
    cellCollisions::counts counts;
    const int warmUp = 500, nSteps = 8000;
    for (int step = 0; step < warmUp + nSteps; ++step)
    {
        if (step == warmUp)
        {
            counts = cellCollisions::counts();
        }
        c.collide(gas.molecules(), gas.box, rate, sigmaCMax, 7, step, counts);
    }
    ASSERT_GT(counts.collisions, 300000);
    const double error = 1/std::sqrt(double(counts.collisions));
    EXPECT_NEAR(counts.collisions/(nSteps*perStep), 1, 4*error);
    EXPECT_LT(4*error, 0.01);
}


TEST(cellCollisions, keepMomentumAndEnergy)
{
    cell gas({argon, nitrogen, methane}, {60, 60, 60}, 300, 3000);
    cellCollisions c(gas.species, 273, 2, 5);
    const double energy = gas.kinetic() + gas.internal();
    const double px = gas.momentum(gas.u);
    const double py = gas.momentum(gas.v);
    const double pz = gas.momentum(gas.w);

    double sigmaCMax = 1e-15;
    cellCollisions::counts counts;
    for (int step = 0; step < 2000; ++step)
    {
        c.collide(gas.molecules(), gas.box, 2e12, sigmaCMax, 0, step, counts);
    }
    ASSERT_GT(counts.collisions, 20000);
    EXPECT_NEAR((gas.kinetic() + gas.internal())/energy, 1, 1e-12);

    // Against the momentum of all going one way
    const double scale = std::sqrt(energy*argon.mass*gas.size());
    EXPECT_NEAR((gas.momentum(gas.u) - px)/scale, 0, 1e-12);
    EXPECT_NEAR((gas.momentum(gas.v) - py)/scale, 0, 1e-12);
    EXPECT_NEAR((gas.momentum(gas.w) - pz)/scale, 0, 1e-12);
}


TEST(cellCollisions, equilibriumSharesEnergyEqually)
{
    // Two rotors of different kind, all energy in the translation at first
    cell gas({nitrogen, methane}, {1000, 1000}, 900, 0);
    cellCollisions c(gas.species, 273, 1.5, 11);
    double sigmaCMax = 2e-15;
    cellCollisions::counts counts;
    double sum[3] = {0, 0, 0}, squares = 0;
    const int nSteps = 600, warmUp = 100;
    for (int step = 0; step < nSteps; ++step)
    {
        c.collide(gas.molecules(), gas.box, 4e11, sigmaCMax, 0, step, counts);
        if (step < warmUp)
        {
            continue;
        }
        sum[0] += gas.kinetic()/(1.5*gas.size());
        for (int i = 0; i < gas.size(); ++i)
        {
            const int s = gas.typeId[i];
            sum[1 + s] += gas.Ei[i]/(s == 0 ? 1 : 1.5)/1000;
            squares += s == 0 ? gas.Ei[i]*gas.Ei[i]/1000 : 0;
        }
    }
    ASSERT_GT(counts.collisions, 100*gas.size());

    // One molecule more or less in 2000: 0.5 % is 4 deviations
    const double T = sum[0];
    EXPECT_NEAR(sum[1]/T, 1, 0.01);
    EXPECT_NEAR(sum[2]/T, 1, 0.01);

    // Exponential law of two degrees of freedom
    const double mean = sum[1]/(nSteps - warmUp);
    EXPECT_NEAR(squares/(nSteps - warmUp)/(mean*mean), 2, 0.06);
}


TEST(cellCollisions, rotationRelaxesAtTheRateOfTheExchange)
{
    // A molecule that exchanges goes, on average over VHS collisions, from
    // rotational temperature Tr to (b T + Tr)/(1 + b), b = 5/2 - omega; the
    // second of a pair meets what the first has left
    const double Z = 5;
    cell gas({nitrogen}, {40000}, 1000, 0);
    gas.box = {{0, 0, 0}, {0, 0, 0}};
    cellCollisions c(gas.species, 273, Z, 23);
    const double b = 2.5 - nitrogen.omega;
    const double perCollision =
        b/(1 + b)/Z*(1 - 0.5/Z/(1 + b))*(1 + 2.0/3);

    double sigmaCMax = 2e-15;
    cellCollisions::counts counts;
    const auto difference = [&]()
    {
        return
            2*gas.kinetic()/(3*k*gas.size()) - gas.internal()/(k*gas.size());
    };
    const double start = difference();
    for (int step = 0; step < 300; ++step)
    {
        c.collide(gas.molecules(), gas.box, 1e9, sigmaCMax, 0, step, counts);
    }
    const double perMolecule = 2.0*counts.collisions/gas.size();
    ASSERT_GT(perMolecule, 2);
    EXPECT_NEAR
    (
        -std::log(difference()/start)/(perCollision*perMolecule), 1, 0.02
    );
}


TEST(cellCollisions, stressDecaysByHalfOfAPairAtEachCollision)
{
    // Two molecules whose relative motion takes any direction keep the half of
    // their unequal stresses that is in the motion of both. With omega = 1 all
    // pairs are as likely, so that the number of collisions says how far the
    // stress of the gas decays. A pair that met twice would lose nothing more.
    cell gas({{66.3e-27, 4.17e-10, 1, 0}}, {400000}, 300, 0);
    for (double& u : gas.u)
    {
        u *= 2.5;
    }
    const auto stress = [&gas]()
    {
        double sum = 0;
        for (int i = 0; i < gas.size(); ++i)
        {
            sum += gas.u[i]*gas.u[i]
              - 0.5*(gas.v[i]*gas.v[i] + gas.w[i]*gas.w[i]);
        }
        return sum;
    };
    cellCollisions c(gas.species, 273, 0, 17);
    cellCollisions::counts counts;
    counterRandom rnd(31);
    const double start = stress();
    double sigmaCMax = 1e-16;
    for (int step = 0; counts.collisions < gas.size(); ++step)
    {
        // Flight takes molecules out of their sub-cells
        for (auto* x : {&gas.x, &gas.y, &gas.z})
        {
            for (double& xi : *x)
            {
                xi = 1e-3*rnd.uniform();
            }
        }
        const double rate = 0.5/(gas.size()*c.sigmaC(0, 0, 1));
        c.collide(gas.molecules(), gas.box, rate, sigmaCMax, 0, step, counts);
        ASSERT_LT(step, 10);
    }
    const double meetings = double(counts.collisions)/(gas.size() - 1);
    EXPECT_NEAR(-std::log(stress()/start)/meetings, 1, 0.016);
}


TEST(cellCollisions, partnersComeFromTheSameSubCell)
{
    // Two clouds in opposite corners, one heading for the other: collisions
    // between them would move momentum
    cell gas({argon}, {400}, 300, 0);
    double before = 0;
    for (int i = 0; i < gas.size(); ++i)
    {
        const bool first = i < 200;
        const double at = first ? 0.1e-3 : 0.9e-3;
        gas.x[i] = at + 0.1*(gas.x[i] - 0.5e-3);
        gas.y[i] = at + 0.1*(gas.y[i] - 0.5e-3);
        gas.z[i] = at + 0.1*(gas.z[i] - 0.5e-3);
        gas.u[i] += first ? 1000 : -1000;
        before += first ? gas.u[i] : 0;
    }
    cellCollisions c(gas.species, 273, 0, 1);
    cellCollisions::counts counts;
    double sigmaCMax = 1e-15;
    c.collide(gas.molecules(), gas.box, 1e13, sigmaCMax, 0, 0, counts);
    ASSERT_GT(counts.collisions, 200);
    double after = 0;
    for (int i = 0; i < 200; ++i)
    {
        after += gas.u[i];
    }
    EXPECT_NEAR(after/before, 1, 1e-12);

    // Without sub-cells they do
    gas.box = {{0, 0, 0}, {0, 0, 0}};
    c.collide(gas.molecules(), gas.box, 1e13, sigmaCMax, 0, 1, counts);
    after = 0;
    for (int i = 0; i < 200; ++i)
    {
        after += gas.u[i];
    }
    EXPECT_LT(after/before, 0.9);
}


TEST(cellCollisions, sameKeySameResult)
{
    cell one({nitrogen}, {50}, 300, 300);
    cell two({nitrogen}, {50}, 300, 300);
    cell three({nitrogen}, {50}, 300, 300);
    cellCollisions c(one.species, 273, 5, 1);
    cellCollisions::counts counts;
    double s1 = 1e-15, s2 = 1e-15, s3 = 1e-15;
    c.collide(one.molecules(), one.box, 1e13, s1, 4, 9, counts);
    c.collide(two.molecules(), two.box, 1e13, s2, 4, 9, counts);
    c.collide(three.molecules(), three.box, 1e13, s3, 5, 9, counts);
    EXPECT_EQ(one.u, two.u);
    EXPECT_EQ(one.Ei, two.Ei);
    EXPECT_NE(one.u, three.u);
}


TEST(cellCollisions, fewMoleculesAreNoTrouble)
{
    cellCollisions c({argon}, 273, 0, 1);
    cellCollisions::counts counts;
    double sigmaCMax = 1e-15;
    for (const int n : {0, 1, 2})
    {
        cell gas({argon}, {n}, 300, 0);
        c.collide(gas.molecules(), gas.box, 1e16, sigmaCMax, 0, 0, counts);
        EXPECT_EQ(counts.candidates > 0, n == 2);
    }

    // Two that stand still against each other cannot collide
    cell gas({argon}, {2}, 300, 0);
    for (auto* a : {&gas.u, &gas.v, &gas.w})
    {
        (*a)[1] = (*a)[0];
    }
    counts = cellCollisions::counts();
    c.collide(gas.molecules(), gas.box, 1e16, sigmaCMax, 0, 0, counts);
    EXPECT_GT(counts.candidates, 0);
    EXPECT_EQ(counts.collisions, 0);
}


TEST(cellCollisions, refusesWhatIsNoGas)
{
    EXPECT_EQ
    (
        refusal(argon, 0, 0), "Tref 0: valid range (0, inf) K"
    );
    EXPECT_EQ
    (
        refusal(argon, 273, 0.5),
        "relaxationCollisionNumber 0.5: valid range [1, inf)"
    );
    cellCollisions::species s = argon;
    s.mass = -1;
    EXPECT_EQ(refusal(s, 273, 0), "mass -1: valid range (0, inf) kg");
    s = argon;
    s.diameter = 0;
    EXPECT_EQ(refusal(s, 273, 0), "diameter 0: valid range (0, inf) m");
    s = argon;
    s.omega = 2;
    EXPECT_EQ
    (
        refusal(s, 273, 0),
        "omega 2: valid range [0.5, 1.5], 0.5 for hard spheres"
    );
    s = argon;
    s.internalDegreesOfFreedom = -2;
    EXPECT_EQ
    (
        refusal(s, 273, 0),
        "internalDegreesOfFreedom -2: valid range [0, inf)"
    );
}
