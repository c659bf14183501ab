/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "SpinningCloud.H"
#include "checked.H"
#include "CoreDragForce.H"
#include "GravityForce.H"
#include "MagnusForce.H"
#include "meshTools.H"
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
        solution, {"rotation", "motion", "collisions", "heatTransfer"}
    );
    // What heat transfer reads may stay where it is switched off, but not
    // where nothing would read it
    wordList properties({"omega0"});
    wordList models({"rotationalTorqueModel"});
    if (solution.found("heatTransfer"))
    {
        properties.append(heatTransfer::properties);
        models.append("heatTransferModel");
    }
    stockCloudEntries::checkProperties
    (
        this->particleProperties().subDict("constantProperties"), properties
    );
    stockCloudEntries::checkModels(this->subModelProperties(), models);
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

    if (solution.lookupOrDefault<Switch>("heatTransfer", false))
    {
        if (!embedded_.valid())
        {
            refuse
            (
                solution, "heatTransfer", "on", "off with motion stock, on"
                " with motion embeddedRK54"
            );
        }
        heat_.reset
        (
            new heatTransfer(this->particleProperties(), this->mesh())
        );
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
void Foam::SpinningCloud<CloudType>::checkTemperatures()
{
    label without = 0;
    for (parcelType& p : *this)
    {
        scalar& T = p.temperature();
        if (!heat_.valid())
        {
            T = 0;
        }
        else if (T == 0)
        {
            T = heat_->T0();
            ++without;
        }
        else if (!(T > 0 && T < 1e8))
        {
            FatalErrorInFunction
                << "File " << this->fieldIOobject("T", IOobject::NO_READ)
                   .objectPath()
                << " has a temperature of " << T << " K: valid range "
                << validRange::temperature << exit(FatalError);
        }
    }
    reduce(without, sumOp<label>());
    if (without)
    {
        Info<< "Parcels without a temperature, which begin at T0 "
            << heat_->T0() << " K: " << without << endl;
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

    const fluidThermo* thermo =
        heat_.valid() ? &heat_->thermo() : drag ? drag->gas() : nullptr;
    const volScalarField* T = thermo ? &thermo->T() : nullptr;
    gas_->update(this->U(), halfCurl_, this->rho(), this->mu(), T);

    coreForce_.clear();
    listedForce_.clear();
    heatedCoreForce_.clear();
    heatedListedForce_.clear();
    const spinningListedForce<spinningCloudType> listed(*this, magnus);
    const spinningCoreForce coreForce
    (
        impact::sphereForces
        (
            core && drag ? &drag->drag() : nullptr,
            core && drag ? drag->gammaR() : 1,
            magnus && rotation_,
            torque_->active() && rotation_,
            toCore(gravity ? this->g().value() : vector::zero),
            counts_
        ),
        this->mesh()
    );
    if (heat_.valid())
    {
        heat_->update();
        const impact::sphereHeat sphere(heat_->sphere());
        if (core)
        {
            heatedCoreForce_.reset
            (
                new heatedForce<spinningCoreForce>(sphere, coreForce)
            );
        }
        else
        {
            heatedListedForce_.reset
            (
                new heatedForce<spinningListedForce<spinningCloudType>>
                (
                    sphere, listed
                )
            );
        }
    }
    else if (core)
    {
        coreForce_.reset(new spinningCoreForce(coreForce));
    }
    else
    {
        listedForce_.reset
        (
            new spinningListedForce<spinningCloudType>(listed)
        );
    }
}


template<class CloudType>
template<class Force>
void Foam::SpinningCloud<CloudType>::changeGas
(
    Force& force,
    typename parcelType::trackingData& td
)
{
    typedef typename Force::state State;
    const scalar dt = this->solution().trackTime();
    const polyMesh& mesh = this->mesh();
    const bool reduced = mesh.nSolutionD() != 3;
    exchanges_.assign(mesh.nCells(), impact::jointExchange());
    cellGas::field store;
    for (parcelType& p : *this)
    {
        if (!p.active())
        {
            continue;
        }
        point at = p.position();
        if (reduced)
        {
            meshTools::constrainToMeshCentre(mesh, at);
        }
        const impact::vector3 x(toCore(at));
        force.parcel(p, td);
        force.place(gas_->at(cells().locate(p.cell(), x), store), x);
        State state;
        state.x = impact::vector3{0, 0, 0};
        state.v = toCore(p.U());
        state.omega = toCore(p.omega());
        if constexpr (impact::particleMotion::thermal<State>)
        {
            state.h = force.heat().material().h(p.temperature());
        }
        const impact::gasState& here = force.here();
        const auto rate = force(state);
        force.done();

        const scalar W = p.nParticle()*p.mass();
        const scalar beta = -std::expm1(-dt*rate.k);
        impact::jointExchange& sum = exchanges_[p.cell()];
        sum.addMotion(W, beta, state.v - here.u);
        if constexpr (impact::particleMotion::thermal<State>)
        {
            // The velocity that heats by friction relaxes as well
            const scalar T = p.temperature();
            const scalar Cp = force.heat().material().cp(T);
            const auto e = force.heat().with(here, state.v);
            const scalar relaxed = -std::expm1(-dt*e.conductance/Cp);
            sum.addHeat
            (
                W*Cp,
                relaxed,
                T - here.T - sqr(1 - beta)*(e.Taw - here.T),
                W*force.heat().radiated(T)*(dt - relaxed*Cp/e.conductance)
            );
        }
    }
    changes_.resize(mesh.nCells());
    forAll(mesh.cells(), celli)
    {
        const scalar M = this->rho()[celli]*this->mesh().V()[celli];
        changes_[celli] =
            exchanges_[celli](M, heat_.valid() ? M*heat_->Cv() : 0);
    }
    gas_->change(this->U(), changes_);
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
    heat_(nullptr),
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
            checkTemperatures();
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
    heat_
    (
        c.heat_.valid()
      ? new heatTransfer(c.particleProperties(), c.mesh())
      : nullptr
    ),
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
    heat_(nullptr),
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
Foam::Pair<Foam::scalar>
Foam::SpinningCloud<CloudType>::heatOfSystem() const
{
    Pair<scalar> sum(0, 0);
    for (const parcelType& p : *this)
    {
        const scalar mass = p.nParticle()*p.mass();
        sum.first() += mass*heat_->material().h(p.temperature());
        sum.second() += mass*p.temperature();
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
    parcel.temperature() = heat_.valid() ? heat_->T0() : 0;
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
    inMotion_ = true;
    if (embedded_.valid() && this->solution().coupled() && gasResponds_)
    {
        if (coreForce_.valid())
        {
            changeGas(coreForce_(), td);
        }
        else if (listedForce_.valid())
        {
            changeGas(listedForce_(), td);
        }
        else if (heatedCoreForce_.valid())
        {
            changeGas(heatedCoreForce_(), td);
        }
        else
        {
            changeGas(heatedListedForce_(), td);
        }
    }

    if (collisions_.valid())
    {
        collisions_->motion(td);
        this->updateCellOccupancy();
    }
    else
    {
        CloudType::motion(cloud, td);
    }
    inMotion_ = false;
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
    if (heat_.valid())
    {
        FixedList<scalar, 4> heats;
        heats[0] = statistics_.heat;
        heats[1] = statistics_.radiated;
        const Pair<scalar> now(heatOfSystem());
        heats[2] = now.first();
        heats[3] = now.second();
        for (scalar& heat : heats)
        {
            reduce(heat, sumOp<scalar>());
        }
        const scalar mass =
            returnReduce(this->massInSystem(), sumOp<scalar>());
        Info<< "    Mean temperature                = "
            << heats[3]/max(mass, VSMALL) << nl
            << "    Enthalpy                        = " << heats[2] << nl
            << "    Heat from the gas, radiated     = " << heats[0] << ", "
            << heats[1] << nl;
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
