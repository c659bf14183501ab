/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.

Description
    Extreme collisions of spheres, traps on: one row 'case | expected |
    observed | verdict' each.
\*---------------------------------------------------------------------------*/

#include "hardSphereGas.H"
#include "counterRandom.H"

#include <cfenv>
#include <cstdarg>
#include <cstdio>
#include <stdexcept>
#include <string>

namespace
{

using namespace impact;

void row
(
    const std::string& name,
    const std::string& expected,
    bool ok,
    const char* format,
    ...
)
{
    char observed[300];
    va_list list;
    va_start(list, format);
    std::vsnprintf(observed, sizeof observed, format, list);
    va_end(list);
    std::printf
    (
        "%s | %s | %s | %s\n", name.c_str(), expected.c_str(), observed,
        ok ? "ok" : "FAILED"
    );
    std::fflush(stdout);
}


std::string number(const char* format, double value)
{
    char text[100];
    std::snprintf(text, sizeof text, format, value);
    return text;
}


gasSphere sphere
(
    std::uint64_t identity,
    double mass,
    double radius,
    const vector3& x,
    const vector3& v
)
{
    return {identity, mass, radius, x, v, {0, 0, 0}};
}


template<class Gas>
vector3 momentum(const Gas& gas)
{
    vector3 sum = {0, 0, 0};
    for (std::size_t i = 0; i < gas.size(); ++i)
    {
        sum = sum + gas.particle(i).mass*gas.particle(i).v;
    }
    return sum;
}


template<class Gas>
double energy(const Gas& gas)
{
    return gas.translationalEnergy() + gas.rotationalEnergy();
}


template<class Gas>
double deepest(const Gas& gas, const vector3& period)
{
    double depth = -1;
    for (std::size_t i = 0; i < gas.size(); ++i)
    {
        for (std::size_t j = 0; j < i; ++j)
        {
            const gasSphere a = gas.particle(i), b = gas.particle(j);
            vector3 d = a.x - b.x;
            for (int k = 0; k < 3; ++k)
            {
                if (period[k] > 0)
                {
                    d[k] -= period[k]*std::round(d[k]/period[k]);
                }
            }
            const double sigma = a.radius + b.radius;
            depth = std::max(depth, (sigma - mag(d))/sigma);
        }
    }
    return depth;
}


void tangency()
{
    for (double depth : {1e-3, 1e-9, 1e-14, -1e-14})
    {
        hardSphereGas<> gas({}, pairLaw(0.9, 0.2), 3);
        gas.add(sphere(1, 1, 0.5, {0, 0, 0}, {1, 0, 0}));
        gas.add(sphere(2, 1, 0.5, {10, 1 - depth, 0}, {-1, 0, 0}));
        gas.run(20);
        const bool hits = depth > 0;
        row
        (
            "spheres that pass at a depth of "
          + number("%g", depth) + " diameters",
            hits ? "one collision, momentum to 1e-15" : "none",
            gas.counts().pairEvents == (hits ? 1u : 0u)
         && mag(momentum(gas)) < 1e-15,
            "%d, momentum %.1e", int(gas.counts().pairEvents),
            mag(momentum(gas))
        );
    }

    // Parabola that just dips in
    for (double depth : {1e-3, 1e-9, 1e-14, -1e-14})
    {
        const double g = 9.81;
        const double t = parabolicContact
        (
            {0, 1 - depth + 2, 0}, {0, -std::sqrt(4*g), 0}, {0, g, 0}, 1, 10
        );
        // Rounding of the data themselves moves the depth by 4e-16
        const double exact = 2/std::sqrt(g)
          - std::sqrt(2*std::max(depth, 0.)/g);
        const double allowed = depth > 0
          ? 4e-15 + std::sqrt(2*(depth + 1e-15)/g) - std::sqrt(2*depth/g) : 0;
        const bool ok = depth > 0
          ? std::fabs(t - exact) <= allowed : t == never;
        row
        (
            "parabola with its turning point at a depth of "
          + number("%g", depth),
            depth > 0 ? "contact, time to the round-off of the data" : "none",
            ok, "t = %.15g", t
        );
    }
}


void overlap()
{
    const double L = 10;
    collisionDomain d;
    d.high = {L, L, L};
    d.periodic[0] = d.periodic[1] = d.periodic[2] = true;
    hardSphereGas<> gas(d, pairLaw(0.9, 0.2), 3);
    counterRandom rnd(71);
    for (int i = 0; i < 300; ++i)
    {
        gas.add(sphere
        (
            i, 1, 0.5,
            {L*rnd.uniform(), L*rnd.uniform(), L*rnd.uniform()},
            {rnd.normal(), rnd.normal(), rnd.normal()}
        ));
    }
    const double before = deepest(gas, d.high);
    const vector3 p = momentum(gas);
    const double E = energy(gas);
    gas.run(10);
    const double after = deepest(gas, d.high);
    row
    (
        "300 spheres dropped at random, many overlapping",
        "those that approach collide at once, all have parted in the end",
        after < 1e-12 && mag(momentum(gas) - p) < 1e-11 && energy(gas) < E,
        "deepest overlap %.2g diameters, then %.1g; momentum %.1e", before,
        after, mag(momentum(gas) - p)
    );

    hardSphereGas<> two({}, pairLaw(0.9, 0.2), 3);
    two.add(sphere(1, 1, 0.5, {0, 0, 0}, {0, 0, 0}));
    two.add(sphere(2, 1, 0.5, {1e-9, 0, 0}, {-1, 0, 0}));
    two.run(5);
    row
    (
        "two spheres of almost the same centre, approaching",
        "one collision, then they part", two.counts().pairEvents == 1
         && deepest(two, {0, 0, 0}) < 0,
        "%d collision", int(two.counts().pairEvents)
    );
}


void ratios()
{
    for (double ratio : {1e9, 1e-9})
    {
        hardSphereGas<> gas({}, pairLaw(1, 0), 3);
        gas.add(sphere(1, 1, 0.5, {0, 0, 0}, {1, 0, 0}));
        gas.add(sphere(2, ratio, 0.5, {3, 0, 0}, {0, 0, 0}));
        gas.run(5);
        const double expected = 2/(1 + ratio);
        double v2 = 0;
        for (int i = 0; i < 2; ++i)
        {
            if (gas.particle(i).identity == 2)
            {
                v2 = gas.particle(i).v.x;
            }
        }
        const double E = energy(gas)/0.5 - 1;
        row
        (
            "mass ratio " + number("%g", ratio) + ", elastic",
            "speed of the second to 1e-15, energy to 1e-15",
            std::fabs(v2/expected - 1) < 1e-15 && std::fabs(E) < 1e-15,
            "errors %.1e, %.1e", v2/expected - 1, E
        );
    }

    const double L = 6;
    collisionDomain d;
    d.high = {L, L, L};
    d.periodic[0] = d.periodic[1] = d.periodic[2] = true;
    hardSphereGas<> gas(d, pairLaw(1, 0.3), 3);
    counterRandom rnd(72);
    gas.add(sphere(0, 1e6, 1, {3, 3, 3}, {0.01, 0, 0}));
    for (int i = 1; i < 1000; ++i)
    {
        vector3 x;
        do
        {
            x = L*vector3{rnd.uniform(), rnd.uniform(), rnd.uniform()};
        }
        while (mag(x - vector3{3, 3, 3}) < 1.02);
        gas.add(sphere
            (i, 1, 0.01, x, {rnd.normal(), rnd.normal(), rnd.normal()}));
    }
    const vector3 p = momentum(gas);
    const double E = energy(gas);
    gas.run(100);
    row
    (
        "diameter ratio 100, mass ratio 1e6, 1000 spheres, friction",
        "momentum to 1e-13 of m v, no overlap beyond 1e-12",
        mag(momentum(gas) - p) < 1e-13*1e6 && energy(gas) <= E
     && gas.counts().deepestOverlap < 1e-12
     && gas.counts().pairEvents > 1000,
        "%d collisions, momentum %.1e, overlap %.1e m",
        int(gas.counts().pairEvents), mag(momentum(gas) - p)/1e6,
        gas.counts().deepestOverlap
    );
}


//- A sheet of spheres and velocities, for a range of speeds and restitutions
void gases()
{
    for (double speed : {1e-9, 1e5})
    {
        for (double e : {0., 1.})
        {
            const double d0 = 5e-6, L = 20*d0;
            collisionDomain d;
            d.high = {L, L, L};
            d.periodic[0] = d.periodic[1] = d.periodic[2] = true;
            hardSphereGas<> gas(d, pairLaw(e, 0), 3);
            counterRandom rnd(73);
            vector3 p = {0, 0, 0};
            for (int i = 0; i < 512; ++i)
            {
                const vector3 v =
                    speed*vector3{rnd.normal(), rnd.normal(), rnd.normal()};
                gas.add(sphere
                (
                    i, 1, 0.5*d0,
                    {
                        (i % 8 + 0.5)*L/8, (i/8 % 8 + 0.5)*L/8,
                        (i/64 + 0.5)*L/8
                    },
                    v
                ));
                p = p + v;
            }
            const double E = energy(gas);
            gas.run(40*L/20/speed);
            const double lost = E - energy(gas);
            const double depth = deepest(gas, d.high);
            row
            (
                "5 um spheres at " + number("%g m/s", speed)
              + number(", restitution %g", e),
                "momentum to 1e-12, no overlap beyond 1e-9 diameter, energy"
                " kept (1) or accounted for (0)",
                mag(momentum(gas) - p) < 1e-12*512*speed && depth < 1e-9
             && gas.counts().pairEvents > 500
             && std::fabs(lost - gas.restitutionLoss()) < 1e-12*E
             && (e < 1 || std::fabs(lost) < 1e-12*E),
                "%d collisions, energy lost %.3g, depth %.1g",
                int(gas.counts().pairEvents), lost/E, depth
            );
        }
    }
}


void densePacking()
{
    // Face-centred cubic, in 2-D triangular; fractions at close packing
    // pi/(3 sqrt 2), pi/(2 sqrt 3)
    for (double relative : {0.99, 0.9999, 0.999999})
    {
        const int m = 6;
        const double a = std::cbrt(1/relative)*std::sqrt(2.);
        collisionDomain d;
        d.high = {m*a, m*a, m*a};
        d.periodic[0] = d.periodic[1] = d.periodic[2] = true;
        hardSphereGas<> gas(d, pairLaw(1, 0), 3);
        counterRandom rnd(74);
        const double corner[4][3] =
            {{0, 0, 0}, {0.5, 0.5, 0}, {0.5, 0, 0.5}, {0, 0.5, 0.5}};
        for (int i = 0; i < 4*m*m*m; ++i)
        {
            const int c = i/4;
            gas.add(sphere
            (
                i, 1, 0.5,
                {
                    a*(c % m + corner[i % 4][0]),
                    a*(c/m % m + corner[i % 4][1]),
                    a*(c/m/m + corner[i % 4][2])
                },
                {rnd.normal(), rnd.normal(), rnd.normal()}
            ));
        }
        const double E = energy(gas);
        const double free = std::cbrt(1/relative) - 1;
        gas.run(100*free);
        const double depth = deepest(gas, d.high);
        row
        (
            "crystal at " + number("%g", relative)
          + " of close packing, elastic",
            "energy to 1e-12, no overlap beyond 1e-12 diameter",
            std::fabs(energy(gas)/E - 1) < 1e-12 && depth < 1e-12
         && gas.counts().pairEvents > 10000,
            "%d collisions, energy %.1e, depth %.1e",
            int(gas.counts().pairEvents), energy(gas)/E - 1, depth
        );
    }
}


void collapse()
{
    // Three spheres on a line collapse for e < 7 - 4 sqrt 3 = 0.0718
    // (McNamara and Young, Phys. Fluids A 4 (1992) 496)
    for (double tc : {0., 1e-6})
    {
        hardSphereGas<> gas({}, pairLaw(0.05, 0), 2, contactDuration(tc));
        gas.add(sphere(1, 1, 0.5, {-2, 0, 0}, {1, 0, 0}));
        gas.add(sphere(2, 1, 0.5, {0, 0, 0}, {0, 0, 0}));
        gas.add(sphere(3, 1, 0.5, {2.2, 0, 0}, {-1, 0, 0}));
        gas.run(10);
        row
        (
            "collapse of three spheres on a line, e = 0.05, contact duration "
          + number("%g s", tc),
            "ends: round-off (0) or the elastic rule ends it, below 1000"
            " collisions, momentum to 1e-15",
            gas.counts().pairEvents < 1000
         && mag(momentum(gas)) < 1e-15 && gas.counts().pairEvents > 8,
            "%d collisions, energy left %.2g, momentum %.1e",
            int(gas.counts().pairEvents), energy(gas), mag(momentum(gas))
        );
    }

    // A dense cooling gas at e = 0.1 collapses as well
    const int n = 400;
    const double L = std::sqrt(n*M_PI/4/0.5);
    for (double tc : {0., 1e-5})
    {
        collisionDomain d;
        d.high = {L, L, 1};
        d.periodic[0] = d.periodic[1] = true;
        hardSphereGas<> gas(d, pairLaw(0.1, 0), 2, contactDuration(tc));
        counterRandom rnd(75);
        for (int i = 0; i < n; ++i)
        {
            gas.add(sphere
            (
                i, 1, 0.5, {(i % 20 + 0.5)*L/20, (i/20 + 0.5)*L/20, 0},
                {rnd.normal(), rnd.normal(), 0}
            ));
        }
        const vector3 p = momentum(gas);
        std::string ended = "ran to the end";
        try
        {
            gas.run(100);
        }
        catch (const std::runtime_error&)
        {
            ended = "stopped with a message";
        }
        row
        (
            "2-D gas, fraction 0.5, e = 0.1, contact duration "
          + number("%g s", tc),
            tc > 0 ? "ends" : "ends, or stops with a message",
            (tc == 0 || ended == "ran to the end")
         && mag(momentum(gas) - p) < 1e-11,
            "%s, %d collisions, momentum %.1e", ended.c_str(),
            int(gas.counts().pairEvents), mag(momentum(gas) - p)
        );
    }

    // A sphere comes to rest on a floor
    const double g = 9.81;
    for (double e : {0., 0.1, 0.9})
    {
        for (double tc : {0., 1e-4})
        {
            planeWalls floor;
            floor.add({0, 0, 0}, {0, 0, 1});
            hardSphereGas<true, planeWalls> gas
            (
                {}, pairLaw(e, 0), 3, contactDuration(tc), {0, 0, -g}, floor,
                pairLaw(e, 0)
            );
            gas.add(sphere(1, 1, 0.5, {0, 0, 1}, {0, 0, 0}));
            std::string ended = "at rest";
            try
            {
                gas.run(12);
            }
            catch (const std::runtime_error&)
            {
                ended = "stopped with a message";
            }
            const double z = gas.particle(0).x.z - 0.5;
            row
            (
                "sphere coming to rest on a floor" + number(", e = %g", e)
              + number(", contact duration %g s", tc),
                tc > 0
                  ? "at rest to g t_c^2/8 = 1.2e-8 m, 4 to 16 events per t_c"
                    " at most"
                  : "stops with a message",
                tc > 0
                  ? std::fabs(z) < g*tc*tc/8
                 && gas.counts().wallEvents < 16*12/tc
                  : ended != "at rest",
                "%s, height %.1e m, %d events", ended.c_str(), z,
                int(gas.counts().wallEvents)
            );
        }
    }
}

} // End anonymous namespace


int main()
{
    feenableexcept(FE_DIVBYZERO | FE_INVALID | FE_OVERFLOW);
    tangency();
    overlap();
    ratios();
    gases();
    densePacking();
    collapse();
    return 0;
}
