/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "wallGasVelocity.H"
#include "pointConstraints.H"
#include "transformFvPatchFields.H"
#include "volPointInterpolation.H"
#include "wallPolyPatch.H"
#include "wedgePolyPatch.H"

#include <Eigen/Eigenvalues>

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    defineTypeNameAndDebug(wallGasVelocity, 0);

    // Two planes whose normals differ by an angle a have the weights
    // 1 +- cos a along their mean and across it: this is their ratio,
    // tan^2(a/2), at 30 degrees
    static const scalar featureWeight = 0.0718;

    static word nameOf(const volVectorField& U)
    {
        return wallGasVelocity::typeName + '(' + U.name() + ')';
    }
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::boolList Foam::wallGasVelocity::boundPatches(const volVectorField& U)
{
    const volVectorField::Boundary& boundary = U.boundaryField();
    boolList bound(boundary.size(), false);
    forAll(boundary, patchi)
    {
        const fvPatchVectorField& Up = boundary[patchi];
        const polyPatch& patch = Up.patch().patch();
        if (Up.coupled() || isA<wedgePolyPatch>(patch))
        {
            continue;
        }
        if (isA<transformFvPatchField<vector>>(Up))
        {
            bound[patchi] = true;
        }
        else if (Up.fixesValue())
        {
            // What enters through a patch may be at any angle to a wall
            // beside it
            bound[patchi] =
                isA<wallPolyPatch>(patch)
             || gMax(mag(Up & Up.patch().nf())) <= SMALL*gMax(mag(Up));
        }
    }
    return bound;
}


Foam::scalar Foam::wallGasVelocity::wallSpeed
(
    const volVectorField& U,
    const label patchi,
    const label facei,
    const vector& n
)
{
    const fvPatchVectorField& Up = U.boundaryField()[patchi];
    return isA<transformFvPatchField<vector>>(Up)
      ? Up[facei] & vector(normalised(Up.patch().Sf()[facei]))
      : Up[facei] & n;
}


void Foam::wallGasVelocity::makeGeometry()
{
    const fvMesh& mesh = U_.mesh();
    const polyBoundaryMesh& patches = mesh.boundaryMesh();

    starts_.resize(mesh.nBoundaryFaces());
    starts_ = -1;
    triangles_.clear();
    symmTensorField weights(mesh.nPoints(), Zero);
    forAll(patches, patchi)
    {
        if (!bound_[patchi])
        {
            continue;
        }
        const polyPatch& patch = patches[patchi];
        forAll(patch, i)
        {
            const label facei = patch.start() + i;
            const face& f = patch[i];
            const vector n = normalised(mesh.faceAreas()[facei]);
            for (const label pointi : f)
            {
                weights[pointi] += sqr(n);
            }
            starts_[facei - mesh.nInternalFaces()] =
                label(triangles_.size());
            for (label tetPti = 1; tetPti < f.size() - 1; ++tetPti)
            {
                triangle t;
                t.vertices =
                    tetIndices(mesh.faceOwner()[facei], facei, tetPti)
                   .faceTriIs(mesh);
                triangles_.push_back(t);
            }
        }
    }
    pointConstraints::syncUntransformedData
    (
        mesh,
        weights,
        plusEqOp<symmTensor>()
    );

    DynamicList<label> points;
    DynamicList<FixedList<vector, 3>> directions;
    DynamicList<FixedList<scalar, 3>> inverses;
    forAll(weights, pointi)
    {
        const symmTensor& w = weights[pointi];
        if (tr(w) < 0.5)
        {
            continue;
        }
        Eigen::Matrix3d m;
        m << w.xx(), w.xy(), w.xz(),
            w.xy(), w.yy(), w.yz(),
            w.xz(), w.yz(), w.zz();
        const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(m);
        FixedList<vector, 3> v;
        FixedList<scalar, 3> inverse;
        for (label k = 0; k < 3; ++k)
        {
            // In falling order
            const auto e = solver.eigenvectors().col(2 - k);
            const scalar value = solver.eigenvalues()[2 - k];
            v[k] = vector(e[0], e[1], e[2]);
            inverse[k] =
                value > featureWeight*solver.eigenvalues()[2] ? 1/value : 0;
        }
        points.append(pointi);
        directions.append(v);
        inverses.append(inverse);
    }
    points_.transfer(points);
    directions_.transfer(directions);
    inverses_.transfer(inverses);
}


void Foam::wallGasVelocity::bind(pointVectorField& pointU)
{
    const fvMesh& mesh = U_.mesh();
    const polyBoundaryMesh& patches = mesh.boundaryMesh();

    vectorField targets(mesh.nPoints(), Zero);
    forAll(patches, patchi)
    {
        if (!bound_[patchi])
        {
            continue;
        }
        const polyPatch& patch = patches[patchi];
        forAll(patch, i)
        {
            const vector n =
                normalised(mesh.faceAreas()[patch.start() + i]);
            const vector target = wallSpeed(U_, patchi, i, n)*n;
            for (const label pointi : patch[i])
            {
                targets[pointi] += target;
            }
        }
    }
    pointConstraints::syncUntransformedData
    (
        mesh,
        targets,
        plusEqOp<vector>()
    );

    vectorField& values = pointU.primitiveFieldRef();
    labelList slots(mesh.nPoints(), -1);
    List<conditions> atPoints(points_.size());
    forAll(points_, i)
    {
        const label pointi = points_[i];
        slots[pointi] = i;
        for (label k = 0; k < 3 && inverses_[i][k] > 0; ++k)
        {
            const vector& e = directions_[i][k];
            atPoints[i].add(e, inverses_[i][k]*(e & targets[pointi]));
        }
        values[pointi] += atPoints[i].lack(values[pointi]);
    }

    forAll(patches, patchi)
    {
        if (!bound_[patchi])
        {
            continue;
        }
        const polyPatch& patch = patches[patchi];
        forAll(patch, i)
        {
            const label facei = patch.start() + i;
            for (label tetPti = 1; tetPti < patch[i].size() - 1; ++tetPti)
            {
                triangle& t = triangles_[find(facei, tetPti)];
                vector n = t.vertices.areaNormal(mesh.points());
                const scalar area = mag(n);
                n = area > VSMALL
                  ? n/area
                  : vector(normalised(mesh.faceAreas()[facei]));
                const scalar w = wallSpeed(U_, patchi, i, n);
                for (label j = 0; j < 3; ++j)
                {
                    conditions& own = t.at[j];
                    own.n = 0;
                    own.add(n, w);

                    // Of the other directions of the vertex as many as it
                    // has besides this one, those most across it first
                    const conditions& all = atPoints[slots[t.vertices[j]]];
                    while (own.n < all.n)
                    {
                        vector best(Zero);
                        scalar value = 0;
                        for (label k = 0; k < all.n; ++k)
                        {
                            vector across = all.e[k];
                            scalar rest = all.w[k];
                            for (label m = 0; m < own.n; ++m)
                            {
                                const scalar share = own.e[m] & all.e[k];
                                across -= share*own.e[m];
                                rest -= share*own.w[m];
                            }
                            if (magSqr(across) > magSqr(best))
                            {
                                best = across;
                                value = rest;
                            }
                        }
                        const scalar magnitude = mag(best);
                        own.add(best/magnitude, value/magnitude);
                    }
                }
            }
        }
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::wallGasVelocity::wallGasVelocity(const volVectorField& U)
:
    regIOobject
    (
        IOobject
        (
            nameOf(U),
            U.mesh().time().constant(),
            U.mesh(),
            IOobject::NO_READ,
            IOobject::NO_WRITE
        )
    ),
    U_(U),
    event_(-2),
    pointEvent_(-2)
{}


Foam::wallGasVelocity* Foam::wallGasVelocity::find(const volVectorField& U)
{
    wallGasVelocity* found =
        U.mesh().thisDb().getObjectPtr<wallGasVelocity>(nameOf(U));
    return found && &found->U_ == &U ? found : nullptr;
}


Foam::wallGasVelocity& Foam::wallGasVelocity::New(const volVectorField& U)
{
    if (wallGasVelocity* found = find(U))
    {
        return *found;
    }

    // That of a field that is no more
    U.mesh().thisDb().checkOut(nameOf(U));
    return regIOobject::store(new wallGasVelocity(U));
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

const Foam::pointVectorField& Foam::wallGasVelocity::pointValues()
{
    const fvMesh& mesh = U_.mesh();
    const word name("volPointInterpolate(" + U_.name() + ')');

    pointVectorField* stored =
        mesh.thisDb().getObjectPtr<pointVectorField>(name);
    if
    (
        stored
     && U_.eventNo() == event_
     && stored->eventNo() == pointEvent_
     && !mesh.changing()
    )
    {
        return *stored;
    }

    const boolList bound(boundPatches(U_));
    if (bound != bound_ || mesh.changing())
    {
        bound_ = bound;
        makeGeometry();
    }

    volPointInterpolation::New(mesh).interpolate(U_, name, true);
    stored = mesh.thisDb().getObjectPtr<pointVectorField>(name);
    bind(*stored);
    event_ = U_.eventNo();
    pointEvent_ = stored->eventNo();
    return *stored;
}
