/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.

Description
    Henderson's drag against creeping flow, the slip correction, exact
    free-molecular drag and the misprints of the formula in circulation.
\*---------------------------------------------------------------------------*/

#include "hendersonDrag.H"

#include <gtest/gtest.h>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

using impact::hendersonDrag;

namespace
{

//- Exact drag coefficient of a sphere in free-molecular flow, diffuse
//  reflection with full accommodation (Schaaf & Chambre 1958)
double CdFreeMolecular(double S, double TwOverT)
{
    const double S2 = S*S;
    return
        (2*S2 + 1)/(std::sqrt(M_PI)*S2*S)*std::exp(-S2)
      + (4*S2*S2 + 4*S2 - 1)/(2*S2*S2)*std::erf(S)
      + 2*std::sqrt(M_PI)/(3*S)*std::sqrt(TwOverT);
}


//- The formula as printed, written down a second time in terms of Cd, Re, M
//  and without any regard to rounding. The variants are misreadings:
//  1: the exponential reaches only the first fraction of its brace
//  2: the slip exponential multiplies 4.33 as well
//  3: -1/S^4 stands outside the rarefaction factor
//  4: the temperature ratio is not under the root
//  5: the last subsonic term has exp(-M/Re) for 1 - exp(-M/Re)
double CdPrinted
(
    double Re,
    double M,
    double gamma,
    double TwOverT,
    int variant = 0
)
{
    const double S = M*std::sqrt(gamma/2);
    if (M <= 1)
    {
        const double temperature =
            (3.65 - 1.53*TwOverT)/(1 + 0.353*TwOverT);
        const double slipExp = std::exp(-0.247*Re/S);
        const double slip =
            variant == 2
          ? (4.33 + temperature)*slipExp
          : 4.33 + temperature*slipExp;
        const double x = 0.03*Re + 0.48*std::sqrt(Re);
        const double fraction = (4.5 + 0.38*x)/(1 + x);
        const double powers = 0.1*std::pow(M, 2) + 0.2*std::pow(M, 8);
        const double decay = std::exp(-0.5*M/std::sqrt(Re));
        const double last = std::exp(-M/Re);
        return
            24/(Re + S*slip)
          + (
                variant == 1
              ? decay*fraction + powers
              : decay*(fraction + powers)
            )
          + (variant == 5 ? last : 1 - last)*0.6*S;
    }
    if (M >= 1.75)
    {
        const double r = 1.86*std::sqrt(M/Re);
        const double T = variant == 4 ? TwOverT : std::sqrt(TwOverT);
        const double inner = 2 + 2/(S*S) + 1.058/S*T;
        const double S4 = 1/std::pow(S, 4);
        const double top = 0.9 + 0.34/(M*M);
        return
            variant == 3
          ? (top + r*inner - S4)/(1 + r)
          : (top + r*(inner - S4))/(1 + r);
    }
    return
        CdPrinted(Re, 1, gamma, TwOverT, variant)
      + 4./3*(M - 1)
       *(
            CdPrinted(Re, 1.75, gamma, TwOverT, variant)
          - CdPrinted(Re, 1, gamma, TwOverT, variant)
        );
}


double Cd(double Re, double M, double gamma = 1.4, double TwOverT = 1)
{
    return hendersonDrag(gamma, TwOverT).CdRe(Re, M/Re)/Re;
}

} // End anonymous namespace


TEST(hendersonDrag, meetsStokesAtSmallReynoldsNumber)
{
    const hendersonDrag drag(1.4, 1);
    for (double Re : {1e-300, 1e-9, 1e-6, 1e-3})
    {
        EXPECT_NEAR(drag.CdRe(Re, 0)/24, 1, 4e-3);
        EXPECT_NEAR(drag.CdRe(Re, 1e-9)/24, 1, 4e-3);
    }
    EXPECT_EQ(drag.CdRe(0, 0), 24);
}


TEST(hendersonDrag, tendsToASlipCorrectionAtRest)
{
    const hendersonDrag drag(1.4, 1);
    for (double K = 1e-6; K < 1e4; K *= 3)
    {
        // Re and M vanish together at a fixed ratio: one finite limit,
        // approached from all speeds and taken at rest
        const double rest = drag.CdRe(0, K);
        EXPECT_GT(rest, 0);
        EXPECT_NEAR(drag.CdRe(1e-300, K)/rest, 1, 1e-13);
        EXPECT_NEAR(drag.CdRe(1e-12/(1 + K), K)/rest, 1, 1e-9);

        // Cunningham's correction with the coefficients of Davies (1945),
        // Kn = 2 lambda/d with lambda = mu/rho sqrt(pi gamma/2)/a
        const double Kn = 2*K*std::sqrt(M_PI*1.4/2);
        const double slip = 1 + Kn*(1.257 + 0.4*std::exp(-1.1/Kn));
        EXPECT_NEAR(rest*slip/24, 1, 0.03) << "K = " << K;
    }
}


TEST(hendersonDrag, meetsFreeMolecularDragToTheQuotedDeviation)
{
    const double gamma = 1.4;
    const auto deviation = [&](double M)
    {
        return
            Cd(1e-9*M, M)/CdFreeMolecular(M*std::sqrt(gamma/2), 1) - 1;
    };

    double worst = 0;
    for (double M = 0.1; M <= 1; M += 0.1)
    {
        EXPECT_LE(deviation(M), 0);
        worst = std::min(worst, deviation(M));
    }
    EXPECT_NEAR(worst, -0.03, 0.003);
    EXPECT_NEAR(deviation(1.75), -0.054, 5e-4);
    EXPECT_NEAR(deviation(3), -0.022, 5e-4);
    EXPECT_NEAR(deviation(6), -0.011, 5e-4);
}


TEST(hendersonDrag, equalsThePrintedFormulaAndNoneOfItsMisreadings)
{
    const std::vector<double> Res{0.03, 1, 40, 900, 2e4};
    const std::vector<double> Ms{0.1, 0.6, 0.99, 1.2, 1.6, 1.75, 2.5, 6, 12};
    std::vector<double> largest(6, 0);
    for (double gamma : {1.3, 5./3})
    {
        for (double TwOverT : {0.4, 1., 3.})
        {
            for (double Re : Res)
            {
                for (double M : Ms)
                {
                    const double value = Cd(Re, M, gamma, TwOverT);
                    for (int variant = 0; variant < 6; ++variant)
                    {
                        const double other =
                            CdPrinted(Re, M, gamma, TwOverT, variant);
                        largest[variant] = std::max
                        (
                            largest[variant],
                            std::fabs(value/other - 1)
                        );
                    }
                }
            }
        }
    }
    EXPECT_LT(largest[0], 1e-13);
    for (int variant = 1; variant < 6; ++variant)
    {
        EXPECT_GT(largest[variant], 0.01) << "misreading " << variant;
    }
}


TEST(hendersonDrag, isContinuousAtTheEndsOfTheInterpolatedRange)
{
    for (double Re : {1e-6, 50., 1e7})
    {
        for (double M : {1.0, 1.75})
        {
            const double below = Cd(Re, M*(1 - 1e-12));
            const double above = Cd(Re, M*(1 + 1e-12));
            EXPECT_NEAR(below/above, 1, 1e-10);
        }
    }
}


TEST(hendersonDrag, isFiniteAndPositiveOnAnyInput)
{
    // With the traps on, an overflow or an invalid operation would abort
    for (double TwOverT : {1e-3, 1., 50.})
    {
        const hendersonDrag drag(1.4, TwOverT);
        for (double Re = 1e-300; Re < 2e8; Re *= 1e4)
        {
            for (double M : {0., 1e-300, 1e-12, 0.3, 1., 1.4, 1.75, 8., 1e3})
            {
                const double value = drag.CdRe(Re, M/Re);
                EXPECT_TRUE(std::isfinite(value));

                // The slip amplitude of the fit turns negative for
                // Tw/T > 2.39, but never outweighs its 4.33
                EXPECT_GT(value, 0) << Re << ' ' << M << ' ' << TwOverT;
            }
        }
        EXPECT_GT(drag.CdRe(0, 1e300), 0);
        EXPECT_GT(drag.CdRe(0, 1e-310), 0);
    }
}


TEST(hendersonDrag, refusesBadCoefficients)
{
    EXPECT_THROW(hendersonDrag(1, 1), std::invalid_argument);
    EXPECT_THROW(hendersonDrag(1.4, 0), std::invalid_argument);
    EXPECT_THROW(hendersonDrag(1.4, -1), std::invalid_argument);
    EXPECT_THROW
    (
        hendersonDrag(std::numeric_limits<double>::quiet_NaN(), 1),
        std::invalid_argument
    );
}
