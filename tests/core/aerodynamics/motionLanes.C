/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.

Description
    Sub-steps of many spheres together against those of one: the same states,
    errors and evaluations, and the same steps refused.
\*---------------------------------------------------------------------------*/

#include "heatLaw.H"
#include "hendersonDrag.H"
#include "motionLanes.H"

#include <gtest/gtest.h>
#include <cmath>
#include <memory>
#include <random>

using namespace impact;

namespace
{

constexpr double gammaR = 401.87;

//- Gas with random gradients: in a cell of 1 mm everything may change by its
//  own size
linearGas randomGas(std::mt19937& random)
{
    std::uniform_real_distribution<double> uniform(-1, 1);
    linearGas f;
    f.centre = vector3{0.1, -0.2, 0.3};
    f.value.u = vector3{1000, 200*uniform(random), 100};
    f.value.spin = vector3{1e4*uniform(random), 0, 1e5*uniform(random)};
    f.value.rho = 0.4;
    f.value.mu = 2e-5;
    f.value.T = 300;
    const double sharp = std::pow(10., 2*uniform(random) - 2);
    const double* value = &f.value.u.x;
    for (auto& slope : f.slope)
    {
        for (int k = 0; k < linearGas::nValues; ++k)
        {
            slope[k] = 1e3*sharp*uniform(random)*(value[k] + 1);
        }
    }
    f.minima[0] = 0.2;
    f.minima[1] = 1e-5;
    f.minima[2] = 150;
    f.length = 1e-3;
    return f;
}


//- The same force for one sphere
struct oneForce
{
    sphereForces forces;
    sphereHeat heat;
    const linearGas& gas;
    vector3 x, solved, rotation;
    secondaryForces secondary;
    vector3 eddy;

    gasState at(const vector3& s) const
    {
        gasState there = gas(x + s);
        there.u = there.u + eddy;
        return there;
    }

    //- With the secondary forces, in the directions that are solved
    void complete
    (
        const gasState& there,
        const motionState& s,
        motionRate& r
    ) const
    {
        if (secondary.any())
        {
            secondary.add
            (
                gas, there, x + s.x, s.v, forces.d(), forces.inverseRhoP(), r
            );
        }
        constrain(r);
    }

    void constrain(motionRate& r) const
    {
        r.a = multiply(solved, r.a);
        r.turn = multiply(rotation, r.turn);
    }

    motionRate operator()(const motionState& s) const
    {
        const gasState there = at(s.x);
        motionRate r = forces(there, s.v, s.omega);
        complete(there, s, r);
        return r;
    }

    thermalRate operator()(const thermalState& s) const
    {
        const gasState there = at(s.x);
        const double T = heat.material().T(s.h);
        thermalRate r;
        static_cast<motionRate&>(r) = forces(there, s.v, s.omega, T);
        complete(there, s, r);
        heat(there, s.v, T, s.h, r);
        return r;
    }
};


void expectNear(const vector3& a, const vector3& b, double scale)
{
    EXPECT_LE(mag(a - b), 1e-13*scale);
}


//- Compare n spheres a thousand times over
//  \param nWith  becomes the number of steps with 2, 4, 6 evaluations, and of
//      those refused
template<class State>
void compare
(
    const sphereForces& forces,
    const sphereHeat& heat,
    double tolerance,
    const vector3& solved,
    const vector3& rotation,
    int n,
    int (&nWith)[4],
    const secondaryForces& secondary = secondaryForces(),
    double eddies = 0
)
{
    std::mt19937 random(7 + n);
    std::uniform_real_distribution<double> uniform(-1, 1);
    const particleMotion motion(tolerance);
    const auto block = std::make_unique<motionLanes>
    (
        forces, particleMotion::thermal<State> ? &heat : nullptr, tolerance,
        solved, rotation, eddies > 0, secondary
    );
    linearGas fields[motionLanes::size];
    double d[motionLanes::size];
    for (int repeat = 0; repeat < 200; ++repeat)
    {
        for (int i = 0; i < n; ++i)
        {
            fields[i] = randomGas(random);
            d[i] = std::pow(10., -6 + uniform(random));
            block->now.gas[i] = &fields[i];
            block->sphere(i, d[i], 2500);
            motionLanes::set
            (
                block->now.x, i,
                fields[i].centre + 5e-4*vector3{uniform(random), 0, 1}
            );
            motionLanes::set
            (
                block->now.v, i,
                vector3{1800 + 800*uniform(random), 100*uniform(random), 0}
            );
            motionLanes::set
            (
                block->now.omega, i, vector3{0, 0, 1e6*uniform(random)}
            );
            if (particleMotion::thermal<State>)
            {
                block->now.h[i] =
                    heat.material().h(600 + 300*uniform(random));
            }
            motionLanes::set
            (
                block->now.eddy, i,
                eddies*vector3{uniform(random), uniform(random), 1}
            );
            block->hTry[i] = i % 3 ? 1 : 3e-8;
        }
        block->begin(n);
        for (int i = 0; i < n; ++i)
        {
            block->hMax[i] = std::pow(10., -7.5 + 1.5*uniform(random));
        }
        block->end(n);

        for (int i = 0; i < n; ++i)
        {
            oneForce force
            {
                forces, heat, fields[i], motionLanes::of(block->now.x, i),
                solved, rotation, secondary,
                motionLanes::of(block->now.eddy, i)
            };
            force.forces.sphere(d[i], 2500);
            force.heat.sphere(d[i], 2500);
            State s;
            s.x = vector3{0, 0, 0};
            s.v = motionLanes::of(block->now.v, i);
            s.omega = motionLanes::of(block->now.omega, i);
            if constexpr (particleMotion::thermal<State>)
            {
                s.h = block->now.h[i];
            }
            const gasState here = force.at({0, 0, 0});
            const double h = std::min(block->hMax[i], block->hTry[i]);
            const auto o = motion.step
            (
                force, s, mag(here.u), mag(here.spin), block->hMax[i],
                block->hTry[i], 1000
            );

            // Its first attempt was explicit and good enough
            const bool accepted =
                o.h == h
             && (o.nForce == 2 || o.nForce == 4 || o.nForce == 6);
            ASSERT_EQ(block->accepted[i] > 0, accepted) << o.nForce;
            if (!accepted)
            {
                ++nWith[3];
                continue;
            }
            ++nWith[o.nForce/2 - 1];
            const auto b = block->template outcome<State>(i);
            EXPECT_EQ(b.nForce, o.nForce);
            EXPECT_EQ(b.h, o.h);
            expectNear(b.state.x, o.state.x, o.h*o.vScale);
            expectNear(b.state.v, o.state.v, o.vScale);
            expectNear(b.state.omega, o.state.omega, o.spinScale);
            EXPECT_NEAR(b.vScale, o.vScale, 1e-13*o.vScale);
            EXPECT_NEAR(b.spinScale, o.spinScale, 1e-13*o.spinScale);
            EXPECT_NEAR(b.k, o.k, 1e-13*o.k);
            EXPECT_NEAR(b.kSpin, o.kSpin, 1e-13*o.kSpin);
            expectNear(b.a, o.a, mag(o.a));
            expectNear(b.alpha, o.alpha, mag(o.alpha));

            if constexpr (particleMotion::thermal<State>)
            {
                EXPECT_NEAR(b.state.h, o.state.h, 1e-13*o.hScale);
                EXPECT_NEAR(b.hScale, o.hScale, 1e-13*o.hScale);
                EXPECT_NEAR(b.kHeat, o.kHeat, 1e-12*o.kHeat);
                EXPECT_NEAR(b.hDot, o.hDot, 1e-12*o.kHeat*o.hScale);
            }

            // The error is a difference of nearly equal numbers
            EXPECT_NEAR(b.hNext, o.hNext, 1e-6*o.hNext);
        }
    }
}

//- Heat of spheres of alumina that may melt and that radiate
struct someHeat
{
    std::unique_ptr<heatLaw> law;
    specificHeat material;

    someHeat()
    :
        law(heatLaw::New("kavanau", heatLaw::coefficients())),
        material({800, 0.3}, {700, 710, 1e5})
    {}

    sphereHeat operator()() const
    {
        return sphereHeat({law.get(), &material, 1400, gammaR, 0.8, 300});
    }
};

} // End anonymous namespace


TEST(motionLanes, takesTheStepsOfOneSphere)
{
    const someHeat heat;
    sphereForces::counts counts;
    const hendersonDrag drag(1.4, 1);
    const vector3 all{1, 1, 1};
    for (const double tolerance : {1e-3, 1e-5, 1e-7})
    {
        for (const bool spin : {true, false})
        {
            const sphereForces forces
            (
                &drag, gammaR, spin, spin, vector3{0, 9.81, 0}, counts
            );
            int nWith[4] = {0, 0, 0, 0};
            for (const int n : {1, 7, motionLanes::size})
            {
                compare<motionState>
                (
                    forces, heat(), tolerance, all, all, n, nWith
                );
            }

            // Each kind was among them
            for (const int count : nWith)
            {
                EXPECT_GE(count, 100) << tolerance;
            }
        }
    }
}


TEST(motionLanes, heatsAsOneSphere)
{
    const someHeat heat;
    const hendersonDrag drag(1.4, 1);
    const vector3 all{1, 1, 1};
    sphereForces::counts counts;
    const sphereForces forces
    (
        &drag, gammaR, true, true, vector3{0, 9.81, 0}, counts
    );
    for (const double tolerance : {1e-3, 1e-5, 1e-7})
    {
        int nWith[4] = {0, 0, 0, 0};
        compare<thermalState>
        (
            forces, heat(), tolerance, all, all, motionLanes::size, nWith
        );
        for (const int count : nWith)
        {
            EXPECT_GE(count, 100) << tolerance;
        }
    }
}


TEST(motionLanes, takesSecondaryForcesAndEddies)
{
    // In a plane, too, where the gas has a velocity across it
    const someHeat heat;
    const hendersonDrag drag(1.4, 1);
    sphereForces::counts counts;
    const sphereForces forces
    (
        &drag, gammaR, true, true, vector3{0, 9.81, 0}, counts
    );
    secondaryForces secondary;
    secondary.pressureGradient = secondary.shearLift = true;
    secondary.virtualMass = 50;
    secondary.acceleration = {1e4, 2e4, 0};
    secondary.Omega = {0, 0, 3e4};
    for (const vector3& solved : {vector3{1, 1, 1}, vector3{1, 1, 0}})
    {
        const vector3 rotation{solved.z, solved.z, 1};
        int nWith[4] = {0, 0, 0, 0};
        compare<motionState>
        (
            forces, heat(), 1e-5, solved, rotation, motionLanes::size, nWith,
            secondary, 80
        );
        compare<thermalState>
        (
            forces, heat(), 1e-5, solved, rotation, 7, nWith, secondary, 80
        );
        for (const int count : nWith)
        {
            EXPECT_GE(count, 100);
        }
    }
}


TEST(motionLanes, leavesOutWhatIsNotThere)
{
    // No drag, no spin, a plane
    const someHeat heat;
    sphereForces::counts counts;
    const sphereForces forces
    (
        nullptr, 1, false, false, vector3{0, 9.81, 5}, counts
    );
    int nWith[4] = {0, 0, 0, 0};
    compare<motionState>
    (
        forces, heat(), 1e-5, vector3{1, 1, 0}, vector3{0, 0, 1},
        motionLanes::size, nWith
    );
    EXPECT_GE(nWith[0], 1000);
    EXPECT_EQ(counts.magnus, 0);
    EXPECT_EQ(counts.torque, 0);
}


TEST(motionLanes, countsEvaluationsOutsideTheFits)
{
    sphereForces::counts counts;
    const hendersonDrag drag(1.4, 1);
    const sphereForces forces
    (
        &drag, gammaR, true, true, vector3{0, 0, 0}, counts
    );
    const auto block = std::make_unique<motionLanes>
    (
        forces, nullptr, 0.1, vector3{1, 1, 1}, vector3{1, 1, 1}
    );
    std::mt19937 random(1);
    const linearGas gas = randomGas(random);
    for (int i = 0; i < 3; ++i)
    {
        block->now.gas[i] = &gas;
        block->sphere(i, i ? 1e-4 : 1e-6, 2500);
        motionLanes::set(block->now.x, i, gas.centre);
        motionLanes::set(block->now.v, i, vector3{0, 0, 0});
        motionLanes::set(block->now.omega, i, vector3{0, 0, 0});
        block->hTry[i] = block->hMax[i] = 1e-9;
    }
    block->begin(3);
    EXPECT_EQ(counts.magnus, 3);
    EXPECT_EQ(counts.torque, 3);
    EXPECT_EQ(counts.magnusOutside, 2);
}
