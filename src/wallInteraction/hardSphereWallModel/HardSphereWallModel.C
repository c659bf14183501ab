/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "HardSphereWallModel.H"

template<class CloudType>
Foam::HardSphereWallModel<CloudType>::HardSphereWallModel
(
    const dictionary& dict,
    CloudType& owner
)
:
    SphereRebound<CloudType, impact::hardSphereWall>
    (
        dict,
        owner,
        typeName,
        reboundEntries::hardSphere,
        {"sliding impacts", "outside of coefficients"}
    )
{}


template<class CloudType>
bool Foam::HardSphereWallModel<CloudType>::correct
(
    parcelType& p,
    const polyPatch& pp,
    bool& keepParticle
)
{
    return this->rebound
    (
        p, pp, keepParticle,
        [&](const auto& outcome)
        {
            this->special(pp, 0) += outcome.slides;
            this->special(pp, 1) += outcome.outside;
        }
    );
}
