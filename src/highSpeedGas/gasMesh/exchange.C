/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "gasMesh.H"
#include "processorPolyPatch.H"
#include "cyclicPolyPatch.H"
#include "cyclicAMIPolyPatch.H"
#include "UIPstream.H"
#include "UOPstream.H"
#include <algorithm>

void Foam::gasMesh::interpolateAMI
(
    const cyclicAMIPolyPatch& patch,
    const int* here,
    const int* there,
    const double* values,
    const int n,
    double* ghost
)
{
    const bool lowWeights = patch.applyLowWeightCorrection();
    scalarField behind(patch.neighbPatch().size());
    scalarField own(lowWeights ? patch.size() : 0);

    for (int k = 0; k < n; k++)
    {
        forAll(behind, i)
        {
            behind[i] = values[n*there[i] + k];
        }
        forAll(own, i)
        {
            own[i] = values[n*here[i] + k];
        }
        const scalarField seen(patch.interpolate(behind, own));
        forAll(seen, i)
        {
            ghost[n*i + k] = seen[i];
        }
    }
}


void Foam::gasMesh::exchange(double* values, const int n) const
{
    const polyBoundaryMesh& boundary = mesh_.boundaryMesh();

    // The cells at a patch
    const auto cellsAt = [&](const label patchi)
    {
        const auto found = std::find_if
        (
            patches_.begin(),
            patches_.end(),
            [&](const patchRange& range) { return range.patchi == patchi; }
        );
        return owner.data() + found->start;
    };

    // First what waits for its own messages, so that no others are on the way
    for (const patchRange& patch : patches_)
    {
        const polyPatch& pp = boundary[patch.patchi];
        if (patch.coupled && isA<cyclicAMIPolyPatch>(pp))
        {
            const auto& ami = refCast<const cyclicAMIPolyPatch>(pp);
            interpolateAMI
            (
                ami,
                cellsAt(patch.patchi),
                cellsAt(ami.neighbPatch().index()),
                values,
                n,
                values + n*(nCells_ + patch.start - nInternal_)
            );
        }
    }

    const label startOfRequests = Pstream::nRequests();

    for (const patchRange& patch : patches_)
    {
        if
        (
            !patch.coupled
         || isA<cyclicAMIPolyPatch>(boundary[patch.patchi])
        )
        {
            continue;
        }
        const polyPatch& pp = boundary[patch.patchi];
        double* ghost = values + n*(nCells_ + patch.start - nInternal_);

        if (isA<cyclicPolyPatch>(pp))
        {
            const int* behind = cellsAt
            (
                refCast<const cyclicPolyPatch>(pp).neighbPatch().index()
            );
            for (label i = 0; i < patch.size; i++)
            {
                const double* from = values + n*behind[i];
                std::copy(from, from + n, ghost + n*i);
            }
            continue;
        }

        const processorPolyPatch& ppp = refCast<const processorPolyPatch>(pp);
        const int* cells = cellsAt(patch.patchi);
        List<double>& send = sendBuffer_[patch.patchi];
        send.setSize(n*patch.size);
        for (label i = 0; i < patch.size; i++)
        {
            const double* from = values + n*cells[i];
            std::copy(from, from + n, send.begin() + n*i);
        }

        UIPstream::read
        (
            Pstream::commsTypes::nonBlocking,
            ppp.neighbProcNo(),
            reinterpret_cast<char*>(ghost),
            n*patch.size*sizeof(double),
            ppp.tag(),
            ppp.comm()
        );
        UOPstream::write
        (
            Pstream::commsTypes::nonBlocking,
            ppp.neighbProcNo(),
            reinterpret_cast<const char*>(send.begin()),
            n*patch.size*sizeof(double),
            ppp.tag(),
            ppp.comm()
        );
    }

    if (Pstream::parRun())
    {
        Pstream::waitRequests(startOfRequests);
    }
}
