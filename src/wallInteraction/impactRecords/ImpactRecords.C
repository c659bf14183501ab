/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "ImpactRecords.H"
#include "IFstream.H"
#include "ListListOps.H"
#include "OSspecific.H"
#include "Pstream.H"
#include "Time.H"
#include "functionObject.H"
#include "stringOps.H"
#include "wordRes.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

template<class CloudType>
Foam::fileName Foam::ImpactRecords<CloudType>::folder() const
{
    return
        this->owner().time().globalPath()/functionObject::outputPrefix
       /this->modelName()/this->owner().name();
}


template<class CloudType>
void Foam::ImpactRecords<CloudType>::readEarlier()
{
    const Time& time = this->owner().time();
    const scalar rounding = 1e-6*time.deltaTValue();

    for (const fileName& part : readDir(folder(), fileName::DIRECTORY))
    {
        IFstream file(folder()/part/"impacts.csv");
        string line;
        file.getLine(line);
        while (file.good())
        {
            file.getLine(line);
            const auto words = stringOps::split(line, ',');
            if (words.size() < 4)
            {
                continue;
            }
            if (readScalar(words[3].str()) <= time.value() + rounding)
            {
                known_.insert
                (
                    {readLabel(words[1].str()), readLabel(words[2].str())}
                );
            }
        }
    }
}


template<class CloudType>
void Foam::ImpactRecords<CloudType>::write()
{
    List<List<record>> all(Pstream::nProcs());
    all[Pstream::myProcNo()] = records_;
    records_.clear();
    Pstream::gatherList(all);

    if (!Pstream::master() || !file_.valid())
    {
        return;
    }

    List<record> records
    (
        ListListOps::combine<List<record>>(all, accessOp<List<record>>())
    );
    Foam::sort
    (
        records,
        [](const record& a, const record& b)
        {
            return
                a.step != b.step ? a.step < b.step
              : a.origProc != b.origProc ? a.origProc < b.origProc
              : a.origId != b.origId ? a.origId < b.origId
              : a.time < b.time;
        }
    );

    OFstream& os = file_();
    for (const record& r : records)
    {
        const bool first = known_.insert({r.origProc, r.origId}).second;
        os  << r.step << ',' << r.origProc << ',' << r.origId << ','
            << r.time << ','
            << r.position.x() << ',' << r.position.y() << ','
            << r.position.z() << ','
            << r.U.x() << ',' << r.U.y() << ',' << r.U.z() << ','
            << r.d << ',' << r.nParticle << ','
            << patchNames_[r.patch].c_str() << ',' << label(first) << '\n';
    }
    os.flush();
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

template<class CloudType>
Foam::ImpactRecords<CloudType>::ImpactRecords
(
    const dictionary& dict,
    CloudType& owner,
    const word& modelName
)
:
    CloudFunctionObject<CloudType>(dict, owner, modelName, typeName),
    recorded_(owner.mesh().boundaryMesh().size(), false),
    patchNames_(owner.mesh().boundaryMesh().names()),
    records_(),
    known_(),
    file_(nullptr)
{
    const wordRes names(this->coeffDict().template get<wordRes>("patches"));

    // Processor patches are no walls and differ from rank to rank
    const label nPatches = owner.mesh().boundaryMesh().nNonProcessor();
    for (const wordRe& name : names)
    {
        bool found = false;
        for (label patchi = 0; patchi < nPatches; ++patchi)
        {
            if (name.match(patchNames_[patchi]))
            {
                recorded_[patchi] = true;
                found = true;
            }
        }
        if (!found)
        {
            FatalIOErrorInFunction(this->coeffDict())
                << modelName << ": entry 'patches', value " << name
                << ", is outside the valid range of patches "
                << SubList<word>(patchNames_, nPatches)
                << exit(FatalIOError);
        }
    }
    if (names.empty())
    {
        FatalIOErrorInFunction(this->coeffDict())
            << modelName << ": entry 'patches', value (), needs at least one"
            << " of the patches " << SubList<word>(patchNames_, nPatches)
            << exit(FatalIOError);
    }

    if (Pstream::master())
    {
        readEarlier();

        const fileName part(folder()/owner.time().timeName());
        mkDir(part);
        file_.reset(new OFstream(part/"impacts.csv"));
        file_->precision(17);
        file_()
            << "step,origProc,origId,time,x,y,z,Ux,Uy,Uz,d,nParticle,patch,"
            << "firstImpact" << endl;
    }
}


template<class CloudType>
Foam::ImpactRecords<CloudType>::ImpactRecords
(
    const ImpactRecords<CloudType>& other
)
:
    CloudFunctionObject<CloudType>(other),
    recorded_(other.recorded_),
    patchNames_(other.patchNames_),
    records_(),
    known_(other.known_),
    file_(nullptr)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

template<class CloudType>
void Foam::ImpactRecords<CloudType>::postEvolve
(
    FOAM_COMPAT_EVOLVE_ARGS(parcelType)
)
{
    const Time& time = this->owner().time();
    const bool last =
        time.value() > time.endTime().value() - 0.5*time.deltaTValue();
    if (time.writeTime() || last)
    {
        write();
    }
}


template<class CloudType>
FOAM_COMPAT_TRACK_RESULT Foam::ImpactRecords<CloudType>::postPatch
(
    const parcelType& p,
    const polyPatch& pp,
    FOAM_COMPAT_TRACK_ARGS(parcelType)
)
{
    if (recorded_[pp.index()])
    {
        const Time& time = this->owner().time();
        records_.append
        (
            record
            {
                time.timeIndex(),
                p.origProc(),
                p.origId(),
                pp.index(),
                time.value()
              - (1 - p.currentTimeFraction())*time.deltaTValue(),
                p.position(),
                p.U(),
                p.d(),
                p.nParticle()
            }
        );
    }

    FOAM_COMPAT_TRACK_KEEP;
}
