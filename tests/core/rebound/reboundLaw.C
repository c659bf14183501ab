/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.

Description
    Both laws of rebound against what holds for any rigid impact: angular
    momentum about the contact, the energy balance, the closed solutions for
    a sphere, and integrations of the friction law.
\*---------------------------------------------------------------------------*/

#include "reboundLaw.H"
#include "convexBody.H"
#include "counterRandom.H"

#include <Eigen/Dense>
#include <boost/numeric/odeint/stepper/runge_kutta_fehlberg78.hpp>
#include <gtest/gtest.h>
#include <array>
#include <cmath>
#include <stdexcept>

using namespace impact;

namespace
{

Eigen::Vector3d eigen(const vector3& v)
{
    return {v.x, v.y, v.z};
}


Eigen::Matrix3d skew(const vector3& v)
{
    Eigen::Matrix3d m;
    m << 0, -v.z, v.y, v.z, 0, -v.x, -v.y, v.x, 0;
    return m;
}


vector3 randomUnit(counterRandom& rnd)
{
    const vector3 v = {rnd.normal(), rnd.normal(), rnd.normal()};
    return (1/mag(v))*v;
}


struct randomImpact
{
    convexBody body = convexBody::sphere(1);
    vector3 n, r, V, omega;

    explicit randomImpact(int i)
    {
        counterRandom rnd(3, i);
        const double a = 0.2 + rnd.uniform();
        const double b = 0.2 + rnd.uniform();
        const double c = 0.2 + rnd.uniform();
        body = i % 3 == 0 ? convexBody::ellipsoid({a, b, c})
          : i % 3 == 1 ? convexBody::box({a, b, c})
          : convexBody::truncatedBox({a, b, c}, 0.25);
        n = randomUnit(rnd);
        r = body.support(-n);
        do
        {
            V = (100*rnd.uniform())*randomUnit(rnd);
            omega = (100*rnd.uniform()/a)*randomUnit(rnd);
        }
        while (dot(n, V + cross(omega, r)) >= -1);
    }

    //- Impulse to change of the velocity of the contact point
    Eigen::Matrix3d inverseMass() const
    {
        const Eigen::Matrix3d R = skew(r);
        const Eigen::Vector3d J = eigen(body.inertia());
        return Eigen::Matrix3d::Identity()
          - R*J.cwiseInverse().asDiagonal()*R;
    }
};

} // End anonymous namespace


TEST(reboundLaw, solvesTheEquationsOfTheRigidImpact)
{
    const reboundLaw law = reboundLaw::restitution(0.7, 0.2);
    for (int i = 0; i < 3000; ++i)
    {
        const randomImpact c(i);
        const impactRecord out =
            law.impact(c.body.inertia(), c.r, c.n, c.V, c.omega);
        const vector3 Vc = c.V + cross(c.omega, c.r);
        const double scale = mag(Vc) + mag(c.V);

        // The velocity of the contact point is what the law says
        const vector3 after =
            c.V + out.dV + cross(c.omega + out.dOmega, c.r);
        const double vn = dot(Vc, c.n);
        const vector3 wanted = 0.2*(Vc - vn*c.n) - (0.7*vn)*c.n;
        EXPECT_LT(mag(after - wanted), 1e-12*scale);

        // Angular momentum about the contact is kept
        const vector3 dL =
            multiply(c.body.inertia(), out.dOmega) - cross(c.r, out.dV);
        EXPECT_LT(mag(dL), 1e-12*scale*c.body.radius());

        // The dense solution
        const Eigen::Matrix3d A =
            Eigen::Matrix3d(eigen(c.body.inertia()).asDiagonal())
          + dot(c.r, c.r)*Eigen::Matrix3d::Identity()
          - eigen(c.r)*eigen(c.r).transpose();
        const Eigen::Vector3d dense =
            A.ldlt().solve(eigen(cross(c.r, wanted - Vc)));
        EXPECT_LT
        (
            (dense - eigen(out.dOmega)).norm(),
            1e-11*(dense.norm() + scale/c.body.radius())
        );
    }
}


TEST(reboundLaw, takesItsCoefficientsAtTheContact)
{
    // As a law of constants that are worked out by hand, at the velocity of
    // the contact point
    typedef reboundCoefficient form;
    const reboundLaw fitted = reboundLaw
    (
        reboundLaw::lawType::restitution,
        form::fit(reboundLaw::normalQuantity(), "GrantTabakoff"),
        form::fit(reboundLaw::tangentialQuantity(), "GrantTabakoff")
    );
    const reboundLaw rubbing = reboundLaw
    (
        reboundLaw::lawType::friction,
        form::McNamaraFalcon(form::restitutionQuantity(), 0.6, 20),
        form::table
        (
            form::frictionQuantity(), {20, 70}, {0}, {0.4, 0.1}
        )
    );
    int outside = 0;
    for (int i = 0; i < 2000; ++i)
    {
        const randomImpact c(i);
        const vector3& J = c.body.inertia();
        const vector3 Vc = c.V + cross(c.omega, c.r);
        const double v = -dot(Vc, c.n);
        const double b = std::asin(v/mag(Vc)), degrees = b*180/M_PI;

        const impactRecord a = fitted.impact(J, c.r, c.n, c.V, c.omega);
        const impactRecord wantedA = reboundLaw::restitution
        (
            0.993 - 1.76*b + 1.56*b*b - 0.49*b*b*b,
            0.988 - 1.66*b + 2.11*b*b - 0.67*b*b*b
        ).impact(J, c.r, c.n, c.V, c.omega);
        EXPECT_LT(mag(a.dV - wantedA.dV), 1e-12*mag(Vc));
        EXPECT_FALSE(a.outside);

        const impactRecord d = rubbing.impact(J, c.r, c.n, c.V, c.omega);
        const double held = std::min(std::max(degrees, 20.), 70.);
        const impactRecord wantedD = reboundLaw::coulomb
        (
            v < 20 ? 1 - 0.4*std::pow(v/20, 0.2) : 0.6*std::pow(v/20, -0.25),
            0.4 - 0.3*(held - 20)/50
        ).impact(J, c.r, c.n, c.V, c.omega);
        EXPECT_LT(mag(d.dV - wantedD.dV), 1e-9*mag(Vc));
        EXPECT_LE(d.energyChange, 1e-12*d.energyBefore);
        EXPECT_EQ(d.outside, degrees < 20 || degrees > 70);
        outside += d.outside;
    }
    EXPECT_GT(outside, 200);
    EXPECT_LT(outside, 1800);
}


TEST(reboundLaw, changesTheEnergyByTheIdentity)
{
    const double an = 0.8, at = 0.3;
    const reboundLaw law = reboundLaw::restitution(an, at);
    for (int i = 0; i < 3000; ++i)
    {
        const randomImpact c(i);
        const impactRecord out =
            law.impact(c.body.inertia(), c.r, c.n, c.V, c.omega);

        // dT = -1/2 [(1 - at^2) u M_tt u + (1 - an^2) M_nn v^2
        //            + 2 (1 + an at) v u M_tn], M the effective mass
        const Eigen::Matrix3d M = c.inverseMass().inverse();
        const vector3 Vc = c.V + cross(c.omega, c.r);
        const double v = dot(Vc, c.n);
        const Eigen::Vector3d n = eigen(c.n);
        const Eigen::Vector3d u = eigen(Vc) - v*n;
        const double expected = -0.5
           *(
                (1 - at*at)*u.dot(M*u) + (1 - an*an)*v*v*n.dot(M*n)
              + 2*(1 + an*at)*v*u.dot(M*n)
            );
        EXPECT_NEAR(out.energyChange, expected, 1e-12*out.energyBefore);
        EXPECT_EQ
        (
            out.pulling,
            dot(c.n, out.dV) < 0
        );
    }
}


TEST(reboundLaw, isLosslessWhenTheContactVelocityIsReversed)
{
    const reboundLaw law = reboundLaw::restitution(1, -1);
    for (int i = 0; i < 3000; ++i)
    {
        const randomImpact c(i);
        const impactRecord out =
            law.impact(c.body.inertia(), c.r, c.n, c.V, c.omega);
        EXPECT_LT(std::fabs(out.energyChange), 1e-12*out.energyBefore);
    }
}


TEST(reboundLaw, boundsTheEnergyOnlyUpToTheKnownRestitution)
{
    // Largest normal restitution, with no slip on leaving, for which no
    // orientation and no velocity gains energy: from dT <= 0 for all u and v,
    // (1 - an^2) M_nn >= M_tn M_tt^-1 M_nt
    auto bound = [](const convexBody& body)
    {
        double minSquare = 1;
        counterRandom rnd(8);
        for (int i = 0; i < 200000; ++i)
        {
            const vector3 n = randomUnit(rnd);
            const vector3 r = body.support(-n);
            const Eigen::Matrix3d R = skew(r);
            const Eigen::Matrix3d W = Eigen::Matrix3d::Identity()
              - R*eigen(body.inertia()).cwiseInverse().asDiagonal()*R;
            // M_nn - M_nt M_tt^-1 M_tn = 1/W_nn
            const Eigen::Vector3d e = eigen(n);
            const double Mnn = e.dot(W.inverse()*e);
            const double Wnn = e.dot(W*e);
            minSquare = std::min(minSquare, 1/(Mnn*Wnn));
        }
        return std::sqrt(minSquare);
    };
    EXPECT_NEAR(bound(convexBody::sphere(1)), 1, 1e-12);
    EXPECT_NEAR(bound(convexBody::ellipsoid({1, 0.8, 0.8})), 0.961, 0.002);
    EXPECT_NEAR(bound(convexBody::box({1, 0.8, 0.8})), 0.707, 0.01);
}


TEST(reboundLaw, reboundsASphereAtItsAngle)
{
    const convexBody ball = convexBody::sphere(32e-6);
    for (double degrees : {0.01, 15., 45., 80., 89.99})
    {
        const double a1 = degrees*M_PI/180;
        const vector3 V = {std::cos(a1), -std::sin(a1), 0};
        const vector3 r = {0, -16e-6, 0};
        const vector3 n = {0, 1, 0};
        for (double an : {0., 0.8, 1.})
        {
            const impactRecord out = reboundLaw::restitution(an).impact
                (ball.inertia(), r, n, V, {0, 0, 0});
            const vector3 V2 = V + out.dV;
            EXPECT_NEAR
            (
                std::atan2(V2.y, V2.x),
                std::atan2(an*std::sin(a1), 5*std::cos(a1)/7),
                1e-14
            );
        }
    }
}


TEST(reboundLaw, frictionOfASphereIsInClosedForm)
{
    // Gross slip, or rolling at the end: e is kinematic for a sphere
    const convexBody ball = convexBody::sphere(2);
    const vector3 r = {0, -1, 0}, n = {0, 1, 0};
    const vector3 V = {3, -2, 1};
    const double e = 0.8;
    const double ut = std::hypot(V.x, V.z);
    for (double mu : {0., 0.05, 0.2, 0.24, 0.26, 0.3, 1.})
    {
        const impactRecord out = reboundLaw::coulomb(e, mu).impact
            (ball.inertia(), r, n, V, {0, 0, 0});
        const double jn = (1 + e)*2;
        const double jt = std::min(mu*jn, 2./7*ut);
        EXPECT_NEAR(out.dV.y, jn, 1e-12);
        EXPECT_NEAR(out.dV.x, -jt*V.x/ut, 1e-12);
        EXPECT_NEAR(out.dV.z, -jt*V.z/ut, 1e-12);
    }
}


TEST(reboundLaw, frictionNeitherPullsNorLeavesItsConeNorMakesEnergy)
{
    int sticking = 0;
    for (int i = 0; i < 3000; ++i)
    {
        const randomImpact c(i);
        const double mu = 0.1*(1 + i % 12);
        const double e = 0.1*(i % 11);
        const impactRecord out = reboundLaw::coulomb(e, mu).impact
            (c.body.inertia(), c.r, c.n, c.V, c.omega);
        const double pn = dot(out.dV, c.n);
        EXPECT_GT(pn, 0);
        EXPECT_FALSE(out.pulling);
        EXPECT_LE(mag(out.dV - pn*c.n), mu*pn*(1 + 1e-9));
        EXPECT_LE(out.energyChange, 1e-9*out.energyBefore);
        EXPECT_FALSE(out.energyChange > 1e-9*out.energyBefore);
        const vector3 dL =
            multiply(c.body.inertia(), out.dOmega) - cross(c.r, out.dV);
        EXPECT_LT(mag(dL), 1e-12*mag(out.dV)*c.body.radius() + 1e-12);
        const vector3 Vc =
            c.V + out.dV + cross(c.omega + out.dOmega, c.r);
        EXPECT_GE(dot(Vc, c.n), -1e-9*mag(c.V));
        sticking += mag(Vc - dot(Vc, c.n)*c.n) < 1e-8*mag(c.V);
    }
    EXPECT_GT(sticking, 100);
    EXPECT_LT(sticking, 2900);
}


TEST(reboundLaw, frictionAgreesWithAPlainIntegration)
{
    // Euler steps of the impulse with friction smoothed around rest:
    // independent of every event of the implementation
    for (int i = 0; i < 12; ++i)
    {
        const randomImpact c(i);
        const double mu = 0.2 + 0.1*(i % 4);
        const double e = 0.6;
        const Eigen::Matrix3d W = c.inverseMass();
        const Eigen::Vector3d n = eigen(c.n);
        Eigen::Vector3d v = eigen(c.V + cross(c.omega, c.r));
        const double v0 = v.norm();
        Eigen::Vector3d S = Eigen::Vector3d::Zero();
        double work = 0, minWork = 0;
        const double dp = 2e-6*v0;
        for (int k = 0; k < 20000000; ++k)
        {
            const Eigen::Vector3d t = v - v.dot(n)*n;
            const Eigen::Vector3d d =
                n - mu*t/std::sqrt(t.squaredNorm() + 1e-8*v0*v0);
            S += dp*d;
            work += dp*(v.dot(n) + 0.5*dp*n.dot(W*d));
            v += dp*(W*d);
            minWork = std::min(minWork, work);
            if (v.dot(n) > 0 && work >= minWork*(1 - e*e))
            {
                break;
            }
        }
        const impactRecord out = reboundLaw::coulomb(e, mu).impact
            (c.body.inertia(), c.r, c.n, c.V, c.omega);
        EXPECT_LT((eigen(out.dV) - S).norm(), 2e-3*S.norm()) << "run " << i;
    }
}


namespace
{

//- Impact with friction by Runge-Kutta steps of another library, of order 8 and
//  by the normal impulse, the ends of its parts by bisection
class exactImpact
{
    //- Impulse and work of the normal force
    struct process
    {
        Eigen::Vector3d S;
        double work;
    };

    Eigen::Matrix3d W_;
    Eigen::Vector3d n_, V0_;
    double mu_, e_;
    Eigen::Vector3d fixed_ = Eigen::Vector3d::Zero();
    bool slides_ = true;
    process q_ = {Eigen::Vector3d::Zero(), 0};

    Eigen::Vector3d tangent(const Eigen::Vector3d& v) const
    {
        return v - v.dot(n_)*n_;
    }

    Eigen::Vector3d velocity(const Eigen::Vector3d& S) const
    {
        return V0_ + W_*S;
    }

    process step(const process& a, double h) const
    {
        typedef std::array<double, 4> values;
        boost::numeric::odeint::runge_kutta_fehlberg78<values> stepper;
        values y = {a.S.x(), a.S.y(), a.S.z(), a.work};
        const auto rate = [&](const values& at, values& dydp, double)
        {
            const Eigen::Vector3d v = velocity({at[0], at[1], at[2]});
            const Eigen::Vector3d d = slides_
              ? Eigen::Vector3d(n_ - mu_*tangent(v).normalized()) : fixed_;
            dydp = {d.x(), d.y(), d.z(), n_.dot(v)};
        };
        stepper.do_step(rate, y, 0, h);
        return {{y[0], y[1], y[2]}, y[3]};
    }

    //- Rest if the cone allows it, else the direction that slip off keeps,
    //  found among many
    void endSlip()
    {
        slides_ = false;
        const Eigen::Vector3d a = n_.unitOrthogonal();
        Eigen::Matrix<double, 3, 2> T;
        T << a, n_.cross(a);
        const Eigen::Matrix2d K = T.transpose()*W_*T;
        const Eigen::Vector2d f = T.transpose()*W_*n_;
        const Eigen::Vector2d hold = -K.ldlt().solve(f);
        fixed_ = n_ + T*hold;
        if (hold.norm() <= mu_)
        {
            return;
        }
        double best = -1, last = 0;
        const int many = 100000;
        for (int m = 0; m <= many; ++m)
        {
            const double w = 2*M_PI*m/many;
            const Eigen::Vector2d s(std::cos(w), std::sin(w));
            const Eigen::Vector2d g = f - mu_*K*s;
            const double turning = s.x()*g.y() - s.y()*g.x();
            if (m && (turning > 0) != (last > 0) && g.dot(s) > best)
            {
                best = g.dot(s);
                fixed_ = n_ - mu_*T*s;
            }
            last = turning;
        }
    }


public:

    bool slipEnded = false;

    exactImpact(const randomImpact& c, double mu, double e)
    :
        W_(c.inverseMass()),
        n_(eigen(c.n)),
        V0_(eigen(c.V + cross(c.omega, c.r))),
        mu_(mu),
        e_(e)
    {}

    bool approaches() const
    {
        return V0_.dot(n_) <= -0.01*V0_.norm();
    }

    void run()
    {
        const double unit = V0_.norm();
        double compression = 0;
        bool restituting = false;
        for (int k = 0; k < 1000000; ++k)
        {
            const Eigen::Vector3d t = tangent(velocity(q_.S));
            if (slides_ && t.norm() < 1e-9*unit)
            {
                slipEnded = true;
                endSlip();
            }
            const double h =
                slides_ ? std::min(0.01*unit, 0.02*t.norm()) : 0.01*unit;
            const auto past = [&](const process& p)
            {
                return restituting
                  ? p.work >= compression*(1 - e_*e_)
                  : velocity(p.S).dot(n_) >= 0;
            };
            process next = step(q_, h);
            const bool ends = past(next);
            if (ends)
            {
                double lo = 0, hi = h;
                for (int m = 0; m < 50; ++m)
                {
                    const double mid = 0.5*(lo + hi);
                    (past(step(q_, mid)) ? hi : lo) = mid;
                }
                next = step(q_, hi);
            }
            q_ = next;
            if (ends && (restituting || e_ == 0))
            {
                return;
            }
            if (ends)
            {
                compression = q_.work;
                restituting = true;
            }
            else if (restituting && velocity(q_.S).dot(n_) < 0)
            {
                restituting = false;
            }
        }
    }

    const Eigen::Vector3d& impulse() const
    {
        return q_.S;
    }

    bool slipTurned() const
    {
        return tangent(velocity(q_.S)).dot(tangent(V0_)) < 0;
    }
};

} // End anonymous namespace


TEST(reboundLaw, frictionIsExact)
{
    int slipEnded = 0, turned = 0;
    for (int i = 0; i < 240; ++i)
    {
        randomImpact c(i);
        const double mu = 0.05 + 0.15*(i % 8);
        const double e = 0.1*(i % 11);
        if (i % 5 == 0)
        {
            // Steep, so that slip comes to its end or is turned round
            counterRandom rnd(4, i);
            c.V = -100*c.n + (20*rnd.uniform())*randomUnit(rnd);
            c.omega = {0, 0, 0};
        }
        exactImpact exact(c, mu, e);
        if (!exact.approaches())
        {
            continue;
        }
        exact.run();
        slipEnded += exact.slipEnded;
        turned += exact.slipTurned();
        const impactRecord out = reboundLaw::coulomb(e, mu).impact
            (c.body.inertia(), c.r, c.n, c.V, c.omega);
        EXPECT_LT
        (
            (eigen(out.dV) - exact.impulse()).norm(),
            3e-8*exact.impulse().norm()
        ) << "run " << i << " friction " << mu << " restitution " << e;
    }
    EXPECT_GT(slipEnded, 40);
    EXPECT_GT(turned, 10);
}


TEST(reboundLaw, frictionSurvivesExtremes)
{
    for (int i = 0; i < 3000; ++i)
    {
        randomImpact c(i);
        counterRandom rnd(9, i);
        const double mu = std::min(1e6, std::pow(10., -9 + i % 16));
        const double slip = std::pow(10., -14 + i % 15);
        c.omega = {0, 0, 0};
        const vector3 u = randomUnit(rnd);
        c.V = i % 2
          ? -c.n + slip*u
          : u - (dot(u, c.n) + std::pow(10., -(i/2) % 17))*c.n;
        const double e = 0.1*(i % 11);
        const impactRecord out = reboundLaw::coulomb(e, mu).impact
            (c.body.inertia(), c.r, c.n, c.V, c.omega);
        const double pn = dot(out.dV, c.n);
        EXPECT_GT(pn, 0) << "run " << i;
        EXPECT_LE(mag(out.dV - pn*c.n), mu*pn*(1 + 1e-9) + 1e-12)
            << "run " << i;
        EXPECT_LE(out.energyChange, 1e-9*out.energyBefore) << "run " << i;
        EXPECT_TRUE(std::isfinite(mag(out.dV) + mag(out.dOmega)));

        // At rest
        EXPECT_EQ
        (
            mag
            (
                reboundLaw::coulomb(e, mu).impact
                    (c.body.inertia(), c.r, c.n, {0, 0, 0}, {0, 0, 0}).dV
            ),
            0
        );
    }
}


TEST(reboundLaw, refusesParametersOutOfRange)
{
    EXPECT_THROW(reboundLaw::restitution(-0.1), std::invalid_argument);
    EXPECT_THROW(reboundLaw::restitution(1.1), std::invalid_argument);
    EXPECT_THROW(reboundLaw::restitution(0.8, -1.1), std::invalid_argument);
    EXPECT_THROW(reboundLaw::coulomb(1.1), std::invalid_argument);
    EXPECT_THROW(reboundLaw::coulomb(0.8, -0.1), std::invalid_argument);
}
