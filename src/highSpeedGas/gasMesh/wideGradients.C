/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "gasMesh.H"
#include <Eigen/Eigenvalues>

Foam::gasMesh::spread Foam::gasMesh::spreadOf
(
    const label c,
    const std::vector<bool>& takesPart
) const
{
    // How far neighbours lie away in each direction is measured by how far the
    // faces do, so that cells may be stretched
    typedef Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, 3, 3>
        matrix;
    typedef Eigen::Matrix<double, Eigen::Dynamic, 1, 0, 3, 1> way;
    typedef Eigen::Map<const way> view;

    matrix faces(matrix::Zero(nDim_, nDim_));
    matrix neighbours(faces);
    for (int i = cellStart[c]; i < cellStart[c + 1]; i++)
    {
        const int f = faceOf[i];
        const view through(&delta[f*nDim_], nDim_);
        const view fromOwner(&toFace[f*nDim_], nDim_);
        const way toCentre(fromOwner - (owner[f] == c ? 0 : 1)*through);
        faces += toCentre*toCentre.transpose();
        if (takesPart[f])
        {
            neighbours += lsqWeight_[f]*through*through.transpose();
        }
    }

    // (in ascending order)
    const Eigen::GeneralizedSelfAdjointEigenSolver<matrix> solver
    (
        neighbours, faces
    );
    spread result;
    for (int k = 0; k < nDim_; k++)
    {
        result.ratio[k] = solver.eigenvalues()[k];
        for (int d = 0; d < nDim_; d++)
        {
            result.across[k][d] = solver.eigenvectors()(d, k);
        }
        result.across[k] = normalised(result.across[k]);
    }
    return result;
}


bool Foam::gasMesh::isFlat
(
    const label c,
    const std::vector<bool>& takesPart
) const
{
    // (of a regular tetrahedron with one face on a wall a quarter)
    const spread neighbours(spreadOf(c, takesPart));
    return neighbours.ratio[0] < 0.1*neighbours.ratio[nDim_ - 1];
}


void Foam::gasMesh::setWideGradients(const std::vector<bool>& takesPart)
{
    std::vector<double> known(nCells_ + nFaces_ - nInternal_, 1);
    flat.assign(nCells_, 0);
    for (const int c : unaligned)
    {
        flat[c] = isFlat(c, takesPart);
        known[c] = 1 - flat[c];
    }
    exchange(known.data(), 1);
    for (const patchRange& patch : patches_)
    {
        const label end = patch.start + (patch.image() ? patch.size : 0);
        for (label f = patch.start; f < end; f++)
        {
            known[far[f]] = known[owner[f]];
        }
    }

    wideStart.assign(1, 0);
    wideCell.clear();
    wideShare.clear();
    for (const int c : unaligned)
    {
        for (int i = cellStart[c]; i < cellStart[c + 1]; i++)
        {
            const int f = faceOf[i];
            const int other = owner[f] == c ? far[f] : owner[f];
            if (gasBehind[f] && known[other] > 0.5)
            {
                wideCell.push_back(other);
            }
        }
        const int n = int(wideCell.size()) - wideStart.back();
        const double own = flat[c] ? 0 : n ? 0.5 : 1;
        wideShare.resize(wideCell.size(), (1 - own)/max(n, 1));
        if (own > 0)
        {
            wideCell.push_back(c);
            wideShare.push_back(own);
        }
        wideStart.push_back(int(wideCell.size()));
    }
}
