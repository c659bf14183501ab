/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "parcelClouds.H"
#include "checked.H"
#include "presentFile.H"
#include "processorTime.H"
#include "wallGasInterpolation.H"
#include "withheldOutput.H"
#include "HashSet.H"
#include "IOdictionary.H"
#include "Time.H"
#include "uniformDimensionedFields.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::wordList Foam::parcelClouds::readEntries(const fvMesh& mesh)
{
    IOobject io
    (
        "parcelClouds",
        mesh.time().constant(),
        mesh,
        IOobject::MUST_READ,
        IOobject::NO_WRITE,
        false
    );
    if (!isPresent<IOdictionary>(io))
    {
        Info<< "Clouds: none (there is no file constant/parcelClouds)" << nl
            << endl;
        return wordList();
    }

    const IOdictionary dict(io);
    refuseOthers(dict, {"clouds", "sourceSmoothing", "decompositionWeights"});
    const wordList names(dict.get<wordList>("clouds"));
    Info<< "Clouds: " << (names.empty() ? "none" : listed(names).c_str())
        << nl << endl;
    wordHashSet seen;
    for (const word& name : names)
    {
        if (!seen.insert(name))
        {
            refuse(dict, "clouds", name, "a list of different names");
        }
        if (mesh.foundObject<regIOobject>(name))
        {
            // In its place in the registry the cloud would not be written
            refuse
            (
                dict, "clouds", name, "a name that no field has, here one of "
                "type ", mesh.lookupObject<regIOobject>(name).type()
            );
        }
    }
    if (dict.found("sourceSmoothing"))
    {
        const scalar length =
            getNumber(dict, "sourceSmoothing", "(0, 1e3] m");
        smoothing_.reset(new sourceSmoothing(mesh, length));
        Info<< "What clouds give to the gas is spread over " << length
            << " m" << nl << endl;
    }
    if (dict.getOrDefault<Switch>("decompositionWeights", false))
    {
        weights_.reset
        (
            new volScalarField
            (
                IOobject
                (
                    "decompositionWeights",
                    mesh.time().timeName(),
                    mesh,
                    IOobject::NO_READ,
                    IOobject::AUTO_WRITE
                ),
                mesh,
                dimensionedScalar(dimless, Zero)
            )
        );
    }
    return names;
}


void Foam::parcelClouds::weigh()
{
    const label nCells = returnReduce(rho_.size(), sumOp<label>());
    const scalar gas =
        returnReduce(processorTime::now() - setUpTime_, sumOp<scalar>())
      - cpuTime();
    scalarField& w = weights_->primitiveFieldRef();
    w = gas/(scalar(nSteps_)*nCells);
    forAll(clouds_, i)
    {
        const scalar steps =
            returnReduce(clouds_[i].nParcelSteps(), sumOp<scalar>());
        const scalar time =
            returnReduce(clouds_[i].cpuTime(), sumOp<scalar>());
        clouds_[i].count(w, time/max(steps, scalar(1)));
    }
    w /= gSum(w)/nCells;
    weights_->correctBoundaryConditions();
}


Foam::dimensionedVector Foam::parcelClouds::readG(const fvMesh& mesh)
{
    IOobject io(parcelCloudModel::gravity(mesh));
    if (isPresent<uniformDimensionedVectorField>(io))
    {
        return uniformDimensionedVectorField(io);
    }
    return dimensionedVector("g", dimAcceleration, Zero);
}


const Foam::volScalarField& Foam::parcelClouds::mu()
{
    const tmp<volScalarField> tmu(thermo_.mu());
    if (!tmu.isTmp())
    {
        // Refers to the field that the thermophysical model keeps up to date
        return tmu();
    }

    mu_.reset
    (
        new volScalarField
        (
            IOobject
            (
                "thermo:mu",
                rho_.time().timeName(),
                rho_.mesh(),
                IOobject::NO_READ,
                IOobject::NO_WRITE
            ),
            tmu()
        )
    );
    return mu_();
}


void Foam::parcelClouds::setGasChanged()
{
    if (mu_.valid())
    {
        mu_() = thermo_.mu();
    }

    // A solver that writes through raw arrays leaves no trace that the
    // cached point values would notice
    const_cast<volScalarField&>(rho_).setUpToDate();
    const_cast<volVectorField&>(U_).setUpToDate();
    const_cast<volScalarField&>(thermo_.T()).setUpToDate();
    const tmp<volScalarField> tmu(thermo_.mu());
    if (!tmu.isTmp())
    {
        const_cast<volScalarField&>(tmu()).setUpToDate();
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::parcelClouds::parcelClouds
(
    const fvMesh& mesh,
    const volScalarField& rho,
    const volVectorField& U,
    const fluidThermo& thermo
)
:
    rho_(rho),
    U_(U),
    thermo_(thermo),
    g_(readG(mesh))
{
    const wordList names(readEntries(mesh));
    if (names.empty())
    {
        return;
    }

    // Before the first scheme for the velocity is made
    wallGasVelocity::New(U);
    selectWallGasInterpolation();

    const volScalarField& viscosity = mu();
    clouds_.resize(names.size());
    forAll(names, i)
    {
        clouds_.set
        (
            i,
            parcelCloudModel::New(names[i], rho, U, viscosity, g_)
        );
    }
    setUpTime_ = processorTime::now();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::parcelClouds::evolve
(
    const bool gasChanged,
    const receiver& receive
)
{
    if (empty())
    {
        return;
    }

    if (gasChanged)
    {
        setGasChanged();
    }

    const withheldOutput quiet(!rho_.time().writeTime());
    forAll(clouds_, i)
    {
        clouds_[i].evolve();
        if (receive && clouds_[i].coupled())
        {
            momentum_.resize(rho_.size());
            energy_.resize(rho_.size());
            momentum_ = Zero;
            energy_ = 0;
            clouds_[i].give(momentum_, energy_);
            if (smoothing_.valid())
            {
                smoothing_->spread(momentum_);
                smoothing_->spread(energy_);
            }
            receive(momentum_, energy_);
            if (i + 1 < clouds_.size())
            {
                setGasChanged();
            }
        }
    }
    ++nSteps_;
    if (weights_.valid() && rho_.time().writeTime())
    {
        weigh();
    }
}


void Foam::parcelClouds::setGasResponds(const bool responds)
{
    if (responds && !empty())
    {
        // Forces by the acceleration of the gas ask for the velocity before
        // the step, already in the first one
        U_.oldTime();
    }
    forAll(clouds_, i)
    {
        clouds_[i].setGasResponds(responds);
    }
}


bool Foam::parcelClouds::coupled() const
{
    bool any = false;
    forAll(clouds_, i)
    {
        any = any || clouds_[i].coupled();
    }
    return any;
}


void Foam::parcelClouds::account(runSummary& summary)
{
    forAll(clouds_, i)
    {
        parcelCloudModel& cloud = clouds_[i];
        const scalar steps =
            returnReduce(cloud.nParcelSteps(), sumOp<scalar>());
        const scalar cpu = returnReduce(cloud.cpuTime(), sumOp<scalar>());

        Info<< "Cloud " << cloud.name() << ": "
            << returnReduce(cloud.nParcels(), sumOp<label>()) << " parcels, "
            << int64_t(steps) << " parcel-steps in " << cpu << " CPU s";
        if (cpu > 0)
        {
            Info<< " (" << steps/cpu << " 1/s)";
        }
        Info<< endl;
        cloud.account(summary);
    }
}


Foam::scalar Foam::parcelClouds::cpuTime() const
{
    scalar sum = 0;
    forAll(clouds_, i)
    {
        sum += clouds_[i].cpuTime();
    }
    return returnReduce(sum, sumOp<scalar>());
}
