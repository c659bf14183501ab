/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.

Application
    dsmcParcelFoam

Description
    Rarefied gas by direct simulation Monte Carlo (dsmcGas.H), on the files of
    the stock solver dsmcFoam: run dsmcInitialise first. With the file
    constant/solidParticleProperties, solid particles in it
    (solidParticles.H).
\*---------------------------------------------------------------------------*/

#include "fvCFD.H"
#include "completeWrite.H"
#include "dsmcGas.H"
#include "release.H"
#include "runProgress.H"
#include "runSummary.H"
#include "solidParticles.H"

int main(int argc, char* argv[])
{
    runSummary summary;
    argList::addNote
    (
        "Rarefied gas by direct simulation Monte Carlo, on the files of"
        " dsmcFoam, and solid particles in it"
    );

    #include "setRootCase.H"
    foamCompat::printRelease();
    completeWrite::setAsideUnfinished(args);
    #include "createTime.H"

    // Digits of the log, whatever those of the files are
    Sout.precision(6);

    completeWrite::checkStart(runTime);
    #include "createMesh.H"

    const convexCells cells(mesh);
    dsmcGas gas(mesh, cells);
    autoPtr<solidParticles> solids(solidParticles::New(mesh, cells, gas));

    Info<< "Starting time loop" << nl << endl;

    runProgress progress(runTime);
    while (completeWrite::run(runTime))
    {
        ++runTime;
        gas.move();
        if (solids.valid())
        {
            solids->move();
            solids->exchange();
        }
        gas.collide();
        gas.record();
        if (solids.valid())
        {
            solids->record();
        }

        if (completeWrite::write(runTime))
        {
            runTime.printExecutionTime(Info);
        }
        progress.report();
    }

    gas.account(summary);
    if (solids.valid())
    {
        solids->account(summary);
    }
    summary.part("writing", completeWrite::cpuTime());
    summary.print();
    Info<< "End" << nl << endl;
    return 0;
}
