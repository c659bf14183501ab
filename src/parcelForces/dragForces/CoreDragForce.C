/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "CoreDragForce.H"
#include "checked.H"
#include "parcelTemperature.H"
#include "stockCloudEntries.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

template<class CloudType>
impact::dragLaw::coefficients Foam::CoreDragForce<CloudType>::read
(
    const dictionary& dict,
    const impact::dragLaw::kind& kind
) const
{
    impact::dragLaw::coefficients c;
    wordList entries;

    if (kind.compressible)
    {
        entries.append("thermo");
        const dictionary& solution = this->owner().solution().dict();
        if (!parcelTemperature::has<parcelType>(solution))
        {
            entries.append("TwOverT");
            c.TpOverT = getNumber
            (
                dict, "TwOverT", impact::dragLaw::TpOverTRange, c.TpOverT
            );
        }
        else if (dict.found("TwOverT"))
        {
            refuse
            (
                dict, "TwOverT", dict.get<scalar>("TwOverT"), "none: the"
                " parcels of this cloud have temperatures of their own"
            );
        }
    }

    if (kind.forms.size())
    {
        wordList forms;
        for (const char* form : kind.forms)
        {
            forms.append(form);
        }
        entries.append("form");
        c.form = getWord(dict, "form", forms);
    }

    for (const auto& number : kind.numbers)
    {
        entries.append(number.name);
        if (dict.found(number.name))
        {
            c.numbers[number.name] =
                getNumber(dict, number.name, number.range);
        }
        else if (!number.as && number.deflt < 0)
        {
            FatalIOErrorInFunction(dict)
                << kind.name << ": entry " << number.name
                << " is missing: valid range " << number.range
                << exit(FatalIOError);
        }
    }

    refuseOthers(dict, entries);
    return c;
}


template<class CloudType>
const Foam::fluidThermo& Foam::CoreDragForce<CloudType>::thermo() const
{
    if (!this->mesh().template foundObject<fluidThermo>(thermoName_))
    {
        FatalIOErrorInFunction(this->coeffs())
            << kind_.name << " needs the gas temperature and ratio of specific"
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
std::unique_ptr<impact::dragLaw> Foam::CoreDragForce<CloudType>::law
(
    const scalar gamma
) const
{
    impact::dragLaw::coefficients c(coefficients_);
    c.gamma = gamma;
    return checked
    (
        this->coeffs(), [&]{ return impact::dragLaw::New(kind_.name, c); }
    );
}


template<class CloudType>
bool Foam::CoreDragForce<CloudType>::upToDate
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
void Foam::CoreDragForce<CloudType>::updateGas(const fluidThermo& thermo)
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
        drag_ = law(0.5*(gammaMin + gammaMax));
        aSqr_.clear();
        gamma_.clear();
    }
    else
    {
        // Both ends must be within the range of the law
        law(gammaMin);
        drag_ = law(gammaMax);

        const word prefix(this->owner().name() + ':' + kind_.name + ':');
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
Foam::CoreDragForce<CloudType>::CoreDragForce
(
    CloudType& owner,
    const fvMesh& mesh,
    const dictionary& dict,
    const word& name
)
:
    ParticleForce<CloudType>(owner, mesh, dict, name, dict.dictName() == name),
    kind_(impact::dragLaw::find(name)),
    coefficients_(read(this->coeffs(), kind_)),
    thermoName_
    (
        this->coeffs().template lookupOrDefault<word>
        (
            "thermo",
            basicThermo::dictName
        )
    ),
    scheme_
    (
        owner.solution().dict().subOrEmptyDict("interpolationSchemes").template
            lookupOrDefault<word>("T", "cellPoint")
    ),
    TEvent_(-1),
    pEvent_(-1),
    uniformGas_(true),
    gammaR_(1),
    drag_(law(1.4))
{
    stockCloudEntries::refuseSecondDrag
    (
        owner.subModelProperties().subOrEmptyDict("particleForces")
    );
    if (kind_.compressible && gMin(thermo().psi().primitiveField()) <= 0)
    {
        FatalIOErrorInFunction(this->coeffs())
            << kind_.name << " needs a speed of sound. Entry thermo "
            << thermoName_ << ": valid range a model with a compressible"
            << " equation of state (psi > 0)"
            << exit(FatalIOError);
    }
}


template<class CloudType>
Foam::CoreDragForce<CloudType>::CoreDragForce
(
    const CoreDragForce<CloudType>& force
)
:
    ParticleForce<CloudType>(force),
    kind_(force.kind_),
    coefficients_(force.coefficients_),
    thermoName_(force.thermoName_),
    scheme_(force.scheme_),
    TEvent_(-1),
    pEvent_(-1),
    uniformGas_(true),
    gammaR_(1),
    drag_(force.drag_->clone())
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

template<class CloudType>
void Foam::CoreDragForce<CloudType>::cacheFields(const bool store)
{
    if (!store || !kind_.compressible)
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
Foam::forceSuSp Foam::CoreDragForce<CloudType>::calcCoupled
(
    const parcelType& p,
    const typename parcelType::trackingData& td,
    const scalar dt,
    const scalar mass,
    const scalar Re,
    const scalar muc
) const
{
    scalar CdRe;
    if (!kind_.compressible)
    {
        CdRe = drag_->CdRe(Re, 0);
    }
    else
    {
        const barycentric& where = p.coordinates();
        const tetIndices tetIs(p.currentTetIndices());
        const scalar value = aSqrInterp_().interpolate(where, tetIs);
        const scalar aSqr = uniformGas_ ? gammaR_*value : value;
        const scalar MachOverRe = muc/(td.rhoc()*p.d()*Foam::sqrt(aSqr));
        const scalar TpOverT =
            parcelTemperature::overThatOfGas(p, td, coefficients_.TpOverT);

        CdRe =
            uniformGas_
          ? drag_->CdRe(Re, MachOverRe, TpOverT)
          : drag_->CdReIn
            (
                gammaInterp_().interpolate(where, tetIs),
                Re,
                MachOverRe,
                TpOverT
            );
    }

    forceSuSp force(Zero);
    force.Sp() = 0.75*mass*muc*CdRe/(p.rho()*sqr(p.d()));
    return force;
}
