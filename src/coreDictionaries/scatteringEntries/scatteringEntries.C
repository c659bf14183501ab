/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "scatteringEntries.H"
#include "checked.H"
#include "coreVector.H"

namespace
{

using namespace Foam;

impact::convexBody readShape
(
    const dictionary& dict,
    const fileName& casePath
)
{
    typedef impact::convexBody body;
    refuseOthers(dict, {"type", "diameter", "size", "cut", "file", "scale"});
    const word type(dict.get<word>("type"));
    return checked(dict, [&]() -> body
    {
        if (type == "sphere")
        {
            return body::sphere(dict.get<scalar>("diameter"));
        }
        if (type == "ellipsoid")
        {
            return body::ellipsoid(toCore(dict.get<vector>("size")));
        }
        if (type == "box")
        {
            return body::box(toCore(dict.get<vector>("size")));
        }
        if (type == "truncatedBox")
        {
            return body::truncatedBox
            (
                toCore(dict.get<vector>("size")),
                dict.getOrDefault<scalar>("cut", 0.25)
            );
        }
        if (type == "polyhedron")
        {
            return body::polyhedron
            (
                getFile(dict, "file", casePath),
                dict.getOrDefault<scalar>("scale", 1)
            );
        }
        unknownWord
        (
            dict, "shape type", type,
            {"sphere", "ellipsoid", "box", "truncatedBox", "polyhedron"}
        );
    });
}


std::shared_ptr<const impact::relief> readWall
(
    const dictionary& dict,
    const fileName& casePath
)
{
    typedef impact::relief relief;
    refuseOthers
    (
        dict,
        {
            "type", "treatment", "meanSpacing", "sigmaSpacing", "sigmaHeight",
            "file", "scale", "amplitude", "wavelength"
        }
    );
    const word type(dict.get<word>("type"));
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
                    dict.get<scalar>("meanSpacing"),
                    dict.get<scalar>("sigmaSpacing"),
                    dict.get<scalar>("sigmaHeight")
                );
            }
            if (type == "profile")
            {
                return relief::profile
                (
                    getFile(dict, "file", casePath),
                    dict.getOrDefault<scalar>("scale", 1)
                );
            }
            if (type == "sinusoidal")
            {
                return relief::sinusoidal
                (
                    dict.get<scalar>("amplitude"),
                    dict.get<scalar>("wavelength")
                );
            }
            if (type == "flat")
            {
                return relief::flat();
            }
            unknownWord
            (
                dict, "wall type", type,
                {"smooth", "rough", "profile", "sinusoidal", "flat"}
            );
        })
    );
}


impact::reboundLaw readLaw(const dictionary& dict)
{
    typedef impact::reboundLaw law;
    refuseOthers
    (
        dict, {"type", "normal", "tangential", "restitution", "friction"}
    );
    const word type(dict.get<word>("type"));
    return checked(dict, [&]() -> law
    {
        if (type == "restitution")
        {
            return law::restitution
            (
                dict.getOrDefault<scalar>("normal", 0.8),
                dict.getOrDefault<scalar>("tangential", 0)
            );
        }
        if (type == "friction")
        {
            return law::coulomb
            (
                dict.getOrDefault<scalar>("restitution", 0.8),
                dict.getOrDefault<scalar>("friction", 0.3)
            );
        }
        unknownWord
        (
            dict, "law type", type, {"restitution", "friction"}
        );
    });
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

    setup.body = readShape(dict.subDict("shape"), casePath);
    const dictionary& wallDict = dict.subDict("wall");
    setup.wall = readWall(wallDict, casePath);
    setup.sharedRelief = wallDict.get<word>("type") == "profile";
    setup.treatment =
        getWordOf
        (
            wallDict, "treatment", "untilExit", {"untilExit", "firstImpact"}
        ) == "untilExit"
      ? visitTreatment::untilExit : visitTreatment::firstImpact;
    setup.law = readLaw(dict.subDict("law"));
    setup.orientation =
        getWordOf
        (
            dict, "orientation", "isotropic", {"isotropic", "uniformEuler"}
        ) == "isotropic"
      ? impact::orientationLaw::isotropic
      : impact::orientationLaw::uniformEuler;
    setup.maxImpacts = dict.getOrDefault<label>("maxImpacts", 200);
}


uint64_t Foam::scatteringEntries::getSeed(const dictionary& dict)
{
    return uint64_t
    (
        getWhole(dict, "seed", dict.getOrDefault<scalar>("seed", 1), 0, 9e15)
    );
}
