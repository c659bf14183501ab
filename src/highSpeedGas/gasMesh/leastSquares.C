/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "gasMesh.H"

Foam::symmTensor Foam::gasMesh::unseen
(
    const label c,
    const std::vector<bool>& takesPart
) const
{
    // A wall face alone gives a half. A row of cells whose centres lie off a
    // line by less than a sixth of its width gives less than this
    const scalar least = 0.1;

    const spread neighbours(spreadOf(c, takesPart));
    symmTensor sum(Zero);
    for (int k = 0; k < nDim_; k++)
    {
        if (neighbours.ratio[k] < least)
        {
            sum += sqr(neighbours.across[k]);
        }
    }
    return sum;
}


void Foam::gasMesh::setLeastSquares(const boolList& excluded)
{
    std::vector<bool> takesPart(nFaces_, true);
    for (const patchRange& patch : patches_)
    {
        for (label i = 0; i < patch.size; i++)
        {
            const label f = patch.start + i;
            takesPart[f] = !excluded[patch.patchi] && lsqWeight_[f] > 0;
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

    lsqVector.assign(faceOf.size()*nDim_, 0);

    // Directions in which a cell has no neighbours get no gradient: the
    // moment of a unit stencil there keeps the matrix regular without adding
    // to the gradient
    for (label c = 0; c < nCells_; c++)
    {
        symmTensor m(moment[c]);
        if (nDim_ == 2)
        {
            m.zz() += 1;
        }
        vector d(m.xx(), m.yy(), m.zz());
        const scalar small = 1e-8*cmptMax(d);
        if (m.xx() < small) m.xx() = 1;
        if (m.yy() < small) m.yy() = 1;
        if (m.zz() < small) m.zz() = 1;
        // Or nearly none: of most cells the determinant says that there are
        if (det(m) < 0.05*pow3(max(cmptMax(d), scalar(1))))
        {
            m += unseen(c, takesPart);
        }

        const symmTensor inverse(inv(m));
        for (int i = cellStart[c]; i < cellStart[c + 1]; i++)
        {
            const int f = faceOf[i];
            if (takesPart[f])
            {
                const vector d(deltaOf(f));
                vector l((inverse & d)/magSqr(d));
                l *= owner[f] == c ? lsqWeight_[f] : -1;
                for (int k = 0; k < nDim_; k++)
                {
                    lsqVector[i*nDim_ + k] = l[k];
                }
            }
        }
    }

    setWays();
    setLines();
    setWideGradients(takesPart);
}
