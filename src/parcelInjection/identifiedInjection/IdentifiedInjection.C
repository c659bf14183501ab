/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "IdentifiedInjection.H"
#include "checked.H"
#include "cellLocator.H"
#include "IOField.H"
#include "pastWrite.H"
#include "stockCloudEntries.H"

#include <cmath>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

template<class CloudType>
Foam::dictionary Foam::IdentifiedInjection<CloudType>::complete
(
    const dictionary& dict,
    const wordList& entries
)
{
    wordList valid
    {
        "type", "U0", "startTime", "diameter", "nParticle", "injectorID"
    };
    valid.append(entries);
    refuseOthers(dict, valid);

    // Mass and number are set by the models themselves; the base class must
    // not withhold a parcel that stands for less than one particle
    dictionary result(dict);
    result.set("massTotal", scalar(0));
    result.set("parcelBasisType", word("number"));
    result.set("minParticlesPerParcel", scalar(0));
    result.set
    (
        "SOI",
        getNumber(result, "startTime", validRange::time, scalar(0))
    );
    result.set
    (
        "nParticle",
        getNumber(result, "nParticle", validRange::number, scalar(1))
    );
    return result;
}


template<class CloudType>
Foam::label Foam::IdentifiedInjection<CloudType>::largestIdentity() const
{
    label largest = -1;
    if (this->properties().found(this->baseName()))
    {
        const dictionary& models =
            this->properties().subDict(this->baseName());
        for (const entry& model : models)
        {
            if (model.isDict())
            {
                largest = max
                (
                    largest,
                    model.dict().template getOrDefault<label>("used", -1)
                );
            }
        }
    }

    const auto numbers = [&](const word& name)
    {
        const IOobject io
        (
            this->owner().fieldIOobject(name, IOobject::MUST_READ)
        );
        IOobject header(io);
        const bool here = header.typeHeaderOk<IOField<label>>(false);
        if (!returnReduce(here, orOp<bool>()))
        {
            return labelList();
        }
        return labelList(IOField<label>(io, here));
    };
    const labelList origId(numbers("origId"));
    const labelList origProc(numbers("origProcId"));
    forAll(origProc, i)
    {
        if (origProc[i] == 0 && i < origId.size())
        {
            largest = max(largest, origId[i]);
        }
    }
    return returnReduce(largest, maxOp<label>());
}


template<class CloudType>
void Foam::IdentifiedInjection<CloudType>::locate
(
    DynamicList<newParcel>& parcels
) const
{
    const polyMesh& mesh = this->owner().mesh();
    const cellLocator& locator = cellLocator::New(mesh);

    // A point on a face between two ranks is claimed by both or by none.
    // Both: the higher rank takes it. None: it is moved a rounding error
    // towards the nearest cell centre and asked again. If it has just entered
    // and flown through a wall it starts anew where it entered.
    for (label attempt = 0; attempt < 3; ++attempt)
    {
        labelList owner(parcels.size(), -1);
        forAll(parcels, i)
        {
            newParcel& parcel = parcels[i];
            if (attempt > 0 && parcel.cell != -2)
            {
                owner[i] = parcel.cell >= 0 ? Pstream::myProcNo() : -1;
                continue;
            }

            point p = parcel.position;
            parcel.cell = -1;
            if (attempt == 2)
            {
                if (parcel.flown == vector::zero)
                {
                    continue;
                }
                p -= parcel.flown;
            }
            if (attempt > 0 && mesh.nCells())
            {
                const label near = locator.near(p);
                if (near < 0)
                {
                    continue;
                }
                p += 1e-9*(mesh.cellCentres()[near] - p);
            }
            parcel.cell = locator.find(p);
            if (parcel.cell >= 0)
            {
                parcel.position = p;
                owner[i] = Pstream::myProcNo();
            }
        }

        Pstream::listCombineGather(owner, maxEqOp<label>());
        Pstream::listCombineScatter(owner);

        bool complete = true;
        forAll(parcels, i)
        {
            if (owner[i] == -1)
            {
                parcels[i].cell = attempt < 2 ? -2 : -1;
                complete = false;
            }
            else if (owner[i] != Pstream::myProcNo())
            {
                parcels[i].cell = -1;
            }
        }
        if (complete)
        {
            break;
        }
    }
    for (newParcel& parcel : parcels)
    {
        if (parcel.cell >= 0)
        {
            parcel.position = locator.offAxis(parcel.position, parcel.cell);
        }
    }
}


// * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * * * //

template<class CloudType>
void Foam::IdentifiedInjection<CloudType>::checkDiameter
(
    const dictionary& dict,
    const word& entry,
    const scalar d
) const
{
    checkNumber(dict, entry, d, validRange::diameter);
    const scalar widest = this->owner().mesh().bounds().mag();
    if (d > widest)
    {
        refuse
        (
            dict, entry, d, "up to ", widest, " m, from corner to corner of"
            " the mesh: diameters are in metres"
        );
    }
}


template<class CloudType>
Foam::scalar Foam::IdentifiedInjection<CloudType>::thickness() const
{
    const polyMesh& mesh = this->owner().mesh();
    if (mesh.nSolutionD() != 2)
    {
        return -1;
    }
    const Vector<label>& solved = mesh.solutionD();
    const direction empty = solved.x() == -1 ? 0 : solved.y() == -1 ? 1 : 2;
    return mesh.bounds().span()[empty];
}


template<class CloudType>
typename Foam::IdentifiedInjection<CloudType>::sequence
Foam::IdentifiedInjection<CloudType>::resumed
(
    const string& settings,
    const bool given
)
{
    settings_ = settings;
    string before;
    this->getModelProperty("settings", before);

    // (a model that was out of the run before has a state of an earlier one)
    string models;
    this->getBaseProperty("models", models);
    const bool there =
        models.empty()
     || models.find(" " + this->modelName() + " ") != string::npos;
    return
        !there || !given ? sequence::fresh
      : before.empty() || before == settings_ ? sequence::continued
      : sequence::changed;
}


template<class CloudType>
void Foam::IdentifiedInjection<CloudType>::setIdentities(const sequence past)
{
    string before;
    this->getBaseProperty("models", before);
    usedBefore_ = this->template getModelProperty<label>("used", -1);

    // A model that begins after the restart has those of the unbroken run
    const bool begins = !before.empty() && usedBefore_ < 0;
    if
    (
        (past == sequence::continued || begins)
     && (before.empty() || before == models_)
    )
    {
        base_ = this->template getModelProperty<label>("base");
        first_ = this->template getModelProperty<label>("first");
        return;
    }

    // Multiples of one number: identities stay interleaved
    const int64_t next = int64_t(largestIdentity()) + 1;
    base_ = (next + nModels_ - 1)/nModels_*nModels_;
    first_ = past == sequence::fresh ? 0 : given();
}


template<class CloudType>
void Foam::IdentifiedInjection<CloudType>::storeIdentities()
{
    this->template setBaseProperty<string>("models", models_);
    this->template setModelProperty<string>("settings", settings_);
    this->template setModelProperty<label>("base", base_);
    this->template setModelProperty<label>("first", first_);
    this->template setModelProperty<label>
    (
        "used",
        given() > first_
      ? max(usedBefore_, identity(given() - 1))
      : usedBefore_
    );
}


template<class CloudType>
bool Foam::IdentifiedInjection<CloudType>::validInjection(const label parcelI)
{
    // The base class takes the time of injection from here: the end of the
    // step, so that it does not move the parcel itself
    this->time0_ = this->owner().db().time().value();
    current_ = parcelI;
    return true;
}


template<class CloudType>
bool Foam::IdentifiedInjection<CloudType>::prepareForNextTimeStep
(
    const scalar time,
    label& newParcels,
    scalar& newVolumeFraction
)
{
    // The sum of the time steps and the time a restart reads from the name of
    // its folder differ by rounding; a grid of a millionth of a step removes
    // the difference
    const scalar deltaT = this->owner().db().time().deltaTValue();
    const scalar grid = 1e-6*deltaT;
    const scalar t0 = grid*std::round((time - deltaT)/grid);

    DynamicList<newParcel> candidates;
    select(t0, candidates);
    locate(candidates);

    label nHere = 0;
    for (const newParcel& candidate : candidates)
    {
        nHere += candidate.cell >= 0;
    }
    outside
    (
        candidates,
        candidates.size() - returnReduce(nHere, sumOp<label>())
    );

    // In place: those that fill the domain at the start are many
    nHere = 0;
    for (const newParcel& candidate : candidates)
    {
        if (candidate.cell >= 0)
        {
            candidates[nHere++] = candidate;
        }
    }
    candidates.setSize(nHere);
    parcels_.transfer(candidates);
    parcels_.shrink();

    newParcels = parcels_.size();
    newVolumeFraction = 1;

    // Makes the base class' interval of injection within the step empty
    this->time0_ = this->timeEnd();

    if (this->writeTime())
    {
        store();
        storeIdentities();
    }

    return newParcels > 0;
}


template<class CloudType>
void Foam::IdentifiedInjection<CloudType>::postInjectCheck
(
    const label parcelsAdded,
    const scalar massAdded
)
{
    InjectionModel<CloudType>::postInjectCheck(parcelsAdded, massAdded);

    parcels_.clearStorage();
}


template<class CloudType>
void Foam::IdentifiedInjection<CloudType>::info(FOAM_COMPAT_INFO_ARGS)
{
    // What has been given is about to be stored: with these parcels
    pastWrite::catchUp(this->owner().mesh(), this->owner());
    InjectionModel<CloudType>::info(FOAM_COMPAT_INFO_PASS);
}


template<class CloudType>
Foam::scalar Foam::IdentifiedInjection<CloudType>::setNumberOfParticles
(
    const label parcels,
    const scalar volumeFraction,
    const scalar diameter,
    const scalar rho
)
{
    return parcels_[current_].nParticle;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

template<class CloudType>
Foam::IdentifiedInjection<CloudType>::IdentifiedInjection
(
    const dictionary& dict,
    CloudType& owner,
    const word& modelName,
    const word& modelType,
    const wordList& entries
)
:
    InjectionModel<CloudType>
    (
        complete(dict, entries), owner, modelName, modelType
    ),
    U0_(getComponents(this->coeffDict(), "U0", validRange::velocity))
{
    stockCloudEntries::refuseSteady(owner, modelType);

    checkNumber
    (
        owner.constProps().dict(), "rho0", owner.constProps().rho0(),
        validRange::density
    );

    const Vector<label>& solved = owner.mesh().solutionD();
    for (direction d = 0; d < 3; ++d)
    {
        if (solved[d] < 0 && U0_[d] != 0)
        {
            refuse
            (
                this->coeffDict(), "U0", U0_,
                "without a component across the plane of the mesh"
            );
        }
    }

    // Clouds of function objects move when the directory has been written
    pastWrite::of(owner.mesh());

    const wordList models
    (
        owner.particleProperties().subDict("subModels")
            .subDict("injectionModels").toc()
    );
    nModels_ = max(1, models.size());
    modelIndex_ = max(0, models.find(modelName));
    models_ = " ";
    for (const word& model : models)
    {
        models_ += model + " ";
    }

    // The first point search builds data with communication between ranks
    (void)owner.mesh().tetBasePtIs();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

template<class CloudType>
Foam::label Foam::IdentifiedInjection<CloudType>::identity
(
    const int64_t k
) const
{
    const int64_t id = base_ + modelIndex_ + nModels_*(k - first_);
    if (id > labelMax)
    {
        FatalErrorInFunction
            << "Injection model " << this->modelName() << " of cloud "
            << this->owner().name() << " has used up the " << labelMax
            << " identities of this build's labels since startTime. Use a"
            << " build with 64-bit labels, a later startTime or more real"
            << " particles per parcel (nParticle)."
            << exit(FatalError);
    }
    return id;
}


template<class CloudType>
void Foam::IdentifiedInjection<CloudType>::setPositionAndCell
(
    const label parcelI,
    const label,
    const scalar,
    vector& position,
    label& cellOwner,
    label& tetFacei,
    label& tetPti
)
{
    position = parcels_[parcelI].position;
    cellOwner = parcels_[parcelI].cell;
}


template<class CloudType>
void Foam::IdentifiedInjection<CloudType>::setProperties
(
    const label parcelI,
    const label,
    const scalar,
    parcelType& parcel
)
{
    parcel.U() = U0_;
    parcel.d() = parcels_[parcelI].d;
    parcel.origProc() = 0;
    parcel.origId() = identity(parcels_[parcelI].number);
}
