/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "gasEquations.H"
#include "cyclicAMIFvPatch.H"

const Foam::FixedList<Foam::word, 3> Foam::gasImbalance::names
({
    "mass", "momentum", "energy"
});


Foam::label Foam::gasImbalance::worst() const
{
    // A NaN compares with nothing, and is the worst there is
    label w = 0;
    for (label k = 1; k < 3; k++)
    {
        w = largest[w] >= largest[k] ? w : k;
    }
    return w;
}


void Foam::gasImbalance::writeOfWalls(Ostream& os) const
{
    os  << "cells gain or lose " << heat << " of the heat that goes through"
        << " the walls, and " << drag << " of the force of moving walls";
}


Foam::Ostream& Foam::operator<<(Ostream& os, const gasImbalance& b)
{
    for (label k = 0; k < 3; k++)
    {
        os  << (k ? ", " : "") << gasImbalance::names[k] << ' '
            << b.largest[k];
    }
    return os;
}


void Foam::gasEquations::scales
(
    std::vector<double>& unknown,
    std::vector<double>& equation
) const
{
    const int nDim = geometry_.nDim();
    spectralRadius(cellLambda_);

    for (label c = 0; c < geometry_.nCells(); c++)
    {
        const double* q = &primitive[c*nVar_];
        double uu = 0;
        for (int d = 0; d < nDim; d++)
        {
            uu += q[2 + d]*q[2 + d];
        }
        const double rho = q[0]/(eos_.R*q[1]);
        const double speed = std::sqrt(uu) + soundSpeed_[c];
        double* s = &unknown[c*nVar_];
        s[0] = rho;
        s[1] = rho*speed*speed;
        for (int d = 0; d < nDim; d++)
        {
            s[2 + d] = rho*speed;
        }
        for (int k = 0; k < nVar_; k++)
        {
            equation[c*nVar_ + k] = 0.5*cellLambda_[c]*s[k];
        }
    }
}


Foam::scalar Foam::gasEquations::mass() const
{
    scalar m = 0;
    for (label c = 0; c < geometry_.nCells(); c++)
    {
        const double* q = &primitive[c*nVar_];
        m += q[0]/(eos_.R*q[1])*geometry_.volume[c];
    }
    return returnReduce(m, sumOp<scalar>());
}


Foam::gasInflows Foam::gasEquations::inflows() const
{
    const int nDim = geometry_.nDim();
    gasInflows flows;
    for (const gasMesh::patchRange& patch : geometry_.patches())
    {
        if (patch.coupled)
        {
            if (isA<cyclicAMIFvPatch>(mesh_.boundary()[patch.patchi]))
            {
                flows.lostMass += sum(phi_.boundaryField()[patch.patchi]);
            }
            continue;
        }
        for (label f = patch.start; f < patch.start + patch.size; f++)
        {
            const scalar m =
                phi_.boundaryField()[patch.patchi][f - patch.start];
            const double* q = &primitive[geometry_.far[f]*nVar_];
            scalar H =
                eos_.thermallyPerfect()
              ? eos_.enthalpy<true>(q[1])
              : eos_.enthalpy<false>(q[1]);
            for (int d = 0; d < nDim; d++)
            {
                H += 0.5*sqr(q[2 + d]);
            }
            const scalar inflow = max(-m, scalar(0));
            flows.mass += inflow;
            flows.enthalpy += inflow*H;

            // What flows in at a thousandth of the speed of sound: where the
            // gas is at rest, round-off is not out of balance with nothing
            const scalar minInflow =
                m == 0
              ? 0
              : 1e-3*q[0]/(eos_.R*q[1])*geometry_.area[f]
               *soundSpeed_[geometry_.owner[f]];
            flows.leastMass += minInflow;
            flows.leastEnthalpy += minInflow*H;
        }
    }

    for
    (
        scalar* flow :
        {
            &flows.mass, &flows.enthalpy, &flows.leastMass,
            &flows.leastEnthalpy, &flows.lostMass
        }
    )
    {
        reduce(*flow, sumOp<scalar>());
    }
    return flows;
}


Foam::Pair<Foam::scalar> Foam::gasEquations::exchangeOfWalls() const
{
    const int nDim = geometry_.nDim();
    scalar heat = 0;
    scalar lowest = GREAT;
    scalar highest = 0;
    scalar drag = 0;
    scalar fastest = 0;
    for (label c = 0; c < geometry_.nCells(); c++)
    {
        lowest = min(lowest, primitive[c*nVar_ + 1]);
        highest = max(highest, primitive[c*nVar_ + 1]);
    }
    for (const gasMesh::patchRange& patch : geometry_.patches())
    {
        const bool wall = !patch.coupled && !patch.image();
        const label end = patch.start + (wall ? patch.size : 0);
        const bool sticks = wall && !frictionless_[patch.patchi];
        for (label f = patch.start; f < end; f++)
        {
            const double* q = &primitive[geometry_.owner[f]*nVar_];
            const double* qw = &primitive[geometry_.far[f]*nVar_];
            const scalar share =
                geometry_.area[f]/geometry_.normalDistance[f];
            const faceTransport t = transport(f);
            lowest = min(lowest, qw[1]);
            highest = max(highest, qw[1]);
            heat += t.lambda*max(mag(qw[1] - q[1]), 1e-3*qw[1])*share;
            if (!sticks)
            {
                continue;
            }
            scalar slip = 0;
            scalar speed = 0;
            for (int d = 0; d < nDim; d++)
            {
                slip += sqr(qw[2 + d] - q[2 + d]);
                speed += sqr(qw[2 + d]);
            }
            slip = std::sqrt(slip);
            speed = std::sqrt(speed);
            drag += t.mu*max(slip, 1e-3*speed)*share;
            fastest = max(fastest, speed/soundSpeed_[geometry_.owner[f]]);
        }
    }
    for (scalar* value : {&heat, &drag})
    {
        reduce(*value, sumOp<scalar>());
    }
    reduce(lowest, minOp<scalar>());
    for (scalar* value : {&highest, &fastest})
    {
        reduce(*value, maxOp<scalar>());
    }

    // Heat that friction makes alone is not waited for, nor motion that dies
    return Pair<scalar>
    (
        highest - lowest > 1e-3*highest ? heat : 0,
        fastest > 1e-6 ? drag : 0
    );
}


Foam::gasImbalance Foam::gasEquations::imbalance(const scalar bound) const
{
    const int nDim = geometry_.nDim();
    const label nCells = geometry_.nCells();
    std::vector<double> unknown(nCells*nVar_);
    std::vector<double> equation(nCells*nVar_);
    scales(unknown, equation);

    // The dynamic pressure of slow gas is small beside what sound is measured
    // by. Of gas that is shut in the heat and drag of walls are looked at.
    const scalar fast = 0.1;
    const scalar mach = open_ ? largestMach(true) : fast;
    const scalar part = sqr(min(scalar(1), max(mach, scalar(1e-3))/fast));

    gasImbalance b;
    b.largest = -1;
    b.cell = -1;
    b.nAbove = 0;

    scalar netMass = 0;
    scalar netEnthalpy = 0;
    scalar gained = 0;
    scalar pushed = 0;
    scalar squares = 0;

    for (label c = 0; c < nCells; c++)
    {
        const double* R = &rate[c*nVar_];
        const double* s = &equation[c*nVar_];
        double mm = 0;
        for (int d = 0; d < nDim; d++)
        {
            mm += sqr(R[2 + d]);
        }
        const double value[3] =
        {
            mag(R[0])/(part*s[0]),
            std::sqrt(mm)/(part*s[2]),
            mag(R[1])/(part*s[1])
        };
        bool above = false;
        for (label k = 0; k < 3; k++)
        {
            if (!(value[k] <= b.largest[k]))
            {
                b.largest[k] = value[k];
                b.cell[k] = geometry_.meshCell[c];
            }
            above = above || !(value[k] <= bound);
            squares += sqr(value[k]);
        }
        b.nAbove += above;
        netMass += R[0];
        netEnthalpy += R[1];
        gained += mag(R[1]);
        pushed += std::sqrt(mm);
    }

    const gasInflows in = inflows();
    reduce(netMass, sumOp<scalar>());
    reduce(netEnthalpy, sumOp<scalar>());
    reduce(gained, sumOp<scalar>());
    reduce(pushed, sumOp<scalar>());
    reduce(b.nAbove, sumOp<label>());
    reduce(squares, sumOp<scalar>());
    b.mean = std::sqrt
    (
        squares/(3*returnReduce(scalar(nCells), sumOp<scalar>()))
    );
    const Pair<scalar> ofWalls =
        viscous_ && !open_ ? exchangeOfWalls() : Pair<scalar>(0, 0);
    b.heat = ofWalls.first() > 0 ? gained/ofWalls.first() : 0;
    b.drag = ofWalls.second() > 0 ? pushed/ofWalls.second() : 0;
    if (in.leastMass == 0)
    {
        b.massBalance = 0;
        b.enthalpyBalance = 0;
        b.lostMass = 0;
    }
    else
    {
        const scalar massIn = max(in.mass, in.leastMass);
        b.massBalance = netMass/massIn;
        b.enthalpyBalance =
            netEnthalpy/max(in.enthalpy, max(in.leastEnthalpy, VSMALL));
        b.lostMass = in.lostMass/massIn;
    }

    for (label k = 0; k < 3; k++)
    {
        const scalar all = returnReduce(b.largest[k], maxOp<scalar>());
        b.rank[k] = returnReduce
        (
            b.largest[k] >= all && b.cell[k] >= 0
          ? Pstream::myProcNo()
          : labelMax,
            minOp<label>()
        );
        const bool here = b.rank[k] == Pstream::myProcNo();
        b.place[k] = returnReduce
        (
            here
          ? mesh_.cellCentres()[b.cell[k]]
          : point(-GREAT, -GREAT, -GREAT),
            maxOp<point>()
        );
        b.cell[k] = returnReduce(here ? b.cell[k] : -1, maxOp<label>());
        b.largest[k] = all;
    }
    return b;
}
