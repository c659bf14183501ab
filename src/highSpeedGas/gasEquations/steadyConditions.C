/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "gasEquations.H"

namespace
{

using namespace Foam;

// Conditions that come to rest with the gas if time goes on for ever
const wordHashSet comesToRest {"advective", "waveTransmissive"};

// Conditions that go on with time, or with chance
const wordHashSet goesOn
{
    "plenumPressure", "syringePressure", "pressurePIDControlInletVelocity",
    "waveSurfacePressure", "activeBaffleVelocity",
    "activePressureForceBaffleVelocity", "lumpedMassWallTemperature",
    "turbulentInlet", "turbulentDigitalFilterInlet", "turbulentDFSEMInlet"
};

} // End anonymous namespace


void Foam::gasEquations::checkSteadyConditions(const label patchi)
{
    const auto check = [&](const word& field, const word& type)
    {
        marching_ = marching_ || comesToRest.found(type);
        if (goesOn.found(type))
        {
            FatalErrorInFunction
                << "Field " << field << " has the boundary condition " << type
                << " on patch " << mesh_.boundary()[patchi].name()
                << ", which goes on in time and has no steady state." << nl
                << "Set 'mode transient;' in the block highSpeedGas of"
                << " system/fvSolution, or another boundary condition"
                << exit(FatalError);
        }
    };
    check("U", U_.boundaryField()[patchi].type());
    check("T", thermo_.T().boundaryField()[patchi].type());
    check("p", thermo_.p().boundaryField()[patchi].type());
}
