/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "kernel.H"
#include "mathematicalConstants.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace SPH
{
    defineTypeNameAndDebug(kernel, 0);
    defineRunTimeSelectionTable(kernel, dictionary);

    //- Four-point Gauss-Legendre quadrature of f from a to b in n panels;
    //- knots of the spline shapes fall on panel edges
    template<class Function>
    static scalar quadrature
    (
        const scalar a,
        const scalar b,
        const label n,
        Function&& f
    )
    {
        static const scalar x[2] = {0.339981043584856265, 0.861136311594052575};
        static const scalar c[2] = {0.652145154862546143, 0.347854845137453857};

        const scalar half = 0.5*(b - a)/n;
        scalar sum = 0;
        for (label panel = 0; panel < n; ++panel)
        {
            const scalar mid = a + (2*panel + 1)*half;
            for (label k = 0; k < 2; ++k)
            {
                sum += c[k]*(f(mid - x[k]*half) + f(mid + x[k]*half));
            }
        }

        return sum*half;
    }
}
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::SPH::kernel::normalisation(const label nDims) const
{
    using constant::mathematical::pi;

    const scalar shell[3] = {2, 2*pi, 4*pi};

    const scalar integral = quadrature
    (
        0,
        cutOff(),
        600,
        [&](const scalar q)
        {
            return w(q)*(nDims == 1 ? 1 : integerPow(q, nDims - 1));
        }
    );

    return 1/(shell[nDims - 1]*integral);
}


Foam::scalar Foam::SPH::kernel::squareLatticeMoment() const
{
    const label n = ceil(support(1));
    const label nY = nDims_ > 1 ? n : 0;
    const label nZ = nDims_ > 2 ? n : 0;

    scalar moment = 0;
    for (label x = -n; x <= n; ++x)
    {
        for (label y = -nY; y <= nY; ++y)
        {
            for (label z = -nZ; z <= nZ; ++z)
            {
                const scalar r = mag(vector(x, y, z));
                if (r > 0)
                {
                    moment -= r*dWdr(r, smoothingRatio_)/nDims_;
                }
            }
        }
    }

    return moment;
}


void Foam::SPH::kernel::normalise()
{
    sigma_ = normalisation(nDims_);
    sigmaLine_ = normalisation(1);
    latticeMoment_ = squareLatticeMoment();
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::SPH::kernel::kernel(const dictionary& dict, const label nDims)
:
    nDims_(nDims),
    smoothingRatio_(dict.lookupOrDefault<scalar>("smoothingRatio", 0.9)),
    sigma_(0),
    sigmaLine_(0),
    latticeMoment_(0)
{
    if (smoothingRatio_ < 0.7 || smoothingRatio_ > 4)
    {
        FatalIOErrorInFunction(dict)
            << "smoothingRatio " << smoothingRatio_
            << " is outside the range 0.7 to 4"
            << exit(FatalIOError);
    }
}


Foam::autoPtr<Foam::SPH::kernel> Foam::SPH::kernel::New
(
    const dictionary& dict,
    const label nDims
)
{
    const word kernelType(dict.lookupOrDefault<word>("type", "WendlandC2"));

    auto cstrIter = dictionaryConstructorTablePtr_->cfind(kernelType);

    if (!cstrIter.found())
    {
        FatalIOErrorInLookup
        (
            dict,
            "kernel",
            kernelType,
            *dictionaryConstructorTablePtr_
        ) << exit(FatalIOError);
    }

    return autoPtr<kernel>(cstrIter()(dict, nDims));
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::SPH::kernel::lineTail(const scalar r, const scalar h) const
{
    const scalar q = max(r/h, scalar(0));

    return
        q >= cutOff()
      ? 0
      : sigmaLine_*quadrature
        (
            q, cutOff(), 24, [&](const scalar s) { return w(s); }
        );
}


// ************************************************************************* //
