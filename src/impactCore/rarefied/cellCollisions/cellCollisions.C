/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "cellCollisions.H"
#include "outOfRange.H"
#include "elementary.H"
#include "maxwellian.H"

#include <algorithm>
#include <cmath>
#include <limits>

namespace
{
    //- One of 0 ... n - 1
    inline int below(std::uint32_t bits, int n)
    {
        return int((std::uint64_t(bits)*std::uint64_t(n)) >> 32);
    }

    inline double unit(std::uint32_t bits)
    {
        return (double(bits) + 0.5)*0x1p-32;
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

impact::cellCollisions::cellCollisions
(
    const std::vector<species>& gas,
    double Tref,
    double relaxationCollisionNumber,
    std::uint64_t seed
)
:
    species_(gas),
    pairs_(gas.size()*gas.size()),
    exchangeProbability_(0),
    rotating_(false),
    seed_(seed)
{
    checkRange("Tref", Tref, "(0, inf) K");
    const double Z = relaxationCollisionNumber;
    if (Z != 0)
    {
        checkRange("relaxationCollisionNumber", Z, "[1, inf)");
    }
    exchangeProbability_ = Z > 0 ? 1/Z : 0;

    for (const species& s : species_)
    {
        checkRange("mass", s.mass, "(0, inf) kg");
        checkRange("diameter", s.diameter, "(0, inf) m");
        checkRange("omega", s.omega, "[0.5, 1.5], 0.5 for hard spheres");
        checkRange
        (
            "internalDegreesOfFreedom", s.internalDegreesOfFreedom, "[0, inf)"
        );
        rotating_ = rotating_
            || (s.internalDegreesOfFreedom > 0 && exchangeProbability_ > 0);
    }

    for (std::size_t p = 0; p < gas.size(); ++p)
    {
        for (std::size_t q = 0; q < gas.size(); ++q)
        {
            const double d = 0.5*(gas[p].diameter + gas[q].diameter);
            const double omega = 0.5*(gas[p].omega + gas[q].omega);
            const double sum = gas[p].mass + gas[q].mass;
            const double m = gas[p].mass/sum*gas[q].mass;

            pair& c = pairs_[p*gas.size() + q];
            c.coefficient =
                M_PI*d*d*std::pow(2*maxwellian::boltzmann*Tref/m, omega - 0.5)
               /std::tgamma(2.5 - omega);
            c.exponent = 1 - omega;
            c.reducedMass = m;
            c.shareOfFirst = gas[p].mass/sum;
            c.relativeShape = 2.5 - omega;
        }
    }
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void impact::cellCollisions::divide(const molecules& gas, const box& around)
{
    const int n = gas.n;
    int nDivided = 0;
    for (const double perWidth : around.perWidth)
    {
        nDivided += perWidth > 0;
    }

    // Two molecules for each sub-cell or more
    int m = 2;
    while (nDivided && 2*std::pow(m + 1, nDivided) <= n)
    {
        ++m;
    }
    const int mx = around.perWidth[0] > 0 ? m : 1;
    const int my = around.perWidth[1] > 0 ? m : 1;
    const int mz = around.perWidth[2] > 0 ? m : 1;
    const int nSub = mx*my*mz;

    if (int(subCell_.size()) < n)
    {
        subCell_.resize(n);
        order_.resize(n);
        rank_.resize(n);
        last_.resize(n);
    }
    std::fill_n(last_.begin(), n, -1);
    subStart_.assign(nSub + 1, 0);

    const auto along = [](double x, double corner, double scale, int limit)
    {
        const int i = int(scale*(x - corner));
        return i < 0 ? 0 : i < limit ? i : limit - 1;
    };
    for (int i = 0; i < n; ++i)
    {
        const int sub =
            along(gas.x[i], around.corner[0], mx*around.perWidth[0], mx)
          + mx
           *(
                along(gas.y[i], around.corner[1], my*around.perWidth[1], my)
              + my
               *along(gas.z[i], around.corner[2], mz*around.perWidth[2], mz)
            );
        subCell_[i] = sub;
        rank_[i] = subStart_[sub + 1]++;
    }
    for (int sub = 0; sub < nSub; ++sub)
    {
        subStart_[sub + 1] += subStart_[sub];
    }
    for (int i = 0; i < n; ++i)
    {
        order_[subStart_[subCell_[i]] + rank_[i]] = i;
    }
}


int impact::cellCollisions::another
(
    int p,
    int q,
    int n,
    counterRandom& rnd
) const
{
    const int sub = subCell_[p];
    const int nSub = subStart_[sub + 1] - subStart_[sub];
    const bool near = nSub > 2 && subCell_[q] == sub;
    const int a = near ? rank_[p] : p;
    const int b = near ? rank_[q] : q;
    int i = below(rnd.bits(), (near ? nSub : n) - 2);
    i += i >= std::min(a, b);
    i += i >= std::max(a, b);
    return near ? order_[subStart_[sub] + i] : i;
}


void impact::cellCollisions::collidePair
(
    const molecules& gas,
    int p,
    int q,
    double relativeSpeedSqr,
    counterRandom& rnd
) const
{
    const pair& c = pairOf(gas.species[p], gas.species[q]);
    const double first = c.shareOfFirst;
    const double second = 1 - first;
    const double uc = first*gas.u[p] + second*gas.u[q];
    const double vc = first*gas.v[p] + second*gas.v[q];
    const double wc = first*gas.w[p] + second*gas.w[q];
    double speed = std::sqrt(relativeSpeedSqr);

    if (rotating_)
    {
        double energy = 0.5*c.reducedMass*relativeSpeedSqr;
        bool exchanged = false;
        for (const int i : {p, q})
        {
            const int zeta = species_[gas.species[i]].internalDegreesOfFreedom;
            if (zeta && unit(rnd.bits()) < exchangeProbability_)
            {
                energy += gas.internalEnergy[i];
                gas.internalEnergy[i] = energy
                    *maxwellian::betaVariate(0.5*zeta, c.relativeShape, rnd);
                energy -= gas.internalEnergy[i];
                exchanged = true;
            }
        }
        if (exchanged)
        {
            speed = std::sqrt(2*(energy > 0 ? energy : 0)/c.reducedMass);
        }
    }

    const double cosine = 2*unit(rnd.bits()) - 1;
    const double sine = std::sqrt(1 - cosine*cosine);
    double s, k;
    sinCosTurns(unit(rnd.bits()), s, k);
    const double u = speed*cosine;
    const double v = speed*sine*k;
    const double w = speed*sine*s;

    gas.u[p] = uc + second*u;
    gas.v[p] = vc + second*v;
    gas.w[p] = wc + second*w;
    gas.u[q] = uc - first*u;
    gas.v[q] = vc - first*v;
    gas.w[q] = wc - first*w;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

double impact::cellCollisions::sigmaC
(
    int p,
    int q,
    double relativeSpeedSqr
) const
{
    if (relativeSpeedSqr < std::numeric_limits<double>::min())
    {
        return 0;
    }
    const pair& c = pairOf(p, q);
    return c.coefficient*std::pow(relativeSpeedSqr, c.exponent);
}


double impact::cellCollisions::equilibriumSigmaC
(
    int p,
    int q,
    double temperature
) const
{
    // c^2 m/(2 k T) of a pair is a gamma variate of 3/2
    const pair& c = pairOf(p, q);
    return
        c.coefficient
       *std::pow
        (
            2*maxwellian::boltzmann*temperature/c.reducedMass,
            c.exponent
        )
       *std::tgamma(1.5 + c.exponent)/std::tgamma(1.5);
}


double impact::cellCollisions::startingSigmaCMax(double temperature) const
{
    double greatest = 0;
    for (std::size_t p = 0; p < species_.size(); ++p)
    {
        for (std::size_t q = 0; q < species_.size(); ++q)
        {
            const double c2 =
                9*2*maxwellian::boltzmann*temperature
               /pairOf(p, q).reducedMass;
            greatest = std::fmax(greatest, sigmaC(p, q, c2));
        }
    }
    return greatest;
}


void impact::cellCollisions::collide
(
    const molecules& gas,
    const box& around,
    double rate,
    double& sigmaCMax,
    std::uint64_t cell,
    std::uint32_t step,
    counts& total
)
{
    const int n = gas.n;
    if (n < 2)
    {
        return;
    }

    counterRandom rnd(seed_, cell, step);
    const double limit = sigmaCMax;
    const double expected = 0.5*n*(n - 1)*rate*limit;
    const std::int64_t nCandidates =
        std::int64_t(expected + unit(rnd.bits()));
    if (!nCandidates)
    {
        return;
    }
    divide(gas, around);

    total.candidates += nCandidates;
    for (std::int64_t k = 0; k < nCandidates; ++k)
    {
        const int p = below(rnd.bits(), n);
        const std::uint32_t other = rnd.bits();
        const int sub = subCell_[p];
        const int nSub = subStart_[sub + 1] - subStart_[sub];
        int q;
        if (nSub > 1)
        {
            const int i = below(other, nSub - 1);
            q = order_[subStart_[sub] + i + (i >= rank_[p])];
        }
        else
        {
            const int i = below(other, n - 1);
            q = i + (i >= p);
        }
        if ((last_[p] == q || last_[q] == p) && n > 2)
        {
            q = another(p, q, n, rnd);
        }
        last_[p] = q;
        last_[q] = p;

        const double du = gas.u[p] - gas.u[q];
        const double dv = gas.v[p] - gas.v[q];
        const double dw = gas.w[p] - gas.w[q];
        const double c2 = du*du + dv*dv + dw*dw;
        const double sc = sigmaC(gas.species[p], gas.species[q], c2);
        if (sc > sigmaCMax)
        {
            sigmaCMax = sc;
        }
        if (unit(rnd.bits())*limit < sc)
        {
            collidePair(gas, p, q, c2, rnd);
            ++total.collisions;
        }
    }
}
