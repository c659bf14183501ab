/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "gasProperties.H"
#include "psiThermo.H"

Foam::gasProperties::gasProperties
(
    fluidThermo& thermo,
    const gasEquationOfState& gas,
    const scalar offset,
    const bool transportKnown
)
:
    thermo_(thermo),
    gas_(gas),
    offset_(offset),
    enthalpy_(thermo.he().name() == "h")
{
    const tmp<volScalarField> mu(thermo.mu());
    if (transportKnown && isA<psiThermo>(thermo) && !mu.isTmp())
    {
        psi_ = &const_cast<volScalarField&>(thermo.psi());
        mu_ = &const_cast<volScalarField&>(mu());
        alpha_ = &const_cast<volScalarField&>(thermo.alpha());
    }
}


inline Foam::gasProperties::values
Foam::gasProperties::at
(
    const scalar T
) const
{
    const bool table = gas_.thermallyPerfect();
    const scalar e = table ? gas_.energy<true>(T) : gas_.energy<false>(T);
    const scalar cv =
        table ? gas_.specificHeat<true>(T) : gas_.specificHeat<false>(T);
    const scalar mu = gas_.viscosity(T);
    const scalar kappa =
        table
      ? gas_.conductivity<true>(mu, T)
      : gas_.conductivity<false>(mu, T);

    return
    {
        offset_ + e + (enthalpy_ ? gas_.R*T : 0),
        1/(gas_.R*T),
        mu,
        kappa/(cv + gas_.R)
    };
}


void Foam::gasProperties::setCell(const label celli) const
{
    const values v = at(thermo_.T()[celli]);
    thermo_.he()[celli] = v.he;
    (*psi_)[celli] = v.psi;
    (*mu_)[celli] = v.mu;
    (*alpha_)[celli] = v.alpha;
}


void Foam::gasProperties::setPatch(const label patchi) const
{
    const fvPatchScalarField& T = thermo_.T().boundaryField()[patchi];
    scalarField& he = thermo_.he().boundaryFieldRef()[patchi];
    scalarField& psi = psi_->boundaryFieldRef()[patchi];
    scalarField& mu = mu_->boundaryFieldRef()[patchi];
    scalarField& alpha = alpha_->boundaryFieldRef()[patchi];
    forAll(T, i)
    {
        const values v = at(T[i]);
        he[i] = v.he;
        psi[i] = v.psi;
        mu[i] = v.mu;
        alpha[i] = v.alpha;
    }
}


void Foam::gasProperties::update() const
{
    volScalarField& T = thermo_.T();

    if (!local())
    {
        thermo_.he() = thermo_.he(thermo_.p(), T);
        const scalarField keepT(T);
        thermo_.correct();
        static_cast<scalarField&>(T) = keepT;
        return;
    }

    forAll(T, celli)
    {
        setCell(celli);
    }

    // The conditions on the energy, and their gradients, follow those on T,
    // and evaluate them anew, which is not their turn
    List<scalarField> keepT(T.boundaryField().size());
    forAll(keepT, patchi)
    {
        keepT[patchi] = T.boundaryField()[patchi];
    }
    thermo_.he().correctBoundaryConditions();
    forAll(keepT, patchi)
    {
        static_cast<scalarField&>(T.boundaryFieldRef()[patchi]) =
            keepT[patchi];
        setPatch(patchi);
    }
}
