/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "sphereTransfer.H"
#include "maxwellian.H"
#include "outOfRange.H"
#include "sphereState.H"

#include <algorithm>
#include <cmath>

namespace
{
    //- (1 - exp(-x))/x
    double relaxed(double x)
    {
        return x > 1e-300 ? -std::expm1(-x)/x : 1;
    }

    //- (1 - exp(-z))/z, z = x + i y: of motion that decays by x and turns by
    //  the angle y about the axis meanwhile, applied to a vector
    impact::vector3 relaxed
    (
        double x,
        double y,
        const impact::vector3& axis,
        const impact::vector3& F
    )
    {
        const impact::vector3 along = dot(F, axis)*axis;
        const double square = x*x + y*y;
        if (!(square > 1e-200))
        {
            return F;
        }
        const double half = std::sin(0.5*y);
        const double left = std::exp(-x);
        const double a = 2*half*half - std::expm1(-x)*std::cos(y);
        const double b = left*std::sin(y);
        return
            relaxed(x)*along
          + ((a*x + b*y)/square)*(F - along)
          + ((b*x - a*y)/square)*cross(axis, F);
    }
}


impact::sphereTransfer::sphereTransfer
(
    const std::vector<cellCollisions::species>& gas,
    double accommodation,
    double specificHeat
)
:
    species_(gas),
    accommodation_(accommodation),
    specificHeat_(specificHeat),
    gas_{}
{
    checkRange("accommodation", accommodation, "[0, 1]");
    checkRange("specificHeat", specificHeat, "(0, 1e100) J/(kg K)");
    for (const cellCollisions::species& s : gas)
    {
        rootMass_.push_back(std::sqrt(s.mass));
        reflected_.push_back(2 + 0.5*s.internalDegreesOfFreedom);
    }
}


void impact::sphereTransfer::gather(const cellCollisions::molecules& gas)
{
    const int w = transferKernels::width;
    const std::size_t n = std::size_t((gas.n + w - 1)/w)*w;
    if (buffer_.size() < 7*n)
    {
        buffer_.resize(7*n);
    }
    double* u = buffer_.data();
    double* v = u + n;
    double* z = v + n;
    double* energy = z + n;
    double* mass = energy + n;
    double* rootMass = mass + n;
    double* reflected = rootMass + n;
    std::copy(gas.u, gas.u + gas.n, u);
    std::copy(gas.v, gas.v + gas.n, v);
    std::copy(gas.w, gas.w + gas.n, z);
    for (int i = 0; i < gas.n; ++i)
    {
        const int s = gas.species[i];
        energy[i] = species_[s].internal(gas.internalEnergy[i]);
        mass[i] = species_[s].mass;
        rootMass[i] = rootMass_[s];
        reflected[i] = reflected_[s];
    }
    for (double* array : {u, v, z, energy, mass, rootMass, reflected})
    {
        std::fill(array + gas.n, array + n, 0.);
    }
    gas_ = {int(n), u, v, z, energy, mass, rootMass, reflected};
}


impact::sphereTransfer::rates impact::sphereTransfer::on
(
    const sphere& s,
    double density
) const
{
    const double kT = maxwellian::boltzmann*s.temperature;
    const double p[3] = {s.velocity.x, s.velocity.y, s.velocity.z};
    const transferKernels::sums sums = transferKernels::sum
    (
        gas_, p, accommodation_/3*std::sqrt(2*M_PI*kT)
    );
    const double f = M_PI*s.radius*s.radius*density;
    return
    {
        {f*sums.force[0], f*sums.force[1], f*sums.force[2]},
        f*accommodation_*sums.energy,
        f*sums.drag,
        f*accommodation_*sums.cooling*maxwellian::boltzmann
    };
}


void impact::sphereTransfer::advance
(
    sphere& s,
    const rates& r,
    double deltaT
) const
{
    const double perMass = deltaT/s.mass;
    const double perHeat = perMass/specificHeat_;
    s.velocity = s.velocity + (perMass*relaxed(r.dragRate*perMass))*r.force;

    // Two parts above zero, whatever their rounding
    const double x = r.coolingRate*perHeat;
    s.temperature =
        s.temperature*std::exp(-x) + perHeat*relaxed(x)*r.heating;
}


impact::sphereTransfer::spinRates impact::sphereTransfer::onSpin
(
    const sphere& s,
    double density
) const
{
    const double p[3] = {s.velocity.x, s.velocity.y, s.velocity.z};
    const transferKernels::spinSums sums = transferKernels::sumSpin(gas_, p);
    const double* axes = sums.axes;
    const double f = accommodation_*M_PI*density*std::pow(s.radius, 3);
    spinRates q;
    for (int i = 0; i < 6; ++i)
    {
        const double all = i < 3 ? 3*(axes[0] + axes[1] + axes[2]) : 0;
        q.damping[i] = 0.25*f*s.radius*(all - axes[i]);
    }
    const double lift = 2./3*f;
    q.lift =
    {
        lift*sums.momentum[0], lift*sums.momentum[1], lift*sums.momentum[2]
    };
    q.lag = lift*sums.mass;
    return q;
}


void impact::sphereTransfer::advance
(
    sphere& s,
    const rates& r,
    const spinRates& q,
    double deltaT
) const
{
    const double perMass = deltaT/s.mass;
    const double perInertia = perMass/sphereInertia(s.radius);
    const double decay =
        perInertia*(q.damping[0] + q.damping[1] + q.damping[2])/3;
    const auto rest = [&](const vector3& omega)
    {
        return perInertia*q.damp(omega) - decay*omega;
    };
    const vector3 omega = s.omega;
    const vector3 first = rest(omega);
    s.omega = std::exp(-decay)*(omega - first + 0.5*rest(first));

    const vector3 mean = relaxed(decay)*omega;
    const double speed = mag(mean);
    const vector3 force = r.force + cross(mean, q.lift);
    s.velocity = s.velocity + perMass*relaxed
    (
        r.dragRate*perMass, q.lag*speed*perMass,
        speed > 0 ? (1/speed)*mean : vector3{0, 0, 0}, force
    );

    const double perHeat = perMass/specificHeat_;
    const double lost =
        sphereRotationalEnergy(s.radius, omega)
      - sphereRotationalEnergy(s.radius, s.omega);
    const double x = r.coolingRate*perHeat;
    s.temperature =
        s.temperature*std::exp(-x)
      + relaxed(x)*(perHeat*r.heating + 0.5*lost/specificHeat_);
}


double impact::sphereTransfer::relaxation
(
    const sphere& s,
    const rates& r
) const
{
    return std::max(r.dragRate, r.coolingRate/specificHeat_)/s.mass;
}


void impact::sphereTransfer::step
(
    sphere& s,
    const sphere& at,
    rates r,
    double density,
    double deltaT
) const
{
    const vector3 ahead = at.velocity - s.velocity;
    r.force = r.force + r.dragRate*ahead;
    if (dot(s.omega, s.omega) > 0)
    {
        spinRates q = onSpin(at, density);
        q.lift = q.lift + q.lag*ahead;
        advance(s, r, q, deltaT);
    }
    else
    {
        advance(s, r, deltaT);
    }
}
