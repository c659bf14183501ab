/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "wallGasInterpolation.H"
#include "interpolationCell.H"
#include "interpolationCellLinear.H"
#include "interpolationCellPatchConstrained.H"
#include "interpolationCellPoint.H"
#include "interpolationCellPointFace.H"
#include "interpolationCellPointWallModified.H"
#include "interpolationPointMVC.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    #define makeWallGasScheme(Scheme, ofPoints, linear)                       \
        template<>                                                            \
        const wallGasScheme wallGasInterpolation<Scheme<vector>>::nature      \
            {ofPoints, linear};

    makeWallGasScheme(interpolationCell, false, true)
    makeWallGasScheme(interpolationCellLinear, false, true)
    makeWallGasScheme(interpolationCellPatchConstrained, false, true)
    makeWallGasScheme(interpolationCellPoint, true, true)
    makeWallGasScheme(interpolationCellPointWallModified, true, true)
    makeWallGasScheme(interpolationCellPointFace, true, false)
    makeWallGasScheme(interpolationPointMVC, true, false)
}


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

namespace Foam
{
    template<class Scheme>
    static void select()
    {
        interpolation<vector>::dictionaryConstructorTablePtr_->set
        (
            Scheme::typeName,
            &wallGasInterpolation<Scheme>::New
        );
    }
}


void Foam::selectWallGasInterpolation()
{
    select<interpolationCell<vector>>();
    select<interpolationCellLinear<vector>>();
    select<interpolationCellPatchConstrained<vector>>();
    select<interpolationCellPoint<vector>>();
    select<interpolationCellPointFace<vector>>();
    select<interpolationCellPointWallModified<vector>>();
    select<interpolationPointMVC<vector>>();
}
