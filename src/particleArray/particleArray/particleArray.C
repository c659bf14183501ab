/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "particleArray.H"

#include <cstring>

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

template<class Payload>
Foam::particleArray<Payload>::particleArray(const convexCells& cells)
:
    cells_(cells),
    start_(cells.size() + 1, 0),
    outgoing_(Pstream::nProcs())
{
    cells.refuseUnknownPairs();
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

template<class Payload>
template<class Boundary>
void Foam::particleArray<Payload>::walk
(
    const label i,
    scalar time,
    Boundary& boundary
)
{
    const vector& moving = cells_.moving();
    impact::vector3 x = position(i);
    const auto track = [&]()
    {
        return impact::vector3
            {moving.x()*u_[i], moving.y()*v_[i], moving.z()*w_[i]};
    };
    impact::vector3 u = track();
    label celli = cell_[i];
    label nHits = 0;

    // Straight flight from x since 'flown'
    scalar flown = 0;
    for (label crossing = 0; crossing < maxCrossings; ++crossing)
    {
        label place = -1;
        const scalar exit = cells_.exitTime(celli, x, u, time, place);
        if (place == -1)
        {
            x = x + time*u;
            setPosition(i, x);
            cell_[i] = celli;
            return;
        }
        flown = max(flown, exit);
        const impact::vector3 hit = x + flown*u;
        const label next = cells_.behind(place, hit);
        if (next >= 0)
        {
            celli = next;
            continue;
        }

        const label facei = -1 - next;
        const convexCells::boundaryFace& face = cells_.boundary()[facei];
        x = hit;
        time -= flown;
        flown = 0;
        switch (face.kind)
        {
            case convexCells::mirror:
            {
                const impact::vector3 n = cells_.normal(place);
                const impact::vector3 all = velocity(i);
                setVelocity(i, all - 2*dot(all, n)*n);
                turnAxial(i, [&n](const impact::vector3& w)
                {
                    return 2*dot(w, n)*n - w;
                });
                u = track();
                break;
            }
            case convexCells::wall:
            {
                setPosition(i, x);
                cell_[i] = celli;
                const impact::vector3 n = cells_.normal(place);
                if (!boundary.hitWall(i, facei, n, nHits++, time))
                {
                    cell_[i] = -1;
                    return;
                }
                u = track();
                break;
            }
            case convexCells::cyclic:
            {
                if (face.rotation >= 0)
                {
                    const convexCells::rotation& r = cells_.rotationOf(face);
                    const vector to =
                        r.to + (r.T & (vector(x.x, x.y, x.z) - r.from));
                    const vector turned =
                        r.T & vector(u_[i], v_[i], w_[i]);
                    x = {to.x(), to.y(), to.z()};
                    setVelocity(i, {turned.x(), turned.y(), turned.z()});
                    turnAxial(i, [&r](const impact::vector3& w)
                    {
                        const vector v = r.T & vector(w.x, w.y, w.z);
                        return impact::vector3{v.x(), v.y(), v.z()};
                    });
                    u = track();
                }
                else
                {
                    x = x + face.shift;
                }
                celli = cells_.inside(face.mate, x);
                break;
            }
            case convexCells::processor:
            {
                x = x + face.shift;
                setPosition(i, x);
                send(i, facei, time);
                cell_[i] = -1;
                return;
            }
            case convexCells::open:
            {
                setPosition(i, x);
                boundary.leave(i, facei);
                cell_[i] = -1;
                return;
            }
        }
    }

    ++nLost_;
    cell_[i] = -1;
}


template<class Payload>
void Foam::particleArray<Payload>::send
(
    const label i,
    const label boundaryFacei,
    const scalar time
)
{
    const convexCells::boundaryFace& face = cells_.boundary()[boundaryFacei];
    std::string& out = outgoing_[face.processor];
    rankMail::append(out, std::int32_t(face.mate));
    rankMail::append(out, time);
    forEach([&](const char*, const auto& array)
    {
        rankMail::append(out, array[i]);
    });
}


template<class Payload>
template<class Boundary>
void Foam::particleArray<Payload>::exchange(Boundary& boundary)
{
    if (!Pstream::parRun())
    {
        return;
    }

    while (rankMail::any(outgoing_))
    {
        const label first = size();
        std::vector<double> times;
        for (const std::string& bytes : rankMail::exchange(outgoing_))
        {
            const char* p = bytes.data();
            const char* last = p + bytes.size();
            const auto get = [&p](auto& value)
            {
                std::memcpy(&value, p, sizeof(value));
                p += sizeof(value);
            };
            while (p < last)
            {
                std::int32_t facei;
                double time;
                get(facei);
                get(time);
                times.push_back(time);
                cell_.push_back(facei);
                forEach([&](const char*, auto& array)
                {
                    array.emplace_back();
                    get(array.back());
                });
            }
        }
        for (label i = first; i < first + label(times.size()); ++i)
        {
            cell_[i] = cells_.inside(cell_[i], position(i));
            walk(i, times[i - first], boundary);
        }
    }
}


template<class Payload>
void Foam::particleArray<Payload>::sort()
{
    const label n = size();
    const label nCells = cells_.size();
    if (!n && !start_.back())
    {
        return;
    }

    std::fill(start_.begin(), start_.end(), 0);
    for (label i = 0; i < n; ++i)
    {
        if (cell_[i] >= 0)
        {
            ++start_[cell_[i]];
        }
    }
    std::int32_t sum = 0;
    for (label c = 0; c <= nCells; ++c)
    {
        const std::int32_t here = c < nCells ? start_[c] : 0;
        start_[c] = sum;
        sum += here;
    }

    // Removed particles go behind the others and are cut off
    const std::int32_t nAlive = sum;
    std::int32_t nDead = 0;
    place_.resize(n);
    for (label i = 0; i < n; ++i)
    {
        place_[i] = cell_[i] >= 0 ? start_[cell_[i]]++ : nAlive + nDead++;
    }
    for (label c = nCells; c > 0; --c)
    {
        start_[c] = start_[c - 1];
    }
    start_[0] = 0;

    const std::int32_t* place = place_.data();
    const auto scatter = [&](const char*, auto& array)
    {
        auto& other = spare(array);
        other.resize(n);
        const auto* from = array.data();
        auto* to = other.data();
        for (label i = 0; i < n; ++i)
        {
            to[place[i]] = from[i];
        }
        array.swap(other);
        array.resize(nAlive);
    };
    forEach(scatter);

    cell_.resize(nAlive);
    for (label c = 0; c < nCells; ++c)
    {
        for (std::int32_t i = start_[c]; i < start_[c + 1]; ++i)
        {
            cell_[i] = c;
        }
    }
    fraction_.clear();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

template<class Payload>
Foam::label Foam::particleArray<Payload>::append
(
    const label celli,
    const impact::vector3& x,
    const impact::vector3& u,
    const scalar fraction
)
{
    forEach([](const char*, auto& array) { array.emplace_back(); });
    cell_.push_back(celli);
    fraction_.push_back(fraction);

    const label i = size() - 1;
    setPosition(i, x);
    setVelocity(i, u);
    return i;
}


template<class Payload>
template<class Boundary>
void Foam::particleArray<Payload>::move(const scalar dt, Boundary& boundary)
{
    const vector dts = dt*cells_.moving();
    const label nSorted = start_.back();
    const label nAppended = size() - nSorted;

    leavers_.resize(nSorted + 1);
    stopped_.resize(nSorted + 1);
    const label nStopped = walkKernels::fly
    (
        nSorted ? cells_.size() : 0,
        start_.data(),
        cells_.shapes(),
        x(), y(), z(),
        u(), v(), w(),
        dts.cdata(),
        cell_.data(),
        leavers_.data(),
        stopped_.data()
    );
    for (label k = 0; k < nStopped; ++k)
    {
        walk(stopped_[k], dt, boundary);
    }
    for (label k = 0; k < nAppended; ++k)
    {
        walk(nSorted + k, fraction_[k]*dt, boundary);
    }
    exchange(boundary);
    sort();
}
