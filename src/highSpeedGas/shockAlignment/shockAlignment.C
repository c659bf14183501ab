/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "shockAlignment.H"
#include "checked.H"
#include "gasMesh.H"
#include "polyMeshTetDecomposition.H"
#include "volFields.H"
#include "wallPolyPatch.H"

Foam::labelHashSet Foam::shockAlignment::bodyPatches
(
    const polyMesh& mesh,
    const dictionary& dict
)
{
    const polyBoundaryMesh& patches = mesh.boundaryMesh();
    if (!dict.found("body"))
    {
        labelHashSet walls(patches.findPatchIDs<wallPolyPatch>());
        if (walls.empty())
        {
            FatalIOErrorInFunction(dict)
                << "The mesh has no patch of type wall. Entry body names the"
                << " patch at which the layers begin" << nl
                << "Valid: " << patches.names() << exit(FatalIOError);
        }
        return walls;
    }

    // One name, or a list of them
    ITstream& is = dict.lookup("body");
    const bool one = is.size() == 1;
    const wordRes names
    (
        one ? wordRes({wordRe(is)}) : dict.get<wordRes>("body")
    );
    for (const wordRe& name : names)
    {
        if (wordRes({name}).matching(patches.names()).empty())
        {
            FatalIOErrorInFunction(dict)
                << "Entry body " << name << " matches no patch" << nl
                << "Valid: " << patches.names() << exit(FatalIOError);
        }
    }
    return patches.patchSet(names, false);
}


Foam::shockAlignment::shockAlignment(fvMesh& mesh, const dictionary& dict)
:
    mesh_(mesh),
    layers_(mesh, bodyPatches(mesh, dict)),
    lines_(layers_.lines().size()),
    moves_(0),
    width_(GREAT),
    narrows_(true),
    doubt_(0),
    change_(GREAT),
    nAtRest_(0),
    nWanted_(1)
{
    refuseOthers
    (
        dict,
        {
            "body", "outer", "bandShare", "bandWidth", "wallShare",
            "wallWidth", "rounds", "tolerance"
        }
    );
    outer_ = getNumber(dict, "outer", "[1.02, 10]", scalar(1.15));
    bandShare_ = getNumber(dict, "bandShare", "[0, 0.9]", scalar(0.4));
    bandWidth_ = getNumber(dict, "bandWidth", "[0.001, 1]", scalar(0.06));
    wallShare_ = getNumber(dict, "wallShare", "[0, 0.9]", scalar(0));
    wallWidth_ = getNumber(dict, "wallWidth", "[0.001, 1]", scalar(0.1));
    rounds_ = getNumber<label>(dict, "rounds", "[1, 100]", 15);
    if (bandShare_ + wallShare_ > 0.9)
    {
        refuse
        (
            dict, "wallShare", wallShare_,
            "[0, 0.9 - bandShare]: some cells stand elsewhere"
        );
    }

    // Where the shock is several cells off its place within the band, cells
    // at its two sides are crossed, and all behind feel it. What is left of
    // its waves is to fall with the square of the cells, as other errors do,
    // until the shock is known no better
    const scalarField x(spacing(outer_, bandWidth_));
    label i = 0;
    while (x[i + 1] < 1)
    {
        i++;
    }
    const scalar cell = x[i + 1] - x[i];
    const scalar share = max(1.0/16, min(1.0/3, 40*cell));
    tolerance_ = getNumber(dict, "tolerance", "(0, 1)", share*cell);

    // A mesh made from one with a wider band has lines that are less smooth
    // than they could be, and the gas at a stagnation point feels their kinks,
    // however little the shock moves, the more the finer cells along the body
    // are: on 80 x 120 cells by 0.4 % of its velocity gradient after the first
    // move without, by 0.1 % after the second. (In few cells a shock may go to
    // and fro with the mesh by about the tolerance.)
    nWanted_ = tolerance_ < 2e-4 ? 2 : 1;

    forAll(lines_, linei)
    {
        lines_[linei] = pointField(mesh.points(), layers_.lines()[linei]);
    }
    Info<< "Layers: " << layers_.size() << " on each of "
        << layers_.bodyFaces().size() << " faces of the body, to rest where"
        << " the shock moves by less than " << 100*tolerance_
        << " % of its distance" << endl;
}


void Foam::shockAlignment::checkInflow
(
    const volVectorField& U,
    const volScalarField& soundSpeed
) const
{
    scalar maxMach = 0;
    forAll(layers_.outerFaces(), columni)
    {
        const vector& S = mesh_.faceAreas()[layers_.outerFaces()[columni]];
        maxMach = max
        (
            maxMach,
           -(outside(U, columni) & S)/mag(S)/outside(soundSpeed, columni)
        );
    }
    if (maxMach < 1)
    {
        FatalErrorInFunction
            << "There is no shock before the body: through the outer boundary"
            << " the gas flows in at a Mach number of " << maxMach
            << " at most" << nl
            << "Layers follow the bow shock of a supersonic stream"
            << exit(FatalError);
    }
}


void Foam::shockAlignment::findShock(const volScalarField& p)
{
    const labelListList& columns = layers_.columns();
    captured_.setSize(columns.size());
    doubt_ = 0;

    forAll(columns, columni)
    {
        scalarField q(p, columns[columni]);
        q.append(outside(p, columni));
        const scalarField depth(layers_.depths(columni));
        const label last = q.size() - 1;

        // The steepest fall of the pressure outwards, and the pressures some
        // cells before and behind it
        label steepest = 0;
        for (label i = 1; i < last; i++)
        {
            if (q[i] - q[i + 1] > q[steepest] - q[steepest + 1])
            {
                steepest = i;
            }
        }
        const scalar front = q[min(steepest + 4, last)];
        const scalar behind = max(q[max(steepest - 2, 0)], q[steepest]);
        if (behind < 1.05*front)
        {
            const label facei = layers_.bodyFaces()[columni];
            FatalErrorInFunction
                << "There is no shock before face " << facei
                << " of the body at " << mesh_.faceCentres()[facei]
                << ": nowhere on the way outwards does the pressure fall by"
                << " 5 % within some cells" << nl
                << "Layers can follow a bow shock that stands before all of"
                << " the body" << exit(FatalError);
        }

        const scalar mean = 0.5*(front + behind);
        label i = min(steepest + 3, last - 1);
        while (i > 0 && q[i] < mean)
        {
            i--;
        }
        const scalar share = (q[i] - mean)/(q[i] - q[i + 1]);
        const scalar gap = depth[i + 1] - depth[i];
        captured_[columni] = depth[i] + share*gap;
        doubt_ = max(doubt_, 4*gap/captured_[columni]);

        // A shock on the outer boundary cannot go where it belongs
        const scalar room = depth[last]/captured_[columni] - 1;
        if (steepest > last - 4 && room < 0.5*(outer_ - 1))
        {
            doubt_ = max(doubt_, scalar(0.5));
        }
    }
}


bool Foam::shockAlignment::follows(const volScalarField& p)
{
    findShock(p);
    const scalarField before(distance_);
    distance_ = layers_.toLines(captured_);
    const auto refuseAttached = [&](const label linei)
    {
        FatalErrorInFunction
            << "The shock does not stand before all of the body: it is"
            << " attached, or wanders, near " << lines_[linei][0] << nl
            << "Layers can follow the detached shock of a blunt body. Before a"
            << " sharp one let mesh lines run along its shock by hand"
            << exit(FatalError);
    };
    const label nearest = findMin(distance_);
    if (distance_[nearest] <= 0)
    {
        refuseAttached(nearest);
    }
    if (before.empty())
    {
        return false;
    }

    const scalarField changes(mag(distance_/before - 1));
    const label worst = findMax(changes);
    change_ = Foam::sqrt(average(sqr(changes)));
    doubt_ = max(doubt_, 4*changes[worst]);
    if (moves_ > 2 && changes[worst] > 0.25)
    {
        refuseAttached(worst);
    }
    Info<< "Shock: moved by " << 100*change_ << " % of its distance, by "
        << 100*changes[worst] << " % at " << lines_[worst][0] << endl;
    nAtRest_ = change_ < tolerance_ && !narrows_ ? nAtRest_ + 1 : 0;
    if (rests() && width_ > max(0.5, bandWidth_))
    {
        // Some cells from the body for good
        refuseAttached(nearest);
    }
    return rests();
}


bool Foam::shockAlignment::rests() const
{
    return nAtRest_ >= nWanted_;
}


void Foam::shockAlignment::report() const
{
    if (rests())
    {
        Info<< "Mesh: follows the shock after " << moves_ << " moves" << endl;
    }
    else
    {
        WarningInFunction
            << "The shock still moves by " << 100*change_
            << " % of its distance after " << moves_
            << " moves of the mesh; it is to rest within " << 100*tolerance_
            << " %" << (nWanted_ > 1 ? " after two in a row" : "")
            << (narrows_ ? ", in a band that has been narrowed" : "") << nl
            << "    Set more rounds, more layers (here " << layers_.size()
            << ") or a larger bandWidth (here " << bandWidth_ << ')' << endl;
    }

    // Band cells thinner than their faces are warped
    label n = 0;
    for
    (
        const label base : polyMeshTetDecomposition::findFaceBasePts(mesh_)
    )
    {
        n += base < 0;
    }
    reduce(n, sumOp<label>());
    if (n)
    {
        WarningInFunction
            << n << " faces of the mesh have no decomposition into tetrahedra,"
            << " which clouds need (checkMesh -allGeometry says where). Take a"
            << " larger bandWidth, or more cells along the body" << endl;
    }
}


Foam::scalarField Foam::shockAlignment::spacing
(
    const scalar outer,
    const scalar width
) const
{
    // Cells up to x: integrals of the parts of n(x), each 1 at the outer
    // boundary
    const label n = 20000;
    scalarField uniform(n + 1), band(n + 1, Zero), wall(n + 1);
    const scalar dx = outer/n;
    for (label i = 0; i <= n; i++)
    {
        const scalar x = i*dx;
        uniform[i] = x/outer;
        wall[i] = -std::expm1(-x/wallWidth_)/-std::expm1(-outer/wallWidth_);
        if (i)
        {
            band[i] =
                band[i - 1] + std::exp(-pow4((x - 0.5*dx - 1)/(0.5*width)));
        }
    }
    const scalarField cells
    (
        layers_.size()
       *(
            (1 - bandShare_ - wallShare_)*uniform
          + bandShare_*band/band[n]
          + wallShare_*wall
        )
    );

    scalarField x(layers_.size() + 1);
    label i = 0;
    forAll(x, j)
    {
        while (i < n - 1 && cells[i + 1] < j)
        {
            i++;
        }
        x[j] = dx*(i + (j - cells[i])/(cells[i + 1] - cells[i]));
    }
    x.first() = 0;
    x.last() = outer;
    return x;
}


Foam::point Foam::shockAlignment::at
(
    const pointField& line,
    const scalar distance
) const
{
    scalar left = distance;
    for (label i = 1; i < line.size() - 1; i++)
    {
        const scalar length = mag(line[i] - line[i - 1]);
        if (left <= length)
        {
            return line[i - 1] + (left/length)*(line[i] - line[i - 1]);
        }
        left -= length;
    }
    const point& end = line[line.size() - 2];
    return end + left*normalised(line.last() - end);
}


void Foam::shockAlignment::movePoints(const scalarField& spacing)
{
    pointField points(mesh_.points());
    forAll(lines_, linei)
    {
        const labelList& line = layers_.lines()[linei];
        forAll(line, i)
        {
            points[line[i]] = at(lines_[linei], spacing[i]*distance_[linei]);
        }
    }

    // Not as a mesh that moves in time: nothing of its past is kept
    mesh_.polyMesh::movePoints(points);
    mesh_.clearOut();
    mesh_.resetMotion();
    mesh_.moving(false);
    gasMesh::refuseInsideOut
    (
        mesh_,
        "Lines of the layers cross behind the outer boundary as it was, or in a"
        " band too thin for their slope. Take lines that spread on their way"
        " outwards, or a larger bandWidth"
    );
}


template<class Type>
Type Foam::shockAlignment::outside
(
    const GeometricField<Type, fvPatchField, volMesh>& field,
    const label columni
) const
{
    const label facei = layers_.outerFaces()[columni];
    const label patchi = mesh_.boundaryMesh().whichPatch(facei);
    const fvPatchField<Type>& values = field.boundaryField()[patchi];
    return values[facei - values.patch().start()];
}


template<class Type>
void Foam::shockAlignment::take
(
    GeometricField<Type, fvPatchField, volMesh>& field,
    const List<scalarField>& before,
    const List<scalarField>& after
) const
{
    Field<Type>& values = field.primitiveFieldRef();
    forAll(before, columni)
    {
        const labelList& cells = layers_.columns()[columni];
        const scalarField& x = before[columni];
        Field<Type> old(values, cells);
        old.append(outside(field, columni));
        label i = 0;
        forAll(cells, j)
        {
            const scalar y = after[columni][j];
            while (i < x.size() - 2 && x[i + 1] < y)
            {
                i++;
            }
            const scalar share =
                max(scalar(0), min(scalar(1), (y - x[i])/(x[i + 1] - x[i])));
            values[cells[j]] = (1 - share)*old[i] + share*old[i + 1];
        }
    }
}


void Foam::shockAlignment::move
(
    volScalarField& p,
    volScalarField& T,
    volVectorField& U
)
{
    // As long as the place of the shock is in doubt it needs more room, but
    // not all of it
    const scalar width = max(bandWidth_, min(doubt_, scalar(1)));
    const scalar outer = max(outer_, 1 + width);

    const label n = layers_.columns().size();
    List<scalarField> before(n), after(n);
    forAll(before, columni)
    {
        before[columni] = layers_.depths(columni)/captured_[columni];
    }

    movePoints(spacing(outer, width));

    const scalarField distance(layers_.toColumns(distance_));
    forAll(after, columni)
    {
        after[columni] = layers_.depths(columni)/distance[columni];
    }
    // Cells of an unchanged spacing keep their values, and with them the
    // profile of the shock, which would have to be found anew
    if (width != width_)
    {
        take(p, before, after);
        take(T, before, after);
        take(U, before, after);
    }

    moves_++;
    narrows_ = width < 0.9*width_;
    width_ = width;
    Info<< "Mesh: band of " << width << ", outer boundary at " << outer
        << " times the distance of the shock, which is " << gMin(distance_)
        << " to " << gMax(distance_) << " m" << endl;
}
