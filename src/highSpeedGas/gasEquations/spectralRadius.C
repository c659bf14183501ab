/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "gasEquations.H"

void Foam::gasEquations::soundSpeed(std::vector<double>& a) const
{
    a.resize(geometry_.nSlots());
    for (label s = 0; s < geometry_.nSlots(); s++)
    {
        const double T = primitive[s*nVar_ + 1];
        a[s] = std::sqrt
        (
            eos_.thermallyPerfect()
          ? eos_.soundSpeedSqr<true>(T)
          : eos_.soundSpeedSqr<false>(T)
        );
    }
}


double Foam::gasEquations::diffusivity(const label f) const
{
    const label o = geometry_.owner[f];
    const label r = geometry_.far[f];
    const double* state = &primitive[r*nVar_];
    const double T = state[1];
    double mu = eos_.viscosity(T);
    const double density = state[0]/(eos_.R*T);
    const double cv =
        eos_.thermallyPerfect()
      ? eos_.specificHeat<true>(T)
      : eos_.cv;
    double lambda =
        eos_.thermallyPerfect()
      ? eos_.conductivity<true>(mu, T)
      : eos_.conductivity<false>(mu, T);
    if (!eddyViscosity_.empty())
    {
        mu += max(eddyViscosity_[o], eddyViscosity_[r]);
        lambda +=
            (cv + eos_.R)*max(eddyDiffusivity_[o], eddyDiffusivity_[r]);
    }
    return
        max(4.0/3*mu, lambda/cv)/density
       *geometry_.area[f]/geometry_.normalDistance[f];
}


void Foam::gasEquations::faceDiffusion(std::vector<double>& diffusion) const
{
    diffusion.resize(geometry_.nFaces());
    for (label f = 0; f < geometry_.nFaces(); f++)
    {
        diffusion[f] = diffusivity(f);
    }
}


void Foam::gasEquations::faceSpectralRadius(std::vector<double>& lambda) const
{
    const int nDim = geometry_.nDim();
    soundSpeed(soundSpeed_);
    lambda.resize(geometry_.nFaces());

    for (label f = 0; f < geometry_.nFaces(); f++)
    {
        const label o = geometry_.owner[f];
        const label r = geometry_.far[f];
        const double* n = &geometry_.normal[f*nDim];
        const double* qo = &primitive[o*nVar_ + 2];
        const double* qr = &primitive[r*nVar_ + 2];
        double uo = 0;
        double ur = 0;
        for (int d = 0; d < nDim; d++)
        {
            uo += qo[d]*n[d];
            ur += qr[d]*n[d];
        }
        lambda[f] =
            max(mag(uo) + soundSpeed_[o], mag(ur) + soundSpeed_[r])
           *geometry_.area[f];

        if (viscous_)
        {
            lambda[f] += 2*diffusivity(f);
        }
    }
}


void Foam::gasEquations::spectralRadius(std::vector<double>& lambda) const
{
    faceSpectralRadius(faceLambda_);
    lambda.assign(geometry_.nCells(), 0);

    for (label f = 0; f < geometry_.nFaces(); f++)
    {
        lambda[geometry_.owner[f]] += faceLambda_[f];
        if (f < geometry_.nInternal())
        {
            lambda[geometry_.far[f]] += faceLambda_[f];
        }
    }
}


void Foam::gasEquations::centralRadius(std::vector<double>& lambda) const
{
    const int nDim = geometry_.nDim();
    soundSpeed(soundSpeed_);
    lambda.assign(geometry_.nCells(), 0);

    for (label f = 0; f < geometry_.nFaces(); f++)
    {
        const label o = geometry_.owner[f];
        const label r = geometry_.far[f];
        const double* n = &geometry_.normal[f*nDim];
        const double* qo = &primitive[o*nVar_ + 2];
        const double* qr = &primitive[r*nVar_ + 2];
        double uo = 0;
        double ur = 0;
        for (int d = 0; d < nDim; d++)
        {
            uo += qo[d]*n[d];
            ur += qr[d]*n[d];
        }
        const double ap =
            max(max(uo + soundSpeed_[o], ur + soundSpeed_[r]), 0.0);
        const double am =
            min(min(uo - soundSpeed_[o], ur - soundSpeed_[r]), 0.0);
        const double share = ap/(ap - am);
        const double flux =
            max(mag(share*(uo - am)), mag((1 - share)*(ur - ap)))
           *geometry_.area[f];

        lambda[o] += flux;
        if (f < geometry_.nInternal())
        {
            lambda[r] += flux;
        }
    }
}
