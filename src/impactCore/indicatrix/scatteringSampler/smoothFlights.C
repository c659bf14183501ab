/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "vectorTargets.H"

#include "searchStep.H"
#include "smoothInline.H"

namespace
{

using namespace impact;

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
    const double tolerance = contactTolerance*R;
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

        // See searchStep
        const double reach = f.reach[i];
        const double least = f.least[i];
        const double longest = 8e10*least;
        const double root0 = f.root[i];
        const double above = positivePart(g1);
        const double root1 = std::sqrt(above);
        const bool pierced = pierces(g1, tolerance);
        const bool clear = isClear(pierced, root0, root1, reach, tau, least);
        const bool gone = clear & (f.V[1][i] > 0) & (y1 > R);
        if (decide)
        {
            const bool step = live & clear;
            const double longer = 1.9*reach*root1;
            const double trial =
                step ? larger(longer, least) : 0.5*tau;
            const double now = 2*(pierced ? 1. : 0.) + (gone ? 1. : 0.);
            f.status[i] = live ? now : before;
            f.ended[i] = int(live ? now : before);
            f.t[i] = t0 + (step ? tau : 0.);
            f.gap[i] = step ? above : g0;
            f.root[i] = step ? root1 : root0;
            f.tau[i] = larger(smaller(trial, longest), least);
        }
        else
        {
            double wx = f.w[0][i], wy = f.w[1][i], wz = f.w[2][i];
            turnAxis<axis>(s, c, wx, wy, wz);
            const double rate1 = f.V[1][i]
              + mx*(wy*rz - wz*ry) + my*(wz*rx - wx*rz)
              + mz*(wx*ry - wy*rx);
            const bool touches = clear & isContact(g1, rate1, tolerance);
            const bool strikes = touches | (pierced & (tau <= least));
            const bool step = live & clear & !touches;

            const double back =
                stepBack(tau, g0, g1, root0, rate1, reach, 1e-30*R);
            const double shorter = stepShorter(tau, root0, root1, reach);

            // A box no further than where it may strike
            const double newton = newtonStep(above, rate1);
            const bool sure = reaches(newton, rate1, reach, root1);
            const double ahead =
                stepAhead(above, root1, rate1, reach, 0.9);
            const double left = f.target[i] - t1 + (sure ? 1e300 : 0.);
            const double longer =
                (!ellipsoid) & (left > 0) & (left < ahead) ? left : ahead;
            const double trial =
                pierced ? back : step ? longer : shorter;

            // Newton's estimate is off by less than the tolerance: no need
            // to look
            const bool last = step & sure & (newton <= near*reach);
            const double now =
                2*(strikes | last ? 1. : 0.) + (gone & !last ? 1. : 0.);
            f.status[i] = live ? now : before;
            f.ended[i] = int(live ? now : before);
            f.t[i] = t0 + (step ? tau : 0.);
            f.gap[i] = step ? above : g0;
            f.root[i] = step ? root1 : root0;
            const double next = larger(smaller(trial, longest), least);
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
        const double t = l.end[i];
        sinCos(-t*L/across, s, c);
        turn(Lx, Ly, Lz, s, c, l.ex[0][i], l.ex[1][i], l.ex[2][i]);
        turn(Lx, Ly, Lz, s, c, l.ey[0][i], l.ey[1][i], l.ey[2][i]);
        sinCos(-t*spin*ratio, s, c);
        turnAxis<axis>(s, c, l.ex[0][i], l.ex[1][i], l.ex[2][i]);
        turnAxis<axis>(s, c, l.ey[0][i], l.ey[1][i], l.ey[2][i]);
        turnAxis<axis>(s, c, wx, wy, wz);
        l.w[0][i] = wx;
        l.w[1][i] = wy;
        l.w[2][i] = wz;
    }
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
        const double least = leastWay*R/(fastest + 1e-100);
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

} // End anonymous namespace


namespace impact
{

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


impactKernel void smoothTurn(int n, const smoothBody& b, smoothLanes& l)
{
    b.axis == 0 ? turnLanes<0>(n, b, l)
  : b.axis == 1 ? turnLanes<1>(n, b, l)
  : b.axis == 2 ? turnLanes<2>(n, b, l)
  : turnLanes<3>(n, b, l);
}

} // End namespace impact
