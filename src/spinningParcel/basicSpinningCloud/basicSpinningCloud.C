/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "basicSpinningCloud.H"
#include "checked.H"
#include "eventDrivenCollisions.H"
#include "MagnusForce.H"
#include "NonInertialFrameForce.H"
#include "StochasticDispersion.H"
#include "SRFForce.H"
#include "stepToFace.H"
#include "stockCloudEntries.H"
#include "wallImpacts.H"
#include "withheldOutput.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::basicSpinningCloud::setModels()
{
    const dictionary& solution = this->solution().dict();
    stockCloudEntries::checkSolution
    (
        solution, {"rotation", "motion", "collisions", "heatTransfer"}
    );
    if (this->solution().coupled() && this->solution().steadyState())
    {
        refuse
        (
            solution, "coupled", "yes", "no with transient no: parcels of a"
            " steady track are particles per second, the sources those of a"
            " step. In a steady gas the block feedback of constant/"
            "highSpeedGasDict closes the coupling with transient yes"
        );
    }
    // What heat transfer reads may stay where it is switched off, but not
    // where nothing would read it
    wordList properties({"omega0"});
    wordList models({"rotationalTorqueModel"});
    const dictionary& constants =
        particleProperties().subDict("constantProperties");
    if (solution.found("heatTransfer"))
    {
        properties.append(heatTransfer::properties);
        models.append("heatTransferModel");
    }
    else
    {
        for (const word& entry : heatTransfer::properties)
        {
            if (constants.found(entry))
            {
                FatalIOErrorInFunction(constants)
                    << "Entry " << entry << " is read by heat transfer alone."
                    << nl << "Add 'heatTransfer on;' to the block solution, or"
                    << " remove the entry" << exit(FatalIOError);
            }
        }
    }
    stockCloudEntries::checkProperties(constants, properties);
    stockCloudEntries::checkModels(subModelProperties(), models);
    rotation_ = solution.lookupOrDefault<Switch>("rotation", true);
    const word torque
    (
        getWordOf
        (
            subModelProperties(), "rotationalTorqueModel",
            "rotationalTorque", {"none", "rotationalTorque"}
        )
    );
    Info<< "Selecting rotational torque model " << torque << endl;
    torque_ = torque != "none";

    const wordList motions{"stock", "embeddedRK54"};
    const dictionary* coeffs = solution.findDict("motion");
    if (coeffs)
    {
        refuseOthers(*coeffs, {"type", "tolerance"});
    }
    const word motion
    (
        coeffs
      ? getWordOf(*coeffs, "type", "", motions)
      : getWord(solution, "motion", motions)
    );

    if (motion == "stock" && coeffs && coeffs->found("tolerance"))
    {
        refuse
        (
            *coeffs, "tolerance", coeffs->get<scalar>("tolerance"),
            "none with motion stock, which has no error control"
        );
    }
    if (motion == "embeddedRK54")
    {
        const scalar tolerance =
            coeffs
          ? getNumber(*coeffs, "tolerance", "[1e-14, 0.1]", scalar(1e-5))
          : 1e-5;
        embedded_.reset(new impact::particleMotion(tolerance));
        checkEmbedded();
        Info<< "Selecting parcel motion embeddedRK54, tolerance " << tolerance
            << ", gas " << gas_->scheme() << endl;
    }

    if (solution.lookupOrDefault<Switch>("heatTransfer", false))
    {
        if (!embedded_.valid())
        {
            refuse
            (
                solution, "heatTransfer", "on", "off with motion stock, on"
                " with motion embeddedRK54"
            );
        }
        heat_.reset
        (
            new heatTransfer(particleProperties(), mesh())
        );
        heat_->update();
        wallImpacts::New(*this).setMaterial(heat_->material());
        Info<< "Selecting heat transfer model " << heat_->law() << endl;
    }
    else if
    (
        subModelProperties().isDict("heatTransferModel")
     || subModelProperties().getOrDefault<word>
        (
            "heatTransferModel", "none"
        ) != "none"
    )
    {
        // Right or refused, though switched off
        heatTransfer(particleProperties(), mesh());
    }

    if (isA<StochasticDispersion<kinematicCloudType>>(dispersion()))
    {
        if (!embedded_.valid())
        {
            refuse
            (
                subModelProperties(), "dispersionModel",
                subModelProperties().get<word>
                    ("dispersionModel"),
                "none with motion stock, this with motion embeddedRK54"
            );
        }
        eddies_.reset
        (
            new turbulentDispersion(U(), subModelProperties())
        );
    }

    arrays().follow(rotation_, heat_.valid(), eddies_.valid());
    Info<< "Parcels of ";
    if (embedded_.valid())
    {
        Info<< arrays().bytes() << " bytes in arrays, as objects of ";
    }
    Info<< label(sizeof(parcelType)) << " bytes" << endl;
    impact::secondaryForces frame;
    for (const auto& force : forces())
    {
        if (isA<NonInertialFrameForce<kinematicCloudType>>(force))
        {
            setFrame(force.coeffs(), frame);
        }
    }
    for (const auto& force : forces())
    {
        if (isA<SRFForce<kinematicCloudType>>(force))
        {
            setRotatingFrame(force.coeffs(), frame);
        }
    }
    if (!rotation_)
    {
        // A force that is nothing need not be asked for each parcel
        auto& forces = this->forces();
        label kept = 0;
        forAll(forces, i)
        {
            if (!isA<MagnusForce<kinematicCloudType>>(forces[i]))
            {
                if (kept != i)
                {
                    forces.set(kept, forces.release(i));
                }
                ++kept;
            }
        }
        const bool magnus = kept < forces.size();
        forces.resize(kept);
        Info<< "Parcels without rotation: no torque"
            << (magnus ? " and no Magnus force" : "") << endl;
    }
}


void Foam::basicSpinningCloud::setCollisions()
{
    const dictionary& solution = this->solution().dict();
    const dictionary* coeffs = solution.findDict("collisions");
    const wordList types{"off", "eventDriven"};
    const word type
    (
        coeffs
      ? getWordOf(*coeffs, "type", "", types)
      : getWord(solution, "collisions", types)
    );
    if (type == "eventDriven")
    {
        collisions_.reset
        (
            new eventDrivenCollisions
            (
                *this,
                coeffs ? *coeffs : dictionary(solution, dictionary())
            )
        );
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::basicSpinningCloud::basicSpinningCloud
(
    const word& cloudName,
    const volScalarField& rho,
    const volVectorField& U,
    const volScalarField& mu,
    const dimensionedVector& g,
    bool readFields
)
:
    kinematicCloudType(cloudName, rho, U, mu, g, false),
    ETrans_
    (
        new volScalarField::Internal
        (
            IOobject
            (
                name() + ":ETrans",
                db().time().timeName(),
                db(),
                IOobject::READ_IF_PRESENT,
                solution().coupled()
              ? IOobject::AUTO_WRITE
              : IOobject::NO_WRITE
            ),
            mesh(),
            dimensionedScalar(dimEnergy, Zero)
        )
    )
{
    if (solution().active())
    {
        setModels();

        if (readFields)
        {
            parcelType::readFields(*this);
            checkPlaces();
            readFlights();
            deleteLostParticles();
            checkTemperatures();
            checkIdentities();
        }
        setCollisions();
    }

    if (solution().resetSourcesOnStartup())
    {
        resetSourceTerms();
    }
}


Foam::basicSpinningCloud::basicSpinningCloud
(
    const fvMesh& mesh,
    const word& name,
    const basicSpinningCloud& c
)
:
    kinematicCloudType(mesh, name, c),
    rotation_(c.rotation_)
{}


Foam::basicSpinningCloud::~basicSpinningCloud() = default;


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::basicSpinningCloud::nRefused() const
{
    return collisions_.valid() ? collisions_->nRefused() : 0;
}


void Foam::basicSpinningCloud::evolve()
{
    if (solution().canEvolve())
    {
        // The tracking data refer to it
        updateCurl();
        parcelType::trackingData td(*this);

        solve(*this, td);
    }
}


void Foam::basicSpinningCloud::info()
{
    if (withheldOutput::now())
    {
        // What counts the steps, without the sums over all parcels
        foamCompat::info(patchInteraction());
        if (collisions_.valid())
        {
            collisions_->info();
        }
        return;
    }

    kinematicCloudType::info();

    const auto total = [](const scalar x)
    {
        return returnReduce(x, sumOp<scalar>());
    };
    if (rotation_)
    {
        Info<< "    Rotational kinetic energy       = "
            << total(rotationalEnergyOfSystem()) << nl;
        const scalar nMagnus = total(counts_.magnus);
        if (nMagnus > 0)
        {
            Info<< "    Magnus force beyond Re "
                << impact::magnusLift::ReMax << " (its fit)  = "
                << 100*total(counts_.magnusOutside)/nMagnus << " % of "
                << nMagnus << nl;
        }
        const scalar nTorque = total(counts_.torque);
        if (nTorque > 0)
        {
            Info<< "    Torque beyond spin Re "
                << impact::rotationalTorque::ReMax << " (its fit) = "
                << 100*total(counts_.torqueOutside)/nTorque << " % of "
                << nTorque << nl;
        }
    }
    if (heat_.valid())
    {
        scalar enthalpy = 0, massTimesT = 0;
        for (const parcelType& p : *this)
        {
            const scalar mass = p.nParticle()*p.mass();
            enthalpy += mass*heat_->material().h(p.temperature());
            massTimesT += mass*p.temperature();
        }
        const scalar mass = total(massInSystem());

        // An account closes to round-off with all its digits only
        const int digits = Sout.precision(IOstream::defaultPrecision());
        Info<< "    Mean temperature                = "
            << total(massTimesT)/max(mass, VSMALL) << nl
            << "    Enthalpy                        = " << total(enthalpy)
            << nl
            << "    Heat from the gas, radiated     = "
            << total(statistics_.heat) << ", " << total(statistics_.radiated)
            << nl;
        Sout.precision(digits);
    }
    if (collisions_.valid())
    {
        collisions_->info();
    }
    if (embedded_.valid())
    {
        const scalar nSteps = total(statistics_.nSteps);
        const scalar nSlides = total(statistics_.nSlides);
        Info<< "    Sub-steps, forces per sub-step  = " << nSteps << ", "
            << total(statistics_.nForces)/max(nSteps, scalar(1)) << nl
            << "    Most forces between two faces   = "
            << returnReduce(statistics_.maxForces, maxOp<scalar>()) << nl
            << "    uncontrolled, at rest           = "
            << total(statistics_.nForced) << ", " << total(statistics_.nPauses)
            << nl;
        if (nSlides > 0)
        {
            Info<< "    Ways along faces between cells  = " << nSlides << nl;
        }
        const scalar heaviest =
            returnReduce(statistics_.heaviest, maxOp<scalar>());
        if (heaviest > 0)
        {
            Info<< "    Heaviest parcel / gas of cell   = " << heaviest << nl;
        }
        const scalar time = total(statistics_.time);
        const scalar forced = total(statistics_.forcedTime);
        if (forced > 0.01*time && !warnedOfForced_)
        {
            warnedOfForced_ = true;
            WarningInFunction
                << 100*forced/time << " % of the time of the parcels of "
                << name() << " has been followed without error control: "
                << stepToFace::maxForces << " evaluations of the forces between"
                << " two faces of cells were not enough" << nl
                << "    Set a larger tolerance of the motion, or a smaller"
                << " deltaT" << endl;
        }
    }
    if (eddies_.valid())
    {
        const scalar nEddies = total(eddies_->nEddies());
        Info<< "    Eddies met, taken together      = " << nEddies << ", "
            << 100*total(eddies_->nTogether())/max(nEddies, scalar(1)) << " %"
            << nl;
    }
}
