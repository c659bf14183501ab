/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "SemiEmpiricalWallModel.H"

template<class CloudType>
Foam::SemiEmpiricalWallModel<CloudType>::SemiEmpiricalWallModel
(
    const dictionary& dict,
    CloudType& owner
)
:
    SphereRebound<CloudType, impact::semiEmpiricalRebound>
    (
        dict,
        owner,
        typeName,
        reboundEntries::semiEmpirical,
        {"rolling impacts", "outside of coefficients", "energy-gaining"}
    )
{}


template<class CloudType>
bool Foam::SemiEmpiricalWallModel<CloudType>::correct
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
            this->special(pp, 0) += outcome.rolls;
            this->special(pp, 1) += outcome.outside;
            this->special(pp, 2) += outcome.gains;
        }
    );
}
