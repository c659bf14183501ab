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


void Foam::gasEquations::transport
(
    const label f,
    double& mu,
    double& lambda
) const
{
    const label o = geometry_.owner[f];
    const label r = geometry_.far[f];
    const double T = primitive[r*nVar_ + 1];
    mu = eos_.viscosity(T);
    lambda =
        eos_.thermallyPerfect()
      ? eos_.conductivity<true>(mu, T)
      : eos_.conductivity<false>(mu, T);
    if (!eddyViscosity_.empty())
    {
        const double cv =
            eos_.thermallyPerfect()
          ? eos_.specificHeat<true>(T)
          : eos_.cv;
        mu += max(eddyViscosity_[o], eddyViscosity_[r]);
        lambda +=
            (cv + eos_.R)*max(eddyDiffusivity_[o], eddyDiffusivity_[r]);
    }
}


double Foam::gasEquations::diffusivity(const label f) const
{
    const double* state = &primitive[geometry_.far[f]*nVar_];
    const double T = state[1];
    const double density = state[0]/(eos_.R*T);
    const double cv =
        eos_.thermallyPerfect()
      ? eos_.specificHeat<true>(T)
      : eos_.cv;
    double mu;
    double lambda;
    transport(f, mu, lambda);
    return
        max(4.0/3*mu, lambda/cv)/density
       *geometry_.area[f]/geometry_.normalDistance[f];
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

    // No wave goes around the axis, which the thin cells of a wedge would take
    // many steps for: what counts of their sides is what they leave of the
    // area in the radial direction
    double radial[3];
    double around[3];
    for (const gasMesh::patchRange& patch : geometry_.patches())
    {
        const label n = patch.wedge ? patch.size : 0;
        for (label f = patch.start; f < patch.start + n; f++)
        {
            geometry_.turning(f, radial, around);
            double across = 0;
            for (int d = 0; d < nDim; d++)
            {
                across += geometry_.normal[f*nDim + d]*radial[d];
            }
            lambda[f] *= mag(across);
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

    // owned: weight of the owner in the speed on its side of the face
    auto faces = [&](const label start, const label end, const double owned)
    {
        for (label f = start; f < end; f++)
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
            uo = owned*uo + (1 - owned)*ur;
            ur = owned < 1 ? uo : ur;
            const double ar = soundSpeed_[r];
            const double ao = owned < 1 ? ar : soundSpeed_[o];
            const double ap = max(max(uo + ao, ur + ar), 0.0);
            const double am = min(min(uo - ao, ur - ar), 0.0);
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
    };

    // The stock solver has one state on a boundary face, that of the boundary
    // condition: between a cell and its image the velocity through the face is
    // none
    faces(0, geometry_.nInternal(), 1);
    for (const gasMesh::patchRange& patch : geometry_.patches())
    {
        faces
        (
            patch.start,
            patch.start + patch.size,
            patch.coupled ? 1 : patch.image() ? 0.5 : 0
        );
    }
}
