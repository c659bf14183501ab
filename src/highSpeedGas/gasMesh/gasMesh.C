/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "gasMesh.H"
#include "emptyPolyPatch.H"
#include "symmetryPolyPatch.H"
#include "symmetryPlanePolyPatch.H"
#include "wedgePolyPatch.H"
#include "processorPolyPatch.H"
#include "cyclicPolyPatch.H"
#include "cyclicAMIPolyPatch.H"
#include "cyclicACMIPolyPatch.H"
#include "cyclicPeriodicAMIPolyPatch.H"
#include "UIPstream.H"
#include "UOPstream.H"
#include "surfaceFields.H"

void Foam::gasMesh::setDirections()
{
    const Vector<label>& solved = mesh_.solutionD();

    nDim_ = 0;
    for (int d = 0; d < 3; d++)
    {
        if (solved[d] == 1)
        {
            direction_[nDim_++] = d;
        }
    }

    // A line of cells is treated as a plane with nothing happening across
    for (int d = 0; d < 3 && nDim_ < 2; d++)
    {
        if (solved[d] != 1)
        {
            direction_[nDim_++] = d;
        }
    }
}


void Foam::gasMesh::setFaces()
{
    const polyBoundaryMesh& boundary = mesh_.boundaryMesh();

    nCells_ = mesh_.nCells();
    nInternal_ = mesh_.nInternalFaces();
    nFaces_ = nInternal_;

    forAll(boundary, patchi)
    {
        const polyPatch& pp = boundary[patchi];

        if (isA<emptyPolyPatch>(pp))
        {
            continue;
        }
        // (An AMI says that it is coupled only once both sides are there)
        const bool ami =
            isA<cyclicAMIPolyPatch>(pp) && !isA<cyclicACMIPolyPatch>(pp)
         && !isA<cyclicPeriodicAMIPolyPatch>(pp);
        const bool coupled =
            ami || isA<processorPolyPatch>(pp) || isA<cyclicPolyPatch>(pp);

        if (!coupled && (pp.coupled() || isA<cyclicAMIPolyPatch>(pp)))
        {
            FatalErrorInFunction
                << "Patch " << pp.name() << " of type " << pp.type()
                << " couples cells in a way the gas solution does not know."
                << nl << "Valid coupled types: processor, cyclic, cyclicAMI"
                << exit(FatalError);
        }
        if
        (
            coupled && !isType<processorPolyPatch>(pp)
         && !refCast<const coupledPolyPatch>(pp).parallel()
        )
        {
            FatalErrorInFunction
                << "Patch " << pp.name() << " of type " << pp.type()
                << " is joined to its neighbour by a rotation; the gas is"
                << " joined by translations only." << nl
                << "Solve the whole circumference, or use a wedge if the flow"
                << " is axisymmetric" << exit(FatalError);
        }

        patches_.push_back
        (
            patchRange
            {
                patchi,
                nFaces_,
                pp.size(),
                coupled,
                isA<symmetryPolyPatch>(pp) || isA<symmetryPlanePolyPatch>(pp),
                isA<wedgePolyPatch>(pp)
            }
        );
        nFaces_ += pp.size();
    }

    owner.resize(nFaces_);
    far.resize(nFaces_);
    normal.assign(nFaces_*nDim_, 0);
    area.resize(nFaces_);
    delta.assign(nFaces_*nDim_, 0);
    toFace.assign(nFaces_*nDim_, 0);
    weight.resize(nFaces_);
    normalDistance.resize(nFaces_);

    const pointField& C = mesh_.cellCentres();

    auto setFace = [&]
    (
        const label f,
        const label own,
        const label farCell,
        const vector& Sf,
        const vector& toFaceCentre,
        const vector& toFar
    )
    {
        owner[f] = own;
        far[f] = farCell;
        area[f] = mag(Sf);
        const vector n = Sf/area[f];
        for (int d = 0; d < nDim_; d++)
        {
            normal[f*nDim_ + d] = n[direction_[d]];
            delta[f*nDim_ + d] = toFar[direction_[d]];
            toFace[f*nDim_ + d] = toFaceCentre[direction_[d]];
        }
        normalDistance[f] = max(mag(n & toFar), 0.05*mag(toFar));
        weight[f] =
            min(max((n & toFaceCentre)/stabilise(n & toFar, VSMALL), 0.0), 1.0);
    };

    for (label f = 0; f < nInternal_; f++)
    {
        const label own = mesh_.faceOwner()[f];
        const label nei = mesh_.faceNeighbour()[f];
        setFace
        (
            f,
            own,
            nei,
            mesh_.faceAreas()[f],
            mesh_.faceCentres()[f] - C[own],
            C[nei] - C[own]
        );
    }

    for (const patchRange& patch : patches_)
    {
        const fvPatch& fvp = mesh_.boundary()[patch.patchi];
        const vectorField delta(fvp.delta());
        const labelUList& cells = fvp.faceCells();

        for (label i = 0; i < patch.size; i++)
        {
            const label f = patch.start + i;
            const vector toFaceCentre(fvp.Cf()[i] - C[cells[i]]);
            const vector n(fvp.Sf()[i]/fvp.magSf()[i]);

            setFace
            (
                f,
                cells[i],
                nCells_ + f - nInternal_,
                fvp.Sf()[i],
                toFaceCentre,
                patch.coupled ? delta[i]
              : patch.symmetry ? 2*(n & toFaceCentre)*n
              : toFaceCentre
            );
            if (!patch.coupled)
            {
                weight[f] = patch.symmetry ? 0.5 : 1;
            }
        }
    }

    volume.resize(nCells_);
    for (label c = 0; c < nCells_; c++)
    {
        volume[c] = mesh_.cellVolumes()[c];
    }

    cellStart.assign(nCells_ + 1, 0);
    for (label f = 0; f < nFaces_; f++)
    {
        cellStart[owner[f] + 1]++;
        if (f < nInternal_)
        {
            cellStart[far[f] + 1]++;
        }
    }
    for (label c = 0; c < nCells_; c++)
    {
        cellStart[c + 1] += cellStart[c];
    }
    faceOf.resize(cellStart[nCells_]);
    std::vector<int> fill(cellStart.begin(), cellStart.end() - 1);
    for (label f = 0; f < nFaces_; f++)
    {
        faceOf[fill[owner[f]]++] = f;
        if (f < nInternal_)
        {
            faceOf[fill[far[f]]++] = f;
        }
    }
}


void Foam::gasMesh::setAlignment()
{
    gasBehind.assign(nFaces_, 0);
    std::fill_n(gasBehind.begin(), nInternal_, 1);
    for (const patchRange& patch : patches_)
    {
        std::fill_n
        (
            gasBehind.begin() + patch.start,
            patch.size,
            patch.coupled || patch.symmetry
        );
    }

    // The cosine of the angle between two ways out of a cell that lie on one
    // line. On hexahedra it is -0.9 and less, a face between one coarse and
    // four fine cells included; on the axis of a wedge, where the images are
    // turned by 120 degrees, -0.87; on regular tetrahedra it is -1/3.
    const double opposite = -0.8;

    unaligned.clear();
    for (label c = 0; c < nCells_; c++)
    {
        const int start = cellStart[c];
        const int end = cellStart[c + 1];
        auto cosine = [&](const int f, const int g)
        {
            const double* x = &delta[f*nDim_];
            const double* y = &delta[g*nDim_];
            double xx = 0;
            double yy = 0;
            double xy = 0;
            for (int d = 0; d < nDim_; d++)
            {
                xx += x[d]*x[d];
                yy += y[d]*y[d];
                xy += x[d]*y[d];
            }
            const bool sameSide = (owner[f] == c) == (owner[g] == c);
            return (sameSide ? xy : -xy)/std::sqrt(xx*yy);
        };

        bool onLines = true;
        for (int i = start; i < end && onLines; i++)
        {
            double least = 1;
            for (int j = start; j < end && gasBehind[faceOf[i]]; j++)
            {
                least = min(least, cosine(faceOf[i], faceOf[j]));
            }
            onLines = !gasBehind[faceOf[i]] || least <= opposite;
        }
        if (!onLines)
        {
            unaligned.push_back(c);
        }
    }
    anyUnaligned = returnReduce(!unaligned.empty(), orOp<bool>());
}


void Foam::gasMesh::setImages()
{
    lsqWeight_.assign(nFaces_, 1);
    image_.assign((nFaces_ - nInternal_)*nDim_*nDim_, 0);
    radial_.assign((nFaces_ - nInternal_)*nDim_, 0);

    const pointField& points = mesh_.points();

    for (const patchRange& patch : patches_)
    {
        if (!patch.image())
        {
            continue;
        }
        const fvPatch& fvp = mesh_.boundary()[patch.patchi];

        for (label i = 0; i < patch.size; i++)
        {
            const label f = patch.start + i;
            const vector n(fvp.Sf()[i]/fvp.magSf()[i]);
            tensor M(tensor::I - 2*n*n);

            if (patch.wedge)
            {
                const wedgePolyPatch& wedge =
                    refCast<const wedgePolyPatch>(fvp.patch());
                const vector axis(normalised(wedge.axis()));
                const vector C(mesh_.cellCentres()[owner[f]]);
                const vector r(C - (C & axis)*axis);

                scalar nearest = GREAT;
                for (const label pointi : wedge[i])
                {
                    const point& P = points[pointi];
                    nearest = min(nearest, mag(P - (P & axis)*axis));
                }
                const bool onAxis = nearest < 1e-4*mag(r);

                // Rodrigues' rotation from the owner to outside the face
                const scalar side = sign((axis ^ r) & n);
                const scalar sine = mag(r & n)/mag(r);
                const scalar angle =
                    side*(onAxis ? 2.0/3*constant::mathematical::pi
                                 : 2*std::asin(sine));
                const tensor K
                (
                    0, -axis.z(), axis.y(),
                    axis.z(), 0, -axis.x(),
                    -axis.y(), axis.x(), 0
                );
                M = tensor::I + std::sin(angle)*K
                  + (1 - std::cos(angle))*(K & K);

                vector toImage((M & r) - r);
                if (onAxis)
                {
                    // Two ghosts that count as one: the gradient of the
                    // square of the radius is then within 5 % of its value
                    lsqWeight_[f] = 0.5;
                }
                else
                {
                    toImage -= (toImage & r)*r/magSqr(r);
                }
                for (int d = 0; d < nDim_; d++)
                {
                    delta[f*nDim_ + d] = toImage[direction_[d]];
                    radial_[(f - nInternal_)*nDim_ + d] =
                        r[direction_[d]]/mag(r);
                }
            }

            double* m = &image_[(f - nInternal_)*nDim_*nDim_];
            for (int d = 0; d < nDim_; d++)
            {
                for (int k = 0; k < nDim_; k++)
                {
                    m[d*nDim_ + k] = M(direction_[d], direction_[k]);
                }
            }
        }
    }
}


void Foam::gasMesh::setRadii()
{
    const wedgePolyPatch* wedge = nullptr;
    for (const polyPatch& pp : mesh_.boundaryMesh())
    {
        if (!wedge && isA<wedgePolyPatch>(pp))
        {
            wedge = &refCast<const wedgePolyPatch>(pp);
        }
    }
    if (!wedge)
    {
        return;
    }

    const vector along(normalised(wedge->axis()));
    const vector side(normalised(wedge->centreNormal() ^ along));
    for (int d = 0; d < nDim_; d++)
    {
        axis.push_back(along[direction_[d]]);
        away.push_back(side[direction_[d]]);
    }

    inverseRadius.assign(nSlots(), 0);
    for (label c = 0; c < nCells_; c++)
    {
        inverseRadius[c] = 1/(mesh_.cellCentres()[c] & side);
    }
    faceRadius.resize(nFaces_);
    for (label f = 0; f < nFaces_; f++)
    {
        const label c = owner[f];
        faceRadius[f] = mesh_.cellCentres()[c] & side;
        for (int d = 0; d < nDim_; d++)
        {
            faceRadius[f] += toFace[f*nDim_ + d]*away[d];
        }
    }
    exchange(inverseRadius.data(), 1);
}


void Foam::gasMesh::turning
(
    const label f,
    double* radial,
    double* around
) const
{
    const double* n = &normal[f*nDim_];
    const double* r = &radial_[(f - nInternal_)*nDim_];
    double nr = 0;
    for (int d = 0; d < nDim_; d++)
    {
        nr += n[d]*r[d];
    }
    const double inverse = 1/std::sqrt(1 - nr*nr);
    for (int d = 0; d < nDim_; d++)
    {
        radial[d] = r[d];
        around[d] = (n[d] - nr*r[d])*inverse;
    }
}


void Foam::gasMesh::reflect(double* states) const
{
    const int nVar = nDim_ + 2;
    for (const patchRange& patch : patches_)
    {
        if (!patch.image())
        {
            continue;
        }
        for (label f = patch.start; f < patch.start + patch.size; f++)
        {
            const double* q = &states[owner[f]*nVar];
            const double* m = &image_[(f - nInternal_)*nDim_*nDim_];
            double* ghost = &states[far[f]*nVar];
            ghost[0] = q[0];
            ghost[1] = q[1];
            for (int d = 0; d < nDim_; d++)
            {
                double sum = 0;
                for (int k = 0; k < nDim_; k++)
                {
                    sum += m[d*nDim_ + k]*q[2 + k];
                }
                ghost[2 + d] = sum;
            }
        }
    }
}


void Foam::gasMesh::reflectGradients(double* gradients) const
{
    const int nVar = nDim_ + 2;
    for (const patchRange& patch : patches_)
    {
        if (!patch.symmetry)
        {
            continue;
        }
        for (label f = patch.start; f < patch.start + patch.size; f++)
        {
            const double* g = &gradients[owner[f]*nVar*nDim_];
            const double* m = &image_[(f - nInternal_)*nDim_*nDim_];
            double* ghost = &gradients[far[f]*nVar*nDim_];

            // The direction of the derivative, then the vector
            for (int d = 0; d < nDim_; d++)
            {
                double turned[5];
                for (int k = 0; k < nVar; k++)
                {
                    turned[k] = 0;
                    for (int e = 0; e < nDim_; e++)
                    {
                        turned[k] += m[d*nDim_ + e]*g[e*nVar + k];
                    }
                }
                ghost[d*nVar] = turned[0];
                ghost[d*nVar + 1] = turned[1];
                for (int k = 0; k < nDim_; k++)
                {
                    double sum = 0;
                    for (int e = 0; e < nDim_; e++)
                    {
                        sum += m[k*nDim_ + e]*turned[2 + e];
                    }
                    ghost[d*nVar + 2 + k] = sum;
                }
            }
        }
    }
}


void Foam::gasMesh::setLeastSquares(const boolList& excluded)
{
    std::vector<bool> takesPart(nFaces_, true);
    for (const patchRange& patch : patches_)
    {
        for (label i = 0; i < patch.size; i++)
        {
            takesPart[patch.start + i] = !excluded[patch.patchi];
        }
    }

    std::vector<symmTensor> moment(nCells_, symmTensor::zero);

    auto deltaOf = [&](const label f)
    {
        vector d(Zero);
        for (int k = 0; k < nDim_; k++)
        {
            d[k] = delta[f*nDim_ + k];
        }
        return d;
    };

    for (label f = 0; f < nFaces_; f++)
    {
        if (takesPart[f])
        {
            const vector d(deltaOf(f));
            const symmTensor dd(lsqWeight_[f]*sqr(d)/magSqr(d));
            moment[owner[f]] += dd;
            if (f < nInternal_)
            {
                moment[far[f]] += dd;
            }
        }
    }

    flat.assign(nCells_, 0);
    for (const int c : unaligned)
    {
        const symmTensor& m = moment[c];
        const vector spread
        (
            nDim_ == 3
          ? eigenValues(m)
          : eigenValues
            (
                symmTensor(m.xx(), m.xy(), 0, m.yy(), 0, 4*(m.xx() + m.yy()))
            )
        );
        // (in ascending order)
        flat[c] = spread[0] < 0.1*spread[nDim_ - 1];
    }

    // Directions in which a cell has no neighbours get no gradient: the
    // moment of a unit stencil there keeps the matrix regular without adding
    // to the gradient
    for (label c = 0; c < nCells_; c++)
    {
        symmTensor& m = moment[c];
        if (nDim_ == 2)
        {
            m.zz() += 1;
        }
        vector d(m.xx(), m.yy(), m.zz());
        const scalar small = 1e-8*cmptMax(d);
        if (m.xx() < small) m.xx() = 1;
        if (m.yy() < small) m.yy() = 1;
        if (m.zz() < small) m.zz() = 1;
        if (det(m) < 1e-10*m.xx()*m.yy()*m.zz())
        {
            // All neighbours on one line that is not a coordinate axis
            m += 1e-6*cmptMax(d)*symmTensor::I;
        }
    }

    lsqOwner.assign(nFaces_*nDim_, 0);
    lsqFar.assign(nFaces_*nDim_, 0);

    std::vector<symmTensor> inverse(nCells_);
    for (label c = 0; c < nCells_; c++)
    {
        inverse[c] = inv(moment[c]);
    }

    for (label f = 0; f < nFaces_; f++)
    {
        if (takesPart[f])
        {
            const vector d(deltaOf(f));
            const vector lo
            (
                (inverse[owner[f]] & d)*lsqWeight_[f]/magSqr(d)
            );
            const vector lf
            (
                f < nInternal_
              ? (inverse[far[f]] & d)/magSqr(d)
              : vector(Zero)
            );
            for (int k = 0; k < nDim_; k++)
            {
                lsqOwner[f*nDim_ + k] = lo[k];
                lsqFar[f*nDim_ + k] = lf[k];
            }
        }
    }
}


Foam::gasMesh::gasMesh(const fvMesh& mesh)
:
    mesh_(mesh)
{
    setDirections();
    setFaces();
    setImages();
    setAlignment();

    sendBuffer_.setSize(mesh.boundaryMesh().size());
    setRadii();
}


void Foam::gasMesh::interpolateAMI
(
    const cyclicAMIPolyPatch& patch,
    const double* values,
    const int n,
    double* ghost
)
{
    const labelUList& here = patch.faceCells();
    const labelUList& there = patch.neighbPatch().faceCells();
    const bool lowWeights = patch.applyLowWeightCorrection();
    scalarField behind(there.size());
    scalarField own(lowWeights ? here.size() : 0);

    for (int k = 0; k < n; k++)
    {
        forAll(behind, i)
        {
            behind[i] = values[n*there[i] + k];
        }
        forAll(own, i)
        {
            own[i] = values[n*here[i] + k];
        }
        const scalarField seen(patch.interpolate(behind, own));
        forAll(seen, i)
        {
            ghost[n*i + k] = seen[i];
        }
    }
}


void Foam::gasMesh::exchange(double* values, const int n) const
{
    const polyBoundaryMesh& boundary = mesh_.boundaryMesh();

    // First what waits for its own messages, so that no others are on the way
    for (const patchRange& patch : patches_)
    {
        const polyPatch& pp = boundary[patch.patchi];
        if (patch.coupled && isA<cyclicAMIPolyPatch>(pp))
        {
            interpolateAMI
            (
                refCast<const cyclicAMIPolyPatch>(pp),
                values,
                n,
                values + n*(nCells_ + patch.start - nInternal_)
            );
        }
    }

    const label startOfRequests = Pstream::nRequests();

    for (const patchRange& patch : patches_)
    {
        if
        (
            !patch.coupled
         || isA<cyclicAMIPolyPatch>(boundary[patch.patchi])
        )
        {
            continue;
        }
        const polyPatch& pp = boundary[patch.patchi];
        double* ghost = values + n*(nCells_ + patch.start - nInternal_);

        if (isA<cyclicPolyPatch>(pp))
        {
            const labelUList& behind =
                refCast<const cyclicPolyPatch>(pp).neighbPatch().faceCells();
            forAll(behind, i)
            {
                const double* from = values + n*behind[i];
                std::copy(from, from + n, ghost + n*i);
            }
            continue;
        }

        const processorPolyPatch& ppp = refCast<const processorPolyPatch>(pp);
        const labelUList& cells = pp.faceCells();
        List<double>& send = sendBuffer_[patch.patchi];
        send.setSize(n*patch.size);
        forAll(cells, i)
        {
            const double* from = values + n*cells[i];
            std::copy(from, from + n, send.begin() + n*i);
        }

        UIPstream::read
        (
            Pstream::commsTypes::nonBlocking,
            ppp.neighbProcNo(),
            reinterpret_cast<char*>(ghost),
            n*patch.size*sizeof(double),
            ppp.tag(),
            ppp.comm()
        );
        UOPstream::write
        (
            Pstream::commsTypes::nonBlocking,
            ppp.neighbProcNo(),
            reinterpret_cast<const char*>(send.begin()),
            n*patch.size*sizeof(double),
            ppp.tag(),
            ppp.comm()
        );
    }

    if (Pstream::parRun())
    {
        Pstream::waitRequests(startOfRequests);
    }
}
