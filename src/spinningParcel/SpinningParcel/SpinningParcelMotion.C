/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "ParcelMotion.H"
#include "meshTools.H"
#include "tetPlace.H"

// * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * * * //

template<class ParcelType>
Foam::SpinningParcel<ParcelType>::place::place(const SpinningParcel& p)
:
    coordinates(p.coordinates()),
    cell(p.cell()),
    tetFace(p.tetFace()),
    tetPt(p.tetPt()),
    face(p.face()),
    stepFraction(p.stepFraction()),
    where(p.inFlight())
{}


template<class ParcelType>
void Foam::SpinningParcel<ParcelType>::place::restore(SpinningParcel& p) const
{
    const_cast<barycentric&>(p.coordinates()) = coordinates;
    p.cell() = cell;
    p.tetFace() = tetFace;
    p.tetPt() = tetPt;
    p.face() = face;
    p.stepFraction() = stepFraction;
    p.setFlight(where);
    foamCompat::forgetTrack(p);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

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
void Foam::SpinningParcel<ParcelType>::settle(const convexCells& cells)
{
    if (convexCell_ >= 0)
    {
        tetPlace::put(*this, cells, x_, convexCell_, -1);
    }
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
