/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "highSpeedGas.H"
#include "checked.H"
#include "localIOdictionary.H"
#include "presentFile.H"
#include "sigFpe.H"

namespace
{

using namespace Foam;

// What boundary conditions on p and T give, by type
const HashTable<word> ofPositive
{
    {"fixedValue", "value"}, {"inletOutlet", "inletValue"},
    {"outletInlet", "outletValue"}, {"freestream", "freestreamValue"},
    {"freestreamPressure", "freestreamValue"}, {"totalPressure", "p0"},
    {"totalTemperature", "T0"}
};

} // End anonymous namespace

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::highSpeedGas::refuseWhatIsNotSolved() const
{
    const Time& time = mesh_.time();

    // Whether a file is there and says something, and that
    auto contents = [&](const word& name, const fileName& folder)
    {
        IOobject io
        (
            name, folder, mesh_, IOobject::READ_IF_PRESENT,
            IOobject::NO_WRITE, false
        );
        isPresent<IOdictionary>(io);    // or refused, without a header
        return localIOdictionary(io);
    };

    const localIOdictionary motion
    (
        contents("dynamicMeshDict", time.constant())
    );
    const word dynamicMesh
    (
        motion.getOrDefault<word>
        (
            "dynamicFvMesh",
            motion.getOrDefault<word>
            (
                "solver", motion.empty() ? "staticFvMesh" : "(none)"
            )
        )
    );
    if (dynamicMesh != "staticFvMesh")
    {
        FatalIOErrorInFunction(motion)
            << "Entry dynamicFvMesh is " << dynamicMesh << ": the gas is"
            << " solved on meshes at rest." << nl
            << "Valid: staticFvMesh, or no file constant/dynamicMeshDict"
            << exit(FatalIOError);
    }

    for
    (
        const word name : {"fvOptions", "MRFProperties", "porosityProperties"}
    )
    {
        for
        (
            const fileName& folder :
            {fileName(time.constant()), fileName(time.system())}
        )
        {
            const localIOdictionary sources(contents(name, folder));
            for (const entry& e : sources)
            {
                if (e.isDict() && e.dict().getOrDefault("active", true))
                {
                    FatalIOErrorInFunction(sources)
                        << "Entry " << e.keyword() << ": the gas takes no"
                        << " sources, rotating or porous zones from " << name
                        << '.'
                        << nl << "Set 'active no;' in it, or remove it"
                        << exit(FatalIOError);
                }
            }
        }
    }

    const localIOdictionary radiation
    (
        contents("radiationProperties", time.constant())
    );
    if
    (
        radiation.getOrDefault("radiation", true)
     && radiation.getOrDefault<word>("radiationModel", "none") != "none"
    )
    {
        FatalIOErrorInFunction(radiation)
            << "Entry radiationModel is "
            << radiation.get<word>("radiationModel")
            << ": the gas does not radiate." << nl
            << "Valid: none, or 'radiation off;'" << exit(FatalIOError);
    }
}


void Foam::highSpeedGas::refuseTimeScheme() const
{
    const dictionary& schemes = mesh_.schemesDict().subDict("ddtSchemes");
    static const wordHashSet local
    {
        "localEuler", "SLTS", "CoEuler", "steadyState"
    };

    for (const entry& e : schemes)
    {
        if (e.isDict())
        {
            continue;
        }
        ITstream& is = e.stream();
        word name(is);
        if (name == "bounded")
        {
            is >> name;
        }
        if (local.found(name) && mode_ == modeType::transient)
        {
            FatalIOErrorInFunction(schemes)
                << "Entry " << e.keyword() << " is " << name
                << ", which leads to a steady state, but the gas is marched"
                << " in time." << nl
                << "For a steady state set 'mode steady;' in the block"
                << " highSpeedGas of system/fvSolution; for a flow in time"
                << " set Euler" << exit(FatalIOError);
        }
    }
}


void Foam::highSpeedGas::readSettings()
{
    const dictionary& solution = mesh_.solutionDict();
    const dictionary* found = findBlockAmongOthers(solution, "highSpeedGas");
    const dictionary& d = found ? *found : dictionary::null;

    refuseOthers
    (
        d,
        {
            "mode", "scheme", "maxCo", "residual", "maxIterations",
            "reportEvery", "viscous", "feedback"
        }
    );
    findBlock(d, "feedback");   // is no word, also where nothing reads it

    mode_ = modeNames
    [
        getWord(d, "mode", {"transient", "steady", "frozen"})
    ];
    refuseTimeScheme();

    const bool steady = mode_ == modeType::steady;
    const wordList schemes({"Euler", "RK2", "RK3", "implicit"});
    const label i = schemes.find
    (
        getWordOf(d, "scheme", steady ? "implicit" : "RK3", schemes)
    );
    if (i == 3 && mode_ == modeType::transient)
    {
        unknownWord
        (
            d, "scheme", "implicit", {"Euler", "RK2", "RK3"},
            " with mode transient, the default"
        );
    }
    implicit_ = i == 3;
    stages_ = implicit_ ? 3 : i + 1;

    const dictionary& control = mesh_.time().controlDict();
    const bool adjusts =
        mode_ == modeType::transient
     && control.getOrDefault("adjustTimeStep", false);

    maxCo_ = getNumber
    (
        d, "maxCo", implicit_ ? "(0, 1e9]" : "(0, 1]",
        scalar(implicit_ ? 100 : adjusts ? 1 : 0.5)
    );
    largestCo(control);
    residual_ = getNumber(d, "residual", "(0, 1)", scalar(1e-6));
    maxIterations_ =
        getNumber<label>(d, "maxIterations", validRange::count, 10000);
    reportEvery_ = getNumber<label>(d, "reportEvery", validRange::count, 100);
    if (!steady && d.found("residual"))
    {
        Info<< "Gas: residual is an entry of mode steady; this is mode "
            << modeNames[mode_] << endl;
    }
    viscous_ = d.getOrDefault
    (
        "viscous", gasEquations::hasViscosity(*thermo_)
    );
}


Foam::scalar Foam::highSpeedGas::largestCo(const dictionary& control)
{
    return getNumber(control, "maxCo", "(0, 1e300]", scalar(0.5));
}


void Foam::highSpeedGas::checkGas(const fvMesh& mesh)
{
    // The stock models divide by some of these numbers before they look
    static const List<Tuple2<word, string>> ranges
    {
        {"molWeight", "[0.1, 1e6] kg/kmol, lighter than hydrogen to polymers"},
        {"Cp", "(0, 1e9) J/(kg K)"},
        {"Cv", "(0, 1e9) J/(kg K)"},
        {"mu", "[0, 1e3] Pa s, no gas"},
        {"Pr", "(0, 1e6]"},
        {"As", "[0, 1] kg/(m s K^0.5), about 1e-6 for gases"},
        {"Ts", "[0, 1e5] K"}
    };
    IOobject io
    (
        basicThermo::dictName, mesh.time().constant(), mesh,
        IOobject::MUST_READ, IOobject::NO_WRITE, false
    );
    if (!isPresent<IOdictionary>(io))
    {
        return;     // the stock reader says so
    }
    const IOdictionary properties(io);
    const dictionary& gas = properties.subOrEmptyDict("mixture");
    for (const entry& e : gas)
    {
        if (!e.isDict())
        {
            continue;
        }
        for (const Tuple2<word, string>& range : ranges)
        {
            const ITstream* is =
                e.dict().found(range.first())
             && !e.dict().isDict(range.first())
              ? &e.dict().lookup(range.first()) : nullptr;
            if (is && is->size() && (*is)[0].isNumber())
            {
                checkNumber
                (
                    e.dict(), range.first(), (*is)[0].number(), range.second()
                );
            }
        }
    }
}


Foam::autoPtr<Foam::fluidThermo> Foam::highSpeedGas::readThermo
(
    const fvMesh& mesh
)
{
    for (const word name : {"p", "T"})
    {
        const localIOdictionary file
        (
            readField(mesh, name, volScalarField::typeName)
        );
        checkDimensions
        (
            file, name, name == "p" ? dimPressure : dimTemperature
        );
        checkPositive(mesh, name, file);
    }
    checkDimensions
    (
        readField(mesh, "U", volVectorField::typeName), "U", dimVelocity
    );
    checkGas(mesh);
    autoPtr<fluidThermo> thermo(fluidThermo::New(mesh));
    restoreTemperature(thermo->T(), readField(mesh, "T", thermo->T().type()));
    for (const word name : {"p", "T"})
    {
        checkGamma(thermo(), readField(mesh, name, volScalarField::typeName));
    }
    return thermo;
}


void Foam::highSpeedGas::checkGamma
(
    const fluidThermo& thermo,
    const dictionary& file
)
{
    const tmp<volScalarField> gamma(thermo.gamma());
    const dictionary& boundary = file.subDict("boundaryField");
    for (const fvPatch& patch : thermo.T().mesh().boundary())
    {
        const dictionary* d =
            boundary.findDict(patch.name(), keyType::REGEX);
        if
        (
            patch.coupled() || !d || !d->found("gamma")
         || d->getOrDefault<word>("type", "") == "waveTransmissive"
        )
        {
            continue;   // or only the speed at which waves leave
        }
        const scalar given = d->get<scalar>("gamma");
        const word type(d->getOrDefault<word>("type", ""));
        if
        (
            (type == "totalPressure" || type == "uniformTotalPressure")
         && d->getOrDefault<word>("psi", "none") == "none"
        )
        {
            // As the condition itself writes it, or not heard
            if (given != 1)
            {
                FatalIOErrorInFunction(*d)
                    << "Entry gamma of p on patch " << patch.name()
                    << " is not taken without psi: the total pressure is that"
                    << " of a gas of constant density." << nl
                    << "Add 'psi thermo:psi;', or remove gamma where gas comes"
                    << " in slowly" << exit(FatalIOError);
            }
            continue;
        }
        const scalar ofGas =
            gAverage(gamma().boundaryField()[patch.index()]);
        if (ofGas > 0 && mag(given - ofGas) > 0.02*ofGas)
        {
            IOWarningInFunction(*d)
                << "Entry gamma is " << given << ", that of the gas on patch "
                << patch.name() << " is " << ofGas << ": what comes in has"
                << " another total pressure or temperature than is said"
                << endl;
        }
    }
}


void Foam::highSpeedGas::restoreTemperature
(
    volScalarField& T,
    const dictionary& file
)
{
    T.primitiveFieldRef() = scalarField("internalField", file, T.size());
    const dictionary& boundary = file.subDict("boundaryField");
    for (fvPatchScalarField& Tp : T.boundaryFieldRef())
    {
        const dictionary* d =
            boundary.findDict(Tp.patch().name(), keyType::REGEX);
        if (d && d->found("value"))
        {
            Tp == scalarField("value", *d, Tp.size());
        }
        else if (Tp.type() == "zeroGradient")
        {
            Tp.evaluate();
        }
    }
}


Foam::localIOdictionary Foam::highSpeedGas::readField
(
    const fvMesh& mesh,
    const word& name,
    const word& type
)
{
    return localIOdictionary
    (
        IOobject
        (
            name,
            mesh.time().timeName(),
            mesh,
            IOobject::MUST_READ,
            IOobject::NO_WRITE,
            false
        ),
        type
    );
}


void Foam::highSpeedGas::checkDimensions
(
    const dictionary& file,
    const word& name,
    const dimensionSet& valid
)
{
    const dimensionSet given(file.lookup("dimensions"));
    if (given != valid)
    {
        FatalIOErrorInFunction(file)
            << "Entry dimensions of " << name << " is " << given << nl
            << "Valid: " << valid
            << (name == "p" ? ", Pa: not that over the density" : "")
            << exit(FatalIOError);
    }
}


void Foam::highSpeedGas::checkPositive
(
    const fvMesh& mesh,
    const word& name,
    const dictionary& file
)
{
    const sigFpe::ignore untrapped;     // A NaN must be looked at
    auto check = [&](const dictionary& d, const word& key, const label size)
    {
        const scalarField values(key, d, size);
        forAll(values, i)
        {
            if (!(values[i] > 0 && values[i] < GREAT))
            {
                FatalIOErrorInFunction(d)
                    << "Entry " << key << " of " << name << " in "
                    << d.dictName() << " holds " << name << " = " << values[i]
                    << " at index " << i
                    << "; pressure and temperature must be positive (> 0)"
                    << " and finite" << exit(FatalIOError);
            }
        }
    };

    check(file, "internalField", mesh.nCells());

    const dictionary& boundary = file.subDict("boundaryField");
    for (const fvPatch& patch : mesh.boundary())
    {
        const dictionary* d =
            boundary.findDict(patch.name(), keyType::REGEX);
        const word type(d ? d->getOrDefault<word>("type", "") : "");
        const auto key = ofPositive.cfind(type);
        if (key.found() && d->found(key.val()))
        {
            check(*d, key.val(), patch.size());
        }
    }
}
