/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.

Description
    Collisions in the spin-carrying cloud: exact two-body cases, a closed box
    against a search of all pairs at every event, a periodic box against the
    mesh-free gas, conservation, cloud functions and sources, extremes,
    injection, refusal of bad input.
\*---------------------------------------------------------------------------*/

#include "IFstream.H"
#include "OFstream.H"
#include "OSspecific.H"
#include "Time.H"
#include "basicSpinningCloud.H"
#include "fluidThermo.H"
#include "fvMesh.H"
#include "hardSphereGas.H"

#include <gtest/gtest.h>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <memory>
#include <random>

using namespace Foam;

namespace
{

typedef basicSpinningCloud::parcelType parcel;

//- Collisions and no gas forces; motion with error control
const std::string base
(
    "solution{motion{type embeddedRK54;}"
    "collisions{type eventDriven;restitution 1;friction 0;}}"
);


class eventDrivenCollisionsTest
:
    public ::testing::Test
{
protected:

    fileName root_;
    autoPtr<Time> time_;
    autoPtr<fvMesh> mesh_;
    autoPtr<fluidThermo> thermo_;
    autoPtr<volScalarField> rho_;
    autoPtr<volVectorField> U_;
    autoPtr<volScalarField> mu_;
    dimensionedVector g_{"g", dimAcceleration, vector(0, 0, 0)};

    //- Of the last error
    std::string message_;

    void SetUp() override
    {
        std::string name
        (
            std::filesystem::temp_directory_path()/"parcelImpactXXXXXX"
        );
        ASSERT_TRUE(mkdtemp(&name[0]));
        root_ = name;
    }

    void close()
    {
        mu_.clear();
        U_.clear();
        rho_.clear();
        thermo_.clear();
        mesh_.clear();
        time_.clear();
    }

    void TearDown() override
    {
        if (HasFailure())
        {
            std::cerr<< message_ << std::endl;
        }
        close();
        rmDir(root_);
    }

    //- A box of 1 mm side with 10 cells each way: "plane" 0.1 mm thick,
    //  "box" with walls all around, "periodic"
    void open(const std::string& kind, const scalar deltaT)
    {
        const fileName dir(root_/"case");
        const std::string copy
        (
            "cp -r " + std::string(std::getenv("PARCEL_IMPACT_DIR"))
          + "/tests/cases/particles/case/. " + dir + " && cd " + dir
          + " && cp -r 0.orig 0"
        );
        ASSERT_EQ(std::system(("mkdir " + dir + " && " + copy).c_str()), 0);
        {
            const bool plane = kind == "plane";
            const bool periodic = kind == "periodic";
            const char* z = plane ? "1e-4" : "1e-3";
            std::ofstream os(dir/"system/blockMeshDict");
            os  << "FoamFile{version 2.0; format ascii; class dictionary;"
                   " object blockMeshDict;}\nvertices (";
            for (const char* level : {"0", z})
            {
                os  << "(0 0 " << level << ")(1e-3 0 " << level
                    << ")(1e-3 1e-3 " << level << ")(0 1e-3 " << level
                    << ")";
            }
            os  << ");\nblocks (hex (0 1 2 3 4 5 6 7) (10 10 "
                << (plane ? 1 : 10) << ") simpleGrading (1 1 1));\n"
                << "boundary (\n";
            const char* faces[6] =
            {
                "(0 4 7 3)", "(2 6 5 1)", "(1 5 4 0)", "(3 7 6 2)",
                "(0 3 2 1)", "(4 5 6 7)"
            };
            for (int i = 0; i < 6; ++i)
            {
                os  << "f" << i << "{type ";
                if (plane && i > 3)
                {
                    os  << "empty;";
                }
                else if (periodic)
                {
                    os  << "cyclic; neighbourPatch f" << (i ^ 1) << ";";
                }
                else
                {
                    os  << "wall;";
                }
                os  << " faces (" << faces[i] << ");}\n";
            }
            os  << ");\n";
            for (const char* field : {"p", "T", "U"})
            {
                std::ofstream f(dir/"0"/field);
                const bool vectors = *field == 'U';
                f   << "FoamFile{version 2.0; format ascii; class vol"
                    << (vectors ? "Vector" : "Scalar") << "Field; object "
                    << field << ";}\ndimensions "
                    << (
                           vectors ? "[0 1 -1 0 0 0 0]"
                         : *field == 'p' ? "[1 -1 -2 0 0 0 0]"
                         : "[0 0 0 1 0 0 0]"
                       )
                    << ";\ninternalField uniform "
                    << (vectors ? "(0 0 0)" : *field == 'p' ? "1e5" : "300")
                    << ";\nboundaryField{";
                for (int i = 0; i < 6; ++i)
                {
                    f   << "f" << i << "{type "
                        << (
                               plane && i > 3 ? "empty"
                             : periodic ? "cyclic" : "zeroGradient"
                           )
                        << ";}";
                }
                f   << "}\n";
            }
        }
        ASSERT_EQ
        (
            std::system
                (("cd " + dir + " && blockMesh > log.blockMesh 2>&1").c_str()),
            0
        );
        start(deltaT);
    }

    void start(const scalar deltaT)
    {
        time_.reset(new Time(Time::controlDictName, root_, fileName("case")));
        time_->setDeltaT(deltaT);
        mesh_.reset
        (
            new fvMesh
            (
                IOobject
                (
                    fvMesh::defaultRegion,
                    time_->timeName(),
                    time_(),
                    IOobject::MUST_READ
                )
            )
        );
        thermo_.reset(fluidThermo::New(mesh_()).ptr());
        const auto field =
            [&](const char* name, const tmp<volScalarField>& value)
            {
                return new volScalarField
                    (IOobject(name, time_->timeName(), mesh_()), value);
            };
        rho_.reset(field("rho", thermo_->rho()));
        mu_.reset(field("thermo:mu", thermo_->mu()));
        U_.reset
        (
            new volVectorField
            (
                IOobject("U", time_->timeName(), mesh_()),
                mesh_(),
                dimensionedVector(dimVelocity, Zero),
                "calculated"
            )
        );
    }

    static dictionary parse(const std::string& text)
    {
        return dictionary(IStringStream(text)());
    }

    std::unique_ptr<basicSpinningCloud> make
    (
        const std::string& changes = base,
        const std::string& forces = "",
        const word& name = "sand"
    )
    {
        IFstream is(root_/"case/constant/kinematicCloudProperties");
        dictionary dict(is);
        dict.subDict("subModels").set("particleForces", parse(forces));
        dict.merge
        (
            parse
            (
                "subModels{injectionModels{rake{SOI 1;}}"
                "patchInteractionModel hardSphereWall;"
                "hardSphereWallCoeffs{patches (\"f.*\""
                "{restitution 1;friction 0;});}"
                "rotationalTorqueModel none;}"
                "cloudFunctions{impacts{patches (\"f.*\");}}"
            )
        );
        dict.subDict("subModels").set("injectionModels", dictionary());
        if (forces.empty())
        {
            dict.set("cloudFunctions", dictionary());
        }
        dict.merge(parse(changes));
        {
            OFstream os(root_/"case"/"constant"/(name + "Properties"));
            os.precision(17);
            os  << "FoamFile{version 2.0; format ascii; class dictionary;"
                << " object " << name << "Properties;}" << nl;
            dict.write(os, false);
        }
        try
        {
            return std::make_unique<basicSpinningCloud>
            (
                name, rho_(), U_(), mu_(), g_
            );
        }
        catch (const error& e)
        {
            message_ = e.message();
            throw;
        }
    }

    parcel& add
    (
        basicSpinningCloud& cloud,
        const vector& x,
        const vector& U,
        const scalar d = 1e-5,
        const vector& omega = vector::zero
    )
    {
        const label celli = mesh_->findCell(x);
        EXPECT_GE(celli, 0);
        parcel* p = new parcel(mesh_(), x, celli);
        p->d() = d;
        p->rho() = 2500;
        p->U() = U;
        p->omega() = omega;
        p->nParticle() = 1;
        cloud.addParticle(p);
        return *p;
    }

    void step(basicSpinningCloud& cloud, const label n = 1)
    {
        for (label i = 0; i < n; ++i)
        {
            (*time_)++;
            try
            {
                cloud.evolve();
            }
            catch (const error& e)
            {
                message_ = e.message();
                throw;
            }
        }
    }

    std::string refusal(const std::string& changes)
    {
        try
        {
            make(changes);
        }
        catch (const error& e)
        {
            return e.message();
        }
        return "none";
    }
};


//- Spheres in a closed box by search of all pairs and walls at every event
struct allPairs
{
    struct sphere
    {
        impact::vector3 x, v, omega;
        double r, m;
    };
    std::vector<sphere> s;
    impact::pairLaw law;
    int nPair = 0, nWall = 0;

    void run(double time, int dimensions)
    {
        while (true)
        {
            double first = time;
            int a = -1, b = -1, axis = -1;
            for (int i = 0; i < int(s.size()); ++i)
            {
                for (int k = 0; k < dimensions; ++k)
                {
                    const double v = s[i].v[k];
                    const double t =
                        v > 0 ? (1e-3 - s[i].x[k])/v
                      : v < 0 ? s[i].x[k]/(-v) : first;
                    if (t < first)
                    {
                        first = std::max(t, 0.);
                        a = i;
                        b = -1;
                        axis = k;
                    }
                }
                for (int j = 0; j < i; ++j)
                {
                    const auto x = s[j].x - s[i].x, v = s[j].v - s[i].v;
                    const double bb = dot(x, v);
                    const double sigma = s[i].r + s[j].r;
                    const double c = dot(x, x) - sigma*sigma;
                    const double D = bb*bb - dot(v, v)*c;
                    if (bb < 0 && D > 0)
                    {
                        const double t = c/(-bb + std::sqrt(D));
                        if (t < first)
                        {
                            first = std::max(t, 0.);
                            a = i;
                            b = j;
                        }
                    }
                }
            }
            for (sphere& p : s)
            {
                p.x = p.x + first*p.v;
            }
            time -= first;
            if (a < 0)
            {
                return;
            }
            if (b < 0)
            {
                s[a].v[axis] = -s[a].v[axis];
                ++nWall;
                continue;
            }
            const auto x = s[b].x - s[a].x;
            const auto out = law.collide
            (
                {s[a].v, s[a].omega, s[a].m, s[a].r},
                {s[b].v, s[b].omega, s[b].m, s[b].r},
                (1/mag(x))*x
            );
            s[a].v = out.v1;
            s[b].v = out.v2;
            s[a].omega = out.omega1;
            s[b].omega = out.omega2;
            ++nPair;
        }
    }
};


//- Deepest overlap of the cloud's parcels, over the diameter
scalar overlap(const basicSpinningCloud& cloud)
{
    scalar deepest = 0;
    for (const parcel& p : cloud)
    {
        for (const parcel& q : cloud)
        {
            if (&p != &q)
            {
                const scalar sigma = 0.5*(p.d() + q.d());
                deepest = max
                (
                    deepest,
                    1 - mag(p.position() - q.position())/sigma
                );
            }
        }
    }
    return deepest;
}


vector momentum(const basicSpinningCloud& cloud)
{
    vector sum(Zero);
    for (const parcel& p : cloud)
    {
        sum += p.mass()*p.U();
    }
    return sum;
}


scalar energy(const basicSpinningCloud& cloud)
{
    scalar sum = 0;
    for (const parcel& p : cloud)
    {
        sum += 0.5*p.mass()*magSqr(p.U()) + p.rotationalEnergy();
    }
    return sum;
}


//- About the origin
vector angularMomentum(const basicSpinningCloud& cloud)
{
    vector sum(Zero);
    for (const parcel& p : cloud)
    {
        sum +=
            p.mass()*(p.position() ^ p.U()) + p.momentOfInertia()*p.omega();
    }
    return sum;
}


//- Spheres that do not overlap, of diameters from low to high
template<class Add>
void fill
(
    const label n,
    const scalar low,
    const scalar high,
    const scalar speed,
    const bool plane,
    const Add& add
)
{
    std::mt19937 generator(7);
    std::uniform_real_distribution<double> uniform(0, 1);
    std::vector<std::pair<vector, scalar>> there;
    while (label(there.size()) < n)
    {
        const scalar d = low + (high - low)*uniform(generator);
        vector x;
        vector U;
        vector omega;
        for (int k = 0; k < 3; ++k)
        {
            x[k] = 0.5*d + (1e-3 - d)*uniform(generator);
            U[k] = speed*(2*uniform(generator) - 1);
            omega[k] = speed/d*(2*uniform(generator) - 1);
        }
        if (plane)
        {
            x.z() = 5e-5;
            U.z() = 0;
            omega.x() = omega.y() = 0;
        }
        bool free = true;
        for (const auto& other : there)
        {
            free = free && mag(x - other.first) > 0.5*(d + other.second);
        }
        if (free)
        {
            there.push_back({x, d});
            add(x, U, d, omega);
        }
    }
}

} // End anonymous namespace


TEST_F(eventDrivenCollisionsTest, offBuildsNothing)
{
    open("plane", 1e-6);
    EXPECT_FALSE(make("", "", "default")->collisions());
    EXPECT_FALSE(make("solution{collisions off;}", "", "off")->collisions());
    EXPECT_TRUE(make(base, "", "on")->collisions());
}


TEST_F(eventDrivenCollisionsTest, headOnIsExact)
{
    open("plane", 1e-6);
    for (const char* motion : {"stock", "embeddedRK54"})
    {
        const auto cloud = make
        (
            "solution{motion " + std::string(motion) + ";collisions"
            "{type eventDriven;restitution 0.5;friction 0;}}",
            "",
            motion
        );
        parcel& a = add(*cloud, vector(4e-4, 5e-4, 5e-5), vector(100, 0, 0));
        parcel& b = add(*cloud, vector(4.6e-4, 5e-4, 5e-5), vector::zero);
        step(*cloud);

        // They meet after 5e-5 m; with e = 0.5 they leave with 25 and 75 m/s
        EXPECT_NEAR(a.U().x(), 25, 1e-11);
        EXPECT_NEAR(b.U().x(), 75, 1e-11);
        EXPECT_NEAR(a.position().x(), 4.5e-4 + 25*0.5e-6, 1e-17);
        EXPECT_NEAR(b.position().x(), 4.6e-4 + 75*0.5e-6, 1e-17);
        const auto& report = cloud->collisions()->lastStep();
        EXPECT_EQ(report.pairEvents, 1);
        EXPECT_EQ(report.wallEvents, 0);
        EXPECT_NEAR
        (
            report.restitutionLoss/(a.mass()*0.25*1e4*0.75), 1, 1e-12
        );
        step(*cloud);
        EXPECT_EQ(cloud->collisions()->lastStep().pairEvents, 0);
        EXPECT_NEAR(b.position().x(), 4.6e-4 + 75*1.5e-6, 1e-16);
    }
}


TEST_F(eventDrivenCollisionsTest, reboundHitsIncomingInTheSameStep)
{
    open("plane", 1e-6);
    const auto cloud = make();

    // a is at the wall x = 1e-3 after 0.2 us, comes back at 200 m/s and
    // meets b, which comes at 300 m/s; they exchange their velocities; b
    // then goes to the left, a to the wall again and returns
    parcel& a = add(*cloud, vector(9.6e-4, 5e-4, 5e-5), vector(200, 0, 0));
    parcel& b = add(*cloud, vector(8e-4, 5e-4, 5e-5), vector(300, 0, 0));
    step(*cloud);
    const scalar t = 0.2e-6 + (1.4e-4 - 1e-5)/500;
    const scalar meetA = 1e-3 - 200*(t - 0.2e-6);
    const scalar meetB = 8e-4 + 300*t;
    ASSERT_NEAR(meetA - meetB, 1e-5, 1e-16);
    const scalar again = t + (1e-3 - meetA)/300;
    EXPECT_NEAR(a.position().x(), 1e-3 - 300*(1e-6 - again), 1e-15);
    EXPECT_NEAR(b.position().x(), meetB - 200*(1e-6 - t), 1e-15);
    EXPECT_NEAR(a.U().x(), -300, 1e-10);
    EXPECT_NEAR(b.U().x(), -200, 1e-10);
    EXPECT_EQ(cloud->collisions()->lastStep().pairEvents, 1);
    EXPECT_EQ(cloud->collisions()->lastStep().wallEvents, 2);
}


TEST_F(eventDrivenCollisionsTest, eventsAreThoseOfASearchOfAllPairs)
{
    for (const bool plane : {true, false})
    {
        close();
        rmDir(root_/"case");
        open(plane ? "plane" : "box", 2e-6);
        for (const char* motion : {"stock", "embeddedRK54"})
        {
            const auto cloud = make
            (
                "solution{motion " + std::string(motion) + ";maxCo 1;"
                "collisions{type eventDriven;restitution 0.8;friction 0.3;"
                "contactDuration 1e-15;}}",
                "",
                motion
            );
            allPairs exact{{}, impact::pairLaw(0.8, 0.3)};
            std::vector<parcel*> parcels;
            fill
            (
                200, plane ? 1e-5 : 2e-5, plane ? 4e-5 : 8e-5, 50, plane,
                [&]
                (
                    const vector& x,
                    const vector& U,
                    const scalar d,
                    const vector& omega
                )
                {
                    parcels.push_back(&add(*cloud, x, U, d, omega));
                    const parcel& p = *parcels.back();
                    exact.s.push_back
                    ({
                        toCore(p.position()), toCore(U), toCore(omega),
                        0.5*d, p.mass()
                    });
                }
            );
            // What round-off grows to from collision to collision
            allPairs disturbed(exact);
            std::mt19937 generator(3);
            std::uniform_real_distribution<double> noise(-1e-18, 1e-18);
            for (auto& sphere : disturbed.s)
            {
                sphere.x.x += noise(generator);
                sphere.x.y += noise(generator);
            }

            const scalar before = energy(*cloud);
            scalar nPair = 0, nWall = 0, lost = 0;
            for (int i = 0; i < 4; ++i)
            {
                step(*cloud);
                const auto& report = cloud->collisions()->lastStep();
                nPair += report.pairEvents;
                nWall += report.wallEvents;
                lost += report.restitutionLoss + report.frictionLoss;
                EXPECT_LT(overlap(*cloud), 1e-9);
            }
            exact.run(8e-6, plane ? 2 : 3);
            disturbed.run(8e-6, plane ? 2 : 3);
            EXPECT_EQ(nPair, exact.nPair);
            EXPECT_EQ(nWall, exact.nWall);
            EXPECT_GT(nPair, 40);
            EXPECT_GT(nWall, 20);
            scalar worst = 0, roundOff = 0;
            for (std::size_t i = 0; i < parcels.size(); ++i)
            {
                const parcel& p = *parcels[i];
                const auto deviation =
                    [&](const vector& x, const vector& U, const vector& omega)
                    {
                        return
                            mag(x - fromCore(exact.s[i].x))/1e-5
                          + mag(U - fromCore(exact.s[i].v))/50
                          + 0.5*p.d()/50
                           *mag(omega - fromCore(exact.s[i].omega));
                    };
                worst =
                    max(worst, deviation(p.position(), p.U(), p.omega()));
                const auto& q = disturbed.s[i];
                roundOff = max
                (
                    roundOff,
                    deviation(fromCore(q.x), fromCore(q.v), fromCore(q.omega))
                );
            }
            EXPECT_LT(worst, 30*roundOff) << plane << motion;
            EXPECT_LT(worst, 1e-5);
            EXPECT_NEAR((energy(*cloud) + lost)/before, 1, 1e-12);
        }
    }
}


TEST_F(eventDrivenCollisionsTest, periodicBoxKeepsAllAndIsTheMeshFreeGas)
{
    open("periodic", 5e-6);
    const auto cloud = make
    (
        base + "subModels{patchInteractionModel standardWallInteraction;}"
    );
    impact::collisionDomain domain;
    domain.high = impact::vector3{1e-3, 1e-3, 1e-3};
    for (bool& periodic : domain.periodic)
    {
        periodic = true;
    }
    impact::hardSphereGas<> gas(domain, impact::pairLaw(1, 0), 3);
    std::vector<parcel*> parcels;
    fill
    (
        300, 4e-5, 6e-5, 50, false,
        [&]
        (
            const vector& x,
            const vector& U,
            const scalar d,
            const vector& omega
        )
        {
            parcel& p = add(*cloud, x, U, d, omega);
            gas.add
            ({
                parcels.size(), p.mass(), 0.5*d, toCore(p.position()),
                toCore(U), toCore(omega)
            });
            parcels.push_back(&p);
        }
    );
    const vector before = momentum(*cloud);
    const scalar E = energy(*cloud);
    scalar nPair = 0;
    for (int i = 0; i < 2; ++i)
    {
        step(*cloud);
        nPair += cloud->collisions()->lastStep().pairEvents;
    }
    gas.run(1e-5);
    EXPECT_EQ(nPair, gas.counts().pairEvents);
    EXPECT_GT(nPair, 50);
    EXPECT_NEAR(energy(*cloud)/E, 1, 1e-12);
    const scalar scale = 300*parcels[0]->mass()*50;
    EXPECT_LT(mag(momentum(*cloud) - before), 1e-12*scale);
    scalar worst = 0;
    for (std::size_t i = 0; i < parcels.size(); ++i)
    {
        const impact::gasSphere s = gas.particle(i);
        vector way =
            parcels[s.identity]->position() - fromCore(s.x);
        for (int k = 0; k < 3; ++k)
        {
            way[k] -= 1e-3*std::round(way[k]/1e-3);
        }
        worst = max(worst, mag(way)/1e-5);
        worst = max
            (worst, mag(parcels[s.identity]->U() - fromCore(s.v))/50);
    }
    EXPECT_LT(worst, 1e-7);
}


TEST_F(eventDrivenCollisionsTest, anEventKeepsMomentumAndAngularMomentum)
{
    open("box", 1e-6);
    const auto cloud = make
    (
        "solution{motion embeddedRK54;collisions{type eventDriven;"
        "restitution 0.7;friction 0.4;}}"
    );
    parcel& a = add
    (
        *cloud, vector(4e-4, 5e-4, 5e-4), vector(100, 3, -2), 1e-5,
        vector(1e6, -2e6, 3e6)
    );
    parcel& b = add
    (
        *cloud, vector(4.6e-4, 5.05e-4, 4.97e-4), vector(-20, 0, 1), 3e-5,
        vector(-3e6, 1e6, 1e5)
    );
    const vector p = momentum(*cloud);
    const vector L = angularMomentum(*cloud);
    const scalar E = energy(*cloud);
    step(*cloud);
    const auto& report = cloud->collisions()->lastStep();
    ASSERT_EQ(report.pairEvents, 1);
    EXPECT_LT(mag(momentum(*cloud) - p), 1e-12*mag(p));
    const scalar scale =
        mag(L) + a.momentOfInertia()*4e6 + b.momentOfInertia()*4e6;
    EXPECT_LT(mag(angularMomentum(*cloud) - L), 1e-12*scale);
    EXPECT_NEAR
    (
        (energy(*cloud) + report.restitutionLoss + report.frictionLoss)/E,
        1,
        1e-13
    );
    EXPECT_GT(report.frictionLoss, 0);
}


TEST_F(eventDrivenCollisionsTest, theGasReceivesEveryMotionOnce)
{
    // Drag, and collisions that cut motions short; nothing reaches a wall
    for (const char* motion : {"stock", "embeddedRK54"})
    {
        close();
        rmDir(root_/"case");
        open("plane", 1e-6);
        const auto cloud = make
        (
            "solution{motion " + std::string(motion) + ";coupled yes;"
            "sourceTerms{schemes{U explicit 1;}}"
            "collisions{type eventDriven;}}"
            "subModels{rotationalTorqueModel rotationalTorque;}",
            "hendersonDrag;magnus;",
            motion
        );
        add(*cloud, vector(4e-4, 5e-4, 5e-5), vector(200, 0, 0));
        add
        (
            *cloud, vector(5e-4, 5.03e-4, 5e-5), vector(-150, 0, 0), 1.2e-5,
            vector(0, 0, 1e6)
        );
        const vector p = momentum(*cloud);
        const scalar E = energy(*cloud);
        step(*cloud);
        const auto& report = cloud->collisions()->lastStep();
        ASSERT_EQ(report.pairEvents, 1);
        const vector given = gSum(cloud->UTrans());
        EXPECT_GT(mag(given), 1e-3*mag(p));
        EXPECT_LT(mag(momentum(*cloud) + given - p), 1e-12*mag(p));
        EXPECT_NEAR
        (
            (
                energy(*cloud) + gSum(cloud->ETrans())
              + report.restitutionLoss + report.frictionLoss
            )/E,
            1,
            1e-12
        );
    }
}


TEST_F(eventDrivenCollisionsTest, freeParcelsMoveAsWithoutCollisions)
{
    open("plane", 1e-6);
    for (const char* motion : {"stock", "embeddedRK54"})
    {
        vector x[2], U[2], omega[2];
        for (const bool on : {false, true})
        {
            const auto cloud = make
            (
                "solution{motion " + std::string(motion) + ";collisions "
              + (on ? "{type eventDriven;}" : "off;") + "}"
                "subModels{rotationalTorqueModel rotationalTorque;}",
                "hendersonDrag;magnus;",
                word(motion) + (on ? "On" : "Off")
            );
            const parcel& p = add
            (
                *cloud, vector(4e-4, 5e-4, 5e-5), vector(200, 30, 0), 1e-5,
                vector(0, 0, 1e6)
            );
            step(*cloud, 20);
            x[on] = p.position();
            U[on] = p.U();
            omega[on] = p.omega();
        }
        // Without collisions parcels move in blocks, which round differently
        EXPECT_LT(mag(x[0] - x[1]), 1e-14*mag(x[0])) << motion;
        EXPECT_LT(mag(U[0] - U[1]), 1e-13*mag(U[0])) << motion;
        EXPECT_LT(mag(omega[0] - omega[1]), 1e-13*mag(omega[0])) << motion;
        EXPECT_GT(mag(U[0] - vector(200, 30, 0)), 10);
    }
}


TEST_F(eventDrivenCollisionsTest, contactOnCurvedPathsConverges)
{
    // Two grains of different size slow down at different rates; where and
    // when they meet follows from the parabolas
    open("plane", 1e-6);
    const auto meeting =
        [this](const label n)
        {
            time_->setDeltaT(4e-5/n);
            const auto cloud = make
            (
                "solution{motion{type embeddedRK54;tolerance 1e-10;}"
                "collisions{type eventDriven;}}",
                "hendersonDrag;",
                word("n" + std::to_string(n))
            );
            const parcel& a =
                add(*cloud, vector(1e-4, 5e-4, 5e-5), vector(40, 0, 0), 2e-6);
            add(*cloud, vector(3e-4, 5.01e-4, 5e-5), vector(10, 0, 0), 8e-6);
            scalar nPair = 0;
            for (label i = 0; i < n; ++i)
            {
                step(*cloud);
                nPair += cloud->collisions()->lastStep().pairEvents;
            }
            EXPECT_EQ(nPair, 1);
            return a.position();
        };
    const vector truth = meeting(512);
    const scalar coarse = mag(meeting(4) - truth);
    const scalar fine = mag(meeting(16) - truth);
    EXPECT_LT(coarse, 2e-5);
    EXPECT_LT(fine, 0.15*coarse);
    EXPECT_GT(coarse, 0);
}


TEST_F(eventDrivenCollisionsTest, extremesStayFiniteAndConserve)
{
    open("plane", 1e-6);
    struct pair
    {
        scalar speed, d;
    };
    for
    (
        const pair& extreme :
        {pair{1e-9, 1e-5}, pair{1e5, 1e-5}, pair{100, 1e-7}}
    )
    {
        const auto cloud = make
        (
            base, "", word("sand" + name(extreme.speed) + name(extreme.d))
        );
        time_->setDeltaT(min(scalar(1e-6), 1e-4/extreme.speed));
        const scalar way = 0.5*time_->deltaTValue()*extreme.speed;
        const scalar sigma = 0.5*(1e-5 + extreme.d);
        const vector x(4e-4, 5e-4, 5e-5);
        const vector U(extreme.speed, 0, 0);
        add(*cloud, x, U);
        const parcel& b = add
        (
            *cloud, x + vector(sigma + way, 0, 0),
            vector::zero, extreme.d
        );
        const scalar E = energy(*cloud);
        step(*cloud);
        EXPECT_EQ(cloud->collisions()->lastStep().pairEvents, 1);
        EXPECT_NEAR(energy(*cloud)/E, 1, 1e-12);
        EXPECT_GT(b.U().x(), 0.999*extreme.speed);
    }
}


TEST_F(eventDrivenCollisionsTest, aLayerComesToRestOnTheWall)
{
    // e = 0.1 under a strong body force: the bounces of each parcel add up to
    // a finite time
    open("plane", 1e-6);
    g_ = dimensionedVector("g", dimAcceleration, vector(0, -1e6, 0));
    const auto cloud = make
    (
        "solution{motion embeddedRK54;collisions{type eventDriven;"
        "restitution 0.1;friction 0.2;contactDuration 1e-8;}}"
        "subModels{hardSphereWallCoeffs{patches (\"f.*\""
        "{restitution 0.1;friction 0.2;});}}",
        "gravity;"
    );
    for (int i = 0; i < 24; ++i)
    {
        add
        (
            *cloud, vector(3e-5*i + 1e-4, 1e-5, 5e-5), vector(0, -5, 0)
        );
    }
    scalar events = 0;
    for (int i = 0; i < 30; ++i)
    {
        step(*cloud);
        events += cloud->collisions()->lastStep().wallEvents;
    }
    ASSERT_EQ(cloud->size(), 24);
    EXPECT_GT(events, 100);
    for (const parcel& p : *cloud)
    {
        EXPECT_LT(mag(p.U()), 2);
        EXPECT_LT(p.position().y(), 1e-6);
    }
}


TEST_F(eventDrivenCollisionsTest, aPileInACornerComesToRest)
{
    // The number of collisions would have no bound
    open("plane", 1e-6);
    g_ = dimensionedVector("g", dimAcceleration, vector(-1e6, -1e6, 0));
    const auto cloud = make
    (
        "solution{motion embeddedRK54;collisions{type eventDriven;"
        "restitution 0.1;friction 0.2;}}"
        "subModels{hardSphereWallCoeffs{patches (\"f.*\""
        "{restitution 0.1;friction 0.2;});}}",
        "gravity;"
    );
    for (int i = 0; i < 24; ++i)
    {
        add
        (
            *cloud,
            vector(1e-5 + 1.1e-5*(i % 6), 1e-5 + 1.1e-5*(i/6), 5e-5),
            vector::zero
        );
    }
    scalar held = 0;
    for (int i = 0; i < 40; ++i)
    {
        step(*cloud);
        held += cloud->collisions()->lastStep().held;
    }
    ASSERT_EQ(cloud->size(), 24);
    EXPECT_GT(held, 0);
    EXPECT_LT(overlap(*cloud), 1e-5);
    for (const parcel& p : *cloud)
    {
        // No more than what the force of two steps gives
        EXPECT_LT(mag(p.U()), 3);
    }
}


TEST_F(eventDrivenCollisionsTest, manyFreeCollisionsInAStepHoldNobody)
{
    // A large grain through 400 small ones: more than 200 events, but no rest
    open("plane", 5e-6);
    const auto cloud = make();
    add(*cloud, vector(3e-4, 5e-4, 5e-5), vector(100, 0, 0));
    for (int i = 0; i < 400; ++i)
    {
        add
        (
            *cloud,
            vector(3.1e-4 + 2e-6*(i/20), 4.95e-4 + 5e-7*(i % 20), 5e-5),
            vector(-20, 0, 0),
            1e-7
        );
    }
    const scalar E = energy(*cloud);
    step(*cloud);
    const auto& report = cloud->collisions()->lastStep();
    EXPECT_GT(report.pairEvents, 300);
    EXPECT_EQ(report.held, 0);
    EXPECT_NEAR(energy(*cloud)/E, 1, 1e-12);
}


TEST_F(eventDrivenCollisionsTest, overlappingInjectionAsTheDictionarySays)
{
    open("plane", 1e-6);
    for (const char* way : {"refuse", "separate"})
    {
        const auto cloud = make
        (
            "solution{motion embeddedRK54;collisions{type eventDriven;"
            "overlappingInjection " + std::string(way) + ";}}",
            "",
            way
        );
        add(*cloud, vector(4e-4, 5e-4, 5e-5), vector::zero);
        step(*cloud);
        add(*cloud, vector(4.04e-4, 5e-4, 5e-5), vector::zero);
        add(*cloud, vector(6e-4, 5e-4, 5e-5), vector::zero);
        step(*cloud);
        EXPECT_EQ(cloud->size(), *way == 'r' ? 2 : 3);
        EXPECT_LT(overlap(*cloud), 1e-9);
        EXPECT_EQ(cloud->collisions()->lastStep().overlappingInjection, 1);
        step(*cloud);
        EXPECT_EQ(cloud->collisions()->lastStep().overlappingInjection, 0);
    }
}


TEST_F(eventDrivenCollisionsTest, refusesBadInput)
{
    open("plane", 1e-6);
    const auto expect =
        [this]
        (
            const std::string& entries,
            std::initializer_list<const char*> words
        )
        {
            const std::string message = refusal
            (
                "solution{collisions{type eventDriven;" + entries + "}}"
            );
            for (const char* word : words)
            {
                EXPECT_NE(message.find(word), std::string::npos) << message;
            }
        };
    expect("restitution 1.1;", {"restitution", "1.1", "[0, 1]"});
    expect("friction -1;", {"friction", "-1", "[0, 1e6]"});
    expect("tangentialRestitution 2;", {"tangentialRestitution", "[-1, 1]"});
    expect("contactDuration 0;", {"contactDuration", "(0, 1e12]"});
    expect("contactDuration -1;", {"contactDuration", "-1"});
    expect("dimension 3;", {"dimension", "3", "2"});
    expect("slabThickness 0;", {"slabThickness", "0", "(0, 1e12]"});
    expect("overlappingInjection ignore;", {"ignore", "refuse", "separate"});
    expect("type stochastic;", {"type stochastic", "eventDriven"});
    EXPECT_NE
    (
        refusal("solution{collisions on;}").find("off eventDriven"),
        std::string::npos
    );

    const auto cloud = make();
    add(*cloud, vector(4e-4, 5e-4, 5e-5), vector::zero).nParticle() = 3;
    try
    {
        step(*cloud);
        FAIL();
    }
    catch (const error& e)
    {
        EXPECT_NE(e.message().find("nParticle"), std::string::npos);
        EXPECT_NE(e.message().find("slabThickness/d = 10"), std::string::npos)
            << e.message();
    }
    cloud->first()->nParticle() = 10;
    step(*cloud);
}


TEST_F(eventDrivenCollisionsTest, annotatedDictionaryIsValid)
{
    open("plane", 1e-6);
    IFstream is
    (
        fileName(std::getenv("PARCEL_IMPACT_DIR"))
       /"etc/caseDicts/annotated/eventDrivenCollisions"
    );
    dictionary dict(is);
    ASSERT_TRUE(dict.subDict("solution").found("collisions"));
    OStringStream os;
    dict.write(os, false);
    const auto cloud = make(os.str());
    ASSERT_TRUE(cloud->collisions());
    add(*cloud, vector(4e-4, 5e-4, 5e-5), vector(1, 0, 0));
    step(*cloud);
    EXPECT_EQ(cloud->size(), 1);
}
