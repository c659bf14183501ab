/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.

Application
    jkrImpact

Group
    grpPreProcessingUtilities

Description
    Normal impacts of a particle with JKR adhesion and viscous dissipation on
    a wall, another particle or a particle that adheres to a wall:
    restitution, capture, motion during the contact.

Usage
    \b jkrImpact [OPTION]

      - \par -case DIR
        The case; needs DIR/system/jkrImpactDict only.

      - \par -noPlot
        Do not call the plot script.

    Results in postProcessing/jkrImpact, which is emptied first:
    restitution.csv, trajectory_<i>.csv of the i-th speed, summary.csv,
    curve.csv and points.csv (static curve), with an alpha that depends on
    the restitution alpha.csv, inverse.csv and measured.csv, with the block
    chain chain.csv and chainTrajectory_<i>.csv; and, where python3 with
    matplotlib is found, pictures of them.

    Entries: see etc/caseDicts/annotated/jkrImpactDict.
\*---------------------------------------------------------------------------*/

#include "argList.H"
#include "IFstream.H"
#include "jkrImpactOutput.H"
#include "plotResults.H"
#include "release.H"

using namespace Foam;

int main(int argc, char* argv[])
{
    argList::addNote
    (
        "Normal impacts with JKR adhesion and viscous dissipation:"
        " restitution, capture, motion during the contact"
    );
    argList::noParallel();
    argList::noFunctionObjects();
    argList::addBoolOption("noPlot", "Do not call the plot script");
    argList args(argc, argv);
    foamCompat::printRelease();

    const fileName casePath(args.globalPath());
    const fileName dictFile(casePath/"system/jkrImpactDict");
    IFstream is(dictFile);
    if (!is.good())
    {
        FatalErrorInFunction
            << "Cannot read " << dictFile << exit(FatalError);
    }
    const dictionary dict(is);
    const jkrImpactSetup setup(dict, casePath);

    const fileName folder(casePath/"postProcessing/jkrImpact");
    writeJkrImpact(folder, setup);
    if (!args.found("noPlot"))
    {
        plotResults("jkrImpact", folder);
    }
    Info<< "End" << endl;
    return 0;
}
