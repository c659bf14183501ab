/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "trackingCells.H"
#include "cellGas.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    defineTypeNameAndDebug(trackingCells, 0);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

const Foam::convexCells& Foam::trackingCells::whole(const polyMesh& mesh)
{
    const trackingCells& cells = New(mesh);
    if (!cells.whole_.valid())
    {
        const boolList others(cellGas::cellsToSplit(mesh));
        const bool any = returnReduce(others.found(true), orOp<bool>());
        cells.whole_.reset
        (
            new convexCells(mesh, any ? others : boolList())
        );
    }
    return *cells.whole_;
}


const Foam::convexCells& Foam::trackingCells::tetrahedra(const polyMesh& mesh)
{
    const trackingCells& cells = New(mesh);
    if (!cells.split_.valid())
    {
        cells.split_.reset
        (
            new convexCells(mesh, boolList(mesh.nCells(), true))
        );
    }
    return *cells.split_;
}
