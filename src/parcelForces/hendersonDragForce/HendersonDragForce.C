/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "HendersonDragForce.H"
#include "checked.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

template<class CloudType>
const Foam::fluidThermo& Foam::HendersonDragForce<CloudType>::thermo() const
{
    if (!this->mesh().template foundObject<fluidThermo>(thermoName_))
    {
        FatalIOErrorInFunction(this->coeffs())
            << "hendersonDrag needs the gas temperature and ratio of specific"
            << " heats. Entry thermo " << thermoName_
            << " is no compressible fluid thermophysical model of region "
            << this->mesh().name() << ": valid range "
            << this->mesh().template sortedNames<fluidThermo>()
            << " (an incompressible solver has none)"
            << exit(FatalIOError);
    }

    return this->mesh().template lookupObject<fluidThermo>(thermoName_);
}


template<class CloudType>
bool Foam::HendersonDragForce<CloudType>::upToDate
(
    const fluidThermo& thermo
) const
{
    return
        thermo.T().eventNo() == TEvent_
     && thermo.p().eventNo() == pEvent_
     && !this->mesh().changing();
}


template<class CloudType>
void Foam::HendersonDragForce<CloudType>::updateGas(const fluidThermo& thermo)
{
    const tmp<volScalarField> tgamma(thermo.gamma());
    const volScalarField& gamma = tgamma();
    const volScalarField& psi = thermo.psi();
    const volScalarField& T = thermo.T();

    // Round-off of R = 1/(psi T) and of Cp/Cv must not count as variation
    const scalar tolerance = 1e-10;
    scalar gammaMin = GREAT, gammaMax = -GREAT;
    scalar gammaRMin = GREAT, gammaRMax = -GREAT;
    const auto extend =
        [&]
        (
            const scalarField& gammas,
            const scalarField& psis,
            const scalarField& Ts
        )
        {
            forAll(gammas, i)
            {
                const scalar gammaR = gammas[i]/(psis[i]*Ts[i]);
                gammaMin = min(gammaMin, gammas[i]);
                gammaMax = max(gammaMax, gammas[i]);
                gammaRMin = min(gammaRMin, gammaR);
                gammaRMax = max(gammaRMax, gammaR);
            }
        };
    extend(gamma.primitiveField(), psi.primitiveField(), T.primitiveField());
    forAll(gamma.boundaryField(), patchi)
    {
        extend
        (
            gamma.boundaryField()[patchi],
            psi.boundaryField()[patchi],
            T.boundaryField()[patchi]
        );
    }
    reduce(gammaMin, minOp<scalar>());
    reduce(gammaMax, maxOp<scalar>());
    reduce(gammaRMin, minOp<scalar>());
    reduce(gammaRMax, maxOp<scalar>());

    aSqrInterp_.clear();
    gammaInterp_.clear();

    uniformGas_ =
        gammaMax - gammaMin <= tolerance*gammaMax
     && gammaRMax - gammaRMin <= tolerance*gammaRMax;

    if (uniformGas_)
    {
        gammaR_ = 0.5*(gammaRMin + gammaRMax);
        drag_ = impact::hendersonDrag(0.5*(gammaMin + gammaMax), TwOverT_);
        aSqr_.clear();
        gamma_.clear();
    }
    else
    {
        const word prefix(this->owner().name() + ":hendersonDrag:");
        aSqr_.clear();
        gamma_.clear();
        aSqr_.reset(new volScalarField(prefix + "aSqr", gamma/psi));
        gamma_.reset(new volScalarField(prefix + "gamma", gamma));
    }

    TEvent_ = T.eventNo();
    pEvent_ = thermo.p().eventNo();
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

template<class CloudType>
Foam::HendersonDragForce<CloudType>::HendersonDragForce
(
    CloudType& owner,
    const fvMesh& mesh,
    const dictionary& dict
)
:
    ParticleForce<CloudType>
    (
        owner,
        mesh,
        dict,
        typeName,
        dict.dictName() == typeName
    ),
    thermoName_
    (
        this->coeffs().template lookupOrDefault<word>
        (
            "thermo",
            basicThermo::dictName
        )
    ),
    TwOverT_
    (
        getNumber(this->coeffs(), "TwOverT", "(0, 1e6]", scalar(1))
    ),
    scheme_
    (
        owner.solution().interpolationSchemes().template
            lookupOrDefault<word>("T", "cellPoint")
    ),
    TEvent_(-1),
    pEvent_(-1),
    uniformGas_(true),
    gammaR_(0),
    drag_(1.4, 1)
{
    refuseOthers(this->coeffs(), {"thermo", "TwOverT"});

    if (gMin(thermo().psi().primitiveField()) <= 0)
    {
        FatalIOErrorInFunction(this->coeffs())
            << "hendersonDrag needs a speed of sound. Entry thermo "
            << thermoName_ << ": valid range a model with a compressible"
            << " equation of state (psi > 0)"
            << exit(FatalIOError);
    }
}


template<class CloudType>
Foam::HendersonDragForce<CloudType>::HendersonDragForce
(
    const HendersonDragForce<CloudType>& force
)
:
    ParticleForce<CloudType>(force),
    thermoName_(force.thermoName_),
    TwOverT_(force.TwOverT_),
    scheme_(force.scheme_),
    TEvent_(-1),
    pEvent_(-1),
    uniformGas_(true),
    gammaR_(0),
    drag_(force.drag_)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

template<class CloudType>
void Foam::HendersonDragForce<CloudType>::cacheFields(const bool store)
{
    if (!store)
    {
        // The interpolation stays for the next step: on a frozen gas it is
        // still valid then
        return;
    }

    const fluidThermo& gas = thermo();
    const bool same = upToDate(gas);
    if (!same)
    {
        updateGas(gas);
    }

    if (!same || !aSqrInterp_.valid())
    {
        aSqrInterp_.reset
        (
            interpolation<scalar>::New
            (
                scheme_,
                uniformGas_ ? gas.T() : aSqr_()
            ).ptr()
        );
        if (!uniformGas_)
        {
            gammaInterp_.reset
            (
                interpolation<scalar>::New(scheme_, gamma_()).ptr()
            );
        }
    }
}


template<class CloudType>
Foam::forceSuSp Foam::HendersonDragForce<CloudType>::calcCoupled
(
    const typename CloudType::parcelType& p,
    const typename CloudType::parcelType::trackingData& td,
    const scalar dt,
    const scalar mass,
    const scalar Re,
    const scalar muc
) const
{
    const barycentric& where = p.coordinates();
    const tetIndices tetIs(p.currentTetIndices());
    const scalar value = aSqrInterp_().interpolate(where, tetIs);
    const scalar aSqr = uniformGas_ ? gammaR_*value : value;

    const scalar MachOverRe = muc/(td.rhoc()*p.d()*Foam::sqrt(aSqr));

    const scalar CdRe =
        uniformGas_
      ? drag_.CdRe(Re, MachOverRe)
      : impact::hendersonDrag
        (
            gammaInterp_().interpolate(where, tetIs),
            TwOverT_
        ).CdRe(Re, MachOverRe);

    forceSuSp force(Zero);
    force.Sp() = 0.75*mass*muc*CdRe/(p.rho()*sqr(p.d()));
    return force;
}
