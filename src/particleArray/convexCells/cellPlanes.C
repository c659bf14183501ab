/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "cellPlanes.H"
#include "syncTools.H"

#include <map>

namespace
{
    // Behind a face of a tetrahedron until the one there is met
    const Foam::label unknown = Foam::labelMin;
}


// * * * * * * * * * * * * * * * * * Plane * * * * * * * * * * * * * * * * * //

Foam::cellPlanes::plane::plane
(
    vector n,
    const point& at,
    const label behind
)
:
    target(behind)
{
    // What is normal to an axis but for rounding is so to the last bit:
    // convexCells::buildBounds
    for (direction d = 0; d < 3; ++d)
    {
        vector axis(Zero);
        axis[d] = n[d] > 0 ? 1 : -1;
        if (mag(n - axis) < 1e-12)
        {
            n = axis;
        }
    }
    normal = n;
    distance = n & at;
}


Foam::cellPlanes::plane Foam::cellPlanes::plane::reversed
(
    const label behind
) const
{
    plane p(*this);
    p.normal = -normal;
    p.distance = -distance;
    p.target = behind;
    return p;
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::cellPlanes::number()
{
    const labelList& own = mesh_.faceOwner();
    firstTet_[0].setSize(mesh_.nFaces(), -1);
    firstTet_[1].setSize(mesh_.nFaces(), -1);
    firstCell.setSize(mesh_.nCells() + 1);
    DynamicList<label> numbers(mesh_.nCells());
    forAll(split_, celli)
    {
        firstCell[celli] = numbers.size();
        if (!split_[celli])
        {
            numbers.append(celli);
            continue;
        }
        ++nSplit;
        for (const label facei : mesh_.cells()[celli])
        {
            firstTet_[own[facei] != celli][facei] = numbers.size();
            for (label i = 2; i < mesh_.faces()[facei].size(); ++i)
            {
                numbers.append(celli);
            }
        }
    }
    firstCell.last() = numbers.size();
    meshCell.transfer(numbers);
}


void Foam::cellPlanes::findSplitBeyond()
{
    // Both sides of a coupled face take the same planes
    const label nInternal = mesh_.nInternalFaces();
    splitBeyond_.setSize(mesh_.nFaces() - nInternal, true);
    for (const polyPatch& patch : mesh_.boundaryMesh())
    {
        for (label i = 0; patch.coupled() && i < patch.size(); ++i)
        {
            splitBeyond_[patch.start() - nInternal + i] =
                split_[patch.faceCells()[i]];
        }
    }
    syncTools::swapBoundaryFaceList(mesh_, splitBeyond_);
}


Foam::labelList Foam::cellPlanes::cellsAt
(
    const label facei,
    const label side
) const
{
    const label celli =
        side ? mesh_.faceNeighbour()[facei] : mesh_.faceOwner()[facei];
    if (!split_[celli])
    {
        return labelList(1, firstCell[celli]);
    }
    labelList result(mesh_.faces()[facei].size() - 2);
    forAll(result, i)
    {
        result[i] = firstTet_[side][facei] + i;
    }
    return result;
}


void Foam::cellPlanes::addFace(const label facei)
{
    const pointField& points = mesh_.points();
    const label own = mesh_.faceOwner()[facei];
    const label boundaryi = facei - mesh_.nInternalFaces();
    const bool internal = boundaryi < 0;
    const bool isSplit[2] =
        {split_[own], internal && split_[mesh_.faceNeighbour()[facei]]};

    labelList behind[2];
    behind[0] = cellsAt(facei, 0);
    if (internal)
    {
        behind[1] = cellsAt(facei, 1);
    }
    else
    {
        boundaryCells[boundaryi] = behind[0];
    }

    // A whole cell before a split one: the choice is made on the spot
    label choice[2] = {-1, -1};
    for (label side = 0; side < 2; ++side)
    {
        if (internal && !isSplit[side] && isSplit[1 - side])
        {
            choice[side] = -1 - boundaryCells.size() - choices.size();
            choices.append(behind[1 - side]);
        }
    }

    const bool byTriangles =
        isSplit[0] && (internal ? isSplit[1] : splitBeyond_[boundaryi]);
    const label nPlanes =
        isSplit[0] || isSplit[1] ? mesh_.faces()[facei].size() - 2 : 1;
    for (label i = 0; i < nPlanes; ++i)
    {
        vector n = mesh_.faceAreas()[facei]/mag(mesh_.faceAreas()[facei]);
        point at = mesh_.faceCentres()[facei];
        if (byTriangles)
        {
            const triFace t = triangles_(facei, i);
            n = normalised
            (
                (points[t[1]] - points[t[0]]) ^ (points[t[2]] - points[t[0]])
            );
            at = points[t[0]];
        }

        const auto cellOf = [&](const label side)
        {
            return behind[side][isSplit[side] ? i : 0];
        };
        plane p(n, at, -1 - boundaryi);
        p.face = facei;
        if (isSplit[0] || i == 0)
        {
            if (internal)
            {
                p.target = choice[0] != -1 ? choice[0] : cellOf(1);
            }
            planes[cellOf(0)].append(p);
        }
        if (internal && (isSplit[1] || i == 0))
        {
            planes[cellOf(1)].append
            (
                p.reversed(choice[1] != -1 ? choice[1] : cellOf(0))
            );
        }
    }
}


Foam::vector Foam::cellPlanes::normalAt
(
    const label celli,
    const triFace& t,
    const label e
) const
{
    const pointField& points = mesh_.points();
    const point& centre = mesh_.cellCentres()[celli];

    // From the lower point to the higher one: the same in both tetrahedra
    const label a = min(t[e], t[(e + 1) % 3]);
    const label b = max(t[e], t[(e + 1) % 3]);
    const vector n =
        normalised((points[a] - centre) ^ (points[b] - centre));
    return ((points[t[(e + 2) % 3]] - centre) & n) > 0 ? vector(-n) : n;
}


bool Foam::cellPlanes::addTetrahedra(const label celli)
{
    const pointField& points = mesh_.points();
    const point& centre = mesh_.cellCentres()[celli];

    // Each plane stands on an edge
    std::map<std::pair<label, label>, label> waiting;
    bool filled = true;
    for (const label facei : mesh_.cells()[celli])
    {
        const label side = mesh_.faceOwner()[facei] != celli;
        for (label i = 0; i + 2 < mesh_.faces()[facei].size(); ++i)
        {
            const label tet = firstTet_[side][facei] + i;
            const triFace t = triangles_(facei, i);
            const vector n =
                (points[t[1]] - points[t[0]]) ^ (points[t[2]] - points[t[0]]);
            const scalar height =
                (side ? -1 : 1)*((points[t[0]] - centre) & n);
            filled = filled && height > 0;

            for (label e = 0; e < 3; ++e)
            {
                const std::pair<label, label> edge
                (
                    min(t[e], t[(e + 1) % 3]), max(t[e], t[(e + 1) % 3])
                );
                const vector m = normalAt(celli, t, e);
                const auto found = waiting.find(edge);
                if (found == waiting.end())
                {
                    waiting[edge] = tet;
                    planes[tet].append(plane(m, centre, unknown));
                    continue;
                }

                const label other = found->second;
                bool matched = false;
                for (plane& p : planes[other])
                {
                    if (p.target == unknown && mag(p.normal + m) < 1e-6)
                    {
                        p.target = tet;
                        planes[tet].append(p.reversed(other));
                        matched = true;
                        break;
                    }
                }
                filled = filled && matched;
                waiting.erase(found);
            }
        }
    }
    return filled;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::cellPlanes::cellPlanes
(
    const polyMesh& mesh,
    const faceTriangles& triangles,
    const boolList& split
)
:
    mesh_(mesh),
    triangles_(triangles),
    split_(split),
    boundaryCells(mesh.nFaces() - mesh.nInternalFaces())
{
    number();
    planes.setSize(meshCell.size());
    forAll(planes, celli)
    {
        planes[celli].setCapacity
        (
            split[meshCell[celli]] ? 4 : mesh.cells()[meshCell[celli]].size()
        );
    }
    findSplitBeyond();
    for (label facei = 0; facei < mesh.nFaces(); ++facei)
    {
        addFace(facei);
    }

    label nBad = 0, badCell = -1;
    forAll(split, celli)
    {
        if (split[celli] && !addTetrahedra(celli))
        {
            ++nBad;
            badCell = celli;
        }
    }
    if (returnReduce(nBad, sumOp<label>()))
    {
        FatalErrorInFunction
            << returnReduce(nBad, sumOp<label>())
            << " cells have no decomposition into tetrahedra about their"
            << " centre"
            << (badCell >= 0 ? ", one of them near " : "");
        if (badCell >= 0)
        {
            FatalError<< mesh.cellCentres()[badCell];
        }
        FatalError
            << ". Improve the mesh (checkMesh -allGeometry)."
            << exit(FatalError);
    }
}
