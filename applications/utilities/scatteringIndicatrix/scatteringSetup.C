/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "scatteringSetup.H"

#include "checked.H"
#include "coreVector.H"
#include "scatteringEntries.H"

namespace
{

using namespace Foam;

const wordList ours
{
    "shape", "wall", "law", "incidence", "speed", "spin", "orientation",
    "nParticles", "seed", "binWidth", "targetError", "maxImpacts",
    "tableSamples"
};

} // End anonymous namespace


Foam::scatteringSetup::scatteringSetup
(
    const dictionary& dict,
    const fileName& casePath
)
:
    incidences(getNumbers(dict, "incidence", "[1e-6, 90] deg"))
{
    refuseOthers(dict, ours);
    scatteringEntries::read(dict, casePath, sampler);
    sampler.incidence = incidences[0];
    sampler.speed = getNumber(dict, "speed", "[1e-6, 3e8) m/s, below light");
    sampler.spin =
        toCore(getComponents(dict, "spin", validRange::spin, vector(Zero)));

    nParticles = getWhole(dict, "nParticles", "[1, 1e15]");
    sampler.seed = scatteringEntries::getSeed(dict);
    sampler.binWidth =
        getNumber(dict, "binWidth", "[0.1, 90] deg", scalar(1));

    targetError = getTargetError(dict);
    tableSamples = getNumber<label>(dict, "tableSamples", "[1, 1e7]", 1024);

    checked(dict, [&]
    {
        impact::scatteringSampler(sampler).emptyStatistics();
        return true;
    });
}
