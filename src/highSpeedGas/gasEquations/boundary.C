/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "gasEquations.H"
#include "wallPolyPatch.H"
#include "wedgePolyPatch.H"
#include "slipFvPatchFields.H"

void Foam::gasEquations::setPatches()
{
    // Boundary conditions that need nothing beyond p, T, U and phi
    static const wordHashSet selfContained
    {
        "fixedValue", "zeroGradient", "slip", "noSlip", "symmetry",
        "symmetryPlane", "wedge", "empty", "calculated", "cyclic", "processor",
        "processorCyclic", "supersonicFreestream", "freestream",
        "freestreamPressure", "freestreamVelocity", "inletOutlet",
        "outletInlet", "uniformFixedValue", "fixedGradient"
    };

    boundaryNeedsThermo_ = false;
    boolList excluded(mesh_.boundary().size(), false);
    frictionless_.setSize(mesh_.boundary().size(), false);

    for (const gasMesh::patchRange& patch : geometry_.patches())
    {
        const label patchi = patch.patchi;
        const polyPatch& pp = mesh_.boundaryMesh()[patchi];
        const fvPatchVectorField& Up = U_.boundaryField()[patchi];

        const bool wedge = isA<wedgePolyPatch>(pp);
        const bool slip = isA<slipFvPatchVectorField>(Up);
        const bool wall = isA<wallPolyPatch>(pp) || slip;

        impermeable_.push_back(wall || patch.symmetry || wedge);
        excluded[patchi] = wedge || slip || (wall && !viscous_);
        frictionless_[patchi] = wedge || slip || patch.symmetry;

        for
        (
            const word& type :
            {
                Up.type(),
                thermo_.T().boundaryField()[patchi].type(),
                thermo_.p().boundaryField()[patchi].type()
            }
        )
        {
            boundaryNeedsThermo_ =
                boundaryNeedsThermo_ || !selfContained.found(type);
        }
    }
    reduce(boundaryNeedsThermo_, orOp<bool>());

    geometry_.setLeastSquares(excluded);
}


void Foam::gasEquations::correctBoundary()
{
    volScalarField& p = thermo_.p();
    volScalarField& T = thermo_.T();
    const int nDim = geometry_.nDim();
    const label nCells = geometry_.nCells();
    const label nInternal = geometry_.nInternal();
    brokenFace_ = -1;

    // The boundary conditions read the fields next to the boundary only
    for (label f = nInternal; f < geometry_.nFaces(); f++)
    {
        const label c = geometry_.owner[f];
        const double* q = &primitive[c*nVar_];
        p[c] = q[0];
        T[c] = q[1];
        rho_[c] = q[0]/(closure_.R*q[1]);
        for (int d = 0; d < nDim; d++)
        {
            U_[c][geometry_.direction(d)] = q[2 + d];
        }
    }

    if (boundaryNeedsThermo_)
    {
        thermo_.he() = thermo_.he(p, T);
        const scalarField keepT(T);
        thermo_.correct();
        static_cast<scalarField&>(T) = keepT;
    }

    for (const gasMesh::patchRange& patch : geometry_.patches())
    {
        if (patch.coupled || patch.symmetry)
        {
            continue;
        }
        const label patchi = patch.patchi;
        U_.boundaryFieldRef()[patchi].evaluate();
        T.boundaryFieldRef()[patchi].evaluate();
        p.boundaryFieldRef()[patchi].evaluate();
        rho_.boundaryFieldRef()[patchi] ==
            p.boundaryField()[patchi]
           /(closure_.R*T.boundaryField()[patchi]);

        const fvPatchVectorField& Up = U_.boundaryField()[patchi];
        const fvPatchScalarField& Tp = T.boundaryField()[patchi];
        const fvPatchScalarField& pp = p.boundaryField()[patchi];
        double* q = &primitive[(nCells + patch.start - nInternal)*nVar_];
        for (label i = 0; i < patch.size; i++, q += nVar_)
        {
            const bool good =
                pp[i] > 0 && pp[i] < GREAT && Tp[i] > 0 && Tp[i] < GREAT
             && magSqr(Up[i]) < GREAT;
            if (!good)
            {
                // Refused at the next step, with all ranks knowing
                brokenFace_ = patch.start + i;
                continue;
            }
            q[0] = pp[i];
            q[1] = Tp[i];
            for (int d = 0; d < nDim; d++)
            {
                q[2 + d] = Up[i][geometry_.direction(d)];
            }
        }
    }

    for (const gasMesh::patchRange& patch : geometry_.patches())
    {
        if (!patch.symmetry)
        {
            continue;
        }
        for (label f = patch.start; f < patch.start + patch.size; f++)
        {
            const double* q = &primitive[geometry_.owner[f]*nVar_];
            const double* n = &geometry_.normal[f*nDim];
            double* g = &primitive[geometry_.far[f]*nVar_];
            double un = 0;
            for (int d = 0; d < nDim; d++)
            {
                un += q[2 + d]*n[d];
            }
            g[0] = q[0];
            g[1] = q[1];
            for (int d = 0; d < nDim; d++)
            {
                g[2 + d] = q[2 + d] - 2*un*n[d];
            }
        }
    }

    geometry_.exchange(primitive.data(), nVar_);
}


void Foam::gasEquations::wallPressure
(
    const gasMesh::patchRange& patch,
    const label i,
    double& p
) const
{
    const int nDim = geometry_.nDim();
    const label f = patch.start + i;
    const label c = geometry_.owner[f];
    const double* g = &gradient_[c*nVar_*nDim];
    double change = 0;
    for (int d = 0; d < nDim; d++)
    {
        change += g[d*nVar_]*geometry_.toFace[f*nDim + d];
    }

    // In the first instants of an impulsive start the pressure next to the
    // wall varies by more than itself
    const double pc = primitive[c*nVar_];
    p = pc + max(-0.5*pc, min(0.5*pc, change));
}
