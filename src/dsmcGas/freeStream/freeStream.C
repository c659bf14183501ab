/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "freeStream.H"
#include "checked.H"
#include "maxwellian.H"
#include "wordRes.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

impact::vector3 Foam::freeStream::pointOn
(
    const label boundaryFacei,
    impact::counterRandom& rnd
) const
{
    const polyMesh& mesh = cells_.mesh();
    const label facei = mesh.nInternalFaces() + boundaryFacei;
    const face& f = mesh.faces()[facei];
    const pointField& p = mesh.points();
    const label base = max(mesh.tetBasePtIs()[facei], label(0));

    const auto corner = [&](const label i) -> const point&
    {
        return p[f[(base + i) % f.size()]];
    };
    const auto area = [&](const label i)
    {
        return mag((corner(i) - corner(0)) ^ (corner(i + 1) - corner(0)));
    };

    scalar sum = 0;
    for (label i = 1; i < f.size() - 1; ++i)
    {
        sum += area(i);
    }
    scalar rest = sum*rnd.uniform();
    label i = 1;
    while (i < f.size() - 2 && rest > area(i))
    {
        rest -= area(i++);
    }

    scalar a = rnd.uniform();
    scalar b = rnd.uniform();
    if (a + b > 1)
    {
        a = 1 - a;
        b = 1 - b;
    }
    const point x =
        corner(0) + a*(corner(i) - corner(0)) + b*(corner(i + 1) - corner(0));
    return {x.x(), x.y(), x.z()};
}


Foam::labelList Foam::freeStream::openPatches
(
    const dictionary& dict,
    const word& entryName,
    const wordRe& expression
) const
{
    const polyBoundaryMesh& patches = cells_.mesh().boundaryMesh();
    labelList matched;
    wordList open;
    forAll(patches, patchi)
    {
        if (isType<polyPatch>(patches[patchi]))
        {
            open.append(patches[patchi].name());
            if (expression.match(patches[patchi].name()))
            {
                matched.append(patchi);
            }
        }
    }
    if (matched.empty())
    {
        unknownWord
        (
            dict, (entryName + ": open patch").c_str(), expression, open
        );
    }
    return matched;
}


void Foam::freeStream::addPatch
(
    const dictionary& dict,
    const label patchi,
    const dictionary& densities,
    const wordList& names,
    const scalar weight,
    const scalarField& T,
    const vectorField& U
)
{
    const polyPatch& patch = cells_.mesh().boundaryMesh()[patchi];
    for (const entry& e : densities)
    {
        const label typeId = names.find(e.keyword());
        if (typeId < 0)
        {
            unknownWord(densities, "species", e.keyword(), names);
        }
        const scalar density = getNumber
        (
            densities, e.keyword(), "[0, 1e30] 1/m3, denser than any solid"
        );
        if (density == 0)
        {
            continue;
        }

        forAll(patch, j)
        {
            if (!within(T[j], validRange::temperature))
            {
                refuse
                (
                    dict, "boundaryT", T[j], "on patch ", patch.name(),
                    ", through which gas enters: ", validRange::temperature
                );
            }
            if (!(cmptMax(cmptMag(U[j])) < 3e8))
            {
                refuse
                (
                    dict, "boundaryU", U[j], "on patch ", patch.name(),
                    " of components ", validRange::velocity
                );
            }
            const scalar area = mag(patch.faceAreas()[j]);
            const vector n = -patch.faceAreas()[j]/area;
            const vector slip = U[j] - (U[j] & n)*n;
            source s;
            s.boundaryFace = patch.start() + j - cells_.mesh().nInternalFaces();
            s.typeId = typeId;
            s.temperature = T[j];
            s.speed = impact::maxwellian::mostProbableSpeed
            (
                T[j],
                species_[typeId].mass
            );
            s.speedRatio = (U[j] & n)/s.speed;
            s.flux = area*density/weight*s.speed
                *impact::maxwellian::fluxFactor(s.speedRatio);
            s.inward = {n.x(), n.y(), n.z()};
            s.slip = {slip.x(), slip.y(), slip.z()};
            sources_.push_back(s);
        }
    }
}


void Foam::freeStream::checkWeight
(
    const dictionary& dict,
    const scalar weight
) const
{
    scalar n = 0;
    for (const source& s : sources_)
    {
        n += s.flux*cells_.mesh().time().deltaTValue();
    }
    if (!within(n, "[0, 2147483647]"))
    {
        refuse
        (
            dict, "nEquivalentParticles", weight, "with fewer than 2147483647"
            " molecules that enter in a step, here ", n
        );
    }
    const Time& time = cells_.mesh().time();
    const scalar steps =
        (time.endTime().value() - time.value())/time.deltaTValue();
    if (n > 0 && n*steps < 1)
    {
        WarningInFunction
            << "Of what flows in " << n << " simulated molecules enter in a"
            << " step, in all of the run none. Lower nEquivalentParticles, now "
            << weight << endl;
    }
}


void Foam::freeStream::addInflows
(
    const dictionary& inflows,
    const wordList& names,
    const scalar weight,
    const volScalarField* boundaryT,
    const volVectorField* boundaryU,
    boolList& taken
)
{
    const polyBoundaryMesh& patches = cells_.mesh().boundaryMesh();
    for (const entry& e : inflows)
    {
        const dictionary& gas = getBlock(inflows, e.keyword());
        refuseOthers(gas, {"numberDensities", "temperature", "velocity"});
        for
        (
            const label patchi
          : openPatches(inflows, "inflows", wordRe(e.keyword()))
        )
        {
            if (taken[patchi])
            {
                FatalIOErrorInFunction(inflows)
                    << "Entry " << e.keyword() << " is the second that matches"
                    << " patch " << patches[patchi].name() << nl
                    << "Valid: one gas behind each patch"
                    << exit(FatalIOError);
            }
            taken[patchi] = true;

            const bool hasT = gas.found("temperature");
            const bool hasU = gas.found("velocity");
            if (!hasT || !hasU)
            {
                needBoundaryFields(gas, boundaryT, boundaryU);
            }
            const label n = patches[patchi].size();
            const scalarField T
            (
                hasT
              ? scalarField
                (
                    n, getNumber(gas, "temperature", validRange::temperature)
                )
              : scalarField(boundaryT->boundaryField()[patchi])
            );
            const vectorField U
            (
                hasU
              ? vectorField
                (
                    n, getComponents(gas, "velocity", validRange::velocity)
                )
              : vectorField(boundaryU->boundaryField()[patchi])
            );
            addPatch
            (
                gas, patchi, getBlock(gas, "numberDensities"), names, weight,
                T, U
            );
        }
    }
}


Foam::labelList Foam::freeStream::stockPatches
(
    const dictionary& coeffs,
    const boolList& taken
) const
{
    const polyBoundaryMesh& patches = cells_.mesh().boundaryMesh();
    labelList stock;
    if (!coeffs.found("patches"))
    {
        forAll(patches, patchi)
        {
            if (isType<polyPatch>(patches[patchi]) && !taken[patchi])
            {
                stock.append(patchi);
            }
        }
        return stock;
    }
    for (const wordRe& expression : coeffs.get<wordRes>("patches"))
    {
        for
        (
            const label patchi : openPatches(coeffs, "patches", expression)
        )
        {
            if (taken[patchi])
            {
                FatalIOErrorInFunction(coeffs)
                    << "Entry patches holds " << expression
                    << ", which matches patch " << patches[patchi].name()
                    << " of inflows" << nl
                    << "Valid: one gas behind each patch"
                    << exit(FatalIOError);
            }
            if (!stock.found(patchi))
            {
                stock.append(patchi);
            }
        }
    }
    return stock;
}


void Foam::freeStream::needBoundaryFields
(
    const dictionary& dict,
    const volScalarField* boundaryT,
    const volVectorField* boundaryU
) const
{
    if (!boundaryT || !boundaryU)
    {
        FatalIOErrorInFunction(dict)
            << "InflowBoundaryModel FreeStream needs the fields boundaryT"
            << " and boundaryU in " << cells_.mesh().time().timePath()
            << ", or inflows with entries temperature and velocity"
            << exit(FatalIOError);
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::freeStream::freeStream
(
    const dictionary& dict,
    const convexCells& cells,
    const wordList& names,
    const std::vector<impact::cellCollisions::species>& species,
    const scalar weight,
    const volScalarField* boundaryT,
    const volVectorField* boundaryU
)
:
    cells_(cells),
    species_(species)
{
    if
    (
        getWordOf(dict, "InflowBoundaryModel", "", {"FreeStream", "none"})
     == "none"
    )
    {
        return;
    }
    const dictionary& coeffs = getBlock(dict, "FreeStreamCoeffs");
    const dictionary* block = findBlock(coeffs, "inflows");
    const dictionary inflows(block ? *block : dictionary());
    const bool ofStock = coeffs.found("numberDensities") || inflows.empty();
    refuseOthers
    (
        coeffs,
        ofStock
      ? wordList{"numberDensities", "patches", "inflows"}
      : wordList{"numberDensities", "inflows"}
    );

    if (ofStock && !coeffs.found("numberDensities"))
    {
        FatalIOErrorInFunction(coeffs)
            << "Entry numberDensities is missing, and inflows names no patch"
            << nl << "Valid: one of them, or both" << exit(FatalIOError);
    }

    // Gases of their own, then that of the stock model behind the others
    boolList taken(cells.mesh().boundaryMesh().size(), false);
    addInflows(inflows, names, weight, boundaryT, boundaryU, taken);
    if (ofStock)
    {
        needBoundaryFields(dict, boundaryT, boundaryU);
        for (const label patchi : stockPatches(coeffs, taken))
        {
            addPatch
            (
                dict, patchi, getBlock(coeffs, "numberDensities"), names,
                weight, boundaryT->boundaryField()[patchi],
                boundaryU->boundaryField()[patchi]
            );
        }
    }
    checkWeight(dict, weight);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::List<Foam::freeStream::gasState> Foam::freeStream::outside
(
    const label patchi,
    const scalar weight
) const
{
    const polyMesh& mesh = cells_.mesh();
    const polyPatch& patch = mesh.boundaryMesh()[patchi];
    const label first = patch.start() - mesh.nInternalFaces();
    List<gasState> gas(patch.size());
    for (const source& s : sources_)
    {
        const label j = s.boundaryFace - first;
        if (j < 0 || j >= patch.size() || !(s.flux > 0))
        {
            continue;
        }
        const vector n(s.inward.x, s.inward.y, s.inward.z);
        const vector slip(s.slip.x, s.slip.y, s.slip.z);
        const scalar density =
            s.flux*weight
           /(
                mag(patch.faceAreas()[j])*s.speed
               *impact::maxwellian::fluxFactor(s.speedRatio)
            );
        const scalar Un = s.speedRatio*s.speed;
        gas[j].massFlux += density*species_[s.typeId].mass*Un;
        gas[j].velocity = Un*n + slip;
        gas[j].temperature = s.temperature;
    }
    return gas;
}


Foam::label Foam::freeStream::enter
(
    moleculeArray& molecules,
    const scalar deltaT,
    const std::uint64_t seed,
    const std::uint64_t stream,
    const std::uint32_t step
) const
{
    using namespace impact;

    label total = 0;
    for (std::size_t k = 0; k < sources_.size(); ++k)
    {
        const source& s = sources_[k];
        counterRandom rnd(seed, stream + k, step);
        const auto& kind = species_[s.typeId];
        const label n = label(s.flux*deltaT + rnd.uniform());
        for (label i = 0; i < n; ++i)
        {
            const vector3 x = pointOn(s.boundaryFace, rnd);

            const vector3 u = maxwellian::crossingVelocity
            (
                s.inward, s.slip, s.speed, s.speedRatio, rnd
            );

            const label at = molecules.append
            (
                cells_.inside(s.boundaryFace, x), x, u, rnd.uniform()
            );
            molecules.payload().typeId[at] = s.typeId;
            molecules.payload().Ei[at] =
                maxwellian::boltzmann*s.temperature
               *maxwellian::internalEnergy(kind.internalDegreesOfFreedom, rnd);
        }
        total += n;
    }
    return total;
}
