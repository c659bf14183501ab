/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "SpinningCloud.H"
#include "checked.H"
#include "CoreDragForce.H"
#include "GravityForce.H"
#include "MagnusForce.H"
#include "NoDispersion.H"
#include "stockCloudEntries.H"
#include "withheldOutput.H"

#include <stdexcept>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

template<class CloudType>
void Foam::SpinningCloud<CloudType>::setModels()
{
    const dictionary& solution = this->solution().dict();
    stockCloudEntries::checkSolution
    (
        solution, {"rotation", "motion", "collisions"}
    );
    stockCloudEntries::checkProperties
    (
        this->particleProperties().subDict("constantProperties"), {"omega0"}
    );
    stockCloudEntries::checkModels
    (
        this->subModelProperties(), {"rotationalTorqueModel"}
    );
    rotation_ = solution.lookupOrDefault<Switch>("rotation", true);
    torque_ = rotationalTorqueModel::New(this->subModelProperties());

    const wordList motions{"stock", "embeddedRK54"};
    const dictionary* coeffs = solution.findDict("motion");
    if (coeffs)
    {
        refuseOthers(*coeffs, {"type", "tolerance"});
    }
    const word motion
    (
        coeffs
      ? getWordOf(*coeffs, "type", "", motions)
      : getWord(solution, "motion", motions)
    );

    if (motion == "embeddedRK54")
    {
        const scalar tolerance =
            coeffs
          ? getNumber(*coeffs, "tolerance", "[1e-14, 0.1]", scalar(1e-5))
          : 1e-5;
        embedded_.reset(new impact::particleMotion(tolerance));
        checkEmbedded();
        Info<< "Selecting parcel motion embeddedRK54, tolerance " << tolerance
            << ", gas " << gas_->scheme() << endl;
    }

    Info<< "Parcels of " << label(sizeof(parcelType)) << " bytes" << endl;
    if (!rotation_)
    {
        // A force that is nothing need not be asked for each parcel
        auto& forces = this->forces();
        label kept = 0;
        forAll(forces, i)
        {
            if (!isA<MagnusForce<kinematicCloudType>>(forces[i]))
            {
                if (kept != i)
                {
                    forces.set(kept, forces.release(i));
                }
                ++kept;
            }
        }
        const bool magnus = kept < forces.size();
        forces.resize(kept);
        Info<< "Parcels without rotation: no torque"
            << (magnus ? " and no Magnus force" : "") << endl;
    }
}


template<class CloudType>
void Foam::SpinningCloud<CloudType>::setCollisions()
{
    const dictionary& solution = this->solution().dict();
    const dictionary* coeffs = solution.findDict("collisions");
    const wordList types{"off", "eventDriven"};
    const word type
    (
        coeffs
      ? getWordOf(*coeffs, "type", "", types)
      : getWord(solution, "collisions", types)
    );
    if (type == "eventDriven")
    {
        collisions_.reset
        (
            new EventDrivenCollisions<spinningCloudType>
            (
                *this,
                coeffs ? *coeffs : dictionary(solution, dictionary())
            )
        );
    }
}


template<class CloudType>
void Foam::SpinningCloud<CloudType>::checkEmbedded()
{
    const dictionary& solution = this->solution().dict();

    // The gas that the motion takes has one scheme, that of the velocity;
    // forces may have fields of their own
    dictionary& schemes =
        const_cast<dictionary&>(solution).subDictOrAdd("interpolationSchemes");
    const word& U = this->U().name();
    const word scheme = getWord(schemes, U, cellGas::schemes);
    const wordList gas
    {
        this->rho().name(), U, this->mu().name(), "T", "halfCurl(" + U + ')'
    };
    for (const entry& e : schemes)
    {
        getWordOf
        (
            schemes, e.keyword(), "",
            gas.found(e.keyword()) ? wordList(1, scheme) : cellGas::schemes
        );
    }
    for (const word& name : gas)
    {
        // What the user has given is the same scheme; added once more it
        // would be warned of
        if (!schemes.found(name, keyType::LITERAL))
        {
            schemes.add(name, scheme);
        }
    }
    gas_.reset(new cellGas(this->mesh(), scheme));

    if (this->solution().cellValueSourceCorrection())
    {
        refuse
        (
            solution, "cellValueSourceCorrection", "on",
            "off with motion embeddedRK54"
        );
    }
    if (!isA<NoDispersion<kinematicCloudType>>(this->dispersion()))
    {
        refuse
        (
            this->subModelProperties(), "dispersionModel",
            this->dispersion().modelType(), "none with motion embeddedRK54"
        );
    }
    if (this->mesh().dynamic())
    {
        refuse(solution, "motion", "embeddedRK54", "stock on a moving mesh");
    }
}


template<class CloudType>
void Foam::SpinningCloud<CloudType>::updateCurl()
{
    if (!rotation_)
    {
        return;
    }

    halfCurl_ = &cellGas::halfCurl(this->U());
    if (halfCurl_->eventNo() == halfCurlEvent_ && !this->mesh().changing())
    {
        return;
    }
    halfCurlEvent_ = halfCurl_->eventNo();

    const dictionary& schemes = this->solution().interpolationSchemes();
    const word UScheme(schemes.get<word>(this->U().name()));
    halfCurlInterp_.clear();
    halfCurlInterp_.reset
    (
        interpolation<vector>::New
        (
            schemes.lookupOrDefault<word>(halfCurl_->name(), UScheme),
            *halfCurl_
        ).ptr()
    );
}


template<class CloudType>
void Foam::SpinningCloud<CloudType>::prepareMotion()
{
    if (!embedded_.valid())
    {
        return;
    }

    typedef CoreDragForce<kinematicCloudType> dragType;
    const dragType* drag = nullptr;
    bool magnus = false;
    bool gravity = false;
    bool core = torque_->standard() || !torque_->active();
    for (const auto& force : this->forces())
    {
        const dragType* law = dynamic_cast<const dragType*>(&force);
        if (law && !drag)
        {
            drag = law;
            core = core && drag->uniformGas();
        }
        else if (isA<MagnusForce<kinematicCloudType>>(force))
        {
            magnus = true;
        }
        else if (isA<GravityForce<kinematicCloudType>>(force))
        {
            gravity = true;
        }
        else
        {
            core = false;
        }
    }

    gas_->update
    (
        this->U(),
        halfCurl_,
        this->rho(),
        this->mu(),
        drag && drag->gas() ? &drag->gas()->T() : nullptr
    );

    if (core)
    {
        coreForce_.reset
        (
            new spinningCoreForce
            (
                impact::sphereForces
                (
                    drag ? &drag->drag() : nullptr,
                    drag ? drag->gammaR() : 1,
                    magnus && rotation_,
                    torque_->active() && rotation_,
                    toCore(gravity ? this->g().value() : vector::zero),
                    counts_
                ),
                this->mesh()
            )
        );
        listedForce_.clear();
    }
    else
    {
        listedForce_.reset
        (
            new spinningListedForce<spinningCloudType>(*this, magnus)
        );
        coreForce_.clear();
    }
}


// * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * * * //

template<class CloudType>
void Foam::SpinningCloud<CloudType>::cloudReset(SpinningCloud<CloudType>& c)
{
    CloudType::cloudReset(c);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

template<class CloudType>
Foam::SpinningCloud<CloudType>::SpinningCloud
(
    const word& cloudName,
    const volScalarField& rho,
    const volVectorField& U,
    const volScalarField& mu,
    const dimensionedVector& g,
    bool readFields
)
:
    CloudType(cloudName, rho, U, mu, g, false),
    cloudCopyPtr_(nullptr),
    rotation_(true),
    embedded_(nullptr),
    torque_(nullptr),
    gas_(nullptr),
    halfCurl_(nullptr),
    halfCurlInterp_(nullptr),
    halfCurlEvent_(-2),
    ETrans_
    (
        new volScalarField::Internal
        (
            IOobject
            (
                this->name() + ":ETrans",
                this->db().time().timeName(),
                this->db(),
                IOobject::READ_IF_PRESENT,
                this->solution().coupled()
              ? IOobject::AUTO_WRITE
              : IOobject::NO_WRITE
            ),
            this->mesh(),
            dimensionedScalar(dimEnergy, Zero)
        )
    )
{
    if (this->solution().active())
    {
        setModels();

        if (readFields)
        {
            parcelType::readFields(*this);
            this->deleteLostParticles();
        }
        setCollisions();
    }

    if (this->solution().resetSourcesOnStartup())
    {
        resetSourceTerms();
    }
}


template<class CloudType>
Foam::SpinningCloud<CloudType>::SpinningCloud
(
    SpinningCloud<CloudType>& c,
    const word& name
)
:
    CloudType(c, name),
    cloudCopyPtr_(nullptr),
    rotation_(c.rotation_),
    embedded_(nullptr),
    torque_(rotationalTorqueModel::New(c.subModelProperties())),
    gas_(nullptr),
    halfCurl_(nullptr),
    halfCurlInterp_(nullptr),
    halfCurlEvent_(-2),
    ETrans_
    (
        new volScalarField::Internal
        (
            IOobject
            (
                name + ":ETrans",
                this->db().time().timeName(),
                this->db(),
                IOobject::NO_READ,
                IOobject::NO_WRITE,
                false
            ),
            c.ETrans()
        )
    ),
    counts_(c.counts_),
    collisions_(nullptr)
{
    if (c.embedded_.valid())
    {
        embedded_.reset
        (
            new impact::particleMotion(c.embedded_->tolerance())
        );
        gas_.reset(new cellGas(this->mesh(), c.gas_->scheme()));
    }
}


template<class CloudType>
Foam::SpinningCloud<CloudType>::SpinningCloud
(
    const fvMesh& mesh,
    const word& name,
    const SpinningCloud<CloudType>& c
)
:
    CloudType(mesh, name, c),
    cloudCopyPtr_(nullptr),
    rotation_(c.rotation_),
    embedded_(nullptr),
    torque_(nullptr),
    gas_(nullptr),
    halfCurl_(nullptr),
    halfCurlInterp_(nullptr),
    halfCurlEvent_(-2),
    ETrans_(nullptr)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

template<class CloudType>
Foam::scalar Foam::SpinningCloud<CloudType>::rotationalEnergyOfSystem() const
{
    scalar sum = 0;
    for (const parcelType& p : *this)
    {
        sum += p.nParticle()*p.rotationalEnergy();
    }
    return sum;
}


template<class CloudType>
void Foam::SpinningCloud<CloudType>::setParcelThermoProperties
(
    parcelType& parcel,
    const scalar lagrangianDt
)
{
    CloudType::setParcelThermoProperties(parcel, lagrangianDt);
    parcel.omega() = rotation_ ? this->constProps().omega0() : vector::zero;
}


template<class CloudType>
void Foam::SpinningCloud<CloudType>::resetSourceTerms()
{
    CloudType::resetSourceTerms();
    ETrans_->field() = 0;
}


template<class CloudType>
void Foam::SpinningCloud<CloudType>::relaxSources
(
    const SpinningCloud<CloudType>& cloudOldTime
)
{
    CloudType::relaxSources(cloudOldTime);
    this->relax(ETrans_(), cloudOldTime.ETrans(), "U");
}


template<class CloudType>
void Foam::SpinningCloud<CloudType>::scaleSources()
{
    CloudType::scaleSources();
    this->scale(ETrans_(), "U");
}


template<class CloudType>
void Foam::SpinningCloud<CloudType>::storeState()
{
    cloudCopyPtr_.reset
    (
        static_cast<SpinningCloud<CloudType>*>
        (
            clone(this->name() + "Copy").ptr()
        )
    );
}


template<class CloudType>
void Foam::SpinningCloud<CloudType>::restoreState()
{
    cloudReset(cloudCopyPtr_());
    cloudCopyPtr_.clear();
}


template<class CloudType>
void Foam::SpinningCloud<CloudType>::preEvolve
(
    FOAM_COMPAT_EVOLVE_ARGS(parcelType)
)
{
    CloudType::preEvolve(FOAM_COMPAT_EVOLVE_PASS);
    prepareMotion();
}


template<class CloudType>
void Foam::SpinningCloud<CloudType>::evolve()
{
    if (this->solution().canEvolve())
    {
        // The tracking data refer to it
        updateCurl();
        typename parcelType::trackingData td(*this);

        this->solve(*this, td);
    }
}


template<class CloudType>
template<class TrackCloudType>
void Foam::SpinningCloud<CloudType>::motion
(
    TrackCloudType& cloud,
    typename parcelType::trackingData& td
)
{
    if (collisions_.valid())
    {
        collisions_->motion(td);
        this->updateCellOccupancy();
    }
    else
    {
        CloudType::motion(cloud, td);
    }
}


template<class CloudType>
void Foam::SpinningCloud<CloudType>::info()
{
    if (withheldOutput::now())
    {
        // What counts the steps, without the sums over all parcels
        Ostream& os = Info;
        this->patchInteraction().info(FOAM_COMPAT_INFO_PASS);
        if (collisions_.valid())
        {
            collisions_->info();
        }
        return;
    }

    CloudType::info();

    FixedList<scalar, 10> sums;
    sums[0] = rotationalEnergyOfSystem();
    sums[1] = counts_.magnus;
    sums[2] = counts_.magnusOutside;
    sums[3] = counts_.torque;
    sums[4] = counts_.torqueOutside;
    sums[5] = statistics_.nSteps;
    sums[6] = statistics_.nForces;
    sums[7] = statistics_.nCuts;
    sums[8] = statistics_.nForced;
    sums[9] = statistics_.nPauses;
    for (scalar& sum : sums)
    {
        reduce(sum, sumOp<scalar>());
    }

    const scalar mostForces =
        returnReduce(statistics_.mostForces, maxOp<scalar>());

    if (rotation_)
    {
        Info<< "    Rotational kinetic energy       = " << sums[0] << nl;
        if (sums[1] > 0)
        {
            Info<< "    Magnus force beyond Re "
                << impact::magnusLift::ReMax << " (its fit)  = "
                << 100*sums[2]/sums[1] << " % of " << sums[1] << nl;
        }
        if (sums[3] > 0)
        {
            Info<< "    Torque beyond spin Re "
                << impact::rotationalTorque::ReMax << " (its fit) = "
                << 100*sums[4]/sums[3] << " % of " << sums[3] << nl;
        }
    }
    if (collisions_.valid())
    {
        collisions_->info();
    }
    if (embedded_.valid())
    {
        Info<< "    Sub-steps, forces per sub-step  = " << sums[5] << ", "
            << sums[6]/max(sums[5], scalar(1)) << nl
            << "    Most forces between two faces   = " << mostForces << nl
            << "    cut, uncontrolled, at rest      = " << sums[7] << ", "
            << sums[8] << ", " << sums[9] << nl;
    }
}
