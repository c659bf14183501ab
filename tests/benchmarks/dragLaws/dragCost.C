/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.

Description
    CPU time of an evaluation of each drag law. Prints a table of
    comma-separated values.
\*---------------------------------------------------------------------------*/

#include "dragLaw.H"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <random>
#include <string>
#include <vector>

namespace
{

double cpuSeconds()
{
    timespec t;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return t.tv_sec + 1e-9*t.tv_nsec;
}


//- CPU time of a call over a number of states [ns], the least of several
template<class Call>
double nanoseconds(int states, const Call& call)
{
    double minTime = 1e300;
    for (int repetition = 0; repetition < 7; ++repetition)
    {
        const double start = cpuSeconds();
        for (int i = 0; i < 100; ++i)
        {
            call();
        }
        minTime = std::min(minTime, (cpuSeconds() - start)/100/states);
    }
    return 1e9*minTime;
}

} // End anonymous namespace


int main()
{
    using impact::dragLaw;
    const int n = 4096;
    std::printf("law,Mach,one_ns,batch_ns,over_henderson\n");
    for (const bool fast : {false, true})
    {
        std::mt19937_64 random(1);
        std::uniform_real_distribution<double> uniform(0, 1);
        std::vector<double> Re(n), K(n), TpOverT(n), result(n);
        for (int i = 0; i < n; ++i)
        {
            Re[i] = std::pow(10, -1 + 4*uniform(random));
            K[i] = (fast ? 2 + 4*uniform(random) : 0.9*uniform(random))/Re[i];
            TpOverT[i] = 0.5 + uniform(random);
        }
        double henderson = 0;
        for (const dragLaw::kind& kind : dragLaw::kinds())
        {
            dragLaw::coefficients c;
            for (const auto& number : kind.numbers)
            {
                if (number.deflt < 0)
                {
                    c.numbers[number.name] = 0.8;
                }
            }
            const auto law = dragLaw::New(kind.name, c);
            const double one = nanoseconds
            (
                n, [&]
                {
                    for (int i = 0; i < n; ++i)
                    {
                        result[i] = law->CdRe(Re[i], K[i], TpOverT[i]);
                    }
                }
            );
            const double batch = nanoseconds
            (
                n, [&]
                {
                    law->CdRe(n, Re.data(), K.data(), TpOverT.data(),
                        result.data());
                }
            );
            henderson = henderson > 0 ? henderson : batch;
            std::printf
            (
                "%s,%s,%.1f,%.1f,%.2f\n",
                kind.name, fast ? "2 to 6" : "0 to 0.9", one, batch,
                batch/henderson
            );
        }
    }
}
