/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "plumeOutput.H"
#include "csvFile.H"

#include "OSspecific.H"

#include <cmath>
#include <cstdio>
#include <limits>

namespace
{

using namespace Foam;

typedef impact::plumeGrid grid;
typedef impact::plumeStatistics statistics;
typedef statistics::estimate estimate;

//- Names of the coordinates in the tables
const char* coordinates(grid::gridType type)
{
    switch (type)
    {
        case grid::gridType::axis: return "x";
        case grid::gridType::plane: return "x,y";
        case grid::gridType::meridian: return "x,r";
        default: return "r,polar_deg,azimuth_deg";
    }
}


//- Groups of a table: 0 is all of them together, unless there is one only
label firstGroup(const statistics& s)
{
    return s.nGroups() > 1 ? -1 : 0;
}


void writeTable
(
    const fileName& file,
    const grid& g,
    int number,
    const statistics& s
)
{
    csvFile f
    (
        file,
        coordinates(g.type())
      + std::string
        (
            ",group,numberDensity,numberDensityError,temperature,"
            "temperatureError,testParticles"
        ),
        9
    );
    const double degrees = 180/M_PI;
    for (int m = firstGroup(s); m < s.nGroups(); ++m)
    {
        for (int c = 0; c < g.nCells(); ++c)
        {
            const int i = c % g.n(0), j = c/g.n(0) % g.n(1);
            const int k = c/g.n(0)/g.n(1);
            const double a = g.coordinate(0, i + 0.5);
            const double b = g.coordinate(1, j + 0.5);
            f.add(a);
            if (g.type() == grid::gridType::sphere)
            {
                f.add(degrees*b);
                f.add(degrees*g.coordinate(2, k + 0.5));
            }
            else if (g.type() != grid::gridType::axis)
            {
                f.add(b);
            }
            const estimate n = s.numberDensity(number, m, c);
            const estimate T = s.temperature(number, m, c);
            f.add(m + 1);
            f.add(n.value);
            f.add(n.error);
            f.add(T.n > 0, T.value);
            f.add(T.n > 1, T.error);
            f.row(n.n);
        }
    }
}


//- Numbers in the byte order of VTK files. OpenFOAM's own formatters narrow
//  them to floats, too coarse for places in a grid of 100 km and for counts.
template<class Type>
class bigEndian
{
    std::vector<char> bytes_;

public:

    void add(Type x)
    {
        const char* p = reinterpret_cast<const char*>(&x);
        for (std::size_t i = sizeof(Type); i-- > 0;)
        {
            bytes_.push_back(p[i]);
        }
    }

    void write(textFile& f) const
    {
        f.bytes(bytes_.data(), bytes_.size());
        f.print("\n");
    }
};


//- Coordinates of the ends of cells along one axis
void writeAxis(textFile& f, const char* name, const std::vector<double>& x)
{
    f.print("%s_COORDINATES %zu double\n", name, x.size());
    bigEndian<double> data;
    for (const double v : x)
    {
        data.add(v);
    }
    data.write(f);
}


void writeVtk
(
    const fileName& file,
    const grid& g,
    int number,
    const statistics& s,
    scalar time
)
{
    textFile f(file);
    f.print
    (
        "# vtk DataFile Version 3.0\n"
        "particles of a plume, time %.9g s, metres, 1/m3, K\nBINARY\n", time
    );
    const int n[3] = {g.n(0), g.n(1), g.n(2)};
    if (g.type() == grid::gridType::sphere)
    {
        f.print
        (
            "DATASET STRUCTURED_GRID\nDIMENSIONS %d %d %d\n"
            "POINTS %d double\n",
            n[0] + 1, n[1] + 1, n[2] + 1, (n[0] + 1)*(n[1] + 1)*(n[2] + 1)
        );
        bigEndian<double> data;
        for (int k = 0; k <= n[2]; ++k)
        {
            for (int j = 0; j <= n[1]; ++j)
            {
                for (int i = 0; i <= n[0]; ++i)
                {
                    const impact::vector3 p = g.point(i, j, k);
                    data.add(p.x);
                    data.add(p.y);
                    data.add(p.z);
                }
            }
        }
        data.write(f);
    }
    else
    {
        // Axis: along x at y = z = 0; meridian: y is the distance
        const bool line = g.type() == grid::gridType::axis;
        f.print
        (
            "DATASET RECTILINEAR_GRID\nDIMENSIONS %d %d 1\n",
            n[0] + 1, line ? 1 : n[1] + 1
        );
        std::vector<double> x, y;
        for (int i = 0; i <= n[0]; ++i)
        {
            x.push_back(g.coordinate(0, i));
        }
        for (int j = 0; j <= n[1]; ++j)
        {
            y.push_back(g.coordinate(1, j));
        }
        writeAxis(f, "X", x);
        writeAxis(f, "Y", line ? std::vector<double>(1, 0) : y);
        writeAxis(f, "Z", {g.point(0, 0, 0).z});
    }

    const int nFields = 5;
    const char* names[nFields] =
    {
        "numberDensity", "numberDensityError", "temperature",
        "temperatureError", "testParticles"
    };
    const double unknown = std::numeric_limits<double>::quiet_NaN();
    const int first = firstGroup(s);
    f.print
    (
        "CELL_DATA %d\nFIELD plume %d\n",
        g.nCells(), nFields*(s.nGroups() - first)
    );
    for (int m = first; m < s.nGroups(); ++m)
    {
        bigEndian<double> data[nFields];
        for (int c = 0; c < g.nCells(); ++c)
        {
            const estimate density = s.numberDensity(number, m, c);
            const estimate T = s.temperature(number, m, c);
            data[0].add(density.value);
            data[1].add(density.error);
            data[2].add(T.n > 0 ? T.value : unknown);
            data[3].add(T.n > 1 ? T.error : unknown);
            data[4].add(double(density.n));
        }
        for (int i = 0; i < nFields; ++i)
        {
            const word group(m < 0 ? word("all") : "group" + Foam::name(m + 1));
            f.print
            (
                "%s_%s 1 %d double\n", names[i], group.c_str(), g.nCells()
            );
            data[i].write(f);
        }
    }
}


void writeGroups
(
    const fileName& file,
    const statistics& s,
    const impact::plumeSource& source
)
{
    const std::vector<double>& stations = s.settings().stations;
    auto column = [](const char* name, double station)
    {
        char text[80];
        std::snprintf(text, sizeof(text), ",%s_%.9gkm", name, 1e-3*station);
        return std::string(text);
    };
    std::string header("diameter,nearEdge,farEdge");
    for (const double x : stations)
    {
        header += column("spreadRadius", x);
    }
    header += ",meanTemperature,meanTemperatureError,group,emitted,"
        "testParticles";
    for (const double x : stations)
    {
        header += column("spreadRadiusError", x) + column("testParticles", x);
    }
    csvFile f(file, header);
    for (int m = 0; m < s.nGroups(); ++m)
    {
        const bool some = s.sampled(m) > 0;
        f.add(source.groups()[m].diameter);
        f.add(some, s.quantile(m, 0.001));
        f.add(some, s.quantile(m, 0.999));
        std::vector<estimate> radii;
        for (std::size_t i = 0; i < stations.size(); ++i)
        {
            radii.push_back(s.radius(m, int(i), 0.99));
            f.add(radii.back().n > 0, radii.back().value);
        }
        const estimate T = s.temperature(m);
        f.add(T.n > 0, T.value);
        f.add(T.n > 1, T.error);
        f.add(m + 1);
        f.add(s.settings().emitted[m]);
        f.add(s.sampled(m));
        for (const estimate& r : radii)
        {
            f.add(r.n > 1, r.error);
            f.add(r.n);
        }
        f.end();
    }
}

} // End anonymous namespace


void Foam::writePlume
(
    const fileName& folder,
    const plumeSetup& setup,
    const impact::plumeSampler& sampler,
    const impact::plumeStatistics& s,
    const monteCarloRun::result& run
)
{
    mkDir(folder);
    writeConvergence(folder/"convergence.csv", run.convergence);
    const impact::plumeSampler::setup& settings = sampler.settings();
    for (std::size_t i = 0; i < settings.grids.size(); ++i)
    {
        const word& name = setup.gridNames[label(i)];
        const grid& g = settings.grids[i];
        writeTable(folder/(name + ".csv"), g, int(i), s);
        writeVtk(folder/(name + ".vtk"), g, int(i), s, settings.time);
    }
    writeGroups(folder/"groups.csv", s, *settings.source);

    csvFile f(folder/"summary.csv", "quantity,value,unit");
    auto row = [&](const word& name, double value, const char* unit)
    {
        // No row without a value: no equilibrium, or nothing to err
        if (std::isfinite(value))
        {
            f.row(name, value, unit);
        }
    };
    const double N = double(s.sampled());
    double emitted = 0;
    for (const double n : s.settings().emitted)
    {
        emitted += n;
    }
    row("time", settings.time, "s");
    row("testParticles", N, "1");
    row("realParticles", emitted, "1");
    row("interfaceRecords", double(setup.nRecords), "1");
    for (std::size_t i = 0; i < settings.grids.size(); ++i)
    {
        double number = 0, inside = 0;
        for (int m = 0; m < s.nGroups(); ++m)
        {
            const double n = double(s.inside(int(i), m));
            inside += n;
            number += n*s.weight(m);
        }
        const word& name = setup.gridNames[label(i)];
        row("testParticlesInside_" + name, inside, "1");
        row("realParticlesInside_" + name, number, "1");
    }
    row("equilibriumTemperature", settings.cooling->equilibrium(), "K");
    row
    (
        "largestRelativeStdError",
        run.convergence.empty()
      ? std::numeric_limits<double>::infinity()
      : run.convergence.back().error,
        "1"
    );
    row("cpuSeconds", run.cpuSeconds, "s");
    row
    (
        "particlesPerCpuSecond", run.cpuSeconds > 0 ? N/run.cpuSeconds : 0,
        "1/s"
    );
    row("complete", run.complete, "1");
}
