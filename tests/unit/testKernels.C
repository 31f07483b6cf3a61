/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

Description
    Kernels against analytic constants and against quadratures that do not use
    the shells of kernel.C.

\*---------------------------------------------------------------------------*/

#include "testCase.H"
#include "kernel.H"
#include "shapedKernel.H"
#include "mathematicalConstants.H"

#include <cmath>
#include <gtest/gtest.h>

using namespace Foam;
using namespace Foam::SPH;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

autoPtr<kernel> makeKernel
(
    const word& type,
    const label nDims,
    const scalar smoothingRatio = 1.3
)
{
    dictionary dict;
    dict.add("type", type);
    dict.add("smoothingRatio", smoothingRatio);
    return kernel::New(dict, nDims);
}


//- Sum of f over the cells of a Cartesian grid with n cells in each of nDims
//- directions from -R to R, times the cells' volume
scalar gridSum
(
    const label nDims,
    const label n,
    const scalar R,
    const std::function<scalar(scalar)>& f
)
{
    const scalar d = 2*R/n;
    scalar sum = 0;

    for (label k = 0; k < (nDims > 2 ? n : 1); ++k)
    {
        for (label j = 0; j < (nDims > 1 ? n : 1); ++j)
        {
            for (label i = 0; i < n; ++i)
            {
                const vector x
                (
                    (i + 0.5)*d - R,
                    nDims > 1 ? (j + 0.5)*d - R : 0,
                    nDims > 2 ? (k + 0.5)*d - R : 0
                );
                sum += f(mag(x));
            }
        }
    }

    return sum*std::pow(d, nDims);
}


const scalar pi = constant::mathematical::pi;

//- Kernel, number of dimensions, sigma for h = 1
typedef std::tuple<const char*, label, scalar> constantOf;

class KernelConstants
:
    public testing::TestWithParam<constantOf>
{};


//- Kernel and number of dimensions
class EveryKernel
:
    public testing::TestWithParam<std::tuple<const char*, label>>
{
protected:

    autoPtr<kernel> W() const
    {
        return makeKernel(std::get<0>(GetParam()), nDims());
    }

    label nDims() const
    {
        return std::get<1>(GetParam());
    }
};

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

TEST_P(KernelConstants, isTheAnalyticOne)
{
    const auto& [type, nDims, sigma] = GetParam();
    const autoPtr<kernel> W(makeKernel(type, nDims));

    EXPECT_NEAR(W->sigma(1)/sigma, 1, 1e-12);
    EXPECT_NEAR(W->sigma(0.2)*std::pow(0.2, nDims)/sigma, 1, 1e-12);
}

INSTANTIATE_TEST_SUITE_P
(
    Published,
    KernelConstants,
    testing::Values
    (
        constantOf{"WendlandC2", 1, 3.0/4},
        constantOf{"WendlandC2", 2, 7/(4*pi)},
        constantOf{"WendlandC2", 3, 21/(16*pi)},
        constantOf{"LaguerreGauss", 2, 3/(pi*(1 - std::exp(-4.0)))},
        constantOf{"cubicSpline", 1, 2.0/3},
        constantOf{"cubicSpline", 2, 10/(7*pi)},
        constantOf{"cubicSpline", 3, 1/pi},
        constantOf{"quinticSpline", 1, 1.0/120},
        constantOf{"quinticSpline", 2, 7/(478*pi)},
        constantOf{"quinticSpline", 3, 1/(120*pi)}
    )
);


TEST_P(EveryKernel, integratesToOne)
{
    const autoPtr<kernel> kernel(W());
    const scalar h = 0.37;

    // Laguerre-Gauss is cut off where it is not yet zero
    const bool cut = mag(kernel->w(0.999999*kernel->cutOff())) > 1e-4;

    EXPECT_NEAR
    (
        gridSum
        (
            nDims(),
            nDims() == 1 ? 100000 : nDims() == 2 ? 1000 : 100,
            1.01*kernel->cutOff()*h,
            [&](const scalar r) { return kernel->W(r, h); }
        ),
        1,
        cut ? 2e-3 : 1e-5
    );
}


TEST_P(EveryKernel, derivativeIsTheSlope)
{
    const autoPtr<kernel> kernel(W());
    const scalar h = 0.37;
    const scalar step = 1e-6;
    const scalar scale = kernel->W(0, h)/h;

    for (label k = 1; k < 50; ++k)
    {
        const scalar r = (k/50.0*kernel->cutOff() + 1e-3)*h;
        if (r + step < kernel->cutOff()*h)
        {
            const scalar slope =
                (kernel->W(r + step, h) - kernel->W(r - step, h))/(2*step);
            EXPECT_NEAR(kernel->dWdr(r, h)/scale, slope/scale, 1e-8) << r;
        }
    }

    EXPECT_EQ(kernel->dWdr(0, h), 0);
    EXPECT_EQ(kernel->W(1.0001*kernel->cutOff()*h, h), 0);
    EXPECT_EQ(kernel->dWdr(1.0001*kernel->cutOff()*h, h), 0);
}


TEST_P(EveryKernel, lineKernelHasUnitIntegralAndItsTail)
{
    const autoPtr<kernel> kernel(W());
    const scalar h = 0.37;
    const scalar R = kernel->cutOff()*h;

    EXPECT_NEAR(kernel->lineTail(0, h), 0.5, 1e-10);
    EXPECT_EQ(kernel->lineTail(1.0001*R, h), 0);
    EXPECT_NEAR(kernel->lineTail(-h, h), 0.5, 1e-10);

    for (const scalar from : {0.1*R, 0.4*R, 0.77*R})
    {
        const label n = 20000;
        scalar sum = 0;
        for (label k = 0; k < n; ++k)
        {
            sum += kernel->lineW(from + (k + 0.5)/n*(R - from), h);
        }
        EXPECT_NEAR(kernel->lineTail(from, h), sum*(R - from)/n, 1e-7);
    }
}


TEST_P(EveryKernel, inlineShapeIsTheVirtualOne)
{
    const autoPtr<kernel> kernel(W());

    withShape
    (
        *kernel,
        [&](const auto shape)
        {
            EXPECT_EQ(shape.cutOff, kernel->cutOff());
            for (scalar q = 0; q < 3.2; q += 0.1)
            {
                EXPECT_NEAR(shape.w(q), kernel->w(q), 1e-14*kernel->w(0));
                EXPECT_NEAR(shape.dw(q), kernel->dw(q), 1e-14*kernel->w(0));
                EXPECT_NEAR
                (
                    q*shape.dwByQ(q), shape.dw(q), 1e-14*kernel->w(0)
                );
            }
        }
    );
}

INSTANTIATE_TEST_SUITE_P
(
    All,
    EveryKernel,
    testing::Combine
    (
        testing::Values
        (
            "WendlandC2", "LaguerreGauss", "cubicSpline", "quinticSpline"
        ),
        testing::Values(1, 2, 3)
    )
);


// w' = -5 q (1 - q/2)^3 with sigma = 7/(4 pi) in 2-D, summed over a quadrant
TEST(Kernel, latticeMomentOfWendlandIsTheSumOverTheLattice)
{
    for (const scalar h : {1.1, 1.3, 1.6})
    {
        scalar moment = 0;
        for (label x = 1; x < 2*h; ++x)
        {
            for (label y = 0; y < 2*h; ++y)
            {
                // (x, y) and its three turns by a right angle
                const scalar q = std::hypot(x, y)/h;
                if (q < 2)
                {
                    moment +=
                        4*7/(4*M_PI*h*h*h)
                       *5*q*std::pow(1 - q/2, 3)*q*h/2;
                }
            }
        }
        EXPECT_NEAR
        (
            makeKernel("WendlandC2", 2, h)->latticeMoment(), moment, 1e-9
        );
    }

    EXPECT_NEAR(makeKernel("WendlandC2", 2)->latticeMoment(), 0.974, 5e-4);
}


TEST(Kernel, defaultsAreWendlandC2AndPointNine)
{
    const autoPtr<kernel> W(kernel::New(dictionary(), 2));

    EXPECT_EQ(W->type(), "WendlandC2");
    EXPECT_EQ(W->smoothingRatio(), 0.9);
    EXPECT_NEAR(W->support(0.1), 0.18, 1e-15);
}


TEST(Kernel, errorsSayWhatIsValid)
{
    const std::string unknown
    (
        errorMessage([&]{ makeKernel("Gauss", 2); })
    );
    for (const char* name : {"WendlandC2", "LaguerreGauss", "quinticSpline"})
    {
        EXPECT_NE(unknown.find(name), std::string::npos) << unknown;
    }

    const std::string range
    (
        errorMessage([&]{ makeKernel("WendlandC2", 2, 0.2); })
    );
    EXPECT_NE(range.find("smoothingRatio 0.2 is outside"), std::string::npos)
        << range;
}

// ************************************************************************* //
