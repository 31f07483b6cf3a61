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

    virtual void stages
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
            law.update(a, (1 - a)*dt, 0, law.nVariables());
            elapsed = (1 - a)*(elapsed + dt);
        }
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

    virtual scalar defaultCo(const conservationLaw&) const
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

    virtual scalar defaultCo(const conservationLaw&) const
    {
        return 0.9;
    }

    virtual scalar maxDiffusion() const
    {
        return 1.13;
    }
};


//- One evaluation at the middle of the step, of the states that gradients and
//- the equations without viscosity tell: second order where viscosity does not
//- count, first order in it; van Leer, SIAM J. Sci. Stat. Comput. 5 (1984) 1
class Hancock
:
    public timeScheme
{
    //- Longest step of the particles that need the shortest [s]
    scalar shortest_ = GREAT;

public:

    TypeName("Hancock");

    virtual bool hasLevels(const conservationLaw& law, const scalar) const
    {
        return law.mayTakeParts();
    }

    virtual scalar stableDeltaT
    (
        conservationLaw& law,
        const scalar maxCo
    )
    {
        shortest_ = timeScheme::stableDeltaT(law, maxCo);
        return law.levels().nParts()*shortest_;
    }

    virtual label nParts(conservationLaw& law, const scalar dt) const
    {
        label n = 1;
        while (n < law.levels().nParts() && dt > (1 + 1e-9)*n*shortest_)
        {
            n *= 2;
        }
        return n;
    }

    virtual scalar defaultCo(const conservationLaw& law) const
    {
        if (!law.maySeeAhead())
        {
            FatalErrorInFunction
                << "timeScheme " << typeName << " is for flow without"
                << " viscosity by the fluxScheme Kurganov or HLLC of"
                << " rhoSphFoam; others: automatic, SSPRK3, SSPRK2,"
                << " symplecticEuler" << exit(FatalError);
        }
        return 0.4;
    }

    virtual scalar maxDiffusion() const
    {
        return 0.9;
    }

    virtual void stages
    (
        conservationLaw& law,
        faceStates& faces,
        const scalar dt,
        const scalar timeLeft
    ) const
    {
        const label n = nParts(law, dt);
        if (n == 1)
        {
            evaluate(law, faces, timeLeft + 0.5*dt, 0.5*dt);
            law.update(0, dt, 0, law.nVariables());
            return;
        }

        stepLevels& levels = law.levels();
        levels.start(n);
        for (label part = 0; part < n; ++part)
        {
            levels.begin(part, dt);
            for (label level = 0; level <= levels.beginning(); ++level)
            {
                const scalar step = dt/n*(1 << level);
                const scalar left = timeLeft + dt - dt/n*part - 0.5*step;
                faces.correct(law.W(), left, levels.step(), step);
            }
            law.evaluate(0);
            law.update(0, 1, 0, law.nVariables());
        }
        levels.stop();
    }
};


//- Hancock where it is stable, else SSPRK3, or where diffusion would shorten its
//- steps a super time step of RKL2: s stages whose steps grow as s^2; Meyer,
//- Balsara, Aslam, J. Comput. Phys. 257 (2014) 594, eq. 15-17. With five stages
//- or more, odd, acoustic waves of upwind fluxes are stable as well up to a
//- Courant number of 0.9, and the more so the more stages (eigenvalues of the
//- one-dimensional scheme)
class automatic
:
    public SSPRK3
{
    static constexpr label leastStages = 5;

    Hancock oneStage_;

    //- Was the step found for one stage
    bool seesAhead_ = false;

    //- Diffusive rate of the state that the step was found for [1/s]
    scalar diffusion_ = 0;

    //- Longest step of SSPRK3 [s]
    scalar shortStep_ = GREAT;

    //- Is one stage stable
    bool mayTakeOneStage(const conservationLaw& law, const scalar maxCo) const
    {
        return law.maySeeAhead() && maxCo <= oneStage_.defaultCo(law);
    }

    //- b_j
    static scalar b(const label j)
    {
        return j < 3 ? 1.0/3.0 : (j*j + j - 2)/(2.0*j*(j + 1));
    }

    //- Least odd number of stages for a step
    label nStages(const scalar dt) const
    {
        // Stable up to eigenvalues of (s^2 + s - 2)/2, less a tenth
        const scalar q = dt*diffusion_/(0.9*0.25);
        const label s = std::ceil(0.5*(std::sqrt(9 + 4*q) - 1));
        return max(leastStages, s + 1 - s % 2);
    }

protected:

    virtual void stages
    (
        conservationLaw& law,
        faceStates& faces,
        const scalar dt,
        const scalar timeLeft
    ) const
    {
        if (seesAhead_)
        {
            oneStage_.stages(law, faces, dt, timeLeft);
            return;
        }
        if (dt <= (1 + 1e-9)*shortStep_)
        {
            SSPRK3::stages(law, faces, dt, timeLeft);
            return;
        }

        const label s = nStages(dt);
        const scalar w = 4.0/(s*s + s - 2);

        evaluate(law, faces, timeLeft + dt);
        law.startSuperStep(w*b(1)*dt);

        for (label j = 2; j <= s; ++j)
        {
            const scalar mu = (2*j - 1)*b(j)/(j*b(j - 1));
            const scalar nu = -(j - 1)*b(j)/(j*b(j - 2));
            const scalar rate = mu*w*dt;

            // Times of the stages: c_1 = c_2/4
            const label k = j - 1;
            const scalar c = k == 1 ? 0.25*w : 0.25*w*(k*k + k - 2);
            evaluate(law, faces, timeLeft + (1 - c)*dt);
            law.superStep(mu, nu, rate, -(1 - b(j - 1))*rate);
        }
    }

public:

    TypeName("automatic");

    virtual scalar defaultCo(const conservationLaw& law) const
    {
        return
            law.maySeeAhead()
          ? oneStage_.defaultCo(law)
          : SSPRK3::defaultCo(law);
    }

    virtual bool hasLevels
    (
        const conservationLaw& law,
        const scalar maxCo
    ) const
    {
        return
            mayTakeOneStage(law, maxCo) && oneStage_.hasLevels(law, maxCo);
    }

    virtual label nParts(conservationLaw& law, const scalar dt) const
    {
        return seesAhead_ ? oneStage_.nParts(law, dt) : 1;
    }

    virtual scalar stableDeltaT
    (
        conservationLaw& law,
        const scalar maxCo
    )
    {
        seesAhead_ = mayTakeOneStage(law, maxCo);
        if (seesAhead_)
        {
            return oneStage_.stableDeltaT(law, maxCo);
        }

        shortStep_ = SSPRK3::stableDeltaT(law, maxCo);

        const scalar longStep = 1/law.stableRate(maxCo, GREAT);
        if (leastStages*shortStep_ >= 3*longStep)
        {
            return shortStep_;
        }

        diffusion_ = law.stableRate(GREAT, 1);
        return
            nStages(longStep)*shortStep_ < 3*longStep ? longStep : shortStep_;
    }
};


//- Scheme of [B]: momentum first, then mass and energy with the new momentum
class symplecticEuler
:
    public timeScheme
{
    virtual void stages
    (
        conservationLaw& law,
        faceStates& faces,
        const scalar dt,
        const scalar timeLeft
    ) const
    {
        const label firstAfter = 1 + loopDims(law.particles());

        evaluate(law, faces, timeLeft + dt);
        law.update(0, dt, 1, firstAfter);

        evaluate(law, faces, timeLeft);
        law.update(0, dt, 0, 1);
        law.update(0, dt, firstAfter, law.nVariables());
    }

public:

    TypeName("symplecticEuler");

    virtual scalar defaultCo(const conservationLaw&) const
    {
        return 0.3;
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

defineTypeNameAndDebug(Hancock, 0);
addToRunTimeSelectionTable(timeScheme, Hancock, empty);

defineTypeNameAndDebug(automatic, 0);
addToRunTimeSelectionTable(timeScheme, automatic, empty);

defineTypeNameAndDebug(symplecticEuler, 0);
addToRunTimeSelectionTable(timeScheme, symplecticEuler, empty);

} // End namespace SPH
} // End namespace Foam


// ************************************************************************* //
