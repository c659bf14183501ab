/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "jkrImpactOutput.H"

#include "csvFile.H"
#include "OSspecific.H"

#include <stdexcept>
#include <string>

namespace
{

using namespace Foam;

//- The rows of summary.csv, also on the screen
class summaryFile
{
    csvFile file_;

public:

    explicit summaryFile(const fileName& folder)
    :
        file_(folder/"summary.csv", "quantity,value,unit")
    {}

    void row(const std::string& quantity, scalar value, const char* unit)
    {
        file_.row(quantity, value, unit);
        Info<< "    " << quantity.c_str() << ' ' << value << ' ' << unit << nl;
    }
};


void writeCurve(const fileName& folder, const impact::jkrContact& contact)
{
    csvFile curve(folder/"curve.csv", "contactRadius,overlap,force");
    const scalar a0 = contact.equilibriumRadius();
    if (a0 == 0)
    {
        return;
    }

    // Even in u = sqrt(a/a0), from S on
    const scalar low = std::cbrt(1./6), high = 1.5;
    const label n = 200;
    for (label i = 0; i <= n; ++i)
    {
        const scalar u = low + (high - low)*i/n;
        const impact::contactState s = contact.at(a0*u*u);
        curve.row(s.contactRadius, s.overlap, s.force);
    }

    csvFile points(folder/"points.csv", "point,contactRadius,overlap,force");
    auto point = [&](const char* name, const impact::contactState& s)
    {
        points.row(name, s.contactRadius, s.overlap, s.force);
    };
    point("A", contact.firstTouch());
    point("B", contact.equilibrium());
    point("C", contact.pullOff());
    point("S", contact.lastTouch());
}


void writeAlpha(const fileName& folder, const jkrImpactSetup& setup)
{
    const impact::dissipationLaw& law = setup.law;
    if (law.isConstant())
    {
        return;
    }
    csvFile file(folder/"alpha.csv", "e_n,alpha,fitted");
    if (setup.measured.empty())
    {
        const label n = 100;
        for (label i = 0; i <= n; ++i)
        {
            const scalar e = law.low() + (law.high() - law.low())*i/n;
            file.row(e, law.alpha(e), law.alpha(e));
        }
        return;
    }
    csvFile data(folder/"measured.csv", "V,e_n");
    for (const measuredImpact& m : setup.measured)
    {
        data.row(m.speed, m.restitution);
        file.row
        (
            m.restitution,
            impact::dissipationLaw::calibrated
            (
                m.speed/setup.contact.separationSpeed(),
                m.restitution,
                setup.settings.unloading
            ),
            law.alpha(m.restitution)
        );
    }
}


//- V(e): the speed that belongs to a restitution
void writeInverse(const fileName& folder, const jkrImpactSetup& setup)
{
    const impact::dissipationLaw& law = setup.law;
    const scalar v = setup.contact.separationSpeed();
    csvFile file(folder/"inverse.csv", "e_n,V");
    const label n = 200;
    for (label i = 0; i <= n; ++i)
    {
        const scalar e =
            min(law.low() + (law.high() - law.low())*i/n, law.high());
        const scalar q = law.speed(e);
        if (std::isfinite(q))
        {
            file.row(e, q*v);
        }
    }
}


void writeChain
(
    const fileName& folder,
    const jkrImpactSetup& setup,
    summaryFile& summary
)
{
    typedef impact::contactChain::event event;
    const impact::contactChain& chain = *setup.chain;
    csvFile file
    (
        folder/"chain.csv",
        "V,P1captured,vP1,P2detached,vP2,maxOverlap1,maxOverlap2"
    );
    List<bool> rebounds, detaches;
    forAll(setup.chainSpeeds, i)
    {
        const scalar V = setup.chainSpeeds[i];
        const impact::chainOutcome out = chain.impact(V);
        if (!out.decided)
        {
            WarningInFunction
                << "Impact on the adhered particle at " << V
                << " m/s: not decided after "
                << label(chain.maxSteps())
                << " steps; particles in contact count as staying" << endl;
        }
        file.row
        (
            V, out.firstCaptured, out.firstSpeed, out.secondDetached,
            out.secondSpeed, out.maxOverlap1, out.maxOverlap2
        );
        rebounds.append(!out.firstCaptured);
        detaches.append(out.secondDetached);

        csvFile path
        (
            folder/("chainTrajectory_" + Foam::name(i) + ".csv"),
            "t,overlap1,velocity1,overlap2,velocity2"
        );
        for (const impact::chainMoment& m : chain.trajectory(V))
        {
            path.row
            (
                m.time, m.overlap1, m.velocity1, m.overlap2, m.velocity2
            );
        }
    }

    // Between speeds next to each other with different outcomes
    auto thresholds =
        [&](event what, const List<bool>& happened, const std::string& name)
    {
        label number = 0;
        for (label i = 1; i < happened.size(); ++i)
        {
            if (happened[i] != happened[i - 1])
            {
                summary.row
                (
                    number ? name + "_" + std::to_string(number + 1) : name,
                    chain.threshold
                    (
                        what, setup.chainSpeeds[i - 1], setup.chainSpeeds[i]
                    ),
                    "m/s"
                );
                ++number;
            }
        }
        if (!number)
        {
            Info<< "    " << name.c_str() << ": all speeds of the chain have "
                << "the same outcome" << nl;
        }
    };
    thresholds(event::firstRebounds, rebounds, "V_captureP1");
    thresholds(event::secondDetaches, detaches, "V_detachP2");
}

void writeContact(summaryFile& summary, const impact::jkrContact& contact)
{
    summary.row("radius", contact.radius(), "m");
    summary.row("modulus", contact.modulus(), "Pa");
    summary.row("mass", contact.mass(), "kg");
    summary.row("workOfAdhesion", contact.workOfAdhesion(), "J/m2");
    summary.row("a0", contact.equilibriumRadius(), "m");
    summary.row("F_C", contact.pullOffForce(), "N");
    summary.row("delta_C", contact.pullOffOverlap(), "m");
    summary.row("delta_B", contact.equilibrium().overlap, "m");
    summary.row("delta_hard", contact.pullOff().overlap, "m");
    summary.row("delta_S", contact.lastTouch().overlap, "m");
    summary.row("W_st", contact.separationWork(), "J");
    summary.row
    (
        "W_hard",
        contact.separationWork(impact::unloadingType::hard),
        "J"
    );
    summary.row("v_st", contact.separationSpeed(), "m/s");
}

void writeConstantLaw(summaryFile& summary, const jkrImpactSetup& setup)
{
    const scalar alpha = setup.law.coeffs()[0];
    summary.row("alpha", alpha, "-");
    summary.row
    (
        "V_capture",
        impact::jkrImpact(setup.contact, alpha, setup.settings).captureSpeed(),
        "m/s"
    );
    summary.row
    (
        "e_withoutAdhesion",
        impact::jkrMotion::hertzRestitution(alpha),
        "-"
    );
}

//- Of a law alpha(e)
void writeLaw(summaryFile& summary, const jkrImpactSetup& setup)
{
    const impact::dissipationLaw& law = setup.law;
    const scalar v = setup.contact.separationSpeed();
    for (std::size_t i = 0; i < law.coeffs().size(); ++i)
    {
        summary.row("alpha_c" + std::to_string(i), law.coeffs()[i], "-");
    }
    summary.row("e_low", law.low(), "-");
    summary.row("e_high", law.high(), "-");
    if (law.low() == 0)
    {
        summary.row("V_capture", law.speed(0)*v, "m/s");
    }
    else
    {
        Info<< "    V_capture: alpha(e) does not reach e = 0" << nl;
    }
    label number = 0;
    for (const impact::dissipationLaw::interval& i : law.ambiguous())
    {
        const std::string end = "_" + std::to_string(++number);
        summary.row("V_ambiguousFrom" + end, i.low*v, "m/s");
        summary.row("V_ambiguousTo" + end, i.high*v, "m/s");
        WarningInFunction
            << "Several restitutions belong to one speed between "
            << i.low*v << " and " << i.high*v
            << " m/s: alpha(e) is too steep there. The largest is taken"
            << endl;
    }
    number = 0;
    for (const impact::dissipationLaw::interval& i : law.unreachable())
    {
        const std::string end = "_" + std::to_string(++number);
        summary.row("e_withoutSpeedFrom" + end, i.low, "-");
        summary.row("e_withoutSpeedTo" + end, i.high, "-");
        WarningInFunction
            << "No speed belongs to a restitution between " << i.low
            << " and " << i.high
            << ": alpha(e) damps more than that even without adhesion"
            << endl;
    }
    if (setup.ofContactWithoutAdhesion)
    {
        WarningInFunction
            << "alpha of type marshall without the entry restitution: the"
            << " polynomial belongs to the restitution of a contact"
            << " without adhesion. As a function of the impact's own it"
            << " has solutions only where the error of the fit, 0.001,"
            << " exceeds what adhesion takes. Give the restitution"
            << " without adhesion, or a calibrated alpha" << endl;
    }
}

void writeTrajectory
(
    const fileName& file,
    const impact::jkrImpact& impact,
    const scalar V,
    const label nLoops
)
{
    csvFile path(file, "t,overlap,velocity,force,contactRadius");
    for (const impact::impactMoment& m : impact.trajectory(V, nLoops))
    {
        path.row(m.time, m.overlap, m.velocity, m.force, m.contactRadius);
    }
}

//- Restitution and trajectories by speed
//  \return evaluations of the force
scalar writeRestitution(const fileName& folder, const jkrImpactSetup& setup)
{
    const impact::jkrContact& contact = setup.contact;
    const impact::dissipationLaw& law = setup.law;
    const scalar v = contact.separationSpeed();
    csvFile file
    (
        folder/"restitution.csv",
        "V,e_n,captured,contactTime,maxOverlap"
    );
    scalar evaluations = 0;
    scalar deepest = 0;
    scalar fastest = 0;
    forAll(setup.speeds, i)
    {
        const scalar V = setup.speeds[i];
        try
        {
            impact::normalRebound rebound = {false, 0};
            scalar alpha = law.coeffs()[0];
            if (!law.isConstant())
            {
                rebound = law.rebound(V/v);
                alpha = law.alpha(rebound.restitution);
            }
            const impact::jkrImpact impact(contact, alpha, setup.settings);
            const impact::impactOutcome out = impact.impact(V);
            if (law.isConstant())
            {
                rebound = {out.captured, out.restitution};
            }
            evaluations += out.evaluations;
            if (out.maxOverlap > deepest)
            {
                deepest = out.maxOverlap;
                fastest = V;
            }
            if (rebound.captured)
            {
                file.row(V, 0., true, "", out.maxOverlap);
            }
            else
            {
                file.row
                (
                    V, rebound.restitution, false, out.contactTime,
                    out.maxOverlap
                );
            }
            if (setup.trajectories)
            {
                writeTrajectory
                (
                    folder/("trajectory_" + Foam::name(i) + ".csv"),
                    impact, V, setup.nLoops
                );
            }
        }
        catch (const std::invalid_argument& error)
        {
            FatalIOErrorInFunction(setup.dict)
                << "Entry speeds " << V << " m/s: " << error.what()
                << " (v_st " << v << " m/s)";
            if (!law.isConstant())
            {
                FatalIOError
                    << ". alpha(e) holds for e from " << law.low() << " to "
                    << law.high() << ", at speeds of " << v*law.speed(law.low())
                    << " to " << v*law.speed(law.high()) << " m/s";
            }
            FatalIOError << exit(FatalIOError);
        }
    }
    const scalar share = deepest/contact.radius();
    if (share > 0.1)
    {
        WarningInFunction
            << "At " << fastest << " m/s the overlap is " << share << " of R*:"
            << " the theory holds for a contact that is small against the"
            << " sphere (overlap below 0.1), and most materials yield before"
            << endl;
    }
    return evaluations;
}

void writeAll(const fileName& folder, const jkrImpactSetup& setup)
{
    rmDir(folder, true);
    mkDir(folder);
    writeCurve(folder, setup.contact);
    writeAlpha(folder, setup);

    summaryFile summary(folder);
    writeContact(summary, setup.contact);
    if (setup.law.isConstant())
    {
        writeConstantLaw(summary, setup);
    }
    else
    {
        writeLaw(summary, setup);
        writeInverse(folder, setup);
    }
    summary.row
    (
        "forceEvaluationsPerImpact",
        writeRestitution(folder, setup)/setup.speeds.size(), "-"
    );
    if (setup.chain)
    {
        writeChain(folder, setup, summary);
    }
}

} // End anonymous namespace


void Foam::writeJkrImpact
(
    const fileName& folder,
    const jkrImpactSetup& setup
)
{
    // Beside the results of an earlier run, whose place they take when all
    // are there
    const fileName unfinished(folder + ".unfinished");
    withReason([&] { writeAll(unfinished, setup); });
    rmDir(folder, true);
    mv(unfinished, folder);
}
