/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "wallCounters.H"
#include "exactText.H"
#include "ListOps.H"
#include "PstreamReduceOps.H"
#include "ops.H"
#include "withheldOutput.H"

#include <algorithm>

namespace Foam
{
    defineTypeNameAndDebug(wallCounters, 0);
}


namespace
{

using namespace Foam;

List<string> exactTexts(const scalarList& numbers)
{
    List<string> texts(numbers.size());
    forAll(numbers, i)
    {
        texts[i] = exactText(numbers[i]);
    }
    return texts;
}


//- The same read, or the plain numbers of earlier versions; none if there is no
//  such entry
scalarList readTotals(const dictionary& stored, const word& entry)
{
    if (!stored.found(entry))
    {
        return scalarList();
    }
    const ITstream& is = stored.lookup(entry);
    if
    (
        std::none_of
        (
            is.begin(), is.end(), [](const token& t) { return t.isString(); }
        )
    )
    {
        return stored.get<scalarList>(entry);
    }
    const List<string> texts(stored.get<List<string>>(entry));
    scalarList totals(texts.size());
    forAll(texts, i)
    {
        totals[i] = exactNumber(texts[i]);
    }
    return totals;
}

} // End anonymous namespace


Foam::wallCounters::wallCounters(const IOobject& io)
:
    regIOobject(io)
{}


Foam::wallCounters& Foam::wallCounters::New(const cloud& c)
{
    if (!c.foundObject<wallCounters>(typeName))
    {
        regIOobject::store
        (
            new wallCounters
            (
                IOobject
                (
                    typeName,
                    c.time().timeName(),
                    c,
                    IOobject::NO_READ,
                    IOobject::NO_WRITE
                )
            )
        );
    }
    return c.lookupObjectRef<wallCounters>(typeName);
}


Foam::word Foam::wallCounters::declare
(
    const label patchi,
    const word& patch,
    const word& model,
    const bool nested,
    const bool open,
    const List<string>& specials
)
{
    if (patchi >= patches_.size())
    {
        patches_.resize(patchi + 1);
    }
    if (patches_.set(patchi))
    {
        return patches_[patchi].model;
    }
    patches_.set
    (
        patchi,
        new patchCounts
        {
            patch, model, nested, open, specials, counts(Zero), counts(Zero)
        }
    );
    return word();
}


Foam::wallCounters::fates Foam::wallCounters::ofRun() const
{
    fates f{0, -nReleased_};
    forAll(patches_, patchi)
    {
        if (patches_.set(patchi))
        {
            const patchCounts& p = patches_[patchi];
            f.escaped +=
                p.ofRun[escapedParcels] + p.sinceStored[escapedParcels];
            f.stuck +=
                p.ofRun[capturedParcels] + p.sinceStored[capturedParcels];
        }
    }
    return f;
}


void Foam::wallCounters::report
(
    Ostream& os,
    dictionary& properties,
    const bool nested,
    const bool store
)
{
    if (withheldOutput::now() && !store)
    {
        return;
    }
    forAll(patches_, patchi)
    {
        if (!patches_.set(patchi) || patches_[patchi].nested != nested)
        {
            continue;
        }
        patchCounts& p = patches_[patchi];
        dictionary& stored =
            properties.subDictOrAdd("patchInteractionModel")
           .subDictOrAdd(p.model);
        const word entry("wallCounters_" + p.patch);

        scalarList total(readTotals(stored, entry));
        total.resize(nQuantities, Zero);
        scalarList recent(p.sinceStored);
        Pstream::listCombineGather(recent, plusEqOp<scalar>());
        Pstream::listCombineScatter(recent);
        forAll(total, i)
        {
            total[i] += recent[i];
        }

        os  << "    Wall impacts: " << p.model << ", patch " << p.patch << nl;
        if (p.open)
        {
            os  << "      - escaped (number, mass)      = "
                << total[escapedParcels] << ", " << total[escapedMass] << nl;
        }
        else
        {
            os  << "      - hits                        = "
                << total[hits] << nl
                << "      - captured (number, mass)     = "
                << total[capturedParcels] << ", " << total[capturedMass]
                << nl
                << "      - energy lost (transl., rot.) = "
                << total[translationLost] << ", " << total[rotationLost]
                << nl;
            forAll(p.specials, i)
            {
                os  << "      - " << p.specials[i].c_str();
                for (label k = p.specials[i].size(); k < 28; ++k)
                {
                    os  << ' ';
                }
                os  << "= " << total[special + i] << nl;
            }
        }

        if (store)
        {
            stored.set(entry, exactTexts(total));
            forAll(p.ofRun, i)
            {
                p.ofRun[i] += p.sinceStored[i];
            }
            p.sinceStored = Zero;
        }
    }
    os  << flush;
}
