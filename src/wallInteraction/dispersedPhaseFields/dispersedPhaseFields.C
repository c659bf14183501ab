/*---------------------------------------------------------------------------*\
    parcelImpact. License: GPL-3.0-or-later, see COPYING.
\*---------------------------------------------------------------------------*/

#include "dispersedPhaseFields.H"
#include "checked.H"
#include "PstreamReduceOps.H"
#include "pastWrite.H"
#include "zeroGradientFvPatchFields.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::IOobject Foam::dispersedPhaseFields::io
(
    const word& name,
    const IOobject::readOption r
) const
{
    return IOobject
    (
        prefix_ + name,
        mesh_.time().timeName(),
        mesh_,
        r,
        r == IOobject::NO_READ ? IOobject::AUTO_WRITE : IOobject::NO_WRITE,
        r == IOobject::NO_READ
    );
}


template<class Field>
void Foam::dispersedPhaseFields::read
(
    const word& name,
    const dictionary& dict,
    const label at
)
{
    IOobject header(io(name, IOobject::MUST_READ));
    if (!header.typeHeaderOk<Field>(true))
    {
        FatalIOErrorInFunction(dict)
            << "Averages go on in " << restart_.objectPath()
            << " but the field " << header.objectPath() << " is missing."
            << " Restore it, or remove the former to begin new averages."
            << exit(FatalIOError);
    }
    const Field field(header, mesh_);
    typedef typename Field::cmptType Cmpt;
    const label n = sizeof(typename Field::value_type)/sizeof(Cmpt);
    forAll(field, celli)
    {
        for (label i = 0; i < n; ++i)
        {
            sums_[celli*width_ + at + i] = component(field[celli], i);
        }
    }
}


template<class Type>
Foam::DimensionedField<Type, Foam::volMesh>& Foam::dispersedPhaseFields::add
(
    const word& name,
    const dimensionSet& dimensions
)
{
    auto* field = new DimensionedField<Type, volMesh>
    (
        io(name, IOobject::NO_READ),
        mesh_,
        dimensioned<Type>(dimensions, Zero)
    );
    fields_.append(field);
    return *field;
}


template<class Type>
Foam::GeometricField<Type, Foam::fvPatchField, Foam::volMesh>&
Foam::dispersedPhaseFields::addVol
(
    const word& name,
    const dimensionSet& dimensions
)
{
    auto* field = new GeometricField<Type, fvPatchField, volMesh>
    (
        io(name, IOobject::NO_READ),
        mesh_,
        dimensioned<Type>(dimensions, Zero),
        zeroGradientFvPatchField<Type>::typeName
    );
    fields_.append(field);
    return *field;
}


void Foam::dispersedPhaseFields::makeFields()
{
    fields_.clear();

    // The sums
    auto& weight = add<scalar>("weight", dimTime);
    auto& volume = add<scalar>("volume", dimVolume*dimTime);
    auto& scatter = add<scalar>("scatter", sqr(dimVelocity)*dimTime);

    // What follows from them
    auto& number = addVol<scalar>("numberDensity", inv(dimVolume));
    auto& concentration = addVol<scalar>("concentration", dimless);
    auto& rms = addVol<scalar>("URms", dimVelocity);
    auto& U = addVol<vector>("U", dimVelocity);
    volVectorField* omega =
        spin_ ? &addVol<vector>("omega", inv(dimTime)) : nullptr;

    const scalarField& V = mesh_.V();
    forAll(V, celli)
    {
        const double* s = &sums_[celli*width_];
        weight[celli] = s[WEIGHT];
        volume[celli] = s[VOLUME];
        scatter[celli] = s[SCATTER];
        U[celli] = vector(s[MEAN], s[MEAN + 1], s[MEAN + 2]);
        if (omega)
        {
            (*omega)[celli] = vector(s[OMEGA], s[OMEGA + 1], s[OMEGA + 2]);
        }
        if (s[WEIGHT] > 0)
        {
            number[celli] = s[WEIGHT]/(V[celli]*time_);
            concentration[celli] = s[VOLUME]/(V[celli]*time_);
            rms[celli] = sqrt(max(s[SCATTER], 0.0)/s[WEIGHT]);
        }
    }
    number.correctBoundaryConditions();
    concentration.correctBoundaryConditions();
    rms.correctBoundaryConditions();
    U.correctBoundaryConditions();
    if (omega)
    {
        omega->correctBoundaryConditions();
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dispersedPhaseFields::dispersedPhaseFields
(
    const dictionary& dict,
    const word& cloudName,
    const word& functionName,
    const fvMesh& mesh,
    const bool spin
)
:
    prefix_(cloudName + ":" + functionName + ":"),
    mesh_(mesh),
    spin_(spin),
    width_(spin ? OMEGA + 3 : OMEGA),
    restart_(cloudName, functionName, mesh, dict),
    window_(dict, functionName, mesh.time(), restart_.found()),
    interval_(getNumber<label>(dict, "interval", validRange::count, 1)),
    sums_(mesh.nCells()*width_, 0.0)
{
    if (restart_.found())
    {
        const scalarList& numbers = restart_.scalars();
        time_ = numbers[0];
        if
        (
            numbers.size() == 3 && time_ > 0
         && (numbers[1] != window_.start() || numbers[2] != interval_)
        )
        {
            FatalIOErrorInFunction(dict)
                << functionName << ": the averages kept in "
                << restart_.objectPath() << " were made with another interval"
                << " or start of the window. Restore those, or begin new"
                << " averages with restart anew;" << exit(FatalIOError);
        }
        read<volScalarField::Internal>("weight", dict, WEIGHT);
        read<volScalarField::Internal>("volume", dict, VOLUME);
        read<volScalarField::Internal>("scatter", dict, SCATTER);
        read<volVectorField>("U", dict, MEAN);
        if (spin_)
        {
            read<volVectorField>("omega", dict, OMEGA);
        }
        restart_.clear();
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::dispersedPhaseFields::begin()
{
    if (mesh_.changing())
    {
        FatalErrorInFunction
            << prefix_ << " the mesh moves or changes; the averages are those"
            << " over cells that stay." << nl
            << "Take the function out of cloudFunctions" << exit(FatalError);
    }
    fields_.clear();

    const Time& time = mesh_.time();
    if (!window_.open() || time.timeIndex() % interval_ != 0)
    {
        return false;
    }
    dt_ = time.deltaTValue();
    time_ += dt_;
    return true;
}


void Foam::dispersedPhaseFields::end()
{
    if (!mesh_.time().writeTime())
    {
        return;
    }
    makeFields();
    for (const regIOobject& field : fields_)
    {
        pastWrite::catchUp(mesh_, field);
    }
    restart_.set
    (
        labelList(), scalarList({time_, window_.start(), scalar(interval_)})
    );

    scalar particles = 0;
    forAll(mesh_.V(), celli)
    {
        particles += sums_[celli*width_ + WEIGHT];
    }
    reduce(particles, sumOp<scalar>());
    Info<< prefix_ << " averaged over " << time_ << " s, "
        << (time_ > 0 ? particles/time_ : 0) << " particles" << nl << endl;
}
