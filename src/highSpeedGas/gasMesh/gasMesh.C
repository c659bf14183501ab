/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "gasMesh.H"
#include "emptyPolyPatch.H"
#include "symmetryPolyPatch.H"
#include "symmetryPlanePolyPatch.H"
#include "wedgePolyPatch.H"
#include "processorPolyPatch.H"
#include "cyclicPolyPatch.H"
#include "cyclicAMIPolyPatch.H"
#include "cyclicACMIPolyPatch.H"
#include "cyclicPeriodicAMIPolyPatch.H"
#include "surfaceFields.H"
#include "bandCompression.H"
#include <algorithm>
#include <numeric>

const Foam::wedgePolyPatch* Foam::gasMesh::wedge() const
{
    for (const polyPatch& pp : mesh_.boundaryMesh())
    {
        if (isA<wedgePolyPatch>(pp))
        {
            return &refCast<const wedgePolyPatch>(pp);
        }
    }
    return nullptr;
}


bool Foam::gasMesh::isFront(const polyPatch& patch)
{
    // (the stock centreNormal looks to the side of its patch)
    const wedgePolyPatch& wedge = refCast<const wedgePolyPatch>(patch);
    return (wedge.n() & cmptMag(wedge.centreNormal())) > 0;
}


bool Foam::gasMesh::hasOneLayer() const
{
    // Each cell has one face in front
    std::vector<int> nFront(mesh_.nCells(), 0);
    for (const polyPatch& pp : mesh_.boundaryMesh())
    {
        if (isA<wedgePolyPatch>(pp) && isFront(pp))
        {
            for (const label c : pp.faceCells())
            {
                nFront[c]++;
            }
        }
    }
    bool one = wedge();
    for (const int n : nFront)
    {
        one = one && n == 1;
    }
    return returnReduce(one, andOp<bool>());
}


void Foam::gasMesh::setDirections()
{
    const Vector<label>& solved = mesh_.solutionD();

    nDim_ = 0;
    for (int d = 0; d < 3; d++)
    {
        const bool around =
            inSection_ && mag(wedge()->centreNormal()[d]) > 0.5;
        if (solved[d] == 1 && !around)
        {
            direction_[nDim_++] = d;
        }
    }

    // A line of cells is treated as a plane with nothing happening across
    for (int d = 0; d < 3 && nDim_ < 2; d++)
    {
        if (solved[d] != 1)
        {
            direction_[nDim_++] = d;
        }
    }
}


void Foam::gasMesh::setPatches()
{
    const polyBoundaryMesh& boundary = mesh_.boundaryMesh();

    nCells_ = mesh_.nCells();
    nInternal_ = mesh_.nInternalFaces();
    nFaces_ = nInternal_;

    forAll(boundary, patchi)
    {
        const polyPatch& pp = boundary[patchi];

        if
        (
            isA<emptyPolyPatch>(pp)
         || (inSection_ && isA<wedgePolyPatch>(pp) && !isFront(pp))
        )
        {
            continue;
        }
        // (An AMI says that it is coupled only once both sides are there)
        const bool ami =
            isA<cyclicAMIPolyPatch>(pp) && !isA<cyclicACMIPolyPatch>(pp)
         && !isA<cyclicPeriodicAMIPolyPatch>(pp);
        const bool coupled =
            ami || isA<processorPolyPatch>(pp) || isA<cyclicPolyPatch>(pp);

        if (!coupled && (pp.coupled() || isA<cyclicAMIPolyPatch>(pp)))
        {
            FatalErrorInFunction
                << "Patch " << pp.name() << " of type " << pp.type()
                << " couples cells in a way the gas solution does not know."
                << nl << "Valid coupled types: processor, cyclic, cyclicAMI"
                << exit(FatalError);
        }
        if
        (
            coupled && !isType<processorPolyPatch>(pp)
         && !refCast<const coupledPolyPatch>(pp).parallel()
        )
        {
            FatalErrorInFunction
                << "Patch " << pp.name() << " of type " << pp.type()
                << " is joined to its neighbour by a rotation; the gas is"
                << " joined by translations only." << nl
                << "Solve the whole circumference, or use a wedge if the flow"
                << " is axisymmetric" << exit(FatalError);
        }

        patches_.push_back
        (
            patchRange
            {
                patchi,
                nFaces_,
                pp.size(),
                coupled,
                isA<symmetryPolyPatch>(pp) || isA<symmetryPlanePolyPatch>(pp),
                isA<wedgePolyPatch>(pp)
            }
        );
        nFaces_ += pp.size();
    }
}


void Foam::gasMesh::setFace
(
    const label f,
    const label own,
    const label farCell,
    const vector& Sf,
    const vector& toFaceCentre,
    const vector& toFar
)
{
    const pointField& C = mesh_.cellCentres();
    owner[f] = cellOf[own];
    far[f] = f < nInternal_ ? cellOf[farCell] : farCell;
    area[f] = mag(Sf);
    const vector n = Sf/area[f];
    for (int d = 0; d < 3; d++)
    {
        if
        (
            f < nInternal_ && mesh_.solutionD()[d] != 1 && mag(n[d]) > 0.5
        )
        {
            FatalErrorInFunction
                << "Nothing is solved in the direction "
                << vector::componentNames[d] << ", since empty patches"
                << " look in it, but the face between the cells at "
                << C[own] << " and " << C[own] + toFar
                << " does too: there are several layers of cells between"
                << " the empty patches, or these are not parallel." << nl
                << "Make one layer of cells of one thickness there, or"
                << " give the sides another patch type than empty"
                << exit(FatalError);
        }
    }
    for (int d = 0; d < nDim_; d++)
    {
        normal[f*nDim_ + d] = n[direction_[d]];
        delta[f*nDim_ + d] = toFar[direction_[d]];
        toFace[f*nDim_ + d] = toFaceCentre[direction_[d]];
    }
    normalDistance[f] = max(mag(n & toFar), 0.05*mag(toFar));
    weight[f] =
        min(max((n & toFaceCentre)/stabilise(n & toFar, VSMALL), 0.0), 1.0);
}


void Foam::gasMesh::setNumbers()
{
    const labelList& own = mesh_.faceOwner();
    const labelList& nei = mesh_.faceNeighbour();
    labelListList neighbours(nCells_);
    {
        labelList n(nCells_, Zero);
        forAll(nei, f)
        {
            n[own[f]]++;
            n[nei[f]]++;
        }
        forAll(neighbours, c)
        {
            neighbours[c].setSize(n[c]);
        }
        forAll(nei, f)
        {
            neighbours[own[f]][--n[own[f]]] = nei[f];
            neighbours[nei[f]][--n[nei[f]]] = own[f];
        }
    }
    const labelList order(bandCompression(neighbours));
    meshCell.assign(order.begin(), order.end());
    cellOf.resize(nCells_);
    for (label c = 0; c < nCells_; c++)
    {
        cellOf[meshCell[c]] = c;
    }

    const auto ends = [&](const int f)
    {
        return std::minmax(cellOf[own[f]], cellOf[nei[f]]);
    };
    meshFace.resize(nInternal_);
    std::iota(meshFace.begin(), meshFace.end(), 0);
    std::sort
    (
        meshFace.begin(),
        meshFace.end(),
        [&](const int f, const int g)
        {
            const auto a = ends(f);
            const auto b = ends(g);
            return a < b || (a == b && f < g);
        }
    );
    meshSign.resize(nInternal_);
    for (label f = 0; f < nInternal_; f++)
    {
        const int g = meshFace[f];
        meshSign[f] = cellOf[own[g]] < cellOf[nei[g]] ? 1 : -1;
    }
}


void Foam::gasMesh::setFaces()
{
    owner.resize(nFaces_);
    far.resize(nFaces_);
    normal.assign(nFaces_*nDim_, 0);
    area.resize(nFaces_);
    delta.assign(nFaces_*nDim_, 0);
    toFace.assign(nFaces_*nDim_, 0);
    weight.resize(nFaces_);
    normalDistance.resize(nFaces_);

    const pointField& C = mesh_.cellCentres();

    for (label f = 0; f < nInternal_; f++)
    {
        const label g = meshFace[f];
        label own = mesh_.faceOwner()[g];
        label nei = mesh_.faceNeighbour()[g];
        if (meshSign[f] < 0)
        {
            std::swap(own, nei);
        }
        setFace
        (
            f,
            own,
            nei,
            meshSign[f]*mesh_.faceAreas()[g],
            mesh_.faceCentres()[g] - C[own],
            C[nei] - C[own]
        );
    }

    for (const patchRange& patch : patches_)
    {
        const fvPatch& fvp = mesh_.boundary()[patch.patchi];
        const vectorField delta(fvp.delta());
        const labelUList& cells = fvp.faceCells();

        for (label i = 0; i < patch.size; i++)
        {
            const label f = patch.start + i;
            vector toFaceCentre(fvp.Cf()[i] - C[cells[i]]);
            const vector n(fvp.Sf()[i]/fvp.magSf()[i]);
            vector Sf(fvp.Sf()[i]);
            if (patch.wedge && inSection_)
            {
                // Both sides together: what they turn towards the axis
                const vector around
                (
                    refCast<const wedgePolyPatch>(fvp.patch()).centreNormal()
                );
                Sf = 2*(Sf - (Sf & around)*around);
                toFaceCentre -= (toFaceCentre & around)*around;
            }

            setFace
            (
                f,
                cells[i],
                nCells_ + f - nInternal_,
                Sf,
                toFaceCentre,
                patch.coupled ? delta[i]
              : patch.symmetry ? 2*(n & toFaceCentre)*n
              : toFaceCentre
            );
            if (!patch.coupled)
            {
                weight[f] = patch.symmetry ? 0.5 : 1;
            }
        }
    }
}


void Foam::gasMesh::refuseInsideOut(const polyMesh& mesh, const char* remedy)
{
    const scalarField& V = mesh.cellVolumes();
    const label worst = findMin(V);
    if (worst >= 0 && V[worst] <= 0)
    {
        label n = 0;
        for (const scalar volume : V)
        {
            n += volume <= 0;
        }
        FatalErrorInFunction
            << "Cell " << worst << " at " << mesh.cellCentres()[worst]
            << " is inside out, the worst of " << n << ": its volume is "
            << V[worst] << " m3" << nl << remedy << exit(FatalError);
    }
}


void Foam::gasMesh::setCells()
{
    // Cells see what lies behind a face. Off the axis nothing does behind the
    // sides of a section.
    std::vector<bool> seen(nFaces_, true);
    for (const patchRange& patch : patches_)
    {
        const label end =
            patch.start + (patch.wedge && inSection_ ? patch.size : 0);
        for (label f = patch.start; f < end; f++)
        {
            seen[f] = lsqWeight_[f] > 0;
        }
    }

    refuseInsideOut(mesh_, "Mend the mesh: checkMesh lists such cells");
    volume.resize(nCells_);
    for (label c = 0; c < nCells_; c++)
    {
        volume[c] = mesh_.cellVolumes()[meshCell[c]];
    }

    cellStart.assign(nCells_ + 1, 0);
    for (label f = 0; f < nFaces_; f++)
    {
        cellStart[owner[f] + 1] += seen[f];
        if (f < nInternal_)
        {
            cellStart[far[f] + 1]++;
        }
    }
    for (label c = 0; c < nCells_; c++)
    {
        cellStart[c + 1] += cellStart[c];
    }
    faceOf.resize(cellStart[nCells_]);
    neighbour.resize(faceOf.size());
    std::vector<int> fill(cellStart.begin(), cellStart.end() - 1);
    for (label f = 0; f < nFaces_; f++)
    {
        if (!seen[f])
        {
            continue;
        }
        neighbour[fill[owner[f]]] = far[f];
        faceOf[fill[owner[f]]++] = f;
        if (f < nInternal_)
        {
            neighbour[fill[far[f]]] = owner[f];
            faceOf[fill[far[f]]++] = f;
        }
    }
}


void Foam::gasMesh::setExtents()
{
    // Half of the areas of the faces, each in the direction of its normal, over
    // the volume: of a box the inverse lengths of its edges
    const int n = nDim_*nDim_;
    inverseExtent.assign(nSlots()*n, 0);
    const auto add = [&](const label f, const bool internal)
    {
        for (int k = 0; k < n; k++)
        {
            const double half =
                0.5*area[f]*normal[f*nDim_ + k/nDim_]
               *normal[f*nDim_ + k % nDim_];
            inverseExtent[owner[f]*n + k] += half/volume[owner[f]];
            if (internal)
            {
                inverseExtent[far[f]*n + k] += half/volume[far[f]];
            }
        }
    };
    for (label f = 0; f < nInternal_; f++)
    {
        add(f, true);
    }
    for (const patchRange& patch : patches_)
    {
        // (nothing changes from one side of a wedge to the other)
        const label end = patch.start + (patch.wedge ? 0 : patch.size);
        for (label f = patch.start; f < end; f++)
        {
            add(f, false);
        }
    }
    for (const patchRange& patch : patches_)
    {
        for (label f = patch.start; f < patch.start + patch.size; f++)
        {
            const double* of = &inverseExtent[owner[f]*n];
            double* ghost = &inverseExtent[far[f]*n];
            std::copy_n(of, n, ghost);
            if (!patch.symmetry)
            {
                continue;
            }

            // Of the image
            const double* N = &normal[f*nDim_];
            double across[3] = {0, 0, 0};
            double through = 0;
            for (int k = 0; k < n; k++)
            {
                across[k/nDim_] += of[k]*N[k % nDim_];
                through += of[k]*N[k/nDim_]*N[k % nDim_];
            }
            for (int k = 0; k < n; k++)
            {
                const int i = k/nDim_;
                const int j = k % nDim_;
                ghost[k] +=
                    4*through*N[i]*N[j]
                  - 2*(N[i]*across[j] + across[i]*N[j]);
            }
        }
    }
    exchange(inverseExtent.data(), n);
}


Foam::gasMesh::gasMesh(const fvMesh& mesh, const bool swirls)
:
    mesh_(mesh),
    inSection_(!swirls && hasOneLayer())
{
    setDirections();
    setPatches();
    setNumbers();
    setFaces();
    setImages();
    setCells();
    setGasBehind();
    sendBuffer_.setSize(mesh.boundaryMesh().size());
    setExtents();
    setAxis();
    setTurning();
}
