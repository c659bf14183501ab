/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "ImplicitGaussSeidel.H"
#include <algorithm>

Foam::ImplicitGaussSeidel::ImplicitGaussSeidel
(
    gasEquations& gas,
    const int nSweeps
)
:
    gas_(gas),
    nSweeps_(nSweeps),
    lambda_(gas.geometry().nFaces()),
    diagonal_(gas.geometry().nCells()),
    kappa_(gas.geometry().nSlots()),
    change_(gas.geometry().nSlots()*gas.nVar()),
    next_(gas.conserved.size())
{}


template<int nDim>
void Foam::ImplicitGaussSeidel::linearise(const scalar Co)
{
    constexpr int nVar = nDim + 2;
    const gasMesh& mesh = gas_.geometry();
    const gasClosure& closure = gas_.closure();
    const double* q = gas_.primitive.data();

    gas_.soundSpeed(soundSpeed_);
    std::fill(diagonal_.begin(), diagonal_.end(), 0);

    for (label f = 0; f < mesh.nFaces(); f++)
    {
        const int o = mesh.owner[f];
        const int r = mesh.far[f];
        const double* n = &mesh.normal[f*nDim];
        double uo = 0;
        double ur = 0;
        for (int d = 0; d < nDim; d++)
        {
            uo += q[o*nVar + 2 + d]*n[d];
            ur += q[r*nVar + 2 + d]*n[d];
        }
        lambda_[f] =
            max(mag(uo) + soundSpeed_[o], mag(ur) + soundSpeed_[r])
           *mesh.area[f];
        diagonal_[o] += 0.5*lambda_[f];
        if (f < mesh.nInternal())
        {
            diagonal_[r] += 0.5*lambda_[f];
        }
    }

    // dt = 2 Co V/sum(lambda S)
    for (double& d : diagonal_)
    {
        d *= 1 + 1/Co;
    }

    for (label s = 0; s < mesh.nSlots(); s++)
    {
        const double T = q[s*nVar + 1];
        kappa_[s] =
            closure.R
           /(
                closure.thermallyPerfect()
              ? closure.specificHeat<true>(T)
              : closure.cv
            );
    }
}


template<int nDim>
void Foam::ImplicitGaussSeidel::relax(const label celli)
{
    constexpr int nVar = nDim + 2;
    const gasMesh& mesh = gas_.geometry();
    const gasClosure& closure = gas_.closure();

    double b[nVar];
    const double* R = &gas_.rate[celli*nVar];
    for (int k = 0; k < nVar; k++)
    {
        b[k] = R[k];
    }

    for (int i = mesh.cellStart[celli]; i < mesh.cellStart[celli + 1]; i++)
    {
        const int f = mesh.faceOf[i];
        const bool owns = mesh.owner[f] == celli;
        const int j = owns ? mesh.far[f] : mesh.owner[f];
        const double sign = owns ? 1 : -1;
        const double* dW = &change_[j*nVar];
        const double* q = &gas_.primitive[j*nVar];
        const double* n = &mesh.normal[f*nDim];

        // A dW with the outward normal, from the state behind the face
        double un = 0;
        double dmn = 0;
        double udm = 0;
        double uu = 0;
        for (int d = 0; d < nDim; d++)
        {
            const double u = q[2 + d];
            un += u*n[d];
            dmn += dW[2 + d]*n[d];
            udm += u*dW[2 + d];
            uu += u*u;
        }

        const double T = q[1];
        const double kappa = kappa_[j];
        const double e =
            closure.thermallyPerfect()
          ? closure.energy<true>(T)
          : closure.cv*T;

        // dp at fixed composition: R T drho + kappa (d(rho e) - e drho)
        const double dp =
            closure.R*T*dW[0]
          + kappa*(dW[1] - udm + (0.5*uu - e)*dW[0]);
        const double dMass = dmn;
        const double dun = dmn - un*dW[0];
        const double H = e + closure.R*T + 0.5*uu;

        const double S = 0.5*sign*mesh.area[f];
        const double half = 0.5*lambda_[f];
        b[0] -= S*dMass - half*dW[0];
        b[1] -= S*(H*dun + un*(dW[1] + dp)) - half*dW[1];
        for (int d = 0; d < nDim; d++)
        {
            b[2 + d] -=
                S*(un*dW[2 + d] + q[2 + d]*dun + dp*n[d]) - half*dW[2 + d];
        }
    }

    double* dW = &change_[celli*nVar];
    const double v = 1/diagonal_[celli];
    for (int k = 0; k < nVar; k++)
    {
        dW[k] = b[k]*v;
    }
}


template<int nDim>
void Foam::ImplicitGaussSeidel::sweep()
{
    constexpr int nVar = nDim + 2;
    const label nCells = gas_.geometry().nCells();

    std::fill(change_.begin(), change_.end(), 0);
    for (int k = 0; k < nSweeps_; k++)
    {
        for (label c = 0; c < nCells; c++)
        {
            relax<nDim>(c);
        }
        gas_.geometry().exchange(change_.data(), nVar);
        for (label c = nCells - 1; c >= 0; c--)
        {
            relax<nDim>(c);
        }
        gas_.geometry().exchange(change_.data(), nVar);
    }
}


template<int nDim>
void Foam::ImplicitGaussSeidel::update()
{
    constexpr int nVar = nDim + 2;

    for (label c = 0; c < gas_.geometry().nCells(); c++)
    {
        const double* w = &gas_.conserved[c*nVar];
        const double* q = &gas_.primitive[c*nVar];
        const double* dW = &change_[c*nVar];
        double uu = 0;
        double udm = 0;
        for (int d = 0; d < nDim; d++)
        {
            uu += q[2 + d]*q[2 + d];
            udm += q[2 + d]*dW[2 + d];
        }
        const double rhoe = w[1] - 0.5*w[0]*uu;
        const double drhoe = dW[1] - udm + 0.5*uu*dW[0];
        const double worst = max(mag(dW[0])/w[0], mag(drhoe)/rhoe);
        const double share = worst > 0.3 ? 0.3/worst : 1;
        for (int k = 0; k < nVar; k++)
        {
            next_[c*nVar + k] = w[k] + share*dW[k];
        }
    }
}


bool Foam::ImplicitGaussSeidel::localStep(const scalar Co)
{
    gas_.computeRate();

    if (gas_.geometry().nDim() == 2)
    {
        linearise<2>(Co);
        sweep<2>();
        update<2>();
    }
    else
    {
        linearise<3>(Co);
        sweep<3>();
        update<3>();
    }

    const bool accepted = gas_.accept(next_) == 0;
    if (accepted)
    {
        gas_.conserved.swap(next_);
        gas_.correctBoundary();
        gas_.calm();
    }
    return accepted;
}
