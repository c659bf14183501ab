/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "gasMesh.H"
#include "processorPolyPatch.H"
#include "cyclicPolyPatch.H"
#include "cyclicAMIPolyPatch.H"
#include "UIPstream.H"
#include "UOPstream.H"

void Foam::gasMesh::interpolateAMI
(
    const cyclicAMIPolyPatch& patch,
    const double* values,
    const int n,
    double* ghost
)
{
    const labelUList& here = patch.faceCells();
    const labelUList& there = patch.neighbPatch().faceCells();
    const bool lowWeights = patch.applyLowWeightCorrection();
    scalarField behind(there.size());
    scalarField own(lowWeights ? here.size() : 0);

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

    // First what waits for its own messages, so that no others are on the way
    for (const patchRange& patch : patches_)
    {
        const polyPatch& pp = boundary[patch.patchi];
        if (patch.coupled && isA<cyclicAMIPolyPatch>(pp))
        {
            interpolateAMI
            (
                refCast<const cyclicAMIPolyPatch>(pp),
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
            const labelUList& behind =
                refCast<const cyclicPolyPatch>(pp).neighbPatch().faceCells();
            forAll(behind, i)
            {
                const double* from = values + n*behind[i];
                std::copy(from, from + n, ghost + n*i);
            }
            continue;
        }

        const processorPolyPatch& ppp = refCast<const processorPolyPatch>(pp);
        const labelUList& cells = pp.faceCells();
        List<double>& send = sendBuffer_[patch.patchi];
        send.setSize(n*patch.size);
        forAll(cells, i)
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
