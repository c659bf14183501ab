/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.

Description
    The cell of many points against the search of the mesh itself, on a box
    mesh and on the same mesh with one point moved: inside, outside, on faces,
    edges and corners.
\*---------------------------------------------------------------------------*/

#include "boxMeshTest.H"
#include "cellLocator.H"

#include <gtest/gtest.h>
#include <random>

using namespace Foam;

class cellLocatorTest
:
    public boxMeshTest
{
protected:

    //- The cell found holds the point; none is found where the mesh has none
    void check(const point& p) const
    {
        const label found = cellLocator::New(*mesh_).find(p);
        if (found == -1)
        {
            EXPECT_EQ(mesh_->findCell(p, polyMesh::CELL_TETS), -1) << p.x()
                << ' ' << p.y() << ' ' << p.z();
        }
        else
        {
            EXPECT_TRUE(mesh_->pointInCell(p, found, polyMesh::CELL_TETS));
        }
    }

    void checkAll() const
    {
        std::mt19937 generator(1);
        std::uniform_real_distribution<double> uniform(-0.1, 1.1);
        label nInside = 0;
        for (label i = 0; i < 2000; ++i)
        {
            const point p
            (
                uniform(generator), uniform(generator), uniform(generator)
            );
            check(p);
            nInside += cellLocator::New(*mesh_).find(p) != -1;
        }

        // 2000/1.2^3 of them, standard deviation 22
        EXPECT_NEAR(nInside, 1157, 110);

        for (const point& p : mesh_->points())
        {
            check(p);
            EXPECT_NE(cellLocator::New(*mesh_).find(p), -1);
        }
        for (const point& p : mesh_->faceCentres())
        {
            check(p);
        }
        forAll(mesh_->cellCentres(), celli)
        {
            const point& p = mesh_->cellCentres()[celli];
            EXPECT_EQ(cellLocator::New(*mesh_).find(p), celli);
        }
    }
};


TEST_F(cellLocatorTest, findsWhatTheMeshFinds)
{
    checkAll();
}


TEST_F(cellLocatorTest, followsTheMesh)
{
    const point p(0.52, 0.48, 0.52);
    EXPECT_TRUE
    (
        mesh_->pointInCell
        (
            p, cellLocator::New(*mesh_).find(p), polyMesh::CELL_TETS
        )
    );
    warp();
    checkAll();
    check(p);
}
