/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "restitutionTable.H"
#include "jkrMotion.H"
#include "outOfRange.H"

#include <Eigen/Dense>

template<int n>
impact::restitutionTable::interpolation<n>::interpolation()
{
    Eigen::Matrix<double, n + 1, n + 1> powers;
    for (int k = 0; k <= n; ++k)
    {
        const double t = -std::cos(M_PI*k/n);
        point[k] = 0.5*(1 + t);
        powers(k, 0) = 1;
        for (int i = 1; i <= n; ++i)
        {
            powers(k, i) = powers(k, i - 1)*t;
        }
    }
    const Eigen::Matrix<double, n + 1, n + 1> inverse = powers.inverse();
    for (int i = 0; i <= n; ++i)
    {
        for (int k = 0; k <= n; ++k)
        {
            matrix[i][k] = inverse(i, k);
        }
    }
}


template struct
impact::restitutionTable::interpolation<impact::restitutionCurve::degree>;


impact::restitutionTable::restitutionTable(unloadingType unloading)
:
    patches_(nAlpha*nX)
{
    const interpolation<degreeCapture> fitCapture;
    const interpolation<degreeAlpha> fitAlpha;
    const interpolation<degreeX> fitX;

    auto ratioAt = [&](double alpha)
    {
        return jkrMotion(alpha, unloading, 1e-14).captureRatio();
    };
    for (int i = 0; i < nAlpha; ++i)
    {
        const double low = lowest(i), width = lowest(i + 1) - low;
        std::array<double, degreeCapture + 1> g;
        for (int k = 0; k <= degreeCapture; ++k)
        {
            g[k] = std::pow(ratioAt(low + width*fitCapture.point[k]), 0.2);
        }
        capture_[i] = fitCapture.coefficients(g);

        std::array<double, degreeAlpha + 1> alpha, ratio;
        for (int k = 0; k <= degreeAlpha; ++k)
        {
            alpha[k] = low + width*fitAlpha.point[k];
            ratio[k] = ratioAt(alpha[k]);
        }
        for (int j = 0; j < nX; ++j)
        {
            patch values;
            for (int k = 0; k <= degreeAlpha; ++k)
            {
                for (int m = 0; m <= degreeX; ++m)
                {
                    values[k][m] = sample
                    (
                        alpha[k], ratio[k], (j + fitX.point[m])/nX, unloading
                    );
                }
                values[k] = fitX.coefficients(values[k]);
            }
            patch& c = patches_[i*nX + j];
            for (int m = 0; m <= degreeX; ++m)
            {
                std::array<double, degreeAlpha + 1> column;
                for (int k = 0; k <= degreeAlpha; ++k)
                {
                    column[k] = values[k][m];
                }
                column = fitAlpha.coefficients(column);
                for (int k = 0; k <= degreeAlpha; ++k)
                {
                    c[k][m] = column[k];
                }
            }
        }
    }
}


const impact::restitutionTable& impact::restitutionTable::of
(
    unloadingType unloading
)
{
    if (unloading == unloadingType::soft)
    {
        static const restitutionTable soft(unloadingType::soft);
        return soft;
    }
    static const restitutionTable hard(unloadingType::hard);
    return hard;
}


double impact::restitutionTable::sample
(
    double alpha,
    double captureRatio,
    double x,
    unloadingType unloading
)
{
    const double y = 1 - x*x;
    if (y >= 1)
    {
        return 0;
    }
    if (y < 1e-12)
    {
        return jkrMotion::hertzRestitution(alpha);
    }

    // Speed in the units of the motion with beta = 2/3, then in those in
    // which it is 1 if it was greater
    const double p =
        captureRatio*jkrMotion::separationSpeed()*std::pow(y, -5);
    const double ratio = std::fmax(std::pow(p, 0.2), 1.);
    return jkrMotion(alpha, unloading, 1e-11).impact
    (
        jkrCurve(2./3*std::pow(ratio, -3)), p*std::pow(ratio, -5)
    ).exitSpeed/(p*std::pow(ratio, -5));
}


void impact::restitutionTable::refuse(double alpha)
{
    throwOutOfRange("alpha of the table", alpha, rangeText("[]", 0, maxAlpha));
}
