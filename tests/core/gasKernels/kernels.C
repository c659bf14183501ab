/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.

Description
    Kernels of the gas: fluxes against the exact flux where it is known,
    reconstruction against the definitions of the limiters, pressures of gas
    that comes to rest.
\*---------------------------------------------------------------------------*/

#include "fluxes.H"
#include "largest.H"
#include "limiters.H"

#include <gtest/gtest.h>
#include <algorithm>
#include <cmath>
#include <map>
#include <memory>

using Foam::faceBlock;

namespace
{

Foam::gasEquationOfState air()
{
    Foam::gasEquationOfState gas{};
    gas.R = 287.05;
    gas.cv = 2.5*gas.R;
    return gas;
}

//- A block of states of all Mach numbers in all directions; R = L if asked
std::unique_ptr<faceBlock> states(const bool equal)
{
    auto block = std::make_unique<faceBlock>();
    for (int i = 0; i < faceBlock::size; i++)
    {
        const double angle = 0.1*i;
        block->normal[0][i] = std::cos(angle);
        block->normal[1][i] = std::sin(angle);
        block->normal[2][i] = 0;
        const double speed[2] = {40.0*i, 35.0*i + 20};
        for (int side = 0; side < 2; side++)
        {
            auto& q = side ? block->R : block->L;
            const int s = equal ? 0 : side;
            q[0][i] = 1e5*(1 + 0.5*s);
            q[1][i] = 300 + 50*s;
            q[2][i] = speed[s];
            q[3][i] = -0.3*speed[s];
            q[4][i] = 0.2*speed[s];
        }
    }
    return block;
}

//- Largest flux difference relative to the sizes of the flux components
double distance
(
    const double (&a)[faceBlock::maxVar][faceBlock::size],
    const double (&b)[faceBlock::maxVar][faceBlock::size],
    const int nVar,
    const double sign = 1
)
{
    double worst = 0;
    for (int k = 0; k < nVar; k++)
    {
        double scale = 0;
        for (int i = 0; i < faceBlock::size; i++)
        {
            scale = std::max(scale, std::fabs(a[k][i]));
        }
        for (int i = 0; i < faceBlock::size; i++)
        {
            worst = largest(worst, std::fabs(a[k][i] - sign*b[k][i])/scale);
        }
    }
    return worst;
}

} // End anonymous namespace


TEST(fluxes, ofTwoEqualStatesAreTheExactFlux)
{
    for (const std::string& name : Foam::fluxNames())
    {
        for (int nDim : {2, 3})
        {
            auto block = states(true);
            auto exact = states(true);
            Foam::selectFlux(name, nDim, false)(*block, faceBlock::size, air());

            for (int i = 0; i < faceBlock::size; i++)
            {
                double q[5];
                double n[3];
                double flux[5];
                for (int k = 0; k < nDim + 2; k++)
                {
                    q[k] = block->L[k][i];
                }
                for (int d = 0; d < nDim; d++)
                {
                    n[d] = block->normal[d][i];
                }
                Foam::exactFlux(q, n, nDim, air(), flux);
                for (int k = 0; k < nDim + 2; k++)
                {
                    exact->flux[k][i] = flux[k];
                }
            }
            EXPECT_LT(distance(block->flux, exact->flux, nDim + 2), 1e-13)
                << name;
        }
    }
}


TEST(fluxes, ofTheShockCarryTheTotalEnthalpyThatBothSidesHave)
{
    // Pressures apart by any amount, speeds by what the temperatures allow
    auto block = states(false);
    const double cp = 3.5*air().R;
    const double H = 4e6;
    for (int i = 0; i < faceBlock::size; i++)
    {
        for (auto* q : {&block->L, &block->R})
        {
            double uu = 0;
            for (int d = 0; d < 3; d++)
            {
                uu += (*q)[2 + d][i]*(*q)[2 + d][i];
            }
            (*q)[1][i] = (H - 0.5*uu)/cp;
            ASSERT_GT((*q)[1][i], 100);
        }
    }
    double far = 0;
    for (const bool shock : {true, false})
    {
        const Foam::fluxKernel flux =
            shock ? Foam::shockFlux(3, false)
          : Foam::selectFlux("Kurganov", 3, false);
        flux(*block, faceBlock::size, air());
        double apart = 0;
        for (int i = 0; i < faceBlock::size; i++)
        {
            const double mass = block->flux[0][i];
            apart = std::max
            (
                apart, std::fabs(block->flux[1][i] - H*mass)/(H*100)
            );
        }
        if (shock)
        {
            EXPECT_LT(apart, 1e-12);
        }
        else
        {
            far = apart;
        }
    }
    EXPECT_GT(far, 1e-3);

    // And equal states give the exact flux, in two dimensions and three
    for (const int nDim : {2, 3})
    {
        auto equal = states(true);
        auto kurganov = states(true);
        Foam::shockFlux(nDim, false)(*equal, faceBlock::size, air());
        Foam::selectFlux("Kurganov", nDim, false)
            (*kurganov, faceBlock::size, air());
        EXPECT_LT(distance(equal->flux, kurganov->flux, nDim + 2), 1e-14);
    }
}


TEST(fluxes, changeSignWhenTheFaceIsSeenFromTheOtherSide)
{
    for (const std::string& name : Foam::fluxNames())
    {
        auto block = states(false);
        auto turned = states(false);
        std::swap(turned->L, turned->R);
        for (int d = 0; d < 2; d++)
        {
            for (double& n : turned->normal[d])
            {
                n = -n;
            }
        }
        Foam::selectFlux(name, 2, false)(*block, faceBlock::size, air());
        Foam::selectFlux(name, 2, false)(*turned, faceBlock::size, air());
        EXPECT_LT(distance(block->flux, turned->flux, 4, -1), 1e-12) << name;
    }
}


TEST(fluxes, takeTheUpwindStateInSupersonicFlow)
{
    for (const std::string& name : Foam::fluxNames())
    {
        if (name == "Tadmor")
        {
            continue;   // Central: the same dissipation both ways
        }
        auto block = states(false);
        for (int i = 0; i < faceBlock::size; i++)
        {
            block->normal[0][i] = 1;
            block->normal[1][i] = 0;
            block->L[2][i] = 2000;
            block->R[2][i] = 2000;     // SLAU2 needs equal velocities for it
        }
        Foam::selectFlux(name, 2, false)(*block, faceBlock::size, air());
        for (int i = 0; i < faceBlock::size; i++)
        {
            const double mass = block->L[0][i]/(air().R*block->L[1][i])*2000;
            EXPECT_NEAR(block->flux[0][i]/mass, 1, 1e-12) << name;
        }
    }
}


TEST(fluxes, ofSlowGasTakeAShareOfTheDifferenceOfVelocityForSound)
{
    // Two streams that meet head on, with a common velocity along the face:
    // their sound raises the pressure there by rho a times half the difference
    const double speed = 0.5;
    const double rise =
        1e5/(air().R*300)*std::sqrt(1.4*air().R*300)*speed;
    for (const double share : {1.0, 0.1, 0.0})
    {
        for (const double sign : {1.0, -1.0})
        {
            auto block = states(true);
            block->soundShare = share;
            for (int i = 0; i < faceBlock::size; i++)
            {
                const double n[2] = {block->normal[0][i], block->normal[1][i]};
                for (auto* q : {&block->L, &block->R})
                {
                    const double un = sign*(q == &block->L ? speed : -speed);
                    (*q)[2][i] = un*n[0] - 3*n[1];
                    (*q)[3][i] = un*n[1] + 3*n[0];
                }
            }
            Foam::selectFlux("HLLC", 2, false)(*block, faceBlock::size, air());
            for (int i = 0; i < faceBlock::size; i++)
            {
                const double n[2] = {block->normal[0][i], block->normal[1][i]};
                const double (&flux)[faceBlock::maxVar][faceBlock::size] =
                    block->flux;
                const double p = flux[2][i]*n[0] + flux[3][i]*n[1];
                EXPECT_NEAR(p - 1e5, sign*share*rise, 2e-3*rise);
                EXPECT_NEAR(flux[0][i], 0, 1e-9);
                EXPECT_NEAR(flux[1][i], 0, 1e-4);
                EXPECT_NEAR(flux[3][i]*n[0] - flux[2][i]*n[1], 0, 1e-8);
            }
        }
    }
}


TEST(equationOfState, bringsGasToRestWithoutLossAndBehindAShock)
{
    // Tables of NACA report 1135, four digits
    EXPECT_NEAR(air().stagnationRatio(4), 1/0.1278, 0.004);
    EXPECT_NEAR(air().stagnationRatio(36), 1/0.6334e-3, 0.13);
    EXPECT_NEAR(air().pitotRatio(4), 5.640, 0.0005);
    EXPECT_NEAR(air().pitotRatio(36), 46.82, 0.005);

    // The jumps of a normal shock, then rest without loss
    for (const double MM : {1., 1.5, 4., 36., 400.})
    {
        const double jump = 1 + 7./6*(MM - 1);
        const double behind = (MM + 5)/(7*MM - 1);
        EXPECT_NEAR
        (
            air().pitotRatio(MM)/(jump*air().stagnationRatio(behind)), 1,
            1e-14
        );
    }
}


TEST(fluxes, keepAContactAtRestWhereTheyClaimTo)
{
    // Kurganov's flux smears a contact; the others must not
    for (const char* name : {"SLAU2", "AUSMPlusUp", "HLLC"})
    {
        auto block = states(true);
        for (int i = 0; i < faceBlock::size; i++)
        {
            block->R[1][i] = 900;
            for (int k = 2; k < 5; k++)
            {
                block->L[k][i] = 0;
                block->R[k][i] = 0;
            }
        }
        Foam::selectFlux(name, 2, false)(*block, faceBlock::size, air());
        for (int i = 0; i < faceBlock::size; i++)
        {
            EXPECT_NEAR(block->flux[0][i], 0, 1e-11) << name;
            EXPECT_NEAR(block->flux[1][i], 0, 1e-5) << name;
        }
    }
}


TEST(fluxes, ofAThermallyPerfectGasWithConstantHeatAreThoseOfTheOther)
{
    const int n = 100;
    std::vector<double> e(n + 1);
    std::vector<double> c(n + 1, air().cv);
    Foam::gasEquationOfState table = air();
    table.T0 = 100;
    table.dT = 10;
    table.n = n;
    for (int i = 0; i <= n; i++)
    {
        e[i] = air().cv*(table.T0 + i*table.dT);
    }
    table.e = e.data();
    table.c = c.data();

    for (const std::string& name : Foam::fluxNames())
    {
        auto block = states(false);
        auto other = states(false);
        Foam::selectFlux(name, 3, false)(*block, faceBlock::size, air());
        Foam::selectFlux(name, 3, true)(*other, faceBlock::size, table);
        EXPECT_LT(distance(block->flux, other->flux, 5), 1e-12) << name;
    }

    for (double T : {20.0, 100.0, 333.0, 1100.0, 5000.0})
    {
        EXPECT_NEAR(table.temperature<true>(air().cv*T, 300)/T, 1, 1e-12);
    }
    EXPECT_NEAR(table.energy<true>(1e15)/(air().cv*1e15), 1, 1e-12);
}


TEST(limiters, areThoseOfTheirDefinitions)
{
    const std::map<std::string, double (*)(double)> psi
    {
        {"upwind", [](double) { return 0.0; }},
        {"Minmod", [](double r) { return std::min(r, 1.0); }},
        {"vanLeer", [](double r) { return 2*r/(1 + r); }},
        {"vanAlbada", [](double r) { return r*(r + 1)/(r*r + 1); }},
        {"OSPRE", [](double r) { return 1.5*r*(r + 1)/(r*r + r + 1); }},
        {"MUSCL",
            [](double r) { return std::min({2*r, 0.5*(1 + r), 2.0}); }},
        {"UMIST", [](double r)
            { return std::min({2*r, 0.25 + 0.75*r, 0.75 + 0.25*r, 2.0}); }},
        {"SuperBee", [](double r)
            { return std::max(std::min(2*r, 1.0), std::min(r, 2.0)); }},
        {"limitedLinear", [](double r) { return std::min(2*r, 1.0); }},
        {"limitedCubic",
            [](double r) { return std::min({2*r, (2 + r)/3, 2.0}); }}
    };

    for (const std::string& name : Foam::reconstructionNames())
    {
        ASSERT_TRUE(psi.count(name)) << name;
        auto block = std::make_unique<faceBlock>();
        const double jump = -7;
        for (int i = 0; i < faceBlock::size; i++)
        {
            const double r = 0.1*(i - 10);
            for (int k = 0; k < faceBlock::maxVar; k++)
            {
                block->owner[k][i] = 100;
                block->far[k][i] = 100 + jump;
                block->slopeOwner[k][i] = jump*(r + 1);
                block->slopeFar[k][i] = jump*(r + 1);
                block->weight[i] = 0.4;
            }
        }
        Foam::selectReconstruction(name)(*block, faceBlock::size, 0, 5);
        for (int i = 0; i < faceBlock::size; i++)
        {
            const double r = 0.1*(i - 10);
            const double p = r > 1e-9 ? psi.at(name)(r) : 0;
            EXPECT_NEAR(block->L[3][i], 100 + 0.4*p*jump, 1e-11) << name;
            EXPECT_NEAR(block->R[3][i], 100 + jump - 0.6*p*jump, 1e-11)
                << name;
        }
    }
}


TEST(limiters, followTheLogarithmOfPressureWhereTheGasExpands)
{
    // Pressures in a geometric series: a straight line in the logarithm, whose
    // face value is the geometric mean but for the third power of the change
    const double c = 0.9;
    for (const std::string& name : Foam::reconstructionNames())
    {
        auto block = std::make_unique<faceBlock>();
        for (int i = 0; i < faceBlock::size; i++)
        {
            for (int k = 0; k < faceBlock::maxVar; k++)
            {
                block->owner[k][i] = 100;
                block->far[k][i] = 100*c;
                block->slopeOwner[k][i] = 100*(c - 1/c);
                block->slopeFar[k][i] = 100*(c*c - 1);
            }
            block->weight[i] = 0.5;
            block->expands[i] = i % 2;
        }
        Foam::selectReconstruction(name)(*block, faceBlock::size, 0, 5);
        const double mean = 100*std::sqrt(c);
        if (name != "upwind")
        {
            EXPECT_NEAR(block->L[0][7], mean, 5e-3) << name;
            EXPECT_NEAR(block->R[0][7], mean, 5e-3) << name;

            // Differences themselves miss it on one side at least
            EXPECT_GT
            (
                std::max
                (
                    std::abs(block->L[0][8] - mean),
                    std::abs(block->R[0][8] - mean)
                ),
                0.05
            ) << name;
        }
        for (int k = 1; k < faceBlock::maxVar; k++)
        {
            EXPECT_EQ(block->L[k][7], block->L[k][8]) << name;
        }
    }
}


TEST(limiters, keepPressureAndTemperaturePositive)
{
    for (const std::string& name : Foam::reconstructionNames())
    {
        for (const bool smooth : {false, true})
        {
            auto block = std::make_unique<faceBlock>();
            block->smooth = smooth;
            for (int i = 0; i < faceBlock::size; i++)
            {
                const double low = std::pow(10.0, -(i % 8));
                for (int k = 0; k < faceBlock::maxVar; k++)
                {
                    block->owner[k][i] = i % 3 ? 1 : low;
                    block->far[k][i] = i % 3 ? low : 1;
                    block->slopeOwner[k][i] = i - 0.5*faceBlock::size;
                    block->slopeFar[k][i] = 0.5*faceBlock::size - i;
                    block->passed[k][i] = 1e-6;
                }
                block->weight[i] = i % 2 ? 0.05 : 0.95;
                block->expands[i] = i/2 % 2;
            }
            Foam::selectReconstruction(name)(*block, faceBlock::size, 0, 5);
            for (int i = 0; i < faceBlock::size; i++)
            {
                for (int k = 0; k < 2; k++)
                {
                    EXPECT_GT(block->L[k][i], 0) << name << i;
                    EXPECT_GT(block->R[k][i], 0) << name << i;
                    EXPECT_LT(block->L[k][i], 100) << name << i;
                    EXPECT_LT(block->R[k][i], 100) << name << i;
                }
            }
        }
    }
}


TEST(limiters, stayFiniteWithoutAnyChange)
{
    for (const std::string& name : Foam::reconstructionNames())
    {
        auto block = std::make_unique<faceBlock>();
        for (int i = 0; i < faceBlock::size; i++)
        {
            for (int k = 0; k < faceBlock::maxVar; k++)
            {
                block->owner[k][i] = 5;
                block->far[k][i] = 5;
                block->slopeOwner[k][i] = i % 2 ? 1e-300 : 0;
                block->slopeFar[k][i] = 0;
            }
            block->weight[i] = 0.5;
        }
        Foam::selectReconstruction(name)(*block, faceBlock::size, 0, 5);
        EXPECT_EQ(block->L[0][7], 5) << name;
        EXPECT_EQ(block->R[4][8], 5) << name;
    }
}
