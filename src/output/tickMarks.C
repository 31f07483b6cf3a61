/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "tickMarks.H"
#include "DynamicList.H"

#include <cmath>
#include <cstdio>

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::SPH::tickMarks::tickMarks
(
    const scalar lowest,
    const scalar highest,
    const Foam::label n
)
:
    step_(0),
    values_()
{
    const scalar span = highest - lowest;

    if (span <= SMALL*max(mag(lowest), mag(highest)) || span < VSMALL)
    {
        values_ = scalarList(1, lowest);
        return;
    }

    const scalar decade = std::pow(10, std::floor(std::log10(span/n)));
    for (const scalar factor : {10, 5, 2, 1})
    {
        if (step_ == 0 || span/(factor*decade) <= n)
        {
            step_ = factor*decade;
        }
    }

    DynamicList<scalar> values;
    const scalar tolerance = 1e-6*step_;
    scalar k = std::ceil((lowest - tolerance)/step_);
    for (; k*step_ <= highest + tolerance; ++k)
    {
        // The sum turns a negative zero into zero
        values.append(k*step_ + 0.0);
    }
    values_.transfer(values);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

std::string Foam::SPH::tickMarks::label(const scalar value) const
{
    const scalar largest =
        max(mag(values_.first()), mag(values_.last()));

    char text[32];
    if (step_ == 0 || largest >= 1e7 || step_ < 1e-5)
    {
        // Digits from the largest value, or zero alone, down to the step
        const int digits =
            step_ > 0
          ? int(std::ceil(std::log10(max(largest, step_)/step_) - 1e-6))
          : 3;
        std::snprintf(text, sizeof(text), "%.*e", digits, value);
    }
    else
    {
        const int decimals =
            max(0, int(std::ceil(-std::log10(step_) - 1e-6)));
        std::snprintf(text, sizeof(text), "%.*f", decimals, value);
    }

    return text;
}

// ************************************************************************* //
