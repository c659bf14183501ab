/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "gasEquations.H"
#include "expansion.H"
#include "faceRows.H"
#include "gradients.H"
#include <algorithm>

//- What the faces of a block are besides their values
struct Foam::gasEquations::faceState
{
    //- Share in a shock and in a strong one, that in which cells are
    //  uniform there, and whether a cell of the face is invalid
    double shock[faceBlock::size];
    double strong[faceBlock::size];
    double flat[faceBlock::size];
    double invalid[faceBlock::size];

    //- Is any?
    bool shocked;
    bool anyInvalid;
};


namespace Foam
{

//- Whether gradients are more than a processor keeps near itself: asking for
//  what is there already costs a twentieth of the time of a step
inline bool outOfReach(const std::vector<double>& gradient)
{
    return gradient.size() > 250000;
}

//- From 0 to 1 as x goes from 0 to 1, without a kink: a steady state can come
//  to rest
inline double smoothStep(const double x)
{
    return x*x*(3 - 2*x);
}


//- Share 0..1 of a face in a shock, by how much the pressure rises along the
//  flow within the distance delta between two cells, or in their extent in the
//  direction of its gradient if that is less, in parts of itself: 0 up to
//  least, 1 from least + 0.1 on. (Sides of a shock count as well. In cells that
//  are long along a wall the pressure rises towards it by more than that within
//  their length, without any shock.)
//  \param inverseExtent  of both cells (gasMesh.H) [1/m]
//  \param restSqr  square of a speed [m^2/s^2] of gas that is nearly at rest
//  \param flatFrom  rise of pressure from which on cells are uniform
//  \param flat  share 0..1 in which they are: 1 from twice that rise on
//  \param strongFrom  rise of pressure from which on the shock is strong
//  \param strong  share 0..1 of the face in a strong one
template<int nDim>
inline double shareInShock
(
    const double* owner,
    const double* far,
    const double* gradientOwner,
    const double* gradientFar,
    const double* inverseExtentOwner,
    const double* inverseExtentFar,
    const double* delta,
    const double least,
    const double restSqr,
    const double flatFrom,
    double& flat,
    const double strongFrom,
    double& strong
)
{
    double gg[2] = {0, 0};
    double ug[2] = {0, 0};
    double uu[2] = {0, 0};
    double dd = 0;
    for (int d = 0; d < nDim; d++)
    {
        const double g0 = gradientOwner[d*(nDim + 2)];
        const double g1 = gradientFar[d*(nDim + 2)];
        gg[0] += g0*g0;
        gg[1] += g1*g1;
        ug[0] += owner[2 + d]*g0;
        ug[1] += far[2 + d]*g1;
        uu[0] += owner[2 + d]*owner[2 + d];
        uu[1] += far[2 + d]*far[2 + d];
        dd += delta[d]*delta[d];
    }

    double share = 0;
    flat = 0;
    strong = 0;
    for (int side = 0; side < 2; side++)
    {
        const double low = min(owner[0], far[0]);
        if (!(ug[side] > 0 && gg[side]*dd > sqr(least*low)))
        {
            continue;
        }

        const double* g = side ? gradientFar : gradientOwner;
        const double* inverse = side ? inverseExtentFar : inverseExtentOwner;
        double across = 0;
        for (int d = 0; d < nDim*nDim; d++)
        {
            across +=
                inverse[d]*g[(d/nDim)*(nDim + 2)]*g[(d % nDim)*(nDim + 2)];
        }
        const double rise =
            min(std::sqrt(gg[side]*dd), gg[side]*std::sqrt(gg[side])/across);
        if (rise > least*low)
        {
            const double jump = rise/low;
            // Gas at rest but for round-off has no direction
            const double along =
                ug[side]/std::sqrt(max(uu[side], restSqr)*gg[side]);
            const double x =
                min(10*(jump - least), 1.0)*min(10*along, 1.0);
            const double inShock = smoothStep(x);
            share = max(share, inShock);

            const auto beyond = [&](const double rise)
            {
                return
                    jump < 2*rise
                  ? smoothStep(max(jump/rise - 1, 0.0))
                  : 1.0;
            };
            flat = max(flat, beyond(flatFrom));
            strong = max(strong, inShock*beyond(strongFrom));
        }
    }
    return share;
}

} // End namespace Foam


template<int nDim>
void Foam::gasEquations::gradients()
{
    const leastSquaresLinks links
    {
        geometry_.nCells(),
        geometry_.cellStart.data(),
        geometry_.neighbour.data(),
        geometry_.lsqVector.data()
    };
    double* g = gradient_.data();
    leastSquaresGradients(links, nDim, primitive.data(), g);

    const auto fillGhosts = [&]()
    {
        geometry_.exchange(g, nVar_*nDim);
        geometry_.reflectGradients(g);
    };
    fillGhosts();
    if (inTime_ && slipWallShear_.used())
    {
        slipWallShear_.limit<nDim>(g);
        fillGhosts();
    }
    if (geometry_.anyUnaligned)
    {
        widenGradients<nDim>();
    }
}


template<int nDim>
void Foam::gasEquations::widenGradients()
{
    constexpr int n = (nDim + 2)*nDim;
    const std::vector<int>& cells = geometry_.unaligned;
    wideGradient_.resize(cells.size()*n);

    double* wide = wideGradient_.data();
    for (std::size_t i = 0; i < cells.size(); i++, wide += n)
    {
        std::fill_n(wide, n, 0);
        const int end = geometry_.wideStart[i + 1];
        for (int j = geometry_.wideStart[i]; j < end; j++)
        {
            const double* g = &gradient_[geometry_.wideCell[j]*n];
            const double share = geometry_.wideShare[j];
            for (int k = 0; k < n; k++)
            {
                wide[k] += share*g[k];
            }
        }
    }

    wide = wideGradient_.data();
    for (const int c : cells)
    {
        std::copy_n(wide, n, &gradient_[c*n]);
        wide += n;
    }
    geometry_.exchange(gradient_.data(), n);
    geometry_.reflectGradients(gradient_.data());
}


void Foam::gasEquations::blendFluxes
(
    faceBlock& block,
    const int n,
    const double* share
) const
{
    double keep[faceBlock::maxVar][faceBlock::size];
    std::copy(&block.flux[0][0], &block.flux[nVar_ - 1][0] + n, &keep[0][0]);

    robustFlux_(block, n, eos_);

    for (int k = 0; k < nVar_; k++)
    {
        for (int i = 0; i < n; i++)
        {
            block.flux[k][i] =
                share[i]*block.flux[k][i] + (1 - share[i])*keep[k][i];
        }
    }
}


template<int nDim>
inline void Foam::gasEquations::turnedToFace
(
    const label f,
    const int cell,
    const double* line,
    double* q,
    double* slope
) const
{
    const double* axis = geometry_.axis.data();
    const double* away = geometry_.away.data();
    const double inverse = geometry_.inverseRadius[cell];
    const double ratio = geometry_.faceRadius[f]*inverse;
    double along = 0;
    double slopeAlong = 0;
    double outward = 0;
    for (int d = 0; d < nDim; d++)
    {
        along += q[2 + d]*axis[d];
        slopeAlong += slope[2 + d]*axis[d];
        outward += 2*line[d]*away[d];
    }
    for (int d = 0; d < nDim; d++)
    {
        const double across = q[2 + d] - along*axis[d];
        const double slopeAcross = slope[2 + d] - slopeAlong*axis[d];
        q[2 + d] = along*axis[d] + ratio*across;
        slope[2 + d] =
            slopeAlong*axis[d] + ratio*(slopeAcross - outward*inverse*across);
    }
}


template<int nDim>
void Foam::gasEquations::readFaces
(
    const label first,
    const int n,
    faceRows& rows,
    faceBlock& block,
    faceState& state
) const
{
    constexpr int nVar = nDim + 2;
    const double* q = primitive.data();
    const double* g = gradient_.data();
    const faceLinks faces
    {
        geometry_.nFaces(),
        geometry_.owner.data(),
        geometry_.far.data(),
        geometry_.alongOwner.data(),
        geometry_.alongFar.data(),
        geometry_.normal.data(),
        outOfReach(gradient_)
    };
    rows.read(faces, nDim, first, n, q, g);
    if (!geometry_.axis.empty())
    {
        for (int i = 0; i < n; i++)
        {
            const label f = first + i;
            turnedToFace<nDim>
            (
                f, faces.owner[f], faces.alongOwner + f*nDim,
                rows.owner + i*nVar, rows.slopeOwner + i*nVar
            );
            turnedToFace<nDim>
            (
                f, faces.far[f], faces.alongFar + f*nDim,
                rows.far + i*nVar, rows.slopeFar + i*nVar
            );
        }
    }
    rows.turnOver(faces, nDim, first, n, block);

    if (faces.ahead)
    {
        for (label f = first; f < first + n; f++)
        {
            __builtin_prefetch(&rate[faces.owner[f]*nVar]);
            if (f < geometry_.nInternal())
            {
                __builtin_prefetch(&rate[faces.far[f]*nVar]);
            }
        }
    }
    // Where the mesh has cells without lines a shock is cut into steps, whose
    // first and last cells need the flux of the shock as well: without it the
    // total temperature behind is off by twice as much
    const double leastRise = geometry_.anyUnaligned ? 0.1 : 0.2;
    const double* extent = geometry_.inverseExtent.data();
    state.shocked = false;
    state.anyInvalid = false;
    for (int i = 0; i < n; i++)
    {
        const label f = first + i;
        const int o = faces.owner[f];
        const int r = faces.far[f];
        const double* qo = q + o*nVar;
        const double* qr = q + r*nVar;
        if (passed_ > 0)
        {
            const double RT = eos_.R*0.5*(qo[1] + qr[1]);
            block.passed[0][i] = passed_;
            block.passed[1][i] = passed_*qo[1]*qr[1];
            for (int d = 0; d < nDim; d++)
            {
                block.passed[2 + d][i] = passed_*RT;
            }
        }
        block.weight[i] = geometry_.evenWeight[f];
        state.strong[i] = 0;
        state.shock[i] =
            sensesShocks_ || flatFrom_ < GREAT
          ? shareInShock<nDim>
            (
                qo, qr, g + o*(nVar*nDim), g + r*(nVar*nDim),
                extent + o*(nDim*nDim), extent + r*(nDim*nDim),
                &geometry_.delta[f*nDim], leastRise,
                0.5e-4*eos_.R*(qo[1] + qr[1]),
                flatFrom_, state.flat[i], strongRise, state.strong[i]
            )
          : 0;
        state.shocked = state.shocked || state.shock[i] > 0;
        state.invalid[i] = anyInvalid_ && (invalid_[o] || invalid_[r]);
        state.anyInvalid = state.anyInvalid || state.invalid[i] > 0;
    }
    faceExpansion(block, n, nDim, eos_.R);
}


template<int nDim>
void Foam::gasEquations::fluxesOfFaces
(
    const int n,
    faceBlock& block,
    const faceState& state
) const
{
    constexpr int nVar = nDim + 2;
    if (rough_)
    {
        firstOrder_(block, n, 0, nVar);
    }
    for (const variableLimiter& limiter : reconstruction_)
    {
        if (!rough_)
        {
            limiter.reconstruct(block, n, limiter.first, limiter.end);
        }
    }
    flux_(block, n, eos_);

    if (state.shocked)
    {
        for (int k = 0; k < nVar && flatFrom_ < GREAT; k++)
        {
            for (int i = 0; i < n; i++)
            {
                const double limited = 1 - state.flat[i];
                const double qo = block.owner[k][i];
                const double qr = block.far[k][i];
                block.L[k][i] = qo + limited*(block.L[k][i] - qo);
                block.R[k][i] = qr + limited*(block.R[k][i] - qr);
            }
        }
        blendFluxes(block, n, state.shock);
    }
    if (state.anyInvalid)
    {
        firstOrder_(block, n, 0, nVar);
        blendFluxes(block, n, state.invalid);
    }
}


template<int nDim>
void Foam::gasEquations::mirrorFluxes
(
    const label first,
    const int n,
    faceBlock& block
) const
{
    for (int i = 0; i < n; i++)
    {
        // Nothing but pressure, to the last digit
        const double* normal = &geometry_.normal[(first + i)*nDim];
        double pressure = 0;
        for (int d = 0; d < nDim; d++)
        {
            pressure += block.flux[2 + d][i]*normal[d];
        }
        block.flux[0][i] = 0;
        block.flux[1][i] = 0;
        for (int d = 0; d < nDim; d++)
        {
            block.flux[2 + d][i] = pressure*normal[d];
        }
    }
}


template<int nDim>
void Foam::gasEquations::addFluxes
(
    const label first,
    const int n,
    const faceBlock& block,
    scalar* massFlux
)
{
    constexpr int nVar = nDim + 2;
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
}


template<int nDim>
void Foam::gasEquations::innerFluxes()
{
    faceRows rows;
    faceBlock block;
    faceState state;
    block.smooth = passed_ > 0;
    block.soundShare = soundShare_;

    // massFlux: those of face f at massFlux[f]. mirrored: the gas behind the
    // faces is an image
    const auto range = [&]
    (
        const label start,
        const label end,
        scalar* massFlux,
        const bool mirrored
    )
    {
        for (label first = start; first < end; first += faceBlock::size)
        {
            const int n = min(label(faceBlock::size), end - first);
            readFaces<nDim>(first, n, rows, block, state);
            for (int i = 0; i < n && surroundings_.used(); i++)
            {
                const double around = surroundings_.ofFace
                (
                    geometry_.owner[first + i],
                    geometry_.far[first + i],
                    state.strong[i]
                );
                state.shock[i] = max(state.shock[i], around);
                state.shocked = state.shocked || around > 0;
            }
            fluxesOfFaces<nDim>(n, block, state);
            if (mirrored)
            {
                mirrorFluxes<nDim>(first, n, block);
            }
            addFluxes<nDim>(first, n, block, massFlux);
        }
    };

    massFlux_.resize(geometry_.nInternal());
    range(0, geometry_.nInternal(), massFlux_.data(), false);
    if (turbulent())
    {
        publishMassFlux();
    }
    for (const gasMesh::patchRange& patch : geometry_.patches())
    {
        // The gas goes on behind a symmetry plane: half a body then has the
        // flow of the whole body
        if (patch.coupled || patch.symmetry)
        {
            range
            (
                patch.start,
                patch.start + patch.size,
                phi_.boundaryFieldRef()[patch.patchi].begin() - patch.start,
                patch.symmetry
            );
        }
    }
    if (surroundings_.used())
    {
        geometry_.exchange(surroundings_.advance(), 1);
    }
}


template<int nDim>
void Foam::gasEquations::sidesOfSection(const label start, const label end)
{
    constexpr int nVar = nDim + 2;
    for (label f = start; f < end; f++)
    {
        double p;
        wallPressure(f, p, true);
        double* rateOfCell = &rate[geometry_.owner[f]*nVar];
        for (int d = 0; d < nDim; d++)
        {
            rateOfCell[2 + d] -=
                p*geometry_.area[f]*geometry_.normal[f*nDim + d];
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
        if (patch.coupled || patch.symmetry)
        {
            continue;
        }
        if (patch.wedge && geometry_.inSection())
        {
            sidesOfSection<nDim>(patch.start, patch.start + patch.size);
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
                wallPressure(f, q[0], patch.wedge);
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
                exactFlux(q, n, nDim, eos_, flux);
            }

            if (patch.wedge)
            {
                // What swirl carries out of one face and, turned, into the
                // other: centrifugal and Coriolis force
                const double* radial = geometry_.radial(f);
                const double* around = geometry_.around(f);
                const double* u = &primitive[c*nVar + 2];
                double swirl = 0;
                double outward = 0;
                double across = 0;
                for (int d = 0; d < nDim; d++)
                {
                    swirl += u[d]*around[d];
                    outward += u[d]*radial[d];
                    across += n[d]*radial[d];
                }
                const double m =
                    across*swirl*primitive[c*nVar]
                   /(eos_.R*primitive[c*nVar + 1]);
                for (int d = 0; d < nDim; d++)
                {
                    flux[2 + d] += m*(swirl*radial[d] - outward*around[d]);
                }
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
