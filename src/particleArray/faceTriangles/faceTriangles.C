/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "faceTriangles.H"
#include "processorCyclicPolyPatch.H"
#include "syncTools.H"
#include "tetPointRef.H"

namespace
{
    // Quality of tetrahedra that there is nothing to be said against
    const Foam::scalar enough = 1e-6;

    // Qualities that differ by less, as by rounding, are the same
    const Foam::scalar rounding = 1e-9;
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::faceTriangles::worst
(
    const face& f,
    const label base,
    const point& centre,
    const scalar sign
) const
{
    const pointField& points = mesh_.points();
    scalar least = GREAT;
    for (label i = 1; i + 1 < f.size(); ++i)
    {
        const tetPointRef tet
        (
            centre,
            points[f[base]],
            points[f[(base + i) % f.size()]],
            points[f[(base + i + 1) % f.size()]]
        );
        least = min(least, sign*tet.quality());
    }
    return least;
}


Foam::label Foam::faceTriangles::baseBetween
(
    const face& f,
    const point& ownCentre,
    const point& otherCentre
) const
{
    scalarField quality(f.size());
    forAll(f, i)
    {
        quality[i] =
            min(worst(f, i, ownCentre, 1), worst(f, i, otherCentre, -1));
        if (i == 0 && quality[0] > enough)
        {
            return 0;
        }
    }
    const scalar best = max(quality);
    const auto before = [](const point& a, const point& b)
    {
        return
            a.x() != b.x() ? a.x() < b.x()
          : a.y() != b.y() ? a.y() < b.y() : a.z() < b.z();
    };
    const pointField& points = mesh_.points();
    label base = -1;
    forAll(f, i)
    {
        if
        (
            quality[i] > best - rounding
         && (base < 0 || before(points[f[i]], points[f[base]]))
        )
        {
            base = i;
        }
    }
    return base;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::faceTriangles::faceTriangles(const polyMesh& mesh)
:
    mesh_(mesh),
    base_(mesh.tetBasePtIs())
{
    for (label& base : base_)
    {
        base = max(base, label(0));
    }

    const pointField& centres = mesh.cellCentres();
    const auto set = [&](const label facei, const point& otherCentre)
    {
        const face& f = mesh.faces()[facei];
        if (f.size() > 3)
        {
            base_[facei] =
                baseBetween(f, centres[mesh.faceOwner()[facei]], otherCentre);
        }
    };
    forAll(mesh.faceNeighbour(), facei)
    {
        set(facei, centres[mesh.faceNeighbour()[facei]]);
    }
    pointField beyond;
    syncTools::swapBoundaryCellPositions(mesh, centres, beyond);
    for (const polyPatch& patch : mesh.boundaryMesh())
    {
        const bool between =
            isA<processorPolyPatch>(patch)
         && !isA<processorCyclicPolyPatch>(patch);
        for (label i = 0; between && i < patch.size(); ++i)
        {
            const label facei = patch.start() + i;
            set(facei, beyond[facei - mesh.nInternalFaces()]);
        }
    }
}
