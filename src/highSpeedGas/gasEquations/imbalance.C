/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "gasEquations.H"

Foam::scalar Foam::gasEquations::imbalance() const
{
    const int nDim = geometry_.nDim();
    soundSpeed(soundSpeed_);

    // Sums over cells: |rates| of mass, momentum and energy, and the
    // mass-weighted means of |u| + a and H that scale the last two
    FixedList<scalar, 8> sums(Zero);
    enum {mass, momentum, energy, weight, speed, enthalpy, inflow, acoustic};

    for (label c = 0; c < geometry_.nCells(); c++)
    {
        const double* R = &rate[c*nVar_];
        const double* w = &conserved[c*nVar_];
        const double* q = &primitive[c*nVar_];
        double mm = 0;
        double uu = 0;
        for (int d = 0; d < nDim; d++)
        {
            mm += R[2 + d]*R[2 + d];
            uu += q[2 + d]*q[2 + d];
        }
        const double m = w[0]*geometry_.volume[c];
        sums[mass] += mag(R[0]);
        sums[momentum] += std::sqrt(mm);
        sums[energy] += mag(R[1]);
        sums[weight] += m;
        sums[speed] += m*(std::sqrt(uu) + soundSpeed_[c]);
        sums[enthalpy] += m*(w[1] + q[0])/w[0];
    }

    for (const gasMesh::patchRange& patch : geometry_.patches())
    {
        if (!patch.coupled)
        {
            for (const scalar m : phi_.boundaryField()[patch.patchi])
            {
                sums[inflow] -= min(m, scalar(0));
            }
        }
    }
    for (label f = 0; f < geometry_.nInternal(); f++)
    {
        const label o = geometry_.owner[f];
        sums[acoustic] +=
            conserved[o*nVar_]*soundSpeed_[o]*geometry_.area[f];
    }

    for (scalar& sum : sums)
    {
        reduce(sum, sumOp<scalar>());
    }

    // A closed domain is measured by the mass that crosses its faces at the
    // speed of sound
    const scalar flow = sums[inflow] > 0 ? sums[inflow] : sums[acoustic];

    return
        max
        (
            sums[mass],
            max
            (
                sums[momentum]*sums[weight]/sums[speed],
                sums[energy]*sums[weight]/sums[enthalpy]
            )
        )
       /flow;
}
