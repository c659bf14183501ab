/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "gasEntropy.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

bool Foam::gasEntropy::known() const
{
    return
        !equations_.viscous()
     && !equations_.equationOfState().thermallyPerfect();
}


Foam::scalar Foam::gasEntropy::at(const label slot) const
{
    const gasEquationOfState& gas = equations_.equationOfState();
    const double* q = &equations_.primitive[slot*equations_.nVar()];
    return std::log(q[1]) - gas.R/(gas.R + gas.cv)*std::log(q[0]);
}


std::vector<double> Foam::gasEntropy::gathered
(
    const std::vector<double>& flux
) const
{
    const gasMesh& mesh = equations_.geometry();
    const label nCells = mesh.nCells();
    const int nVar = equations_.nVar();

    // upstream(c, act): act(what lies upstream, mass flux from there)
    const auto upstream = [&](const label c, const auto& act)
    {
        for (int j = mesh.cellStart[c]; j < mesh.cellStart[c + 1]; j++)
        {
            const label f = mesh.faceOf[j];
            const double in = mesh.owner[f] == c ? -flux[f] : flux[f];
            if (in > 0)
            {
                act(mesh.neighbour[j], in);
            }
        }
    };

    // Only of a supersonic flow: gas in a wake comes round again. And not where
    // streams of different entropy mix.
    const double leastFall = 0.02;      // Of ln p
    const double mostMixed = 0.05;      // Standard deviation of what comes in
    std::vector<double> inflow(nCells, 0);
    std::vector<double> change(nCells, 0);
    std::vector<char> follows(nCells);
    for (label c = 0; c < nCells; c++)
    {
        const double* q = &equations_.primitive[c*nVar];
        const double logP = std::log(q[0]);
        const double entropy = at(c);
        double uu = 0;
        for (int k = 2; k < nVar; k++)
        {
            uu += q[k]*q[k];
        }
        follows[c] =
            uu > equations_.equationOfState().soundSpeedSqr<false>(q[1]);
        double fall = 0;
        double square = 0;
        upstream(c, [&](const label u, const double in)
        {
            const double gain = entropy - at(u);
            inflow[c] += in;
            fall += in*(std::log(equations_.primitive[u*nVar]) - logP);
            change[c] += in*gain;
            square += in*gain*gain;
        });
        const double mean = change[c]/max(inflow[c], VSMALL);
        const bool counts =
            follows[c] && fall > leastFall*inflow[c]
         && square/max(inflow[c], VSMALL) - mean*mean < sqr(mostMixed);
        change[c] = counts ? mean : 0;
    }

    // It goes downstream, in sweeps there and back; before the last ones are
    // there, there is less than in the end
    std::vector<double> total(mesh.nSlots(), 0);
    scalar step = GREAT;
    for (label sweep = 0; sweep < 100 && step > 1e-3; sweep++)
    {
        step = 0;
        for (label i = 0; i < nCells; i++)
        {
            const label c = sweep % 2 ? nCells - 1 - i : i;
            double sum = 0;
            upstream(c, [&](const label u, const double in)
            {
                sum += in*total[u];
            });
            const double next =
                follows[c] && inflow[c] > 0 ? change[c] + sum/inflow[c] : 0;
            step = max(step, mag(next - total[c]));
            total[c] = next;
        }
        mesh.exchange(total.data(), 1);
        reduce(step, maxOp<scalar>());
    }
    return total;
}


Foam::gasEntropy::excess Foam::gasEntropy::above
(
    const std::vector<double>& change,
    const int sign
) const
{
    const gasMesh& mesh = equations_.geometry();
    excess e{0, 0, Zero};
    for (label c = 0; c < mesh.nCells(); c++)
    {
        e.nCells += sign*change[c] > 0.1;
        if (sign*change[c] > e.largest)
        {
            e.largest = sign*change[c];
            e.place = mesh.mesh().cellCentres()[mesh.meshCell[c]];
        }
    }
    reduce(e.nCells, sumOp<label>());
    if (e.largest < returnReduce(e.largest, maxOp<scalar>()))
    {
        e.place = vector::uniform(-GREAT);
    }
    reduce(e.largest, maxOp<scalar>());
    reduce(e.place, maxOp<vector>());
    return e;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::gasEntropy::gasEntropy
(
    const gasEquations& equations,
    const surfaceScalarField& phi
)
:
    equations_(equations),
    phi_(phi)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::gasEntropy::least(const bool ofCells) const
{
    if (!known())
    {
        return -GREAT;
    }
    const gasMesh& mesh = equations_.geometry();
    scalar least = GREAT;
    for (label c = 0; c < mesh.nCells() && ofCells; c++)
    {
        least = min(least, at(c));
    }
    for (const gasMesh::patchRange& patch : mesh.patches())
    {
        for (label i = 0; i < patch.size && !patch.coupled; i++)
        {
            if (phi_.boundaryField()[patch.patchi][i] < 0)
            {
                least = min(least, at(mesh.far[patch.start + i]));
            }
        }
    }
    return returnReduce(least, minOp<scalar>());
}


void Foam::gasEntropy::reportLoss(const scalar least) const
{
    if (!known() || least == -GREAT)
    {
        return;
    }
    std::vector<double> change(equations_.geometry().nCells());
    for (std::size_t c = 0; c < change.size(); c++)
    {
        change[c] = at(c) - least;
    }
    const excess e(above(change, -1));
    if (e.nCells)
    {
        WarningInFunction
            << "In " << e.nCells << " cells the gas has less entropy than any"
            << " had at the start or comes in with, which no gas can lose: for"
            << " its pressure it is up to " << 100*(1 - std::exp(-e.largest))
            << " % too cold, at " << e.place << ". Where it expands the cells"
            << " are too large for that: take more of them along the flow, and"
            << " round corners off" << endl;
    }
}


void Foam::gasEntropy::reportExpansion() const
{
    if (!known())
    {
        return;
    }
    const gasMesh& mesh = equations_.geometry();
    std::vector<double> flux(mesh.nFaces(), 0);
    for (label f = 0; f < mesh.nInternal(); f++)
    {
        flux[f] = mesh.meshSign[f]*phi_[mesh.meshFace[f]];
    }
    for (const gasMesh::patchRange& patch : mesh.patches())
    {
        for (label i = 0; i < patch.size && !patch.image(); i++)
        {
            flux[patch.start + i] = phi_.boundaryField()[patch.patchi][i];
        }
    }
    const std::vector<double> change(gathered(flux));
    for (const int sign : {1, -1})
    {
        const excess e(above(change, sign));
        if (e.nCells)
        {
            WarningInFunction
                << "In " << e.nCells << " cells gas that has expanded is "
                << (sign > 0 ? "hotter" : "colder")
                << " than an expansion without losses leaves it, by up to "
                << 100*mag(std::exp(sign*e.largest) - 1) << " % at "
                << e.place << ". The gas is steady, but the cells where the"
                << " expansion begins are too large for it: take more of them"
                << " along the flow. At a corner round it off: smaller cells"
                << " alone make the layer behind thinner, not better" << endl;
        }
    }
}
