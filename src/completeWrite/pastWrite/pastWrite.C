/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "pastWrite.H"
#include "OSspecific.H"
#include "Time.H"
#include "cloud.H"

namespace Foam
{
    defineTypeNameAndDebug(pastWrite, 0);
}


Foam::pastWrite::pastWrite(const polyMesh& mesh)
:
    regIOobject
    (
        IOobject
        (
            typeName,
            mesh.time().timeName(),
            mesh,
            IOobject::NO_READ,
            IOobject::AUTO_WRITE
        )
    )
{}


const Foam::pastWrite& Foam::pastWrite::of(const polyMesh& mesh)
{
    if (const auto* here = mesh.findObject<pastWrite>(typeName))
    {
        return *here;
    }
    return regIOobject::store(new pastWrite(mesh));
}


void Foam::pastWrite::catchUp(const polyMesh& mesh, const regIOobject& object)
{
    if (of(mesh).timeIndex_ == mesh.time().timeIndex())
    {
        // One that is empty writes no files, and has written those of before
        const cloud* parcels = dynamic_cast<const cloud*>(&object);
        if (parcels && !parcels->nParcels())
        {
            rmDir
            (
                mesh.time().path()/mesh.time().timeName()/mesh.dbDir()
               /cloud::prefix/parcels->name(),
                true
            );
        }
        object.write();
    }
}


bool Foam::pastWrite::writeObject(FOAM_COMPAT_WRITE_ARGS_UNUSED) const
{
    timeIndex_ = time().timeIndex();
    return true;
}
