/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "ImplicitGaussSeidel.H"
#include "gaussSeidel.H"
#include <algorithm>

void Foam::ImplicitGaussSeidel::setLinks()
{
    const gasMesh& mesh = gas_.geometry();
    const int nDim = mesh.nDim();

    // Behind other boundaries nothing changes
    std::vector<bool> changes(mesh.nFaces(), false);
    std::fill_n(changes.begin(), mesh.nInternal(), true);
    for (const gasMesh::patchRange& patch : mesh.patches())
    {
        std::fill_n(changes.begin() + patch.start, patch.size, patch.coupled);
    }

    placeOfOwner_.assign(mesh.nFaces(), -1);
    placeOfFar_.assign(mesh.nFaces(), -1);
    start_.assign(1, 0);
    for (label c = 0; c < mesh.nCells(); c++)
    {
        for (int i = mesh.cellStart[c]; i < mesh.cellStart[c + 1]; i++)
        {
            const int f = mesh.faceOf[i];
            const bool owns = mesh.owner[f] == c;
            if (!changes[f])
            {
                continue;
            }
            (owns ? placeOfOwner_ : placeOfFar_)[f] = neighbour_.size();
            neighbour_.push_back(mesh.neighbour[i]);
            coeffs_.push_back(0);
            for (int d = 0; d < nDim; d++)
            {
                coeffs_.push_back
                (
                    (owns ? 0.5 : -0.5)
                   *mesh.area[f]*mesh.normal[f*nDim + d]
                );
            }
        }
        start_.push_back(neighbour_.size());
    }
}


Foam::ImplicitGaussSeidel::ImplicitGaussSeidel
(
    gasEquations& gas,
    const int nSweeps
)
:
    gas_(gas),
    nSweeps_(nSweeps),
    nSteps_(0),
    stride_(gas.nVar()*(gas.geometry().nDim() + 1)),
    cells_(3*gas.geometry().nCells()),
    change_(gas.geometry().nSlots()*stride_),
    next_(gas.conserved.size())
{
    setLinks();
}


void Foam::ImplicitGaussSeidel::linearise(const scalar Co)
{
    const gasMesh& mesh = gas_.geometry();
    const gasEquationOfState& eos = gas_.equationOfState();
    const int nVar = gas_.nVar();
    const int step = mesh.nDim() + 1;

    gas_.faceSpectralRadius(lambda_);
    diagonal_.assign(mesh.nCells(), 0);

    for (label f = 0; f < mesh.nFaces(); f++)
    {
        const double half = 0.5*lambda_[f];
        diagonal_[mesh.owner[f]] += half;
        if (placeOfOwner_[f] >= 0)
        {
            coeffs_[placeOfOwner_[f]*step] = half;
        }
        if (f < mesh.nInternal())
        {
            diagonal_[mesh.far[f]] += half;
            coeffs_[placeOfFar_[f]*step] = half;
        }
    }

    for (label c = 0; c < mesh.nCells(); c++)
    {
        const double T = gas_.primitive[c*nVar + 1];
        const bool thermally = eos.thermallyPerfect();

        // dt = 2 Co V/sum(lambda S)
        cells_[3*c] = 1/(diagonal_[c]*(1 + 1/Co));
        cells_[3*c + 1] =
            eos.R/(thermally ? eos.specificHeat<true>(T) : eos.cv);
        cells_[3*c + 2] = thermally ? eos.energy<true>(T) : eos.cv*T;
    }
}


void Foam::ImplicitGaussSeidel::sweep()
{
    const gasMesh& mesh = gas_.geometry();
    const gaussSeidelRows rows =
    {
        mesh.nCells(),
        start_.data(),
        neighbour_.data(),
        coeffs_.data(),
        cells_.data(),
        gas_.primitive.data(),
        gas_.rate.data(),
        gas_.equationOfState().R
    };

    std::fill(change_.begin(), change_.end(), 0);
    for (int k = 0; k < nSweeps_; k++)
    {
        for (const bool forward : {true, false})
        {
            gaussSeidelSweep(rows, mesh.nDim(), forward, change_.data());
            mesh.exchange(change_.data(), stride_);
        }
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

        // A cell that cannot follow is taken to first order in the next steps
        if (share < 0.5)
        {
            gas_.setInvalid(c);
        }
    }
}


bool Foam::ImplicitGaussSeidel::localStep(const scalar Co)
{
    gas_.computeRate();

    // Where fluxes of second order draw the internal energy of a cell below
    // zero those of first order for one step do not give it back
    const label patience = 50;
    if (++nSteps_ % patience == 0)
    {
        gas_.calm();
    }

    linearise(Co);
    sweep();
    gas_.geometry().nDim() == 2 ? update<2>() : update<3>();

    const bool accepted = gas_.accept(next_) == 0;
    if (accepted)
    {
        gas_.conserved.swap(next_);
        gas_.correctBoundary();
    }
    return accepted;
}
