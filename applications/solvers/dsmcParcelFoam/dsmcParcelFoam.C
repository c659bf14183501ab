/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.

Application
    dsmcParcelFoam

Description
    Rarefied gas by direct simulation Monte Carlo (dsmcGas.H), on the files of
    the stock solver dsmcFoam: run dsmcInitialise first.
\*---------------------------------------------------------------------------*/

#include "fvCFD.H"
#include "completeWrite.H"
#include "dsmcGas.H"

int main(int argc, char* argv[])
{
    argList::addNote
    (
        "Rarefied gas by direct simulation Monte Carlo, on the files of"
        " dsmcFoam"
    );

    #include "setRootCase.H"
    completeWrite::setAsideUnfinished(args);
    #include "createTime.H"
    #include "createMesh.H"

    const convexCells cells(mesh);
    dsmcGas gas(mesh, cells);

    Info<< "Starting time loop" << nl << endl;

    while (runTime.loop())
    {
        gas.move();
        gas.collide();
        gas.record();

        if (completeWrite::write(runTime))
        {
            runTime.printExecutionTime(Info);
        }
    }

    gas.info();
    Info<< "End" << nl << endl;
    return 0;
}
