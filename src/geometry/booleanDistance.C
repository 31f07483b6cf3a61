/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "booleanDistance.H"
#include "error.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::SPH::booleanDistance::booleanDistance
(
    const operation op,
    const List<const signedDistance*>& operands
)
:
    operation_(op),
    operands_(operands)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::SPH::signedDistance::nearest Foam::SPH::booleanDistance::find
(
    const point& p
) const
{
    nearest result(operands_[0]->find(p));

    for (label i = 1; i < operands_.size(); ++i)
    {
        // Outside its box an operand is at least as far as the box
        const boundBox box(operands_[i]->bounds());
        const scalar least = mag(p - min(max(p, box.min()), box.max()));
        if
        (
            operation_ == operation::unite
          ? least > result.distance
          : complemented(i) && -least < result.distance
        )
        {
            continue;
        }

        nearest other(operands_[i]->find(p));
        if (complemented(i))
        {
            other.distance = -other.distance;
            other.normal = -other.normal;
        }

        const bool replace =
            operation_ == operation::unite
          ? other.distance < result.distance
          : other.distance > result.distance;

        if (replace)
        {
            result = other;
        }
    }

    return result;
}


bool Foam::SPH::booleanDistance::inside(const point& p) const
{
    forAll(operands_, i)
    {
        const bool in = operands_[i]->inside(p) != complemented(i);

        if (in == (operation_ == operation::unite))
        {
            return in;
        }
    }

    return operation_ != operation::unite;
}


Foam::boundBox Foam::SPH::booleanDistance::bounds() const
{
    boundBox box(operands_[0]->bounds());

    for (label i = 1; i < operands_.size(); ++i)
    {
        if (operation_ == operation::unite)
        {
            box.add(operands_[i]->bounds());
        }
        else if (operation_ == operation::intersect)
        {
            box.intersect(operands_[i]->bounds());
        }
    }

    return box;
}


// ************************************************************************* //
