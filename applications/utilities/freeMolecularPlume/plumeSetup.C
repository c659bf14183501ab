/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "plumeSetup.H"
#include "checked.H"
#include "coreVector.H"
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
    const word type(dict.get<word>("type"));
    if (type == "file")
    {
        return checked(dict, [&]
        {
            const std::vector<source::record> records
            (
                impact::particleInterface::read(getFile(dict, "file", casePath))
            );
            nRecords = label(records.size());
            const List<scalar> edges
            (
                dict.getOrDefault<List<scalar>>("groupEdges", List<scalar>())
            );
            return source::interface
            (
                records,
                std::vector<double>(edges.begin(), edges.end()),
                dict.getOrDefault<bool>("axisymmetric", false),
                dict.getOrDefault<scalar>("smoothing", 0)
            );
        });
    }
    if (type != "analytic")
    {
        unknownWord(dict, "source type", type, {"analytic", "file"});
    }

    std::vector<source::beam> beams;
    for (const dictionary& group : dict.get<List<dictionary>>("groups"))
    {
        source::beam b;
        b.diameter = group.get<scalar>("diameter");
        b.flux = group.get<scalar>("flux");
        b.speed = group.get<scalar>("speed");
        b.speedDeviation = group.getOrDefault<scalar>("speedDeviation", 0);
        b.spread = group.get<scalar>("spread");
        b.distribution =
            getWord(group, "distribution", {"cone", "gaussian"}) == "cone"
          ? source::angleLaw::cone : source::angleLaw::gaussian;
        b.temperature = group.get<scalar>("temperature");
        beams.push_back(b);
    }
    return checked(dict, [&]
    {
        return source::analytic(dict.get<scalar>("exitRadius"), beams);
    });
}


impact::radiativeCooling readMaterial(const dictionary& dict)
{
    const dictionary& material = dict.subDict("material");
    impact::radiativeCooling::setup s;
    s.density = material.get<scalar>("density");
    s.heatCapacity.clear();
    ITstream& is = material.lookup("heatCapacity");
    const token first(is);
    is.rewind();
    if (first.isNumber())
    {
        s.heatCapacity.push_back({0, material.get<scalar>("heatCapacity")});
    }
    else
    {
        const auto pairs
        (
            material.get<List<Tuple2<scalar, scalar>>>("heatCapacity")
        );
        for (const Tuple2<scalar, scalar>& p : pairs)
        {
            s.heatCapacity.push_back({p.first(), p.second()});
        }
    }
    s.absorptivity = material.get<scalar>("absorptivity");
    s.emissivity = material.get<scalar>("emissivity");
    s.sunlight = dict.getOrDefault<scalar>("sunlight", 1368);
    if (dict.found("planet"))
    {
        const dictionary& planet = dict.subDict("planet");
        s.reflected = planet.getOrDefault<scalar>("reflected", 0);
        s.infrared = planet.getOrDefault<scalar>("infrared", 0);
    }
    return checked(material, [&] { return impact::radiativeCooling(s); });
}


impact::plumeGrid::range readRange
(
    const dictionary& dict,
    const word& from,
    const word& to,
    const char* n
)
{
    return
    {
        dict.get<scalar>(from),
        dict.get<scalar>(to),
        int(getWhole(dict, n, dict.get<scalar>(n), 1, 1e6))
    };
}


impact::plumeGrid readGrid(const dictionary& dict)
{
    typedef impact::plumeGrid grid;
    const word type
    (
        getWord(dict, "type", {"axis", "plane", "meridian", "sphere"})
    );
    return checked(dict, [&]
    {
        if (type == "axis")
        {
            return grid::axis
            (
                readRange(dict, "from", "to", "n"),
                dict.get<scalar>("radius")
            );
        }
        if (type == "sphere")
        {
            return grid::sphere
            (
                dict.found("centre")
              ? getVector(dict, "centre") : impact::vector3{0, 0, 0},
                readRange(dict, "from", "to", "n"),
                dict.getOrDefault<label>("nPolar", 1),
                dict.getOrDefault<label>("nAzimuth", 1)
            );
        }
        const grid::range x(readRange(dict, "xFrom", "xTo", "nx"));
        if (type == "plane")
        {
            return grid::plane
            (
                x, readRange(dict, "yFrom", "yTo", "ny"),
                dict.getOrDefault<scalar>("position", 0),
                dict.get<scalar>("thickness")
            );
        }
        return grid::meridian(x, readRange(dict, "rFrom", "rTo", "nr"));
    });
}

} // End anonymous namespace


Foam::plumeSetup::plumeSetup
(
    const dictionary& dict,
    const fileName& casePath
)
:
    times(getNumbers(dict, "times")),
    targetError(getTargetError(dict)),
    nRecords(0)
{
    typedef impact::plumeSampler core;

    sampler.source = std::make_shared<const impact::plumeSource>
        (readSource(dict.subDict("source"), casePath, nRecords));
    sampler.cooling = std::make_shared<const impact::radiativeCooling>
        (readMaterial(dict));

    const dictionary& burn = dict.subDict("burn");
    sampler.burnStart = burn.get<scalar>("start");
    sampler.burnEnd = burn.get<scalar>("end");

    if (dict.found("nozzle"))
    {
        const dictionary& nozzle = dict.subDict("nozzle");
        sampler.motion =
            getWord(nozzle, "motion", {"uniform", "orbit"}) == "uniform"
          ? core::nozzleMotion::uniform : core::nozzleMotion::orbit;
        const vector zero(Zero);
        sampler.position =
            toCore(nozzle.getOrDefault<vector>("position", zero));
        sampler.velocity =
            toCore(nozzle.getOrDefault<vector>("velocity", zero));
        sampler.acceleration =
            toCore(nozzle.getOrDefault<vector>("acceleration", zero));
        sampler.frame =
            getWord(nozzle, "frame", {"inertial", "nozzle"}) == "inertial"
          ? core::frameType::inertial : core::frameType::nozzle;
    }

    // 'off', or a dictionary
    if (dict.isDict("gravity"))
    {
        const dictionary& gravity = dict.subDict("gravity");
        getWord(gravity, "type", {"twoBody"});
        sampler.gravity = checked(gravity, [&]
        {
            return std::make_shared<const impact::keplerOrbit>
                (gravity.get<scalar>("mu"));
        });
        sampler.gravityCentre = getVector(gravity, "centre");
    }
    else
    {
        getWord(dict, "gravity", {"off"});
    }

    sampler.temperature =
        getWord(dict, "temperature", {"exact", "euler"}) == "exact"
      ? core::temperatureMethod::exact : core::temperatureMethod::euler;
    if (sampler.temperature == core::temperatureMethod::euler)
    {
        sampler.deltaT = dict.get<scalar>("deltaT");
    }

    const dictionary& grids = dict.subDict("grids");
    for (const word& name : grids.toc())
    {
        sampler.grids.push_back(readGrid(grids.subDict(name)));
        gridNames.append(name);
    }
    const List<scalar> stations
    (
        dict.getOrDefault<List<scalar>>("stations", List<scalar>())
    );
    sampler.stations.assign(stations.begin(), stations.end());
    sampler.stationHalfWidth =
        dict.getOrDefault<scalar>("stationHalfWidth", 1000);

    sampler.nParticles = getWhole
        (dict, "nParticles", dict.get<scalar>("nParticles"), 1, 1e13);
    sampler.seed = uint64_t(getWhole
        (dict, "seed", dict.getOrDefault<scalar>("seed", 1), 0, 9e15));

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
