/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "ParcelWallModel.H"
#include "writtenState.H"
#include "impactTime.H"
#include "parcelHeat.H"

// * * * * * * * * * * * * * ParcelWallReport * * * * * * * * * * * * * * * * //

template<class CloudType>
void Foam::ParcelWallReport<CloudType>::postEvolve
(
    FOAM_COMPAT_EVOLVE_ARGS(CloudType::parcelType)
)
{
    CloudType& cloud = this->owner();
    const bool store =
        cloud.solution().transient() && cloud.db().time().writeTime();
    counters_.report(Info, cloud.outputProperties(), true, store);
    if (store)
    {
        writtenState::addParcels(cloud.mesh(), cloud, cloud.size());
    }
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

template<class CloudType>
void Foam::ParcelWallModel<CloudType>::publish
(
    const parcelType& p,
    const polyPatch& pp,
    const wallHit& hit,
    const vector& U1,
    const bool captured
)
{
    const scalar mass = p.mass();

    wallImpact impact;
    impact.patch = pp.index();
    impact.face = pp.whichFace(p.face());
    impact.origProc = p.origProc();
    impact.origId = p.origId();
    impact.time = impactTime(p);
    impact.position = p.position();
    impact.n = fromCore(hit.n);
    impact.Uw = hit.Uw;
    impact.U0 = hit.U0;
    impact.U1 = U1;
    impact.omega0 = hit.omega0;
    impact.omega1 = spins_ ? fromCore(hit.omega1) : vector(Zero);
    impact.rotationalEnergy0 = spins_ ? mass*hit.rotation0 : 0;
    impact.rotationalEnergy1 = spins_ ? mass*hit.rotation1 : 0;
    impact.d = p.d();
    impact.mass = mass;
    impact.nParticle = p.nParticle();
    impact.captured = captured;
    parcelHeat::set(impact, p, impacts_);
    impacts_.publish(impact);
}


// * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * * * //

template<class CloudType>
inline bool Foam::ParcelWallModel<CloudType>::arrive
(
    parcelType& p,
    const polyPatch& pp,
    bool& keepParticle,
    wallHit& hit
)
{
    hit.setting = patches_.of(pp.index());
    hit.handled = hit.setting >= 0;
    if (!hit.handled)
    {
        return false;
    }
    const fateType fate = fates_[hit.setting];
    keepParticle = true;
    p.active(true);
    if (fate == fateType::escape)
    {
        wallCounters::counts& c = counters_.of(pp.index());
        c[wallCounters::escapedParcels] += 1;
        c[wallCounters::escapedMass] += p.nParticle()*p.mass();
        keepParticle = false;
        p.active(false);
        return false;
    }

    vector nw;
    this->owner().patchData(p, pp, nw, hit.Uw);
    hit.U0 = p.U();
    const vector V0(hit.U0 - hit.Uw);
    const scalar approach = V0 & nw;
    if (approach <= 0)
    {
        if (approach > -sliding*mag(V0))
        {
            lift(p);
        }
        return false;
    }
    hit.n = toCore(-nw);
    hit.V0 = toCore(V0);
    hit.omega0 = spins_ ? parcelSpin::get(p) : vector(Zero);
    hit.radius = 0.5*p.d();

    if (fate == fateType::capture)
    {
        hit.rotation0 =
            impact::sphereRotationalEnergy(hit.radius, toCore(hit.omega0));
        capture(p, pp, hit, keepParticle);
        return false;
    }
    return true;
}


template<class CloudType>
inline void Foam::ParcelWallModel<CloudType>::leave
(
    parcelType& p,
    const polyPatch& pp,
    const wallHit& hit
)
{
    vector V1(fromCore(hit.V1));
    reduceDimensions(V1);
    p.U() = V1 + hit.Uw;
    if (spins_)
    {
        parcelSpin::set(p, fromCore(hit.omega1));
    }
    if constexpr (parcelSpin::countsImpacts<parcelType>)
    {
        ++p.nImpacts();
    }

    wallCounters::counts& c = counters_.of(pp.index());
    const scalar mass = p.nParticle()*p.mass();
    c[wallCounters::hits] += 1;
    c[wallCounters::translationLost] += mass
       *(
            impact::translationalEnergy(hit.V0)
          - impact::translationalEnergy(toCore(V1))
        );
    if (spins_)
    {
        c[wallCounters::rotationLost] +=
            mass*(hit.rotation0 - hit.rotation1);
    }
    if (impacts_.heard())
    {
        publish(p, pp, hit, p.U(), false);
    }
    if (mag(V1 & fromCore(hit.n)) < sliding*mag(V1))
    {
        lift(p);
    }
}


template<class CloudType>
void Foam::ParcelWallModel<CloudType>::capture
(
    parcelType& p,
    const polyPatch& pp,
    wallHit& hit,
    bool& keepParticle
)
{
    wallCounters::counts& c = counters_.of(pp.index());
    const scalar mass = p.nParticle()*p.mass();
    hit.V1 = hit.omega1 = {0, 0, 0};
    hit.rotation1 = 0;
    c[wallCounters::hits] += 1;
    c[wallCounters::capturedParcels] += 1;
    c[wallCounters::capturedMass] += mass;
    c[wallCounters::translationLost] +=
        mass*impact::translationalEnergy(hit.V0);
    c[wallCounters::rotationLost] += mass*hit.rotation0;
    if (impacts_.heard())
    {
        publish(p, pp, hit, hit.Uw, true);
    }
    keepParticle = false;
    p.active(false);
}


template<class CloudType>
void Foam::ParcelWallModel<CloudType>::reduceDimensions(vector& V) const
{
    if (reduced_)
    {
        const polyMesh& mesh = this->owner().pMesh();
        const scalar speed = mag(V);
        meshTools::constrainDirection(mesh, mesh.solutionD(), V);
        const scalar rest = mag(V);
        if (keepSpeed_ && rest > 0)
        {
            V *= speed/rest;
        }
    }
}


template<class CloudType>
void Foam::ParcelWallModel<CloudType>::lift(parcelType& p) const
{
    const point& centre = this->owner().pMesh().cellCentres()[p.cell()];
    p.trackToFace(1e-6*(centre - p.position()), 0);
}


template<class CloudType>
void Foam::ParcelWallModel<CloudType>::compareWithLastRun()
{
    // Of one model to a cloud; those within multiInteraction each
    const string settings
    (
        this->modelType() + " " + this->coeffDict().digest().str()
    );
    const word entry("settings");
    string before;
    if (nested_)
    {
        this->getModelProperty(entry, before);
        this->setModelProperty(entry, settings);
    }
    else
    {
        this->getBaseProperty(entry, before);
        this->setBaseProperty(entry, settings);
    }
    if (!before.empty() && before != settings)
    {
        const string type(before.substr(0, before.find(' ')));
        Info<< "    The settings of the wall model are not those of the run"
            << " before (" << type.c_str() << " then): "
            << (
                    type == this->modelType()
                  ? "counters and averages go on."
                  : "it counts for itself, averages go on."
               )
            << " Averages begin anew with the entry 'restart anew;' of their"
            << " function" << endl;
    }
}


template<class CloudType>
void Foam::ParcelWallModel<CloudType>::startReport()
{
    auto& functions = this->owner().functions();
    for (const auto& function : functions)
    {
        if (isA<ParcelWallReport<CloudType>>(function))
        {
            return;
        }
    }
    functions.append(new ParcelWallReport<CloudType>(this->owner()));
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

template<class CloudType>
Foam::ParcelWallModel<CloudType>::ParcelWallModel
(
    const dictionary& dict,
    CloudType& owner,
    const word& type,
    const List<string>& specials,
    const wordList& entries
)
:
    PatchInteractionModel<CloudType>(dict, owner, type),
    nested_(&dict != &owner.subModelProperties()),
    patches_
    (
        this->coeffDict(), owner.pMesh().boundaryMesh(), type, !nested_
    ),
    fates_(patches_.size()),
    counters_(wallCounters::New(owner)),
    impacts_(wallImpacts::New(owner)),
    spins_
    (
        parcelSpin::carried<parcelType>()
     && owner.solution().dict().template lookupOrDefault<Switch>
        (
            "rotation", true
        )
    ),
    reduced_
    (
        keepsToSolvedDirections<parcelType>
     && owner.pMesh().nSolutionD() < 3
    ),
    keepSpeed_
    (
        getWord
        (
            this->coeffDict(), "reducedDimensions", {"project", "keepSpeed"}
        ) == "keepSpeed"
    )
{
    // Beside those of the stock model: writeToFile and its like
    wordList valid
    {
        "patches", "reducedDimensions", "U", "writeToFile", "writePrecision",
        "useUserTime", "type"
    };
    valid.append(entries);
    refuseOthers(this->coeffDict(), valid);
    getWord(this->coeffDict(), "type", {this->modelType()});
    getWord(this->coeffDict(), "U", {owner.U().name()});

    forAll(fates_, i)
    {
        const word fate
        (
            getWordOf
            (
                patches_[i], "type", "rebound",
                {"rebound", "escape", "capture"}
            )
        );
        fates_[i] =
            fate == "rebound" ? fateType::rebound
          : fate == "escape" ? fateType::escape : fateType::capture;
        if (fates_[i] != fateType::rebound)
        {
            refuseOthers(patches_[i], {"type"});
        }
    }
    forAll(patches_.ofPatch(), patchi)
    {
        const label i = patches_.of(patchi);
        if (i < 0)
        {
            continue;
        }
        const word& patch = owner.pMesh().boundaryMesh()[patchi].name();
        const word other
        (
            counters_.declare
            (
                patchi,
                patch,
                type,
                nested_,
                fates_[i] == fateType::escape,
                specials
            )
        );
        if (!other.empty())
        {
            refuse
            (
                this->coeffDict(), "patches", patch, "one law to a patch, this"
                " one has that of ", other
            );
        }
        if (fates_[i] != fateType::escape)
        {
            impacts_.publishes(patchi);
        }
    }
    if (nested_)
    {
        startReport();
    }
    compareWithLastRun();
    writtenState::checkParcels(owner.mesh(), owner.name(), owner.size());
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

template<class CloudType>
void Foam::ParcelWallModel<CloudType>::info(FOAM_COMPAT_INFO_ARGS)
{
    if (nested_)
    {
        return;
    }
    PatchInteractionModel<CloudType>::info(FOAM_COMPAT_INFO_PASS);
    this->file() << endl;
    counters_.report
    (
        FOAM_COMPAT_INFO_STREAM,
        this->owner().outputProperties(),
        false,
        this->writeTime()
    );
    if (this->writeTime())
    {
        writtenState::addParcels
        (
            this->owner().mesh(), this->owner(), this->owner().size()
        );
    }
}
