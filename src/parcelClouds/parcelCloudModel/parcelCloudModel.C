/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "parcelCloudModel.H"
#include "IOdictionary.H"
#include "Time.H"

#include <ctime>

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    defineTypeNameAndDebug(parcelCloudModel, 0);
    defineRunTimeSelectionTable(parcelCloudModel, gas);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::parcelCloudModel::parcelCloudModel()
:
    cpuTime_(0),
    nParcelSteps_(0)
{}


Foam::autoPtr<Foam::parcelCloudModel> Foam::parcelCloudModel::New
(
    const word& name,
    const volScalarField& rho,
    const volVectorField& U,
    const volScalarField& mu,
    const dimensionedVector& g
)
{
    const IOdictionary properties
    (
        IOobject
        (
            name + "Properties",
            rho.time().constant(),
            rho.mesh(),
            IOobject::MUST_READ,
            IOobject::NO_WRITE,
            false
        )
    );
    const word type
    (
        properties.lookupOrDefault<word>("type", "basicKinematicCloud")
    );

    auto constructor = gasConstructorTablePtr_->cfind(type);
    if (!constructor.found())
    {
        FatalIOErrorInFunction(properties)
            << "Entry 'type', value " << type << ", is no kind of cloud."
            << " Valid: " << gasConstructorTablePtr_->sortedToc()
            << exit(FatalIOError);
    }

    Info<< "Cloud " << name << " (" << type << ")" << endl;
    return constructor()(name, rho, U, mu, g);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::parcelCloudModel::evolve()
{
    // OpenFOAM's own cpuTime counts in hundredths of a second
    const std::clock_t start = std::clock();
    advance();
    cpuTime_ += scalar(std::clock() - start)/CLOCKS_PER_SEC;
    nParcelSteps_ += nParcels();
}
