/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "reboundEntries.H"
#include "checked.H"
#include "Tuple2.H"
#include "scalarList.H"

namespace
{

using namespace Foam;

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
        return dict.get<List<scalarList>>(entry);
    }
    List<scalarList> rows;
    for (const scalar value : dict.get<scalarList>(entry))
    {
        rows.append(scalarList(1, value));
    }
    return rows;
}


impact::reboundCoefficient readCoefficient
(
    const dictionary& dict,
    const word& entry,
    const impact::reboundCoefficient::quantity& quantity
)
{
    typedef impact::reboundCoefficient form;

    if (!dict.isDict(entry))
    {
        const token first(dict.lookup(entry));
        if (first.isNumber())
        {
            const scalar value = dict.get<scalar>(entry);
            return checked
            (
                dict, [&] { return form::constant(quantity, value); }
            );
        }
        // The fit is one of e_N
        const word name(dict.get<word>(entry));
        const wordList names
        (
            entry == "normal" ? wordList{"corundumOnSteel"} : wordList()
        );
        if (!names.found(name))
        {
            unknownWord(dict, entry.c_str(), name, names);
        }
        return form::corundumOnSteel();
    }

    const dictionary& coeffs = dict.subDict(entry);
    const word type
    (
        getWordOf(coeffs, "type", "", {"table", "polynomial"})
    );
    if (type == "table")
    {
        std::vector<double> values;
        for (const scalarList& row : readRows(coeffs, "values"))
        {
            values.insert(values.end(), row.begin(), row.end());
        }
        const scalarList angles(coeffs.get<scalarList>("angles"));
        const scalarList speeds
        (
            coeffs.getOrDefault<scalarList>("speeds", scalarList(1, Zero))
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
    return checked
    (
        coeffs,
        [&]
        {
            return form::polynomial
            (
                quantity, coefficients, angles.first(), angles.second(),
                speeds.first(), speeds.second()
            );
        }
    );
}

} // End anonymous namespace


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
    const scalar restitution = dict.get<scalar>("restitution");
    const scalar friction = dict.get<scalar>("friction");
    if (model == "constant")
    {
        return checked
        (
            dict, [&] { return law::constant(restitution, friction); }
        );
    }
    const scalar speed = dict.get<scalar>("restitutionSpeed");
    return checked
    (
        dict,
        [&] { return law::McNamaraFalcon(restitution, speed, friction); }
    );
}


impact::semiEmpiricalRebound Foam::reboundEntries::semiEmpirical
(
    const dictionary& dict
)
{
    typedef impact::semiEmpiricalRebound law;
    return law
    (
        readCoefficient(dict, "normal", law::normalQuantity()),
        readCoefficient(dict, "tangential", law::tangentialQuantity()),
        readCoefficient(dict, "criticalAngle", law::criticalAngleQuantity())
    );
}
