/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "solidExchange.H"
#include "maxwellian.H"
#include "outOfRange.H"
#include "sphereState.H"

#include <cmath>

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


std::string impact::solidExchange::whyNoSpin() const
{
    return
        correction_
      ? "knudsenCorrection knows no torque for all Knudsen numbers"
      : law_ != sphereReflection::law::exact
      ? "deflection polynomial knows no point that a molecule hits" : "";
}


void impact::solidExchange::rotate()
{
    const std::string why = whyNoSpin();
    if (!why.empty())
    {
        throwInvalid("rotation yes: ", why, "; rotation no follows no spin");
    }
    rotates_ = true;
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
        mean = mean + gas.velocity(i);
    }
    mean = (1./gas.n)*mean;
    double greatest = 0;
    for (int i = 0; i < gas.n; ++i)
    {
        const vector3 c = gas.velocity(i) - mean;
        const double square = dot(c, c);
        greatest = square > greatest ? square : greatest;
    }
    return {mean, std::sqrt(greatest)};
}


double impact::solidExchange::shareEnergy
(
    const arrival& a,
    double motion,
    sphereTransfer::sphere& s,
    double& internal,
    counterRandom& rnd
) const
{
    // The molecule's energy is a part of all energy of the pair, as its
    // degrees of freedom are of theirs
    const double capacity = a.sphereMass*material_.specificHeat;
    const double all = motion + a.weight*internal + capacity*s.temperature;
    const double out = all*maxwellian::betaVariate
    (
        2 + 0.5*a.zeta, capacity/(a.weight*maxwellian::boltzmann), rnd
    );
    const double turning =
        a.zeta ? maxwellian::betaVariate(0.5*a.zeta, 2, rnd) : 0;
    internal = out*turning/a.weight;
    s.temperature = (all - out)/capacity;
    return out*(1 - turning);
}


impact::vector3 impact::solidExchange::reflected
(
    const arrival& a,
    sphereTransfer::sphere& s,
    double& internal,
    counterRandom& rnd
) const
{
    const vector3 incident = (1/a.c)*a.relative;
    if (a.sphereMass > 0 && rotates_)
    {
        // Motion of the surfaces at the point of impact, towards and past
        // each other
        const vector3 n = sphereReflection::normalHit(incident, rnd);
        const double perInertia = 1/(sphereInertia(s.radius)*a.sphereMass);
        const double tangentialMass =
            1/(1/a.reducedMass + s.radius*s.radius*perInertia);
        const vector3 g = a.relative - s.radius*cross(s.omega, n);
        const double gn = dot(g, n);
        const vector3 gt = g - gn*n;
        const double motion =
            0.5*(a.reducedMass*gn*gn + tangentialMass*dot(gt, gt));
        const double E = shareEnergy(a, motion, s, internal, rnd);
        const vector3 e = sphereReflection::aboutNormal(n, rnd);
        const double en = dot(e, n);
        const vector3 impulse =
            (std::sqrt(2*E*a.reducedMass)*en - a.reducedMass*gn)*n
          + std::sqrt(2*E*tangentialMass)*(e - en*n) - tangentialMass*gt;
        s.omega = s.omega - (s.radius*perInertia)*cross(n, impulse);
        return a.relative + (1/a.reducedMass)*impulse;
    }

    double speed;
    if (a.sphereMass > 0)
    {
        const double motion = 0.5*a.reducedMass*a.c*a.c;
        const double E = shareEnergy(a, motion, s, internal, rnd);
        speed = std::sqrt(2*E/a.reducedMass);
    }
    else
    {
        const double kT = maxwellian::boltzmann*s.temperature;
        speed = std::sqrt
        (
            -2*kT/a.moleculeMass*std::log(rnd.uniform()*rnd.uniform())
        );
        internal = a.zeta ? kT*maxwellian::internalEnergy(a.zeta, rnd) : 0;
    }
    if (dot(s.omega, s.omega) > 0)
    {
        const vector3 n = sphereReflection::normalHit(incident, rnd);
        return
            speed*sphereReflection::aboutNormal(n, rnd)
          + s.radius*cross(s.omega, n);
    }
    return speed*sphereReflection::diffuse(law_, incident, rnd);
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
    const double sphereMass = number*s.mass;
    total.candidates += nCandidates;

    for (std::int64_t k = 0; k < nCandidates; ++k)
    {
        const int i = int((std::uint64_t(rnd.bits())*gas.n) >> 32);
        const vector3 before = gas.velocity(i);
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
        const double reduced = both ? own*sphereMass/(own + sphereMass) : own;
        const arrival a
        {
            relative, c, m, weight, both ? sphereMass : 0, reduced, zeta
        };
        const vector3 leaving =
            rnd.uniform() < material_.accommodation
          ? reflected(a, s, internal, rnd)
          : c*sphereReflection::specular(rnd);

        vector3 after = s.velocity + leaving;
        if (both)
        {
            const vector3 impulse = reduced*(leaving - relative);
            after = before + (1/own)*impulse;
            s.velocity = s.velocity - (1/sphereMass)*impulse;
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


void impact::solidExchange::advance
(
    sphereTransfer::sphere& s,
    const knudsenCorrection::factors& f,
    double density,
    double deltaT
) const
{
    const auto ratesWith = [&]
    (
        const sphereTransfer::sphere& at,
        const knudsenCorrection::factors& g
    )
    {
        sphereTransfer::rates r = transfer_.on(at, density);
        r.force = g.force*r.force;
        r.dragRate *= g.force;
        r.heating *= g.heating;
        r.coolingRate *= g.cooling;
        return r;
    };
    const auto ratesOf = [&](const sphereTransfer::sphere& at)
    {
        return ratesWith(at, correction_ ? correction_->of(at) : f);
    };
    transfer_.follow(s, ratesWith(s, f), density, deltaT, ratesOf);
}


impact::balance impact::solidExchange::gained
(
    const sphereTransfer::sphere& s,
    const sphereTransfer::sphere& before,
    double number
) const
{
    const double mass = number*s.mass;
    const vector3 dv = s.velocity - before.velocity;
    balance b
    {
        mass*dv,
        mass
       *(
            0.5*dot(dv, s.velocity + before.velocity)
          + material_.specificHeat*(s.temperature - before.temperature)
        )
    };
    if (rotates_)
    {
        b.energy += 0.5*mass*sphereInertia(s.radius)
           *dot(s.omega - before.omega, s.omega + before.omega);
    }
    return b;
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
        if (rotates_)
        {
            b.energy += mass*sphereRotationalEnergy
            (
                sizes_[solids.group[j]].radius, solids.omega[j]
            );
        }
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
            const sphereTransfer::sphere before
            {
                {solids.u[j], solids.v[j], solids.w[j]},
                solids.temperature[j], shape.radius, shape.mass,
                rotates_ ? solids.omega[j] : vector3{0, 0, 0}
            };
            sphereTransfer::sphere s = before;
            knudsenCorrection::factors f;
            if (correction_)
            {
                f = correction_->of(s);
                total.minForce = std::fmin(total.minForce, f.force);
                const bool acts = std::fabs(f.force - 1) > 0.1;
                total.corrected += acts;
                total.inFew += acts && gas.n < fewMolecules;
            }
            if (twoWay())
            {
                hits += f.force*solids.number[j]*M_PI*shape.radius*shape.radius
                   *(mag(s.velocity - b.mean) + b.thermal)*deltaT/volume;
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
                advance(s, f, weight/volume, deltaT);
            }
            solids.u[j] = s.velocity.x;
            solids.v[j] = s.velocity.y;
            solids.w[j] = s.velocity.z;
            solids.temperature[j] = s.temperature;
            if (rotates_)
            {
                solids.omega[j] = s.omega;
            }
            g.solids += gained(s, before, solids.number[j]);
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
