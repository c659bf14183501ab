/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "cellGas.H"
#include "coreVector.H"
#include "emptyPolyPatch.H"
#include "fvcCurl.H"
#include "fvcDdt.H"
#include "interpolationCellLinear.H"
#include "trackingCells.H"
#include "wallGasVelocity.H"
#include "wedgePolyPatch.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

const Foam::wordList Foam::cellGas::schemes({"cellLinear", "cellPoint"});


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

template<class Type>
void Foam::cellGas::putGradients
(
    const GeometricField<Type, fvPatchField, volMesh>& q,
    const label offset
)
{
    constexpr direction n = pTraits<Type>::nComponents;
    const auto grad = interpolationCellLinear<Type>::gradient(q);
    forAll(q, celli)
    {
        field& f = cells_[celli];
        for (direction j = 0; j < n; ++j)
        {
            (&f.value.u.x)[offset + j] = component(q[celli], j);
            for (direction d = 0; d < 3; ++d)
            {
                f.slope[d][offset + j] = component(grad()[celli], n*d + j);
            }
        }
    }
}


template<class Type>
void Foam::cellGas::putValues
(
    const GeometricField<Type, fvPatchField, volMesh>& q,
    const Field<Type>& pointValues,
    const label offset
)
{
    const auto fill =
        [offset](std::vector<impact::gasState>& states, const Field<Type>& f)
        {
            forAll(f, i)
            {
                double* to = &states[i].u.x + offset;
                for (direction d = 0; d < pTraits<Type>::nComponents; ++d)
                {
                    to[d] = component(f[i], d);
                }
            }
        };
    fill(cellValues_, q.primitiveField());
    fill(pointValues_, pointValues);
}


Foam::labelList Foam::cellGas::choose(const UList<condition>& all)
{
    DynamicList<label> chosen;
    DynamicList<vector> axes;
    label next = 0;
    while (next >= 0 && next < all.size())
    {
        vector across = all[next].n;
        for (const vector& e : axes)
        {
            across -= (across & e)*e;
        }
        chosen.append(next);
        axes.append(normalised(across));

        // At least 30 degrees out of what is spanned
        scalar maxAcross = 0.5;
        next = -1;
        for (label i = 0; axes.size() < 3 && i < all.size(); ++i)
        {
            vector rest = all[i].n;
            for (const vector& e : axes)
            {
                rest -= (rest & e)*e;
            }
            // Of equals the first, whatever their rounding
            if (mag(rest) > maxAcross + 1e-6)
            {
                maxAcross = mag(rest);
                next = i;
            }
        }
    }
    return labelList(chosen);
}


void Foam::cellGas::bind(field& f, const UList<condition>& all)
{
    const labelList chosen(choose(all));

    // The normals, made a basis with directions across them all
    vector n[3] = {Zero, Zero, Zero};
    forAll(chosen, i)
    {
        n[i] = all[chosen[i]].n;
    }
    if (chosen.size() == 1)
    {
        direction smallest = 0;
        for (direction d = 1; d < 3; ++d)
        {
            if (mag(n[0][d]) < mag(n[0][smallest]))
            {
                smallest = d;
            }
        }
        vector axis(Zero);
        axis[smallest] = 1;
        n[1] = normalised(n[0] ^ axis);
    }
    if (chosen.size() < 3)
    {
        n[2] = normalised(n[0] ^ n[1]);
    }
    const scalar volume = n[0] & (n[1] ^ n[2]);

    const vector u(f.value.u.x, f.value.u.y, f.value.u.z);
    tensor G;
    for (direction d = 0; d < 3; ++d)
    {
        for (direction j = 0; j < 3; ++j)
        {
            G[3*d + j] = f.slope[d][j];
        }
    }

    // G_dj is the d-th derivative of the j-th component: G.n is the gradient
    // of u.n
    tensor change(Zero);
    vector shift(Zero);
    forAll(chosen, i)
    {
        const condition& c = all[chosen[i]];
        const vector dual = (n[(i + 1) % 3] ^ n[(i + 2) % 3])/volume;
        scalar slope = (c.w - (u & c.n))/c.delta;
        for (const condition& other : all)
        {
            if (opposite(c, other))
            {
                // Between parallel walls from that of one to that of the other
                slope = (c.w + other.w)/(c.delta + other.delta);
                shift += (c.w - slope*c.delta - (u & c.n))*dual;
                break;
            }
        }
        change += (slope*c.n - (G & c.n))*dual;
    }
    f.value.u = f.value.u + toCore(shift);
    for (direction d = 0; d < 3; ++d)
    {
        for (direction j = 0; j < 3; ++j)
        {
            f.slope[d][j] += change[3*d + j];
        }
    }
}


void Foam::cellGas::bindAxis()
{
    for (const wedgePoints::axisCell& a : axisCells_)
    {
        field& f = cells_[a.cell];
        for (const int offset : {0, 3})
        {
            const double* q = &f.value.u.x + offset;
            const vector value(q[0], q[1], q[2]);
            const scalar spread = (value & a.outward)/a.r;
            const scalar turn = (value & a.around)/a.r;

            // Change of the derivatives away from the axis and about it
            vector away = spread*a.outward + turn*a.around;
            vector about = spread*a.around - turn*a.outward;
            for (direction j = 0; j < 3; ++j)
            {
                for (direction d = 0; d < 3; ++d)
                {
                    away[j] -= a.outward[d]*f.slope[d][offset + j];
                    about[j] -= a.around[d]*f.slope[d][offset + j];
                }
            }

            // What is along the axis changes with the distance as it did
            away -= (away & a.axis())*a.axis();
            for (direction d = 0; d < 3; ++d)
            {
                const vector change = a.outward[d]*away + a.around[d]*about;
                for (direction j = 0; j < 3; ++j)
                {
                    f.slope[d][offset + j] += change[j];
                }
            }
        }
    }
}


void Foam::cellGas::bindWalls(const volVectorField& U)
{
    const boolList bound(wallGasVelocity::boundPatches(U));
    const label nInternal = mesh_.nInternalFaces();

    // Planes of the bound faces of each cell, the nearest first
    List<DynamicList<condition>> conditions(mesh_.nCells());
    List<DynamicList<label>> faces(mesh_.nCells());
    const auto plane =
        [&](const vector& n, const point& on, const label facei)
        {
            const convexCells::boundaryFace& face =
                convex_.boundary()[facei - nInternal];
            return condition
            {
                n,
                n & (on - mesh_.cellCentres()[mesh_.faceOwner()[facei]]),
                wallGasVelocity::wallSpeed(U, face.patch, face.patchFace, n)
            };
        };
    forAll(bound, patchi)
    {
        const polyPatch& patch = mesh_.boundaryMesh()[patchi];
        for (label i = 0; bound[patchi] && i < patch.size(); ++i)
        {
            const label facei = patch.start() + i;
            const label celli = patch.faceCells()[i];
            const condition c = plane
            (
                normalised(patch.faceAreas()[i]), patch.faceCentres()[i], facei
            );
            if (c.delta > 0)
            {
                conditions[celli].append(c);
                faces[celli].append(facei);
                if (c.delta < conditions[celli][0].delta)
                {
                    std::swap(conditions[celli][0], conditions[celli].last());
                    std::swap(faces[celli][0], faces[celli].last());
                }
            }
        }
    }

    // Tetrahedra on them: the own plane, then those of the faces it touches
    cells_.resize(mesh_.nCells());
    forAll(conditions, celli)
    {
        const label first = convex_.firstCell()[celli];
        const label last = convex_.firstCell()[celli + 1];
        for (label k = first; last > first + 1 && k < last; ++k)
        {
            fieldOf_[k] = celli;
        }
        label k = first;
        const labelList& cellFaces = mesh_.cells()[celli];
        for (label i = 0; last > first + 1 && i < cellFaces.size(); ++i)
        {
            const label facei = cellFaces[i];
            const label nTriangles = mesh_.faces()[facei].size() - 2;
            const bool onWall = faces[celli].found(facei);
            for (label j = 0; onWall && j < nTriangles; ++j)
            {
                const triFace t = convex_.triangles()(facei, j);
                DynamicList<condition> all;
                all.append
                (
                    plane
                    (
                        t.unitNormal(mesh_.points()), mesh_.points()[t[0]],
                        facei
                    )
                );
                forAll(faces[celli], m)
                {
                    const label other = faces[celli][m];
                    bool touches = false;
                    for (const label pointi : t)
                    {
                        touches =
                            touches || mesh_.faces()[other].found(pointi);
                    }
                    if (other != facei && touches)
                    {
                        all.append(conditions[celli][m]);
                    }
                }
                if (all[0].delta > 0)
                {
                    fieldOf_[k + j] = cells_.size();
                    cells_.push_back(cells_[celli]);
                    bind(cells_.back(), all);
                }
            }
            k += nTriangles;
        }
    }
    for (const wedgePoints::axisCell& a : axisCells_)
    {
        if (conditions[a.cell].size())
        {
            conditions[a.cell].append(condition{-a.outward, a.r, 0});
        }
    }
    forAll(conditions, celli)
    {
        if (conditions[celli].size())
        {
            bind(cells_[celli], conditions[celli]);
        }
    }
}


void Foam::cellGas::tetrahedronField(const tetrahedron& tet, field& f) const
{
    const point& centre = mesh_.cellCentres()[tet.cell];
    const pointField& points = mesh_.points();
    const vector b = points[tet.points[0]] - centre;
    const vector c = points[tet.points[1]] - centre;
    const vector d = points[tet.points[2]] - centre;
    const vector normals[3] = {c ^ d, d ^ b, b ^ c};
    const scalar inverse = 1/(b & normals[0]);

    f.centre = toCore(centre);
    f.value = cellValues_[tet.cell];
    f.length = lengths_[tet.cell];
    f.uDot =
        uDot_.size() ? uDot_[tet.cell] : impact::vector3{0, 0, 0};
    const double* v0 = &f.value.u.x;
    for (int k = 0; k < nValues; ++k)
    {
        f.slope[0][k] = f.slope[1][k] = f.slope[2][k] = 0;
    }
    for (int k = 0; k < 3; ++k)
    {
        f.minima[k] = v0[6 + k];
    }
    for (int i = 0; i < 3; ++i)
    {
        const double* v =
            tet.wall < 0
          ? &pointValues_[tet.points[i]].u.x
          : &wallValues_[3*tet.wall + i].u.x;
        const vector w = inverse*normals[i];
        for (int k = 0; k < nValues; ++k)
        {
            const double difference = v[k] - v0[k];
            f.slope[0][k] += difference*w.x();
            f.slope[1][k] += difference*w.y();
            f.slope[2][k] += difference*w.z();
        }
        for (int k = 0; k < 3; ++k)
        {
            f.minima[k] = std::min(f.minima[k], v[6 + k]);
        }
    }
    if (changes_.size())
    {
        const impact::jointExchange::change& c = changes_[tet.cell];
        f.value.u = f.value.u + c.u;
        f.value.T += c.T;
        f.minima[2] = std::min(f.minima[2], f.value.T);
    }
    for (int k = 0; k < 3; ++k)
    {
        f.minima[k] *= 0.5;
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::cellGas::cellGas(const fvMesh& mesh, const word& scheme)
:
    mesh_(mesh),
    convex_
    (
        scheme == schemes[1]
      ? trackingCells::tetrahedra(mesh)
      : trackingCells::whole(mesh)
    ),
    lengths_(mesh.nCells()),
    events_(-2)
{
    forAll(lengths_, celli)
    {
        // Of the directions in which particles move
        const boundBox box
        (
            mesh.cells()[celli].points(mesh.faces(), mesh.points()),
            false
        );
        scalar volume = 1;
        for (direction d = 0; d < 3; ++d)
        {
            volume *= mesh.solutionD()[d] == 1 ? box.span()[d] : 1;
        }
        lengths_[celli] = pow(volume, 1.0/max(mesh.nSolutionD(), label(1)));
    }

    if (scheme == schemes[0])
    {
        fieldOf_.resize(convex_.size());
        for (label k = 0; k < convex_.size(); ++k)
        {
            fieldOf_[k] = convex_.meshCell(k);
        }
        axisCells_ = wedgePoints::axisCells(mesh);
        return;
    }

    tets_.reserve(convex_.size());
    forAll(mesh.cells(), celli)
    {
        for (const label facei : mesh.cells()[celli])
        {
            for (label i = 0; i + 2 < mesh.faces()[facei].size(); ++i)
            {
                const triFace t = convex_.triangles()(facei, i);
                tets_.push_back(tetrahedron{celli, {t[0], t[1], t[2]}, -1});
            }
        }
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::boolList Foam::cellGas::cellsToSplit(const polyMesh& mesh)
{
    List<DynamicList<condition>> planes(mesh.nCells());
    for (const polyPatch& patch : mesh.boundaryMesh())
    {
        if
        (
            patch.coupled()
         || isA<emptyPolyPatch>(patch)
         || isA<wedgePolyPatch>(patch)
        )
        {
            continue;
        }
        forAll(patch, i)
        {
            const vector n = normalised(patch.faceAreas()[i]);
            planes[patch.faceCells()[i]].append
            (
                condition{n, n & patch.faceCentres()[i], 0}
            );
        }
    }

    boolList split(mesh.nCells(), false);
    forAll(planes, celli)
    {
        if (planes[celli].size() < 2)
        {
            continue;
        }
        const labelList chosen(choose(planes[celli]));
        for (const condition& c : planes[celli])
        {
            bool met = false;
            for (const label i : chosen)
            {
                // The plane itself, or its continuation
                const condition& other = planes[celli][i];
                met =
                    met
                 || opposite(c, other)
                 || (
                        mag(c.n - other.n) < 1e-9
                     && mag(c.delta - other.delta)
                      < 1e-9*cbrt(mesh.cellVolumes()[celli])
                    );
            }
            split[celli] = split[celli] || !met;
        }
    }
    return split;
}


const Foam::volVectorField& Foam::cellGas::halfCurl(const volVectorField& U)
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


void Foam::cellGas::update
(
    const volVectorField& U,
    const volVectorField* halfCurl,
    const volScalarField& rho,
    const volScalarField& mu,
    const volScalarField* T,
    const bool changing
)
{
    FixedList<label, 6> events;
    events[0] = U.eventNo();
    events[1] = halfCurl ? halfCurl->eventNo() : -1;
    events[2] = rho.eventNo();
    events[3] = mu.eventNo();
    events[4] = T ? T->eventNo() : -1;
    events[5] = changing ? mesh_.time().timeIndex() : -1;
    if (returnReduce(events == events_, andOp<bool>()))
    {
        return;
    }
    events_ = events;
    changes_.clear();
    uDot_.clear();
    if (changing)
    {
        const tmp<volVectorField> dUdt(fvc::ddt(U));
        for (const vector& a : dUdt().primitiveField())
        {
            uDot_.push_back(toCore(a));
        }
    }

    // Call with each field and the place of its first number
    const auto forEach = [&](const auto& take)
    {
        take(U, 0);
        if (halfCurl)
        {
            take(*halfCurl, 3);
        }
        take(rho, 6);
        take(mu, 7);
        if (T)
        {
            take(*T, 8);
        }
    };
    impact::gasState none{};
    none.T = 1;
    if (tets_.empty())
    {
        cells_.resize(mesh_.nCells());
        forAll(mesh_.cellCentres(), celli)
        {
            field& f = cells_[celli];
            f = field{};
            f.centre = toCore(mesh_.cellCentres()[celli]);
            f.value = none;
            f.length = lengths_[celli];
            f.uDot = changing ? uDot_[celli] : impact::vector3{0, 0, 0};
        }
        forEach
        (
            [this](const auto& q, const label offset)
            {
                putGradients(q, offset);
            }
        );
        for (field& f : cells_)
        {
            f.minima[0] = 0.5*f.value.rho;
            f.minima[1] = 0.5*f.value.mu;
            f.minima[2] = 0.5*f.value.T;
        }
        bindAxis();
        bindWalls(U);
        lookBeyond();
        return;
    }

    cellValues_.assign(mesh_.nCells(), none);
    pointValues_.assign(mesh_.nPoints(), none);
    forEach
    (
        [this, &U](const auto& q, const label offset)
        {
            // By the name that the stock scheme takes, which shares them
            if (!offset)
            {
                wallGasVelocity::New(U).pointValues();
            }
            const auto values = volPointInterpolation::New(mesh_).interpolate
            (
                q, "volPointInterpolate(" + q.name() + ')', true
            );
            auto points(values().primitiveField());
            if constexpr (std::is_same_v<decltype(points), vectorField>)
            {
                wedgePoints::restoreTurning(q, points);
            }
            putValues(q, points, offset);
        }
    );

    // Triangles of walls
    const wallGasVelocity& walls = wallGasVelocity::New(U);
    wallValues_.resize(3*walls.nTriangles());
    for (label i = 0; i < walls.nTriangles(); ++i)
    {
        for (label j = 0; j < 3; ++j)
        {
            impact::gasState& state = wallValues_[3*i + j];
            state = pointValues_[walls[i].vertices[j]];
            const vector u(state.u.x, state.u.y, state.u.z);
            state.u = toCore(u + walls[i].at[j].lack(u));
        }
    }
    std::size_t k = 0;
    forAll(mesh_.cells(), celli)
    {
        for (const label facei : mesh_.cells()[celli])
        {
            for (label i = 1; i < mesh_.faces()[facei].size() - 1; ++i, ++k)
            {
                tets_[k].wall = walls.find(facei, i);
            }
        }
    }
}


void Foam::cellGas::change
(
    const volVectorField& U,
    const std::vector<impact::jointExchange::change>& by
)
{
    events_ = -2;
    if (tets_.empty())
    {
        for (label celli = 0; celli < mesh_.nCells(); ++celli)
        {
            field& f = cells_[celli];
            f.value.u = f.value.u + by[celli].u;
            f.value.T += by[celli].T;
            f.minima[2] = std::min(f.minima[2], 0.5*f.value.T);
        }
        bindAxis();
        bindWalls(U);
        lookBeyond();
        return;
    }

    // Between point values that stay a change is the same all over the cell:
    // at a wall it can only be along it
    changes_ = by;
    const boolList bound(wallGasVelocity::boundPatches(U));
    forAll(bound, patchi)
    {
        const polyPatch& patch = mesh_.boundaryMesh()[patchi];
        for (label i = 0; bound[patchi] && i < patch.size(); ++i)
        {
            const impact::vector3 n
            (
                toCore(normalised(patch.faceAreas()[i]))
            );
            impact::vector3& u = changes_[patch.faceCells()[i]].u;
            u = u - impact::dot(u, n)*n;
        }
    }
}
