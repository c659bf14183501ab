/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "solidParticles.H"
#include "solidWalls.H"
#include "checked.H"
#include "coreVector.H"
#include "lagrangianFile.H"
#include "presentFile.H"
#include "sizeGroups.H"
#include "wallLayer.H"
#include "wallPolyPatch.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::solidParticles::readGroups()
{
    const dictionary& d = getBlock(properties_, "groups");
    const word type(getWordOf(d, "type", "", {"list", "lognormal"}));
    std::vector<impact::sizeGroups::group> sizes;
    if (type == "list")
    {
        refuseOthers(d, {"type", "diameters", "massFractions"});
        const scalarList diameters
        (
            getNumbers(d, "diameters", validRange::diameter)
        );
        const scalarList fractions
        (
            getNumbers(d, "massFractions", validRange::number)
        );
        sizes = checked
        (
            d,
            [&]
            {
                return impact::sizeGroups::list
                (
                    {diameters.begin(), diameters.end()},
                    {fractions.begin(), fractions.end()}
                );
            }
        );
    }
    else
    {
        refuseOthers
        (
            d, {"type", "radius", "deviation", "weighting", "classes"}
        );
        const word weighting
        (
            getWordOf(d, "weighting", "", {"number", "mass"})
        );
        const scalar radius = getNumber(d, "radius", validRange::diameter);
        const scalar deviation = getNumber(d, "deviation", "(1, 10]");
        const label classes = getNumber<label>(d, "classes", "[1, 100]");
        sizes = checked
        (
            d,
            [&]
            {
                return impact::sizeGroups::lognormal
                (
                    radius, deviation,
                    weighting == "mass"
                  ? impact::sizeGroups::weighting::mass
                  : impact::sizeGroups::weighting::number,
                    classes
                );
            }
        );
    }
    for (const auto& size : sizes)
    {
        groups_.append({size.diameter, 0, size.massFraction});
    }
}


void Foam::solidParticles::readExchange()
{
    typedef impact::solidExchange law;
    const dictionary& material = getBlock(properties_, "material");
    refuseOthers(material, {"density", "specificHeat"});
    material_ =
    {
        getNumber(material, "density", validRange::density),
        getNumber(material, "specificHeat", "(0, 1e9) J/(kg K)"),
        getNumber(properties_, "accommodation", validRange::share)
    };
    const word mode
    (
        getWord(properties_, "exchange", {"perCell", "perCollision", "none"})
    );
    const word deflection
    (
        getWord(properties_, "deflection", {"exact", "polynomial"})
    );
    std::vector<double> diameters;
    for (const auto& group : groups_)
    {
        diameters.push_back(group.diameter);
    }
    exchange_ = checked
    (
        properties_,
        [&]
        {
            return autoPtr<law>
            (
                new law
                (
                    gas_.species(), material_, diameters,
                    mode == "perCell" ? law::mode::perCell
                  : mode == "perCollision" ? law::mode::perCollision
                  : law::mode::none,
                    deflection == "exact"
                  ? impact::sphereReflection::law::exact
                  : impact::sphereReflection::law::polynomial,
                    seed_
                )
            );
        }
    );
    forAll(groups_, g)
    {
        groups_[g].mass = exchange_->sizeOf(g).mass;
    }
    readCorrection();
    readLedger();
}


void Foam::solidParticles::readCorrection()
{
    const word name("knudsenCorrection");
    if (!properties_.isDict(name))
    {
        const word value(properties_.lookupOrDefault<word>(name, "off"));
        if (value != "off")
        {
            refuse
            (
                properties_, name, value,
                "off, or a block { drag ...; heat ...; }"
            );
        }
        return;
    }
    const dictionary& dict = getBlock(properties_, name);
    refuseOthers(dict, {"drag", "heat", "densityScale"});
    const auto law = [&]
    (
        const word& entry,
        const std::vector<std::string>& names
    )
    {
        wordList words(names.size());
        forAll(words, i)
        {
            words[i] = names[i];
        }
        return getWordOf(dict, entry, "", words);
    };
    const word drag(law("drag", impact::knudsenCorrection::dragLaws()));
    const word heat(law("heat", impact::knudsenCorrection::heatLaws()));
    const scalar densityScale =
        getNumber(dict, "densityScale", "(0, 1e12]", scalar(1));
    if (!(gas_.referenceTemperature() > 0))
    {
        FatalIOErrorInFunction(dict)
            << "A gas without collisions between its molecules has no"
            << " viscosity: its Knudsen number is infinite"
            << exit(FatalIOError);
    }
    checked
    (
        properties_,
        [&]
        {
            exchange_->correct
            (
                gas_.referenceTemperature(), drag, heat, densityScale
            );
            return true;
        }
    );
    Info<< "    exchange corrected for the Knudsen number by " << drag
        << " and " << heat;
    if (densityScale != 1)
    {
        Info<< ", in a gas " << densityScale << " times as dense";
    }
    Info<< endl;
}


void Foam::solidParticles::readRotation()
{
    const word name("rotation");
    const string why(exchange_->whyNoSpin());
    const bool given =
        solidWalls::giveSpin(properties_, mesh_.boundaryMesh());
    const bool spins =
        properties_.getOrDefault<Switch>(name, given && why.empty());
    if (spins)
    {
        checked
        (
            properties_,
            [&]
            {
                exchange_->rotate();
                return true;
            }
        );
    }
    Info<< "    spin: " << (spins ? "followed" : "not followed, ");
    if (!spins)
    {
        Info<< (
                properties_.found(name) ? "rotation no"
              : given ? why.c_str() : "no wall gives any"
            );
    }
    Info<< endl;

    // As the models of the walls ask for it
    properties_.set(name, word(spins ? "yes" : "no"));
    particles_.payload().spins = spins;
}


bool Foam::solidParticles::readArrays()
{
    solidData& data = particles_.payload();
    const bool spins = data.spins;
    IOobject omega
    (
        lagrangianFile::file(mesh_, cloudName, "omega", IOobject::MUST_READ)
    );
    data.spins =
        spins
     && returnReduce
        (
            omega.typeHeaderOk<IOField<vector>>(true), orOp<bool>()
        );
    const bool found = lagrangianFile::read(mesh_, cloudName, particles_);
    if (found && spins && !data.spins)
    {
        Info<< "    no spin at the start: " << mesh_.time().timeName()
            << "/lagrangian/" << cloudName << " has no file omega" << endl;
    }
    data.omega.resize(spins ? particles_.size() : 0, {0, 0, 0});
    data.spins = spins;
    checkIdentity();
    return found;
}


void Foam::solidParticles::checkIdentity() const
{
    const IOdictionary was
    (
        exactSums::state(mesh_, stateName, IOobject::READ_IF_PRESENT)
    );
    const scalar density = material_.density;
    const scalar before = was.getOrDefault<scalar>("density", density);
    if (mag(before/density - 1) > 1e-9)
    {
        FatalIOErrorInFunction(getBlock(properties_, "material"))
            << "Entry density " << density << ": the particles of "
            << mesh_.time().timePath() << " were written with " << before
            << exit(FatalIOError);
    }

    IOobject sizes
    (
        lagrangianFile::file(mesh_, cloudName, "d", IOobject::MUST_READ)
    );
    IOobject places
    (
        lagrangianFile::file(mesh_, cloudName, "group", IOobject::MUST_READ)
    );
    if
    (
        !sizes.typeHeaderOk<IOField<scalar>>(true)
     || !places.typeHeaderOk<IOField<label>>(true)
    )
    {
        return;
    }
    const scalar tolerance =
        max(1e-5, std::pow(10.0, 1.0 - IOstream::defaultPrecision()));
    const IOField<scalar> d(sizes);
    const IOField<label> group(places);
    for (label i = 0; i < min(d.size(), group.size()); i++)
    {
        // (what ASCII files leave of it)
        if
        (
            group[i] < 0 || group[i] >= groups_.size()
         || mag(d[i]/groups_[group[i]].diameter - 1) > tolerance
        )
        {
            FatalIOErrorInFunction(properties_)
                << "Entry groups: a particle of group " << group[i] << " in "
                << mesh_.time().timePath()/"lagrangian"/cloudName
                << " has the diameter " << d[i] << " m, ";
            if (group[i] >= 0 && group[i] < groups_.size())
            {
                FatalIOError
                    << "that group has " << groups_[group[i]].diameter
                    << " m.";
            }
            else
            {
                FatalIOError << "there are groups 0 to "
                    << groups_.size() - 1 << '.';
            }
            FatalIOError
                << " Go on with the groups that the particles were written"
                << " with" << exit(FatalIOError);
        }
    }
}


void Foam::solidParticles::readLedger()
{
    if (exchange_->twoWay())
    {
        ledger_.resize(mesh_.nCells());
    }
    const auto present = [&](const label k)
    {
        return IOobject
        (
            ledgerNames[k],
            mesh_.time().timeName(),
            mesh_,
            IOobject::MUST_READ,
            IOobject::NO_WRITE
        );
    };
    IOobject P = present(0);
    IOobject E = present(1);
    if
    (
        P.typeHeaderOk<volVectorField>(true)
     && E.typeHeaderOk<volScalarField>(true)
    )
    {
        const volVectorField momentum(P, mesh_);
        const volScalarField energy(E, mesh_);
        if (!exchange_->twoWay())
        {
            WarningInFunction
                << "The ledger of " << mesh_.time().timePath()
                << " holds " << gSum(momentum.primitiveField())
                << " kg m/s and " << gSum(energy.primitiveField())
                << " J that the gas has still to take: with exchange none it"
                << " never does" << endl;
            return;
        }
        forAll(energy, i)
        {
            ledger_[i].momentum = toCore(momentum[i]);
            ledger_[i].energy = energy[i];
            nHolding_ += !ledger_[i].isZero();
        }
    }
}


void Foam::solidParticles::readParticles()
{
    // Particles that have all gone leave no file, but a state
    const bool found = readArrays();
    const IOdictionary state
    (
        exactSums::state(mesh_, stateName, IOobject::READ_IF_PRESENT)
    );
    if (!found && !state.found("initial"))
    {
        inflow_->fill(particles_, seed_);
        name(0);
    }
    label above = 0;
    const solidData& data = particles_.payload();
    for (label i = 0; i < particles_.size(); ++i)
    {
        if
        (
            data.group[i] < 0 || data.group[i] >= groups_.size()
         || !(data.nParticle[i] > 0) || !(data.T[i] >= 0)
        )
        {
            FatalErrorInFunction
                << "Solid particle " << i << " of "
                << mesh_.time().timePath()/"lagrangian"/cloudName
                << " has group " << data.group[i] << ", nParticle "
                << data.nParticle[i] << ", T " << data.T[i]
                << ". Valid range: 0 <= group < " << groups_.size()
                << ", nParticle > 0, T >= 0" << exit(FatalError);
        }
        count(tally_[initial], i);
        if (data.origProc[i] != wallLayer::releasedProc)
        {
            above = max(above, data.origId[i] + 1);
        }
    }

    // Particles may be here that another processor has put in
    if (found)
    {
        nNamed_ = returnReduce(above, maxOp<label>());
    }
}


void Foam::solidParticles::readWalls()
{
    cloud_.reset
    (
        new solidCloud
        (
            cloudName,
            properties_,
            mesh_,
            gas_,
            material_.specificHeat,
            particles_.size()
        )
    );
    scalarList diameters;
    for (const auto& group : groups_)
    {
        diameters.append(group.diameter);
    }
    for (const polyPatch& patch : mesh_.boundaryMesh())
    {
        if (gas_.boundaryU() && isA<wallPolyPatch>(patch))
        {
            gas_.checkWallVelocity(patch.index(), "wall of solid particles");
        }
    }
    walls_.reset
    (
        new solidWalls(properties_, cloud_(), diameters, label(seed_))
    );
}


void Foam::solidParticles::readTallies()
{
    IOdictionary state
    (
        exactSums::state(mesh_, stateName, IOobject::READ_IF_PRESENT)
    );
    if (!state.found("initial"))
    {
        return;
    }

    // The state has the sums over processors: the master goes on with them
    const bool mine = Pstream::master();
    const auto restore = [&](const dictionary& d, tally& t)
    {
        t = tally();
        if (mine)
        {
            t.simulators = std::int64_t(d.get<scalar>("simulators"));
            t.number = d.get<scalar>("number");
            t.mass = d.get<scalar>("mass");
        }
    };
    for (label k = 0; k < nFates; ++k)
    {
        restore(state.subDict(fateNames[k]), tally_[k]);
    }
    std::int64_t balance = 0;
    for (label k = 0; k < nFates; ++k)
    {
        const std::int64_t n = nSimulators(fate(k));
        balance += k <= entered ? n : -n;
    }
    nLostBefore_ =
        label(balance - returnReduce(particles_.size(), sumOp<label>()));
    hits_ = mine ? std::int64_t(state.get<scalar>("hits")) : 0;

    // On as many processors as before each goes on with its own, on others
    // above all given
    const dictionary* named = state.findDict("named");
    const bool same = named && named->size() == Pstream::nProcs();
    nNamed_ = named ? 0 : nNamed_;
    for (const entry& e : named ? *named : dictionary::null)
    {
        if (!same || e.keyword() == processorName(Pstream::myProcNo()))
        {
            nNamed_ = max(nNamed_, named->get<label>(e.keyword()));
        }
    }
    const dictionary& deposits = state.subDict("deposits");
    for (const entry& e : deposits)
    {
        const label patchi = mesh_.boundaryMesh().findPatchID(e.keyword());
        if (patchi >= 0)
        {
            restore(deposits.subDict(e.keyword()), deposits_[patchi]);
        }
    }
}


void Foam::solidParticles::warnOfLargeParticles() const
{
    scalar d = 0;
    for (const auto& group : groups_)
    {
        d = max(d, group.diameter);
    }
    const scalar minSize = Foam::cbrt(gMin(mesh_.V()));
    label nSmall = 0;
    for (const scalar V : mesh_.V())
    {
        nSmall += 3*d > Foam::cbrt(V);
    }
    reduce(nSmall, sumOp<label>());
    if (nSmall)
    {
        WarningInFunction
            << "The largest particles have a diameter of " << d
            << " m. " << nSmall << " of "
            << returnReduce(mesh_.nCells(), sumOp<label>())
            << " cells are less than three times as wide, the smallest "
            << minSize << " m (cube root of its volume)." << nl
            << "    Forces are those of the molecules of one cell: they need"
            << " particles far smaller than their cells" << endl;
    }
    const scalar path = gas_.meanFreePath();
    if (d > path && !properties_.isDict("knudsenCorrection"))
    {
        WarningInFunction
            << "The largest particles have a diameter of " << d
            << " m, the mean free path of the gas is " << path
            << " m: molecules that come back to a particle after a collision"
            << " are not told from others, and force and heat come out too"
            << " large. Laws for all Knudsen numbers: knudsenCorrection"
            << endl;
    }
}


void Foam::solidParticles::warnOfLightParticles()
{
    scalarList minNumbers;
    forAll(groups_, g)
    {
        minNumbers.append(exchange_->minNumber(g, gas_.weight()));
    }
    label nLight = 0;
    const solidData& data = particles_.payload();
    for (label i = 0; i < particles_.size(); ++i)
    {
        nLight += data.nParticle[i] < minNumbers[data.group[i]];
    }
    reduce(nLight, sumOp<label>());
    warnedOfLight_ = true;
    WarningInFunction
        << nLight << " of " << returnReduce(particles_.size(), sumOp<label>())
        << " simulated particles stand for so few real ones that a collision"
        << " with a simulated molecule, which stands for " << gas_.weight()
        << " real ones, could take nearly all of their heat." << nl
        << "    They exchange momentum and energy as with exchange perCell."
        << nl << "    Real particles for a simulated one that perCollision"
        << " needs, by group: " << flatOutput(minNumbers) << nl << endl;
}
