/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "lagrangianFile.H"
#include "barycentric.H"
#include "cloud.H"
#include "IOdictionary.H"
#include "polyMeshTetDecomposition.H"
#include "Time.H"

namespace Foam
{
    // Names of the two forms, as in the files
    static const word coordinatesName("coordinates");
    static const word positionsName("positions");


    //- A file of one of the two forms
    class geometryFile
    :
        public regIOobject
    {
        const word header_;
        const lagrangianFile::geometry* particles_;

        void writeCoordinates(Ostream& os) const;

    public:

        geometryFile
        (
            const IOobject& io,
            const word& header,
            const lagrangianFile::geometry* particles
        )
        :
            regIOobject(io),
            header_(header),
            particles_(particles)
        {}

        virtual const word& type() const
        {
            return header_;
        }

        virtual bool writeData(Ostream& os) const;

        void readGeometry(lagrangianFile::geometry& particles);
    };


    //- Write where a particle is, and the numbers of cell and tetrahedron
    template<class Place, std::size_t n>
    static void put(Ostream& os, const Place& x, const label (&numbers)[n])
    {
        if (os.format() == IOstream::ASCII)
        {
            os << x;
            for (const label number : numbers)
            {
                os << token::SPACE << number;
            }
        }
        else
        {
            char bytes[sizeof(x) + sizeof(numbers)];
            std::memcpy(bytes, &x, sizeof(x));
            std::memcpy(bytes + sizeof(x), numbers, sizeof(numbers));
            os.write(bytes, sizeof(bytes));
        }
        os << nl;
    }

    template<class Place, std::size_t n>
    static void get(Istream& is, Place& x, label (&numbers)[n])
    {
        if (is.format() == IOstream::ASCII)
        {
            is >> x;
            for (label& number : numbers)
            {
                is >> number;
            }
        }
        else
        {
            char bytes[sizeof(x) + sizeof(numbers)];
            is.read(bytes, sizeof(bytes));
            std::memcpy(x.data(), bytes, sizeof(x));
            std::memcpy(numbers, bytes + sizeof(x), sizeof(numbers));
        }
    }


    //- Weights of the corners of a tetrahedron: centre, base, p, q
    static barycentric weightsOf(const tetPointRef& tet, const point& x)
    {
        const vector ab = tet.b() - tet.a();
        const vector ac = tet.c() - tet.a();
        const vector ad = tet.d() - tet.a();
        const vector ax = x - tet.a();
        const scalar volume = (ab ^ ac) & ad;
        const scalar b = ((ax ^ ac) & ad)/volume;
        const scalar c = ((ab ^ ax) & ad)/volume;
        const scalar d = ((ab ^ ac) & ax)/volume;
        return barycentric(1 - b - c - d, b, c, d);
    }
}


void Foam::geometryFile::writeCoordinates(Ostream& os) const
{
    const polyMesh& mesh = refCast<const polyMesh>(db());
    label celli = -1;
    List<tetIndices> tets;
    forAll(particles_->position, i)
    {
        // Particles are sorted by cell
        if (particles_->meshCell[i] != celli)
        {
            celli = particles_->meshCell[i];
            tets = polyMeshTetDecomposition::cellTetIndices(mesh, celli);
        }

        barycentric best;
        scalar deepest = -GREAT;
        label found = 0;
        forAll(tets, t)
        {
            const barycentric weights =
                weightsOf(tets[t].tet(mesh), particles_->position[i]);
            const scalar depth = cmptMin(weights);
            if (depth > deepest)
            {
                deepest = depth;
                best = weights;
                found = t;
                if (depth >= 0)
                {
                    break;
                }
            }
        }

        put(os, best, {celli, tets[found].face(), tets[found].tetPt()});
    }
}


bool Foam::geometryFile::writeData(Ostream& os) const
{
    os  << particles_->position.size() << nl << token::BEGIN_LIST << nl;
    if (name() == coordinatesName)
    {
        writeCoordinates(os);
    }
    else
    {
        forAll(particles_->position, i)
        {
            put(os, particles_->position[i], {particles_->meshCell[i]});
        }
    }
    os  << token::END_LIST << endl;
    return os.good();
}


void Foam::geometryFile::readGeometry(lagrangianFile::geometry& particles)
{
    const polyMesh& mesh = refCast<const polyMesh>(db());
    Istream& is = readStream(word::null);
    const bool native =
        is.checkLabelSize<label>() && is.checkScalarSize<scalar>();
    if (is.format() != IOstream::ASCII && !native)
    {
        FatalIOErrorInFunction(is)
            << "Numbers of another width than this program's;"
            << " write the file in ascii" << exit(FatalIOError);
    }

    const label n = readLabel(is);
    particles.position.setSize(n);
    particles.meshCell.setSize(n);
    is.readBeginList("particles");
    for (label i = 0; i < n; ++i)
    {
        if (name() == coordinatesName)
        {
            barycentric weights;
            label numbers[3];
            get(is, weights, numbers);
            const bool valid =
                numbers[0] >= 0 && numbers[0] < mesh.nCells()
             && numbers[1] >= 0 && numbers[1] < mesh.nFaces()
             && numbers[2] > 0
             && numbers[2] < mesh.faces()[numbers[1]].size() - 1;
            if (!valid)
            {
                FatalIOErrorInFunction(is)
                    << "Particle " << i << " is in cell " << numbers[0]
                    << ", face " << numbers[1] << ", triangle " << numbers[2]
                    << ", which this mesh of " << mesh.nCells() << " cells and "
                    << mesh.nFaces() << " faces does not have"
                    << exit(FatalIOError);
            }
            const tetPointRef tet =
                tetIndices(numbers[0], numbers[1], numbers[2]).tet(mesh);
            particles.position[i] =
                weights.a()*tet.a() + weights.b()*tet.b()
              + weights.c()*tet.c() + weights.d()*tet.d();
            particles.meshCell[i] = numbers[0];
        }
        else
        {
            point x;
            label celli[1];
            get(is, x, celli);
            if (celli[0] < 0 || celli[0] >= mesh.nCells())
            {
                FatalIOErrorInFunction(is)
                    << "Particle " << i << " is in cell " << celli[0]
                    << ". Valid range: 0 <= cell < " << mesh.nCells()
                    << exit(FatalIOError);
            }
            particles.position[i] = x;
            particles.meshCell[i] = celli[0];
        }
    }
    is.readEndList("particles");
    is.check(FUNCTION_NAME);
    close();
}


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

Foam::IOobject Foam::lagrangianFile::file
(
    const polyMesh& mesh,
    const word& cloud,
    const word& name,
    const IOobject::readOption r
)
{
    return IOobject
    (
        name,
        mesh.time().timeName(),
        Foam::cloud::prefix/cloud,
        mesh,
        r,
        IOobject::NO_WRITE,
        false
    );
}


void Foam::lagrangianFile::write
(
    const polyMesh& mesh,
    const word& cloud,
    const word& header,
    const geometry& particles
)
{
    // Without particles there are no files: those of a run before would stay
    rmDir(file(mesh, cloud, "", IOobject::NO_READ).path(), true);
    for (const word& name : {coordinatesName, positionsName})
    {
        geometryFile
        (
            file(mesh, cloud, name, IOobject::NO_READ),
            header,
            &particles
        ).write(particles.position.size() > 0);
    }

    IOdictionary properties
    (
        IOobject
        (
            "cloudProperties",
            mesh.time().timeName(),
            "uniform"/Foam::cloud::prefix/cloud,
            mesh,
            IOobject::NO_READ,
            IOobject::NO_WRITE,
            false
        )
    );
    properties.add("geometry", coordinatesName);
    for (label proci = 0; proci < Pstream::nProcs(); ++proci)
    {
        dictionary count;
        count.add("particleCount", label(0));
        properties.add(word("processor" + Foam::name(proci)), count);
    }
    properties.writeObject
    (
        IOstream::ASCII,
        IOstream::currentVersion,
        mesh.time().writeCompression(),
        true
    );
}


bool Foam::lagrangianFile::read
(
    const polyMesh& mesh,
    const word& cloud,
    geometry& particles
)
{
    bool found = false;
    for (const word& name : {coordinatesName, positionsName})
    {
        geometryFile in
        (
            file(mesh, cloud, name, IOobject::MUST_READ),
            "",
            nullptr
        );
        if (!in.headerOk())
        {
            continue;
        }
        geometry some;
        in.readGeometry(some);
        if (!found || some.position.size() == particles.position.size())
        {
            particles = some;
        }
        found = true;
    }
    return returnReduce(found, orOp<bool>());
}
