/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "gasMesh.H"
#include "bandCompression.H"
#include <algorithm>
#include <numeric>

Foam::labelList Foam::gasMesh::compressedOrder() const
{
    labelListList neighbours(nCells_);
    for (label c = 0; c < nCells_; c++)
    {
        for (int i = cellStart[c]; i < cellStart[c + 1]; i++)
        {
            if (neighbour[i] < nCells_)
            {
                neighbours[c].append(neighbour[i]);
            }
        }
    }
    return bandCompression(neighbours);
}


void Foam::gasMesh::setOrder()
{
    // Many times the distance in a compressed order: as random numbers have,
    // and grids of a few blocks have not
    const double manifold = 4;

    order.resize(nCells_);
    std::iota(order.begin(), order.end(), 0);

    const auto distance = [&](const std::vector<int>& place)
    {
        double sum = 0;
        for (label f = 0; f < nInternal_; f++)
        {
            sum += std::abs(place[owner[f]] - place[far[f]]);
        }
        return sum;
    };

    const labelList compressed(compressedOrder());
    std::vector<int> place(nCells_);
    forAll(compressed, r)
    {
        place[compressed[r]] = r;
    }
    if (distance(order) > manifold*distance(place))
    {
        std::copy(compressed.begin(), compressed.end(), order.begin());
    }
}
