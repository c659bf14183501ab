/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.

Description
    The wall models in the kinematic clouds: one step of each, what is
    published against the laws of the core, spin, copies of a cloud, the
    annotated dictionaries.
\*---------------------------------------------------------------------------*/

#include "basicKinematicCloud.H"
#include "basicKinematicCollidingCloud.H"
#include "basicKinematicMPPICCloud.H"
#include "coreVector.H"
#include "hardSphereWall.H"
#include "nonSphericalRebound.H"
#include "wallModelsTest.H"

using namespace Foam;

class kinematicWallModels
:
    public wallModelsTest
{
protected:

    template<class Cloud>
    void run(const modelSettings& m)
    {
        SCOPED_TRACE(m.model);
        writeCloud("sand", m.model, withPlate(m.settings));
        openMesh();
        const volVectorField U(velocity());
        const volScalarField rho(uniform("rho", dimDensity, 1));
        const volScalarField mu(uniform("mu", dimDynamicViscosity, 1e-5));
        Cloud cloud("sand", rho, U, mu, noGravity());
        evolveOnce(cloud);
    }

    //- The adhesive wall, on what adheres already
    template<class Cloud>
    void runOnLayer()
    {
        writeCloud("sand", adhesive.model, withPlate(adhesive.settings));
        openMesh();
        const volVectorField U(velocity());
        const volScalarField rho(uniform("rho", dimDensity, 1));
        const volScalarField mu(uniform("mu", dimDynamicViscosity, 1e-5));
        Cloud cloud("sand", rho, U, mu, noGravity());
        evolveOnLayer(cloud);
    }

    template<class Cloud>
    void runAll()
    {
        for (const modelSettings& m : allModels)
        {
            run<Cloud>(m);
        }
    }
};


TEST_F(kinematicWallModels, inBasicKinematicCloud)
{
    runAll<basicKinematicCloud>();
}


TEST_F(kinematicWallModels, inBasicKinematicCollidingCloud)
{
    runAll<basicKinematicCollidingCloud>();
}


TEST_F(kinematicWallModels, inBasicKinematicMPPICCloud)
{
    runAll<basicKinematicMPPICCloud>();
}


TEST_F(kinematicWallModels, releaseWhatAdheres)
{
    runOnLayer<basicKinematicCloud>();
    runOnLayer<basicKinematicCollidingCloud>();
    runOnLayer<basicKinematicMPPICCloud>();
}


TEST_F(kinematicWallModels, publishWhatTheCoreSays)
{
    writeCloud
    (
        "sand", "hardSphereWall",
        withPlate
        (
            "restitutionModel McNamaraFalcon; restitution 0.7;"
            " restitutionSpeed 0.3; friction 0.02;"
        )
    );
    openMesh();
    const volVectorField U(velocity());
    const volScalarField rho(uniform("rho", dimDensity, 1));
    const volScalarField mu(uniform("mu", dimDynamicViscosity, 1e-5));
    basicKinematicCollidingCloud cloud("sand", rho, U, mu, noGravity());
    typedef impact::reboundCoefficient form;
    const impact::hardSphereWall law
    (
        form::McNamaraFalcon(form::restitutionQuantity(), 0.7, 0.3),
        form::constant(form::frictionQuantity(), 0.02)
    );
    const auto impacts = evolveOnce(cloud);
    ASSERT_EQ(impacts.size(), nToPlate);
    for (const wallImpact& i : impacts)
    {
        EXPECT_LT(mag(i.U0 - vector(1000, 200, 0)), 1e-12);
        impact::sphereState s = {toCore(i.U0), toCore(i.omega0)};
        law.rebound(toCore(i.n), 0.5*i.d, s);
        EXPECT_LT(mag(toCore(i.U1) - s.V), 1e-14*1000);
        EXPECT_LT(mag(toCore(i.omega1) - s.omega), 1e-14*mag(s.omega));
        EXPECT_GT(mag(s.omega), 1e6);
        const scalar inertia = 0.1*i.mass*sqr(i.d);
        EXPECT_NEAR
        (
            i.rotationalEnergy1, 0.5*inertia*magSqr(i.omega1),
            1e-13*i.rotationalEnergy1
        );
        EXPECT_EQ(i.rotationalEnergy0, 0);
    }

    // The parcels carry it on
    for (const auto& p : cloud)
    {
        EXPECT_LT(mag(p.U() - impacts[0].U1), 1e-10);
        EXPECT_NEAR
        (
            mag(p.omega()/mag(impacts[0].omega1)), 1, 1e-12
        );
    }
}


TEST_F(kinematicWallModels, tellTheTimeWithinSubCycles)
{
    // The colliding cloud moves in sub-cycles of the step, by the stiffness of
    // its pairs; the springs of the walls are too soft to matter
    writeCloud
    (
        "sand", "hardSphereWall",
        withPlate("restitution 0.7; friction 0.2;"), "",
        "collisionModel pairCollision; pairCollisionCoeffs {"
        " maxInteractionDistance 2e-5; writeReferredParticleCloud no;"
        " pairModel pairSpringSliderDashpot; pairSpringSliderDashpotCoeffs {"
        " useEquivalentSize no; alpha 0; b 1.5; mu 0;"
        " cohesionEnergyDensity 0; collisionResolutionSteps 12; }"
        " wallModel wallSpringSliderDashpot; wallSpringSliderDashpotCoeffs {"
        " useEquivalentSize no; collisionResolutionSteps 12;"
        " youngsModulus 1e-6; poissonsRatio 0.3; alpha 0; b 1.5; mu 0;"
        " cohesionEnergyDensity 0; } }"
    );
    openMesh();
    const volVectorField U(velocity());
    const volScalarField rho(uniform("rho", dimDensity, 1));
    const volScalarField mu(uniform("mu", dimDynamicViscosity, 1e-5));
    basicKinematicCollidingCloud cloud("sand", rho, U, mu, noGravity());
    const auto& mesh = mesh_();
    const scalar before[] = {2e-4, 4.5e-4, 1.7e-3};
    for (label i = 0; i < 3; ++i)
    {
        // No injector: those move their parcels beside the sub-cycles
        const point start(0.1 - before[i], 0.01 + 0.005*i, 5e-4);
        auto* p = new basicKinematicCollidingCloud::parcelType
        (
            mesh, start, mesh.findCell(start)
        );
        p->origProc() = 7;
        p->origId() = i;
        p->d() = 2e-5;
        p->rho() = 2500;
        p->nParticle() = 1;
        p->U() = vector(1000, 0, 0);
        cloud.addParticle(p);
    }
    cloud.injectors().clear();

    recordingListener listener;
    wallImpacts& impacts = wallImpacts::New(cloud);
    impacts.add(listener);
    for (label step = 0; step < 2; ++step)
    {
        ASSERT_GT(cloud.collision().nSubCycles(), 3);
        (*time_)++;
        cloud.evolve();
    }
    impacts.remove(listener);
    label found = 0;
    for (const wallImpact& i : listener.impacts)
    {
        if (i.origProc == 7)
        {
            EXPECT_NEAR(i.time, before[i.origId]/1000, 1e-13);
            ++found;
        }
    }
    EXPECT_EQ(found, 3);
}


TEST_F(kinematicWallModels, keyDrawsOnTheImpact)
{
    writeCloud("sand", allModels[2].model, withPlate(allModels[2].settings));
    openMesh();
    const volVectorField U(velocity());
    const volScalarField rho(uniform("rho", dimDensity, 1));
    const volScalarField mu(uniform("mu", dimDynamicViscosity, 1e-5));
    basicKinematicCloud cloud("sand", rho, U, mu, noGravity());
    const auto impacts = evolveOnce(cloud);

    impact::wallEncounter setup;
    setup.body = impact::convexBody::box({2e-5, 1.6e-5, 1.6e-5});
    setup.wall = std::make_shared<const impact::relief>
    (
        impact::relief::rough(8e-5, 1e-5, 2e-5)
    );
    impact::nonSphericalRebound wall(setup);
    label first = 0;
    for (const wallImpact& i : impacts)
    {
        if (mag(i.U0 - vector(1000, 200, 0)) > 1e-9)
        {
            continue;       // a second visit
        }
        ++first;
        const impact::wallFrame frame =
            impact::wallFrame::across(toCore(i.n), toCore(i.U0));
        const scalar fraction =
            1 - (time_->value() - i.time)/time_->deltaTValue();
        const auto d = wall.depart
        (
            frame.toWall(toCore(i.U0)), {0, 0, 0}, 2e-5,
            impact::impactKey::ofTime
            (
                1, i.origProc, i.origId, 1,
                impact::impactKey::rounded(fraction), 0
            )
        );
        const impact::vector3 V = frame.fromWall(d.V);
        EXPECT_NEAR(i.U1.x(), V.x, 1e-10);
        EXPECT_NEAR(i.U1.y(), V.y, 1e-10);

        // This parcel carries no spin
        EXPECT_EQ(mag(i.omega1), 0);
        EXPECT_EQ(i.rotationalEnergy1, 0);
    }
    EXPECT_EQ(first, nToPlate);
}


TEST_F(kinematicWallModels, reportWithinMultiInteraction)
{
    writeCloud
    (
        "sand", "multiInteraction",
        "oneInteractionOnly yes; a { patchInteractionModel hardSphereWall;"
        " hardSphereWallCoeffs { patches ( plate { restitution 1; friction"
        " 0; } ); } } b { patchInteractionModel semiEmpiricalRebound;"
        " semiEmpiricalReboundCoeffs { patches ( sides { type capture; }"
        " inlet { type escape; } ); } }"
    );
    openMesh();
    const volVectorField U(velocity());
    const volScalarField rho(uniform("rho", dimDensity, 1));
    const volScalarField mu(uniform("mu", dimDynamicViscosity, 1e-5));
    basicKinematicCloud cloud("sand", rho, U, mu, noGravity());
    ASSERT_EQ(cloud.functions().size(), 1);

    evolveOnce(cloud);
    OStringStream report;
    dictionary properties;
    wallCounters::New(cloud).report(report, properties, true, true);
    const string text(report.str());
    EXPECT_NE(text.find("hardSphereWall, patch plate"), string::npos) << text;
    EXPECT_NE(text.find("semiEmpiricalRebound, patch inlet"), string::npos);
    const List<string> stored
    (
        properties.subDict("patchInteractionModel").subDict("hardSphereWall")
       .get<List<string>>("wallCounters_plate")
    );
    EXPECT_EQ(stored[wallCounters::hits], std::to_string(nToPlate));
}


TEST_F(kinematicWallModels, takeTheAnnotatedDictionaries)
{
    for (const modelSettings& m : allModels)
    {
        SCOPED_TRACE(m.model);
        const fileName file
        (
            std::string(std::getenv("PARCEL_IMPACT_DIR"))
          + "/etc/caseDicts/annotated/" + m.model
        );
        IFstream is(file);
        const dictionary dict(is);
        const word coeffs(word(m.model) + "Coeffs");
        ASSERT_EQ(dict.get<word>("patchInteractionModel"), word(m.model));
        OStringStream text;
        dict.subDict(coeffs).write(text, false);
        writeCloud("sand", m.model, text.str());
        openMesh();
        const volVectorField U(velocity());
        const volScalarField rho(uniform("rho", dimDensity, 1));
        const volScalarField mu(uniform("mu", dimDynamicViscosity, 1e-5));
        basicKinematicCollidingCloud cloud("sand", rho, U, mu, noGravity());
        (*time_)++;
        cloud.evolve();
        const label plate = mesh_->boundaryMesh().findPatchID("plate");
        EXPECT_GE
        (
            wallCounters::New(cloud).of(plate)[wallCounters::hits], nToPlate
        );
    }
}
