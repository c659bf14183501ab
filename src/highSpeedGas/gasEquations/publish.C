/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "endlessStep.H"
#include "gasEquations.H"

void Foam::gasEquations::publishCell(const label c)
{
    const label celli = geometry_.meshCell[c];
    const double* q = &primitive[c*nVar_];
    thermo_.p()[celli] = q[0];
    thermo_.T()[celli] = q[1];
    rho_[celli] = q[0]/(eos_.R*q[1]);
    for (int d = 0; d < geometry_.nDim(); d++)
    {
        U_[celli][geometry_.direction(d)] = q[2 + d];
    }
}


void Foam::gasEquations::publish(const bool asWritten)
{
    volScalarField& p = thermo_.p();
    volScalarField& T = thermo_.T();

    for (label c = 0; c < geometry_.nCells(); c++)
    {
        publishCell(c);
    }

    if (!asWritten)
    {
        const endlessStep step(mesh_.time(), marching_);
        U_.correctBoundaryConditions();
        forAll(ofFlux_, patchi)
        {
            if (ofFlux_[patchi])
            {
                evaluateVelocity(patchi);
            }
        }
        T.correctBoundaryConditions();
        p.correctBoundaryConditions();
        correctBoundary();
    }

    // Gradients for the pressure on the walls
    if (geometry_.nDim() == 2)
    {
        gradients<2>();
    }
    else
    {
        gradients<3>();
    }

    label k = -1;
    for (const gasMesh::patchRange& patch : geometry_.patches())
    {
        k++;
        if (!reconstructed_[k] || patch.image())
        {
            continue;
        }
        scalarField& pp = p.boundaryFieldRef()[patch.patchi];
        forAll(pp, i)
        {
            double un;
            if (impermeable(k, patch.start + i, un))
            {
                wallPressure(patch.start + i, pp[i]);
            }
        }
    }

    forAll(rho_.boundaryField(), patchi)
    {
        rho_.boundaryFieldRef()[patchi] ==
            p.boundaryField()[patchi]
           /(eos_.R*T.boundaryField()[patchi]);
    }

    if (!turbulent())
    {
        publishMassFlux();
    }
    properties_->update();
    checkTemperature();
}


void Foam::gasEquations::publishMassFlux()
{
    for (std::size_t f = 0; f < massFlux_.size(); f++)
    {
        phi_[geometry_.meshFace[f]] = geometry_.meshSign[f]*massFlux_[f];
    }
}


void Foam::gasEquations::storeOldTime()
{
    auto store = [](auto& field)
    {
        // The first call makes the old field without noting the time
        field.oldTime();
        field.storeOldTimes();
    };

    if (turbulent() || boundaryNeedsProperties_)
    {
        store(rho_);
    }
    if (turbulent() || boundaryNeedsProperties_ || U_.nOldTimes())
    {
        store(U_);
    }
    if (boundaryNeedsProperties_)
    {
        store(thermo_.p());
        store(thermo_.T());
    }
}


void Foam::gasEquations::checkTemperature()
{
    if (!eos_.thermallyPerfect())
    {
        return;
    }

    label outside = 0;
    label worst = -1;
    scalar distance = 0;
    for (label c = 0; c < geometry_.nCells(); c++)
    {
        const double T = primitive[c*nVar_ + 1];
        const scalar beyond = max(T - highestT_, lowestT_ - T);
        if (beyond > 0)
        {
            outside++;
            if (beyond > distance)
            {
                distance = beyond;
                worst = c;
            }
        }
    }

    if (returnReduce(outside, sumOp<label>()) == 0)
    {
        warnedOfTemperature_ = false;
        return;
    }

    // Once when it begins, and for every time that is written
    if (!warnedOfTemperature_ || mesh_.time().writeTime())
    {
        WarningInFunction
            << "At time " << mesh_.time().timeName() << ' '
            << returnReduce(outside, sumOp<label>()) << " cells are hotter or"
            << " colder than the thermophysical model is good for, "
            << lowestT_ << " to " << highestT_ << " K; beyond, its specific"
            << " heat is taken to be constant" << endl;
        const scalar furthest = returnReduce(distance, maxOp<scalar>());
        if (worst >= 0 && distance >= furthest)
        {
            const label celli = geometry_.meshCell[worst];
            Pout<< "Gas: cell " << celli << " at " << mesh_.cellCentres()[celli]
                << " has T = " << primitive[worst*nVar_ + 1] << " K" << endl;
        }
    }
    warnedOfTemperature_ = true;
}
