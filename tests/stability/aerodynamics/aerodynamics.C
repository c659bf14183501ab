/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.

Description
    The laws of drag, Magnus force and torque for arguments from next to
    nothing to the absurd, traps on: one row 'case | expected | observed |
    verdict' each.
\*---------------------------------------------------------------------------*/

#include "heatLaw.H"
#include "hendersonDrag.H"
#include "magnusLift.H"
#include "rotationalTorque.H"

#include <algorithm>
#include <cfenv>
#include <cmath>
#include <cstdio>
#include <string>

namespace
{

using namespace impact;

//- Smallest and largest of what a law gives, and whether all are finite
struct extremes
{
    double min = HUGE_VAL, max = -HUGE_VAL;
    int n = 0;
    bool finite = true;

    void add(double value)
    {
        finite = finite && std::isfinite(value);
        min = std::min(min, value);
        max = std::max(max, value);
        ++n;
    }

    void row(const char* name, const char* expected, bool good) const
    {
        std::printf
        (
            "%s | %s | %d values from %.4g to %.4g | %s\n",
            name, expected, n, min, max, finite && good ? "ok" : "FAILED"
        );
    }
};


//- Zero, and powers of ten from 1e-least to 1e+most with three steps each
template<class F>
void sweep(int min, int max, const F& f)
{
    f(0.);
    for (int i = -3*min; i <= 3*max; ++i)
    {
        f(std::pow(10., i/3.));
    }
}


void henderson()
{
    for (const double TwOverT : {0.01, 1., 100.})
    {
        const hendersonDrag drag(1.4, TwOverT);
        extremes CdRe, slow;
        sweep
        (
            30, 12, [&](double Re)
            {
                sweep
                (
                    30, 30, [&](double M)
                    {
                        // Mach over Reynolds number; without relative motion
                        // a Knudsen number
                        CdRe.add(drag.CdRe(Re, Re > 0 ? M/Re : M));
                    }
                );
                if (Re <= 1e-6)
                {
                    slow.add(drag.CdRe(Re, 1e-9)/24);
                }
            }
        );
        char name[100];
        std::snprintf
        (
            name, sizeof name, "Henderson's drag, Tw/T = %g, Re 0 to 1e12, "
            "M 0 to 1e30", TwOverT
        );
        CdRe.row(name, "finite, never thrust", CdRe.min >= 0);
        std::snprintf
        (
            name, sizeof name, "Henderson's drag, Tw/T = %g, Re 0 to 1e-6, "
            "M/Re 1e-9", TwOverT
        );
        slow.row
        (
            name, "24/Re within 0.4 %",
            slow.min > 0.996 && slow.max < 1.004
        );
    }
}


void dragLaws()
{
    for (const dragLaw::kind& kind : dragLaw::kinds())
    {
        extremes CdRe;
        for (const double TpOverT : {1e-3, 1., 1000.})
        {
            dragLaw::coefficients c;
            c.TpOverT = TpOverT;
            for (const auto& number : kind.numbers)
            {
                c.numbers[number.name] =
                    number.name == std::string("omega") ? 1 : 0.1;
            }
            const auto law = dragLaw::New(kind.name, c);
            sweep
            (
                100, 100, [&](double Re)
                {
                    sweep
                    (
                        100, 100, [&](double M)
                        {
                            CdRe.add(law->CdRe(Re, Re > 0 ? M/Re : M));
                        }
                    );
                }
            );
        }
        CdRe.row
        (
            (
                kind.name
              + std::string(", Tp/T 1e-3 to 1000, Re and M 0 to 1e100")
            ).c_str(),
            "finite, never thrust", CdRe.min >= 0
        );
    }
}


void heatLaws()
{
    for (const std::string& name : heatLaw::names())
    {
        extremes Nu;
        const auto law = heatLaw::New(name, heatLaw::coefficients());
        sweep
        (
            100, 100, [&](double Re)
            {
                sweep
                (
                    100, 100, [&](double M)
                    {
                        const auto r = (*law)(Re, Re > 0 ? M/Re : M);
                        Nu.add(r.Nu);
                        Nu.add(r.TawOverT);
                    }
                );
            }
        );
        Nu.row
        (
            ("Heat law " + name + ", Re and M 0 to 1e100").c_str(),
            "finite, positive", Nu.min >= 0
        );
    }
}


void spin()
{
    extremes lift;
    sweep
    (
        30, 30, [&](double Re)
        {
            sweep
            (
                30, 30, [&](double ReOmega)
                {
                    lift.add(magnusLift::coefficient(Re, ReOmega));
                }
            );
        }
    );
    lift.row
    (
        "Magnus coefficient, Re and spin Re 0 to 1e30", "from 0 to 1",
        lift.min >= 0 && lift.max <= 1
    );

    extremes torque, left;
    sweep
    (
        30, 30, [&](double ReOmega)
        {
            torque.add(rotationalTorque::clRe(ReOmega));
            sweep
            (
                30, 30, [&](double t)
                {
                    left.add(rotationalTorque::remaining(ReOmega, t));
                }
            );
        }
    );
    torque.row
    (
        "torque, spin Re 0 to 1e30", "at least Stokes' 64 pi",
        torque.min > 64*M_PI*(1 - 1e-2)
    );
    left.row
    (
        "spin left after 0 to 1e30 relaxation times, spin Re 0 to 1e30",
        "from 0 to 1", left.min >= 0 && left.max <= 1
    );
}

} // End anonymous namespace


int main()
{
    feenableexcept(FE_INVALID | FE_DIVBYZERO | FE_OVERFLOW);
    henderson();
    dragLaws();
    heatLaws();
    spin();
    return 0;
}
