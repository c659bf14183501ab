/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "slipWallShear.H"

void Foam::slipWallShear::set(const gasMesh& geometry, const boolList& walls)
{
    const int nDim = geometry.nDim();
    cells_.clear();
    for (const gasMesh::patchRange& patch : geometry.patches())
    {
        const label end =
            patch.start + (walls[patch.patchi] ? patch.size : 0);
        for (label f = patch.start; f < end; f++)
        {
            // The cell most nearly opposite to the wall
            const int c = geometry.owner[f];
            wallCell found{c, -1, {}};
            std::copy_n(&geometry.normal[f*nDim], nDim, found.normal);
            double straightest = 0.7;
            for
            (
                int i = geometry.cellStart[c];
                i < geometry.cellStart[c + 1] && !geometry.isUnaligned[c];
                i++
            )
            {
                const int other = geometry.faceOf[i];
                const bool own = geometry.owner[other] == c;
                double inwards = 0;
                double distanceSqr = 0;
                for (int d = 0; d < nDim; d++)
                {
                    const double x =
                        (own ? 1 : -1)*geometry.delta[other*nDim + d];
                    inwards -= x*found.normal[d];
                    distanceSqr += x*x;
                }
                const double straight = inwards/std::sqrt(distanceSqr);
                if (geometry.gasBehind[other] && straight > straightest)
                {
                    straightest = straight;
                    found.inner =
                        own ? geometry.far[other] : geometry.owner[other];
                }
            }
            if (found.inner >= 0)
            {
                cells_.push_back(found);
            }
        }
    }
    excess_.resize(cells_.size()*nDim);
    used_ = returnReduce(cells_.size() > 0, orOp<bool>());
}


template<int nDim>
void Foam::slipWallShear::limit(double* gradient)
{
    constexpr int nVar = nDim + 2;

    // The next cell may stand at a wall as well: nothing is changed before all
    // is known
    double* excess = excess_.data();
    for (const wallCell& at : cells_)
    {
        const auto shear = [&at, gradient](const int slot, double* along)
        {
            const double* g = &gradient[slot*nVar*nDim];
            double through = 0;
            for (int k = 0; k < nDim; k++)
            {
                along[k] = 0;
                for (int d = 0; d < nDim; d++)
                {
                    along[k] += g[d*nVar + 2 + k]*at.normal[d];
                }
                through += along[k]*at.normal[k];
            }
            for (int k = 0; k < nDim; k++)
            {
                along[k] -= through*at.normal[k];
            }
        };
        double here[nDim];
        double inner[nDim];
        shear(at.cell, here);
        shear(at.inner, inner);
        double square = 0;
        double product = 0;
        for (int k = 0; k < nDim; k++)
        {
            square += here[k]*here[k];
            product += here[k]*inner[k];
        }
        const double ratio = square > 0 ? product/square : 1;
        const double most = max(0.0, min(ratio, 1.0));
        const double rough =
            max(0.0, min((std::fabs(ratio - 1) - 0.05)/0.25, 1.0));
        const double share = rough*min(most, 0.5) + (1 - rough)*most;
        for (int k = 0; k < nDim; k++)
        {
            *excess++ = (1 - share)*here[k];
        }
    }

    excess = excess_.data();
    for (const wallCell& at : cells_)
    {
        double* g = &gradient[at.cell*nVar*nDim];
        for (int d = 0; d < nDim; d++)
        {
            for (int k = 0; k < nDim; k++)
            {
                g[d*nVar + 2 + k] -= excess[k]*at.normal[d];
            }
        }
        excess += nDim;
    }
}


template void Foam::slipWallShear::limit<2>(double*);
template void Foam::slipWallShear::limit<3>(double*);
