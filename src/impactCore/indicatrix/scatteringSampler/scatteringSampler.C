/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "blockLoop.H"
#include "outOfRange.H"
#include "samplerWorkspace.H"
#include "scatteringKernels.H"
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

} // End anonymous namespace


impact::scatteringSampler::scatteringSampler(const setup& s)
:
    setup_(s),
    flat_(relief::flat(1e3*s.body.radius())),
    visit_(setup_.body, s.law, s.treatment, s.maxImpacts)
{
    checkRange("incidence", s.incidence, "(0, 90] (degrees)");
    checkRange("speed", s.speed, "(0, 1e100) m/s");
    for (int i = 0; i < 3; ++i)
    {
        checkRange("spin", s.spin[i], "(-1e100, 1e100) (rad/s)");
    }
    s.check();

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
    smooth_.normal = s.law.normal()(s.incidence, s.speed);
    smooth_.tangential = s.law.other()(s.incidence, s.speed);
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
        const double begin = piece.knot(hint);
        const double length = piece.knot(hint + 1) - begin;
        if (p.u0*longest < length)
        {
            b.x = begin + p.u1*length;
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
