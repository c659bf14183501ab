/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.

Description
    The wall models in basicReactingCloud: one step of each.
\*---------------------------------------------------------------------------*/

#include "basicReactingCloud.H"
#include "SLGThermo.H"
#include "heatWallModelsTest.H"

using namespace Foam;

TEST_F(heatWallModelsTest, inBasicReactingCloud)
{
    for (const modelSettings& m : allModels)
    {
        SCOPED_TRACE(m.model);
        writeCloud
        (
            "sand", m.model, withPlate(m.settings), "",
            "compositionModel singlePhaseMixture; singlePhaseMixtureCoeffs {"
            " phases ( solid { ash 1; } ); }"
        );
        openGas();
        const volVectorField U(velocity());
        const volScalarField rho("rho", thermo_->rho());
        SLGThermo slg(mesh_(), thermo_());
        basicReactingCloud cloud("sand", rho, U, noGravity(), slg);
        evolveOnce(cloud);
    }
}


TEST_F(heatWallModelsTest, releaseInBasicReactingCloud)
{
    writeCloud
    (
        "sand", adhesive.model, withPlate(adhesive.settings), "",
        "compositionModel singlePhaseMixture; singlePhaseMixtureCoeffs {"
        " phases ( solid { ash 1; } ); }"
    );
    openGas();
    const volVectorField U(velocity());
    const volScalarField rho("rho", thermo_->rho());
    SLGThermo slg(mesh_(), thermo_());
    basicReactingCloud cloud("sand", rho, U, noGravity(), slg);
    evolveOnLayer(cloud);
}
