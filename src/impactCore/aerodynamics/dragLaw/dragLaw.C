/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "dragLaw.H"
#include "hendersonDrag.H"
#include "lothDrag.H"
#include "nonSphericalDrag.H"
#include "outOfRange.H"
#include "singhDrag.H"

namespace
{

template<class Law>
std::unique_ptr<impact::dragLaw> make(const impact::dragLaw::coefficients& c)
{
    return std::make_unique<Law>(c);
}


//- The coefficients with all their defaults, all of them valid
impact::dragLaw::coefficients complete
(
    const impact::dragLaw::kind& law,
    impact::dragLaw::coefficients c
)
{
    for (const auto& given : c.numbers)
    {
        impact::named(law.numbers, given.first, given.first, given.second);
    }
    for (const auto& n : law.numbers)
    {
        if (!c.numbers.count(n.name))
        {
            if (!n.as && n.deflt < 0)
            {
                impact::throwOutOfRange(n.name, "missing", n.range);
            }
            c.numbers[n.name] = n.as ? c.numbers.at(n.as) : n.deflt;
        }
        impact::checkRange(n.name, c.numbers[n.name], n.range);
    }
    if (!c.form.empty())
    {
        impact::named(law.forms, c.form, "form", c.form);
    }
    return c;
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

impact::dragLaw::dragLaw(double TpOverT)
:
    TpOverT_(TpOverT)
{
    checkRange("TpOverT", TpOverT, TpOverTRange);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

const std::vector<impact::dragLaw::kind>& impact::dragLaw::kinds()
{
    const number sphericity = {"sphericity", "(0, 1]", -1, nullptr};

    static const std::vector<kind> all
    {
        {"hendersonDrag", true, {}, {}, make<hendersonDrag>},
        {"lothDrag", true, {}, {"published", "continuous"}, make<lothDrag>},
        {
            "singhDrag", true,
            {
                {"omega", "[0.5, 1], hard spheres to Maxwell", 0.74, nullptr},
                {"alphaHoc", "[0, 100]", 0.9071, nullptr}
            },
            {}, make<singhDrag>
        },
        {
            "haiderLevenspielDrag", false, {sphericity}, {},
            make<haiderLevenspielDrag>
        },
        {
            "holzerSommerfeldDrag", false,
            {
                sphericity,
                {"crosswiseSphericity", "(0, 1000]", -1, "sphericity"},
                {"lengthwiseSphericity", "(0, 1000]", -1, "sphericity"}
            },
            {}, make<holzerSommerfeldDrag>
        },
        {
            "ganserDrag", false,
            {sphericity, {"projectedDiameterRatio", "(0, 1000]", 1, nullptr}},
            {}, make<ganserDrag>
        }
    };
    return all;
}


const impact::dragLaw::kind& impact::dragLaw::find(const std::string& name)
{
    return named(kinds(), name, "drag law", name);
}


std::unique_ptr<impact::dragLaw> impact::dragLaw::New
(
    const std::string& name,
    const coefficients& c
)
{
    const kind& law = find(name);
    return law.make(complete(law, c));
}
