/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "plumeSampler.H"
#include "blockLoop.H"
#include "philoxLanes.H"
#include "plumeKernels.H"
#include "outOfRange.H"

#include <algorithm>
#include <cmath>
#include <stdexcept>

impact::plumeSampler::plumeSampler(const setup& s)
:
    setup_(s),
    duration_(std::min(s.burnEnd, s.time) - s.burnStart),
    observed_(s.time - s.burnStart),
    origin_{0, 0, 0},
    hottest_(0)
{
    checkRange("start", s.burnStart, "(-1e12, 1e12) s");
    checkRange(s.burnEnd > s.burnStart && s.burnEnd < 1e12, "end", s.burnEnd,
        "(start, 1e12) s");
    checkRange("time", s.time, "(-1e12, 1e12) s");
    const std::size_t nGroups = s.source->groups().size();
    checkRange
    (
        s.nParticles >= double(nGroups) && s.nParticles <= 1e13,
        "nParticles", double(s.nParticles),
        "[" + std::to_string(nGroups) + ", 1e13], one at least of each of the "
      + std::to_string(nGroups) + " groups of the source"
    );
    checkRange("position", s.position, "(-1e15, 1e15) m");
    checkRange("velocity", s.velocity, "(-3e8, 3e8) m/s");
    checkRange("acceleration", s.acceleration, "(-1e6, 1e6) m/s2");
    checkRange("centre", s.gravityCentre, "(-1e15, 1e15) m");
    if (s.motion == nozzleMotion::orbit && !s.gravity)
    {
        throw std::invalid_argument
            ("motion orbit: needs gravity of type twoBody");
    }
    if (s.motion == nozzleMotion::orbit && mag(s.acceleration) > 0)
    {
        throw std::invalid_argument
            ("motion orbit: has no acceleration, valid is (0 0 0)");
    }
    if (s.gravity)
    {
        const double r = mag(s.position - s.gravityCentre);
        checkRange
        (
            "distance of the nozzle from the centre of gravity", r, "(0, inf) m"
        );
    }
    if (s.temperature == temperatureMethod::euler)
    {
        checkRange(s.deltaT > 0, "deltaT", s.deltaT, "(0, limit] s");
        if (s.cooling->kinked())
        {
            throw std::invalid_argument
                ("temperature euler: needs a constant heatCapacity");
        }
    }

    // All tests that depend on the temperatures of the source
    const plumeSource& source = *s.source;
    auto checkParticle = [&](double T, double d)
    {
        const radiativeCooling::state start = s.cooling->start(T);
        const double y =
            start.y + s.cooling->rate(d)*std::max(0., observed_);
        if (!(y < radiativeCooling::maxY))
        {
            throwOutOfRange
            (
                "time", s.time, "up to ",
                radiativeCooling::maxY/s.cooling->rate(d),
                " s after a particle of diameter ", d, " m at ", T,
                " K has left the nozzle"
            );
        }
        s.cooling->checkEnd(T, d, std::max(0., observed_));
        if (s.temperature == temperatureMethod::euler)
        {
            const double limit = s.cooling->eulerLimit(T, d);
            if (s.deltaT > limit)
            {
                throwOutOfRange
                (
                    "deltaT", s.deltaT, "(0, ", limit,
                    "] (s), stable for a particle of diameter ", d,
                    " (m) at ", T, " (K)"
                );
            }
        }
    };
    for (const plumeSource::beam& b : source.beams())
    {
        checkParticle(b.temperature, b.diameter);
    }
    for (const plumeSource::record& r : source.records())
    {
        checkParticle(r.temperature, r.diameter);
    }
    const double reach =
        (source.topSpeed() + mag(s.velocity))*std::fabs(observed_);
    checkRange("time times speed", reach, "[0, 1e12) m");

    if (s.frame == frameType::nozzle)
    {
        vector3 velocity;
        nozzleAt(observed_, origin_, velocity);
    }
    makeRecords();
    hottest_ = findHottest();
    emptyStatistics();
}


void impact::plumeSampler::makeRecords()
{
    const plumeSource& source = *setup_.source;
    for (const plumeSource::record& r : source.records())
    {
        records_.push_back
        ({
            r.position, r.velocity, thermalOf(r.temperature, r.diameter), 0, 0
        });
    }
    if (source.isAnalytic())
    {
        return;
    }
    for (const plumeSource::group& g : source.groups())
    {
        const std::size_t n = g.last - g.first;
        std::vector<double> share(n);
        std::vector<std::int32_t> small, large;
        for (std::size_t i = 0; i < n; ++i)
        {
            share[i] = source.records()[g.first + i].weight*double(n)/g.flux;
            (share[i] < 1 ? small : large).push_back(std::int32_t(i));
        }
        readyRecord* ready = records_.data() + g.first;
        for (std::size_t i = 0; i < n; ++i)
        {
            ready[i].keep = 1;
            ready[i].alias = std::int32_t(i);
        }
        while (!small.empty() && !large.empty())
        {
            const std::int32_t i = small.back();
            small.pop_back();
            const std::int32_t j = large.back();
            ready[i].keep = share[i];
            ready[i].alias = j;
            share[j] -= 1 - share[i];
            if (share[j] < 1)
            {
                large.pop_back();
                small.push_back(j);
            }
        }
    }
}


double impact::plumeSampler::findHottest() const
{
    // Towards the equilibrium, or up for ever without emission
    const radiativeCooling& cooling = *setup_.cooling;
    const double Te = cooling.equilibrium();
    const double time = std::max(0., observed_);
    double T = 1;
    auto take = [&](double start, double d)
    {
        T = std::max
        ({
            T, start, std::isfinite(Te) ? Te : cooling.after(start, d, time)
        });
    };
    for (const plumeSource::beam& b : setup_.source->beams())
    {
        take(b.temperature, b.diameter);
    }
    for (const plumeSource::record& r : setup_.source->records())
    {
        take(r.temperature, r.diameter);
    }
    return 1.001*T;
}


std::int64_t impact::plumeSampler::particles(int group) const
{
    const std::int64_t G = std::int64_t(setup_.source->groups().size());
    return setup_.nParticles/G + (group < setup_.nParticles % G);
}


std::int64_t impact::plumeSampler::nBlocks() const
{
    return
        duration_ > 0 ? (particles(0) + blockSize - 1)/blockSize : 0;
}


double impact::plumeSampler::emitted(int group) const
{
    return setup_.source->groups()[group].flux*std::max(0., duration_);
}


impact::plumeStatistics impact::plumeSampler::emptyStatistics() const
{
    plumeStatistics::setup s;
    s.grids = setup_.grids;
    s.stations = setup_.stations;
    s.stationHalfWidth = setup_.stationHalfWidth;
    for (std::size_t g = 0; g < setup_.source->groups().size(); ++g)
    {
        s.emitted.push_back(emitted(int(g)));
    }
    s.nParticles = double(setup_.nParticles);
    s.hottest = hottest_;
    return plumeStatistics(s);
}


void impact::plumeSampler::nozzleAt
(
    double time,
    vector3& r,
    vector3& v
) const
{
    r = setup_.position;
    v = setup_.velocity;
    if (setup_.motion == nozzleMotion::orbit)
    {
        r = r - setup_.gravityCentre;
        setup_.gravity->move(r, v, time);
        r = r + setup_.gravityCentre;
        return;
    }

    // Before ignition and after the burn it coasts
    const double burn = setup_.burnEnd - setup_.burnStart;
    const double t = std::min(std::max(time, 0.), burn);
    const vector3& a = setup_.acceleration;
    r = r + t*v + (0.5*t*t)*a;
    v = v + t*a;
    r = r + (time - t)*v;
}


impact::plumeSampler::thermal impact::plumeSampler::thermalOf
(
    double T,
    double diameter
) const
{
    const radiativeCooling& cooling = *setup_.cooling;
    const radiativeCooling::state start = cooling.start(T);
    if (setup_.temperature == temperatureMethod::euler)
    {
        return
        {
            T, cooling.eulerHeat(diameter), cooling.eulerLoss(diameter),
            start.branch
        };
    }
    return {T, start.y, cooling.rate(diameter), start.branch};
}


impact::beamShape impact::plumeSampler::shapeOf
(
    const plumeSource::beam& b
) const
{
    beamShape shape = {};
    const double angle = b.spread*M_PI/180;
    shape.exitRadius = setup_.source->exitRadius();
    shape.speed = b.speed;
    shape.deviation = b.speedDeviation;
    if (b.distribution == plumeSource::angleLaw::gaussian)
    {
        shape.square = angle*angle;
        shape.rest = -std::expm1(-2/shape.square);
    }
    else
    {
        const double s = std::sin(0.5*angle);
        shape.cone = 2*s*s;
    }
    return shape;
}


void impact::plumeSampler::takeRecords
(
    int group,
    int m,
    const plumeDraws& draws,
    plumeLanes& l
) const
{
    const plumeSource& source = *setup_.source;
    const plumeSource::group& g = source.groups()[group];
    const readyRecord* records = records_.data() + g.first;
    const std::int64_t nRecords = std::int64_t(g.last - g.first);
    for (int i = 0; i < m; ++i)
    {
        // One number chooses the place, and in it record or alias
        const double u = l.choice[i]*double(nRecords);
        const std::int64_t place = std::min(std::int64_t(u), nRecords - 1);
        const readyRecord& here = records[place];
        const readyRecord& r =
            u - double(place) < here.keep ? here : records[here.alias];
        for (int d = 0; d < 3; ++d)
        {
            l.x[d][i] = r.x[d];
            l.v[d][i] = r.v[d];
        }
        l.y[i] = r.heat.y;
        l.rate[i] = r.heat.rate;
        l.branch[i] = r.heat.branch;
        l.T[i] = r.heat.T;
    }
    if (source.smoothing() > 0)
    {
        smoothVelocities(m, draws, source.smoothing(), l);
    }
    if (source.axisymmetric())
    {
        turnLanes(m, draws, l);
    }
}


void impact::plumeSampler::cool(int m, plumeLanes& l) const
{
    const radiativeCooling& cooling = *setup_.cooling;
    if (setup_.temperature == temperatureMethod::euler)
    {
        stepLanes(m, setup_.deltaT, l);
        return;
    }
    coolLanes(m, cooling.table(), l);
    for (int i = 0; cooling.kinked() && i < m; ++i)
    {
        l.T[i] = cooling.mended
        (
            {l.y[i] + l.rate[i]*l.age[i], int(l.branch[i])}, l.T[i]
        );
    }
}


void impact::plumeSampler::fly(int m, plumeLanes& l) const
{
    if (setup_.gravity)
    {
        for (int i = 0; i < m; ++i)
        {
            vector3 r, v;
            nozzleAt(observed_ - l.age[i], r, v);
            r = r - setup_.gravityCentre
              + vector3{l.x[0][i], l.x[1][i], l.x[2][i]};
            v = v + vector3{l.v[0][i], l.v[1][i], l.v[2][i]};
            setup_.gravity->move(r, v, l.age[i]);
            r = r + (setup_.gravityCentre - origin_);
            for (int d = 0; d < 3; ++d)
            {
                l.x[d][i] = r[d];
            }
        }
        return;
    }
    const nozzleShape nozzle =
    {
        setup_.position, setup_.velocity, setup_.acceleration, origin_,
        observed_
    };
    flyStraight(m, nozzle, l);
}


void impact::plumeSampler::sampleBlock
(
    int group,
    std::int64_t first,
    int n,
    plumeLanes& l,
    plumeStatistics& result
) const
{
    const emissionTime time = {duration_, observed_};
    const bool beams = setup_.source->isAnalytic();
    beamShape shape = {};
    thermal heat = {};
    if (beams)
    {
        const plumeSource::beam& b = setup_.source->beams()[group];
        shape = shapeOf(b);
        heat = thermalOf(b.temperature, b.diameter);
        std::fill_n(l.y, plumeBatch, heat.y);
        std::fill_n(l.rate, plumeBatch, heat.rate);
        std::fill_n(l.branch, plumeBatch, heat.branch);
    }
    for (int from = 0; from < n; from += plumeBatch)
    {
        const int m = std::min(plumeBatch, n - from);
        const plumeDraws draws =
        {
            setup_.seed, drawPurpose::plume + std::uint32_t(group),
            first + from
        };
        if (beams)
        {
            emitBeam(m, draws, shape, time, l);
            std::fill_n(l.T, m, heat.T);
        }
        else
        {
            emitTimes(m, draws, time, l);
            takeRecords(group, m, draws, l);
        }
        cool(m, l);
        fly(m, l);
        result.add(group, m, l.x[0], l.x[1], l.x[2], l.T);
    }
}


void impact::plumeSampler::sample
(
    std::int64_t from,
    std::int64_t to,
    int proc,
    int nProcs,
    int threads,
    const std::atomic<bool>& stop,
    std::atomic<std::int64_t>& done,
    plumeStatistics& result
) const
{
    const std::int64_t G = std::int64_t(setup_.source->groups().size());
    const std::int64_t n = std::min(to, nBlocks()) - from;
    blockLoop
    (
        0, n*G, proc, nProcs, threads, stop, result,
        [this] { return emptyStatistics(); },
        [&]
        {
            std::shared_ptr<plumeLanes> lanes(new plumeLanes());
            return [&, lanes](std::int64_t block, plumeStatistics& own)
            {
                const int group = int(block/n);
                const std::int64_t first = (from + block % n)*blockSize;
                const std::int64_t m = std::min<std::int64_t>
                    (blockSize, particles(group) - first);
                if (m > 0)
                {
                    sampleBlock(group, first, int(m), *lanes, own);
                    done += m;
                }
            };
        }
    );
}


std::vector<impact::plumeSampler::state> impact::plumeSampler::states
(
    int group,
    std::int64_t first,
    int n
) const
{
    plumeLanes l;
    std::vector<state> result;
    plumeStatistics unused(emptyStatistics());
    for (int from = 0; from < n && duration_ > 0; from += plumeBatch)
    {
        const int m = std::min(plumeBatch, n - from);
        sampleBlock(group, first + from, m, l, unused);
        for (int i = 0; i < m; ++i)
        {
            result.push_back
            ({
                {l.x[0][i], l.x[1][i], l.x[2][i]}, l.T[i], l.age[i]
            });
        }
    }
    return result;
}
