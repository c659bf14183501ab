/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "solidExchange.H"
#include "maxwellian.H"
#include "outOfRange.H"

#include <cmath>
#include <sstream>
#include <stdexcept>

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

impact::solidExchange::solidExchange
(
    const std::vector<cellCollisions::species>& gas,
    const material& m,
    const std::vector<double>& diameters,
    mode exchange,
    sphereReflection::law deflection,
    std::uint64_t seed
)
:
    species_(gas),
    material_(m),
    mode_(exchange),
    law_(deflection),
    seed_(seed),
    heaviest_(0),
    transfer_(gas, m.accommodation, m.specificHeat),
    return_(gas)
{
    checkRange("density", m.density, "(0, 1e100) kg/m3");
    for (const double d : diameters)
    {
        checkRange("diameter", d, "(0, 1e3) m");
        sizes_.push_back({0.5*d, m.density*M_PI/6*d*d*d});
    }
    for (const cellCollisions::species& s : gas)
    {
        heaviest_ = std::fmax(heaviest_, s.mass);
    }
}


void impact::solidExchange::correct
(
    double referenceTemperature,
    const std::string& drag,
    const std::string& heat,
    double densityScale
)
{
    if (mode_ == mode::perCollision)
    {
        throwInvalid
        (
            "exchange perCollision gives spheres what single molecules bring:"
            " a correction for the Knudsen number needs perCell or none"
        );
    }
    if (material_.accommodation != 1)
    {
        throwOutOfRange
        (
            "accommodation", material_.accommodation,
            "[1, 1] with a correction for the Knudsen number, whose laws are"
            " those of diffuse reflection"
        );
    }
    correction_ = std::make_unique<knudsenCorrection>
    (
        species_, referenceTemperature, drag, heat, densityScale
    );
}


void impact::solidExchange::setTrials(int trials)
{
    checkRange("trials", trials, "[1, 1000]");
    if (trials > 1 && mode_ != mode::perCell)
    {
        throwOutOfRange
        (
            "trials", trials, "[1, 1] unless exchange is perCell, in which"
            " alone spheres do not feel single collisions"
        );
    }
    trials_ = trials;
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

impact::solidExchange::bound impact::solidExchange::findBound
(
    const cellCollisions::molecules& gas
) const
{
    vector3 mean{0, 0, 0};
    for (int i = 0; i < gas.n; ++i)
    {
        mean = mean + vector3{gas.u[i], gas.v[i], gas.w[i]};
    }
    mean = (1./gas.n)*mean;
    double greatest = 0;
    for (int i = 0; i < gas.n; ++i)
    {
        const vector3 c = vector3{gas.u[i], gas.v[i], gas.w[i]} - mean;
        const double square = dot(c, c);
        greatest = square > greatest ? square : greatest;
    }
    return {mean, std::sqrt(greatest)};
}


void impact::solidExchange::scatter
(
    const cellCollisions::molecules& gas,
    sphereTransfer::sphere& s,
    double number,
    double weight,
    double perVolume,
    bool both,
    bound& b,
    counterRandom& rnd,
    gains& g,
    counts& total
) const
{
    const double cMax = mag(s.velocity - b.mean) + b.thermal;
    const double expected =
        trials_*number*gas.n*M_PI*s.radius*s.radius*cMax*perVolume;
    const std::int64_t nCandidates = std::int64_t(expected + rnd.uniform());
    const double share = number*s.mass;
    total.candidates += nCandidates;

    for (std::int64_t k = 0; k < nCandidates; ++k)
    {
        const int i = int((std::uint64_t(rnd.bits())*gas.n) >> 32);
        const vector3 before{gas.u[i], gas.v[i], gas.w[i]};
        const vector3 relative = before - s.velocity;
        const double c = mag(relative);
        if (!(cMax*rnd.uniform() < c))
        {
            continue;
        }
        total.beyond += c > cMax;

        const cellCollisions::species& kind = species_[gas.species[i]];
        const double m = kind.mass;
        const int zeta = kind.internalDegreesOfFreedom;
        double internal = zeta ? gas.internalEnergy[i] : 0;
        const double internalBefore = internal;
        const double own = weight*m;
        const double reduced = both ? own*share/(own + share) : own;
        vector3 leaving;
        if (rnd.uniform() < material_.accommodation)
        {
            double speed;
            if (both)
            {
                // The molecule's energy is a part of all energy of the pair,
                // as its degrees of freedom are of theirs
                const double capacity = share*material_.specificHeat;
                const double all =
                    0.5*reduced*c*c + weight*internal
                  + capacity*s.temperature;
                const double out = all*maxwellian::betaVariate
                (
                    2 + 0.5*zeta, capacity/(weight*maxwellian::boltzmann), rnd
                );
                const double turning =
                    zeta ? maxwellian::betaVariate(0.5*zeta, 2, rnd) : 0;
                internal = out*turning/weight;
                speed = std::sqrt(2*out*(1 - turning)/reduced);
                s.temperature = (all - out)/capacity;
            }
            else
            {
                const double kT = maxwellian::boltzmann*s.temperature;
                speed = std::sqrt
                (
                    -2*kT/m*std::log(rnd.uniform()*rnd.uniform())
                );
                internal =
                    zeta ? kT*maxwellian::internalEnergy(zeta, rnd) : 0;
            }
            leaving = speed
               *sphereReflection::diffuse(law_, (1/c)*relative, rnd);
        }
        else
        {
            leaving = c*sphereReflection::specular(rnd);
        }

        vector3 after = s.velocity + leaving;
        if (both)
        {
            const vector3 impulse = reduced*(leaving - relative);
            after = before + (1/own)*impulse;
            s.velocity = s.velocity - (1/share)*impulse;
        }

        const balance change
        {
            (weight*m)*(after - before),
            weight
           *(
                0.5*m*(dot(after, after) - dot(before, before))
              + internal - internalBefore
            )
        };
        g.sampled += (1./trials_)*change;
        if (trials_ > 1 && !(trials_*rnd.uniform() < 1))
        {
            continue;
        }

        ++total.collisions;
        gas.u[i] = after.x;
        gas.v[i] = after.y;
        gas.w[i] = after.z;
        if (zeta)
        {
            gas.internalEnergy[i] = internal;
        }
        g.gas += change;
        b.thermal = std::fmax(b.thermal, mag(after - b.mean));
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

double impact::solidExchange::minNumber(int group, double weight) const
{
    return weight/sizes_[group].mass*std::fmax
    (
        heaviest_,
        minCapacity*maxwellian::boltzmann/material_.specificHeat
    );
}


impact::balance impact::solidExchange::of(const spheres& solids) const
{
    balance b;
    for (int j = 0; j < solids.n; ++j)
    {
        const double mass = solids.number[j]*sizes_[solids.group[j]].mass;
        const vector3 v{solids.u[j], solids.v[j], solids.w[j]};
        b.momentum = b.momentum + mass*v;
        b.energy += mass
           *(0.5*dot(v, v) + material_.specificHeat*solids.temperature[j]);
    }
    return b;
}


impact::solidExchange::gains impact::solidExchange::exchange
(
    const cellCollisions::molecules& gas,
    const spheres& solids,
    double weight,
    double volume,
    double deltaT,
    balance& ledger,
    std::uint64_t cell,
    std::uint32_t step,
    counts& total
)
{
    const auto body = [&](int j)
    {
        return
            mode_ == mode::perCollision
         && solids.number[j] >= minNumber(solids.group[j], weight);
    };
    int nBodies = 0;
    for (int j = 0; j < solids.n; ++j)
    {
        nBodies += body(j);
    }
    const int nOthers = solids.n - nBodies;
    if (mode_ == mode::perCollision)
    {
        total.light += nOthers;
    }

    gains g;
    if (solids.n && gas.n)
    {
        if (nOthers)
        {
            transfer_.gather(gas);
            total.pairs += std::int64_t(gas.n)*nOthers;
            if (correction_)
            {
                correction_->gather(gas, weight/volume);
            }
        }
        bound b{};
        if (twoWay())
        {
            b = findBound(gas);
        }
        counterRandom rnd(seed_, cell, step);
        double hits = 0;
        for (int j = 0; j < solids.n; ++j)
        {
            const size& shape = sizes_[solids.group[j]];
            const bool both = body(j);
            const vector3 v0{solids.u[j], solids.v[j], solids.w[j]};
            const double T0 = solids.temperature[j];
            sphereTransfer::sphere s{v0, T0, shape.radius, shape.mass};
            knudsenCorrection::factors f;
            if (correction_)
            {
                f = correction_->of(s);
                total.minForce = std::fmin(total.minForce, f.force);
            }
            if (twoWay())
            {
                hits += f.force*solids.number[j]*M_PI*shape.radius*shape.radius
                   *(mag(v0 - b.mean) + b.thermal)*deltaT/volume;
                if (!(hits < hitLimit))
                {
                    throwOutOfRange
                    (
                        "hits that a molecule expects from solid particles in"
                        " a step",
                        hits, "[0, ", hitLimit, "), fewer particles or a"
                        " shorter step"
                    );
                }
                scatter
                (
                    gas, s, solids.number[j], weight,
                    f.force*(deltaT/volume), both, b,
                    rnd, g, total
                );
            }
            if (!both)
            {
                sphereTransfer::rates r = transfer_.on(s, weight/volume);
                r.force = f.force*r.force;
                r.dragRate *= f.force;
                r.heating *= f.heating;
                r.coolingRate *= f.cooling;
                transfer_.advance(s, r, deltaT);
            }
            solids.u[j] = s.velocity.x;
            solids.v[j] = s.velocity.y;
            solids.w[j] = s.velocity.z;
            solids.temperature[j] = s.temperature;

            const double mass = solids.number[j]*shape.mass;
            const vector3 dv = s.velocity - v0;
            g.solids.momentum = g.solids.momentum + mass*dv;
            g.solids.energy += mass
               *(
                    0.5*dot(dv, s.velocity + v0)
                  + material_.specificHeat*(s.temperature - T0)
                );
        }
        total.maxHits = std::fmax(total.maxHits, hits);
    }

    if (twoWay() && (nOthers || !ledger.isZero()))
    {
        balance owed = ledger - g.solids;
        owed = owed - g.gas;
        ledger = weight*return_.give(gas, (1/weight)*owed);
        total.holding += !ledger.isZero();
    }
    return g;
}
