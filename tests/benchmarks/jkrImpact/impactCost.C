/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.

Description
    Error of the restitution against force evaluations and CPU time of the
    schemes of jkrImpact. Prints a table of comma-separated values.
\*---------------------------------------------------------------------------*/

#include "counterRandom.H"
#include "jkrImpact.H"
#include "restitutionTable.H"

#include <algorithm>
#include <cstdio>
#include <ctime>
#include <string>
#include <vector>

namespace
{

using namespace impact;

// Silica sphere of 20 um on steel
const jkrContact contact(10e-6, 50e9, 9.717993e-12, 0.1528);


double cpuSeconds()
{
    timespec t;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return t.tv_sec + 1e-9*t.tv_nsec;
}


//- CPU time of one call [ns], the least of several repetitions
template<class Call>
double nanoseconds(const Call& call, long nCalls)
{
    double minTime = 1e300;
    for (int repetition = 0; repetition < 5; ++repetition)
    {
        volatile double sink = 0;
        const double start = cpuSeconds();
        for (long i = 0; i < nCalls; ++i)
        {
            sink = sink + call(i);
        }
        minTime = std::min(minTime, (cpuSeconds() - start)/nCalls);
    }
    return 1e9*minTime;
}


void row
(
    const char* name,
    const char* scheme,
    const std::string& setting,
    double evaluations,
    double time,
    double error
)
{
    std::printf
    (
        "%s,%s,%s,%.0f,%.3g,%.2g\n",
        name, scheme, setting.c_str(), evaluations, time, error
    );
}


void measure(const char* name, double alpha, double times)
{
    impactSettings settings;
    settings.tolerance = 1e-13;
    const jkrImpact truth(contact, alpha, settings);
    const double V = times*truth.captureSpeed();
    const double e = truth.impact(V).restitution;

    auto one = [&](const char* scheme, const std::string& setting, long calls)
    {
        const jkrImpact impact(contact, alpha, settings);
        const impactOutcome out = impact.impact(V);
        row
        (
            name, scheme, setting, out.evaluations,
            nanoseconds
            (
                [&](long) { return impact.rebound(V).restitution; }, calls
            ),
            std::fabs(impact.rebound(V).restitution - e)
        );
    };
    settings.scheme = impactScheme::rk4;
    for (bool interpolate : {false, true})
    {
        settings.interpolate = interpolate;
        for (double step : {1., 0.3, 0.1, 0.03, 0.01})
        {
            settings.timeStep = 1e-9*step;
            char text[32];
            std::snprintf(text, sizeof(text), "%g ns", step);
            one
            (
                interpolate ? "rk4 interpolated" : "rk4",
                text,
                std::max(1L, long(200*step))
            );
        }
    }
    settings.scheme = impactScheme::adaptive;
    for (double tolerance : {1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 5e-10, 1e-10, 1e-11})
    {
        settings.tolerance = tolerance;
        char text[32];
        std::snprintf(text, sizeof(text), "tolerance %g", tolerance);
        one("adaptive", text, 2000);
    }
    settings.scheme = impactScheme::table;
    one("table", "one alpha", 2000000);
}


//- The tables over all alpha in [0, 1.6] and speeds from capture to 1e4 v_st
void measureTables()
{
    const restitutionTable& table = restitutionTable::of(unloadingType::soft);
    const int n = 4096;
    std::vector<double> alpha(n), q(n);
    double worst = 0, worstCurve = 0;
    for (int i = 0; i < 5*n; ++i)
    {
        counterRandom random(1, i, 0);
        const double a = 1.6*random.uniform();
        impactSettings settings;
        settings.tolerance = 1e-13;
        const jkrImpact impact(contact, a, settings);
        const double g = impact.captureSpeed()/contact.separationSpeed();

        // Half of them within 1 of capture, down to 1e-12 of it
        const double r = random.uniform();
        const double s = i % 2
          ? g*std::pow(1e4/g, r) : g*(1 + std::pow(10, 12*r - 12));
        const double e =
            impact.impact(s*contact.separationSpeed()).restitution;
        worst = std::max(worst, std::fabs(table.rebound(a, s).restitution - e));
        if (i % 64 == 0)
        {
            const restitutionCurve curve(a);
            worstCurve = std::max
            (
                worstCurve, std::fabs(curve.rebound(s).restitution - e)
            );
        }
        alpha[i % n] = a;
        q[i % n] = s;
    }
    auto time = [&](auto&& call)
    {
        return nanoseconds([&](long i) { return call(i % n); }, 1000L*n);
    };
    row
    (
        "worst of all", "table", "any alpha", 0,
        time([&](int i) { return table.rebound(alpha[i], q[i]).restitution; }),
        worst
    );
    const restitutionCurve curve(1.1891);
    row
    (
        "worst of all", "table", "one alpha", 0,
        time([&](int i) { return curve.rebound(28 + q[i]).restitution; }),
        worstCurve
    );
    const double start = cpuSeconds();
    const restitutionTable again(unloadingType::soft);
    const double built = cpuSeconds() - start;
    const double startCurve = cpuSeconds();
    const restitutionCurve curveAgain(1);
    const double builtCurve = cpuSeconds() - startCurve;
    row("construction", "table", "any alpha", 0, 1e9*built, 0);
    row("construction", "table", "one alpha", 0, 1e9*builtCurve, 0);
}

} // End anonymous namespace


int main()
{
    std::puts("case,scheme,setting,force_evaluations,cpu_ns,error");
    measure("undamped 3 V_cap", 0, 3);
    measure("undamped 1.001 V_cap", 0, 1.001);
    measure("damped 3 V_cap", 1.1891, 3);
    measure("damped 1.001 V_cap", 1.1891, 1.001);
    measureTables();
    return 0;
}
