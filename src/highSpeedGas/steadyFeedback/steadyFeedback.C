/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "steadyFeedback.H"
#include "checked.H"
#include "Time.H"

namespace
{

using namespace Foam;

IOobject sourceField(const fvMesh& mesh, const word& name)
{
    return IOobject
    (
        name,
        mesh.time().timeName(),
        mesh,
        IOobject::READ_IF_PRESENT,
        IOobject::AUTO_WRITE
    );
}

//- The larger sum of magnitudes, not zero
template<class Field>
scalar larger(const Field& a, const Field& b)
{
    return max(max(gSum(mag(a)()), gSum(mag(b)())), VSMALL);
}

} // End anonymous namespace


Foam::scalar Foam::steadyFeedback::delaySteps() const
{
    return std::round(delay_/equations_.mesh().time().deltaTValue());
}


Foam::scalar Foam::steadyFeedback::roundSteps() const
{
    const scalar dt = equations_.mesh().time().deltaTValue();
    return delaySteps() + max(std::round(window_/dt), scalar(1));
}


void Foam::steadyFeedback::store()
{
    dictionary& d = state_.subDictOrAdd("feedback");
    d.set("round", round_);
    d.set("share", share_);
    d.set("nSteps", nSteps_);
    d.set("deltaT", equations_.mesh().time().deltaTValue());
    d.set("rests", rests_);
}


Foam::steadyFeedback::steadyFeedback
(
    gasEquations& equations,
    IOdictionary& state,
    const dictionary& dict
)
:
    equations_(equations),
    state_(state),
    force_
    (
        sourceField(equations.mesh(), "particleForce"),
        equations.mesh(),
        dimensionedVector(dimForce, Zero)
    ),
    power_
    (
        sourceField(equations.mesh(), "particlePower"),
        equations.mesh(),
        dimensionedScalar(dimPower, Zero)
    ),
    momentum_
    (
        sourceField(equations.mesh(), "particleForceSum"),
        equations.mesh(),
        dimensionedVector(dimForce*dimTime, Zero)
    ),
    energy_
    (
        sourceField(equations.mesh(), "particlePowerSum"),
        equations.mesh(),
        dimensionedScalar(dimPower*dimTime, Zero)
    ),
    forceChange_
    (
        sourceField(equations.mesh(), "particleForceChange"),
        equations.mesh(),
        dimensionedVector(dimForce, Zero)
    ),
    powerChange_
    (
        sourceField(equations.mesh(), "particlePowerChange"),
        equations.mesh(),
        dimensionedScalar(dimPower, Zero)
    ),
    share_(0),
    newSources_(GREAT),
    newCells_(0),
    gasChange_(0),
    round_(0),
    nSteps_(0),
    rests_(false)
{
    refuseOthers
    (
        dict, {"delay", "window", "relaxation", "tolerance", "maxRounds"}
    );
    delay_ = getNumber<scalar>(dict, "delay", "[0, 1e9] s");
    window_ = getNumber<scalar>(dict, "window", "(0, 1e9] s");
    relaxation_ = getNumber(dict, "relaxation", "(0, 1]", scalar(1));
    tolerance_ = getNumber(dict, "tolerance", "(0, 1)", scalar(1e-3));
    maxRounds_ = getNumber<label>(dict, "maxRounds", validRange::count, 50);

    const dictionary& old = state.subOrEmptyDict("feedback");
    round_ = old.getOrDefault<label>("round", 0);
    share_ = old.getOrDefault<scalar>("share", min(relaxation_, firstShare));
    nSteps_ = old.getOrDefault<label>("nSteps", 0);
    rests_ = old.getOrDefault("rests", false);
    const scalar dt = equations_.mesh().time().deltaTValue();
    if (mag(old.getOrDefault("deltaT", dt)/dt - 1) > 1e-4 && nSteps_ > 0)
    {
        Info<< "Gas: the time step has changed, a round begins anew" << endl;
        clearRound();
    }
    equations_.setSources(force_.field(), power_.field());
    store();
}


bool Foam::steadyFeedback::roundEnds()
{
    if (nSteps_ < roundSteps())
    {
        return false;
    }
    if (rests_)
    {
        lookAgain();
    }
    return open();
}


Foam::scalar Foam::steadyFeedback::perTime() const
{
    return
        1
       /(
            equations_.mesh().time().deltaTValue()
           *(roundSteps() - delaySteps())
        );
}


void Foam::steadyFeedback::lookAgain()
{
    const vectorField F(perTime()*momentum_.field());
    const scalarField P(perTime()*energy_.field());
    const scalar newForce =
        mag(gSum(F) - gSum(force_.field()))/larger(force_.field(), F);
    const scalar newPower =
        mag(gSum(P) - gSum(power_.field()))/larger(power_.field(), P);

    // Averages scatter by more than the last ones happened to differ
    const scalar bound = 30*tolerance_;
    rests_ = max(newForce, newPower) <= bound;
    if (rests_)
    {
        clearRound();
        return;
    }
    WarningInFunction
        << "Gas and particles had come to rest, but the particles give"
        << " something else by now: new in force and power " << newForce << ", "
        << newPower << ", more than " << bound << " (30 times the tolerance)."
        << " The gas is marched again; statistics up to here are those of"
        << " particles in another gas." << endl;
}


void Foam::steadyFeedback::clearRound()
{
    momentum_.field() = Zero;
    energy_.field() = 0;
    nSteps_ = 0;
}


void Foam::steadyFeedback::setShare
(
    const vectorField& forceChange,
    const scalarField& powerChange
)
{
    if (round_ == 0)
    {
        share_ = min(relaxation_, firstShare);
        return;
    }

    // If the change falls as that of one mode, the share that would have ended
    // it: the mean of the longer and the shorter step of Barzilai and Borwein.
    // The shorter one, Aitken's, vanishes in the noise of the averages, which
    // lies across the change; the longer one overshoots at the start.
    FixedList<scalar, 8> sums(Zero);
    forAll(powerChange, c)
    {
        const vector& F = forceChange_[c];
        const scalar P = powerChange_[c];
        const vector dF(F - forceChange[c]);
        const scalar dP = P - powerChange[c];
        sums[0] += F & dF;
        sums[1] += magSqr(F);
        sums[2] += magSqr(dF);
        sums[3] += P*dP;
        sums[4] += sqr(P);
        sums[5] += sqr(dP);
        sums[6] += magSqr(force_[c] + forceChange[c]);
        sums[7] += sqr(power_[c] + powerChange[c]);
    }
    for (scalar& sum : sums)
    {
        reduce(sum, sumOp<scalar>());
    }
    const scalar F = 1/max(sums[6], VSMALL);
    const scalar P = 1/max(sums[7], VSMALL);
    const scalar fallen = F*sums[0] + P*sums[3];
    const scalar before = F*sums[1] + P*sums[4];
    const scalar now = F*sums[2] + P*sums[5];
    const scalar ideal =
        share_*(fallen > 0 && 4*now > before ? std::sqrt(before/now) : 2);

    // In digits that a file keeps
    const scalar maxShare = min(relaxation_, 2*share_);
    share_ = 1e-3*std::round
    (
        1e3*max(min(ideal, maxShare), min(0.5*share_, maxShare))
    );
    share_ = max(share_, min(relaxation_, minShare));
}


void Foam::steadyFeedback::endRound()
{
    const vectorField dF(perTime()*momentum_.field() - force_.field());
    const scalarField dP(perTime()*energy_.field() - power_.field());
    setShare(dF, dP);
    forceChange_.field() = dF;
    powerChange_.field() = dP;
    force_.field() += share_*dF;
    power_.field() += share_*dP;

    const scalar F = larger(force_.field(), dF);
    const scalar P = larger(power_.field(), dP);
    const FixedList<scalar, 2> all{mag(gSum(dF))/F, mag(gSum(dP))/P};
    const FixedList<scalar, 2> cells{gSum(mag(dF)())/F, gSum(mag(dP)())/P};
    newSources_ = max(all[0], all[1]);
    newCells_ = max(cells[0], cells[1]);
    Info<< "Gas: round " << round_ + 1 << " of the particles ends: they give "
        << gSum(force_.field()) << " N and " << gSum(power_.field())
        << " W; new in both " << all[0] << ", " << all[1]
        << ", cell by cell " << cells[0] << ", " << cells[1] << ", of which "
        << share_ << " is taken" << endl;

    clearRound();
    round_++;
    equations_.setSources(force_.field(), power_.field());
}


void Foam::steadyFeedback::compare
(
    const std::vector<double>& before,
    const bool steady
)
{
    // Of p, T and U: change and size
    FixedList<scalar, 6> sums(Zero);
    const gasMesh& geometry = equations_.geometry();
    const int nVar = equations_.nVar();
    for (label c = 0; c < geometry.nCells(); c++)
    {
        const double* q = &equations_.primitive[c*nVar];
        const double* old = &before[c*nVar];
        scalar change = 0;
        scalar squares = 0;
        for (int d = 2; d < nVar; d++)
        {
            change += sqr(q[d] - old[d]);
            squares += sqr(q[d]);
        }
        const scalar V = geometry.volume[c];
        for (int k = 0; k < 2; k++)
        {
            sums[k] += V*mag(q[k] - old[k]);
            sums[3 + k] += V*q[k];
        }
        sums[2] += V*std::sqrt(change);
        sums[5] += V*std::sqrt(squares);
    }
    for (scalar& sum : sums)
    {
        reduce(sum, sumOp<scalar>());
    }

    takeFelt();
    gasChange_ = 0;
    Info<< "Gas: in round " << round_ << " p, T, U have changed by";
    for (int k = 0; k < 3; k++)
    {
        const scalar change = sums[k]/max(share_*sums[3 + k], VSMALL);
        gasChange_ = max(gasChange_, change);
        Info<< ' ' << change;
    }

    // Before any particle has met the gas nothing changes, either
    const bool given =
        gSum(mag(force_.field())()) > 0 || gSum(mag(power_.field())()) > 0;
    rests_ =
        given && steady && max(gasChange_, newSources_) <= tolerance_;
    Info<< (rests_ ? ": gas and particles rest" : "") << endl;
    if (!rests_ && round_ == maxRounds_)
    {
        WarningInFunction
            << "Gas and particles do not rest after " << round_
            << " rounds: in the last one the gas has changed by " << gasChange_
            << ", what the particles give by " << newSources_
            << ", tolerance " << tolerance_
            << (steady ? "" : ", and the gas is not steady")
            << (given ? "" : ". No particle has acted on it")
            << ". A longer window, more parcels or a smaller relaxation may"
            << " help.";
        adviseOnScatter();
        Info<< endl;
    }
    store();
}


void Foam::steadyFeedback::takeFelt()
{
    forAll(power_, celli)
    {
        const scalar share =
            equations_.sourceShare(equations_.geometry().cellOf[celli]);
        force_[celli] *= share;
        power_[celli] *= share;
    }
    equations_.setSources(force_.field(), power_.field());
}


void Foam::steadyFeedback::beginAnew()
{
    rests_ = false;
    round_ = 0;
    clearRound();
    store();
}


void Foam::steadyFeedback::beginStep()
{
    if (rests_ || open())
    {
        nSteps_++;
        store();
    }
}


void Foam::steadyFeedback::receive
(
    const vectorField& momentum,
    const scalarField& energy
)
{
    if ((rests_ || open()) && nSteps_ > delaySteps())
    {
        momentum_.field() += momentum;
        energy_.field() += energy;
    }
}


void Foam::steadyFeedback::adviseOnScatter() const
{
    // What comes nearer to rest has one sign in most cells, scatter has any
    const scalar change = max(gasChange_, newSources_);
    if (newSources_ > 0.3*newCells_ || change <= tolerance_)
    {
        return;
    }
    Info<< " What they give was new by " << newCells_
        << " cell by cell, but by " << newSources_
        << " in all: that is the scatter of few parcels. It lets them rest"
        << " within a tolerance of " << change << "; for " << tolerance_
        << " take about " << std::ceil(sqr(change/tolerance_))
        << " times as many parcels, or a window as much longer.";
}


void Foam::steadyFeedback::warnUnlessAtRest() const
{
    if (open())
    {
        WarningInFunction
            << "The run has ended in round " << round_ + 1 << " of the"
            << " particles: they do not rest in the gas yet. Go on to a later"
            << " endTime: a round takes " << delay_ + window_ << " s.";
        adviseOnScatter();
        Info<< endl;
    }
}
