/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "restartData.H"
#include "writtenState.H"
#include "pastWrite.H"
#include "checked.H"
#include "Pstream.H"
#include "Time.H"
#include "cloud.H"

namespace Foam
{
    defineTypeNameAndDebug(restartData, 0);
}


Foam::restartData::restartData
(
    const word& cloudName,
    const word& functionName,
    const polyMesh& mesh,
    const dictionary& dict
)
:
    regIOobject
    (
        IOobject
        (
            cloudName + ":" + functionName,
            mesh.time().timeName(),
            "uniform"/cloud::prefix/cloudName,
            mesh,
            IOobject::READ_IF_PRESENT,
            IOobject::AUTO_WRITE
        )
    ),
    cloudName_(cloudName),
    mesh_(mesh)
{
    const bool here = headerOk();
    Istream& is = readStream(typeName, here);
    if (here)
    {
        is >> labels_ >> scalars_;
    }
    close();
    pastWrite::of(mesh);

    const bool anew =
        getWord(dict, "restart", {"continue", "anew"}) == "anew";
    if (here && anew)
    {
        clear();
        Info<< functionName << ": averages of an earlier part of the run are"
            << " left behind (restart anew)" << endl;
    }
    if (Pstream::master() && !here && !anew)
    {
        writtenState::check(mesh, cloudName, name());
    }
    found_ = here && !anew;
    Pstream::scatter(found_);
    Pstream::scatter(labels_);
    Pstream::scatter(scalars_);
}


void Foam::restartData::clear()
{
    labels_.clear();
    scalars_.clear();
}


void Foam::restartData::set(labelList&& labels, scalarList&& scalars)
{
    if (Pstream::master())
    {
        labels_.transfer(labels);
        scalars_.transfer(scalars);
    }
    timeIndex_ = time().timeIndex();
    writtenState::add(mesh_, cloudName_, name());
    pastWrite::catchUp(mesh_, *this);
}


bool Foam::restartData::writeObject(FOAM_COMPAT_WRITE_ARGS) const
{
    if (timeIndex_ != time().timeIndex())
    {
        Warning
            << "The averages of " << name() << " are not part of the write at"
            << " time " << time().timeName() << ": a run that starts there"
            << " begins new ones." << endl;
        return true;
    }
    return regIOobject::writeObject(FOAM_COMPAT_WRITE_BINARY);
}


bool Foam::restartData::writeData(Ostream& os) const
{
    os  << labels_ << nl << scalars_ << nl;
    return os.good();
}
