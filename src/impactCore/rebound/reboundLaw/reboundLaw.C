/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "reboundLaw.H"

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
    auto K = [&](const vector3& S) { return response(inertia, r, S); };
    auto tangent = [&](const vector3& v) { return v - dot(v, n)*n; };

    const double speed0 = mag(Vc0);
    const double still = 1e-11*speed0;
    const vector3 Kn = K(n);
    vector3 Vc = Vc0;
    vector3 S = {0, 0, 0};
    double work = 0;            // of the normal force so far
    double compression = 0;     // its value when the approach stopped
    bool restituting = dot(Vc, n) >= 0;

    // Impulse direction, per unit of normal impulse, of a contact at rest
    auto restDirection = [&](bool& sticks)
    {
        // Tangential impulse T that keeps the contact at rest:
        // tangent(K(n + T)) = 0, two equations in the plane
        vector3 e1 = std::fabs(n.x) < 0.6
            ? cross(n, vector3{1, 0, 0}) : cross(n, vector3{0, 1, 0});
        e1 = (1/mag(e1))*e1;
        const vector3 e2 = cross(n, e1);
        const vector3 K1 = K(e1), K2 = K(e2);
        const double a = dot(e1, K1), b = dot(e1, K2), d = dot(e2, K2);
        const double f1 = -dot(e1, Kn), f2 = -dot(e2, Kn);
        const double det = a*d - b*b;
        const double t1 = (d*f1 - b*f2)/det;
        const double t2 = (a*f2 - b*f1)/det;
        sticks = std::sqrt(t1*t1 + t2*t2) <= mu;
        if (sticks)
        {
            return n + t1*e1 + t2*e2;
        }
        // Slip starts along the direction s with tangent(K(n - mu s))
        // parallel to s: Newton on the angle, from the direction of slip
        // without friction. The residual has one root of outward slip.
        const double start = std::atan2(dot(e2, Kn), dot(e1, Kn));
        double best = start;
        auto residual = [&](double angle, double& outward)
        {
            const double c = std::cos(angle), s = std::sin(angle);
            const vector3 along = c*e1 + s*e2;
            const vector3 v = Kn - mu*K(along);
            outward = c*dot(e1, v) + s*dot(e2, v);
            return -s*dot(e1, v) + c*dot(e2, v);
        };
        double outward = 0, largest = -1;
        const int parts = 90;
        double last = residual(start, outward);
        for (int i = 1; i <= parts; ++i)
        {
            const double high = start + 2*M_PI*i/parts;
            const double value = residual(high, outward);
            if ((last > 0) != (value > 0))
            {
                double lo = high - 2*M_PI/parts, hi = high;
                for (int k = 0; k < 52; ++k)
                {
                    const double mid = 0.5*(lo + hi);
                    ((residual(mid, outward) > 0) == (last > 0) ? lo : hi)
                        = mid;
                }
                residual(lo, outward);
                if (outward > largest)
                {
                    largest = outward;
                    best = lo;
                }
            }
            last = value;
        }
        return n - mu*(std::cos(best)*e1 + std::sin(best)*e2);
    };

    // Follow a constant impulse direction to the end of the impact
    auto finish = [&](const vector3& direction)
    {
        const vector3 k = K(direction);
        const double a = dot(k, n);
        double v = dot(Vc, n);
        if (!restituting)
        {
            // Stop the approach: a > 0 in the rest and the slip directions
            const double p = -v/a;
            S = S + p*direction;
            work += v*p + 0.5*a*p*p;
            v = 0;
            compression = work;
        }
        // v p + a p^2/2 = target
        const double target =
            std::max(0., -normal_*normal_*compression
          - (restituting ? work - compression : 0));
        S = S + ((std::sqrt(v*v + 2*a*target) - v)/a)*direction;
    };

    if (mag(tangent(Vc)) <= still || mu == 0)
    {
        bool sticks = true;
        finish(mu == 0 ? n : restDirection(sticks));
        return S;
    }

    // Sliding: fourth-order Runge-Kutta in p with steps that turn the
    // sliding velocity by a small angle at most
    const double scaleP = speed0/dot(Kn, n);
    auto rate = [&](const vector3& v)
    {
        const vector3 t = tangent(v);
        const double m = mag(t);
        return m > 0 ? K(n - (mu/m)*t) : Kn;
    };
    for (int step = 0; step < 100000; ++step)
    {
        const vector3 t = tangent(Vc);
        const double slip = mag(t);
        const double v = dot(Vc, n);
        const vector3 k1 = rate(Vc);
        const double acceleration = mag(tangent(k1));
        const vector3 s = (1/slip)*t;
        const vector3 across =
            tangent(k1) - dot(tangent(k1), s)*s;

        // A step that neither turns nor shortens the slip much, in units of p
        double p = 0.02*scaleP;
        if (acceleration > 0)
        {
            p = std::min(p, 0.25*slip/acceleration);
        }
        if (mag(across) > 0)
        {
            p = std::min(p, 0.02*slip/mag(across));
        }
        auto advance = [&](double h, vector3& dS, double& dWork)
        {
            const vector3 r2 = rate(Vc + (0.5*h)*k1);
            const vector3 r3 = rate(Vc + (0.5*h)*r2);
            const vector3 r4 = rate(Vc + h*r3);
            const vector3 next =
                Vc + (h/6)*(k1 + 2*r2 + 2*r3 + r4);
            // The impulse that makes this change of velocity is recovered
            // from its own rate n - mu s with the same weights
            auto dir = [&](const vector3& w)
            {
                const vector3 tw = tangent(w);
                const double m = mag(tw);
                return m > 0 ? n - (mu/m)*tw : n;
            };
            dS = (h/6)
               *(
                    dir(Vc) + 2*dir(Vc + (0.5*h)*k1)
                  + 2*dir(Vc + (0.5*h)*r2) + dir(Vc + h*r3)
                );
            dWork = (h/6)
               *(
                    v + 4*dot(Vc + (0.5*h)*r2, n) + dot(next, n)
                );
            return next;
        };

        vector3 dS;
        double dWork;
        vector3 next = advance(p, dS, dWork);

        // The end of compression, then of restitution, inside this step?
        auto past = [&](const vector3& vNext, double dw)
        {
            return restituting
              ? work + dw - compression
             >= -normal_*normal_*compression
              : dot(vNext, n) >= 0;
        };
        if (past(next, dWork))
        {
            double lo = 0, hi = p;
            for (int k = 0; k < 60 && hi - lo > 1e-16*scaleP; ++k)
            {
                const double mid = 0.5*(lo + hi);
                next = advance(mid, dS, dWork);
                (past(next, dWork) ? hi : lo) = mid;
            }
            next = advance(hi, dS, dWork);
            S = S + dS;
            work += dWork;
            Vc = next;
            if (restituting)
            {
                return S;
            }
            restituting = true;
            compression = work;
            if (normal_ == 0)
            {
                return S;
            }
        }
        else
        {
            S = S + dS;
            work += dWork;
            Vc = next;
        }
        if (mag(tangent(Vc)) <= 1e-9*speed0)
        {
            bool sticks;
            finish(restDirection(sticks));
            return S;
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
