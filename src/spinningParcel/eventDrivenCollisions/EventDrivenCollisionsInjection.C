/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "EventDrivenCollisions.H"
#include "mathematicalConstants.H"
#include "vicinity.H"
#include "wallLayer.H"

#include <algorithm>
#include <tuple>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

template<class CloudType>
typename Foam::EventDrivenCollisions<CloudType>::member
Foam::EventDrivenCollisions<CloudType>::memberOf(const std::int32_t i) const
{
    const freeMotion& q = freeMotions_[i];
    const scalar d = ownDiameter(i);
    const scalar rho = q.parcel ? q.parcel->rho() : arrays().rho[i];
    const scalar mass = rho*constant::mathematical::pi/6*pow3(d);
    return
    {
        ownIdentity(i), position(i), d, mass,
        {Pstream::myProcNo(), ~label(i)}, q.injected
    };
}


template<class CloudType>
std::vector<typename Foam::EventDrivenCollisions<CloudType>::memberPair>
Foam::EventDrivenCollisions<CloudType>::injectedUpon(const vicinity& ofNew)
{
    const label me = Pstream::myProcNo();
    const bool* periodic = step_.grid().domain().periodic;
    const bool all = periodic[0] || periodic[1] || periodic[2];
    std::vector<std::int32_t> own;
    std::vector<member> others;
    post out(Pstream::nProcs());
    for (std::size_t i = 0; i < freeMotions_.size(); ++i)
    {
        const freeMotion& q = freeMotions_[i];
        if (!q.injected && !all && !ofNew.near(position(i)))
        {
            continue;
        }
        own.push_back(i);
        if (!territories_.valid())
        {
            continue;
        }
        const member here(memberOf(i));
        const impact::sweptBox box(here.box());
        if (territories_->foreign(box))
        {
            for (label rank = 0; rank < Pstream::nProcs(); ++rank)
            {
                if (rank != me && territories_->near(rank, box))
                {
                    rankMail::append(out[rank], here);
                }
            }
        }
    }
    if (Pstream::parRun())
    {
        for (const std::string& bytes : rankMail::exchange(out))
        {
            rankMail::take(bytes, others);
        }
    }

    // All may be new: nothing is kept of them
    const std::int32_t nOwn = own.size();
    const auto memberAt = [&](const std::int32_t k)
    {
        return k < nOwn ? memberOf(own[k]) : others[k - nOwn];
    };
    impact::sweptGrid grid(step_.grid().domain());
    const std::int32_t nAll = nOwn + others.size();
    grid.resize(nAll);
    for (std::int32_t k = 0; k < nAll; ++k)
    {
        grid.box(k) = memberAt(k).box();
    }
    grid.build();
    std::vector<memberPair> pairs;
    grid.pairs
    (
        [&](std::int32_t i, std::int32_t j, std::int32_t image)
        {
            member a = memberAt(i), b = memberAt(j);
            if (b.identity < a.identity)
            {
                std::swap(a, b);
                image = 2*impact::sweptGrid::noImage - image;
            }

            // The rank of the lower identity has the pair
            if ((a.injected || b.injected) && a.where.rank == me)
            {
                pairs.push_back({a, b, image});
            }
        }
    );
    rankMail::gather(pairs);
    const auto key = [](const memberPair& c)
    {
        return std::make_tuple(c.a.identity, c.b.identity, c.image);
    };
    std::sort
    (
        pairs.begin(), pairs.end(),
        [&](const memberPair& a, const memberPair& b)
        {
            return key(a) < key(b);
        }
    );
    return pairs;
}


template<class CloudType>
void Foam::EventDrivenCollisions<CloudType>::displaceMember
(
    member& a,
    const vector& way
)
{
    trajectory c;
    c.home = a.where;
    mission m{DISPLACE, 0};
    m.way = way;
    m.injected = a.injected;
    fly(c, m);
    a.where = c.home;
    a.x = m.way;
}


template<class CloudType>
Foam::labelPair Foam::EventDrivenCollisions<CloudType>::part
(
    const std::vector<memberPair>& pairs
)
{
    // A parcel may be in several pairs
    std::unordered_map<std::uint64_t, member> members;
    std::unordered_map<std::uint64_t, bool> removed;
    labelPair n(0, 0);
    const auto released = [](const member& m)
    {
        return
            m.injected
         && m.identity >> 32 == std::uint64_t(wallLayer::releasedProc);
    };
    for (const memberPair& c : pairs)
    {
        member& a = members.emplace(c.a.identity, c.a).first->second;
        member& b = members.emplace(c.b.identity, c.b).first->second;
        const vector s = solved
        (
            b.x - a.x
          + (
                c.image == impact::sweptGrid::noImage
              ? vector(Zero)
              : fromCore(step_.grid().shift(c.image))
            )
        );
        const scalar sigma = 0.5*(a.d + b.d);
        const scalar overlap = sigma - mag(s);
        if
        (
            overlap <= 1e-12*sigma
         || removed[a.identity] || removed[b.identity]
        )
        {
            continue;
        }

        // What comes off a layer does so where a parcel has just struck it
        const bool injected = !released(a) && !released(b);
        ++n.first();
        n.second() += injected;
        if (!separate_ && injected)
        {
            // The later of the two goes
            const member& late = b.injected ? b : a;
            removed[late.identity] = true;
            ask(late.where.rank, {REMOVE, late.where.slot, {PLAN, 0}});
            continue;
        }
        vector along(Zero);
        along[directions_.x() > 0 ? 0 : 1] = 1;
        const vector e = mag(s) > 1e-9*sigma ? s/mag(s) : along;
        const scalar share = b.mass/(a.mass + b.mass);
        const scalar way = (1 + 1e-9)*overlap;
        displaceMember(a, -share*way*e);
        displaceMember(b, (1 - share)*way*e);
    }
    return n;
}


template<class CloudType>
void Foam::EventDrivenCollisions<CloudType>::admitInjected()
{
    if (!returnReduce(anyNew_, orOp<bool>()))
    {
        return;
    }
    const scalar largest = returnReduce(largest_, maxOp<scalar>());
    if (territories_.valid())
    {
        territories_->setReach(largest, true);
    }

    // Others matter near new parcels only, or at the ends of a period
    vicinity ofNew(bounds_, directions_);
    for (std::size_t i = 0; i < freeMotions_.size(); ++i)
    {
        if (freeMotions_[i].injected)
        {
            ofNew.add(position(i), 2*largest);
        }
    }
    ofNew.reduce();

    // Moving a pair apart may bring one of them upon a third
    for (label sweep = 0; sweep < 20; ++sweep)
    {
        const std::vector<memberPair> pairs = injectedUpon(ofNew);
        label nOverlaps = 0;
        if (Pstream::master())
        {
            const labelPair n = part(pairs);
            buffer_.clear();
            dismiss();
            nOverlaps = n.first();
            if (sweep == 0)
            {
                report_.overlappingInjection = n.second();
            }
        }
        else
        {
            serve(Pstream::masterNo());
        }
        regroup();
        Pstream::scatter(nOverlaps);
        if (nOverlaps == 0)
        {
            break;
        }
    }
}
