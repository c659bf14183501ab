/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "BlockMotion.H"
#include "curvedPath.H"
#include "meshTools.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

template<class CloudType, class Force>
void Foam::BlockMotion<CloudType, Force>::meetEddy(const int i)
{
    flyer& f = flyers_[i];
    const label celli = cells_.meshCell(cell_[i]);
    if (!eddies_->over(celli, f.eddyLeft))
    {
        return;
    }
    const label at = f.at;
    force_.sphere(parcels_.d[at], parcels_.rho[at]);
    force_.eddy({0, 0, 0});
    force_.place(*block_.now.gas[i], impact::motionLanes::of(block_.now.x, i));
    const State state(begin(i));
    eddies_->next
    (
        celli,
        parcels_.origProc[at],
        parcels_.origId[at],
        force_.here().u - state.v,
        force_(state).k,
        parcels_.UTurb[at],
        f.eddyLeft,
        parcels_.nEddies[at]
    );
    impact::motionLanes::set(block_.now.eddy, i, toCore(parcels_.UTurb[at]));
    f.nForces = 0;
}


template<class CloudType, class Force>
void Foam::BlockMotion<CloudType, Force>::take(const int i, const label at)
{
    flyer& f = flyers_[i];
    f.at = at;
    cell_[i] = parcels_.cell[at];
    impact::motionLanes::set(block_.now.x, i, toCore(parcels_.x[at]));
    f.begin = 0;
    f.over = false;
    f.nForces = 0;
    f.stalls = 0;
    f.face = -1;
    enter(i);

    block_.sphere(i, parcels_.d[at], parcels_.rho[at]);
    block_.hTry[i] = GREAT;
    impact::motionLanes::set(block_.now.v, i, toCore(parcels_.U[at]));
    impact::motionLanes::set(block_.now.omega, i, toCore(parcels_.spin(at)));
    if constexpr (heated)
    {
        block_.now.enthalpy[i] = force_.heat().material().h(parcels_.T[at]);
    }
    if (eddies_)
    {
        impact::motionLanes::set
            (block_.now.eddy, i, toCore(parcels_.UTurb[at]));
        f.eddyLeft = parcels_.tTurb[at];
        meetEddy(i);
    }
}


template<class CloudType, class Force>
void Foam::BlockMotion<CloudType, Force>::release(const int i)
{
    const label at = flyers_[i].at;
    parcels_.x[at] = fromCore(impact::motionLanes::of(block_.now.x, i));
    parcels_.U[at] = fromCore(impact::motionLanes::of(block_.now.v, i));
    if (parcels_.omega.size())
    {
        parcels_.omega[at] =
            fromCore(impact::motionLanes::of(block_.now.omega, i));
    }
    if (eddies_)
    {
        parcels_.tTurb[at] = flyers_[i].eddyLeft;
    }
    parcels_.cell[at] = cell_[i];
}


template<class CloudType, class Force>
typename Foam::BlockMotion<CloudType, Force>::outcome
Foam::BlockMotion<CloudType, Force>::alone
(
    const int i,
    const scalar hMax,
    const scalar hTry
)
{
    const flyer& f = flyers_[i];
    force_.sphere(parcels_.d[f.at], parcels_.rho[f.at]);
    if (eddies_)
    {
        force_.eddy(impact::motionLanes::of(block_.now.eddy, i));
    }
    force_.place(*block_.now.gas[i], impact::motionLanes::of(block_.now.x, i));
    return motion_.step
    (
        force_,
        begin(i),
        impact::mag(force_.here().u),
        impact::mag(force_.here().spin),
        hMax,
        hTry,
        max(stepToFace::maxForces - f.nForces - stepToFace::kept, label(3))
    );
}


template<class CloudType, class Force>
void Foam::BlockMotion<CloudType, Force>::exchange
(
    const int i,
    const State& state,
    const outcome& o,
    const scalar t
)
{
    const label at = flyers_[i].at;
    parcelType& p = *exchanging_;
    p.d() = parcels_.d[at];
    p.rho() = parcels_.rho[at];
    p.nParticle() = parcels_.nParticle[at];
    p.U() = fromCore(impact::motionLanes::of(block_.now.v, i));
    p.omega() = fromCore(impact::motionLanes::of(block_.now.omega, i));
    p.cell() = cells_.meshCell(cell_[i]);
    const scalar T0 = heated ? parcels_.T[at] : 0;
    if constexpr (heated)
    {
        p.temperature() = parcels_.T[at] =
            force_.heat().material().T(block_.now.enthalpy[i]);
        force_.sphere(p.d(), p.rho());
    }
    const auto give = [&](auto& receiver)
    {
        scalar heat = 0;
        if constexpr (heated)
        {
            heat = p.takeHeat(receiver, force_.heat(), T0, o.kHeat, t);
        }
        if (coupled_)
        {
            const scalar mass = p.mass();
            p.giveToGas
            (
                receiver,
                mass,
                fromCore(state.v),
                fromCore(state.omega),
                t*force_.external
                (
                    mass, p.rho(), state.v,
                    impact::motionLanes::of(block_.now.x, i),
                    block_.here.rho[i]
                ),
                heat,
                true
            );
        }
    };
    if (planned_)
    {
        give(*planned_);
        planned_->keep(at, p.cell());
    }
    else
    {
        give(cloud_);
    }
}


template<class CloudType, class Force>
bool Foam::BlockMotion<CloudType, Force>::slide
(
    const int i,
    const label place,
    const label next
)
{
    const flyer& f = flyers_[i];
    const impact::vector3 n = cells_.normal(place);
    cellGas::field here, there, along;
    State state(begin(i));
    impact::vector3 x(impact::motionLanes::of(block_.now.x, i));
    state.v = state.v - impact::dot(n, state.v)*n;
    force_.sphere(parcels_.d[f.at], parcels_.rho[f.at]);
    if (eddies_)
    {
        force_.eddy(impact::motionLanes::of(block_.now.eddy, i));
    }
    if
    (
       !faceSlide::holds
        (
            n,
            cloud_.gas().at(cell_[i], here),
            cloud_.gas().at(next, there),
            x,
            state,
            force_,
            along
        )
    )
    {
        return false;
    }
    x = x - cells_.heightAbove(place, x)*n;
    impact::motionLanes::set(block_.now.x, i, x);
    impact::motionLanes::set(block_.now.v, i, state.v);
    cloud_.statistics().nSlides += f.face != place;
    along_[i] = along;
    return true;
}


template<class CloudType, class Force>
void Foam::BlockMotion<CloudType, Force>::follow(const int i)
{
    flyer& f = flyers_[i];
    const bool accepted = block_.accepted[i] > 0;
    const outcome o =
        accepted
      ? block_.template outcome<State>(i)
      : alone(i, block_.hMax[i], block_.hTry[i]);
    const State state(begin(i));
    impact::vector3 x(impact::motionLanes::of(block_.now.x, i));
    State end = o.state;
    label place = -1;
    scalar tau = 1;
    if (accepted && stays_[i])
    {
        end.x = impact::multiply(moving_, end.x);
    }
    else
    {
        const curvedPath path
        (
            x,
            impact::multiply(moving_, o.state.x),
            o.h*impact::multiply(moving_, state.v),
            o.h*impact::multiply(moving_, o.state.v)
        );
        tau = path.exit(cells_, cell_[i], 0, 1, place);
        end.x = path(tau);
    }
    if (place >= 0 && cells_.targets()[place] < 0)
    {
        // A boundary, or a choice of cells
        f.over = true;
        return;
    }

    auto& statistics = cloud_.statistics();
    ++statistics.nSteps;
    statistics.nForces += o.nForce;
    statistics.nForced += o.forced;
    f.nForces += o.nForce;

    const scalar left = remaining(f);
    scalar hTry = o.hNext;
    scalar t = tau*o.h;
    if (tau < 1)
    {
        // A parabola where that is accurate, another step where not
        if (!stepToFace::onParabola(motion_, state, o, tau, end))
        {
            const outcome again = alone(i, t, t);
            statistics.nForces += again.nForce;
            statistics.nForced += again.forced && !o.forced;
            f.nForces += again.nForce;
            hTry = again.hNext;
            end = again.state;
            place = again.h < t ? -1 : place;
            t = again.h;
        }
        end.x = impact::multiply(moving_, end.x);
    }
    x = x + end.x;
    if (place >= 0)
    {
        stepToFace::ontoFace(cells_, place, moving_, state, o, x, end, t);
    }
    impact::motionLanes::set(block_.now.x, i, x);
    vector U = fromCore(end.v);
    meshTools::constrainDirection(cells_.mesh(), cells_.mesh().solutionD(), U);
    impact::motionLanes::set(block_.now.v, i, toCore(U));
    impact::motionLanes::set(block_.now.omega, i, end.omega);
    if constexpr (heated)
    {
        block_.now.enthalpy[i] = end.h;
    }
    statistics.time += t;
    statistics.forcedTime += o.forced ? t : 0;
    const label face = place >= 0 ? place : f.face;
    const label next = face >= 0 ? cells_.behind(face, x) : -1;
    const bool slides =
        face >= 0
     && faceSlide::near
        (
            impact::dot(cells_.normal(face), end.v),
            o.k,
            block_.now.gas[i]->length
        )
     && slide(i, face, next);
    f.face = slides ? face : -1;
    if (heated || coupled_)
    {
        exchange(i, state, o, t);
    }
    parcels_.age[f.at] += t;
    f.begin =
        place >= 0 || t < left ? min(f.begin + t/trackTime_, scalar(1)) : 1;
    f.stalls = t < 1e-9*trackTime_ ? f.stalls + 1 : 0;
    if (face >= 0)
    {
        cell_[i] = place >= 0 && !slides ? next : cell_[i];
        enter(i);
    }
    if (place >= 0)
    {
        statistics.maxForces =
            max(statistics.maxForces, scalar(f.nForces));
        f.nForces = 0;
        hTry = GREAT;
    }
    if (eddies_)
    {
        f.eddyLeft -= t;
        if (f.begin < 1)
        {
            meetEddy(i);
        }
    }
    block_.hTry[i] = hTry;
    f.over =
        f.begin >= 1 || f.stalls > 10
     || f.nForces > stepToFace::maxForces - 2*stepToFace::kept;
    if (f.over)
    {
        statistics.maxForces =
            max(statistics.maxForces, scalar(f.nForces));
    }
}


template<class CloudType, class Force>
void Foam::BlockMotion<CloudType, Force>::advance(const int n)
{
    impact::motionLanes::row left, way[3], exit, points[9];
    block_.begin(n);
    for (int i = 0; i < n; ++i)
    {
        left[i] = remaining(flyers_[i]);
        if (eddies_)
        {
            left[i] = min(left[i], flyers_[i].eddyLeft);
        }
        for (int c = 0; c < 3; ++c)
        {
            way[c][i] = moving_[c]*block_.now.v[c][i];
        }
    }
    walkKernels::exitTimes
    (
        n, cells_.shapes(), cell_,
        block_.now.x[0], block_.now.x[1], block_.now.x[2],
        way[0], way[1], way[2], left, exit
    );
    for (int i = 0; i < n; ++i)
    {
        block_.hMax[i] = stepToFace::longest
        (
            left[i], exit[i], block_.now.gas[i]->length,
            impact::mag(impact::motionLanes::of(block_.now.v, i)),
            impact::mag(impact::motionLanes::of(block_.here.u, i))
        );
        if (flyers_[i].face >= 0)
        {
            block_.hMax[i] = min
            (
                block_.hMax[i],
                faceSlide::longest
                (
                    *block_.now.gas[i],
                    impact::motionLanes::of(block_.now.v, i),
                    impact::motionLanes::of(block_.here.u, i)
                )
            );
        }
    }
    block_.end(n);

    const double* rows[9];
    for (int c = 0; c < 3; ++c)
    {
        for (int i = 0; i < n; ++i)
        {
            const scalar x = block_.now.x[c][i];
            const scalar h = block_.h[i];
            const scalar s = moving_[c]*block_.last.x[c][i];
            points[c][i] = x + (1.0/3)*(h*way[c][i]);
            points[3 + c][i] =
                x + s - (1.0/3)*(h*(moving_[c]*block_.last.v[c][i]));
            points[6 + c][i] = x + s;
        }
    }
    for (int k = 0; k < 9; ++k)
    {
        rows[k] = points[k];
    }
    walkKernels::pathsInside(n, cells_.shapes(), cell_, rows, stays_);
    for (int i = 0; i < n; ++i)
    {
        follow(i);
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

template<class CloudType, class Force>
Foam::BlockMotion<CloudType, Force>::BlockMotion
(
    CloudType& cloud,
    Force& force,
    PlannedCloud<CloudType>* planned
)
:
    cloud_(cloud),
    parcels_(cloud.arrays()),
    force_(force),
    motion_(cloud.embedded()),
    cells_(cloud.cells()),
    moving_(toCore(cells_.moving())),
    trackTime_(cloud.solution().trackTime()),
    coupled_(cloud.solution().coupled()),
    eddies_(cloud.eddies()),
    block_
    (
        force.forces(),
        heat(),
        motion_.tolerance(),
        force.directions().velocity(),
        force.directions().rotation(),
        eddies_ != nullptr,
        force.secondary()
    ),
    planned_(planned)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

template<class CloudType, class Force>
template<class Rest>
void Foam::BlockMotion<CloudType, Force>::move(const Rest& rest)
{
    const label nParcels = parcels_.size();
    if (nParcels && (heated || coupled_))
    {
        exchanging_.reset(cloud_.objectOf(0));
    }
    label next = 0;
    int n = 0;
    while (true)
    {
        while (n < size && next < nParcels)
        {
            take(n++, next++);
        }
        if (n == 0)
        {
            break;
        }
        advance(n);
        for (int i = 0; i < n; )
        {
            flyer& f = flyers_[i];
            if (!f.over)
            {
                ++i;
                continue;
            }
            release(i);
            if (f.begin < 1)
            {
                rest
                (
                    f.at,
                    typename parcelType::begun
                    {
                        f.begin, block_.hTry[i], f.nForces
                    }
                );
            }
            --n;
            if (i < n)
            {
                f = flyers_[n];
                cell_[i] = cell_[n];
                if (f.face >= 0)
                {
                    along_[i] = along_[n];
                }
                block_.move(n, i);
                enter(i);
            }
        }
    }
}
