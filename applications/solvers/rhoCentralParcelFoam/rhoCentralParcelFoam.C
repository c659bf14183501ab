/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.

Application
    rhoCentralParcelFoam

Description
    Compressible flow of a perfect gas, transient, steady or frozen, with any
    number of Lagrangian particle clouds in it (highSpeedGas.H,
    parcelClouds.H).

    Without clouds a steady run ends, and writes its fields, as soon as the
    gas is steady.
\*---------------------------------------------------------------------------*/

#include "fvCFD.H"
#include "completeWrite.H"
#include "highSpeedGas.H"
#include "parcelClouds.H"
#include "release.H"
#include "runProgress.H"
#include "runSummary.H"

int main(int argc, char* argv[])
{
    runSummary summary;
    argList::addNote
    (
        "Compressible flow of a perfect gas (transient, steady or frozen)"
        " with particle clouds"
    );

    #include "setRootCase.H"
    foamCompat::printRelease();
    completeWrite::setAsideUnfinished(args);
    #include "createTime.H"

    // Digits of the log, whatever those of the files are
    Sout.precision(6);

    completeWrite::checkStart(runTime);
    #include "createMesh.H"

    highSpeedGas gas(mesh);
    parcelClouds clouds(mesh, gas.rho(), gas.U(), gas.thermo());

    gas.expectParticles(clouds.coupled());
    clouds.setGasResponds(gas.responds());
    const parcelClouds::receiver receive
    (
        [&gas](const vectorField& momentum, const scalarField& energy)
        {
            gas.receive(momentum, energy);
        }
    );

    Info<< nl << "Starting time loop" << nl << endl;

    runProgress progress(runTime);
    while (completeWrite::run(runTime))
    {
        gas.setDeltaT(runTime);
        ++runTime;

        Info<< "Time = " << runTime.timeName() << endl;

        const bool report = runTime.writeTime();
        const bool changed = gas.solve();

        if (!clouds.empty())
        {
            clouds.evolve(changed, receive);
        }

        if (clouds.empty() && gas.frozen())
        {
            // Nothing more will happen
            completeWrite::writeNow(runTime);
            runTime.setEndTime(runTime.value());
        }
        else
        {
            completeWrite::write(runTime);
        }
        if (report)
        {
            runTime.printExecutionTime(Info);
        }
        progress.report();
    }

    gas.account(summary);
    clouds.account(summary);
    summary.part("writing", completeWrite::cpuTime());
    summary.print();
    Info<< "End" << nl << endl;
    return 0;
}
