/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "vectorKernel.H"
#include "gaussSeidel.H"

namespace Foam
{
namespace
{

template<int nDim>
VECTOR_INLINE void relax
(
    const gaussSeidelRows& rows,
    const int c,
    double* change
)
{
    constexpr int nVar = nDim + 2;
    constexpr int stride = nVar*(nDim + 1);

    double b[nVar];
    for (int k = 0; k < nVar; k++)
    {
        b[k] = rows.rate[c*nVar + k];
    }
    for (int i = rows.start[c]; i < rows.start[c + 1]; i++)
    {
        const double* dW = change + rows.neighbour[i]*stride;
        const double* coeffs = rows.coeffs + i*(nDim + 1);
        for (int k = 0; k < nVar; k++)
        {
            b[k] += coeffs[0]*dW[k];
        }
        for (int d = 1; d <= nDim; d++)
        {
            for (int k = 0; k < nVar; k++)
            {
                b[k] -= coeffs[d]*dW[d*nVar + k];
            }
        }
    }

    const double v = rows.cells[3*c];
    const double kappa = rows.cells[3*c + 1];
    const double e = rows.cells[3*c + 2];
    double w[nVar];
    for (int k = 0; k < nVar; k++)
    {
        w[k] = b[k]*v;
    }

    // Change of the fluxes along each direction that goes with it, once here
    // instead of once per face
    const double* q = rows.primitive + c*nVar;
    const double RT = rows.R*q[1];
    double udm = 0;
    double uu = 0;
    for (int d = 0; d < nDim; d++)
    {
        udm += q[2 + d]*w[2 + d];
        uu += q[2 + d]*q[2 + d];
    }
    const double H = e + RT + 0.5*uu;
    const double dp = RT*w[0] + kappa*(w[1] - udm + (0.5*uu - e)*w[0]);

    double* dW = change + c*stride;
    for (int k = 0; k < nVar; k++)
    {
        dW[k] = w[k];
    }
    for (int d = 0; d < nDim; d++)
    {
        double* dF = dW + (d + 1)*nVar;
        const double u = q[2 + d];
        const double du = w[2 + d] - u*w[0];
        dF[0] = w[2 + d];
        dF[1] = H*du + u*(w[1] + dp);
        for (int k = 0; k < nDim; k++)
        {
            dF[2 + k] = u*w[2 + k] + q[2 + k]*du;
        }
        dF[2 + d] += dp;
    }
}


template<int nDim>
VECTOR_INLINE void sweep
(
    const gaussSeidelRows& rows,
    const bool forward,
    double* change
)
{
    if (forward)
    {
        for (int c = 0; c < rows.nCells; c++)
        {
            relax<nDim>(rows, c, change);
        }
    }
    else
    {
        for (int c = rows.nCells - 1; c >= 0; c--)
        {
            relax<nDim>(rows, c, change);
        }
    }
}


VECTOR_KERNEL void sweep2
(
    const gaussSeidelRows& rows,
    const bool forward,
    double* change
)
{
    sweep<2>(rows, forward, change);
}


VECTOR_KERNEL void sweep3
(
    const gaussSeidelRows& rows,
    const bool forward,
    double* change
)
{
    sweep<3>(rows, forward, change);
}

} // End anonymous namespace
} // End namespace Foam


void Foam::gaussSeidelSweep
(
    const gaussSeidelRows& rows,
    const int nDim,
    const bool forward,
    double* change
)
{
    nDim == 2
      ? sweep2(rows, forward, change)
      : sweep3(rows, forward, change);
}
