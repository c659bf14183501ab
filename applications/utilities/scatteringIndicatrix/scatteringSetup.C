/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "scatteringSetup.H"

#include "dictionaryChecks.H"

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
    const word type(dict.get<word>("type"));
    return checked(dict, [&]() -> body
    {
        if (type == "sphere")
        {
            return body::sphere(dict.get<scalar>("diameter"));
        }
        if (type == "ellipsoid")
        {
            return body::ellipsoid(getVector(dict, "size"));
        }
        if (type == "box")
        {
            return body::box(getVector(dict, "size"));
        }
        if (type == "truncatedBox")
        {
            return body::truncatedBox
            (
                getVector(dict, "size"),
                dict.getOrDefault<scalar>("cut", 0.25)
            );
        }
        if (type == "polyhedron")
        {
            return body::polyhedron
            (
                getFile(dict, casePath),
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
                    getFile(dict, casePath),
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


List<scalar> readIncidences(const dictionary& dict)
{
    const List<scalar> angles(getNumbers(dict, "incidence"));
    forAll(angles, i)
    {
        if (!(angles[i] > 0 && angles[i] <= 90))
        {
            FatalIOErrorInFunction(dict)
                << "incidence " << angles[i]
                << ": valid range (0, 90] (degrees)" << exit(FatalIOError);
        }
    }
    return angles;
}

} // End anonymous namespace


Foam::scatteringSetup::scatteringSetup
(
    const dictionary& dict,
    const fileName& casePath
)
:
    incidences(readIncidences(dict))
{
    typedef impact::wallVisit::treatmentType treatmentType;

    sampler.body = readShape(dict.subDict("shape"), casePath);
    const dictionary& wallDict = dict.subDict("wall");
    sampler.wall = readWall(wallDict, casePath);
    sampler.sharedRelief = wallDict.get<word>("type") == "profile";
    const word treatment
    (
        wallDict.getOrDefault<word>("treatment", "untilExit")
    );
    if (treatment != "untilExit" && treatment != "firstImpact")
    {
        unknownWord
        (
            wallDict, "treatment", treatment, {"untilExit", "firstImpact"}
        );
    }
    sampler.treatment =
        treatment == "untilExit"
      ? treatmentType::untilExit : treatmentType::firstImpact;
    sampler.law = readLaw(dict.subDict("law"));
    sampler.incidence = incidences[0];
    sampler.speed = dict.get<scalar>("speed");
    sampler.spin = {0, 0, 0};
    if (dict.found("spin"))
    {
        sampler.spin = getVector(dict, "spin");
    }
    const word orientation
    (
        dict.getOrDefault<word>("orientation", "isotropic")
    );
    if (orientation != "isotropic" && orientation != "uniformEuler")
    {
        unknownWord
        (
            dict, "orientation", orientation, {"isotropic", "uniformEuler"}
        );
    }
    sampler.orientation =
        orientation == "isotropic"
      ? impact::orientationLaw::isotropic
      : impact::orientationLaw::uniformEuler;

    nParticles = getWhole
        (dict, "nParticles", dict.get<scalar>("nParticles"), 1, 1e15);
    sampler.seed = uint64_t(getWhole
        (dict, "seed", dict.getOrDefault<scalar>("seed", 1), 0, 9e15));
    sampler.binWidth = dict.getOrDefault<scalar>("binWidth", 1);
    sampler.maxImpacts = dict.getOrDefault<label>("maxImpacts", 200);

    targetError = getTargetError(dict);
    tableSamples = dict.getOrDefault<label>("tableSamples", 1024);
    if (tableSamples < 1)
    {
        FatalIOErrorInFunction(dict)
            << "tableSamples " << tableSamples << ": valid range >= 1"
            << exit(FatalIOError);
    }

    checked(dict, [&]
    {
        impact::scatteringSampler(sampler).emptyStatistics();
        return true;
    });
}
