/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "gasFields.H"
#include "IOdictionary.H"
#include "maxwellian.H"
#include "sampledField.H"

namespace
{
    //- Names and dimensions, in the order of the sums
    struct description
    {
        const char* name;
        Foam::dimensionSet dimensions;
    };

    const description scalarFields[] =
    {
        {"rhoN", Foam::dimensionSet(0, -3, 0, 0, 0)},
        {"rhoM", Foam::dimensionSet(1, -3, 0, 0, 0)},
        {"dsmcRhoN", Foam::dimensionSet(0, -3, 0, 0, 0)},
        {"linearKE", Foam::dimensionSet(1, -1, -2, 0, 0)},
        {"internalE", Foam::dimensionSet(1, -1, -2, 0, 0)},
        {"iDof", Foam::dimensionSet(0, -3, 0, 0, 0)},
        {"q", Foam::dimensionSet(1, 0, -3, 0, 0)}
    };

    const description vectorFields[] =
    {
        {"momentum", Foam::dimensionSet(1, -2, -1, 0, 0)},
        {"fD", Foam::dimensionSet(1, -1, -2, 0, 0)}
    };

    const description derivedFields[] =
    {
        {"translationalT", Foam::dimensionSet(0, 0, 0, 1, 0)},
        {"internalT", Foam::dimensionSet(0, 0, 0, 1, 0)},
        {"overallT", Foam::dimensionSet(0, 0, 0, 1, 0)},
        {"p", Foam::dimensionSet(1, -1, -2, 0, 0)}
    };

    enum scalarIndex
    {
        rhoN, rhoM, dsmcRhoN, linearKE, internalE, iDof, q, nScalars
    };
    enum vectorIndex {momentum, fD, nVectors};

    const Foam::word meanSuffix("Mean");
    const Foam::word stateName("gasFieldsMean");
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::gasFields::makeFields(const bool readSums)
{
    for (const description& d : scalarFields)
    {
        scalars_.append
        (
            sampledField<scalar>
            (
                mesh_, d.name + suffix_, d.dimensions, readSums
            )
        );
    }
    for (const description& d : vectorFields)
    {
        vectors_.append
        (
            sampledField<vector>
            (
                mesh_, d.name + suffix_, d.dimensions, readSums
            )
        );
    }
    if (suffix_ == meanSuffix)
    {
        U_.reset(sampledField<vector>(mesh_, "U" + suffix_, dimVelocity));
        for (const description& d : derivedFields)
        {
            derived_.append
            (
                sampledField<scalar>(mesh_, d.name, d.dimensions)
            );
        }
    }
}


Foam::exactSums Foam::gasFields::savedSums()
{
    exactSums saved(mesh_, "gasFieldsSums");
    saved.add(duration_);
    saved.add(cells_);
    saved.add(walls_);
    return saved;
}


void Foam::gasFields::derive()
{
    const scalar k = impact::maxwellian::boltzmann;

    // On all values at once: cells, then the faces of each patch
    const auto deriveOn = [&]
    (
        const scalarField& n, const scalarField& rho, const scalarField& ke,
        const scalarField& ei, const scalarField& dof, const vectorField& mom,
        vectorField& U, scalarField& Tt, scalarField& Ti, scalarField& T,
        scalarField& p
    )
    {
        forAll(n, i)
        {
            const bool any = n[i] > 0;
            const bool turning = any && dof[i] > 0;
            U[i] = any ? vector(mom[i]/rho[i]) : vector(Zero);
            const scalar thermal =
                any ? max(ke[i] - 0.5*rho[i]*magSqr(U[i]), scalar(0)) : 0;
            Tt[i] = any ? 2*thermal/(3*k*n[i]) : 0;
            Ti[i] = turning ? 2*ei[i]/(k*dof[i]) : 0;
            T[i] = any ? 2*(thermal + ei[i])/(k*(3*n[i] + dof[i])) : 0;
            p[i] = k*n[i]*Tt[i];
        }
    };

    deriveOn
    (
        scalars_[rhoN], scalars_[rhoM], scalars_[linearKE],
        scalars_[internalE], scalars_[iDof], vectors_[momentum],
        U_->primitiveFieldRef(), derived_[0].primitiveFieldRef(),
        derived_[1].primitiveFieldRef(), derived_[2].primitiveFieldRef(),
        derived_[3].primitiveFieldRef()
    );
    U_->correctBoundaryConditions();
    for (volScalarField& f : derived_)
    {
        f.correctBoundaryConditions();
    }

    forAll(mesh_.boundary(), patchi)
    {
        if (!isA<wallFvPatch>(mesh_.boundary()[patchi]))
        {
            continue;
        }
        deriveOn
        (
            scalars_[rhoN].boundaryField()[patchi],
            scalars_[rhoM].boundaryField()[patchi],
            scalars_[linearKE].boundaryField()[patchi],
            scalars_[internalE].boundaryField()[patchi],
            scalars_[iDof].boundaryField()[patchi],
            vectors_[momentum].boundaryField()[patchi],
            U_->boundaryFieldRef()[patchi],
            derived_[0].boundaryFieldRef()[patchi],
            derived_[1].boundaryFieldRef()[patchi],
            derived_[2].boundaryFieldRef()[patchi],
            derived_[3].boundaryFieldRef()[patchi]
        );
        derived_[3].boundaryFieldRef()[patchi] ==
            (vectors_[fD].boundaryField()[patchi]
          & mesh_.boundary()[patchi].nf());
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::gasFields::gasFields
(
    const fvMesh& mesh,
    const scalarField& volumes,
    const std::vector<impact::cellCollisions::species>& species,
    const scalar weight,
    const word& suffix
)
:
    mesh_(mesh),
    volumes_(volumes),
    species_(species),
    weight_(weight),
    suffix_(suffix),
    nSteps_(0),
    duration_(0),
    cells_(mesh.nCells(), sums()),
    walls_(mesh.nFaces() - mesh.nInternalFaces(), wallSums())
{
    const IOdictionary state
    (
        exactSums::state
        (
            mesh,
            stateName,
            suffix_ == meanSuffix
          ? IOobject::READ_IF_PRESENT : IOobject::NO_READ
        )
    );
    const bool continued = state.found("nSteps");
    makeFields(continued);
    if (!continued)
    {
        return;
    }

    nSteps_ = state.get<label>("nSteps");
    duration_ = state.get<scalar>("duration");
    Info<< "Continuing means over " << nSteps_ << " steps" << nl << endl;
    if (savedSums().read(nSteps_))
    {
        return;
    }

    const auto restore = [&](auto values, sums& s, const scalar factor)
    {
        s.number = factor*values(rhoN);
        s.mass = factor*values(rhoM);
        s.kineticEnergy = factor*values(linearKE);
        s.internalEnergy = factor*values(internalE);
        s.degreesOfFreedom = factor*values(iDof);
    };
    forAll(mesh_.cells(), i)
    {
        const scalar factor = volumes_[i]*nSteps_/weight_;
        restore
        (
            [&](const label f) { return scalars_[f][i]; }, cells_[i], factor
        );
        for (direction d = 0; d < 3; ++d)
        {
            cells_[i].momentum[d] = factor*vectors_[momentum][i][d];
        }
    }
    forAll(mesh_.boundary(), patchi)
    {
        const fvPatch& patch = mesh_.boundary()[patchi];
        if (!isA<wallFvPatch>(patch))
        {
            continue;
        }
        forAll(patch, j)
        {
            wallSums& s = walls_[patch.start() - mesh_.nInternalFaces() + j];
            const scalar factor = patch.magSf()[j]*duration_/weight_;
            restore
            (
                [&](const label f)
                {
                    return scalars_[f].boundaryField()[patchi][j];
                },
                s.state,
                factor
            );
            s.heat = factor*scalars_[q].boundaryField()[patchi][j];
            for (direction d = 0; d < 3; ++d)
            {
                s.state.momentum[d] =
                    factor*vectors_[momentum].boundaryField()[patchi][j][d];
                s.impulse[d] =
                    factor*vectors_[fD].boundaryField()[patchi][j][d];
            }
        }
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::gasFields::addHit
(
    const label boundaryFacei,
    const impact::vector3& normal,
    const wallState& before,
    const wallState& after
)
{
    wallSums& s = walls_[boundaryFacei];
    scalar sign = 1;
    for (const wallState* state : {&before, &after})
    {
        const impact::vector3& u = state->velocity;
        const scalar un = dot(u, normal);
        const scalar energy = 0.5*state->mass*dot(u, u);

        // A molecule is in front of the wall for a time ~ 1/|un|
        const scalar stay = 1/max(mag(un), VSMALL);
        s.state.number += stay;
        s.state.mass += state->mass*stay;
        s.state.kineticEnergy += energy*stay;
        s.state.internalEnergy += state->internalEnergy*stay;
        s.state.degreesOfFreedom += state->internalDegreesOfFreedom*stay;
        for (direction d = 0; d < 3; ++d)
        {
            s.state.momentum[d] +=
                state->mass*(u[d] - un*normal[d])*stay;
            s.impulse[d] += sign*state->mass*u[d];
        }
        s.heat += sign*(energy + state->internalEnergy);
        sign = -1;
    }
}


void Foam::gasFields::addStep
(
    const moleculeArray& molecules,
    const scalar deltaT
)
{
    ++nSteps_;
    duration_ += deltaT;

    const double* u = molecules.u();
    const double* v = molecules.v();
    const double* w = molecules.w();
    const double* Ei = molecules.payload().Ei.data();
    const std::int32_t* typeId = molecules.payload().typeId.data();

    forAll(mesh_.cells(), celli)
    {
        sums& s = cells_[celli];
        const label last = molecules.begin(celli + 1);
        for (label i = molecules.begin(celli); i < last; ++i)
        {
            const auto& kind = species_[typeId[i]];
            s.number += 1;
            s.mass += kind.mass;
            s.momentum[0] += kind.mass*u[i];
            s.momentum[1] += kind.mass*v[i];
            s.momentum[2] += kind.mass*w[i];
            s.kineticEnergy +=
                0.5*kind.mass*(u[i]*u[i] + v[i]*v[i] + w[i]*w[i]);
            s.internalEnergy += Ei[i];
            s.degreesOfFreedom += kind.internalDegreesOfFreedom;
        }
    }
}


void Foam::gasFields::reset()
{
    nSteps_ = 0;
    duration_ = 0;
    std::fill(cells_.begin(), cells_.end(), sums());
    std::fill(walls_.begin(), walls_.end(), wallSums());
}


void Foam::gasFields::update()
{
    if (!nSteps_)
    {
        return;
    }

    // dsmcFields divides by these. Of means it asks first whether the densities
    // are zero, but not the degrees of freedom
    const scalar minValue = suffix_ == meanSuffix ? 0 : VSMALL;

    // Fields of the cells, then of each wall
    scalarField* f[nScalars];
    vectorField* g[nVectors];
    const auto set = [&](const label i, const sums& s, const scalar factor)
    {
        (*f[rhoN])[i] = max(factor*s.number, minValue);
        (*f[rhoM])[i] = max(factor*s.mass, minValue);
        (*f[linearKE])[i] = factor*s.kineticEnergy;
        (*f[internalE])[i] = factor*s.internalEnergy;
        (*f[iDof])[i] = max(factor*s.degreesOfFreedom, VSMALL);
        (*g[momentum])[i] =
            factor*vector(s.momentum[0], s.momentum[1], s.momentum[2]);
    };

    forAll(scalars_, k)
    {
        f[k] = &scalars_[k].primitiveFieldRef();
    }
    forAll(vectors_, k)
    {
        g[k] = &vectors_[k].primitiveFieldRef();
    }
    forAll(mesh_.cells(), i)
    {
        const sums& s = cells_[i];
        set(i, s, weight_/(volumes_[i]*nSteps_));
        (*f[dsmcRhoN])[i] = s.number/nSteps_;
    }
    for (volScalarField& field : scalars_)
    {
        field.correctBoundaryConditions();
    }
    for (volVectorField& field : vectors_)
    {
        field.correctBoundaryConditions();
    }

    forAll(mesh_.boundary(), patchi)
    {
        const fvPatch& patch = mesh_.boundary()[patchi];
        if (!isA<wallFvPatch>(patch))
        {
            continue;
        }
        forAll(scalars_, k)
        {
            f[k] = &scalars_[k].boundaryFieldRef()[patchi];
        }
        forAll(vectors_, k)
        {
            g[k] = &vectors_[k].boundaryFieldRef()[patchi];
        }
        forAll(patch, j)
        {
            const wallSums& s =
                walls_[patch.start() - mesh_.nInternalFaces() + j];
            const scalar factor = weight_/(patch.magSf()[j]*duration_);
            set(j, s.state, factor);
            (*f[q])[j] = factor*s.heat;
            (*g[fD])[j] =
                factor*vector(s.impulse[0], s.impulse[1], s.impulse[2]);
        }
    }

    if (suffix_ == meanSuffix)
    {
        derive();
    }
}


void Foam::gasFields::writeState() const
{
    const_cast<gasFields&>(*this)
        .savedSums().write(stateName, nSteps_, duration_);
}
