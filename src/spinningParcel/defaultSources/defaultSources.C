/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.

Description
    What the stock solution dictionary asks for with "coupled yes", where the
    user has not given it:
    \verbatim
        sourceTerms
        {
            resetOnStartup  yes;
            schemes { U explicit 1; }
        }
    \endverbatim

    The stock cloud reads its file and the entries of this in one constructor,
    between which nothing can be said. So this library is linked with
    --wrap (Make/options): its clouds call the function below in the place of
    the constructor of cloudSolution, and all others the stock's.
\*---------------------------------------------------------------------------*/

#include "cloudSolution.H"
#include "IStringStream.H"
#include "Switch.H"

// The names are those of Foam::cloudSolution::cloudSolution(const fvMesh&,
// const dictionary&) in the object files, with the linker's prefixes

extern "C" void __real__ZN4Foam13cloudSolutionC1ERKNS_6fvMeshERKNS_10dictionaryE
(
    Foam::cloudSolution* place,
    const Foam::fvMesh& mesh,
    const Foam::dictionary& dict
);


extern "C" void __wrap__ZN4Foam13cloudSolutionC1ERKNS_6fvMeshERKNS_10dictionaryE
(
    Foam::cloudSolution* place,
    const Foam::fvMesh& mesh,
    const Foam::dictionary& dict
)
{
    using namespace Foam;

    dictionary solution(dict);
    if (dict.getOrDefault<Switch>("coupled", false))
    {
        dictionary& sources = solution.subDictOrAdd("sourceTerms");
        sources.add("resetOnStartup", true, false);
        dictionary& schemes = sources.subDictOrAdd("schemes");
        const dictionary given(schemes);
        schemes = dictionary(IStringStream("U explicit 1;")());
        schemes.merge(given);
    }
    __real__ZN4Foam13cloudSolutionC1ERKNS_6fvMeshERKNS_10dictionaryE
    (
        place, mesh, solution
    );
}
