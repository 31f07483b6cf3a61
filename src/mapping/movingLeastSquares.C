/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include <CGAL/Fuzzy_sphere.h>
#include <CGAL/Kd_tree.h>
#include <CGAL/Orthogonal_k_neighbor_search.h>
#include <CGAL/Search_traits_3.h>
#include <CGAL/Search_traits_adapter.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/property_map.h>
#include <Eigen/Dense>
#include <omp.h>

#include "movingLeastSquares.H"
#include "kernel.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace SPH
{
    //- Radius over source spacing and over target spacing
    static constexpr scalar sourceRadius = 1.6;
    static constexpr scalar targetRadius = 1.1;

    //- The radius holds the nearest source well inside
    static constexpr scalar nearestRadius = 1.2;

    //- Growth of the radius and how often it may grow
    static constexpr scalar growth = 1.3;
    static constexpr label maxGrowths = 6;

    //- Extents of a stencil below this fraction of R^2 are none
    static constexpr scalar degenerate = 1e-3;
    static constexpr scalar singular = 1e-12;

    //- Largest accepted sum |w_k|: extrapolation from a corner by half a
    //- spacing has 3
    static constexpr scalar maxAmplification = 4;

    //- Shape of the weight, Wendland C2
    static scalar shape(const scalar q)
    {
        return q < 1 ? pow4(1 - q)*(1 + 4*q) : 0;
    }

    //- CGAL's k-d tree over points and their indices. Searches allocate, but
    //- each thread for itself, unlike indexedOctree's spheres, whose hash
    //- tables make them three to six times slower
    typedef CGAL::Simple_cartesian<scalar> pointKernel;
    typedef std::pair<pointKernel::Point_3, label> indexedPoint;
    typedef CGAL::Search_traits_adapter
    <
        indexedPoint,
        CGAL::First_of_pair_property_map<indexedPoint>,
        CGAL::Search_traits_3<pointKernel>
    > treeTraits;
    typedef CGAL::Kd_tree<treeTraits> pointTree;

    static pointKernel::Point_3 treePoint(const point& p)
    {
        return pointKernel::Point_3(p.x(), p.y(), p.z());
    }

    static label nearest(const pointTree& tree, const point& x)
    {
        const CGAL::Orthogonal_k_neighbor_search<treeTraits> search
        (
            tree, treePoint(x), 1
        );
        return search.begin()->first.second;
    }

    //- Indices of all points within R of x, ascending
    static void withinSphere
    (
        const pointTree& tree,
        const point& x,
        const scalar R,
        DynamicList<label>& found
    )
    {
        std::vector<indexedPoint> points;
        tree.search
        (
            std::back_inserter(points),
            CGAL::Fuzzy_sphere<treeTraits>(treePoint(x), R)
        );
        found.clear();
        for (const indexedPoint& p : points)
        {
            found.append(p.second);
        }
        std::sort(found.begin(), found.end());
    }

    //- Points in the solution space, in local coordinates
    static tmp<pointField> localPoints
    (
        const solutionSpace& space,
        const pointField& points
    )
    {
        tmp<pointField> tlocal(new pointField(points.size()));
        pointField& local = tlocal.ref();
        forAll(local, i)
        {
            local[i] = space.toLocal(points[i]);
        }
        return tlocal;
    }

    //- Stencil of one target: the sources within R and their weights
    struct stencil
    {
        DynamicList<label> source;
        DynamicList<scalar> weight;

        //- Sum of |weight|
        scalar amplification;

        //- Projection on the directions that the fit leaves out
        tensor missing;

        //- Weights of the linear fit at x. Directions in which the extent of
        //- the sources is below the tolerance are left out.
        //  \param scaling of distances, to 1 where the weights end
        //  \return number of directions used
        label fit
        (
            const pointField& points,
            const scalarField& volume,
            const point& x,
            const tensor& scaling,
            const scalar tolerance
        );
    };
}
}


Foam::label Foam::SPH::stencil::fit
(
    const pointField& points,
    const scalarField& volume,
    const point& x,
    const tensor& scaling,
    const scalar tolerance
)
{
    weight.setSize(source.size());

    scalar sum = 0;
    vector centroid(Zero);
    forAll(source, k)
    {
        const vector d(scaling & (points[source[k]] - x));
        weight[k] = volume[source[k]]*shape(mag(d));
        sum += weight[k];
        centroid += weight[k]*d;
    }
    centroid /= sum;

    Eigen::Matrix3d C(Eigen::Matrix3d::Zero());
    const auto fromCentroid = [&](const label k)
    {
        const vector d((scaling & (points[source[k]] - x)) - centroid);
        return Eigen::Vector3d(d.x(), d.y(), d.z());
    };
    forAll(source, k)
    {
        weight[k] /= sum;
        const Eigen::Vector3d d(fromCentroid(k));
        C += weight[k]*d*d.transpose();
    }

    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen(C);

    // Gradient at the centroid needed per unit of W_k (x_k - xc)
    const Eigen::Vector3d toTarget
    (
        -centroid.x(), -centroid.y(), -centroid.z()
    );
    Eigen::Vector3d g(Eigen::Vector3d::Zero());
    label rank = 0;
    missing = Zero;
    for (label c = 0; c < 3; ++c)
    {
        const scalar extent = eigen.eigenvalues()[c];
        const Eigen::Vector3d e(eigen.eigenvectors().col(c));
        if (extent > tolerance)
        {
            g += e*(e.dot(toTarget)/extent);
            ++rank;
        }
        else
        {
            const vector direction(e[0], e[1], e[2]);
            missing += direction*direction;
        }
    }

    amplification = 0;
    forAll(source, k)
    {
        weight[k] *= 1 + g.dot(fromCentroid(k));
        amplification += mag(weight[k]);
    }

    return rank;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::SPH::movingLeastSquares::movingLeastSquares
(
    const solutionSpace& space,
    const cloud& from,
    const cloud& to
)
:
    nearest_(to.points.size()),
    start_(to.points.size() + 1, 0),
    source_(),
    weight_()
{
    if (from.points.empty() && size())
    {
        FatalErrorInFunction
            << "Cannot map to " << size() << " points from no points"
            << exit(FatalError);
    }

    const pointField sources(localPoints(space, from.points));
    const pointField targets(localPoints(space, to.points));

    scalarField volume(from.spacing);
    for (scalar& v : volume)
    {
        v = kernel::integerPow(v, space.nDims());
    }

    pointTree tree;
    forAll(sources, k)
    {
        tree.insert({treePoint(sources[k]), k});
    }
    if (sources.size())
    {
        // Before the threads search, of which the first one would build it
        tree.build();
    }

    // Every thread fills its own contiguous share of the targets
    List<DynamicList<label>> threadSource(omp_get_max_threads());
    List<DynamicList<scalar>> threadWeight(omp_get_max_threads());

    #pragma omp parallel
    {
        DynamicList<label>& shareSource = threadSource[omp_get_thread_num()];
        DynamicList<scalar>& shareWeight = threadWeight[omp_get_thread_num()];

        stencil current;
        stencil best;

        #pragma omp for schedule(static)
        for (label i = 0; i < size(); ++i)
        {
            const point& x = targets[i];
            const label n0 = nearest_[i] = nearest(tree, x);

            const scalar R0 = max
            (
                sourceRadius*from.spacing[n0], targetRadius*to.spacing[i]
            );
            const vector toNearest(sources[n0] - x);
            const scalar distance = mag(toNearest);
            const scalar Rn = max(R0, nearestRadius*distance);

            // Of flat cells the first R reaches one column only, of one layer
            // it never reaches two: R grows in the direction left out, and
            // in all directions if that does not help
            label bestRank = -1;
            tensor bestScaling;
            const auto found = [&]()
            {
                return
                    bestRank == space.nDims()
                 && best.amplification <= maxAmplification;
            };

            for (const bool allDirections : {false, true})
            {
                if (bestRank < space.nDims())
                {
                    bestRank = -1;
                }
                scalar R = Rn;
                tensor scaling(tensor::I/(allDirections ? Rn : R0));
                tensor grows(tensor::I);
                if (!allDirections && Rn > R0)
                {
                    scaling -=
                        (1/R0 - 1/Rn)*(toNearest*toNearest)/sqr(distance);
                }

                for (label n = 0; n <= maxGrowths && !found(); ++n)
                {
                    withinSphere(tree, x, R, current.source);
                    const label rank =
                        current.fit(sources, volume, x, scaling, degenerate);

                    if
                    (
                        rank > bestRank
                     || (
                            rank == bestRank
                         && best.amplification > maxAmplification
                         && current.amplification < best.amplification
                        )
                    )
                    {
                        best = current;
                        bestRank = rank;
                        bestScaling = scaling;
                    }
                    if (!allDirections && rank < space.nDims())
                    {
                        grows = current.missing;
                    }
                    R *= growth;
                    scaling -= (1 - 1/growth)*(grows & scaling);
                }
            }

            if (bestRank < space.nDims())
            {
                // Two thin layers: across them too, where that is safe
                current.source = best.source;
                current.fit(sources, volume, x, bestScaling, singular);
                if (current.amplification <= maxAmplification)
                {
                    best = current;
                }
            }

            shareSource.append(best.source);
            shareWeight.append(best.weight);
            start_[i + 1] = best.source.size();
        }
    }

    for (label i = 0; i < size(); ++i)
    {
        start_[i + 1] += start_[i];
    }

    source_.setSize(start_.last());
    weight_.setSize(start_.last());
    label k = 0;
    forAll(threadSource, threadi)
    {
        const label n = threadSource[threadi].size();
        SubList<label>(source_, n, k) = threadSource[threadi];
        SubList<scalar>(weight_, n, k) = threadWeight[threadi];
        k += n;
    }
}


// ************************************************************************* //
