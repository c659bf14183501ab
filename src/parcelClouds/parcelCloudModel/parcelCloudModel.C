/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "parcelCloudModel.H"
#include "checked.H"
#include "presentFile.H"
#include "processorTime.H"
#include "stockCloudEntries.H"
#include "IOdictionary.H"
#include "Time.H"
#include "uniformDimensionedFields.H"

#include <cstdlib>
#include <dlfcn.h>
#include <sstream>

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    defineTypeNameAndDebug(parcelCloudModel, 0);
    defineRunTimeSelectionTable(parcelCloudModel, gas);
}


namespace
{

using namespace Foam;

//- Refuse a model of ours whose library is not loaded, which the stock clouds
//  call unknown
void findLibraries(const dictionary& dict)
{
    static const HashTable<string> libraryOf
    {
        {"crossSectionInjection", "parcelInjection"},
        {"rakeInjection", "parcelInjection"},
        {"hendersonDrag", "parcelForces"},
        {"lothDrag", "parcelForces"},
        {"singhDrag", "parcelForces"},
        {"haiderLevenspielDrag", "parcelForces"},
        {"holzerSommerfeldDrag", "parcelForces"},
        {"ganserDrag", "parcelForces"},
        {"hardSphereWall", "parcelWallInteraction"},
        {"semiEmpiricalRebound", "parcelWallInteraction"},
        {"nonSphericalRebound", "parcelWallInteraction"},
        {"jkrAdhesion", "parcelWallInteraction"},
        {"surfaceImpact", "parcelWallInteraction"},
        {"impactRecords", "parcelWallInteraction"},
        {"dispersedPhase", "parcelWallInteraction"}
    };
    for (const entry& e : dict)
    {
        if (e.isDict())
        {
            findLibraries(e.dict());
        }
        word model;
        if (dict.dictName() == "particleForces")
        {
            model = e.keyword();
        }
        else if (!e.isDict() && (e.keyword() == "type"
         || e.keyword() == "patchInteractionModel"))
        {
            const ITstream& is = e.stream();
            model = is.size() && is[0].isWord() ? is[0].wordToken() : word();
        }
        const auto library = libraryOf.cfind(model);
        if
        (
            library.found()
         && !::dlopen
            (
                ("lib" + library.val() + ".so").c_str(),
                RTLD_LAZY | RTLD_NOLOAD
            )
        )
        {
            FatalIOErrorInFunction(dict)
                << "Unknown "
                << (e.keyword() == model ? dict.dictName() : word(e.keyword()))
                << ' ' << model << nl
                << model << " is in the library " << library.val().c_str()
                << ": add libs (" << library.val().c_str()
                << "); to system/controlDict, or choose the cloud's type"
                << " spinningKinematicCloud, which has it"
                << exit(FatalIOError);
        }
    }
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::parcelCloudModel::parcelCloudModel()
:
    cpuTime_(0),
    nParcelSteps_(0),
    before_{}
{}


namespace Foam
{

//- A file in constant that is read once
IOobject constantFile(const word& name, const fvMesh& mesh)
{
    return IOobject
    (
        name,
        mesh.time().constant(),
        mesh,
        IOobject::MUST_READ,
        IOobject::NO_WRITE,
        false
    );
}


//- Clouds are given no gravity if there is no file of it
void refuseGravityWithout(const dictionary& forces, const fvMesh& mesh)
{
    IOobject g(parcelCloudModel::gravity(mesh));
    if (forces.found("gravity") && !isPresent<uniformDimensionedVectorField>(g))
    {
        FatalIOErrorInFunction(forces)
            << "Force gravity needs the file constant/g, e.g. with"
            << " dimensions [0 1 -2 0 0 0 0]; value (0 0 -9.81);"
            << exit(FatalIOError);
    }
}


//- The stock cloud would give up its own time where the schemes are steady
void refuseSteadySchemes(const dictionary& solution, const fvMesh& mesh)
{
    if (solution.getOrDefault<Switch>("transient", false) && mesh.steady())
    {
        const dictionary& schemes = mesh.schemesDict().subDict("ddtSchemes");
        FatalIOErrorInFunction(schemes)
            << "Entry default steadyState: the parcels of "
            << solution.name() << " move in time ('transient"
            << " yes;')." << nl
            << "Set 'default Euler;', and for eddies of a steady gas"
            << " 'ddt(rho,k) steadyState;' and the like. The gas is steady by"
            << " 'mode steady;' in system/fvSolution" << exit(FatalIOError);
    }
}

} // End namespace Foam


// * * * * * * * * * * * * * * * * Selectors * * * * * * * * * * * * * * * * //

Foam::IOobject Foam::parcelCloudModel::properties
(
    const word& name,
    const fvMesh& mesh
)
{
    return constantFile(name + "Properties", mesh);
}


Foam::IOobject Foam::parcelCloudModel::gravity(const fvMesh& mesh)
{
    return constantFile("g", mesh);
}


Foam::autoPtr<Foam::parcelCloudModel> Foam::parcelCloudModel::New
(
    const word& name,
    const volScalarField& rho,
    const volVectorField& U,
    const volScalarField& mu,
    const dimensionedVector& g
)
{
    const IOdictionary properties
    (
        parcelCloudModel::properties(name, rho.mesh())
    );
    const dictionary forces
    (
        properties.subOrEmptyDict("subModels").subOrEmptyDict("particleForces")
    );
    refuseGravityWithout(forces, rho.mesh());
    stockCloudEntries::refuseSecondDrag(forces);
    stockCloudEntries::refuseCoefficients(forces);
    refuseOthers
    (
        properties,
        {
            "type", "solution", "constantProperties", "subModels",
            "cloudFunctions"
        }
    );
    for
    (
        const char* block
      : {"constantProperties", "subModels", "cloudFunctions"}
    )
    {
        findBlock(properties, block);
    }
    const word type
    (
        properties.lookupOrDefault<word>("type", "basicKinematicCloud")
    );

    auto constructor = gasConstructorTablePtr_->cfind(type);
    if (!constructor.found())
    {
        unknownWord
        (
            properties, "type", type, gasConstructorTablePtr_->sortedToc(),
            type == "spinningKinematicCloud"
          ? ". It is in the library spinningParcel: add libs (spinningParcel);"
            " to system/controlDict" : ""
        );
    }
    stockCloudEntries::checkNumbers(properties);
    stockCloudEntries::checkSchemes(properties.subDict("solution"));
    refuseSteadySchemes(properties.subDict("solution"), rho.mesh());
    if (type != "spinningKinematicCloud")
    {
        findLibraries(properties);
    }
    // Beside those of the basicKinematicCloud: entries of constantProperties
    // and subModels
    static const HashTable<Pair<wordList>> stock
    ({
        {"basicKinematicCloud", {{}, {}}},
        {
            // (in braces alone a word is taken for a switch of the pair)
            "basicKinematicCollidingCloud",
            {wordList(), wordList{"collisionModel"}}
        },
        {
            "basicThermoCloud",
            {
                {"T0", "TMin", "TMax", "Cp0", "epsilon0", "f0"},
                {"heatTransferModel"}
            }
        }
    });
    if (stock.found(type))
    {
        stockCloudEntries::checkSolution(properties.subDict("solution"), {});
        stockCloudEntries::checkProperties
        (
            properties.subOrEmptyDict("constantProperties"),
            stock[type].first()
        );
        stockCloudEntries::checkModels
        (
            properties.subOrEmptyDict("subModels"),
            stock[type].second()
        );
    }

    Info<< "Cloud " << name << " (" << type << ")" << endl;
    autoPtr<parcelCloudModel> cloud(constructor()(name, rho, U, mu, g));
    cloud->before_ = cloud->balance();
    return cloud;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::parcelCloudModel::evolve()
{
    {
        const processorTime timer(cpuTime_);
        advance();
    }
    nParcelSteps_ += nParcels();
}


bool Foam::parcelCloudModel::readFates
(
    const std::string& report,
    scalar& escaped,
    scalar& stuck
)
{
    // The fates of the system count impacts on patches that are no walls,
    // whatever becomes of the parcel: those of the patches tell it
    bool ofPatch = false;
    bool told = false;
    std::istringstream lines(report);
    for (std::string line; std::getline(lines, line);)
    {
        if (line.find("Parcel fate:") != std::string::npos)
        {
            ofPatch = line.find("patch") != std::string::npos;
            told = told || ofPatch;
        }
        const std::size_t equals = line.find('=');
        if (ofPatch && equals != std::string::npos)
        {
            const scalar n = std::strtod(line.c_str() + equals + 1, nullptr);
            escaped += line.find("- escape") < equals ? n : 0;
            stuck += line.find("- stick") < equals ? n : 0;
        }
    }
    return told;
}


Foam::runSummary::balance Foam::parcelCloudModel::balance()
{
    runSummary::balance b{};
    b.name = name();
    b.injected = nInjected();
    b.inFlight = returnReduce(nActive(), sumOp<label>());
    b.fatesKnown = returnReduce(readFates(b.escaped, b.stuck), orOp<bool>());
    reduce(b.escaped, sumOp<scalar>());
    reduce(b.stuck, sumOp<scalar>());
    return b;
}


void Foam::parcelCloudModel::account(runSummary& summary)
{
    summary.part("cloud " + name(), cpuTime_);
    summary.work(name(), nParcelSteps_, cpuTime_);
    runSummary::balance b(balance());
    b.start = before_.inFlight;
    b.injected -= before_.injected;
    b.escaped -= before_.escaped;
    b.stuck -= before_.stuck;
    if (b.fatesKnown && b.lost() != 0)
    {
        WarningInFunction
            << "Cloud " << name() << ": " << label(b.lost())
            << " parcels are gone,"
            << " and no wall model tells how. They leave through patches that"
            << " are no walls and on which no model acts ('type none;'), and"
            << " are lost where patches that are coupled (cyclicAMI) do not"
            << " fit; cloud functions may remove them, too." << endl;
    }
    summary.particles(b);
}
