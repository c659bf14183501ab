/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.

Application
    wallModelCost

Description
    CPU time of one call of each wall model of a case, beside stock rebound.

    constant/wallModelCost names models: a list of (name dictionary), each
    dictionary with patchInteractionModel, its coefficients, and 'calls'.
    Parcels of different identities sit on the patch 'plate' and strike it
    again and again at each of 'incidences' (degrees) with 'speed'. Prints name,
    incidence, microseconds per call and microseconds above stock rebound,
    which must be the first. With 'histograms', a list of numbers of calls, it
    prints instead, for every model but the first, name, incidence, number of
    calls, CPU seconds and how many rebounded into each of 36 intervals of 5
    degrees from the plate.
\*---------------------------------------------------------------------------*/

#include "IFstream.H"
#include "argList.H"
#include "basicKinematicCollidingCloud.H"
#include "fvMesh.H"
#include "unitConversion.H"
#include "volFields.H"

#include <ctime>

using namespace Foam;

namespace
{

double cpuSeconds()
{
    timespec t;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return double(t.tv_sec) + 1e-9*double(t.tv_nsec);
}


//- Writes the properties of a cloud with a wall model
void writeProperties(const Time& time, const word& cloud, const dictionary& m)
{
    IFstream is(time.constant()/"cloudProperties");
    dictionary dict(is);
    dict.subDict("subModels").merge(m);
    OFstream os(time.constant()/(cloud + "Properties"));
    os.precision(17);
    os  << "FoamFile{version 2.0; format ascii; class dictionary; object "
        << cloud << "Properties;}" << nl;
    dict.write(os, false);
}


//- Clouds that differ in their wall model alone, and parcels at the plate
class plateImpacts
{
    typedef basicKinematicCollidingCloud cloudType;
    typedef cloudType::parcelType parcelType;

    PtrList<cloudType> clouds_;
    wordList names_;
    labelList calls_;
    PtrList<parcelType> parcels_;
    PtrList<parcelType> atPlate_;
    const polyPatch& plate_;


public:

    plateImpacts
    (
        const dictionary& list,
        const volScalarField& rho,
        const volVectorField& U,
        const volScalarField& mu
    )
    :
        plate_(U.mesh().boundaryMesh()["plate"])
    {
        const fvMesh& mesh = U.mesh();
        const dimensionedVector g("g", dimAcceleration, Zero);
        for (const entry& e : list.subDict("models"))
        {
            names_.append(e.keyword());
            calls_.append(e.dict().get<label>("calls"));
            writeProperties(mesh.time(), e.keyword(), e.dict());
            clouds_.append(new cloudType(e.keyword(), rho, U, mu, g));
        }

        // Parcels on their way to the plate, brought to it
        const scalar d(list.get<scalar>("d"));
        const point start(list.get<point>("start"));
        for (label i = 0; i < 64; ++i)
        {
            parcels_.append
            (
                new parcelType
                (
                    mesh, start + vector(0, 0, 1e-4*i), mesh.findCell(start)
                )
            );
            parcelType& p = parcels_[i];
            p.track(vector(0, -1, 0), 1);
            if (!p.onBoundaryFace() || p.patch() != plate_.index())
            {
                FatalErrorInFunction
                    << "A parcel has not come to the plate"
                    << exit(FatalError);
            }
            p.d() = d;
            p.rho() = 2500;
            p.nParticle() = 1;
            p.active(true);
            atPlate_.append(new parcelType(p));
        }
    }

    //- A parcel on the plate strikes it, the n-th time of all
    vector strike(const label c, const vector& U0, const label n)
    {
        parcelType& p = parcels_[n & 63];
        bool keep = true;
        p.U() = U0;
        p.angularMomentum() = Zero;
        p.origId() = n;
        clouds_[c].patchInteraction().correct(p, plate_, keep);
        const vector U1(p.U());

        // One that was left sliding has been lifted off the plate
        if (!p.onBoundaryFace())
        {
            parcels_.set(n & 63, new parcelType(atPlate_[n & 63]));
        }
        return U1;
    }

    //- Angles of so many impacts each in bins of 5 deg, and their time
    void histograms
    (
        const scalar incidence,
        const vector& U0,
        const labelList& numbers
    )
    {
        for (label c = 1; c < clouds_.size(); ++c)
        {
            label first = 0;
            for (const label n : numbers)
            {
                labelList counts(36, Zero);
                const double begin = cpuSeconds();
                for (label i = 0; i < n; ++i)
                {
                    const vector U1(strike(c, U0, first + i));
                    const scalar degrees =
                        radToDeg(std::atan2(U1.y(), U1.x()));
                    ++counts[max(0, min(35, label(degrees/5)))];
                }
                std::printf
                (
                    "HISTOGRAM %s %g %d %.4f",
                    names_[c].c_str(), incidence, n, cpuSeconds() - begin
                );
                for (const label count : counts)
                {
                    std::printf(" %d", count);
                }
                std::printf("\n");
                first += n;
            }
        }
    }

    //- Time of an impact [us], and what it is above that of the first model
    void times(const scalar incidence, const vector& U0)
    {
        double rebound = 0;
        forAll(clouds_, c)
        {
            const double begin = cpuSeconds();
            for (label i = 0; i < calls_[c]; ++i)
            {
                strike(c, U0, i);
            }
            const double each = 1e6*(cpuSeconds() - begin)/calls_[c];
            if (c == 0)
            {
                rebound = each;
            }
            std::printf
            (
                "RESULT %s %g %.4f %.4f\n",
                names_[c].c_str(), incidence, each, each - rebound
            );
        }
    }
};

} // End anonymous namespace


int main(int argc, char* argv[])
{
    argList args(argc, argv);
    Time time(Time::controlDictName, args);
    const fvMesh mesh
    (
        IOobject(fvMesh::defaultRegion, time.timeName(), time,
            IOobject::MUST_READ)
    );
    const volVectorField U
    (
        IOobject("U", time.timeName(), mesh, IOobject::MUST_READ), mesh
    );
    const volScalarField rho
    (
        IOobject("rho", time.timeName(), mesh), mesh,
        dimensionedScalar("rho", dimDensity, 1)
    );
    const volScalarField mu
    (
        IOobject("mu", time.timeName(), mesh), mesh,
        dimensionedScalar("mu", dimDynamicViscosity, 1e-5)
    );

    IFstream is(time.constant()/"wallModelCost");
    const dictionary list(is);
    plateImpacts impacts(list, rho, U, mu);
    const scalar speed(list.get<scalar>("speed"));
    const labelList histograms
    (
        list.getOrDefault<labelList>("histograms", labelList())
    );
    for (const scalar incidence : list.get<scalarList>("incidences"))
    {
        const scalar angle = degToRad(incidence);
        const vector U0(speed*vector(Foam::cos(angle), -Foam::sin(angle), 0));
        if (histograms.size())
        {
            impacts.histograms(incidence, U0, histograms);
        }
        else
        {
            impacts.times(incidence, U0);
        }
    }
    return 0;
}
