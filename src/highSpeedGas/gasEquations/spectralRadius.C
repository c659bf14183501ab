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


Foam::gasEquations::faceTransport Foam::gasEquations::transport
(
    const label f
) const
{
    const label o = geometry_.owner[f];
    const label r = geometry_.far[f];
    const double T = primitive[r*nVar_ + 1];
    faceTransport t;
    t.mu = eos_.viscosity(T);
    t.lambda =
        eos_.thermallyPerfect()
      ? eos_.conductivity<true>(t.mu, T)
      : eos_.conductivity<false>(t.mu, T);
    if (!eddyViscosity_.empty())
    {
        const double cv =
            eos_.thermallyPerfect()
          ? eos_.specificHeat<true>(T)
          : eos_.cv;
        t.mu += max(eddyViscosity_[o], eddyViscosity_[r]);
        t.lambda +=
            (cv + eos_.R)*max(eddyDiffusivity_[o], eddyDiffusivity_[r]);
    }
    return t;
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
    const faceTransport t = transport(f);
    return
        max(4.0/3*t.mu, t.lambda/cv)/density
       *geometry_.area[f]/geometry_.normalDistance[f];
}


Foam::gasEquations::faceVelocities Foam::gasEquations::normalVelocities
(
    const label f
) const
{
    const int nDim = geometry_.nDim();
    const double* n = &geometry_.normal[f*nDim];
    const double* qo = &primitive[geometry_.owner[f]*nVar_ + 2];
    const double* qr = &primitive[geometry_.far[f]*nVar_ + 2];
    faceVelocities u = {0, 0};
    for (int d = 0; d < nDim; d++)
    {
        u.owner += qo[d]*n[d];
        u.far += qr[d]*n[d];
    }
    return u;
}


void Foam::gasEquations::sumOverFaces
(
    const std::vector<double>& ofFaces,
    std::vector<double>& ofCells
) const
{
    ofCells.assign(geometry_.nCells(), 0);
    for (label f = 0; f < geometry_.nFaces(); f++)
    {
        ofCells[geometry_.owner[f]] += ofFaces[f];
        if (f < geometry_.nInternal())
        {
            ofCells[geometry_.far[f]] += ofFaces[f];
        }
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
        const faceVelocities u = normalVelocities(f);
        lambda[f] =
            max(mag(u.owner) + soundSpeed_[o], mag(u.far) + soundSpeed_[r])
           *geometry_.area[f];

        if (viscous_)
        {
            lambda[f] += 2*diffusivity(f);
        }
    }

    // No wave goes around the axis, which the thin cells of a wedge would take
    // many steps for: what counts of their sides is what they leave of the
    // area in the radial direction
    for (const gasMesh::patchRange& patch : geometry_.patches())
    {
        const bool sides = patch.wedge && !geometry_.inSection();
        const label n = sides ? patch.size : 0;
        for (label f = patch.start; f < patch.start + n; f++)
        {
            const double* radial = geometry_.radial(f);
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
    sumOverFaces(faceLambda_, lambda);
}


void Foam::gasEquations::centralRadius(std::vector<double>& lambda)
{
    if (returnReduce(brokenFace_ >= 0, orOp<bool>()))
    {
        reportInvalidCells();
    }
    soundSpeed(soundSpeed_);
    faceLambda_.resize(geometry_.nFaces());

    // owned: weight of the owner in the speed on its side of the face
    auto faces = [&](const label start, const label end, const double owned)
    {
        for (label f = start; f < end; f++)
        {
            const label o = geometry_.owner[f];
            const label r = geometry_.far[f];
            const faceVelocities u = normalVelocities(f);
            const double uo = owned*u.owner + (1 - owned)*u.far;
            const double ur = owned < 1 ? uo : u.far;
            const double ar = soundSpeed_[r];
            const double ao = owned < 1 ? ar : soundSpeed_[o];
            const double ap = max(max(uo + ao, ur + ar), 0.0);
            const double am = min(min(uo - ao, ur - ar), 0.0);
            const double share = ap/(ap - am);
            faceLambda_[f] =
                max(mag(share*(uo - am)), mag((1 - share)*(ur - ap)))
               *geometry_.area[f];
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
        if (patch.wedge && geometry_.inSection())
        {
            // Nothing moves through the sides of a section
            std::fill_n(faceLambda_.begin() + patch.start, patch.size, 0);
        }
    }
    sumOverFaces(faceLambda_, lambda);
}
