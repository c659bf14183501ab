/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "endlessStep.H"
#include "gasEquations.H"
#include "basicSymmetryFvPatchFields.H"
#include "mappedPatchBase.H"
#include "mixedFvPatchFields.H"
#include "surfaceInterpolate.H"
#include "wallFvPatch.H"
#include <algorithm>

namespace
{

using namespace Foam;

// Boundary conditions that need nothing beyond p, T, U and phi
const wordHashSet selfContained
{
    "fixedValue", "zeroGradient", "slip", "noSlip", "symmetry",
    "symmetryPlane", "wedge", "empty", "calculated", "cyclic", "processor",
    "processorCyclic", "cyclicAMI", "freestream", "freestreamPressure",
    "freestreamVelocity", "inletOutlet", "outletInlet", "uniformFixedValue",
    "fixedGradient"
};

// Conditions whose velocity is the same at all times: of others that are
// at rest at the start a restart would know nothing
const wordHashSet ofFixedVelocity
{
    "fixedValue", "noSlip", "movingWallVelocity",
    "translatingWallVelocity", "rotatingWallVelocity", "maxwellSlipU"
};

// Conditions that make the velocity of the flux through their patch
const wordHashSet ofFlux
{
    "pressureInletVelocity", "pressureInletUniformVelocity",
    "pressureDirectedInletVelocity", "pressureDirectedInletOutletVelocity",
    "pressureNormalInletOutletVelocity",
    "pressureInletOutletParSlipVelocity", "fluxCorrectedVelocity"
};

// Conditions that take the velocity of what comes in from the gas inside (as
// those of the flux do)
const wordHashSet takesVelocity
{
    "pressureInletOutletVelocity", "zeroGradient"
};

// Conditions on the pressure that leave its value at a wall to the gas
const wordHashSet leavesPressure
{
    "zeroGradient", "calculated", "fixedFluxPressure", "slip", "wedge",
    "symmetry", "symmetryPlane"
};

} // End anonymous namespace

// * * * * * * * * * * * * * * * Set-up  * * * * * * * * * * * * * * * * * * //

void Foam::gasEquations::checkCoupledConditions() const
{
    for (const gasMesh::patchRange& patch : geometry_.patches())
    {
        const fvPatch& fvp = mesh_.boundary()[patch.patchi];
        if (!patch.coupled)
        {
            continue;
        }

        auto check = [&](const word& field, const word& type)
        {
            if (type != fvp.type())
            {
                FatalErrorInFunction
                    << "Field " << field << " has the boundary condition "
                    << type << " on the coupled patch " << fvp.name()
                    << ", across which the gas is taken to be continuous."
                    << nl << "Valid boundary condition: " << fvp.type()
                    << exit(FatalError);
            }
        };
        const label patchi = patch.patchi;
        check("U", U_.boundaryField()[patchi].type());
        check("T", thermo_.T().boundaryField()[patchi].type());
        check("p", thermo_.p().boundaryField()[patchi].type());
    }
}


void Foam::gasEquations::setPatches(const bool steady)
{
    checkCoupledConditions();

    boundaryNeedsProperties_ = false;
    open_ = false;
    bool needsStress = false;
    boolList excluded(mesh_.boundary().size(), false);
    frictionless_.setSize(mesh_.boundary().size(), false);
    ofGradient_.setSize(mesh_.boundary().size(), false);
    wall_.setSize(mesh_.boundary().size(), false);
    ofFlux_.setSize(mesh_.boundary().size(), false);
    pressed_.setSize(mesh_.boundary().size(), false);
    fed_.setSize(mesh_.boundary().size(), false);

    for (const gasMesh::patchRange& patch : geometry_.patches())
    {
        const label patchi = patch.patchi;
        const fvPatch& fvp = mesh_.boundary()[patchi];
        const fvPatchVectorField& Up = U_.boundaryField()[patchi];
        const fvPatchScalarField& pressure =
            thermo_.p().boundaryField()[patchi];

        const bool slip =
            isA<basicSymmetryFvPatchVectorField>(Up) && !patch.image();

        ofFlux_[patchi] = ofFlux.found(Up.type());
        pressed_[patchi] =
            !(patch.coupled || patch.image() || slip)
         && !leavesPressure.found(pressure.type())
         && !ofFixedVelocity.found(Up.type())
         && Up.type() != "uniformFixedValue";
        fed_[patchi] =
            pressed_[patchi]
         && (ofFlux_[patchi] || takesVelocity.found(Up.type()));

        // Whether the condition on U never lets gas through
        // (processor patches differ from rank to rank: no sums over them)
        bool shut = slip;
        if (!patch.coupled)
        {
            const vectorField& Sf = mesh_.Sf().boundaryField()[patchi];
            const vectorField velocity(Up);
            const scalar through = gSumMag(scalarField(velocity & Sf));
            const scalar along = gSum(scalarField(mag(velocity)*mag(Sf)));
            shut =
                slip
             || (ofFixedVelocity.found(Up.type()) && through <= 1e-6*along);
        }

        tight_.push_back(slip || patch.image());
        reconstructed_.push_back
        (
            !patch.coupled && leavesPressure.found(pressure.type())
        );
        outlet_.push_back
        (
            !patch.coupled && !patch.image()
         && Up.type() == "zeroGradient" && pressure.type() == "zeroGradient"
         && thermo_.T().boundaryField()[patchi].type() == "zeroGradient"
        );
        open_ = open_ || !(patch.coupled || patch.image() || shut);
        excluded[patchi] = slip || (shut && !viscous_ && !patch.image());
        frictionless_[patchi] = slip;

        // (mixed conditions say that they fix a value, whatever their share)
        const fvPatchScalarField& Tp = thermo_.T().boundaryField()[patchi];
        ofGradient_[patchi] =
            !Tp.fixesValue()
         || (isA<wallFvPatch>(fvp) && isA<mixedFvPatchScalarField>(Tp));
        wall_[patchi] =
            isA<wallFvPatch>(fvp)
         || (ofFixedVelocity.found(Up.type()) && Up.type() != "fixedValue");

        if (steady)
        {
            checkSteadyConditions(patchi);
        }
        for
        (
            const word& type :
            {
                Up.type(),
                thermo_.T().boundaryField()[patchi].type(),
                pressure.type()
            }
        )
        {
            boundaryNeedsProperties_ =
                boundaryNeedsProperties_ || !selfContained.found(type);
            readsAllCells_ =
                readsAllCells_ || isA<mappedPatchBase>(fvp.patch())
             || type.compare(0, 5, "coded") == 0;
        }
        needsStress = needsStress || Up.type() == "maxwellSlipU";
    }
    reduce(boundaryNeedsProperties_, orOp<bool>());
    reduce(needsStress, orOp<bool>());
    reduce(open_, orOp<bool>());

    if (needsStress)
    {
        tauMC_.reset
        (
            new volTensorField
            (
                IOobject("tauMC", mesh_.time().timeName(), mesh_),
                mesh_,
                dimensionedTensor(dimPressure, Zero)
            )
        );
    }

    geometry_.setLeastSquares(excluded);
    slipWallShear_.set(geometry_, excluded);
}


// * * * * * * * * * * * * * * * State * * * * * * * * * * * * * * * * * * * //

void Foam::gasEquations::initialiseFlux()
{
    const volScalarField& p = thermo_.p();
    const volScalarField& T = thermo_.T();

    rho_.primitiveFieldRef() = p.primitiveField()/(eos_.R*T.primitiveField());
    forAll(rho_.boundaryField(), patchi)
    {
        rho_.boundaryFieldRef()[patchi] ==
            p.boundaryField()[patchi]
           /(eos_.R*T.boundaryField()[patchi]);
    }

    const surfaceVectorField momentum(fvc::interpolate(rho_*U_));
    phi_ = momentum & mesh_.Sf();
    forgetSwirl();
}


bool Foam::gasEquations::sticks() const
{
    bool any = false;
    for (size_t k = 0; viscous_ && k < geometry_.patches().size(); k++)
    {
        const gasMesh::patchRange& patch = geometry_.patches()[k];
        if (patch.coupled || patch.image() || frictionless_[patch.patchi])
        {
            continue;
        }

        // A stream may run along an outer boundary: on a patch that is no
        // wall gas sticks only where it is at rest
        for (label i = 0; i < patch.size && !any; i++)
        {
            double un;
            any =
                impermeable(k, patch.start + i, un)
             && (
                    wall_[patch.patchi]
                 || mag(U_.boundaryField()[patch.patchi][i]) < SMALL
                );
        }
    }
    return returnReduce(any, orOp<bool>());
}


bool Foam::gasEquations::impermeable
(
    const label k,
    const label f,
    double& un
) const
{
    const int nDim = geometry_.nDim();
    const double* q = &primitive[geometry_.far[f]*nVar_];
    un = 0;
    if (tight_[k])
    {
        return true;
    }

    const double* n = &geometry_.normal[f*nDim];
    double uu = 0;
    for (int d = 0; d < nDim; d++)
    {
        un += q[2 + d]*n[d];
        uu += q[2 + d]*q[2 + d];
    }

    // Round-off in a velocity meant to be tangential is no flow
    const double a2 =
        eos_.thermallyPerfect()
      ? eos_.soundSpeedSqr<true>(q[1])
      : eos_.soundSpeedSqr<false>(q[1]);
    if (sqr(un) <= 1e-24*(uu + a2))
    {
        un = 0;
    }
    return sqr(un) <= 1e-12*a2;
}


void Foam::gasEquations::wallPressure
(
    const label f,
    double& p,
    const bool side
) const
{
    const int nDim = geometry_.nDim();
    const label c = geometry_.owner[f];
    const double pc = primitive[c*nVar_];
    const double* g = &gradient_[c*nVar_*nDim];
    double change = 0;
    for (int d = 0; d < nDim; d++)
    {
        change += g[d*nVar_]*geometry_.toFace[f*nDim + d];
    }

    // In the first instants of an impulsive start the pressure next to the
    // wall varies by more than itself
    const double x = max(-0.5, min(0.5, change/pc));
    if (side)
    {
        p = pc*(1 + x);
        return;
    }

    // Behind the edge of a step the gas leaves the wall, and the pressure
    // falls by much of itself within a cell. Extrapolated across such a fan it
    // leaves a layer of wrong entropy on the wall, and that of the cell is
    // nearer.
    double a;
    double un = outwardSpeed(f, &primitive[c*nVar_], a);
    p = pc*(1 + x/(1 + 200*sqr(min(un, 0)/a*x)));

    // The velocity that the gradient gives at the wall, or that of the cell if
    // the gradient is its neighbours'
    const double* n = &geometry_.normal[f*nDim];
    for (int d = 0; d < nDim && !geometry_.flat[c]; d++)
    {
        for (int k = 0; k < nDim; k++)
        {
            un += g[d*nVar_ + 2 + k]*geometry_.toFace[f*nDim + d]*n[k];
        }
    }
    const double gamma = a*a/(eos_.R*primitive[c*nVar_ + 1]);
    if (geometry_.isUnaligned[c])
    {
        // On tetrahedra the gas could flow to and from the wall without being
        // stopped: the wall sends back the acoustic wave that stops it
        p += pc*max(-0.5, min(0.5, gamma*un/a));
    }
    else if (un*x > 0 && (un > 0 || inTime_))
    {
        // Gas that runs into the wall, the pressure rising towards it, is
        // stopped by a shock: behind the tip of a wedge within a few cells
        // instead of tens. From gas that runs off it, the pressure falling, a
        // rarefaction goes out, in time: behind a sharp corner the pressure of
        // the cells would take entropy from the gas at the wall. (The whole of
        // it would give too much of that to gas that turns by a right angle, at
        // the edge of a step.) Smooth flows have none of either: their velocity
        // at the wall is well below a fifth of the speed of sound, or their
        // pressure changes by less than a tenth.
        const double m = mag(un)/a;
        const double M = m*m/(m + (un > 0 ? 0.2 : 0.5))*x*x/(x*x + 0.01);
        if (un > 0)
        {
            const double b = 0.25*(gamma + 1)*M;
            p *= 1 + gamma*M*(b + std::sqrt(1 + b*b));
        }
        else
        {
            const double r = max(1 - 0.5*(gamma - 1)*M, 0.0);
            p *= std::pow(r, 2*gamma/(gamma - 1));
        }
    }
}


void Foam::gasEquations::setBoundaryProperties()
{
    if (!boundaryNeedsProperties_)
    {
        return;
    }

    if (!properties_->local())
    {
        properties_->update();
    }
    else
    {
        for (const gasMesh::patchRange& patch : geometry_.patches())
        {
            if (patch.coupled || patch.image())
            {
                continue;
            }
            for (label f = patch.start; f < patch.start + patch.size; f++)
            {
                properties_->setCell(geometry_.meshCell[geometry_.owner[f]]);
            }
            properties_->setPatch(patch.patchi);
        }
    }

    if (tauMC_.valid())
    {
        setBoundaryStress();
    }
}


void Foam::gasEquations::setBoundaryStress()
{
    const int nDim = geometry_.nDim();
    const volScalarField& T = thermo_.T();

    for (const gasMesh::patchRange& patch : geometry_.patches())
    {
        if (patch.coupled || patch.image())
        {
            continue;
        }
        const label patchi = patch.patchi;
        const fvPatchVectorField& Up = U_.boundaryField()[patchi];
        const vectorField n(Up.patch().nf());
        const vectorField snGrad(Up.snGrad());
        tensorField stress(patch.size);

        for (label i = 0; i < patch.size; i++)
        {
            // Gradient in the cell, its normal part replaced by the one at
            // the face
            const label f = patch.start + i;
            const double* g =
                &gradient_[geometry_.owner[f]*(nVar_*nDim)];
            tensor gradU(Zero);
            for (int d = 0; d < nDim; d++)
            {
                for (int k = 0; k < nDim; k++)
                {
                    gradU
                    (
                        geometry_.direction(d), geometry_.direction(k)
                    ) = g[d*nVar_ + 2 + k];
                }
            }
            gradU += n[i]*(snGrad[i] - (n[i] & gradU));
            stress[i] =
                eos_.viscosity(T.boundaryField()[patchi][i])
               *dev2(gradU.T());
        }
        tauMC_->boundaryFieldRef()[patchi] == stress;
    }
}


void Foam::gasEquations::evaluateVelocity(const label patchi)
{
    fvPatchVectorField& Up = U_.boundaryFieldRef()[patchi];
    if (!ofFlux_[patchi])
    {
        Up.evaluate();
        return;
    }

    // The flux through a boundary face is that of the velocity on it: made of
    // each other the two would stay what they are at the start. The velocity
    // is made of what the cell brings to the face
    scalarField& phip = phi_.boundaryFieldRef()[patchi];
    const scalarField flux(phip);
    phip =
        rho_.boundaryField()[patchi]
       *(Up.patchInternalField() & mesh_.Sf().boundaryField()[patchi]);
    Up.evaluate();
    phip = flux;
}


void Foam::gasEquations::correctBoundary()
{
    volScalarField& p = thermo_.p();
    volScalarField& T = thermo_.T();
    const endlessStep step(mesh_.time(), marching_);

    // Most boundary conditions read the fields next to the boundary only
    for (label c = 0; readsAllCells_ && c < geometry_.nCells(); c++)
    {
        publishCell(c);
    }
    for (const gasMesh::patchRange& patch : geometry_.patches())
    {
        const label n = patch.image() || readsAllCells_ ? 0 : patch.size;
        for (label f = patch.start; f < patch.start + n; f++)
        {
            publishCell(geometry_.owner[f]);
        }
    }

    setBoundaryProperties();

    for (const gasMesh::patchRange& patch : geometry_.patches())
    {
        if (patch.coupled || patch.image())
        {
            continue;
        }
        const label patchi = patch.patchi;
        evaluateVelocity(patchi);
        if (fed_[patchi])
        {
            evaluateAmbience(patchi);
        }
        else
        {
            T.boundaryFieldRef()[patchi].evaluate();
            p.boundaryFieldRef()[patchi].evaluate();
        }
        rho_.boundaryFieldRef()[patchi] ==
            p.boundaryField()[patchi]
           /(eos_.R*T.boundaryField()[patchi]);
    }

    takeBoundary();
}


void Foam::gasEquations::keepBoundary()
{
    const label n = mesh_.boundary().size();
    kept_.U.setSize(n);
    kept_.T.setSize(n);
    kept_.p.setSize(n);
    for (const gasMesh::patchRange& patch : geometry_.patches())
    {
        if (!patch.coupled && !patch.image())
        {
            const label i = patch.patchi;
            kept_.U[i] = U_.boundaryField()[i];
            kept_.T[i] = thermo_.T().boundaryField()[i];
            kept_.p[i] = thermo_.p().boundaryField()[i];
        }
    }
    if (tauMC_.valid())
    {
        kept_.gradient = gradient_;
    }
}


void Foam::gasEquations::restoreBoundary()
{
    for (const gasMesh::patchRange& patch : geometry_.patches())
    {
        if (!patch.coupled && !patch.image())
        {
            const label i = patch.patchi;
            U_.boundaryFieldRef()[i] == kept_.U[i];
            thermo_.T().boundaryFieldRef()[i] == kept_.T[i];
            thermo_.p().boundaryFieldRef()[i] == kept_.p[i];
        }
    }
}


void Foam::gasEquations::correctKeptBoundary()
{
    if (!boundaryNeedsProperties_)
    {
        correctBoundary();
        return;
    }
    restoreBoundary();
    if (tauMC_.valid())
    {
        gradient_ = kept_.gradient;
    }

    // Where the gas slips along a wall by as much as its own velocity, each
    // repetition leaves four tenths of the difference
    for (int i = 0; i < 4; i++)
    {
        correctBoundary();
    }
}


void Foam::gasEquations::settleBoundary()
{
    const auto start = primitive.begin() + geometry_.nCells()*nVar_;
    std::vector<double> before;
    bool same = false;
    for (int i = 0; i < 20 && !same; i++)
    {
        before.assign(start, primitive.end());
        correctBoundary();
        same = true;
        for (size_t k = 0; k < before.size(); k++)
        {
            same = same && mag(start[k] - before[k]) <= 1e-14*mag(start[k]);
        }
        reduce(same, andOp<bool>());
    }
}


void Foam::gasEquations::takeBoundary()
{
    const volScalarField& p = thermo_.p();
    const volScalarField& T = thermo_.T();
    const int nDim = geometry_.nDim();
    const label nCells = geometry_.nCells();
    const label nInternal = geometry_.nInternal();
    brokenFace_ = -1;

    label k = -1;
    for (const gasMesh::patchRange& patch : geometry_.patches())
    {
        k++;
        if (patch.coupled || patch.image())
        {
            continue;
        }
        const label patchi = patch.patchi;
        const fvPatchVectorField& Up = U_.boundaryField()[patchi];
        const fvPatchScalarField& Tp = T.boundaryField()[patchi];
        const fvPatchScalarField& pp = p.boundaryField()[patchi];
        refuseSwirl(patchi);
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
            if (rough_ && outlet_[k])
            {
                drain(patch.start + i, q);
            }
            if (pressed_[patchi])
            {
                leave(patch.start + i, q, fed_[patchi]);
            }
        }
    }

    geometry_.reflect(primitive.data());
    geometry_.exchange(primitive.data(), nVar_);
}
