/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "basicSpinningCloud.H"
#include "checked.H"
#include "CoreDragForce.H"
#include "GravityForce.H"
#include "MagnusForce.H"
#include "NonInertialFrameForce.H"
#include "NonSphereDragForce.H"
#include "PressureGradientForce.H"
#include "SaffmanMeiLiftForce.H"
#include "SphereDragForce.H"
#include "sphereDrag.H"
#include "SRFForce.H"
#include "SRFModel.H"
#include "uniformDimensionedFields.H"
#include "VirtualMassForce.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::basicSpinningCloud::setFrame
(
    const dictionary& coeffs,
    impact::secondaryForces& forces
) const
{
    bool any = false;
    const auto take = [&]
    (
        const word& entry,
        const dimensionSet& dimensions,
        impact::vector3& value
    )
    {
        const word name(coeffs.getOrDefault<word>(entry, entry));
        const auto* object =
            mesh().findObject<uniformDimensionedVectorField>
            (
                name
            );
        IOobject header
        (
            name, db().time().constant(), mesh(),
            IOobject::MUST_READ
        );
        if
        (
            !object
         && header.typeHeaderOk<uniformDimensionedVectorField>(true)
        )
        {
            object = &regIOobject::store
            (
                new uniformDimensionedVectorField(header)
            );
        }
        if (!object)
        {
            if (coeffs.found(entry))
            {
                refuse
                (
                    coeffs, entry.c_str(), name,
                    "the name of an object, or of a file in constant"
                );
            }
            return;
        }
        if (object->dimensions() != dimensions)
        {
            FatalIOErrorInFunction(coeffs)
                << "particle force nonInertialFrame: " << name << " has the"
                << " dimensions " << object->dimensions() << ", valid for "
                << entry << ": " << dimensions << exit(FatalIOError);
        }
        any = true;
        value = toCore(object->value());
    };
    take("linearAcceleration", dimAcceleration, forces.acceleration);
    take("angularVelocity", dimless/dimTime, forces.Omega);
    take("angularAcceleration", dimless/sqr(dimTime), forces.OmegaDot);
    take("centreOfRotation", dimLength, forces.centre);
    if (!any)
    {
        FatalIOErrorInFunction(coeffs)
            << "particle force nonInertialFrame: there is neither an object"
            << " nor a file constant/linearAcceleration, angularVelocity,"
            << " angularAcceleration or centreOfRotation (or as the entries of"
            << " these names say)" << exit(FatalIOError);
    }
}


void Foam::basicSpinningCloud::setRotatingFrame
(
    const dictionary& coeffs,
    impact::secondaryForces& forces
) const
{
    const word name("SRFProperties");
    const auto* model =
        mesh().findObject<SRF::SRFModel>(name);
    if (!model)
    {
        IOobject header
        (
            name, db().time().constant(), mesh(),
            IOobject::MUST_READ
        );
        if (!header.typeHeaderOk<IOdictionary>(true))
        {
            FatalIOErrorInFunction(coeffs)
                << "particle force SRF: there is no file constant/" << name
                << exit(FatalIOError);
        }
        model = &regIOobject::store(SRF::SRFModel::New(U()).ptr());
    }
    if (forces.framed())
    {
        FatalIOErrorInFunction(coeffs)
            << "particle forces SRF and nonInertialFrame: valid is one of them"
            << exit(FatalIOError);
    }
    forces.buoyantFrame = true;
    forces.Omega = toCore(model->omega().value());
    forces.centre = toCore(model->origin().value());
}


Foam::basicSpinningCloud::coreForces
Foam::basicSpinningCloud::coreForcesOf()
{
    typedef CoreDragForce<kinematicCloudType> dragType;
    static const impact::sphereDrag stockDrag;

    coreForces core;
    for (const auto& force : forces())
    {
        if (isA<MagnusForce<kinematicCloudType>>(force))
        {
            core.magnus = true;
        }
        else if (isA<GravityForce<kinematicCloudType>>(force))
        {
            core.gravity = true;
        }
        else if (isA<VirtualMassForce<kinematicCloudType>>(force))
        {
            core.secondary.virtualMass = force.coeffs().getScalar("Cvm");
        }
        else if (isA<PressureGradientForce<kinematicCloudType>>(force))
        {
            core.secondary.pressureGradient = true;
        }
        else if (isA<SaffmanMeiLiftForce<kinematicCloudType>>(force))
        {
            core.secondary.shearLift = true;
        }
        else if (isA<NonInertialFrameForce<kinematicCloudType>>(force))
        {
            setFrame(force.coeffs(), core.secondary);
        }
        else if (isA<SRFForce<kinematicCloudType>>(force))
        {
            setRotatingFrame(force.coeffs(), core.secondary);
        }
        else if (core.drag)
        {
            core.all = false;
        }
        else
        {
            if (const auto* law = dynamic_cast<const dragType*>(&force))
            {
                core.gas = law->gas();
                if (law->uniformGas())
                {
                    core.drag = &law->drag();
                    core.gammaR = law->gammaR();
                }
            }
            else if (isA<SphereDragForce<kinematicCloudType>>(force))
            {
                core.drag = &stockDrag;
            }
            else if (isA<NonSphereDragForce<kinematicCloudType>>(force))
            {
                if (!nonSphereDrag_)
                {
                    impact::dragLaw::coefficients c;
                    c.numbers["sphericity"] = force.coeffs().getScalar("phi");
                    nonSphereDrag_ =
                        impact::dragLaw::New("haiderLevenspielDrag", c);
                }
                core.drag = nonSphereDrag_.get();
            }
            core.all = core.all && core.drag;
        }
    }
    return core;
}
