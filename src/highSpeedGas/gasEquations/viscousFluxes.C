/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "gasEquations.H"

template<int nDim>
void Foam::gasEquations::viscousFlux
(
    const label f,
    const double share,
    const label behind,
    const double friction,
    const bool ofGradient
)
{
    constexpr int nVar = nDim + 2;
    const double* qo = &primitive[geometry_.owner[f]*nVar];
    const double* qf = &primitive[geometry_.far[f]*nVar];
    const double* go = &gradient_[geometry_.owner[f]*(nVar*nDim)];
    const double* gf = &gradient_[behind*(nVar*nDim)];
    const double* delta = &geometry_.delta[f*nDim];
    const double* n = &geometry_.normal[f*nDim];

    // Mean gradient of temperature and velocity, its normal part such that it
    // gives the difference along the line of centres. To change the part along
    // that line instead leaves the face without its own difference where the
    // line leans: thin cells beside a sharp tip had no friction.
    double g[nDim][nVar];
    double q[nVar];
    for (int k = 1; k < nVar; k++)
    {
        double along = 0;
        for (int d = 0; d < nDim; d++)
        {
            g[d][k] = (1 - share)*go[d*nVar + k] + share*gf[d*nVar + k];
            along += g[d][k]*delta[d];
        }
        const double defect =
            (qf[k] - qo[k] - along)/geometry_.normalDistance[f];
        for (int d = 0; d < nDim; d++)
        {
            g[d][k] += defect*n[d];
        }
        q[k] = (1 - share)*qo[k] + share*qf[k];
    }

    if (ofGradient)
    {
        // The condition has made the temperature of the face of that of the
        // cell and its own gradient: the way along the face is not in it, and
        // what the cell has of a gradient there would heat adiabatic walls
        double normal = 0;
        for (int d = 0; d < nDim; d++)
        {
            normal += g[d][1]*n[d];
        }
        const double defect =
            (qf[1] - qo[1])/geometry_.normalDistance[f] - normal;
        for (int d = 0; d < nDim; d++)
        {
            g[d][1] += defect*n[d];
        }
    }

    const double T = q[1];
    double mu = eos_.viscosity(T);
    double lambda =
        eos_.thermallyPerfect()
      ? eos_.conductivity<true>(mu, T)
      : eos_.conductivity<false>(mu, T);
    if (!eddyViscosity_.empty())
    {
        const label o = geometry_.owner[f];
        const label r = geometry_.far[f];
        const double cv =
            eos_.thermallyPerfect()
          ? eos_.specificHeat<true>(T)
          : eos_.cv;
        mu += (1 - share)*eddyViscosity_[o] + share*eddyViscosity_[r];
        lambda +=
            (cv + eos_.R)
           *((1 - share)*eddyDiffusivity_[o] + share*eddyDiffusivity_[r]);
    }

    double divU =
        (1 - share)*hoopStrain(geometry_.owner[f]) + share*hoopStrain(behind);
    for (int d = 0; d < nDim; d++)
    {
        divU += g[d][2 + d];
    }

    double flux[nVar];
    flux[1] = 0;
    for (int d = 0; d < nDim; d++)
    {
        double stress = -2.0/3*divU*n[d];
        for (int k = 0; k < nDim; k++)
        {
            stress += (g[k][2 + d] + g[d][2 + k])*n[k];
        }
        flux[2 + d] = -friction*mu*stress;
        flux[1] += flux[2 + d]*q[2 + d] - lambda*g[d][1]*n[d];
    }

    const double S = geometry_.area[f];
    double* ro = &rate[geometry_.owner[f]*nVar];
    const bool inner = f < geometry_.nInternal();
    double* rf = inner ? &rate[geometry_.far[f]*nVar] : nullptr;
    for (int k = 1; k < nVar; k++)
    {
        ro[k] -= flux[k]*S;
        if (inner)
        {
            rf[k] += flux[k]*S;
        }
    }
}


double Foam::gasEquations::hoopStrain(const label s) const
{
    if (!geometry_.inSection())
    {
        return 0;
    }
    double outward = 0;
    for (int d = 0; d < geometry_.nDim(); d++)
    {
        outward += primitive[s*nVar_ + 2 + d]*geometry_.away[d];
    }
    return outward*geometry_.inverseRadius[s];
}


template<int nDim>
void Foam::gasEquations::hoopStress(const label f)
{
    constexpr int nVar = nDim + 2;
    const label c = geometry_.owner[f];
    const double* g = &gradient_[c*(nVar*nDim)];
    const double* n = &geometry_.normal[f*nDim];
    double mu = eos_.viscosity(primitive[c*nVar + 1]);
    if (!eddyViscosity_.empty())
    {
        mu += eddyViscosity_[c];
    }

    const double strain = hoopStrain(c);
    double divU = strain;
    for (int d = 0; d < nDim; d++)
    {
        divU += g[d*nVar + 2 + d];
    }
    double* rate_c = &rate[c*nVar];
    if (geometry_.inSection())
    {
        const double force =
            mu*(2*strain - 2.0/3*divU)*geometry_.area[f];
        for (int d = 0; d < nDim; d++)
        {
            rate_c[2 + d] += force*n[d];
        }
        return;
    }
    const double* r = geometry_.radial(f);
    const double* t = geometry_.around(f);

    // Traction on a plane through the axis
    double traction[nDim];
    double along = 0;
    double radial = 0;
    double across = 0;
    for (int d = 0; d < nDim; d++)
    {
        traction[d] = -2.0/3*divU*t[d];
        for (int k = 0; k < nDim; k++)
        {
            traction[d] += (g[k*nVar + 2 + d] + g[d*nVar + 2 + k])*t[k];
        }
        along += traction[d]*t[d];
        radial += traction[d]*r[d];
        across += n[d]*r[d];
    }

    // Of the tractions on both faces of the wedge, turned towards each other,
    // this remains; their work cancels
    const double share = mu*across*geometry_.area[f];
    for (int d = 0; d < nDim; d++)
    {
        rate_c[2 + d] += share*(along*r[d] - radial*t[d]);
    }
}


template<int nDim>
void Foam::gasEquations::viscousFluxes()
{
    for (label f = 0; f < geometry_.nInternal(); f++)
    {
        viscousFlux<nDim>(f, geometry_.weight[f], geometry_.far[f]);
    }

    for (const gasMesh::patchRange& patch : geometry_.patches())
    {
        for (label f = patch.start; f < patch.start + patch.size; f++)
        {
            if (patch.coupled || patch.symmetry)
            {
                viscousFlux<nDim>(f, geometry_.weight[f], geometry_.far[f]);
            }
            else if (patch.wedge)
            {
                hoopStress<nDim>(f);
            }
            else
            {
                // State of the face, gradient of the cell
                viscousFlux<nDim>
                (
                    f,
                    1,
                    geometry_.owner[f],
                    frictionless_[patch.patchi] ? 0 : 1,
                    ofGradient_[patch.patchi]
                );
            }
        }
    }
}


template void Foam::gasEquations::viscousFluxes<2>();
template void Foam::gasEquations::viscousFluxes<3>();
