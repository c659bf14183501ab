/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "gasEquations.H"
#include "wallPolyPatch.H"
#include "wedgePolyPatch.H"
#include "slipFvPatchFields.H"
#include "thermodynamicConstants.H"
#include "completeWrite.H"
#include <algorithm>

namespace Foam
{

static wordList listOf(const std::vector<std::string>& names)
{
    wordList list(label(names.size()));
    forAll(list, i)
    {
        list[i] = names[i];
    }
    return list;
}

} // End namespace Foam


// * * * * * * * * * * * * * * * Set-up  * * * * * * * * * * * * * * * * * * //

void Foam::gasEquations::setClosure()
{
    const IOdictionary& properties = thermo_;
    const dictionary& type = properties.subDict("thermoType");
    const word state(type.get<word>("equationOfState"));
    const word mixture(type.get<word>("mixture"));

    if (state != "perfectGas")
    {
        FatalIOErrorInFunction(type)
            << "equationOfState " << state << " is not a perfect gas." << nl
            << "Valid equationOfState: perfectGas" << exit(FatalIOError);
    }
    if (mixture != "pureMixture")
    {
        FatalIOErrorInFunction(type)
            << "mixture " << mixture << " is not a single gas." << nl
            << "Valid mixture: pureMixture" << exit(FatalIOError);
    }

    // Sample the model of the case over the range of temperatures it can meet
    const word caloric(type.get<word>("thermo"));
    const bool constantHeat = caloric == "hConst" || caloric == "eConst";

    scalar low = 20;
    scalar high = 20000;
    if (!constantHeat)
    {
        const dictionary& thermodynamics =
            properties.subDict("mixture").subDict("thermodynamics");
        low = thermodynamics.getOrDefault<scalar>("Tlow", 50);
        high = thermodynamics.getOrDefault<scalar>("Thigh", 6000);
    }

    const label n = constantHeat ? 1 : label(ceil((high - low)/2));
    scalarField T(n + 1);
    forAll(T, i)
    {
        T[i] = low + i*(high - low)/n;
    }
    const scalarField p(n + 1, 1e5);
    const labelList cells(n + 1, Zero);

    const scalar W = thermo_.W()()[0];
    closure_.R = constant::thermodynamic::RR/W;

    const scalarField he(thermo_.he(p, T, cells));
    const bool enthalpyForm = thermo_.he().name() == "h";

    closureEnergy_.resize(n + 1);
    closureHeat_.resize(n + 1);
    forAll(T, i)
    {
        closureEnergy_[i] =
            he[i] - he[0] - (enthalpyForm ? closure_.R*(T[i] - T[0]) : 0);
    }

    closure_.T0 = low;
    closure_.dT = (high - low)/n;
    closure_.cv = closureEnergy_[n]/(high - low);
    closure_.n = 0;
    closure_.e = nullptr;
    closure_.c = nullptr;

    if (!constantHeat)
    {
        // Specific heat at the nodes: slope of the quartic through five
        // neighbouring energies (the models are polynomials of this order)
        const scalar h = closure_.dT;
        auto slope = [&](const label i)
        {
            const label m = min(max(i, label(2)), n - 2);
            const double* e = &closureEnergy_[m - 2];
            const scalar x = i - m;
            scalar d = 0;
            for (label k = 0; k < 5; k++)
            {
                // Derivative of the Lagrange basis polynomial k at x
                scalar sum = 0;
                for (label j = 0; j < 5; j++)
                {
                    if (j == k)
                    {
                        continue;
                    }
                    scalar product = 1.0/(k - j);
                    for (label l = 0; l < 5; l++)
                    {
                        if (l != k && l != j)
                        {
                            product *= (x - (l - 2))/(k - l);
                        }
                    }
                    sum += product;
                }
                d += sum*e[k];
            }
            return d/h;
        };

        for (label i = 0; i <= n; i++)
        {
            closureHeat_[i] = slope(i);
        }

        // Energy counted so that the gas has none at zero temperature if its
        // specific heat went on as it is at the low end
        const scalar offset = closureHeat_[0]*low;
        for (label i = 0; i <= n; i++)
        {
            closureEnergy_[i] += offset;
        }
        closure_.n = n;
        closure_.e = closureEnergy_.data();
        closure_.c = closureHeat_.data();
    }

    const scalar cv =
        constantHeat
      ? closure_.cv
      : *std::min_element(closureHeat_.begin(), closureHeat_.end());

    if (!(cv > 0) || !(closure_.R > 0))
    {
        FatalIOErrorInFunction(properties)
            << "The gas has no ratio of specific heats: R = " << closure_.R
            << " J/(kg K), smallest Cv = " << cv << " J/(kg K)." << nl
            << "Both must be > 0 (entries molWeight, Cp or Cv)"
            << exit(FatalIOError);
    }
}


void Foam::gasEquations::setTransport()
{
    closure_.As = 0;
    closure_.Ts = 0;
    closure_.mu = 0;
    closure_.Pr = 1;
    if (!viscous_)
    {
        return;
    }

    const IOdictionary& properties = thermo_;
    const dictionary& type = properties.subDict("thermoType");
    const word model(type.get<word>("transport"));
    const dictionary& d = properties.subDict("mixture").subDict("transport");

    auto positive = [&](const word& name)
    {
        const scalar value = d.get<scalar>(name);
        if (!(value > 0))
        {
            FatalIOErrorInFunction(d)
                << "Entry " << name << " is " << value
                << "; its valid range is > 0" << exit(FatalIOError);
        }
        return value;
    };

    if (model == "sutherland")
    {
        closure_.As = positive("As");
        closure_.Ts = positive("Ts");
    }
    else if (model == "const")
    {
        closure_.mu = positive("mu");
        closure_.Pr = positive("Pr");
    }
    else
    {
        FatalIOErrorInFunction(type)
            << "transport " << model << " cannot be used with viscous flow."
            << nl << "Valid transport: const, sutherland"
            << exit(FatalIOError);
    }
}


void Foam::gasEquations::setSchemes()
{
    const dictionary& schemes = mesh_.schemesDict();
    const word fluxName(schemes.getOrDefault<word>("fluxScheme", "HLLC"));
    const int nDim = geometry_.nDim();

    flux_ = selectFlux(fluxName, nDim, closure_.thermallyPerfect());
    robustFlux_ = selectFlux("Kurganov", nDim, closure_.thermallyPerfect());
    sensesShocks_ = fluxName != "Kurganov";
    shocksStay_ = false;
    roughShocks_ = false;
    shocked_.assign(geometry_.nFaces(), 0);

    if (!flux_)
    {
        FatalIOErrorInFunction(schemes)
            << "Unknown fluxScheme " << fluxName << nl
            << "Valid fluxScheme: " << listOf(fluxNames()) << exit(FatalIOError);
    }

    // The reconstruction of all variables shares one limiter; the names of
    // the stock central solver are understood
    const dictionary& interpolation = schemes.subDict("interpolationSchemes");
    word limiter;
    word source;
    for (const word key : {"reconstruct", "reconstruct(rho)", "reconstruct(U)",
        "reconstruct(T)"})
    {
        if (!interpolation.found(key))
        {
            continue;
        }
        word name(interpolation.lookup(key));
        if (name.size() > 1 && name[name.size() - 1] == 'V')
        {
            name = name.substr(0, name.size() - 1);
        }
        if (!selectReconstruction(name))
        {
            FatalIOErrorInFunction(interpolation)
                << "Unknown limiter " << name << " in entry " << key << nl
                << "Valid limiters: " << listOf(reconstructionNames())
                << exit(FatalIOError);
        }
        if (limiter.size() && limiter != name)
        {
            FatalIOErrorInFunction(interpolation)
                << "Limiters differ: " << source << ' ' << limiter << " and "
                << key << ' ' << name << nl
                << "One limiter serves all variables" << exit(FatalIOError);
        }
        limiter = name;
        source = key;
    }
    if (limiter.empty())
    {
        limiter = "vanAlbada";
    }

    reconstruction_ = selectReconstruction(limiter);
    firstOrder_ = selectReconstruction("upwind");

    Info<< "Gas: flux " << fluxName << ", limiter " << limiter << ", "
        << (viscous_ ? "viscous" : "inviscid") << ", "
        << (closure_.thermallyPerfect() ? "thermally" : "calorically")
        << " perfect, R = " << closure_.R << " J/(kg K)";
    if (!closure_.thermallyPerfect())
    {
        Info<< ", gamma = " << 1 + closure_.R/closure_.cv;
    }
    Info<< nl << "Gas: " << geometry_.nDim() << "-D, "
        << returnReduce(geometry_.nCells(), sumOp<label>()) << " cells"
        << endl;
}


void Foam::gasEquations::setPatches()
{
    // Boundary conditions that need nothing beyond p, T, U and phi
    static const wordHashSet selfContained
    {
        "fixedValue", "zeroGradient", "slip", "noSlip", "symmetry",
        "symmetryPlane", "wedge", "empty", "calculated", "cyclic", "processor",
        "processorCyclic", "supersonicFreestream", "freestream",
        "freestreamPressure", "freestreamVelocity", "inletOutlet",
        "outletInlet", "uniformFixedValue", "fixedGradient"
    };

    boundaryNeedsThermo_ = false;
    boolList excluded(mesh_.boundary().size(), false);
    frictionless_.setSize(mesh_.boundary().size(), false);

    for (const gasMesh::patchRange& patch : geometry_.patches())
    {
        const label patchi = patch.patchi;
        const polyPatch& pp = mesh_.boundaryMesh()[patchi];
        const fvPatchVectorField& Up = U_.boundaryField()[patchi];

        const bool wedge = isA<wedgePolyPatch>(pp);
        const bool slip = isA<slipFvPatchVectorField>(Up);
        const bool wall = isA<wallPolyPatch>(pp) || slip;

        impermeable_.push_back(wall || patch.symmetry || wedge);
        excluded[patchi] = wedge || slip || (wall && !viscous_);
        frictionless_[patchi] = wedge || slip || patch.symmetry;

        for
        (
            const word& type :
            {
                Up.type(),
                thermo_.T().boundaryField()[patchi].type(),
                thermo_.p().boundaryField()[patchi].type()
            }
        )
        {
            boundaryNeedsThermo_ =
                boundaryNeedsThermo_ || !selfContained.found(type);
        }
    }
    reduce(boundaryNeedsThermo_, orOp<bool>());

    geometry_.setLeastSquares(excluded);
}


Foam::gasEquations::gasEquations
(
    const fvMesh& mesh,
    fluidThermo& thermo,
    volVectorField& U,
    volScalarField& rho,
    surfaceScalarField& phi,
    const bool viscous
)
:
    mesh_(mesh),
    thermo_(thermo),
    U_(U),
    rho_(rho),
    phi_(phi),
    geometry_(mesh),
    nVar_(geometry_.nDim() + 2),
    viscous_(viscous),
    troubled_(geometry_.nSlots(), 0),
    anyTroubled_(false),
    brokenFace_(-1),
    conserved(geometry_.nCells()*nVar_),
    primitive(geometry_.nSlots()*nVar_),
    rate(geometry_.nCells()*nVar_)
{
    setClosure();
    setTransport();
    setSchemes();
    setPatches();
    gradient_.resize(geometry_.nSlots()*nVar_*geometry_.nDim());
    readFields();
}


// * * * * * * * * * * * * * * * State * * * * * * * * * * * * * * * * * * * //

void Foam::gasEquations::readFields()
{
    const scalarField& p = thermo_.p();
    const scalarField& T = thermo_.T();
    const vectorField& U = U_;
    const int nDim = geometry_.nDim();

    for (label c = 0; c < geometry_.nCells(); c++)
    {
        const bool good =
            p[c] > 0 && p[c] < GREAT && T[c] > 0 && T[c] < GREAT
         && magSqr(U[c]) < GREAT;
        if (!good)
        {
            FatalErrorInFunction
                << "Pressure and temperature must be positive, and all fields"
                << " finite, but cell " << c << " at " << mesh_.C()[c]
                << " holds p = " << p[c] << " Pa, T = " << T[c] << " K, U = "
                << U[c] << " m/s at time " << mesh_.time().timeName()
                << exit(FatalError);
        }

        double* q = &primitive[c*nVar_];
        q[0] = p[c];
        q[1] = T[c];
        for (int d = 0; d < nDim; d++)
        {
            q[2 + d] = U[c][geometry_.direction(d)];
        }
    }

    conserveFromPrimitive();
    correctBoundary();
}


void Foam::gasEquations::conserveFromPrimitive()
{
    const int nDim = geometry_.nDim();

    for (label c = 0; c < geometry_.nCells(); c++)
    {
        const double* q = &primitive[c*nVar_];
        double* w = &conserved[c*nVar_];
        const double e =
            closure_.thermallyPerfect()
          ? closure_.energy<true>(q[1])
          : closure_.energy<false>(q[1]);

        w[0] = q[0]/(closure_.R*q[1]);
        double uu = 0;
        for (int d = 0; d < nDim; d++)
        {
            w[2 + d] = w[0]*q[2 + d];
            uu += q[2 + d]*q[2 + d];
        }
        w[1] = w[0]*(e + 0.5*uu);
    }
}


void Foam::gasEquations::publish()
{
    volScalarField& p = thermo_.p();
    volScalarField& T = thermo_.T();
    const int nDim = geometry_.nDim();

    for (label c = 0; c < geometry_.nCells(); c++)
    {
        const double* q = &primitive[c*nVar_];
        p[c] = q[0];
        T[c] = q[1];
        rho_[c] = q[0]/(closure_.R*q[1]);
        for (int d = 0; d < nDim; d++)
        {
            U_[c][geometry_.direction(d)] = q[2 + d];
        }
    }

    U_.correctBoundaryConditions();
    T.correctBoundaryConditions();
    p.correctBoundaryConditions();

    // Gradients for the pressure on the walls
    correctBoundary();
    if (nDim == 2)
    {
        gradients<2>();
    }
    else
    {
        gradients<3>();
    }

    label k = 0;
    for (const gasMesh::patchRange& patch : geometry_.patches())
    {
        if (impermeable_[k++] && !patch.symmetry)
        {
            scalarField& pp = p.boundaryFieldRef()[patch.patchi];
            forAll(pp, i)
            {
                wallPressure(patch, i, pp[i]);
            }
        }
    }

    forAll(rho_.boundaryField(), patchi)
    {
        rho_.boundaryFieldRef()[patchi] ==
            p.boundaryField()[patchi]
           /(closure_.R*T.boundaryField()[patchi]);
    }

    // Energy and transport properties follow from p and T
    thermo_.he() = thermo_.he(p, T);
    const scalarField keepT(T);
    thermo_.correct();
    static_cast<scalarField&>(T) = keepT;
}


Foam::label Foam::gasEquations::refused(const std::vector<double>& state)
{
    const int nDim = geometry_.nDim();
    label nBad = 0;

    // (A comparison with NaN is false.)
    for (label c = 0; c < geometry_.nCells(); c++)
    {
        const double* w = &state[c*nVar_];
        double mm = 0;
        for (int d = 0; d < nDim; d++)
        {
            mm += w[2 + d]*w[2 + d];
        }
        const bool good =
            w[0] > 0 && w[0] < GREAT && w[1] < VGREAT
         && w[1]*w[0] > 0.5*mm*(1 + 1e-12);
        if (!good)
        {
            troubled_[c] = 1;
            nBad++;
        }
    }

    if (brokenFace_ >= 0)
    {
        troubled_[geometry_.owner[brokenFace_]] = 1;
        nBad++;
    }
    return returnReduce(nBad, sumOp<label>());
}


template<bool Thermally>
void Foam::gasEquations::primitivesOf(const std::vector<double>& state)
{
    const int nDim = geometry_.nDim();

    for (label c = 0; c < geometry_.nCells(); c++)
    {
        const double* w = &state[c*nVar_];
        double* q = &primitive[c*nVar_];
        const double v = 1/w[0];
        double uu = 0;
        for (int d = 0; d < nDim; d++)
        {
            q[2 + d] = w[2 + d]*v;
            uu += q[2 + d]*q[2 + d];
        }
        q[1] = closure_.temperature<Thermally>(w[1]*v - 0.5*uu, q[1]);
        q[0] = w[0]*closure_.R*q[1];
    }
}


void Foam::gasEquations::restore(const std::vector<double>& state)
{
    if (closure_.thermallyPerfect())
    {
        primitivesOf<true>(state);
    }
    else
    {
        primitivesOf<false>(state);
    }
}


Foam::label Foam::gasEquations::accept(const std::vector<double>& state)
{
    // First look, then touch: a refused state leaves the old one whole
    const label nBad = refused(state);
    if (nBad == 0)
    {
        restore(state);
    }

    anyTroubled_ = returnReduce(anyTroubled_ || nBad > 0, orOp<bool>());
    return nBad;
}


void Foam::gasEquations::receive
(
    const vectorField& momentum,
    const scalarField& energy
)
{
    for (label c = 0; c < geometry_.nCells(); c++)
    {
        const double perVolume = 1/geometry_.volume[c];
        double* w = &conserved[c*nVar_];
        w[1] += energy[c]*perVolume;
        for (int d = 0; d < geometry_.nDim(); d++)
        {
            w[2 + d] += momentum[c][geometry_.direction(d)]*perVolume;
        }
    }

    if (accept(conserved) != 0)
    {
        reportTrouble();
    }
    correctBoundary();
}


void Foam::gasEquations::reportTrouble()
{
    label celli = -1;
    forAll(mesh_.C(), c)
    {
        if (troubled_[c])
        {
            celli = c;
            break;
        }
    }

    if (celli >= 0)
    {
        const double* q = &primitive[celli*nVar_];
        Pout<< "Gas: cell " << celli << " at " << mesh_.C()[celli]
            << " at time " << mesh_.time().timeName()
            << " has no finite, positive density and internal energy after a"
            << " step from p = " << q[0] << " Pa, T = " << q[1] << " K"
            << endl;
    }
    if (brokenFace_ >= 0)
    {
        for (const gasMesh::patchRange& patch : geometry_.patches())
        {
            const label i = brokenFace_ - patch.start;
            if (i >= 0 && i < patch.size && !patch.coupled)
            {
                Pout<< "Gas: the boundary condition of patch "
                    << mesh_.boundary()[patch.patchi].name() << " gives face "
                    << i << " at "
                    << mesh_.Cf().boundaryField()[patch.patchi][i]
                    << " no finite velocity, positive pressure and"
                    << " temperature: U = "
                    << U_.boundaryField()[patch.patchi][i] << " m/s, p = "
                    << thermo_.p().boundaryField()[patch.patchi][i]
                    << " Pa, T = "
                    << thermo_.T().boundaryField()[patch.patchi][i] << " K"
                    << endl;
            }
        }
    }

    // Marked as incomplete: to look at, not to restart from
    publish();
    completeWrite::begin(mesh_.time());
    const_cast<Time&>(mesh_.time()).writeNow();
    FatalErrorInFunction
        << "The gas solution broke down at time " << mesh_.time().timeName()
        << "; the last good fields are written there. A smaller maxCo, a"
        << " finer mesh or a more robust limiter (Minmod, upwind) may help."
        << exit(FatalError);
}


void Foam::gasEquations::calm()
{
    if (anyTroubled_)
    {
        std::fill(troubled_.begin(), troubled_.end(), 0);
        anyTroubled_ = false;
    }
}


void Foam::gasEquations::correctBoundary()
{
    volScalarField& p = thermo_.p();
    volScalarField& T = thermo_.T();
    const int nDim = geometry_.nDim();
    const label nCells = geometry_.nCells();
    const label nInternal = geometry_.nInternal();
    brokenFace_ = -1;

    // The boundary conditions read the fields next to the boundary only
    for (label f = nInternal; f < geometry_.nFaces(); f++)
    {
        const label c = geometry_.owner[f];
        const double* q = &primitive[c*nVar_];
        p[c] = q[0];
        T[c] = q[1];
        rho_[c] = q[0]/(closure_.R*q[1]);
        for (int d = 0; d < nDim; d++)
        {
            U_[c][geometry_.direction(d)] = q[2 + d];
        }
    }

    if (boundaryNeedsThermo_)
    {
        thermo_.he() = thermo_.he(p, T);
        const scalarField keepT(T);
        thermo_.correct();
        static_cast<scalarField&>(T) = keepT;
    }

    for (const gasMesh::patchRange& patch : geometry_.patches())
    {
        if (patch.coupled || patch.symmetry)
        {
            continue;
        }
        const label patchi = patch.patchi;
        U_.boundaryFieldRef()[patchi].evaluate();
        T.boundaryFieldRef()[patchi].evaluate();
        p.boundaryFieldRef()[patchi].evaluate();
        rho_.boundaryFieldRef()[patchi] ==
            p.boundaryField()[patchi]
           /(closure_.R*T.boundaryField()[patchi]);

        const fvPatchVectorField& Up = U_.boundaryField()[patchi];
        const fvPatchScalarField& Tp = T.boundaryField()[patchi];
        const fvPatchScalarField& pp = p.boundaryField()[patchi];
        double* q = &primitive[(nCells + patch.start - nInternal)*nVar_];
        for (label i = 0; i < patch.size; i++, q += nVar_)
        {
            const bool good =
                pp[i] > 0 && pp[i] < GREAT && Tp[i] > 0 && Tp[i] < GREAT
             && magSqr(Up[i]) < GREAT;
            if (!good)
            {
                // Refused at the next step, with all ranks knowing
                brokenFace_ = patch.start + i;
                continue;
            }
            q[0] = pp[i];
            q[1] = Tp[i];
            for (int d = 0; d < nDim; d++)
            {
                q[2 + d] = Up[i][geometry_.direction(d)];
            }
        }
    }

    for (const gasMesh::patchRange& patch : geometry_.patches())
    {
        if (!patch.symmetry)
        {
            continue;
        }
        for (label f = patch.start; f < patch.start + patch.size; f++)
        {
            const double* q = &primitive[geometry_.owner[f]*nVar_];
            const double* n = &geometry_.normal[f*nDim];
            double* g = &primitive[geometry_.far[f]*nVar_];
            double un = 0;
            for (int d = 0; d < nDim; d++)
            {
                un += q[2 + d]*n[d];
            }
            g[0] = q[0];
            g[1] = q[1];
            for (int d = 0; d < nDim; d++)
            {
                g[2 + d] = q[2 + d] - 2*un*n[d];
            }
        }
    }

    geometry_.exchange(primitive.data(), nVar_);
}


namespace Foam
{

//- Whether the pressure rises along the flow by a large part of itself within
//  the distance delta between two cells: the face lies in a shock
template<int nDim>
inline bool inShock
(
    const double* owner,
    const double* far,
    const double* gradientOwner,
    const double* gradientFar,
    const double* delta
)
{
    double gg[2] = {0, 0};
    double dd = 0;
    double ug[2] = {0, 0};
    for (int d = 0; d < nDim; d++)
    {
        const double g0 = gradientOwner[d*(nDim + 2)];
        const double g1 = gradientFar[d*(nDim + 2)];
        gg[0] += g0*g0;
        gg[1] += g1*g1;
        ug[0] += owner[2 + d]*g0;
        ug[1] += far[2 + d]*g1;
        dd += delta[d]*delta[d];
    }
    return
        max(ug[0] > 0 ? gg[0] : 0, ug[1] > 0 ? gg[1] : 0)*dd
      > sqr(0.2*min(owner[0], far[0]));
}

} // End namespace Foam


// * * * * * * * * * * * * * * * Rates * * * * * * * * * * * * * * * * * * * //

template<int nDim>
void Foam::gasEquations::gradients()
{
    constexpr int nVar = nDim + 2;
    const label nInternal = geometry_.nInternal();
    const label nFaces = geometry_.nFaces();

    std::fill(gradient_.begin(), gradient_.end(), 0);

    const double* __restrict q = primitive.data();
    double* __restrict g = gradient_.data();

    for (label f = 0; f < nFaces; f++)
    {
        const double* qo = q + geometry_.owner[f]*nVar;
        const double* qf = q + geometry_.far[f]*nVar;
        double jump[nVar];
        for (int k = 0; k < nVar; k++)
        {
            jump[k] = qf[k] - qo[k];
        }

        double* go = g + geometry_.owner[f]*(nVar*nDim);
        const double* lo = &geometry_.lsqOwner[f*nDim];
        for (int d = 0; d < nDim; d++)
        {
            for (int k = 0; k < nVar; k++)
            {
                go[d*nVar + k] += lo[d]*jump[k];
            }
        }

        if (f < nInternal)
        {
            double* gf = g + geometry_.far[f]*(nVar*nDim);
            const double* lf = &geometry_.lsqFar[f*nDim];
            for (int d = 0; d < nDim; d++)
            {
                for (int k = 0; k < nVar; k++)
                {
                    gf[d*nVar + k] += lf[d]*jump[k];
                }
            }
        }
    }

    geometry_.exchange(g, nVar*nDim);
}


void Foam::gasEquations::replaceFluxes
(
    faceBlock& block,
    const int n,
    const bool* which
) const
{
    double keep[faceBlock::maxVar][faceBlock::size];
    std::copy(&block.flux[0][0], &block.flux[nVar_ - 1][0] + n, &keep[0][0]);

    robustFlux_(block, n, closure_);

    for (int k = 0; k < nVar_; k++)
    {
        for (int i = 0; i < n; i++)
        {
            block.flux[k][i] = which[i] ? block.flux[k][i] : keep[k][i];
        }
    }
}


template<int nDim>
void Foam::gasEquations::innerFluxes()
{
    constexpr int nVar = nDim + 2;
    const double* __restrict q = primitive.data();
    const double* __restrict g = gradient_.data();
    faceBlock block;

    auto blockOfFaces = [&](const label first, const int n)
    {
        bool troubledBlock = false;
        bool troubledFace[faceBlock::size];
        bool shockedBlock = false;
        bool shock[faceBlock::size];

        for (int i = 0; i < n; i++)
        {
            const label f = first + i;
            const int o = geometry_.owner[f];
            const int r = geometry_.far[f];
            const double* qo = q + o*nVar;
            const double* qr = q + r*nVar;
            const double* go = g + o*(nVar*nDim);
            const double* gr = g + r*(nVar*nDim);
            const double* delta = &geometry_.delta[f*nDim];
            double so[nVar];
            double sr[nVar];
            for (int k = 0; k < nVar; k++)
            {
                so[k] = 2*delta[0]*go[k];
                sr[k] = 2*delta[0]*gr[k];
            }
            for (int d = 1; d < nDim; d++)
            {
                for (int k = 0; k < nVar; k++)
                {
                    so[k] += 2*delta[d]*go[d*nVar + k];
                    sr[k] += 2*delta[d]*gr[d*nVar + k];
                }
            }
            for (int k = 0; k < nVar; k++)
            {
                block.owner[k][i] = qo[k];
                block.far[k][i] = qr[k];
                block.slopeOwner[k][i] = so[k];
                block.slopeFar[k][i] = sr[k];
            }
            block.weight[i] = geometry_.weight[f];
            for (int d = 0; d < nDim; d++)
            {
                block.normal[d][i] = geometry_.normal[f*nDim + d];
            }
            shock[i] =
                sensesShocks_
             && (
                    (shocksStay_ && shocked_[f])
                 || inShock<nDim>(qo, qr, go, gr, delta)
                );
            shocked_[f] = shock[i];
            shockedBlock = shockedBlock || shock[i];
            troubledFace[i] = anyTroubled_ && (troubled_[o] || troubled_[r]);
            troubledBlock = troubledBlock || troubledFace[i];
        }

        reconstruction_(block, n, nVar);
        flux_(block, n, closure_);

        if (shockedBlock)
        {
            if (roughShocks_)
            {
                firstOrder_(block, n, nVar);
            }
            replaceFluxes(block, n, shock);
        }
        if (troubledBlock)
        {
            firstOrder_(block, n, nVar);
            replaceFluxes(block, n, troubledFace);
        }

        for (int i = 0; i < n; i++)
        {
            const label f = first + i;
            const double S = geometry_.area[f];
            double* ro = &rate[geometry_.owner[f]*nVar];
            if (f < geometry_.nInternal())
            {
                double* rf = &rate[geometry_.far[f]*nVar];
                for (int k = 0; k < nVar; k++)
                {
                    const double F = block.flux[k][i]*S;
                    ro[k] -= F;
                    rf[k] += F;
                }
                phi_[f] = block.flux[0][i]*S;
            }
            else
            {
                for (int k = 0; k < nVar; k++)
                {
                    ro[k] -= block.flux[k][i]*S;
                }
            }
        }
    };

    auto range = [&](label first, const label end)
    {
        for (; first < end; first += faceBlock::size)
        {
            blockOfFaces(first, min(label(faceBlock::size), end - first));
        }
    };

    range(0, geometry_.nInternal());
    for (const gasMesh::patchRange& patch : geometry_.patches())
    {
        if (patch.coupled)
        {
            range(patch.start, patch.start + patch.size);
        }
    }
}


void Foam::gasEquations::wallPressure
(
    const gasMesh::patchRange& patch,
    const label i,
    double& p
) const
{
    const int nDim = geometry_.nDim();
    const label f = patch.start + i;
    const label c = geometry_.owner[f];
    const double* g = &gradient_[c*nVar_*nDim];
    double change = 0;
    for (int d = 0; d < nDim; d++)
    {
        change += g[d*nVar_]*geometry_.toFace[f*nDim + d];
    }

    // In the first instants of an impulsive start the pressure next to the
    // wall varies by more than itself
    const double pc = primitive[c*nVar_];
    p = pc + max(-0.5*pc, min(0.5*pc, change));
}


template<int nDim>
void Foam::gasEquations::boundaryFluxes()
{
    constexpr int nVar = nDim + 2;

    label k = 0;
    for (const gasMesh::patchRange& patch : geometry_.patches())
    {
        const bool wall = impermeable_[k++];
        if (patch.coupled)
        {
            continue;
        }
        scalarField& phip = phi_.boundaryFieldRef()[patch.patchi];

        for (label i = 0; i < patch.size; i++)
        {
            const label f = patch.start + i;
            const label c = geometry_.owner[f];
            const double* n = &geometry_.normal[f*nDim];
            const double S = geometry_.area[f];
            double flux[nVar];

            if (wall)
            {
                double p;
                wallPressure(patch, i, p);
                const double* q = &primitive[geometry_.far[f]*nVar];
                double un = 0;
                for (int d = 0; d < nDim && !patch.symmetry; d++)
                {
                    un += q[2 + d]*n[d];
                }
                flux[0] = 0;
                flux[1] = p*un;
                for (int d = 0; d < nDim; d++)
                {
                    flux[2 + d] = p*n[d];
                }
            }
            else
            {
                exactFlux
                (
                    &primitive[geometry_.far[f]*nVar], n, nDim, closure_, flux
                );
            }

            phip[i] = flux[0]*S;
            for (int j = 0; j < nVar; j++)
            {
                rate[c*nVar + j] -= flux[j]*S;
            }
        }
    }
}


template<int nDim>
void Foam::gasEquations::viscousFlux
(
    const label f,
    const double share,
    const double* gradientFar
)
{
    constexpr int nVar = nDim + 2;
    const double* qo = &primitive[geometry_.owner[f]*nVar];
    const double* qf = &primitive[geometry_.far[f]*nVar];
    const double* go = &gradient_[geometry_.owner[f]*(nVar*nDim)];
    const double* gf = gradientFar;
    const double* delta = &geometry_.delta[f*nDim];
    const double* n = &geometry_.normal[f*nDim];

    double dd = 0;
    for (int d = 0; d < nDim; d++)
    {
        dd += delta[d]*delta[d];
    }

    // Mean gradient of temperature and velocity, with its part along the line
    // of centres replaced by the difference over it
    double g[nDim][nVar];
    double q[nVar];
    for (int k = 1; k < nVar; k++)
    {
        double along = 0;
        for (int d = 0; d < nDim; d++)
        {
            g[d][k] = (1 - share)*go[d*nVar + k] + share*gf[d*nVar + k];
            along += g[d][k]*delta[d];
        }
        const double defect = (qf[k] - qo[k] - along)/dd;
        for (int d = 0; d < nDim; d++)
        {
            g[d][k] += defect*delta[d];
        }
        q[k] = (1 - share)*qo[k] + share*qf[k];
    }

    const double T = q[1];
    const double mu = closure_.viscosity(T);
    const double lambda =
        closure_.thermallyPerfect()
      ? closure_.conductivity<true>(mu, T)
      : closure_.conductivity<false>(mu, T);

    double divU = 0;
    for (int d = 0; d < nDim; d++)
    {
        divU += g[d][2 + d];
    }

    double flux[nVar];
    flux[1] = 0;
    for (int d = 0; d < nDim; d++)
    {
        double stress = -2.0/3*divU*n[d];
        for (int k = 0; k < nDim; k++)
        {
            stress += (g[k][2 + d] + g[d][2 + k])*n[k];
        }
        flux[2 + d] = -mu*stress;
        flux[1] += flux[2 + d]*q[2 + d] - lambda*g[d][1]*n[d];
    }

    const double S = geometry_.area[f];
    double* ro = &rate[geometry_.owner[f]*nVar];
    const bool inner = f < geometry_.nInternal();
    double* rf = inner ? &rate[geometry_.far[f]*nVar] : nullptr;
    for (int k = 1; k < nVar; k++)
    {
        ro[k] -= flux[k]*S;
        if (inner)
        {
            rf[k] += flux[k]*S;
        }
    }
}


template<int nDim>
void Foam::gasEquations::viscousFluxes()
{
    constexpr int width = (nDim + 2)*nDim;
    auto far = [&](const label f)
    {
        return &gradient_[geometry_.far[f]*width];
    };

    for (label f = 0; f < geometry_.nInternal(); f++)
    {
        viscousFlux<nDim>(f, geometry_.weight[f], far(f));
    }

    for (const gasMesh::patchRange& patch : geometry_.patches())
    {
        for (label f = patch.start; f < patch.start + patch.size; f++)
        {
            if (patch.coupled)
            {
                viscousFlux<nDim>(f, geometry_.weight[f], far(f));
            }
            else if (!frictionless_[patch.patchi])
            {
                // State of the face, gradient of the cell
                viscousFlux<nDim>
                (
                    f, 1, &gradient_[geometry_.owner[f]*width]
                );
            }
        }
    }
}


void Foam::gasEquations::computeRate()
{
    std::fill(rate.begin(), rate.end(), 0);

    if (anyTroubled_)
    {
        // Ranks must agree on the faces they share
        std::vector<double> flag(geometry_.nSlots());
        for (label c = 0; c < geometry_.nCells(); c++)
        {
            flag[c] = troubled_[c];
        }
        geometry_.exchange(flag.data(), 1);
        for (label s = geometry_.nCells(); s < geometry_.nSlots(); s++)
        {
            troubled_[s] = flag[s] > 0.5;
        }
    }

    if (geometry_.nDim() == 2)
    {
        gradients<2>();
        innerFluxes<2>();
        boundaryFluxes<2>();
        if (viscous_)
        {
            viscousFluxes<2>();
        }
    }
    else
    {
        gradients<3>();
        innerFluxes<3>();
        boundaryFluxes<3>();
        if (viscous_)
        {
            viscousFluxes<3>();
        }
    }
}


void Foam::gasEquations::soundSpeed(std::vector<double>& a) const
{
    a.resize(geometry_.nSlots());
    for (label s = 0; s < geometry_.nSlots(); s++)
    {
        const double T = primitive[s*nVar_ + 1];
        a[s] = std::sqrt
        (
            closure_.thermallyPerfect()
          ? closure_.soundSpeedSqr<true>(T)
          : closure_.soundSpeedSqr<false>(T)
        );
    }
}


void Foam::gasEquations::faceSpectralRadius(std::vector<double>& lambda) const
{
    const int nDim = geometry_.nDim();
    soundSpeed(soundSpeed_);
    lambda.resize(geometry_.nFaces());

    for (label f = 0; f < geometry_.nFaces(); f++)
    {
        const label o = geometry_.owner[f];
        const label r = geometry_.far[f];
        const double* n = &geometry_.normal[f*nDim];
        const double* qo = &primitive[o*nVar_ + 2];
        const double* qr = &primitive[r*nVar_ + 2];
        double uo = 0;
        double ur = 0;
        for (int d = 0; d < nDim; d++)
        {
            uo += qo[d]*n[d];
            ur += qr[d]*n[d];
        }
        lambda[f] =
            max(mag(uo) + soundSpeed_[o], mag(ur) + soundSpeed_[r])
           *geometry_.area[f];

        if (viscous_)
        {
            const double* state = &primitive[r*nVar_];
            const double T = state[1];
            const double mu = closure_.viscosity(T);
            const double density = state[0]/(closure_.R*T);
            const double cv =
                closure_.thermallyPerfect()
              ? closure_.specificHeat<true>(T)
              : closure_.cv;
            const double lambdaT =
                closure_.thermallyPerfect()
              ? closure_.conductivity<true>(mu, T)
              : closure_.conductivity<false>(mu, T);
            lambda[f] +=
                2*max(4.0/3*mu, lambdaT/cv)/density
               *geometry_.area[f]/geometry_.normalDistance[f];
        }
    }
}


void Foam::gasEquations::spectralRadius(std::vector<double>& lambda) const
{
    faceSpectralRadius(faceLambda_);
    lambda.assign(geometry_.nCells(), 0);

    for (label f = 0; f < geometry_.nFaces(); f++)
    {
        lambda[geometry_.owner[f]] += faceLambda_[f];
        if (f < geometry_.nInternal())
        {
            lambda[geometry_.far[f]] += faceLambda_[f];
        }
    }
}


Foam::scalar Foam::gasEquations::imbalance() const
{
    const int nDim = geometry_.nDim();
    soundSpeed(soundSpeed_);

    // Sums over cells: |rates| of mass, momentum and energy, and the
    // mass-weighted means of |u| + a and H that scale the last two
    FixedList<scalar, 8> sums(Zero);
    enum {mass, momentum, energy, weight, speed, enthalpy, inflow, acoustic};

    for (label c = 0; c < geometry_.nCells(); c++)
    {
        const double* R = &rate[c*nVar_];
        const double* w = &conserved[c*nVar_];
        const double* q = &primitive[c*nVar_];
        double mm = 0;
        double uu = 0;
        for (int d = 0; d < nDim; d++)
        {
            mm += R[2 + d]*R[2 + d];
            uu += q[2 + d]*q[2 + d];
        }
        const double m = w[0]*geometry_.volume[c];
        sums[mass] += mag(R[0]);
        sums[momentum] += std::sqrt(mm);
        sums[energy] += mag(R[1]);
        sums[weight] += m;
        sums[speed] += m*(std::sqrt(uu) + soundSpeed_[c]);
        sums[enthalpy] += m*(w[1] + q[0])/w[0];
    }

    for (const gasMesh::patchRange& patch : geometry_.patches())
    {
        if (!patch.coupled)
        {
            for (const scalar m : phi_.boundaryField()[patch.patchi])
            {
                sums[inflow] -= min(m, scalar(0));
            }
        }
    }
    for (label f = 0; f < geometry_.nInternal(); f++)
    {
        const label o = geometry_.owner[f];
        sums[acoustic] +=
            conserved[o*nVar_]*soundSpeed_[o]*geometry_.area[f];
    }

    for (scalar& sum : sums)
    {
        reduce(sum, sumOp<scalar>());
    }

    // A closed domain is measured by the mass that crosses its faces at the
    // speed of sound
    const scalar flow = sums[inflow] > 0 ? sums[inflow] : sums[acoustic];

    return
        max
        (
            sums[mass],
            max
            (
                sums[momentum]*sums[weight]/sums[speed],
                sums[energy]*sums[weight]/sums[enthalpy]
            )
        )
       /flow;
}
