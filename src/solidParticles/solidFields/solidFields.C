/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "solidFields.H"
#include "IOdictionary.H"
#include "coreVector.H"
#include "checked.H"
#include "sampledField.H"

namespace Foam
{
    static const word phase(".solids");
    static const word stateName("solidFieldsMean");

    static const dimensionSet rateDimensions(1, -2, -2, 0, 0);
    static const dimensionSet energyRateDimensions(1, -1, -3, 0, 0);
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::solidFields::makeFields(const bool read)
{
    const label nGroups = mass_.size();
    const auto add = [&](auto& list, const word& name, const dimensionSet& unit)
    {
        typedef typename std::decay_t<decltype(list[0])>::value_type Type;
        list.append(sampledField<Type>(mesh_, name, unit, read));
    };
    for (label g = 0; particlesAsked() && g <= nGroups; ++g)
    {
        const word end(g < nGroups ? word(phase + Foam::name(g)) : phase);
        add(n_, "numberDensity" + end, dimless/dimVolume);
        if (asked_[concentration])
        {
            add(rho_, "concentration" + end, dimDensity);
        }
        if (asked_[velocity])
        {
            add(U_, "U" + end, dimVelocity);
        }
        if (asked_[temperature])
        {
            add(T_, "T" + end, dimTemperature);
        }
    }
    if (asked_[exchange])
    {
        for (const word& end : {phase, word(".gas")})
        {
            add(momentumRate_, "momentumRate" + end, rateDimensions);
            add(energyRate_, "energyRate" + end, energyRateDimensions);
        }
    }
    if (asked_[surface])
    {
        add(surface_, "numberFlux" + phase, dimless/dimArea/dimTime);
        add(surface_, "massFlux" + phase, dimMass/dimArea/dimTime);
        add(surface_, "energyFlux" + phase, dimEnergy/dimArea/dimTime);
        add(surface_, "impactT" + phase, dimTemperature);
    }
}


Foam::exactSums Foam::solidFields::savedSums()
{
    exactSums saved(mesh_, "solidFieldsSums");
    saved.add(duration_);
    saved.add(cells_);
    saved.add(gains_);
    saved.add(walls_);
    return saved;
}


void Foam::solidFields::restore()
{
    const label nGroups = mass_.size();
    forAll(volumes_, celli)
    {
        const scalar V = volumes_[celli];
        for (label g = 0; particlesAsked() && g < nGroups; ++g)
        {
            sums& s = cells_[celli*nGroups + g];
            s.number = n_[g][celli]*V*nSteps_;
            for (direction d = 0; asked_[velocity] && d < 3; ++d)
            {
                s.momentum[d] = s.number*U_[g][celli][d];
            }
            s.heat = asked_[temperature] ? s.number*T_[g][celli] : 0;
        }
        if (asked_[exchange])
        {
            const scalar f = V*duration_;
            gains_[celli].solids =
            {
                toCore(f*momentumRate_[0][celli]), f*energyRate_[0][celli]
            };
            gains_[celli].gas =
            {
                toCore(f*momentumRate_[1][celli]), f*energyRate_[1][celli]
            };
        }
    }
    for (const fvPatch& patch : mesh_.boundary())
    {
        if (!asked_[surface] || !isA<wallFvPatch>(patch))
        {
            continue;
        }
        forAll(patch, j)
        {
            const label patchi = patch.index();
            wallSums& s = walls_[patch.start() - mesh_.nInternalFaces() + j];
            const scalar f = patch.magSf()[j]*duration_;
            s.number = f*surface_[0].boundaryField()[patchi][j];
            s.mass = f*surface_[1].boundaryField()[patchi][j];
            s.energy = f*surface_[2].boundaryField()[patchi][j];
            s.heat = s.mass*surface_[3].boundaryField()[patchi][j];
        }
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::solidFields::solidFields
(
    const dictionary& dict,
    const fvMesh& mesh,
    const scalarField& volumes,
    const scalarList& mass
)
:
    mesh_(mesh),
    volumes_(volumes),
    mass_(mass),
    start_(getNumber(dict, "start", validRange::time, scalar(0))),
    every_(getNumber<label>(dict, "every", validRange::count, 1)),
    trials_(getNumber<label>(dict, "trials", "[1, 1000]", 1))
{
    refuseOthers(dict, {"start", "every", "trials", "fields"});
    warnOfLateStart(dict, mesh.time(), start_, every_);
    const wordList names
    {
        "numberDensity", "concentration", "U", "T", "exchange", "surface"
    };
    const wordList fields(getItems<word>(dict, "fields"));
    if (fields.empty())
    {
        refuse(dict, "fields", "()", "one field at least");
    }
    for (const word& name : fields)
    {
        const label at = names.find(name);
        if (at < 0)
        {
            unknownWord(dict, "fields", name, names);
        }
        asked_[at] = true;
    }

    if (particlesAsked())
    {
        cells_.resize(std::size_t(mesh.nCells())*mass_.size(), sums());
    }
    if (asked_[exchange])
    {
        gains_.resize(mesh.nCells());
    }
    if (asked_[surface])
    {
        walls_.resize(mesh.nFaces() - mesh.nInternalFaces(), wallSums());
    }

    const IOdictionary state
    (
        exactSums::state(mesh, stateName, IOobject::READ_IF_PRESENT)
    );
    const bool continued = state.found("nSteps");
    makeFields(continued);
    if (continued)
    {
        nSteps_ = state.get<label>("nSteps");
        duration_ = state.get<scalar>("duration");
        if (!savedSums().read(nSteps_))
        {
            restore();
        }
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::solidFields::samplingNow() const
{
    return
        mesh_.time().value() > start_ - 0.5*mesh_.time().deltaTValue()
     && mesh_.time().timeIndex() % every_ == 0;
}


void Foam::solidFields::addStep(const solidArray& particles)
{
    ++nSteps_;
    duration_ += mesh_.time().deltaTValue();
    if (!particlesAsked())
    {
        return;
    }
    const label nGroups = mass_.size();
    const solidData& data = particles.payload();
    for (label celli = 0; celli < mesh_.nCells(); ++celli)
    {
        sums* here = &cells_[std::size_t(celli)*nGroups];
        const label last = particles.begin(celli + 1);
        for (label i = particles.begin(celli); i < last; ++i)
        {
            sums& s = here[data.group[i]];
            const scalar n = data.nParticle[i];
            s.number += n;
            s.momentum[0] += n*particles.u()[i];
            s.momentum[1] += n*particles.v()[i];
            s.momentum[2] += n*particles.w()[i];
            s.heat += n*data.T[i];
        }
    }
}


void Foam::solidFields::update()
{
    if (!nSteps_)
    {
        return;
    }
    const label nGroups = mass_.size();
    forAll(volumes_, celli)
    {
        const scalar V = volumes_[celli];
        if (particlesAsked())
        {
            scalar number = 0, mass = 0, heat = 0;
            vector momentum(Zero);
            for (label g = 0; g <= nGroups; ++g)
            {
                scalar n = number, m = mass, h = heat;
                vector p = momentum;
                if (g < nGroups)
                {
                    const sums& s = cells_[std::size_t(celli)*nGroups + g];
                    n = s.number;
                    m = n*mass_[g];
                    h = mass_[g]*s.heat;
                    p = mass_[g]
                       *vector(s.momentum[0], s.momentum[1], s.momentum[2]);
                    number += n;
                    mass += m;
                    heat += h;
                    momentum += p;
                }
                n_[g].primitiveFieldRef()[celli] = n/(V*nSteps_);
                if (asked_[concentration])
                {
                    rho_[g].primitiveFieldRef()[celli] = m/(V*nSteps_);
                }
                if (asked_[velocity])
                {
                    U_[g].primitiveFieldRef()[celli] =
                        m > 0 ? vector(p/m) : vector(Zero);
                }
                if (asked_[temperature])
                {
                    T_[g].primitiveFieldRef()[celli] = m > 0 ? h/m : 0;
                }
            }
        }
        if (asked_[exchange])
        {
            const auto& g = gains_[celli];
            const scalar f = 1/(V*duration_);
            label k = 0;
            for (const impact::balance* b : {&g.solids, &g.gas})
            {
                momentumRate_[k].primitiveFieldRef()[celli] =
                    f*fromCore(b->momentum);
                energyRate_[k].primitiveFieldRef()[celli] = f*b->energy;
                ++k;
            }
        }
    }
    const auto correct = [](auto&... lists)
    {
        const auto all = [](auto& list)
        {
            for (auto& field : list)
            {
                field.correctBoundaryConditions();
            }
        };
        (all(lists), ...);
    };
    correct(n_, rho_, T_, energyRate_, U_, momentumRate_);

    forAll(surface_, k)
    {
        for (const fvPatch& patch : mesh_.boundary())
        {
            if (!isA<wallFvPatch>(patch))
            {
                continue;
            }
            fvPatchScalarField& values =
                surface_[k].boundaryFieldRef()[patch.index()];
            forAll(patch, j)
            {
                const wallSums& s =
                    walls_[patch.start() - mesh_.nInternalFaces() + j];
                const scalar f = 1/(patch.magSf()[j]*duration_);
                values[j] =
                    k == 0 ? f*s.number : k == 1 ? f*s.mass
                  : k == 2 ? f*s.energy : s.mass > 0 ? s.heat/s.mass : 0;
            }
        }
    }
}


void Foam::solidFields::writeState() const
{
    const_cast<solidFields&>(*this)
        .savedSums().write(stateName, nSteps_, duration_);
}
