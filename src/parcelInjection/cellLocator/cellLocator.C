/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "cellLocator.H"
#include "wedgePolyPatch.H"

#include <algorithm>

namespace Foam
{
    defineTypeNameAndDebug(cellLocator, 0);
}

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::cellLocator::divide
(
    const List<boundBox>& boxes,
    const label begin,
    const label end
)
{
    const label nodei = nodes_.size();
    boundBox box;
    for (label i = begin; i < end; ++i)
    {
        box.add(boxes[cells_[i]]);
    }
    nodes_.append(node{box, begin, end, -1});

    if (end - begin <= 2)
    {
        return;
    }

    const vector span = box.span();
    const direction along =
        span.x() >= span.y() && span.x() >= span.z()
      ? 0
      : span.y() >= span.z() ? 1 : 2;
    const label middle = (begin + end)/2;
    std::nth_element
    (
        cells_.begin() + begin,
        cells_.begin() + middle,
        cells_.begin() + end,
        [&boxes, along](const label a, const label b)
        {
            return
                boxes[a].min()[along] + boxes[a].max()[along]
              < boxes[b].min()[along] + boxes[b].max()[along];
        }
    );
    divide(boxes, begin, middle);
    nodes_[nodei].second = nodes_.size();
    divide(boxes, middle, end);
}


Foam::label Foam::cellLocator::find(const point& p, const label nodei) const
{
    const node& n = nodes_[nodei];
    if (!n.box.contains(p))
    {
        return -1;
    }
    if (n.second != -1)
    {
        const label cell = find(p, nodei + 1);
        return cell != -1 ? cell : find(p, n.second);
    }
    for (label i = n.begin; i < n.end; ++i)
    {
        if
        (
            boxes_[i].contains(p)
         && mesh().pointInCell(p, cells_[i], polyMesh::CELL_TETS)
        )
        {
            return cells_[i];
        }
    }
    return -1;
}


void Foam::cellLocator::near
(
    const point& p,
    const label nodei,
    label& celli
) const
{
    const auto holds = [&p](boundBox box)
    {
        box.inflate(1e-8);
        return box.contains(p);
    };
    const node& n = nodes_[nodei];
    if (!holds(n.box))
    {
        return;
    }
    if (n.second != -1)
    {
        near(p, nodei + 1, celli);
        near(p, n.second, celli);
        return;
    }
    const auto distance = [&](const label i)
    {
        return magSqr(mesh().cellCentres()[i] - p);
    };
    for (label i = n.begin; i < n.end; ++i)
    {
        const label other = cells_[i];
        if
        (
            holds(boxes_[i])
         && (celli < 0 || distance(other) < distance(celli))
        )
        {
            celli = other;
        }
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::cellLocator::cellLocator(const polyMesh& mesh)
:
    MeshObject<polyMesh, GeometricMeshObject, cellLocator>(mesh),
    cells_(identity(mesh.nCells())),
    nodes_(mesh.nCells())
{
    if (cells_.empty())
    {
        return;
    }

    // The tetrahedra have the cell centre as a vertex, which may lie outside
    // the faces of a badly shaped cell
    List<boundBox> boxes(mesh.nCells());
    const faceList& faces = mesh.faces();
    const pointField& points = mesh.points();
    forAll(boxes, celli)
    {
        boxes[celli].add(mesh.cellCentres()[celli]);
        for (const label facei : mesh.cells()[celli])
        {
            for (const label pointi : faces[facei])
            {
                boxes[celli].add(points[pointi]);
            }
        }

        // For points on the boundary that rounding has put outside
        boxes[celli].inflate(1e-10);
    }

    divide(boxes, 0, cells_.size());

    boxes_.setSize(cells_.size());
    forAll(cells_, i)
    {
        boxes_[i] = boxes[cells_[i]];
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::label Foam::cellLocator::find(const point& p) const
{
    return nodes_.empty() ? -1 : find(p, 0);
}


Foam::label Foam::cellLocator::near(const point& p) const
{
    label celli = -1;
    if (!nodes_.empty())
    {
        near(p, 0, celli);
    }
    return celli;
}


Foam::point Foam::cellLocator::offAxis(const point& p, const label celli) const
{
    const scalar reach = 1e-9*std::cbrt(mesh_.cellVolumes()[celli]);
    label nPlanes = 0;
    for (const label facei : mesh_.cells()[celli])
    {
        const label patchi = mesh_.boundaryMesh().whichPatch(facei);
        if (patchi >= 0 && isA<wedgePolyPatch>(mesh_.boundaryMesh()[patchi]))
        {
            const vector n = normalised(mesh_.faceAreas()[facei]);
            nPlanes += mag(n & (p - mesh_.faceCentres()[facei])) < reach;
        }
    }
    return nPlanes < 2 ? p : p + 1e-9*(mesh_.cellCentres()[celli] - p);
}
