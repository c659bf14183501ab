/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "gasEquations.H"
#include "wedgeFvPatch.H"
#include "wedgePolyPatch.H"

bool Foam::gasEquations::swirls(const volVectorField& U)
{
    // Conditions that give swirl where the gas or their values have some
    static const wordHashSet passive
    {
        "fixedValue", "zeroGradient", "slip", "noSlip", "partialSlip",
        "symmetry", "symmetryPlane", "wedge", "empty", "calculated",
        "processor", "processorCyclic", "cyclic", "cyclicAMI",
        "supersonicFreestream", "freestream", "freestreamVelocity",
        "inletOutlet", "pressureInletVelocity",
        "pressureInletOutletVelocity", "flowRateInletVelocity",
        "uniformFixedValue", "maxwellSlipU"
    };

    vector around(Zero);
    bool any = false;
    for (const fvPatch& patch : U.mesh().boundary())
    {
        if (isA<wedgeFvPatch>(patch))
        {
            around =
                refCast<const wedgePolyPatch>(patch.patch()).centreNormal();
        }
        any = any || !passive.found(U.boundaryField()[patch.index()].type());
    }

    // More than what files and round-off make of none
    scalar speed = 0;
    scalar swirl = 0;
    const auto look = [&](const vectorField& values)
    {
        for (const vector& u : values)
        {
            speed = max(speed, mag(u));
            swirl = max(swirl, mag(u & around));
        }
    };
    look(U);
    for (const fvPatchVectorField& Up : U.boundaryField())
    {
        if (!isA<wedgeFvPatch>(Up.patch()))
        {
            look(Up);
        }
    }
    reduce(speed, maxOp<scalar>());
    reduce(swirl, maxOp<scalar>());
    return returnReduce(any, orOp<bool>()) || swirl > 1e-6*speed;
}


void Foam::gasEquations::forgetSwirl()
{
    if (!geometry_.inSection())
    {
        return;
    }
    for (vector& u : U_.primitiveFieldRef())
    {
        u[geometry_.turning()] = 0;
    }
    forAll(mesh_.boundary(), patchi)
    {
        if (isA<wedgeFvPatch>(mesh_.boundary()[patchi]))
        {
            phi_.boundaryFieldRef()[patchi] = 0;
        }
    }
}


void Foam::gasEquations::refuseSwirl(const label patchi) const
{
    if (!geometry_.inSection())
    {
        return;
    }
    const fvPatchVectorField& Up = U_.boundaryField()[patchi];
    const fvPatchScalarField& Tp = thermo_.T().boundaryField()[patchi];
    forAll(Up, i)
    {
        const scalar swirl = mag(Up[i][geometry_.turning()]);
        if (swirl > 1e-6*(mag(Up[i]) + std::sqrt(eos_.R*mag(Tp[i]))))
        {
            FatalErrorInFunction
                << "Boundary condition " << Up.type() << " of patch "
                << Up.patch().name() << " lets the gas go around the axis"
                << " of the wedge with " << swirl << " m/s at time "
                << mesh_.time().timeName() << ", but it does not at the start,"
                << " and is solved without swirl." << nl
                << "Begin with some: a millionth of the speed in one cell of"
                << " the field U is enough" << exit(FatalError);
        }
    }
}
