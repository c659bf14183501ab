/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "gasEquations.H"
#include "StringStream.H"
#include <numeric>

namespace
{

using namespace Foam;

//- Speed squared [m^2/s^2] of primitive variables p, T, u
double speedSquared(const double* q, const int nVar)
{
    return std::inner_product(q + 2, q + nVar, q + 2, 0.0);
}

//- Whether a condition on p takes the total pressure for that of a gas of
//  constant density
bool ofConstantDensity(const fvPatchScalarField& pp)
{
    if (pp.type() != "totalPressure" && pp.type() != "uniformTotalPressure")
    {
        return false;
    }
    OStringStream os;
    pp.write(os);
    IStringStream is(os.str());
    return dictionary(is).getOrDefault<word>("psi", "none") == "none";
}

} // End anonymous namespace

// * * * * * * * * * * * * * * * State * * * * * * * * * * * * * * * * * * * //

double Foam::gasEquations::outwardSpeed
(
    const label f,
    const double* q,
    double& a
) const
{
    const int nDim = geometry_.nDim();
    const double* n = &geometry_.normal[f*nDim];
    double un = 0;
    for (int d = 0; d < nDim; d++)
    {
        un += q[2 + d]*n[d];
    }
    a = std::sqrt
    (
        eos_.thermallyPerfect()
      ? eos_.soundSpeedSqr<true>(q[1])
      : eos_.soundSpeedSqr<false>(q[1])
    );
    return un;
}


void Foam::gasEquations::drain(const label f, double* q) const
{
    double a;
    const double un = outwardSpeed(f, q, a);
    if (un >= a)
    {
        return;
    }

    // Simple wave that leaves the gas behind it: u + 2 a/(gamma - 1) constant
    const int nDim = geometry_.nDim();
    const double gamma = a*a/(eos_.R*q[1]);
    const double share = max(((gamma - 1)*un/a + 2)/(gamma + 1), 0.1);
    q[0] *= std::pow(share, 2*gamma/(gamma - 1));
    q[1] *= sqr(share);
    for (int d = 0; d < nDim; d++)
    {
        q[2 + d] +=
            (share*a - un)*geometry_.normal[f*nDim + d];
    }
}


void Foam::gasEquations::evaluateAmbience(const label patchi)
{
    fvPatchVectorField& Up = U_.boundaryFieldRef()[patchi];
    fvPatchScalarField& Tp = thermo_.T().boundaryFieldRef()[patchi];
    scalarField& phip = phi_.boundaryFieldRef()[patchi];
    const vectorField& Sf = mesh_.Sf().boundaryField()[patchi];
    const vectorField velocity(Up);

    // Whether gas comes in by what the velocity is now
    const scalarField flux(phip);
    phip = rho_.boundaryField()[patchi]*(velocity & Sf);
    Up == vectorField(Up.size(), Zero);
    Tp.evaluate();
    const scalarField T0(Tp);
    Up == velocity;
    Tp.evaluate();

    // Along the patch a stream may be faster
    vectorField U(velocity);
    const vectorField n(Up.patch().nf());
    forAll(U, i)
    {
        const scalar aa =
            eos_.thermallyPerfect()
          ? eos_.soundSpeedSqr<true>(T0[i])
          : eos_.soundSpeedSqr<false>(T0[i]);
        const scalar gamma = aa/(eos_.R*T0[i]);
        const scalar limit = T0[i] == Tp[i] ? aa : 2*aa/(gamma + 1);
        const scalar un = U[i] & n[i];
        if (un < 0 && sqr(un) > limit)
        {
            U[i] -= (un + std::sqrt(limit))*n[i];
        }
    }
    Up == U;
    Tp.evaluate();
    thermo_.p().boundaryFieldRef()[patchi].evaluate();
    phip = flux;
}


bool Foam::gasEquations::sweptOut(const label f, const double p) const
{
    const double* q = &primitive[geometry_.owner[f]*nVar_];
    double a;
    const double M = outwardSpeed(f, q, a)/a;
    const double gamma = a*a/(eos_.R*q[1]);
    return M > 1 && p < q[0]*(1 + 2*gamma/(gamma + 1)*(M*M - 1));
}


void Foam::gasEquations::leave
(
    const label f,
    double* q,
    const bool fed
) const
{
    const double* inside = &primitive[geometry_.owner[f]*nVar_];
    double a;
    if (outwardSpeed(f, q, a) <= 0)
    {
        return;
    }
    q[1] = inside[1];
    if (sweptOut(f, q[0]))
    {
        q[0] = inside[0];
        return;
    }

    // Below the pressure at which it leaves with the speed of sound it feels
    // no more of it
    double choked[8];
    std::copy(inside, inside + nVar_, choked);
    drain(f, choked);
    if (q[0] < choked[0])
    {
        std::copy(choked, choked + nVar_, q);
        return;
    }

    if (!fed)
    {
        return;
    }
    if (rough_)
    {
        // On the way waves are to leave
        q[0] = inside[0] + 0.3*(q[0] - inside[0]);
    }

    // A higher pressure outside sends in a shock, behind which the gas is
    // slower and hotter: it would else leave with the density of that pressure,
    // and the cell run empty. The difference that smooth flow has from a cell
    // to its face is none
    const double un = max(outwardSpeed(f, inside, a), 0.0);
    const int nDim = geometry_.nDim();
    const double gamma = a*a/(eos_.R*q[1]);
    const double rise = max(q[0]/inside[0] - 1, 0.0);
    const double shock = rise*rise/(rise + 0.2);
    const double r = 1 + shock;
    const double slower = min
    (
        un,
        a*shock/(gamma*std::sqrt(1 + 0.5*(gamma + 1)/gamma*shock))
    );
    q[1] *= r*((gamma - 1)*r + gamma + 1)/((gamma + 1)*r + gamma - 1);
    for (int d = 0; d < nDim; d++)
    {
        q[2 + d] -= slower*geometry_.normal[f*nDim + d];
    }
}


bool Foam::gasEquations::subsonicOutlet() const
{
    scalar area = 0;
    scalar subsonic = 0;
    label k = -1;
    for (const gasMesh::patchRange& patch : geometry_.patches())
    {
        k++;
        for (label i = 0; i < patch.size && outlet_[k]; i++)
        {
            const label f = patch.start + i;
            double a;
            area += geometry_.area[f];
            const double un =
                outwardSpeed(f, &primitive[geometry_.owner[f]*nVar_], a);
            if (un < a)
            {
                subsonic += geometry_.area[f];
            }
        }
    }
    reduce(area, sumOp<scalar>());
    reduce(subsonic, sumOp<scalar>());
    return subsonic > 0.5*area;
}


void Foam::gasEquations::reportShockedInlets(const bool steady) const
{
    // Of pressures, through a normal shock at Mach number 1.2
    const scalar jump = 1.5;

    // In a steady gas one that begins at the corner of a wall and an inlet may
    // be meant
    const scalar least = steady ? 0.05 : 0.01;

    for (const gasMesh::patchRange& patch : geometry_.patches())
    {
        if (patch.coupled || patch.image())
        {
            continue;
        }
        scalar all = 0;
        scalar shocked = 0;
        for (label f = patch.start; f < patch.start + patch.size; f++)
        {
            double a;
            const double* outside = &primitive[geometry_.far[f]*nVar_];
            const double* inside = &primitive[geometry_.owner[f]*nVar_];
            const double un = outwardSpeed(f, outside, a);
            const double uu = speedSquared(outside, nVar_);
            all += geometry_.area[f];
            if (un < 0 && uu > a*a && inside[0] > jump*outside[0])
            {
                shocked += geometry_.area[f];
            }
        }
        reduce(all, sumOp<scalar>());
        reduce(shocked, sumOp<scalar>());
        if (shocked > least*all)
        {
            WarningInFunction
                << "A shock stands at " << 100*shocked/all << " % of patch "
                << mesh_.boundary()[patch.patchi].name()
                << ", through which gas comes in faster than sound. The patch"
                << " must lie farther out, before the shock"
                << (
                       shocked > 0.9*all
                     ? ", unless the gas that was inside at the start throws"
                       " the stream back: start from the stream then"
                     : ""
                   )
                << endl;
        }
    }
}


void Foam::gasEquations::reportOpenPatches(const bool steady) const
{
    reportShockedInlets(steady);
    for (const gasMesh::patchRange& patch : geometry_.patches())
    {
        if (patch.coupled || patch.image())
        {
            continue;
        }
        scalar all = 0;
        scalar returning = 0;
        scalar choked = 0;
        scalar driven = 0;
        scalar unfelt = 0;
        scalar slow = 0;
        scalar compressed = 0;
        const fvPatchScalarField& pp =
            thermo_.p().boundaryField()[patch.patchi];
        const bool ofStatic =
            fed_[patch.patchi]
         && (pp.type() == "fixedValue" || pp.type() == "uniformFixedValue");
        const bool constantDensity = ofConstantDensity(pp);
        for (label f = patch.start; f < patch.start + patch.size; f++)
        {
            double a;
            const double* outside = &primitive[geometry_.far[f]*nVar_];
            const double* inside = &primitive[geometry_.owner[f]*nVar_];
            const double un = outwardSpeed(f, outside, a);
            const double uu = speedSquared(outside, nVar_);
            all += geometry_.area[f];
            choked +=
                fed_[patch.patchi] && un < -0.999*a ? geometry_.area[f] : 0;

            // Of gas that has come from rest, more than the pressure given
            const scalar gamma = a*a/(eos_.R*outside[1]);
            driven +=
                ofStatic && un < 0 && 0.5*gamma*sqr(un/a) > 0.05
              ? geometry_.area[f]
              : 0;
            if (constantDensity && un < 0)
            {
                const scalar MM = uu/(a*a);
                compressed = max
                (
                    compressed,
                    std::pow(1 + 0.5*(gamma - 1)*MM, gamma/(gamma - 1))
                   /(1 + 0.5*gamma*MM) - 1
                );
            }
            const scalar p = pp[f - patch.start];
            unfelt +=
                pressed_[patch.patchi] && sweptOut(f, p)
             && mag(p/inside[0] - 1) > 0.05
              ? geometry_.area[f]
              : 0;
            slow += outwardSpeed(f, inside, a) < a ? geometry_.area[f] : 0;

            // (along a patch gas may come by round-off)
            returning += un < -1e-3*a ? geometry_.area[f] : 0;
        }
        reduce(all, sumOp<scalar>());
        reduce(returning, sumOp<scalar>());
        reduce(choked, sumOp<scalar>());
        reduce(driven, sumOp<scalar>());
        reduce(unfelt, sumOp<scalar>());
        reduce(slow, sumOp<scalar>());
        reduce(compressed, maxOp<scalar>());
        if (choked > 0.01*all)
        {
            WarningInFunction
                << "Gas comes in at the speed of sound through "
                << 100*choked/all << " % of patch "
                << mesh_.boundary()[patch.patchi].name()
                << ", whose condition on p can give no more" << endl;
        }
        if (driven > 0.01*all)
        {
            WarningInFunction
                << "Gas comes in through " << 100*driven/all << " % of patch "
                << mesh_.boundary()[patch.patchi].name()
                << " with the pressure that is given and a velocity that makes"
                << " its total pressure 5 % more or beyond. If it comes from"
                << " rest set totalPressure on p and totalTemperature on T"
                << endl;
        }
        if (compressed > 1e-3)
        {
            WarningInFunction
                << "Gas comes in through patch "
                << mesh_.boundary()[patch.patchi].name()
                << " with a total pressure up to " << 100*compressed
                << " % above p0: without psi the condition on p is that of a"
                << " gas of constant density. Set psi thermo:psi and gamma"
                << " there" << endl;
        }
        if (unfelt > 0.01*all)
        {
            WarningInFunction
                << "Gas leaves faster than sound through " << 100*unfelt/all
                << " % of patch " << mesh_.boundary()[patch.patchi].name()
                << ", where it does not feel the condition on p: "
                << (slow > 0.01*all ? "" : "set zeroGradient, or ")
                << "put the patch farther out" << endl;
        }
        const bool outlet =
            U_.boundaryField()[patch.patchi].type() == "zeroGradient";
        if (!steady && outlet && returning > 0.01*all)
        {
            WarningInFunction
                << "Gas comes back through " << 100*returning/all
                << " % of patch " << mesh_.boundary()[patch.patchi].name()
                << ", whose condition on U is zeroGradient: it says nothing of"
                << " what comes. Set pressureInletOutletVelocity on U,"
                << " inletOutlet on T and, if gas is at rest outside,"
                << " totalPressure on p" << endl;
        }
    }
}
