/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "virtualDisplay.H"

#include <cstdlib>
#include <fcntl.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <X11/Xlib.h>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

std::string Foam::SPH::virtualDisplay::start()
{
    int ends[2];
    if (pipe(ends) != 0)
    {
        return std::string();
    }

    const std::string writeEnd(std::to_string(ends[1]));

    // Without a reset when the last client leaves: the next one would come too
    // early. A number of our own instead of the lowest free one: a server that
    // ends removes its socket by name, even if another has just taken it over
    const std::string display(":" + std::to_string(1000 + getpid() % 50000));

    server_ = fork();
    if (server_ == 0)
    {
        // Only calls that are safe after a fork of a threaded program
        prctl(PR_SET_PDEATHSIG, SIGTERM);
        close(ends[0]);
        const int null = open("/dev/null", O_RDWR);
        dup2(null, STDIN_FILENO);
        dup2(null, STDOUT_FILENO);
        dup2(null, STDERR_FILENO);
        execlp
        (
            "Xvfb", "Xvfb", display.c_str(),
            "-displayfd", writeEnd.c_str(),
            "-screen", "0", "640x480x24",
            "-nolisten", "tcp",
            "-noreset",
            static_cast<char*>(nullptr)
        );
        _exit(127);
    }

    // Xvfb writes the number of its display and a newline when it is ready;
    // the pipe closes without them when it cannot run
    close(ends[1]);
    char c = 0;
    while (server_ > 0 && c != '\n' && read(ends[0], &c, 1) == 1)
    {}
    const bool ready = c == '\n';
    close(ends[0]);

    return ready ? display : std::string();
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::SPH::virtualDisplay::virtualDisplay()
:
    server_(-1),
    userDisplay_(),
    userDisplaySet_(false)
{
    if (const char* display = std::getenv("DISPLAY"))
    {
        userDisplay_ = display;
        userDisplaySet_ = true;
    }

    const std::string display(start());
    if (!display.empty())
    {
        setenv("DISPLAY", display.c_str(), 1);
    }
}


// * * * * * * * * * * * * * * * * Destructor  * * * * * * * * * * * * * * * //

Foam::SPH::virtualDisplay::~virtualDisplay()
{
    if (server_ > 0)
    {
        kill(server_, SIGTERM);
        waitpid(server_, nullptr, 0);
    }

    if (userDisplaySet_)
    {
        setenv("DISPLAY", userDisplay_.c_str(), 1);
    }
    else
    {
        unsetenv("DISPLAY");
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::SPH::virtualDisplay::available()
{
    Display* display = XOpenDisplay(nullptr);

    if (display)
    {
        XCloseDisplay(display);
    }

    return display;
}

// ************************************************************************* //
