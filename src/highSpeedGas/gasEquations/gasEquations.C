/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "gasEquations.H"
#include "checked.H"
#include "completeWrite.H"
#include <algorithm>
#include <array>
#include <utility>

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


//- Refuse entries that are nearly those read here, which stock files may
//  hold beside many others
static void refuseMisspelt(const dictionary& schemes)
{
    const auto differs = [](const word& a, const word& b)
    {
        return a != b && spellingDistance(a, b) <= 2;
    };
    const auto refuse = []
    (
        const dictionary& d, const word& key, const word& meant
    )
    {
        FatalIOErrorInFunction(d)
            << "Unknown entry " << key << nl
            << "Did you mean " << meant << '?' << exit(FatalIOError);
    };
    for (const word& key : schemes.toc())
    {
        if (differs(key, "fluxScheme"))
        {
            refuse(schemes, key, "fluxScheme");
        }
    }
    const dictionary& d = schemes.subDict("interpolationSchemes");
    for (const entry& e : d)
    {
        const word& key = e.keyword();
        if (e.keyword().isPattern())
        {
            continue;
        }
        const auto bracket = key.find('(');
        const word stem(key.substr(0, bracket));
        const string of(bracket == word::npos ? "" : key.substr(bracket));
        for (const char* valid : {"", "(p)", "(rho)", "(T)", "(U)"})
        {
            const word meant("reconstruct" + string(valid));
            if
            (
                spellingDistance(of, valid) == 0 && key != meant
             && (stem == "reconstruct" || differs(stem, "reconstruct"))
            )
            {
                refuse(d, key, meant);
            }
        }
    }
}


//- The limiter that the first entry found of the given ones names
static word readLimiter
(
    const dictionary& schemes,
    const wordList& keys,
    const word& otherwise
)
{
    const dictionary& interpolation = schemes.subDict("interpolationSchemes");
    for (const word& key : keys)
    {
        if (!interpolation.found(key))
        {
            continue;
        }

        ITstream& is = interpolation.lookup(key);
        word name(is);

        // The limiters of vectors are applied to each component
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

        if (is.nRemainingTokens() > 0)
        {
            const scalar coefficient = readScalar(is);
            const bool hasCoefficient =
                name == "limitedLinear" || name == "limitedCubic";
            if (!hasCoefficient || coefficient != 1 || is.nRemainingTokens())
            {
                FatalIOErrorInFunction(interpolation)
                    << "Entry " << key << ": limiter " << name
                    << " with coefficient " << coefficient << nl
                    << "limitedLinear and limitedCubic take the coefficient 1"
                    << " (or none), the other limiters none"
                    << exit(FatalIOError);
            }
        }
        return name;
    }
    return otherwise;
}

} // End namespace Foam


void Foam::gasEquations::setSchemes(const bool steady)
{
    const dictionary& schemes = mesh_.schemesDict();
    refuseMisspelt(schemes);
    const word fluxName(schemes.getOrDefault<word>("fluxScheme", "HLLC"));
    const int nDim = geometry_.nDim();

    flux_ = selectFlux(fluxName, nDim, eos_.thermallyPerfect());
    robustFlux_ = shockFlux(nDim, eos_.thermallyPerfect());
    sensesShocks_ = fluxName != "Kurganov" && fluxName != "Tadmor";

    // A shock that crosses mesh lines leaves a wake of errors where states
    // within it are not uniform, the more so the stronger it is; a weak one
    // would only be smeared. A steady state has flattenShocks() for this.
    flatFrom_ = steady || !sensesShocks_ ? GREAT : strongRise;

    if (!flux_)
    {
        FatalIOErrorInFunction(schemes)
            << "Unknown fluxScheme " << fluxName << nl
            << "Valid fluxScheme: " << listOf(fluxNames())
            << exit(FatalIOError);
    }

    // The stock central solver reconstructs density, temperature and velocity;
    // here pressure takes the limiter of the density
    const std::array<wordList, 3> keys
    {{
        {"reconstruct(p)", "reconstruct(rho)", "reconstruct"},
        {"reconstruct(T)", "reconstruct"},
        {"reconstruct(U)", "reconstruct"}
    }};
    const int ends[3] = {1, 2, nVar_};
    word limiters[3];

    // In time the limiter of the stock central solver's tutorials, which loses
    // less at edges; it is not smooth enough for a steady state to come to rest
    const word otherwise(steady ? "vanAlbada" : "vanLeer");
    reconstruction_.clear();
    for (int i = 0; i < 3; i++)
    {
        limiters[i] = readLimiter(schemes, keys[i], otherwise);
        if (i > 0 && limiters[i] == limiters[i - 1])
        {
            reconstruction_.back().end = ends[i];
        }
        else
        {
            reconstruction_.push_back
            (
                {
                    selectReconstruction(limiters[i]),
                    i > 0 ? ends[i - 1] : 0,
                    ends[i]
                }
            );
        }
    }
    firstOrder_ = selectReconstruction("upwind");

    word limiter(limiters[0]);
    if (reconstruction_.size() > 1)
    {
        limiter =
            limiters[0] + " (p), " + limiters[1] + " (T), " + limiters[2]
          + " (U)";
    }

    Info<< "Gas: flux " << fluxName << ", limiter " << limiter << ", "
        << (viscous_ ? "viscous" : "inviscid") << ", "
        << (eos_.thermallyPerfect() ? "thermally" : "calorically")
        << " perfect, R = " << eos_.R << " J/(kg K)";
    if (!eos_.thermallyPerfect())
    {
        Info<< ", gamma = " << 1 + eos_.R/eos_.cv;
    }
    Info<< nl << "Gas: " << geometry_.nDim() << "-D"
        << (geometry_.inSection() ? ", axisymmetric without swirl" : "")
        << ", " << returnReduce(geometry_.nCells(), sumOp<label>())
        << " cells" << endl;
    if (steady && limiter.find("vanLeer") != std::string::npos)
    {
        Info<< "Gas: with limiter vanLeer the way to a steady state takes"
            << " longer than with vanAlbada, the default of mode steady"
            << endl;
    }
}


Foam::gasEquations::gasEquations
(
    const fvMesh& mesh,
    fluidThermo& thermo,
    volVectorField& U,
    volScalarField& rho,
    surfaceScalarField& phi,
    const bool viscous,
    const bool inTime,
    const bool steady,
    const bool restarts
)
:
    mesh_(mesh),
    thermo_(thermo),
    U_(U),
    rho_(rho),
    phi_(phi),
    geometry_(mesh, swirls(U)),
    nVar_(geometry_.nDim() + 2),
    boundaryNeedsProperties_(false),
    readsAllCells_(false),
    marching_(false),
    transportKnown_(false),
    energyOffset_(0),
    lowestT_(0),
    highestT_(GREAT),
    warnedOfTemperature_(false),
    viscous_(viscous),
    inTime_(inTime),
    turbulence_(geometry_, rho, U, phi, thermo, viscous),
    nCutEddies_(0),
    passed_(0),
    rough_(false),
    invalid_(geometry_.nSlots(), 0),
    anyInvalid_(false),
    brokenFace_(-1),
    coupled_(false),
    conserved(geometry_.nCells()*nVar_),
    primitive(geometry_.nSlots()*nVar_),
    rate(geometry_.nCells()*nVar_)
{
    setEquationOfState();
    setTransport();
    setSchemes(steady);
    setPatches(steady);
    properties_.reset
    (
        new gasProperties(thermo_, eos_, energyOffset_, transportKnown_)
    );
    gradient_.resize(geometry_.nSlots()*nVar_*geometry_.nDim());
    readFields(restarts);
    if (!sensesShocks_ && sticks())
    {
        Info<< "Gas: the central fluxes make layers of friction thicker: with"
            << " 15 cells across one, heat flux is 30 % too high where that of"
            << " HLLC is within 5 %" << endl;
    }
}


template<class Field>
void Foam::gasEquations::evaluateCoupled(Field& field)
{
    auto& boundary = field.boundaryFieldRef();
    const label startOfRequests = Pstream::nRequests();
    for (auto& patch : boundary)
    {
        if (patch.coupled())
        {
            patch.initEvaluate(Pstream::commsTypes::nonBlocking);
        }
    }
    if (Pstream::parRun())
    {
        Pstream::waitRequests(startOfRequests);
    }
    for (auto& patch : boundary)
    {
        if (patch.coupled())
        {
            patch.evaluate(Pstream::commsTypes::nonBlocking);
        }
    }
}


void Foam::gasEquations::readFields(const bool asWritten)
{
    const scalarField& p = thermo_.p();
    const scalarField& T = thermo_.T();
    const vectorField& U = U_;
    const int nDim = geometry_.nDim();

    forAll(p, c)
    {
        const bool good =
            p[c] > 0 && p[c] < GREAT && T[c] > 0 && T[c] < GREAT
         && magSqr(U[c]) < GREAT;
        if (!good)
        {
            FatalErrorInFunction
                << "Pressure and temperature must be positive, and all fields"
                << " finite, but cell " << c << " at " << mesh_.cellCentres()[c]
                << " holds p = " << p[c] << " Pa, T = " << T[c] << " K, U = "
                << U[c] << " m/s at time " << mesh_.time().timeName()
                << exit(FatalError);
        }

        double* q = &primitive[geometry_.cellOf[c]*nVar_];
        q[0] = p[c];
        q[1] = T[c];
        for (int d = 0; d < nDim; d++)
        {
            q[2 + d] = U[c][geometry_.direction(d)];
        }
    }

    if (asWritten)
    {
        evaluateCoupled(thermo_.p());
        evaluateCoupled(thermo_.T());
        evaluateCoupled(U_);
    }

    // A restart knows nothing but the fields
    std::fill(gradient_.begin(), gradient_.end(), 0);
    conserveFromPrimitive();
    initialiseFlux();
    if (asWritten)
    {
        // A zero gradient writes no value: the reconstructed one of a wall is
        // not in the file
        for (fvPatchScalarField& pp : thermo_.p().boundaryFieldRef())
        {
            if (pp.type() == "zeroGradient")
            {
                pp.evaluate();
            }
        }
        takeBoundary();
    }
    else
    {
        correctBoundary();
    }
}


void Foam::gasEquations::conserveFromPrimitive()
{
    const int nDim = geometry_.nDim();

    for (label c = 0; c < geometry_.nCells(); c++)
    {
        const double* q = &primitive[c*nVar_];
        double* w = &conserved[c*nVar_];
        const double e =
            eos_.thermallyPerfect()
          ? eos_.energy<true>(q[1])
          : eos_.energy<false>(q[1]);

        w[0] = q[0]/(eos_.R*q[1]);
        double uu = 0;
        for (int d = 0; d < nDim; d++)
        {
            w[2 + d] = w[0]*q[2 + d];
            uu += q[2 + d]*q[2 + d];
        }
        w[1] = w[0]*(e + 0.5*uu);
    }
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
            invalid_[c] = 1;
            nBad++;
        }
    }

    if (brokenFace_ >= 0)
    {
        invalid_[geometry_.owner[brokenFace_]] = 1;
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
        q[1] = eos_.temperature<Thermally>(w[1]*v - 0.5*uu, q[1]);
        q[0] = w[0]*eos_.R*q[1];
    }
}


void Foam::gasEquations::restore(const std::vector<double>& state)
{
    if (eos_.thermallyPerfect())
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

    anyInvalid_ = returnReduce(anyInvalid_ || nBad > 0, orOp<bool>());
    return nBad;
}


void Foam::gasEquations::receive
(
    const vectorField& momentum,
    const scalarField& energy
)
{
    coupled_ = true;
    for (label c = 0; c < geometry_.nCells(); c++)
    {
        const label celli = geometry_.meshCell[c];
        const double perVolume = 1/geometry_.volume[c];
        double* w = &conserved[c*nVar_];
        w[1] += energy[celli]*perVolume;
        for (int d = 0; d < geometry_.nDim(); d++)
        {
            w[2 + d] += momentum[celli][geometry_.direction(d)]*perVolume;
        }
    }

    if (accept(conserved) != 0)
    {
        reportInvalidCells();
    }
    correctBoundary();
}


void Foam::gasEquations::setSources
(
    const vectorField& force,
    const scalarField& power
)
{
    coupled_ = true;
    source_.assign(rate.size(), 0);
    sourcePressure_.resize(geometry_.nCells());
    for (label c = 0; c < geometry_.nCells(); c++)
    {
        const label celli = geometry_.meshCell[c];
        sourcePressure_[c] = primitive[c*nVar_];
        double* s = &source_[c*nVar_];
        s[1] = power[celli];
        for (int d = 0; d < geometry_.nDim(); d++)
        {
            s[2 + d] = force[celli][geometry_.direction(d)];
        }
    }
}


void Foam::gasEquations::reportInvalidCells()
{
    label celli = -1;
    forAll(mesh_.cellCentres(), c)
    {
        if (invalid_[geometry_.cellOf[c]])
        {
            celli = c;
            break;
        }
    }

    if (celli >= 0)
    {
        const double* q = &primitive[geometry_.cellOf[celli]*nVar_];
        Pout<< "Gas: cell " << celli << " at " << mesh_.cellCentres()[celli]
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

    reportOpenPatches(false);

    // Marked as incomplete: to look at, not to restart from. What a run
    // started from stays as it is
    const Time& time = mesh_.time();
    const bool written = time.value() != time.startTime().value();
    if (written)
    {
        publish();
        completeWrite::begin(time);
        const_cast<Time&>(time).writeNow();
    }

    // The first rank that stops ends the others, whatever they are writing:
    // all wait here
    const label rank = returnReduce
    (
        celli >= 0 ? Pstream::myProcNo() : Pstream::nProcs(), minOp<label>()
    );
    const point place = returnReduce
    (
        rank == Pstream::myProcNo() ? mesh_.cellCentres()[celli] : point(Zero),
        sumOp<point>()
    );
    OStringStream where;
    if (rank < Pstream::nProcs())
    {
        where << " The cell at " << place << " has no possible gas.";
    }
    FatalErrorInFunction
        << "The gas solution broke down at time " << time.timeName()
        << (
               written
             ? "; the last good fields are written there."
             : ", whose files stay as they were."
           )
        << where.str().c_str()
        << " Where warnings above name patches mend those first. A smaller"
        << " maxCo, a finer mesh or a more robust limiter (Minmod, upwind) may"
        << " help"
        << (
               coupled_
             ? ", or a shorter time step, lighter parcels (weighting radial in"
               " wedges), sourceSmoothing or a smaller relaxation in feedback."
             : "."
           )
        << exit(FatalError);
}


bool Foam::gasEquations::calm()
{
    if (anyInvalid_)
    {
        std::fill(invalid_.begin(), invalid_.end(), 0);
    }
    return std::exchange(anyInvalid_, false);
}


void Foam::gasEquations::surroundShocks()
{
    if (!sensesShocks_)
    {
        return;
    }
    robustFlux_ =
        selectFlux("Kurganov", geometry_.nDim(), eos_.thermallyPerfect());
    surroundings_.use(geometry_.nSlots());
    for (int i = 0; i < shockSurroundings::reach; i++)
    {
        computeRate();
    }
}


void Foam::gasEquations::computeRate()
{
    setSoundShare();
    if (source_.empty())
    {
        std::fill(rate.begin(), rate.end(), 0);
    }
    else
    {
        for (label c = 0; c < geometry_.nCells(); c++)
        {
            const double share = sourceShare(c);
            for (int k = 0; k < nVar_; k++)
            {
                rate[c*nVar_ + k] = share*source_[c*nVar_ + k];
            }
        }
    }

    if (anyInvalid_)
    {
        // Ranks must agree on the faces they share
        std::vector<double> flag(geometry_.nSlots());
        for (label c = 0; c < geometry_.nCells(); c++)
        {
            flag[c] = invalid_[c];
        }
        geometry_.exchange(flag.data(), 1);
        for (label s = geometry_.nCells(); s < geometry_.nSlots(); s++)
        {
            invalid_[s] = flag[s] > 0.5;
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
