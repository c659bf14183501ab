/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "solidWalls.H"
#include "checked.H"
#include "wallPolyPatch.H"
#include "wordRes.H"

Foam::solidWalls::solidWalls(const dictionary& dict, const polyMesh& mesh)
:
    kinds_(mesh.boundaryMesh().size(), specular),
    lawOf_(mesh.boundaryMesh().size(), -1)
{
    const wordList types
    {
        "specular", "hardSphereWall", "semiEmpiricalRebound", "stick", "escape"
    };
    const polyBoundaryMesh& patches = mesh.boundaryMesh();
    wordList walls;
    for (const polyPatch& patch : patches)
    {
        if (isA<wallPolyPatch>(patch))
        {
            walls.append(patch.name());
        }
    }

    const dictionary* block = findBlock(dict, "walls");
    const dictionary own(block ? *block : dictionary());
    List<const dictionary*> settings(patches.size(), nullptr);
    for (const bool names : {false, true})
    {
        for (const entry& e : own)
        {
            const dictionary& d = own.subDict(e.keyword());
            bool found = false;
            forAll(patches, patchi)
            {
                const word& name = patches[patchi].name();
                if (!walls.found(name))
                {
                    continue;
                }
                if (name == e.keyword() || wordRe(e.keyword()).match(name))
                {
                    found = true;
                    if (!names || name == e.keyword())
                    {
                        settings[patchi] = &d;
                    }
                }
            }
            if (!found)
            {
                unknownWord(own, "wall", e.keyword(), walls);
            }
        }
    }

    forAll(patches, patchi)
    {
        if (!walls.found(patches[patchi].name()))
        {
            continue;
        }
        if (!settings[patchi])
        {
            FatalIOErrorInFunction(dict)
                << "No entry of walls is for the wall "
                << patches[patchi].name() << nl
                << "Walls: " << flatOutput(walls) << exit(FatalIOError);
        }
        const dictionary& d = *settings[patchi];
        kinds_[patchi] =
            kind(types.find(getWordOf(d, "type", "", types)));
        if (kinds_[patchi] == hardSphere)
        {
            lawOf_[patchi] = label(hardSpheres_.size());
            hardSpheres_.push_back(reboundEntries::hardSphere(d));
        }
        else if (kinds_[patchi] == semiEmpirical)
        {
            lawOf_[patchi] = label(semiEmpiricals_.size());
            semiEmpiricals_.push_back(reboundEntries::semiEmpirical(d));
        }
        else
        {
            refuseOthers(d, {"type"});
        }
    }
}


impact::vector3 Foam::solidWalls::rebound
(
    const label patchi,
    const impact::vector3& n,
    const scalar radius,
    const impact::vector3& velocity
) const
{
    const kind what = kinds_[patchi];
    if (what == specular)
    {
        return velocity - 2*dot(velocity, n)*n;
    }

    impact::sphereState s = {velocity, {0, 0, 0}};
    if (what == hardSphere)
    {
        hardSpheres_[lawOf_[patchi]].rebound(-n, radius, s);
    }
    else
    {
        semiEmpiricals_[lawOf_[patchi]].rebound(-n, radius, s);
    }
    const scalar minSpeed = 1e-9*mag(s.V);
    const scalar away = -dot(s.V, n);
    return away < minSpeed ? s.V - (minSpeed - away)*n : s.V;
}
