/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "basicSpinningCloud.H"
#include "checked.H"
#include "IFstream.H"
#include "rankMail.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::basicSpinningCloud::readFlights()
{
    IOobject xHeader(fieldIOobject(exactPosition, IOobject::MUST_READ));
    IOobject cellHeader(fieldIOobject(convexCell, IOobject::MUST_READ));
    const bool there =
        embedded_.valid()
     && xHeader.typeHeaderOk<IOField<vector>>(false)
     && cellHeader.typeHeaderOk<IOField<label>>(false);
    if (!there)
    {
        return;
    }
    IOField<vector> x(xHeader);
    IOField<label> cell(cellHeader);
    checkFieldIOobject(*this, x);
    checkFieldIOobject(*this, cell);
    label i = 0;
    for (parcelType& p : *this)
    {
        const label celli = cell[i];
        if (celli < 0 || p.cell() < 0)
        {
            ++i;
            continue;
        }
        const scalar reach = 1e-9*cbrt(mesh().cellVolumes()[p.cell()]);

        // Cells have other numbers on another decomposition. In warped cells
        // the stock's coordinates may not reach the place
        const impact::vector3 at(toCore(x[i]));
        const bool inside =
            celli < cells().size() && cells().meshCell(celli) == p.cell()
         && cells().height(celli, at) < reach;
        if (inside || mag(x[i] - p.position()) < reach)
        {
            p.setFlight
            ({
                at, inside ? celli : cells().locate(p.cell(), at)
            });
        }
        ++i;
    }
}


void Foam::basicSpinningCloud::checkTemperatures()
{
    label without = 0;
    for (parcelType& p : *this)
    {
        scalar& T = p.temperature();
        if (!heat_.valid())
        {
            T = 0;
        }
        else if (T == 0)
        {
            T = heat_->T0();
            ++without;
        }
        else if (!(T > 0 && T < 1e8))
        {
            FatalErrorInFunction
                << "File " << fieldIOobject("T", IOobject::NO_READ)
                   .objectPath()
                << " has a temperature of " << T << " K: valid range "
                << validRange::temperature << exit(FatalError);
        }
    }
    reduce(without, sumOp<label>());
    if (without)
    {
        Info<< "Parcels without a temperature, which begin at T0 "
            << heat_->T0() << " K: " << without << endl;
    }
}


void Foam::basicSpinningCloud::checkPlaces() const
{
    // The places are written besides the coordinates in the cells
    IOobject header(fieldIOobject("positions", IOobject::MUST_READ));
    pointField x;
    if (header.typeHeaderOk<cloud>(false))
    {
        IFstream is(header.objectPath());
        header.readHeader(is);
        x.setSize(readLabel(is));
        is.readBeginList("positions");
        struct
        {
            point x;
            label cell;
        } place;
        for (point& position : x)
        {
            if (is.format() == IOstream::ASCII)
            {
                is >> place.x >> place.cell;
            }
            else
            {
                is.read
                (
                    reinterpret_cast<char*>(&place),
                    sizeof(point) + sizeof(label)
                );
            }
            position = place.x;
        }
        if (!is.good())
        {
            x.clear();
        }
    }

    // (those that other programs have written may be of other parcels)
    label nElsewhere = 0;
    if (x.size() == size())
    {
        label i = 0;
        for (const parcelType& p : *this)
        {
            if (p.cell() >= 0)
            {
                // (round values of text may be rounder than cells are wide)
                const scalar near =
                    cbrt(mesh().cellVolumes()[p.cell()])
                  + 1e-5*mag(x[i]);
                nElsewhere += mag(x[i] - p.position()) > near;
            }
            ++i;
        }
    }
    reduce(nElsewhere, sumOp<label>());
    const label nAll = returnReduce(size(), sumOp<label>());
    if (nElsewhere > nAll/2)
    {
        FatalErrorInFunction
            << "Of the parcels in " << header.path() << ' ' << nElsewhere
            << " of " << nAll << " are not where their positions are: the"
            << " cells of the mesh have other numbers or places than when"
            << " they were written (renumberMesh, transformPoints)." << nl
            << "Put back the mesh as it was, and change it before parcels are"
            << " injected" << exit(FatalError);
    }
}


void Foam::basicSpinningCloud::checkIdentities()
{
    // To the rank that an identity falls to, which learns of two of one
    struct carrier
    {
        std::uint64_t identity;
        label rank;
        label index;
    };
    const label me = Pstream::myProcNo();
    const std::uint64_t nRanks = Pstream::nProcs();
    const auto exchange = [&](rankMail::post& out)
    {
        const std::string own(std::move(out[me]));
        out[me].clear();
        rankMail::post in(nRanks);
        if (nRanks > 1)
        {
            in = rankMail::exchange(out);
        }
        in[me] = own;
        return in;
    };

    label greatest = -1;
    label given = -1;
    rankMail::post out(nRanks);
    label i = 0;
    for (const parcelType& p : *this)
    {
        const label id = p.origId();
        given = max(given, id);
        const std::uint64_t identity =
            std::uint64_t(std::uint32_t(p.origProc())) << 32
          | std::uint32_t(id);
        rankMail::append
        (
            out[std::uint32_t(id) % nRanks], carrier{identity, me, i++}
        );
        if (p.origProc() == renamedProc)
        {
            greatest = max(greatest, id);
        }
    }

    // Stock models count on from what their rank has given, which is not known
    // of other numbers of ranks
    reduce(given, maxOp<label>());
    parcelType::particleCount_ = max(parcelType::particleCount_, given + 1);

    std::vector<carrier> carriers;
    for (const std::string& bytes : exchange(out))
    {
        rankMail::take(bytes, carriers);
    }
    std::sort
    (
        carriers.begin(), carriers.end(),
        [](const carrier& a, const carrier& b)
        {
            return
                std::tie(a.identity, a.rank, a.index)
              < std::tie(b.identity, b.rank, b.index);
        }
    );
    out.assign(nRanks, std::string());
    for (std::size_t k = 0; k < carriers.size(); ++k)
    {
        const carrier& c = carriers[k];
        const bool none = std::int32_t(c.identity) < 0;
        if (none || (k && carriers[k - 1].identity == c.identity))
        {
            rankMail::append(out[c.rank], c.index);
        }
    }
    std::vector<label> renamed;
    for (const std::string& bytes : exchange(out))
    {
        rankMail::take(bytes, renamed);
    }

    labelList counts(nRanks, 0);
    counts[me] = renamed.size();
    Pstream::listCombineGather(counts, plusEqOp<label>());
    Pstream::listCombineScatter(counts);
    const label n = sum(counts);
    reduce(greatest, maxOp<label>());
    if (!n)
    {
        return;
    }
    label next = greatest + 1 + sum(SubList<label>(counts, me));
    std::sort(renamed.begin(), renamed.end());
    i = 0;
    auto place = renamed.begin();
    for (parcelType& p : *this)
    {
        if (place != renamed.end() && *place == i++)
        {
            p.origProc() = renamedProc;
            p.origId() = next++;
            ++place;
        }
    }
    WarningInFunction
        << "Cloud " << name() << ": " << n << " parcels have no origId"
        << " of their own (foamFormatConvert takes all of them away; other"
        << " clouds mapped or added to this one repeat them) and are numbered"
        << " anew." << nl
        << "    What is known of them by it, first impacts and random numbers"
        << " in particular, begins anew" << endl;
}
