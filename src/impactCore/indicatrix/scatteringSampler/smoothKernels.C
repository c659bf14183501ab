/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "vectorTargets.H"

#include "orientation.H"
#include "philoxLanes.H"
#include "reboundLaw.H"
#include "searchStep.H"
#include "smoothKernels.H"

namespace
{

using namespace impact;

//- Trials after which a flight is given up
constexpr double manyTrials = 10000;


impactInline vector3 get(const smoothLanes::lane* l, int i)
{
    return {l[0][i], l[1][i], l[2][i]};
}


impactInline void put(smoothLanes::lane* l, int i, const vector3& v)
{
    l[0][i] = v.x;
    l[1][i] = v.y;
    l[2][i] = v.z;
}


//- Lowest point of the body from its centre, and its distance below; m is the
//  laboratory axis y
template<bool box>
impactInline double lowest(const smoothBody& b, const vector3& m, vector3& r)
{
    const double along = b.along, across = b.across;
    if (box)
    {
        r.x = m.x > 0 ? -along : along;
        r.y = m.y > 0 ? -across : across;
        r.z = m.z > 0 ? -across : across;
        return -dot(r, m);
    }
    const vector3 s = {along*m.x, across*m.y, across*m.z};
    const double h = mag(s);
    const double f = -1/h;
    r = {f*along*s.x, f*across*s.y, f*across*s.z};
    return h;
}


//- Rotation from the start of a flight
struct turning
{
    vector3 axis;
    double s, c, sAxis, cAxis;

    impactInline turning(const smoothLanes& l, int i, double t)
    :
        axis(get(l.axisL, i))
    {
        sinCos(-l.rateL[i]*t, s, c);
        sinCos(-l.rateAxis[i]*t, sAxis, cAxis);
    }

    impactInline vector3 aboutAxis(const vector3& v) const
    {
        return {v.x, cAxis*v.y - sAxis*v.z, sAxis*v.y + cAxis*v.z};
    }

    //- What is fixed in the laboratory
    impactInline vector3 of(const vector3& v) const
    {
        return aboutAxis
            (c*v + s*cross(axis, v) + ((1 - c)*dot(axis, v))*axis);
    }
};


//- Begin a flight from the wall with the angular velocity w, after an impact
//  from which the contact point rises
template<bool box>
impactInline void begin
(
    const smoothBody& b,
    const vector3& V,
    const vector3& w,
    double h,
    double rise,
    smoothLanes& l,
    int i
)
{
    const double R = b.radius;
    const double ratio = 1 - b.Ja/b.Jc;
    const vector3 L = {b.Ja*w.x, b.Jc*w.y, b.Jc*w.z};
    const double magL = mag(L);
    const double w2 = dot(w, w);
    const double fastest =
        std::sqrt(V.x*V.x + V.y*V.y) + std::sqrt(w2)*R + 1e-100;
    const double reach = boundedReach(b.bend*w2, 0, fastest, R, 0, 0);
    const double minStep = minAdvance*R/fastest;
    put(l.axisL, i, (1/nonZero(magL))*L);
    l.rateL[i] = magL/b.Jc;
    l.rateAxis[i] = ratio*w.x;
    l.y[i] = h;
    l.t[i] = 0;
    l.gap[i] = 0;
    l.reach[i] = reach;
    l.minStep[i] = minStep;
    l.trials[i] = 0;

    // Rises faster than any point can sink? Or is out of reach after the time
    // (R - h)/V.y, before which rise t - sink w^2 t^2/2 > 0 (of an ellipsoid:
    // another corner of a box may be sinking already)
    const bool fast = V.y*V.y > R*R*w2;
    const bool high = (!box) & (2*rise*V.y >= b.sink*w2*(R - h));
    l.status[i] = (V.y > 0) & (fast | high)
      ? smoothStatus::gone : smoothStatus::flies;
    const double first =
        stepAhead(0, std::sqrt(allowedDepth*R), rise, reach);
    l.tau[i] = larger(smaller(first, 8e10*minStep), minStep);
}


template<bool box>
impactInline void strike
(
    int n,
    const smoothBody& b,
    smoothLanes& __restrict__ l
)
{
    const vector3 J = {b.Ja, b.Jc, b.Jc};
    for (int i = 0; i < n; ++i)
    {
        const turning to(l, i, l.t[i] + l.tau[i]);
        const vector3 ex = to.of(get(l.ex, i));
        const vector3 ey = to.of(get(l.ey, i));
        const vector3 ez = cross(ex, ey);
        const vector3 w = to.aboutAxis(get(l.w, i));
        vector3 r;
        const double h = lowest<box>(b, ey, r);
        const vector3 V = l.V[0][i]*ex + l.V[1][i]*ey + l.V[2][i]*ez;
        const impactRecord hit = restitutionImpact
            (b.normal, b.tangential, J, r, ey, V, w);

        // A corner that grazes at the shortest step may depart already
        const double strikes = hit.approachSpeed > 0 ? 1. : 0.;
        const vector3 V2 = V + strikes*hit.dV;
        const vector3 w2 = w + strikes*hit.dOmega;
        const vector3 out = {dot(V2, ex), dot(V2, ey), dot(V2, ez)};
        const double rise =
            larger(b.normal*hit.approachSpeed, -hit.approachSpeed);
        l.approach[i] = hit.approachSpeed;
        l.pulling[i] = hit.pulling ? strikes : 0;
        l.gaining[i] = hit.gainsEnergy() ? strikes : 0;
        l.spinEnergy[i] = dot(multiply(J, w2), w2);
        put(l.ex, i, ex);
        put(l.ey, i, ey);
        put(l.w, i, w2);
        put(l.V, i, out);
        begin<box>(b, out, w2, h, rise, l, i);
    }
}


template<bool box>
impactInline void advance
(
    int n,
    const smoothBody& b,
    smoothLanes& __restrict__ l
)
{
    const double R = b.radius;
    const double tolerance = contactTolerance*R;
    const double allowed = allowedDepth*R;
    for (int i = 0; i < n; ++i)
    {
        const double tau = l.tau[i];
        const double t1 = l.t[i] + tau;
        const double Vy = l.V[1][i];
        const turning to(l, i, t1);
        const vector3 m = to.of(get(l.ey, i));
        const vector3 w = to.aboutAxis(get(l.w, i));
        vector3 r;
        const double h = lowest<box>(b, m, r);
        const double y1 = l.y[i] + Vy*t1;
        const double g0 = l.gap[i];
        const double g1 = y1 - h;
        const double rate1 = Vy + dot(m, cross(w, r));

        // See searchStep
        const double reach = l.reach[i];
        const double minStep = l.minStep[i];
        const double root0 = std::sqrt(g0 + allowed);
        const double above = positivePart(g1);
        const double root1 = std::sqrt(above + allowed);
        const bool pierced = pierces(g1, tolerance);
        const bool clear = isClear(pierced, root0, root1, reach, tau, minStep);
        const bool touches = clear & isContact(g1, rate1, tolerance);
        const bool strikes = touches | (pierced & (tau <= minStep));
        const bool gone = clear & (Vy > 0) & (y1 > R);
        const bool moves = clear & !touches;

        const double back =
            stepBack(tau, g0, g1, root0, rate1, reach, 1e-30*R);
        const double shorter = stepShorter(tau, root0, root1, reach);
        const double longer = stepAhead(above, root1, rate1, reach);
        const double next = pierced ? back : moves ? longer : shorter;
        const double trials = l.trials[i] + 1;
        const double wish = gone ? smoothStatus::gone
          : trials > manyTrials ? smoothStatus::lost : smoothStatus::flies;
        l.status[i] = strikes ? smoothStatus::strikes : wish;
        l.trials[i] = trials;
        l.t[i] = moves ? t1 : l.t[i];
        l.gap[i] = moves ? above : g0;
        l.tau[i] =
            strikes ? tau : larger(smaller(next, 8e10*minStep), minStep);
    }
}


template<orientationLaw law>
impactInline void arrive
(
    std::uint64_t seed,
    std::int64_t first,
    int n,
    const smoothBody& b,
    smoothLanes& __restrict__ l
)
{
    const vector3 spin = {b.spin[0], b.spin[1], b.spin[2]};
    const double V0 = b.V[0], V1 = b.V[1], V2 = b.V[2];

    // From axes x, y, z to those along and across the axis of symmetry
    const double f0 = b.axis == 0, f1 = b.axis == 1, f2 = b.axis == 2;
    auto ownAxes = [&](const vector3& v) __attribute__((always_inline))
    {
        return vector3
        {
            f0*v.x + f1*v.y + f2*v.z,
            f0*v.y + f1*v.z + f2*v.x,
            f0*v.z + f1*v.x + f2*v.y
        };
    };
    for (int i = 0; i < n; ++i)
    {
        const threeUnits u = threeUnits::drawn
            (seed, 0, drawPurpose::orientation, std::uint64_t(first + i));
        vector3 ex, ey;
        orient<law>(u.u0, u.u1, u.u2, ex, ey);
        ex = ownAxes(ex);
        ey = ownAxes(ey);
        put(l.ex, i, ex);
        put(l.ey, i, ey);
        put(l.w, i, spin.x*ex + spin.y*ey + spin.z*cross(ex, ey));
        l.V[0][i] = V0;
        l.V[1][i] = V1;
        l.V[2][i] = V2;
        l.t[i] = l.tau[i] = 0;
        l.rateL[i] = l.rateAxis[i] = 0;
        l.impacts[i] = 0;
    }
}

} // End anonymous namespace


namespace impact
{

impactKernel void smoothArrive
(
    bool isotropic,
    std::uint64_t seed,
    std::int64_t first,
    int n,
    const smoothBody& b,
    smoothLanes& l
)
{
    isotropic
  ? arrive<orientationLaw::isotropic>(seed, first, n, b, l)
  : arrive<orientationLaw::uniformEuler>(seed, first, n, b, l);
}


impactKernel void smoothImpact(int n, const smoothBody& b, smoothLanes& l)
{
    b.box ? strike<true>(n, b, l) : strike<false>(n, b, l);
}


impactKernel void smoothAdvance(int n, const smoothBody& b, smoothLanes& l)
{
    b.box ? advance<true>(n, b, l) : advance<false>(n, b, l);
}

} // End namespace impact
