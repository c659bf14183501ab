/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.

Description
    The gas velocity that parcels see on walls, in their edges and corners:
    every scheme, plane, curved and moving walls, symmetry planes.
\*---------------------------------------------------------------------------*/

#include "OFstream.H"
#include "channelTest.H"
#include "cellGas.H"
#include "coreVector.H"
#include "largest.H"
#include "volFields.H"
#include "wallGasInterpolation.H"
#include "wallPolyPatch.H"

#include <gtest/gtest.h>
#include <cstdlib>
#include <map>
#include <random>

using namespace Foam;

namespace
{

//- Between two quarters of cylinders of radius 1 and 2, in a gas that blows
//  through everything
class wallGasTest
:
    public folderTest
{
protected:

    autoPtr<Time> time_;
    autoPtr<fvMesh> mesh_;
    autoPtr<volVectorField> U_;

    void write(const char* name, const std::string& kind, const char* text)
    {
        OFstream os(root_/"case"/name);
        os.writeQuoted
        (
            "FoamFile{version 2.0; format ascii; class " + kind
          + "; object x;}\n" + text,
            false
        );
    }

    void SetUp() override
    {
        folderTest::SetUp();
        for (const char* folder : {"system", "constant", "0"})
        {
            mkDir(root_/"case"/folder);
        }
        write
        (
            "system/controlDict",
            "dictionary",
            "deltaT 1; endTime 1; writeInterval 1; writePrecision 17;"
        );
        write
        (
            "system/fvSchemes",
            "dictionary",
            "ddtSchemes{} gradSchemes{} divSchemes{} laplacianSchemes{}"
            " snGradSchemes{} interpolationSchemes{default linear;}"
        );
        write("system/fvSolution", "dictionary", "");
        write
        (
            "system/blockMeshDict",
            "dictionary",
            "vertices ((1 0 0) (2 0 0) (0 2 0) (0 1 0)"
            " (1 0 1) (2 0 1) (0 2 1) (0 1 1));"
            "blocks (hex (0 1 2 3 4 5 6 7) (4 8 3) simpleGrading (1 1 1));"
            "edges (arc 0 3 (0.70710678118654752 0.70710678118654752 0)"
            " arc 4 7 (0.70710678118654752 0.70710678118654752 1)"
            " arc 1 2 (1.4142135623730951 1.4142135623730951 0)"
            " arc 5 6 (1.4142135623730951 1.4142135623730951 1));"
            "boundary ("
            "inner { type wall; faces ((0 4 7 3)); }"
            "outer { type patch; faces ((1 2 6 5)); }"
            "below { type symmetryPlane; faces ((0 1 5 4)); }"
            "aside { type wall; faces ((3 7 6 2)); }"
            "back { type wall; faces ((0 3 2 1)); }"
            "front { type patch; faces ((4 5 6 7)); });"
        );
        write
        (
            "0/U",
            "volVectorField",
            "dimensions [0 1 -1 0 0 0 0]; internalField uniform (0 0 0);"
            "boundaryField {"
            "inner { type slip; } outer { type zeroGradient; }"
            "below { type symmetryPlane; }"
            "aside { type fixedValue; value uniform (7 11 3); }"
            "back { type partialSlip; valueFraction uniform 0.3; }"
            "front { type noSlip; } }"
        );
        const std::string command
        (
            "blockMesh -case " + root_ + "/case > " + root_ + "/log 2>&1"
        );
        ASSERT_EQ(std::system(command.c_str()), 0);
        time_.reset
        (
            new Time(Time::controlDictName, root_, fileName("case"))
        );
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
        U_ = velocity(mesh_());
        vectorField& u = U_->primitiveFieldRef();
        forAll(u, i)
        {
            const vector& x = mesh_->C()[i];
            u[i] = vector(40 + 90*x.y(), -70 + 50*x.x()*x.y(), 60 - 90*x.z());
        }
        U_->correctBoundaryConditions();
        selectWallGasInterpolation();
    }

    void TearDown() override
    {
        U_.clear();
        mesh_.clear();
        time_.clear();
        folderTest::TearDown();
    }

    //- u.n of the wall of a patch
    static scalar wallSpeed(const word& patch, const vector& n)
    {
        return patch == "aside" ? (vector(7, 11, 3) & n) : 0;
    }

    //- Call with the patch, tetrahedron and normal of all triangles of walls
    template<class Function>
    void onWalls(const Function& look) const
    {
        for (const polyPatch& patch : mesh_->boundaryMesh())
        {
            if (patch.name() == "outer")
            {
                continue;
            }
            forAll(patch, i)
            {
                const label facei = patch.start() + i;
                for (label tetPti = 1; tetPti < patch[i].size() - 1; ++tetPti)
                {
                    const tetIndices tet
                    (
                        patch.faceCells()[i],
                        facei,
                        tetPti
                    );
                    const vector n =
                        tet.faceTriIs(mesh_()).unitNormal(mesh_->points());
                    look(patch.name(), tet, n);
                }
            }
        }
    }

    //- Largest u.n - w on the triangles
    template<class Velocity>
    scalar worst(const Velocity& velocity) const
    {
        std::mt19937 random(1);
        std::uniform_real_distribution<double> uniform(0, 1);
        scalar maxSpeed = 0;
        onWalls
        (
            [&](const word& patch, const tetIndices& tet, const vector& n)
            {
                for (int trial = 0; trial < 5; ++trial)
                {
                    const double a = uniform(random);
                    const double b = (1 - a)*uniform(random);
                    const vector u =
                        velocity(barycentric(0, a, b, 1 - a - b), tet);
                    maxSpeed = largest
                        (maxSpeed, mag((u & n) - wallSpeed(patch, n)));
                }
            }
        );
        return maxSpeed;
    }

    //- Largest u.n - w of all triangles that meet in an edge or corner, seen
    //  from each of them
    template<class Velocity>
    scalar worstInEdges(const Velocity& velocity) const
    {
        struct condition
        {
            word patch;
            vector n;
        };
        std::map<std::pair<label, label>, std::vector<condition>> edges;
        const auto key =
            [](const label a, const label b)
            {
                return std::make_pair(min(a, b), max(a, b));
            };
        onWalls
        (
            [&](const word& patch, const tetIndices& tet, const vector& n)
            {
                const triFace f(tet.faceTriIs(mesh_()));
                for (label j = 0; j < 3; ++j)
                {
                    edges[key(f[j], f[(j + 1)%3])].push_back({patch, n});
                    edges[key(f[j], f[j])].push_back({patch, n});
                }
            }
        );
        scalar maxSpeed = 0;
        label nEdges = 0;
        onWalls
        (
            [&](const word& patch, const tetIndices& tet, const vector& n)
            {
                const triFace f(tet.faceTriIs(mesh_()));
                for (label j = 0; j < 6; ++j)
                {
                    const label k = j < 3 ? (j + 1)%3 : j - 3;
                    barycentric y(0, 0, 0, 0);
                    y[j%3 + 1] += 0.3;
                    y[k + 1] += 0.7;
                    const vector u = velocity(y, tet);
                    const point& a = mesh_->points()[f[j%3]];
                    const point& b = mesh_->points()[f[k]];
                    const bool facets =
                        max(min(a.x(), a.y()), min(b.x(), b.y())) > 1e-9;
                    for (const condition& c : edges[key(f[j%3], f[k])])
                    {
                        // Of two facets of the curved wall only the parcel's
                        // own is exact
                        if
                        (
                            c.patch != patch
                         && !(c.patch == "inner" && facets)
                        )
                        {
                            ++nEdges;
                            maxSpeed =
                                largest
                                (
                                    maxSpeed,
                                    mag((u & c.n) - wallSpeed(c.patch, c.n))
                                );
                        }
                    }
                }
            }
        );
        EXPECT_GT(nEdges, 100);
        return maxSpeed;
    }
};

} // End anonymous namespace


TEST_F(wallGasTest, everySchemeMeetsTheWalls)
{
    const auto names =
        interpolation<vector>::dictionaryConstructorTablePtr_->sortedToc();
    ASSERT_GE(names.size(), 6);

    wallGasVelocity::New(U_());
    for (const word& name : names)
    {
        const auto scheme = interpolation<vector>::New(name, U_());
        EXPECT_EQ(scheme->type(), name);

        // On the faces of a cell the stock pointMVC divides by zero
        const scalar off = name == "pointMVC" ? 1e-6 : 0;
        const auto velocity =
            [&](const barycentric& y, const tetIndices& tet)
            {
                return scheme->interpolate
                (
                    off*barycentric(1, 0, 0, 0) + (1 - off)*y,
                    tet
                );
            };
        EXPECT_LT(worst(velocity), 1e-11 + 300*off) << name;
        if (off == 0)
        {
            EXPECT_LT(worstInEdges(velocity), 1e-11) << name;
        }
    }
}


TEST_F(wallGasTest, theWallsMatterWithoutIt)
{
    // What the schemes give is that of the stock ones for any other field
    volVectorField V("V", U_());
    for (const word name : {"cell", "cellPoint", "cellPointFace"})
    {
        const auto scheme = interpolation<vector>::New(name, V);
        const auto velocity =
            [&](const barycentric& y, const tetIndices& tet)
            {
                return scheme->interpolate(y, tet);
            };
        EXPECT_GT(worst(velocity), 1) << name;
        EXPECT_GT(worstInEdges(velocity), 1) << name;
    }
}


TEST_F(wallGasTest, theGasOfTheCellsMeetsTheWalls)
{
    const volScalarField one
    (
        IOobject("one", time_->timeName(), mesh_()),
        mesh_(),
        dimensionedScalar("one", dimless, 1)
    );
    for (const word& name : cellGas::schemes)
    {
        SCOPED_TRACE(name);
        cellGas gas(mesh_(), name);
        EXPECT_EQ(gas.scheme(), name);
        gas.update(U_(), nullptr, one, one, nullptr);
        const auto velocity =
            [&](const barycentric& y, const tetIndices& tet)
            {
                const particle p
                    (mesh_(), y, tet.cell(), tet.face(), tet.tetPt());
                const impact::vector3 x = toCore(p.position());
                cellGas::field store;
                const label celli = gas.cells().locate(tet.cell(), x);
                return fromCore(gas.at(celli, store)(x).u);
            };
        EXPECT_LT(worst(velocity), 1e-11);
        EXPECT_LT(worstInEdges(velocity), 1e-11);

        // The stock clouds see the same
        const auto scheme = interpolation<vector>::New(name, U_());
        onWalls
        (
            [&](const word&, const tetIndices& tet, const vector&)
            {
                const barycentric y(0.4, 0.3, 0.2, 0.1);
                if (name == "cellPoint")
                {
                    const vector stock = scheme->interpolate(y, tet);
                    EXPECT_LT(mag(velocity(y, tet) - stock), 1e-11);
                }
            }
        );
    }
}


TEST_F(wallGasTest, wallsThatOneLinearFieldCannotMeet)
{
    // One cell, a prism on a polygon whose first sides are walls
    struct shape
    {
        std::vector<vector> corners;
        label nWalls;
        label nSplit;
    };
    const std::vector<shape> shapes
    {
        // A floor of two facets, at 23 degrees
        {
            {
                vector(0, 0.1, 0), vector(0.5, 0, 0), vector(1, 0.1, 0),
                vector(1, 1, 0), vector(0, 1, 0)
            },
            2, 1
        },
        // A channel that narrows, open at one end
        {
            {
                vector(1, 0.8, 0), vector(0, 1, 0), vector(0, 0, 0),
                vector(1, 0.1, 0)
            },
            3, 1
        },
        // One that does not
        {
            {
                vector(1, 1, 0), vector(0, 1, 0), vector(0, 0, 0),
                vector(1, 0, 0)
            },
            3, 0
        }
    };
    U_.clear();
    mesh_.clear();
    for (const shape& s : shapes)
    {
        const label n = s.corners.size();
        SCOPED_TRACE(n*10 + s.nSplit);
        pointField points(2*n);
        faceList faces(n + 2);
        face front(n), back(n);
        for (label i = 0; i < n; ++i)
        {
            const label j = (i + 1) % n;
            points[i] = s.corners[i];
            points[n + i] = s.corners[i] + vector(0, 0, 0.5);
            faces[i] = face({i, j, j + n, i + n});
            front[i] = n + i;
            back[i] = n - 1 - i;
        }
        faces[n] = front;
        faces[n + 1] = back;
        fvMesh mesh
        (
            IOobject(fvMesh::defaultRegion, time_->timeName(), time_()),
            std::move(points),
            std::move(faces),
            labelList(n + 2, Zero),
            labelList()
        );
        List<polyPatch*> patches
        ({
            new wallPolyPatch
            (
                "walls", s.nWalls, 0, 0, mesh.boundaryMesh(), "wall"
            ),
            new polyPatch
            (
                "rest", n + 2 - s.nWalls, s.nWalls, 1, mesh.boundaryMesh(),
                "patch"
            )
        });
        mesh.addFvPatches(patches);
        volVectorField U
        (
            IOobject("U", time_->timeName(), mesh),
            mesh,
            dimensionedVector("U", dimVelocity, vector(100, -30, 20)),
            wordList({"slip", "zeroGradient"})
        );
        U.correctBoundaryConditions();
        const volScalarField one
        (
            IOobject("one", time_->timeName(), mesh),
            mesh,
            dimensionedScalar("one", dimless, 1)
        );
        cellGas gas(mesh, "cellLinear");
        gas.update(U, nullptr, one, one, nullptr);
        EXPECT_EQ(gas.cells().nSplit(), s.nSplit);
        for (label facei = 0; facei < s.nWalls; ++facei)
        {
            for (label tetPti = 1; tetPti < 3; ++tetPti)
            {
                const triFace t =
                    tetIndices(0, facei, tetPti).faceTriIs(mesh);
                const point at =
                    0.2*mesh.points()[t[0]]
                  + 0.3*mesh.points()[t[1]]
                  + 0.5*mesh.points()[t[2]];
                const impact::vector3 x = toCore(at);
                cellGas::field store;
                const label celli = gas.cells().locate(0, x);
                const vector u = fromCore(gas.at(celli, store)(x).u);
                EXPECT_NEAR(u & t.unitNormal(mesh.points()), 0, 1e-11);
                EXPECT_GT(mag(u), 10);
            }
        }
    }
}


TEST_F(wallGasTest, followsTheGasAndTurnsNoFlowAlongACurvedWall)
{
    wallGasVelocity::New(U_()).pointValues();

    // Rotation about the axis: along the curved wall, and along the planes
    // across the axis
    volVectorField& U = U_();
    vectorField& u = U.primitiveFieldRef();
    forAll(u, i)
    {
        u[i] = 100*(vector(0, 0, 1) ^ mesh_->C()[i]);
    }
    U.correctBoundaryConditions();
    const auto scheme = interpolation<vector>::New("cellPoint", U);
    label n = 0;
    onWalls
    (
        [&](const word& patch, const tetIndices& tet, const vector& normal)
        {
            const point x =
                tet.faceTriIs(mesh_()).centre(mesh_->points());
            const scalar angle = std::atan2(x.y(), x.x());
            if (patch == "inner" && angle > 0.4 && angle < 1.1
             && x.z() > 0.35 && x.z() < 0.65)
            {
                const vector v = scheme->interpolate
                (
                    barycentric(0, 1./3, 1./3, 1./3),
                    tet
                );
                // The slip condition hands on what the next cell has
                EXPECT_NEAR(mag(v), 112.5, 2.5);
                EXPECT_NEAR(v & normal, 0, 1e-11);
                ++n;
            }
        }
    );
    EXPECT_GT(n, 2);
}
