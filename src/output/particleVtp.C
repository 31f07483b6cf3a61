/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "particleVtp.H"
#include "error.H"
#include "OSspecific.H"
#include "trapsOff.H"

#include <vtkCellArray.h>
#include <vtkDoubleArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkTypeInt32Array.h>
#include <vtkTypeInt64Array.h>
#include <vtkXMLPolyDataWriter.h>

// * * * * * * * * * * * * * * * Local Classes * * * * * * * * * * * * * * * //

struct Foam::SPH::particleVtp::contents
{
    vtkNew<vtkPolyData> data;
};


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

template<class Value, class Array>
void Foam::SPH::particleVtp::addArray
(
    const word& name,
    const Value* values,
    const label n,
    const label components
)
{
    vtkNew<Array> array;
    array->SetName(name.c_str());
    array->SetNumberOfComponents(components);
    array->SetNumberOfTuples(n);
    std::copy(values, values + components*n, array->GetPointer(0));

    contents_->data->GetPointData()->AddArray(array);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::SPH::particleVtp::particleVtp(const fileName& file)
:
    file_(file),
    contents_(new contents)
{}


// * * * * * * * * * * * * * * * * Destructor  * * * * * * * * * * * * * * * //

Foam::SPH::particleVtp::~particleVtp() = default;


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::SPH::particleVtp::add
(
    const word& name,
    const UList<scalar>& field
)
{
    addArray<scalar, vtkDoubleArray>(name, field.cdata(), field.size(), 1);
}


void Foam::SPH::particleVtp::add
(
    const word& name,
    const UList<vector>& field
)
{
    addArray<scalar, vtkDoubleArray>
    (
        name,
        reinterpret_cast<const scalar*>(field.cdata()),
        field.size(),
        3
    );
}


void Foam::SPH::particleVtp::add
(
    const word& name,
    const UList<label>& field
)
{
    typedef std::conditional
    <
        sizeof(label) == 4, vtkTypeInt32Array, vtkTypeInt64Array
    >::type labelArray;

    addArray<label, labelArray>(name, field.cdata(), field.size(), 1);
}


void Foam::SPH::particleVtp::write(const UList<point>& points)
{
    vtkPointData* fields = contents_->data->GetPointData();

    for (int i = 0; i < fields->GetNumberOfArrays(); ++i)
    {
        if (fields->GetArray(i)->GetNumberOfTuples() != points.size())
        {
            FatalErrorInFunction
                << "Field " << fields->GetArrayName(i) << " has "
                << label(fields->GetArray(i)->GetNumberOfTuples())
                << " values for " << points.size() << " points in "
                << file_ << exit(FatalError);
        }
    }

    vtkNew<vtkPoints> positions;
    positions->SetDataTypeToDouble();
    positions->SetNumberOfPoints(points.size());

    vtkNew<vtkCellArray> vertices;
    vertices->AllocateExact(points.size(), points.size());

    forAll(points, i)
    {
        positions->SetPoint(i, points[i].cdata());

        const vtkIdType id = i;
        vertices->InsertNextCell(1, &id);
    }
    contents_->data->SetPoints(positions);
    contents_->data->SetVerts(vertices);

    mkDir(file_.path());

    const trapsOff untrapped;
    vtkNew<vtkXMLPolyDataWriter> writer;
    writer->SetFileName(file_.c_str());
    writer->SetInputData(contents_->data);
    writer->Write();
    if (writer->GetErrorCode())
    {
        FatalErrorInFunction
            << "Cannot write " << file_ << exit(FatalError);
    }
}


// ************************************************************************* //
