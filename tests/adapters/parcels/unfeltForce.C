/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.

Description
    A particle force that is nowhere to be felt, but not one of the core: with
    it the cloud calls the stock forces of its list.
\*---------------------------------------------------------------------------*/

#include "basicSpinningCloud.H"
#include "ParticleForce.H"

namespace Foam
{

template<class CloudType>
class UnfeltForce
:
    public ParticleForce<CloudType>
{
public:

    TypeName("unfelt");

    UnfeltForce(CloudType& owner, const fvMesh& mesh, const dictionary& dict)
    :
        ParticleForce<CloudType>(owner, mesh, dict, typeName, false)
    {}

    virtual autoPtr<ParticleForce<CloudType>> clone() const
    {
        return autoPtr<ParticleForce<CloudType>>(new UnfeltForce(*this));
    }
};

// (As makeParticleForceModelType has it, whose names other sources use, too)
typedef UnfeltForce<basicSpinningCloud::kinematicCloudType> spinningUnfelt;

defineNamedTemplateTypeNameAndDebug(spinningUnfelt, 0);

ParticleForce<basicSpinningCloud::kinematicCloudType>::
    adddictionaryConstructorToTable<spinningUnfelt> addSpinningUnfelt_;

} // End namespace Foam
