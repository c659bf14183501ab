/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "keplerOrbit.H"
#include "bracketedRoot.H"
#include "outOfRange.H"

#include <algorithm>
#include <cmath>
#include <limits>

namespace
{

//- The functions G_1, G_2, G_3 of s
struct universal
{
    double g1, g2, g3;

    universal(double beta, double s)
    {
        const double x = beta*s*s;
        if (std::fabs(x) < 0.5)
        {
            // Series: differences of functions would lose all digits
            double a = 0, b = 0;
            for (int k = 9; k >= 0; --k)
            {
                a = (1 - a*x)/((2*k + 2)*(2*k + 1));
                b = (1 - b*x)/((2*k + 3)*(2*k + 2));
            }
            g1 = s*(1 - x*b);
            g2 = s*s*a;
            g3 = s*s*s*b;
            return;
        }
        const double root = std::sqrt(std::fabs(beta));
        double sine, cosine;
        if (beta > 0)
        {
            sine = std::sin(root*s);
            cosine = std::cos(root*s);
        }
        else
        {
            sine = std::sinh(root*s);
            cosine = std::cosh(root*s);
        }
        g1 = sine/root;
        g2 = (1 - cosine)/beta;
        g3 = (s - g1)/beta;
    }
};

} // End anonymous namespace


impact::keplerOrbit::keplerOrbit(double mu)
:
    mu_(mu)
{
    checkRange("mu", mu, "(0, 1e30) m3/s2");
}


void impact::keplerOrbit::move(vector3& r, vector3& v, double time) const
{
    const double r0 = mag(r);
    const double eta = dot(r, v);
    const double beta = 2*mu_/r0 - dot(v, v);
    const double zeta = mu_ - beta*r0;
    double t = time;
    double low, high;
    if (beta > 0)
    {
        const double root = std::sqrt(beta);
        const double turn = 2*M_PI/root;
        const double period = mu_*turn/beta;
        t -= period*std::floor(t/period + 0.5);

        // Half a period is at most half a turn + 2 radians
        low = -0.83*turn;
        high = 0.83*turn;
    }
    else
    {
        // The distance grows at last: double the range until it holds s
        const double sign = t < 0 ? -1 : 1;
        const double speed = std::max(mag(v), std::sqrt(mu_/r0));
        double far = 1/speed;
        const double farthest =
            beta < 0 ? 600/std::sqrt(-beta)
          : std::numeric_limits<double>::max();
        for (int i = 0; i < 200; ++i)
        {
            far = std::min(far, farthest);
            const universal g(beta, sign*far);
            const double reached =
                r0*g.g1 + eta*g.g2 + mu_*g.g3;
            if (sign*reached >= sign*t || far == farthest)
            {
                break;
            }
            far *= 2;
        }
        low = std::min(0., sign*far);
        high = std::max(0., sign*far);
    }

    const double s = bracketedRoot
    (
        [&](double x)
        {
            const universal g(beta, x);
            return r0*g.g1 + eta*g.g2 + mu_*g.g3 - t;
        },
        low,
        high
    );

    const universal g(beta, s);
    const double distance = r0 + eta*g.g1 + zeta*g.g2;
    const double f = 1 - mu_*g.g2/r0;
    const double h = r0*g.g1 + eta*g.g2;
    const double inverse = 1/std::max(distance, 1e-300);
    const double df = -mu_*g.g1*inverse/r0;
    const double dh = 1 - mu_*g.g2*inverse;
    const vector3 start(r);
    r = f*start + h*v;
    v = df*start + dh*v;
}
