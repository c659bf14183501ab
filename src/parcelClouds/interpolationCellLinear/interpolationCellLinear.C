/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "interpolationCellLinear.H"
#include "gradScheme.H"
#include "IStringStream.H"

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

template<class Type>
Foam::tmp<typename Foam::interpolationCellLinear<Type>::volGradType>
Foam::interpolationCellLinear<Type>::gradient(const volFieldType& psi)
{
    const word name("cellLinear(" + psi.name() + ')');
    const auto computed = [&]()
    {
        IStringStream scheme
        (
            pTraits<Type>::nComponents == 1
          ? "cellLimited leastSquares 1"
          : "leastSquares"
        );
        // Not by the name of the one that is kept, which would be deleted
        return fv::gradScheme<Type>::New(psi.mesh(), scheme)().grad
        (
            psi,
            "new:" + name
        );
    };

    // A field that comes and goes may have a namesake
    const objectRegistry& db = psi.db();
    if (db.findObject<volFieldType>(psi.name()) != &psi)
    {
        return computed();
    }
    if (!db.foundObject<volGradType>(name))
    {
        volGradType* first = computed().ptr();
        first->rename(name);
        first->checkIn();
        regIOobject::store(first);
        first->setUpToDate();
    }
    volGradType& kept = db.lookupObjectRef<volGradType>(name);
    if (!kept.upToDate(psi) || psi.mesh().changing())
    {
        kept = computed();
        kept.setUpToDate();
    }
    return tmp<volGradType>(kept);
}


// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    #define makeCellLinear(Type)                                              \
        defineNamedTemplateTypeNameAndDebug                                   \
        (                                                                     \
            interpolationCellLinear<Type>,                                    \
            0                                                                 \
        );                                                                    \
        interpolation<Type>::adddictionaryConstructorToTable                  \
            <interpolationCellLinear<Type>>                                   \
            add##Type##CellLinear_;

    makeCellLinear(scalar)
    makeCellLinear(vector)
}
