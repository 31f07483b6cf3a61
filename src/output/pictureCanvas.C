/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "pictureCanvas.H"
#include "OSspecific.H"
#include "trapsOff.H"

#include <vtkActor.h>
#include <vtkActor2D.h>
#include <vtkAutoInit.h>
#include <vtkCamera.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkContourFilter.h>
#include <vtkDoubleArray.h>
#include <vtkFeatureEdges.h>
#include <vtkLookupTable.h>
#include <vtkNew.h>
#include <vtkPNGWriter.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkPolyDataMapper2D.h>
#include <vtkProperty.h>
#include <vtkProperty2D.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>
#include <vtkTextActor.h>
#include <vtkTextProperty.h>
#include <vtkUnsignedCharArray.h>
#include <vtkWindowToImageFilter.h>

VTK_MODULE_INIT(vtkRenderingOpenGL2);
VTK_MODULE_INIT(vtkRenderingFreeType);

// * * * * * * * * * * * * * * * Local Classes * * * * * * * * * * * * * * * //

struct Foam::SPH::pictureCanvas::contents
{
    label width;
    label height;

    vtkNew<vtkRenderWindow> window;

    //- Texts and lines, over everything else
    vtkNew<vtkRenderer> annotation;

    //- Add an actor to a renderer that shows an area pixel by pixel
    vtkSmartPointer<vtkRenderer> pixelRenderer(const rectangle& area) const
    {
        auto renderer = vtkSmartPointer<vtkRenderer>::New();
        renderer->SetBackground(1, 1, 1);

        // Where a processor draws, several samples a pixel cost twice as much
        renderer->UseFXAAOn();

        renderer->SetViewport
        (
            area.x/width,
            area.y/height,
            (area.x + area.width)/width,
            (area.y + area.height)/height
        );

        vtkCamera* camera = renderer->GetActiveCamera();
        const scalar x = area.x + area.width/2;
        const scalar y = area.y + area.height/2;
        camera->ParallelProjectionOn();
        camera->SetFocalPoint(x, y, 0);
        camera->SetPosition(x, y, 10);
        camera->SetClippingRange(1, 100);
        camera->SetParallelScale(area.height/2);

        return renderer;
    }
};


// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- Grey level of all lines and texts
const double ink = 0.12;

vtkSmartPointer<vtkLookupTable> lookupTable
(
    const Foam::SPH::colourMap& colours,
    const double lowest,
    const double highest
)
{
    const int n = 256;

    auto table = vtkSmartPointer<vtkLookupTable>::New();
    table->SetNumberOfTableValues(n);
    table->SetRange(lowest, highest);
    for (int i = 0; i < n; ++i)
    {
        const Foam::vector c(colours(i/double(n - 1)));
        table->SetTableValue(i, c.x(), c.y(), c.z());
    }
    return table;
}


//- Surface lines of one colour in front of the surface
vtkSmartPointer<vtkActor> lineActor
(
    vtkAlgorithmOutput* lines,
    const double width,
    const double opacity
)
{
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputConnection(lines);
    mapper->ScalarVisibilityOff();

    auto actor = vtkSmartPointer<vtkActor>::New();
    actor->SetMapper(mapper);
    actor->GetProperty()->SetColor(ink, ink, ink);
    actor->GetProperty()->SetLighting(false);
    actor->GetProperty()->SetLineWidth(width);
    actor->GetProperty()->SetOpacity(opacity);
    actor->SetPosition(0, 0, 1);
    return actor;
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::SPH::pictureCanvas::pictureCanvas(const label width, const label height)
:
    contents_(new contents)
{
    const trapsOff untrapped;

    contents_->width = width;
    contents_->height = height;

    contents_->window->SetOffScreenRendering(1);
    contents_->window->SetMultiSamples(0);
    contents_->window->SetSize(width, height);
    contents_->window->SetNumberOfLayers(2);

    contents_->window->AddRenderer
    (
        contents_->pixelRenderer({0, 0, scalar(width), scalar(height)})
    );

    contents_->annotation->SetLayer(1);
    contents_->annotation->InteractiveOff();
    contents_->window->AddRenderer(contents_->annotation);
}


// * * * * * * * * * * * * * * * * Destructor  * * * * * * * * * * * * * * * //

Foam::SPH::pictureCanvas::~pictureCanvas()
{
    const trapsOff untrapped;
    contents_.reset();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::SPH::pictureCanvas::text
(
    const std::string& string,
    const scalar x,
    const scalar y,
    const label size,
    const alignment along,
    const alignment across,
    const bool bold,
    const bool upwards
)
{
    vtkNew<vtkTextActor> actor;
    actor->SetInput(string.c_str());
    actor->SetDisplayPosition(int(x), int(y));

    vtkTextProperty* property = actor->GetTextProperty();
    property->SetFontFamilyToArial();
    property->SetFontSize(size);
    property->SetColor(ink, ink, ink);
    property->SetBold(bold);
    property->SetJustification
    (
        along == low ? VTK_TEXT_LEFT
      : along == centre ? VTK_TEXT_CENTERED
      : VTK_TEXT_RIGHT
    );
    property->SetVerticalJustification
    (
        across == low ? VTK_TEXT_BOTTOM
      : across == centre ? VTK_TEXT_CENTERED
      : VTK_TEXT_TOP
    );
    if (upwards)
    {
        property->SetOrientation(90);
    }

    contents_->annotation->AddActor2D(actor);
}


void Foam::SPH::pictureCanvas::lines
(
    const List<Pair<point>>& segments,
    const scalar width
)
{
    vtkNew<vtkPoints> points;
    vtkNew<vtkCellArray> cells;
    for (const Pair<point>& segment : segments)
    {
        cells->InsertNextCell(2);
        cells->InsertCellPoint(points->InsertNextPoint(segment[0].cdata()));
        cells->InsertCellPoint(points->InsertNextPoint(segment[1].cdata()));
    }

    vtkNew<vtkPolyData> data;
    data->SetPoints(points);
    data->SetLines(cells);

    vtkNew<vtkPolyDataMapper2D> mapper;
    mapper->SetInputData(data);

    vtkNew<vtkActor2D> actor;
    actor->SetMapper(mapper);
    actor->GetProperty()->SetColor(ink, ink, ink);
    actor->GetProperty()->SetLineWidth(width);
    contents_->annotation->AddActor2D(actor);
}


void Foam::SPH::pictureCanvas::colourBar
(
    const rectangle& area,
    const colourMap& colours
)
{
    const label n = 256;
    const bool upright = area.height > area.width;

    vtkNew<vtkPoints> points;
    vtkNew<vtkCellArray> cells;
    vtkNew<vtkUnsignedCharArray> rgb;
    rgb->SetNumberOfComponents(3);

    for (label i = 0; i <= n; ++i)
    {
        const scalar s = scalar(i)/n;
        const scalar x = area.x + (upright ? 0 : s*area.width);
        const scalar y = area.y + (upright ? s*area.height : 0);
        points->InsertNextPoint(x, y, 0);
        points->InsertNextPoint
        (
            upright ? x + area.width : x,
            upright ? y : y + area.height,
            0
        );
    }
    for (label i = 0; i < n; ++i)
    {
        const vtkIdType corners[] = {2*i, 2*i + 1, 2*i + 3, 2*i + 2};
        cells->InsertNextCell(4, corners);
        const vector c(255*colours((i + 0.5)/n));
        rgb->InsertNextTuple3(c.x(), c.y(), c.z());
    }

    vtkNew<vtkPolyData> data;
    data->SetPoints(points);
    data->SetPolys(cells);
    data->GetCellData()->SetScalars(rgb);

    vtkNew<vtkPolyDataMapper2D> mapper;
    mapper->SetInputData(data);

    vtkNew<vtkActor2D> actor;
    actor->SetMapper(mapper);
    contents_->annotation->AddActor2D(actor);
}


void Foam::SPH::pictureCanvas::draw(const rectangle& area, const surface& s)
{
    const trapsOff untrapped;

    vtkNew<vtkPoints> points;
    points->SetNumberOfPoints(s.points.size());
    forAll(s.points, i)
    {
        points->SetPoint(i, s.points[i].cdata());
    }

    vtkNew<vtkCellArray> cells;
    for (const face& f : s.polygons)
    {
        cells->InsertNextCell(f.size());
        for (const label pointi : f)
        {
            cells->InsertCellPoint(pointi);
        }
    }

    vtkNew<vtkDoubleArray> values;
    values->SetNumberOfValues(s.values.size());
    forAll(s.values, i)
    {
        values->SetValue(i, s.values[i]);
    }

    vtkNew<vtkPolyData> data;
    data->SetPoints(points);
    data->SetPolys(cells);
    const bool pointValues = s.values.size() == s.points.size();
    if (pointValues)
    {
        data->GetPointData()->SetScalars(values);
    }
    else
    {
        data->GetCellData()->SetScalars(values);
    }

    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputData(data);
    mapper->SetLookupTable(lookupTable(s.colours, s.lowest, s.highest));
    mapper->UseLookupTableScalarRangeOn();
    mapper->SetInterpolateScalarsBeforeMapping(pointValues);

    vtkNew<vtkActor> actor;
    actor->SetMapper(mapper);
    actor->GetProperty()->SetLighting(false);

    const auto renderer = contents_->pixelRenderer(area);
    renderer->AddActor(actor);

    if (s.contours.size())
    {
        vtkNew<vtkContourFilter> filter;
        filter->SetInputData(data);
        forAll(s.contours, i)
        {
            filter->SetValue(i, s.contours[i]);
        }
        renderer->AddActor(lineActor(filter->GetOutputPort(), 1, 0.45));
    }

    if (s.outlined)
    {
        vtkNew<vtkFeatureEdges> filter;
        filter->SetInputData(data);
        filter->BoundaryEdgesOn();
        filter->FeatureEdgesOff();
        filter->NonManifoldEdgesOff();
        filter->ManifoldEdgesOff();
        filter->ColoringOff();
        renderer->AddActor(lineActor(filter->GetOutputPort(), 2, 1));
    }

    contents_->window->AddRenderer(renderer);
}


void Foam::SPH::pictureCanvas::write(const fileName& file)
{
    const trapsOff untrapped;

    mkDir(file.path());
    contents_->window->Render();

    vtkNew<vtkWindowToImageFilter> image;
    image->SetInput(contents_->window);
    image->ReadFrontBufferOff();

    vtkNew<vtkPNGWriter> writer;
    writer->SetFileName(file.c_str());
    writer->SetInputConnection(image->GetOutputPort());
    writer->Write();

    if (!isFile(file))
    {
        FatalErrorInFunction
            << "Cannot write " << file << exit(FatalError);
    }
}

// ************************************************************************* //
