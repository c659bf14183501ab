/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "gasEquations.H"
#include <algorithm>

namespace Foam
{

//- Whether the pressure rises along the flow by a large part of itself within
//  the distance delta between two cells: the face lies in a shock
template<int nDim>
inline bool inShock
(
    const double* owner,
    const double* far,
    const double* gradientOwner,
    const double* gradientFar,
    const double* delta
)
{
    double gg[2] = {0, 0};
    double dd = 0;
    double ug[2] = {0, 0};
    for (int d = 0; d < nDim; d++)
    {
        const double g0 = gradientOwner[d*(nDim + 2)];
        const double g1 = gradientFar[d*(nDim + 2)];
        gg[0] += g0*g0;
        gg[1] += g1*g1;
        ug[0] += owner[2 + d]*g0;
        ug[1] += far[2 + d]*g1;
        dd += delta[d]*delta[d];
    }
    return
        max(ug[0] > 0 ? gg[0] : 0, ug[1] > 0 ? gg[1] : 0)*dd
      > sqr(0.2*min(owner[0], far[0]));
}

} // End namespace Foam


template<int nDim>
void Foam::gasEquations::gradients()
{
    constexpr int nVar = nDim + 2;
    const label nInternal = geometry_.nInternal();
    const label nFaces = geometry_.nFaces();

    std::fill(gradient_.begin(), gradient_.end(), 0);

    const double* __restrict q = primitive.data();
    double* __restrict g = gradient_.data();

    for (label f = 0; f < nFaces; f++)
    {
        const double* qo = q + geometry_.owner[f]*nVar;
        const double* qf = q + geometry_.far[f]*nVar;
        double jump[nVar];
        for (int k = 0; k < nVar; k++)
        {
            jump[k] = qf[k] - qo[k];
        }

        double* go = g + geometry_.owner[f]*(nVar*nDim);
        const double* lo = &geometry_.lsqOwner[f*nDim];
        for (int d = 0; d < nDim; d++)
        {
            for (int k = 0; k < nVar; k++)
            {
                go[d*nVar + k] += lo[d]*jump[k];
            }
        }

        if (f < nInternal)
        {
            double* gf = g + geometry_.far[f]*(nVar*nDim);
            const double* lf = &geometry_.lsqFar[f*nDim];
            for (int d = 0; d < nDim; d++)
            {
                for (int k = 0; k < nVar; k++)
                {
                    gf[d*nVar + k] += lf[d]*jump[k];
                }
            }
        }
    }

    geometry_.exchange(g, nVar*nDim);
}


void Foam::gasEquations::replaceFluxes
(
    faceBlock& block,
    const int n,
    const bool* which
) const
{
    double keep[faceBlock::maxVar][faceBlock::size];
    std::copy(&block.flux[0][0], &block.flux[nVar_ - 1][0] + n, &keep[0][0]);

    robustFlux_(block, n, closure_);

    for (int k = 0; k < nVar_; k++)
    {
        for (int i = 0; i < n; i++)
        {
            block.flux[k][i] = which[i] ? block.flux[k][i] : keep[k][i];
        }
    }
}


template<int nDim>
void Foam::gasEquations::innerFluxes()
{
    constexpr int nVar = nDim + 2;
    const double* __restrict q = primitive.data();
    const double* __restrict g = gradient_.data();
    faceBlock block;

    //- Mass fluxes of the faces in hand, those of face f at massFlux[f]
    scalar* massFlux = phi_.begin();

    auto blockOfFaces = [&](const label first, const int n)
    {
        bool troubledBlock = false;
        bool troubledFace[faceBlock::size];
        bool shockedBlock = false;
        bool shock[faceBlock::size];

        for (int i = 0; i < n; i++)
        {
            const label f = first + i;
            const int o = geometry_.owner[f];
            const int r = geometry_.far[f];
            const double* qo = q + o*nVar;
            const double* qr = q + r*nVar;
            const double* go = g + o*(nVar*nDim);
            const double* gr = g + r*(nVar*nDim);
            const double* delta = &geometry_.delta[f*nDim];
            double so[nVar];
            double sr[nVar];
            for (int k = 0; k < nVar; k++)
            {
                so[k] = 2*delta[0]*go[k];
                sr[k] = 2*delta[0]*gr[k];
            }
            for (int d = 1; d < nDim; d++)
            {
                for (int k = 0; k < nVar; k++)
                {
                    so[k] += 2*delta[d]*go[d*nVar + k];
                    sr[k] += 2*delta[d]*gr[d*nVar + k];
                }
            }
            for (int k = 0; k < nVar; k++)
            {
                block.owner[k][i] = qo[k];
                block.far[k][i] = qr[k];
                block.slopeOwner[k][i] = so[k];
                block.slopeFar[k][i] = sr[k];
            }
            block.weight[i] = geometry_.weight[f];
            for (int d = 0; d < nDim; d++)
            {
                block.normal[d][i] = geometry_.normal[f*nDim + d];
            }
            shock[i] =
                sensesShocks_
             && (
                    (shocksStay_ && shocked_[f])
                 || inShock<nDim>(qo, qr, go, gr, delta)
                );
            shocked_[f] = shock[i];
            shockedBlock = shockedBlock || shock[i];
            troubledFace[i] = anyTroubled_ && (troubled_[o] || troubled_[r]);
            troubledBlock = troubledBlock || troubledFace[i];
        }

        for (const variableLimiter& limiter : reconstruction_)
        {
            limiter.reconstruct(block, n, limiter.first, limiter.end);
        }
        flux_(block, n, closure_);

        if (shockedBlock)
        {
            if (roughShocks_)
            {
                firstOrder_(block, n, 0, nVar);
            }
            replaceFluxes(block, n, shock);
        }
        if (troubledBlock)
        {
            firstOrder_(block, n, 0, nVar);
            replaceFluxes(block, n, troubledFace);
        }

        for (int i = 0; i < n; i++)
        {
            const label f = first + i;
            const double S = geometry_.area[f];
            double* ro = &rate[geometry_.owner[f]*nVar];
            massFlux[f] = block.flux[0][i]*S;
            if (f < geometry_.nInternal())
            {
                double* rf = &rate[geometry_.far[f]*nVar];
                for (int k = 0; k < nVar; k++)
                {
                    const double F = block.flux[k][i]*S;
                    ro[k] -= F;
                    rf[k] += F;
                }
            }
            else
            {
                for (int k = 0; k < nVar; k++)
                {
                    ro[k] -= block.flux[k][i]*S;
                }
            }
        }
    };

    auto range = [&](label first, const label end)
    {
        for (; first < end; first += faceBlock::size)
        {
            blockOfFaces(first, min(label(faceBlock::size), end - first));
        }
    };

    range(0, geometry_.nInternal());
    for (const gasMesh::patchRange& patch : geometry_.patches())
    {
        if (patch.coupled)
        {
            massFlux =
                phi_.boundaryFieldRef()[patch.patchi].begin() - patch.start;
            range(patch.start, patch.start + patch.size);
        }
    }
}


template<int nDim>
void Foam::gasEquations::boundaryFluxes()
{
    constexpr int nVar = nDim + 2;

    label k = -1;
    for (const gasMesh::patchRange& patch : geometry_.patches())
    {
        k++;
        if (patch.coupled)
        {
            continue;
        }
        scalarField& phip = phi_.boundaryFieldRef()[patch.patchi];

        for (label i = 0; i < patch.size; i++)
        {
            const label f = patch.start + i;
            const label c = geometry_.owner[f];
            const double* n = &geometry_.normal[f*nDim];
            const double S = geometry_.area[f];
            double q[nVar];
            std::copy_n(&primitive[geometry_.far[f]*nVar], nVar, q);
            double flux[nVar];
            double un;

            if (impermeable(k, f, un) && (reconstructed_[k] || tight_[k]))
            {
                wallPressure(f, q[0]);
            }
            if (un == 0)
            {
                flux[0] = 0;
                flux[1] = 0;
                for (int d = 0; d < nDim; d++)
                {
                    flux[2 + d] = q[0]*n[d];
                }
            }
            else
            {
                exactFlux(q, n, nDim, closure_, flux);
            }

            phip[i] = flux[0]*S;
            for (int j = 0; j < nVar; j++)
            {
                rate[c*nVar + j] -= flux[j]*S;
            }
        }
    }
}


template void Foam::gasEquations::gradients<2>();
template void Foam::gasEquations::gradients<3>();
template void Foam::gasEquations::innerFluxes<2>();
template void Foam::gasEquations::innerFluxes<3>();
template void Foam::gasEquations::boundaryFluxes<2>();
template void Foam::gasEquations::boundaryFluxes<3>();
