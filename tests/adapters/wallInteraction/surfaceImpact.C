/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.

Description
    Impacts that a wall model publishes, as impactRecords and surfaceImpact
    take them: energy lost against exact values, captured mass, the columns of
    the log, several functions at once, moving walls, patches of either kind,
    clouds whose parcels spin; the annotated dictionaries.
\*---------------------------------------------------------------------------*/

#include "IFstream.H"
#include "OFstream.H"
#include "PublishingWall.H"
#include "SurfaceImpact.H"
#include "basicKinematicCloud.H"
#include "basicKinematicCollidingCloud.H"
#include "channelTest.H"

#include <gtest/gtest.h>
#include <cstdlib>
#include <fstream>
#include <map>
#include <memory>
#include <sstream>

makePatchInteractionModelType(PublishingWall, basicKinematicCloud);

using namespace Foam;

namespace
{

typedef basicKinematicCloud::kinematicCloudType cloudType;
typedef surfaceImpactStatistics statistics;

//- A row of a table by the names of its columns
typedef std::map<std::string, std::string> row;


//- The channel of tests/cases/particles, without gas forces
class surfaceImpactTest
:
    public channelTest
{
protected:

    autoPtr<volScalarField> rho_;
    autoPtr<volVectorField> U_;
    autoPtr<volScalarField> mu_;

    void TearDown() override
    {
        mu_.clear();
        U_.clear();
        rho_.clear();
        channelTest::TearDown();
    }

    //- The cloud's dictionary with a rake of parcels and changes
    void properties(const std::string& changes)
    {
        const fileName file(root_/"case/constant/kinematicCloudProperties");
        IFstream is(file);
        dictionary dict(is);
        dict.remove("cloudFunctions");
        dict.subDict("subModels").subDict("particleForces").clear();
        dict.subDict("solution").subDict("integrationSchemes")
            .set("U", word("Euler"));
        dict.merge(dictionary(IStringStream(changes)()));
        OFstream os(file);
        os  << "FoamFile{version 2.0; format ascii; class dictionary;"
            << " object kinematicCloudProperties;}" << nl;
        dict.write(os, false);
    }

    template<class Type>
    autoPtr<GeometricField<Type, fvPatchField, volMesh>> field
    (
        const word& name,
        const dimensioned<Type>& value
    )
    {
        return autoPtr<GeometricField<Type, fvPatchField, volMesh>>
        (
            new GeometricField<Type, fvPatchField, volMesh>
            (
                IOobject(name, time_->timeName(), mesh_()),
                mesh_(),
                value,
                "fixedValue"
            )
        );
    }

    void open()
    {
        openMesh();
        rho_ = field("rho", dimensionedScalar("", dimDensity, 1));
        U_ = field("U", dimensionedVector(dimVelocity, Zero));
        mu_ = field
        (
            "thermo:mu",
            dimensionedScalar("", dimDynamicViscosity, 1e-5)
        );
    }

    template<class CloudType>
    std::unique_ptr<CloudType> make()
    {
        return std::make_unique<CloudType>
        (
            "kinematicCloud",
            rho_(),
            U_(),
            mu_(),
            dimensionedVector(dimAcceleration, Zero)
        );
    }

    template<class CloudType>
    void evolve(CloudType& cloud, const label nSteps)
    {
        for (label i = 0; i < nSteps; ++i)
        {
            (*time_)++;
            cloud.evolve();
            if (time_->writeTime())
            {
                time_->write();
            }
        }
    }

    static const statistics& results(cloudType& cloud, const label i)
    {
        return *dynamic_cast<const SurfaceImpact<cloudType>&>
        (
            cloud.functions()[i]
        ).recorder();
    }

    static scalar sum(const statistics& s, statistics::quantity q)
    {
        // Without an axis the items are the patches
        scalar total = 0;
        for (std::size_t i = 0; i < s.statistics().nItems(); ++i)
        {
            total += s.statistics().sum(i, q);
        }
        return total;
    }

    std::vector<row> table(const std::string& path) const
    {
        std::ifstream file(root_ + "/case/postProcessing/" + path);
        std::vector<std::string> names;
        std::vector<row> rows;
        std::string line;
        for (bool first = true; std::getline(file, line); first = false)
        {
            std::istringstream words(line + ",");
            std::string word;
            std::vector<std::string> values;
            while (std::getline(words, word, ','))
            {
                values.push_back(word);
            }
            if (first)
            {
                names = values;
                continue;
            }
            EXPECT_EQ(values.size(), names.size());
            row r;
            for (std::size_t i = 0; i < names.size(); ++i)
            {
                r[names[i]] = values[i];
            }
            rows.push_back(r);
        }
        return rows;
    }
};


//- Seven parcels towards the plate, which they meet in the first 20 steps
const char* const rake =
    "subModels{injectionModels{rake{start (0.095 0.005 0); end (0.095 0.035 0);"
    " U0 (1000 0 0); diameter 5e-6; nParticle 3;}}";

const scalar mass = 2500*M_PI/6*1.25e-16;

} // End anonymous namespace


TEST_F(surfaceImpactTest, takesWhatTheWallTells)
{
    properties
    (
        std::string(rake)
      + "patchInteractionModel publishingWall; publishingWallCoeffs"
        "{published (plate); restitution 0.6; captureSpeed 10;}}"
        "cloudFunctions{"
        "a{type surfaceImpact; patches (plate); log yes;}"
        "b{type surfaceImpact; patches (plate); threshold 2000;}"
        "c{type impactRecords; patches (plate);}}"
    );
    open();
    auto cloud = make<basicKinematicCloud>();
    evolve(*cloud, 50);

    const scalar n = 7*3;
    const scalar energy = mass/2*1e6;
    const scalar spin = 0.05*mass*25e-12*1e16;
    const statistics& a = results(*cloud, 0);
    EXPECT_EQ(sum(a, statistics::NUMBER), n);
    EXPECT_EQ(sum(a, statistics::FIRST), n);
    EXPECT_EQ(sum(a, statistics::IMPACTS), 7);
    EXPECT_EQ(sum(a, statistics::REBOUND_UNKNOWN), 0);
    EXPECT_NEAR(sum(a, statistics::NORMAL_SPEED)/n, 1000, 1e-9);
    EXPECT_NEAR(sum(a, statistics::ANGLE)/n, M_PI/2, 1e-12);
    EXPECT_NEAR(sum(a, statistics::MASS)/(n*mass), 1, 1e-13);
    EXPECT_NEAR(sum(a, statistics::INCIDENT)/(n*energy), 1, 1e-13);
    EXPECT_NEAR
    (
        sum(a, statistics::LOST_TRANSLATIONAL)/(n*energy*(1 - 0.36)), 1, 1e-13
    );
    EXPECT_NEAR
    (
        sum(a, statistics::LOST)/(n*(energy*(1 - 0.36) - spin)), 1, 1e-13
    );
    EXPECT_GT(spin/energy, 0.02);
    EXPECT_EQ(sum(a, statistics::CAPTURED), 0);
    EXPECT_EQ(sum(results(*cloud, 1), statistics::IMPACTS), 0);

    // Rates: of the plate's area and 50 us
    const auto patch = table("a/kinematicCloud/5e-05/byPatch.csv");
    ASSERT_EQ(patch.size(), 1u);
    EXPECT_EQ(patch[0].at("patch"), "plate");
    EXPECT_NEAR(std::stod(patch[0].at("area")), 0.04*1e-3, 1e-16);
    EXPECT_NEAR
    (
        std::stod(patch[0].at("specificPowerTranslational"))
       /(n*energy*0.64/(4e-5*5e-5)), 1, 1e-10
    );
    EXPECT_EQ(patch[0].at("reboundKnown"), "1");

    // The logs hold both states, and are the same but for their first lines
    const auto log = table("a/kinematicCloud/0/impacts.csv");
    ASSERT_EQ(log.size(), 7u);
    EXPECT_EQ(log, table("c/kinematicCloud/0/impacts.csv"));
    for (const row& r : log)
    {
        EXPECT_NEAR(std::stod(r.at("Ux")), 1000, 1e-9);
        EXPECT_NEAR(std::stod(r.at("UxOut")), -600, 1e-9);
        EXPECT_NEAR(std::stod(r.at("omegaZOut")), 1e8, 1e-4);
        EXPECT_EQ(r.at("omegaZ"), "0");
        EXPECT_EQ(r.at("captured"), "0");
        EXPECT_EQ(r.at("firstImpact"), "1");
        EXPECT_EQ(r.at("reboundKnown"), "1");
    }

    // Fields of the time directory, on the patch that has them
    const volScalarField power
    (
        IOobject
        (
            "kinematicCloud:a:specificPower",
            time_->timeName(),
            mesh_(),
            IOobject::MUST_READ,
            IOobject::NO_WRITE,
            false
        ),
        mesh_()
    );
    const label plate = mesh_->boundaryMesh().findPatchID("plate");
    EXPECT_NEAR
    (
        gSum(power.boundaryField()[plate]*mesh_->magSf().boundaryField()[plate])
       *5e-5/sum(a, statistics::LOST),
        1, 1e-12
    );
    EXPECT_EQ(gMax(power.primitiveField()), 0);
    EXPECT_EQ(power.dimensions(), dimPower/dimArea);
}


TEST_F(surfaceImpactTest, countsWhatStaysOnTheWall)
{
    properties
    (
        std::string(rake)
      + "patchInteractionModel publishingWall; publishingWallCoeffs"
        "{published (plate); restitution 0.6; captureSpeed 2000;}}"
        "cloudFunctions{a{type surfaceImpact; patches (plate); log yes;}}"
    );
    open();
    auto cloud = make<basicKinematicCloud>();
    evolve(*cloud, 50);
    const statistics& a = results(*cloud, 0);
    EXPECT_NEAR(sum(a, statistics::CAPTURED)/(21*mass), 1, 1e-13);
    EXPECT_NEAR(sum(a, statistics::LOST)/(21*mass/2*1e6), 1, 1e-13);
    EXPECT_EQ(cloud->size(), 0);
    for (const row& r : table("a/kinematicCloud/0/impacts.csv"))
    {
        EXPECT_EQ(r.at("captured"), "1");
    }
}


TEST_F(surfaceImpactTest, addsUpTheHeat)
{
    properties("");
    open();
    const label plate = mesh_->boundaryMesh().findPatchID("plate");
    boolList patches(mesh_->boundaryMesh().size(), false);
    patches[plate] = true;
    const auto make = [&](const std::string& heat)
    {
        const dictionary dict
        (
            IStringStream("type surfaceImpact; patches (plate);" + heat)()
        );
        return std::make_unique<statistics>
        (
            dict, "kinematicCloud", "a", mesh_(), patches
        );
    };

    // h = 700 T + 0.15 T^2, melting between 900 and 1000 K
    const impact::specificHeat material({700, 0.3}, {900, 1000, 4e5});
    wallImpact i{};
    i.patch = plate;
    i.n = vector(0, 1, 0);
    i.U0 = vector(0, -100, 0);
    i.U1 = vector(0, 60, 0);
    i.d = 5e-6;
    i.mass = mass;
    i.nParticle = 3;
    i.T = 1100;
    i.material = &material;
    const auto h = [](scalar T){ return 700*T + 0.15*T*T; };

    const auto s = make("heat{wallTemperature 400;}");
    (*time_)++;
    s->begin(true);
    s->take(i, true, true);
    wallImpact stays(i);
    stays.captured = true;
    stays.origId = 1;
    stays.T = 500;
    s->take(stays, true, true);
    wallImpact stock(i);
    stock.material = nullptr;
    stock.Cp = 900;
    stock.origId = 2;
    s->take(stock, true, true);

    const scalar w = 3*mass;
    const scalar kinetic = w*(0.5*(1e4 - 3600)*2 + 0.5*1e4);
    const scalar stayed = w*(h(500) - h(400));
    s->end();
    const auto total = [&](statistics::quantity q)
    {
        return sum(*s, q);
    };
    EXPECT_NEAR(total(statistics::LOST)/kinetic, 1, 1e-12);
    EXPECT_NEAR(total(statistics::HEAT)/(kinetic + stayed), 1, 1e-12);
    EXPECT_NEAR
    (
        total(statistics::HEAT_INCIDENT)
       /(w*(h(1100) + 4e5 - h(400)) + stayed + w*900*700),
        1,
        1e-12
    );

    // Without a temperature, of parcel or wall
    EXPECT_THROW(s->begin(false), IOerror);
    EXPECT_THROW(make("heat{}"), IOerror);
    EXPECT_THROW(make("heat{wallTemperature -1;}"), IOerror);
    EXPECT_THROW(make("heat{wallTemprature 300;}"), IOerror);
}


TEST_F(surfaceImpactTest, tellsPatchesOfEitherKindApart)
{
    // Up and to the right: the published plate, then a side without a word
    properties
    (
        std::string(rake) + "patchInteractionModel publishingWall;"
        "publishingWallCoeffs{published (plate); restitution 1;"
        " captureSpeed 0;}}"
        "cloudFunctions{a{type surfaceImpact; patches (\".*\"); log yes;"
        " axis{origin (0.05 0.02 0); direction (0 0 1); from (1 0 0);"
        " binWidth 10;}}}"
        "subModels{injectionModels{rake{U0 (1000 1000 0);}}}"
    );
    open();
    auto cloud = make<basicKinematicCloud>();
    evolve(*cloud, 50);

    label published = 0;
    label silent = 0;
    for (const row& r : table("a/kinematicCloud/0/impacts.csv"))
    {
        const bool known = r.at("reboundKnown") == "1";
        EXPECT_EQ(known, r.at("patch") == "plate");
        EXPECT_EQ(r.at("UxOut").empty(), !known);
        EXPECT_EQ(r.at("captured").empty(), !known);
        EXPECT_EQ(r.at("omegaX").empty(), !known);
        (known ? published : silent)++;
    }
    EXPECT_GE(published, 5);
    EXPECT_GE(silent, 5);

    label empty = 0;
    for (const row& r : table("a/kinematicCloud/5e-05/byAngle.csv"))
    {
        const bool known = r.at("reboundKnown") == "1";
        EXPECT_EQ(r.at("specificPower").empty(), !known);
        EXPECT_FALSE(r.at("intensity").empty());
        empty += !known;
        if (known && std::stod(r.at("nImpacts")) > 0)
        {
            EXPECT_NEAR(std::stod(r.at("specificPowerTranslational")), 0, 1e-9);
        }
    }
    EXPECT_GE(empty, 1);
    const auto patch = table("a/kinematicCloud/5e-05/byPatch.csv");
    ASSERT_EQ(patch.size(), 3u);
    EXPECT_FALSE(patch[1].at("specificPower").empty());
    EXPECT_TRUE(patch[2].at("specificPower").empty());
    // Nothing strikes the inlet: no certainty about it
    EXPECT_EQ(patch[0].at("intensity"), "0");
    EXPECT_TRUE(patch[0].at("intensityError").empty());
    EXPECT_TRUE(patch[0].at("meanNormalSpeed").empty());
}


TEST_F(surfaceImpactTest, anAxisLeavesPlatesFlat)
{
    // Beside the plate, in it, and across: none makes it a cylinder
    const std::string function = "{type surfaceImpact; patches (plate);";
    std::string functions = "cloudFunctions{a" + function + "}";
    int i = 0;
    for
    (
        const char* axis :
        {
            "origin (0.05 0.02 0); direction (0 0 1); from (1 0 0);",
            "origin (0.1 0 0); direction (0 1 0); from (0 0 1);",
            "origin (0 0.02 0); direction (1 0 0); from (0 0 1);"
        }
    )
    {
        functions += std::string(1, char('b' + i++)) + function
            + " axis{" + axis + " binWidth 10;}}";
    }
    properties
    (
        std::string(rake) + "patchInteractionModel rebound;"
        "reboundCoeffs{UFactor 1;}}" + functions + "}"
        "subModels{injectionModels{rake{U0 (1000 400 0);}}}"
    );
    open();
    auto cloud = make<basicKinematicCloud>();
    evolve(*cloud, 50);
    const auto mean = [&](const label k, const statistics::quantity quantity)
    {
        const statistics& a = results(*cloud, k);
        return sum(a, quantity)/sum(a, statistics::IMPACTS);
    };
    ASSERT_GE(sum(results(*cloud, 0), statistics::IMPACTS), 5);
    for (const auto q : {statistics::ANGLE, statistics::NORMAL_SPEED})
    {
        for (label k = 1; k < 4; ++k)
        {
            EXPECT_NEAR(mean(k, q)/mean(0, q), 1, 1e-12) << k;
        }
    }
}


TEST_F(surfaceImpactTest, measuresRelativeToTheWall)
{
    // The plate flees tangentially with the parcels' tangential velocity
    properties
    (
        std::string(rake) + "patchInteractionModel rebound;"
        "reboundCoeffs{UFactor 1;}}"
        "cloudFunctions{"
        "a{type surfaceImpact; patches (plate);}"
        "b{type surfaceImpact; patches (plate); threshold 1000.5;}}"
        "subModels{injectionModels{rake{U0 (1000 300 0);"
        " end (0.095 0.03 0);}}}"
    );
    open();
    const label plate = mesh_->boundaryMesh().findPatchID("plate");
    U_->boundaryFieldRef()[plate] == vector(0, 300, 0);
    U_->oldTime();
    auto cloud = make<basicKinematicCloud>();
    evolve(*cloud, 50);
    const statistics& a = results(*cloud, 0);
    EXPECT_EQ(sum(a, statistics::IMPACTS), 7);
    EXPECT_NEAR(sum(a, statistics::ANGLE)/21, M_PI/2, 1e-6);
    EXPECT_NEAR(sum(a, statistics::INCIDENT)/(21*mass/2*1e6), 1, 1e-12);
    EXPECT_EQ(sum(results(*cloud, 1), statistics::IMPACTS), 0);
}


TEST_F(surfaceImpactTest, aCopyOfTheCloudRecordsNothing)
{
    properties
    (
        std::string(rake) + "patchInteractionModel publishingWall;"
        "publishingWallCoeffs{published (plate); restitution 1;"
        " captureSpeed 0;}}"
        "cloudFunctions{a{type surfaceImpact; patches (plate);}"
        "d{type dispersedPhase;}}"
    );
    open();
    auto cloud = make<basicKinematicCloud>();
    autoPtr<Cloud<basicKinematicCloud::parcelType>> copy
    (
        cloud->clone("copy")
    );
    evolve(dynamic_cast<basicKinematicCloud&>(copy()), 20);
    evolve(*cloud, 30);
    EXPECT_EQ(sum(results(*cloud, 0), statistics::IMPACTS), 7);
}


TEST_F(surfaceImpactTest, knowsParcelsThatSpin)
{
    typedef basicKinematicCloud::parcelType plain;
    typedef basicKinematicCollidingCloud::parcelType spinning;
    EXPECT_FALSE(parcelSpin::carried<plain>());
    EXPECT_TRUE(parcelSpin::carried<spinning>());

    properties
    (
        std::string(rake) + "patchInteractionModel none; collisionModel none;}"
        "cloudFunctions{d{type dispersedPhase;}}"
        "constantProperties{youngsModulus 1e9; poissonsRatio 0.3;"
        " constantVolume 0; volumeUpdate true;}"
        "subModels{injectionModels{rake{U0 (0 10 0);}}}"
    );
    open();
    auto cloud = make<basicKinematicCollidingCloud>();
    evolve(*cloud, 1);
    for (auto& p : *cloud)
    {
        p.angularMomentum() = p.momentOfInertia()*vector(0, 0, 4e5);
    }
    evolve(*cloud, 49);
    const volVectorField omega
    (
        IOobject
        (
            "kinematicCloud:d:omega",
            time_->timeName(),
            mesh_(),
            IOobject::MUST_READ,
            IOobject::NO_WRITE,
            false
        ),
        mesh_()
    );
    const volScalarField::Internal weight
    (
        IOobject
        (
            "kinematicCloud:d:weight",
            time_->timeName(),
            mesh_(),
            IOobject::MUST_READ,
            IOobject::NO_WRITE,
            false
        ),
        mesh_()
    );
    // One sample of 50 was without spin
    EXPECT_NEAR
    (
        gSum(weight.field()*omega.primitiveField().component(2))
       /gSum(weight.field()),
        4e5*49/50, 1
    );
    EXPECT_NEAR(gSum(weight.field())/(21*5e-5), 1, 1e-12);
}


TEST_F(surfaceImpactTest, refusesHeatOfParcelsWithoutTemperatures)
{
    properties
    (
        std::string(rake) + "} cloudFunctions { a { type surfaceImpact;"
        " patches (plate); heat { wallTemperature 300; } } }"
    );
    open();
    auto cloud = make<basicKinematicCloud>();
    EXPECT_THROW(evolve(*cloud, 1), IOerror);
}


TEST_F(surfaceImpactTest, takesTheAnnotatedDictionaries)
{
    const fileName folder
    (
        std::string(std::getenv("PARCEL_IMPACT_DIR"))
      + "/etc/caseDicts/annotated"
    );
    for (const char* model : {"surfaceImpact", "dispersedPhase"})
    {
        IFstream is(folder/model);
        dictionary dict(is);
        ASSERT_TRUE(dict.found("cloudFunctions")) << model;
        // (This cloud has no temperatures)
        for (entry& e : dict.subDict("cloudFunctions"))
        {
            e.dict().remove("heat");
        }
        OStringStream text;
        dict.write(text, false);
        properties
        (
            std::string(rake) + "}" + text.str()
        );
        open();
        auto cloud = make<basicKinematicCloud>();
        ASSERT_EQ(cloud->functions().size(), 1) << model;
        evolve(*cloud, 2);
        cloud.reset();
        mu_.clear();
        U_.clear();
        rho_.clear();
        mesh_.clear();
        time_.clear();
    }
}
