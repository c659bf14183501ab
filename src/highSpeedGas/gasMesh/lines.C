/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "gasMesh.H"
#include "cyclicAMIPolyPatch.H"
#include "syncTools.H"

namespace Foam
{

//- The ways out of one cell to the cells behind its faces
class waysOut
{
    const gasMesh& mesh_;

    //- From the owner to the far cell, as these two see it
    const std::vector<double>& fromOwner_;
    const std::vector<double>& toFar_;

    const int cell_;
    const int n_;

public:

    waysOut
    (
        const gasMesh& mesh,
        const std::vector<double>& fromOwner,
        const std::vector<double>& toFar,
        const int cell
    )
    :
        mesh_(mesh),
        fromOwner_(fromOwner),
        toFar_(toFar),
        cell_(cell),
        n_(mesh.nDim())
    {}

    const int* begin() const
    {
        return mesh_.faceOf.data() + mesh_.cellStart[cell_];
    }

    const int* end() const
    {
        return mesh_.faceOf.data() + mesh_.cellStart[cell_ + 1];
    }

    //- 1 if the normal of a face leads out of the cell, else -1
    int outward(const int f) const
    {
        return mesh_.owner[f] == cell_ ? 1 : -1;
    }

    //- The way through a face, from the owner to the far cell
    const double* through(const int f) const
    {
        return &(outward(f) > 0 ? fromOwner_ : toFar_)[f*n_];
    }

    double distance(const int f) const
    {
        return length(through(f));
    }

    //- Component of the way through a face in the direction of a vector
    double along(const int f, const double* v) const
    {
        double sum = 0;
        for (int d = 0; d < n_; d++)
        {
            sum += through(f)[d]*v[d];
        }
        return outward(f)*sum;
    }

    double length(const double* v) const
    {
        double square = 0;
        for (int d = 0; d < n_; d++)
        {
            square += sqr(v[d]);
        }
        return std::sqrt(square);
    }

    //- Make a vector one of length one, and return how long it was
    double normalise(double* v) const
    {
        const double magnitude = length(v);
        for (int d = 0; d < n_; d++)
        {
            v[d] /= max(magnitude, VSMALL);
        }
        return magnitude;
    }

    //- Number of faces on the other side of the cell from face f, the last of
    //  them, and their direction
    int acrossFrom(const int f, int& last, double* direction) const
    {
        // The cosine of the angle between two ways out of a cell that lie on
        // one line. On hexahedra it is -0.9 and less, a face between one
        // coarse and four fine cells included; on the axis of a wedge, where
        // the images are turned by 120 degrees, -0.87; on regular tetrahedra
        // it is -1/3.
        const double opposite = -0.8;

        int nAcross = 0;
        std::fill_n(direction, n_, 0);
        for (const int g : *this)
        {
            const double cosine =
                outward(f)*along(g, through(f))
               /(distance(f)*distance(g));
            if (cosine <= opposite)
            {
                last = g;
                nAcross++;
                for (int d = 0; d < n_; d++)
                {
                    direction[d] +=
                        outward(g)*through(g)[d]/distance(g);
                }
            }
        }
        normalise(direction);
        return nAcross;
    }

    //- Whether the gas goes on across the cell from face f to the axis of a
    //  wedge, where lines end at an angle to it and have no centre across
    bool endsOnAxis(const int f, const std::vector<bool>& isWedge) const
    {
        for (const int g : *this)
        {
            if
            (
                isWedge[g]
             && outward(f)*along(g, through(f))
              < -0.2*distance(f)*distance(g)
            )
            {
                return true;
            }
        }
        return false;
    }

    //- Distance to the next cell in a direction or against it, GREAT if there
    //  is none
    double height(const double* direction) const
    {
        double minDistance = GREAT;
        for (const int g : *this)
        {
            const double separation = distance(g);
            if
            (
                mesh_.gasBehind[g]
             && std::abs(along(g, direction)) > 0.7*separation
            )
            {
                minDistance = min(minDistance, separation);
            }
        }
        return minDistance;
    }

    //- The way through face f along the line of cells whose other direction
    //  is back, from the owner to the far cell
    void bent(const int f, const double* back, double* way) const
    {
        const double separation = distance(f);
        double tangent[3];
        double bend[3];
        for (int d = 0; d < n_; d++)
        {
            tangent[d] = outward(f)*way[d]/separation - back[d];
        }
        normalise(tangent);
        for (int d = 0; d < n_; d++)
        {
            bend[d] = outward(f)*separation*tangent[d] - way[d];
        }
        const double bendSize = normalise(bend);

        // All of the bend where it is more than the height of a cell. Where
        // the line hardly bends the straight way is better, with which a
        // velocity that is linear in space, as at a stagnation point, has no
        // limited slopes.
        const double x = pow4(min(5*bendSize/height(bend), 50.0));
        for (int d = 0; d < n_; d++)
        {
            way[d] += x/(1 + x)*bendSize*bend[d];
        }
    }
};

} // End namespace Foam


void Foam::gasMesh::setGasBehind()
{
    gasBehind.assign(nFaces_, 0);
    std::fill_n(gasBehind.begin(), nInternal_, 1);
    for (const patchRange& patch : patches_)
    {
        std::fill_n
        (
            gasBehind.begin() + patch.start,
            patch.size,
            patch.coupled || patch.symmetry
        );
    }
}


void Foam::gasMesh::setLines()
{
    std::vector<bool> isWedge(nFaces_, false);
    for (const patchRange& patch : patches_)
    {
        std::fill_n(isWedge.begin() + patch.start, patch.size, patch.wedge);
    }

    const std::vector<double> fromOwner(alongOwner);
    const std::vector<double> toFar(alongFar);
    unaligned.clear();
    isUnaligned.assign(nCells_, 0);
    for (label c = 0; c < nCells_; c++)
    {
        const waysOut ways(*this, fromOwner, toFar, c);
        // (nothing lies across from a face of a tetrahedron or triangle)
        bool onLines = ways.end() - ways.begin() != nDim_ + 1;
        for (const int f : ways)
        {
            if (!gasBehind[f])
            {
                continue;
            }
            int g = -1;
            double back[3];
            const int nAcross = ways.acrossFrom(f, g, back);
            onLines =
                onLines && (nAcross > 0 || ways.endsOnAxis(f, isWedge));

            // A line has one cell on either side
            int h = -1;
            double ahead[3];
            if
            (
                nAcross == 1 && gasBehind[g]
             && ways.acrossFrom(g, h, ahead) == 1
            )
            {
                std::vector<double>& way =
                    ways.outward(f) > 0 ? alongOwner : alongFar;
                ways.bent(f, back, &way[f*nDim_]);
            }
        }
        if (!onLines)
        {
            unaligned.push_back(c);
            isUnaligned[c] = 1;
        }
    }
    anyUnaligned = returnReduce(!unaligned.empty(), orOp<bool>());
    setLinesBehind();
}


void Foam::gasMesh::setLinesBehind()
{
    const polyBoundaryMesh& boundary = mesh_.boundaryMesh();

    // What the cells behind coupled patches see as owners
    vectorField behind(mesh_.nBoundaryFaces(), Zero);
    for (const patchRange& patch : patches_)
    {
        const label first = boundary[patch.patchi].start() - nInternal_;
        for (label i = 0; i < patch.size; i++)
        {
            for (int d = 0; d < nDim_; d++)
            {
                behind[first + i][d] =
                    alongOwner[(patch.start + i)*nDim_ + d];
            }
        }
    }
    syncTools::swapBoundaryFaceList(mesh_, behind);

    for (const patchRange& patch : patches_)
    {
        const polyPatch& pp = boundary[patch.patchi];
        const bool faceToFace =
            patch.coupled && !isA<cyclicAMIPolyPatch>(pp);
        for (label i = 0; i < patch.size; i++)
        {
            const label f = patch.start + i;
            const double* m = &image_[(f - nInternal_)*nDim_*nDim_];
            for (int d = 0; d < nDim_; d++)
            {
                double& way = alongFar[f*nDim_ + d];
                if (faceToFace)
                {
                    way = -behind[pp.start() - nInternal_ + i][d];
                }
                else if (patch.symmetry)
                {
                    way = 0;
                    for (int k = 0; k < nDim_; k++)
                    {
                        way -= m[d*nDim_ + k]*alongOwner[f*nDim_ + k];
                    }
                }
            }
        }
    }
}
