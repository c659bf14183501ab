/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "convexCells.H"
#include "cellPlanes.H"
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

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::convexCells::buildCells(const boolList& split)
{
    cellPlanes built(mesh_, triangles_, split);
    nSplit_ = built.nSplit;
    firstCell_.transfer(built.firstCell);
    meshCell_.transfer(built.meshCell);
    boundaryCells_.transfer(built.boundaryCells);
    choices_.transfer(built.choices);

    // Into groups
    using namespace walkKernels;
    firstGroup_.assign(1, 0);
    firstGroup_.reserve(built.planes.size() + 1);
    for (const DynamicList<cellPlanes::plane>& planes : built.planes)
    {
        const label nGroups = (planes.size() + width - 1)/width;
        const std::size_t group = firstGroup_.back();
        firstGroup_.push_back(group + nGroups);
        planes_.resize(stride*(group + nGroups), 0);
        targets_.resize(width*(group + nGroups), -1);
        faces_.resize(width*(group + nGroups), -1);
        for (label i = 0; i < width*nGroups; ++i)
        {
            double* p = &planes_[stride*(group + i/width) + i % width];
            p[3*width] = 1;
            if (i < planes.size())
            {
                const cellPlanes::plane& q = planes[i];
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


void Foam::convexCells::buildVolumes()
{
    volumes_ = mesh_.cellVolumes();
    const pointField& points = mesh_.points();
    forAll(volumes_, celli)
    {
        if (firstCell_[celli + 1] - firstCell_[celli] == 1)
        {
            continue;
        }
        const point& centre = mesh_.cellCentres()[celli];
        scalar sum = 0;
        for (const label facei : mesh_.cells()[celli])
        {
            const scalar sign = mesh_.faceOwner()[facei] == celli ? 1 : -1;
            for (label i = 0; i < mesh_.faces()[facei].size() - 2; ++i)
            {
                const triFace t(triangles_(facei, i));
                sum +=
                    sign*(t.areaNormal(points) & (points[t[0]] - centre))/3;
            }
        }
        volumes_[celli] = sum;
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
            const double* p = planeAt(k);
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
    triangles_(mesh)
{
    boolList split(cellsToSplit());
    forAll(others, celli)
    {
        split[celli] = split[celli] || others[celli];
    }
    buildCells(split);
    buildVolumes();
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
            << (
                   others.empty()
                 ? " (warped, not convex or beside smaller ones)"
                 : ""
               )
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

    scalar maxHeight = -GREAT;
    for (label g = firstGroup_[celli]; g < firstGroup_[celli + 1]; ++g)
    {
        const double* p = &planes_[stride*std::size_t(g)];
        for (int k = 0; k < width; ++k)
        {
            const bool used = p[k] != 0 || p[width + k] != 0
                || p[2*width + k] != 0;
            if (used)
            {
                maxHeight = max
                (
                    maxHeight,
                    p[k]*x.x + p[width + k]*x.y + p[2*width + k]*x.z
                  - p[3*width + k]
                );
            }
        }
    }
    return maxHeight;
}


Foam::label Foam::convexCells::locate
(
    const label meshCelli,
    const impact::vector3& x
) const
{
    const label first = firstCell_[meshCelli];
    const label n = firstCell_[meshCelli + 1] - first;
    return n == 1 ? first : lowest(labelRange(first, n), x);
}


Foam::label Foam::convexCells::inside
(
    const label facei,
    const impact::vector3& x
) const
{
    const labelList& cells = boundaryCells_[facei];
    return cells.size() > 1 ? lowest(cells, x) : cells[0];
}
