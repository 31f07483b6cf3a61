/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "surfaceIntegral.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- Gauss-Legendre quadrature with 8 points, M. Abramowitz and I. A. Stegun,
//- Handbook of Mathematical Functions (1964), table 25.4
constexpr Foam::scalar gaussPoint[4] =
{
    0.183434642495650, 0.525532409916329, 0.796666477413627, 0.960289856497536
};

constexpr Foam::scalar gaussWeight[4] =
{
    0.362683783378362, 0.313706645877887, 0.222381034453374, 0.101228536290376
};

template<class Function>
Foam::scalar integrate
(
    const Function& f,
    const Foam::scalar from,
    const Foam::scalar to
)
{
    if (from == to)
    {
        return 0;
    }

    const Foam::scalar middle = 0.5*(from + to);
    const Foam::scalar half = 0.5*(to - from);

    Foam::scalar sum = 0;
    for (int k = 0; k < 4; ++k)
    {
        sum +=
            gaussWeight[k]
           *(f(middle - half*gaussPoint[k]) + f(middle + half*gaussPoint[k]));
    }

    return half*sum;
}

//- Steps of the table of moments
constexpr Foam::label nMoments = 2000;

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::SPH::surfaceIntegral::moment(const scalar q) const
{
    const scalar s = q/kernel_.cutOff()*nMoments;
    if (s >= nMoments)
    {
        return 0;
    }

    const label i = label(s);

    return moment_[i] + (s - i)*(moment_[i+1] - moment_[i]);
}


Foam::scalar Foam::SPH::surfaceIntegral::overSegment
(
    const point& x,
    const point& a,
    const point& b,
    const scalar h
) const
{
    const scalar length = mag(b - a);
    const vector t((b - a)/max(length, VSMALL));
    const scalar foot = (x - a) & t;
    const scalar sqrDistance = max(magSqr(x - a) - foot*foot, scalar(0));
    const scalar sqrReach = sqr(kernel_.cutOff()*h);

    if (sqrDistance >= sqrReach)
    {
        return 0;
    }

    const scalar half = Foam::sqrt(sqrReach - sqrDistance);
    const scalar from = max(-foot, -half);
    const scalar to = min(length - foot, half);

    if (from >= to)
    {
        return 0;
    }

    // Split at the foot, where W has a kink if x lies on the segment
    const scalar middle = min(max(scalar(0), from), to);
    const auto w = [&](const scalar s)
    {
        return kernel_.w(Foam::sqrt(sqrDistance + s*s)/h);
    };

    const scalar sum = integrate(w, from, middle) + integrate(w, middle, to);

    return kernel_.sigma(h)*sum;
}


Foam::scalar Foam::SPH::surfaceIntegral::overTriangle
(
    const point& x,
    const FixedList<point, 3>& corners,
    const vector& normal,
    const scalar h
) const
{
    const scalar d = (x - corners[0]) & normal;
    const scalar sqrReach = sqr(kernel_.cutOff()*h) - d*d;

    if (sqrReach <= 0)
    {
        return 0;
    }

    const point foot(x - d*normal);
    const scalar atFoot = moment(mag(d)/h);

    scalar sum = 0;
    for (label k = 0; k < 3; ++k)
    {
        const point& a = corners[k];
        const point& b = corners[(k + 1) % 3];
        const scalar length = mag(b - a);
        const vector t((b - a)/max(length, VSMALL));

        // Distance of the edge, positive with the foot on its inner side
        const scalar p = ((foot - a) ^ t) & -normal;
        const scalar magP = mag(p);
        const scalar from = (a - foot) & t;
        const scalar to = from + length;

        if (magP < SMALL*length)
        {
            continue;
        }

        scalar part =
            atFoot*(Foam::atan2(to, magP) - Foam::atan2(from, magP));

        // The piece in the support, split at its nearest point
        const scalar half = Foam::sqrt(max(sqrReach - p*p, scalar(0)));
        const scalar first = max(from, -half);
        const scalar last = min(to, half);

        if (first < last)
        {
            const scalar theta0 = Foam::atan2(first, magP);
            const scalar theta1 = Foam::atan2(last, magP);
            const scalar middle = min(max(scalar(0), theta0), theta1);
            const auto f = [&](const scalar theta)
            {
                const scalar rho = p/Foam::cos(theta);
                return moment(Foam::sqrt(d*d + rho*rho)/h);
            };

            part -= integrate(f, theta0, middle) + integrate(f, middle, theta1);
        }

        sum += p > 0 ? part : -part;
    }

    return kernel_.sigma(h)*h*h*sum;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::SPH::surfaceIntegral::surfaceIntegral
(
    const surfaceDistance& surface,
    const kernel& k
)
:
    surface_(surface),
    kernel_(k),
    moment_(kernel_.nDims() == 3 ? nMoments + 1 : 0, Zero)
{
    const scalar step = kernel_.cutOff()/nMoments;

    for (label i = moment_.size() - 2; i >= 0; --i)
    {
        moment_[i] =
            moment_[i+1]
          + integrate
            (
                [&](const scalar q){ return q*kernel_.w(q); },
                i*step,
                (i + 1)*step
            );
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::vector Foam::SPH::surfaceIntegral::operator()
(
    const point& p,
    const scalar h
) const
{
    const point x(surface_.space().toLocal(p));
    DynamicList<label> near(32);
    surface_.elementsWithin(p, kernel_.cutOff()*h, near);

    vector g(Zero);
    for (const label elementi : near)
    {
        const FixedList<point, 3> corners(surface_.corners(elementi));
        const vector& n = surface_.normal(elementi);

        const scalar integral =
            kernel_.nDims() == 1 ? kernel_.W(mag(x.x() - corners[0].x()), h)
          : kernel_.nDims() == 2 ? overSegment(x, corners[0], corners[1], h)
          : overTriangle(x, corners, n, h);

        g += integral*n;
    }

    return g;
}


// ************************************************************************* //
