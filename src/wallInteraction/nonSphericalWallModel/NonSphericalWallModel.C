/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "NonSphericalWallModel.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

template<class CloudType>
void Foam::NonSphericalWallModel<CloudType>::compareWithFaces
(
    const dictionary& dict,
    const wallData& wall,
    const impact::relief& relief,
    const label setting
) const
{
    const bool rough = relief.type() == impact::relief::reliefType::rough;
    const scalar pitch = rough ? 2*relief.meanSpacing() : relief.period();
    const vector lay(normalised(wall.layDirection));
    scalar size = GREAT;
    scalar along = -1;
    const polyBoundaryMesh& boundary = this->owner().pMesh().boundaryMesh();
    forAll(this->patches().ofPatch(), patchi)
    {
        if (this->patches().of(patchi) == setting)
        {
            for (const vector& S : boundary[patchi].faceAreas())
            {
                size = min(size, sqrt(mag(S)));
                along = max(along, mag(lay ^ S)/mag(S));
            }
        }
    }
    reduce(size, minOp<scalar>());
    reduce(along, maxOp<scalar>());
    if (wall.lay == layType::fixed && along >= 0 && along < 1e-3)
    {
        refuse
        (
            dict, "layDirection", wall.layDirection,
            "a direction along the wall: this is the normal of all its faces"
        );
    }
    if (rough && pitch > size)
    {
        WarningInFunction
            << this->modelType() << ": the mean pitch of the relief, "
            << pitch << " m, is coarser than the smallest face of its"
            << " patches, " << size << " m: the mesh resolves what the relief"
            << " is to stand for" << endl;
    }
}


template<class CloudType>
Foam::Tuple2<Foam::scalar, Foam::scalar>
Foam::NonSphericalWallModel<CloudType>::readRange
(
    const dictionary& dict,
    const word& entry,
    const char* valid
)
{
    const auto range(dict.get<Tuple2<scalar, scalar>>(entry));
    checkNumber(dict, entry, range.first(), valid);
    checkNumber(dict, entry, range.second(), valid);
    if (range.first() > range.second())
    {
        refuse(dict, entry, range, "lowest <= highest");
    }
    return range;
}


template<class CloudType>
void Foam::NonSphericalWallModel<CloudType>::readTable
(
    const dictionary& dict,
    const fileName& casePath,
    const impact::wallEncounter& setup,
    wallData& wall
) const
{
    const fileName file(getFile(dict, "table", casePath));
    const Tuple2<scalar, scalar> incidences
    (
        readRange(dict, "incidenceRange", "(0, 90] deg")
    );
    Tuple2<scalar, scalar> speeds(0, 0);
    if (setup.law.dependsOnSpeed())
    {
        speeds = readRange(dict, "speedRange", validRange::speed);
    }
    else if (dict.found("speedRange"))
    {
        FatalIOErrorInFunction(dict)
            << "Entry speedRange: the law does not depend on the speed, its"
            << " table holds for every speed. Leave it out"
            << exit(FatalIOError);
    }
    wall.diameterTolerance =
        getNumber(dict, "diameterTolerance", "(0, 1)", scalar(0.01));
    checked
    (
        dict,
        [&]
        {
            wall.table = std::make_shared<const impact::scatteringTable>(file);
            wall.table->checkCovers
            (
                setup, incidences.first(), incidences.second(),
                speeds.first(), speeds.second()
            );
            return true;
        }
    );
    if (this->spins())
    {
        Info<< "    " << this->modelType() << ": a table holds arrivals"
            << " without spin; that of a parcel is used by method direct only"
            << endl;
    }
}


template<class CloudType>
typename Foam::NonSphericalWallModel<CloudType>::wallData
Foam::NonSphericalWallModel<CloudType>::readWall
(
    const dictionary& dict,
    const label setting
) const
{
    const word method
    (
        getWordOf(dict, "method", "direct", {"direct", "tabulated"})
    );
    const word lay
    (
        getWordOf
        (
            dict, "lay", "acrossMotion",
            {"acrossMotion", "acrossFlow", "fixed"}
        )
    );
    wordList valid
    {
        "type", "shape", "wall", "law", "orientation", "maxImpacts", "method",
        "lay"
    };
    if (method == "tabulated")
    {
        valid.append
        (
            wordList
            {
                "table", "incidenceRange", "speedRange", "diameterTolerance"
            }
        );
    }
    if (lay == "fixed")
    {
        valid.append("layDirection");
    }
    refuseOthers(dict, valid);
    const fileName casePath(this->owner().db().time().globalPath());
    impact::wallEncounter setup;
    scatteringEntries::read(dict, casePath, setup);

    wallData wall;
    wall.firstImpact =
        setup.treatment == impact::visitTreatment::firstImpact;
    wall.sized = bool(setup.wall);
    wall.maxImpacts = setup.maxImpacts;
    wall.layDirection = Zero;
    wall.diameterTolerance = 0;
    wall.lay =
        lay == "acrossMotion" ? layType::acrossMotion
      : lay == "acrossFlow" ? layType::acrossFlow : layType::fixed;
    if (wall.lay == layType::fixed)
    {
        wall.layDirection = getComponents(dict, "layDirection", "[-1e6, 1e6]");
        if (mag(wall.layDirection) < 1e-6)
        {
            refuse
            (
                dict, "layDirection", wall.layDirection, "any vector but zero"
            );
        }
    }
    if (setup.wall)
    {
        compareWithFaces(dict, wall, *setup.wall, setting);
    }

    if (method == "direct")
    {
        checked
        (
            dict,
            [&]
            {
                wall.direct.emplace(setup);
                return true;
            }
        );
        return wall;
    }

    if (wall.lay != layType::acrossMotion)
    {
        refuse
        (
            dict, "lay", lay, "acrossMotion with a table, which was sampled"
            " so; another lay needs method direct"
        );
    }
    readTable(dict, casePath, setup, wall);
    return wall;
}


template<class CloudType>
impact::wallFrame Foam::NonSphericalWallModel<CloudType>::frameOf
(
    const wallData& wall,
    const parcelType& p,
    const wallHit& hit
) const
{
    typedef impact::wallFrame frame;
    switch (wall.lay)
    {
        case layType::fixed:
        {
            return frame::along(hit.n, toCore(wall.layDirection));
        }
        case layType::acrossFlow:
        {
            const impact::vector3 flow =
                toCore(this->owner().U()[p.cell()] - hit.Uw);
            if (mag(cross(flow, hit.n)) > 1e-6*mag(hit.V0))
            {
                return frame::across(hit.n, flow);
            }
            break;
        }
        case layType::acrossMotion:
        {
            break;
        }
    }
    return frame::across(hit.n, hit.V0);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

template<class CloudType>
Foam::NonSphericalWallModel<CloudType>::NonSphericalWallModel
(
    const dictionary& dict,
    CloudType& owner
)
:
    ParcelWallModel<CloudType>
    (
        dict,
        owner,
        typeName,
        {
            "pulling impacts", "energy-gaining impacts", "capped",
            "incidence raised or held", "outside of coefficients",
            "speed held"
        },
        {"seed"}
    ),
    wallOf_(this->patches().size(), -1),
    keys_(scatteringEntries::getSeed(this->coeffDict()))
{
    const polyMesh& mesh = owner.pMesh();
    if
    (
        mesh.nGeometricD() < mesh.nSolutionD()
     && keepsToSolvedDirections<parcelType>
     && !parcelSpin::carried<parcelType>()
    )
    {
        FatalIOErrorInFunction(this->coeffDict())
            << "Entry patchInteractionModel " << typeName << ": it gives"
            << " parcels a velocity about the axis of a wedge, and those of a"
            << " stock cloud end the run where they meet a plane of the wedge."
            << nl << "Valid: a spinningKinematicCloud, whose parcels the planes"
            << " pass on to each other, or a sector between patches of type"
            << " symmetryPlane"
            << exit(FatalIOError);
    }
    forAll(wallOf_, i)
    {
        if (this->fate(i) == ParcelWallModel<CloudType>::fateType::rebound)
        {
            wallOf_[i] = label(walls_.size());
            walls_.push_back
            (
                readWall(wallPatches::law(this->patches()[i]), i)
            );
        }
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

template<class CloudType>
bool Foam::NonSphericalWallModel<CloudType>::correct
(
    parcelType& p,
    const polyPatch& pp,
    bool& keepParticle
)
{
    wallHit hit;
    if (!this->arrive(p, pp, keepParticle, hit))
    {
        return hit.handled;
    }

    wallData& wall = walls_[wallOf_[hit.setting]];
    const impact::wallFrame frame(frameOf(wall, p, hit));
    const impact::vector3 V = frame.toWall(hit.V0);
    const impact::impactKey k
    (
        keys_(p, this->owner().db().time().timeIndex())
    );

    impact::wallDeparture d;
    if (wall.direct)
    {
        d = wall.direct->depart
        (
            V, frame.toWall(toCore(hit.omega0)), p.d(), k
        );
    }
    else
    {
        const scalar held = wall.table->diameter();
        if (wall.sized && mag(p.d() - held) > wall.diameterTolerance*held)
        {
            FatalErrorInFunction
                << this->modelType() << ": the table of patch " << pp.name()
                << " holds particles of diameter " << held
                << " m, parcel (" << p.origProc() << ' ' << p.origId()
                << ") has " << p.d() << " m; diameterTolerance is "
                << wall.diameterTolerance
                << ". Use method direct for particles of several sizes"
                << exit(FatalError);
        }
        bool outside;
        d = wall.table->depart(V, p.d(), k, outside);
        d.raised = outside;
    }
    if (d.V.y <= 0 && keys_.repeat() >= uint32_t(wall.maxImpacts))
    {
        d.V.y = 0;
        d.capped = true;
    }

    hit.V1 = frame.fromWall(d.V);
    hit.omega1 = frame.fromWall(d.omega);
    hit.rotation0 =
        impact::sphereRotationalEnergy(hit.radius, toCore(hit.omega0));
    hit.rotation1 = d.rotation1;
    this->special(pp, 0) += d.pulling;
    this->special(pp, 1) += d.gaining;
    this->special(pp, 2) += d.capped;
    this->special(pp, 3) += d.raised;
    this->special(pp, 4) += d.outside;
    this->special(pp, 5) += d.held;
    this->leave(p, pp, hit);
    return true;
}
