/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "gasMesh.H"
#include "wedgePolyPatch.H"
#include "syncTools.H"

namespace Foam
{

//- Integral of r^k over a triangle with the distances a, b, c of its corners
//  from the axis, over twice its area and k!/(k + 2)!: the sum of all
//  monomials of that degree
static scalar monomials
(
    const int k,
    const scalar a,
    const scalar b,
    const scalar c
)
{
    scalar sum = 0;
    for (int i = 0; i <= k; i++)
    {
        for (int j = 0; j <= k - i; j++)
        {
            sum += std::pow(a, i)*std::pow(b, j)*std::pow(c, k - i - j);
        }
    }
    return sum;
}


//- The ways in the section (along the axis, away from it) from a point to those
//  that edges join it to
typedef List<vector> waysFromPoint;


//- Adds the ways that are not known yet
struct uniteWays
{
    void operator()(waysFromPoint& ways, const waysFromPoint& others) const
    {
        for (const vector& other : others)
        {
            bool known = false;
            for (const vector& way : ways)
            {
                known = known || magSqr(way - other) < 1e-8*magSqr(other);
            }
            if (!known)
            {
                ways.append(other);
            }
        }
    }
};


//- Positive if b points to the left of a
static scalar leftOf(const vector& a, const vector& b)
{
    return a.x()*b.y() - a.y()*b.x();
}


//- Curvature [1/m] at the far end of an edge that leads to a point, where it
//  goes on in the direction that turns least; 0 where there is none
static scalar curvatureAhead
(
    const vector& edge,
    const waysFromPoint& ways
)
{
    scalar straightest = 0.8;
    scalar curvature = 0;
    for (const vector& way : ways)
    {
        const scalar product = mag(edge)*mag(way);
        if ((edge & way) > straightest*product)
        {
            straightest = (edge & way)/product;
            curvature = 2*leftOf(edge, way)/product/(mag(edge) + mag(way));
        }
    }
    return curvature;
}

} // End namespace Foam


void Foam::gasMesh::setSquareRadii(const vector& side)
{
    const pointField& points = mesh_.points();
    squareRadius_.assign(nSlots(), 0);
    squareRadiusAtFace_.assign(nFaces_, 0);

    const auto between = [&](const face& corners)
    {
        // The mean of r^2 on a line turned about the axis
        scalar least = GREAT;
        scalar most = 0;
        for (const label pointi : corners)
        {
            const scalar r = points[pointi] & side;
            least = min(least, r);
            most = max(most, r);
        }
        return 0.5*(sqr(least) + sqr(most));
    };

    for (label f = 0; f < nInternal_; f++)
    {
        squareRadiusAtFace_[f] = between(mesh_.faces()[meshFace[f]]);
    }
    for (const patchRange& patch : patches_)
    {
        const polyPatch& pp = mesh_.boundaryMesh()[patch.patchi];
        for (label i = 0; i < patch.size; i++)
        {
            const label f = patch.start + i;
            if (!patch.wedge)
            {
                squareRadiusAtFace_[f] = between(pp[i]);
                continue;
            }

            // The face is the section of its cell
            const face& corners = pp[i];
            scalar moment[4] = {0, 0, 0, 0};
            for (label k = 1; k < corners.size() - 1; k++)
            {
                const point& a = points[corners[0]];
                const point& b = points[corners[k]];
                const point& c = points[corners[k + 1]];
                const scalar twiceArea =
                    (((b - a) ^ (c - a)) & pp.faceAreas()[i])
                   /mag(pp.faceAreas()[i]);
                scalar factor = 0.5;
                for (int n = 0; n < 4; n++)
                {
                    moment[n] +=
                        factor*twiceArea
                       *monomials(n, a & side, b & side, c & side);
                    factor *= (n + 1.0)/(n + 3.0);
                }
            }
            squareRadiusAtFace_[f] = moment[2]/moment[0];
            squareRadius_[owner[f]] = moment[3]/moment[1];
        }
    }

    fillGhosts(squareRadius_);
    for (const patchRange& patch : patches_)
    {
        const bool ends = !patch.coupled && !patch.image();
        const label end = patch.start + (ends ? patch.size : 0);
        for (label f = patch.start; f < end; f++)
        {
            squareRadius_[far[f]] = squareRadiusAtFace_[f];
        }
    }
}


void Foam::gasMesh::bendFaces
(
    const vector& along,
    const vector& side,
    const scalar cosine
)
{
    const pointField& points = mesh_.points();
    const vector across(along ^ side);

    // What two sides of a section of 1 m^2 push away from the axis
    const scalar perSection = 2*std::sqrt(1 - sqr(cosine))/cosine;

    // The two points of a face on one side of the wedge
    std::vector<edge> edges(nFaces_, edge(-1, -1));
    const auto findEdge = [&](const face& corners, edge& ends)
    {
        int n = 0;
        for (const label pointi : corners)
        {
            const point& P = points[pointi];
            if ((P & across) > -1e-6*mag(P) && n++ < 2)
            {
                ends[n - 1] = pointi;
            }
        }
        if (n != 2)
        {
            ends = edge(-1, -1);
        }
    };
    for (label f = 0; f < nInternal_; f++)
    {
        findEdge(mesh_.faces()[meshFace[f]], edges[f]);
    }
    for (const patchRange& patch : patches_)
    {
        const polyPatch& pp = mesh_.boundaryMesh()[patch.patchi];
        for (label i = 0; i < patch.size && !patch.wedge; i++)
        {
            findEdge(pp[i], edges[patch.start + i]);
        }
    }

    const auto inSection = [&](const label pointi)
    {
        return vector(points[pointi] & along, points[pointi] & side, 0);
    };
    List<waysFromPoint> ways(points.size());
    for (const edge& ends : edges)
    {
        if (ends.first() >= 0)
        {
            const vector way(inSection(ends[1]) - inSection(ends[0]));
            ways[ends[0]].append(way);
            ways[ends[1]].append(-way);
        }
    }
    syncTools::syncPointList(mesh_, ways, uniteWays(), waysFromPoint());

    // Share by which the section of a cell grows
    std::vector<double> growth(nCells_, 0);
    for (label f = 0; f < nFaces_; f++)
    {
        if (edges[f].first() < 0)
        {
            continue;
        }
        const vector start(inSection(edges[f][0]));
        const vector end(inSection(edges[f][1]));
        const vector way(end - start);

        // On the axis the edge meets its image
        const auto curvature = [&]
        (
            const vector& way,
            const label pointi,
            const vector& place
        )
        {
            return
                place.y() > 1e-6*mag(way)
              ? curvatureAhead(way, ways[pointi])
              : 2*way.x()*way.y()/pow3(mag(way));
        };
        const scalar ahead = curvature(way, edges[f][1], end);
        const scalar behind = -curvature(-way, edges[f][0], start);
        const scalar least =
            ahead*behind > 0 ? sign(ahead)*min(mag(ahead), mag(behind)) : 0;

        // A curve that turns to the left lies on the right of its chord
        const scalar bulge = least*pow3(mag(way))/12;
        double* n = &normal[f*nDim_];
        vector outward(Zero);
        for (int d = 0; d < nDim_; d++)
        {
            outward += n[d]*vector(axis[d], away[d], 0);
        }
        const scalar gain = leftOf(outward, way) > 0 ? bulge : -bulge;
        growth[owner[f]] += gain;
        if (f < nInternal_)
        {
            growth[far[f]] -= gain;
        }

        double size = 0;
        for (int d = 0; d < nDim_; d++)
        {
            n[d] = area[f]*n[d] + perSection*gain*away[d];
            size += sqr(n[d]);
        }
        area[f] = std::sqrt(size);
        for (int d = 0; d < nDim_; d++)
        {
            n[d] /= area[f];
        }
    }

    for (const patchRange& patch : patches_)
    {
        const label end = patch.start + (patch.wedge ? patch.size : 0);
        for (label f = patch.start; f < end; f++)
        {
            area[f] += growth[owner[f]]*(inSection_ ? perSection : 1/cosine);
        }
    }
}


void Foam::gasMesh::fillGhosts(std::vector<double>& values) const
{
    exchange(values.data(), 1);
    for (const patchRange& patch : patches_)
    {
        const label end = patch.start + (patch.image() ? patch.size : 0);
        for (label f = patch.start; f < end; f++)
        {
            values[far[f]] = values[owner[f]];
        }
    }
}


void Foam::gasMesh::checkWedge() const
{
    std::vector<bool> beside(nCells_, false);
    scalar width = 0;
    scalar offset = 0;
    for (const polyPatch& pp : mesh_.boundaryMesh())
    {
        if (!isA<wedgePolyPatch>(pp))
        {
            continue;
        }
        const wedgePolyPatch& plane = refCast<const wedgePolyPatch>(pp);
        forAll(pp, i)
        {
            beside[pp.faceCells()[i]] = true;
            const point C(pp.faceCentres()[i]);
            const vector r(C - (C & plane.axis())*plane.axis());
            width = max(width, mag(r)*std::sqrt(1 - sqr(plane.cosAngle())));
            offset = max(offset, mag(r & plane.n()));
        }
    }
    reduce(width, maxOp<scalar>());
    reduce(offset, maxOp<scalar>());
    if (offset > 1e-3*width)
    {
        FatalErrorInFunction
            << "The axis of the wedge does not go through the origin: one of"
            << " its planes is " << offset << " m away from it." << nl
            << "Move the mesh there (transformPoints -translate)"
            << exit(FatalError);
    }
    for (label c = 0; c < nCells_; c++)
    {
        if (!beside[c])
        {
            FatalErrorInFunction
                << "The cell at " << mesh_.cellCentres()[c] << " touches no"
                << " patch of type wedge: there are more than two layers of"
                << " cells around the axis." << nl
                << "Make one layer of cells between the wedge patches"
                << exit(FatalError);
        }
    }
}


void Foam::gasMesh::setAxis()
{
    if (!wedge())
    {
        return;
    }
    checkWedge();

    const vector along(normalised(wedge()->axis()));
    const vector side(normalised(wedge()->centreNormal() ^ along));
    for (int d = 0; d < nDim_; d++)
    {
        axis.push_back(along[direction_[d]]);
        away.push_back(side[direction_[d]]);
    }

    inverseRadius.assign(nSlots(), 0);
    for (label c = 0; c < nCells_; c++)
    {
        inverseRadius[c] = 1/(mesh_.cellCentres()[meshCell[c]] & side);
    }
    faceRadius.resize(nFaces_);
    for (label f = 0; f < nFaces_; f++)
    {
        faceRadius[f] = 1/inverseRadius[owner[f]];
        for (int d = 0; d < nDim_; d++)
        {
            faceRadius[f] += toFace[f*nDim_ + d]*away[d];
        }
    }
    fillGhosts(inverseRadius);

    const scalar cosine = wedge()->cosAngle();
    bendFaces(along, side, cosine);

    setSquareRadii(side);
}


void Foam::gasMesh::setWays()
{
    alongOwner = delta;
    alongFar = delta;
    evenWeight = weight;
    if (axis.empty())
    {
        return;
    }

    // Component away from the axis of nDim values per face
    const auto outward = [&](const std::vector<double>& way, const label f)
    {
        double sum = 0;
        for (int d = 0; d < nDim_; d++)
        {
            sum += way[f*nDim_ + d]*away[d];
        }
        return sum;
    };
    const auto lengthen =
        [&](std::vector<double>& way, const label f, const double more)
    {
        for (int d = 0; d < nDim_; d++)
        {
            way[f*nDim_ + d] += more*away[d];
        }
    };

    // The inverse of the gradient of r^2, as the least squares have it
    std::vector<double> inverse(nSlots(), 0);
    for (label c = 0; c < nCells_; c++)
    {
        double gradient = 0;
        for (int i = cellStart[c]; i < cellStart[c + 1]; i++)
        {
            gradient +=
                outward(lsqVector, i)
               *(squareRadius_[neighbour[i]] - squareRadius_[c]);
        }
        inverse[c] = 1/max(gradient, 1/inverseRadius[c]);
    }
    fillGhosts(inverse);

    for (label f = 0; f < nFaces_; f++)
    {
        const int o = owner[f];
        const int r = far[f];
        const double toFaceRise = squareRadiusAtFace_[f] - squareRadius_[o];
        if (gasBehind[f])
        {
            const double rise = squareRadius_[r] - squareRadius_[o];
            const double straight = outward(delta, f);
            lengthen(alongOwner, f, inverse[o]*rise - straight);
            lengthen(alongFar, f, inverse[r]*rise - straight);

            // Of the way across the face
            const double across = outward(normal, f);
            const double perRise = 0.5*across/faceRadius[f];
            double part = perRise*toFaceRise;
            double whole = perRise*rise;
            for (int d = 0; d < nDim_; d++)
            {
                const double n = normal[f*nDim_ + d] - across*away[d];
                part += n*toFace[f*nDim_ + d];
                whole += n*delta[f*nDim_ + d];
            }
            evenWeight[f] =
                min(max(part/stabilise(whole, VSMALL), 0.0), 1.0);
        }
        lengthen(toFace, f, inverse[o]*toFaceRise - outward(toFace, f));
    }
}
