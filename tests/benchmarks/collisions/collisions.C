/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.

Description
    Collisions per CPU second of a gas of hard spheres in equilibrium:

        collisions METHOD DIMENSION N FRACTION LAW COLLISIONS

    METHOD event or bruteForce, LAW smooth or rough. Prints one row of the
    table; the brute force prints by how much its positions differ from those
    of the event-driven engine.

        collisions stream DIMENSION N FRACTION SPREAD STEPS

    A host that supplies parabolic paths, as a cloud would: spheres of 5 um
    at 1797 m/s with a standard deviation SPREAD [m/s] in each component,
    strewn at random, accelerations of 1e5 m/s2, steps of 1e-7 s.
\*---------------------------------------------------------------------------*/

#include "hardSphereGas.H"
#include "counterRandom.H"

#include <cfenv>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <new>
#include <string>

namespace
{

std::size_t allocations = 0;

} // End anonymous namespace


void* operator new(std::size_t n)
{
    ++allocations;
    if (void* p = std::malloc(n))
    {
        return p;
    }
    throw std::bad_alloc();
}

void operator delete(void* p) noexcept
{
    std::free(p);
}

void operator delete(void* p, std::size_t) noexcept
{
    std::free(p);
}


namespace
{

using namespace impact;

//- All pairs searched for their contact: once per step, and the pairs of a
//  particle again after its event
class bruteForce
{
    std::vector<gasSphere> s_;
    std::vector<double> next_;
    std::vector<int> partner_;
    pairLaw law_;
    double L_;
    int dimension_;

    vector3 separation(int i, int j) const
    {
        vector3 d = s_[j].x - s_[i].x;
        for (int k = 0; k < dimension_; ++k)
        {
            d[k] -= L_*std::round(d[k]/L_);
        }
        return d;
    }

    void search(int i, double now, double end)
    {
        next_[i] = never;
        partner_[i] = -1;
        for (int j = 0; j < int(s_.size()); ++j)
        {
            if (j == i)
            {
                continue;
            }
            const double t = now + straightContact
            (
                separation(i, j), s_[j].v - s_[i].v,
                s_[i].radius + s_[j].radius, end - now, {1e-12, 1e-14}
            );
            if (t < next_[i])
            {
                next_[i] = t;
                partner_[i] = j;
            }
            if (t < next_[j])
            {
                next_[j] = t;
                partner_[j] = i;
            }
        }
    }

public:

    std::uint64_t collisions = 0;

    bruteForce
    (
        const std::vector<gasSphere>& s,
        const pairLaw& law,
        double L,
        int dimension
    )
    :
        s_(s),
        next_(s.size()),
        partner_(s.size()),
        law_(law),
        L_(L),
        dimension_(dimension)
    {}

    const gasSphere& sphere(int i) const
    {
        return s_[i];
    }

    void run(double duration)
    {
        const int n = int(s_.size());
        double left = duration;
        while (left > 0)
        {
            // The nearest image stays the nearest that can be met
            double fastest = 0;
            for (const gasSphere& s : s_)
            {
                fastest = std::max(fastest, mag(s.v));
            }
            const double h = std::min(left, 0.1*L_/fastest);
            std::fill(next_.begin(), next_.end(), never);
            for (int i = 0; i < n; ++i)
            {
                search(i, 0, h);
            }
            double now = 0;
            while (true)
            {
                int a = 0;
                for (int i = 1; i < n; ++i)
                {
                    a = next_[i] < next_[a] ? i : a;
                }
                const double t = std::min(next_[a], h);
                for (gasSphere& s : s_)
                {
                    s.x = s.x + (t - now)*s.v;
                }
                now = t;
                if (next_[a] > h)
                {
                    break;
                }
                const int b = partner_[a];
                const vector3 d = separation(a, b);
                gasSphere& p = s_[a];
                gasSphere& q = s_[b];
                const pairCollision out = law_.collide
                (
                    {p.v, p.omega, p.mass, p.radius},
                    {q.v, q.omega, q.mass, q.radius}, (1/mag(d))*d
                );
                p.v = out.v1;
                q.v = out.v2;
                p.omega = out.omega1;
                q.omega = out.omega2;
                ++collisions;
                for (int i = 0; i < n; ++i)
                {
                    if
                    (
                        i == a || i == b || partner_[i] == a
                     || partner_[i] == b
                    )
                    {
                        search(i, now, h);
                    }
                }
            }
            left -= h;
        }
    }
};


struct stream
:
    loneHost
{
    typedef parabolicPath Path;

    std::vector<Path> paths;
    double r;

    std::size_t size() const
    {
        return paths.size();
    }

    std::uint64_t identity(std::int32_t i) const
    {
        return i;
    }

    double radius(std::int32_t) const
    {
        return r;
    }

    Path path(std::int32_t i) const
    {
        return paths[i];
    }

    double wallTime(std::int32_t, double, double) const
    {
        return never;
    }

    void advance(Path& p, double t)
    {
        const vector3 x = p.position(t), v = p.velocity(t);
        p.x = x;
        p.v = v;
        p.start = t;
    }

    void collide(std::int32_t i, std::int32_t j, const vector3& s, double t)
    {
        advance(paths[i], t);
        advance(paths[j], t);
        const vector3 zero = {0, 0, 0};
        const pairCollision out = pairLaw(1, 0).collide
        (
            {paths[i].v, zero, 1, r}, {paths[j].v, zero, 1, r}, (1/mag(s))*s
        );
        paths[i].v = out.v1;
        paths[j].v = out.v2;
    }

    bool hitWall(std::int32_t, double)
    {
        return true;
    }
};


double cpu()
{
    return double(std::clock())/CLOCKS_PER_SEC;
}

int runStream
(
    int dimension,
    int n,
    double fraction,
    double spread,
    int steps
)
{
    const double d = 5e-6, tau = 1e-7;
    // In 2-D spheres whose centres lie in the plane: 3 C_V A/(2 pi r^2)
    const double L = dimension == 3
      ? std::cbrt(n*M_PI/6/fraction)*d : std::sqrt(n*M_PI/6/fraction)*d;
    counterRandom rnd(62);
    stream host;
    host.r = 0.5*d;
    const int m = int(std::ceil(std::pow(n, 1./dimension) - 1e-9));
    for (int i = 0; i < n; ++i)
    {
        // One in each cell of a lattice: near in space, near in memory
        const int c[3] = {i % m, i/m % m, i/m/m};
        parabolicPath p = {{0, 0, 0}, {0, 0, 0}, {0, 0, 0}, 0};
        for (int k = 0; k < dimension; ++k)
        {
            p.x[k] = (c[k] + 0.05 + 0.9*rnd.uniform())*L/m;
            p.v[k] = (k == 0 ? 1797 : 0) + spread*rnd.normal();
            p.a[k] = 1e5*rnd.normal();
        }
        host.paths.push_back(p);
    }
    collisionStep<stream> step({}, contactDuration(1e-9));
    collisionCounts counts;
    std::size_t allocated = 0;
    double start = 0;
    for (int k = -2; k < steps; ++k)
    {
        if (k == 0)
        {
            counts = collisionCounts();
            allocated = allocations;
            start = cpu();
        }
        counts += step.run(host, tau);
        for (parabolicPath& p : host.paths)
        {
            host.advance(p, tau);
            p.start = 0;
        }
    }
    const double used = cpu() - start;
    std::printf
    (
        "stream spread %g m/s,%d,%d,%g,smooth,%.0f,%.3g,,,%zu,,,,%.3g\n",
        spread, dimension, n, fraction, double(counts.pairEvents), used,
        allocations - allocated, 1e6*used/n/steps
    );
    return 0;
}


//- What is to be run
struct box
{
    int dimension;
    int n;
    double fraction;
    const char* surface;
    double wanted;          // collisions

    bool rough() const
    {
        return std::string(surface) == "rough";
    }

    double L() const
    {
        return dimension == 3
          ? std::cbrt(n*M_PI/6/fraction) : std::sqrt(n*M_PI/4/fraction);
    }
};


//- Spheres on a lattice, with velocities of a gas
void fill(hardSphereGas<>& gas, const box& run)
{
    const int n = run.n, dimension = run.dimension;
    const double L = run.L();
    const int m = int(std::ceil(std::pow(n, 1./dimension) - 1e-9));
    counterRandom rnd(61);
    for (int i = 0; i < n; ++i)
    {
        gasSphere s =
            {std::uint64_t(i), 1, 0.5, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}};
        const int c[3] = {i % m, i/m % m, i/m/m};
        for (int k = 0; k < dimension; ++k)
        {
            s.x[k] = (c[k] + 0.5)*L/m;
            s.v[k] = rnd.normal();
        }
        gas.add(s);
    }
}


//- Until there have been so many more collisions
void runFor(hardSphereGas<>& gas, double L, double collisions)
{
    const double start = gas.time();
    const std::uint64_t before = gas.counts().pairEvents;
    double part = 0.02*L;
    while (double(gas.counts().pairEvents - before) < collisions)
    {
        gas.run(part);
        const double done = double(gas.counts().pairEvents - before);
        part = std::min
        (
            2*part,
            (gas.time() - start)*(collisions - done + 1)/(done + 1)
        );
        part = std::max(part, 1e-3*(gas.time() - start));
    }
}


void runEvents(hardSphereGas<>& gas, const box& run)
{
    const int n = run.n, dimension = run.dimension;
    const double fraction = run.fraction;
    const collisionCounts before = gas.counts();
    const std::size_t allocated = allocations;
    const double E =
        gas.translationalEnergy() + gas.rotationalEnergy();
    const double T =
        2*gas.translationalEnergy()/(dimension*(n - 1.));
    const double from = gas.time();
    const double start = cpu();
    runFor(gas, run.L(), run.wanted);
    const double used = cpu() - start;
    const double done =
        double(gas.counts().pairEvents - before.pairEvents);
    const double drift =
        (gas.translationalEnergy() + gas.rotationalEnergy())/E - 1;

    // Enskog's rate with the contact values of Carnahan and Starling and
    // of Henderson; rough spheres do not keep their temperature exactly
    const double contact = dimension == 3
      ? (1 - fraction/2)/std::pow(1 - fraction, 3)
      : (1 - 7*fraction/16)/std::pow(1 - fraction, 2);
    const double rate = (dimension == 3 ? 4*6 : 2*4)/std::sqrt(M_PI)
       *fraction*contact*std::sqrt(T);
    std::string overTheory;
    if (!run.rough())
    {
        char text[40];
        std::snprintf
        (
            text, sizeof text, "%.4f",
            2*done/(n - 1)/(gas.time() - from)/rate
        );
        overTheory = text;
    }
    std::printf
    (
        "event,%d,%d,%g,%s,%.0f,%.3g,%.3g,%.2g,%zu,%.1e,%s,,\n",
        dimension, n, fraction, run.surface, done, used, done/used,
        1e6*used/done, allocations - allocated, std::fabs(drift),
        overTheory.c_str()
    );
}


void runBruteForce(hardSphereGas<>& gas, const pairLaw& law, const box& run)
{
    const int n = run.n, dimension = run.dimension;
    const double L = run.L();
    std::vector<gasSphere> start(n);
    for (int i = 0; i < n; ++i)
    {
        start[gas.particle(i).identity] = gas.particle(i);
    }
    const double from = gas.time();
    runFor(gas, L, run.wanted);
    bruteForce all(start, law, L, dimension);
    const std::size_t allocated = allocations;
    const double begin = cpu();
    all.run(gas.time() - from);
    const double used = cpu() - begin;
    double E0 = 0, E1 = 0, difference = 0;
    for (int i = 0; i < n; ++i)
    {
        const gasSphere a = gas.particle(i);
        const gasSphere& b = all.sphere(int(a.identity));
        vector3 d = a.x - b.x;
        for (int k = 0; k < dimension; ++k)
        {
            d[k] -= L*std::round(d[k]/L);
        }
        difference = std::max(difference, mag(d));
        E0 += dot(start[i].v, start[i].v);
        E1 += dot(all.sphere(i).v, all.sphere(i).v);
    }
    std::printf
    (
        "bruteForce,%d,%d,%g,%s,%.0f,%.3g,%.3g,%.3g,%zu,%.1e,,%.0e,\n",
        dimension, n, run.fraction, run.surface, double(all.collisions), used,
        all.collisions/used, 1e6*used/all.collisions,
        allocations - allocated, std::fabs(E1/E0 - 1), difference
    );
}

} // End anonymous namespace


int main(int argc, char** argv)
{
    if (argc != 7)
    {
        std::fprintf
        (
            stderr, "Usage: collisions event|bruteForce 2|3 N FRACTION"
            " smooth|rough COLLISIONS\n"
        );
        return 1;
    }
    feenableexcept(FE_DIVBYZERO | FE_INVALID | FE_OVERFLOW);
    if (std::string(argv[1]) == "stream")
    {
        return runStream
        (
            std::atoi(argv[2]), std::atoi(argv[3]), std::atof(argv[4]),
            std::atof(argv[5]), std::atoi(argv[6])
        );
    }
    const box run =
    {
        std::atoi(argv[2]), std::atoi(argv[3]), std::atof(argv[4]), argv[5],
        std::atof(argv[6])
    };
    const double L = run.L();
    collisionDomain domain;
    domain.high = {L, L, L};
    for (int k = 0; k < run.dimension; ++k)
    {
        domain.periodic[k] = true;
    }
    // Rough spheres that lose nothing: the state stays the same
    const bool rough = run.rough();
    const pairLaw law(1, rough ? 1e12 : 0, true, rough ? 1 : 0);
    hardSphereGas<> gas(domain, law, run.dimension);
    fill(gas, run);

    // Into equilibrium, and the arrays to their size
    runFor(gas, L, 5.*run.n);
    if (std::string(argv[1]) == "bruteForce")
    {
        runBruteForce(gas, law, run);
    }
    else
    {
        runEvents(gas, run);
    }
    return 0;
}
