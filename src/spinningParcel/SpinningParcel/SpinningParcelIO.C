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
        if (is.format() == IOstream::ASCII)
        {
            is >> omega_ >> T_ >> x_.x >> x_.y >> x_.z >> convexCell_
                >> nImpacts_ >> nEddies_;
        }
        else if (!is.checkLabelSize<label>() || !is.checkScalarSize<scalar>())
        {
            is.beginRawRead();
            readRawScalar(is, omega_.data(), vector::nComponents);
            readRawScalar(is, &T_);
            readRawScalar(is, &x_.x, 3);
            readRawLabel(is, &convexCell_);
            readRawLabel(is, &nImpacts_);
            readRawLabel(is, &nEddies_);
            is.endRawRead();
        }
        else
        {
            is.read(reinterpret_cast<char*>(omega_.data()), sizeof(omega_));
            is.read(reinterpret_cast<char*>(&T_), sizeof(T_));
            is.read(reinterpret_cast<char*>(&x_), sizeof(x_));
            is.read
            (
                reinterpret_cast<char*>(&convexCell_), sizeof(convexCell_)
            );
            is.read(reinterpret_cast<char*>(&nImpacts_), sizeof(nImpacts_));
            is.read(reinterpret_cast<char*>(&nEddies_), sizeof(nEddies_));
        }
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

    // Written by later releases, and by clouds with heat transfer
    const auto optional = [&](const word& name, const auto& value)
    {
        take(name, value, IOobject::READ_IF_PRESENT);
    };
    foamCompat::visitLaterFields(optional);
    optional("T", [](auto& p) -> decltype(auto) { return p.temperature(); });
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

    const auto& omega = cloud::lookupIOField<vector>("omega", obr);
    const auto& nImpacts = cloud::lookupIOField<label>("nImpacts", obr);
    label i = 0;
    for (SpinningParcel<ParcelType>& p : c)
    {
        p.omega_ = omega[i];
        p.nImpacts_ = nImpacts[i];
        i++;
    }
    if (const auto* T = obr.findObject<IOField<scalar>>("T"))
    {
        i = 0;
        for (SpinningParcel<ParcelType>& p : c)
        {
            p.T_ = (*T)[i++];
        }
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

    auto& omega = cloud::createIOField<vector>("omega", c.size(), obr);
    auto& nImpacts = cloud::createIOField<label>("nImpacts", c.size(), obr);
    label i = 0;
    for (const SpinningParcel<ParcelType>& p : c)
    {
        omega[i] = p.omega_;
        nImpacts[i] = p.nImpacts_;
        i++;
    }
    if (hasTemperatures(c))
    {
        auto& T = cloud::createIOField<scalar>("T", c.size(), obr);
        i = 0;
        for (const SpinningParcel<ParcelType>& p : c)
        {
            T[i++] = p.T_;
        }
    }
}


template<class ParcelType>
Foam::Ostream& Foam::operator<<
(
    Ostream& os,
    const SpinningParcel<ParcelType>& p
)
{
    // Cells have other numbers elsewhere
    typedef typename SpinningParcel<ParcelType>::flight flight;
    const label cell = p.convexCell_ == -1 ? -1 : flight::passed;
    os << static_cast<const ParcelType&>(p);
    if (os.format() == IOstream::ASCII)
    {
        os  << token::SPACE << p.omega_
            << token::SPACE << p.T_
            << token::SPACE << p.x_.x
            << token::SPACE << p.x_.y
            << token::SPACE << p.x_.z
            << token::SPACE << cell
            << token::SPACE << p.nImpacts_
            << token::SPACE << p.nEddies_;
    }
    else
    {
        os.write
        (
            reinterpret_cast<const char*>(p.omega_.cdata()),
            sizeof(p.omega_)
        );
        os.write(reinterpret_cast<const char*>(&p.T_), sizeof(p.T_));
        os.write(reinterpret_cast<const char*>(&p.x_), sizeof(p.x_));
        os.write(reinterpret_cast<const char*>(&cell), sizeof(cell));
        os.write
        (
            reinterpret_cast<const char*>(&p.nImpacts_),
            sizeof(p.nImpacts_)
        );
        os.write
        (
            reinterpret_cast<const char*>(&p.nEddies_),
            sizeof(p.nEddies_)
        );
    }
    os.check(FUNCTION_NAME);
    return os;
}
