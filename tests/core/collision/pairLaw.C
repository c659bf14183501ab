/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.

Description
    The pair law against conservation, against a dense solution of the impact
    equations as a complementarity problem, and at its ends.
\*---------------------------------------------------------------------------*/

#include "pairLaw.H"
#include "counterRandom.H"

#include <Eigen/Dense>
#include <gtest/gtest.h>
#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

using namespace impact;

namespace
{

vector3 randomVector(counterRandom& rnd)
{
    return {rnd.normal(), rnd.normal(), rnd.normal()};
}


struct randomPair
{
    collidingSphere a, b;
    vector3 n;

    explicit randomPair(int i)
    {
        counterRandom rnd(11, i);
        auto sphere = [&]
        {
            collidingSphere s;
            s.radius = std::exp(2*rnd.normal());
            s.mass = std::exp(3*rnd.normal());
            s.v = randomVector(rnd);
            s.omega = (rnd.uniform()/s.radius)*randomVector(rnd);
            return s;
        };
        n = randomVector(rnd);
        n = (1/mag(n))*n;
        do
        {
            a = sphere();
            b = sphere();
        }
        while (dot(n, a.v - b.v) <= 0);
    }
};


double energy(const collidingSphere& s, const vector3& v, const vector3& w)
{
    return 0.5*s.mass*dot(v, v)
      + 0.2*s.mass*s.radius*s.radius*dot(w, w);
}


//- About the contact point
vector3 angularMomentum
(
    const collidingSphere& s,
    const vector3& centre,
    const vector3& v,
    const vector3& w
)
{
    return s.mass*cross(centre, v)
      + (0.4*s.mass*s.radius*s.radius)*w;
}


vector3 slip
(
    const randomPair& p,
    const vector3& v1,
    const vector3& v2,
    const vector3& w1,
    const vector3& w2
)
{
    const vector3 G = v1 - v2;
    return G - dot(p.n, G)*p.n
      + cross(p.a.radius*w1 + p.b.radius*w2, p.n);
}

} // End anonymous namespace


TEST(pairLaw, keepsMomentumAndAccountsForTheEnergy)
{
    int sliding = 0, sticking = 0;
    for (int i = 0; i < 20000; ++i)
    {
        const randomPair p(i);
        const double e = 0.1*(i % 11);
        const double f = i % 7 == 0 ? 0 : 0.05*(i % 13);
        const double b = -1 + 0.25*(i % 9);
        const pairLaw law(e, f, true, b);
        const pairCollision out = law.collide(p.a, p.b, p.n);

        // Each body's own change, so that a light one is not lost beside a
        // heavy one
        const vector3 d1 = p.a.mass*(out.v1 - p.a.v);
        const vector3 d2 = p.b.mass*(out.v2 - p.b.v);
        const double scale = p.a.mass*mag(p.a.v) + p.b.mass*mag(p.b.v)
          + mag(out.impulse);
        EXPECT_LT(mag(d1 + d2), 4e-15*scale);

        // About the contact point and about a distant one
        for (double away : {0., 3.})
        {
            const vector3 o = {away, -2*away, away};
            const vector3 x1 = o - p.a.radius*p.n;
            const vector3 x2 = o + p.b.radius*p.n;
            const vector3 before =
                angularMomentum(p.a, x1, p.a.v, p.a.omega)
              + angularMomentum(p.b, x2, p.b.v, p.b.omega);
            const vector3 after =
                angularMomentum(p.a, x1, out.v1, out.omega1)
              + angularMomentum(p.b, x2, out.v2, out.omega2);
            EXPECT_LT
            (
                mag(after - before),
                1e-14*(p.a.radius + p.b.radius + mag(o))*scale
              + 1e-14
               *(
                    p.a.mass*p.a.radius*p.a.radius*mag(p.a.omega)
                  + p.b.mass*p.b.radius*p.b.radius*mag(p.b.omega)
                )
            );
        }

        const double E0 =
            energy(p.a, p.a.v, p.a.omega) + energy(p.b, p.b.v, p.b.omega);
        const double E1 =
            energy(p.a, out.v1, out.omega1)
          + energy(p.b, out.v2, out.omega2);
        EXPECT_NEAR
            (E0 - E1, out.restitutionLoss + out.frictionLoss, 1e-13*E0);
        EXPECT_GE(out.restitutionLoss, 0);
        EXPECT_GE(out.frictionLoss, -1e-15*E0);
        EXPECT_LE(E1, E0*(1 + 1e-14));

        // Restitution, and the cone
        EXPECT_NEAR
        (
            dot(p.n, out.v1 - out.v2),
            -e*out.approachSpeed,
            1e-14*(mag(p.a.v) + mag(p.b.v) + mag(out.impulse)/p.a.mass
          + mag(out.impulse)/p.b.mass)
        );
        const double Jn = dot(p.n, out.impulse);
        EXPECT_LE
        (
            mag(out.impulse - Jn*p.n),
            f*std::fabs(Jn)*(1 + 1e-12) + 1e-14*mag(out.impulse)
        );
        (out.sliding ? sliding : sticking)++;
    }
    EXPECT_GT(sliding, 2000);
    EXPECT_GT(sticking, 2000);
}


TEST(pairLaw, solvesTheImpactProblem)
{
    // Independent: the dense 6x6 mass matrix of contact velocities and
    // Coulomb's cone. The tangential impulse minimises the slip energy over
    // the disc of radius f Jn: projected gradient, no case distinction
    for (int i = 0; i < 500; ++i)
    {
        const randomPair p(i);
        const double e = 0.3 + 0.1*(i % 8);
        const double f = 0.04*(1 + i % 20);
        const pairCollision out = pairLaw(e, f).collide(p.a, p.b, p.n);

        auto eigen = [](const vector3& v)
        {
            return Eigen::Vector3d(v.x, v.y, v.z);
        };
        auto skew = [](const Eigen::Vector3d& v)
        {
            Eigen::Matrix3d m;
            m << 0, -v[2], v[1], v[2], 0, -v[0], -v[1], v[0], 0;
            return m;
        };
        const Eigen::Vector3d n = eigen(p.n);

        // Relative velocity of the contact points = D (v1 w1 v2 w2)
        Eigen::MatrixXd D(3, 12);
        D << Eigen::Matrix3d::Identity(), -skew(p.a.radius*n),
            -Eigen::Matrix3d::Identity(), -skew(p.b.radius*n);
        Eigen::VectorXd mass(12), u(12);
        const double I1 = 0.4*p.a.mass*p.a.radius*p.a.radius;
        const double I2 = 0.4*p.b.mass*p.b.radius*p.b.radius;
        mass << Eigen::Vector3d::Constant(p.a.mass),
            Eigen::Vector3d::Constant(I1),
            Eigen::Vector3d::Constant(p.b.mass),
            Eigen::Vector3d::Constant(I2);
        u << eigen(p.a.v), eigen(p.a.omega), eigen(p.b.v),
            eigen(p.b.omega);
        const Eigen::Matrix3d W =
            D*mass.cwiseInverse().asDiagonal()*D.transpose();
        const Eigen::Vector3d U = D*u;
        const double Jn = -(1 + e)*n.dot(U)/n.dot(W*n);
        const Eigen::Matrix3d T =
            Eigen::Matrix3d::Identity() - n*n.transpose();
        Eigen::Vector3d Jt = Eigen::Vector3d::Zero();
        const double step = 1/W.norm();
        for (int k = 0; k < 400; ++k)
        {
            Jt -= step*(T*(U + W*(Jn*n + Jt)));
            const double length = Jt.norm();
            if (length > f*std::fabs(Jn))
            {
                Jt *= f*std::fabs(Jn)/length;
            }
        }
        const Eigen::Vector3d J = Jn*n + Jt;
        const Eigen::VectorXd after =
            u + mass.cwiseInverse().asDiagonal()*D.transpose()*J;
        const double speed = U.norm() + u.norm();
        EXPECT_LT((eigen(out.impulse) - J).norm(), 1e-12*J.norm());
        EXPECT_LT
        (
            (after.segment<3>(0) - eigen(out.v1)).norm(),
            1e-11*speed*std::max(1., J.norm()/p.a.mass)
        );
        EXPECT_LT
        (
            (after.segment<3>(3) - eigen(out.omega1)).norm(),
            1e-11*(speed + J.norm()*p.a.radius/I1)
        );
        EXPECT_LT
        (
            (after.segment<3>(9) - eigen(out.omega2)).norm(),
            1e-11*(speed + J.norm()*p.b.radius/I2)
        );
    }
}


TEST(pairLaw, changesRegimeWhereTheSourceSaysAndContinuously)
{
    // (n.G)/|G_ct| against (2/7)/(f (1 + e))
    const double e = 0.8, f = 0.25;
    const double border = (2./7)/(f*(1 + e));
    const pairLaw law(e, f);
    auto collide = [&](double ratio)
    {
        const collidingSphere a = {{ratio, 1, 0}, {0, 0, 0}, 2, 0.5};
        const collidingSphere b = {{0, 0, 0}, {0, 0, 0}, 3, 1};
        return law.collide(a, b, {1, 0, 0});
    };
    EXPECT_TRUE(collide(border*(1 - 1e-12)).sliding);
    EXPECT_FALSE(collide(border*(1 + 1e-12)).sliding);
    const vector3 step = collide(border*(1 + 1e-12)).impulse
      - collide(border*(1 - 1e-12)).impulse;
    EXPECT_LT(mag(step), 1e-11);

    // A contact that sticks leaves without slip; b = 1 reverses it
    for (int i = 0; i < 1000; ++i)
    {
        const randomPair p(i);
        const vector3 before =
            slip(p, p.a.v, p.b.v, p.a.omega, p.b.omega);
        for (double b : {-1., -0.5, 0., 0.7, 1.})
        {
            const pairCollision out =
                pairLaw(0.9, 1e12, true, b).collide(p.a, p.b, p.n);
            const vector3 after =
                slip(p, out.v1, out.v2, out.omega1, out.omega2);
            EXPECT_LT
            (
                mag(after + b*before),
                1e-13*(mag(before) + mag(p.a.v) + mag(p.b.v)
              + mag(out.impulse)*(1/p.a.mass + 1/p.b.mass))
            );
        }
    }
}


TEST(pairLaw, takesSlipDownToZero)
{
    // The limit without slip is the smooth collision, reached linearly
    const pairLaw law(0.9, 0.2);
    const vector3 n = {0, 1, 0};
    const collidingSphere b = {{0, 0, 0}, {0, 0, 0}, 1, 1};
    for (double s : {0., 1e-320, 1e-200, 1e-150, 1e-30, 1e-8})
    {
        const collidingSphere a = {{s, 1, 0}, {0, 0, 0}, 1, 1};
        const pairCollision out = law.collide(a, b, n);
        EXPECT_FALSE(out.sliding);
        EXPECT_NEAR(out.v1.y, 0.05, 1e-15);
        EXPECT_NEAR(out.v1.x, s*(1 - 1./7), 1e-15*s);
        EXPECT_TRUE(std::isfinite(out.omega1.z));
    }
    // Slip made of spin alone that cancels the passing speed
    const collidingSphere a = {{0.3, 1, 0}, {0, 0, 0.3}, 1, 1};
    EXPECT_EQ(law.collide(a, b, n).impulse.x, 0);
}


TEST(pairLaw, withoutSpinKeepsLinearMomentumAndDiscardsTheSpin)
{
    for (int i = 0; i < 5000; ++i)
    {
        randomPair p(i);
        const pairLaw law(0.1*(i % 11), 0.06*(i % 11), false);
        const pairCollision out = law.collide(p.a, p.b, p.n);
        EXPECT_EQ(mag(out.omega1), 0);
        EXPECT_EQ(mag(out.omega2), 0);
        const vector3 d = p.a.mass*(out.v1 - p.a.v)
          + p.b.mass*(out.v2 - p.b.v);
        EXPECT_LT
        (
            mag(d),
            4e-15*(p.a.mass*mag(p.a.v) + p.b.mass*mag(p.b.v)
          + mag(out.impulse))
        );
        const vector3 rest = {0, 0, 0};
        const double E0 = energy(p.a, p.a.v, rest)
          + energy(p.b, p.b.v, rest);
        const double E1 = energy(p.a, out.v1, rest)
          + energy(p.b, out.v2, rest);
        EXPECT_NEAR
            (E0 - E1, out.restitutionLoss + out.frictionLoss, 1e-13*E0);

        // The same impulse as with a spin that starts from rest
        p.a.omega = p.b.omega = rest;
        const pairCollision spinning =
            pairLaw(0.1*(i % 11), 0.06*(i % 11)).collide(p.a, p.b, p.n);
        EXPECT_EQ(mag(spinning.impulse - out.impulse), 0);
    }
}


TEST(pairLaw, isTheWallLawForAnImmovableBody)
{
    // Hard sphere with friction on a wall, outward normal y (page 2.5 of the
    // same source): closed form with the slip speed
    const double infinite = std::numeric_limits<double>::infinity();
    const double r = 0.3, e = 0.7;
    const collidingSphere wall = {{0, 0, 0}, {0, 0, 0}, infinite, 0};
    for (int i = 0; i < 2000; ++i)
    {
        counterRandom rnd(5, i);
        vector3 v = randomVector(rnd);
        v.y = -std::fabs(v.y) - 1e-3;
        const vector3 w = (1/r)*randomVector(rnd);
        const double f = 0.03*(1 + i % 30);
        const pairCollision out = pairLaw(e, f).collide
            ({v, w, 2.5, r}, wall, {0, -1, 0});

        const double sx = v.x + r*w.z, sz = v.z - r*w.x;
        const double s = std::hypot(sx, sz);
        vector3 v1, w1;
        if (-v.y/s < 2/(7*f*(1 + e)))
        {
            const double k = f*(1 + e)*v.y;
            v1 = {v.x + sx/s*k, -e*v.y, v.z + sz/s*k};
            w1 = {w.x - 2.5/r*sz/s*k, w.y, w.z + 2.5/r*sx/s*k};
            EXPECT_TRUE(out.sliding);
        }
        else
        {
            v1 =
            {
                5./7*(v.x - 0.4*r*w.z), -e*v.y, 5./7*(v.z + 0.4*r*w.x)
            };
            w1 = {v1.z/r, w.y, -v1.x/r};
            EXPECT_FALSE(out.sliding);
        }
        EXPECT_LT(mag(out.v1 - v1), 1e-14*(mag(v) + r*mag(w)));
        EXPECT_LT(r*mag(out.omega1 - w1), 3e-14*(mag(v) + r*mag(w)));
        EXPECT_EQ(mag(out.v2), 0);
        EXPECT_EQ(mag(out.omega2), 0);
    }
}


TEST(pairLaw, takesItsCoefficientsAtTheContact)
{
    // As a law of constants that are worked out by hand, at the velocity of
    // the contact points; without spin, that of the centres
    typedef reboundCoefficient form;
    int outside = 0;
    for (int i = 0; i < 4000; ++i)
    {
        const randomPair p(i);
        const bool spin = i % 2;
        const pairLaw law
        (
            form::McNamaraFalcon(form::restitutionQuantity(), 0.6, 1.5),
            form::table
            (
                form::frictionQuantity(), {10, 80}, {0.5, 4},
                {0.1, 0.2, 0.4, 0.6}
            ),
            spin
        );
        const vector3 G = p.a.v - p.b.v;
        const double v = dot(p.n, G);
        const vector3 surface =
            p.a.radius*p.a.omega + p.b.radius*p.b.omega;
        const vector3 Gc = spin ? G + cross(surface, p.n) : G;
        const double degrees = std::asin(v/mag(Gc))*180/M_PI;
        const double a = (std::min(std::max(degrees, 10.), 80.) - 10)/70;
        const double s = (std::min(std::max(mag(Gc), 0.5), 4.) - 0.5)/3.5;
        outside += degrees < 10 || degrees > 80;
        const pairLaw wanted
        (
            v < 1.5
          ? 1 - 0.4*std::pow(v/1.5, 0.2) : 0.6*std::pow(v/1.5, -0.25),
            0.1 + 0.1*s + 0.3*a + 0.1*s*a,
            spin
        );
        const pairCollision x = law.collide(p.a, p.b, p.n);
        const pairCollision y = wanted.collide(p.a, p.b, p.n);
        EXPECT_LT(mag(x.impulse - y.impulse), 1e-12*mag(y.impulse));
        EXPECT_NEAR
        (
            x.restitutionLoss, y.restitutionLoss, 1e-12*y.restitutionLoss
        );
        EXPECT_EQ(x.sliding, y.sliding);
    }
    EXPECT_GT(outside, 100);
}


TEST(pairLaw, elasticCollisionsLoseNothing)
{
    const pairLaw law(0.1, 0.5);
    for (int i = 0; i < 2000; ++i)
    {
        const randomPair p(i);
        const pairCollision out = law.collide(p.a, p.b, p.n, true);
        EXPECT_EQ(out.restitutionLoss, 0);
        EXPECT_EQ(out.frictionLoss, 0);
        const double E0 =
            energy(p.a, p.a.v, p.a.omega) + energy(p.b, p.b.v, p.b.omega);
        const double E1 =
            energy(p.a, out.v1, out.omega1)
          + energy(p.b, out.v2, out.omega2);
        EXPECT_NEAR(E1, E0, 1e-14*E0);
    }
}


TEST(pairLaw, leavesSpheresThatPartAlone)
{
    const collidingSphere a = {{-1, 2, 0}, {1, 2, 3}, 1, 1};
    const collidingSphere b = {{0, 0, 0}, {0, 1, 0}, 2, 1};
    for (double vn : {-1., 0.})
    {
        collidingSphere c = a;
        c.v.x = vn;
        const pairCollision out = pairLaw().collide(c, b, {1, 0, 0});
        EXPECT_EQ(mag(out.v1 - c.v), 0);
        EXPECT_EQ(mag(out.omega1 - c.omega), 0);
        EXPECT_EQ(mag(out.impulse), 0);
    }
}


TEST(pairLaw, refusesParametersOutOfRange)
{
    EXPECT_THROW(pairLaw(-0.1), std::invalid_argument);
    EXPECT_THROW(pairLaw(1.1), std::invalid_argument);
    EXPECT_THROW(pairLaw(0.9, -0.1), std::invalid_argument);
    EXPECT_THROW(pairLaw(0.9, 0.2, true, 1.1), std::invalid_argument);
    EXPECT_THROW
        (pairLaw(std::nan("")), std::invalid_argument);
}
