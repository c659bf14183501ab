/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "vicinity.H"

#include "PstreamReduceOps.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::vicinity::vicinity(const boundBox& box, const vector& directions)
:
    box_(box),
    n_(Vector<label>::one)
{
    for (label k = 0; k < 3; ++k)
    {
        n_[k] = directions[k] > 0 ? 64 : 1;
    }
    if (cmptProduct(n_) > 4096)
    {
        n_ = Vector<label>(16, 16, 16);
    }
    marked_.setSize(cmptProduct(n_), false);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::vicinity::add(const point& x, const scalar distance)
{
    Vector<label> low, high, i;
    for (label k = 0; k < 3; ++k)
    {
        low[k] = along(k, x[k] - distance);
        high[k] = along(k, x[k] + distance);
    }
    for (i.z() = low.z(); i.z() <= high.z(); ++i.z())
    {
        for (i.y() = low.y(); i.y() <= high.y(); ++i.y())
        {
            for (i.x() = low.x(); i.x() <= high.x(); ++i.x())
            {
                marked_[cell(i)] = true;
            }
        }
    }
}


void Foam::vicinity::reduce()
{
    Pstream::listCombineGather(marked_, orEqOp<bool>());
    Pstream::listCombineScatter(marked_);
}
