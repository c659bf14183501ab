/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "SpinningParcel.H"
#include "ParcelMotion.H"
#include "forceSuSp.H"
#include "meshTools.H"
#include "rotationalTorque.H"
#include "transform.H"
#include "wedgePolyPatch.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

template<class ParcelType>
Foam::SpinningParcel<ParcelType>::SpinningParcel
(
    const SpinningParcel<ParcelType>& p,
    const polyMesh& mesh
)
:
    ParcelType(p, mesh),
    omega_(p.omega_),
    T_(p.T_),
    x_(p.x_),
    convexCell_(p.convexCell_),
    nImpacts_(p.nImpacts_),
    nEddies_(p.nEddies_)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

template<class ParcelType>
template<class TrackCloudType>
void Foam::SpinningParcel<ParcelType>::giveToGas
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
    const vector taken = massEff*(this->U_ - U0) - impulse;
    const label celli = this->cell();
    const scalar n = this->nParticle_;

    cloud.ETrans()[celli] -=
        n
       *(
            (taken & 0.5*(U0 + this->U_))
          + this->momentOfInertia()*((omega_ - omega0) & 0.5*(omega0 + omega_))
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


template<class ParcelType>
template<class TrackCloudType>
void Foam::SpinningParcel<ParcelType>::calc
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

    typedef typename TrackCloudType::parcelType parcelType;
    const parcelType& p = static_cast<const parcelType&>(*this);
    const typename parcelType::trackingData& ttd =
        static_cast<const typename parcelType::trackingData&>(td);

    const vector U0 = this->U_;
    const vector omega0 = omega_;
    const scalar mass = this->mass();
    scalar massEff = mass;
    vector impulse(Zero);
    if (coupled)
    {
        impulse = dt*cloud.forces().calcNonCoupled
        (
            p,
            ttd,
            dt,
            mass,
            this->Re(td),
            td.muc()
        ).Su();
        massEff = cloud.forces().massEff(p, ttd, mass);
    }

    ParcelType::calc(cloud, td, dt);

    if (td.rotation && cloud.torque())
    {
        typedef impact::rotationalTorque law;
        const vector W = omega_ - td.halfCurl;
        const scalar ReOmega =
            law::ReOmega(this->d_, td.rhoc(), td.muc(), mag(W));
        const scalar t = dt*law::scale(this->d_, this->rho_, td.muc());
        omega_ = td.halfCurl + law::remaining(ReOmega, t)*W;
        ++td.counts.torque;
        td.counts.torqueOutside += !law::inRange(ReOmega);
    }

    scalar heat = 0;
    if (td.heated)
    {
        impact::sphereHeat sphere(cloud.heat().sphere());
        sphere.sphere(this->d_, this->rho_);
        const impact::gasState gas
        {
            toCore(td.Uc()), toCore(td.halfCurl), td.rhoc(), td.muc(),
            td.gasTemperature
        };
        const scalar T0 = T_;
        const scalar h0 = sphere.material().h(T0);
        impact::thermalRate rate;
        sphere(gas, toCore(this->U_), T0, h0, rate);
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


template<class ParcelType>
template<class TrackCloudType>
bool Foam::SpinningParcel<ParcelType>::hitPatch
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
        const vector U0(this->U());
        const vector n(normalised(this->mesh().faceAreas()[this->face()]));
        const bool done = ParcelType::hitPatch(cloud, td);

        // The eddy of a parcel that has been thrown back is as if seen in a
        // mirror, as at a symmetry plane: else it would press the parcel to
        // the wall for as long as it lives
        if (((this->U() - U0) & n) < 0)
        {
            this->UTurb_ = transform(I - 2*sqr(n), this->UTurb_);
        }

        // Wall laws evaluated without spin may have left one
        if (!td.rotation)
        {
            omega_ = Zero;
        }
        return done;
    }
}


template<class ParcelType>
template<class TrackCloudType>
void Foam::SpinningParcel<ParcelType>::hitWedgePatch
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
            << this->position() << ", which motion stock does not pass"
            << " rightly. Use motion embeddedRK54 in its solution"
            << exit(FatalError);
    }

    const polyMesh& mesh = this->mesh();
    const polyBoundaryMesh& patches = mesh.boundaryMesh();
    const label here = patches.whichPatch(this->face());
    label there = -1;
    for (const label facei : mesh.cells()[this->cell()])
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
            << "Cell " << this->cell() << " at "
            << mesh.cellCentres()[this->cell()] << " lies at the wedge "
            << patches[here].name() << " and at no other. Valid: wedges of one"
            << " layer of cells" << exit(FatalError);
    }
    const vector n = normalised(patches[here].faceAreas()[0]);
    const vector m = normalised(patches[there].faceAreas()[0]);
    const point x = this->position();
    const scalar toHere = n & (patches[here].faceCentres()[0] - x);
    const scalar toThere = m & (patches[there].faceCentres()[0] - x);

    // The axis of both planes where it is nearest
    const scalar nm = n & m;
    const point axis =
        x
      + ((toHere - nm*toThere)*n + (toThere - nm*toHere)*m)/(1 - sqr(nm));

    const tensor R = rotationTensor(n, -m);
    const scalar reach = 1e-9*sqrt(mag(mesh.faceAreas()[this->face()]));
    if (mag(toThere) > reach)
    {
        if ((this->U() & n) > 0)
        {
            const point p = axis + (R & (x - axis));
            const convexCells& cells = cloud.cells();
            const label celli = cells.locate(this->cell(), toCore(p));
            tetPlace::put(*this, cells, toCore(p), celli, -1);
            transformProperties(R);
        }
        return;
    }

    // On the axis, out of which it goes where the sector is
    const tensor turn = (this->U() & n) > (this->U() & m) ? R : R.T();
    const auto goesOut = [&]
    {
        const scalar least = 1e-14*mag(this->U());
        return (this->U() & n) > least || (this->U() & m) > least;
    };
    for (label i = 0; i < 10000 && goesOut(); ++i)
    {
        transformProperties(turn);
    }
}


template<class ParcelType>
void Foam::SpinningParcel<ParcelType>::transformProperties(const tensor& T)
{
    ParcelType::transformProperties(T);
    omega_ = det(T)*transform(T, omega_);
    this->UTurb_ = transform(T, this->UTurb_);

    // On the other side of a period its coordinates say where it is
    convexCell_ = -1;
}


template<class ParcelType>
void Foam::SpinningParcel<ParcelType>::locate
(
    const convexCells& cells,
    impact::vector3& x,
    label& celli
) const
{
    if (convexCell_ >= 0)
    {
        x = x_;
        celli = convexCell_;
        return;
    }
    if (convexCell_ == flight::passed)
    {
        x = x_;
        celli = cells.locate(this->cell(), x);
        return;
    }
    const polyMesh& mesh = cells.mesh();
    point at = ParcelType::position();
    if (mesh.nSolutionD() != 3)
    {
        meshTools::constrainToMeshCentre(mesh, at);
    }
    x = toCore(at);
    celli = cells.locate(this->cell(), x);
}


template<class ParcelType>
template<class TrackCloudType>
bool Foam::SpinningParcel<ParcelType>::move
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
            typedef typename TrackCloudType::parcelType parcelType;
            return ParcelMotion<TrackCloudType, forceType>
            (
                cloud,
                static_cast<typename parcelType::trackingData&>(td),
                force,
                static_cast<parcelType&>(*this),
                trackTime
            ).move();
        }
    );
}


#include "SpinningParcelIO.C"
