/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "convexCells.H"
#include "syncTools.H"

namespace
{
    using Foam::scalar;

    const scalar tolerance = 1e-6;

    // Least difference of the normals of two faces of a whole cell
    const scalar minTurn = 1e-3;
}


Foam::boolList Foam::convexCells::cellsToSplit() const
{
    const pointField& points = mesh_.points();
    const vectorField& centres = mesh_.faceCentres();
    const vectorField& areas = mesh_.faceAreas();

    boolList split(mesh_.nCells());
    boolList warped(mesh_.nFaces());
    split = false;
    warped = false;

    forAll(areas, facei)
    {
        const scalar area = mag(areas[facei]);
        if (area < VSMALL)
        {
            FatalErrorInFunction
                << "Face " << facei << " of the mesh at " << centres[facei]
                << " has no area" << exit(FatalError);
        }
        const vector n = areas[facei]/area;
        scalar height = 0;
        for (const label pointi : mesh_.faces()[facei])
        {
            height = max(height, mag((points[pointi] - centres[facei]) & n));
        }
        warped[facei] = height > tolerance*sqrt(area);
    }

    // Both sides of a coupled face have to take the same view of it
    syncTools::syncFaceList(mesh_, warped, orEqOp<bool>());

    forAll(warped, facei)
    {
        if (warped[facei])
        {
            split[mesh_.faceOwner()[facei]] = true;
            if (mesh_.isInternalFace(facei))
            {
                split[mesh_.faceNeighbour()[facei]] = true;
            }
        }
    }

    // Where a cell meets smaller ones its side is several faces in one plane,
    // and that a particle crosses the plane does not tell which it enters
    DynamicList<vector> normals;
    forAll(split, celli)
    {
        normals.clear();
        for (const label facei : mesh_.cells()[celli])
        {
            const scalar sign = mesh_.faceOwner()[facei] == celli ? 1 : -1;
            const vector n = sign*areas[facei]/mag(areas[facei]);
            for (const vector& other : normals)
            {
                split[celli] =
                    split[celli] || magSqr(n - other) < sqr(minTurn);
            }
            normals.append(n);
        }
    }

    const labelListList& cellPoints = mesh_.cellPoints();
    forAll(split, celli)
    {
        const scalar limit = tolerance*cbrt(mesh_.cellVolumes()[celli]);
        for (const label facei : mesh_.cells()[celli])
        {
            if (split[celli])
            {
                break;
            }
            const scalar sign = mesh_.faceOwner()[facei] == celli ? 1 : -1;
            const vector n = sign*areas[facei]/mag(areas[facei]);
            for (const label pointi : cellPoints[celli])
            {
                if (((points[pointi] - centres[facei]) & n) > limit)
                {
                    split[celli] = true;
                    break;
                }
            }
        }
    }

    return split;
}
