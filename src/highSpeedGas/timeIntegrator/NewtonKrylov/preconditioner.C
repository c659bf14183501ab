/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "NewtonKrylov.H"
#include <algorithm>

namespace Foam
{
namespace
{

//- Jacobian of the flux through a unit area with normal n: A[row][column] in
//  the order rho, rho E, rho u
template<int nDim>
struct fluxJacobian
{
    static constexpr int nVar = nDim + 2;

    double A[nVar][nVar];
    double un;
    double a;

    //- Pressure change with the conserved variables
    double dp[nVar];

    fluxJacobian
    (
        const double* q,
        const double* n,
        const gasEquationOfState& gas
    )
    {
        const double T = q[1];
        const double RT = gas.R*T;
        const bool thermally = gas.thermallyPerfect();
        const double e =
            thermally ? gas.energy<true>(T) : gas.energy<false>(T);
        const double kappa =
            gas.R/(thermally ? gas.specificHeat<true>(T) : gas.cv);

        double uu = 0;
        un = 0;
        for (int d = 0; d < nDim; d++)
        {
            uu += q[2 + d]*q[2 + d];
            un += q[2 + d]*n[d];
        }
        a = std::sqrt((1 + kappa)*RT);
        const double H = e + RT + 0.5*uu;

        dp[0] = RT + kappa*(0.5*uu - e);
        dp[1] = kappa;
        for (int d = 0; d < nDim; d++)
        {
            dp[2 + d] = -kappa*q[2 + d];
        }

        A[0][0] = 0;
        A[0][1] = 0;
        A[1][0] = -H*un + un*dp[0];
        A[1][1] = un*(1 + dp[1]);
        for (int d = 0; d < nDim; d++)
        {
            A[0][2 + d] = n[d];
            A[1][2 + d] = H*n[d] + un*dp[2 + d];
        }
        for (int k = 0; k < nDim; k++)
        {
            const double u = q[2 + k];
            A[2 + k][0] = -u*un + dp[0]*n[k];
            A[2 + k][1] = dp[1]*n[k];
            for (int d = 0; d < nDim; d++)
            {
                A[2 + k][2 + d] = u*n[d] + dp[2 + d]*n[k];
            }
            A[2 + k][2 + k] += un;
        }
    }

    //- |A|: the quadratic of A that takes its three eigenvalues to their
    //  magnitudes, none below a share of the largest
    void magnitude(const double floor, double (&M)[nVar][nVar]) const
    {
        const double minSpeed = floor*(std::fabs(un) + a);
        const double l0 = std::max(std::fabs(un - a), minSpeed);
        const double l1 = std::max(std::fabs(un), minSpeed);
        const double l2 = std::max(std::fabs(un + a), minSpeed);
        const double linear = 0.5*(l2 - l0)/a;
        const double square = 0.5*(l2 - 2*l1 + l0)/(a*a);

        double B[nVar][nVar];
        for (int i = 0; i < nVar; i++)
        {
            for (int j = 0; j < nVar; j++)
            {
                B[i][j] = A[i][j] - (i == j ? un : 0);
            }
        }
        for (int i = 0; i < nVar; i++)
        {
            for (int j = 0; j < nVar; j++)
            {
                double sum = 0;
                for (int k = 0; k < nVar; k++)
                {
                    sum += B[i][k]*B[k][j];
                }
                M[i][j] =
                    (i == j ? l1 : 0) + linear*B[i][j] + square*sum;
            }
        }
    }
};


//- Change of what friction and conduction carry through a unit area with
//  normal n over a unit distance, with the conserved variables of the cell
//  before it; u is the velocity on the area
template<int nDim>
inline void frictionJacobian
(
    const double* q,
    const double* u,
    const double* n,
    const double mu,
    const double lambda,
    const gasEquationOfState& gas,
    double (&D)[nDim + 2][nDim + 2]
)
{
    constexpr int nVar = nDim + 2;
    const double T = q[1];
    const bool thermally = gas.thermallyPerfect();
    const double e = thermally ? gas.energy<true>(T) : gas.energy<false>(T);
    const double cv = thermally ? gas.specificHeat<true>(T) : gas.cv;
    const double v = gas.R*T/q[0];

    // Changes of the velocities and of the temperature
    double du[nDim][nVar] = {};
    double dT[nVar];
    double uu = 0;
    for (int d = 0; d < nDim; d++)
    {
        du[d][0] = -q[2 + d]*v;
        du[d][2 + d] = v;
        dT[2 + d] = -q[2 + d]*v/cv;
        uu += q[2 + d]*q[2 + d];
    }
    dT[0] = (0.5*uu - e)*v/cv;
    dT[1] = v/cv;

    for (int j = 0; j < nVar; j++)
    {
        double along = 0;
        for (int d = 0; d < nDim; d++)
        {
            along += n[d]*du[d][j];
        }
        D[0][j] = 0;
        D[1][j] = lambda*dT[j];
        for (int d = 0; d < nDim; d++)
        {
            D[2 + d][j] = mu*(du[d][j] + along*n[d]/3);
            D[1][j] += u[d]*D[2 + d][j];
        }
    }
}


template<int n>
inline void invert(float* M)
{
    double w[n][2*n];
    for (int i = 0; i < n; i++)
    {
        for (int j = 0; j < n; j++)
        {
            w[i][j] = M[i*n + j];
            w[i][n + j] = i == j;
        }
    }
    for (int k = 0; k < n; k++)
    {
        int pivot = k;
        for (int i = k + 1; i < n; i++)
        {
            pivot = std::fabs(w[i][k]) > std::fabs(w[pivot][k]) ? i : pivot;
        }
        if (pivot != k)
        {
            std::swap_ranges(w[k], w[k] + 2*n, w[pivot]);
        }
        const double d = w[k][k] != 0 ? 1/w[k][k] : 1;
        for (int j = k; j < 2*n; j++)
        {
            w[k][j] *= d;
        }
        for (int i = 0; i < n; i++)
        {
            if (i != k)
            {
                const double f = w[i][k];
                for (int j = k; j < 2*n; j++)
                {
                    w[i][j] -= f*w[k][j];
                }
            }
        }
    }
    for (int i = 0; i < n; i++)
    {
        std::copy(w[i] + n, w[i] + 2*n, M + i*n);
    }
}


//- y -= M x
template<int n>
inline void subtractProduct(const float* M, const double* x, double* y)
{
    for (int i = 0; i < n; i++)
    {
        double sum = 0;
        for (int j = 0; j < n; j++)
        {
            sum += M[i*n + j]*x[j];
        }
        y[i] -= sum;
    }
}


template<int n, class Type>
inline void multiplyBlocks(const Type* a, const float* b, double* c)
{
    for (int i = 0; i < n; i++)
    {
        for (int j = 0; j < n; j++)
        {
            double sum = 0;
            for (int k = 0; k < n; k++)
            {
                sum += a[i*n + k]*b[k*n + j];
            }
            c[i*n + j] = sum;
        }
    }
}

} // End anonymous namespace
} // End namespace Foam


void Foam::NewtonKrylov::setBlocks()
{
    const gasMesh& mesh = gas_.geometry();

    std::vector<std::vector<int>> columns(nCells_);
    for (label r = 0; r < nCells_; r++)
    {
        columns[r].assign(1, r);
        for (int i = mesh.cellStart[r]; i < mesh.cellStart[r + 1]; i++)
        {
            if (mesh.neighbour[i] < nCells_)
            {
                columns[r].push_back(mesh.neighbour[i]);
            }
        }
        std::sort(columns[r].begin(), columns[r].end());
        columns[r].erase
        (
            std::unique(columns[r].begin(), columns[r].end()),
            columns[r].end()
        );
    }
    const auto number = [&](std::vector<int>& start, const bool lower)
    {
        start.assign(1, int(column_.size()));
        for (label r = 0; r < nCells_; r++)
        {
            for (const int c : columns[r])
            {
                if ((c < r) == lower)
                {
                    column_.push_back(c);
                }
            }
            start.push_back(int(column_.size()));
        }
    };
    number(lower_, true);
    number(diagonal_, false);

    auto place = [&](const int row, const int c)
    {
        const std::vector<int>& start = c < row ? lower_ : diagonal_;
        const auto begin = column_.begin() + start[row];
        const auto end = column_.begin() + start[row + 1];
        return int(std::lower_bound(begin, end, c) - column_.begin());
    };

    ownerBlock_.resize(mesh.nInternal());
    farBlock_.resize(mesh.nInternal());
    for (label f = 0; f < mesh.nInternal(); f++)
    {
        const int o = mesh.owner[f];
        const int r = mesh.far[f];
        ownerBlock_[f] = place(o, r);
        farBlock_[f] = place(r, o);
    }
    block_.resize(column_.size()*nVar_*nVar_);
}


template<int nVar>
void Foam::NewtonKrylov::add
(
    const int place,
    const label r,
    const label c,
    const double share,
    const double (&M)[nVar][nVar]
)
{
    float* B = &block_[place*nVar*nVar];
    const double* rows = &equationScale_[r*nVar];
    const double* columns = &unknownScale_[c*nVar];
    for (int i = 0; i < nVar; i++)
    {
        const double s = share/rows[i];
        for (int j = 0; j < nVar; j++)
        {
            B[i*nVar + j] += s*M[i][j]*columns[j];
        }
    }
}


void Foam::NewtonKrylov::findClosed()
{
    const gasMesh& mesh = gas_.geometry();
    closed_.assign(mesh.nFaces() - mesh.nInternal(), false);
    for (size_t k = 0; k < mesh.patches().size(); k++)
    {
        const gasMesh::patchRange& patch = mesh.patches()[k];
        for (label i = 0; i < patch.size && !patch.coupled; i++)
        {
            const label f = patch.start + i;
            double un;
            closed_[f - mesh.nInternal()] = gas_.impermeable(k, f, un);
        }
    }
}


template<int nDim>
void Foam::NewtonKrylov::addConvection()
{
    constexpr int nVar = nDim + 2;
    const gasMesh& mesh = gas_.geometry();
    const gasEquationOfState& eos = gas_.equationOfState();
    const double* primitive = gas_.primitive.data();

    // Share of the largest speed below which no wave's dissipation falls. Where
    // cells do not stand on lines the factors of less than Rusanov's amplify
    // what they are to damp; on layers around a body it would cost twice as
    // many Krylov vectors.
    const double floor = mesh.anyUnaligned ? 1 : 0.1;

    for (label f = 0; f < mesh.nFaces(); f++)
    {
        const label o = mesh.owner[f];
        const label r = mesh.far[f];
        const double* n = &mesh.normal[f*nDim];
        const double* qo = primitive + o*nVar;
        const double* qr = primitive + r*nVar;
        const double half = 0.5*mesh.area[f];
        const int diagonal = diagonal_[o];

        const fluxJacobian<nDim> Ao(qo, n, eos);

        if (f >= mesh.nInternal() && closed_[f - mesh.nInternal()])
        {
            // Pressure alone, and that of the cell
            double P[nVar][nVar] = {};
            for (int k = 0; k < nDim; k++)
            {
                for (int j = 0; j < nVar; j++)
                {
                    P[2 + k][j] = Ao.dp[j]*n[k];
                }
            }
            add(diagonal, o, o, 2*half, P);
            continue;
        }

        double mean[nVar];
        for (int k = 0; k < nVar; k++)
        {
            mean[k] = 0.5*(qo[k] + qr[k]);
        }
        const fluxJacobian<nDim> between(mean, n, eos);
        double M[nVar][nVar];
        between.magnitude(floor, M);

        add(diagonal, o, o, half, Ao.A);
        add(diagonal, o, o, half, M);

        if (f < mesh.nInternal())
        {
            const fluxJacobian<nDim> Ar(qr, n, eos);
            const int diagonalFar = diagonal_[r];
            add(diagonalFar, r, r, -half, Ar.A);
            add(diagonalFar, r, r, half, M);
            add(ownerBlock_[f], o, r, half, Ar.A);
            add(ownerBlock_[f], o, r, -half, M);
            add(farBlock_[f], r, o, -half, Ao.A);
            add(farBlock_[f], r, o, -half, M);
        }
    }
}


template<int nDim>
void Foam::NewtonKrylov::addDiffusion()
{
    constexpr int nVar = nDim + 2;
    const gasMesh& mesh = gas_.geometry();
    const gasEquationOfState& eos = gas_.equationOfState();
    const double* primitive = gas_.primitive.data();

    auto faces =
        [&](const label start, const label end, const bool slips = false)
    {
        for (label f = start; f < end; f++)
        {
            const label o = mesh.owner[f];
            const label r = mesh.far[f];
            const double* n = &mesh.normal[f*nDim];
            const double* qo = primitive + o*nVar;
            const double* qr = primitive + r*nVar;

            gasEquations::faceTransport t = gas_.transport(f);
            t.mu = slips ? 0 : t.mu;
            const double share = mesh.area[f]/mesh.normalDistance[f];
            const bool inner = f < mesh.nInternal();

            double D[nVar][nVar];
            double u[nDim];
            for (int d = 0; d < nDim; d++)
            {
                u[d] = inner ? 0.5*(qo[2 + d] + qr[2 + d]) : qr[2 + d];
            }
            frictionJacobian<nDim>(qo, u, n, t.mu, t.lambda, eos, D);
            add(diagonal_[o], o, o, share, D);
            if (inner)
            {
                add(farBlock_[f], r, o, -share, D);
                frictionJacobian<nDim>(qr, u, n, t.mu, t.lambda, eos, D);
                add(diagonal_[r], r, r, share, D);
                add(ownerBlock_[f], o, r, -share, D);
            }
        }
    };

    faces(0, mesh.nInternal());
    for (const gasMesh::patchRange& patch : mesh.patches())
    {
        const bool slips = gas_.frictionless(patch.patchi);
        if
        (
            patch.coupled
         || !(patch.image() || (slips && !gas_.fixesT(patch.patchi)))
        )
        {
            faces(patch.start, patch.start + patch.size, slips);
        }
    }
}


template<int nDim>
void Foam::NewtonKrylov::assemble(const scalar Co)
{
    constexpr int nVar = nDim + 2;
    std::fill(block_.begin(), block_.end(), 0);
    findClosed();
    addConvection<nDim>();
    if (gas_.viscous())
    {
        addDiffusion<nDim>();
    }

    // An incomplete factorisation needs some weight on the diagonal
    const scalar least = 1.0/200;
    for (label r = 0; r < nCells_; r++)
    {
        float* B = &block_[diagonal_[r]*nVar*nVar];
        const double inertia = max(ownStep_[r]/Co, least);
        for (int k = 0; k < nVar; k++)
        {
            B[k*nVar + k] += inertia;
        }
    }

    slow_ = gas_.largestMach(false) < 1;
    if (slow_)
    {
        groups_.set(lower_, diagonal_, column_, block_, equationScale_);
    }
    factorise<nVar>();
}


template<int nVar>
void Foam::NewtonKrylov::factorise()
{
    constexpr int nn = nVar*nVar;
    double L[nn];
    double product[nn];

    for (label r = 0; r < nCells_; r++)
    {
        // The next block of the row
        const auto next = [&](const int j)
        {
            return j + 1 == lower_[r + 1] ? diagonal_[r] : j + 1;
        };
        for (int i = lower_[r]; i < lower_[r + 1]; i++)
        {
            // L = A_ik D_k^-1; the diagonal of a finished row is inverse
            const int k = column_[i];
            float* A = &block_[i*nn];
            multiplyBlocks<nVar>(A, &block_[diagonal_[k]*nn], L);
            std::copy(L, L + nn, A);

            int j = next(i);
            for (int u = diagonal_[k] + 1; u < diagonal_[k + 1]; u++)
            {
                while (j < diagonal_[r + 1] && column_[j] < column_[u])
                {
                    j = next(j);
                }
                if (j < diagonal_[r + 1] && column_[j] == column_[u])
                {
                    multiplyBlocks<nVar>(L, &block_[u*nn], product);
                    float* target = &block_[j*nn];
                    for (int m = 0; m < nn; m++)
                    {
                        target[m] -= product[m];
                    }
                }
            }
        }
        invert<nVar>(&block_[diagonal_[r]*nn]);
    }
}


template<int nVar>
void Foam::NewtonKrylov::precondition
(
    const std::vector<double>& b,
    std::vector<double>& x
)
{
    constexpr int nn = nVar*nVar;
    double y[nVar];

    for (label r = 0; r < nCells_; r++)
    {
        std::copy_n(&b[r*nVar], nVar, y);
        for (int i = lower_[r]; i < lower_[r + 1]; i++)
        {
            subtractProduct<nVar>(&block_[i*nn], &x[column_[i]*nVar], y);
        }
        std::copy_n(y, nVar, &x[r*nVar]);
    }
    for (label r = nCells_ - 1; r >= 0; r--)
    {
        double* xr = &x[r*nVar];
        std::copy_n(xr, nVar, y);
        for (int i = diagonal_[r] + 1; i < diagonal_[r + 1]; i++)
        {
            subtractProduct<nVar>(&block_[i*nn], &x[column_[i]*nVar], y);
        }
        std::fill_n(xr, nVar, 0);
        const float* D = &block_[diagonal_[r]*nn];
        for (int i = 0; i < nVar; i++)
        {
            for (int j = 0; j < nVar; j++)
            {
                xr[i] += D[i*nVar + j]*y[j];
            }
        }
    }
}


void Foam::NewtonKrylov::precondition
(
    const std::vector<double>& b,
    std::vector<double>& x
)
{
    const std::vector<double>* rest = &b;
    if (slow_)
    {
        rest_ = b;
        groups_.remove(rest_);
        rest = &rest_;
    }
    nVar_ == 4 ? precondition<4>(*rest, x) : precondition<5>(*rest, x);
    if (slow_)
    {
        groups_.add(x);
    }
}


template void Foam::NewtonKrylov::assemble<2>(const scalar);
template void Foam::NewtonKrylov::assemble<3>(const scalar);
