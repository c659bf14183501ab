/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "solidInflow.H"
#include "boundBox.H"
#include "coreVector.H"
#include "checked.H"
#include "drawPurpose.H"
#include "wordRes.H"

#include <algorithm>
#include <cmath>

namespace
{
    const char* const simulators = "(0, 1e9]";

    //- Is the entry the word 'gas'?
    bool ofGas(const Foam::dictionary& d, const Foam::word& name)
    {
        const Foam::token first(d.lookup(name));
        return first.isWord() && first.wordToken() == "gas";
    }

    //- What a fill fills
    Foam::word regionOf(const Foam::dictionary& d)
    {
        return Foam::getWordOf(d, "region", "", {"all", "box", "zone"});
    }

}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::label Foam::solidInflow::counted
(
    const scalar n,
    const group& size
) const
{
    if (!within(n, "[0, 1e9]"))
    {
        FatalIOErrorInFunction(dict_)
            << "Of diameter " << size.diameter << " m " << n << " simulated"
            << " particles come in at once: valid range [0, 1e9] on one"
            << " processor" << nl
            << "Set a larger realPerSimulator, or simulators where they come"
            << " in" << exit(FatalIOError);
    }
    return label(n);
}


void Foam::solidInflow::warnOfNone
(
    const dictionary& d,
    const word& count,
    const group& size,
    const scalar expected,
    const scalar real
) const
{
    if (expected < 1 - 1e-9)
    {
        IOWarningInFunction(d)
            << "Of diameter " << size.diameter << " m " << expected
            << " simulated particles come in, in what is left of the run: fewer"
            << " than one. Lower realPerSimulator, now " << real << ", or set "
            << count << endl;
    }
}


Foam::scalarList Foam::solidInflow::perGroup
(
    const dictionary& d,
    const word& name,
    const char* range
) const
{
    scalarList values(getNumbers(d, name, range));
    if (values.size() == 1)
    {
        values = scalarList(groups_.size(), values[0]);
    }
    if (values.size() != groups_.size())
    {
        refuse
        (
            d, name, flatOutput(values), "one number, or one for each of the ",
            groups_.size(), " groups"
        );
    }
    return values;
}


Foam::scalarList Foam::solidInflow::realPerSimulator
(
    const dictionary& d,
    const word& count,
    const scalar mass
) const
{
    if (!d.found(count))
    {
        if (!dict_.found("realPerSimulator"))
        {
            FatalIOErrorInFunction(d)
                << "Neither " << count << " here nor realPerSimulator in "
                << dict_.name() << nl
                << "Valid: one of the two" << exit(FatalIOError);
        }
        return perGroup(dict_, "realPerSimulator", validRange::number);
    }
    scalarList number(perGroup(d, count, simulators));
    forAll(number, g)
    {
        number[g] =
            mass*groups_[g].massFraction/(groups_[g].mass*number[g]);
    }
    for (const scalar n : number)
    {
        if (!within(n, validRange::number))
        {
            refuse
            (
                d, count, flatOutput(getNumbers(d, count, simulators)),
                "with real particles for each in ", validRange::number
            );
        }
    }
    return number;
}


Foam::labelList Foam::solidInflow::regionCells(const dictionary& d) const
{
    const polyMesh& mesh = cells_.mesh();
    const word region(regionOf(d));
    if (region == "all")
    {
        return identity(mesh.nCells());
    }
    labelList found;
    if (region == "zone")
    {
        const word name(d.get<word>("zone"));
        const label zone = mesh.cellZones().findZoneID(name);
        if (zone < 0)
        {
            unknownWord(d, "zone", name, mesh.cellZones().names());
        }
        found = mesh.cellZones()[zone];
    }
    else
    {
        ITstream& is = d.lookup("box");
        const point low(is);
        const point high(is);
        const boundBox box(low, high);
        if (!(box.span().x() > 0 && box.span().y() > 0 && box.span().z() > 0))
        {
            refuse(d, "box", box, "least and greatest corner");
        }
        forAll(mesh.cellCentres(), i)
        {
            if (box.contains(mesh.cellCentres()[i]))
            {
                found.append(i);
            }
        }
    }
    if (!returnReduce(found.size(), sumOp<label>()))
    {
        refuse(d, "region", region, "a region with cells");
    }
    return found;
}


impact::vector3 Foam::solidInflow::pointIn
(
    const label meshCelli,
    impact::counterRandom& rnd,
    label& celli
) const
{
    const polyMesh& mesh = cells_.mesh();
    const boundBox box(mesh.points(), mesh.cellPoints()[meshCelli], false);
    while (true)
    {
        const scalar a = rnd.uniform();
        const scalar b = rnd.uniform();
        const scalar c = rnd.uniform();
        const impact::vector3 x = toCore
        (
            box.min() + cmptMultiply(box.span(), vector(a, b, c))
        );
        for
        (
            celli = cells_.firstCell()[meshCelli];
            celli < cells_.firstCell()[meshCelli + 1];
            ++celli
        )
        {
            if (cells_.height(celli, x) < 0)
            {
                return x;
            }
        }
    }
}


Foam::solidInflow::inflow Foam::solidInflow::readInflow
(
    const dictionary& d
) const
{
    refuseOthers
    (
        d,
        {
            "massFlow", "massLoading", "velocity", "temperature",
            "simulatorsPerStep"
        }
    );
    if (d.found("massFlow") == d.found("massLoading"))
    {
        FatalIOErrorInFunction(d)
            << "Valid: one of the entries massFlow and massLoading"
            << exit(FatalIOError);
    }
    inflow in;
    in.loading = d.found("massLoading");
    in.amount =
        in.loading
      ? getNumber(d, "massLoading", "(0, 1e9]")
      : getNumber(d, "massFlow", "(0, 1e12] kg/s");
    in.ofGasU = ofGas(d, "velocity");
    in.ofGasT = ofGas(d, "temperature");
    in.U =
        in.ofGasU
      ? vector(Zero) : getComponents(d, "velocity", validRange::velocity);
    in.T =
        in.ofGasT ? 0 : getNumber(d, "temperature", validRange::temperature);
    return in;
}


void Foam::solidInflow::addPatch
(
    const dictionary& d,
    const inflow& in,
    const polyPatch& patch
)
{
    const polyMesh& mesh = cells_.mesh();
    const auto outside =
        gas_.inflow().outside(patch.index(), gas_.weight());
    const scalar area = gSum(mag(patch.faceAreas()));
    source s;
    scalar sum = 0;
    forAll(patch, j)
    {
        const scalar a = mag(patch.faceAreas()[j]);
        const vector n = -patch.faceAreas()[j]/a;
        const auto& gas = outside[j];
        if ((in.loading || in.ofGasU || in.ofGasT) && !(gas.massFlux > 0))
        {
            FatalIOErrorInFunction(d)
                << "Particles take their flux, velocity or temperature"
                << " from the gas outside patch " << patch.name()
                << ", whose mass flux is " << gas.massFlux
                << " kg/(m^2 s)" << nl
                << "Valid: an inflow of gas (dsmcProperties)"
                << exit(FatalIOError);
        }
        s.velocity.push_back(in.ofGasU ? gas.velocity : in.U);
        s.temperature.push_back(in.ofGasT ? gas.temperature : in.T);
        if (!((s.velocity.back() & n) > 0))
        {
            refuse
            (
                d, "velocity", s.velocity.back(),
                "a velocity into the domain, along ", n,
                " on patch ", patch.name()
            );
        }
        sum += in.loading ? in.amount*gas.massFlux*a : in.amount*a/area;
        s.flow.push_back(sum);
        s.faces.push_back
        (
            patch.start() + j - mesh.nInternalFaces()
        );
    }
    const scalar all = returnReduce(sum, sumOp<scalar>());
    s.number = realPerSimulator
    (
        d, "simulatorsPerStep", all*mesh.time().deltaTValue()
    );
    sources_.push_back(s);
    Info<< "    through " << patch.name() << ": " << all << " kg/s"
        << nl;

    const scalar duration = mesh.time().endTime().value() - mesh.time().value();
    forAll(groups_, g)
    {
        const group& size = groups_[g];
        if (duration > 0)
        {
            warnOfNone
            (
                d, "simulatorsPerStep", size,
                all*size.massFraction*duration/(size.mass*s.number[g]),
                s.number[g]
            );
        }
    }
}


void Foam::solidInflow::readInflows()
{
    const polyBoundaryMesh& patches = cells_.mesh().boundaryMesh();
    if (dict_.found("realPerSimulator"))
    {
        // Refused if it is no number, also where nothing needs it
        perGroup(dict_, "realPerSimulator", validRange::number);
    }
    const dictionary* block = findBlock(dict_, "inflows");
    const dictionary inflows(block ? *block : dictionary());
    std::vector<bool> taken(patches.size(), false);
    wordList open;
    for (const polyPatch& patch : patches)
    {
        if (isType<polyPatch>(patch))
        {
            open.append(patch.name());
        }
    }

    for (const entry& e : inflows)
    {
        const dictionary& d = getBlock(inflows, e.keyword());
        const inflow in(readInflow(d));
        bool found = false;
        forAll(patches, patchi)
        {
            const polyPatch& patch = patches[patchi];
            if
            (
                !open.found(patch.name())
             || !(
                    patch.name() == e.keyword()
                 || wordRe(e.keyword()).match(patch.name())
                )
            )
            {
                continue;
            }
            found = true;
            if (taken[patchi])
            {
                refuse
                (
                    inflows, "inflows", e.keyword(), "one entry for patch ",
                    patch.name()
                );
            }
            taken[patchi] = true;

            addPatch(d, in, patch);
        }
        if (!found)
        {
            unknownWord(inflows, "inflows: open patch", e.keyword(), open);
        }
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::solidInflow::solidInflow
(
    const dictionary& dict,
    const convexCells& cells,
    const dsmcGas& gas,
    const List<group>& groups
)
:
    dict_(dict),
    cells_(cells),
    gas_(gas),
    groups_(groups)
{
    readInflows();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::solidInflow::fill
(
    solidArray& particles,
    const std::uint64_t seed
) const
{
    const dictionary* block = findBlock(dict_, "fills");
    const dictionary fills(block ? *block : dictionary());
    std::uint32_t number = 0;
    for (const entry& e : fills)
    {
        const dictionary& d = getBlock(fills, e.keyword());
        const word region(regionOf(d));
        wordList valid
        {
            "region", "concentration", "velocity", "temperature", "simulators"
        };
        if (region != "all")
        {
            valid.append(region);
        }
        refuseOthers(d, valid);
        const scalar concentration =
            getNumber(d, "concentration", validRange::density);
        const scalar T = getNumber(d, "temperature", validRange::temperature);
        const impact::vector3 U =
            toCore(getComponents(d, "velocity", validRange::velocity));
        const labelList inside(regionCells(d));

        std::vector<scalar> volume;
        scalar sum = 0;
        for (const label i : inside)
        {
            sum += cells_.volumes()[i];
            volume.push_back(sum);
        }

        // Counted along the volumes of all processors, one after the other: as
        // many simulated particles on any number of them
        scalarList upTo(Pstream::nProcs());
        upTo[Pstream::myProcNo()] = sum;
        Pstream::gatherList(upTo);
        Pstream::scatterList(upTo);
        for (label i = 1; i < upTo.size(); ++i)
        {
            upTo[i] += upTo[i - 1];
        }
        const scalar end = upTo[Pstream::myProcNo()];
        const scalar start =
            Pstream::master() ? 0 : upTo[Pstream::myProcNo() - 1];
        const scalar all = upTo.last();
        const scalarList real
        (
            realPerSimulator(d, "simulators", concentration*all)
        );

        impact::counterRandom ofAll
        (
            seed, impact::drawPurpose::filling << 60, number
        );
        impact::counterRandom rnd(seed, Pstream::myProcNo(), number++);
        forAll(groups_, g)
        {
            const group& size = groups_[g];
            const scalar mean =
                concentration*all*size.massFraction/(size.mass*real[g]);
            warnOfNone(d, "simulators", size, mean, real[g]);
            const scalar nAll = std::floor(mean*(1 + 1e-12) + ofAll.uniform());
            const scalar shift = ofAll.uniform();
            const scalar first = std::ceil(start/all*nAll - shift);
            const label n =
                counted(std::ceil(end/all*nAll - shift) - first, size);
            std::size_t k = 0;
            for (label i = 0; i < n; ++i)
            {
                // At equal distances along the volumes of the cells
                const scalar at = (first + i + shift)/nAll*all - start;
                while (k + 1 < volume.size() && volume[k] < at)
                {
                    ++k;
                }
                label celli;
                const impact::vector3 x = pointIn(inside[k], rnd, celli);
                const label p = particles.append(celli, x, U);
                particles.payload().T[p] = T;
                particles.payload().nParticle[p] = real[g];
                particles.payload().group[p] = g;
            }
        }
    }
    particles.update();
}


void Foam::solidInflow::enter
(
    solidArray& particles,
    const scalar deltaT,
    const std::uint64_t seed,
    const std::uint64_t stream,
    const std::uint32_t step
) const
{
    for (std::size_t i = 0; i < sources_.size(); ++i)
    {
        const source& s = sources_[i];
        if (s.faces.empty())
        {
            continue;
        }
        impact::counterRandom rnd(seed, stream + i, step);
        impact::counterRandom ofAllSteps(seed, stream + i, 0);
        const scalar sum = s.flow.back();
        forAll(groups_, g)
        {
            const group& size = groups_[g];
            const scalar phase = ofAllSteps.uniform();

            // The whole numbers that the sum up to now has passed
            const scalar mean =
                sum*size.massFraction*deltaT/(size.mass*s.number[g]);
            const label n = counted
            (
                std::floor(mean*step + phase)
              - std::floor(mean*(step - 1.) + phase),
                size
            );
            const scalar shift = rnd.uniform();
            for (label j = 0; j < n; ++j)
            {
                const scalar at = (j + shift)/n*sum;
                const std::size_t k = std::min
                (
                    std::size_t
                    (
                        std::lower_bound(s.flow.begin(), s.flow.end(), at)
                      - s.flow.begin()
                    ),
                    s.faces.size() - 1
                );
                const impact::vector3 x =
                    gas_.inflow().pointOn(s.faces[k], rnd);
                const label p = particles.append
                (
                    cells_.inside(s.faces[k], x), x, toCore(s.velocity[k]),
                    rnd.uniform()
                );
                particles.payload().T[p] = s.temperature[k];
                particles.payload().nParticle[p] = s.number[g];
                particles.payload().group[p] = g;
            }
        }
    }
}
