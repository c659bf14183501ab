/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "CrossSectionInjection.H"
#include "checked.H"
#include "ListListOps.H"
#include "ListOps.H"
#include "wordRes.H"

#include <algorithm>
#include <cmath>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

template<class CloudType>
const Foam::scalar Foam::CrossSectionInjection<CloudType>::maxParcels = 1e9;


template<class CloudType>
impact::undisturbedStream Foam::CrossSectionInjection<CloudType>::makeStream
(
    const dictionary& dict
) const
{
    const dictionary& coeffs = this->coeffDict();

    List<Tuple2<scalar, scalar>> sizes;
    if (coeffs.found("sizes") && coeffs.found("diameter"))
    {
        FatalIOErrorInFunction(coeffs)
            << "Entry sizes is there as well as diameter: valid is one of them"
            << exit(FatalIOError);
    }
    if (coeffs.found("sizes"))
    {
        coeffs.readEntry("sizes", sizes);
    }
    else
    {
        sizes.append
        (
            Tuple2<scalar, scalar>
            (
                getNumber(coeffs, "diameter", validRange::diameter),
                1
            )
        );
    }

    const scalar dz = this->thickness();
    const bool given = dict.found("nParticle");
    const scalar nParticle =
        getNumber(dict, "nParticle", validRange::number, scalar(1));

    std::vector<impact::undisturbedStream::sizeClass> classes;
    for (const Tuple2<scalar, scalar>& size : sizes)
    {
        const scalar d = size.first();
        this->checkDiameter
        (
            coeffs, coeffs.found("sizes") ? "sizes" : "diameter", d
        );
        checkNumber(coeffs, "sizes", size.second(), "(0, 1]");
        classes.push_back
        (
            {d, size.second(), given || dz < 0 || d <= 0 ? nParticle : dz/d}
        );
    }

    const label seed = getNumber<label>(coeffs, "seed", validRange::seed, 0);
    const scalar volumeFraction =
        getNumber(coeffs, "volumeFraction", "(0, 0.1)");
    return checked
    (
        coeffs,
        [&]
        {
            return impact::undisturbedStream(volumeFraction, classes, seed);
        }
    );
}


template<class CloudType>
Foam::labelList Foam::CrossSectionInjection<CloudType>::entryPatches() const
{
    const polyBoundaryMesh& boundary = this->owner().mesh().boundaryMesh();
    const wordRes names
    (
        this->coeffDict().template get<wordRes>("patches")
    );

    const wordList patchNames
    (
        SubList<word>(boundary.names(), boundary.nNonProcessor())
    );
    if (names.empty())
    {
        refuse
        (
            this->coeffDict(), "patches", "()", "at least one of ",
            listed(patchNames).c_str()
        );
    }
    labelList patchIDs;
    for (const wordRe& name : names)
    {
        bool found = false;
        forAll(patchNames, patchi)
        {
            if (name.match(patchNames[patchi]))
            {
                patchIDs.append(patchi);
                found = true;
            }
        }
        if (!found)
        {
            unknownWord(this->coeffDict(), "patches", name, patchNames);
        }
    }
    inplaceUniqueSort(patchIDs);
    return patchIDs;
}


template<class CloudType>
Foam::pointField
Foam::CrossSectionInjection<CloudType>::entryTriangles() const
{
    // A triangle fan over each face, or what covers it once if it has corners
    // that point inwards
    const polyMesh& mesh = this->owner().mesh();
    const pointField& points = mesh.points();
    DynamicList<point> own;
    for (const label patchi : entryPatches())
    {
        const polyPatch& patch = mesh.boundaryMesh()[patchi];
        forAll(patch, facei)
        {
            const face& f = patch[facei];
            const vector& area = patch.faceAreas()[facei];
            faceList triangles(f.size() - 2);
            bool convex = true;
            forAll(triangles, i)
            {
                triangles[i] = triFace(f[0], f[i + 1], f[i + 2]).triFaceFace();
                convex =
                    convex
                 && (triangles[i].areaNormal(points) & area)
                 >= -1e-9*magSqr(area);
            }
            if (!convex)
            {
                label n = 0;
                f.triangles(points, n, triangles);
            }
            for (const face& triangle : triangles)
            {
                own.append(triangle.points(points));
            }
        }
    }

    List<pointField> all(Pstream::nProcs());
    all[Pstream::myProcNo()] = own;
    Pstream::gatherList(all);
    Pstream::scatterList(all);
    const pointField corners
    (
        ListListOps::combine<pointField>(all, accessOp<pointField>())
    );

    const auto before =
        [](const point& a, const point& b)
        {
            return
                a.x() != b.x() ? a.x() < b.x()
              : a.y() != b.y() ? a.y() < b.y()
              : a.z() < b.z();
        };
    labelList order(identity(corners.size()/3));
    std::sort
    (
        order.begin(),
        order.end(),
        [&](const label a, const label b)
        {
            const auto first = corners.begin();
            return std::lexicographical_compare
            (
                first + 3*a, first + 3*a + 3, first + 3*b, first + 3*b + 3,
                before
            );
        }
    );
    pointField sorted(corners.size());
    forAll(sorted, i)
    {
        sorted[i] = corners[3*order[i/3] + i % 3];
    }
    return sorted;
}


template<class CloudType>
void Foam::CrossSectionInjection<CloudType>::setQuietEntry()
{
    const polyMesh& mesh = this->owner().mesh();
    vector empty(Zero);
    if (mesh.nSolutionD() == 2)
    {
        for (direction d = 0; d < 3; ++d)
        {
            empty[d] = mesh.solutionD()[d] == -1;
        }
    }
    section_ = entrySection(corners_, this->U0(), empty);
    sequenceRate_ =
        stream_.parcelDensity()*section_.area()
       *mag(this->U0() - (this->U0() & empty)*empty);

    // A section that is entered twice is met in a first few members
    for (int64_t k = 0; k < 10000; ++k)
    {
        scalar instant;
        point p;
        entry(k, instant, p);
    }
}


template<class CloudType>
void Foam::CrossSectionInjection<CloudType>::setEntry()
{
    const pointField triangles(entryTriangles());
    DynamicList<point> corners;
    DynamicList<scalar> cumulative;
    scalar flux = 0;
    for (label i = 0; i < triangles.size(); i += 3)
    {
        const point& a = triangles[i];
        const point& b = triangles[i + 1];
        const point& c = triangles[i + 2];
        const scalar inward = -0.5*(((b - a)^(c - a)) & this->U0());
        if (inward > 0)
        {
            flux += inward;
            corners.append(a);
            corners.append(b);
            corners.append(c);
            cumulative.append(flux);
        }
    }
    corners_ = corners;
    cumulativeFlux_ = cumulative;

    if (flux <= 0)
    {
        refuse
        (
            this->coeffDict(), "U0", this->U0(),
            "of velocities that point into the mesh through ",
            flatOutput(this->coeffDict().template get<wordRes>("patches"))
        );
    }

    rate_ = stream_.parcelDensity()*flux;
    sequenceRate_ = rate_;
    if (quiet_)
    {
        setQuietEntry();
    }

    // No memory holds them
    const scalar perStep =
        rate_*this->owner().db().time().deltaTValue();
    if (!(perStep < maxParcels))
    {
        refuse
        (
            this->coeffDict(), "volumeFraction", stream_.parcelDensity(),
            "of parcels per m3 (here the value): fewer than ", maxParcels,
            " parcels that enter in a time step, not ", perStep,
            "; raise nParticle"
        );
    }
}


template<class CloudType>
bool Foam::CrossSectionInjection<CloudType>::entry
(
    const int64_t k,
    scalar& instant,
    point& p
) const
{
    const uint32_t sequence = 2*this->modelIndex() + 1;
    if (quiet_)
    {
        const auto draw = stream_.quietOf(k, sequence);
        instant = draw.entry;
        const bool plane = this->owner().mesh().nSolutionD() == 2;
        const auto result =
            section_.enter(draw.a, plane ? 0.5 : draw.b, p);
        if (result == entrySection::entries::several)
        {
            refuse
            (
                this->coeffDict(), "arrival", "quiet", "random where lines"
                " along U0 enter through the patches more than once, as they"
                " do near ", p
            );
        }
        return result == entrySection::entries::one;
    }

    const auto random = stream_.drawOf(nBox_ + k, sequence);
    instant = random.entry;
    const scalar flux = random.a*cumulativeFlux_.last();
    const label triangle = min
    (
        label
        (
            std::upper_bound
            (
                cumulativeFlux_.begin(),
                cumulativeFlux_.end(),
                flux
            )
          - cumulativeFlux_.begin()
        ),
        cumulativeFlux_.size() - 1
    );
    const point& a = corners_[3*triangle];
    const scalar root = Foam::sqrt(random.b);
    p =
        a
      + root*(1 - random.c)*(corners_[3*triangle + 1] - a)
      + root*random.c*(corners_[3*triangle + 2] - a);
    return true;
}


template<class CloudType>
bool Foam::CrossSectionInjection<CloudType>::behindFront
(
    const point& p,
    const scalar t
) const
{
    return
        !plane_
     || ((p - front_) & this->U0()) <= magSqr(this->U0())*(t - this->SOI_);
}


template<class CloudType>
typename Foam::CrossSectionInjection<CloudType>::newParcel
Foam::CrossSectionInjection<CloudType>::parcel
(
    const point& p,
    const int64_t k
) const
{
    const auto& size = stream_.sizes()
    [
        quiet_
      ? stream_.quietSizeOf(k, 2*this->modelIndex())
      : stream_.sizeOf(k)
    ];
    return newParcel{p, size.d, size.weight, k, -1};
}


template<class CloudType>
Foam::scalar Foam::CrossSectionInjection<CloudType>::meshLength() const
{
    return this->owner().mesh().bounds().mag();
}


// * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * * * //

template<class CloudType>
void Foam::CrossSectionInjection<CloudType>::select
(
    const scalar t0,
    DynamicList<newParcel>& parcels
)
{
    if (this->owner().mesh().changing())
    {
        FatalIOErrorInFunction(this->coeffDict())
            << "The mesh moves or changes: crossSectionInjection lets its"
            << " stream enter through the patches as they were at the start."
            << nl << "Valid: a mesh at rest, or rakeInjection at points that"
            << " stay in the mesh" << exit(FatalIOError);
    }
    if (t0 < begin_)
    {
        return;
    }
    until_ = t0;

    // Else all that enter now have done so since the last step, however much
    // longer than this one that was
    const Time& time = this->owner().db().time();
    const scalar step = max(time.deltaTValue(), time.deltaT0Value());
    bool late = !filled_ && t0 - begin_ > step;
    if (!filled_)
    {
        filled_ = true;
        const uint32_t sequence = 2*this->modelIndex();
        const vector span(box_.span());
        const vector drift(this->U0()*max(t0 - this->SOI_, scalar(0)));
        for (int64_t k = 0; k < nBox_; ++k)
        {
            const auto draw =
                quiet_
              ? stream_.quietOf(k, sequence)
              : stream_.drawOf(k, sequence);
            const point p
            (
                box_.min()
              + vector(draw.a*span.x(), draw.b*span.y(), draw.c*span.z())
            );
            if (behindFront(p, this->SOI_))
            {
                parcels.append(parcel(p + drift, k));
            }
        }
    }

    // Parcels that entered so long ago that they have left again
    const scalar oldest =
        firstMember_
      + (t0 - begin_ - meshLength()/mag(this->U0()))*sequenceRate_;
    if (oldest > next_)
    {
        next_ = oldest;
        late = true;
    }

    for (;; ++next_)
    {
        scalar instant;
        point p;
        const bool enters = entry(next_, instant, p);
        const scalar since = (next_ - firstMember_ + instant)/sequenceRate_;
        const scalar t = begin_ + since;
        if (t > t0 || begin_ - start_ + since > duration_)
        {
            break;
        }
        if (enters && behindFront(p, t))
        {
            const vector way((t0 - t)*this->U0());
            parcels.append(parcel(p + way, nBox_ + next_));
            if (!late || t0 - t <= step)
            {
                parcels.last().flown = way;
            }
        }
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

template<class CloudType>
Foam::CrossSectionInjection<CloudType>::CrossSectionInjection
(
    const dictionary& dict,
    CloudType& owner,
    const word& modelName
)
:
    IdentifiedInjection<CloudType>
    (
        dict, owner, modelName, typeName,
        {
            "patches", "volumeFraction", "sizes", "seed", "duration", "front",
            "prefill", "arrival"
        }
    ),
    stream_(makeStream(dict)),
    quiet_
    (
        getWord(this->coeffDict(), "arrival", {"random", "quiet"}) == "quiet"
    ),
    duration_
    (
        getNumber
        (
            this->coeffDict(), "duration", validRange::duration, scalar(VGREAT)
        )
    ),
    plane_(this->coeffDict().found("front")),
    front_
    (
        getComponents
        (
            this->coeffDict(), "front", validRange::coordinate, vector(Zero)
        )
    ),
    prefill_(this->coeffDict().found("prefill")),
    next_(this->template getModelProperty<label>("next")),
    filled_(this->template getModelProperty<label>("filled"))
{
    if (magSqr(this->U0()) <= 0)
    {
        refuse(this->coeffDict(), "U0", "(0 0 0)", "any vector but zero");
    }

    setEntry();

    if (prefill_)
    {
        const dictionary& prefill = this->coeffDict().subDict("prefill");
        refuseOthers(prefill, {"box"});
        ITstream& is = prefill.lookup("box");
        is >> box_.min() >> box_.max();
        if (cmptMin(box_.span()) <= 0)
        {
            refuse(prefill, "box", box_, "(min) (max) with min < max");
        }

        const boundBox& bounds = owner.mesh().bounds();
        box_.min() = max(box_.min(), bounds.min());
        box_.max() = min(box_.max(), bounds.max());
        const scalar n =
            cmptMin(box_.span()) > 0
          ? box_.volume()*stream_.parcelDensity() : 0;
        if (!(n < maxParcels))
        {
            refuse
            (
                prefill, "box", box_, "with fewer than ", maxParcels,
                " parcels, not ", n, "; raise nParticle"
            );
        }
        nBox_ = std::llround(n);
    }
    resume();

    Info<< "    " << modelName << ": " << rate_ << " parcels/s enter";
    if (nBox_ && !filled_)
    {
        Info<< ", the box holds " << nBox_;
    }
    for (unsigned j = 0; j < stream_.sizes().size(); ++j)
    {
        Info<< nl << "    diameter " << stream_.sizes()[j].d << " m, "
            << stream_.numberDensity(j) << " 1/m^3, "
            << stream_.sizes()[j].weight << " per parcel";
    }
    Info<< endl;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

template<class CloudType>
Foam::label Foam::CrossSectionInjection<CloudType>::parcelsToInject
(
    const scalar time0,
    const scalar time1
)
{
    const scalar end = min(time1, duration_);
    return std::floor(max(rate_*(end - max(time0, scalar(0))), scalar(0)));
}


template<class CloudType>
Foam::scalar Foam::CrossSectionInjection<CloudType>::volumeToInject
(
    const scalar time0,
    const scalar time1
)
{
    return
        parcelsToInject(time0, time1)*averageParcelMass()
       /this->owner().constProps().rho0();
}


template<class CloudType>
Foam::scalar Foam::CrossSectionInjection<CloudType>::averageParcelMass()
{
    scalar volume = 0;
    for (unsigned j = 0; j < stream_.sizes().size(); ++j)
    {
        volume +=
            stream_.numberDensity(j)/stream_.parcelDensity()
           *CloudType::parcelType::volume(stream_.sizes()[j].d);
    }
    return volume*this->owner().constProps().rho0();
}
