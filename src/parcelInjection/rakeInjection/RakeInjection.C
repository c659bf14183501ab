/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "RakeInjection.H"
#include "checked.H"
#include "meshTools.H"
#include "StringStream.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

template<class CloudType>
Foam::point Foam::RakeInjection<CloudType>::position(const label i) const
{
    point p =
        nParcels_ > 1 ? start_ + i*(end_ - start_)/(nParcels_ - 1) : start_;
    meshTools::constrainToMeshCentre(this->owner().mesh(), p);
    return p;
}


// * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * * * //

template<class CloudType>
void Foam::RakeInjection<CloudType>::select
(
    const scalar t0,
    DynamicList<newParcel>& parcels
)
{
    const scalar rounding = 1e-6*this->owner().db().time().deltaTValue();
    if (released_ || t0 < this->SOI_ - rounding)
    {
        return;
    }
    released_ = true;
    for (label i = 0; i < nParcels_; ++i)
    {
        parcels.append(newParcel{position(i), d_, nParticle_, i, -1});
    }
}


template<class CloudType>
void Foam::RakeInjection<CloudType>::outside
(
    const DynamicList<newParcel>& all,
    label n
)
{
    if (n)
    {
        WarningInFunction
            << n << " of the " << all.size() << " parcels of "
            << this->modelName() << " lie outside the mesh and are left out"
            << endl;
    }
}


template<class CloudType>
void Foam::RakeInjection<CloudType>::store()
{
    this->template setModelProperty<label>("released", released_);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

template<class CloudType>
Foam::RakeInjection<CloudType>::RakeInjection
(
    const dictionary& dict,
    CloudType& owner,
    const word& modelName
)
:
    IdentifiedInjection<CloudType>
    (
        dict, owner, modelName, typeName, {"start", "end", "nParcels"}
    ),
    start_(getComponents(this->coeffDict(), "start", validRange::coordinate)),
    end_(getComponents(this->coeffDict(), "end", validRange::coordinate)),
    nParcels_
    (
        getNumber<label>(this->coeffDict(), "nParcels", "[1, 100000000]")
    ),
    d_(getNumber(this->coeffDict(), "diameter", validRange::diameter)),
    nParticle_
    (
        getNumber(this->coeffDict(), "nParticle", validRange::number)
    ),
    released_(this->template getModelProperty<label>("released"))
{
    this->checkDiameter(this->coeffDict(), "diameter", d_);
    for (const label i : {label(0), nParcels_ - 1})
    {
        const point p = position(i);
        if (!owner.mesh().bounds().contains(p))
        {
            refuse
            (
                this->coeffDict(), i == 0 ? "start" : "end", p,
                owner.mesh().bounds(), " (bounds of the mesh)"
            );
        }
    }

    OStringStream settings;
    settings
        << start_ << end_ << nParcels_ << ' ' << d_ << ' ' << nParticle_
        << ' ' << this->U0() << this->SOI_;
    const auto past = this->resumed(settings.str(), released_);
    const scalar now = owner.db().time().value();
    if (past == IdentifiedInjection<CloudType>::sequence::fresh)
    {
        released_ = false;
    }
    else if (past == IdentifiedInjection<CloudType>::sequence::changed)
    {
        const scalar rounding = 1e-6*owner.db().time().deltaTValue();
        released_ = this->SOI_ < now - rounding;
        Info<< "    " << modelName << ": released in a run before, with other"
            << " entries; "
            << (released_ ? "not released again (startTime has passed)"
                          : "released again at startTime") << endl;
    }
    this->setIdentities(past);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

template<class CloudType>
Foam::scalar Foam::RakeInjection<CloudType>::volumeToInject
(
    const scalar time0,
    const scalar time1
)
{
    return
        parcelsToInject(time0, time1)*nParticle_
       *CloudType::parcelType::volume(d_);
}


template<class CloudType>
Foam::scalar Foam::RakeInjection<CloudType>::averageParcelMass()
{
    return
        nParticle_*this->owner().constProps().rho0()
       *CloudType::parcelType::volume(d_);
}
