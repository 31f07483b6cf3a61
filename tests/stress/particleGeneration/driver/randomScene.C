/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "randomScene.H"
#include "mathematicalConstants.H"
#include "unitConversion.H"

#include <algorithm>

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

const Foam::Enum<Foam::SPH::randomScene::kind>
Foam::SPH::randomScene::kindNames
({
    {kind::spike, "spike"},
    {kind::notch, "notch"},
    {kind::inside, "inside"},
    {kind::plate, "plate"},
    {kind::gap, "gap"},
    {kind::touching, "touching"}
});


// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace SPH
{
    //- Twice the signed area of a triangle
    static scalar turn
    (
        const vector2D& a,
        const vector2D& b,
        const vector2D& c
    )
    {
        const vector2D u(b - a);
        const vector2D v(c - a);
        return u.x()*v.y() - u.y()*v.x();
    }


    static bool crosses
    (
        const vector2D& a,
        const vector2D& b,
        const vector2D& c,
        const vector2D& d
    )
    {
        return
            turn(a, b, c)*turn(a, b, d) < 0
         && turn(c, d, a)*turn(c, d, b) < 0;
    }


    //- No two sides meet but at their common vertices
    static bool simple(const List<vector2D>& p)
    {
        const label n = p.size();
        for (label i = 0; i < n; ++i)
        {
            for (label j = i + 1; j < n; ++j)
            {
                if (crosses(p[i], p[(i + 1) % n], p[j], p[(j + 1) % n]))
                {
                    return false;
                }
            }
        }
        return true;
    }


    //- Smallest angle between successive sides [degrees]
    static scalar smallestAngle(const List<vector2D>& p)
    {
        const label n = p.size();
        scalar smallest = 180;
        for (label i = 0; i < n; ++i)
        {
            const vector2D a(p[(i + n - 1) % n] - p[i]);
            const vector2D b(p[(i + 1) % n] - p[i]);
            const scalar c = (a & b)/(mag(a)*mag(b));
            smallest = min
            (
                smallest,
                radToDeg(acos(max(scalar(-1), min(scalar(1), c))))
            );
        }
        return smallest;
    }
}
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::SPH::randomScene::polygon
Foam::SPH::randomScene::tipped(const bool notch)
{
    const scalar pi = constant::mathematical::pi;

    while (true)
    {
        const scalar tip = degToRad(uniform(5, 30));
        const scalar direction = uniform(0, 2*pi);
        const scalar reach = notch ? uniform(0.0, 0.2) : uniform(0.7, 0.95);
        const scalar length = notch ? uniform(0.35, 0.6) : uniform(0.4, 0.7);

        const auto at = [&](const scalar radius, const scalar angle)
        {
            return vector2D(radius*cos(angle), radius*sin(angle));
        };

        // The sides of the tip, inward for a spike and outward for a notch
        const vector2D end(at(reach, direction));
        const scalar side = notch ? 1 : -1;
        const vector2D first
        (
            end + side*at(length, direction - side*0.5*tip)
        );
        const vector2D second
        (
            end + side*at(length, direction + side*0.5*tip)
        );

        // Other vertices around the rest of the circle
        const label n = 3 + label(uniform(0, 7));
        std::vector<scalar> angles(n);
        for (scalar& angle : angles)
        {
            angle = direction + uniform(0.15*pi, 1.85*pi);
        }
        std::sort(angles.begin(), angles.end());

        polygon p(3);
        p[0] = first;
        p[1] = end;
        p[2] = second;
        for (const scalar angle : angles)
        {
            p.append(at(uniform(0.25, 0.7), angle));
        }

        if (simple(p) && smallestAngle(p) >= 4.999)
        {
            return p;
        }
    }
}


Foam::SPH::randomScene::polygon Foam::SPH::randomScene::rectangle
(
    const vector2D& centre,
    const scalar a,
    const scalar b,
    const scalar angle
)
{
    const vector2D u(a*cos(angle), a*sin(angle));
    const vector2D v(-b*sin(angle), b*cos(angle));

    return polygon
    ({
        centre - u - v,
        centre + u - v,
        centre + u + v,
        centre - u + v
    });
}


Foam::SPH::randomScene::polygon
Foam::SPH::randomScene::box(const scalar halfSide)
{
    return rectangle(vector2D::zero, halfSide, halfSide, 0);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::SPH::randomScene::randomScene(const kind k, const label seed)
:
    random_(1000*label(k) + seed + 1),
    spacing_(uniform(0.05, 0.09))
{
    const scalar pi = constant::mathematical::pi;

    switch (k)
    {
        case kind::spike:
        case kind::notch:
            loops_.append(box(1.25));
            loops_.append(tipped(k == kind::notch));
            break;

        case kind::inside:
            loops_.append(tipped(false));
            break;

        case kind::plate:
            loops_.append(box(1.25));
            loops_.append
            (
                rectangle
                (
                    vector2D(uniform(-0.2, 0.2), uniform(-0.2, 0.2)),
                    uniform(0.3, 0.8),
                    0.75*spacing_,
                    uniform(0, pi)
                )
            );
            break;

        case kind::gap:
        {
            const scalar angle = uniform(0, pi);
            const vector2D across(-sin(angle), cos(angle));
            const scalar upper = uniform(0.1, 0.3);
            const scalar lower = uniform(0.1, 0.3);
            loops_.append(box(1.25));
            loops_.append
            (
                rectangle
                (
                    (spacing_ + upper)*across, uniform(0.3, 0.6), upper, angle
                )
            );
            loops_.append
            (
                rectangle
                (
                    -(spacing_ + lower)*across, uniform(0.3, 0.6), lower, angle
                )
            );
            break;
        }

        case kind::touching:
        {
            // A side on the boundary, at a random place
            const scalar left = uniform(-0.9, 0.1);
            const scalar right = left + uniform(0.2, 0.8);
            loops_.append
            (
                polygon
                ({
                    vector2D(-1.25, -1.25),
                    vector2D(left, -1.25),
                    vector2D(uniform(left - 0.3, left + 0.3), uniform(-1, 0.5)),
                    vector2D(right, -1.25),
                    vector2D(1.25, -1.25),
                    vector2D(1.25, 1.25),
                    vector2D(-1.25, 1.25)
                })
            );
            break;
        }
    }

    sharpest_ = 180;
    for (const polygon& p : loops_)
    {
        sharpest_ = min(sharpest_, smallestAngle(p));
    }
}


// ************************************************************************* //
