/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.

Description
    Results, tables, fields and restart of surfaceImpactStatistics.
\*---------------------------------------------------------------------------*/

#include "surfaceImpactStatistics.H"
#include "csvFile.H"
#include "OSspecific.H"
#include "PstreamReduceOps.H"
#include "calculatedFvPatchFields.H"
#include "surfaceFields.H"
#include "unitConversion.H"

#include <algorithm>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

const std::vector<Foam::surfaceImpactStatistics::result>&
Foam::surfaceImpactStatistics::allResults()
{
    const label rate = AREA_AND_TIME;
    const dimensionSet number(inv(dimArea*dimTime));
    const dimensionSet mass(dimMass/dimArea/dimTime);
    const dimensionSet power(dimPower/dimArea);
    const scalar year = 365.25*86400;
    const char* none = nullptr;

    static const std::vector<result> all
    ({
        {"intensity", NUMBER, rate, false, number, none, none, 1},
        {"firstIntensity", FIRST, rate, false, number, none, none, 1},
        {
            "meanNormalSpeed", NORMAL_SPEED, NUMBER, false, dimVelocity,
            none, none, 1
        },
        {"specificPower", LOST, rate, true, power, none, none, 1},
        {
            "specificPowerTranslational", LOST_TRANSLATIONAL, rate, true,
            power, none, none, 1
        },
        {
            "impactAngle", ANGLE, NUMBER, false, dimless, none, none,
            radToDeg()
        },
        {"massFlux", MASS, rate, false, mass, none, none, 1},
        {"specificPowerIncident", INCIDENT, rate, false, power, none, none, 1},
        {"capturedMassFlux", CAPTURED, rate, true, mass, none, none, 1},
        {"erosionRate", EROSION, rate, false, dimVelocity, "erosion", none, 1},
        {
            "wearRate", EROSION, rate, false, dimless, "erosion", "mm/year",
            1e3*year
        },
        {
            "specificErosion", EROSION, MASS, false, dimless, "erosion",
            "mm3/kg", 1e9
        },
        {
            "specificHeatIncident", HEAT_INCIDENT, rate, false, power, "heat",
            none, 1
        },
        {"heatFlux", HEAT, rate, true, power, "heat", none, 1}
    });
    return all;
}


Foam::word Foam::surfaceImpactStatistics::result::column
(
    const bool error
) const
{
    std::string s(name);
    s += error ? "Error" : "";
    if (unit)
    {
        s += std::string("_") + unit;
        s.replace(s.find('/'), 1, "_per_");
    }
    return word(s);
}


impact::blockStatistics::estimate Foam::surfaceImpactStatistics::estimate
(
    const impact::blockStatistics& statistics,
    const label item,
    const result& r,
    const scalar area
) const
{
    impact::blockStatistics::estimate e =
        r.per == AREA_AND_TIME
      ? statistics.rate(item, r.sum)
      : statistics.ratio(item, r.sum, r.per);

    const scalar scale =
        r.per != AREA_AND_TIME ? r.scale : area > 0 ? r.scale/area : 0;
    e.value *= scale;
    if (e.error >= 0)
    {
        // No impact at all is no certainty
        e.error = statistics.sum(item, IMPACTS) > 0 ? e.error*scale : -1;
    }
    return e;
}


bool Foam::surfaceImpactStatistics::known
(
    const impact::blockStatistics& statistics,
    const label item,
    const result& r
)
{
    return
        (!r.needsRebound || statistics.sum(item, REBOUND_UNKNOWN) == 0)
     && (r.per == AREA_AND_TIME || statistics.sum(item, IMPACTS) > 0);
}


Foam::scalar Foam::surfaceImpactStatistics::largestError
(
    const bool bounded
) const
{
    // A patch without faces has no error to wait for
    scalar largest = 0;
    bool any = false;
    for (const label item : stop_->items)
    {
        if (!(areas_[item] > 0))
        {
            continue;
        }
        any = true;
        for (const label i : stop_->results)
        {
            const result& r = results_[i];
            const auto e = estimate(*bins_, item, r, areas_[item]);
            if (!known(*bins_, item, r) || e.error < 0 || e.value == 0)
            {
                return GREAT;
            }
            const scalar factor =
                bounded
              ? impact::blockStatistics::errorBound(e.nBlocks) : scalar(1);
            largest = max(largest, factor*e.error/mag(e.value));
        }
    }
    return any ? largest : GREAT;
}


void Foam::surfaceImpactStatistics::sumOverRanks()
{
    if (Pstream::parRun())
    {
        std::vector<double>& open = bins_->open();
        scalarList sums(label(open.size()));
        std::copy(open.begin(), open.end(), sums.begin());
        Pstream::listCombineGather(sums, plusEqOp<scalar>());
        Pstream::listCombineScatter(sums);
        std::copy(sums.begin(), sums.end(), open.begin());
    }
}


void Foam::surfaceImpactStatistics::settle()
{
    sumOverRanks();
    bins_->settle();
    faces_->settle();
}


void Foam::surfaceImpactStatistics::writeTable
(
    const word& name,
    const string& firstColumn,
    const labelList& items
) const
{
    if (!Pstream::master())
    {
        return;
    }
    const fileName folder
    (
        impactLog::folder(cloudName_, functionName_, mesh_.time())
       /mesh_.time().timeName()
    );
    mkDir(folder);
    // Five results, the parcels, their errors; then each with its error
    const label nLeading = 5;
    const std::vector<result>& all = results_;
    std::string header(firstColumn);
    for (label i = 0; i < nLeading; ++i)
    {
        header += ',' + all[i].column(false);
    }
    header += ",nImpacts";
    for (label i = 0; i < nLeading; ++i)
    {
        header += ',' + all[i].column(true);
    }
    for (label i = nLeading; i < nResults(); ++i)
    {
        header += ',' + all[i].column(false) + ',' + all[i].column(true);
    }
    csvFile file(folder/name, header + ",area,reboundKnown");

    for (const label item : items)
    {
        if (!(areas_[item] > 0))
        {
            continue;
        }
        if (angle_ && item < angle_->size())
        {
            file.add(angle_->centre(item));
        }
        else
        {
            const label nBins = angle_ ? angle_->size() : 0;
            file.add(mesh_.boundaryMesh()[patches_[item - nBins]].name());
        }

        const auto value = [&](const label i)
        {
            file.add
            (
                known(*bins_, item, all[i]),
                estimate(*bins_, item, all[i], areas_[item]).value
            );
        };
        const auto error = [&](const label i)
        {
            const scalar e =
                estimate(*bins_, item, all[i], areas_[item]).error;
            file.add(known(*bins_, item, all[i]) && e >= 0, e);
        };

        for (label i = 0; i < nLeading; ++i)
        {
            value(i);
        }
        file.add(bins_->sum(item, IMPACTS));
        for (label i = 0; i < nLeading; ++i)
        {
            error(i);
        }
        for (label i = nLeading; i < nResults(); ++i)
        {
            value(i);
            error(i);
        }
        file.row(areas_[item], bins_->sum(item, REBOUND_UNKNOWN) == 0);
    }
}


Foam::volScalarField& Foam::surfaceImpactStatistics::makeField
(
    const word& name,
    const dimensionSet& dimensions
)
{
    fields_.append
    (
        new volScalarField
        (
            IOobject
            (
                cloudName_ + ":" + functionName_ + ":" + name,
                mesh_.time().timeName(),
                mesh_,
                IOobject::NO_READ,
                IOobject::AUTO_WRITE
            ),
            mesh_,
            dimensionedScalar(dimensions, Zero),
            calculatedFvPatchScalarField::typeName
        )
    );
    return fields_.last();
}


void Foam::surfaceImpactStatistics::makeFields()
{
    // Results that need the rebound where no patch tells it are left out
    bool reboundKnown = false;
    for (const label patchi : patches_)
    {
        const label item = patchItem_[patchi];
        reboundKnown =
            reboundKnown || bins_->sum(item, REBOUND_UNKNOWN) == 0;
    }

    fields_.clear();
    for (label i = 0; i < nResults(); ++i)
    {
        const result& r = results_[i];
        if (r.needsRebound && !reboundKnown)
        {
            continue;
        }
        for (const bool error : {false, true})
        {
            if (error && !faces_->errorsKnown())
            {
                continue;
            }
            volScalarField& field =
                makeField(word(r.name) + (error ? "Error" : ""), r.dimensions);
            if (r.unit)
            {
                // Into the head of the file: no dimensions are millimetres
                field.note() = r.unit;
            }
            for (const label patchi : patches_)
            {
                fvPatchScalarField& values = field.boundaryFieldRef()[patchi];
                const scalarField& areas =
                    mesh_.magSf().boundaryField()[patchi];
                forAll(values, facei)
                {
                    const label item = firstFace_[patchi] + facei;
                    if (known(*faces_, item, r))
                    {
                        const auto e =
                            estimate(*faces_, item, r, areas[facei]);
                        values[facei] = error ? max(e.error, 0.0) : e.value;
                    }
                }
            }

            // The function object wallHeatFlux counts what the gas receives
            const volScalarField* gas =
                r.sum == HEAT && !error
              ? mesh_.findObject<volScalarField>("wallHeatFlux")
              : nullptr;
            if (gas)
            {
                volScalarField& load = makeField("heatLoad", r.dimensions);
                for (const label patchi : patches_)
                {
                    load.boundaryFieldRef()[patchi] ==
                        field.boundaryField()[patchi]
                      - gas->boundaryField()[patchi];
                }
            }
        }
    }
}


void Foam::surfaceImpactStatistics::reportWear() const
{
    for (const label patchi : patches_)
    {
        const label item = patchItem_[patchi];
        Info<< "    wear of " << mesh_.boundaryMesh()[patchi].name();
        const char* separator = ": ";
        for (const result& r : results_)
        {
            if (r.sum == EROSION && r.unit && known(*bins_, item, r))
            {
                const auto e = estimate(*bins_, item, r, areas_[item]);
                Info<< separator << e.value;
                if (e.error >= 0)
                {
                    Info<< " +- " << e.error;
                }
                Info<< ' ' << r.unit;
                separator = ", ";
            }
        }
        Info<< nl << "        (" << 1e9*bins_->sum(item, EROSION)
            << " mm3 by " << bins_->sum(item, MASS) << " kg)" << nl;
    }
}


void Foam::surfaceImpactStatistics::report() const
{
    const scalar time = bins_->time();
    scalar number = 0;
    scalar parcels = 0;
    scalar mass = 0;
    scalar captured = 0;
    scalar lost = 0;
    scalar unknown = 0;
    for (const label patchi : patches_)
    {
        const label item = patchItem_[patchi];
        number += bins_->sum(item, NUMBER);
        parcels += bins_->sum(item, IMPACTS);
        mass += bins_->sum(item, MASS);
        captured += bins_->sum(item, CAPTURED);
        lost += bins_->sum(item, LOST);
        unknown += bins_->sum(item, REBOUND_UNKNOWN);
    }
    const label slow = returnReduce(nSlow_, sumOp<label>());

    Info<< functionName_ << " of " << cloudName_ << ": averaged over " << time
        << " s in " << label(bins_->nBlocks()) << " blocks" << nl
        << "    impacts of parcels               = " << parcels << nl
        << "    impacts of particles, their mass = " << number << ", " << mass
        << " kg" << nl
        << "    parcels that have hit            = " << firsts_.size() << nl
        << "    too slow to count (this run)     = " << slow << nl;
    if (unknown < parcels || parcels == 0)
    {
        Info<< "    captured mass, energy lost       = " << captured << " kg, "
            << lost << " J" << nl;
    }
    if (unknown > 0)
    {
        Info<< "    rebound unknown (stock wall model) for " << unknown
            << " impacts" << nl;
    }
    if (erosion_)
    {
        reportWear();
    }
    if (stop_)
    {
        const scalar error = bins_->errorsKnown() ? largestError(false) : GREAT;
        Info<< "    largest relative error           = ";
        if (error < GREAT)
        {
            Info<< error;
        }
        else
        {
            Info<< "not yet known";
        }
        Info<< ", target " << stop_->target << nl;
        if (stopped_)
        {
            // (the step with the last write may have closed another block)
            Info<< "    the target is met: " << met_
                << ", the run ends" << nl;
        }
    }
    Info<< endl;
}


// * * * * * * * * * * * * * * * Restart * * * * * * * * * * * * * * * * * * //

Foam::scalarList Foam::surfaceImpactStatistics::settings() const
{
    scalarList s({threshold_, window_.start(), scalar(bins_->minBlocks())});
    if (normalThreshold_ > 0)
    {
        s.append(normalThreshold_);
    }
    if (angle_)
    {
        // Positions whose bins tell origin, axis, direction and width
        s.append(angle_->size());
        s.append(angle_->centre(0));
        for
        (
            const impact::vector3& x
          : {
                impact::vector3{0, 0, 0}, impact::vector3{1, 0, 0},
                impact::vector3{0, 1, 0}, impact::vector3{0, 0, 1}
            }
        )
        {
            s.append(angle_->phi(x));
        }
    }
    if (erosion_)
    {
        // Volumes that tell the law and its constants
        s.append(erosion_->volume(1, 1e-4, 100, 0.3));
        s.append(erosion_->volume(1, 1e-4, 50, 0.8));
        s.append(erosion_->volume(1, 2e-4, 100, 1.2));
    }
    if (heat_)
    {
        s.append(wallTemperature_);
    }
    return s;
}


void Foam::surfaceImpactStatistics::writeRestart()
{
    // Faces of all ranks: patch, centre, sums
    const label nSums = label(faces_->nBlocks() + 1)*nQuantities_;
    List<scalarList> sent(Pstream::nProcs());
    {
        scalarList& mine = sent[Pstream::myProcNo()];
        mine.setSize(label(faces_->nItems())*(4 + nSums));
        label at = 0;
        for (const label patchi : patches_)
        {
            const vectorField::subField centres
            (
                mesh_.boundaryMesh()[patchi].faceCentres()
            );
            forAll(centres, facei)
            {
                mine[at++] = patchi;
                mine[at++] = centres[facei].x();
                mine[at++] = centres[facei].y();
                mine[at++] = centres[facei].z();
                for (const double x : faces_->state(firstFace_[patchi] + facei))
                {
                    mine[at++] = x;
                }
            }
        }
    }
    Pstream::gatherList(sent);

    labelList labels;
    scalarList scalars;
    if (Pstream::master())
    {
        // In an order that does not depend on the decomposition
        DynamicList<const scalar*> faces;
        for (const scalarList& list : sent)
        {
            for (label i = 0; i < list.size(); i += 4 + nSums)
            {
                faces.append(&list[i]);
            }
        }
        std::sort
        (
            faces.begin(),
            faces.end(),
            [](const scalar* a, const scalar* b)
            {
                return std::lexicographical_compare(a, a + 4, b, b + 4);
            }
        );

        const scalarList s(settings());
        const std::vector<double> times(bins_->times());
        DynamicList<scalar> all
        (
            s.size() + label(times.size())
          + (label(bins_->nItems()) + faces.size())*(4 + nSums)
        );
        for (const scalar x : s)
        {
            all.append(x);
        }
        for (const double x : times)
        {
            all.append(x);
        }
        for (std::size_t item = 0; item < bins_->nItems(); ++item)
        {
            for (const double x : bins_->state(item))
            {
                all.append(x);
            }
        }
        for (const scalar* f : faces)
        {
            for (label i = 0; i < 4 + nSums; ++i)
            {
                all.append(f[i]);
            }
        }
        scalars.transfer(all);

        labels =
            labelList
            ({
                s.size(),
                label(times.size()),
                label(bins_->nItems()),
                nQuantities_,
                faces.size()
            });
        labels.append(firsts_.labels());
    }
    restart_.set(std::move(labels), std::move(scalars));
}


void Foam::surfaceImpactStatistics::readRestart()
{
    const labelList& labels = restart_.labels();
    const scalarList& scalars = restart_.scalars();

    const auto refuse = [this](const char* what)
    {
        FatalIOErrorInFunction(dict_)
            << functionName_ << ": the averages kept in "
            << restart_.objectPath() << " were made with other " << what
            << ". Restore those, or begin new averages with restart anew;"
            << exit(FatalIOError);
    };

    const scalarList mine(settings());
    bool same =
        labels.size() >= 5 && labels[0] == mine.size()
     && labels[2] == label(bins_->nItems()) && labels[3] == nQuantities_;
    for (label i = 0; same && i < mine.size(); ++i)
    {
        same = scalars[i] == mine[i];
    }
    if (!same)
    {
        refuse
        (
            "settings (patches, thresholds, start of the window, blocks, axis,"
            " erosion)"
        );
    }
    if
    (
        labels[4]
     != returnReduce(label(faces_->nItems()), sumOp<label>())
    )
    {
        refuse("faces of the patches");
    }

    label at = mine.size();
    const std::vector<double> times
    (
        &scalars[at],
        &scalars[at] + labels[1]
    );
    at += labels[1];
    bins_->setTimes(times);
    faces_->setTimes(times);
    const label nSums = label(bins_->nBlocks() + 1)*nQuantities_;
    for (std::size_t item = 0; item < bins_->nItems(); ++item)
    {
        bins_->setState(item, &scalars[at], nSums);
        at += nSums;
    }

    // Faces are known by their patch and centre
    const scalar* faces = &scalars[0] + at;
    const label width = 4 + nSums;
    for (const label patchi : patches_)
    {
        const vectorField::subField centres
        (
            mesh_.boundaryMesh()[patchi].faceCentres()
        );
        forAll(centres, facei)
        {
            const scalar key[4] =
            {
                scalar(patchi),
                centres[facei].x(),
                centres[facei].y(),
                centres[facei].z()
            };
            label low = 0;
            label high = labels[4];
            while (low < high)
            {
                const label middle = (low + high)/2;
                const scalar* f = faces + middle*width;
                if (std::lexicographical_compare(f, f + 4, key, key + 4))
                {
                    low = middle + 1;
                }
                else
                {
                    high = middle;
                }
            }
            const scalar* f = faces + low*width;
            if (low == labels[4] || !std::equal(f, f + 4, key))
            {
                refuse("faces of the patches");
            }
            faces_->setState(firstFace_[patchi] + facei, f + 4, nSums);
        }
    }

    firsts_.set(SubList<label>(labels, labels.size() - 5, 5));
}
