/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "turbulentDispersion.H"
#include "checked.H"
#include "coreVector.H"
#include "drawPurpose.H"
#include "turbulenceModel.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::turbulentDispersion::turbulentDispersion
(
    const volVectorField& U,
    const dictionary& models
)
:
    U_(U),
    models_(models)
{
    const word coeffs("stochasticDispersionRASCoeffs");
    if (const dictionary* dict = models.findDict(coeffs))
    {
        refuseOthers(*dict, {"seed"});
        seed_ = getNumber<label>(*dict, "seed", validRange::seed, 0);
    }
    const Vector<label>& d = U.mesh().solutionD();
    for (int i = 0; i < 3; ++i)
    {
        solved_[i] = d[i] == 1;
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::turbulentDispersion::update(const scalar deltaT)
{
    shortest_ = deltaT/16;
    const auto* model = U_.mesh().findObject<turbulenceModel>
    (
        IOobject::groupName(turbulenceModel::propertiesName, U_.group())
    );
    if (!model || model->get<word>("simulationType") != "RAS")
    {
        refuse
        (
            models_, "dispersionModel",
            models_.get<word>("dispersionModel"),
            "none in a gas whose constant/turbulenceProperties do not say"
            " simulationType RAS"
        );
    }
    const tmp<volScalarField> k(model->k());
    const tmp<volScalarField> epsilon(model->epsilon());
    if (gMax(k()) <= 0 || gMax(epsilon()) <= 0)
    {
        refuse
        (
            models_, "dispersionModel",
            models_.get<word>("dispersionModel"),
            "none with the turbulence model " + model->type()
          + ", which has no k and epsilon"
        );
    }
    cells_.resize(U_.mesh().nCells());
    forAll(k(), celli)
    {
        cells_[celli] = {k()[celli], epsilon()[celli]};
    }
}


void Foam::turbulentDispersion::next
(
    const label celli,
    const label origProc,
    const label origId,
    const impact::vector3& w,
    const scalar rate,
    vector& u,
    scalar& left,
    label& number
)
{
    const auto eddy = impact::eddyInteraction::begin
    (
        cells_[celli],
        w,
        rate,
        solved_,
        shortest_,
        impact::counterRandom
        (
            seed_,
            std::uint64_t(std::uint32_t(origProc)) << 32
          | std::uint32_t(origId),
            impact::drawPurpose::eddy + (std::uint32_t(number) & 0xffffff)
        )
    );
    u = fromCore(eddy.u);
    left = eddy.life;
    ++number;
    ++nEddies_;
    nTogether_ += left == shortest_;
}
