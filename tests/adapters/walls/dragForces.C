/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.

Description
    The drag laws in stock clouds whose parcels have a temperature: it is that
    of the parcel, and another one is refused.
\*---------------------------------------------------------------------------*/

#include "SLGThermo.H"
#include "basicReactingCloud.H"
#include "basicSprayCloud.H"
#include "basicThermoCloud.H"
#include "dragLaw.H"
#include "heatWallModelsTest.H"

using namespace Foam;

namespace
{

class dragForcesTest
:
    public heatWallModelsTest
{
protected:

    void writeForce(const string& force, const string& more = "")
    {
        writeCloud
        (
            "sand", "standardWallInteraction", "type rebound;", "",
            "particleForces { " + force + " } " + more
        );
    }

    //- The force on the first parcel, at a temperature of its own, is that of
    //  the law in the gas of its cell
    template<class Cloud>
    void expectCoreDrag(Cloud& cloud, const char* law)
    {
        typedef typename Cloud::kinematicCloudType kinematicCloud;
        (*time_)++;
        cloud.evolve();
        ASSERT_GT(cloud.size(), 0);
        auto& p = *cloud.first();
        const label cell = p.cell();
        typename Cloud::parcelType::trackingData td(cloud);
        td.rhoc() = thermo_->rho()()[cell];
        td.muc() = thermo_->mu()()[cell];
        td.Uc() = vector(0, 0, 0);
        td.Tc() = thermo_->T()[cell];
        auto& forces =
            const_cast<typename kinematicCloud::forceType&>(cloud.forces());
        forces.cacheFields(true);

        impact::dragLaw::coefficients c;
        c.gamma = thermo_->gamma()()[cell];
        const auto core = impact::dragLaw::New(law, c);
        scalar last = 0;

        // Small, in rarefied gas: there the temperature matters
        p.d() = 2e-8;
        for (const scalar T : {150., 1500.})
        {
            p.T() = T;
            const scalar a = std::sqrt(c.gamma/thermo_->psi()[cell]);
            const scalar K = td.muc()/(td.rhoc()*p.d()*a);

            const scalar Re = 1/K;
            const scalar Sp =
                forces.calcCoupled(p, td, 1e-9, p.mass(), Re, td.muc()).Sp();
            EXPECT_NEAR
            (
                Sp
               /(
                    M_PI/8*p.d()*td.muc()
                   *core->CdRe(Re, K, T/thermo_->T()[cell])
                ),
                1,
                1e-12
            );
            EXPECT_GT(Sp, last*(1 + 1e-6));
            last = Sp;
        }
    }

    template<class Construct>
    std::string refusal(const Construct& construct)
    {
        try
        {
            construct();
        }
        catch (const error& e)
        {
            return e.message();
        }
        return "none";
    }
};

const char* const laws[] = {"hendersonDrag", "lothDrag", "singhDrag"};

} // End anonymous namespace


TEST_F(dragForcesTest, takeTheTemperatureOfAThermalParcel)
{
    for (const char* law : laws)
    {
        SCOPED_TRACE(law);
        writeForce(law + string(";"));
        openGas();
        const volVectorField U(velocity());
        const volScalarField rho("rho", thermo_->rho());
        SLGThermo slg(mesh_(), thermo_());
        basicThermoCloud cloud("sand", rho, U, noGravity(), slg);
        expectCoreDrag(cloud, law);
    }
}


TEST_F(dragForcesTest, takeTheTemperatureOfAReactingParcel)
{
    for (const char* law : laws)
    {
        SCOPED_TRACE(law);
        writeForce
        (
            law + string(";"),
            "compositionModel singlePhaseMixture; singlePhaseMixtureCoeffs {"
            " phases ( liquid { H2O 1; } ); }"
        );
        openGas();
        const volVectorField U(velocity());
        const volScalarField rho("rho", thermo_->rho());
        SLGThermo slg(mesh_(), thermo_());
        basicReactingCloud cloud("sand", rho, U, noGravity(), slg);
        expectCoreDrag(cloud, law);
    }
}


TEST_F(dragForcesTest, takeTheTemperatureOfASprayParcel)
{
    for (const char* law : laws)
    {
        SCOPED_TRACE(law);
        writeForce
        (
            law + string(";"),
            "compositionModel singlePhaseMixture; singlePhaseMixtureCoeffs {"
            " phases ( liquid { H2O 1; } ); } atomizationModel none;"
            " breakupModel none;"
        );
        openGas();
        const volVectorField U(velocity());
        const volScalarField rho("rho", thermo_->rho());
        SLGThermo slg(mesh_(), thermo_());
        basicSprayCloud cloud("sand", rho, U, noGravity(), slg);
        expectCoreDrag(cloud, law);
    }
}


TEST_F(dragForcesTest, refuseATemperatureThatParcelsHave)
{
    writeForce("lothDrag { TwOverT 1.5; }");
    openGas();
    const volVectorField U(velocity());
    const volScalarField rho("rho", thermo_->rho());
    SLGThermo slg(mesh_(), thermo_());
    const std::string message = refusal
    (
        [&]
        {
            basicThermoCloud("sand", rho, U, noGravity(), slg);
        }
    );
    for (const char* word : {"TwOverT 1.5", "temperatures of their own"})
    {
        EXPECT_NE(message.find(word), std::string::npos) << message;
    }
}
