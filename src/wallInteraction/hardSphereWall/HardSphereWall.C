/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "HardSphereWall.H"

template<class CloudType>
Foam::HardSphereWall<CloudType>::HardSphereWall
(
    const dictionary& dict,
    CloudType& owner
)
:
    ParcelWallModel<CloudType>(dict, owner, typeName, {"sliding impacts"}),
    laws_(),
    lawOf_(this->patches().size(), -1)
{
    forAll(lawOf_, i)
    {
        if (this->fate(i) == ParcelWallModel<CloudType>::fateType::rebound)
        {
            lawOf_[i] = label(laws_.size());
            laws_.push_back(reboundEntries::hardSphere(this->patches()[i]));
        }
    }
}


template<class CloudType>
bool Foam::HardSphereWall<CloudType>::correct
(
    parcelType& p,
    const polyPatch& pp,
    bool& keepParticle
)
{
    wallHit hit;
    if (!this->arrive(p, pp, keepParticle, hit))
    {
        return hit.handled;
    }

    impact::sphereState s = {hit.V0, toCore(hit.omega0)};
    hit.rotation0 = impact::sphereRotationalEnergy(hit.radius, s.omega);
    const bool slides =
        laws_[lawOf_[hit.setting]].rebound(hit.n, hit.radius, s);
    hit.V1 = s.V;
    hit.omega1 = s.omega;
    hit.rotation1 = impact::sphereRotationalEnergy(hit.radius, s.omega);
    this->special(pp, 0) += slides;
    this->leave(p, pp, hit);
    return true;
}
