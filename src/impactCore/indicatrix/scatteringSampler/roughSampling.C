/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "roughFlights.H"

void impact::scatteringSampler::setRoughBody()
{
    const convexBody& body = setup_.body;
    const relief& wall = *setup_.wall;
    const reboundLaw& law = setup_.law;
    const bool ellipsoid =
        body.shape() == convexBody::shapeType::ellipsoid;
    const double R = body.radius();
    const double shortest = wall.meanSpacing() - 3*wall.sigmaSpacing();

    vectorRough_ =
        body.symmetryAxis() >= 0 && (ellipsoid || body.isBox())
     && law.normal().least() > 0
     && stretch_ < 512
     && 2.001*R < 2*shortest;
    if (!vectorRough_)
    {
        return;
    }
    const int axis = body.symmetryAxis() % 3;
    const vector3& half = body.semiAxes();
    rough_.shape = body.isSphere() ? roughBody::sphere
      : ellipsoid ? roughBody::spheroid : roughBody::box;
    rough_.a = half[axis];
    rough_.b = half[(axis + 1) % 3];
    rough_.c = half[(axis + 2) % 3];
    rough_.Ja = body.inertia()[axis];
    rough_.Jc = body.inertia()[(axis + 1) % 3];
    rough_.radius = R;
    rough_.wide = 2.001*R > shortest;
    rough_.lever = R - body.leastCurvature();
    rough_.bend = rough_.lever*(1 + freeRotation::skewness(body));
    rough_.top = wall.top();
    rough_.normal = smooth_.normal;
    rough_.tangential = smooth_.tangential;
}


void impact::scatteringSampler::sampleRandomRelief
(
    std::int64_t first,
    int n,
    workspace& w,
    scatteringStatistics& result
) const
{
    visitCounts total;
    roughFlights(*this, w, total, first, n).run();
    total.addTo(result);
}
