/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "surfaceImpactStatistics.H"
#include "checked.H"
#include "PstreamReduceOps.H"
#include "coreVector.H"
#include "impactMeasures.H"
#include "pastWrite.H"

#include <algorithm>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::surfaceImpactStatistics::setPatches(const boolList& selected)
{
    DynamicList<label> patches;
    firstFace_.setSize(selected.size(), -1);
    patchItem_.setSize(selected.size(), -1);
    label nFaces = 0;
    forAll(selected, patchi)
    {
        if (selected[patchi])
        {
            patches.append(patchi);
            firstFace_[patchi] = nFaces;
            nFaces += mesh_.boundaryMesh()[patchi].size();
        }
    }
    patches_.transfer(patches);
}


void Foam::surfaceImpactStatistics::setAngle()
{
    const dictionary* axis = findBlock(dict_, "axis");
    if (!axis)
    {
        return;
    }
    refuseOthers(*axis, {"origin", "direction", "from", "binWidth", "folded"});
    const auto direction = [&](const word& entry)
    {
        const vector v(getComponents(*axis, entry, "[-1e6, 1e6]"));
        if (mag(v) < 1e-6)
        {
            refuse(*axis, entry, v, "any vector but zero");
        }
        return toCore(v);
    };
    checked
    (
        *axis,
        [&]
        {
            angle_.reset
            (
                new impact::angularBins
                (
                    toCore
                    (
                        getComponents
                        (
                            *axis, "origin", validRange::coordinate,
                            vector(Zero)
                        )
                    ),
                    direction("direction"),
                    direction("from"),
                    getNumber(*axis, "binWidth", "[0.1, 90] deg", scalar(1)),
                    axis->lookupOrDefault<bool>("folded", true)
                )
            );
            return true;
        }
    );
}


void Foam::surfaceImpactStatistics::setErosion()
{
    const dictionary* erosion = findBlock(dict_, "erosion");
    if (!erosion)
    {
        return;
    }
    const auto read = [&](const word& entry, const char* range, double& value)
    {
        value = getNumber(*erosion, entry, range, scalar(value));
    };
    if (getWordOf(*erosion, "model", "", {"Finnie", "Oka"}) == "Finnie")
    {
        refuseOthers(*erosion, {"model", "p", "psi", "K"});
        const double p = getNumber(*erosion, "p", validRange::modulus);
        double psi = 2, K = 2;
        read("psi", "(0, 100]", psi);
        read("K", "(0, 100]", K);
        checked
        (
            *erosion,
            [&]
            {
                erosion_.reset
                (
                    new impact::erosionLaw
                    (
                        impact::erosionLaw::finnie(p, psi, K)
                    )
                );
                return true;
            }
        );
        return;
    }

    refuseOthers
    (
        *erosion,
        {
            "model", "hardness", "n1", "n2", "K", "k1", "k2", "k3",
            "referenceSpeed", "referenceDiameter"
        }
    );
    const char* const exponent = "[-10, 10]";
    checked
    (
        *erosion,
        [&]
        {
            impact::erosionLaw::okaConstants c
            (
                getNumber
                (
                    *erosion, "hardness", "[1e-6, 150] GPa, a gel to diamond"
                )
            );
            read("n1", exponent, c.n1);
            read("n2", exponent, c.n2);
            read("K", "(0, 1e3] m3/kg, all of a wall lighter than air", c.K);
            read("k1", exponent, c.k1);
            read("k2", exponent, c.k2);
            read("k3", exponent, c.k3);
            read("referenceSpeed", "[1e-3, 1e6] m/s", c.referenceSpeed);
            read
            (
                "referenceDiameter", validRange::diameter, c.referenceDiameter
            );
            erosion_.reset
            (
                new impact::erosionLaw(impact::erosionLaw::oka(c))
            );
            return true;
        }
    );
}


void Foam::surfaceImpactStatistics::setHeat()
{
    const dictionary* heat = findBlock(dict_, "heat");
    if (heat)
    {
        refuseOthers(*heat, {"wallTemperature"});
        heat_ = true;
        if (heat->found("wallTemperature"))
        {
            wallTemperature_ =
                getNumber(*heat, "wallTemperature", validRange::temperature);
        }
        else if (!mesh_.foundObject<volScalarField>("T"))
        {
            FatalIOErrorInFunction(*heat)
                << "Entry wallTemperature is missing, and there is no field T"
                << " to take it from" << exit(FatalIOError);
        }
    }
}


Foam::scalar Foam::surfaceImpactStatistics::enthalpy
(
    const wallImpact& impact
) const
{
    return impact.mass*impact.enthalpyAbove
    (
        wallTemperature_ > 0
      ? wallTemperature_
      : mesh_.lookupObject<volScalarField>("T")
       .boundaryField()[impact.patch][impact.face]
    );
}


bool Foam::surfaceImpactStatistics::isRound(const polyPatch& pp) const
{
    bool round = true;
    const pointField::subField centres(pp.faceCentres());
    const vectorField::subField areas(pp.faceAreas());
    forAll(pp, i)
    {
        const impact::vector3 radial = angle_->normal(toCore(centres[i]));
        round = round
         && mag(impact::dot(radial, toCore(areas[i])))
          > roundness*mag(areas[i]);
    }
    return returnReduce(round, andOp<bool>());
}


void Foam::surfaceImpactStatistics::setAreas()
{
    const label nBins = angle_ ? angle_->size() : 0;
    round_.setSize(mesh_.boundaryMesh().size(), false);
    areas_.setSize(nBins + patches_.size(), 0);

    std::vector<double> binned(nBins, 0.0);
    std::vector<impact::vector3> polygon;
    forAll(patches_, i)
    {
        const polyPatch& pp = mesh_.boundaryMesh()[patches_[i]];
        patchItem_[patches_[i]] = nBins + i;
        areas_[nBins + i] = sum(mag(pp.faceAreas()));
        if (angle_)
        {
            round_[patches_[i]] = isRound(pp);
            for (const face& f : pp)
            {
                polygon.clear();
                for (const label pointi : f)
                {
                    polygon.push_back(toCore(mesh_.points()[pointi]));
                }
                angle_->addArea(polygon, binned);
            }
        }
    }
    std::copy(binned.begin(), binned.end(), areas_.begin());
    Pstream::listCombineGather(areas_, plusEqOp<scalar>());
    Pstream::listCombineScatter(areas_);

    // A patch that ends on the edge of a bin has a sliver beyond by round-off
    scalar largest = 0;
    for (label k = 0; k < nBins; ++k)
    {
        largest = max(largest, areas_[k]);
    }
    DynamicList<label> there;
    for (label k = 0; k < nBins; ++k)
    {
        if (areas_[k] > 1e-9*largest)
        {
            there.append(k);
        }
        else
        {
            areas_[k] = 0;
        }
    }
    nearestBin_.setSize(nBins);
    for (label k = 0; k < nBins; ++k)
    {
        nearestBin_[k] = k;
        label minDistance = labelMax;
        for (const label other : there)
        {
            if (mag(other - k) < minDistance)
            {
                minDistance = mag(other - k);
                nearestBin_[k] = other;
            }
        }
    }
}


void Foam::surfaceImpactStatistics::setStop()
{
    const dictionary* dict = findBlock(dict_, "stopAtError");
    if (!dict)
    {
        return;
    }
    stop_.reset(new stopping);
    refuseOthers(*dict, {"target", "bins", "quantities"});
    stop_->target = getNumber(*dict, "target", "(0, 1e6]");

    DynamicList<label> items;
    const label nBins = angle_ ? angle_->size() : 0;
    if (angle_)
    {
        const Tuple2<scalar, scalar> range
        (
            dict->get<Tuple2<scalar, scalar>>("bins")
        );
        for (label k = 0; k < nBins; ++k)
        {
            const scalar phi = angle_->centre(k);
            if (phi >= range.first() && phi <= range.second() && areas_[k] > 0)
            {
                items.append(k);
            }
        }
        if (items.empty())
        {
            refuse
            (
                *dict, "bins", range, "angles (from to) in degrees, from ",
                angle_->centre(0), " to ", angle_->centre(nBins - 1),
                ", with the centre of a bin that has some of the patches' area"
            );
        }
    }
    else
    {
        if (dict->found("bins"))
        {
            FatalIOErrorInFunction(*dict)
                << "Entry bins needs the entry axis: without it the error is"
                << " that of the patches" << exit(FatalIOError);
        }
        forAll(patches_, i)
        {
            items.append(nBins + i);
        }
    }
    stop_->items.transfer(items);

    wordList valid;
    for (label i = 0; i < nResults(); ++i)
    {
        valid.append(results_[i].name);
    }
    DynamicList<label> quantities;
    for
    (
        const word& name
      : dict->lookupOrDefault("quantities", wordList(1, "intensity"))
    )
    {
        const label i = valid.find(name);
        for (const result& r : allResults())
        {
            if (i < 0 && name == r.name)
            {
                FatalIOErrorInFunction(*dict)
                    << "Entry quantities: " << name << " needs the entry "
                    << r.entry << " of " << functionName_
                    << ", see etc/caseDicts/annotated/surfaceImpact"
                    << exit(FatalIOError);
            }
        }
        if (i < 0)
        {
            unknownWord(*dict, "quantities", name, valid);
        }
        quantities.append(i);
    }
    stop_->results.transfer(quantities);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::surfaceImpactStatistics::surfaceImpactStatistics
(
    const dictionary& dict,
    const word& cloudName,
    const word& functionName,
    const fvMesh& mesh,
    const boolList& patches
)
:
    dict_(dict),
    cloudName_(cloudName),
    functionName_(functionName),
    mesh_(mesh),
    threshold_(getNumber(dict, "threshold", "[0, 3e8) m/s", scalar(1))),
    normalThreshold_
        (getNumber(dict, "normalThreshold", "[0, 3e8) m/s", scalar(0))),
    restart_(cloudName, functionName, mesh, dict),
    window_(dict, functionName, mesh.time(), restart_.found())
{
    const label blocks = getNumber<label>(dict, "blocks", "[10, 1000]", 10);

    setPatches(patches);
    setAngle();
    setErosion();
    setHeat();
    for (const result& r : allResults())
    {
        if (!r.entry || dict.found(r.entry))
        {
            results_.push_back(r);
        }
    }
    setAreas();
    setStop();

    nQuantities_ = heat_ ? HEAT + 1 : erosion_ ? EROSION + 1 : EROSION;
    label nFaces = 0;
    for (const label patchi : patches_)
    {
        nFaces += mesh.boundaryMesh()[patchi].size();
    }
    bins_.reset
    (
        new impact::blockStatistics(areas_.size(), nQuantities_, blocks)
    );
    faces_.reset(new impact::blockStatistics(nFaces, nQuantities_, blocks));

    if (restart_.found())
    {
        readRestart();
        restart_.clear();
    }

    if (dict.lookupOrDefault<bool>("log", false))
    {
        log_.reset
        (
            new impactLog
            (
                cloudName,
                functionName,
                mesh.time(),
                mesh.boundaryMesh().names()
            )
        );
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::surfaceImpactStatistics::begin(const bool hot)
{
    if (heat_ && !hot)
    {
        FatalIOErrorInFunction(dict_)
            << "Entry heat: the parcels of " << cloudName_ << " have no"
            << " temperature." << nl << "Valid: a spinningKinematicCloud with"
            << " heatTransfer on, a stock thermo cloud, or no entry heat"
            << exit(FatalIOError);
    }
    if (mesh_.changing())
    {
        FatalErrorInFunction
            << functionName_ << ": the mesh moves or changes; the averages are"
            << " those over faces that stay." << nl
            << "Take the function out of cloudFunctions" << exit(FatalError);
    }
    fields_.clear();
    averaging_ = window_.open();
}


void Foam::surfaceImpactStatistics::take
(
    const wallImpact& i,
    const bool spinKnown,
    const bool reboundKnown
)
{
    const impact::vector3 v0 = toCore(i.U0 - i.Uw);
    const impact::vector3 wall = toCore(i.n);
    if (impact::dot(v0, wall) >= 0)
    {
        // Leaves the wall: the tracker's second meeting with the same face
        return;
    }

    impact::vector3 n = wall;
    pending p{-1, -1, -1, i.nParticle, -1};
    if (angle_)
    {
        const impact::vector3 x = toCore(i.position);
        if (round_[i.patch])
        {
            const impact::vector3 radial = angle_->normal(x);
            n = impact::dot(radial, wall) > 0 ? radial : -radial;
        }
        p.bin = nearestBin_[angle_->bin(x)];
    }

    const impact::impactMeasures measures(v0, n);
    if
    (
        !(measures.speed > threshold_)
     || measures.normalSpeed < normalThreshold_
    )
    {
        ++nSlow_;
        return;
    }

    p.patch = patchItem_[i.patch];
    p.face = firstFace_[i.patch] + i.face;

    if (averaging_)
    {
        double a[HEAT + 1];
        const double w = i.nParticle;
        const double mass = w*i.mass;
        a[NUMBER] = w;
        a[FIRST] = 0;
        a[NORMAL_SPEED] = w*measures.normalSpeed;
        a[ANGLE] = w*measures.angle;
        a[MASS] = mass;
        a[INCIDENT] =
            impact::impactMeasures::translationalLoss(mass, v0, {0, 0, 0})
          + w*i.rotationalEnergy0;
        a[LOST] = 0;
        a[LOST_TRANSLATIONAL] = 0;
        a[CAPTURED] = 0;
        a[IMPACTS] = 1;
        a[REBOUND_UNKNOWN] = !reboundKnown;
        if (reboundKnown)
        {
            const impact::vector3 v1 =
                i.captured ? impact::vector3{0, 0, 0} : toCore(i.U1 - i.Uw);
            a[LOST_TRANSLATIONAL] =
                impact::impactMeasures::translationalLoss(mass, v0, v1);
            a[LOST] = a[LOST_TRANSLATIONAL] + w
               *(
                    i.rotationalEnergy0
                  - (i.captured ? 0 : i.rotationalEnergy1)
                );
            a[CAPTURED] = i.captured ? mass : 0;
        }
        a[EROSION] = 0;
        if (heat_)
        {
            a[HEAT_INCIDENT] = w*enthalpy(i);
            a[HEAT] = a[LOST] + (i.captured ? a[HEAT_INCIDENT] : 0);
        }
        if (erosion_)
        {
            // Next to the rim of the patch a face may be steeper than the
            // normal of the axis has it
            a[EROSION] = w*erosion_->volume
            (
                i.mass,
                i.d,
                measures.speed,
                std::max(measures.angle, 0.0)
            );
        }

        const auto add = [&](impact::blockStatistics& to, const label item)
        {
            double* sums = &to.open()[item*nQuantities_];
            for (label q = 0; q < nQuantities_; ++q)
            {
                sums[q] += a[q];
            }
        };
        add(*faces_, p.face);
        add(*bins_, p.patch);
        if (p.bin >= 0)
        {
            add(*bins_, p.bin);
        }

        if (log_)
        {
            p.logged = log_->append(i, spinKnown, reboundKnown);
        }
    }
    else
    {
        p.bin = p.patch = p.face = -1;
    }

    firsts_.note(i.origProc, i.origId, i.time, pending_.size());
    pending_.append(p);
}


void Foam::surfaceImpactStatistics::end()
{
    for (const label index : firsts_.resolve())
    {
        const pending& p = pending_[index];
        if (p.face >= 0)
        {
            faces_->open()[p.face*nQuantities_ + FIRST] += p.nParticle;
            bins_->open()[p.patch*nQuantities_ + FIRST] += p.nParticle;
        }
        if (p.bin >= 0)
        {
            bins_->open()[p.bin*nQuantities_ + FIRST] += p.nParticle;
        }
        if (p.logged >= 0)
        {
            log_->setFirst(p.logged);
        }
    }
    pending_.clear();

    const Time& time = mesh_.time();
    const bool last = averagingWindow::lastStep(time);

    if (averaging_)
    {
        const bool full = bins_->advance(time.deltaTValue());
        faces_->advance(time.deltaTValue());
        if (full)
        {
            sumOverRanks();
            bins_->close();
            faces_->close();

            // An error that is looked at again and again will be below the
            // target by chance too early
            if
            (
                stop_ && !stopped_ && !last && bins_->errorsKnown()
             && largestError(true) < stop_->target
            )
            {
                // The solver does one more step, with a write
                stopped_ = true;
                met_ = largestError(false);
                time.stopAt(Time::saWriteNow);
            }
        }
    }

    if (time.writeTime() || last)
    {
        settle();
        if (log_)
        {
            log_->write();
        }
        if (angle_)
        {
            writeTable("byAngle.csv", "phi_deg", identity(angle_->size()));
        }
        labelList items(patches_.size());
        forAll(items, i)
        {
            items[i] = patchItem_[patches_[i]];
        }
        writeTable("byPatch.csv", "patch", items);
        report();
    }
    if (time.writeTime())
    {
        makeFields();
        for (const volScalarField& field : fields_)
        {
            pastWrite::catchUp(mesh_, field);
        }
        writeRestart();
    }
}
