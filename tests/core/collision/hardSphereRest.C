/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.

Description
    Hard spheres that come to rest: corners, heaps; what is refused.
\*---------------------------------------------------------------------------*/

#include "hardSphereGasTest.H"

TEST(hardSphereGas, comesToRestInACorner)
{
    // Restitution 0.1 or 0 between two walls, pressed in by gravity: at most
    // 8 events and those at rest, 4 per wall, in a contact duration
    const double g = 9.81, tc = 1e-3, end = 4;
    for (double e : {0., 0.1, 0.5})
    {
        planeWalls corner;
        corner.add({0, 0, 0}, {1, 0, 1});
        corner.add({0, 0, 0}, {-1, 0, 1});
        hardSphereGas<true, planeWalls> gas
        (
            {}, pairLaw(e, 0.2), 3, contactDuration(tc), {0, 0, -g}, corner,
            pairLaw(e, 0.2)
        );
        gas.add({1, 1, 0.5, {0.1, 0, 3}, {0, 0, 0}, {0, 0, 0}});
        gas.run(end);
        const gasSphere s = gas.particle(0);
        EXPECT_NEAR(s.x.x, 0, g*tc*tc);
        EXPECT_NEAR(s.x.z, std::sqrt(0.5), g*tc*tc);
        EXPECT_LT(mag(s.v), g*tc);
        EXPECT_LT(gas.counts().wallEvents, 16*end/tc);
    }
}


TEST(hardSphereGas, endsTheCollapseOfAHeap)
{
    const double g = 9.81, tc = 1e-3, r = 0.45;
    planeWalls hole;
    hole.add({0, 0, 0}, {0, 0, 1});
    hole.add({0, 0, 0}, {1, 0, 0});
    hole.add({3, 0, 0}, {-1, 0, 0});
    hole.add({0, 0, 0}, {0, 1, 0});
    hole.add({0, 3, 0}, {0, -1, 0});
    for (double e : {0., 0.5})
    {
        hardSphereGas<true, planeWalls> heap
        (
            {}, pairLaw(e, 0.2), 3, contactDuration(tc), {0, 0, -g}, hole,
            pairLaw(e, 0.2)
        );
        const int n = 27;
        for (int i = 0; i < n; ++i)
        {
            heap.add
            ({
                std::uint64_t(i), 1, r,
                {
                    0.5 + i % 3 + 0.01*(i % 7 - 3),
                    0.5 + i/3 % 3 + 0.01*(i % 5 - 2), 0.5 + i/9
                },
                {0, 0, 0}, {0, 0, 0}
            });
        }
        auto energy = [&]
        {
            double sum =
                heap.translationalEnergy() + heap.rotationalEnergy();
            for (int i = 0; i < n; ++i)
            {
                sum += g*heap.particle(i).x.z;
            }
            return sum;
        };
        double last = energy();
        const double first = last;
        const double depth = 2*g*tc*tc/32;
        for (int k = 0; k < 10; ++k)
        {
            heap.run(0.1);
            const double now = energy();
            EXPECT_LT(now, last*(1 + 1e-12));
            last = now;
        }
        EXPECT_NEAR
        (
            first - last, heap.restitutionLoss() + heap.frictionLoss(),
            1e-11*first
        );
        EXPECT_LT(heap.counts().deepestOverlap, 1.001*depth);
        for (int i = 0; i < n; ++i)
        {
            const vector3 x = heap.particle(i).x;
            for (double gap : {x.x, x.y, x.z, 3 - x.x, 3 - x.y})
            {
                EXPECT_GT(gap, r - depth);
            }
        }
        EXPECT_LT
        (
            double(heap.counts().pairEvents + heap.counts().wallEvents),
            20*n/tc
        );
    }
}


TEST(hardSphereGas, refusesBadInput)
{
    typedef hardSphereGas<> gasType;
    const pairLaw law;
    EXPECT_THROW(gasType({}, law, 4), std::invalid_argument);
    EXPECT_THROW(contactDuration(-1), std::invalid_argument);
    EXPECT_THROW(contactDuration{std::nan("")}, std::invalid_argument);
    EXPECT_THROW
    (
        gasType({}, law, 3, contactDuration(), {0, 0, 1}),
        std::invalid_argument
    );
    EXPECT_THROW(gasType(box(1, 3), law, 2), std::invalid_argument);
    gasType gas({}, law, 2);
    const vector3 zero = {0, 0, 0};
    EXPECT_THROW(gas.add({1, 0, 1, zero, zero, zero}), std::invalid_argument);
    EXPECT_THROW(gas.add({1, 1, -1, zero, zero, zero}), std::invalid_argument);
    EXPECT_THROW
        (gas.add({1, 1, 1, {0, 0, 1}, zero, zero}), std::invalid_argument);
    EXPECT_THROW
        (gas.add({1, 1, 1, zero, zero, {1, 0, 0}}), std::invalid_argument);
    EXPECT_THROW
        (gas.add({1, 1, 1, {never, 0, 0}, zero, zero}), std::invalid_argument);
    gas.add({1, 1, 1, zero, zero, zero});
    gas.add({1, 1, 1, {5, 0, 0}, zero, zero});
    EXPECT_THROW(gas.run(1), std::invalid_argument);
    EXPECT_THROW(gas.run(-1), std::invalid_argument);
    planeWalls walls;
    EXPECT_THROW(walls.add(zero, zero), std::invalid_argument);
}
