/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "scatteringEntries.H"
#include "checked.H"
#include "coreVector.H"
#include "reboundEntries.H"

namespace
{

using namespace Foam;

const char* const reliefRange = "[1e-12, 1e6] m, an atom to a mountain";
const char* const deviationRange = "[0, 1e6] m, flat to a mountain";
const char* const scaleRange = "[1e-15, 1e6]";


typedef impact::convexBody body;

impact::vector3 sizeOf(const dictionary& dict)
{
    return toCore(getComponents(dict, "size", validRange::diameter));
}


//- A shape: its word, its entries beside it, and how they make it
struct shape
{
    word type;
    wordList entries;
    body (*make)(const dictionary& dict, const fileName& casePath);
};


const std::vector<shape>& shapes()
{
    static const std::vector<shape> rows =
    {
        {
            "sphere", {"diameter"},
            [](const dictionary& dict, const fileName&)
            {
                return body::sphere
                (
                    getNumber(dict, "diameter", validRange::diameter)
                );
            }
        },
        {
            "ellipsoid", {"size"},
            [](const dictionary& dict, const fileName&)
            {
                return body::ellipsoid(sizeOf(dict));
            }
        },
        {
            "box", {"size"},
            [](const dictionary& dict, const fileName&)
            {
                return body::box(sizeOf(dict));
            }
        },
        {
            "truncatedBox", {"size", "cut"},
            [](const dictionary& dict, const fileName&)
            {
                return body::truncatedBox
                (
                    sizeOf(dict),
                    getNumber(dict, "cut", "(0, 0.5)", scalar(0.25))
                );
            }
        },
        {
            "polyhedron", {"file", "scale"},
            [](const dictionary& dict, const fileName& casePath)
            {
                return body::polyhedron
                (
                    getFile(dict, "file", casePath),
                    getNumber(dict, "scale", scaleRange, scalar(1))
                );
            }
        }
    };
    return rows;
}


body readShape(const dictionary& dict, const fileName& casePath)
{
    wordList types;
    for (const shape& s : shapes())
    {
        types.append(s.type);
    }
    const word type(getWordOf(dict, "type", "", types));
    const shape& chosen = shapes()[types.find(type)];
    wordList entries{"type"};
    entries.append(chosen.entries);
    refuseOthers(dict, entries);
    return checked(dict, [&]() { return chosen.make(dict, casePath); });
}


std::shared_ptr<const impact::relief> readWall
(
    const dictionary& dict,
    const fileName& casePath
)
{
    typedef impact::relief relief;
    const word type
    (
        getWordOf
        (
            dict, "type", "",
            {"smooth", "rough", "profile", "sinusoidal", "flat"}
        )
    );
    wordList valid{"type", "treatment"};
    if (type == "rough")
    {
        valid.append(wordList{"meanSpacing", "sigmaSpacing", "sigmaHeight"});
    }
    else if (type == "profile")
    {
        valid.append(wordList{"file", "scale"});
    }
    else if (type == "sinusoidal")
    {
        valid.append(wordList{"amplitude", "wavelength"});
    }
    refuseOthers(dict, valid);
    if (type == "smooth")
    {
        return nullptr;
    }
    return std::make_shared<const relief>
    (
        checked(dict, [&]() -> relief
        {
            if (type == "rough")
            {
                return relief::rough
                (
                    getNumber(dict, "meanSpacing", reliefRange),
                    getNumber(dict, "sigmaSpacing", deviationRange),
                    getNumber(dict, "sigmaHeight", deviationRange)
                );
            }
            if (type == "profile")
            {
                return relief::profile
                (
                    getFile(dict, "file", casePath),
                    getNumber(dict, "scale", scaleRange, scalar(1))
                );
            }
            if (type == "sinusoidal")
            {
                return relief::sinusoidal
                (
                    getNumber(dict, "amplitude", deviationRange),
                    getNumber(dict, "wavelength", reliefRange)
                );
            }
            return relief::flat();
        })
    );
}


impact::reboundLaw readLaw(const dictionary& dict)
{
    typedef impact::reboundLaw law;
    const word type
    (
        getWordOf(dict, "type", "", {"restitution", "friction"})
    );
    refuseOthers
    (
        dict,
        type == "restitution"
      ? wordList{"type", "normal", "tangential"}
      : wordList{"type", "restitution", "friction"}
    );
    typedef reboundEntries entries;
    typedef impact::reboundCoefficient form;
    return type == "restitution"
      ? law
        (
            law::lawType::restitution,
            entries::coefficient(dict, law::normalQuantity(), 0.8),
            entries::coefficient(dict, law::tangentialQuantity(), 0)
        )
      : law
        (
            law::lawType::friction,
            entries::coefficient(dict, form::restitutionQuantity(), 0.8),
            entries::coefficient(dict, form::frictionQuantity(), 0.3)
        );
}

} // End anonymous namespace


void Foam::scatteringEntries::read
(
    const dictionary& dict,
    const fileName& casePath,
    impact::wallEncounter& setup
)
{
    typedef impact::visitTreatment visitTreatment;

    setup.body = readShape(getBlock(dict, "shape"), casePath);
    const dictionary& wallDict = getBlock(dict, "wall");
    setup.wall = readWall(wallDict, casePath);
    setup.sharedRelief = wallDict.get<word>("type") == "profile";
    setup.treatment =
        getWordOf
        (
            wallDict, "treatment", "untilExit", {"untilExit", "firstImpact"}
        ) == "untilExit"
      ? visitTreatment::untilExit : visitTreatment::firstImpact;
    setup.law = readLaw(getBlock(dict, "law"));
    setup.orientation =
        getWordOf
        (
            dict, "orientation", "isotropic", {"isotropic", "uniformEuler"}
        ) == "isotropic"
      ? impact::orientationLaw::isotropic
      : impact::orientationLaw::uniformEuler;
    setup.maxImpacts = getNumber<label>(dict, "maxImpacts", "[1, 1e9]", 200);
}


uint64_t Foam::scatteringEntries::getSeed(const dictionary& dict)
{
    return uint64_t(getWhole(dict, "seed", "[0, 9e15]", 1));
}
