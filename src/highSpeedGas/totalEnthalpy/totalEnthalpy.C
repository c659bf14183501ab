/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "totalEnthalpy.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::totalEnthalpy::at(const label slot) const
{
    const int nVar = equations_.nVar();
    const gasEquationOfState& gas = equations_.equationOfState();
    const double* q = &equations_.primitive[slot*nVar];
    double uu = 0;
    for (int k = 2; k < nVar; k++)
    {
        uu += q[k]*q[k];
    }
    const double h =
        gas.thermallyPerfect()
      ? gas.enthalpy<true>(q[1]) : gas.enthalpy<false>(q[1]);
    return h + 0.5*uu;
}


Foam::scalar Foam::totalEnthalpy::ofStream() const
{
    // Gas that comes back through a patch by which more leaves is none of it
    const gasMesh& mesh = equations_.geometry();
    scalarField flux(mesh.mesh().boundaryMesh().nNonProcessor(), Zero);
    forAll(flux, patchi)
    {
        flux[patchi] = sum(phi_.boundaryField()[patchi]);
    }
    Pstream::listCombineGather(flux, plusEqOp<scalar>());
    Pstream::listCombineScatter(flux);

    scalar least = GREAT;
    scalar most = -GREAT;
    for (const gasMesh::patchRange& patch : mesh.patches())
    {
        const bool enters = !patch.coupled && flux[patch.patchi] < 0;
        for (label i = 0; i < patch.size && enters; i++)
        {
            if (phi_.boundaryField()[patch.patchi][i] < 0)
            {
                const scalar H = at(mesh.far[patch.start + i]);
                least = min(least, H);
                most = max(most, H);
            }
        }
    }
    reduce(least, minOp<scalar>());
    reduce(most, maxOp<scalar>());
    return most > 0 && most - least < 1e-3*most ? most : 0;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::totalEnthalpy::totalEnthalpy
(
    const gasEquations& equations,
    const surfaceScalarField& phi
)
:
    equations_(equations),
    phi_(phi)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::totalEnthalpy::report() const
{
    const scalar stream = ofStream();
    if (equations_.viscous() || stream == 0)
    {
        return;
    }

    // Captured shocks have such cells, too, but not with all their neighbours
    const gasMesh& mesh = equations_.geometry();
    std::vector<double> off(mesh.nCells());
    for (label c = 0; c < mesh.nCells(); c++)
    {
        off[c] = at(c)/stream - 1;
    }

    label nCells = 0;
    scalar volume = 0;
    scalar sum = 0;
    vector place(Zero);
    for (label c = 0; c < mesh.nCells(); c++)
    {
        scalar least = mag(off[c]);
        for (int i = mesh.cellStart[c]; i < mesh.cellStart[c + 1]; i++)
        {
            const label n = mesh.neighbour[i];
            if (n < mesh.nCells())
            {
                least = min(least, off[c] > 0 ? off[n] : -off[n]);
            }
        }
        if (least > 0.03)
        {
            const scalar V = mesh.volume[c];
            nCells++;
            volume += V;
            sum += V*off[c];
            place += V*mesh.mesh().cellCentres()[mesh.meshCell[c]];
        }
    }
    reduce(nCells, sumOp<label>());
    reduce(volume, sumOp<scalar>());
    reduce(sum, sumOp<scalar>());
    reduce(place, sumOp<vector>());
    if (nCells > 4)
    {
        const scalar mean = sum/volume;
        WarningInFunction
            << "In " << nCells << " cells around " << place/volume
            << " the total enthalpy is " << 100*mag(mean) << " % "
            << (mean < 0 ? "below" : "above") << " that of what flows in. Gas"
            << " that goes round there, as in eddies, gets none of it, and"
            << " without friction nothing else decides on its temperature. Let"
            << " the gas have friction ('viscous yes;')" << endl;
    }
}
