/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "parcelGas.H"
#include "coreVector.H"
#include "fvcCurl.H"
#include "volPointInterpolation.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

template<class Type>
void Foam::parcelGas::pack
(
    const GeometricField<Type, fvPatchField, volMesh>& field,
    const Field<Type>& pointValues,
    const label offset
)
{
    const auto fill =
        [offset](std::vector<impact::gasState>& states, const Field<Type>& f)
        {
            for (std::size_t i = 0; i < states.size(); ++i)
            {
                double* to = &states[i].u.x + offset;
                for (direction d = 0; d < pTraits<Type>::nComponents; ++d)
                {
                    to[d] = component(f[label(i)], d);
                }
            }
        };
    fill(cells_, field.primitiveField());
    fill(points_, pointValues);
}


template<class Type>
void Foam::parcelGas::pack
(
    const GeometricField<Type, fvPatchField, volMesh>& field,
    const label offset
)
{
    // The name is that of the stock interpolation, which then shares the
    // cached point values
    const tmp<GeometricField<Type, pointPatchField, pointMesh>> tpoints
    (
        volPointInterpolation::New(mesh_).interpolate
        (
            field,
            "volPointInterpolate(" + field.name() + ')',
            true
        )
    );
    pack(field, tpoints().primitiveField(), offset);
}


void Foam::parcelGas::set(const scalar value, const label offset)
{
    for (auto* states : {&cells_, &points_})
    {
        for (impact::gasState& state : *states)
        {
            (&state.u.x)[offset] = value;
        }
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::parcelGas::parcelGas(const fvMesh& mesh)
:
    mesh_(mesh),
    walls_(nullptr),
    events_(-2)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

const Foam::volVectorField& Foam::parcelGas::halfCurl
(
    const volVectorField& U
)
{
    const word name("halfCurl(" + U.name() + ')');
    const objectRegistry& db = U.db();

    if (!db.foundObject<volVectorField>(name))
    {
        regIOobject::store(new volVectorField(name, 0.5*fvc::curl(U)));
    }

    volVectorField& result = db.lookupObjectRef<volVectorField>(name);
    if (!result.upToDate(U) || U.mesh().changing())
    {
        result = 0.5*fvc::curl(U);
        result.setUpToDate();
    }
    return result;
}


bool Foam::parcelGas::update
(
    const volVectorField& U,
    const volVectorField* halfCurl,
    const volScalarField& rho,
    const volScalarField& mu,
    const volScalarField* T
)
{
    FixedList<label, 5> events;
    events[0] = U.eventNo();
    events[1] = halfCurl ? halfCurl->eventNo() : -1;
    events[2] = rho.eventNo();
    events[3] = mu.eventNo();
    events[4] = T ? T->eventNo() : -1;
    if (events == events_ && !mesh_.changing())
    {
        return false;
    }
    events_ = events;

    cells_.resize(mesh_.nCells());
    points_.resize(mesh_.nPoints());
    wallGasVelocity& walls = wallGasVelocity::New(U);
    pack(U, walls.pointValues().primitiveField(), 0);
    if (halfCurl)
    {
        pack(*halfCurl, 3);
    }
    else
    {
        for (label i = 3; i < 6; ++i)
        {
            set(0, i);
        }
    }
    pack(rho, 6);
    pack(mu, 7);
    if (T)
    {
        pack(*T, 8);
    }
    else
    {
        set(1, 8);
    }

    walls_ = &walls;
    wallVertices_.resize(3*walls.nTriangles());
    for (label i = 0; i < walls.nTriangles(); ++i)
    {
        for (label j = 0; j < 3; ++j)
        {
            impact::gasState& state = wallVertices_[3*i + j];
            state = points_[walls[i].vertices[j]];
            const vector u(state.u.x, state.u.y, state.u.z);
            const vector bound = u + walls[i].at[j].lack(u);
            state.u = toCore(bound);
        }
    }
    return true;
}


void Foam::parcelGas::tetField::set(const parcelGas& gas, const particle& p)
{
    const polyMesh& mesh = p.mesh();
    const triFace tri(p.currentTetIndices().faceTriIs(mesh));
    values_[0] = &gas.cells_[p.cell()];
    gas.vertices(p, tri, values_ + 1);
    for (int i = 0; i < 4; ++i)
    {
        weights_[i] = p.coordinates()[i];
    }

    const point& centre = mesh.cellCentres()[p.cell()];
    const vector b = mesh.points()[tri[0]] - centre;
    const vector c = mesh.points()[tri[1]] - centre;
    const vector d = mesh.points()[tri[2]] - centre;
    start_ = centre + weights_[1]*b + weights_[2]*c + weights_[3]*d;
    const vector normals[3] = {c ^ d, d ^ b, b ^ c};
    const scalar volume = b & normals[0];

    // A flat tetrahedron has no gradient: its value holds throughout
    const bool flat =
        sqr(volume) <= 1e-24*magSqr(b)*magSqr(c)*magSqr(d);
    const scalar inverse = flat ? 0 : 1/volume;
    proper_ = !flat && volume > 0;
    for (int j = 0; j < 3; ++j)
    {
        slopes_[0][j] = 0;
        for (int i = 0; i < 3; ++i)
        {
            slopes_[i + 1][j] = inverse*normals[i][j];
            slopes_[0][j] -= slopes_[i + 1][j];
        }
    }
}


bool Foam::parcelGas::tetField::moveInside(particle& p, const vector& x) const
{
    if (!proper_)
    {
        return false;
    }
    double w[4];
    weights(toCore(x), w);
    if (!(min(min(w[0], w[1]), min(w[2], w[3])) > 0))
    {
        return false;
    }

    // Of sum 1, as the tracking leaves them
    const_cast<barycentric&>(p.coordinates()) =
        barycentric(1 - w[1] - w[2] - w[3], w[1], w[2], w[3]);
    p.face() = -1;
    return true;
}


double Foam::parcelGas::tetField::exit(const impact::vector3& x) const
{
    double w[4];
    weights(x, w);
    double share = GREAT;
    for (int i = 0; i < 4; ++i)
    {
        const double change = w[i] - weights_[i];
        if (change < -VSMALL)
        {
            share = min(share, max(0., weights_[i])/-change);
        }
    }
    return share;
}


impact::gasState Foam::parcelGas::at(const particle& p) const
{
    const triFace tri(p.currentTetIndices().faceTriIs(p.mesh()));
    const barycentric& y = p.coordinates();
    const double w[4] = {y[0], y[1], y[2], y[3]};
    const impact::gasState* values[3];
    vertices(p, tri, values);
    return impact::interpolate
    (
        cells_[p.cell()],
        *values[0],
        *values[1],
        *values[2],
        w
    );
}
