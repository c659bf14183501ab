/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "knudsenCorrection.H"
#include "freeMolecularSphere.H"
#include "maxwellian.H"
#include "outOfRange.H"

#include <algorithm>
#include <cmath>

std::vector<std::string> impact::knudsenCorrection::dragLaws()
{
    std::vector<std::string> names;
    for (const dragLaw::kind& k : dragLaw::kinds())
    {
        if (k.compressible)
        {
            names.push_back(k.name);
        }
    }
    return names;
}


std::vector<std::string> impact::knudsenCorrection::heatLaws()
{
    return {"kavanau", "fox"};
}


impact::knudsenCorrection::knudsenCorrection
(
    const std::vector<cellCollisions::species>& gas,
    double referenceTemperature,
    const std::string& drag,
    const std::string& heat,
    double densityScale
)
:
    species_(gas),
    referenceTemperature_(referenceTemperature),
    densityScale_(densityScale),
    count_(gas.size()),
    mu_(gas.size())
{
    checkRange("Tref", referenceTemperature, "(0, 1e8) K");
    checkRange("densityScale", densityScale, "(0, 1e12]");
    named(dragLaws(), drag, "drag", drag);
    named(heatLaws(), heat, "heat", heat);
    drag_ = dragLaw::New(drag, dragLaw::coefficients());
    heat_ = heatLaw::New(heat, heatLaw::coefficients());
    freeHeat_ = heatLaw::New("freeMolecular", heatLaw::coefficients());
    for (const cellCollisions::species& s : gas)
    {
        reference_.push_back
        (
            15*std::sqrt
            (
                M_PI*s.mass*maxwellian::boltzmann*referenceTemperature
            )
           /(
                2*M_PI*s.diameter*s.diameter
               *(5 - 2*s.omega)*(7 - 2*s.omega)
            )
        );
    }
}


double impact::knudsenCorrection::viscosity(double T)
{
    const int nSpecies = int(species_.size());
    for (int i = 0; i < nSpecies; ++i)
    {
        mu_[i] =
            reference_[i]*std::pow(T/referenceTemperature_, species_[i].omega);
    }
    double sum = 0;
    for (int i = 0; i < nSpecies; ++i)
    {
        double around = 0;
        for (int j = 0; j < nSpecies; ++j)
        {
            const double m = species_[i].mass/species_[j].mass;
            const double root = 1 + std::sqrt(mu_[i]/mu_[j]/std::sqrt(m));
            around += count_[j]/gas_.n*root*root/std::sqrt(8*(1 + m));
        }
        if (count_[i] > 0)
        {
            sum += count_[i]/gas_.n*mu_[i]/around;
        }
    }
    return sum;
}


void impact::knudsenCorrection::gather
(
    const cellCollisions::molecules& gas,
    double density
)
{
    std::fill(count_.begin(), count_.end(), 0.);
    double mass = 0, internal = 0;
    vector3 momentum = {0, 0, 0};
    for (int i = 0; i < gas.n; ++i)
    {
        const cellCollisions::species& s = species_[gas.species[i]];
        count_[gas.species[i]] += 1;
        mass += s.mass;
        internal += s.internalDegreesOfFreedom;
        momentum = momentum + s.mass*gas.velocity(i);
    }
    const vector3 mean = (1/mass)*momentum;
    double square = 0;
    for (int i = 0; i < gas.n; ++i)
    {
        const vector3 c = gas.velocity(i) - mean;
        square += species_[gas.species[i]].mass*dot(c, c);
    }
    const double zeta = internal/gas.n;
    gas_.n = gas.n;
    gas_.density = densityScale_*density*mass;
    gas_.velocity = mean;
    gas_.temperature =
        gas.n > 1 ? square/(3*maxwellian::boltzmann*(gas.n - 1)) : 0;
    gas_.molecule = mass/gas.n;
    gas_.gamma = (5 + zeta)/(3 + zeta);
    gas_.viscosity =
        gas_.temperature > 0 ? viscosity(gas_.temperature) : 0;
    if (gas_.gamma != gamma_)
    {
        gamma_ = gas_.gamma;
        heatLaw::coefficients c;
        c.gamma = gamma_;
        c.Pr = 4*gamma_/(9*gamma_ - 5);
        heat_->set(c);
        freeHeat_->set(c);
    }
}


impact::knudsenCorrection::factors impact::knudsenCorrection::of
(
    const sphereTransfer::sphere& s
)
{
    const bool known = gas_.temperature > 0;
    const double T = known ? gas_.temperature : s.temperature;
    const double mu = known ? gas_.viscosity : viscosity(T);
    const double sound2 = gas_.gamma*maxwellian::boltzmann*T/gas_.molecule;
    const double K = mu/(gas_.density*2*s.radius*std::sqrt(sound2));
    const vector3 slip = gas_.velocity - s.velocity;
    const double M2 = dot(slip, slip)/sound2;

    // By chance, in each direction
    const double scatter = 1/(gas_.gamma*gas_.n);

    // The laws take temperature ratios up to 1000; a sphere that is so hot
    // has its drag from its own temperature alone
    const double ratio = std::min(std::max(s.temperature/T, 1e-3), 1e3);
    const double perMach = std::sqrt(0.5*gas_.gamma);
    const double M = std::sqrt(std::max(M2 - 4*scatter, 0.));
    const double freeCdRe =
        freeMolecularSphere::sCd(M*perMach, ratio)/(K*perMach);
    factors f;
    f.force = drag_->CdReIn(gas_.gamma, M/K, K, ratio)/freeCdRe;

    const double Re = std::sqrt(std::max(M2 - 1.5*scatter, 0.))/K;
    f.cooling = (*heat_)(Re, K).Nu/(*freeHeat_)(Re, K).Nu;

    const double drivingM2 = M2 - 3*scatter;
    const double drivingRe = std::sqrt(std::fabs(drivingM2))/K;
    const double ratioOfTaw =
        (*heat_)(drivingRe, K).TawOverT/(*freeHeat_)(drivingRe, K).TawOverT;
    f.heating = f.cooling*(drivingM2 < 0 ? 1/ratioOfTaw : ratioOfTaw);
    return f;
}
