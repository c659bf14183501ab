/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "gasEquations.H"
#include "checked.H"
#include "thermodynamicConstants.H"
#include <algorithm>

namespace
{

using Foam::label;
using Foam::scalar;

//- Slope of the quartic through five neighbouring values, one apart, at the
//  value i (the models of specific heat are polynomials of this order)
scalar slopeOf(const std::vector<double>& values, const label i)
{
    const label n = label(values.size()) - 1;
    const label m = Foam::min(Foam::max(i, label(2)), n - 2);
    const double* e = &values[m - 2];
    const scalar x = i - m;
    scalar slope = 0;
    for (label k = 0; k < 5; k++)
    {
        // Derivative of the Lagrange basis polynomial k at x
        scalar sum = 0;
        for (label j = 0; j < 5; j++)
        {
            if (j == k)
            {
                continue;
            }
            scalar product = 1.0/(k - j);
            for (label l = 0; l < 5; l++)
            {
                if (l != k && l != j)
                {
                    product *= (x - (l - 2))/(k - l);
                }
            }
            sum += product;
        }
        slope += sum*e[k];
    }
    return slope;
}

} // End anonymous namespace


void Foam::gasEquations::refuseOtherGases() const
{
    const IOdictionary& properties = thermo_;
    const dictionary& type = properties.subDict("thermoType");

    // Liquids have properties instead
    const word key
    (
        type.found("properties") ? "properties" : "equationOfState"
    );
    const word state(type.get<word>(key));
    const word mixture(type.get<word>("mixture"));

    if (state != "perfectGas")
    {
        FatalIOErrorInFunction(type)
            << key << " " << state << " is not a perfect gas." << nl
            << "Valid equationOfState: perfectGas" << exit(FatalIOError);
    }
    if (mixture != "pureMixture")
    {
        FatalIOErrorInFunction(type)
            << "mixture " << mixture << " is not a single gas." << nl
            << "Valid mixture: pureMixture" << exit(FatalIOError);
    }
}


void Foam::gasEquations::setEquationOfState()
{
    refuseOtherGases();
    const IOdictionary& properties = thermo_;
    const dictionary& type = properties.subDict("thermoType");

    // Sample the model of the case over the range of temperatures it can meet
    const word caloric(type.get<word>("thermo"));
    const bool constantHeat = caloric == "hConst" || caloric == "eConst";

    scalar low = 20;
    scalar high = 20000;
    if (!constantHeat)
    {
        const dictionary& thermodynamics =
            properties.subDict("mixture").subDict("thermodynamics");
        low = thermodynamics.getOrDefault<scalar>("Tlow", 50);
        high = thermodynamics.getOrDefault<scalar>("Thigh", 6000);
    }

    const label n = constantHeat ? 1 : label(ceil((high - low)/2));
    scalarField T(n + 1);
    forAll(T, i)
    {
        T[i] = low + i*(high - low)/n;
    }
    const scalarField p(n + 1, 1e5);
    const labelList cells(n + 1, Zero);

    // (a rank may have no cells)
    const scalar W = gMax(thermo_.W()().primitiveField());
    eos_.R = constant::thermodynamic::RR/W;

    const scalarField he(thermo_.he(p, T, cells));
    const bool enthalpyForm = thermo_.he().name() == "h";

    tableEnergy_.resize(n + 1);
    tableHeat_.resize(n + 1);
    forAll(T, i)
    {
        tableEnergy_[i] =
            he[i] - he[0] - (enthalpyForm ? eos_.R*(T[i] - T[0]) : 0);
    }

    eos_.T0 = low;
    eos_.dT = (high - low)/n;
    eos_.cv = tableEnergy_[n]/(high - low);
    eos_.n = 0;
    eos_.e = nullptr;
    eos_.c = nullptr;

    if (!constantHeat)
    {
        // Specific heat at the nodes
        for (label i = 0; i <= n; i++)
        {
            tableHeat_[i] = slopeOf(tableEnergy_, i)/eos_.dT;
        }

        trimTable(low, eos_.dT);
    }

    // Energy of the model where the equation of state has its first node
    const scalar T0 = eos_.T0;
    energyOffset_ =
        thermo_.he
        (
            scalarField(1, 1e5), scalarField(1, T0), labelList(1, Zero)
        )()[0]
      - (enthalpyForm ? eos_.R*T0 : 0)
      - (
            eos_.thermallyPerfect()
          ? eos_.energy<true>(T0)
          : eos_.energy<false>(T0)
        );

    if (!(eos_.cv > 0) || !(eos_.R > 0))
    {
        FatalIOErrorInFunction(properties)
            << "The gas has no ratio of specific heats: R = " << eos_.R
            << " J/(kg K), Cv = " << eos_.cv << " J/(kg K)." << nl
            << "Both must be > 0 (entries molWeight, Cp or Cv)"
            << exit(FatalIOError);
    }
}


void Foam::gasEquations::trimTable(const scalar low, const scalar dT)
{
    const label n = label(tableHeat_.size()) - 1;

    // Temperatures of the case at the start
    scalar minTemperature = GREAT;
    scalar maxTemperature = 0;
    auto extend = [&](const scalarField& T)
    {
        for (const scalar t : T)
        {
            minTemperature = min(minTemperature, t);
            maxTemperature = max(maxTemperature, t);
        }
    };
    extend(thermo_.T().primitiveField());
    forAll(thermo_.T().boundaryField(), patchi)
    {
        extend(thermo_.T().boundaryField()[patchi]);
    }
    reduce(minTemperature, minOp<scalar>());
    reduce(maxTemperature, maxOp<scalar>());

    // No ideal gas has less than 3/2 R: a polynomial that gives less than a
    // third of that has left its range
    auto good = [&](const label i)
    {
        return tableHeat_[i] > 0.5*eos_.R;
    };
    auto node = [&](const scalar T)
    {
        return min(max(label((T - low)/dT), label(0)), n - 1);
    };

    label first = node(minTemperature);
    label last = node(maxTemperature) + 1;
    for (label i = first; i <= last; i++)
    {
        if (!good(i))
        {
            FatalIOErrorInFunction
            (
                static_cast<const IOdictionary&>(thermo_)
            )
                << "The specific heat Cv of the gas is " << tableHeat_[i]
                << " J/(kg K) at " << low + i*dT << " K; it must be above R/2"
                << " = " << 0.5*eos_.R << " J/(kg K) at the temperatures"
                << " of the case, " << minTemperature << " to "
                << maxTemperature << " K (entry thermodynamics)"
                << exit(FatalIOError);
        }
    }
    while (first > 0 && good(first - 1))
    {
        first--;
    }
    while (last < n && good(last + 1))
    {
        last++;
    }

    tableHeat_.erase(tableHeat_.begin() + last + 1, tableHeat_.end());
    tableHeat_.erase(tableHeat_.begin(), tableHeat_.begin() + first);
    tableEnergy_.erase
    (
        tableEnergy_.begin() + last + 1, tableEnergy_.end()
    );
    tableEnergy_.erase
    (
        tableEnergy_.begin(), tableEnergy_.begin() + first
    );
    lowestT_ = low + first*dT;
    highestT_ = low + last*dT;

    // Energy counted so that the gas has none at zero temperature if its
    // specific heat went on as it is at the low end
    const scalar offset = tableHeat_[0]*lowestT_ - tableEnergy_[0];
    for (double& e : tableEnergy_)
    {
        e += offset;
    }

    eos_.T0 = lowestT_;
    eos_.n = last - first;
    eos_.cv = tableHeat_[0];
    eos_.e = tableEnergy_.data();
    eos_.c = tableHeat_.data();
}


bool Foam::gasEquations::hasViscosity(const fluidThermo& thermo)
{
    return gMax(thermo.mu()().primitiveField()) > 0;
}


void Foam::gasEquations::setTransport()
{
    eos_.As = 0;
    eos_.Ts = 0;
    eos_.mu = 0;
    eos_.Pr = 1;

    const IOdictionary& properties = thermo_;
    const dictionary& type = properties.subDict("thermoType");
    const word model(type.get<word>("transport"));
    const dictionary& d = properties.subDict("mixture").subDict("transport");

    auto inRange = [&](const word& name, const bool zeroToo)
    {
        return getNumber(d, name, zeroToo ? "[0, inf)" : "(0, inf)");
    };

    transportKnown_ = model == "sutherland" || model == "const";
    if (model == "sutherland")
    {
        eos_.As = inRange("As", !viscous_);
        eos_.Ts = inRange("Ts", !viscous_);
    }
    else if (model == "const")
    {
        eos_.mu = inRange("mu", !viscous_);
        eos_.Pr = inRange("Pr", false);
    }
    else if (viscous_)
    {
        FatalIOErrorInFunction(type)
            << "transport " << model << " cannot be used with viscous flow."
            << nl << "Valid transport: const, sutherland" << nl
            << "(a gas without friction: viscous no; in the block highSpeedGas"
            << " of system/fvSolution)" << exit(FatalIOError);
    }
}
