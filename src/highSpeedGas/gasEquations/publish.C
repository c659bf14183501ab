/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "gasEquations.H"

void Foam::gasEquations::publish()
{
    volScalarField& p = thermo_.p();
    volScalarField& T = thermo_.T();
    const int nDim = geometry_.nDim();

    for (label c = 0; c < geometry_.nCells(); c++)
    {
        const double* q = &primitive[c*nVar_];
        p[c] = q[0];
        T[c] = q[1];
        rho_[c] = q[0]/(closure_.R*q[1]);
        for (int d = 0; d < nDim; d++)
        {
            U_[c][geometry_.direction(d)] = q[2 + d];
        }
    }

    U_.correctBoundaryConditions();
    T.correctBoundaryConditions();
    p.correctBoundaryConditions();

    // Gradients for the pressure on the walls
    correctBoundary();
    if (nDim == 2)
    {
        gradients<2>();
    }
    else
    {
        gradients<3>();
    }

    label k = 0;
    for (const gasMesh::patchRange& patch : geometry_.patches())
    {
        if (impermeable_[k++] && !patch.symmetry)
        {
            scalarField& pp = p.boundaryFieldRef()[patch.patchi];
            forAll(pp, i)
            {
                wallPressure(patch, i, pp[i]);
            }
        }
    }

    forAll(rho_.boundaryField(), patchi)
    {
        rho_.boundaryFieldRef()[patchi] ==
            p.boundaryField()[patchi]
           /(closure_.R*T.boundaryField()[patchi]);
    }

    // Energy and transport properties follow from p and T
    thermo_.he() = thermo_.he(p, T);
    const scalarField keepT(T);
    thermo_.correct();
    static_cast<scalarField&>(T) = keepT;
}
