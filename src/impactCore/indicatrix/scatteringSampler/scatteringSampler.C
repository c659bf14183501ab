/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "blockLoop.H"
#include "outOfRange.H"
#include "philoxLanes.H"
#include "scatteringKernels.H"
#include "scatteringSampler.H"

#include <algorithm>

namespace
{

using impact::smoothLanes;

typedef impact::scatteringStatistics S;

//- A lane with all but its last impact
void copyLane(const smoothLanes& a, int i, smoothLanes& b, int j)
{
    const double* from = a.ex[0] + i;
    double* to = b.ex[0] + j;
    const int stride = sizeof(smoothLanes::lane)/sizeof(double);
    for (int k = 0; k < a.approach - a.ex[0]; k += stride)
    {
        to[k] = from[k];
    }
}

} // End anonymous namespace


struct impact::scatteringSampler::workspace
{
    reliefPiece piece;
    std::int64_t pieceIdentity = -1;

    //- Velocities after the last impact, by particle of the block
    double Vx[blockSize], Vy[blockSize], Vz[blockSize];
    double spinEnergy[blockSize];
    unsigned char profileBlock[blockSize];

    smoothLanes flying = {}, striking = {};

    workspace(const relief& r, std::uint64_t seed)
    :
        piece(r, seed)
    {
        // Vectors reach beyond the last lane: bodies there, too
        for (smoothLanes* lanes : {&flying, &striking})
        {
            std::fill_n(lanes->ey[0], smoothRoom + 8, 1.);
        }
    }

    //- A whole visit
    void record
    (
        int particle,
        const visitResult& r,
        const convexBody& body,
        scatteringStatistics& result
    )
    {
        const vector3& spin = r.state.rotation.omega;
        Vx[particle] = r.state.V.x;
        Vy[particle] = r.state.V.y;
        Vz[particle] = r.state.V.z;
        spinEnergy[particle] = dot(multiply(body.inertia(), spin), spin);
        result.add(S::impacts, r.impacts);
        result.add(S::microImpacts, r.microImpacts);
        result.add(S::pulling, r.pulling);
        result.add(S::gaining, r.gaining);
        result.add(S::outside, r.outside);
        result.add(S::capped, r.capped);
    }
};


void impact::scatteringSampler::setSmoothBody()
{
    const setup& s = setup_;
    const convexBody& body = s.body;
    smoothBody& b = smooth_;
    b.box = body.isBox();
    b.axis = std::max(body.symmetryAxis(), 0) % 3;
    b.along = body.semiAxes()[b.axis];
    b.across = body.semiAxes()[(b.axis + 1) % 3];
    b.Ja = body.inertia()[b.axis];
    b.Jc = body.inertia()[(b.axis + 1) % 3];
    b.radius = body.radius();

    // The support h(m) of the body along the turning normal m has
    // h'' = rho |m'|^2 - h |m'|^2 + r_t m''_t, rho between its radii of
    // curvature, r_t the offset of the contact point from the normal
    const double a = b.along, c = b.across, R = b.radius;
    const double shortest = std::min(a, c), longest = std::max(a, c);
    const double skewed =
        (b.box ? R : R - shortest)*freeRotation::skewness(body);
    b.bend = 1.0001*(R - body.minCurvature() + skewed);
    b.sink = 1.0001*(longest*longest/shortest - shortest + skewed);
    b.normal = s.law.normal()(s.incidence, s.speed);
    b.tangential = s.law.other()(s.incidence, s.speed);
    for (int i = 0; i < 3; ++i)
    {
        b.V[i] = V1_[i];
        b.spin[i] = s.spin[i];
    }

    // A body that turns as it arrives meets the wall in some orientations
    // more often than in others, as often as its lowest point approaches fast:
    // its flight down to the wall must be followed
    manyAtOnce_ =
        !s.wall && s.law.law() == reboundLaw::lawType::restitution
     && s.law.isConstant()
     && (mag(s.spin) == 0 || body.isSphere())
     && body.symmetryAxis() >= 0
     && (b.box || body.shape() == convexBody::shapeType::ellipsoid);
}


impact::scatteringSampler::scatteringSampler(const setup& s)
:
    setup_(s),
    flat_(relief::flat(1e3*s.body.radius())),
    visit_(setup_.body, s.law, s.treatment, s.maxImpacts)
{
    checkRange("incidence", s.incidence, "(0, 90] (degrees)");
    checkRange("speed", s.speed, "(0, 1e100) m/s");
    checkRange("spin", s.spin, "(-1e100, 1e100) (rad/s)");
    s.check();

    double sine, cosine;
    sinCosTurns(s.incidence/360, sine, cosine);
    if (s.incidence == 90)
    {
        cosine = 0;
    }
    V1_ = {s.speed*cosine, -s.speed*sine, 0};

    setSmoothBody();
    if (setup_.wall && setup_.wall->type() == relief::reliefType::rough)
    {
        // The descent from the highest crest to somewhat below the mean
        // plane, where no particle of an ordinary wall arrives, and room to
        // leave and to choose the start. A particle that goes further
        // enters the stretch of the next.
        const double descent =
            (1.3*s.wall->top() + s.body.radius())*cosine/sine
          + 4*s.body.radius();
        checkReach(descent/s.wall->meanSpacing());

        // The body may reach back from where it begins
        before_ = s.wall->reach(s.body.radius());
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
    else if (setup_.wall && !setup_.wall->isFlat())
    {
        // From where the circle about the body is within reach
        checkReach(cosine/sine);
    }
}


void impact::scatteringSampler::checkReach(double steps) const
{
    const double most = 1e6;
    if (steps > most)
    {
        throwOutOfRange
        (
            "incidence", setup_.incidence, "[", setup_.incidence*steps/most,
            ", 90] deg on this relief, below which the way down to it is too"
            " long to be followed"
        );
    }
}


impact::scatteringStatistics
impact::scatteringSampler::emptyStatistics() const
{
    // A sphere leaves at tan(alpha2) = (7/5) normal tan(alpha1): the angles
    // are summed relative to that
    const double reference =
        arcTan2(-1.4*smooth_.normal*V1_.y, V1_.x + 1e-300);
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
    const threeUnits o = threeUnits::drawn
        (s.seed, 0, drawPurpose::orientation, std::uint64_t(i));
    orient(s.orientation, o.u0, o.u1, o.u2, b.rotation.ex, b.rotation.ey);
    b.V = V1_;
    b.rotation.omega =
        s.spin.x*b.rotation.ex + s.spin.y*b.rotation.ey
      + s.spin.z*b.rotation.ez();

    const relief& wall = piece.model();
    b.y = wall.top() + s.body.radius();
    if (wall.type() == relief::reliefType::periodic)
    {
        // Neither does a smooth wall depend on where it is met
        const double u = threeUnits::drawn
            (s.seed, 0, drawPurpose::position, std::uint64_t(i)).u0;
        b.x = s.wall ? u*wall.period() : 0.5*wall.period();
        hint = s.wall ? std::int64_t(u*double(wall.table().size())) : 0;
        return b;
    }

    const std::int64_t identity = i/perPiece_;
    if (identity != pieceIdentity)
    {
        piece.start(std::uint64_t(identity), perPiece_*stretch_);
        pieceIdentity = identity;
    }
    hint = (i - identity*perPiece_)*stretch_;
    b.x = piece.drawPlace(s.seed, std::uint64_t(i), before_ + 1, hint);
    return b;
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


void impact::scatteringSampler::sampleOneByOne
(
    std::int64_t first,
    int n,
    workspace& w,
    scatteringStatistics& result
) const
{
    for (int i = 0; i < n; ++i)
    {
        std::int64_t hint = 0;
        const bodyState b =
            arrival(first + i, w.piece, w.pieceIdentity, hint);
        const visitResult r = visit_.visit(b, w.piece, hint);
        w.record(i, r, setup_.body, result);
        result.add(S::intoWall, r.intoWall);
        result.add(S::secondImpact, r.second);
        if (setup_.wall && setup_.sharedRelief)
        {
            w.profileBlock[i] = static_cast<unsigned char>
            (
                b.x/setup_.wall->period()
               *scatteringStatistics::profileBlocks
            );
        }
    }
}


void impact::scatteringSampler::account
(
    int i,
    workspace& w,
    scatteringStatistics& result
) const
{
    smoothLanes& l = w.striking;
    const int particle = int(l.particle[i]);
    const double approach = l.approach[i], small = 1e-3*setup_.speed;
    result.add(S::impacts, approach > small);
    result.add(S::microImpacts, approach > 0 && approach <= small);
    result.add(S::pulling, l.pulling[i] > 0);
    result.add(S::gaining, l.gaining[i] > 0);
    result.add(S::intoWall, l.impacts[i] == 0 && l.V[1][i] <= 0);
    result.add(S::secondImpact, l.impacts[i] == 1 && approach > 0);
    l.impacts[i] += 1;
    w.Vx[particle] = l.V[0][i];
    w.Vy[particle] = l.V[1][i];
    w.Vz[particle] = l.V[2][i];
    w.spinEnergy[particle] = l.spinEnergy[i];
}


void impact::scatteringSampler::sampleSmooth
(
    std::int64_t first,
    int n,
    workspace& w,
    scatteringStatistics& result
) const
{
    const bool once = setup_.treatment == visitTreatment::firstImpact;
    const int maxImpacts = once ? 1 : setup_.maxImpacts;
    const bool isotropic = setup_.orientation == orientationLaw::isotropic;
    auto wholeVectors = [](int k) { return (k + 7) & ~7; };
    smoothLanes& flying = w.flying;
    smoothLanes& striking = w.striking;
    int inFlight = 0;
    for (int arrived = 0; arrived < n || inFlight > 0; )
    {
        // Impacts to come: of those that arrive, as soon as there is room for
        // them, or of those whose flight has ended
        int m = 0;
        if (arrived < n && inFlight <= smoothRoom - smoothBatch)
        {
            m = std::min(smoothBatch, n - arrived);
            smoothArrive
                (isotropic, setup_.seed, first + arrived, m, smooth_, striking);
            for (int i = 0; i < m; ++i)
            {
                striking.particle[i] = arrived++;
            }
        }
        else
        {
            smoothAdvance(wholeVectors(inFlight), smooth_, flying);

            // Backwards: the last one comes into the place of one that ended
            for (int i = inFlight - 1; i >= 0; --i)
            {
                const double status = flying.status[i];
                if (status == smoothStatus::flies)
                {
                    continue;
                }
                const bool strikes = status == smoothStatus::strikes;
                if (strikes && flying.impacts[i] < maxImpacts)
                {
                    copyLane(flying, i, striking, m++);
                }
                else if (strikes && once)
                {
                    result.add(S::secondImpact, 1);
                }
                else if (status != smoothStatus::gone)
                {
                    result.add(S::capped, 1);
                }
                copyLane(flying, --inFlight, flying, i);
            }
        }
        smoothImpact(wholeVectors(m), smooth_, striking);
        for (int i = 0; i < m; ++i)
        {
            account(i, w, result);
            if (striking.status[i] == smoothStatus::flies)
            {
                copyLane(striking, i, flying, inFlight++);
            }
        }
    }
}


void impact::scatteringSampler::sampleBlock
(
    std::int64_t first,
    int n,
    workspace& w,
    scatteringStatistics& result
) const
{
    manyAtOnce_
  ? sampleSmooth(first, n, w, result)
  : sampleOneByOne(first, n, w, result);
    double translation = 0, rotation = 0;
    for (const double* component : {w.Vx, w.Vy, w.Vz})
    {
        double sum, squares;
        sumAndSquares(n, component, sum, squares);
        translation += squares;
    }
    double unused;
    sumAndSquares(n, w.spinEnergy, rotation, unused);
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
