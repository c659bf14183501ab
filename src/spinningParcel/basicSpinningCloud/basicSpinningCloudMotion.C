/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "BlockMotion.H"
#include "checked.H"
#include "eventDrivenCollisions.H"
#include "SaffmanMeiLiftForce.H"

#include <limits>

// * * * * * * * * * * * * * * * * Local Classes * * * * * * * * * * * * * * //

class Foam::basicSpinningCloud::settled
{
    const basicSpinningCloud& cloud_;

public:

    explicit settled(const basicSpinningCloud& cloud)
    :
        cloud_(cloud)
    {
        if (cloud_.embedded_.valid())
        {
            cloud_.settle(cloud_.cells(), true);
        }
    }

    settled(const settled&) = delete;
    void operator=(const settled&) = delete;

    ~settled()
    {
        if (cloud_.embedded_.valid())
        {
            cloud_.settle(cloud_.cells(), false);
        }
    }
};


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::basicSpinningCloud::checkEmbedded()
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
        rho().name(), U, mu().name(), "T", "halfCurl(" + U + ')'
    };
    wordList valid(gas);
    valid.append
    (
        wordList({"DUcDt", "curlUcDt", "p", "mu", "muc", "rhoc", "Cp", "kappa"})
    );
    for (const entry& e : schemes)
    {
        const bool known =
            e.keyword().isPattern()
         || valid.found(e.keyword())
         || mesh().objectRegistry::found(e.keyword());
        if (!known)
        {
            unknownWord(schemes, "field", e.keyword(), valid);
        }
        getWordOf
        (
            schemes, e.keyword(), "",
            gas.found(e.keyword()) ? wordList(1, scheme) : cellGas::schemes
        );
    }
    wordList asked(gas);
    asked.append(wordList({"DUcDt", "curlUcDt"}));
    for (const word& name : asked)
    {
        // What the user has given is the same scheme; added once more it
        // would be warned of
        if (!schemes.found(name, keyType::LITERAL))
        {
            schemes.add(name, scheme);
        }
    }
    gas_.reset(new cellGas(mesh(), scheme));

    if (solution.found("deltaTMax"))
    {
        refuse
        (
            solution, "deltaTMax", solution.get<scalar>("deltaTMax"),
            "none with motion embeddedRK54, whose steps follow the tolerance"
        );
    }
    if (this->solution().cellValueSourceCorrection())
    {
        refuse
        (
            solution, "cellValueSourceCorrection", "on",
            "off with motion embeddedRK54"
        );
    }
    if (mesh().dynamic())
    {
        refuse(solution, "motion", "embeddedRK54", "stock on a moving mesh");
    }
}


void Foam::basicSpinningCloud::updateCurl()
{
    bool lift = false;
    for (const auto& force : forces())
    {
        lift = lift || isA<SaffmanMeiLiftForce<kinematicCloudType>>(force);
    }
    if (!rotation_ && !(lift && embedded_.valid()))
    {
        return;
    }

    halfCurl_ = &cellGas::halfCurl(U());
    if (halfCurl_->eventNo() == halfCurlEvent_ && !mesh().changing())
    {
        return;
    }
    halfCurlEvent_ = halfCurl_->eventNo();

    const dictionary& schemes = solution().interpolationSchemes();
    const word UScheme(schemes.get<word>(U().name()));
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


void Foam::basicSpinningCloud::prepareMotion()
{
    if (!embedded_.valid())
    {
        return;
    }

    const coreForces core = coreForcesOf();
    const fluidThermo* thermo = heat_.valid() ? &heat_->thermo() : core.gas;
    const volScalarField* T = thermo ? &thermo->T() : nullptr;
    const bool changing =
        gasResponds_
     && (core.secondary.pressureGradient || core.secondary.virtualMass > 0);
    gas_->update
    (
        U(), halfCurl_, rho(), mu(), T, changing
    );
    if (eddies_.valid())
    {
        eddies_->update(solution().trackTime());
    }

    // Ends and walls are all that these functions look at
    static const wordList ofWalls
    {
        "dispersedPhase", "impactRecords", "surfaceImpact",
        "particleErosion", "patchPostProcessing"
    };
    watched_ = false;
    for (const auto& function : functions())
    {
        watched_ = watched_ || !ofWalls.found(function.type());
    }

    const auto set = [&](const auto& force)
    {
        typedef std::decay_t<decltype(force)> Force;
        if (heat_.valid())
        {
            heat_->update();
            force_.emplace
            (
                std::in_place_type<heatedForce<Force>>, heat_->sphere(), force
            );
        }
        else
        {
            force_.emplace(std::in_place_type<Force>, force);
        }
    };
    if (!core.all)
    {
        set(listedForce(*this, core.magnus));
        return;
    }
    set
    (
        spinningCoreForce
        (
            impact::sphereForces
            (
                core.drag,
                core.gammaR,
                core.magnus && rotation_,
                torque_ && rotation_,
                toCore(core.gravity ? g().value() : vector::zero),
                counts_
            ),
            core.secondary,
            mesh()
        )
    );
}


template<class Force>
void Foam::basicSpinningCloud::changeGas
(
    Force& force,
    parcelType::trackingData& td
)
{
    typedef typename Force::state State;
    const scalar dt = solution().trackTime();
    const fvMesh& mesh = this->mesh();
    exchanges_.assign(mesh.nCells(), impact::jointExchange());
    cellGas::field store;
    const auto add = [&](parcelType& p)
    {
        impact::vector3 x{0, 0, 0};
        label celli = -1;
        p.locate(cells(), x, celli);
        if (Force::places)
        {
            p.land(cells());
        }
        force.parcel(p, td);
        if (eddies_.valid())
        {
            force.eddy(toCore(p.UTurb()));
        }
        force.place(gas_->at(celli, store), x);
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
        statistics_.heaviest = max
        (
            statistics_.heaviest, W/(rho()[p.cell()]*mesh.V()[p.cell()])
        );
        impact::jointExchange& sum = exchanges_[p.cell()];
        sum.addMotion(W, dt, here, state.v, rate.k);
        if constexpr (impact::particleMotion::thermal<State>)
        {
            sum.addHeat
            (
                W, dt, here, state.v, rate.k, p.temperature(), force.heat()
            );
        }
    };
    if (arrays().size())
    {
        std::unique_ptr<parcelType> p(objectOf(0));
        for (label i = 0; i < arrays().size(); ++i)
        {
            arrays().show(i, cells(), *p);
            add(*p);
        }
    }
    for (parcelType& p : objects())
    {
        if (p.active())
        {
            add(p);
        }
    }
    changes_.resize(mesh.nCells());
    forAll(mesh.cells(), celli)
    {
        const scalar M = rho()[celli]*mesh.V()[celli];
        changes_[celli] =
            exchanges_[celli](M, heat_.valid() ? M*heat_->Cv() : 0);
    }
    gas_->change(U(), changes_);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::basicSpinningCloud::writeFields() const
{
    {
        const settled now(*this);
        particle::writeFields(*this);
    }
    parcelType::writeFields(*this);
    if (eddies_.valid())
    {
        parcelType::writeField
        (
            *this, "nEddies", [](const parcelType& p) { return p.nEddies(); }
        );
    }
    if (!embedded_.valid() || watched_)
    {
        return;
    }

    // Coordinates round off where a parcel is: with these a run that goes on
    // from here is the same to the last bit, if all bits are written
    const bool exact =
        db().time().writeFormat() == IOstream::BINARY
     || IOstream::defaultPrecision()
     >= unsigned(std::numeric_limits<scalar>::max_digits10);
    if (!exact)
    {
        return;
    }
    parcelType::writeField
    (
        *this, exactPosition, [](const parcelType& p) { return p.position(); }
    );
    parcelType::writeField
    (
        *this, convexCell, [](const parcelType& p) { return p.inFlight().cell; }
    );
}


void Foam::basicSpinningCloud::writeObjects(objectRegistry& obr) const
{
    const settled now(*this);
    kinematicCloudType::writeObjects(obr);
}


void Foam::basicSpinningCloud::preEvolve
(
    FOAM_COMPAT_EVOLVE_ARGS(parcelType)
)
{
    kinematicCloudType::preEvolve(FOAM_COMPAT_EVOLVE_PASS);
    prepareMotion();
    if (inArrays())
    {
        // What is injected comes behind what there is
        pack(cells());
        packAdded(cells(), true);
    }
}


void Foam::basicSpinningCloud::motion
(
    basicSpinningCloud& cloud,
    parcelType::trackingData& td
)
{
    inMotion_ = true;
    if (inArrays())
    {
        packAdded(cells(), false);
    }
    else
    {
        unpack();
    }
    if (embedded_.valid() && solution().coupled() && gasResponds_)
    {
        withForce([&](auto& force) { changeGas(force, td); });
    }

    if (collisions_.valid())
    {
        collisions_->motion(td);
        updateCellOccupancy();
    }
    else if (inArrays())
    {
        // Those that stick to walls step aside for those that go on one by one
        IDLList<parcelType> inactive;
        inactive.transfer(objects());
        for (parcelType& p : inactive)
        {
            p.stepFraction() = 1;
            p.age() += solution().trackTime();
        }
        moveInBlocks
        (
            *this,
            [&](const label i, const parcelType::begun& begun)
            {
                leaveBegun(*take(i), begun);
            }
        );
        fill();
        kinematicCloudType::motion(cloud, td);
        while (inactive.size())
        {
            objects().append(inactive.removeHead());
        }
    }
    else
    {
        kinematicCloudType::motion(cloud, td);
    }
    inMotion_ = false;
}
