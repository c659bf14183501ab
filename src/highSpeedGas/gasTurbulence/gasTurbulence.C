/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "gasTurbulence.H"
#include "checked.H"
#include "presentFile.H"

Foam::gasTurbulence::gasTurbulence
(
    const gasMesh& geometry,
    const volScalarField& rho,
    const volVectorField& U,
    const surfaceScalarField& phi,
    fluidThermo& thermo,
    const bool viscous
)
:
    geometry_(geometry),
    eddies_(false),
    U_(U),
    thermo_(thermo),
    warned_(false)
{
    const fvMesh& mesh = geometry.mesh();
    IOobject io
    (
        turbulenceModel::propertiesName,
        mesh.time().constant(),
        mesh,
        IOobject::MUST_READ,
        IOobject::NO_WRITE,
        false
    );
    if (!isPresent<IOdictionary>(io))
    {
        // Without a turbulence model the stock function takes the diffusivity
        // of enthalpy for that of whatever energy the thermo has
        const dictionary& control = rho.time().controlDict();
        for (const entry& e : control.subOrEmptyDict("functions"))
        {
            if
            (
                e.isDict() && thermo.he().name() == "e"
             && e.dict().getOrDefault<word>("type", "") == "wallHeatFlux"
            )
            {
                FatalIOErrorInFunction(e.dict())
                    << "Function object " << e.keyword() << " of type"
                    << " wallHeatFlux needs a turbulence model, or it takes"
                    << " the heat flux for smaller than it is, by Cv/Cp." << nl
                    << "Add constant/turbulenceProperties with 'simulationType"
                    << " laminar;'" << exit(FatalIOError);
            }
        }
        return;
    }

    properties_ = IOdictionary(io);
    const dictionary& properties = properties_;
    const word type(properties.get<word>("simulationType"));
    eddies_ = type != "laminar";

    if (eddies_ && !viscous)
    {
        FatalIOErrorInFunction(properties)
            << "simulationType " << type << " needs a gas with friction, but"
            << " 'viscous' in the block highSpeedGas of system/fvSolution is"
            << " no, or the viscosity is zero." << nl
            << "Set 'viscous yes;' and a viscosity > 0, or 'simulationType"
            << " laminar;'" << exit(FatalIOError);
    }

    const dictionary& laminar = properties.subOrEmptyDict("laminar");
    const word model
    (
        laminar.getOrDefault<word>
        (
            "model", laminar.getOrDefault<word>("laminarModel", "Stokes")
        )
    );
    if (!eddies_ && model != "Stokes")
    {
        FatalIOErrorInFunction(laminar)
            << "Laminar model " << model << " is not that of a gas." << nl
            << "Valid laminar model: Stokes" << exit(FatalIOError);
    }

    model_ = compressible::turbulenceModel::New(rho, U, phi, thermo);
}


void Foam::gasTurbulence::refuseEddies(const string& why) const
{
    if (eddies_)
    {
        FatalIOErrorInFunction(properties_)
            << "simulationType " << properties_.get<word>("simulationType")
            << ": " << why << nl << "Valid simulationType: laminar"
            << exit(FatalIOError);
    }
}


void Foam::gasTurbulence::checkSteady() const
{
    if (!eddies_)
    {
        return;
    }
    if (properties_.get<word>("simulationType") != "RAS")
    {
        refuseEddies
        (
            "eddies that are resolved have no steady state. Set 'mode"
            " transient;' in the block highSpeedGas of system/fvSolution, or"
            " 'simulationType RAS;'"
        );
    }

    static const wordList transported
    ({
        "k", "epsilon", "omega", "nuTilda", "R", "ReThetat", "gammaInt",
        "v2", "phit"
    });
    const fvMesh& mesh = geometry_.mesh();
    for (const word& field : transported)
    {
        if (!mesh.foundObject<regIOobject>(field))
        {
            continue;
        }
        const word term("ddt(rho," + field + ')');
        const word scheme(mesh.ddtScheme(term));
        if (scheme != "steadyState")
        {
            refuse
            (
                mesh.schemesDict().subDict("ddtSchemes"), term, scheme,
                "steadyState, since the gas is (mode steady)"
            );
        }
        if (!mesh.relaxEquation(field))
        {
            FatalIOErrorInFunction(mesh.solutionDict())
                << "The steady equation of " << field << " has no relaxation"
                << " factor." << nl << "Add to system/fvSolution:" << nl
                << "    relaxationFactors { equations { " << field
                << " 0.7; } }" << exit(FatalIOError);
        }
    }
}


void Foam::gasTurbulence::validate()
{
    if (model_.valid())
    {
        model_->validate();
    }
}


void Foam::gasTurbulence::correct(const bool report)
{
    if (model_.valid())
    {
        const int shown = solverPerformance::debug;
        solverPerformance::debug = report ? shown : 0;
        model_->correct();
        solverPerformance::debug = shown;
    }
}


void Foam::gasTurbulence::warnOfWallHeat()
{
    if (!eddies_ || warned_)
    {
        return;
    }
    const tmp<volScalarField> talphat(model_->alphat());
    const volScalarField::Boundary& alphat = talphat().boundaryField();

    forAll(alphat, patchi)
    {
        const fvPatchScalarField& Tp = thermo_.T().boundaryField()[patchi];
        if
        (
            !Tp.fixesValue()
         || alphat[patchi].type().find("WallFunction") == string::npos
        )
        {
            continue;
        }

        // Friction heats the gas by u^2/2, of which the wall function knows
        // as little as of the enthalpy of recovery
        const scalarField heated
        (
            0.5*magSqr(U_.boundaryField()[patchi].patchInternalField())
           /thermo_.Cp(thermo_.p().boundaryField()[patchi], Tp, patchi)
        );
        const scalarField driving(mag(Tp.patchInternalField() - Tp));
        label nWrong = 0;
        forAll(heated, facei)
        {
            nWrong +=
                alphat[patchi][facei] > 0
             && heated[facei] > 0.1*driving[facei];
        }
        reduce(nWrong, sumOp<label>());
        if (nWrong)
        {
            warned_ = true;
            WarningInFunction
                << "The heat flux of patch " << Tp.patch().name() << " is not"
                << " to be relied on: on " << nWrong << " faces the wall"
                << " function " << alphat[patchi].type() << " leaves out the"
                << " heat of friction, which warms the gas next to them by "
                << gMax(heated) << " K." << nl
                << "Resolve the wall layer (y+ below 1), where the wall"
                << " function adds nothing" << endl;
        }
    }
}


void Foam::gasTurbulence::take
(
    std::vector<double>& mut,
    std::vector<double>& alphat
) const
{
    auto fill = [&](const volScalarField& from, std::vector<double>& to)
    {
        to.assign(geometry_.nSlots(), 0);
        for (label c = 0; c < geometry_.nCells(); c++)
        {
            to[c] = from[geometry_.meshCell[c]];
        }
        for (const gasMesh::patchRange& patch : geometry_.patches())
        {
            const fvPatchScalarField& pf = from.boundaryField()[patch.patchi];
            double* ghost =
                &to[geometry_.nCells() + patch.start - geometry_.nInternal()];
            if (patch.image())
            {
                const labelUList& cells = pf.patch().faceCells();
                for (label i = 0; i < patch.size; i++)
                {
                    ghost[i] = from[cells[i]];
                }
            }
            else
            {
                std::copy(pf.begin(), pf.end(), ghost);
            }
        }
        geometry_.exchange(to.data(), 1);
    };

    const tmp<volScalarField> tmut(model_->mut());
    fill(tmut(), mut);
    const tmp<volScalarField> talphat(model_->alphat());
    fill(talphat(), alphat);
}
