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
    stride_(gas.nVar()*(gas.geometry().nDim() + 1)),
    diagonal_(gas.geometry().nCells()),
    kappa_(gas.geometry().nCells()),
    energy_(gas.geometry().nCells()),
    change_(gas.geometry().nSlots()*stride_),
    next_(gas.conserved.size())
{
    const gasMesh& mesh = gas.geometry();
    const int nDim = mesh.nDim();

    links_.resize(mesh.faceOf.size());
    halfArea_.resize(mesh.faceOf.size()*nDim);
    placeOfOwner_.assign(mesh.nFaces(), -1);
    placeOfFar_.assign(mesh.nFaces(), -1);

    for (label c = 0; c < mesh.nCells(); c++)
    {
        for (int i = mesh.cellStart[c]; i < mesh.cellStart[c + 1]; i++)
        {
            const int f = mesh.faceOf[i];
            const bool owns = mesh.owner[f] == c;
            links_[i].neighbour = owns ? mesh.far[f] : mesh.owner[f];
            for (int d = 0; d < nDim; d++)
            {
                halfArea_[i*nDim + d] =
                    (owns ? 0.5 : -0.5)
                   *mesh.area[f]*mesh.normal[f*nDim + d];
            }
            (owns ? placeOfOwner_ : placeOfFar_)[f] = i;
        }
    }
}


template<int nDim>
void Foam::ImplicitGaussSeidel::linearise(const scalar Co)
{
    constexpr int nVar = nDim + 2;
    const gasMesh& mesh = gas_.geometry();
    const gasEquationOfState& eos = gas_.equationOfState();
    const double* q = gas_.primitive.data();

    gas_.faceSpectralRadius(lambda_);
    std::fill(diagonal_.begin(), diagonal_.end(), 0);

    for (label f = 0; f < mesh.nFaces(); f++)
    {
        const double half = 0.5*lambda_[f];
        diagonal_[mesh.owner[f]] += half;
        links_[placeOfOwner_[f]].halfLambda = half;
        if (f < mesh.nInternal())
        {
            diagonal_[mesh.far[f]] += half;
            links_[placeOfFar_[f]].halfLambda = half;
        }
    }

    // dt = 2 Co V/sum(lambda S)
    for (double& d : diagonal_)
    {
        d = 1/(d*(1 + 1/Co));
    }

    for (label c = 0; c < mesh.nCells(); c++)
    {
        const double T = q[c*nVar + 1];
        kappa_[c] =
            eos.R
           /(
                eos.thermallyPerfect()
              ? eos.specificHeat<true>(T)
              : eos.cv
            );
        energy_[c] =
            eos.thermallyPerfect()
          ? eos.energy<true>(T)
          : eos.cv*T;
    }
}


template<int nDim>
inline void Foam::ImplicitGaussSeidel::relax(const label celli)
{
    constexpr int nVar = nDim + 2;
    constexpr int stride = nVar*(nDim + 1);
    const gasMesh& mesh = gas_.geometry();

    double b[nVar];
    const double* R = &gas_.rate[celli*nVar];
    for (int k = 0; k < nVar; k++)
    {
        b[k] = R[k];
    }

    const int end = mesh.cellStart[celli + 1];
    for (int i = mesh.cellStart[celli]; i < end; i++)
    {
        const double* dW = &change_[links_[i].neighbour*stride];
        const double half = links_[i].halfLambda;
        const double* S = &halfArea_[i*nDim];
        for (int k = 0; k < nVar; k++)
        {
            b[k] += half*dW[k];
        }
        for (int d = 0; d < nDim; d++)
        {
            for (int k = 0; k < nVar; k++)
            {
                b[k] -= S[d]*dW[(d + 1)*nVar + k];
            }
        }
    }

    double* dW = &change_[celli*stride];
    const double v = diagonal_[celli];
    for (int k = 0; k < nVar; k++)
    {
        dW[k] = b[k]*v;
    }

    // Change of the fluxes along each direction that goes with it, once here
    // instead of once per face
    const double* q = &gas_.primitive[celli*nVar];
    const double e = energy_[celli];
    const double RT = gas_.equationOfState().R*q[1];
    double udm = 0;
    double uu = 0;
    for (int d = 0; d < nDim; d++)
    {
        udm += q[2 + d]*dW[2 + d];
        uu += q[2 + d]*q[2 + d];
    }
    const double H = e + RT + 0.5*uu;
    const double dp =
        RT*dW[0] + kappa_[celli]*(dW[1] - udm + (0.5*uu - e)*dW[0]);

    for (int d = 0; d < nDim; d++)
    {
        double* dF = dW + (d + 1)*nVar;
        const double u = q[2 + d];
        const double du = dW[2 + d] - u*dW[0];
        dF[0] = dW[2 + d];
        dF[1] = H*du + u*(dW[1] + dp);
        for (int k = 0; k < nDim; k++)
        {
            dF[2 + k] = u*dW[2 + k] + q[2 + k]*du;
        }
        dF[2 + d] += dp;
    }
}


template<int nDim>
void Foam::ImplicitGaussSeidel::sweep()
{
    const label nCells = gas_.geometry().nCells();

    std::fill(change_.begin(), change_.end(), 0);
    for (int k = 0; k < nSweeps_; k++)
    {
        for (label c = 0; c < nCells; c++)
        {
            relax<nDim>(c);
        }
        gas_.geometry().exchange(change_.data(), stride_);
        for (label c = nCells - 1; c >= 0; c--)
        {
            relax<nDim>(c);
        }
        gas_.geometry().exchange(change_.data(), stride_);
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
        const double* dW = &change_[c*stride_];
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
        double share = worst > 0.3 ? 0.3/worst : 1;
        double* next = &next_[c*nVar];

        // In hypersonic flow the internal energy is a small difference of
        // large numbers, of which the linear estimate may know little
        for (int attempt = 0; attempt < 30; attempt++, share *= 0.5)
        {
            double mm = 0;
            for (int k = 0; k < nVar; k++)
            {
                next[k] = w[k] + share*dW[k];
                mm += k > 1 ? sqr(next[k]) : 0;
            }
            if (next[1] - 0.5*mm/next[0] > 0.5*rhoe)
            {
                break;
            }
        }

        // A cell that cannot follow is taken to first order in the next step
        if (share < 0.5)
        {
            gas_.setInvalid(c);
        }
    }
}


bool Foam::ImplicitGaussSeidel::localStep(const scalar Co)
{
    gas_.computeRate();
    gas_.calm();

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
    }
    return accepted;
}
