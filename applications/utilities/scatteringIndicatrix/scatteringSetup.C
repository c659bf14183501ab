/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "scatteringSetup.H"
#include "utilityTools.H"

#include "vector.H"
#include "ListOps.H"
#include "FlatOutput.H"

namespace
{

using namespace Foam;

[[noreturn]] void unknownWord
(
    const dictionary& dict,
    const char* entry,
    const word& value,
    const wordList& valid
)
{
    FatalIOErrorInFunction(dict)
        << "Unknown " << entry << ' ' << value << nl
        << "Valid words: " << flatOutput(valid) << exit(FatalIOError);
    std::abort();
}


impact::vector3 getVector(const dictionary& dict, const word& name)
{
    const vector v(dict.get<vector>(name));
    return {v.x(), v.y(), v.z()};
}


fileName getFile
(
    const dictionary& dict,
    const fileName& casePath
)
{
    fileName file(dict.get<fileName>("file"));
    file.expand();
    return file.isAbsolute() ? file : casePath/file;
}


impact::convexBody readShape
(
    const dictionary& dict,
    const fileName& casePath
)
{
    typedef impact::convexBody body;
    const word type(dict.get<word>("type"));
    return checked<body>(dict, [&]() -> body
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
        checked<relief>(dict, [&]() -> relief
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
    return checked<law>(dict, [&]() -> law
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
    ITstream& is = dict.lookup("incidence");
    const token first(is);
    is.rewind();
    List<scalar> angles;
    if (first.isNumber())
    {
        angles.append(dict.get<scalar>("incidence"));
    }
    else
    {
        angles = dict.get<List<scalar>>("incidence");
    }
    if (angles.empty())
    {
        FatalIOErrorInFunction(dict)
            << "incidence: the list is empty" << exit(FatalIOError);
    }
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

    // Read as a real number: more than an integer of 32 bits may be asked for
    const scalar number = dict.get<scalar>("nParticles");
    if (!(number >= 1 && number <= 1e15) || number != std::floor(number))
    {
        FatalIOErrorInFunction(dict)
            << "nParticles " << number
            << ": valid range: whole numbers from 1 to 1e15"
            << exit(FatalIOError);
    }
    nParticles = int64_t(number);

    const scalar seed = dict.getOrDefault<scalar>("seed", 1);
    if (!(seed >= 0 && seed <= 9e15) || seed != std::floor(seed))
    {
        FatalIOErrorInFunction(dict)
            << "seed " << seed
            << ": valid range: whole numbers from 0 to 9e15"
            << exit(FatalIOError);
    }
    sampler.seed = uint64_t(seed);
    sampler.binWidth = dict.getOrDefault<scalar>("binWidth", 1);
    sampler.maxImpacts = dict.getOrDefault<label>("maxImpacts", 200);

    targetError = dict.getOrDefault<scalar>("targetError", 0);
    if (dict.found("targetError") && !(targetError > 0 && targetError < 1))
    {
        FatalIOErrorInFunction(dict)
            << "targetError " << targetError << ": valid range (0, 1)"
            << exit(FatalIOError);
    }
    tableSamples = dict.getOrDefault<label>("tableSamples", 1024);
    if (tableSamples < 1)
    {
        FatalIOErrorInFunction(dict)
            << "tableSamples " << tableSamples << ": valid range >= 1"
            << exit(FatalIOError);
    }

    checked<bool>(dict, [&]
    {
        impact::scatteringSampler(sampler).emptyStatistics();
        return true;
    });
}
