/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "dsmcGas.H"
#include "exactSums.H"
#include "lagrangianFile.H"
#include "maxwellian.H"
#include "runSummary.H"

namespace Foam
{
    // A count, in full
    static int64_t whole(const scalar count)
    {
        return int64_t(count + 0.5);
    }
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::dsmcGas::state Foam::dsmcGas::stateOfAll() const
{
    state s;
    s.count.setSize(names_.size(), 0);
    scalar energy = 0;
    vector momentum(Zero);
    for (label i = 0; i < molecules_.size(); ++i)
    {
        const label typeId = molecules_.payload().typeId[i];
        const scalar m = species_[typeId].mass;
        const impact::vector3 u = molecules_.velocity(i);
        ++s.count[typeId];
        s.mass += m;
        momentum += m*vector(u.x, u.y, u.z);
        energy += 0.5*m*dot(u, u);
    }
    reduce(s.count, sumOp<scalarField>());
    reduce(momentum, sumOp<vector>());
    reduce(s.mass, sumOp<scalar>());
    reduce(energy, sumOp<scalar>());
    const scalar n = sum(s.count);
    if (n > 0)
    {
        s.velocity = momentum/s.mass;
        s.temperature =
            2*max(energy - 0.5*magSqr(momentum)/s.mass, scalar(0))
           /(3*impact::maxwellian::boltzmann*n);
    }
    if (!collisions_.valid() || !(s.temperature > 0))
    {
        return s;
    }

    // Means over pairs at equilibrium: of |c| and of sigma |c|
    const scalar T = s.temperature;
    const scalar density = n*weight_/gSum(cells_.volumes());
    scalar speed = 0;
    forAll(names_, p)
    {
        const scalar share = s.count[p]/n;
        speed += share*impact::maxwellian::meanSpeed(T, species_[p].mass);
        forAll(names_, q)
        {
            s.collisionRate += share*s.count[q]/n*density
               *collisions_->equilibriumSigmaC(p, q, T);
        }
    }
    s.meanFreePath = speed/max(s.collisionRate, VSMALL);
    return s;
}


void Foam::dsmcGas::describe() const
{
    const state whole = stateOfAll();
    const scalar T = whole.temperature;
    const label n = nStart_;
    const scalar density = n*weight_/gSum(cells_.volumes());

    Info<< "Gas" << nl
        << "    species: " << flatOutput(names_) << nl
        << "    simulated molecules: " << n << ", each for " << weight_
        << " real ones" << nl;
    if (!n)
    {
        Info<< "    the domain is empty at the start" << nl << endl;
        return;
    }

    Info<< "    number density: " << density << " 1/m^3, temperature: " << T
        << " K, mean velocity: " << whole.velocity << " m/s" << nl
        << "    molecules per cell: "
        << scalar(n)/returnReduce(mesh_.nCells(), sumOp<label>()) << nl;

    if (whole.collisionRate > 0)
    {
        const scalar rate = whole.collisionRate;
        const scalar path = whole.meanFreePath;
        scalar width = 0;
        forAll(mesh_.cells(), celli)
        {
            for (direction d = 0; d < 3; ++d)
            {
                const scalar perWidth = boxes_[celli].perWidth[d];
                width = max(width, perWidth > 0 ? 1/perWidth : 0);
            }
        }
        reduce(width, maxOp<scalar>());
        const scalar deltaT = mesh_.time().deltaTValue();
        Info<< "    mean free path: " << path
            << " m, greatest cell width: " << width << " m" << nl
            << "    mean collision time: " << 1/rate << " s, time step: "
            << deltaT << " s" << nl;
        if (width > 10*path || deltaT*rate > 10)
        {
            WarningInFunction
                << "Cells and steps are to be below the mean free path "
                << path << " m and the mean collision time " << 1/rate
                << " s. This gas, with cells up to " << width
                << " m and steps of " << deltaT << " s, conducts heat and"
                << " momentum many times as well as a real one" << endl;
        }
        else if (width > path || deltaT*rate > 1)
        {
            Info<< "    (accurate transport needs cells and steps below these"
                << " lengths and times)" << nl;
        }
    }
    Info<< endl;
}


void Foam::dsmcGas::report()
{
    events e = recent_;
    e.sumOverProcessors();
    total_.add(e);
    recent_ = events();

    label n = molecules_.size();
    scalar energy = 0, internal = 0, mass = 0;
    vector momentum(Zero);
    for (label i = 0; i < n; ++i)
    {
        const scalar m = species_[molecules_.payload().typeId[i]].mass;
        const impact::vector3 u = molecules_.velocity(i);
        mass += m;
        momentum += m*vector(u.x, u.y, u.z);
        energy += 0.5*m*dot(u, u);
        internal += molecules_.payload().Ei[i];
    }
    reduce(n, sumOp<label>());
    reduce(mass, sumOp<scalar>());
    reduce(momentum, sumOp<vector>());
    reduce(energy, sumOp<scalar>());
    reduce(internal, sumOp<scalar>());

    Info<< "Time = " << mesh_.time().timeName() << nl
        << "    molecules: " << n;
    if (e.entered || e.left)
    {
        Info<< " (+" << whole(e.entered) << " entered, -" << whole(e.left)
            << " left)";
    }
    Info<< nl;
    if (collisions_.valid())
    {
        Info<< "    collisions per step: " << e.collisions/e.steps
            << ", accepted "
            << 100*e.collisions/max(e.candidates, scalar(1))
            << " % of the candidates" << nl;
    }
    if (e.hits)
    {
        Info<< "    wall hits per step: " << e.hits/e.steps << nl;
    }
    Info<< "    mass: " << weight_*mass << " kg, momentum: "
        << weight_*momentum << " kg m/s" << nl
        << "    energy: " << weight_*(energy + internal) << " J, of it "
        << weight_*internal << " J internal" << nl << endl;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::dsmcGas::account(runSummary& summary) const
{
    events e = recent_;
    e.sumOverProcessors();
    e.add(total_);
    const label n = returnReduce(molecules_.size(), sumOp<label>());
    const label lost = returnReduce(molecules_.nLost(), sumOp<label>());
    const scalar time =
        returnReduce(moveTime_ + collideTime_ + sampleTime_, sumOp<scalar>());

    Info<< "Molecules: " << nStart_ << " at the start + "
        << whole(e.entered) << " entered - " << whole(e.left) << " left - "
        << lost << " lost = " << n
        << " now" << nl;
    if (nStart_ + e.entered - e.left - lost != n)
    {
        FatalErrorInFunction
            << "The balance of molecules does not close"
            << exit(FatalError);
    }
    Info<< "Collisions: " << whole(e.collisions) << " in " << whole(e.steps)
        << " steps, " << e.moleculeSteps/max(time, SMALL)
        << " molecule-steps per CPU s" << nl << endl;

    summary.part("gas, moving", moveTime_);
    summary.part("gas, colliding", collideTime_);
    summary.part("gas, sampling", sampleTime_);
    summary.work
    (
        "molecules", ownSteps_,
        moveTime_ + collideTime_ + sampleTime_
    );
    summary.particles
    (
        {
            "molecules", scalar(nStart_), e.entered, scalar(n), true, e.left, 0
        }
    );
}


void Foam::dsmcGas::writeWeights() const
{
    volScalarField weights
    (
        IOobject
        (
            "decompositionWeights",
            mesh_.time().timeName(),
            mesh_,
            IOobject::NO_READ,
            IOobject::NO_WRITE,
            false
        ),
        mesh_,
        dimensionedScalar(dimless, Zero)
    );
    scalarField& w = weights.primitiveFieldRef();
    forAll(w, celli)
    {
        w[celli] = molecules_.begin(celli + 1) - molecules_.begin(celli);
    }

    // A cell without molecules takes some time, too
    const label nCells = returnReduce(w.size(), sumOp<label>());
    const scalar mean = max(gSum(w)/nCells, SMALL);
    w = (w + 0.01*mean)/(1.01*mean);
    weights.write();
}


bool Foam::dsmcGas::writeObject(FOAM_COMPAT_WRITE_ARGS_UNUSED) const
{
    lagrangianFile::write
    (
        mesh_,
        cloudName,
        cloudHeader,
        const_cast<moleculeArray&>(molecules_)
    );
    IOdictionary state(exactSums::state(mesh_, stateName));
    state.merge(settings());
    const unsigned precision = IOstream::defaultPrecision(17);
    state.regIOobject::write();
    IOstream::defaultPrecision(precision);
    if (means_.valid())
    {
        means_->writeState();
    }
    if (properties_.getOrDefault<Switch>("decompositionWeights", false))
    {
        writeWeights();
    }
    return true;
}
