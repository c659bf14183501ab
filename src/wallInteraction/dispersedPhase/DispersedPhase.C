/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "DispersedPhase.H"
#include "stockCloudEntries.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

template<class CloudType>
Foam::DispersedPhase<CloudType>::DispersedPhase
(
    const dictionary& dict,
    CloudType& owner,
    const word& modelName
)
:
    CloudFunctionObject<CloudType>(dict, owner, modelName, typeName)
{
    stockCloudEntries::refuseSteady(owner, typeName);
    refuseOthers(this->coeffDict(), {"type", "window", "interval", "restart"});
    fields_.reset
    (
        new dispersedPhaseFields
        (
            this->coeffDict(),
            owner.name(),
            modelName,
            owner.mesh(),
            parcelSpin::carried<parcelType>()
        )
    );
}


template<class CloudType>
Foam::DispersedPhase<CloudType>::DispersedPhase
(
    const DispersedPhase<CloudType>& other
)
:
    CloudFunctionObject<CloudType>(other)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

template<class CloudType>
void Foam::DispersedPhase<CloudType>::postEvolve
(
    FOAM_COMPAT_EVOLVE_ARGS(parcelType)
)
{
    if (!fields_)
    {
        return;
    }
    if (fields_->begin())
    {
        const CloudType& cloud = this->owner();
        for (const parcelType& p : cloud)
        {
            if (p.active())
            {
                fields_->add
                (
                    p.cell(),
                    p.nParticle(),
                    p.volume(),
                    p.U(),
                    parcelSpin::get(p)
                );
            }
        }
    }
    fields_->end();
}
