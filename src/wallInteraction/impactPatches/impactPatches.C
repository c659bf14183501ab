/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "impactPatches.H"
#include "checked.H"
#include "wordRes.H"

Foam::boolList Foam::impactPatches::read
(
    const dictionary& dict,
    const word& functionName,
    const polyMesh& mesh
)
{
    const wordRes names(dict.get<wordRes>("patches"));
    const polyBoundaryMesh& patches = mesh.boundaryMesh();

    boolList selected(patches.size(), false);
    wordList valid;
    for (const polyPatch& pp : patches)
    {
        if (!polyPatch::constraintType(pp.type()))
        {
            valid.append(pp.name());
        }
    }

    for (const wordRe& name : names)
    {
        bool found = false;
        for (const polyPatch& pp : patches)
        {
            if
            (
                !polyPatch::constraintType(pp.type())
             && name.match(pp.name())
            )
            {
                selected[pp.index()] = true;
                found = true;
            }
        }
        if (!found)
        {
            unknownWord(dict, "patches", name, valid);
        }
    }
    if (names.empty())
    {
        refuse
        (
            dict, "patches", "()", "at least one of ", listed(valid).c_str()
        );
    }
    return selected;
}
