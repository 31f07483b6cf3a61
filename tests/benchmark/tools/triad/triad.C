/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

Application
    triad

Description
    Prints what one thread, and all threads together, get from memory in
    a = b + s c on arrays that no cache holds, in GB/s of 24 bytes an element.
    The time is that of the processor, so that programs that share it count as
    little as they can.

Usage
    \b triad

\*---------------------------------------------------------------------------*/

#include <algorithm>
#include <cstdio>
#include <ctime>
#include <memory>
#include <omp.h>

namespace
{

//- Seconds of processor time of this thread
double threadSeconds()
{
    timespec t;
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
    return t.tv_sec + 1e-9*t.tv_nsec;
}

} // End anonymous namespace


int main()
{
    constexpr long n = 1L << 24;
    constexpr int nRepeats = 8;

    // Not initialised here: a thread touches its own part first
    const std::unique_ptr<double[]> a(new double[n]);
    const std::unique_ptr<double[]> b(new double[n]);
    const std::unique_ptr<double[]> c(new double[n]);

    for (const int nThreads : {1, omp_get_max_threads()})
    {
        double best = 0;
        for (int repeat = 0; repeat < nRepeats; ++repeat)
        {
            double slowest = 0;

            #pragma omp parallel num_threads(nThreads) reduction(max:slowest)
            {
                if (!repeat)
                {
                    #pragma omp for schedule(static)
                    for (long i = 0; i < n; ++i)
                    {
                        a[i] = 0;
                        b[i] = 1;
                        c[i] = i;
                    }
                }

                const double start = threadSeconds();

                #pragma omp for schedule(static) nowait
                for (long i = 0; i < n; ++i)
                {
                    a[i] = b[i] + 3*c[i];
                }

                slowest = threadSeconds() - start;
            }

            best = std::max(best, 24e-9*n/slowest);
        }

        std::printf("threads %d triad %.2f GB/s\n", nThreads, best);
    }

    return 0;
}


// ************************************************************************* //
