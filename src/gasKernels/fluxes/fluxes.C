/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "vectorKernel.H"
#include "fluxes.H"
#include <cmath>
#include <map>

namespace Foam
{
namespace
{


//- One side of a face
template<int nDim>
struct side
{
    double p;       //- Pressure [Pa]
    double rho;     //- Density [kg/m^3]
    double H;       //- Total enthalpy [J/kg]
    double a;       //- Speed of sound [m/s]
    double u[nDim]; //- Velocity [m/s]
    double uu;      //- Square of the speed [m^2/s^2]
    double un;      //- Normal velocity [m/s]
};


template<int nDim, bool Thermally>
VECTOR_INLINE side<nDim> sideOf
(
    const double (&q)[faceBlock::maxVar][faceBlock::size],
    const double (&normal)[3][faceBlock::size],
    const int i,
    const gasEquationOfState& gas
)
{
    side<nDim> s;
    s.p = q[0][i];
    const double T = q[1][i];
    s.rho = s.p/(gas.R*T);
    s.uu = 0;
    s.un = 0;
    for (int d = 0; d < nDim; d++)
    {
        s.u[d] = q[2 + d][i];
        s.uu += s.u[d]*s.u[d];
        s.un += s.u[d]*normal[d][i];
    }
    s.H = gas.enthalpy<Thermally>(T) + 0.5*s.uu;
    s.a = std::sqrt(gas.soundSpeedSqr<Thermally>(T));
    return s;
}


//- Speeds of the outermost waves between two states after Einfeldt: of the
//  state's own gas or of the Roe average, whichever is faster
template<int nDim>
VECTOR_INLINE void waveSpeeds
(
    const side<nDim>& L,
    const side<nDim>& R,
    double& sL,
    double& sR
)
{
    const double rootL = std::sqrt(L.rho);
    const double rootR = std::sqrt(R.rho);
    const double sum = 1/(rootL + rootR);
    const double un = (rootL*L.un + rootR*R.un)*sum;
    const double d = R.un - L.un;
    const double a = std::sqrt
    (
        (rootL*L.a*L.a + rootR*R.a*R.a)*sum
      + 0.5*rootL*rootR*sum*sum*d*d
    );
    sL = min(L.un - L.a, un - a);
    sR = max(R.un + R.a, un + a);
}


//- Flux = mass flux times the upwind state + pressure along the normal, the
//  form common to the AUSM family
template<int nDim>
VECTOR_INLINE void convect
(
    faceBlock& block,
    const int i,
    const side<nDim>& L,
    const side<nDim>& R,
    const double mass,
    const double p
)
{
    const double right = 0.5*(mass + abs(mass));
    const double left = 0.5*(mass - abs(mass));
    block.flux[0][i] = mass;
    block.flux[1][i] = right*L.H + left*R.H;
    for (int d = 0; d < nDim; d++)
    {
        block.flux[2 + d][i] =
            right*L.u[d] + left*R.u[d] + p*block.normal[d][i];
    }
}


//- Flux of the two-wave Riemann solution with the wave speeds sL <= 0 <= sR.
//  With Enthalpy the dissipation of energy acts on rho H instead of rho E.
template<bool Enthalpy, int nDim>
VECTOR_INLINE void twoWaves
(
    faceBlock& block,
    const int i,
    const side<nDim>& L,
    const side<nDim>& R,
    const double sL,
    const double sR
)
{
    const double d = 1/(sR - sL);
    const double jump = sL*sR;
    const double rhoEL = L.rho*L.H - (Enthalpy ? 0 : L.p);
    const double rhoER = R.rho*R.H - (Enthalpy ? 0 : R.p);

    block.flux[0][i] =
        d*(sR*L.rho*L.un - sL*R.rho*R.un + jump*(R.rho - L.rho));
    block.flux[1][i] =
        d
       *(
            sR*L.rho*L.un*L.H - sL*R.rho*R.un*R.H
          + jump*(rhoER - rhoEL)
        );
    for (int k = 0; k < nDim; k++)
    {
        const double n = block.normal[k][i];
        block.flux[2 + k][i] =
            d
           *(
                sR*(L.rho*L.un*L.u[k] + L.p*n)
              - sL*(R.rho*R.un*R.u[k] + R.p*n)
              + jump*(R.rho*R.u[k] - L.rho*L.u[k])
            );
    }
}


//- Split pressure weight (1/4)(M + 1)^2 (2 - M), one beyond M = 1
VECTOR_INLINE double beta(const double M)
{
    const double m = max(-1, min(1, M));
    return 0.25*(m + 1)*(m + 1)*(2 - m);
}


struct Kurganov
{
    template<int nDim>
    static VECTOR_INLINE void flux
    (
        faceBlock& block,
        const int i,
        const side<nDim>& L,
        const side<nDim>& R
    )
    {
        const double sR = max(max(L.un + L.a, R.un + R.a), 0);
        const double sL = min(min(L.un - L.a, R.un - R.a), 0);
        twoWaves<false>(block, i, L, R, sL, sR);
    }
};


struct shock
{
    template<int nDim>
    static VECTOR_INLINE void flux
    (
        faceBlock& block,
        const int i,
        const side<nDim>& L,
        const side<nDim>& R
    )
    {
        double sL;
        double sR;
        waveSpeeds<nDim>(L, R, sL, sR);
        twoWaves<true>(block, i, L, R, min(sL, 0), max(sR, 0));
    }
};


struct Tadmor
{
    template<int nDim>
    static VECTOR_INLINE void flux
    (
        faceBlock& block,
        const int i,
        const side<nDim>& L,
        const side<nDim>& R
    )
    {
        const double s =
            max(abs(L.un) + L.a, abs(R.un) + R.a);
        twoWaves<false>(block, i, L, R, -s, s);
    }
};


struct SLAU2
{
    template<int nDim>
    static VECTOR_INLINE void flux
    (
        faceBlock& block,
        const int i,
        const side<nDim>& L,
        const side<nDim>& R
    )
    {
        const double a = 0.5*(L.a + R.a);
        const double ML = L.un/a;
        const double MR = R.un/a;
        const double speed = std::sqrt(0.5*(L.uu + R.uu));
        const double Mhat = min(1, speed/a);
        const double chi = (1 - Mhat)*(1 - Mhat);
        const double g =
            -max(min(ML, 0), -1)*min(max(MR, 0), 1);

        const double mean =
            (L.rho*abs(L.un) + R.rho*abs(R.un))/(L.rho + R.rho);
        const double plus = (1 - g)*mean + g*abs(L.un);
        const double minus = (1 - g)*mean + g*abs(R.un);
        const double mass =
            0.5
           *(
                L.rho*(L.un + plus) + R.rho*(R.un - minus)
              - chi/a*(R.p - L.p)
            );

        const double bL = beta(ML);
        const double bR = beta(-MR);
        const double p =
            0.5*(L.p + R.p)
          + 0.5*(bL - bR)*(L.p - R.p)
          + speed*(bL + bR - 1)*0.5*(L.rho + R.rho)*a;

        convect(block, i, L, R, mass, p);
    }
};


struct AUSMPlusUp
{
    //- Split Mach number of the fourth degree, beta = 1/8
    static VECTOR_INLINE double split(const double M)
    {
        const double m = max(-1, min(1, M));
        const double q = 0.25*(m + 1)*(m + 1);
        const double r = 0.25*(m - 1)*(m - 1);
        return (M >= 1 ? M : 0) + (abs(M) < 1 ? q*(1 + 2*r) : 0);
    }

    //- Split pressure of the fifth degree, alpha = 3/16 (-4 + 5 f_a^2)
    static VECTOR_INLINE double weight(const double M, const double fa)
    {
        const double m = max(-1, min(1, M));
        const double q = 0.25*(m + 1)*(m + 1);
        const double r = 0.25*(m - 1)*(m - 1);
        return q*((2 - m) + (15*fa*fa - 12)*m*r);
    }

    template<int nDim>
    static VECTOR_INLINE void flux
    (
        faceBlock& block,
        const int i,
        const side<nDim>& L,
        const side<nDim>& R
    )
    {
        const double a = 0.5*(L.a + R.a);
        const double ML = L.un/a;
        const double MR = R.un/a;
        const double rho = 0.5*(L.rho + R.rho);
        const double M2 = 0.5*(ML*ML + MR*MR);

        const double M =
            split(ML) - split(-MR)
          - 0.25*max(1 - M2, 0)*(R.p - L.p)/(rho*a*a);
        const double mass = a*M*(M > 0 ? L.rho : R.rho);

        const double M0 =
            min(1, std::sqrt(max(L.uu, R.uu))/min(L.a, R.a));
        const double fa = M0*(2 - M0);
        const double wL = weight(ML, fa);
        const double wR = weight(-MR, fa);
        const double p =
            wL*L.p + wR*R.p
          - 0.75*fa*wL*wR*(L.rho + R.rho)*a*(R.un - L.un);

        convect(block, i, L, R, mass, p);
    }
};


struct HLLC
{
    template<int nDim>
    static VECTOR_INLINE void flux
    (
        faceBlock& block,
        const int i,
        const side<nDim>& ofL,
        const side<nDim>& ofR
    )
    {
        // What is no sound of the difference is left out, half on either side
        side<nDim> L = ofL;
        side<nDim> R = ofR;
        const double out = 0.5*(1 - block.soundShare)*(R.un - L.un);
        L.un += out;
        R.un -= out;
        L.H += out*(ofL.un + 0.5*out);
        R.H -= out*(ofR.un - 0.5*out);

        double sL;
        double sR;
        waveSpeeds<nDim>(L, R, sL, sR);

        const double dL = L.rho*(sL - L.un);
        const double dR = R.rho*(sR - R.un);
        const double sM = (R.p - L.p + dL*L.un - dR*R.un)/(dL - dR);

        // Only the side the contact lies on counts. Weights of zero and one
        // are exact, and unlike a branch they leave the loop in one piece.
        const double onLeft = sM > 0 ? 1 : 0;
        const double onRight = 1 - onLeft;
        const double s = onLeft*sL + onRight*sR;
        const double active = onLeft*min(sL, 0) + onRight*max(sR, 0);
        const double rho = onLeft*L.rho + onRight*R.rho;
        const double p = onLeft*L.p + onRight*R.p;
        const double u = onLeft*L.un + onRight*R.un;
        const double H = onLeft*L.H + onRight*R.H;
        const double add = onLeft*out - onRight*out;

        const double star = rho*(s - u)/(s - sM);
        const double E = H - p/rho;
        const double starE = E + (sM - u)*(sM + p/(rho*(s - u)));

        block.flux[0][i] = rho*u + active*(star - rho);
        block.flux[1][i] = rho*u*H + active*(star*starE - rho*E);
        for (int k = 0; k < nDim; k++)
        {
            const double n = block.normal[k][i];
            const double v = onLeft*L.u[k] + onRight*R.u[k] + add*n;
            block.flux[2 + k][i] =
                rho*u*v + p*n
              + active*(star*(v + (sM - u)*n) - rho*v);
        }
    }
};


template<class Scheme, int nDim, bool Thermally>
VECTOR_INLINE void fluxes
(
    faceBlock& block,
    const int n,
    const gasEquationOfState& gas
)
{
    for (int i = 0; i < n; i++)
    {
        const side<nDim> L = sideOf<nDim, Thermally>
        (
            block.L, block.normal, i, gas
        );
        const side<nDim> R = sideOf<nDim, Thermally>
        (
            block.R, block.normal, i, gas
        );
        Scheme::template flux<nDim>(block, i, L, R);
    }
}

} // End anonymous namespace

#define makeFlux(Scheme, nDim, Thermally)                                      \
    VECTOR_KERNEL                                                              \
    void flux##Scheme##nDim##Thermally                                         \
    (                                                                          \
        faceBlock& block,                                                      \
        const int n,                                                           \
        const gasEquationOfState& gas                                          \
    )                                                                          \
    {                                                                          \
        fluxes<Scheme, nDim, Thermally>(block, n, gas);                        \
    }

#define makeFluxes(Scheme)                                                     \
    makeFlux(Scheme, 2, false)                                                 \
    makeFlux(Scheme, 3, false)                                                 \
    makeFlux(Scheme, 2, true)                                                  \
    makeFlux(Scheme, 3, true)

makeFluxes(Kurganov)
makeFluxes(Tadmor)
makeFluxes(SLAU2)
makeFluxes(AUSMPlusUp)
makeFluxes(HLLC)
makeFluxes(shock)

#define listFluxes(Scheme)                                                     \
    {                                                                          \
        #Scheme,                                                               \
        {                                                                      \
            flux##Scheme##2false, flux##Scheme##3false,                        \
            flux##Scheme##2true, flux##Scheme##3true                           \
        }                                                                      \
    }

namespace
{

struct fluxVersions
{
    fluxKernel kernel[4];
};

const std::map<std::string, fluxVersions>& table()
{
    static const std::map<std::string, fluxVersions> kernels
    {
        listFluxes(Kurganov),
        listFluxes(Tadmor),
        listFluxes(SLAU2),
        listFluxes(AUSMPlusUp),
        listFluxes(HLLC)
    };
    return kernels;
}

} // End anonymous namespace

#undef makeFlux
#undef makeFluxes
#undef listFluxes

} // End namespace Foam


Foam::fluxKernel Foam::selectFlux
(
    const std::string& scheme,
    const int nDim,
    const bool thermallyPerfect
)
{
    const auto found = table().find(scheme);
    return
        found == table().end()
      ? nullptr
      : found->second.kernel[(nDim - 2) + 2*int(thermallyPerfect)];
}


Foam::fluxKernel Foam::shockFlux(const int nDim, const bool thermallyPerfect)
{
    return
        nDim == 2
      ? (thermallyPerfect ? fluxshock2true : fluxshock2false)
      : (thermallyPerfect ? fluxshock3true : fluxshock3false);
}


std::vector<std::string> Foam::fluxNames()
{
    std::vector<std::string> names;
    for (const auto& versions : table())
    {
        names.push_back(versions.first);
    }
    return names;
}


void Foam::exactFlux
(
    const double* q,
    const double* n,
    const int nDim,
    const gasEquationOfState& gas,
    double* flux
)
{
    const double p = q[0];
    const double T = q[1];
    const double rho = p/(gas.R*T);
    double uu = 0;
    double un = 0;
    for (int d = 0; d < nDim; d++)
    {
        uu += q[2 + d]*q[2 + d];
        un += q[2 + d]*n[d];
    }
    const double h =
        gas.thermallyPerfect() ? gas.enthalpy<true>(T) : gas.enthalpy<false>(T);

    flux[0] = rho*un;
    flux[1] = rho*un*(h + 0.5*uu);
    for (int d = 0; d < nDim; d++)
    {
        flux[2 + d] = rho*un*q[2 + d] + p*n[d];
    }
}
