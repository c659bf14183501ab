/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "knudsenCorrection.H"
#include "freeMolecularSphere.H"
#include "maxwellian.H"
#include "outOfRange.H"

#include <algorithm>
#include <cmath>

namespace
{

void checkName
(
    const char* entry,
    const std::string& name,
    const std::vector<std::string>& valid
)
{
    if (std::find(valid.begin(), valid.end(), name) != valid.end())
    {
        return;
    }
    std::string all;
    for (const std::string& other : valid)
    {
        all += (all.empty() ? "" : " ") + other;
    }
    impact::throwOutOfRange(entry, name, '(' + all + ')');
}

} // End anonymous namespace


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
    heatName_(heat),
    count_(gas.size())
{
    checkRange("Tref", referenceTemperature, "(0, 1e8) K");
    checkRange("densityScale", densityScale, "(0, 1e12]");
    checkName("drag", drag, dragLaws());
    checkName("heat", heat, heatLaws());
    drag_ = dragLaw::New(drag, dragLaw::coefficients());
}


double impact::knudsenCorrection::viscosity(double T, double n) const
{
    const int nSpecies = int(species_.size());
    std::vector<double> mu(nSpecies);
    for (int i = 0; i < nSpecies; ++i)
    {
        const cellCollisions::species& s = species_[i];
        mu[i] =
            15*std::sqrt
            (
                M_PI*s.mass*maxwellian::boltzmann*referenceTemperature_
            )
           /(
                2*M_PI*s.diameter*s.diameter
               *(5 - 2*s.omega)*(7 - 2*s.omega)
            )
           *std::pow(T/referenceTemperature_, s.omega);
    }
    double sum = 0;
    for (int i = 0; i < nSpecies; ++i)
    {
        double around = 0;
        for (int j = 0; j < nSpecies; ++j)
        {
            const double m = species_[i].mass/species_[j].mass;
            const double root = 1 + std::sqrt(mu[i]/mu[j]/std::sqrt(m));
            around += count_[j]/n*root*root/std::sqrt(8*(1 + m));
        }
        if (count_[i] > 0)
        {
            sum += count_[i]/n*mu[i]/around;
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
    gas_ = state();
    if (gas.n < 2)
    {
        return;
    }
    std::fill(count_.begin(), count_.end(), 0.);
    double mass = 0, internal = 0;
    vector3 momentum = {0, 0, 0};
    for (int i = 0; i < gas.n; ++i)
    {
        const cellCollisions::species& s = species_[gas.species[i]];
        count_[gas.species[i]] += 1;
        mass += s.mass;
        internal += s.internalDegreesOfFreedom;
        momentum =
            momentum + s.mass*vector3{gas.u[i], gas.v[i], gas.w[i]};
    }
    const vector3 mean = (1/mass)*momentum;
    double square = 0;
    for (int i = 0; i < gas.n; ++i)
    {
        const vector3 c = vector3{gas.u[i], gas.v[i], gas.w[i]} - mean;
        square += species_[gas.species[i]].mass*dot(c, c);
    }
    const double T = square/(3*maxwellian::boltzmann*(gas.n - 1));
    if (!(T > 0))
    {
        return;
    }
    const double zeta = internal/gas.n;
    gas_.density = densityScale_*density*mass;
    gas_.velocity = mean;
    gas_.temperature = T;
    gas_.molecule = mass/gas.n;
    gas_.gamma = (5 + zeta)/(3 + zeta);
    gas_.viscosity = viscosity(T, gas.n);
    if (gas_.gamma != gamma_)
    {
        gamma_ = gas_.gamma;
        heatLaw::coefficients c;
        c.gamma = gamma_;
        c.Pr = 4*gamma_/(9*gamma_ - 5);
        heat_ = heatLaw::New(heatName_, c);
        freeHeat_ = heatLaw::New("freeMolecular", c);
    }
}


impact::knudsenCorrection::factors impact::knudsenCorrection::of
(
    const sphereTransfer::sphere& s
) const
{
    factors f;
    if (!(gas_.density > 0))
    {
        return f;
    }
    const double d = 2*s.radius;
    const double sound = std::sqrt
    (
        gas_.gamma*maxwellian::boltzmann*gas_.temperature/gas_.molecule
    );
    const double K = gas_.viscosity/(gas_.density*d*sound);
    const double M = mag(gas_.velocity - s.velocity)/sound;
    const double Re = M/K;

    // The laws take temperature ratios up to 1000; a sphere that is so hot
    // has its drag from its own temperature alone
    const double ratio = std::min
    (
        std::max(s.temperature/gas_.temperature, 1e-3), 1e3
    );
    const double perMach = std::sqrt(0.5*gas_.gamma);
    const double freeCdRe =
        freeMolecularSphere::sCd(M*perMach, ratio)/(K*perMach);
    f.force = drag_->CdReIn(gas_.gamma, Re, K, ratio)/freeCdRe;

    const heatLaw::result wanted = (*heat_)(Re, K);
    const heatLaw::result free = (*freeHeat_)(Re, K);
    f.cooling = wanted.Nu/free.Nu;
    f.heating = f.cooling*wanted.TawOverT/free.TawOverT;
    return f;
}
