/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "wallLayer.H"
#include "allGather.H"
#include "writtenState.H"
#include "ListOps.H"
#include "PstreamReduceOps.H"
#include "calculatedFvPatchField.H"
#include "checked.H"
#include "volFields.H"

#include <algorithm>
#include <tuple>

namespace Foam
{
    defineTypeNameAndDebug(wallLayer, 0);
}

namespace
{

using namespace Foam;

const char* const quantityNames[] = {"Number", "Mass", "Area", "Volume"};

const dimensionSet quantityDimensions[] =
{
    dimless/dimArea, dimMass/dimArea, dimless, dimLength
};

typedef impact::adheredParticles layer;


//- Order of what happens on a face: by the identity of the parcel
template<class Type>
std::tuple<label, label, scalar> order(const Type& t)
{
    return std::make_tuple(t.origProc, t.origId, t.fraction);
}

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::wallLayer::wallLayer
(
    const IOobject& io,
    const fvMesh& mesh,
    const word& cloudName,
    const std::vector<double>& bounds
)
:
    regIOobject(io),
    mesh_(mesh),
    cloudName_(cloudName),
    firstFace_(mesh.boundaryMesh().size()),
    areas_(mesh.nBoundaryFaces()),
    state_(bounds, mesh.nBoundaryFaces()),
    freedNumber_(mesh.boundaryMesh().size(), Zero),
    freedMass_(mesh.boundaryMesh().size(), Zero)
{
    for (const polyPatch& patch : mesh.boundaryMesh())
    {
        firstFace_[patch.index()] = patch.start() - mesh.nInternalFaces();
        forAll(patch, i)
        {
            areas_[item(patch.index(), i)] = mag(patch.faceAreas()[i]);
        }
    }
}


Foam::word Foam::wallLayer::fieldName
(
    const label sizeClass,
    const label quantity
) const
{
    return
        cloudName_ + ":layer" + Foam::name(sizeClass)
      + quantityNames[quantity];
}


void Foam::wallLayer::read(const dictionary& dict)
{
    const auto present = [&](const word& name)
    {
        return IOobject
        (
            name, mesh_.time().timeName(), mesh_, IOobject::MUST_READ
        ).typeHeaderOk<volScalarField>(true);
    };
    if (!present(fieldName(0, 0)))
    {
        writtenState::check(mesh_, cloudName_, fieldName(0, 0));
        return;
    }
    List<layer::sums> sums(areas_.size()*state_.nClasses(), layer::sums{});
    bool fits = !present(fieldName(state_.nClasses(), 0));
    for (label k = 0; fits && k < state_.nClasses(); ++k)
    {
        for (label i = 0; fits && i < layer::nQuantities; ++i)
        {
            fits = present(fieldName(k, i));
            if (!fits)
            {
                writtenState::check(mesh_, cloudName_, fieldName(k, i));
                break;
            }
            const volScalarField field
            (
                IOobject
                (
                    fieldName(k, i),
                    mesh_.time().timeName(),
                    mesh_,
                    IOobject::MUST_READ,
                    IOobject::NO_WRITE,
                    false
                ),
                mesh_
            );
            forAll(field.boundaryField(), patchi)
            {
                const scalarField& values = field.boundaryField()[patchi];
                forAll(values, facei)
                {
                    sums[item(patchi, facei)*state_.nClasses() + k][i] =
                        values[facei];
                }
            }
        }
    }
    forAll(sums, i)
    {
        const label k = i % state_.nClasses();
        state_.restore(i/state_.nClasses(), k, sums[i]);
        if (sums[i][layer::number] > 0 && fits)
        {
            // The mean of like particles may be off by round-off
            const scalar d =
                state_.meanOf(i/state_.nClasses(), k).diameter;
            fits =
                state_.classOf(d*(1 + 1e-9)) == k
             || state_.classOf(d*(1 - 1e-9)) == k;
        }
    }
    if (!returnReduce(fits, andOp<bool>()))
    {
        FatalIOErrorInFunction(dict)
            << "Entry sizeClasses (" << state_.nClasses() << " classes): valid"
            << " range those of the layer of time "
            << mesh_.time().timeName() << ", " << fieldName(0, 0) << " etc."
            << exit(FatalIOError);
    }
}


void Foam::wallLayer::identify()
{
    struct key
    {
        label origProc, origId;
        scalar fraction;
        label rank, local;
    };
    const label n = releases_.size();
    const label total = returnReduce(n, sumOp<label>());
    if (total == 0)
    {
        return;
    }
    List<scalarList> keys(Pstream::nProcs());
    scalarList& mine = keys[Pstream::myProcNo()];
    mine.setSize(3*n);
    for (label i = 0; i < n; ++i)
    {
        mine[3*i] = releases_[i].origProc;
        mine[3*i + 1] = releases_[i].origId;
        mine[3*i + 2] = releases_[i].fraction;
    }
    foamCompat::allGather(keys);

    std::vector<key> all;
    forAll(keys, rank)
    {
        for (label i = 0; 3*i < keys[rank].size(); ++i)
        {
            all.push_back
            ({
                label(keys[rank][3*i]), label(keys[rank][3*i + 1]),
                keys[rank][3*i + 2], rank, i
            });
        }
    }
    std::stable_sort
    (
        all.begin(), all.end(),
        [](const key& a, const key& b) { return order(a) < order(b); }
    );
    if (nReleased_ > labelMax - total)
    {
        FatalErrorInFunction
            << "The wall layer of cloud " << cloudName_ << " has used up the "
            << labelMax << " identities of this build's labels"
            << exit(FatalError);
    }
    for (const key& k : all)
    {
        if (k.rank == Pstream::myProcNo())
        {
            releases_[k.local].identity = nReleased_;
        }
        ++nReleased_;
    }
    std::sort
    (
        releases_.begin(), releases_.end(),
        [](const release& a, const release& b)
        {
            return a.identity < b.identity;
        }
    );
}


void Foam::wallLayer::writeField
(
    const word& name,
    const dimensionSet& dimensions,
    const scalarField& values
) const
{
    volScalarField field
    (
        IOobject
        (
            name,
            mesh_.time().timeName(),
            mesh_,
            IOobject::NO_READ,
            IOobject::NO_WRITE,
            false
        ),
        mesh_,
        dimensionedScalar(dimensions, Zero),
        calculatedFvPatchScalarField::typeName
    );
    forAll(field.boundaryField(), patchi)
    {
        fvPatchScalarField& patch = field.boundaryFieldRef()[patchi];
        forAll(patch, facei)
        {
            patch[facei] = values[item(patchi, facei)];
        }
    }
    field.regIOobject::writeObject
    (
        IOstream::BINARY,
        IOstream::currentVersion,
        mesh_.time().writeCompression(),
        true
    );
}


// * * * * * * * * * * * * * * * * Selectors * * * * * * * * * * * * * * * * //

Foam::wallLayer& Foam::wallLayer::New
(
    const cloud& c,
    const fvMesh& mesh,
    const std::vector<double>& bounds,
    const dictionary& dict
)
{
    if (!c.foundObject<wallLayer>(typeName))
    {
        wallLayer* layer = checked(dict, [&]()
        {
            return new wallLayer
            (
                IOobject
                (
                    typeName,
                    c.time().timeName(),
                    c,
                    IOobject::NO_READ,
                    IOobject::NO_WRITE
                ),
                mesh,
                c.name(),
                bounds
            );
        });
        regIOobject::store(layer);
        layer->read(dict);
    }
    wallLayer& layer = c.lookupObjectRef<wallLayer>(typeName);
    if (layer.state_.bounds() != bounds)
    {
        FatalIOErrorInFunction(dict)
            << "sizeClasses: another model of this cloud has others; one list"
            << " to a cloud" << exit(FatalIOError);
    }
    return layer;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::wallLayer::deposit
(
    const strikeType& strike,
    const scalar d,
    const scalar mass
)
{
    events_.append
    ({
        strike, item(strike.patch, strike.face), d, mass, -1
    });
}


void Foam::wallLayer::detach
(
    const strikeType& strike,
    std::unique_ptr<particle>&& parcel,
    const scalar energy
)
{
    events_.append
    ({
        strike, item(strike.patch, strike.face), 0, 0,
        label(releases_.size())
    });
    releases_.push_back
    ({
        strike.patch, std::move(parcel), energy,
        strike.origProc, strike.origId, strike.fraction, 0, -1, 0, 0
    });
}


std::vector<Foam::wallLayer::release> Foam::wallLayer::settle()
{
    if (mesh_.changing())
    {
        FatalErrorInFunction
            << "The layer of particles on the walls of cloud " << cloudName_
            << " needs a mesh that does not move or change"
            << exit(FatalError);
    }
    if (settledStep_ != mesh_.time().timeIndex())
    {
        settledStep_ = mesh_.time().timeIndex();
        freedNumber_ = Zero;
        freedMass_ = Zero;
    }
    std::stable_sort
    (
        events_.begin(), events_.end(),
        [](const event& a, const event& b)
        {
            return
                a.item != b.item ? a.item < b.item
              : order(a.strike) < order(b.strike);
        }
    );
    for (const event& e : events_)
    {
        const scalar area = areas_[e.item];
        if (e.release < 0)
        {
            state_.add
            (
                e.item, e.strike.sizeClass, e.strike.number/area, e.d, e.mass
            );
            continue;
        }
        const layer::sums taken =
            state_.take(e.item, e.strike.sizeClass, e.strike.number/area);
        release& r = releases_[e.release];
        r.number = area*taken[layer::number];
        freedNumber_[r.patch] += r.number;
        freedMass_[r.patch] += area*taken[layer::mass];
        if (r.number > 0)
        {
            r.d = std::cbrt
            (
                6/constant::mathematical::pi
               *taken[layer::volume]/taken[layer::number]
            );
            r.rho = taken[layer::mass]/taken[layer::volume];
        }
    }
    events_.clear();
    releases_.erase
    (
        std::remove_if
        (
            releases_.begin(), releases_.end(),
            [](const release& r) { return !(r.number > 0); }
        ),
        releases_.end()
    );
    identify();
    std::vector<release> released;
    released.swap(releases_);
    return released;
}


void Foam::wallLayer::write() const
{
    scalarField number(areas_.size(), Zero);
    scalarField mass(areas_.size(), Zero);
    scalarField coverage(areas_.size(), Zero);
    scalarField values(areas_.size());
    for (label k = 0; k < state_.nClasses(); ++k)
    {
        for (label i = 0; i < layer::nQuantities; ++i)
        {
            forAll(values, facei)
            {
                values[facei] = state_.of(facei, k)[i];
            }
            writeField(fieldName(k, i), quantityDimensions[i], values);
            writtenState::add(mesh_, cloudName_, fieldName(k, i));
            if (i == layer::number)
            {
                number += values;
            }
            else if (i == layer::mass)
            {
                mass += values;
            }
            else if (i == layer::area)
            {
                coverage += values;
            }
        }
    }
    writeField(cloudName_ + ":adheredNumber", dimless/dimArea, number);
    writeField(cloudName_ + ":adheredMass", dimMass/dimArea, mass);
    writeField
    (
        cloudName_ + ":coverage", dimless, min(coverage, scalar(1))
    );
    writeField
    (
        cloudName_ + ":overfill", dimless, max(coverage - 1, scalar(0))
    );
}


void Foam::wallLayer::report
(
    Ostream& os,
    const label patchi,
    const word& model
) const
{
    const polyPatch& patch = mesh_.boundaryMesh()[patchi];
    scalar number = 0, mass = 0, covered = 0, area = 0, maxCover = 0;
    forAll(patch, i)
    {
        const label f = item(patchi, i);
        for (label k = 0; k < state_.nClasses(); ++k)
        {
            number += areas_[f]*state_.of(f, k)[layer::number];
            mass += areas_[f]*state_.of(f, k)[layer::mass];
        }
        const scalar c = state_.coverage(f);
        covered += areas_[f]*min(c, scalar(1));
        area += areas_[f];
        maxCover = max(maxCover, c);
    }
    reduce(number, sumOp<scalar>());
    reduce(mass, sumOp<scalar>());
    reduce(covered, sumOp<scalar>());
    reduce(area, sumOp<scalar>());
    reduce(maxCover, maxOp<scalar>());
    os  << "    Layer on patch " << patch.name() << ", " << model
        << nl
        << "      - adhered (number, mass)      = " << number << ", " << mass
        << nl
        << "      - freed now (number, mass)    = "
        << returnReduce(freedNumber_[patchi], sumOp<scalar>()) << ", "
        << returnReduce(freedMass_[patchi], sumOp<scalar>()) << nl
        << "      - coverage (mean)             = "
        << (area > 0 ? covered/area : 0) << nl
        << "      - projected area / face, most = " << maxCover << endl;
}
