/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "solidWalls.H"
#include "checked.H"
#include "wallPatches.H"
#include "wallPolyPatch.H"
#include "wordRes.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::List<const Foam::dictionary*> Foam::solidWalls::settingsOf
(
    const dictionary& dict,
    const polyBoundaryMesh& patches
)
{
    wordList walls;
    for (const polyPatch& patch : patches)
    {
        if (isA<wallPolyPatch>(patch))
        {
            walls.append(patch.name());
        }
    }

    const dictionary* own = findBlock(dict, "walls");
    List<const dictionary*> settings(patches.size(), nullptr);

    // (a name goes before patterns)
    for (const bool names : {false, true})
    {
        for (const entry& e : own ? *own : dictionary::null)
        {
            const dictionary& d = getBlock(*own, e.keyword());
            bool found = false;
            forAll(patches, patchi)
            {
                const word& name = patches[patchi].name();
                if (!walls.found(name))
                {
                    continue;
                }
                const bool named = name == e.keyword();
                if (!named && !wordRe(e.keyword()).match(name))
                {
                    continue;
                }
                found = true;
                if
                (
                    !names && !named && settings[patchi]
                 && !own->found(name, keyType::LITERAL)
                )
                {
                    refuse
                    (
                        *own, "walls", e.keyword(),
                        "one pattern for the wall ", name,
                        ", or an entry of its name"
                    );
                }
                if (names == named)
                {
                    settings[patchi] = &d;
                }
            }
            if (!found)
            {
                unknownWord(*own, "wall", e.keyword(), walls);
            }
        }
    }
    for (const word& name : walls)
    {
        if (!settings[patches.findPatchID(name)])
        {
            FatalIOErrorInFunction(dict)
                << "No entry of walls is for the wall " << name << nl
                << "Walls: " << flatOutput(walls) << exit(FatalIOError);
        }
    }
    return settings;
}


void Foam::solidWalls::addModel
(
    const word& model,
    const wordList& types,
    const dictionary& dict,
    const List<const dictionary*>& settings,
    const scalarList& diameters,
    const label seed
)
{
    dictionary patches;
    forAll(settings, patchi)
    {
        const word type
        (
            settings[patchi] ? settings[patchi]->get<word>("type") : word()
        );
        if (!types.found(type))
        {
            continue;
        }
        modelOf_[patchi] = models_.size();
        isOpen_[patchi] = type == "escape";
        dictionary own(*settings[patchi]);
        own.remove("type");
        if (type != model)
        {
            refuseOthers(*settings[patchi], {"type"});
            own.add("type", word(type == "stick" ? "capture" : type));
        }
        if (type == "specular")
        {
            own.set("type", word("rebound"));
            own.add("restitution", 1);
            own.add("friction", 0);
        }
        patches.add(cloud_.pMesh().boundaryMesh()[patchi].name(), own);
    }
    if (patches.empty())
    {
        return;
    }

    // As the dictionary of a cloud has it
    dictionary coeffs;
    coeffs.add("patches", patches);
    if (model == "nonSphericalRebound" || model == "jkrAdhesion")
    {
        coeffs.add("seed", seed);
    }
    if (model == "jkrAdhesion")
    {
        coeffs.add("sizeClasses", between(diameters, dict));
    }

    dictionary all;
    all.add("patchInteractionModel", model);
    all.add(word(model + "Coeffs"), coeffs);
    dictionary& copied = all.subDict(model + "Coeffs");
    wallPatches::rename(copied, dict.name() + ".walls");
    wallPatches::rename(copied.subDict("patches"), copied.name());
    models_.append(PatchInteractionModel<solidCloud>::New(all, cloud_));
}


Foam::scalarList Foam::solidWalls::between
(
    const scalarList& diameters,
    const dictionary& dict
)
{
    scalarList sizes(diameters);
    Foam::sort(sizes);
    scalarList bounds;
    for (label i = 1; i < sizes.size(); ++i)
    {
        if (sizes[i] > sizes[i - 1])
        {
            bounds.append(sqrt(sizes[i]*sizes[i - 1]));
        }
    }
    if (bounds.size() > 15)
    {
        FatalIOErrorInFunction(dict)
            << "A wall of type jkrAdhesion takes particles of 16 sizes at"
            << " most, groups has " << bounds.size() + 1
            << exit(FatalIOError);
    }
    return bounds;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::solidWalls::solidWalls
(
    const dictionary& dict,
    solidCloud& cloud,
    const scalarList& diameters,
    const label seed
)
:
    cloud_(cloud),
    modelOf_(cloud.pMesh().boundaryMesh().size(), -1),
    isOpen_(modelOf_.size(), false)
{
    const List<const dictionary*> settings
    (
        settingsOf(dict, cloud.pMesh().boundaryMesh())
    );
    const wordList types
    {
        "specular", "hardSphereWall", "semiEmpiricalRebound",
        "nonSphericalRebound", "jkrAdhesion", "stick", "escape"
    };
    Info<< "Walls of the solid particles:" << nl;
    forAll(settings, patchi)
    {
        if (settings[patchi])
        {
            Info<< "    " << cloud.pMesh().boundaryMesh()[patchi].name() << ": "
                << getWordOf(*settings[patchi], "type", "", types) << nl;
        }
    }
    Info<< endl;

    // The three that are no models are cases of the first one
    addModel
    (
        "hardSphereWall", {"hardSphereWall", "specular", "stick", "escape"},
        dict, settings, diameters, seed
    );
    for (const label i : {2, 3, 4})
    {
        addModel(types[i], {types[i]}, dict, settings, diameters, seed);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::solidWalls::giveSpin
(
    const dictionary& dict,
    const polyBoundaryMesh& patches
)
{
    const wordList others{"specular", "stick", "escape"};
    for (const dictionary* d : settingsOf(dict, patches))
    {
        if (!d || others.found(d->getOrDefault<word>("type", "")))
        {
            continue;
        }
        const entry* friction = d->findEntry("friction", keyType::LITERAL);
        const ITstream* value =
            friction && friction->isStream() ? &friction->stream() : nullptr;
        const bool none =
            value && value->size() && (*value)[0].isNumber()
         && (*value)[0].number() == 0;
        if (!none)
        {
            return true;
        }
    }
    return false;
}


Foam::solidWalls::fate Foam::solidWalls::meet
(
    solidParcel& p,
    const label patchi,
    const vector& n,
    const vector& Uw
)
{
    cloud_.setWall(n, Uw);
    bool keep = true;
    models_[modelOf_[patchi]].correct
    (
        p, cloud_.pMesh().boundaryMesh()[patchi], keep
    );
    if (!keep)
    {
        return isOpen_[patchi] ? leaves : stays;
    }

    const vector V(p.U() - Uw);
    const scalar least = 1e-9*mag(V);
    const scalar away = -(V & n);
    if (away < least)
    {
        p.U() -= (least - away)*n;
    }
    return rebounds;
}
