/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "wallVisit.H"
#include "contactSearch.H"

#include <cmath>


impact::wallVisit::wallVisit
(
    const convexBody& body,
    const reboundLaw& law,
    visitTreatment treatment,
    int maxImpacts
)
:
    body_(&body),
    law_(law),
    treatment_(treatment),
    maxImpacts_(maxImpacts),
    skewness_(freeRotation::skewness(body))
{}


template<class Shadow>
impact::visitResult impact::wallVisit::visitWith
(
    bodyState state,
    reliefPiece& piece,
    std::int64_t hint
) const
{
    visitResult out = {};
    const double small = 1e-3*mag(state.V);
    const vector3& J = body_->inertia();
    const vector3& spin = state.rotation.omega;
    out.energyOnArrival =
        0.5*(dot(state.V, state.V) + dot(multiply(J, spin), spin));
    bool touching = false;
    bool lost = false;
    double departure = 0;
    for (int impacts = 0; ; ++impacts)
    {
        freeRotation rotation(*body_, state.rotation);
        const contactPoint c =
            contactSearch<Shadow>
            (
                *body_, skewness_, state, rotation, piece, hint
            ).find(touching, departure, lost);
        if (lost)
        {
            out.capped = true;
        }
        if (!c.found)
        {
            break;
        }
        if (treatment_ == visitTreatment::firstImpact && impacts > 0)
        {
            // Would strike again
            out.second = true;
            break;
        }
        if (impacts >= maxImpacts_)
        {
            out.capped = true;
            break;
        }

        // The orientation of a sphere is of no account
        rotationState at = state.rotation;
        if (!body_->isSphere())
        {
            rotation.evaluate(c.time, at);
        }
        const double f = 1/std::sqrt(1 + c.slope*c.slope);
        const vector3 n = f*(at.ey - c.slope*at.ex);
        const vector3 ez = at.ez();
        const vector3 V =
            state.V.x*at.ex + state.V.y*at.ey + state.V.z*ez;
        state.x += state.V.x*c.time;
        state.y += state.V.y*c.time;
        touching = true;

        const impactRecord record =
            law_.impact(J, c.r, n, V, at.omega);
        state.rotation = at;
        if (record.approachSpeed > 0)
        {
            out.second = out.second || impacts > 0;
            const vector3 V2 = V + record.dV;
            state.V = {dot(V2, at.ex), dot(V2, at.ey), dot(V2, ez)};
            state.rotation.omega = at.omega + record.dOmega;
            if (impacts == 0)
            {
                out.intoWall = state.V.y <= 0;
            }
            ++(record.approachSpeed > small ? out.impacts : out.microImpacts);
            out.pulling += record.pulling;
            out.gaining += record.gainsEnergy();
            out.outside += record.outside;
        }
        const vector3 Vn =
            state.V.x*at.ex + state.V.y*at.ey + state.V.z*ez;
        departure =
            dot(n, Vn + cross(state.rotation.omega, c.r))/f;
    }
    out.state = state;
    return out;
}


impact::visitResult impact::wallVisit::visit
(
    const bodyState& state,
    reliefPiece& piece,
    std::int64_t hint
) const
{
    return flatSpheroid::holds(*body_, piece.model())
      ? visitWith<flatSpheroid>(state, piece, hint)
      : body_->shape() == convexBody::shapeType::ellipsoid
      ? visitWith<ellipseShadow>(state, piece, hint)
      : body_->isBox() ? visitWith<boxShadow>(state, piece, hint)
      : visitWith<polygonShadow>(state, piece, hint);
}
