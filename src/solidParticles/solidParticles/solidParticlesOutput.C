/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "allGather.H"
#include "solidParticles.H"
#include "solidCloud.H"
#include "coreVector.H"
#include "lagrangianFile.H"
#include "processorPolyPatch.H"
#include "runSummary.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

std::int64_t Foam::solidParticles::nSimulators(const fate k) const
{
    return returnReduce(tally_[k].simulators, sumOp<std::int64_t>());
}


Foam::solidParticles::tally Foam::solidParticles::summed(tally t)
{
    reduce(t.simulators, sumOp<std::int64_t>());
    reduce(t.number, sumOp<scalar>());
    reduce(t.mass, sumOp<scalar>());
    return t;
}


void Foam::solidParticles::describe() const
{
    const label n = returnReduce(particles_.size(), sumOp<label>());
    Info<< "    " << groups_.size() << " groups, diameters (m), mass fractions"
        << ":" << nl;
    for (const auto& group : groups_)
    {
        Info<< "        " << group.diameter << "  " << group.massFraction
            << nl;
    }
    Info<< "    simulated particles: " << n << nl << endl;
}


bool Foam::solidParticles::reportNow() const
{
    const label step = mesh_.time().timeIndex();
    return
        mesh_.time().writeTime()
     || step == mesh_.time().startTimeIndex() + 1
     || step % reportEvery_ == 0;
}


void Foam::solidParticles::report()
{
    impact::solidExchange::counts c = counts_;
    for
    (
        std::int64_t* value :
        {
            &c.pairs, &c.candidates, &c.collisions, &c.beyond, &c.holding,
            &c.light, &c.corrected, &c.inFew
        }
    )
    {
        scalar x = *value;
        reduce(x, sumOp<scalar>());
        *value = std::int64_t(x + 0.5);
    }
    reduce(c.maxHits, maxOp<scalar>());
    reduce(c.minForce, minOp<scalar>());
    impact::solidExchange::gains g = gains_;
    sumOverProcessors(g.solids);
    sumOverProcessors(g.gas);

    tally now;
    for (label i = 0; i < particles_.size(); ++i)
    {
        count(now, i);
    }
    now = summed(now);

    if (c.light && !warnedOfLight_)
    {
        warnOfLightParticles();
    }
    const scalar perTime = 1/duration_;
    Info<< "    solid particles: " << now.simulators << " for " << now.number
        << " real ones, " << now.mass << " kg" << nl
        << "    solids gain: " << perTime*fromCore(g.solids.momentum)
        << " N, " << perTime*g.solids.energy << " W" << nl;
    if (particles_.payload().spins)
    {
        scalar fastest = 0;
        for (const impact::vector3& w : particles_.payload().omega)
        {
            fastest = max(fastest, dot(w, w));
        }
        reduce(fastest, maxOp<scalar>());
        Info<< "    greatest spin: " << Foam::sqrt(fastest) << " rad/s" << nl;
    }
    if (c.minForce < 1)
    {
        Info<< "    least force over the free-molecular one: "
            << c.minForce << nl;
    }
    if (10*c.inFew > c.corrected && !warnedOfFew_)
    {
        warnedOfFew_ = true;
        WarningInFunction
            << "knudsenCorrection: " << 100.*c.inFew/c.corrected << " % of"
            << " the particles whose force it changes are in cells of less"
            << " than " << label(impact::solidExchange::fewMolecules)
            << " molecules, whose velocity by chance counts as slip." << nl
            << "    Slow ones take up to half too much force from 10"
            << " molecules, more than twice as much from 5; a smaller"
            << " nEquivalentParticles or larger cells bring more" << endl;
    }
    if (exchange_->twoWay())
    {
        Info<< "    gas gains by collisions: "
            << perTime*fromCore(g.gas.momentum) << " N, "
            << perTime*g.gas.energy << " W" << nl
            << "    collisions with solids: " << c.collisions << " of "
            << c.candidates << " candidates; greatest number of hits of a"
            << " molecule in a step: " << c.maxHits << nl;
        if (c.maxHits > 10 && !warnedOfHits_)
        {
            warnedOfHits_ = true;
            WarningInFunction
                << "A molecule is hit " << c.maxHits << " times in a step, of"
                << " which one counts: the gas cannot take what the particles"
                << " give it, and the rest waits in the ledger of its cell."
                << nl << "    A deltaT of " << 5/c.maxHits
                << " of this one, or less mass of particles, keeps both"
                << " phases together" << endl;
        }
        if (c.light)
        {
            Info<< "    particles that exchange by the cell, in the steps: "
                << c.light << nl;
        }
        if (c.beyond)
        {
            Info<< "    " << c.beyond << " of them beyond the greatest relative"
                << " speed, which collisions have changed" << nl;
        }
        if (!ledger_.empty())
        {
            impact::balance owed;
            if (nHolding_)
            {
                for (const impact::balance& b : ledger_)
                {
                    owed += b;
                }
            }
            sumOverProcessors(owed);
            Info<< "    ledger: " << fromCore(owed.momentum) << " kg m/s, "
                << owed.energy << " J; cells with an entry in the steps: "
                << c.holding << nl;
        }
        Info<< "    gas + solids + ledger change in this step by: "
            << momentumError_ << " of momentum, " << energyError_
            << " of energy" << nl;
    }
    Info<< endl;

    counts_ = impact::solidExchange::counts();
    gains_ = impact::solidExchange::gains();
    duration_ = 0;
}


void Foam::solidParticles::writeLedger() const
{
    if (!returnReduce(nHolding_, sumOp<label>()))
    {
        return;
    }
    volVectorField momentum
    (
        IOobject(ledgerNames[0], mesh_.time().timeName(), mesh_),
        mesh_,
        dimensionedVector(dimMass*dimVelocity, Zero),
        "zeroGradient"
    );
    volScalarField energy
    (
        IOobject(ledgerNames[1], mesh_.time().timeName(), mesh_),
        mesh_,
        dimensionedScalar(dimEnergy, Zero),
        "zeroGradient"
    );
    forAll(energy, i)
    {
        momentum[i] = fromCore(ledger_[i].momentum);
        energy[i] = ledger_[i].energy;
    }
    momentum.write();
    energy.write();
}


void Foam::solidParticles::writeTallies() const
{
    IOdictionary state(exactSums::state(mesh_, stateName));
    state.add("density", material_.density);
    const auto sums = [](const tally& here)
    {
        const tally t = summed(here);
        dictionary d;
        d.add("simulators", scalar(t.simulators));
        d.add("number", t.number);
        d.add("mass", t.mass);
        return d;
    };
    for (label k = 0; k < nFates; ++k)
    {
        state.add(fateNames[k], sums(tally_[k]));
    }
    state.add("hits", scalar(returnReduce(hits_, sumOp<std::int64_t>())));
    dictionary deposits;
    const polyBoundaryMesh& patches = mesh_.boundaryMesh();
    forAll(patches, patchi)
    {
        if (!isA<processorPolyPatch>(patches[patchi]))
        {
            deposits.add(patches[patchi].name(), sums(deposits_[patchi]));
        }
    }
    state.add("deposits", deposits);
    labelList counts(Pstream::nProcs());
    counts[Pstream::myProcNo()] = nNamed_;
    foamCompat::allGather(counts);
    dictionary named;
    forAll(counts, proci)
    {
        named.add(processorName(proci), counts[proci]);
    }
    state.add("named", named);

    // A restart goes on with the same bits, whatever writePrecision is
    const unsigned precision = IOstream::defaultPrecision(17);
    state.regIOobject::write();
    IOstream::defaultPrecision(precision);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::solidParticles::account(runSummary& summary) const
{
    Info<< "Solid particles (simulated, real, kg)" << nl;
    std::int64_t balance = 0;
    for (label k = 0; k < nFates; ++k)
    {
        const tally t = summed(tally_[k]);
        Info<< "    " << fateNames[k] << ": " << t.simulators << "  "
            << t.number << "  " << t.mass << nl;
        balance += k <= entered ? t.simulators : -t.simulators;
    }
    const label n = returnReduce(particles_.size(), sumOp<label>());
    const label lost =
        nLostBefore_ + returnReduce(particles_.nLost(), sumOp<label>());
    Info<< "    lost: " << lost << ", now: " << n << nl
        << "    wall hits: " << returnReduce(hits_, sumOp<std::int64_t>())
        << nl;
    const polyBoundaryMesh& patches = mesh_.boundaryMesh();
    forAll(patches, patchi)
    {
        if (isA<processorPolyPatch>(patches[patchi]))
        {
            break;
        }
        const tally t = summed(deposits_[patchi]);
        if (t.simulators)
        {
            Info<< "    deposited on " << patches[patchi].name() << ": "
                << t.simulators << "  " << t.number << "  " << t.mass << nl;
        }
    }
    Info<< endl;
    if (interface_.valid())
    {
        interface_->info();
    }
    if (balance - lost != n)
    {
        FatalErrorInFunction
            << "The balance of solid particles does not close"
            << exit(FatalError);
    }

    const auto inThisRun = [&](const fate k)
    {
        return scalar(nSimulators(k) - before_[k]);
    };
    summary.part("solids, moving", moveTime_);
    summary.part("solids, exchange", exchangeTime_);
    summary.work("solids", ownSteps_, moveTime_ + exchangeTime_);
    summary.particles
    (
        {
            "solids", scalar(nStart_), inThisRun(entered), scalar(n), true,
            inThisRun(left) + inThisRun(escaped), inThisRun(stuck)
        }
    );
}


bool Foam::solidParticles::writeObject(FOAM_COMPAT_WRITE_ARGS_UNUSED) const
{
    lagrangianFile::write
    (
        mesh_,
        cloudName,
        cloudHeader,
        const_cast<solidArray&>(particles_)
    );
    scalarField d(particles_.size());
    forAll(d, i)
    {
        d[i] = groups_[particles_.payload().group[i]].diameter;
    }
    lagrangianFile::writeField<scalar>(mesh_, cloudName, "d", d);
    if (!ledger_.empty())
    {
        writeLedger();
    }
    writeTallies();
    cloud_->writeProperties();
    if (fields_.valid())
    {
        fields_->writeState();
    }
    if (interface_.valid())
    {
        interface_->write();
    }
    return true;
}
