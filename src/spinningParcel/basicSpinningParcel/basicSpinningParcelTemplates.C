/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "Cloud.H"
#include "IOField.H"
#include "ParcelMotion.H"
#include "forceSuSp.H"
#include "meshTools.H"
#include "rotationalTorque.H"
#include "transform.H"
#include "wedgePolyPatch.H"

#include <type_traits>
#include <utility>

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

template<class TrackCloudType>
void Foam::basicSpinningParcel::giveToGas
(
    TrackCloudType& cloud,
    const scalar massEff,
    const vector& U0,
    const vector& omega0,
    const vector& impulse,
    const scalar heat,
    const bool momentum
) const
{
    // m (U^2 - U0^2)/2 is the product of m (U - U0) with the mean velocity
    const vector taken = massEff*(U_ - U0) - impulse;
    const label celli = cell();
    const scalar n = nParticle_;

    cloud.ETrans()[celli] -=
        n
       *(
            (taken & 0.5*(U0 + U_))
          + momentOfInertia()*((omega_ - omega0) & 0.5*(omega0 + omega_))
          + heat
        );

    if (momentum)
    {
        vector dUTrans = -taken;
        const polyMesh& mesh = cloud.pMesh();
        meshTools::constrainDirection(mesh, mesh.solutionD(), dUTrans);
        cloud.UTrans()[celli] += n*dUTrans;
    }
}


template<class TrackCloudType>
void Foam::basicSpinningParcel::calc
(
    TrackCloudType& cloud,
    trackingData& td,
    const scalar dt
)
{
    const bool coupled = cloud.solution().coupled();
    if (!td.rotation && !coupled && !td.heated)
    {
        ParcelType::calc(cloud, td, dt);
        return;
    }

    const vector U0 = U_;
    const vector omega0 = omega_;
    const scalar mass = this->mass();
    scalar massEff = mass;
    vector impulse(Zero);
    if (coupled)
    {
        impulse = dt*cloud.forces().calcNonCoupled
        (
            *this, td, dt, mass, Re(td), td.muc()
        ).Su();
        massEff = cloud.forces().massEff(*this, td, mass);
    }

    ParcelType::calc(cloud, td, dt);

    if (td.rotation && cloud.torque())
    {
        typedef impact::rotationalTorque law;
        const vector W = omega_ - td.halfCurl;
        const scalar ReOmega =
            law::ReOmega(d_, td.rhoc(), td.muc(), mag(W));
        const scalar t = dt*law::scale(d_, rho_, td.muc());
        omega_ = td.halfCurl + law::remaining(ReOmega, t)*W;
        ++td.counts.torque;
        td.counts.torqueOutside += !law::inRange(ReOmega);
    }

    scalar heat = 0;
    if (td.heated)
    {
        impact::sphereHeat sphere(cloud.heat().sphere());
        sphere.sphere(d_, rho_);
        const impact::gasState gas
        {
            toCore(td.Uc()), toCore(td.halfCurl), td.rhoc(), td.muc(),
            td.gasTemperature
        };
        const scalar T0 = T_;
        const scalar h0 = sphere.material().h(T0);
        impact::thermalRate rate;
        sphere(gas, toCore(U_), T0, h0, rate);
        T_ = sphere.material().T
        (
            rate.kHeat*dt > 1e-12
          ? h0 - std::expm1(-rate.kHeat*dt)*rate.hDot/rate.kHeat
          : h0 + dt*rate.hDot
        );
        heat = takeHeat(cloud, sphere, T0, rate.kHeat, dt);
    }

    if (coupled)
    {
        // The stock parcel has given the momentum already
        giveToGas(cloud, massEff, U0, omega0, impulse, heat, false);
    }
}


template<class TrackCloudType>
bool Foam::basicSpinningParcel::hitPatch
(
    TrackCloudType& cloud,
    trackingData& td
)
{
    if constexpr (TrackCloudType::planned)
    {
        // Motion without effects ends here
        td.switchProcessor = true;
        return true;
    }
    else
    {
        const vector U0(U());
        const vector n(normalised(mesh().faceAreas()[face()]));
        const bool done = ParcelType::hitPatch(cloud, td);

        // The eddy of a parcel that has been thrown back is as if seen in a
        // mirror, as at a symmetry plane: else it would press the parcel to
        // the wall for as long as it lives
        if (((U() - U0) & n) < 0)
        {
            UTurb_ = transform(I - 2*sqr(n), UTurb_);
        }

        // Wall laws evaluated without spin may have left one
        if (!td.rotation)
        {
            omega_ = Zero;
        }
        return done;
    }
}


template<class TrackCloudType>
void Foam::basicSpinningParcel::hitWedgePatch
(
    TrackCloudType& cloud,
    trackingData&
)
{
    if (!cloud.embeddedMotion())
    {
        // It draws parcels back to the middle plane in each sub-step
        FatalErrorInFunction
            << "A spinning parcel meets the axis or a plane of a wedge at "
            << position() << ", which motion stock does not pass"
            << " rightly. Use motion embeddedRK54 in its solution"
            << exit(FatalError);
    }

    const polyMesh& mesh = this->mesh();
    const polyBoundaryMesh& patches = mesh.boundaryMesh();
    const label here = patches.whichPatch(face());
    label there = -1;
    for (const label facei : mesh.cells()[cell()])
    {
        const label patchi = patches.whichPatch(facei);
        if
        (
            patchi >= 0 && patchi != here
         && isA<wedgePolyPatch>(patches[patchi])
        )
        {
            there = patchi;
        }
    }
    if (there < 0)
    {
        FatalErrorInFunction
            << "Cell " << cell() << " at " << mesh.cellCentres()[cell()]
            << " lies at the wedge "
            << patches[here].name() << " and at no other. Valid: wedges of one"
            << " layer of cells" << exit(FatalError);
    }
    const vector n = normalised(patches[here].faceAreas()[0]);
    const vector m = normalised(patches[there].faceAreas()[0]);
    const point x = position();
    const scalar toHere = n & (patches[here].faceCentres()[0] - x);
    const scalar toThere = m & (patches[there].faceCentres()[0] - x);

    // The axis of both planes where it is nearest
    const scalar nm = n & m;
    const point axis =
        x
      + ((toHere - nm*toThere)*n + (toThere - nm*toHere)*m)/(1 - sqr(nm));

    const scalar reach = 1e-9*sqrt(mag(mesh.faceAreas()[face()]));
    point to;
    if (mag(toThere) > reach)
    {
        if ((U() & n) <= 0)
        {
            return;
        }
        const tensor R = rotationTensor(n, -m);
        to = axis + (R & (x - axis));
        transformProperties(R);
    }
    else
    {
        // Its azimuth is rounding: it is past the axis, and goes out from there
        // in the middle of the sector with the velocity about the axis that it
        // has. On the planes it would be at the next at once
        const vector outward = -normalised(n + m);
        const vector along = normalised(n ^ m);
        const scalar r = mag(x - axis);
        const vector e = r > VSMALL ? (x - axis)/r : outward;
        const vector w = U() - (U() & along)*along;
        const vector v =
            mag(w & e)*outward + (w & (along ^ e))*(along ^ outward);
        to = axis + max(r, reach)*outward;
        transformProperties(Ra(along, std::atan2(along & (w ^ v), w & v)));
    }
    const convexCells& cells = cloud.cells();
    const label celli = cells.locate(cell(), toCore(to));
    tetPlace::put(*this, cells, toCore(to), celli, -1);
}


template<class TrackCloudType>
bool Foam::basicSpinningParcel::move
(
    TrackCloudType& cloud,
    trackingData& td,
    const scalar trackTime
)
{
    if (!cloud.embeddedMotion())
    {
        return ParcelType::move(cloud, td, trackTime);
    }
    if (cloud.solution().coupled() && !cloud.inMotion())
    {
        // The gas is that of the exchange only in the step of all parcels
        td.keepParticle = true;
        td.switchProcessor = false;
        return true;
    }
    return cloud.withForce
    (
        [&](auto& force)
        {
            typedef std::remove_reference_t<decltype(force)> forceType;
            return ParcelMotion<TrackCloudType, forceType>
            (
                cloud, td, force, *this, trackTime
            ).move();
        }
    );
}


template<class Visitor>
void Foam::basicSpinningParcel::visitFields(Visitor&& visit)
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


template<class CloudType>
void Foam::basicSpinningParcel::readFields(CloudType& c)
{
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


template<class CloudType, class Value>
void Foam::basicSpinningParcel::writeField
(
    const CloudType& c,
    const word& name,
    const Value& value
)
{
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


template<class CloudType>
void Foam::basicSpinningParcel::writeFields(const CloudType& c)
{
    // One by one: the function of the kinematic parcel has all of its fields
    // in memory at the same time
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


template<class CloudType>
void Foam::basicSpinningParcel::readObjects
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


template<class CloudType>
void Foam::basicSpinningParcel::writeObjects
(
    const CloudType& c,
    objectRegistry& obr
)
{
    ParcelType::writeObjects(c, obr);

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
