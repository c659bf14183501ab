/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.

Description
    Force and equilibrium of a sphere in cells of few molecules: the means over
    many cells against those with a thousand molecules.
\*---------------------------------------------------------------------------*/

#include "knudsenCorrection.H"
#include "maxwellian.H"

#include <gtest/gtest.h>
#include <cmath>

using namespace impact;

namespace
{

const double k = maxwellian::boltzmann;
const double T = 300;
const std::vector<cellCollisions::species> nitrogen =
    {{4.65e-26, 4.17e-10, 0.74, 2}};

//- Mean force, heat at T, and cooling of a sphere of 100 um that moves through
//  cells whose number of molecules is that of a Poisson law
struct means
{
    double force = 0, heat = 0, cooling = 0;

    means(double slip, double scale, double molecules, int nCells)
    {
        const double numberDensity = 1e22;
        knudsenCorrection correction
            (nitrogen, 273, "singhDrag", "kavanau", scale);
        sphereTransfer transfer(nitrogen, 1, 900);
        const double c = std::sqrt(k*T/nitrogen[0].mass);
        const double density = numberDensity/molecules;
        std::vector<double> u, v, w, e;
        std::vector<std::int32_t> kind;
        for (int cell = 0; cell < nCells; ++cell)
        {
            counterRandom rnd(31, cell, int(molecules));
            u.clear();
            v.clear();
            w.clear();
            e.clear();
            double time = -std::log(rnd.uniform());
            for (; time < molecules; time -= std::log(rnd.uniform()))
            {
                u.push_back(slip + c*rnd.normal());
                v.push_back(c*rnd.normal());
                w.push_back(c*rnd.normal());
                e.push_back(k*T*maxwellian::internalEnergy(2, rnd));
            }
            if (u.empty())
            {
                continue;
            }
            kind.assign(u.size(), 0);
            const cellCollisions::molecules gas =
            {
                int(u.size()), nullptr, nullptr, nullptr, u.data(), v.data(),
                w.data(), e.data(), kind.data()
            };
            transfer.gather(gas);
            correction.gather(gas, density);
            const sphereTransfer::sphere s{{0, 0, 0}, T, 5e-5, 1e-9};
            const auto r = transfer.on(s, density);
            const auto f = correction.of(s);
            force += f.force*r.force.x/nCells;
            heat += (f.heating*r.heating - f.cooling*r.coolingRate*T)/nCells;
            cooling += f.cooling*r.coolingRate/nCells;
        }
    }
};

} // End anonymous namespace


TEST(knudsenCorrection, fewMoleculesBiasLittle)
{
    // The biases of doc/models/solidParticles.md, at Knudsen numbers of 0.01
    // and 0.001; means known to 2 % (n = 30: 1 %)
    const struct
    {
        double scale, molecules, force, cooling;
    } cases[] =
    {
        {100, 30, 1, 0.97}, {100, 10, 1.17, 0.99}, {100, 5, 1.42, 0.99},
        {1000, 30, 1.04, 0.97}, {1000, 10, 1.48, 1.06}, {1000, 5, 2.36, 1.1}
    };
    for (const auto& c : cases)
    {
        const means exact(50, c.scale, 1000, 1000);
        const means few(50, c.scale, c.molecules, 60000);
        EXPECT_NEAR(few.force/exact.force/c.force, 1, 0.06)
            << c.scale << ' ' << c.molecules;
        EXPECT_NEAR(few.cooling/exact.cooling/c.cooling, 1, 0.04)
            << c.scale << ' ' << c.molecules;
    }
}


TEST(knudsenCorrection, fewMoleculesLeaveFreeMolecularFlowAsItIs)
{
    for (const double molecules : {30., 10., 5.})
    {
        EXPECT_NEAR
        (
            means(500, 1e-4, molecules, 30000).force
           /means(500, 1e-4, 1000, 300).force, 1, 0.015
        ) << molecules;

        // At rest at the temperature of the gas
        const means rest(0, 1e-4, molecules, 60000);
        EXPECT_NEAR(rest.heat/rest.cooling, 0, 1.2) << molecules;
    }
}


TEST(knudsenCorrection, oneMoleculeIsAGasOfTheSpheresTemperature)
{
    // Dense gas, of which one molecule must not take the sphere along as if it
    // were free-molecular
    double u = 300, zero = 0;
    const std::int32_t kind = 0;
    knudsenCorrection c(nitrogen, 273, "singhDrag", "kavanau");
    c.gather
    (
        {1, nullptr, nullptr, nullptr, &u, &zero, &zero, &zero, &kind}, 1e25
    );
    const auto f = c.of({{0, 0, 0}, T, 5e-5, 1e-9});
    EXPECT_GT(f.force, 0);
    EXPECT_LT(f.force, 0.05);
    EXPECT_LT(f.heating, 0.05);
    EXPECT_LT(f.cooling, 0.05);
}
