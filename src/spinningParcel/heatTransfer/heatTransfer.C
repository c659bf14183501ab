/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "heatTransfer.H"
#include "checked.H"
#include "fvMesh.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

const Foam::wordList Foam::heatTransfer::properties
({
    "T0", "Cp0", "epsilon0", "TSurroundings", "melting"
});


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::heatTransfer::readModel()
{
    const char* entry = "heatTransferModel";
    wordList names;
    for (const std::string& name : impact::heatLaw::names())
    {
        names.append(name);
    }

    const dictionary* coeffs = models_.findDict(entry);
    if (!coeffs)
    {
        law_ = getWordOf(models_, entry, "ranzMarshall", names);
    }
    else
    {
        const dictionary& d = *coeffs;
        law_ = getWordOf(d, "type", "", names);
        wordList valid{"type", "thermo"};
        thermoName_ = d.getOrDefault<word>("thermo", thermoName_);
        if (law_ == "freeMolecular")
        {
            valid.append("accommodation");
            coefficients_.accommodation =
                getNumber(d, "accommodation", validRange::share, scalar(1));
        }
        else
        {
            valid.append("recoveryFactor");
            coefficients_.recoveryFactor =
                getNumber(d, "recoveryFactor", "[0, 2]", scalar(-1));
        }
        if (law_ == "kavanau")
        {
            valid.append("form");
            coefficients_.form =
                getWord(d, "form", {"ranzMarshall", "original"});
        }
        refuseOthers(d, valid);
    }
}


Foam::scalar Foam::heatTransfer::uniform
(
    const scalarField& field,
    const char* what
) const
{
    const scalar low = gMin(field);
    const scalar high = gMax(field);
    if (!(high - low <= 1e-9*high))
    {
        FatalIOErrorInFunction(models_)
            << "heatTransfer on: " << what << " of the gas goes from " << low
            << " to " << high << ": valid range a uniform one"
            << " (thermo hConst or eConst, transport const or sutherland)"
            << exit(FatalIOError);
    }
    return 0.5*(low + high);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::heatTransfer::heatTransfer
(
    const dictionary& cloudProperties,
    const fvMesh& mesh
)
:
    mesh_(mesh),
    models_(cloudProperties.subDict("subModels")),
    thermoName_(basicThermo::dictName)
{
    const dictionary& d = cloudProperties.subDict("constantProperties");
    T0_ = getNumber(d, "T0", validRange::temperature);
    emissivity_ = getNumber(d, "epsilon0", validRange::share, scalar(0));
    TSurroundings_ =
        emissivity_ > 0
      ? getNumber(d, "TSurroundings", "[0, 1e8) K, nothing is solid there")
      : 0;

    impact::specificHeat::melting melting;
    if (const dictionary* m = findBlock(d, "melting"))
    {
        refuseOthers(*m, {"solidus", "liquidus", "latentHeat"});
        melting.solidus = getNumber(*m, "solidus", validRange::temperature);
        melting.liquidus = getNumber(*m, "liquidus", validRange::temperature);
        melting.latentHeat =
            getNumber(*m, "latentHeat", "(0, 1e9] J/kg, more than any bond");
    }
    const scalarList Cp(getNumbers(d, "Cp0", "(-1e30, 1e30) J/kg/K"));
    material_ = checked
    (
        d, [&]
        {
            return std::make_unique<impact::specificHeat>
            (
                std::vector<double>(Cp.begin(), Cp.end()), melting
            );
        }
    );

    readModel();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

const Foam::fluidThermo& Foam::heatTransfer::thermo() const
{
    const fluidThermo* gas = mesh_.findObject<fluidThermo>(thermoName_);
    if (!gas)
    {
        FatalIOErrorInFunction(models_)
            << "heatTransfer on needs the temperature of the gas. Entry thermo "
            << thermoName_ << " is no compressible fluid thermophysical model"
            << " of region " << mesh_.name() << ": valid range "
            << mesh_.sortedNames<fluidThermo>()
            << " (an incompressible solver has none)" << exit(FatalIOError);
    }
    return *gas;
}


void Foam::heatTransfer::update()
{
    const fluidThermo& gas = thermo();
    if (gas.T().eventNo() != TEvent_)
    {
        TEvent_ = gas.T().eventNo();
        const scalarField Cp(gas.Cp()().primitiveField());
        const scalarField Cv(gas.Cv()().primitiveField());
        const scalarField mu(gas.mu()().primitiveField());
        const scalarField& psi = gas.psi().primitiveField();
        if (gMin(psi) <= 0)
        {
            FatalIOErrorInFunction(models_)
                << "heatTransfer on needs a speed of sound. Entry thermo "
                << thermoName_ << ": valid range a model with a compressible"
                << " equation of state (psi > 0)" << exit(FatalIOError);
        }
        const scalarField& T = gas.T().primitiveField();
        const scalar gamma = uniform(Cp/Cv, "the ratio of specific heats");
        const scalar Pr = uniform
        (
            mu/gas.alpha().primitiveField(), "the Prandtl number"
        );
        const scalar R = uniform(1/(psi*T), "the gas constant, 1/(psi T),");
        Cv_ = uniform(Cv, "the specific heat");
        gammaR_ = gamma*R;
        CpOverPr_ = gamma*Cv_/Pr;

        // Rounded data of a monatomic gas are beyond 5/3 by their last digits
        const scalar monatomic = 5.0/3.0;
        if (gamma > 1.002*monatomic)
        {
            FatalIOErrorInFunction(models_)
                << "heatTransfer on: Cp and molWeight of " << thermoName_
                << " make a ratio of specific heats of " << gamma
                << ": valid range (1, 5/3]" << exit(FatalIOError);
        }
        coefficients_.gamma = min(gamma, monatomic);
        coefficients_.Pr = Pr;
        heatLaw_ = checked
        (
            models_, [&]{ return impact::heatLaw::New(law_, coefficients_); }
        );
    }
}
