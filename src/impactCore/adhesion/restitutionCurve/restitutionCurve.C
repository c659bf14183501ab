/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "restitutionCurve.H"
#include "jkrMotion.H"
#include "restitutionTable.H"

impact::restitutionCurve::restitutionCurve
(
    double alpha,
    unloadingType unloading
)
:
    captureRatio_
    (
        jkrMotion(alpha, unloading, 1e-14).captureRatio()
    ),
    panels_{}
{
    if (!std::isfinite(captureRatio_))
    {
        return;
    }
    const auto fit = restitutionTable::interpolation<degree>();
    for (int i = 0; i < nPanels; ++i)
    {
        std::array<double, degree + 1> values;
        for (int k = 0; k <= degree; ++k)
        {
            values[k] = restitutionTable::sample
            (
                alpha,
                captureRatio_,
                (i + fit.point[k])/nPanels,
                unloading
            );
        }
        panels_[i] = fit.coefficients(values);
    }
}
