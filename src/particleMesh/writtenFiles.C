/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "writtenFiles.H"
#include "particleFiles.H"
#include "dictionary.H"
#include "IFstream.H"
#include "OFstream.H"
#include "OSspecific.H"
#include "Tuple2.H"

#include <fstream>
#include <unistd.h>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace SPH
{
    //- The file of the digests
    static fileName recordFile(const fileName& path)
    {
        return path/"constant"/particleFiles::folder/"writtenFiles";
    }

    //- Contents of a text file
    static std::string contents(const fileName& file)
    {
        std::ifstream is(file);
        return std::string
        (
            std::istreambuf_iterator<char>(is),
            std::istreambuf_iterator<char>()
        );
    }
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::SPH::writtenFiles::writtenFiles(const fileName& path)
:
    path_(path),
    digests_()
{
    IFstream is(recordFile(path));
    if (is.good())
    {
        const dictionary record(is);
        for
        (
            const Tuple2<fileName, word>& file
          : record.get<List<Tuple2<fileName, word>>>("files")
        )
        {
            digests_.insert(file.first(), file.second());
        }
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::SPH::writtenFiles::mayWrite(const fileName& file) const
{
    const word digest(fileDigest(path_/file));

    if
    (
        digest.empty()
     || (digests_.found(file) && digests_[file] == digest)
    )
    {
        return true;
    }

    Info<< "    keeping " << file << ", which was edited: remove it to have it"
        << " made anew" << nl;
    return false;
}


void Foam::SPH::writtenFiles::add(const fileName& file)
{
    digests_.set(file, fileDigest(path_/file));
}


void Foam::SPH::writtenFiles::writeText
(
    const fileName& file,
    const std::string& text
)
{
    const fileName path(path_/file);

    if (contents(path) != text && mayWrite(file))
    {
        mkDir(path.path());
        std::ofstream os(path);
        os << text;
        os.close();
        if (!os)
        {
            FatalErrorInFunction
                << "Cannot write " << path << exit(FatalError);
        }
    }
    if (contents(path) == text)
    {
        add(file);
    }
}


void Foam::SPH::writtenFiles::link
(
    const fileName& file,
    const fileName& target
) const
{
    const fileName path(path_/file);

    if (!exists(path, false))
    {
        mkDir(path.path());
        if (symlink(target.c_str(), path.c_str()) != 0)
        {
            FatalErrorInFunction
                << "Cannot link " << path << " to " << target
                << exit(FatalError);
        }
    }
}


void Foam::SPH::writtenFiles::write() const
{
    DynamicList<Tuple2<fileName, word>> files;
    for (const fileName& file : digests_.sortedToc())
    {
        files.append({file, digests_[file]});
    }

    dictionary record;
    record.add("files", files);

    mkDir(recordFile(path_).path());
    OFstream os(recordFile(path_));
    record.write(os, false);
    if (!os.stdStream().flush())
    {
        FatalErrorInFunction
            << "Cannot write " << os.name() << exit(FatalError);
    }
}


// ************************************************************************* //
