/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

Description
    The explicit time schemes under their names in system/sphSchemes. The
    default Courant numbers lie below the limits measured with walls.

\*---------------------------------------------------------------------------*/

#include "timeScheme.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam
{
namespace SPH
{

//- Strong-stability preserving Runge-Kutta schemes as repeated Euler steps
//- Q = a Q0 + (1 - a)(Q + dt dQ/dt) from the start, where time goes the same
//- way; Shu and Osher, J. Comput. Phys. 77 (1988) 439
template<int nOldWeights>
class SSPRungeKutta
:
    public timeScheme
{
protected:

    virtual const scalar* oldWeights() const = 0;

    virtual bool stages
    (
        conservationLaw& law,
        faceStates& faces,
        const scalar dt,
        const scalar timeLeft
    ) const
    {
        scalar elapsed = 0;
        for (int stage = 0; stage < nOldWeights; ++stage)
        {
            const scalar a = oldWeights()[stage];

            evaluate(law, faces, timeLeft + dt - elapsed);
            if (!law.update(a, (1 - a)*dt, 0, law.nVariables()))
            {
                return false;
            }
            elapsed = (1 - a)*(elapsed + dt);
        }
        return true;
    }

public:

    virtual label nStages() const
    {
        return nOldWeights;
    }
};


class SSPRK2
:
    public SSPRungeKutta<2>
{
    virtual const scalar* oldWeights() const
    {
        static constexpr scalar weights[] = {0, 0.5};
        return weights;
    }

public:

    TypeName("SSPRK2");

    virtual scalar defaultCo() const
    {
        return 0.4;
    }

    virtual scalar maxDiffusion() const
    {
        return 0.9;
    }
};


class SSPRK3
:
    public SSPRungeKutta<3>
{
    virtual const scalar* oldWeights() const
    {
        static constexpr scalar weights[] = {0, 0.75, 1.0/3.0};
        return weights;
    }

public:

    TypeName("SSPRK3");

    virtual scalar defaultCo() const
    {
        return 0.9;
    }

    virtual scalar maxDiffusion() const
    {
        return 1.13;
    }
};


//- Scheme of [B]: momentum first, then mass and energy with the new momentum
class symplecticEuler
:
    public timeScheme
{
    virtual bool stages
    (
        conservationLaw& law,
        faceStates& faces,
        const scalar dt,
        const scalar timeLeft
    ) const
    {
        const label firstAfter = 1 + loopDims(law.particles());

        evaluate(law, faces, timeLeft + dt);
        if (!law.update(0, dt, 1, firstAfter))
        {
            return false;
        }

        evaluate(law, faces, timeLeft);
        return
            law.update(0, dt, 0, 1)
         && law.update(0, dt, firstAfter, law.nVariables());
    }

public:

    TypeName("symplecticEuler");

    virtual label nStages() const
    {
        return 2;
    }

    virtual scalar defaultCo() const
    {
        return 0.5;
    }

    virtual scalar maxDiffusion() const
    {
        return 0.9;
    }
};


// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

defineTypeNameAndDebug(SSPRK2, 0);
addToRunTimeSelectionTable(timeScheme, SSPRK2, empty);

defineTypeNameAndDebug(SSPRK3, 0);
addToRunTimeSelectionTable(timeScheme, SSPRK3, empty);

defineTypeNameAndDebug(symplecticEuler, 0);
addToRunTimeSelectionTable(timeScheme, symplecticEuler, empty);

} // End namespace SPH
} // End namespace Foam


// ************************************************************************* //
