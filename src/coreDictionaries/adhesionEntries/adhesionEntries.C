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

const char* const alphaRange = "[0, 10]";

//- Entries of a contact, of their own or among others
const wordList contactEntries
{
    "radius", "modulus", "mass", "particle", "wall", "partner",
    "workOfAdhesion"
};


impact::elasticSolid readSolid(const dictionary& dict)
{
    return
    {
        getNumber(dict, "E", validRange::modulus),
        getNumber(dict, "nu", "(-1, 0.5)")
    };
}


impact::elasticSphere readSphere(const dictionary& dict)
{
    refuseOthers(dict, {"diameter", "density", "E", "nu"});
    return
    {
        getNumber(dict, "diameter", validRange::diameter),
        getNumber(dict, "density", validRange::density),
        readSolid(dict)
    };
}


impact::elasticSolid readWallSolid(const dictionary& dict)
{
    const dictionary& wall = getBlock(dict, "wall");
    refuseOthers(wall, {"E", "nu"});
    return readSolid(wall);
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
        refuse(dict, "file", file, "a file that can be read");
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
         || !within(m.speed, validRange::speed)
         || !(m.restitution > 0 && m.restitution < 1)
        )
        {
            FatalIOErrorInFunction(dict)
                << "Entry file " << file << ", line " << number << ", '"
                << line.c_str() << "': valid range V in "
                << validRange::speed << " and e in (0, 1)"
                << exit(FatalIOError);
        }
        data.push_back(m);
    }
    return data;
}


//- E* and w of two materials, or given as they are
impact::adhesiveRebound::materials readMaterials(const dictionary& dict)
{
    if (const dictionary* contact = findBlock(dict, "contact"))
    {
        // Radius and mass are those of the parcel
        refuseOthers(*contact, {"modulus", "workOfAdhesion"});
        return
        {
            getNumber(*contact, "modulus", validRange::modulus),
            getNumber(*contact, "workOfAdhesion", validRange::adhesion)
        };
    }
    if (!dict.found("particle") && !dict.found("workOfAdhesion"))
    {
        FatalIOErrorInFunction(dict)
            << "Entry contact is missing" << nl
            << "Valid: a block contact { modulus; workOfAdhesion; }, or blocks"
            << " particle and wall with workOfAdhesion" << exit(FatalIOError);
    }
    const scalar w = getNumber(dict, "workOfAdhesion", validRange::adhesion);
    const dictionary& ofParticle = getBlock(dict, "particle");
    refuseOthers(ofParticle, {"E", "nu"});
    const impact::elasticSolid particle(readSolid(ofParticle));
    const impact::elasticSolid wall(readWallSolid(dict));
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
        return getNumber(layer, "modulus", validRange::modulus);
    }
    const impact::elasticSolid solid(readSolid(getBlock(dict, "particle")));
    return checked(dict, [&]()
    {
        const impact::elasticSphere sphere = {1e-6, 1000, solid};
        return impact::jkrContact::between(sphere, sphere, 0).modulus();
    });
}


} // End anonymous namespace


impact::chainAlpha Foam::adhesionEntries::chainAlpha
(
    const dictionary& dict,
    const word& entry,
    const impact::dissipationLaw& law
)
{
    if (dict.isDict(entry))
    {
        const dictionary& coeffs = getBlock(dict, entry);
        getWordOf(coeffs, "type", "", {"table"});
        refuseOthers(coeffs, {"type", "speeds", "values"});
        const scalarList speeds
        (
            getList(coeffs, "speeds", "[0, 3e8) m/s, less than light")
        );
        const scalarList values(getList(coeffs, "values", alphaRange));
        return checked
        (
            coeffs,
            [&]
            {
                return impact::chainAlpha
                (
                    std::vector<double>(speeds.begin(), speeds.end()),
                    std::vector<double>(values.begin(), values.end())
                );
            }
        );
    }
    if (!dict.found(entry) && !law.isConstant())
    {
        FatalIOErrorInFunction(dict)
            << "Entry " << entry << " is needed: the alpha that would be its"
            << " default is not constant" << exit(FatalIOError);
    }
    return dict.found(entry)
      ? getNumber(dict, entry, alphaRange) : law.coeffs()[0];
}


impact::jkrContact Foam::adhesionEntries::contact
(
    const dictionary& dict,
    const wordList& others
)
{
    // Of several ways to say it, only one
    wordList valid
    (
        dict.found("radius")
      ? wordList{"radius", "modulus", "mass", "workOfAdhesion"}
      : dict.found("partner")
      ? wordList{"particle", "partner", "workOfAdhesion"}
      : dict.found("particle")
      ? wordList{"particle", "wall", "workOfAdhesion"}
      : contactEntries
    );
    valid.append(others);
    refuseOthers(dict, valid);
    if (!dict.found("radius") && !dict.found("particle"))
    {
        FatalIOErrorInFunction(dict)
            << "Entry radius of a contact is missing" << nl
            << "Valid: radius, modulus and mass of the contact, or blocks"
            << " particle and wall or partner" << exit(FatalIOError);
    }
    return checked(dict, [&]()
    {
        const scalar w =
            getNumber(dict, "workOfAdhesion", validRange::adhesion);
        if (dict.found("radius"))
        {
            return impact::jkrContact
            (
                getNumber(dict, "radius", validRange::diameter),
                getNumber(dict, "modulus", validRange::modulus),
                getNumber(dict, "mass", "[1e-30, 1e12] kg, of a particle"),
                w
            );
        }
        const impact::elasticSphere particle =
            readSphere(getBlock(dict, "particle"));
        return dict.found("partner")
          ? impact::jkrContact::between
            (
                particle, readSphere(getBlock(dict, "partner")), w
            )
          : impact::jkrContact::onWall
            (
                particle, readWallSolid(dict), w
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
    std::vector<measuredImpact>& measured,
    const wordList& ofMeasured
)
{
    typedef impact::dissipationLaw form;
    if (!dict.isDict("alpha"))
    {
        return checked(dict, [&]()
        {
            return form::constant
            (
                getNumber(dict, "alpha", alphaRange), unloading
            );
        });
    }
    const dictionary& alpha = getBlock(dict, "alpha");
    const word type
    (
        getWordOf
        (
            alpha, "type", "",
            {"constant", "marshall", "polynomial", "calibrated"}
        )
    );
    wordList valid
    (
        type == "constant" ? wordList{"type", "value"}
      : type == "marshall" ? wordList{"type", "restitution"}
      : type == "polynomial"
      ? wordList{"type", "coeffs", "range", "restitution"}
      : wordList{"type", "file", "degree", "extrapolate"}
    );
    if (type == "calibrated")
    {
        valid.append(ofMeasured);
    }
    refuseOthers(alpha, valid);
    return checked(alpha, [&]()
    {
        if (type == "constant")
        {
            return form::constant
            (
                getNumber(alpha, "value", alphaRange), unloading
            );
        }
        if (type == "marshall")
        {
            if (!alpha.found("restitution"))
            {
                return form::marshall(unloading);
            }
            return form::constant
            (
                form::marshall().alpha
                (
                    getNumber(alpha, "restitution", validRange::share)
                ),
                unloading
            );
        }
        if (type == "polynomial")
        {
            const scalarList coeffs(getList(alpha, "coeffs", "[-1e6, 1e6]"));
            const scalarList range
            (
                getList(alpha, "range", validRange::share, scalarList{0, 1})
            );
            if (range.size() != 2)
            {
                refuse
                (
                    alpha, "range", flatOutput(range),
                    "(low high), 0 <= low < high <= 1"
                );
            }
            const form polynomial
            (
                std::vector<double>(coeffs.begin(), coeffs.end()),
                range[0],
                range[1],
                unloading
            );
            return alpha.found("restitution")
              ? form::constant
                (
                    polynomial.alpha
                    (
                        getNumber(alpha, "restitution", validRange::share)
                    ),
                    unloading
                )
              : polynomial;
        }
        const scalar v = contact.separationSpeed();
        if (!(v > 0))
        {
            refuse
            (
                dict, "workOfAdhesion", contact.workOfAdhesion(),
                "with alpha calibrated (0, inf)"
            );
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
            getNumber<label>(alpha, "degree", "[0, 20]", 3),
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
    wordList valid
    {
        "type", "alpha", "unloading", "outside", "friction", "layer"
    };
    valid.append
    (
        dict.found("contact")
      ? wordList{"contact"} : wordList{"particle", "wall", "workOfAdhesion"}
    );
    refuseOthers(dict, valid);
    const wall::materials materials(readMaterials(dict));

    // Of the particles that alpha was measured with, if it was
    std::optional<impact::jkrContact> measured;
    if
    (
        dict.isDict("alpha")
     && getBlock(dict, "alpha").getOrDefault<word>("type", word::null)
     == "calibrated"
    )
    {
        const dictionary& alpha = getBlock(dict, "alpha");
        const impact::elasticSphere sphere =
        {
            getNumber(alpha, "diameter", validRange::diameter),
            getNumber(alpha, "density", validRange::density),
            {1, 0}
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
            data,
            {"diameter", "density"}
        )
    );
    const bool hold =
        getWordOf(dict, "outside", "refuse", {"refuse", "hold"}) == "hold";
    const scalar friction = getNumber(dict, "friction", validRange::friction);
    wall result = checked(dict, [&]()
    {
        return wall
        (
            materials, impact::lawCurve(alpha, end, hold), friction
        );
    });

    if (dict.found("layer"))
    {
        const dictionary& layer = getBlock(dict, "layer");
        refuseOthers
        (
            layer,
            {"modulus", "workOfAdhesion", "alpha", "wallAlpha", "coupling"}
        );
        if (end != impact::unloadingType::soft)
        {
            refuse(dict, "unloading", "hard", "with a layer: soft");
        }
        const wall::layerSettings settings =
        {
            {
                particleModulus(dict, layer),
                getNumber(layer, "workOfAdhesion", validRange::adhesion)
            },
            chainAlpha(layer, "alpha", alpha),
            chainAlpha(layer, "wallAlpha", alpha),
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
