/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "vectorTargets.H"

#include "smoothKernels.H"
#include "elementary.H"
#include "orientation.H"
#include "philoxLanes.H"

namespace
{

using namespace impact;

//- Lanes that are worked on together: short loops over a few of them, one
//  after the other, keep the arithmetic busy where one long loop would wait
//  for its own results
constexpr int lanesAtOnce = 64;

//- Attempts to bring a hop to its end before it is left to the search step by
//  step
constexpr double manyAttempts = 6;


//- Lowest point of the body, and its distance below the centre; m is the
//  laboratory axis y in body components
impactInline double lowest
(
    bool ellipsoid,
    double a0,
    double a1,
    double a2,
    double mx,
    double my,
    double mz,
    double& rx,
    double& ry,
    double& rz
)
{
    if (ellipsoid)
    {
        const double sx = a0*mx;
        const double sy = a1*my;
        const double sz = a2*mz;
        const double h = std::sqrt(sx*sx + sy*sy + sz*sz);
        const double f = -1/h;
        rx = f*a0*sx;
        ry = f*a1*sy;
        rz = f*a2*sz;
        return h;
    }
    rx = mx > 0 ? -a0 : a0;
    ry = my > 0 ? -a1 : a1;
    rz = mz > 0 ? -a2 : a2;
    return -(rx*mx + ry*my + rz*mz);
}


//- v turned about a unit vector k
impactInline void turn
(
    double kx,
    double ky,
    double kz,
    double s,
    double c,
    double& vx,
    double& vy,
    double& vz
)
{
    const double d = (1 - c)*(kx*vx + ky*vy + kz*vz);
    const double x = c*vx + s*(ky*vz - kz*vy) + d*kx;
    const double y = c*vy + s*(kz*vx - kx*vz) + d*ky;
    const double z = c*vz + s*(kx*vy - ky*vx) + d*kz;
    vx = x;
    vy = y;
    vz = z;
}


//- v turned about a body axis
template<int axis, class Real>
impactInline void turnAxis
(
    Real s,
    Real c,
    Real& vx,
    Real& vy,
    Real& vz
)
{
    if (axis == 0)
    {
        const Real y = c*vy - s*vz;
        vz = s*vy + c*vz;
        vy = y;
    }
    else if (axis == 1)
    {
        const Real z = c*vz - s*vx;
        vx = s*vz + c*vx;
        vz = z;
    }
    else if (axis == 2)
    {
        const Real x = c*vx - s*vy;
        vy = s*vx + c*vy;
        vx = x;
    }
}


template<orientationLaw law>
impactInline void arrive
(
    std::uint64_t seed,
    std::int64_t first,
    int n,
    const double* V,
    const double* spin,
    smoothLanes& __restrict__ l
)
{
    const double V0 = V[0], V1 = V[1], V2 = V[2];
    const double s0 = spin[0], s1 = spin[1], s2 = spin[2];
    for (int i = 0; i < n; ++i)
    {
        std::uint64_t w0, w1, w2, w3;
        philoxLane
        (
            seed, 0, drawPurpose::orientation, std::uint64_t(first + i),
            w0, w1, w2, w3
        );
        double u0, u1, u2;
        threeUnits(w0, w1, w2, w3, u0, u1, u2);
        vector3 ex, ey;
        orient<law>(u0, u1, u2, ex, ey);
        l.ex[0][i] = ex.x;
        l.ex[1][i] = ex.y;
        l.ex[2][i] = ex.z;
        l.ey[0][i] = ey.x;
        l.ey[1][i] = ey.y;
        l.ey[2][i] = ey.z;
        const vector3 ez = cross(ex, ey);
        l.w[0][i] = s0*ex.x + s1*ey.x + s2*ez.x;
        l.w[1][i] = s0*ex.y + s1*ey.y + s2*ez.y;
        l.w[2][i] = s0*ex.z + s1*ey.z + s2*ez.z;
        l.V[0][i] = V0;
        l.V[1][i] = V1;
        l.V[2][i] = V2;
        l.contacts[i] = 0;
    }
}


//- Contact points of the lanes
template<bool ellipsoid>
impactInline void touch(int n, const smoothBody& b, smoothLanes& __restrict__ l)
{
    const double a0 = b.a[0], a1 = b.a[1], a2 = b.a[2];
    for (int i = 0; i < n; ++i)
    {
        l.y[i] = lowest
        (
            ellipsoid, a0, a1, a2, l.ey[0][i], l.ey[1][i], l.ey[2][i],
            l.r[0][i], l.r[1][i], l.r[2][i]
        );
    }
}


impactInline void touchVertices
(
    int n,
    const smoothBody& b,
    smoothLanes& __restrict__ l
)
{
    const double* __restrict__ x = b.vertices;
    const double* __restrict__ y = x + b.nVertices;
    const double* __restrict__ z = y + b.nVertices;
    const int m = b.nVertices;
    for (int i = 0; i < n; ++i)
    {
        const double ex = l.ey[0][i], ey = l.ey[1][i], ez = l.ey[2][i];
        double low = 1e300, rx = 0, ry = 0, rz = 0;
        for (int k = 0; k < m; ++k)
        {
            const double h = ex*x[k] + ey*y[k] + ez*z[k];
            const bool lower = h < low;
            low = lower ? h : low;
            rx = lower ? x[k] : rx;
            ry = lower ? y[k] : ry;
            rz = lower ? z[k] : rz;
        }
        l.r[0][i] = rx;
        l.r[1][i] = ry;
        l.r[2][i] = rz;
        l.y[i] = -low;
    }
}


impactInline void touchAny(int n, const smoothBody& b, smoothLanes& l)
{
    if (b.ellipsoid)
    {
        touch<true>(n, b, l);
    }
    else if (!b.vertices)
    {
        touch<false>(n, b, l);
    }
    else
    {
        touchVertices(n, b, l);
    }
}


//- Change of the angular velocity of a body with the moments J per unit mass,
//  when the velocity of its point r changes by dVc: spinChange() of
//  reboundLaw.H, all over the product of the three pivots, which takes two
//  divisions instead of four
impactInline vector3 spinJump
(
    const vector3& J,
    const vector3& r,
    const vector3& dVc
)
{
    const double r2 = dot(r, r);
    const double dx = J.x + r2, dy = J.y + r2, dz = J.z + r2;
    const double px = dy*dz, py = dz*dx, pz = dx*dy;
    const double inverse = 1/(dx*px);
    const vector3 m = cross(r, dVc);
    const vector3 q = {px*m.x, py*m.y, pz*m.z};
    const vector3 d = {px*r.x, py*r.y, pz*r.z};
    const double rest = J.x*r.x*d.x + J.y*r.y*d.y + J.z*r.z*d.z;
    const double f = dot(r, q)*r2/rest;
    return
    {
        inverse*(q.x + f*d.x),
        inverse*(q.y + f*d.y),
        inverse*(q.z + f*d.z)
    };
}


//- What the loops of meetStill() hand on
struct drawScratch
{
    double u0[lanesAtOnce], u1[lanesAtOnce], u2[lanesAtOnce];
};


//- Arrival and first impact of bodies that do not turn before it. All of them
//  approach alike: with V the velocity and n the normal, the change of velocity
//  at the contact point is the same in laboratory components
template<orientationLaw law, bool ellipsoid>
impactInline void meetStill
(
    std::uint64_t seed,
    std::int64_t first,
    int n,
    const double* V,
    const smoothBody& b,
    smoothLanes& __restrict__ l
)
{
    const double a0 = b.a[0], a1 = b.a[1], a2 = b.a[2];
    const double J0 = b.J[0], J1 = b.J[1], J2 = b.J[2];
    const double V0 = V[0], V1 = V[1];
    const double along = (b.tangential - 1)*V0;
    const double away = -(1 + b.normal)*V1;
    const double meanAlong = V0 + 0.5*along;
    const double meanAway = V1 + 0.5*away;
    const double needed = 1e-12*0.5*(V0*V0 + V1*V1);
    drawScratch q_;
    for (int from = 0; from < n; from += lanesAtOnce)
    {
        const int m = n - from < lanesAtOnce ? n - from : lanesAtOnce;
        for (int j = 0; j < m; ++j)
        {
            std::uint64_t w0, w1, w2, w3;
            philoxLane
            (
                seed, 0, drawPurpose::orientation,
                std::uint64_t(first + from + j), w0, w1, w2, w3
            );
            double u0, u1, u2;
            threeUnits(w0, w1, w2, w3, u0, u1, u2);
            q_.u0[j] = u0;
            q_.u1[j] = u1;
            q_.u2[j] = u2;
        }
        for (int j = 0; j < m; ++j)
        {
            const int i = from + j;
            vector3 ex, ey;
            orient<law>(q_.u0[j], q_.u1[j], q_.u2[j], ex, ey);
            const vector3 ez = cross(ex, ey);
            vector3 r;
            l.y[i] = lowest
            (
                ellipsoid, a0, a1, a2, ey.x, ey.y, ey.z, r.x, r.y, r.z
            );
            const vector3 dVc = along*ex + away*ey;

            const vector3 w = spinJump({J0, J1, J2}, r, dVc);
            const vector3 lever = cross(w, r);
            const double dV0 = along - dot(lever, ex);
            const double dV1 = away - dot(lever, ey);
            const double dV2 = -dot(lever, ez);
            const double spin = J0*w.x*w.x + J1*w.y*w.y + J2*w.z*w.z;

            // Work of the impulse at the mean velocity of its point
            const double change = meanAlong*dV0 + meanAway*dV1;
            l.ex[0][i] = ex.x;
            l.ex[1][i] = ex.y;
            l.ex[2][i] = ex.z;
            l.ey[0][i] = ey.x;
            l.ey[1][i] = ey.y;
            l.ey[2][i] = ey.z;
            l.w[0][i] = w.x;
            l.w[1][i] = w.y;
            l.w[2][i] = w.z;
            l.V[0][i] = V0 + dV0;
            l.V[1][i] = V1 + dV1;
            l.V[2][i] = dV2;
            l.approach[i] = -V1;
            l.contacts[i] = 1;
            l.pulling[i] = dV1 < 0 ? 1. : 0.;
            l.gaining[i] = change > needed ? 1. : 0.;
            l.spinEnergy[i] = spin;
        }
    }
}


//- The same of a sphere, whose orientation is of no account
impactInline void meetSphere
(
    int n,
    const double* V,
    const smoothBody& b,
    smoothLanes& __restrict__ l
)
{
    // All alike: w = f r x dVc, r below the centre
    const double a = b.a[0], J = b.J[0];
    const double along = (b.tangential - 1)*V[0];
    const double away = -(1 + b.normal)*V[1];
    const double wz = a*along/(J + a*a);
    const double dV0 = along - wz*a, dV1 = away;
    const double change = V[0]*dV0 + V[1]*dV1
      + 0.5*(dV0*dV0 + dV1*dV1 + J*wz*wz);
    const double V0 = V[0] + dV0, V1 = V[1] + dV1;
    const double gaining =
        change > 1e-12*0.5*(V[0]*V[0] + V[1]*V[1]) ? 1. : 0.;
    const double approach = -V[1], pulling = dV1 < 0 ? 1. : 0.;
    const double spinEnergy = J*wz*wz;
    for (int i = 0; i < n; ++i)
    {
        l.ex[0][i] = 1;
        l.ex[1][i] = 0;
        l.ex[2][i] = 0;
        l.ey[0][i] = 0;
        l.ey[1][i] = 1;
        l.ey[2][i] = 0;
        l.y[i] = a;
        l.w[0][i] = 0;
        l.w[1][i] = 0;
        l.w[2][i] = wz;
        l.V[0][i] = V0;
        l.V[1][i] = V1;
        l.V[2][i] = 0;
        l.approach[i] = approach;
        l.contacts[i] = 1;
        l.pulling[i] = pulling;
        l.gaining[i] = gaining;
        l.spinEnergy[i] = spinEnergy;
    }
}


template<orientationLaw law>
impactInline void meetAny
(
    std::uint64_t seed,
    std::int64_t first,
    int n,
    const double* V,
    const smoothBody& b,
    smoothLanes& l
)
{
    if (b.axis == 3 && b.ellipsoid)
    {
        meetSphere(n, V, b, l);
    }
    else if (b.ellipsoid)
    {
        meetStill<law, true>(seed, first, n, V, b, l);
    }
    else
    {
        meetStill<law, false>(seed, first, n, V, b, l);
    }
}


template<int axis, bool ellipsoid, bool decide>
impactInline void advance
(
    int n,
    const smoothBody& b,
    smoothFlights& __restrict__ f
)
{
    const double a0 = b.a[0], a1 = b.a[1], a2 = b.a[2];
    const double R = b.radius;
    const double tolerance = 1e-11*R;
    const double near = std::sqrt(0.5*tolerance);
    for (int i = 0; i < n; ++i)
    {
        const double tau = f.tau[i];
        const double before = f.status[i];
        const bool live = before == 0;
        const double t0 = f.t[i];
        const double g0 = f.gap[i];
        const double t1 = t0 + tau;
        double mx = f.ey[0][i], my = f.ey[1][i], mz = f.ey[2][i];
        double s, c;
        sinCos(-f.rateL[i]*t1, s, c);
        turn(f.axisL[0][i], f.axisL[1][i], f.axisL[2][i], s, c, mx, my, mz);
        sinCos(-f.rateAxis[i]*t1, s, c);
        turnAxis<axis>(s, c, mx, my, mz);
        double rx, ry, rz;
        const double h =
            lowest(ellipsoid, a0, a1, a2, mx, my, mz, rx, ry, rz);
        const double y1 = f.y[i] + f.V[1][i]*t1;
        const double g1 = y1 - h;

        // As in wallVisit::search
        const double reach = f.reach[i];
        const double least = f.least[i];
        const double longest = 8e10*least;
        const double root0 = f.root[i];
        const double above = positivePart(g1);
        const double root1 = std::sqrt(above);
        const bool pierced = g1 < -tolerance;
        const bool shortest = tau <= least;
        const bool clear =
            ((root0 + root1)*reach > tau) | (!pierced & shortest);
        const bool gone = !pierced & clear & (f.V[1][i] > 0) & (y1 > R);
        if (decide)
        {
            const bool step = live & !pierced & clear;
            const double longer = 1.9*reach*root1;
            const double trial =
                step ? (longer > least ? longer : least) : 0.5*tau;
            const double now = 2*(pierced ? 1. : 0.) + (gone ? 1. : 0.);
            f.status[i] = live ? now : before;
            f.ended[i] = int(live ? now : before);
            f.t[i] = t0 + (step ? tau : 0.);
            f.gap[i] = step ? above : g0;
            f.root[i] = step ? root1 : root0;
            const double next = trial < longest ? trial : longest;
            f.tau[i] = next > least ? next : least;
        }
        else
        {
            double wx = f.w[0][i], wy = f.w[1][i], wz = f.w[2][i];
            turnAxis<axis>(s, c, wx, wy, wz);
            const double rate1 = f.V[1][i]
              + mx*(wy*rz - wz*ry) + my*(wz*rx - wx*rz)
              + mz*(wx*ry - wy*rx);
            const bool falling = rate1 < 0;
            const double inverse = -1/nonZero(std::fabs(rate1));
            const bool strikes =
                (pierced & shortest)
             | (!pierced & clear & falling & (g1 <= tolerance));
            const bool step = live & !pierced & clear & !strikes;

            // Pierced: Newton's step back, or the chord's, and not beyond
            // what is certain
            const double newton = (pierced ? g1 : above)*inverse;
            double back = tau - newton;
            const double chord =
                tau*g0/(std::fabs(g0 - g1) + 1e-30*R);
            back = falling & (back > 0) & (back < tau) ? back : chord;
            back = back > 0.01*tau ? back : 0.01*tau;
            const double certain = 0.999*reach*root0;
            const double cut = certain < 0.9*tau ? certain : 0.9*tau;
            back = (back >= reach*root0) & (root0 > 0) ? cut : back;
            back = back < 0.9999999*tau ? back : 0.9999999*tau;

            // Uncertain: a shorter step
            double shorter = 0.9*reach*(root0 + root1);
            shorter = shorter < 0.9*tau ? shorter : 0.9*tau;

            // Certain: on from there
            const double ahead =
                0.9*reach*(reach*rate1 + 2*root1);
            const bool sure = falling & (-newton < 0.99*reach*root1);
            const double left = f.target[i] - t1;
            const double hence =
                (!ellipsoid) & (left > 0) & (left < ahead) ? left : ahead;
            const double longer = sure ? -newton : hence;

            const double trial =
                pierced ? back : step ? longer : shorter;

            // Newton's estimate is off by less than the tolerance: no need
            // to look
            const bool last = step & sure & (-newton <= near*reach);
            const double now =
                2*(strikes | last ? 1. : 0.) + (gone & !last ? 1. : 0.);
            f.status[i] = live ? now : before;
            f.ended[i] = int(live ? now : before);
            f.t[i] = t0 + (step ? tau : 0.);
            f.gap[i] = step ? above : g0;
            f.root[i] = step ? root1 : root0;
            const double capped = trial < longest ? trial : longest;
            const double next = capped > least ? capped : least;
            f.tau[i] = strikes | !live ? tau : next;
        }
    }
}


template<bool ellipsoid, bool decide>
impactInline void advanceAxis(int n, const smoothBody& b, smoothFlights& f)
{
    b.axis == 0 ? advance<0, ellipsoid, decide>(n, b, f)
  : b.axis == 1 ? advance<1, ellipsoid, decide>(n, b, f)
  : b.axis == 2 ? advance<2, ellipsoid, decide>(n, b, f)
  : advance<3, ellipsoid, decide>(n, b, f);
}


template<int axis>
impactInline void turnLanes
(
    int n,
    const smoothBody& b,
    const double* __restrict__ t,
    smoothLanes& __restrict__ l
)
{
    const double J0 = b.J[0], J1 = b.J[1], J2 = b.J[2];
    const double across = axis == 0 ? J1 : J0;
    const double along = axis == 0 ? J0 : axis == 1 ? J1 : J2;
    const double ratio = axis < 3 ? 1 - along/across : 0;
    for (int i = 0; i < n; ++i)
    {
        double wx = l.w[0][i], wy = l.w[1][i], wz = l.w[2][i];
        double Lx = J0*wx, Ly = J1*wy, Lz = J2*wz;
        const double L = std::sqrt(Lx*Lx + Ly*Ly + Lz*Lz);
        const double f = 1/nonZero(L);
        Lx *= f;
        Ly *= f;
        Lz *= f;
        const double spin = axis == 0 ? wx : axis == 1 ? wy : wz;
        double s, c;
        sinCos(-t[i]*L/across, s, c);
        turn(Lx, Ly, Lz, s, c, l.ex[0][i], l.ex[1][i], l.ex[2][i]);
        turn(Lx, Ly, Lz, s, c, l.ey[0][i], l.ey[1][i], l.ey[2][i]);
        sinCos(-t[i]*spin*ratio, s, c);
        turnAxis<axis>(s, c, l.ex[0][i], l.ex[1][i], l.ex[2][i]);
        turnAxis<axis>(s, c, l.ey[0][i], l.ey[1][i], l.ey[2][i]);
        turnAxis<axis>(s, c, wx, wy, wz);
        l.w[0][i] = wx;
        l.w[1][i] = wy;
        l.w[2][i] = wz;
    }
}

template<bool ellipsoid, bool box>
impactInline int cull
(
    int n,
    const smoothBody& b,
    bool decide,
    smoothLanes& __restrict__ l
)
{
    const double ifSure = decide ? 0 : 1;
    int surely = 0;
    const double R = b.radius;
    const double offset = b.offset;
    const double bend = b.bend;
    const double a0 = b.a[0], a1 = b.a[1], a2 = b.a[2];
    const double bounce = ellipsoid ? b.normal : 0;
    for (int i = 0; i < n; ++i)
    {
        const double wx = l.w[0][i], wy = l.w[1][i], wz = l.w[2][i];
        const double mx = l.ey[0][i], my = l.ey[1][i], mz = l.ey[2][i];
        const double w2 = wx*wx + wy*wy + wz*wz;
        const double Vy = l.V[1][i];
        const double y = l.y[i];

        // Rises faster than any lowest point can sink; or is out of reach
        // after the time (R - y)/Vy, before which rise t - bend w^2 t^2/2 > 0
        // (of an ellipsoid: another corner of a box may be sinking already)
        const double rise = bounce*l.approach[i];
        const double needed = bend*w2*(R - y);

        // A box: with the normal m(t) in body components and m' = m x w, no
        // corner is lower than y + Vy t - h(m + t m') - bend w^2 t^2/2, h the
        // support of the box. This is concave in t and 0 at t = 0: if it is
        // positive when the body gets out of reach it was so before
        const double up = positivePart(Vy) + 1e-9*R*std::sqrt(w2);
        const double T = (R - y)/nonZero(up);
        const double depth =
            a0*std::fabs(mx + T*(my*wz - mz*wy))
          + a1*std::fabs(my + T*(mz*wx - mx*wz))
          + a2*std::fabs(mz + T*(mx*wy - my*wx));
        const bool clear = box & (R - depth > 0.5*bend*w2*T*T + 1e-9*R);
        const bool gone = (Vy > 0)
          & ((Vy*Vy >= offset*offset*w2) | (2*rise*Vy >= needed) | clear);
        const bool sinks = !(Vy > 0);
        const double stays = gone ? 0. : 1.;
        l.mayReturn[i] = sinks ? ifSure : stays;
        surely += sinks ? 1 : 0;
    }
    return decide ? surely : 0;
}

template<bool box>
impactInline void begin
(
    int from,
    int to,
    const smoothBody& b,
    smoothFlights& __restrict__ f
)
{
    const double J0 = b.J[0], J1 = b.J[1], J2 = b.J[2];
    const double across = b.axis == 0 ? J1 : J0;
    const double along = b.axis == 0 ? J0 : b.axis == 1 ? J1 : J2;
    const double ratio = b.axis == 3 ? 0 : 1 - along/across;
    const double along0 = b.axis == 0, along1 = b.axis == 1;
    const double along2 = b.axis == 2;
    const double R = b.radius;
    const double bend = b.bend;
    const double bounce = b.normal;
    const double a0 = b.a[0], a1 = b.a[1], a2 = b.a[2];
    for (int i = from; i < to; ++i)
    {
        const double wx = f.w[0][i], wy = f.w[1][i], wz = f.w[2][i];
        const double Lx = J0*wx, Ly = J1*wy, Lz = J2*wz;
        const double w2 = wx*wx + wy*wy + wz*wz;
        const double L = std::sqrt(Lx*Lx + Ly*Ly + Lz*Lz);
        const double unit = 1/nonZero(L);
        const double Vx = f.V[0][i], Vy = f.V[1][i];
        const double rise = bounce*f.approach[i];
        const double fastest =
            std::sqrt(Vx*Vx + Vy*Vy) + std::sqrt(w2)*R;
        const double bound =
            nonZero(bend*w2 + 1e-30*fastest*fastest/R);
        const double least = 1e-10*R/(fastest + 1e-100);
        f.axisL[0][i] = unit*Lx;
        f.axisL[1][i] = unit*Ly;
        f.axisL[2][i] = unit*Lz;
        f.rateL[i] = L/across;
        f.rateAxis[i] = ratio*(along0*wx + along1*wy + along2*wz);
        f.t[i] = 0;
        f.gap[i] = 0;
        f.root[i] = 0;
        f.reach[i] = std::sqrt(2/bound);
        f.least[i] = least;
        const double lift = 1.8*rise/bound;
        double first = lift < 8e10*least ? lift : 8e10*least;
        f.target[i] = 0;
        if (box)
        {
            // Were the normal m(t) in body components linear in time, with
            // m' = m x w, the height of the lowest corner were concave and
            // made of straight pieces: Newton from a later time finds where
            // it comes down to the wall
            const double mx = f.ey[0][i], my = f.ey[1][i], mz = f.ey[2][i];
            const double px = my*wz - mz*wy;
            const double py = mz*wx - mx*wz;
            const double pz = mx*wy - my*wx;
            const double y = f.y[i];
            const double slow = 1e-12*fastest + 1e-100;
            double t = 2/(std::sqrt(w2) + 1e-100);
            bool comes = true;
            #pragma GCC unroll 3
            for (int k = 0; k < 3; ++k)
            {
                const double qx = mx + t*px;
                const double qy = my + t*py;
                const double qz = mz + t*pz;
                const double sx = qx < 0 ? -a0 : a0;
                const double sy = qy < 0 ? -a1 : a1;
                const double sz = qz < 0 ? -a2 : a2;
                const double height = y + Vy*t - (sx*qx + sy*qy + sz*qz);
                const double fall = sx*px + sy*py + sz*pz - Vy;
                comes = comes & (height <= 0) & (fall > 0);
                t = t + height/(std::fabs(fall) + slow);
            }
            comes = comes & (t > 0) & (t < 8e10*least);
            f.target[i] = comes ? t : 0;

            const double half = 0.55*t;
            first = comes & (half < first) ? half : first;
        }
        f.tau[i] = first > least ? first : least;
        f.status[i] = 0;
    }
}

//- The rotation of a hop: with the angles theta = rate t of precession and
//  phi = rateAxis t about the axis of symmetry, the normal of the wall in
//  body components is A + B cos(theta) + C sin(theta), turned by -phi
struct hopRotation
{
    vector3 w, k, A, B, C;
    double rate, rateAxis;

    impactInline hopRotation
    (
        const vector3& spin,
        const vector3& normal,
        const double J[3],
        double ratio,
        double inverseAcross,
        int axis
    )
    {
        w = spin;
        const vector3 L = {J[0]*w.x, J[1]*w.y, J[2]*w.z};
        const double size = std::sqrt(dot(L, L));
        k = (1/nonZero(size))*L;
        rate = size*inverseAcross;
        rateAxis = axis == 3 ? 0 : ratio*(axis == 0 ? w.x : axis == 1 ? w.y
          : w.z);
        A = dot(k, normal)*k;
        B = normal - A;
        C = cross(normal, k);
    }

    impactInline vector3 before(double s, double c) const
    {
        return
        {
            A.x + (c*B.x + s*C.x), A.y + (c*B.y + s*C.y),
            A.z + (c*B.z + s*C.z)
        };
    }
};


//- Time derivative of the angular velocity w of a body that turns freely
template<int axis>
impactInline vector3 spinRate(double rateAxis, const vector3& w)
{
    return axis == 0 ? vector3{0, rateAxis*w.z, -rateAxis*w.y}
      : axis == 1 ? vector3{-rateAxis*w.z, 0, rateAxis*w.x}
      : axis == 2 ? vector3{rateAxis*w.y, -rateAxis*w.x, 0}
      : vector3{0, 0, 0};
}


//- Half sizes with the signs of the lowest corner's depth below the centre
impactInline vector3 signedHalf(const double a[3], const vector3& m)
{
    return
    {
        m.x < 0 ? -a[0] : a[0], m.y < 0 ? -a[1] : a[1],
        m.z < 0 ? -a[2] : a[2]
    };
}


//- Depth of the lowest corner of a box below its centre
impactInline double boxDepth(const double a[3], const vector3& m)
{
    return a[0]*std::fabs(m.x) + a[1]*std::fabs(m.y) + a[2]*std::fabs(m.z);
}


//- Step to the zero of g + r x + q x^2/2 next to x = 0, r < 0
impactInline double stepToZero(double g, double r, double q)
{
    // Halley's; never more than twice that of Newton
    const double r2 = r*r;
    const double rest = 2*r2 - g*q;
    return -2*g*r/(nonZero(rest > r2 ? rest : r2));
}


//- Guesses are made in single precision, of which twice as many fit a vector.
//  Lengths are measured by the radius, times by a time in which the body turns
//  by an angle of about 1 or less: no number overflows.
struct single3
{
    float x, y, z;
};

impactInline single3 operator+(const single3& a, const single3& b)
{
    return {a.x + b.x, a.y + b.y, a.z + b.z};
}

impactInline single3 operator-(const single3& a, const single3& b)
{
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}

impactInline single3 operator*(float s, const single3& a)
{
    return {s*a.x, s*a.y, s*a.z};
}

impactInline float dot(const single3& a, const single3& b)
{
    return a.x*b.x + a.y*b.y + a.z*b.z;
}

impactInline single3 cross(const single3& a, const single3& b)
{
    return
    {
        a.y*b.z - a.z*b.y, a.z*b.x - a.x*b.z, a.x*b.y - a.y*b.x
    };
}

//- As above
template<int axis>
impactInline single3 spinRate(float rateAxis, const single3& w)
{
    return axis == 0 ? single3{0, rateAxis*w.z, -rateAxis*w.y}
      : axis == 1 ? single3{-rateAxis*w.z, 0, rateAxis*w.x}
      : axis == 2 ? single3{rateAxis*w.y, -rateAxis*w.x, 0}
      : single3{0, 0, 0};
}

//- As above
impactInline single3 signedHalf(const single3& a, const single3& m)
{
    return
    {
        m.x < 0 ? -a.x : a.x, m.y < 0 ? -a.y : a.y, m.z < 0 ? -a.z : a.z
    };
}


//- What the loops of guess() hand on
struct hopScratch
{
    typedef float lane[lanesAtOnce];

    lane m[3], w[3];            // normal, angular velocity
    lane rate[3], bend[3];      // first two derivatives of the normal
    lane k[3];                  // unit angular momentum
    lane turn, turnAlong;       // rates of precession
    lane y, Vy, t, longest, slow, comes;
    double unit[lanesAtOnce];   // of time [s]

    impactInline single3 at(const lane x[3], int j) const
    {
        return {x[0][j], x[1][j], x[2][j]};
    }

    impactInline static void put(const single3& v, lane x[3], int j)
    {
        x[0][j] = v.x;
        x[1][j] = v.y;
        x[2][j] = v.z;
    }
};


//- What guess() needs to know of the body
struct hopBody
{
    single3 a, J;   // half sizes by radius, moments by that across the axis
    float ratio;
};


template<int axis>
impactInline void guessSetup
(
    int n,
    const hopBody& b,
    double R,
    const smoothHops& __restrict__ h,
    int from,
    hopScratch& __restrict__ q
)
{
    const double perRadius = 1/R;
    for (int j = 0; j < n; ++j)
    {
        const int i = from + j;
        const double rising = h.V[1][i]*perRadius;
        const double unit = 1/
        (
            std::fabs(h.w[0][i]) + std::fabs(h.w[1][i])
          + std::fabs(h.w[2][i]) + 1e-3*std::fabs(rising) + 1e-100
        );
        q.unit[j] = unit;
        q.y[j] = float(h.y[i]*perRadius);
        q.Vy[j] = float(rising*unit);
        q.w[0][j] = float(h.w[0][i]*unit);
        q.w[1][j] = float(h.w[1][i]*unit);
        q.w[2][j] = float(h.w[2][i]*unit);
        q.m[0][j] = float(h.ey[0][i]);
        q.m[1][j] = float(h.ey[1][i]);
        q.m[2][j] = float(h.ey[2][i]);
    }
    for (int j = 0; j < n; ++j)
    {
        const single3 m = q.at(q.m, j);
        const single3 w = q.at(q.w, j);
        const single3 L = {b.J.x*w.x, b.J.y*w.y, b.J.z*w.z};
        const float turn = std::sqrt(dot(L, L));
        const float turnAlong = axis == 3 ? 0.f
          : b.ratio*(axis == 0 ? w.x : axis == 1 ? w.y : w.z);
        const float turning = turn + std::fabs(turnAlong);
        const float longest = 2/(turning + 1e-6f);
        const single3 rate = cross(m, w);
        q.put((1/(turn + 1e-10f))*L, q.k, j);
        q.put(rate, q.rate, j);
        q.put
        (
            cross(rate, w) + cross(m, spinRate<axis>(turnAlong, w)),
            q.bend, j
        );
        q.turn[j] = turn;
        q.turnAlong[j] = turnAlong;
        q.t[j] = longest;
        q.longest[j] = longest;
        q.slow[j] = 1e-6f*(std::fabs(q.Vy[j]) + turning) + 1e-10f;
        q.comes[j] = 0;
    }
}


//- Were the normal m(t) in body components linear in time, with m' = m x w,
//  the height of the lowest corner were concave and made of straight pieces:
//  a step of Newton's from a later time towards where it comes down
impactInline void guessStraight
(
    int n,
    const hopBody& b,
    hopScratch& __restrict__ q
)
{
    for (int j = 0; j < n; ++j)
    {
        const float t = q.t[j];
        const single3 p = q.at(q.rate, j);
        const single3 m = q.at(q.m, j) + t*p;
        const single3 s = signedHalf(b.a, m);
        const float height = q.y[j] + q.Vy[j]*t - dot(s, m);
        const float fall = dot(s, p) - q.Vy[j];
        const float next = t + height/(std::fabs(fall) + q.slow[j]);
        q.t[j] = (height <= 0) & (fall > 0) & (next > 0) ? next : t;
    }
}


//- A step of Halley's towards the zero of a height with the derivatives
//  r and c, if it falls
impactInline void guessStep
(
    float g,
    float r,
    float c,
    int j,
    hopScratch& __restrict__ q
)
{
    const float t = q.t[j];
    const float r2 = r*r;
    const float rest = 2*r2 - g*c;
    const float next = t - 2*g*r/((rest > r2 ? rest : r2) + 1e-20f);
    const bool comes = (r < 0) & (next > 0) & (next < q.longest[j]);
    q.t[j] = comes ? next : t;
    q.comes[j] = comes ? 1.f : 0.f;
}


//- A step with the series of third degree of the normal
template<int axis>
impactInline void guessSeries
(
    int n,
    const hopBody& b,
    hopScratch& __restrict__ q
)
{
    for (int j = 0; j < n; ++j)
    {
        const float t = q.t[j];
        const single3 m0 = q.at(q.m, j);
        const single3 w = q.at(q.w, j);
        const single3 p = q.at(q.rate, j);
        const single3 c = q.at(q.bend, j);
        const float rateAxis = q.turnAlong[j];
        single3 d = cross(c, w);
        if (axis < 3)
        {
            const single3 dw = spinRate<axis>(rateAxis, w);
            d = d + cross(2*p, dw)
              + cross(m0, spinRate<axis>(rateAxis, dw));
        }
        const single3 td = t*d;
        const single3 bend = c + td;
        const single3 rate = p + t*(c + 0.5f*td);
        const single3 m = m0 + t*(p + (0.5f*t)*(c + (1.f/3)*td));
        const single3 half = signedHalf(b.a, m);
        guessStep
        (
            q.y[j] + q.Vy[j]*t - dot(half, m), q.Vy[j] - dot(half, rate),
            -dot(half, bend), j, q
        );
    }
}


//- A step with the rotation itself, in a series good to 1e-5
template<int axis>
impactInline void guessTurning
(
    int n,
    const hopBody& b,
    hopScratch& __restrict__ q
)
{
    for (int j = 0; j < n; ++j)
    {
        const float t = q.t[j];
        const float x = q.turn[j]*t, x2 = x*x;
        const float s = x*(1 - x2*(1.f/6 - x2*(1.f/120 - x2*(1.f/5040
          - x2*(1.f/362880)))));
        const float c = x2*(0.5f - x2*(1.f/24 - x2*(1.f/720
          - x2*(1.f/40320 - x2*(1.f/3628800)))));
        const single3 m0 = q.at(q.m, j);
        const single3 k = q.at(q.k, j);
        single3 m = m0 + s*cross(m0, k) - c*(m0 - dot(k, m0)*k);
        single3 w = q.at(q.w, j);
        const float rateAxis = q.turnAlong[j];
        if (axis < 3)
        {
            const float f = rateAxis*t, f2 = f*f;
            const float sf =
               -f*(1 - f2*(1.f/6 - f2*(1.f/120 - f2*(1.f/5040))));
            const float cf = 1 - f2*(0.5f - f2*(1.f/24 - f2*(1.f/720
              - f2*(1.f/40320))));
            turnAxis<axis>(sf, cf, m.x, m.y, m.z);
            turnAxis<axis>(sf, cf, w.x, w.y, w.z);
        }
        const single3 rate = cross(m, w);
        const single3 bend =
            cross(rate, w) + cross(m, spinRate<axis>(rateAxis, w));
        const single3 half = signedHalf(b.a, m);
        guessStep
        (
            q.y[j] + q.Vy[j]*t - dot(half, m), q.Vy[j] - dot(half, rate),
            -dot(half, bend), j, q
        );
    }
}


template<int axis>
impactInline void guess
(
    int from,
    int to,
    const smoothBody& b,
    bool decide,
    smoothHops& __restrict__ h
)
{
    const double R = b.radius;
    const double beyond = decide ? 1.03 : 1;
    const double across = axis == 0 ? b.J[1] : b.J[0];
    const double along = axis == 0 ? b.J[0] : axis == 1 ? b.J[1] : b.J[2];
    const hopBody s =
    {
        {float(b.a[0]/R), float(b.a[1]/R), float(b.a[2]/R)},
        {
            float(b.J[0]/across), float(b.J[1]/across), float(b.J[2]/across)
        },
        float(1 - along/across)
    };
    hopScratch q;
    for (int first = from; first < to; first += lanesAtOnce)
    {
        // Whole vectors: what lies behind the last hop is an old one, and
        // harmless
        const int rest = (to - first + 15) & ~15;
        const int n = rest < lanesAtOnce ? rest : lanesAtOnce;
        guessSetup<axis>(n, s, R, h, first, q);
        guessStraight(n, s, q);
        guessStraight(n, s, q);
        guessSeries<axis>(n, s, q);
        guessTurning<axis>(n, s, q);

        // Those that seem not to strike: until they are out of reach
        for (int j = 0; j < n; ++j)
        {
            const int i = first + j;
            const double t = double(q.t[j])*q.unit[j];
            const double longest = double(q.longest[j])*q.unit[j];
            const double Vy = h.V[1][i];
            const double out = (R - h.y[i])
               /(positivePart(Vy) + 1e-12*R/longest + 1e-100);
            const bool strikes = (q.comes[j] > 0) & (t < out);
            const double end = strikes ? beyond*t : out;

            // What turns far is not found clear all the way: half of it, or
            // less, at first
            const bool isFar = !decide & (end > 0.7*longest);
            const double part = 0.5*end < 0.45*longest ? 0.5*end : 0.45*longest;
            const double all = end < longest ? end : longest;
            h.t[i] = isFar ? part : all;
            h.seems[i] = strikes & !isFar ? 1. : 0.;
        }
    }
}


//- With m(t) the normal in body components, a body at y(t) is no lower than
//  y - H(m), H its support. Between 0 and t the cubic with the values and
//  rates of m at both ends is off by at most M u^2 (t - u)^2/24, M the largest
//  fourth derivative; H is convex: it is at most that at the five control
//  points of the cubic in Bernstein's form of fourth degree, weighted, and so
//  the height is positive if it is so at those points. Returns the least of
//  the middle three heights, of the last what it exceeds \c needed by.
impactInline double clearance
(
    const double a[3],
    double R,
    double y,
    double Vy,
    double t,
    double turning,
    const vector3& m0,
    const vector3& rate0,
    const vector3& m1,
    const vector3& rate1,
    double needed
)
{
    const double third = t*(1./3);
    const vector3 p1 = m0 + third*rate0;
    const vector3 p2 = m1 - third*rate1;
    const double x = turning*t, x2 = x*x;
    const double error = 1.0001*R*x2*x2*(1./144) + 1e-14*R;
    const vector3 c1 = 0.25*(m0 + 3*p1);
    const vector3 c2 = 0.5*(p1 + p2);
    const vector3 c3 = 0.25*(3*p2 + m1);
    const double h1 = y + 0.25*t*Vy - boxDepth(a, c1);
    const double h2 = y + 0.5*t*Vy - boxDepth(a, c2) - error;
    const double h3 = y + 0.75*t*Vy - boxDepth(a, c3) - needed;
    const double least = h1 < h2 ? h1 : h2;
    return least < h3 ? least : h3;
}


template<int axis, bool decide>
impactInline void land
(
    int n,
    const smoothBody& b,
    smoothHops& __restrict__ h,
    smoothLanes* __restrict__ l
)
{
    const double a[3] = {b.a[0], b.a[1], b.a[2]};
    const double J[3] = {b.J[0], b.J[1], b.J[2]};
    const double across = axis == 0 ? J[1] : J[0];
    const double along = axis == 0 ? J[0] : axis == 1 ? J[1] : J[2];
    const double ratio = 1 - along/across;
    const double inverse = 1/across;
    const double R = b.radius;
    const double tolerance = 1e-11*R;
    for (int i = 0; i < n; ++i)
    {
        const vector3 m0 = {h.ey[0][i], h.ey[1][i], h.ey[2][i]};
        const vector3 w0 = {h.w[0][i], h.w[1][i], h.w[2][i]};
        const double Vy = h.V[1][i];
        const double y = h.y[i];
        const double t = h.t[i];
        const hopRotation q(w0, m0, J, ratio, inverse, axis);
        const double turning = q.rate + std::fabs(q.rateAxis);

        double s, c, sf = 0, cf = 1;
        sinCos(q.rate*t, s, c);
        vector3 m = q.before(s, c);
        vector3 w = w0;
        if (axis < 3)
        {
            sinCos(-q.rateAxis*t, sf, cf);
            turnAxis<axis>(sf, cf, m.x, m.y, m.z);
            turnAxis<axis>(sf, cf, w.x, w.y, w.z);
        }
        const vector3 rate = cross(m, w);
        const vector3 half = signedHalf(a, m);
        const double g = y + Vy*t - dot(half, m);
        const double r = Vy - dot(half, rate);
        const bool seems = h.seems[i] > 0;

        // The bound must not vanish much before the height does
        const double needed = seems ? 0.125*t*positivePart(-r) : 0;
        const bool clear =
            clearance
            (
                a, R, y, Vy, t, turning, m0, cross(m0, w0), m, rate, needed
            ) > 0;
        const bool out = (Vy > 0) & (y + Vy*t >= 0.999999999*R);
        const bool gone = clear & out & (g > tolerance);
        if (decide)
        {
            const bool pierced = seems & (g < -10*tolerance);
            h.outcome[i] = hopOutcome::gone*(gone ? 1. : 0.)
              + hopOutcome::strikes*(pierced ? 1. : 0.);
        }
        else
        {
            // To the contact itself, if it is so close that the series of
            // second degree is exact, and no corner can change its place with
            // another
            const vector3 dw = spinRate<axis>(q.rateAxis, w);
            const vector3 bend = cross(rate, w) + cross(m, dw);
            const double step = stepToZero(g, r, -dot(half, bend));
            const double angle = std::fabs(step)*turning;
            const double edge = 4*R*angle + tolerance;
            const bool single =
                (a[0]*std::fabs(m.x) > edge) & (a[1]*std::fabs(m.y) > edge)
              & (a[2]*std::fabs(m.z) > edge);
            const double end = t + step;
            const bool falls = seems & (r < 0) & (end > 0);
            const bool close = angle < 3e-5;
            const bool strikes = falls & clear & single & close;
            const bool nearly =
                falls & (angle < 0.5) & !strikes & (clear | !close);
            const bool still = clear & !seems & !gone & (g > 1e3*tolerance);

            // What else is left is looked at half as far
            const bool more = h.attempts[i] < manyAttempts;
            const bool again = !(strikes | gone | still);
            h.outcome[i] = hopOutcome::gone*(gone ? 1. : 0.)
              + hopOutcome::strikes*(strikes ? 1. : 0.)
              + hopOutcome::again*(again & more ? 1. : 0.)
              + hopOutcome::clear*(still & more ? 1. : 0.);
            h.attempts[i] += 1;
            h.seems[i] = nearly ? 1. : 0.;
            h.t[i] = nearly ? end : 0.5*t;

            const double d = strikes ? step : 0;
            const double d2 = 0.5*d*d;
            const vector3 e0 = {h.ex[0][i], h.ex[1][i], h.ex[2][i]};
            const vector3 Ae = dot(q.k, e0)*q.k;
            const vector3 Be = e0 - Ae;
            const vector3 Ce = cross(e0, q.k);
            vector3 e = Ae + (c*Be + s*Ce);
            turnAxis<axis>(sf, cf, e.x, e.y, e.z);
            const vector3 eRate = cross(e, w);
            const vector3 eBend = cross(eRate, w) + cross(e, dw);
            const vector3 e1 = e + (d*eRate + d2*eBend);
            const vector3 m1 = m + (d*rate + d2*bend);
            const vector3 dw2 = spinRate<axis>(q.rateAxis, dw);
            const vector3 w1 = w + (d*dw + d2*dw2);
            const bool moves = strikes | still;
            h.ex[0][i] = moves ? e1.x : e0.x;
            h.ex[1][i] = moves ? e1.y : e0.y;
            h.ex[2][i] = moves ? e1.z : e0.z;
            h.ey[0][i] = moves ? m1.x : m0.x;
            h.ey[1][i] = moves ? m1.y : m0.y;
            h.ey[2][i] = moves ? m1.z : m0.z;
            h.w[0][i] = moves ? w1.x : w0.x;
            h.w[1][i] = moves ? w1.y : w0.y;
            h.w[2][i] = moves ? w1.z : w0.z;
            const double y1 = strikes ? dot(half, m1) : y + Vy*t;
            h.y[i] = moves ? y1 : y;
            l->r[0][i] = -half.x;
            l->r[1][i] = -half.y;
            l->r[2][i] = -half.z;
        }
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
    const double V[3],
    const double spin[3],
    const smoothBody& b,
    smoothLanes& l
)
{
    if (isotropic)
    {
        arrive<orientationLaw::isotropic>(seed, first, n, V, spin, l);
    }
    else
    {
        arrive<orientationLaw::uniformEuler>(seed, first, n, V, spin, l);
    }
    touchAny(n, b, l);
}


impactKernel void smoothMeet
(
    bool isotropic,
    std::uint64_t seed,
    std::int64_t first,
    int n,
    const double V[3],
    const smoothBody& b,
    smoothLanes& l
)
{
    if (isotropic)
    {
        meetAny<orientationLaw::isotropic>(seed, first, n, V, b, l);
    }
    else
    {
        meetAny<orientationLaw::uniformEuler>(seed, first, n, V, b, l);
    }
}


impactKernel void smoothImpact
(
    int n,
    const smoothBody& b,
    smoothLanes& __restrict__ l
)
{
    const double J0 = b.J[0], J1 = b.J[1], J2 = b.J[2];
    const double tangent = b.tangential - 1;
    const double bounce = b.normal + b.tangential;
    for (int i = 0; i < n; ++i)
    {
        const vector3 ex = {l.ex[0][i], l.ex[1][i], l.ex[2][i]};
        const vector3 n_ = {l.ey[0][i], l.ey[1][i], l.ey[2][i]};
        const vector3 ez = cross(ex, n_);
        const vector3 w = {l.w[0][i], l.w[1][i], l.w[2][i]};
        const vector3 r = {l.r[0][i], l.r[1][i], l.r[2][i]};
        const vector3 V =
            l.V[0][i]*ex + l.V[1][i]*n_ + l.V[2][i]*ez;

        const vector3 Vc = V + cross(w, r);
        const double vn = dot(Vc, n_);
        const vector3 dVc = tangent*Vc - (bounce*vn)*n_;

        const vector3 dw = spinJump({J0, J1, J2}, r, dVc);
        const vector3 dV = dVc - cross(dw, r);

        // Work of the impulse at the mean velocity of its point
        const double change = dot(Vc + 0.5*dVc, dV);
        const double before = 0.5
           *(dot(V, V) + J0*w.x*w.x + J1*w.y*w.y + J2*w.z*w.z);
        l.approach[i] = -vn;
        l.contacts[i] += 1;
        l.pulling[i] = dot(dV, n_) < 0 ? 1. : 0.;
        l.gaining[i] = change > 1e-12*before ? 1. : 0.;

        const vector3 V2 = V + dV;
        l.V[0][i] = dot(V2, ex);
        l.V[1][i] = dot(V2, n_);
        l.V[2][i] = dot(V2, ez);
        const vector3 w2 = w + dw;
        l.w[0][i] = w2.x;
        l.w[1][i] = w2.y;
        l.w[2][i] = w2.z;
        l.spinEnergy[i] = J0*w2.x*w2.x + J1*w2.y*w2.y + J2*w2.z*w2.z;
    }
}


impactKernel void smoothTally
(
    int n,
    double small,
    const smoothLanes& __restrict__ l,
    int* counts
)
{
    int large = 0, pulling = 0, gaining = 0, into = 0;
    for (int i = 0; i < n; ++i)
    {
        large += l.approach[i] > small ? 1 : 0;
        pulling += l.pulling[i] > 0 ? 1 : 0;
        gaining += l.gaining[i] > 0 ? 1 : 0;
        into += l.V[1][i] <= 0 ? 1 : 0;
    }
    counts[0] = large;
    counts[1] = pulling;
    counts[2] = gaining;
    counts[3] = into;
}


impactKernel int smoothCull
(
    int n,
    const smoothBody& b,
    bool decide,
    smoothLanes& l
)
{
    return b.ellipsoid ? cull<true, false>(n, b, decide, l)
      : b.vertices ? cull<false, false>(n, b, decide, l)
      : cull<false, true>(n, b, decide, l);
}


impactKernel void smoothGuess
(
    int from,
    int to,
    const smoothBody& b,
    bool decide,
    smoothHops& h
)
{
    b.axis == 0 ? guess<0>(from, to, b, decide, h)
  : b.axis == 1 ? guess<1>(from, to, b, decide, h)
  : b.axis == 2 ? guess<2>(from, to, b, decide, h)
  : guess<3>(from, to, b, decide, h);
}


impactKernel void smoothLand
(
    int n,
    const smoothBody& b,
    smoothHops& h,
    smoothLanes& l
)
{
    b.axis == 0 ? land<0, false>(n, b, h, &l)
  : b.axis == 1 ? land<1, false>(n, b, h, &l)
  : b.axis == 2 ? land<2, false>(n, b, h, &l)
  : land<3, false>(n, b, h, &l);
}


impactKernel void smoothDecide(int n, const smoothBody& b, smoothHops& h)
{
    b.axis == 0 ? land<0, true>(n, b, h, nullptr)
  : b.axis == 1 ? land<1, true>(n, b, h, nullptr)
  : b.axis == 2 ? land<2, true>(n, b, h, nullptr)
  : land<3, true>(n, b, h, nullptr);
}


impactKernel void smoothLaunch
(
    int from,
    int to,
    const smoothBody& b,
    smoothFlights& f
)
{
    b.ellipsoid ? begin<false>(from, to, b, f) : begin<true>(from, to, b, f);
}


impactKernel void smoothAdvance
(
    int n,
    const smoothBody& b,
    bool decide,
    smoothFlights& f
)
{
    if (b.ellipsoid)
    {
        decide ? advanceAxis<true, true>(n, b, f)
          : advanceAxis<true, false>(n, b, f);
    }
    else
    {
        decide ? advanceAxis<false, true>(n, b, f)
          : advanceAxis<false, false>(n, b, f);
    }
}


impactKernel void smoothTurn
(
    int n,
    const smoothBody& b,
    const double* t,
    smoothLanes& l
)
{
    b.axis == 0 ? turnLanes<0>(n, b, t, l)
  : b.axis == 1 ? turnLanes<1>(n, b, t, l)
  : b.axis == 2 ? turnLanes<2>(n, b, t, l)
  : turnLanes<3>(n, b, t, l);
    touchAny(n, b, l);
}

} // End namespace impact
