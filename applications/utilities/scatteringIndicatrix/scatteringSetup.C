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

List<scalar> readIncidences(const dictionary& dict)
{
    const List<scalar> angles(getNumbers(dict, "incidence"));
    forAll(angles, i)
    {
        if (!(angles[i] > 0 && angles[i] <= 90))
        {
            FatalIOErrorInFunction(dict)
                << "incidence " << angles[i]
                << ": valid range (0, 90] (degrees)" << exit(FatalIOError);
        }
    }
    return angles;
}


//- An entry that nothing reads may be one that macros refer to: no error
void warnOfOthers(const dictionary& dict)
{
    const wordList known
    ({
        "FoamFile", "shape", "wall", "law", "incidence", "speed", "spin",
        "orientation", "nParticles", "seed", "binWidth", "targetError",
        "maxImpacts", "tableSamples"
    });
    for (const word& entry : dict.toc())
    {
        if (!known.found(entry) && !dict.isDict(entry))
        {
            IOWarningInFunction(dict)
                << "entry " << entry << " is not used. Known entries: "
                << flatOutput(known) << endl;
        }
    }
}

} // End anonymous namespace


Foam::scatteringSetup::scatteringSetup
(
    const dictionary& dict,
    const fileName& casePath
)
:
    incidences(readIncidences(dict))
{
    warnOfOthers(dict);
    scatteringEntries::read(dict, casePath, sampler);
    sampler.incidence = incidences[0];
    sampler.speed = dict.get<scalar>("speed");
    sampler.spin = {0, 0, 0};
    if (dict.found("spin"))
    {
        sampler.spin = getVector(dict, "spin");
    }

    nParticles =
        getWhole(dict, "nParticles", dict.get<scalar>("nParticles"), 1, 1e15);
    sampler.seed = scatteringEntries::getSeed(dict);
    sampler.binWidth = dict.getOrDefault<scalar>("binWidth", 1);

    targetError = getTargetError(dict);
    tableSamples = dict.getOrDefault<label>("tableSamples", 1024);
    if (tableSamples < 1)
    {
        FatalIOErrorInFunction(dict)
            << "tableSamples " << tableSamples << ": valid range >= 1"
            << exit(FatalIOError);
    }

    checked(dict, [&]
    {
        impact::scatteringSampler(sampler).emptyStatistics();
        return true;
    });
}
