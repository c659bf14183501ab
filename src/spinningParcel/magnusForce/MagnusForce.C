/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "MagnusForce.H"
#include "magnusLift.H"
#include "rotationalTorque.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

template<class CloudType>
Foam::MagnusForce<CloudType>::MagnusForce
(
    CloudType& owner,
    const fvMesh& mesh,
    const dictionary& dict
)
:
    ParticleForce<CloudType>
    (
        owner,
        mesh,
        dict,
        typeName,
        dict.dictName() == typeName
    )
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

template<class CloudType>
Foam::forceSuSp Foam::MagnusForce<CloudType>::calcCoupled
(
    const typename CloudType::parcelType& p,
    const typename CloudType::parcelType::trackingData& td,
    const scalar dt,
    const scalar mass,
    const scalar Re,
    const scalar muc
) const
{
    forceSuSp force(Zero);
    if (!td.rotation)
    {
        return force;
    }

    const vector W = td.halfCurl - p.omega();
    const scalar ReOmega =
        impact::rotationalTorque::ReOmega(p.d(), td.rhoc(), muc, mag(W));
    force.Su() =
        mass*impact::magnusLift::rotation(td.rhoc()/p.rho(), Re, ReOmega)
       *(W ^ (td.Uc() - p.U()));

    ++td.counts.magnus;
    td.counts.magnusOutside += !impact::magnusLift::inRange(Re);
    return force;
}
