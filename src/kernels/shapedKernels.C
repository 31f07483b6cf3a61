/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "shapedKernel.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

#define makeKernel(Shape)                                                      \
                                                                               \
    template<>                                                                 \
    const Foam::word Foam::SPH::shapedKernel<Foam::SPH::Shape>::typeName       \
    (                                                                          \
        Foam::SPH::Shape::name                                                 \
    );                                                                         \
                                                                               \
    namespace Foam                                                             \
    {                                                                          \
    namespace SPH                                                              \
    {                                                                          \
        typedef shapedKernel<Shape> shapedKernel##Shape;                       \
        addToRunTimeSelectionTable(kernel, shapedKernel##Shape, dictionary);   \
    }                                                                          \
    }

makeKernel(WendlandC2Shape)
makeKernel(LaguerreGaussShape)
makeKernel(cubicSplineShape)
makeKernel(quinticSplineShape)


// ************************************************************************* //
