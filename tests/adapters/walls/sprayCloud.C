/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.

Description
    The wall models in basicSprayCloud: one step of each; the cloud functions
    can be selected.
\*---------------------------------------------------------------------------*/

#include "basicSprayCloud.H"
#include "SLGThermo.H"
#include "heatWallModelsTest.H"

using namespace Foam;

TEST_F(heatWallModelsTest, inBasicSprayCloud)
{
    for (const modelSettings& m : allModels)
    {
        SCOPED_TRACE(m.model);
        writeCloud
        (
            "sand", m.model, withPlate(m.settings), "",
            "compositionModel singlePhaseMixture; singlePhaseMixtureCoeffs {"
            " phases ( liquid { H2O 1; } ); } atomizationModel none;"
            " breakupModel none;"
        );
        openGas();
        const volVectorField U(velocity());
        const volScalarField rho("rho", thermo_->rho());
        SLGThermo slg(mesh_(), thermo_());
        basicSprayCloud cloud("sand", rho, U, noGravity(), slg);
        evolveOnce(cloud);
    }
}


TEST(sprayWallInteraction, hasTheCloudFunctions)
{
    const auto* table = CloudFunctionObject
    <
        basicSprayCloud::kinematicCloudType
    >::dictionaryConstructorTablePtr_;
    ASSERT_NE(table, nullptr);
    for
    (
        const char* name
      : {"dispersedPhase", "impactRecords", "surfaceImpact"}
    )
    {
        EXPECT_TRUE(table->found(name)) << name;
    }
}
