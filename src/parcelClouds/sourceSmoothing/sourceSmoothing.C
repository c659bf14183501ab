/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "sourceSmoothing.H"
#include "cyclicPolyPatch.H"
#include "processorPolyPatch.H"
#include "surfaceFields.H"
#include "zeroGradientFvPatchFields.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::sourceSmoothing::addFluxes(const scalar factor, scalarField& sum)
{
    phi_.correctBoundaryConditions();
    const scalarField& phi = phi_;
    const labelUList& owner = mesh_.owner();
    const labelUList& neighbour = mesh_.neighbour();
    forAll(neighbour, f)
    {
        const label a = owner[f], b = neighbour[f];
        const scalar flux = factor*weights_[f]*(phi[b] - phi[a]);
        sum[a] += flux;
        sum[b] -= flux;
    }
    for (const fvPatchScalarField& patch : phi_.boundaryField())
    {
        if (patch.coupled())
        {
            const scalarField& weights =
                weights_.boundaryField()[patch.patch().index()];
            const labelUList& cells = patch.patch().faceCells();
            const scalarField beyond(patch.patchNeighbourField());
            forAll(cells, f)
            {
                const label a = cells[f];
                sum[a] += factor*weights[f]*(beyond[f] - phi[a]);
            }
        }
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::sourceSmoothing::sourceSmoothing
(
    const fvMesh& mesh,
    const scalar length
)
:
    mesh_(mesh),
    diffusivity_(0.5*sqr(length)),
    phi_
    (
        IOobject
        (
            "smoothedSource",
            mesh.time().timeName(),
            mesh,
            IOobject::NO_READ,
            IOobject::NO_WRITE,
            false
        ),
        mesh,
        dimensionedScalar(dimless, Zero),
        zeroGradientFvPatchScalarField::typeName
    ),
    weights_
    (
        "smoothingWeights",
        dimensionedScalar("half", dimArea, diffusivity_)*mesh.magSf()
       *mesh.deltaCoeffs()
    ),
    diagonal_(mesh.V())
{
    for (const polyPatch& patch : mesh.boundaryMesh())
    {
        const auto* coupled = isA<coupledPolyPatch>(patch);
        const bool matches =
            isA<cyclicPolyPatch>(patch) || isA<processorPolyPatch>(patch);
        if (coupled && !(matches && coupled->parallel()))
        {
            FatalErrorInFunction
                << "Patch " << patch.name() << " of type " << patch.type()
                << ": sourceSmoothing needs patches of type cyclic whose"
                << " sides are not turned" << exit(FatalError);
        }
    }
    forAll(mesh.neighbour(), f)
    {
        diagonal_[mesh.owner()[f]] += weights_[f];
        diagonal_[mesh.neighbour()[f]] += weights_[f];
    }
    for (const fvPatchScalarField& patch : phi_.boundaryField())
    {
        if (patch.coupled())
        {
            const label i = patch.patch().index();
            forAll(patch, f)
            {
                diagonal_[patch.patch().faceCells()[f]] +=
                    weights_.boundaryField()[i][f];
            }
        }
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::sourceSmoothing::spread(scalarField& source)
{
    // Conjugate gradients with the diagonal; phi_ holds the direction, which
    // alone is needed beyond the boundaries
    const label maxIterations = 1000;
    const scalar tolerance = 1e-13;

    scalarField& direction = phi_.primitiveFieldRef();
    const scalarField& V = mesh_.V();
    scalarField solution(source/V);
    direction = solution;
    scalarField residual(source - V*solution);
    addFluxes(1, residual);
    scalarField scaled(residual/diagonal_);
    direction = scaled;
    scalar rz = gSumProd(residual, scaled);
    const scalar enough =
        sqr(tolerance)*gSumProd(source, scalarField(source/diagonal_));
    scalarField image(source.size());
    for (label i = 0; i < maxIterations && rz > enough; ++i)
    {
        image = V*direction;
        addFluxes(-1, image);
        const scalar step = rz/gSumProd(direction, image);
        solution += step*direction;
        residual -= step*image;
        scaled = residual/diagonal_;
        const scalar before = rz;
        rz = gSumProd(residual, scaled);
        direction = scaled + (rz/before)*direction;
    }

    direction = solution;
    addFluxes(1, source);
}


void Foam::sourceSmoothing::spread(vectorField& source)
{
    for (direction c = 0; c < vector::nComponents; ++c)
    {
        scalarField component(source.component(c));
        spread(component);
        source.replace(c, component);
    }
}
