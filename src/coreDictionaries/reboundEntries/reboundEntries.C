/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "reboundEntries.H"
#include "checked.H"
#include "OSspecific.H"
#include "outOfRange.H"

namespace
{

using namespace Foam;

// Restitution and angles; coefficients of powers
const char* const coefficientRange = "[-1e6, 1e6]";

const char* const speedRange = "[0, 3e8) m/s, less than light";


std::vector<double> numbers(const scalarList& list)
{
    return std::vector<double>(list.begin(), list.end());
}


//- A list of numbers, or of lists of numbers of the same length
List<scalarList> readRows(const dictionary& dict, const word& entry)
{
    // Nested if a second list opens before the first number
    label depth = 0;
    for (const token& t : dict.lookup(entry))
    {
        if (t.isNumber() || depth == 2)
        {
            break;
        }
        depth += t == token::BEGIN_LIST;
    }
    if (depth == 2)
    {
        const List<scalarList> rows(dict.get<List<scalarList>>(entry));
        for (const scalarList& row : rows)
        {
            for (const scalar value : row)
            {
                checkNumber(dict, entry, value, coefficientRange);
            }
        }
        return rows;
    }
    List<scalarList> rows;
    for (const scalar value : getList(dict, entry, coefficientRange))
    {
        rows.append(scalarList(1, value));
    }
    return rows;
}


impact::reboundCoefficient readTable
(
    const dictionary& coeffs,
    const impact::reboundCoefficient::quantity& quantity
)
{
    typedef impact::reboundCoefficient form;

    if (coeffs.found("file"))
    {
        refuseOthers(coeffs, {"type", "file"});
        const fileName file(getFile(coeffs, "file", getEnv("FOAM_CASE")));
        return checked(coeffs, [&] { return form::table(quantity, file); });
    }
    refuseOthers(coeffs, {"type", "file", "angles", "speeds", "values"});
    std::vector<double> values;
    for (const scalarList& row : readRows(coeffs, "values"))
    {
        values.insert(values.end(), row.begin(), row.end());
    }
    const scalarList angles(getList(coeffs, "angles", "[0, 90] deg"));
    const scalarList speeds
    (
        getList(coeffs, "speeds", speedRange, scalarList(1, Zero))
    );
    return checked
    (
        coeffs,
        [&]
        {
            return form::table
            (
                quantity, numbers(angles), numbers(speeds), values
            );
        }
    );
}


impact::reboundCoefficient readPolynomial
(
    const dictionary& coeffs,
    const impact::reboundCoefficient::quantity& quantity
)
{
    refuseOthers
    (
        coeffs, {"type", "coefficients", "angleRange", "speedRange"}
    );
    std::vector<std::vector<double>> coefficients;
    for (const scalarList& row : readRows(coeffs, "coefficients"))
    {
        coefficients.push_back(numbers(row));
    }
    typedef Tuple2<scalar, scalar> range;
    const range angles(coeffs.getOrDefault<range>("angleRange", {0, 90}));
    range speeds(0, 0);
    if (!coefficients.empty() && coefficients[0].size() > 1)
    {
        coeffs.readEntry("speedRange", speeds);
    }
    else if (coeffs.found("speedRange"))
    {
        FatalIOErrorInFunction(coeffs)
            << "Entry speedRange has no meaning for coefficients of one column,"
            << " which do not depend on the speed." << nl
            << "Remove it, or give a column for each power of the speed"
            << exit(FatalIOError);
    }
    for (const scalar angle : {angles.first(), angles.second()})
    {
        checkNumber(coeffs, "angleRange", angle, "[0, 90] deg");
    }
    for (const scalar speed : {speeds.first(), speeds.second()})
    {
        checkNumber(coeffs, "speedRange", speed, speedRange);
    }
    return checked
    (
        coeffs,
        [&]
        {
            return impact::reboundCoefficient::polynomial
            (
                quantity, coefficients, angles.first(), angles.second(),
                speeds.first(), speeds.second()
            );
        }
    );
}

} // End anonymous namespace


impact::reboundCoefficient Foam::reboundEntries::coefficient
(
    const dictionary& dict,
    const impact::reboundCoefficient::quantity& quantity,
    const std::optional<scalar>& deflt
)
{
    typedef impact::reboundCoefficient form;

    const word entry(quantity.name);
    if (dict.isDict(entry))
    {
        const dictionary& coeffs = getBlock(dict, entry);
        wordList types{"table", "polynomial"};
        if (quantity.of == form::component::normal)
        {
            types.append("McNamaraFalcon");
        }
        const word type(getWordOf(coeffs, "type", "", types));
        if (type == "table")
        {
            return readTable(coeffs, quantity);
        }
        if (type == "polynomial")
        {
            return readPolynomial(coeffs, quantity);
        }
        refuseOthers(coeffs, {"type", "restitution", "speed"});
        const scalar value =
            getNumber(coeffs, "restitution", validRange::share);
        const scalar speed = getNumber(coeffs, "speed", validRange::speed);
        return checked
        (
            coeffs,
            [&] { return form::McNamaraFalcon(quantity, value, speed); }
        );
    }
    if (dict.found(entry) && !token(dict.lookup(entry)).isNumber())
    {
        const word name(dict.get<word>(entry));
        wordList names;
        for (const std::string& fit : form::fits(quantity))
        {
            names.append(fit);
        }
        if (!names.found(name))
        {
            unknownWord(dict, entry.c_str(), name, names);
        }
        return form::fit(quantity, name);
    }
    const scalar value =
        missing(dict, entry, deflt)
      ? *deflt
      : getNumber
        (
            dict, entry,
            impact::rangeText("[]", quantity.low, quantity.high)
        );
    return checked(dict, [&] { return form::constant(quantity, value); });
}


impact::hardSphereWall Foam::reboundEntries::hardSphere
(
    const dictionary& dict
)
{
    typedef impact::hardSphereWall law;
    const word model
    (
        getWordOf
        (
            dict, "restitutionModel", "constant",
            {"constant", "McNamaraFalcon"}
        )
    );
    refuseOthers
    (
        dict,
        model == "constant"
      ? wordList{"type", "restitutionModel", "restitution", "friction"}
      : wordList
        {
            "type", "restitutionModel", "restitution", "friction",
            "restitutionSpeed"
        }
    );
    typedef impact::reboundCoefficient form;
    const form friction(coefficient(dict, form::frictionQuantity()));
    if (model == "constant")
    {
        return law(coefficient(dict, form::restitutionQuantity()), friction);
    }
    const scalar restitution =
        getNumber(dict, "restitution", validRange::share);
    const scalar speed =
        getNumber(dict, "restitutionSpeed", validRange::speed);
    return checked
    (
        dict,
        [&]
        {
            return law
            (
                form::McNamaraFalcon
                (
                    form::restitutionQuantity(), restitution, speed
                ),
                friction
            );
        }
    );
}


impact::semiEmpiricalRebound Foam::reboundEntries::semiEmpirical
(
    const dictionary& dict
)
{
    typedef impact::semiEmpiricalRebound law;
    refuseOthers(dict, {"type", "normal", "tangential", "criticalAngle"});
    return law
    (
        coefficient(dict, law::normalQuantity()),
        coefficient(dict, law::tangentialQuantity()),
        coefficient(dict, law::criticalAngleQuantity())
    );
}
