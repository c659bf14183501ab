/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.

Application
    rhoCentralParcelFoam

Description
    Compressible flow of a perfect gas, transient, steady or frozen, with any
    number of Lagrangian particle clouds in it.
\*---------------------------------------------------------------------------*/

#include "fvCFD.H"
#include "highSpeedGas.H"

int main(int argc, char* argv[])
{
    argList::addNote
    (
        "Compressible flow of a perfect gas (transient, steady or frozen)"
        " with particle clouds"
    );

    #include "setRootCase.H"
    #include "createTime.H"
    #include "createMesh.H"

    highSpeedGas gas(mesh);

    Info<< nl << "Starting time loop" << nl << endl;

    while (runTime.run())
    {
        if (runTime.controlDict().getOrDefault("adjustTimeStep", false))
        {
            runTime.setDeltaT(min(gas.stableDeltaT(), runTime.deltaTValue()*1.2));
        }
        ++runTime;

        gas.solve();

        runTime.write();
        runTime.printExecutionTime(Info);
    }

    Info<< "Gas: " << gas.cpuTime() << " s of processor time" << nl
        << "End" << nl << endl;
    return 0;
}
