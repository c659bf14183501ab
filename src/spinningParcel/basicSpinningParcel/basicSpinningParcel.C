/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "basicSpinningParcel.H"
#include "IOstreams.H"
#include "meshTools.H"
#include "transform.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    defineTypeNameAndDebug(basicSpinningParcel, 0);
}


Foam::string Foam::basicSpinningParcel::propertyList_ =
    Foam::basicSpinningParcel::propertyList();


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::basicSpinningParcel::basicSpinningParcel
(
    const basicSpinningParcel& p,
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


Foam::basicSpinningParcel::basicSpinningParcel
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


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::basicSpinningParcel::transformProperties(const tensor& T)
{
    ParcelType::transformProperties(T);
    omega_ = det(T)*transform(T, omega_);
    UTurb_ = transform(T, UTurb_);

    // On the other side of a period its coordinates say where it is
    convexCell_ = -1;
}


void Foam::basicSpinningParcel::locate
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
        celli = cells.locate(cell(), x);
        return;
    }
    const polyMesh& mesh = cells.mesh();
    point at = ParcelType::position();
    if (mesh.nSolutionD() != 3)
    {
        meshTools::constrainToMeshCentre(mesh, at);
    }
    x = toCore(at);
    celli = cells.locate(cell(), x);
}


void Foam::basicSpinningParcel::writeProperties
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


// * * * * * * * * * * * * * * * Friend Operators  * * * * * * * * * * * * * //

Foam::Ostream& Foam::operator<<
(
    Ostream& os,
    const basicSpinningParcel& p
)
{
    os << static_cast<const basicSpinningParcel::ParcelType&>(p);
    const bool ascii = os.format() == IOstream::ASCII;
    basicSpinningParcel::visitTransferred(p, [&](const auto& value)
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
