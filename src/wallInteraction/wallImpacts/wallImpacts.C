/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "wallImpacts.H"

namespace Foam
{
    defineTypeNameAndDebug(wallImpacts, 0);
}


Foam::wallImpacts::wallImpacts(const IOobject& io)
:
    regIOobject(io)
{}


Foam::wallImpacts& Foam::wallImpacts::New(const cloud& c)
{
    if (!c.foundObject<wallImpacts>(typeName))
    {
        regIOobject::store
        (
            new wallImpacts
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
    return c.lookupObjectRef<wallImpacts>(typeName);
}


void Foam::wallImpacts::publishes(const label patchi)
{
    if (patchi >= published_.size())
    {
        published_.setSize(patchi + 1, false);
    }
    published_[patchi] = true;
}


void Foam::wallImpacts::add(wallImpactListener& listener)
{
    remove(listener);
    listeners_.append(&listener);
}


void Foam::wallImpacts::remove(wallImpactListener& listener)
{
    label n = 0;
    for (wallImpactListener* other : listeners_)
    {
        if (other != &listener)
        {
            listeners_[n++] = other;
        }
    }
    listeners_.setSize(n);
}
