/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "Cloud.H"
#include "IOField.H"
#include "IOstreams.H"

#include <type_traits>
#include <utility>

template<class ParcelType>
Foam::string Foam::SpinningParcel<ParcelType>::propertyList_ =
    Foam::SpinningParcel<ParcelType>::propertyList();


template<class ParcelType>
Foam::SpinningParcel<ParcelType>::SpinningParcel
(
    const polyMesh& mesh,
    Istream& is,
    bool readFields,
    bool newFormat
)
:
    ParcelType(mesh, is, readFields, newFormat)
{
    if (readFields)
    {
        const bool ascii = is.format() == IOstream::ASCII;
        visitTransferred(*this, [&](auto& value)
        {
            if (ascii)
            {
                is >> value;
            }
            else
            {
                is.read(reinterpret_cast<char*>(&value), sizeof(value));
            }
        });

        // Cells have other numbers elsewhere
        convexCell_ = convexCell_ == -1 ? -1 : label(flight::passed);
    }
    is.check(FUNCTION_NAME);
}


template<class ParcelType>
template<class Visitor>
void Foam::SpinningParcel<ParcelType>::visitFields(Visitor&& visit)
{
    #define visitField(name)                                                   \
        visit(#name, [](auto& p) -> decltype(auto) { return p.name(); })
    visitField(typeId);
    visitField(nParticle);
    visitField(d);
    visitField(dTarget);
    visitField(U);
    visitField(rho);
    visitField(age);
    visitField(tTurb);
    visitField(UTurb);
    visitField(omega);
    visitField(nImpacts);
    #undef visitField
}


template<class ParcelType>
template<class CloudType>
void Foam::SpinningParcel<ParcelType>::readFields(CloudType& c)
{
    typedef SpinningParcel<ParcelType> parcel;
    const bool valid = c.size();
    particle::readFields(c);

    const auto read =
        [&](IOobject&& header, const auto& empty, const auto& set)
    {
        IOField<std::decay_t<decltype(empty)>> field(header, valid);
        if (header.readOpt() == IOobject::MUST_READ || field.size())
        {
            c.checkFieldIOobject(c, field);
            label i = 0;
            for (parcel& p : c)
            {
                set(p, field[i++]);
            }
        }
    };
    read
    (
        c.fieldIOobject("active", IOobject::MUST_READ), label(),
        [](parcel& p, const label value) { p.active(value); }
    );
    const auto take = [&](const word& name, const auto& value, const auto opt)
    {
        typedef std::decay_t<decltype(value(std::declval<parcel&>()))> Type;
        read
        (
            c.fieldIOobject(name, opt), Type(),
            [&](parcel& p, const Type& x) { value(p) = x; }
        );
    };

    // Parcels of a stock cloud have no spin and have struck nothing
    const auto there = [&](const word& name)
    {
        return valid && isFile
        (
            c.fieldIOobject(name, IOobject::MUST_READ).objectPath()
        );
    };
    const bool spinning =
        returnReduce(there("omega") || there("nImpacts"), orOp<bool>());
    visitFields([&](const word& name, const auto& value)
    {
        const bool ours = name == "omega" || name == "nImpacts";
        take
        (
            name,
            value,
            ours && !spinning
          ? IOobject::READ_IF_PRESENT
          : IOobject::MUST_READ
        );
    });

    // Written by later releases, and by clouds with heat transfer or eddies
    const auto optional = [&](const word& name, const auto& value)
    {
        take(name, value, IOobject::READ_IF_PRESENT);
    };
    foamCompat::visitLaterFields(optional);
    optional("T", [](auto& p) -> decltype(auto) { return p.temperature(); });
    optional("nEddies", [](auto& p) -> decltype(auto) { return p.nEddies(); });
}


template<class ParcelType>
template<class CloudType, class Value>
void Foam::SpinningParcel<ParcelType>::writeField
(
    const CloudType& c,
    const word& name,
    const Value& value
)
{
    typedef SpinningParcel<ParcelType> parcel;
    IOField<std::decay_t<decltype(value(std::declval<const parcel&>()))>> field
    (
        c.fieldIOobject(name, IOobject::NO_READ), c.size()
    );
    label i = 0;
    for (const parcel& p : c)
    {
        field[i++] = value(p);
    }
    field.write(c.size() > 0);
}


template<class ParcelType>
template<class CloudType>
void Foam::SpinningParcel<ParcelType>::writeFields(const CloudType& c)
{
    // One by one: the function of the kinematic parcel has all of its fields
    // in memory at the same time
    typedef SpinningParcel<ParcelType> parcel;
    const auto write = [&](const word& name, const auto& value)
    {
        writeField(c, name, value);
    };
    write("active", [](const parcel& p) { return label(p.active()); });
    visitFields(write);
    foamCompat::visitLaterFields(write);
    if (hasTemperatures(c))
    {
        write("T", [](const parcel& p) { return p.temperature(); });
    }
}


template<class ParcelType>
void Foam::SpinningParcel<ParcelType>::writeProperties
(
    Ostream& os,
    const wordRes& filters,
    const word& delim,
    const bool namesOnly
) const
{
    ParcelType::writeProperties(os, filters, delim, namesOnly);
    ParcelType::writeProperty(os, "omega", omega_, namesOnly, delim, filters);
    ParcelType::writeProperty(os, "T", T_, namesOnly, delim, filters);
    ParcelType::writeProperty
    (
        os, "nImpacts", nImpacts_, namesOnly, delim, filters
    );
}


template<class ParcelType>
template<class CloudType>
void Foam::SpinningParcel<ParcelType>::readObjects
(
    CloudType& c,
    const objectRegistry& obr
)
{
    ParcelType::readObjects(c, obr);
    if (!c.size())
    {
        return;
    }

    typedef SpinningParcel<ParcelType> parcel;
    const auto take = [&](const auto& values, auto parcel::* member)
    {
        label i = 0;
        for (parcel& p : c)
        {
            p.*member = values[i++];
        }
    };
    take(cloud::lookupIOField<vector>("omega", obr), &parcel::omega_);
    take(cloud::lookupIOField<label>("nImpacts", obr), &parcel::nImpacts_);
    if (const auto* T = obr.findObject<IOField<scalar>>("T"))
    {
        take(*T, &parcel::T_);
    }
}


template<class ParcelType>
template<class CloudType>
void Foam::SpinningParcel<ParcelType>::writeObjects
(
    const CloudType& c,
    objectRegistry& obr
)
{
    ParcelType::writeObjects(c, obr);

    typedef SpinningParcel<ParcelType> parcel;
    const auto give = [&](const word& name, auto parcel::* member)
    {
        typedef std::decay_t<decltype(std::declval<parcel>().*member)> Type;
        auto& values = cloud::createIOField<Type>(name, c.size(), obr);
        label i = 0;
        for (const parcel& p : c)
        {
            values[i++] = p.*member;
        }
    };
    give("omega", &parcel::omega_);
    give("nImpacts", &parcel::nImpacts_);
    if (hasTemperatures(c))
    {
        give("T", &parcel::T_);
    }
}


template<class ParcelType>
Foam::Ostream& Foam::operator<<
(
    Ostream& os,
    const SpinningParcel<ParcelType>& p
)
{
    os << static_cast<const ParcelType&>(p);
    const bool ascii = os.format() == IOstream::ASCII;
    SpinningParcel<ParcelType>::visitTransferred(p, [&](const auto& value)
    {
        if (ascii)
        {
            os << token::SPACE << value;
        }
        else
        {
            os.write(reinterpret_cast<const char*>(&value), sizeof(value));
        }
    });
    os.check(FUNCTION_NAME);
    return os;
}
