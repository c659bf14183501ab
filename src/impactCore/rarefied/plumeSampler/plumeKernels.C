/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "vectorTargets.H"

#include "plumeKernels.H"
#include "elementary.H"
#include "philoxLanes.H"

namespace
{

using namespace impact;

impactInline threeUnits draw(const plumeDraws& d, std::uint32_t block, int i)
{
    return threeUnits::drawn
        (d.seed, block, d.substream, std::uint64_t(d.first + i));
}


template<bool gaussian, bool disc>
impactInline void emit
(
    int n,
    const plumeDraws& draws,
    const beamShape& beam,
    const emissionTime& time,
    plumeLanes& __restrict__ l
)
{
    const plumeDraws d = draws;
    const beamShape b = beam;
    const emissionTime t = time;
    for (int i = 0; i < n; ++i)
    {
        const threeUnits u = draw(d, 0, i);
        l.age[i] = t.observed - t.duration*u.u0;

        // 1 - cos keeps the digits of narrow beams
        const double versine =
            gaussian
          ? -b.square*logarithm(1 - b.rest*u.u1)
          : b.cone*u.u1;
        const double sine = std::sqrt(positivePart(versine*(2 - versine)));
        double s, c;
        sinCosTurns(u.u2, s, c);

        double speed = b.speed;
        if (disc)
        {
            const threeUnits p = draw(d, 1, i);
            const double r = b.exitRadius*std::sqrt(p.u0);
            double sp, cp;
            sinCosTurns(p.u1, sp, cp);
            l.x[1][i] = r*cp;
            l.x[2][i] = r*sp;
            speed += b.deviation*truncatedNormal(p.u2);
        }
        else
        {
            l.x[1][i] = 0;
            l.x[2][i] = 0;
        }
        l.x[0][i] = 0;
        l.v[0][i] = speed*(1 - versine);
        l.v[1][i] = speed*sine*c;
        l.v[2][i] = speed*sine*s;
    }
}

} // End anonymous namespace


namespace impact
{

impactKernel void emitBeam
(
    int n,
    const plumeDraws& d,
    const beamShape& b,
    const emissionTime& t,
    plumeLanes& l
)
{
    const bool disc = b.exitRadius > 0 || b.deviation > 0;
    const bool gaussian = b.square > 0;
    gaussian && disc ? emit<true, true>(n, d, b, t, l)
  : gaussian ? emit<true, false>(n, d, b, t, l)
  : disc ? emit<false, true>(n, d, b, t, l)
  : emit<false, false>(n, d, b, t, l);
}


impactKernel void emitTimes
(
    int n,
    const plumeDraws& draws,
    const emissionTime& time,
    plumeLanes& __restrict__ l
)
{
    const plumeDraws d = draws;
    const emissionTime t = time;
    for (int i = 0; i < n; ++i)
    {
        const threeUnits u = draw(d, 0, i);
        l.age[i] = t.observed - t.duration*u.u0;
        l.choice[i] = u.u1;
    }
}


impactKernel void turnLanes
(
    int n,
    const plumeDraws& draws,
    plumeLanes& __restrict__ l
)
{
    const plumeDraws d = draws;
    for (int i = 0; i < n; ++i)
    {
        double s, c;
        sinCosTurns(draw(d, 0, i).u2, s, c);
        const double y = l.x[1][i], z = l.x[2][i];
        const double v = l.v[1][i], w = l.v[2][i];
        l.x[1][i] = c*y - s*z;
        l.x[2][i] = s*y + c*z;
        l.v[1][i] = c*v - s*w;
        l.v[2][i] = s*v + c*w;
    }
}


impactKernel void smoothVelocities
(
    int n,
    const plumeDraws& draws,
    double deviation,
    plumeLanes& __restrict__ l
)
{
    const plumeDraws d = draws;
    for (int i = 0; i < n; ++i)
    {
        const threeUnits u = draw(d, 1, i);
        l.v[0][i] += deviation*truncatedNormal(u.u0);
        l.v[1][i] += deviation*truncatedNormal(u.u1);
        l.v[2][i] += deviation*truncatedNormal(u.u2);
    }
}


impactKernel void flyStraight
(
    int n,
    const nozzleShape& shape,
    plumeLanes& __restrict__ l
)
{
    for (int d = 0; d < 3; ++d)
    {
        const double P = shape.position[d] - shape.origin[d];
        const double V = shape.velocity[d];
        const double A = shape.acceleration[d];
        const double observed = shape.observed;
        double* __restrict__ x = l.x[d];
        const double* __restrict__ v = l.v[d];
        const double* __restrict__ age = l.age;
        for (int i = 0; i < n; ++i)
        {
            const double t = observed - age[i];
            x[i] +=
                P + t*(V + 0.5*A*t) + (v[i] + V + A*t)*age[i];
        }
    }
}


impactKernel void coolLanes
(
    int n,
    const radiativeCooling::cell* __restrict__ table,
    plumeLanes& __restrict__ l
)
{
    for (int i = 0; i < n; ++i)
    {
        l.T[i] = radiativeCooling::lookUp
        (
            table, int(l.branch[i]), l.y[i] + l.rate[i]*l.age[i]
        );
    }
}


impactKernel void stepLanes
(
    int n,
    double deltaT,
    plumeLanes& __restrict__ l
)
{
    const int width = 16;
    for (int from = 0; from < n; from += width)
    {
        double left[width], T[width], heat[width], loss[width];
        double longest = 0;
        for (int i = 0; i < width; ++i)
        {
            // Lanes behind the last repeat it: they must hold numbers
            const int k = from + i < n ? from + i : n - 1;
            left[i] = l.age[k];
            T[i] = l.T[k];
            heat[i] = l.y[k];
            loss[i] = l.rate[k];
            longest = left[i] > longest ? left[i] : longest;
        }
        for (double t = 0; t < longest; t += deltaT)
        {
            for (int i = 0; i < width; ++i)
            {
                const double h = left[i] < deltaT ? left[i] : deltaT;
                const double square = T[i]*T[i];
                T[i] += h*(heat[i] - loss[i]*(square*square));
                left[i] -= h;
            }
        }
        for (int i = 0; i < width && from + i < n; ++i)
        {
            l.T[from + i] = T[i];
        }
    }
}

} // End namespace impact
