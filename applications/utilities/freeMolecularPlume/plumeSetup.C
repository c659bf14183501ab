/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "plumeSetup.H"
#include "checked.H"
#include "coreVector.H"
#include "PtrList.H"
#include "Tuple2.H"

namespace
{

using namespace Foam;

impact::plumeSource readSource
(
    const dictionary& dict,
    const fileName& casePath,
    label& nRecords
)
{
    typedef impact::plumeSource source;
    nRecords = 0;
    const bool fromFile =
        getWordOf(dict, "type", "", {"analytic", "file"}) == "file";
    refuseOthers
    (
        dict,
        fromFile
      ? wordList{"type", "file", "groupEdges", "axisymmetric", "smoothing"}
      : wordList{"type", "exitRadius", "groups"}
    );
    if (fromFile)
    {
        return checked(dict, [&]
        {
            const std::vector<source::record> records
            (
                impact::particleInterface::read(getFile(dict, "file", casePath))
            );
            nRecords = label(records.size());
            const scalarList edges
            (
                getList
                (
                    dict, "groupEdges", validRange::diameter, scalarList()
                )
            );
            return source::interface
            (
                records,
                std::vector<double>(edges.begin(), edges.end()),
                dict.getOrDefault<bool>("axisymmetric", false),
                getNumber(dict, "smoothing", "[0, 1e8)", scalar(0))
            );
        });
    }
    std::vector<source::beam> beams;

    // A List of dictionaries loses memory as it grows
    const PtrList<dictionary> groups(dict.lookup("groups"));
    for (const dictionary& group : groups)
    {
        source::beam b;
        refuseOthers
        (
            group,
            {
                "diameter", "flux", "speed", "speedDeviation", "spread",
                "distribution", "temperature"
            }
        );
        b.diameter = getNumber(group, "diameter", validRange::diameter);
        b.flux = getNumber(group, "flux", "(0, 1e30) 1/s");
        b.speed = getNumber(group, "speed", validRange::speed);
        b.speedDeviation =
            getNumber(group, "speedDeviation", "[0, 3e8) m/s", scalar(0));
        b.spread = getNumber(group, "spread", "[0, 180] deg");
        b.distribution =
            getWord(group, "distribution", {"cone", "gaussian"}) == "cone"
          ? source::angleLaw::cone : source::angleLaw::gaussian;
        b.temperature =
            getNumber(group, "temperature", validRange::temperature);
        beams.push_back(b);
    }
    return checked(dict, [&]
    {
        return source::analytic
        (
            getNumber(dict, "exitRadius", "[0, 1e6) m"), beams
        );
    });
}


impact::radiativeCooling readMaterial(const dictionary& dict)
{
    const dictionary& material = getBlock(dict, "material");
    impact::radiativeCooling::setup s;
    refuseOthers
    (
        material, {"density", "heatCapacity", "absorptivity", "emissivity"}
    );
    s.density = getNumber(material, "density", validRange::density);
    s.heatCapacity.clear();
    const char* const capacityRange = "(0, 1e9) J/(kg K)";
    ITstream& is = material.lookup("heatCapacity");
    if (is.size() && is[0].isNumber())
    {
        s.heatCapacity.push_back
        (
            {0, getNumber(material, "heatCapacity", capacityRange)}
        );
    }
    else
    {
        const auto pairs
        (
            material.get<List<Tuple2<scalar, scalar>>>("heatCapacity")
        );
        for (const Tuple2<scalar, scalar>& p : pairs)
        {
            checkNumber
            (
                material, "heatCapacity", p.first(), "[0, 1e8) K"
            );
            checkNumber(material, "heatCapacity", p.second(), capacityRange);
            s.heatCapacity.push_back({p.first(), p.second()});
        }
    }
    const char* const lightRange = "[0, 1e12) W/m2";
    s.absorptivity = getNumber(material, "absorptivity", validRange::share);
    s.emissivity = getNumber(material, "emissivity", validRange::share);
    s.sunlight = getNumber(dict, "sunlight", lightRange, scalar(1368));
    if (const dictionary* planet = findBlock(dict, "planet"))
    {
        refuseOthers(*planet, {"reflected", "infrared"});
        s.reflected = getNumber(*planet, "reflected", lightRange, scalar(0));
        s.infrared = getNumber(*planet, "infrared", lightRange, scalar(0));
    }
    return checked(material, [&] { return impact::radiativeCooling(s); });
}


impact::plumeGrid::range readRange
(
    const dictionary& dict,
    const word& from,
    const word& to,
    const char* n,
    const char* valid = validRange::coordinate
)
{
    const impact::plumeGrid::range r
    {
        getNumber(dict, from, valid), getNumber(dict, to, valid),
        int(getWhole(dict, n, "[1, 1e6]"))
    };
    if (!(r.to > r.from))
    {
        refuse(dict, to, r.to, "greater than ", from, ", ", r.from);
    }
    return r;
}


impact::plumeGrid readGrid(const dictionary& dict)
{
    typedef impact::plumeGrid grid;
    const char* const radius = "[0, 1e12] m, planets' orbits";
    const word type
    (
        getWord(dict, "type", {"axis", "plane", "meridian", "sphere"})
    );
    refuseOthers
    (
        dict,
        type == "axis" ? wordList{"type", "from", "to", "n", "radius"}
      : type == "sphere"
      ? wordList
        {
            "type", "centre", "from", "to", "n", "nPolar", "nAzimuth"
        }
      : type == "plane"
      ? wordList
        {
            "type", "xFrom", "xTo", "nx", "yFrom", "yTo", "ny", "position",
            "thickness"
        }
      : wordList{"type", "xFrom", "xTo", "nx", "rFrom", "rTo", "nr"}
    );
    return checked(dict, [&]
    {
        if (type == "axis")
        {
            return grid::axis
            (
                readRange(dict, "from", "to", "n"),
                getNumber(dict, "radius", validRange::length)
            );
        }
        if (type == "sphere")
        {
            return grid::sphere
            (
                toCore
                (
                    getComponents
                    (
                        dict, "centre", validRange::coordinate, vector(Zero)
                    )
                ),
                readRange(dict, "from", "to", "n", radius),
                getNumber<label>(dict, "nPolar", "[1, 1e4]", 1),
                getNumber<label>(dict, "nAzimuth", "[1, 1e4]", 1)
            );
        }
        const grid::range x(readRange(dict, "xFrom", "xTo", "nx"));
        if (type == "plane")
        {
            return grid::plane
            (
                x, readRange(dict, "yFrom", "yTo", "ny"),
                getNumber
                (
                    dict, "position", validRange::coordinate, scalar(0)
                ),
                getNumber(dict, "thickness", validRange::length)
            );
        }
        return grid::meridian(x, readRange(dict, "rFrom", "rTo", "nr", radius));
    });
}

} // End anonymous namespace


Foam::plumeSetup::plumeSetup
(
    const dictionary& dict,
    const fileName& casePath
)
:
    times(getNumbers(dict, "times", "(-1e12, 1e12) s")),
    targetError(getTargetError(dict)),
    nRecords(0)
{
    typedef impact::plumeSampler core;

    sampler.temperature =
        getWord(dict, "temperature", {"exact", "euler"}) == "exact"
      ? core::temperatureMethod::exact : core::temperatureMethod::euler;
    wordList valid
    {
        "source", "material", "sunlight", "planet", "times", "burn",
        "nozzle", "gravity", "temperature", "grids", "stations",
        "stationHalfWidth", "nParticles", "seed", "targetError"
    };
    if (sampler.temperature == core::temperatureMethod::euler)
    {
        valid.append("deltaT");
        sampler.deltaT = getNumber(dict, "deltaT", validRange::duration);
    }
    refuseOthers(dict, valid);
    refuseSameNames(dict, "times", times);
    sampler.source = std::make_shared<const impact::plumeSource>
        (readSource(getBlock(dict, "source"), casePath, nRecords));
    sampler.cooling = std::make_shared<const impact::radiativeCooling>
        (readMaterial(dict));

    const dictionary& burn = getBlock(dict, "burn");
    refuseOthers(burn, {"start", "end"});
    sampler.burnStart = getNumber(burn, "start", "(-1e12, 1e12) s");
    sampler.burnEnd = getNumber(burn, "end", "(-1e12, 1e12) s");

    if (const dictionary* found = findBlock(dict, "nozzle"))
    {
        const dictionary& nozzle = *found;
        refuseOthers
        (
            nozzle,
            {"motion", "position", "velocity", "acceleration", "frame"}
        );
        sampler.motion =
            getWord(nozzle, "motion", {"uniform", "orbit"}) == "uniform"
          ? core::nozzleMotion::uniform : core::nozzleMotion::orbit;
        const vector zero(Zero);
        sampler.position =
            toCore
            (
                getComponents(nozzle, "position", validRange::coordinate, zero)
            );
        sampler.velocity =
            toCore
            (
                getComponents(nozzle, "velocity", validRange::velocity, zero)
            );
        sampler.acceleration =
            toCore
            (
                getComponents
                (
                    nozzle, "acceleration", validRange::acceleration, zero
                )
            );
        sampler.frame =
            getWord(nozzle, "frame", {"inertial", "nozzle"}) == "inertial"
          ? core::frameType::inertial : core::frameType::nozzle;
    }

    // 'off', or a dictionary
    if (dict.isDict("gravity"))
    {
        const dictionary& gravity = getBlock(dict, "gravity");
        refuseOthers(gravity, {"type", "mu", "centre"});
        getWord(gravity, "type", {"twoBody"});
        sampler.gravity = checked(gravity, [&]
        {
            return std::make_shared<const impact::keplerOrbit>
                (getNumber(gravity, "mu", "(0, 1e30) m3/s2"));
        });
        sampler.gravityCentre =
            toCore(getComponents(gravity, "centre", validRange::coordinate));
    }
    else
    {
        getWord(dict, "gravity", {"off"});
    }

    const dictionary& grids = getBlock(dict, "grids");
    for (const word& name : grids.toc())
    {
        for (const char* file : {"groups", "summary", "convergence"})
        {
            if (name == file)
            {
                refuse(grids, "grids", name, "another name: it is a result's");
            }
        }
        sampler.grids.push_back(readGrid(getBlock(grids, name)));
        gridNames.append(name);
    }
    const scalarList stations
    (
        getList(dict, "stations", validRange::coordinate, scalarList())
    );
    sampler.stations.assign(stations.begin(), stations.end());
    refuseSameNames(dict, "stations", stations);
    if (stations.empty() && dict.found("stationHalfWidth"))
    {
        refuse
        (
            dict, "stationHalfWidth", dict.get<scalar>("stationHalfWidth"),
            "with entry stations"
        );
    }
    if (gridNames.empty() && targetError > 0)
    {
        refuse(dict, "targetError", targetError, "with a grid in grids");
    }
    sampler.stationHalfWidth =
        getNumber(dict, "stationHalfWidth", validRange::length, scalar(1000));

    sampler.nParticles = getWhole(dict, "nParticles", "[1, 1e13]");
    sampler.seed = uint64_t(getWhole(dict, "seed", "[0, 9e15]", 1));

    for (const scalar time : times)
    {
        checked(dict, [&] { return at(time); });
    }
}


impact::plumeSampler Foam::plumeSetup::at(scalar time) const
{
    impact::plumeSampler::setup s(sampler);
    s.time = time;
    return impact::plumeSampler(s);
}
