/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "gasEquations.H"

namespace
{

using namespace Foam;

//- Whether gas (p, T and velocity) sends a shock back into a supersonic stream
//  that runs into it
bool throwsBack
(
    const gasEquationOfState& eos,
    const int nVar,
    const double* stream,
    const double* q
)
{
    const auto gammaOf = [&](const double T)
    {
        const double aa =
            eos.thermallyPerfect()
          ? eos.soundSpeedSqr<true>(T)
          : eos.soundSpeedSqr<false>(T);
        return aa/(eos.R*T);
    };
    double uu = 0;
    double along = 0;
    for (int k = 2; k < nVar; k++)
    {
        uu += sqr(stream[k]);
        along += stream[k]*q[k];
    }

    // With a shock at rest in the stream: does the gas behind it run into that
    // inside, brought to the same pressure? Then the shock does not rest
    const double u = std::sqrt(uu);
    const double gamma = gammaOf(stream[1]);
    const double MM = uu/(gamma*eos.R*stream[1]);
    if (!(MM > 1))
    {
        return false;   // a mean of streams that cross
    }
    const double p = stream[0]*(1 + 2*gamma/(gamma + 1)*(MM - 1));
    const double behind = u*((gamma - 1)*MM + 2)/((gamma + 1)*MM);

    const double g = gammaOf(q[1]);
    const double RT = eos.R*q[1];
    const double change =
        p > q[0]
      ? (p - q[0])*std::sqrt(2*RT/(q[0]*((g + 1)*p + (g - 1)*q[0])))
      : 2*std::sqrt(g*RT)/(g - 1)*(std::pow(p/q[0], 0.5*(g - 1)/g) - 1);
    return along/u + change < behind;
}


} // End anonymous namespace


bool Foam::gasEquations::supersonicStream
(
    scalar& largestMach,
    scalar& leastPitot
) const
{
    label nSubsonic = 0;
    largestMach = 0;
    leastPitot = GREAT;

    for (const gasMesh::patchRange& patch : geometry_.patches())
    {
        // (On curved walls of wedges round values of U point inwards)
        const label end = patch.start + patch.size;
        const bool shut =
            patch.coupled || patch.image() || frictionless_[patch.patchi];
        for (label f = shut ? end : patch.start; f < end; f++)
        {
            const double* q = &primitive[geometry_.far[f]*nVar_];
            double a;
            if (outwardSpeed(f, q, a) > -1e-6*a)
            {
                continue;
            }
            double uu = 0;
            for (int k = 2; k < nVar_; k++)
            {
                uu += q[k]*q[k];
            }
            const scalar MM = uu/(a*a);
            if (MM <= 1)
            {
                nSubsonic++;
                continue;
            }
            largestMach = max(largestMach, std::sqrt(MM));
            leastPitot = min(leastPitot, q[0]*eos_.pitotRatio(MM));
        }
    }
    reduce(nSubsonic, sumOp<label>());
    reduce(largestMach, maxOp<scalar>());
    reduce(leastPitot, minOp<scalar>());
    return nSubsonic == 0 && largestMach > 0;
}


void Foam::gasEquations::beginFromStream()
{
    scalar streamMach;
    scalar pitot;
    if (!supersonicStream(streamMach, pitot))
    {
        return;
    }

    // The mean stream, and whether gas in its way throws it back
    scalarList stream(nVar_, Zero);
    scalar area = 0;
    scalar opposed = 0;
    for (const gasMesh::patchRange& patch : geometry_.patches())
    {
        const bool shut = patch.coupled || patch.image();
        const label end = patch.start + (shut ? 0 : patch.size);
        for (label f = patch.start; f < end; f++)
        {
            const double* inside = &primitive[geometry_.owner[f]*nVar_];
            const double* q = &primitive[geometry_.far[f]*nVar_];
            double a;
            if (outwardSpeed(f, q, a) < -a)
            {
                const scalar S = geometry_.area[f];
                area += S;
                opposed += throwsBack(eos_, nVar_, q, inside) ? S : 0;
                for (int k = 0; k < nVar_; k++)
                {
                    stream[k] += S*q[k];
                }
            }
        }
    }
    reduce(area, sumOp<scalar>());
    reduce(opposed, sumOp<scalar>());
    Pstream::listCombineGather(stream, plusEqOp<scalar>());
    Pstream::listCombineScatter(stream);
    if (opposed <= 0.5*area)
    {
        return;
    }
    for (scalar& value : stream)
    {
        value /= area;
    }

    label nCells = 0;
    for (label c = 0; c < geometry_.nCells(); c++)
    {
        double* q = &primitive[c*nVar_];
        if (throwsBack(eos_, nVar_, stream.begin(), q))
        {
            nCells++;
            std::copy(stream.begin(), stream.end(), q);
        }
    }
    std::fill(gradient_.begin(), gradient_.end(), 0);
    conserveFromPrimitive();
    correctBoundary();
    reduce(nCells, sumOp<label>());
    Info<< "Gas: begins as the stream in " << nCells << " cells, whose gas"
        << " would throw the stream back through the inlet" << endl;
}


void Foam::gasEquations::reportStagnation() const
{
    if (viscous_ || eos_.thermallyPerfect() || !source_.empty())
    {
        return;
    }
    scalar streamMach;
    scalar pitot;
    if (!supersonicStream(streamMach, pitot))
    {
        return;
    }

    // A bow shock captured in too few cells may bulge and have gas go round
    // behind it, steadily, like a carbuncle. Here counts gas that has come
    // nearly to rest, at a pressure that only gas behind no more than one
    // strong shock has: no wake
    const scalar leastPressure = 0.8*pitot;
    const scalar mostMach = 0.2;

    // What meshes in line with the shock stay below by far
    const scalar accuracy = 0.01;

    // At the wall, where all gas has come through the shock before the nose:
    // further out a stripe of gas that has lost too little may be made up for
    scalar total = 0;
    vector place(Zero);
    label nFaces = 0;
    for (const gasMesh::patchRange& patch : geometry_.patches())
    {
        const bool shut = frictionless_[patch.patchi] && !patch.image();
        const label end = patch.start + patch.size;
        for (label f = shut ? patch.start : end; f < end; f++)
        {
            const label c = geometry_.owner[f];
            const double p = primitive[c*nVar_];
            const scalar MM = machNumberSqr(c);
            if (p > leastPressure && MM < sqr(mostMach))
            {
                nFaces++;
                place += mesh_.cellCentres()[geometry_.meshCell[c]];
                total += p*eos_.stagnationRatio(MM);
            }
        }
    }
    reduce(nFaces, sumOp<label>());
    reduce(total, sumOp<scalar>());
    reduce(place, sumOp<vector>());

    // (a captured shock may overshoot by some per cent)
    const bool expands = largestMach(false) > 1.05*streamMach;
    const scalar lost = nFaces ? 1 - total/(nFaces*pitot) : 0;
    if (lost < -accuracy)
    {
        WarningInFunction
            << "At " << nFaces << " faces of walls around " << place/nFaces
            << " the gas comes nearly to rest, and its total pressure is "
            << -100*lost << " % above that behind a normal shock of the"
            << " stream. That is right behind weaker shocks, before a blunt"
            << " nose it is not: a shock across slanted mesh lines, or"
            << " tetrahedra, loses too little. Take layers of hexahedra, which"
            << " alignMeshToShock can move, or smaller cells" << endl;
    }
    if (!expands && lost > accuracy)
    {
        WarningInFunction
            << "At " << nFaces << " faces of walls around " << place/nFaces
            << " the gas comes nearly to rest, and its total pressure is "
            << 100*lost << " % below that behind a normal shock of the"
            << " stream, the least that one shock leaves. The gas is steady,"
            << " but the mesh does not resolve the shock and what is between"
            << " it and the body: take smaller cells there, or layers that"
            << " alignMeshToShock can move" << endl;
    }
}
