/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "rankTerritories.H"

#include "Pstream.H"

#include <cmath>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::label Foam::rankTerritories::along(const label k, const scalar x) const
{
    if (n_[k] == 1)
    {
        return 0;
    }
    const scalar c = std::floor((x - domain_.low[k])*perLength_[k]);
    if (domain_.periodic[k])
    {
        // What passes more than a period passes all cells
        return label(min(max(c, scalar(-2*n_[k])), scalar(3*n_[k])));
    }
    return label(min(max(c, scalar(0)), scalar(n_[k] - 1)));
}


void Foam::rankTerritories::markMesh(const polyMesh& mesh)
{
    List<boundBox> boxes(mesh.nCells());
    forAll(mesh.faces(), facei)
    {
        for (const label pointi : mesh.faces()[facei])
        {
            const point& p = mesh.points()[pointi];
            boxes[mesh.faceOwner()[facei]].add(p);
            if (facei < mesh.nInternalFaces())
            {
                boxes[mesh.faceNeighbour()[facei]].add(p);
            }
        }
    }
    boolList& marked = mesh_[Pstream::myProcNo()];
    marked.setSize(n_[0]*n_[1]*n_[2], false);
    forAll(boxes, celli)
    {
        impact::sweptBox& box = meshCells_[celli];
        for (label k = 0; k < 3; ++k)
        {
            box.low[k] = boxes[celli].min()[k];
            box.high[k] = boxes[celli].max()[k];
        }
        any(box, [&](const label i) { marked[i] = true; return false; });
    }
    Pstream::gatherList(mesh_);
    Pstream::scatterList(mesh_);
}


void Foam::rankTerritories::widen(std::vector<bool>& marked) const
{
    label stride = 1;
    for (label k = 0; k < 3; ++k)
    {
        const std::vector<bool> before(marked);
        const label n = n_[k];
        for (label i = 0; n > 1 && i < label(before.size()); ++i)
        {
            if (!before[i])
            {
                continue;
            }
            const label at = (i/stride) % n;
            for (label d = -min(width_, n); d <= min(width_, n); ++d)
            {
                const bool inside = at + d >= 0 && at + d < n;
                if (inside || domain_.periodic[k])
                {
                    const label to = ((at + d) % n + n) % n;
                    marked[i + (to - at)*stride] = true;
                }
            }
        }
        stride *= n;
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::rankTerritories::rankTerritories
(
    const polyMesh& mesh,
    const impact::collisionDomain& domain,
    const vector& directions
)
:
    domain_(domain),
    mesh_(Pstream::nProcs()),
    near_(Pstream::nProcs()),
    width_(0),
    meshCells_(mesh.nCells())
{
    label axes = 0;
    scalar volume = 1;
    for (label k = 0; k < 3; ++k)
    {
        if (directions[k] > 0)
        {
            ++axes;
            volume *= domain.high[k] - domain.low[k];
        }
    }
    const scalar size = std::pow(volume/(axes < 3 ? 65536 : 110592), 1.0/axes);
    for (label k = 0; k < 3; ++k)
    {
        const scalar length = domain.high[k] - domain.low[k];
        n_[k] = directions[k] > 0 ? max(label(length/size), label(1)) : 1;
        perLength_[k] = n_[k]/max(length, VSMALL);
    }
    markMesh(mesh);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::rankTerritories::setReach(const scalar distance, const bool extend)
{
    label width = 0;
    for (label k = 0; k < 3; ++k)
    {
        if (n_[k] > 1)
        {
            width = max(width, label(min(distance*perLength_[k], 1e6)) + 1);
        }
    }
    if (width == width_ || (extend && width < width_))
    {
        return;
    }
    width_ = width;
    foreign_.assign(n_[0]*n_[1]*n_[2], false);
    forAll(mesh_, rank)
    {
        std::vector<bool>& near = near_[rank];
        near.assign(mesh_[rank].begin(), mesh_[rank].end());
        widen(near);
        if (rank != Pstream::myProcNo())
        {
            for (std::size_t i = 0; i < near.size(); ++i)
            {
                foreign_[i] = foreign_[i] || near[i];
            }
        }
    }
    std::vector<bool> around(foreign_);
    widen(around);
    foreignFrom_.resize(meshCells_.size());
    for (std::size_t i = 0; i < meshCells_.size(); ++i)
    {
        foreignFrom_[i] =
            any(meshCells_[i], [&](const label k) { return bool(around[k]); });
    }
}
