/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "dsmcGas.H"
#include "checked.H"
#include "exactSums.H"
#include "lagrangianFile.H"
#include "maxwellian.H"
#include "presentFile.H"
#include "wallPolyPatch.H"
#include "wordRes.H"

#include <algorithm>
#include <type_traits>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::dsmcGas::checkEntries() const
{
    // Ours, those of the stock program, and its models' coefficients
    refuseOthers
    (
        properties_,
        {
            "wallDiffuseFractions", "sampling", "decompositionWeights",
            "reportEvery", "randomSeed",
            "nEquivalentParticles", "typeIdList", "moleculeProperties",
            "BinaryCollisionModel", "WallInteractionModel",
            "InflowBoundaryModel", "VariableHardSphereCoeffs",
            "LarsenBorgnakkeVariableHardSphereCoeffs",
            "NoBinaryCollisionCoeffs",
            "MixedDiffuseSpecularCoeffs", "MaxwellianThermalCoeffs",
            "SpecularReflectionCoeffs", "FreeStreamCoeffs",
            "NoInflowCoeffs"
        }
    );
}


void Foam::dsmcGas::readSpecies()
{
    weight_ =
        getNumber(properties_, "nEquivalentParticles", "[1e-30, 1e30]");
    seed_ = getNumber<label>(properties_, "randomSeed", validRange::seed, 1);

    names_ = properties_.get<wordList>("typeIdList");
    if (names_.empty())
    {
        FatalIOErrorInFunction(properties_)
            << "Entry typeIdList is empty: name at least one species"
            << exit(FatalIOError);
    }
    const dictionary& all = getBlock(properties_, "moleculeProperties");
    forAll(names_, i)
    {
        const word& name = names_[i];
        if (names_.find(name) != i)
        {
            refuse
            (
                properties_, "typeIdList", name, "a list of different names"
            );
        }
        if (!all.isDict(name))
        {
            FatalIOErrorInFunction(all)
                << "Species " << name << " of typeIdList has no"
                << " sub-dictionary here" << nl
                << "Species found: " << all.toc() << exit(FatalIOError);
        }
        const dictionary& d = getBlock(all, name);
        refuseOthers
        (
            d, {"mass", "diameter", "omega", "internalDegreesOfFreedom"}
        );
        species_.push_back
        (
            {
                getNumber(d, "mass", "[1e-28, 1e-20] kg, of a molecule"),
                getNumber(d, "diameter", "[1e-12, 1e-7] m, of a molecule"),
                d.get<scalar>("omega"),
                int
                (
                    getNumber<label>
                        (d, "internalDegreesOfFreedom", "[0, 1000]")
                )
            }
        );
        // One by one, so that a message has the name of the species
        try
        {
            impact::cellCollisions({species_.back()}, 273, 0, 0);
        }
        catch (const std::invalid_argument& e)
        {
            FatalIOErrorInFunction(d)
                << "Entry " << e.what() << " (species " << name << ')'
                << exit(FatalIOError);
        }
    }
}


void Foam::dsmcGas::readCollisions()
{
    const word model
    (
        getWordOf
        (
            properties_, "BinaryCollisionModel", "",
            {"LarsenBorgnakkeVariableHardSphere", "VariableHardSphere", "none"}
        )
    );
    const bool exchange = model == "LarsenBorgnakkeVariableHardSphere";
    const word exchangeCoeffs("LarsenBorgnakkeVariableHardSphereCoeffs");
    const word elasticCoeffs("VariableHardSphereCoeffs");

    // Coefficients of the model not selected are allowed, misspelt ones not
    refuseOthers(properties_.subOrEmptyDict(elasticCoeffs), {"Tref"});
    refuseOthers
    (
        properties_.subOrEmptyDict(exchangeCoeffs),
        {"Tref", "relaxationCollisionNumber"}
    );
    if (model == "none")
    {
        return;
    }
    const dictionary& coeffs =
        getBlock(properties_, exchange ? exchangeCoeffs : elasticCoeffs);
    const scalar Tref = getNumber(coeffs, "Tref", validRange::temperature);
    referenceTemperature_ = Tref;
    const scalar Z =
        exchange
      ? getNumber(coeffs, "relaxationCollisionNumber", "[1, 1e12]") : 0;
    checked
    (
        coeffs,
        [&]
        {
            collisions_.reset
            (
                new impact::cellCollisions(species_, Tref, Z, seed_)
            );
            return true;
        }
    );
}


void Foam::dsmcGas::readWalls()
{
    // What the conditions say now, whatever their entries 'value' have said
    const auto read = [&](auto& field, const word& name)
    {
        typedef std::decay_t<decltype(field())> fieldType;
        IOobject header
        (
            name,
            mesh_.time().timeName(),
            mesh_,
            IOobject::MUST_READ,
            IOobject::AUTO_WRITE
        );
        if (isPresent<fieldType>(header, false))
        {
            field.reset(new fieldType(header, mesh_));
            field->correctBoundaryConditions();
        }
    };
    read(boundaryT_, "boundaryT");
    read(boundaryU_, "boundaryU");
    readDiffuseFractions();
    checkDiffuseWalls();
}


void Foam::dsmcGas::readDiffuseFractions()
{
    const word model
    (
        getWordOf
        (
            properties_, "WallInteractionModel", "",
            {"MaxwellianThermal", "MixedDiffuseSpecular", "SpecularReflection"}
        )
    );
    scalar fraction = 0;
    if (model == "MaxwellianThermal")
    {
        fraction = 1;
    }
    else if (model == "MixedDiffuseSpecular")
    {
        const dictionary& coeffs = getBlock(properties_, model + "Coeffs");
        refuseOthers(coeffs, {"diffuseFraction"});
        fraction = getNumber(coeffs, "diffuseFraction", validRange::share);
    }

    const polyBoundaryMesh& patches = mesh_.boundaryMesh();
    wordList walls;
    forAll(patches, patchi)
    {
        if (isA<wallPolyPatch>(patches[patchi]))
        {
            walls.append(patches[patchi].name());
        }
    }
    diffuseFraction_.setSize(patches.size(), 0);
    forAll(patches, patchi)
    {
        if (walls.found(patches[patchi].name()))
        {
            diffuseFraction_[patchi] = fraction;
        }
    }
    const dictionary* block = findBlock(properties_, "wallDiffuseFractions");
    const dictionary own(block ? *block : dictionary());
    for (const entry& e : own)
    {
        getNumber(own, e.keyword(), validRange::share);
        const wordRe name(e.keyword());
        if
        (
            std::none_of
            (
                walls.begin(), walls.end(),
                [&name](const word& wall) { return name.match(wall); }
            )
        )
        {
            unknownWord(own, "wall", e.keyword(), walls);
        }
    }
    // (a name goes before patterns)
    for (const word& wall : walls)
    {
        own.readIfPresent(wall, diffuseFraction_[patches.findPatchID(wall)]);
    }
}


void Foam::dsmcGas::checkDiffuseWalls() const
{
    const polyBoundaryMesh& patches = mesh_.boundaryMesh();
    forAll(patches, patchi)
    {
        if (diffuseFraction_[patchi] == 0)
        {
            continue;
        }
        const polyPatch& patch = patches[patchi];
        if (!boundaryT_.valid() || !boundaryU_.valid())
        {
            FatalIOErrorInFunction(properties_)
                << "The diffuse wall " << patch.name() << " needs the fields"
                << " boundaryT and boundaryU in " << mesh_.time().timePath()
                << exit(FatalIOError);
        }
        const scalarField& wallT = boundaryT_->boundaryField()[patchi];
        forAll(patch, i)
        {
            if (!within(wallT[i], validRange::temperature))
            {
                refuse
                (
                    dictionary(boundaryT_->objectPath()),
                    "boundaryT of the diffuse wall " + patch.name(), wallT[i],
                    validRange::temperature
                );
            }
        }
        checkWallVelocity(patchi, "diffuse wall");
    }
}


Foam::dictionary Foam::dsmcGas::settings() const
{
    // (No lists of numbers, which the state would have in binary)
    dictionary d;
    d.add("typeIdList", names_);
    forAll(names_, i)
    {
        d.add(word("mass_" + names_[i]), species_[i].mass);
    }
    d.add("nEquivalentParticles", weight_);
    return d;
}


bool Foam::dsmcGas::checkSettings() const
{
    const IOdictionary was
    (
        exactSums::state(mesh_, stateName, IOobject::READ_IF_PRESENT)
    );
    if (!was.found("typeIdList"))
    {
        return false;
    }
    const dictionary is(settings());
    for (const entry& e : is)
    {
        const word& name = e.keyword();
        const bool words = name == "typeIdList";
        const auto value = [&](const dictionary& d)
        {
            std::string text;
            for (const word& w : words ? d.get<wordList>(name) : wordList())
            {
                text += (text.empty() ? "" : " ") + w;
            }
            return words ? '(' + text + ')' : Foam::name(d.get<scalar>(name));
        };
        const bool same =
            words
          ? was.get<wordList>(name) == names_
          : mag(is.get<scalar>(name)/was.get<scalar>(name) - 1) < 1e-9;
        if (!same)
        {
            FatalIOErrorInFunction(properties_)
                << "The molecules of " << mesh_.time().timePath()
                << " were written with " << name << ' ' << value(was).c_str()
                << ", and now it is " << value(is).c_str() << '.' << nl
                << "They would become others. Go on with what they were"
                << " written with. To start anew remove uniform there and run"
                << " dsmcInitialise"
                << exit(FatalIOError);
        }
    }
    return true;
}


void Foam::dsmcGas::readMolecules()
{
    // Molecules that have all gone leave no file, but a state
    const bool found = lagrangianFile::read(mesh_, cloudName, molecules_);
    const bool goesOn = checkSettings();
    nStart_ = returnReduce(molecules_.size(), sumOp<label>());
    if (!returnReduce(found || goesOn || inflow_->active(), orOp<bool>()))
    {
        FatalErrorInFunction
            << "No molecules in "
            << mesh_.time().timePath()/"lagrangian"/cloudName
            << " and no inflow. Run dsmcInitialise first"
            << exit(FatalError);
    }
    for (label i = 0; i < molecules_.size(); ++i)
    {
        const label typeId = molecules_.payload().typeId[i];
        if (typeId < 0 || typeId >= names_.size())
        {
            FatalErrorInFunction
                << "Molecule " << i << " has typeId " << typeId
                << ". Valid range: 0 <= typeId < " << names_.size()
                << ", the number of species" << exit(FatalError);
        }
    }
}


void Foam::dsmcGas::makeBoxes()
{
    boxes_.resize(mesh_.nCells());
    forAll(mesh_.cells(), celli)
    {
        const boundBox box(mesh_.points(), mesh_.cellPoints()[celli], false);
        for (direction d = 0; d < 3; ++d)
        {
            boxes_[celli].corner[d] = box.min()[d];
            boxes_[celli].perWidth[d] =
                cells_.moving()[d] == 0 ? 0 : 1/box.span()[d];
        }
    }
}


void Foam::dsmcGas::refuseOtherMeans(const dictionary& functions) const
{
    for (const entry& e : functions)
    {
        if
        (
            !e.isDict()
         || e.dict().getOrDefault<word>("type", "") != "fieldAverage"
        )
        {
            continue;
        }
        for (const token& t : e.dict().lookup("fields"))
        {
            if (t.isWord() && mesh_.thisDb().found(t.wordToken() + "Mean"))
            {
                FatalIOErrorInFunction(e.dict())
                    << "Field " << t.wordToken() << "Mean of the function"
                    << " object " << e.keyword() << " (fieldAverage) is"
                    << " written by the block sampling of the gas as well, over"
                    << " times of its own: valid is one of them"
                    << exit(FatalIOError);
            }
        }
    }
}


void Foam::dsmcGas::readSampling()
{
    reportEvery_ =
        getNumber<label>(properties_, "reportEvery", validRange::count, 10);

    const dictionary* functions =
        mesh_.time().controlDict().findDict("functions");
    if (functions && !functions->empty())
    {
        instantaneous_.reset
        (
            new gasFields(mesh_, cells_.volumes(), species_, weight_, "")
        );
    }

    if (const dictionary* sampling = findBlock(properties_, "sampling"))
    {
        refuseOthers(*sampling, {"start", "every"});
        samplingStart_ =
            getNumber(*sampling, "start", validRange::time, scalar(0));
        samplingEvery_ =
            getNumber<label>(*sampling, "every", validRange::count, 1);
        means_.reset
        (
            new gasFields(mesh_, cells_.volumes(), species_, weight_, "Mean")
        );
        if (functions)
        {
            refuseOtherMeans(*functions);
        }
        warnOfLateStart
            (*sampling, mesh_.time(), samplingStart_, samplingEvery_);
    }
}


void Foam::dsmcGas::findMaxima()
{
    if (!collisions_.valid())
    {
        return;
    }

    // dsmcInitialise starts at the most probable speed
    const scalar T = stateOfAll().temperature;
    const scalar start = collisions_->startingSigmaCMax(T > 0 ? T : 300);
    sigmaTcRMax_.primitiveFieldRef() =
        max(sigmaTcRMax_.primitiveField(), start);
    sigmaTcRMax_.correctBoundaryConditions();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::dsmcGas::checkWallVelocity
(
    const label patchi,
    const std::string& kind
) const
{
    const polyPatch& patch = mesh_.boundaryMesh()[patchi];
    const vectorField& U = boundaryU_->boundaryField()[patchi];
    forAll(patch, i)
    {
        const vector n = normalised(patch.faceAreas()[i]);
        if
        (
            !(cmptMax(cmptMag(U[i])) < 3e8)
         || mag(U[i] & n) > 1e-6*mag(U[i])
        )
        {
            refuse
            (
                dictionary(boundaryU_->objectPath()),
                "boundaryU of the " + kind + " " + patch.name(), U[i],
                "a velocity along the wall, whose normal is ", n,
                ", less than 3e8 m/s"
            );
        }
    }
}
