/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "cellGas.H"
#include "rankMail.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::cellGas::lookBeyond()
{
    const std::vector<convexCells::boundaryFace>& faces = convex_.boundary();
    const auto joined = [](const convexCells::boundaryFace& face)
    {
        return
            (
                face.kind == convexCells::cyclic
             || face.kind == convexCells::processor
            )
         && face.rotation < 0;
    };
    if (beyondOf_.empty())
    {
        std::int32_t n = 0;
        for (const auto& face : faces)
        {
            beyondOf_.push_back(joined(face) ? n++ : -1);
        }
        beyond_.resize(n);
    }

    struct letter
    {
        label face;
        field gas;
    };
    rankMail::post outgoing(Pstream::nProcs());
    for (const auto& face : faces)
    {
        if (!joined(face))
        {
            continue;
        }
        const polyPatch& patch = mesh_.boundaryMesh()[face.patch];
        field f = cells_[patch.faceCells()[face.patchFace]];
        f.centre = f.centre + face.shift;
        if (face.kind == convexCells::cyclic)
        {
            beyond_[beyondOf_[face.mate]] = f;
            continue;
        }
        rankMail::append(outgoing[face.processor], letter{face.mate, f});
    }
    if (!Pstream::parRun())
    {
        return;
    }

    std::vector<letter> letters;
    for (const std::string& bytes : rankMail::exchange(outgoing))
    {
        rankMail::take(bytes, letters);
    }
    for (const letter& l : letters)
    {
        beyond_[beyondOf_[l.face]] = l.gas;
    }
}
