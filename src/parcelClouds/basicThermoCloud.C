/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.

Description
    Makes basicThermoCloud selectable in constant/parcelClouds: stock parcels
    with a temperature. Its constructor takes the thermophysical model of the
    gas in the place of the viscosity.
\*---------------------------------------------------------------------------*/

#include "basicThermoCloud.H"
#include "kinematicParcelCloud.H"

namespace Foam
{

class basicThermoCloudInGas
:
    public basicThermoCloud
{
    //- One for all clouds of the mesh, which keeps it
    static const SLGThermo& thermoOf(const fvMesh& mesh)
    {
        if (!mesh.foundObject<SLGThermo>(SLGThermo::typeName))
        {
            regIOobject::store
            (
                new SLGThermo
                (
                    mesh,
                    mesh.lookupObjectRef<fluidThermo>(basicThermo::dictName)
                )
            );
        }
        return mesh.lookupObject<SLGThermo>(SLGThermo::typeName);
    }

public:

    basicThermoCloudInGas
    (
        const word& name,
        const volScalarField& rho,
        const volVectorField& U,
        const volScalarField&,
        const dimensionedVector& g
    )
    :
        basicThermoCloud(name, rho, U, g, thermoOf(rho.mesh()))
    {}
};

typedef kinematicParcelCloud<basicThermoCloudInGas>
    basicThermoCloudParcelCloud;

defineTemplateTypeNameAndDebugWithName
(
    basicThermoCloudParcelCloud,
    "basicThermoCloud",
    0
);
addToRunTimeSelectionTable(parcelCloudModel, basicThermoCloudParcelCloud, gas);

} // End namespace Foam
