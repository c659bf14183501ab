/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.

Description
    The wall models in basicReactingMultiphaseCloud: one step of each.
\*---------------------------------------------------------------------------*/

#include "basicReactingMultiphaseCloud.H"
#include "SLGThermo.H"
#include "heatWallModelsTest.H"

using namespace Foam;

TEST_F(heatWallModelsTest, inBasicReactingMultiphaseCloud)
{
    for (const modelSettings& m : allModels)
    {
        SCOPED_TRACE(m.model);
        writeCloud
        (
            "sand", m.model, withPlate(m.settings), "",
            "compositionModel singleMixtureFraction;"
            " singleMixtureFractionCoeffs { phases ( gas { N2 1; }"
            " liquid { H2O 1; } solid { ash 1; } );"
            " YGasTot0 0; YLiquidTot0 0; YSolidTot0 1; }"
        );
        openGas();
        const volVectorField U(velocity());
        const volScalarField rho("rho", thermo_->rho());
        SLGThermo slg(mesh_(), thermo_());
        basicReactingMultiphaseCloud cloud("sand", rho, U, noGravity(), slg);
        evolveOnce(cloud);
    }
}


TEST_F(heatWallModelsTest, releaseInBasicReactingMultiphaseCloud)
{
    writeCloud
    (
        "sand", adhesive.model, withPlate(adhesive.settings), "",
        "compositionModel singleMixtureFraction;"
        " singleMixtureFractionCoeffs { phases ( gas { N2 1; }"
        " liquid { H2O 1; } solid { ash 1; } );"
        " YGasTot0 0; YLiquidTot0 0; YSolidTot0 1; }"
    );
    openGas();
    const volVectorField U(velocity());
    const volScalarField rho("rho", thermo_->rho());
    SLGThermo slg(mesh_(), thermo_());
    basicReactingMultiphaseCloud cloud("sand", rho, U, noGravity(), slg);
    evolveOnLayer(cloud);
}
