/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.

Description
    Parcels of the spin-carrying cloud in arrays: what goes in comes out, seen
    through a constant cloud and as objects; gaps and order; which clouds have
    them; and that they move as objects do.
\*---------------------------------------------------------------------------*/

#include "spinningCloudTest.H"

#include <map>
#include <sstream>

typedef basicSpinningCloud::parcelType parcel;

namespace
{

//- All that a parcel has, but for its coordinates in the mesh
std::string properties(const parcel& p)
{
    OStringStream os;
    os.precision(17);
    parcel::visitFields
    (
        [&](const word& name, const auto& value)
        {
            os  << name << ' ' << value(p) << ' ';
        }
    );
    os  << p.temperature() << ' ' << p.nEddies() << ' ' << p.position() << ' ' << p.cell() << ' '
        << p.origProc() << ' ' << p.origId() << ' ' << p.active();
    return os.str();
}


//- Of all parcels, in their order
std::vector<std::string> seen(const basicSpinningCloud& cloud)
{
    std::vector<std::string> all;
    for (const parcel& p : cloud)
    {
        all.push_back(properties(p));
    }
    return all;
}

} // End anonymous namespace


//- A channel with parcels of all kinds
class spinningArrays
:
    public spinningCloudTest
{
protected:

    void fill(basicSpinningCloud& cloud, const label n)
    {
        for (label i = 0; i < n; ++i)
        {
            const vector x(0.002 + 0.03*i/n, 0.013, 0);
            parcel* p = new parcel(mesh_(), x, mesh_->findCell(x));
            p->d() = 1e-6*(i + 1);
            p->rho() = 2000 + i;
            p->U() = vector(i, 2*i, 0);
            p->omega() = vector(0, 0, 1e3*i);
            p->nParticle() = i + 0.5;
            p->age() = 1e-3*i;
            p->typeId() = i % 3;
            p->nImpacts() = i % 5;
            p->nEddies() = i % 7;
            p->tTurb() = 0.1*i;
            p->UTurb() = vector(i, -i, 3);
            p->dTarget() = i;
            p->active(i % 4 != 3);
            cloud.addParticle(p);
        }
    }
};


TEST_F(spinningArrays, giveBackWhatTheyGot)
{
    open();
    const auto cloud = make(embedded);
    cloud->arrays().follow(true, false, true);
    fill(*cloud, 40);

    // The convex cells take parcels of a plane mesh to its middle
    for (parcel& p : *cloud)
    {
        p.fly(cloud->cells());
    }
    const auto before = seen(*cloud);
    ASSERT_EQ(before.size(), 40u);
    cloud->pack(cloud->cells());

    // Three quarters are active
    EXPECT_EQ(cloud->arrays().size(), 30);
    EXPECT_EQ(cloud->objects().size(), 10);
    EXPECT_EQ(cloud->size(), 40);
    EXPECT_EQ(cloud->nParcels(), 40);
    const auto packed = seen(*cloud);
    std::vector<std::string> expected;
    for (const bool active : {true, false})
    {
        for (std::size_t i = 0; i < before.size(); ++i)
        {
            if ((i % 4 != 3) == active)
            {
                expected.push_back(before[i]);
            }
        }
    }
    EXPECT_EQ(packed, expected);

    // Whoever can change parcels has objects, whose changes stay
    for (parcel& p : *cloud)
    {
        p.age() += 1;
    }
    EXPECT_EQ(cloud->arrays().size(), 0);
    for (parcel& p : *cloud)
    {
        p.age() -= 1;
    }
    EXPECT_EQ(cloud->size(), 40);
    cloud->clear();
    EXPECT_EQ(cloud->size(), 0);

    // Nothing of one parcel is left to others
    fill(*cloud, 1);
    for (parcel& p : *cloud)
    {
        p.UTurb() = vector::zero;
        p.d() = 5e-6;
        p.fly(cloud->cells());
    }
    const auto plain = seen(*cloud);
    cloud->pack(cloud->cells());
    EXPECT_EQ(cloud->arrays().size(), 1);
    EXPECT_EQ(seen(*cloud), plain);
}


TEST_F(spinningArrays, fillGapsAndSortByCell)
{
    open();
    const auto cloud = make(embedded);
    fill(*cloud, 40);
    cloud->pack(cloud->cells());
    const auto before = seen(*cloud);
    const auto& arrays = cloud->arrays();
    const auto byProperties = [&]()
    {
        auto all = seen(*cloud);
        std::sort(all.begin(), all.end());
        return all;
    };
    const auto all = byProperties();

    // First, last, and two beside each other
    for (const label i : {29, 0, 28, 7})
    {
        const parcel* p = cloud->take(i);
        EXPECT_EQ(properties(*p), before[i]);
    }
    cloud->arrays().fill();
    EXPECT_EQ(arrays.size(), 26);
    EXPECT_EQ(cloud->size(), 40);
    EXPECT_EQ(byProperties(), all);

    // In disorder, then sorted: those of a cell keep their order
    cloud->pack(cloud->cells());
    ASSERT_FALSE(std::is_sorted(arrays.cell.begin(), arrays.cell.end()));
    std::map<label, std::vector<label>> ofCell;
    for (label i = 0; i < arrays.size(); ++i)
    {
        ofCell[arrays.cell[i]].push_back(arrays.origId[i]);
    }
    cloud->arrays().sort(cloud->cells().size());
    EXPECT_TRUE(std::is_sorted(arrays.cell.begin(), arrays.cell.end()));
    for (label i = 0; i < arrays.size(); ++i)
    {
        auto& ids = ofCell[arrays.cell[i]];
        ASSERT_FALSE(ids.empty());
        EXPECT_EQ(arrays.origId[i], ids.front());
        ids.erase(ids.begin());
    }
    EXPECT_EQ(byProperties(), all);
}


TEST_F(spinningArrays, areWhereTheCoreHasTheForces)
{
    open(100, 2e4, 3e4);
    struct kind
    {
        const char* name;
        std::string changes;
        const char* forces;
        bool inArrays;
    };
    const std::string tracks
    (
        "cloudFunctions{tracks{type particleTracks; trackInterval 1;"
        " maxSamples 10; resetOnWrite no;}}"
    );
    for
    (
        const kind& k :
        {
            kind{"core", embedded, "hendersonDrag;magnus;", true},
            kind{"listed", embedded, "hendersonDrag;unfelt;", false},
            kind{"watched", embedded + tracks, "hendersonDrag;", false},
            kind{"stock", "", "hendersonDrag;", false}
        }
    )
    {
        const auto cloud = make(k.changes, k.name, k.forces);
        step(*cloud, 3);
        const label n = cloud->arrays().size();
        EXPECT_EQ(n > 0, k.inArrays) << k.name;
        EXPECT_GT(cloud->size(), 0);

        // What spins and temperatures take is not there without them
        if (k.inArrays)
        {
            const auto still = make
            (
                k.changes + "solution{rotation off;}", "still", k.forces
            );
            EXPECT_EQ(cloud->arrays().bytes() - still->arrays().bytes(), 24);
            EXPECT_EQ(still->arrays().bytes(), 100);
        }
    }
}
