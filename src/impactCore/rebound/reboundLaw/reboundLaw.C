/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "reboundLaw.H"
#include "elementary.H"

#include <algorithm>
#include <sstream>
#include <stdexcept>

namespace
{

using impact::vector3;

void checkRange
(
    const char* name,
    double value,
    double low,
    double high,
    const char* range
)
{
    if (!(value >= low && value <= high))
    {
        std::ostringstream text;
        text<< name << ' ' << value << ": valid range " << range;
        throw std::invalid_argument(text.str());
    }
}


//- Change of the contact point's velocity for an impulse S at it
vector3 response
(
    const vector3& inertia,
    const vector3& r,
    const vector3& S
)
{
    const vector3 m = cross(r, S);
    const vector3 dOmega =
        {m.x/inertia.x, m.y/inertia.y, m.z/inertia.z};
    return S + cross(dOmega, r);
}

} // End anonymous namespace


impact::reboundLaw::reboundLaw
(
    lawType law,
    double normal,
    double tangential,
    double friction
)
:
    law_(law),
    normal_(normal),
    tangential_(tangential),
    friction_(friction)
{}


impact::reboundLaw impact::reboundLaw::restitution
(
    double normal,
    double tangential
)
{
    checkRange("normal", normal, 0, 1, "[0, 1]");
    checkRange("tangential", tangential, -1, 1, "[-1, 1]");
    return reboundLaw(lawType::restitution, normal, tangential, 0);
}


impact::reboundLaw impact::reboundLaw::coulomb
(
    double restitution,
    double friction
)
{
    checkRange("restitution", restitution, 0, 1, "[0, 1]");
    checkRange("friction", friction, 0, 1e6, "[0, 1e6]");
    return reboundLaw(lawType::friction, restitution, 0, friction);
}


impact::vector3 impact::reboundLaw::frictionImpulse
(
    const vector3& inertia,
    const vector3& r,
    const vector3& n,
    const vector3& Vc0
) const
{
    // The normal impulse p is the independent variable:
    //     dVc/dp = K (n - mu s),  dW/dp = n.Vc,  s = sliding direction
    const double mu = friction_;
    const double e2 = normal_*normal_;
    auto K = [&](const vector3& S) { return response(inertia, r, S); };
    auto tangent = [&](const vector3& v) { return v - dot(v, n)*n; };

    const double speed0 = mag(Vc0);
    const vector3 Kn = K(n);
    vector3 Vc = Vc0;
    vector3 S = {0, 0, 0};
    double work = 0;            // of the normal force so far
    double compression = 0;     // its value when the approach stopped
    bool restituting = false;

    // Follow a constant direction of the impulse to the end of the impact
    auto finish = [&](const vector3& direction)
    {
        const double a = dot(K(direction), n);
        double v = dot(Vc, n);
        double rest = 0;        // work still to be given back
        if (restituting)
        {
            rest = compression*(1 - e2) - work;
        }
        else
        {
            const double p = -v/a;
            S = S + p*direction;
            rest = -e2*(work + 0.5*v*p);
            v = 0;
        }
        // v p + a p^2/2 = rest
        S = S
          + ((std::sqrt(std::max(0., v*v + 2*a*rest)) - v)/a)*direction;
        return S;
    };
    if (mu == 0)
    {
        return finish(n);
    }

    // Direction of the impulse, per unit of its normal part, of a contact
    // that does not slide at the moment
    auto restDirection = [&]
    {
        vector3 t1 = std::fabs(n.x) < 0.6
            ? cross(n, vector3{1, 0, 0}) : cross(n, vector3{0, 1, 0});
        t1 = (1/mag(t1))*t1;
        const vector3 t2 = cross(n, t1);

        // It stays at rest if the cone holds the T of tangent(K(n + T)) = 0
        const vector3 K1 = K(t1), K2 = K(t2);
        const double k11 = dot(t1, K1), k12 = dot(t1, K2), k22 = dot(t2, K2);
        const double f1 = dot(t1, Kn), f2 = dot(t2, Kn);
        const double det = k11*k22 - k12*k12;
        const double T1 = (k12*f2 - k22*f1)/det;
        const double T2 = (k12*f1 - k11*f2)/det;
        if (T1*T1 + T2*T2 <= mu*mu)
        {
            return n + T1*t1 + T2*t2;
        }
        // Else it slides off in the direction s that it keeps:
        // tangent(K(n - mu s)) parallel to s, the root of fastest growth
        auto turning = [&](double angle, double& growth)
        {
            double s, c;
            sinCos(angle, s, c);
            const double v1 = f1 - mu*(k11*c + k12*s);
            const double v2 = f2 - mu*(k12*c + k22*s);
            growth = c*v1 + s*v2;
            return c*v2 - s*v1;
        };
        const double pi = 3.141592653589793;
        const int parts = 64;
        double best = 0, fastest = -1, growth;
        double last = turning(0, growth);
        for (int i = 0; i < parts; ++i)
        {
            double lo = 2*pi*i/parts, hi = 2*pi*(i + 1)/parts;
            const double value = turning(hi, growth);
            if ((last > 0) != (value > 0))
            {
                for (int k = 0; k < 52; ++k)
                {
                    const double mid = 0.5*(lo + hi);
                    ((turning(mid, growth) > 0) == (last > 0) ? lo : hi)
                        = mid;
                }
                turning(lo, growth);
                if (growth > fastest)
                {
                    fastest = growth;
                    best = lo;
                }
            }
            last = value;
        }
        double s, c;
        sinCos(best, s, c);
        return n - mu*(c*t1 + s*t2);
    };

    auto direction = [&](const vector3& v)
    {
        const vector3 t = tangent(v);
        const double m = mag(t);
        return m > 0 ? n - (mu/m)*t : n;
    };

    // Sliding: Runge-Kutta of fourth order in p
    const double unit = speed0/dot(Kn, n);
    for (int step = 0; step < 100000; ++step)
    {
        const vector3 t = tangent(Vc);
        const double slip = mag(t);
        if (slip <= 1e-10*speed0)
        {
            return finish(restDirection());
        }
        const vector3 d1 = direction(Vc);
        const vector3 change = tangent(K(d1));
        const vector3 along = (dot(change, t)/(slip*slip))*t;

        // A step turns the slip by 0.02 at most, and does not reverse it
        double p = 0.02*unit;
        p = std::min(p, 0.3*slip/(mag(along) + 1e-300));
        p = std::min(p, 0.02*slip/(mag(change - along) + 1e-300));

        vector3 dS, next;
        double dWork = 0;
        auto advance = [&](double h)
        {
            const vector3 d2 = direction(Vc + (0.5*h)*K(d1));
            const vector3 middle = Vc + (0.5*h)*K(d2);
            const vector3 d3 = direction(middle);
            const vector3 d4 = direction(Vc + h*K(d3));
            dS = (h/6)*(d1 + 2*d2 + 2*d3 + d4);
            next = Vc + K(dS);
            dWork = (h/6)*(dot(Vc, n) + 4*dot(middle, n) + dot(next, n));
        };
        // Does compression, or restitution, end within the step?
        auto past = [&]
        {
            return restituting
              ? work + dWork >= compression*(1 - e2)
              : dot(next, n) >= 0;
        };
        advance(p);
        const bool ends = past();
        if (ends)
        {
            double lo = 0, hi = p;
            for (int k = 0; k < 54; ++k)
            {
                const double mid = 0.5*(lo + hi);
                advance(mid);
                (past() ? hi : lo) = mid;
            }
            advance(hi);
        }
        S = S + dS;
        work += dWork;
        Vc = next;
        if (ends && (restituting || normal_ == 0))
        {
            return S;
        }
        if (ends)
        {
            restituting = true;
            compression = work;
        }
        else if (restituting && dot(Vc, n) < 0)
        {
            restituting = false;    // pressed on again while it slides
        }
    }
    return S;
}


impact::impactRecord impact::reboundLaw::impact
(
    const vector3& inertia,
    const vector3& r,
    const vector3& n,
    const vector3& V,
    const vector3& omega
) const
{
    const vector3 Vc = V + cross(omega, r);
    const double vn = dot(Vc, n);

    impactRecord out;
    if (law_ == lawType::restitution)
    {
        const vector3 dVc =
            (tangential_ - 1)*Vc - ((normal_ + tangential_)*vn)*n;
        out.dOmega = spinChange(inertia, r, dVc);
        out.dV = dVc - cross(out.dOmega, r);
    }
    else
    {
        out.dV = frictionImpulse(inertia, r, n, Vc);
        const vector3 m = cross(r, out.dV);
        out.dOmega = {m.x/inertia.x, m.y/inertia.y, m.z/inertia.z};
    }
    out.approachSpeed = -vn;
    const vector3 spin = multiply(inertia, omega);
    const vector3 dSpin = multiply(inertia, out.dOmega);
    out.energyBefore = 0.5*(dot(V, V) + dot(omega, spin));
    out.energyChange =
        dot(V, out.dV) + 0.5*dot(out.dV, out.dV)
      + dot(omega, dSpin) + 0.5*dot(out.dOmega, dSpin);
    out.pulling = dot(out.dV, n) < 0;
    return out;
}
