/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "wallPatches.H"
#include "checked.H"
#include "dictionaryEntry.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::wallPatches::readItems(const dictionary& dict)
{
    if (dict.isDict("patches"))
    {
        for (const entry& item : dict.subDict("patches"))
        {
            names_.append(item.keyword());
            settings_.append(new dictionary(item.dict()));
        }
        return;
    }

    ITstream& is = dict.lookup("patches");
    is.readBegin("patches");
    token next(is);
    while (next != token::END_LIST)
    {
        is.putBack(next);
        const dictionaryEntry item(dict, is);
        names_.append(item.keyword());
        settings_.append(new dictionary(item.dict()));

        // Read from the list's stream, it has a path of its own
        rename(settings_.last(), dict.name() + '.' + item.keyword());
        is.read(next);
    }
}


void Foam::wallPatches::rename(dictionary& dict, const fileName& name)
{
    dict.name() = name;
    for (entry& e : dict)
    {
        if (e.isDict())
        {
            rename(e.dict(), name + '.' + e.keyword());
        }
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::wallPatches::wallPatches
(
    const dictionary& dict,
    const polyBoundaryMesh& boundary,
    const word& model,
    bool complete
)
:
    ofPatch_(boundary.nNonProcessor(), -1)
{
    // Processor patches differ from rank to rank and are no walls
    wordList valid;
    forAll(ofPatch_, patchi)
    {
        if (!polyPatch::constraintType(boundary[patchi].type()))
        {
            valid.append(boundary[patchi].name());
        }
    }

    if (valid.empty())
    {
        FatalIOErrorInFunction(dict)
            << "Entry patchInteractionModel " << model << ": the mesh has no"
            << " patch that parcels could rebound from." << nl
            << "Valid: patchInteractionModel none" << exit(FatalIOError);
    }
    readItems(dict);
    const char* remedy =
        " With patchInteractionModel multiInteraction and oneInteractionOnly"
        " false a stock localInteraction beside this model can hold parcels"
        " there";
    forAll(settings_, number)
    {
        const keyType& name = names_[number];
        bool found = false;
        DynamicList<word> passed;
        for (const label patchi : boundary.indices(name, true))
        {
            if (patchi >= ofPatch_.size())
            {
                continue;
            }
            const polyPatch& patch = boundary[patchi];
            if (polyPatch::constraintType(patch.type()))
            {
                if (!name.isPattern() && name == patch.name())
                {
                    refuse
                    (
                        dict, "patches", name, listed(valid).c_str(),
                        ": this model leaves patches of type ", patch.type(),
                        " as they are.", remedy
                    );
                }
                passed.append(patch.name());
                continue;
            }
            if (ofPatch_[patchi] != -1)
            {
                refuse
                (
                    dict, "patches", name, "one law to a patch: ",
                    patch.name(), " is matched twice, by item ",
                    ofPatch_[patchi] + 1, " and by item ", number + 1
                );
            }
            ofPatch_[patchi] = number;
            found = true;
        }
        if (!found)
        {
            unknownWord(dict, "patches", name, valid);
        }
        if (passed.size() && name != ".*")
        {
            IOWarningInFunction(dict)
                << "Entry patches " << name << ", model " << model
                << ": cyclic patches, symmetry planes and others of their kind"
                << " stay what they are, among them " << passed << '.'
                << remedy << nl << endl;
        }
    }
    if (settings_.empty())
    {
        refuse
        (
            dict, "patches", "()", "at least one of ", listed(valid).c_str()
        );
    }

    wordList missing;
    forAll(ofPatch_, patchi)
    {
        if
        (
            ofPatch_[patchi] == -1
         && !polyPatch::constraintType(boundary[patchi].type())
        )
        {
            missing.append(boundary[patchi].name());
        }
    }
    if (complete && !missing.empty())
    {
        FatalIOErrorInFunction(dict)
            << "Entry patches of " << model << " lacks the patches "
            << listed(missing).c_str() << ": what happens there? Give them the"
            << " law or one of 'type escape;' and 'type capture;', or use the"
            << " model within multiInteraction" << exit(FatalIOError);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

const Foam::dictionary& Foam::wallPatches::law(const dictionary& settings)
{
    if (settings.empty())
    {
        FatalIOErrorInFunction(settings)
            << "Entry type is missing, and there is no law" << nl
            << "Valid: the law, 'type escape;' or 'type capture;'"
            << exit(FatalIOError);
    }
    return settings;
}
