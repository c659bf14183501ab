/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "highSpeedGas.H"
#include "ImplicitGaussSeidel.H"

const Foam::Enum<Foam::highSpeedGas::modeType>
Foam::highSpeedGas::modeNames
({
    {modeType::transient, "transient"},
    {modeType::steady, "steady"},
    {modeType::frozen, "frozen"}
});


void Foam::highSpeedGas::readSettings()
{
    const dictionary& d = settings_;

    mode_ = modeNames.getOrDefault("mode", d, modeType::transient);
    scheme_ = d.getOrDefault<word>("scheme", "RK3");
    maxCo_ = d.getCheckOrDefault<scalar>
    (
        "maxCo", 0.5, scalarMinMax::ge(SMALL)
    );
    residual_ = d.getCheckOrDefault<scalar>
    (
        "residual", 1e-6, scalarMinMax(SMALL, 1)
    );
    maxIterations_ = d.getCheckOrDefault<label>
    (
        "maxIterations", 20000, labelMinMax::ge(1)
    );
    reportEvery_ = d.getCheckOrDefault<label>
    (
        "reportEvery", 100, labelMinMax::ge(1)
    );
}


Foam::highSpeedGas::highSpeedGas(const fvMesh& mesh)
:
    mesh_(mesh),
    settings_(mesh.solutionDict().subOrEmptyDict("highSpeedGas")),
    thermo_(fluidThermo::New(mesh)),
    U_
    (
        IOobject
        (
            "U",
            mesh.time().timeName(),
            mesh,
            IOobject::MUST_READ,
            IOobject::AUTO_WRITE
        ),
        mesh
    ),
    rho_
    (
        IOobject
        (
            "rho",
            mesh.time().timeName(),
            mesh,
            IOobject::NO_READ,
            IOobject::AUTO_WRITE
        ),
        mesh,
        dimensionedScalar("one", dimDensity, 1)
    ),
    phi_
    (
        IOobject("phi", mesh.time().timeName(), mesh),
        mesh,
        dimensionedScalar(dimMass/dimTime, Zero)
    ),
    Ma_
    (
        IOobject
        (
            "Ma",
            mesh.time().timeName(),
            mesh,
            IOobject::NO_READ,
            IOobject::AUTO_WRITE
        ),
        mesh,
        dimensionedScalar(dimless, Zero)
    ),
    converged_(false),
    cpuTime_(0)
{
    readSettings();

    equations_.reset
    (
        new gasEquations(mesh, *thermo_, U_, rho_, phi_, false)
    );
    march_.reset(new RungeKutta(*equations_, 3));
    publish();
}


Foam::scalar Foam::highSpeedGas::stableDeltaT()
{
    return frozen() ? GREAT : march_->stableStep(maxCo_);
}


void Foam::highSpeedGas::publish()
{
    equations_->publish();

    const gasMesh& geometry = equations_->geometry();
    std::vector<double> a;
    equations_->soundSpeed(a);
    forAll(Ma_, celli)
    {
        Ma_[celli] = mag(U_[celli])/a[celli];
    }

    for (const gasMesh::patchRange& patch : geometry.patches())
    {
        const label slot =
            geometry.nCells() + patch.start - geometry.nInternal();
        fvPatchScalarField& Mp = Ma_.boundaryFieldRef()[patch.patchi];
        const fvPatchVectorField& Up = U_.boundaryField()[patch.patchi];
        forAll(Mp, i)
        {
            Mp[i] = mag(Up[i])/a[slot + i];
        }
    }
}


void Foam::highSpeedGas::marchToSteadyState()
{
    Info<< "Gas: marching to a steady state" << endl;

    scalar imbalance = GREAT;
    label iteration = 0;
    ImplicitGaussSeidel implicit(*equations_, getenv("SW") ? atoi(getenv("SW")) : 2);
    scalar Co = 1;
    while (iteration < maxIterations_)
    {
        if (scheme_ == "implicit")
        {
            Co = implicit.localStep(Co) ? min(maxCo_, 1.1*Co) : 0.5*Co;
        }
        else
        march_->localStep(maxCo_);
        iteration++;

        imbalance = equations_->imbalance();
        if (iteration % reportEvery_ == 0)
        {
            Info<< "Gas: iteration " << iteration << ", mass imbalance "
                << imbalance << endl;
        }
        if (imbalance < residual_)
        {
            break;
        }
    }

    Info<< "Gas: " << (imbalance < residual_ ? "steady" : "NOT steady")
        << " after " << iteration << " iterations, mass imbalance "
        << imbalance << " (wanted " << residual_ << ")" << endl;
    converged_ = true;
}


bool Foam::highSpeedGas::solve()
{
    if (frozen())
    {
        return false;
    }

    const scalar start = mesh_.time().elapsedCpuTime();

    if (mode_ == modeType::steady)
    {
        marchToSteadyState();
    }
    else
    {
        const label n =
            march_->advance(mesh_.time().deltaTValue(), maxCo_);
        if (n > 1)
        {
            Info<< "Gas: " << n << " steps" << endl;
        }
    }
    publish();

    cpuTime_ += mesh_.time().elapsedCpuTime() - start;
    return true;
}
