/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "gasEquations.H"

double Foam::gasEquations::machNumberSqr(const label s) const
{
    const double* q = &primitive[s*nVar_];
    double uu = 0;
    for (int k = 2; k < nVar_; k++)
    {
        uu += q[k]*q[k];
    }
    return
        uu
       /(
            eos_.thermallyPerfect()
          ? eos_.soundSpeedSqr<true>(q[1])
          : eos_.soundSpeedSqr<false>(q[1])
        );
}


Foam::scalar Foam::gasEquations::largestMach(const bool withGhosts) const
{
    const label end = withGhosts ? geometry_.nSlots() : geometry_.nCells();
    scalar largest = 0;
    for (label s = 0; s < end; s++)
    {
        largest = max(largest, machNumberSqr(s));
    }
    return std::sqrt(returnReduce(largest, maxOp<scalar>()));
}


void Foam::gasEquations::muffle(const bool muffled)
{
    muffled_ =
        muffled
     && flux_
     == selectFlux("HLLC", geometry_.nDim(), eos_.thermallyPerfect());
}


void Foam::gasEquations::setSoundShare()
{
    // One Mach number for all gas, as by the upstream one of Liou (2006): with
    // that of each face sound would not be damped where gas is at rest beside
    // a jet or behind a shock. From 0.5 on all is as without this.
    const scalar fast = 0.5;
    soundShare_ = muffled_ ? min(scalar(1), largestMach(true)/fast) : 1;
}


void Foam::gasEquations::warnOfSlowGas()
{
    // Of the dynamic pressure of gas at Mach number 0.3, 0.1, 0.05 and 0.01
    // HLLC loses 1.6, 2.8, 5.7 and 21 % before a sphere (40 cells over 90
    // degrees) where it takes all differences of velocity for sound, SLAU2 1
    // to 2 %; beside it Kurganov's flux loses 18 to 53 %, SLAU2 2 to 4 %
    const word flux
    (
        mesh_.schemesDict().getOrDefault<word>("fluxScheme", "HLLC")
    );
    const scalar least =
        flux == "SLAU2" || flux == "AUSMPlusUp" ? 0
      : flux == "HLLC" ? (inTime_ ? 0.1 : 0)
      : 0.5;
    const scalar mach = largestMach(false);

    // (at rest there is nothing but round-off)
    if (!warnedOfSlowGas_ && mach > 1e-5 && mach < least)
    {
        warnedOfSlowGas_ = true;
        WarningInFunction
            << "The gas is slow, Mach number " << mach << " at most. There"
            << " fluxScheme " << flux << " takes differences of velocity for"
            << " sound, and total pressure may be lost or gained by several per"
            << " cent of the dynamic pressure, the more the slower the gas is."
            << " Set 'fluxScheme SLAU2;' in fvSchemes" << endl;
    }
}
