/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "storedArrays.H"
#include "compat.H"

// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

Foam::IOobject Foam::SPH::arrayIO
(
    const word& name,
    const fvMesh& mesh,
    const fileName& local,
    const IOobject::readOption read
)
{
    return IOobject
    (
        name,
        mesh.time().constant(),
        local,
        mesh,
        read,
        IOobject::NO_WRITE,
        false
    );
}


void Foam::SPH::checkWritten(const bool written, const regIOobject& object)
{
    if (!written)
    {
        FatalErrorInFunction
            << "Cannot write " << object.objectPath() << exit(FatalError);
    }
}


void Foam::SPH::writeBinary(const regIOobject& object)
{
    checkWritten(writeAs(object, IOstream::BINARY), object);
}


// ************************************************************************* //
