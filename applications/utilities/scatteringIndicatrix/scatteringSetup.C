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
    ITstream& is = dict.lookup("incidence");
    const token first(is);
    is.rewind();
    List<scalar> angles;
    if (first.isNumber())
    {
        angles.append(dict.get<scalar>("incidence"));
    }
    else
    {
        angles = dict.get<List<scalar>>("incidence");
    }
    if (angles.empty())
    {
        FatalIOErrorInFunction(dict)
            << "incidence: the list is empty" << exit(FatalIOError);
    }
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

} // End anonymous namespace


Foam::scatteringSetup::scatteringSetup
(
    const dictionary& dict,
    const fileName& casePath
)
:
    incidences(readIncidences(dict))
{
    scatteringEntries::read(dict, casePath, sampler);
    sampler.incidence = incidences[0];
    sampler.speed = dict.get<scalar>("speed");
    sampler.spin = {0, 0, 0};
    if (dict.found("spin"))
    {
        sampler.spin = toCore(dict.get<vector>("spin"));
    }

    // Read as a real number: more than an integer of 32 bits may be asked for
    const scalar number = dict.get<scalar>("nParticles");
    if (!(number >= 1 && number <= 1e15) || number != std::floor(number))
    {
        FatalIOErrorInFunction(dict)
            << "nParticles " << number
            << ": valid range: whole numbers from 1 to 1e15"
            << exit(FatalIOError);
    }
    nParticles = int64_t(number);

    sampler.seed = scatteringEntries::getSeed(dict);
    sampler.binWidth = dict.getOrDefault<scalar>("binWidth", 1);

    targetError = dict.getOrDefault<scalar>("targetError", 0);
    if (dict.found("targetError") && !(targetError > 0 && targetError < 1))
    {
        FatalIOErrorInFunction(dict)
            << "targetError " << targetError << ": valid range (0, 1)"
            << exit(FatalIOError);
    }
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
