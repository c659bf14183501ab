/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "adhesionEntries.H"
#include "checked.H"

#include "FlatOutput.H"
#include "Switch.H"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <fstream>
#include <optional>
#include <sstream>
#include <string>

namespace
{

using namespace Foam;

impact::elasticSolid readSolid(const dictionary& dict)
{
    return {dict.get<scalar>("E"), dict.get<scalar>("nu")};
}


impact::elasticSphere readSphere(const dictionary& dict)
{
    return
    {
        dict.get<scalar>("diameter"),
        dict.get<scalar>("density"),
        readSolid(dict)
    };
}


//- Columns V, e of a file; commas, lines that begin with # and a first line
//  of names are skipped
std::vector<measuredImpact> readMeasured
(
    const dictionary& dict,
    const fileName& casePath
)
{
    const fileName file(getFile(dict, "file", casePath));
    std::ifstream is(file);
    if (!is)
    {
        FatalIOErrorInFunction(dict)
            << "file " << file << " cannot be read" << exit(FatalIOError);
    }
    std::vector<measuredImpact> data;
    bool namesMayFollow = true;
    std::string line;
    for (label number = 1; std::getline(is, line); ++number)
    {
        std::replace(line.begin(), line.end(), ',', ' ');
        std::istringstream columns(line);
        std::string first;
        if (!(columns >> first) || first[0] == '#')
        {
            continue;
        }
        // A line of names begins with one: "V,e", but not "1.2,high"
        const bool names =
            namesMayFollow
         && (std::isalpha(static_cast<unsigned char>(first[0]))
          || first[0] == '"');
        namesMayFollow = false;
        if (names)
        {
            continue;
        }
        measuredImpact m = {0, 0};
        columns.clear();
        columns.seekg(0);
        if
        (
            !(columns >> m.speed >> m.restitution)
         || !(m.speed > 0 && std::isfinite(m.speed))
         || !(m.restitution > 0 && m.restitution < 1)
        )
        {
            FatalIOErrorInFunction(dict)
                << "file " << file << ", line " << number << ", '"
                << line.c_str()
                << "': valid lines: V in (0, inf) m/s and e in (0, 1)"
                << exit(FatalIOError);
        }
        data.push_back(m);
    }
    return data;
}


//- E* and w of two materials, or given as they are
impact::adhesiveRebound::materials readMaterials(const dictionary& dict)
{
    if (dict.isDict("contact"))
    {
        const dictionary& contact = dict.subDict("contact");
        for (const char* entry : {"radius", "mass"})
        {
            if (contact.found(entry))
            {
                FatalIOErrorInFunction(contact)
                    << "Entry " << entry << ": radius and mass are those of"
                    << " the parcel at a wall; valid entries: modulus,"
                    << " workOfAdhesion" << exit(FatalIOError);
            }
        }
        return
        {
            contact.get<scalar>("modulus"),
            contact.get<scalar>("workOfAdhesion")
        };
    }
    const scalar w = dict.get<scalar>("workOfAdhesion");
    const impact::elasticSolid particle(readSolid(dict.subDict("particle")));
    const impact::elasticSolid wall(readSolid(dict.subDict("wall")));
    return checked(dict, [&]()
    {
        // The modulus does not depend on the size
        const impact::jkrContact contact = impact::jkrContact::onWall
        (
            {1e-6, 1000, particle}, wall, w
        );
        return impact::adhesiveRebound::materials{contact.modulus(), w};
    });
}


//- E* of two particles of the material of a patch
scalar particleModulus(const dictionary& dict, const dictionary& layer)
{
    if (layer.found("modulus") || !dict.isDict("particle"))
    {
        return layer.get<scalar>("modulus");
    }
    const impact::elasticSolid solid(readSolid(dict.subDict("particle")));
    return checked(dict, [&]()
    {
        const impact::elasticSphere sphere = {1e-6, 1000, solid};
        return impact::jkrContact::between(sphere, sphere, 0).modulus();
    });
}


//- A constant alpha of the layer, that of the patch if there is none
scalar layerAlpha
(
    const dictionary& layer,
    const word& entry,
    const impact::dissipationLaw& law
)
{
    return
        law.isConstant()
      ? layer.getOrDefault<scalar>(entry, law.coeffs()[0])
      : layer.get<scalar>(entry);
}

} // End anonymous namespace


impact::jkrContact Foam::adhesionEntries::contact(const dictionary& dict)
{
    return checked(dict, [&]()
    {
        const scalar w = dict.get<scalar>("workOfAdhesion");
        if (dict.found("radius"))
        {
            return impact::jkrContact
            (
                dict.get<scalar>("radius"),
                dict.get<scalar>("modulus"),
                dict.get<scalar>("mass"),
                w
            );
        }
        const impact::elasticSphere particle =
            readSphere(dict.subDict("particle"));
        return dict.found("partner")
          ? impact::jkrContact::between
            (
                particle, readSphere(dict.subDict("partner")), w
            )
          : impact::jkrContact::onWall
            (
                particle, readSolid(dict.subDict("wall")), w
            );
    });
}


impact::unloadingType Foam::adhesionEntries::unloading
(
    const dictionary& dict
)
{
    return
        getWordOf(dict, "unloading", "soft", {"soft", "hard"}) == "soft"
      ? impact::unloadingType::soft : impact::unloadingType::hard;
}


impact::dissipationLaw Foam::adhesionEntries::law
(
    const dictionary& dict,
    const fileName& casePath,
    const impact::jkrContact& contact,
    const impact::unloadingType unloading,
    std::vector<measuredImpact>& measured
)
{
    typedef impact::dissipationLaw form;
    if (!dict.isDict("alpha"))
    {
        return checked(dict, [&]()
        {
            return form::constant(dict.get<scalar>("alpha"), unloading);
        });
    }
    const dictionary& alpha = dict.subDict("alpha");
    const word type
    (
        getWordOf
        (
            alpha, "type", "",
            {"constant", "marshall", "polynomial", "calibrated"}
        )
    );
    return checked(alpha, [&]()
    {
        if (type == "constant")
        {
            return form::constant(alpha.get<scalar>("value"), unloading);
        }
        if (type == "marshall")
        {
            if (!alpha.found("restitution"))
            {
                return form::marshall(unloading);
            }
            return form::constant
            (
                form::marshall().alpha(alpha.get<scalar>("restitution")),
                unloading
            );
        }
        if (type == "polynomial")
        {
            const List<scalar> coeffs(alpha.get<List<scalar>>("coeffs"));
            const List<scalar> range
            (
                alpha.getOrDefault<List<scalar>>("range", {0, 1})
            );
            if (range.size() != 2)
            {
                FatalIOErrorInFunction(alpha)
                    << "range " << flatOutput(range)
                    << ": valid (low high), 0 <= low < high <= 1"
                    << exit(FatalIOError);
            }
            const form polynomial = form::polynomial
            (
                std::vector<double>(coeffs.begin(), coeffs.end()),
                range[0],
                range[1],
                unloading
            );
            return alpha.found("restitution")
              ? form::constant
                (
                    polynomial.alpha(alpha.get<scalar>("restitution")),
                    unloading
                )
              : polynomial;
        }
        const scalar v = contact.separationSpeed();
        if (!(v > 0))
        {
            FatalIOErrorInFunction(dict)
                << "workOfAdhesion " << contact.workOfAdhesion()
                << ": valid range with alpha calibrated (0, inf)"
                << exit(FatalIOError);
        }
        measured = readMeasured(alpha, casePath);
        std::vector<form::measurement> data;
        for (const measuredImpact& m : measured)
        {
            data.push_back({m.speed/v, m.restitution});
        }
        return form::fit
        (
            data,
            alpha.getOrDefault<label>("degree", 3),
            alpha.getOrDefault<Switch>("extrapolate", false),
            unloading
        );
    });
}


impact::adhesiveRebound Foam::adhesionEntries::wall
(
    const dictionary& dict,
    const fileName& casePath
)
{
    typedef impact::adhesiveRebound wall;
    const wall::materials materials(readMaterials(dict));

    // Of the particles that alpha was measured with, if it was
    std::optional<impact::jkrContact> measured;
    if
    (
        dict.isDict("alpha")
     && dict.subDict("alpha").getOrDefault<word>("type", word::null)
     == "calibrated"
    )
    {
        const dictionary& alpha = dict.subDict("alpha");
        const impact::elasticSphere sphere =
        {
            alpha.get<scalar>("diameter"), alpha.get<scalar>("density"), {1, 0}
        };
        measured = checked(alpha, [&]()
        {
            return impact::jkrContact
            (
                0.5*sphere.diameter,
                materials.modulus,
                sphere.mass(),
                materials.workOfAdhesion
            );
        });
    }
    const impact::unloadingType end = unloading(dict);
    std::vector<measuredImpact> data;
    const impact::dissipationLaw alpha
    (
        law
        (
            dict,
            casePath,
            measured.value_or(impact::jkrContact(1, 1, 1, 1)),
            end,
            data
        )
    );
    const bool hold =
        getWordOf(dict, "outside", "refuse", {"refuse", "hold"}) == "hold";
    const scalar friction = dict.get<scalar>("friction");
    wall result = checked(dict, [&]()
    {
        return wall
        (
            materials, impact::lawCurve(alpha, end, hold), friction
        );
    });

    if (dict.found("layer"))
    {
        const dictionary& layer = dict.subDict("layer");
        if (end != impact::unloadingType::soft)
        {
            FatalIOErrorInFunction(dict)
                << "unloading hard: valid with a layer: soft"
                << exit(FatalIOError);
        }
        const wall::layerSettings settings =
        {
            {
                particleModulus(dict, layer),
                layer.get<scalar>("workOfAdhesion")
            },
            layerAlpha(layer, "alpha", alpha),
            layerAlpha(layer, "wallAlpha", alpha),
            getWordOf(layer, "coupling", "twoWay", {"twoWay", "oneWay"})
         == "twoWay"
          ? impact::chainCoupling::twoWay : impact::chainCoupling::oneWay
        };
        checked(layer, [&]()
        {
            result.setLayer(settings);
            return true;
        });
    }
    return result;
}
