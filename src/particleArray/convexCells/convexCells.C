/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "convexCells.H"
#include "cyclicAMIPolyPatch.H"
#include "cyclicPolyPatch.H"
#include "emptyPolyPatch.H"
#include "processorCyclicPolyPatch.H"
#include "processorPolyPatch.H"
#include "symmetryPlanePolyPatch.H"
#include "symmetryPolyPatch.H"
#include "syncTools.H"
#include "wallPolyPatch.H"
#include "wedgePolyPatch.H"

#include <algorithm>
#include <map>

namespace
{
    using Foam::label;
    using Foam::scalar;
    using Foam::vector;

    // Behind a face of a tetrahedron until the one there is met
    const label unknown = Foam::labelMin;

    struct facePlane
    {
        vector normal;
        scalar distance;
        label target;

        //- Of the mesh; -1 between tetrahedra of a cell
        label face;
    };

    facePlane planeThrough(vector n, const vector& at, const label target)
    {
        // What is normal to an axis but for rounding is so to the last bit:
        // buildBounds
        for (Foam::direction d = 0; d < 3; ++d)
        {
            if (Foam::mag(Foam::mag(n[d]) - 1) < 1e-12)
            {
                const scalar sign = n[d] > 0 ? 1 : -1;
                vector axis(Foam::Zero);
                axis[d] = sign;
                if (Foam::mag(n - axis) < 1e-12)
                {
                    n = axis;
                }
            }
        }
        return facePlane{n, n & at, target, -1};
    }

    facePlane reversed(const facePlane& p, const label target)
    {
        return facePlane{-p.normal, -p.distance, target, p.face};
    }
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::convexCells::buildCells(const boolList& split)
{
    const pointField& points = mesh_.points();
    const vectorField& cellCentres = mesh_.cellCentres();
    const vectorField& areas = mesh_.faceAreas();
    const labelList& own = mesh_.faceOwner();
    const labelList& nei = mesh_.faceNeighbour();
    const label nInternal = mesh_.nInternalFaces();
    const label nBoundary = mesh_.nFaces() - nInternal;

    // Numbering. firstTet[side][face]: tetrahedron of its first triangle
    labelList firstTet[2];
    firstTet[0].setSize(mesh_.nFaces(), -1);
    firstTet[1].setSize(mesh_.nFaces(), -1);
    firstCell_.setSize(mesh_.nCells() + 1);
    DynamicList<label> meshCell(mesh_.nCells());
    nSplit_ = 0;
    forAll(split, celli)
    {
        firstCell_[celli] = meshCell.size();
        if (!split[celli])
        {
            meshCell.append(celli);
            continue;
        }
        ++nSplit_;
        for (const label facei : mesh_.cells()[celli])
        {
            firstTet[own[facei] != celli][facei] = meshCell.size();
            for (label i = 2; i < mesh_.faces()[facei].size(); ++i)
            {
                meshCell.append(celli);
            }
        }
    }
    firstCell_.last() = meshCell.size();
    meshCell_.transfer(meshCell);

    const auto triangle = [&](const label facei, const label i)
    {
        const face& f = mesh_.faces()[facei];
        const label base = max(mesh_.tetBasePtIs()[facei], label(0));
        return triFace
        (
            f[base],
            f[(base + i + 1) % f.size()],
            f[(base + i + 2) % f.size()]
        );
    };

    List<DynamicList<facePlane>> cells(meshCell_.size());
    forAll(cells, celli)
    {
        const label meshCelli = meshCell_[celli];
        cells[celli].setCapacity
        (
            split[meshCelli] ? 4 : mesh_.cells()[meshCelli].size()
        );
    }
    boundaryCells_.setSize(nBoundary);
    DynamicList<labelList> choices;

    // Both sides of a coupled face take the same planes
    boolList splitBeyond(nBoundary, true);
    for (const polyPatch& patch : mesh_.boundaryMesh())
    {
        for (label i = 0; patch.coupled() && i < patch.size(); ++i)
        {
            splitBeyond[patch.start() - nInternal + i] =
                split[patch.faceCells()[i]];
        }
    }
    syncTools::swapBoundaryFaceList(mesh_, splitBeyond);

    // Faces of the mesh, seen from the owner
    forAll(areas, facei)
    {
        const bool internal = facei < nInternal;
        const label nTriangles = mesh_.faces()[facei].size() - 2;
        const label sideCell[2] =
            {own[facei], internal ? nei[facei] : -1};
        const bool isSplit[2] =
            {split[own[facei]], internal && split[nei[facei]]};

        labelList behind[2];
        for (label side = 0; side < (internal ? 2 : 1); ++side)
        {
            behind[side].setSize(isSplit[side] ? nTriangles : 1);
            forAll(behind[side], i)
            {
                behind[side][i] = isSplit[side]
                  ? firstTet[side][facei] + i
                  : firstCell_[sideCell[side]];
            }
        }
        if (!internal)
        {
            boundaryCells_[facei - nInternal] = behind[0];
        }

        const vector whole = areas[facei]/mag(areas[facei]);
        const bool byTriangles =
            isSplit[0]
         && (internal ? isSplit[1] : splitBeyond[facei - nInternal]);

        // A whole cell before a split one: the choice is made on the spot
        label choice[2] = {-1, -1};
        for (label side = 0; side < 2; ++side)
        {
            if (internal && !isSplit[side] && isSplit[1 - side])
            {
                choice[side] = -1 - nBoundary - choices.size();
                choices.append(behind[1 - side]);
            }
        }

        const label nPlanes =
            isSplit[0] || isSplit[1] ? nTriangles : label(1);
        for (label i = 0; i < nPlanes; ++i)
        {
            vector n = whole;
            vector at = mesh_.faceCentres()[facei];
            if (byTriangles)
            {
                const triFace t = triangle(facei, i);
                n = normalised
                (
                    (points[t[1]] - points[t[0]])
                  ^ (points[t[2]] - points[t[0]])
                );
                at = points[t[0]];
            }

            const auto cellOf = [&](const label side)
            {
                return behind[side][isSplit[side] ? i : 0];
            };
            facePlane p = planeThrough(n, at, -1);
            p.face = facei;
            if (isSplit[0] || i == 0)
            {
                cells[cellOf(0)].append(p);
                cells[cellOf(0)].last().target =
                    !internal ? -1 - (facei - nInternal)
                  : choice[0] != -1 ? choice[0]
                  : cellOf(1);
            }
            if (internal && (isSplit[1] || i == 0))
            {
                cells[cellOf(1)].append
                (
                    reversed(p, choice[1] != -1 ? choice[1] : cellOf(0))
                );
            }
        }
    }
    choices_.transfer(choices);

    // Faces between the tetrahedra of a cell: each stands on an edge
    label nBad = 0, badCell = -1;
    forAll(split, celli)
    {
        if (!split[celli])
        {
            continue;
        }

        std::map<std::pair<label, label>, label> waiting;
        const vector& centre = cellCentres[celli];
        bool bad = false;
        for (const label facei : mesh_.cells()[celli])
        {
            const label side = own[facei] != celli;
            for (label i = 0; i + 2 < mesh_.faces()[facei].size(); ++i)
            {
                const label tet = firstTet[side][facei] + i;
                const triFace t = triangle(facei, i);
                const vector n =
                    (points[t[1]] - points[t[0]])
                  ^ (points[t[2]] - points[t[0]]);
                const scalar height =
                    (side ? -1 : 1)*((points[t[0]] - centre) & n);
                bad = bad || height <= 0;

                for (label e = 0; e < 3; ++e)
                {
                    const label a = min(t[e], t[(e + 1) % 3]);
                    const label b = max(t[e], t[(e + 1) % 3]);
                    const point& opposite = points[t[(e + 2) % 3]];
                    vector m = normalised
                    (
                        (points[a] - centre) ^ (points[b] - centre)
                    );
                    if (((opposite - centre) & m) > 0)
                    {
                        m = -m;
                    }

                    const auto found = waiting.find({a, b});
                    if (found == waiting.end())
                    {
                        waiting[{a, b}] = tet;
                        cells[tet].append(planeThrough(m, centre, -1));
                        cells[tet].last().target = unknown;
                        continue;
                    }

                    const label other = found->second;
                    bool matched = false;
                    for (facePlane& p : cells[other])
                    {
                        if (p.target == unknown && mag(p.normal + m) < 1e-6)
                        {
                            p.target = tet;
                            cells[tet].append(reversed(p, other));
                            matched = true;
                            break;
                        }
                    }
                    bad = bad || !matched;
                    waiting.erase(found);
                }
            }
        }
        if (bad)
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
            FatalError<< cellCentres[badCell];
        }
        FatalError<< ". Improve the mesh (checkMesh)." << exit(FatalError);
    }

    // Into groups
    using namespace walkKernels;
    firstGroup_.assign(1, 0);
    firstGroup_.reserve(cells.size() + 1);
    forAll(cells, celli)
    {
        const label nGroups = (cells[celli].size() + width - 1)/width;
        const std::size_t group = firstGroup_.back();
        firstGroup_.push_back(group + nGroups);
        planes_.resize(stride*(group + nGroups), 0);
        targets_.resize(width*(group + nGroups), -1);
        faces_.resize(width*(group + nGroups), -1);
        for (label i = 0; i < width*nGroups; ++i)
        {
            double* p = &planes_[stride*(group + i/width) + i % width];
            p[3*width] = 1;
            if (i < cells[celli].size())
            {
                const facePlane& q = cells[celli][i];
                for (label d = 0; d < 3; ++d)
                {
                    p[d*width] = q.normal[d];
                }
                p[3*width] = q.distance;
                targets_[width*group + i] = q.target;
                faces_[width*group + i] = q.face;
            }
        }
    }
}


void Foam::convexCells::buildBounds()
{
    using namespace walkKernels;

    const label nCells = size();
    bounds_.resize(boundStride*nCells, 0);
    beyond_.resize(boundStride*nCells, -1);
    label nBoxes = 0;
    for (label c = 0; c < nCells; ++c)
    {
        double* bounds = &bounds_[boundStride*c];
        std::int32_t* beyond = &beyond_[boundStride*c];

        // Each plane once, its normal without any other component: the bound
        // is then its distance to the last bit
        label met = 0;
        bool box = true;
        const label last = width*firstGroup_[c + 1];
        for (label k = width*firstGroup_[c]; k < last; ++k)
        {
            const double* p = &planes_[stride*(k/width) + k % width];
            const double n[3] = {p[0], p[width], p[2*width]};
            if (n[0] == 0 && n[1] == 0 && n[2] == 0)
            {
                continue;
            }
            label place = -1;
            for (label d = 0; d < 3; ++d)
            {
                if
                (
                    mag(n[d]) == 1
                 && n[(d + 1) % 3] == 0
                 && n[(d + 2) % 3] == 0
                )
                {
                    place = n[d] > 0 ? width + d : d;
                    bounds[place] = n[d]*p[3*width];
                    beyond[place] = targets_[k];
                }
            }
            box = box && place >= 0 && !(met & (1 << place));
            met |= place >= 0 ? 1 << place : 0;
        }
        const label all = 7 | (7 << width);
        if (box && met == all)
        {
            ++nBoxes;
        }
        else
        {
            bounds[0] = 1;
            bounds[width] = 0;
        }
    }
    if (!nBoxes)
    {
        bounds_ = std::vector<double>();
        beyond_ = std::vector<std::int32_t>();
    }
}


void Foam::convexCells::buildBoundary()
{
    const label nInternal = mesh_.nInternalFaces();
    const polyBoundaryMesh& patches = mesh_.boundaryMesh();
    boundary_.resize(mesh_.nFaces() - nInternal);

    // The faces and their centres on the other side of coupled patches
    labelList mates(boundary_.size());
    pointField centres(boundary_.size());
    forAll(mates, i)
    {
        mates[i] = i;
        centres[i] = mesh_.faceCentres()[nInternal + i];
    }
    pointField mateCentres(centres);
    syncTools::swapBoundaryFaceList(mesh_, mates);
    syncTools::swapBoundaryFaceList(mesh_, mateCentres);

    forAll(patches, patchi)
    {
        const polyPatch& patch = patches[patchi];
        boundaryKind kind = open;
        int processorNo = -1;

        if (isA<wallPolyPatch>(patch))
        {
            kind = wall;
        }
        else if
        (
            isA<symmetryPolyPatch>(patch)
         || isA<symmetryPlanePolyPatch>(patch)
         || isA<wedgePolyPatch>(patch)
         || isA<emptyPolyPatch>(patch)
        )
        {
            kind = mirror;
        }
        else if (isA<processorPolyPatch>(patch))
        {
            kind = processor;
            processorNo =
                refCast<const processorPolyPatch>(patch).neighbProcNo();
        }
        else if (isA<cyclicPolyPatch>(patch))
        {
            kind = cyclic;
        }

        const bool turns =
            patch.coupled()
         && !refCast<const coupledPolyPatch>(patch).parallel();
        forAll(patch, i)
        {
            const label facei = patch.start() - nInternal + i;
            boundaryFace& face = boundary_[facei];
            face.kind = kind;
            face.patch = patchi;
            face.patchFace = i;
            face.mate = mates[facei];
            face.processor = processorNo;
            face.rotation = -1;
            face.shift = {0, 0, 0};

            if (turns && kind == cyclic)
            {
                const auto& pair = refCast<const cyclicPolyPatch>(patch);
                const vector to =
                    pair.neighbPatch().faceCentres()[i];
                const vector n = normalised(patch.faceAreas()[i]);
                const vector nTo =
                    normalised(pair.neighbPatch().faceAreas()[i]);

                // Outward normals point against each other once turned
                tensor T = pair.forwardT()[pair.forwardT().size() > 1 ? i : 0];
                if (mag((T & n) + nTo) > mag((T.T() & n) + nTo))
                {
                    T = T.T();
                }
                face.rotation = rotations_.size();
                rotations_.push_back(rotation{T, centres[facei], to});
            }
            else if
            (
                kind == cyclic || isA<processorCyclicPolyPatch>(patch)
            )
            {
                const vector s = mateCentres[facei] - centres[facei];
                face.shift = {s.x(), s.y(), s.z()};
            }
        }
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::convexCells::convexCells(const polyMesh& mesh, const boolList& others)
:
    mesh_(mesh),
    nSplit_(0),
    moving_(vector::one)
{
    boolList split(cellsToSplit());
    forAll(others, celli)
    {
        split[celli] = split[celli] || others[celli];
    }
    buildCells(split);
    buildBounds();
    buildBoundary();

    for (direction d = 0; d < 3; ++d)
    {
        if (mesh.solutionD()[d] == -1)
        {
            moving_[d] = 0;
        }
    }

    const label nCells = returnReduce(mesh.nCells(), sumOp<label>());
    const label nSplit = returnReduce(nSplit_, sumOp<label>());
    Info<< "Tracking through " << nCells << " cells";
    if (nSplit)
    {
        Info<< ", " << nSplit << " of them"
            << (others.empty() ? " (warped, not convex or beside smaller ones)" : "")
            << " split into "
            << returnReduce(size(), sumOp<label>()) - (nCells - nSplit)
            << " tetrahedra";
    }
    Info<< nl << endl;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::convexCells::refuseUnknownPairs() const
{
    for (const polyPatch& patch : mesh_.boundaryMesh())
    {
        if (isA<cyclicAMIPolyPatch>(patch))
        {
            FatalErrorInFunction
                << "Patch " << patch.name() << " of type " << patch.type()
                << " is not supported by face-plane tracking."
                << " Valid types: patch, wall, symmetry, symmetryPlane,"
                << " wedge, empty, cyclic, processor" << exit(FatalError);
        }
        if
        (
            isA<processorPolyPatch>(patch)
         && !refCast<const coupledPolyPatch>(patch).parallel()
        )
        {
            FatalErrorInFunction
                << "Patch " << patch.name() << " joins the two sides of a"
                << " rotational cyclic patch across processors. Keep them on"
                << " one with the preservePatches constraint of decomposePar"
                << exit(FatalError);
        }
    }
}


Foam::scalar Foam::convexCells::height
(
    const label celli,
    const impact::vector3& x
) const
{
    using namespace walkKernels;

    scalar greatest = -GREAT;
    for (label g = firstGroup_[celli]; g < firstGroup_[celli + 1]; ++g)
    {
        const double* p = &planes_[stride*std::size_t(g)];
        for (int k = 0; k < width; ++k)
        {
            const bool used = p[k] != 0 || p[width + k] != 0
                || p[2*width + k] != 0;
            if (used)
            {
                greatest = max
                (
                    greatest,
                    p[k]*x.x + p[width + k]*x.y + p[2*width + k]*x.z
                  - p[3*width + k]
                );
            }
        }
    }
    return greatest;
}


Foam::label Foam::convexCells::locate
(
    const label meshCelli,
    const impact::vector3& x
) const
{
    label best = firstCell_[meshCelli];
    if (firstCell_[meshCelli + 1] == best + 1)
    {
        return best;
    }
    scalar least = GREAT;
    for (label i = best; i < firstCell_[meshCelli + 1]; ++i)
    {
        const scalar h = height(i, x);
        if (h < least)
        {
            least = h;
            best = i;
        }
    }
    return best;
}


Foam::label Foam::convexCells::inside
(
    const label facei,
    const impact::vector3& x
) const
{
    const labelList& cells = boundaryCells_[facei];
    label best = cells[0];
    if (cells.size() > 1)
    {
        scalar least = GREAT;
        for (const label celli : cells)
        {
            const scalar h = height(celli, x);
            if (h < least)
            {
                least = h;
                best = celli;
            }
        }
    }
    return best;
}
