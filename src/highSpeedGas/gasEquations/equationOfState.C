/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "gasEquations.H"
#include "thermodynamicConstants.H"
#include <algorithm>

void Foam::gasEquations::setClosure()
{
    const IOdictionary& properties = thermo_;
    const dictionary& type = properties.subDict("thermoType");
    const word state(type.get<word>("equationOfState"));
    const word mixture(type.get<word>("mixture"));

    if (state != "perfectGas")
    {
        FatalIOErrorInFunction(type)
            << "equationOfState " << state << " is not a perfect gas." << nl
            << "Valid equationOfState: perfectGas" << exit(FatalIOError);
    }
    if (mixture != "pureMixture")
    {
        FatalIOErrorInFunction(type)
            << "mixture " << mixture << " is not a single gas." << nl
            << "Valid mixture: pureMixture" << exit(FatalIOError);
    }

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

    const scalar W = thermo_.W()()[0];
    closure_.R = constant::thermodynamic::RR/W;

    const scalarField he(thermo_.he(p, T, cells));
    const bool enthalpyForm = thermo_.he().name() == "h";

    closureEnergy_.resize(n + 1);
    closureHeat_.resize(n + 1);
    forAll(T, i)
    {
        closureEnergy_[i] =
            he[i] - he[0] - (enthalpyForm ? closure_.R*(T[i] - T[0]) : 0);
    }

    closure_.T0 = low;
    closure_.dT = (high - low)/n;
    closure_.cv = closureEnergy_[n]/(high - low);
    closure_.n = 0;
    closure_.e = nullptr;
    closure_.c = nullptr;

    if (!constantHeat)
    {
        // Specific heat at the nodes: slope of the quartic through five
        // neighbouring energies (the models are polynomials of this order)
        const scalar h = closure_.dT;
        auto slope = [&](const label i)
        {
            const label m = min(max(i, label(2)), n - 2);
            const double* e = &closureEnergy_[m - 2];
            const scalar x = i - m;
            scalar d = 0;
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
                d += sum*e[k];
            }
            return d/h;
        };

        for (label i = 0; i <= n; i++)
        {
            closureHeat_[i] = slope(i);
        }

        // Energy counted so that the gas has none at zero temperature if its
        // specific heat went on as it is at the low end
        const scalar offset = closureHeat_[0]*low;
        for (label i = 0; i <= n; i++)
        {
            closureEnergy_[i] += offset;
        }
        closure_.n = n;
        closure_.e = closureEnergy_.data();
        closure_.c = closureHeat_.data();
    }

    const scalar cv =
        constantHeat
      ? closure_.cv
      : *std::min_element(closureHeat_.begin(), closureHeat_.end());

    if (!(cv > 0) || !(closure_.R > 0))
    {
        FatalIOErrorInFunction(properties)
            << "The gas has no ratio of specific heats: R = " << closure_.R
            << " J/(kg K), smallest Cv = " << cv << " J/(kg K)." << nl
            << "Both must be > 0 (entries molWeight, Cp or Cv)"
            << exit(FatalIOError);
    }
}


void Foam::gasEquations::setTransport()
{
    closure_.As = 0;
    closure_.Ts = 0;
    closure_.mu = 0;
    closure_.Pr = 1;
    if (!viscous_)
    {
        return;
    }

    const IOdictionary& properties = thermo_;
    const dictionary& type = properties.subDict("thermoType");
    const word model(type.get<word>("transport"));
    const dictionary& d = properties.subDict("mixture").subDict("transport");

    auto positive = [&](const word& name)
    {
        const scalar value = d.get<scalar>(name);
        if (!(value > 0))
        {
            FatalIOErrorInFunction(d)
                << "Entry " << name << " is " << value
                << "; its valid range is > 0" << exit(FatalIOError);
        }
        return value;
    };

    if (model == "sutherland")
    {
        closure_.As = positive("As");
        closure_.Ts = positive("Ts");
    }
    else if (model == "const")
    {
        closure_.mu = positive("mu");
        closure_.Pr = positive("Pr");
    }
    else
    {
        FatalIOErrorInFunction(type)
            << "transport " << model << " cannot be used with viscous flow."
            << nl << "Valid transport: const, sutherland"
            << exit(FatalIOError);
    }
}
