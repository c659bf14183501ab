/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "restartData.H"
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
    const polyMesh& mesh
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
    found_(false),
    timeIndex_(-1),
    labels_(),
    scalars_()
{
    const bool here = headerOk();
    Istream& is = readStream(typeName, here);
    if (here)
    {
        is >> labels_ >> scalars_;
    }
    close();

    found_ = here;
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
}


bool Foam::restartData::writeObject
(
    IOstream::streamFormat,
    IOstream::versionNumber version,
    IOstream::compressionType compression,
    const bool valid
) const
{
    if (timeIndex_ != time().timeIndex())
    {
        Warning
            << "The averages of " << name() << " are not part of the write at"
            << " time " << time().timeName() << ": a run that starts there"
            << " begins new ones." << endl;
        return true;
    }
    return
        regIOobject::writeObject
        (
            IOstream::BINARY,
            version,
            compression,
            valid
        );
}


bool Foam::restartData::writeData(Ostream& os) const
{
    os  << labels_ << nl << scalars_ << nl;
    return os.good();
}
