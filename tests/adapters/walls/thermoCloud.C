/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.

Description
    The wall models in basicThermoCloud: one step of each.
\*---------------------------------------------------------------------------*/

#include "basicThermoCloud.H"
#include "SLGThermo.H"
#include "heatWallModelsTest.H"

using namespace Foam;

TEST_F(heatWallModelsTest, inBasicThermoCloud)
{
    for (const modelSettings& m : allModels)
    {
        SCOPED_TRACE(m.model);
        writeCloud
        (
            "sand", m.model, withPlate(m.settings), "",
            ""
        );
        openGas();
        const volVectorField U(velocity());
        const volScalarField rho("rho", thermo_->rho());
        SLGThermo slg(mesh_(), thermo_());
        basicThermoCloud cloud("sand", rho, U, noGravity(), slg);
        evolveOnce(cloud);
    }
}


TEST_F(heatWallModelsTest, releaseInBasicThermoCloud)
{
    writeCloud
    (
        "sand", adhesive.model, withPlate(adhesive.settings), "",
        ""
    );
    openGas();
    const volVectorField U(velocity());
    const volScalarField rho("rho", thermo_->rho());
    SLGThermo slg(mesh_(), thermo_());
    basicThermoCloud cloud("sand", rho, U, noGravity(), slg);
    evolveOnLayer(cloud);
}
