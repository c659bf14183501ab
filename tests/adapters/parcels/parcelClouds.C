/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.

Description
    The list of clouds and the models in it on a small channel: construction
    and refusal, frozen and changing gas, drag against the core in perfect and
    in thermally perfect gas, the annotated dictionaries.
\*---------------------------------------------------------------------------*/

#include "IFstream.H"
#include "OFstream.H"
#include "basicKinematicCloud.H"
#include "channelTest.H"
#include "dragLaw.H"
#include "fluidThermo.H"
#include "kinematicParcelCloud.H"
#include "parcelClouds.H"

#include <gtest/gtest.h>
#include <cstdlib>
#include <map>
#include <memory>

using namespace Foam;

namespace
{

//- The case of tests/cases/particles, in a folder of its own
class parcelCloudsTest
:
    public channelTest
{
protected:

    autoPtr<fluidThermo> thermo_;
    autoPtr<volScalarField> rho_;
    autoPtr<volVectorField> U_;

    void TearDown() override
    {
        U_.clear();
        rho_.clear();
        thermo_.clear();
        channelTest::TearDown();
    }

    fileName path(const char* name) const
    {
        return root_/"case"/name;
    }

    dictionary read(const fileName& file) const
    {
        IFstream is(file);
        return dictionary(is);
    }

    void write(const word& name, const dictionary& dict) const
    {
        OFstream os(root_/"case"/"constant"/name);
        os.precision(17);
        os  << "FoamFile{version 2.0; format ascii; class dictionary;"
            << " object " << name << ";}" << nl;
        dict.write(os, false);
    }

    //- The cloud's dictionary with changes merged in, whose forces are all
    //  that it then has
    void addCloud(const word& cloud, const dictionary& changes) const
    {
        dictionary dict(read(path("constant/kinematicCloudProperties")));
        if (changes.subOrEmptyDict("subModels").found("particleForces"))
        {
            dict.subDict("subModels").remove("particleForces");
        }
        dict.merge(changes);
        write(cloud + "Properties", dict);
    }

    void list(const char* clouds) const
    {
        dictionary dict;
        dict.set("clouds", wordList(IStringStream(clouds)()));
        write("parcelClouds", dict);
    }

    //- Mesh and gas
    void open()
    {
        openMesh();
        thermo_.reset(fluidThermo::New(mesh_()).ptr());
        rho_.reset
        (
            new volScalarField
            (
                IOobject("rho", time_->timeName(), mesh_()),
                thermo_->rho()
            )
        );
        U_ = velocity(mesh_());
    }

    std::unique_ptr<parcelClouds> make()
    {
        return std::make_unique<parcelClouds>
        (
            mesh_(),
            rho_(),
            U_(),
            thermo_()
        );
    }

    static const basicKinematicCloud& cloud(const parcelCloudModel& model)
    {
        return dynamic_cast<const kinematicParcelCloud<basicKinematicCloud>&>
        (
            model
        ).cloud();
    }

    static scalar speed(const parcelCloudModel& model)
    {
        return cloud(model).first()->U().x();
    }

    //- The message with which the clouds are refused
    std::string refusal()
    {
        try
        {
            make();
        }
        catch (const error& e)
        {
            return e.message();
        }
        return "none";
    }

    //- Compare the force on the first parcel with a law of the core, in the
    //  gas of its cell. Returns the Mach number of the relative motion.
    scalar expectCoreDrag
    (
        const parcelCloudModel& model,
        const char* law,
        impact::dragLaw::coefficients coefficients
    ) const
    {
        auto& c = const_cast<basicKinematicCloud&>(cloud(model));
        auto& p = *c.first();
        const label cell = p.cell();
        basicKinematicCloud::parcelType::trackingData td(c);
        td.rhoc() = rho_()[cell];
        td.Uc() = U_()[cell];
        td.muc() = thermo_->mu()()[cell];
        const scalar Re = p.Re(td);
        const_cast<basicKinematicCloud::forceType&>(c.forces())
            .cacheFields(true);
        const scalar Sp =
            c.forces().calcCoupled(p, td, 1e-9, p.mass(), Re, td.muc()).Sp();

        const scalar gamma = thermo_->gamma()()[cell];
        const scalar a = std::sqrt(gamma/thermo_->psi()[cell]);
        const scalar K = td.muc()/(td.rhoc()*p.d()*a);
        coefficients.gamma = gamma;
        const scalar CdRe =
            impact::dragLaw::New(law, coefficients)->CdRe(Re, K);
        EXPECT_NEAR(Sp/(M_PI/8*p.d()*td.muc()*CdRe), 1, 1e-13);
        return K*Re;
    }
};

} // End anonymous namespace


TEST_F(parcelCloudsTest, hasNoneWithoutTheFile)
{
    open();
    const auto clouds = make();
    EXPECT_TRUE(clouds->empty());
    (*time_)++;
    clouds->evolve();
}


TEST_F(parcelCloudsTest, advancesSeveralClouds)
{
    list("(coarse fine)");
    addCloud("coarse", dictionary());
    addCloud
    (
        "fine",
        dictionary
        (
            IStringStream
            (
                "subModels{injectionModels{rake{diameter 1e-6;nParcels 3;}}}"
                "type basicKinematicCloud;"
            )()
        )
    );
    open();
    const auto clouds = make();
    ASSERT_EQ(clouds->size(), 2);
    for (int step = 0; step < 5; ++step)
    {
        (*time_)++;
        clouds->evolve(false);
    }
    EXPECT_EQ((*clouds)[0].name(), "coarse");
    EXPECT_EQ((*clouds)[0].nParcels(), 7);
    EXPECT_EQ((*clouds)[1].nParcels(), 3);
    EXPECT_EQ((*clouds)[0].nParcelSteps(), 5*7);
    EXPECT_EQ((*clouds)[1].nParcelSteps(), 5*3);
    EXPECT_GT(clouds->cpuTime(), 0);
    EXPECT_LT(speed((*clouds)[1]), speed((*clouds)[0]));
}


TEST_F(parcelCloudsTest, takesCollisionModelsWhereThereAreSome)
{
    const dictionary pairs
    (
        IStringStream
        (
            "constantProperties{youngsModulus 1e9;poissonsRatio 0.3;}"
            "subModels{collisionModel pairCollision;pairCollisionCoeffs{"
            "maxInteractionDistance 5e-6;writeReferredParticleCloud no;"
            "pairModel pairSpringSliderDashpot;pairSpringSliderDashpotCoeffs{"
            "useEquivalentSize no;alpha 0;b 1.5;mu 0;"
            "cohesionEnergyDensity 0;collisionResolutionSteps 12;}"
            "wallModel wallSpringSliderDashpot;wallSpringSliderDashpotCoeffs{"
            "useEquivalentSize no;collisionResolutionSteps 12;"
            "youngsModulus 1e9;poissonsRatio 0.3;alpha 0;b 1.5;mu 0;"
            "cohesionEnergyDensity 0;}}}"
        )()
    );
    list("(sand)");
    addCloud("sand", pairs);
    open();
    const std::string message = refusal();
    EXPECT_NE(message.find("collisionModel"), std::string::npos) << message;

    dictionary colliding(pairs);
    colliding.set("type", word("basicKinematicCollidingCloud"));
    addCloud("sand", colliding);
    const auto clouds = make();
    (*time_)++;
    clouds->evolve(false);
    EXPECT_EQ((*clouds)[0].nParcels(), 7);
}


TEST_F(parcelCloudsTest, refusesBadLists)
{
    list("(sand sand)");
    addCloud("sand", dictionary());
    open();
    std::string message = refusal();
    EXPECT_NE(message.find("sand"), std::string::npos) << message;
    EXPECT_NE(message.find("different names"), std::string::npos) << message;

    list("(other)");
    addCloud("other", dictionary(IStringStream("type sandCloud;")()));
    message = refusal();
    EXPECT_NE(message.find("sandCloud"), std::string::npos) << message;
    EXPECT_NE(message.find("basicKinematicCloud"), std::string::npos)
        << message;
}


TEST_F(parcelCloudsTest, refusesAnIncompressibleGas)
{
    dictionary thermo(read(path("constant/thermophysicalProperties")));
    thermo.subDict("thermoType").set("type", word("heRhoThermo"));
    thermo.subDict("thermoType").set("equationOfState", word("rhoConst"));
    thermo.subDict("thermoType").set("transport", word("const"));
    thermo.subDict("mixture").set
    (
        "equationOfState",
        dictionary(IStringStream("rho 1;")())
    );
    thermo.subDict("mixture").set
    (
        "transport",
        dictionary(IStringStream("mu 1e-5; Pr 0.7;")())
    );
    write("thermophysicalProperties", thermo);
    list("(sand)");
    addCloud("sand", dictionary());
    open();
    const std::string message = refusal();
    EXPECT_NE(message.find("equation of state"), std::string::npos) << message;
}


TEST_F(parcelCloudsTest, noticesAChangeOfTheGas)
{
    // A solver may write through raw arrays, which leaves no trace that the
    // cached point values would notice
    list("(sand)");
    addCloud("sand", dictionary());
    open();
    const auto clouds = make();
    (*time_)++;
    clouds->evolve();

    const auto seen = [this, &clouds]()
    {
        const auto& p = *cloud((*clouds)[0]).first();
        return interpolation<vector>::New("cellPoint", U_())->interpolate
        (
            p.coordinates(),
            p.currentTetIndices()
        ).x();
    };

    vector* u = U_->primitiveFieldRef().data();
    (*time_)++;
    clouds->evolve();
    EXPECT_EQ(seen(), 0);

    std::fill_n(u, U_->size(), vector(100, 0, 0));
    forAll(U_->boundaryField(), patchi)
    {
        fvPatchVectorField& boundary =
            const_cast<fvPatchVectorField&>(U_->boundaryField()[patchi]);
        std::fill(boundary.begin(), boundary.end(), vector(100, 0, 0));
    }
    // Half of what the parcel sees would be old
    (*time_)++;
    clouds->evolve(false);
    EXPECT_LT(seen(), 99);
    (*time_)++;
    clouds->evolve(true);
    EXPECT_NEAR(seen(), 100, 1e-10);
}


TEST_F(parcelCloudsTest, dragIsThatOfTheCoreInPerfectGas)
{
    struct setting
    {
        const char* law;
        const char* entries;
        double TwOverT;
        const char* form;
        std::map<std::string, double> numbers;
    };
    list("(sand)");
    open();
    for
    (
        const setting& s
      : std::vector<setting>
        {
            {"hendersonDrag", "TwOverT 1.3;", 1.3, "", {}},
            {"hendersonDrag", "", 1, "", {}},
            {"lothDrag", "TwOverT 0.7;", 0.7, "published", {}},
            {"lothDrag", "form continuous;", 1, "continuous", {}},
            {"singhDrag", "TwOverT 2;", 2, "", {}},
            {
                "singhDrag", "omega 0.81; alphaHoc 1.27;", 1, "",
                {{"omega", 0.81}, {"alphaHoc", 1.27}}
            },
            {
                "haiderLevenspielDrag", "sphericity 0.6;", 1, "",
                {{"sphericity", 0.6}}
            },
            {
                "holzerSommerfeldDrag",
                "sphericity 0.6; crosswiseSphericity 0.9;", 1, "",
                {{"sphericity", 0.6}, {"crosswiseSphericity", 0.9}}
            },
            {
                "ganserDrag",
                "sphericity 0.6; projectedDiameterRatio 1.3;", 1, "",
                {{"sphericity", 0.6}, {"projectedDiameterRatio", 1.3}}
            }
        }
    )
    {
        SCOPED_TRACE(std::string(s.law) + ' ' + s.entries);
        dictionary cloud(read(path("constant/kinematicCloudProperties")));
        cloud.subDict("subModels").set
        (
            "particleForces",
            dictionary(IStringStream(s.law + string("{") + s.entries + "}")())
        );
        write("sandProperties", cloud);
        const auto clouds = make();
        (*time_)++;
        clouds->evolve();

        impact::dragLaw::coefficients c;
        c.TpOverT = s.TwOverT;
        c.form = s.form;
        c.numbers = s.numbers;
        EXPECT_GT(expectCoreDrag((*clouds)[0], s.law, c), 1.75);
    }
}


TEST_F(parcelCloudsTest, refusesBadEntriesOfDragLaws)
{
    struct mistake
    {
        const char* forces;
        std::vector<const char*> said;
    };
    list("(sand)");
    open();
    for
    (
        const mistake& m
      : std::vector<mistake>
        {
            {"hendersonDrag { TwOverT -1; }", {"TwOverT -1", "(0, 1000]"}},
            {"lothDrag { TwOverT 0; }", {"TwOverT 0", "(0, 1000]"}},
            {"lothDrag { form smooth; }", {"smooth", "published continuous"}},
            {"lothDrag { forn continuous; }", {"forn", "Did you mean form"}},
            {"lothDrag { sphericity 0.5; }", {"sphericity", "thermo"}},
            {"lothDrag { thermo gas; }", {"gas", "thermophysicalProperties"}},
            {"singhDrag { omega 1.2; }", {"omega 1.2", "[0.5, 1]"}},
            {"singhDrag { alphaHoc -1; }", {"alphaHoc -1", "[0, 100]"}},
            {"haiderLevenspielDrag;", {"sphericity", "missing", "(0, 1]"}},
            {
                "haiderLevenspielDrag { sphericity 1.01; }",
                {"sphericity 1.01", "(0, 1]"}
            },
            {
                "haiderLevenspielDrag { sphericity 1; TwOverT 1; }",
                {"TwOverT", "Valid: (sphericity)"}
            },
            {
                "holzerSommerfeldDrag { sphericity 0; }",
                {"sphericity 0", "(0, 1]"}
            },
            {
                "holzerSommerfeldDrag { sphericity 1; crosswiseSphericity"
                " 2000; }", {"crosswiseSphericity 2000", "(0, 1000]"}
            },
            {"ganserDrag;", {"sphericity", "missing", "(0, 1]"}},
            {"ganserDrag { sphericity 1.2; }", {"sphericity 1.2", "(0, 1]"}},
            {
                "ganserDrag { sphericity 0.8; projectedDiameterRatio 0; }",
                {"projectedDiameterRatio 0", "(0, 1000]"}
            }
        }
    )
    {
        dictionary cloud(read(path("constant/kinematicCloudProperties")));
        cloud.subDict("subModels").set
        (
            "particleForces", dictionary(IStringStream(m.forces)())
        );
        write("sandProperties", cloud);
        const std::string message = refusal();
        for (const char* word : m.said)
        {
            EXPECT_NE(message.find(word), std::string::npos)
                << m.forces << ": " << message;
        }
    }
}


TEST_F(parcelCloudsTest, dragOfNonSphericalParticlesIsThatOfStock)
{
    // Haider and Levenspiel's law is there as nonSphereDrag, too
    list("(sand)");
    open();
    scalar speeds[2];
    int i = 0;
    for
    (
        const char* forces
      : {
            "nonSphereDrag { phi 0.7; }",
            "haiderLevenspielDrag { sphericity 0.7; }"
        }
    )
    {
        dictionary cloud(read(path("constant/kinematicCloudProperties")));
        cloud.subDict("subModels").set
        (
            "particleForces", dictionary(IStringStream(forces)())
        );
        write("sandProperties", cloud);
        const auto clouds = make();
        for (int step = 0; step < 3; ++step)
        {
            (*time_)++;
            clouds->evolve();
        }
        speeds[i++] = speed((*clouds)[0]);
    }
    EXPECT_LT(speeds[0], 995);
    EXPECT_NEAR(speeds[0]/speeds[1], 1, 1e-9);
}


TEST_F(parcelCloudsTest, dragFollowsGammaInThermallyPerfectGas)
{
    dictionary thermo(read(path("constant/thermophysicalProperties")));
    thermo.subDict("thermoType").set("thermo", word("janaf"));
    thermo.subDict("mixture").set
    (
        "thermodynamics",
        dictionary
        (
            IStringStream
            (
                "Tlow 200; Thigh 6000; Tcommon 1000;"
                "highCpCoeffs (3.08581 0.00124862 -4.23613e-07 6.74775e-11"
                " -3.97077e-15 -983.191 5.96043);"
                "lowCpCoeffs (3.56839 -0.000678729 1.55371e-06 -3.29937e-12"
                " -4.66395e-13 -1062.35 3.71582);"
            )()
        )
    );
    write("thermophysicalProperties", thermo);
    list("(sand)");
    open();
    auto& T = const_cast<volScalarField&>(thermo_->T());
    T.primitiveFieldRef() =
        300 + 2e4*mesh_->C().primitiveField().component(vector::X);
    T.correctBoundaryConditions();
    thermo_->he() = thermo_->he(thermo_->p(), T);
    thermo_->correct();
    EXPECT_GT(gMax(thermo_->gamma()()) - gMin(thermo_->gamma()()), 0.05);
    for (const char* law : {"hendersonDrag", "lothDrag", "singhDrag"})
    {
        dictionary cloud(read(path("constant/kinematicCloudProperties")));
        cloud.subDict("solution").subDict("interpolationSchemes").set
        (
            "T", word("cell")
        );
        cloud.subDict("subModels").set
        (
            "particleForces", dictionary(IStringStream(law + string(";"))())
        );
        write("sandProperties", cloud);
        const auto clouds = make();
        (*time_)++;
        clouds->evolve();
        EXPECT_GT
        (
            expectCoreDrag
            (
                (*clouds)[0], law, impact::dragLaw::coefficients()
            ),
            1
        );
    }
}


TEST_F(parcelCloudsTest, takesTheAnnotatedDictionaries)
{
    const fileName folder
    (
        std::string(std::getenv("PARCEL_IMPACT_DIR"))
      + "/etc/caseDicts/annotated"
    );
    for
    (
        const char* model
      : {
            "hendersonDrag", "lothDrag", "singhDrag",
            "haiderLevenspielDrag", "holzerSommerfeldDrag", "ganserDrag",
            "crossSectionInjection", "rakeInjection", "impactRecords"
        }
    )
    {
        const dictionary dict(read(folder/model));
        ASSERT_GT(dict.size(), 0) << model;
        addCloud(model, dict);
    }
    list
    (
        "(hendersonDrag lothDrag singhDrag haiderLevenspielDrag"
        " holzerSommerfeldDrag ganserDrag crossSectionInjection rakeInjection"
        " impactRecords)"
    );
    ASSERT_EQ(read(folder/"parcelClouds").get<wordList>("clouds").size(), 2);
    open();
    const auto clouds = make();
    (*time_)++;
    clouds->evolve();
    for (label i = 0; i < clouds->size(); ++i)
    {
        EXPECT_GT((*clouds)[i].nParcels(), 0) << (*clouds)[i].name();
    }
}
