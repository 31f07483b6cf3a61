/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

Application
    taylorGreenError

Description
    Error of the velocities of the Taylor-Green vortex in a particle case of the
    periodic unit square against a spectral solution of the same equations.

    The weakly compressible equations with p = c^2 (rho - 1),

        d(rho)/dt + div(rho u) = 0
        d(rho u)/dt + div(rho u u) + grad p = nu laplacian(u)

    are integrated from the incompressible initial state by a Fourier
    collocation method and the classical Runge-Kutta scheme; doubling the
    points changes the velocity by less than 1e-9.

Usage
    \b taylorGreenError -case sph [OPTION]

      - \par -soundSpeed \<c\>
        Sound speed over the initial maximum velocity, default 10

      - \par -points \<N\>
        Collocation points in each direction, default 32

\*---------------------------------------------------------------------------*/

#include <Eigen/Dense>

#include "fvCFD.H"
#include "particleMesh.H"

using namespace Foam;

typedef Eigen::ArrayXXd gridArray;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{
    const double pi = M_PI;

    //- Fourier differentiation matrix of N points on the unit interval
    Eigen::MatrixXd differentiation(const int N)
    {
        Eigen::MatrixXd D(N, N);
        for (int i = 0; i < N; ++i)
        {
            for (int j = 0; j < N; ++j)
            {
                D(i, j) =
                    i == j
                  ? 0
                  : ((i - j) % 2 ? -pi : pi)/std::tan(pi*(i - j)/N);
            }
        }
        return D;
    }

    //- Density and momentum at the collocation points
    struct state
    {
        gridArray rho, mx, my;

        state operator+(const state& s) const
        {
            return {rho + s.rho, mx + s.mx, my + s.my};
        }

        state operator*(const double a) const
        {
            return {rho*a, mx*a, my*a};
        }
    };

    struct spectralSolver
    {
        Eigen::MatrixXd D;
        double c;
        double nu;

        gridArray dx(const gridArray& f) const
        {
            return (D*f.matrix()).array();
        }

        gridArray dy(const gridArray& f) const
        {
            return (f.matrix()*D.transpose()).array();
        }

        state rate(const state& s) const
        {
            const gridArray u(s.mx/s.rho);
            const gridArray v(s.my/s.rho);
            const gridArray p(c*c*(s.rho - 1));
            const gridArray muv(s.mx*v);

            return
            {
                -dx(s.mx) - dy(s.my),
                dx(nu*dx(u) - s.mx*u - p) + dy(nu*dy(u) - muv),
                dx(nu*dx(v) - muv) + dy(nu*dy(v) - s.my*v - p)
            };
        }

        void advance(state& s, const double dt) const
        {
            const state k1(rate(s));
            const state k2(rate(s + k1*(dt/2)));
            const state k3(rate(s + k2*(dt/2)));
            const state k4(rate(s + k3*dt));
            s = s + (k1 + k2*2 + k3*2 + k4)*(dt/6);
        }
    };

    //- Trigonometric cardinal functions of N points at x
    Eigen::VectorXd cardinal(const int N, const double x)
    {
        Eigen::VectorXd phi(N);
        for (int i = 0; i < N; ++i)
        {
            const double t = pi*(x - double(i)/N);
            const double s = std::sin(t);
            phi[i] =
                std::abs(s) < 1e-12
              ? 1
              : std::sin(N*t)*std::cos(t)/(N*s);
        }
        return phi;
    }
}


// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

int main(int argc, char *argv[])
{
    argList::noParallel();
    argList::addOption("soundSpeed", "c", "Sound speed, default 10");
    argList::addOption("points", "N", "Collocation points, default 32");

    #include "setRootCase.H"
    #include "createTime.H"
    #include "createMesh.H"

    const instantList times(runTime.times());
    runTime.setTime(times.last(), times.size() - 1);

    const SPH::particleMesh particles(mesh);
    const volVectorField U
    (
        IOobject
        (
            "U",
            runTime.timeName(),
            mesh,
            IOobject::MUST_READ
        ),
        mesh
    );

    const IOdictionary transport
    (
        IOobject
        (
            "transportProperties",
            runTime.constant(),
            mesh,
            IOobject::MUST_READ
        )
    );

    const int N = args.getOrDefault<label>("points", 32);
    const spectralSolver solver
    ({
        differentiation(N),
        args.getOrDefault<scalar>("soundSpeed", 10),
        dimensionedScalar("nu", dimViscosity, transport).value()
    });

    state s({gridArray(N, N), gridArray(N, N), gridArray(N, N)});
    for (int i = 0; i < N; ++i)
    {
        for (int j = 0; j < N; ++j)
        {
            const double x = 2*pi*i/N;
            const double y = 2*pi*j/N;
            const double p = -0.25*(std::cos(2*x) + std::cos(2*y));
            s.rho(i, j) = 1 + p/(solver.c*solver.c);
            s.mx(i, j) = -s.rho(i, j)*std::cos(x)*std::sin(y);
            s.my(i, j) = s.rho(i, j)*std::sin(x)*std::cos(y);
        }
    }

    const double endTime = runTime.value();
    const int nSteps = int(endTime*(solver.c + 1)*N*pi/1.5) + 1;
    for (int step = 0; step < nSteps; ++step)
    {
        solver.advance(s, endTime/nSteps);
    }
    const gridArray u(s.mx/s.rho);
    const gridArray v(s.my/s.rho);

    scalar error = 0;
    scalar reference = 0;
    scalar largest = 0;
    forAll(U, i)
    {
        const point& x = particles.C()[i];
        const Eigen::VectorXd phiX(cardinal(N, x.x()));
        const Eigen::VectorXd phiY(cardinal(N, x.y()));
        const vector exact
        (
            phiX.dot(u.matrix()*phiY),
            phiX.dot(v.matrix()*phiY),
            0
        );
        error += particles.V()[i]*magSqr(U[i] - exact);
        reference += particles.V()[i]*magSqr(exact);
        largest = max(largest, mag(U[i] - exact));
    }

    Info<< "particles " << U.size() << " time " << endTime
        << " relativeL2 " << std::sqrt(error/reference)
        << " Linf " << largest << nl << "End\n" << endl;

    return 0;
}


// ************************************************************************* //
