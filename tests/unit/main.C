/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

Application
    eulerianSPHTests

Description
    Runs the unit tests with OpenFOAM as an application sees it, floating-point
    exceptions trapped, but for errors, which are thrown so that tests can read
    their messages.

Usage
    \b eulerianSPHTests [--gtest_filter=PATTERN] [--gtest_list_tests]

\*---------------------------------------------------------------------------*/

#include "testCase.H"
#include "error.H"
#include "messageStream.H"
#include "sigFpe.H"

#include <exception>
#include <iostream>
#include <gtest/gtest.h>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- Prints the message of an OpenFOAM error that ends a test: to GoogleTest it
//- is a std::exception without any
class errorPrinter
:
    public testing::EmptyTestEventListener
{
    void OnTestPartResult(const testing::TestPartResult&) override
    {
        if (const std::exception_ptr error = std::current_exception())
        {
            std::cout
                << Foam::SPH::errorMessage
                   (
                       [&]{ std::rethrow_exception(error); }
                   )
                << std::endl;
        }
    }
};

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

int main(int argc, char* argv[])
{
    testing::InitGoogleTest(&argc, argv);
    testing::UnitTest::GetInstance()->listeners().Append(new errorPrinter);

    Foam::messageStream::level = 0;
    Foam::FatalError.throwExceptions();
    Foam::FatalIOError.throwExceptions();
    Foam::sigFpe::set(false);

    return RUN_ALL_TESTS();
}


// ************************************************************************* //
