/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.

Application
    alignMeshToShock

Description
    Moves the points of a mesh with layers around a body so that it follows
    the bow shock before the body, whose place need not be known: finds the
    steady state of the gas (highSpeedGas) on the mesh as it is, moves the
    outer boundary and a band of small cells to the shock that it finds there
    (shockAlignment), and so on until the shock rests. Run it once between
    blockMesh and rhoCentralParcelFoam, or decomposePar (on one rank: it is
    refused on more):

        alignMeshToShock [-dict FILE]

    The points are written where they were read, constant/polyMesh (blockMesh
    brings the old ones back) or that of a time, as moveDynamicMesh leaves
    them, and the steady gas as the fields p, T and U of the start time, from
    which rhoCentralParcelFoam goes on.

    Reads system/alignMeshToShockDict if it is there.
\*---------------------------------------------------------------------------*/

#include "fvCFD.H"
#include "completeWrite.H"
#include "cloud.H"
#include "finishFile.H"
#include "highSpeedGas.H"
#include "OFstream.H"
#include "presentFile.H"
#include "release.H"
#include "runSummary.H"
#include "shockAlignment.H"

namespace
{

using namespace Foam;

//- Replace files once all new ones are whole: a full disk leaves the mesh
//  and the fields as they were
void write(const UPtrList<const regIOobject>& objects)
{
    const auto unfinished = [](const regIOobject& object)
    {
        return fileName(object.objectPath() + ".unfinished");
    };
    forAll(objects, i)
    {
        errno = 0;
        OFstream os(unfinished(objects[i]), objects[i].time().writeFormat());
        if (!os.good())
        {
            failedFile(os.name(), errno);
        }
        objects[i].writeHeader(os);
        objects[i].writeData(os);
        IOobject::writeEndDivider(os);
        finishFile(os);
    }
    forAll(objects, i)
    {
        const fileName file(objects[i].objectPath());
        errno = 0;
        if (!mv(unfinished(objects[i]), file))
        {
            failedFile(file, errno);
        }
        rm(file + ".gz");
    }
}

} // End anonymous namespace


int main(int argc, char* argv[])
{
    runSummary summary;
    argList::addNote
    (
        "Move the layers around a body to the bow shock before it"
    );
    argList::addOption
    (
        "dict", "file", "Other dictionary than system/alignMeshToShockDict"
    );

    #include "setRootCase.H"
    if (Pstream::parRun())
    {
        FatalErrorInFunction
            << "alignMeshToShock moves the points of the whole mesh, on one"
            << " rank." << nl
            << "Run it without -parallel before decomposePar, which takes the"
            << " moved mesh and the fields along" << exit(FatalError);
    }
    foamCompat::printRelease();
    completeWrite::setAsideUnfinished(args);
    #include "createTime.H"
    completeWrite::checkStart(runTime);

    // Digits of the log, whatever those of the files are
    Sout.precision(6);

    #include "createMesh.H"

    if (isDir(runTime.timePath()/cloud::prefix))
    {
        FatalErrorInFunction
            << "There are parcels at time " << runTime.timeName()
            << ", on the mesh as it is." << nl
            << "Align the mesh before they are injected" << exit(FatalError);
    }

    const bool given = args.found("dict");
    IOobject io
    (
        given
      ? args.get<fileName>("dict")
      : runTime.system()/"alignMeshToShockDict",
        mesh,
        IOobject::MUST_READ
    );
    autoPtr<IOdictionary> dict;
    if (given || isPresent<IOdictionary>(io))
    {
        dict.reset(new IOdictionary(io));
    }

    // (a mesh that moves calls the time at hand that of its points)
    const fileName pointsInstance(mesh.pointsInstance());
    shockAlignment alignment(mesh, dict.valid() ? *dict : dictionary());
    highSpeedGas gas(mesh);
    gas.align(alignment);
    gas.account(summary);

    // What is written is what was found, to the last digit
    IOstream::defaultPrecision(17);
    auto& points = mesh.thisDb().lookupObjectRef<pointIOField>("points");
    points.instance() = pointsInstance;
    UPtrList<const regIOobject> objects(4);
    objects.set(0, &points);
    label n = 1;
    for (const word name : {"p", "T", "U"})
    {
        objects.set(n++, &mesh.thisDb().lookupObject<regIOobject>(name));
    }
    completeWrite::changed(runTime);
    withReason([&] { write(objects); });
    Info<< "Fields p, T, U of time " << runTime.timeName() << " written" << nl
        << "Points written to "
        << points.instance()/points.local()/points.name() << nl;
    summary.print();
    Info<< "End" << nl << endl;
    return 0;
}
