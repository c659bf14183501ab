/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "scatteringSampler.H"
#include "blockLoop.H"
#include "philoxLanes.H"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>

namespace
{

//- Uniform numbers of one particle for one purpose
struct draws
{
    double u0, u1, u2;

    draws
    (
        std::uint64_t seed,
        std::uint32_t block,
        std::uint32_t purpose,
        std::int64_t particle
    )
    {
        std::uint64_t w0, w1, w2, w3;
        impact::philoxLane
        (
            seed, block, purpose, std::uint64_t(particle), w0, w1, w2, w3
        );
        impact::threeUnits(w0, w1, w2, w3, u0, u1, u2);
    }
};


//- Numbers of the lanes that may come back; with 'decide' less those that
//  surely do, which are counted
int mayReturn
(
    int n,
    const impact::smoothBody& body,
    const impact::smoothLanes& lanes,
    bool decide,
    int* id,
    int& surely
)
{
    double may[impact::smoothBatch];
    impact::smoothCull(n, body, lanes, may);
    surely = 0;
    int m = 0;
    for (int i = 0; i < n; ++i)
    {
        const bool sure = decide && may[i] == 2;
        id[m] = i;
        m += may[i] > 0 && !sure;
        surely += sure;
    }
    return m;
}


//- Move the flights that go on to the front, return their number
int keepInFlight(int n, impact::smoothFlights& f)
{
    int keep[impact::smoothBatch + 1];
    int m = 0;
    for (int i = 0; i < n; ++i)
    {
        keep[m] = i;
        m += f.status[i] == 0;
    }
    if (m == n)
    {
        return m;
    }
    typedef impact::smoothFlights::lane lane;
    lane* const fields[] =
    {
        &f.ey[0], &f.ey[1], &f.ey[2], &f.w[0], &f.w[1], &f.w[2],
        &f.axisL[0], &f.axisL[1], &f.axisL[2], &f.rateL, &f.rateAxis,
        &f.y, &f.Vy, &f.t, &f.gap, &f.tau, &f.reach, &f.least, &f.status
    };
    for (lane* field : fields)
    {
        double* x = *field;
        for (int i = 0; i < m; ++i)
        {
            x[i] = x[keep[i]];
        }
    }
    for (int i = 0; i < m; ++i)
    {
        f.id[i] = f.id[keep[i]];
    }
    return m;
}


//- Copy state and contact point of n lanes; a null list is 0, 1, 2, ...
void copyLanes
(
    int n,
    const int* from,
    const int* to,
    const impact::smoothLanes& a,
    impact::smoothLanes& b
)
{
    for (int c = 0; c < 3; ++c)
    {
        for (int i = 0; i < n; ++i)
        {
            const int p = from ? from[i] : i;
            const int q = to ? to[i] : i;
            b.ex[c][q] = a.ex[c][p];
            b.ey[c][q] = a.ey[c][p];
            b.w[c][q] = a.w[c][p];
            b.V[c][q] = a.V[c][p];
            b.r[c][q] = a.r[c][p];
        }
    }
    for (int i = 0; i < n; ++i)
    {
        b.approach[to ? to[i] : i] = a.approach[from ? from[i] : i];
    }
}


//- Counts over the visits of a block
struct visitCounts
{
    std::int64_t impacts = 0, micro = 0, into = 0, second = 0;
    std::int64_t pulling = 0, gaining = 0, capped = 0;

    //- What an impact or more of one visit add
    void addImpacts(const impact::visitResult& r)
    {
        impacts += r.impacts;
        micro += r.microImpacts;
        pulling += r.pulling;
        gaining += r.gaining;
        capped += r.capped;
    }

    void addTo(impact::scatteringStatistics& result) const
    {
        typedef impact::scatteringStatistics S;
        result.count(S::impacts, impacts);
        result.count(S::microImpacts, micro);
        result.count(S::intoWall, into);
        result.count(S::secondImpact, second);
        result.count(S::pulling, pulling);
        result.count(S::gaining, gaining);
        result.count(S::capped, capped);
    }
};

} // End anonymous namespace


struct impact::scatteringSampler::workspace
{
    reliefPiece piece;
    std::int64_t pieceIdentity = -1;

    //- Velocities after the last impact, by particle of the block
    double Vx[blockSize], Vy[blockSize], Vz[blockSize];
    double spinEnergy[blockSize];
    unsigned char profileBlock[blockSize];

    smoothLanes lanes, struck, start;
    smoothFlights flights;

    workspace(const relief& r, std::uint64_t seed)
    :
        piece(r, seed),
        flights()
    {
        std::fill_n(flights.ey[0], smoothBatch, 1.);
    }
};


impact::scatteringSampler::scatteringSampler(const setup& s)
:
    setup_(s),
    flat_(relief::flat(1e3*s.body.radius())),
    visit_(setup_.body, s.law, s.treatment, s.maxImpacts)
{
    auto check = [](bool ok, const char* name, double value, const char* range)
    {
        if (!ok)
        {
            std::ostringstream text;
            text<< name << ' ' << value << ": valid range " << range;
            throw std::invalid_argument(text.str());
        }
    };
    check
    (
        s.incidence > 0 && s.incidence <= 90,
        "incidence", s.incidence, "(0, 90] (degrees)"
    );
    check(s.speed > 0 && s.speed < 1e100, "speed", s.speed, "(0, inf) (m/s)");
    for (int i = 0; i < 3; ++i)
    {
        check
        (
            std::fabs(s.spin[i]) < 1e100,
            "spin", s.spin[i], "finite (rad/s)"
        );
    }
    check(s.maxImpacts > 0, "maxImpacts", s.maxImpacts, "> 0");

    double sine, cosine;
    sinCosTurns(s.incidence/360, sine, cosine);
    if (s.incidence == 90)
    {
        cosine = 0;
    }
    V1_ = {s.speed*cosine, -s.speed*sine, 0};

    const convexBody& body = setup_.body;
    smooth_.ellipsoid = body.shape() == convexBody::shapeType::ellipsoid;
    for (int i = 0; i < 3; ++i)
    {
        smooth_.a[i] = body.semiAxes()[i];
        smooth_.J[i] = body.inertia()[i];
        for (const vector3& v : body.vertices())
        {
            vertices_.push_back(v[i]);
        }
    }
    smooth_.axis = body.symmetryAxis();
    smooth_.radius = body.radius();

    // The support h(m) of the body along the turning normal m has
    // h'' >= -(h - rho) |m'|^2 - |r_t| |m''_t|: rho the least radius of
    // curvature, r_t the offset of the contact point from the normal
    const double R = body.radius();
    const vector3& semi = body.semiAxes();
    const double least = std::min({semi.x, semi.y, semi.z});
    const double rho = body.leastCurvature();
    smooth_.offset = smooth_.ellipsoid ? R - least : R;
    smooth_.bend = 1.0001
       *(R - rho + smooth_.offset*freeRotation::skewness(body));
    smooth_.nVertices = int(body.vertices().size());
    const bool simple = smooth_.ellipsoid || body.isBox();
    smooth_.vertices = simple ? nullptr : vertices_.data();
    smooth_.normal = s.law.normal();
    smooth_.tangential = s.law.tangential();
    vectorFlights_ = simple && body.symmetryAxis() >= 0;

    if (setup_.wall && setup_.wall->type() == relief::reliefType::rough)
    {
        // The descent from the highest crest to somewhat below the mean
        // plane, where no particle of an ordinary wall arrives, and room to
        // leave and to choose the start. A particle that goes further
        // enters the stretch of the next.
        const double descent =
            (1.3*s.wall->top() + s.body.radius())*cosine/sine
          + 4*s.body.radius();
        stretch_ = int
        (
            std::min(512., 5 + descent/s.wall->meanSpacing())
        );
        perPiece_ = std::max(1, std::min(64, 512/stretch_));
        while (blockSize % perPiece_)
        {
            --perPiece_;
        }
    }
}


impact::scatteringSampler::~scatteringSampler()
{}


impact::scatteringStatistics
impact::scatteringSampler::emptyStatistics() const
{
    // A sphere leaves at tan(alpha2) = (7/5) normal tan(alpha1): the angles
    // are summed relative to that
    const double reference =
        arcTan2(-1.4*setup_.law.normal()*V1_.y, V1_.x + 1e-300);
    return scatteringStatistics
    (
        setup_.binWidth, reference, setup_.wall && setup_.sharedRelief
    );
}


impact::bodyState impact::scatteringSampler::arrival
(
    std::int64_t i,
    reliefPiece& piece,
    std::int64_t& pieceIdentity,
    std::int64_t& hint
) const
{
    const setup& s = setup_;
    bodyState b;
    const draws o(s.seed, 0, drawPurpose::orientation, i);
    if (s.orientation == orientationLaw::isotropic)
    {
        orient<orientationLaw::isotropic>
            (o.u0, o.u1, o.u2, b.rotation.ex, b.rotation.ey);
    }
    else
    {
        orient<orientationLaw::uniformEuler>
            (o.u0, o.u1, o.u2, b.rotation.ex, b.rotation.ey);
    }
    b.V = V1_;
    b.rotation.omega =
        s.spin.x*b.rotation.ex + s.spin.y*b.rotation.ey
      + s.spin.z*b.rotation.ez();

    const relief& wall = piece.model();
    b.y = wall.top() + s.body.radius();
    if (wall.type() == relief::reliefType::periodic)
    {
        // Neither does a smooth wall depend on where it is met
        const draws p(s.seed, 0, drawPurpose::position, i);
        b.x = s.wall ? p.u0*wall.period() : 0.5*wall.period();
        hint = s.wall
          ? std::int64_t(p.u0*double(wall.table().size())) : 0;
        return b;
    }

    const std::int64_t identity = i/perPiece_;
    if (identity != pieceIdentity)
    {
        piece.start(std::uint64_t(identity), perPiece_*stretch_);
        pieceIdentity = identity;
    }
    // A uniformly random place on the wall lies in a long interval more
    // often than in a short one: intervals of the stretch are accepted in
    // proportion to their length
    hint = (i - identity*perPiece_)*stretch_;
    const double longest = wall.meanSpacing() + 3*wall.sigmaSpacing();
    for (std::uint32_t attempt = 0; ; ++attempt, ++hint)
    {
        const draws p(s.seed, attempt, drawPurpose::position, i);
        const relief::interval& in = piece.at(hint);
        const double length = in.x1 - in.x0;
        if (p.u0*longest < length)
        {
            b.x = in.x0 + p.u1*length;
            return b;
        }
    }
}


std::vector<impact::visitResult> impact::scatteringSampler::visits
(
    std::int64_t from,
    int n
) const
{
    reliefPiece piece(setup_.wall ? *setup_.wall : flat_, setup_.seed);
    std::int64_t identity = -1;
    std::vector<visitResult> results;
    for (int i = 0; i < n; ++i)
    {
        std::int64_t hint = 0;
        const bodyState b = arrival(from + i, piece, identity, hint);
        results.push_back(visit_.visit(b, piece, hint));
    }
    return results;
}


void impact::scatteringSampler::sampleSmooth
(
    std::int64_t first,
    int n,
    workspace& w,
    scatteringStatistics& result
) const
{
    if (setup_.law.law() != reboundLaw::lawType::restitution)
    {
        sampleRough(first, n, w, result);
        return;
    }
    const bool decide =
        setup_.treatment == wallVisit::treatmentType::firstImpact;
    const double small = 1e-3*mag(V1_);
    const double V[3] = {V1_.x, V1_.y, V1_.z};
    const double spin[3] = {setup_.spin.x, setup_.spin.y, setup_.spin.z};
    const vector3& J = setup_.body.inertia();
    visitCounts total;
    smoothLanes& l = w.lanes;
    smoothFlights& f = w.flights;

    auto tally = [&](const smoothLanes& lanes, int m)
    {
        int counts[4];
        smoothTally(m, small, lanes, counts);
        total.impacts += counts[0];
        total.micro += m - counts[0];
        total.pulling += counts[1];
        total.gaining += counts[2];
        return counts[3];
    };

    // The rest of one visit outside the kernels, from the state after
    // 'number' impacts
    auto finish = [&](int i, int number)
    {
        bodyState b;
        b.rotation.ex = {l.ex[0][i], l.ex[1][i], l.ex[2][i]};
        b.rotation.ey = {l.ey[0][i], l.ey[1][i], l.ey[2][i]};
        b.rotation.omega = {l.w[0][i], l.w[1][i], l.w[2][i]};
        b.V = {l.V[0][i], l.V[1][i], l.V[2][i]};
        b.x = 0.5*flat_.period();
        b.y =
           -(
                l.r[0][i]*l.ey[0][i] + l.r[1][i]*l.ey[1][i]
              + l.r[2][i]*l.ey[2][i]
            );
        const visitResult r = visit_.resume(b, number, w.piece, 0);
        total.addImpacts(r);
        total.second += number == 1 && r.second;
        l.V[0][i] = r.state.V.x;
        l.V[1][i] = r.state.V.y;
        l.V[2][i] = r.state.V.z;
        l.w[0][i] = r.state.rotation.omega.x;
        l.w[1][i] = r.state.rotation.omega.y;
        l.w[2][i] = r.state.rotation.omega.z;
    };

    for (int from = 0; from < n; from += smoothBatch)
    {
        const int m = std::min(smoothBatch, n - from);
        smoothArrive
        (
            setup_.orientation == orientationLaw::isotropic, setup_.seed,
            first + from, m, V, spin, smooth_, l
        );
        smoothImpact(m, smooth_, l);
        total.into += tally(l, m);

        // Bodies of this round, by place in the batch
        int place[smoothBatch + 1];
        int surely = 0;
        int inFlight = mayReturn(m, smooth_, l, decide, place, surely);
        total.second += surely;
        if (!vectorFlights_)
        {
            for (int i = 0; i < inFlight; ++i)
            {
                finish(place[i], 1);
            }
        }
        else
        {
            copyLanes(inFlight, place, nullptr, l, w.start);
            smoothLaunch(inFlight, smooth_, w.start, f);
            std::copy_n(place, inFlight, f.id);
            for (int round = 1; inFlight > 0; ++round)
            {
                int nStruck = 0;
                int struckId[smoothBatch];
                double struckTime[smoothBatch];
                for (int pass = 0; inFlight > 0; ++pass)
                {
                    // Whole vectors: what lies behind the last flight is
                    // an old one, and harmless
                    smoothAdvance
                    (
                        (inFlight + 7) & ~7, smooth_, decide, f
                    );
                    int ended = 0;
                    for (int i = 0; i < inFlight; ++i)
                    {
                        ended += f.status[i] != 0;
                    }
                    if (pass > 100)
                    {
                        // Hardly ever: left to the general search
                        for (int i = 0; i < inFlight; ++i)
                        {
                            if (f.status[i] == 0)
                            {
                                finish(f.id[i], round);
                                f.status[i] = 1;
                            }
                        }
                        ended = inFlight;
                    }
                    if (3*ended >= inFlight)
                    {
                        for (int i = 0; i < inFlight; ++i)
                        {
                            if (f.status[i] == 2)
                            {
                                struckId[nStruck] = f.id[i];
                                struckTime[nStruck++] = f.t[i] + f.tau[i];
                            }
                        }
                        inFlight = keepInFlight(inFlight, f);
                    }
                }
                if (round == 1)
                {
                    total.second += nStruck;
                }
                if (decide || nStruck == 0)
                {
                    break;
                }
                if (round + 1 > setup_.maxImpacts)
                {
                    total.capped += nStruck;
                    break;
                }
                smoothLanes& s = w.struck;
                copyLanes(nStruck, struckId, nullptr, l, s);
                smoothTurn(nStruck, smooth_, struckTime, s);
                smoothImpact(nStruck, smooth_, s);
                tally(s, nStruck);
                copyLanes(nStruck, nullptr, struckId, s, l);
                inFlight =
                    mayReturn(nStruck, smooth_, s, false, place, surely);
                copyLanes(inFlight, place, nullptr, s, w.start);
                smoothLaunch(inFlight, smooth_, w.start, f);
                for (int i = 0; i < inFlight; ++i)
                {
                    f.id[i] = struckId[place[i]];
                }
            }
        }
        for (int i = 0; i < m; ++i)
        {
            w.Vx[from + i] = l.V[0][i];
            w.Vy[from + i] = l.V[1][i];
            w.Vz[from + i] = l.V[2][i];
            w.spinEnergy[from + i] =
                J.x*l.w[0][i]*l.w[0][i] + J.y*l.w[1][i]*l.w[1][i]
              + J.z*l.w[2][i]*l.w[2][i];
        }
    }
    total.addTo(result);
}


void impact::scatteringSampler::sampleRough
(
    std::int64_t first,
    int n,
    workspace& w,
    scatteringStatistics& result
) const
{
    const vector3& J = setup_.body.inertia();
    visitCounts total;
    for (int i = 0; i < n; ++i)
    {
        std::int64_t hint = 0;
        const bodyState b =
            arrival(first + i, w.piece, w.pieceIdentity, hint);
        const visitResult r = visit_.visit(b, w.piece, hint);
        w.Vx[i] = r.state.V.x;
        w.Vy[i] = r.state.V.y;
        w.Vz[i] = r.state.V.z;
        const vector3& spin = r.state.rotation.omega;
        w.spinEnergy[i] = dot(multiply(J, spin), spin);
        total.addImpacts(r);
        total.into += r.intoWall;
        total.second += r.second;
        if (setup_.wall && setup_.sharedRelief)
        {
            w.profileBlock[i] = static_cast<unsigned char>
            (
                b.x/setup_.wall->period()
               *scatteringStatistics::profileBlocks
            );
        }
    }
    total.addTo(result);
}


void impact::scatteringSampler::sampleBlock
(
    std::int64_t first,
    int n,
    workspace& w,
    scatteringStatistics& result
) const
{
    if (setup_.wall)
    {
        sampleRough(first, n, w, result);
    }
    else
    {
        sampleSmooth(first, n, w, result);
    }
    double translation = 0, rotation = 0;
    for (int i = 0; i < n; ++i)
    {
        translation +=
            w.Vx[i]*w.Vx[i] + w.Vy[i]*w.Vy[i] + w.Vz[i]*w.Vz[i];
        rotation += w.spinEnergy[i];
    }
    const double unit = 1/(setup_.speed*setup_.speed);
    result.addBlock(scatteringStatistics::translational, unit*translation);
    result.addBlock(scatteringStatistics::rotational, unit*rotation);
    result.addDirections
    (
        n, w.Vx, w.Vy, w.Vz,
        setup_.wall && setup_.sharedRelief ? w.profileBlock : nullptr
    );
}


void impact::scatteringSampler::sample
(
    std::int64_t from,
    std::int64_t to,
    int proc,
    int nProcs,
    int threads,
    const std::atomic<bool>& stop,
    std::atomic<std::int64_t>& done,
    scatteringStatistics& result
) const
{
    blockLoop
    (
        from/blockSize, (to + blockSize - 1)/blockSize,
        proc, nProcs, threads, stop, result,
        [this] { return emptyStatistics(); },
        [&]
        {
            std::shared_ptr<workspace> w
            (
                new workspace(setup_.wall ? *setup_.wall : flat_, setup_.seed)
            );
            return [&, w](std::int64_t block, scatteringStatistics& own)
            {
                const std::int64_t first = block*blockSize;
                const int n =
                    int(std::min<std::int64_t>(blockSize, to - first));
                sampleBlock(first, n, *w, own);
                done += n;
            };
        }
    );
}
