/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "solidCloud.H"
#include "checked.H"
#include "foamCompat.H"
#include "wallImpacts.H"
#include "withheldOutput.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::solidCloud::solidCloud
(
    const word& name,
    const dictionary& dict,
    const fvMesh& mesh,
    const dsmcGas& gas,
    const scalar specificHeat,
    const label nFlying
)
:
    cloud(mesh, name),
    mesh_(mesh),
    solution_(dict),
    U_(gas),
    heat_({specificHeat}, impact::specificHeat::melting()),
    nFlying_(nFlying),
    outputProperties_
    (
        IOobject
        (
            name + "OutputProperties",
            mesh.time().timeName(),
            "uniform"/cloud::prefix/name,
            mesh,
            IOobject::READ_IF_PRESENT,
            IOobject::NO_WRITE
        )
    )
{
    wallImpacts::New(*this).setMaterial(heat_);
    const dictionary* functions = findBlock(dict, "cloudFunctions");
    functions_.reset
    (
        functions
      ? new CloudFunctionObjectList<solidCloud>(*this, *functions, true)
      : new CloudFunctionObjectList<solidCloud>(*this)
    );
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::vector Foam::solidCloud::gasVelocity::operator[](const label celli) const
{
    const moleculeArray& molecules = gas_.molecules();
    vector momentum(Zero);
    scalar mass = 0;
    const label last = molecules.begin(celli + 1);
    for (label i = molecules.begin(celli); i < last; ++i)
    {
        const scalar m = gas_.species()[molecules.payload().typeId[i]].mass;
        const impact::vector3 u = molecules.velocity(i);
        momentum += m*vector(u.x, u.y, u.z);
        mass += m;
    }
    return mass > 0 ? momentum/mass : momentum;
}


void Foam::solidCloud::beginStep()
{
    foamCompat::preEvolve(functions_(), *this);
}


std::vector<std::unique_ptr<Foam::solidParcel>> Foam::solidCloud::endStep
(
    const label nFlying,
    const bool report
)
{
    nFlying_ = nFlying;
    {
        const withheldOutput quiet(!report);
        foamCompat::postEvolve(functions_(), *this);
    }
    std::vector<std::unique_ptr<solidParcel>> released;
    released.swap(released_);
    return released;
}


void Foam::solidCloud::writeProperties() const
{
    // A restart goes on with the same bits, whatever writePrecision is
    const unsigned precision = IOstream::defaultPrecision(17);
    const_cast<IOdictionary&>(outputProperties_).instance() =
        mesh_.time().timeName();
    outputProperties_.writeObject
    (
        IOstream::ASCII,
        IOstream::currentVersion,
        mesh_.time().writeCompression(),
        true
    );
    IOstream::defaultPrecision(precision);
}
