/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "entrySection.H"
#include "DynamicList.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::entrySection::entrySection()
:
    e_{Zero, Zero},
    origin_{0, 0},
    span_{0, 0},
    n_{0, 0}
{}


Foam::entrySection::entrySection
(
    const pointField& corners,
    const vector& U,
    const vector& empty
)
:
    corners_(corners)
{
    const vector along(normalised(U - (U & empty)*empty));

    // The axis that is nearest to the section, if no direction is empty
    vector second(empty);
    if (magSqr(empty) <= 0)
    {
        direction smallest = 0;
        for (direction d = 1; d < 3; ++d)
        {
            if (mag(along[d]) < mag(along[smallest]))
            {
                smallest = d;
            }
        }
        second[smallest] = 1;
        second = normalised(second - (second & along)*along);
    }
    e_[0] = along ^ second;
    e_[1] = second;

    const label n = corners_.size()/3;
    for (label j = 0; j < 2; ++j)
    {
        const scalarField x(corners_ & e_[j]);
        origin_[j] = min(x);
        span_[j] = max(x) - origin_[j];
    }

    // As many squares as triangles, of about the same sides
    const scalar root = sqrt(scalar(n));
    const scalar aspect = sqrt(span_[0]/max(span_[1], VSMALL));
    n_[0] = max(label(1), label(min(root*aspect, scalar(n))));
    n_[1] = max(label(1), label(n/n_[0]));

    List<DynamicList<label>> triangles(n_[0]*n_[1]);
    for (label i = 0; i < n; ++i)
    {
        label first[2], last[2];
        for (label j = 0; j < 2; ++j)
        {
            scalar minX = GREAT, maxX = -GREAT;
            for (label k = 0; k < 3; ++k)
            {
                const scalar x =
                    ((corners_[3*i + k] & e_[j]) - origin_[j])
                   /max(span_[j], VSMALL);
                minX = min(minX, x);
                maxX = max(maxX, x);
            }
            first[j] = max(label((minX - 1e-9)*n_[j]), label(0));
            last[j] = min(label((maxX + 1e-9)*n_[j]), n_[j] - 1);
        }
        for (label k0 = first[0]; k0 <= last[0]; ++k0)
        {
            for (label k1 = first[1]; k1 <= last[1]; ++k1)
            {
                triangles[k0*n_[1] + k1].append(i);
            }
        }
    }
    triangles_.setSize(triangles.size());
    forAll(triangles_, i)
    {
        triangles_[i].transfer(triangles[i]);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::entrySection::entries Foam::entrySection::enter
(
    const scalar a,
    const scalar b,
    point& x
) const
{
    const scalar y[2] =
        {origin_[0] + a*span_[0], origin_[1] + b*span_[1]};
    const label k0 = min(label(a*n_[0]), n_[0] - 1);
    const label k1 = min(label(b*n_[1]), n_[1] - 1);
    const scalar near = 1e-6*(span_[0] + span_[1]);

    // A line through an edge may meet both triangles there, in one place
    entries result = entries::none;
    for (const label i : triangles_[k0*n_[1] + k1])
    {
        const point* p = &corners_[3*i];
        scalar u[3][2];
        for (label k = 0; k < 3; ++k)
        {
            for (label j = 0; j < 2; ++j)
            {
                u[k][j] = (p[k] & e_[j]) - y[j];
            }
        }
        scalar w[3];
        for (label k = 0; k < 3; ++k)
        {
            const scalar* v1 = u[(k + 1) % 3];
            const scalar* v2 = u[(k + 2) % 3];
            w[k] = v1[0]*v2[1] - v1[1]*v2[0];
        }
        const scalar sum = w[0] + w[1] + w[2];
        if (mag(sum) <= VSMALL)
        {
            continue;
        }
        if (min(min(w[0]/sum, w[1]/sum), w[2]/sum) < -1e-12)
        {
            continue;
        }
        const point there((w[0]*p[0] + w[1]*p[1] + w[2]*p[2])/sum);
        if (result == entries::none)
        {
            result = entries::one;
            x = there;
        }
        else if (mag(there - x) > near)
        {
            return entries::several;
        }
    }
    return result;
}
