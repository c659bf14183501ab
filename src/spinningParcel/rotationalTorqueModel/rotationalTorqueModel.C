/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "rotationalTorqueModel.H"
#include "checked.H"
#include "addToRunTimeSelectionTable.H"
#include "rotationalTorque.H"

namespace Foam
{

defineTypeNameAndDebug(rotationalTorqueModel, 0);
defineRunTimeSelectionTable(rotationalTorqueModel, dictionary);

namespace rotationalTorqueModels
{

//- Parcels keep their spin
class none
:
    public rotationalTorqueModel
{
public:

    //- Runtime type information
    TypeName("none");

    explicit none(const dictionary&)
    {}

    virtual bool active() const
    {
        return false;
    }

    virtual scalar rate
    (
        const scalar,
        const scalar,
        const scalar,
        const scalar,
        const scalar
    ) const
    {
        return 0;
    }

    virtual scalar remaining
    (
        const scalar,
        const scalar,
        const scalar,
        const scalar,
        const scalar,
        const scalar
    ) const
    {
        return 1;
    }
};


//- impact::rotationalTorque
class standardTorque
:
    public rotationalTorqueModel
{
    typedef impact::rotationalTorque law;

public:

    //- Runtime type information
    TypeName("rotationalTorque");

    explicit standardTorque(const dictionary&)
    {}

    virtual bool standard() const
    {
        return true;
    }

    virtual scalar rate
    (
        const scalar d,
        const scalar rhoP,
        const scalar rho,
        const scalar mu,
        const scalar W
    ) const
    {
        return law::scale(d, rhoP, mu)*law::clRe(law::ReOmega(d, rho, mu, W));
    }

    virtual scalar remaining
    (
        const scalar d,
        const scalar rhoP,
        const scalar rho,
        const scalar mu,
        const scalar W,
        const scalar dt
    ) const
    {
        return law::remaining
        (
            law::ReOmega(d, rho, mu, W),
            dt*law::scale(d, rhoP, mu)
        );
    }

    virtual bool outside
    (
        const scalar d,
        const scalar rho,
        const scalar mu,
        const scalar W
    ) const
    {
        return !law::inRange(law::ReOmega(d, rho, mu, W));
    }
};

defineTypeNameAndDebug(none, 0);
addToRunTimeSelectionTable(rotationalTorqueModel, none, dictionary);

defineTypeNameAndDebug(standardTorque, 0);
addToRunTimeSelectionTable(rotationalTorqueModel, standardTorque, dictionary);

} // End namespace rotationalTorqueModels
} // End namespace Foam


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::autoPtr<Foam::rotationalTorqueModel> Foam::rotationalTorqueModel::New
(
    const dictionary& dict
)
{
    const word type
    (
        getWordOf
        (
            dict,
            "rotationalTorqueModel",
            rotationalTorqueModels::standardTorque::typeName,
            dictionaryConstructorTablePtr_->sortedToc()
        )
    );
    auto constructor = dictionaryConstructorTablePtr_->cfind(type);
    Info<< "Selecting rotational torque model " << type << endl;
    return constructor()(dict);
}
