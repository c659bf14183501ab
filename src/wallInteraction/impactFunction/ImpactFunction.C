/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "ImpactFunction.H"
#include "checked.H"
#include "impactMeasures.H"
#include "impactPatches.H"
#include "impactTime.H"
#include "parcelHeat.H"
#include "stockCloudEntries.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

template<class CloudType, class Recorder>
void Foam::ImpactFunction<CloudType, Recorder>::hear(const wallImpact& impact)
{
    if (patches_[impact.patch])
    {
        recorder_->take(impact, true, true);
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

template<class CloudType, class Recorder>
Foam::ImpactFunction<CloudType, Recorder>::ImpactFunction
(
    const dictionary& dict,
    CloudType& owner,
    const word& modelName
)
:
    CloudFunctionObject<CloudType>(dict, owner, modelName, typeName),
    patches_(impactPatches::read(this->coeffDict(), modelName, owner.mesh()))
{
    stockCloudEntries::refuseSteady(owner, typeName);
    refuseOthers(this->coeffDict(), Recorder::entries());
    recorder_.reset
    (
        new Recorder
        (
            this->coeffDict(),
            owner.name(),
            modelName,
            owner.mesh(),
            patches_
        )
    );
}


template<class CloudType, class Recorder>
Foam::ImpactFunction<CloudType, Recorder>::ImpactFunction
(
    const ImpactFunction<CloudType, Recorder>& other
)
:
    CloudFunctionObject<CloudType>(other),
    patches_(other.patches_)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

template<class CloudType, class Recorder>
void Foam::ImpactFunction<CloudType, Recorder>::preEvolve
(
    FOAM_COMPAT_EVOLVE_ARGS(parcelType)
)
{
    if (recorder_)
    {
        published_ = &wallImpacts::New(this->owner());
        recorder_->begin(parcelHeat::carried<parcelType>(*published_));
        published_->add(*this);
    }
}


template<class CloudType, class Recorder>
void Foam::ImpactFunction<CloudType, Recorder>::postEvolve
(
    FOAM_COMPAT_EVOLVE_ARGS(parcelType)
)
{
    if (recorder_)
    {
        published_->remove(*this);
        published_ = nullptr;
        recorder_->end();
    }
}


template<class CloudType, class Recorder>
FOAM_COMPAT_TRACK_RESULT
Foam::ImpactFunction<CloudType, Recorder>::postPatch
(
    const parcelType& p,
    const polyPatch& pp,
    FOAM_COMPAT_TRACK_ARGS(parcelType)
)
{
    const label patchi = pp.index();
    if (published_ && patches_[patchi] && !published_->published(patchi))
    {
        vector nw;
        vector Uw;
        this->owner().patchData(p, pp, nw, Uw);

        wallImpact i;
        i.patch = patchi;
        i.face = pp.whichFace(p.face());
        i.origProc = p.origProc();
        i.origId = p.origId();
        i.time = impactTime(p);
        i.position = p.position();
        i.n = -nw;
        i.Uw = Uw;
        i.U0 = p.U();
        i.U1 = Zero;
        i.omega0 = parcelSpin::get(p);
        i.omega1 = Zero;
        i.d = p.d();
        i.mass = p.mass();
        i.rotationalEnergy0 = impact::impactMeasures::rotationalEnergy
        (
            i.mass,
            i.d,
            {i.omega0.x(), i.omega0.y(), i.omega0.z()}
        );
        i.rotationalEnergy1 = 0;
        i.nParticle = p.nParticle();
        i.captured = false;
        parcelHeat::set(i, p, *published_);
        recorder_->take(i, parcelSpin::carried<parcelType>(), false);
    }

    FOAM_COMPAT_TRACK_KEEP;
}
