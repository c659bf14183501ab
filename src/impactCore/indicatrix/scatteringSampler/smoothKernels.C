/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "vectorTargets.H"

#include "smoothInline.H"

namespace
{

using namespace impact;

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
        put(ex, l.ex, i);
        put(ey, l.ey, i);
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


template<bool ellipsoid, bool box>
impactInline void cull
(
    int n,
    const smoothBody& b,
    bool decide,
    smoothLanes& __restrict__ l
)
{
    const int ifSinks = decide ? 0 : 1;
    const double R = b.radius;
    const double offset = b.offset;
    const double bend = b.bend;
    const vector3 a = {b.a[0], b.a[1], b.a[2]};
    const double bounce = ellipsoid ? b.normal : 0;
    for (int i = 0; i < n; ++i)
    {
        const vector3 w = at(l.w, i);
        const vector3 m = at(l.ey, i);
        const double w2 = dot(w, w);
        const double Vy = l.V[1][i];
        const double y = l.y[i];

        // Rises faster than any lowest point can sink; or is out of reach
        // after the time (R - y)/Vy, before which rise t - bend w^2 t^2/2 > 0
        // (of an ellipsoid: another corner of a polyhedron may be sinking
        // already)
        const double rise = bounce*l.approach[i];
        const double needed = bend*w2*(R - y);
        const bool gone = box
          ? boxLeaves(a, R, bend, 1e-9, y, Vy, w, m)
          : (Vy > 0)
          & ((Vy*Vy >= offset*offset*w2) | (2*rise*Vy >= needed));
        const int stays = gone ? 0 : 1;
        l.mayReturn[i] = Vy > 0 ? stays : ifSinks;
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
        const vector3 ex = at(l.ex, i);
        const vector3 n_ = at(l.ey, i);
        const vector3 ez = cross(ex, n_);
        const vector3 w = at(l.w, i);
        const vector3 r = at(l.r, i);
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
        put(w2, l.w, i);
    }
}


impactKernel void smoothRecord
(
    int from,
    int n,
    const smoothBody& b,
    const smoothLanes& __restrict__ l,
    int to,
    const smoothResults& results
)
{
    const double J0 = b.J[0], J1 = b.J[1], J2 = b.J[2];
    double* __restrict__ Vx = results.V[0] + to;
    double* __restrict__ Vy = results.V[1] + to;
    double* __restrict__ Vz = results.V[2] + to;
    double* __restrict__ spinEnergy = results.spinEnergy + to;
    for (int i = 0; i < n; ++i)
    {
        const vector3 w = at(l.w, from + i);
        Vx[i] = l.V[0][from + i];
        Vy[i] = l.V[1][from + i];
        Vz[i] = l.V[2][from + i];
        spinEnergy[i] = J0*w.x*w.x + J1*w.y*w.y + J2*w.z*w.z;
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


impactKernel void smoothCull
(
    int n,
    const smoothBody& b,
    bool decide,
    smoothLanes& l
)
{
    b.ellipsoid ? cull<true, false>(n, b, decide, l)
      : b.vertices ? cull<false, false>(n, b, decide, l)
      : cull<false, true>(n, b, decide, l);
}


impactKernel void smoothTouch(int n, const smoothBody& b, smoothLanes& l)
{
    touchAny(n, b, l);
}

} // End namespace impact
