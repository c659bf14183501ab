/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "gasEquations.H"

void Foam::gasEquations::reportExpansion() const
{
    if (viscous_ || eos_.thermallyPerfect() || !source_.empty())
    {
        return;
    }

    // What flows into a cell should have its entropy if the pressure falls.
    // The change is that of ln T at the same pressure: s/c_p.
    const double least = 0.02;      // Fall of ln p in a cell that expands
    const scalar bound = 0.1;       // Change of entropy that is told
    const double k = eos_.R/(eos_.R + eos_.cv);
    const label nCells = geometry_.nCells();
    std::vector<double> logP(geometry_.nSlots());
    std::vector<double> entropy(geometry_.nSlots());
    for (label c = 0; c < geometry_.nSlots(); c++)
    {
        const double* q = &primitive[c*nVar_];
        logP[c] = std::log(q[0]);
        entropy[c] = std::log(q[1]) - k*logP[c];
    }

    // Mass flux out of the owner
    std::vector<double> flux(massFlux_);
    flux.resize(geometry_.nFaces(), 0);
    for (const gasMesh::patchRange& patch : geometry_.patches())
    {
        for (label i = 0; i < patch.size && !patch.image(); i++)
        {
            flux[patch.start + i] = phi_.boundaryField()[patch.patchi][i];
        }
    }

    // upstream(c, act): act(what lies upstream, mass flux from there)
    const auto upstream = [&](const label c, const auto& act)
    {
        const int end = geometry_.cellStart[c + 1];
        for (int j = geometry_.cellStart[c]; j < end; j++)
        {
            const label f = geometry_.faceOf[j];
            const double in = geometry_.owner[f] == c ? -flux[f] : flux[f];
            if (in > 0)
            {
                act(geometry_.neighbour[j], in);
            }
        }
    };
    std::vector<double> inflow(nCells, 0);
    std::vector<double> change(nCells, 0);
    for (label c = 0; c < nCells; c++)
    {
        double fall = 0;
        upstream(c, [&](const label u, const double in)
        {
            inflow[c] += in;
            fall += in*(logP[u] - logP[c]);
            change[c] += in*(entropy[c] - entropy[u]);
        });
        change[c] = fall > least*inflow[c] ? change[c]/inflow[c] : 0;
    }

    // Changes go downstream, in sweeps there and back; before the last ones
    // are there, there is less than in the end
    std::vector<double> total(geometry_.nSlots(), 0);
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
                change[c] + (inflow[c] > 0 ? sum/inflow[c] : 0);
            step = max(step, mag(next - total[c]));
            total[c] = next;
        }
        geometry_.exchange(total.data(), 1);
        reduce(step, maxOp<scalar>());
    }

    for (const int sign : {1, -1})
    {
        label n = 0;
        scalar worst = 0;
        vector place(Zero);
        for (label c = 0; c < nCells; c++)
        {
            n += sign*total[c] > bound;
            if (sign*total[c] > worst)
            {
                worst = sign*total[c];
                place = mesh_.C()[geometry_.meshCell[c]];
            }
        }
        reduce(n, sumOp<label>());
        if (worst < returnReduce(worst, maxOp<scalar>()))
        {
            place = vector::uniform(-GREAT);
        }
        reduce(worst, maxOp<scalar>());
        reduce(place, maxOp<vector>());
        if (n)
        {
            WarningInFunction
                << "In " << n << " cells gas that has expanded is "
                << (sign > 0 ? "hotter" : "colder")
                << " than an expansion without losses leaves it, by up to "
                << 100*mag(std::exp(sign*worst) - 1) << " % at "
                << place << ". The gas is steady, but the cells where"
                << " the expansion begins are too large for it: round the"
                << " corner off and take more cells along it. Behind a sharp"
                << " corner smaller cells make the layer thinner, not better"
                << endl;
        }
    }
}
