/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "gasMesh.H"

void Foam::gasMesh::setLeastSquares(const boolList& excluded)
{
    std::vector<bool> takesPart(nFaces_, true);
    for (const patchRange& patch : patches_)
    {
        for (label i = 0; i < patch.size; i++)
        {
            takesPart[patch.start + i] = !excluded[patch.patchi];
        }
    }

    std::vector<symmTensor> moment(nCells_, symmTensor::zero);

    auto deltaOf = [&](const label f)
    {
        vector d(Zero);
        for (int k = 0; k < nDim_; k++)
        {
            d[k] = delta[f*nDim_ + k];
        }
        return d;
    };

    for (label f = 0; f < nFaces_; f++)
    {
        if (takesPart[f])
        {
            const vector d(deltaOf(f));
            const symmTensor dd(lsqWeight_[f]*sqr(d)/magSqr(d));
            moment[owner[f]] += dd;
            if (f < nInternal_)
            {
                moment[far[f]] += dd;
            }
        }
    }

    flat.assign(nCells_, 0);
    for (const int c : unaligned)
    {
        const symmTensor& m = moment[c];
        const vector spread
        (
            nDim_ == 3
          ? eigenValues(m)
          : eigenValues
            (
                symmTensor(m.xx(), m.xy(), 0, m.yy(), 0, 4*(m.xx() + m.yy()))
            )
        );
        // (in ascending order)
        flat[c] = spread[0] < 0.1*spread[nDim_ - 1];
    }

    // Directions in which a cell has no neighbours get no gradient: the
    // moment of a unit stencil there keeps the matrix regular without adding
    // to the gradient
    for (label c = 0; c < nCells_; c++)
    {
        symmTensor& m = moment[c];
        if (nDim_ == 2)
        {
            m.zz() += 1;
        }
        vector d(m.xx(), m.yy(), m.zz());
        const scalar small = 1e-8*cmptMax(d);
        if (m.xx() < small) m.xx() = 1;
        if (m.yy() < small) m.yy() = 1;
        if (m.zz() < small) m.zz() = 1;
        if (det(m) < 1e-10*m.xx()*m.yy()*m.zz())
        {
            // All neighbours on one line that is not a coordinate axis
            m += 1e-6*cmptMax(d)*symmTensor::I;
        }
    }

    lsqOwner.assign(nFaces_*nDim_, 0);
    lsqFar.assign(nFaces_*nDim_, 0);

    std::vector<symmTensor> inverse(nCells_);
    for (label c = 0; c < nCells_; c++)
    {
        inverse[c] = inv(moment[c]);
    }

    for (label f = 0; f < nFaces_; f++)
    {
        if (takesPart[f])
        {
            const vector d(deltaOf(f));
            const vector lo
            (
                (inverse[owner[f]] & d)*lsqWeight_[f]/magSqr(d)
            );
            const vector lf
            (
                f < nInternal_
              ? (inverse[far[f]] & d)/magSqr(d)
              : vector(Zero)
            );
            for (int k = 0; k < nDim_; k++)
            {
                lsqOwner[f*nDim_ + k] = lo[k];
                lsqFar[f*nDim_ + k] = lf[k];
            }
        }
    }
}
