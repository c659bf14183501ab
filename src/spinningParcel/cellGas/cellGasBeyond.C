/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "cellGas.H"
#include "PstreamBuffers.H"
#include "UIPstream.H"
#include "UOPstream.H"

#include <cstring>

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

    List<DynamicList<char>> outgoing(Pstream::nProcs());
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
        DynamicList<char>& out = outgoing[face.processor];
        const label at = out.size();
        out.setSize(at + sizeof(face.mate) + sizeof(f));
        std::memcpy(&out[at], &face.mate, sizeof(face.mate));
        std::memcpy(&out[at + sizeof(face.mate)], &f, sizeof(f));
    }
    if (!Pstream::parRun())
    {
        return;
    }

    PstreamBuffers buffers(Pstream::commsTypes::nonBlocking);
    forAll(outgoing, proci)
    {
        if (outgoing[proci].size())
        {
            UOPstream stream(proci, buffers);
            stream << static_cast<const List<char>&>(outgoing[proci]);
        }
    }
    labelList sizes;
    buffers.finishedSends(sizes);
    forAll(sizes, proci)
    {
        if (!sizes[proci])
        {
            continue;
        }
        UIPstream stream(proci, buffers);
        const List<char> bytes(stream);
        const char* p = bytes.cdata();
        const char* last = p + bytes.size();
        while (p < last)
        {
            label facei;
            std::memcpy(&facei, p, sizeof(facei));
            std::memcpy
            (
                &beyond_[beyondOf_[facei]], p + sizeof(facei), sizeof(field)
            );
            p += sizeof(facei) + sizeof(field);
        }
    }
}
