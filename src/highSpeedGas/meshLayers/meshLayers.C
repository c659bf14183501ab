/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "meshLayers.H"
#include "symmetryPolyPatch.H"
#include "SubField.H"
#include "symmetryPlanePolyPatch.H"
#include "wedgePolyPatch.H"
#include <Eigen/SVD>

void Foam::meshLayers::refuse(const label celli, const char* reason) const
{
    FatalErrorInFunction
        << "The mesh has no layers around the body: cell " << celli << " at "
        << mesh_.cellCentres()[celli] << ' ' << reason << nl
        << "Layers are cells one behind the other, as many on every face of"
        << " the body, as in a structured mesh" << exit(FatalError);
    std::abort();
}


Foam::label Foam::meshLayers::opposite
(
    const label celli,
    const label facei
) const
{
    const face& from = mesh_.faces()[facei];
    label found = -1;

    for (const label otherFacei : mesh_.cells()[celli])
    {
        const face& other = mesh_.faces()[otherFacei];
        bool apart = otherFacei != facei && other.size() == from.size();
        for (const label pointi : other)
        {
            apart = apart && !from.found(pointi);
        }
        if (apart)
        {
            if (found >= 0)
            {
                refuse(celli, "has several faces opposite to one");
            }
            found = otherFacei;
        }
    }
    if (found < 0)
    {
        refuse(celli, "has no face opposite to that towards the body");
    }
    return found;
}


void Foam::meshLayers::extend
(
    const label celli,
    const label facei,
    const label oppositeFace,
    labelList& next
) const
{
    const face& from = mesh_.faces()[facei];
    const face& to = mesh_.faces()[oppositeFace];

    for (const label sidei : mesh_.cells()[celli])
    {
        const face& side = mesh_.faces()[sidei];
        if (sidei == facei || sidei == oppositeFace)
        {
            continue;
        }
        forAll(side, i)
        {
            const label a = side[i];
            const label b = side.nextLabel(i);
            for (const edge& e : {edge(a, b), edge(b, a)})
            {
                if (from.found(e.first()) && to.found(e.second()))
                {
                    label& n = next[e.first()];
                    if (n >= 0 && n != e.second())
                    {
                        refuse(celli, "has edges that lead apart");
                    }
                    n = e.second();
                }
            }
        }
    }
    for (const label pointi : from)
    {
        if (next[pointi] < 0)
        {
            refuse(celli, "has points without an edge away from the body");
        }
    }
}


Foam::meshLayers::meshLayers(const polyMesh& mesh, const labelHashSet& body)
:
    mesh_(mesh)
{
    DynamicList<label> faces;
    for (const label patchi : body.sortedToc())
    {
        const polyPatch& patch = mesh.boundaryMesh()[patchi];
        forAll(patch, i)
        {
            faces.append(patch.start() + i);
        }
    }
    bodyFaces_.transfer(faces);
    if (bodyFaces_.empty())
    {
        FatalErrorInFunction
            << "The body has no faces" << exit(FatalError);
    }

    // From face to face through the cells
    boolList visited(mesh.nCells(), false);
    labelList next(mesh.nPoints(), -1);
    columns_.setSize(bodyFaces_.size());
    outerFaces_.setSize(bodyFaces_.size());
    forAll(bodyFaces_, columni)
    {
        DynamicList<label> column;
        label facei = bodyFaces_[columni];
        label celli = mesh.faceOwner()[facei];
        while (true)
        {
            if (visited[celli])
            {
                refuse(celli, "belongs to two columns");
            }
            visited[celli] = true;
            column.append(celli);

            const label to = opposite(celli, facei);
            extend(celli, facei, to, next);
            facei = to;
            if (!mesh.isInternalFace(facei))
            {
                break;
            }
            celli =
                mesh.faceOwner()[facei] == celli
              ? mesh.faceNeighbour()[facei]
              : mesh.faceOwner()[facei];
        }
        if (body.found(mesh.boundaryMesh().whichPatch(facei)))
        {
            refuse(celli, "stands between two faces of the body");
        }
        if (columni && column.size() != columns_[0].size())
        {
            refuse(celli, "ends a column of another number of cells");
        }
        columns_[columni].transfer(column);
        outerFaces_[columni] = facei;
    }
    forAll(visited, celli)
    {
        if (!visited[celli])
        {
            refuse(celli, "does not stand in a column on the body");
        }
    }
    if (size() < 8)
    {
        FatalErrorInFunction
            << "The mesh has " << size() << " layers around the body; to"
            << " follow a shock takes 8 or more" << exit(FatalError);
    }

    // From point to point along the edges
    labelList lineOf(mesh.nPoints(), -1);
    DynamicList<labelList> lines;
    for (const label facei : bodyFaces_)
    {
        for (const label start : mesh.faces()[facei])
        {
            if (lineOf[start] >= 0)
            {
                continue;
            }
            labelList line(size() + 1);
            label pointi = start;
            forAll(line, i)
            {
                if (pointi < 0 || lineOf[pointi] >= 0)
                {
                    FatalErrorInFunction
                        << "The mesh has no layers around the body: the edges"
                        << " from point " << start << " at "
                        << mesh.points()[start] << " do not lead through all"
                        << exit(FatalError);
                }
                lineOf[pointi] = lines.size();
                line[i] = pointi;
                pointi = next[pointi];
            }
            lines.append(line);
        }
    }
    lines_.transfer(lines);
    setNeighbours(lineOf);
    setImages();
}


void Foam::meshLayers::appendImages(const polyPatch& patch)
{
    const label most = 6;
    DynamicList<vector> areas;
    DynamicList<point> origins;
    forAll(patch, i)
    {
        const vector area(patch.faceAreas()[i]);
        label k = 0;
        while
        (
            k < areas.size()
         && (areas[k] & area) < (1 - 1e-4)*mag(areas[k])*mag(area)
        )
        {
            k++;
        }
        if (k == most)
        {
            FatalErrorInFunction
                << "Patch " << patch.name() << " of type " << patch.type()
                << " is curved: its faces have more than " << most
                << " directions." << nl
                << "A plane of symmetry is plane. Give what is curved the type"
                << " patch, and slip as the condition of U" << exit(FatalError);
        }
        if (k == areas.size())
        {
            areas.append(Zero);
            origins.append(patch.faceCentres()[i]);
        }
        areas[k] += area;
    }
    forAll(areas, k)
    {
        const vector n(normalised(areas[k]));
        images_.append(image{origins[k], I - 2*sqr(n)});
    }
}


void Foam::meshLayers::setImages()
{
    for (const polyPatch& patch : mesh_.boundaryMesh())
    {
        if (patch.empty())
        {
            continue;
        }
        if (isA<wedgePolyPatch>(patch))
        {
            // Beyond the axis, which goes through the origin
            const vector axis
            (
                normalised(refCast<const wedgePolyPatch>(patch).axis())
            );
            images_ = List<image>({image{Zero, 2*sqr(axis) - I}});
            return;
        }
        if
        (
            isA<symmetryPlanePolyPatch>(patch)
         || isA<symmetryPolyPatch>(patch)
        )
        {
            appendImages(patch);
        }
    }
}


void Foam::meshLayers::setNeighbours(const labelList& lineOf)
{
    labelListList around(lines_.size());
    forAll(bodyFaces_, columni)
    {
        for (const label pointi : mesh_.faces()[bodyFaces_[columni]])
        {
            around[lineOf[pointi]].append(columni);
        }
    }

    neighbours_.setSize(lines_.size());
    forAll(lines_, linei)
    {
        labelHashSet set(around[linei]);
        for (int ring = 0; ring < 3; ring++)
        {
            for (const label columni : set.toc())
            {
                for (const label pointi : mesh_.faces()[bodyFaces_[columni]])
                {
                    set.insert(around[lineOf[pointi]]);
                }
            }
        }
        neighbours_[linei] = set.sortedToc();
    }
}


Foam::scalarField Foam::meshLayers::depths(const label column) const
{
    const labelList& cells = columns_[column];
    scalarField depth(cells.size() + 1);
    point before = mesh_.faceCentres()[bodyFaces_[column]];
    scalar sum = 0;
    forAll(depth, i)
    {
        const point& centre =
            i < cells.size()
          ? mesh_.cellCentres()[cells[i]]
          : mesh_.faceCentres()[outerFaces_[column]];
        sum += mag(centre - before);
        depth[i] = sum;
        before = centre;
    }
    return depth;
}


Foam::scalarField Foam::meshLayers::toLines
(
    const scalarField& ofColumns
) const
{
    scalarField values(lines_.size());
    forAll(lines_, linei)
    {
        const labelList& columns = neighbours_[linei];
        const point& here = mesh_.points()[lines_[linei][0]];

        vector normal(Zero);
        point middle(Zero);
        scalar reach = 0;
        for (const label columni : columns)
        {
            const label facei = bodyFaces_[columni];
            normal += normalised(mesh_.faceAreas()[facei]);
            middle += mesh_.faceCentres()[facei]/columns.size();
            reach = max(reach, mag(mesh_.faceCentres()[facei] - here));
        }
        normal.normalise();
        vector shortAxis(Zero);
        shortAxis[findMin(cmptMag(normal))] = 1;
        const vector across(normalised(normal ^ shortAxis));
        const vector along(normal ^ across);

        // In the tangent plane: a body is a surface. What lies behind planes
        // of symmetry and the axis is known as well.
        DynamicList<Tuple2<vector, scalar>> known(4*columns.size());
        for (const label columni : columns)
        {
            const point& centre = mesh_.faceCentres()[bodyFaces_[columni]];
            const label begin = known.size();
            known.append({centre, ofColumns[columni]});
            for (const image& other : images_)
            {
                for (label i = known.size() - 1; i >= begin; i--)
                {
                    const point behind
                    (
                        other.origin
                      + (other.turn & (known[i].first() - other.origin))
                    );
                    if (mag(behind - here) < reach)
                    {
                        known.append({behind, ofColumns[columni]});
                    }
                }
            }
        }

        const auto powersAt = [&](const point& place)
        {
            const scalar x = ((place - middle) & across)/reach;
            const scalar y = ((place - middle) & along)/reach;
            Eigen::Matrix<double, 1, 6> powers;
            powers << 1, x, y, x*x, x*y, y*y;
            return powers;
        };
        Eigen::MatrixXd powers(known.size(), 6);
        Eigen::VectorXd heights(known.size());
        forAll(known, i)
        {
            powers.row(i) = powersAt(known[i].first());
            heights(i) = known[i].second();
        }

        // (seen from their middle, in a direction in which no columns lie
        // nothing changes)
        Eigen::JacobiSVD<Eigen::MatrixXd> fit
        (
            powers, Eigen::ComputeThinU | Eigen::ComputeThinV
        );
        fit.setThreshold(1e-3);
        values[linei] = powersAt(here).dot(fit.solve(heights));
    }
    return values;
}


Foam::scalarField Foam::meshLayers::toColumns
(
    const scalarField& ofLines
) const
{
    Map<label> lineOf(2*lines_.size());
    forAll(lines_, linei)
    {
        lineOf.insert(lines_[linei][0], linei);
    }
    scalarField values(bodyFaces_.size(), Zero);
    forAll(bodyFaces_, columni)
    {
        const face& f = mesh_.faces()[bodyFaces_[columni]];
        for (const label pointi : f)
        {
            values[columni] += ofLines[lineOf[pointi]]/f.size();
        }
    }
    return values;
}
