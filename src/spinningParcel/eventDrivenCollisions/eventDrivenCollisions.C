/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "eventDrivenCollisions.H"
#include "NoDispersion.H"
#include "wedgePolyPatch.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::eventDrivenCollisions::checkCloud() const
{
    const auto refuseHere =
        [&](const char* entry, const word& value, const char* range)
        {
            refuse
            (
                dict_, entry, value, range, " with collisions eventDriven"
            );
        };
    if
    (
        !isA<NoDispersion<basicSpinningCloud::kinematicCloudType>>
            (cloud_.dispersion())
    )
    {
        refuseHere("dispersionModel", cloud_.dispersion().type(), "none");
    }
    if (cloud_.solution().cellValueSourceCorrection())
    {
        refuseHere("cellValueSourceCorrection", "on", "off");
    }
    if (cloud_.solution().steadyState())
    {
        refuseHere("transient", "no", "yes");
    }
    if (cloud_.mesh().dynamic())
    {
        refuseHere("collisions", "eventDriven", "off on a moving mesh");
    }
    const label n = cloud_.mesh().nGeometricD();
    if (dimension_ != n || n < 2)
    {
        refuse
        (
            dict_, "dimension", dimension_, "2 or 3, that of this mesh: ", n,
            ". A thin three-dimensional slab needs a mesh of that thickness"
            " between cyclic patches"
        );
    }

    if (dimension_ == 2)
    {
        checkThickness();
    }
}


void Foam::eventDrivenCollisions::checkThickness() const
{
    // The number of real particles of a parcel refers to one thickness, and
    // parcels meet as circles in a plane: in a wedge neither holds
    const polyMesh& mesh = cloud_.mesh();
    bool even = true;
    for (const polyPatch& patch : mesh.boundaryMesh())
    {
        even = even && !isA<wedgePolyPatch>(patch);
    }
    const boundBox& box = mesh.bounds();
    for (direction k = 0; k < 3; ++k)
    {
        if (mesh.geometricD()[k] != 1)
        {
            const scalar tolerance = 1e-6*box.span()[k];
            for (const point& p : mesh.points())
            {
                even =
                    even
                 && (
                        p[k] - box.min()[k] < tolerance
                     || box.max()[k] - p[k] < tolerance
                    );
            }
        }
    }
    if (!returnReduce(even, andOp<bool>()))
    {
        refuse
        (
            dict_, "collisions", "eventDriven", "off on a wedge or another"
            " mesh of varying thickness. Collisions need a plane mesh of one"
            " thickness or three dimensions"
        );
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::eventDrivenCollisions::eventDrivenCollisions
(
    basicSpinningCloud& cloud,
    const dictionary& dict
)
:
    injectedParcels(cloud, dict),
    restingLaw_
    (
        impact::reboundCoefficient::constant
        (
            impact::reboundCoefficient::restitutionQuantity(), 0
        ),
        law_.friction(), law_.spin(), law_.tangentialRestitution()
    ),
    step_(domain_, duration_, maxEvents)
{
    const polyMesh& mesh = cloud.mesh();
    for (label k = 0; k < 3; ++k)
    {
        if (mesh.geometricD()[k] != 1)
        {
            slabThickness_ = mesh.bounds().span()[k];
        }
    }
    refuseOthers
    (
        dict,
        {
            "type", "restitution", "friction", "tangentialRestitution",
            "contactDuration", "dimension", "slabThickness",
            "overlappingInjection"
        }
    );
    slabThickness_ =
        getNumber(dict, "slabThickness", validRange::length, slabThickness_);
    checkCloud();

    Info<< "Selecting parcel collisions eventDriven: " << dimension_
        << " dimensions, restitution " << law_.restitution().describe()
        << ", friction " << law_.friction().describe()
        << ", contact duration " << duration_.value() << " s" << endl;
    if (Pstream::parRun())
    {
        territories_.reset
        (
            new rankTerritories(mesh, domain_, directions_)
        );
        Info<< "    Each of " << Pstream::nProcs() << " ranks orders the"
            << " events of its parcels, with those near it as its halo"
            << endl;
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::eventDrivenCollisions::motion(trackingData& td)
{
    td.part() = trackingData::tpLinearTrack;
    td_ = &td;
    deltaT_ = cloud_.solution().trackTime();
    report_ = report();
    planned_.clear();

    collect();
    admitInjected();
    planAll();
    if (Pstream::parRun())
    {
        handOn();
    }

    std::string failure;
    try
    {
        if (Pstream::parRun())
        {
            settle();
        }
        else
        {
            step_.run(*this, deltaT_);
        }
    }
    catch (const std::runtime_error& error)
    {
        failure = error.what();
    }
    catch (const std::invalid_argument& error)
    {
        failure = error.what();
    }
    if (!failure.empty())
    {
        FatalErrorInFunction
            << "Cloud " << cloud_.name() << ": " << failure
            << exit(FatalError);
    }
    const impact::collisionCounts& counts = step_.counts();
    report_.wallEvents = counts.wallEvents;
    report_.deepestOverlap = counts.deepestOverlap;
    work_[2] += counts.candidates;
    work_[3] += counts.late;
    if (Pstream::parRun())
    {
        commitAll();
    }

    for (flight& f : flights_)
    {
        if (!f.parcel)
        {
            continue;
        }
        if (f.ghost)
        {
            delete f.parcel;
            continue;
        }
        act(f);
        if (!f.keep)
        {
            cloud_.deleteParticle(*f.parcel);
        }
    }
    finish();
}


void Foam::eventDrivenCollisions::info()
{
    FixedList<scalar, 9> step
    ({
        report_.pairEvents, report_.wallEvents,
        report_.restitutionLoss, report_.frictionLoss,
        report_.overlappingInjection, report_.rankPairs, report_.handOvers,
        report_.held, report_.heldEnergy
    });
    forAll(step, i)
    {
        reduce(step[i], sumOp<scalar>());
        totals_[i] += step[i];
    }
    const scalar overlap =
        returnReduce(report_.deepestOverlap, maxOp<scalar>());
    if (overlap > deepest_)
    {
        scalar smallest = VGREAT;
        for (const scalar d : arrays().d)
        {
            smallest = min(smallest, d);
        }
        for (const parcelType& p : cloud_.objects())
        {
            smallest = min(smallest, p.d());
        }
        reduce(smallest, minOp<scalar>());
        const scalar bound = 1e-3*smallest;
        if (deepest_ <= bound && overlap > bound)
        {
            WarningInFunction
                << "Spheres overlap by " << overlap << " m, the smallest have"
                << " a diameter of " << smallest << " m. Those that began so"
                << " (with collisions switched on, or put there by others)"
                << " part as they move; until then they are no gas of hard"
                << " spheres" << endl;
        }
        deepest_ = overlap;
    }
    const auto line =
        [&](const char* text, const label i)
        {
            Info<< text << step[i] << ", " << step[i + 1]
                << "; in all " << totals_[i] << ", " << totals_[i + 1]
                << nl;
        };
    const auto byRank =
        [](const char* text, const scalar n)
        {
            scalarList all(Pstream::nProcs(), scalar(0));
            all[Pstream::myProcNo()] = n;
            Pstream::gatherList(all);
            Info<< "    " << text << " =";
            for (const scalar k : all)
            {
                Info<< ' ' << int64_t(k);
            }
            Info<< nl;
        };
    line("    Pair, boundary events           = ", 0);
    Info<< "    Deepest overlap                 = " << overlap
        << "; in all " << deepest_ << nl;
    line("    Lost to restitution, friction   = ", 2);
    if (totals_[7] > 0)
    {
        line("    Held parcels, their energy      = ", 7);
    }
    if (Pstream::parRun())
    {
        line("    Pairs, hand-overs between ranks = ", 5);
        byRank("Parcels of each rank           ", work_[0]);
        byRank("Halo of each rank              ", work_[1]);
    }
    byRank("Pairs searched by each rank    ", work_[2]);
    const scalar late = returnReduce(work_[3], sumOp<scalar>());
    if (late > 0)
    {
        Info<< "    Pairs searched out of order     = " << late << nl;
    }
    if (totals_[4] > 0)
    {
        Info<< "    Injections upon others          = " << step[4]
            << "; in all " << totals_[4]
            << (separate_ ? ", separated" : ", refused") << nl;
        const bool first = totals_[4] == step[4];
        if (!separate_ && first)
        {
            WarningInFunction
                << "Parcels injected upon others have been taken out again,"
                << " and those to come will be (collisionModel,"
                << " overlappingInjection refuse): fewer fly than the"
                << " injection says. 'overlappingInjection separate;' moves"
                << " them apart. Stock injections move parcels by part of a"
                << " step first: shorter steps let more of them in" << endl;
        }
    }
}
