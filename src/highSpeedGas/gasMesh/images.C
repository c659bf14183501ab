/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "gasMesh.H"
#include "wedgePolyPatch.H"
#include "mathematicalConstants.H"

void Foam::gasMesh::setSectionImage
(
    const label f,
    const vector& r,
    const bool onAxis
)
{
    // Off the axis the images of the sides say nothing of what changes within
    // the section. On it they are those of setImages, turned by 120 degrees
    // to both sides, as the section sees them.
    const double share = onAxis ? 1.5 : 0;
    lsqWeight_[f] = onAxis ? 11.0/16 : 0;
    normalDistance[f] = mag(r);
    double* m = &image_[(f - nInternal_)*nDim_*nDim_];
    for (int d = 0; d < nDim_; d++)
    {
        const double rd = r[direction_[d]];
        delta[f*nDim_ + d] = -share*rd;
        radial_[(f - nInternal_)*nDim_ + d] = rd/mag(r);
        for (int k = 0; k < nDim_; k++)
        {
            m[d*nDim_ + k] =
                (d == k) - share*rd*r[direction_[k]]/magSqr(r);
        }
    }
}


void Foam::gasMesh::setImages()
{
    lsqWeight_.assign(nFaces_, 1);
    image_.assign((nFaces_ - nInternal_)*nDim_*nDim_, 0);
    radial_.assign((nFaces_ - nInternal_)*nDim_, 0);

    const pointField& points = mesh_.points();

    for (const patchRange& patch : patches_)
    {
        if (!patch.image())
        {
            continue;
        }
        const fvPatch& fvp = mesh_.boundary()[patch.patchi];

        for (label i = 0; i < patch.size; i++)
        {
            const label f = patch.start + i;
            const vector n(fvp.Sf()[i]/fvp.magSf()[i]);
            tensor M(tensor::I - 2*n*n);

            if (patch.wedge)
            {
                const wedgePolyPatch& wedge =
                    refCast<const wedgePolyPatch>(fvp.patch());
                const vector axis(normalised(wedge.axis()));
                const vector C(mesh_.cellCentres()[meshCell[owner[f]]]);
                const vector r(C - (C & axis)*axis);

                scalar nearest = GREAT;
                for (const label pointi : wedge[i])
                {
                    const point& P = points[pointi];
                    nearest = min(nearest, mag(P - (P & axis)*axis));
                }
                const bool onAxis = nearest < 1e-4*mag(r);
                if (inSection_)
                {
                    setSectionImage(f, r, onAxis);
                    continue;
                }

                // Rodrigues' rotation from the owner to outside the face
                const scalar side = sign((axis ^ r) & n);
                const scalar sine = mag(r & n)/mag(r);
                const scalar angle =
                    side*(onAxis ? 2.0/3*constant::mathematical::pi
                                 : 2*std::asin(sine));
                const tensor K
                (
                    0, -axis.z(), axis.y(),
                    axis.z(), 0, -axis.x(),
                    -axis.y(), axis.x(), 0
                );
                M = tensor::I + std::sin(angle)*K
                  + (1 - std::cos(angle))*(K & K);

                vector toImage((M & r) - r);
                if (onAxis)
                {
                    // The gradient of the square of the radius is then exact
                    // if the next cell is as high
                    lsqWeight_[f] = 11.0/24;
                }
                else
                {
                    toImage -= (toImage & r)*r/magSqr(r);
                }
                for (int d = 0; d < nDim_; d++)
                {
                    delta[f*nDim_ + d] = toImage[direction_[d]];
                    radial_[(f - nInternal_)*nDim_ + d] =
                        r[direction_[d]]/mag(r);
                }
            }

            double* m = &image_[(f - nInternal_)*nDim_*nDim_];
            for (int d = 0; d < nDim_; d++)
            {
                for (int k = 0; k < nDim_; k++)
                {
                    m[d*nDim_ + k] = M(direction_[d], direction_[k]);
                }
            }
        }
    }
}


void Foam::gasMesh::setTurning()
{
    around_.assign(radial_.size(), 0);
    for (const patchRange& patch : patches_)
    {
        const label n = patch.wedge && !inSection_ ? patch.size : 0;
        for (label f = patch.start; f < patch.start + n; f++)
        {
            const double* r = radial(f);
            double nr = 0;
            for (int d = 0; d < nDim_; d++)
            {
                nr += normal[f*nDim_ + d]*r[d];
            }
            const double inverse = 1/std::sqrt(1 - nr*nr);
            for (int d = 0; d < nDim_; d++)
            {
                around_[(f - nInternal_)*nDim_ + d] =
                    (normal[f*nDim_ + d] - nr*r[d])*inverse;
            }
        }
    }
}


void Foam::gasMesh::reflect(double* states) const
{
    const int nVar = nDim_ + 2;
    for (const patchRange& patch : patches_)
    {
        if (!patch.image())
        {
            continue;
        }
        for (label f = patch.start; f < patch.start + patch.size; f++)
        {
            const double* q = &states[owner[f]*nVar];
            const double* m = &image_[(f - nInternal_)*nDim_*nDim_];
            double* ghost = &states[far[f]*nVar];
            ghost[0] = q[0];
            ghost[1] = q[1];
            for (int d = 0; d < nDim_; d++)
            {
                double sum = 0;
                for (int k = 0; k < nDim_; k++)
                {
                    sum += m[d*nDim_ + k]*q[2 + k];
                }
                ghost[2 + d] = sum;
            }
        }
    }
}


void Foam::gasMesh::reflectGradients(double* gradients) const
{
    const int nVar = nDim_ + 2;
    for (const patchRange& patch : patches_)
    {
        if (!patch.symmetry)
        {
            continue;
        }
        for (label f = patch.start; f < patch.start + patch.size; f++)
        {
            const double* g = &gradients[owner[f]*nVar*nDim_];
            const double* m = &image_[(f - nInternal_)*nDim_*nDim_];
            double* ghost = &gradients[far[f]*nVar*nDim_];

            // The direction of the derivative, then the vector
            for (int d = 0; d < nDim_; d++)
            {
                double turned[5];
                for (int k = 0; k < nVar; k++)
                {
                    turned[k] = 0;
                    for (int e = 0; e < nDim_; e++)
                    {
                        turned[k] += m[d*nDim_ + e]*g[e*nVar + k];
                    }
                }
                ghost[d*nVar] = turned[0];
                ghost[d*nVar + 1] = turned[1];
                for (int k = 0; k < nDim_; k++)
                {
                    double sum = 0;
                    for (int e = 0; e < nDim_; e++)
                    {
                        sum += m[k*nDim_ + e]*turned[2 + e];
                    }
                    ghost[d*nVar + 2 + k] = sum;
                }
            }
        }
    }
}
