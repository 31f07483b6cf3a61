/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "fieldPicture.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

// All in pixels
const label titleSize = 34;
const label panelTitleSize = 28;
const label labelSize = 24;
const scalar tickLength = 9;
const scalar titleSpace = 72;
const scalar panelTitleSpace = 48;
const scalar xAxisSpace = 92;
const scalar yAxisSpace = 130;
const scalar gap = 84;
const scalar margin = 48;
const scalar barThickness = 26;
const scalar barSpace = 120;
const scalar uprightBarSpace = 220;

//- Width of all panels together, largest height of one, and the flattest
const scalar totalWidth = 1860;
const scalar maxHeight = 1100;
const scalar minFlatness = 0.1;

//- Widest panels that still stand side by side
const scalar maxAspect = 2.2;


scalar fraction(const scalar value, const scalar lowest, const scalar highest)
{
    return (value - lowest)/max(highest - lowest, VSMALL);
}


//- Straight lines under construction
class segments
:
    public DynamicList<Pair<point>>
{
public:

    //- Start with the sides of a rectangle
    segments(const SPH::pictureCanvas::rectangle& area)
    {
        const scalar right = area.x + area.width;
        const scalar top = area.y + area.height;
        add(area.x, area.y, right, area.y);
        add(right, area.y, right, top);
        add(right, top, area.x, top);
        add(area.x, top, area.x, area.y);
    }

    void add
    (
        const scalar x0,
        const scalar y0,
        const scalar x1,
        const scalar y1
    )
    {
        append(Pair<point>(point(x0, y0, 0), point(x1, y1, 0)));
    }
};

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::SPH::fieldPicture::aspect() const
{
    const vector span(box_.span());
    return min(span.x()/max(span.y(), VSMALL), 1/minFlatness);
}


bool Foam::SPH::fieldPicture::sideBySide() const
{
    return aspect() < maxAspect;
}


void Foam::SPH::fieldPicture::drawPanel
(
    pictureCanvas& canvas,
    const panel& p,
    const pictureCanvas::rectangle& area,
    const bool xLabelled,
    const bool yLabelled
) const
{
    const auto x = [&](const scalar v)
    {
        return area.x + area.width*fraction(v, box_.min().x(), box_.max().x());
    };
    const auto y = [&](const scalar v)
    {
        return
            area.y + area.height*fraction(v, box_.min().y(), box_.max().y());
    };

    pointField pixels(p.points.size());
    forAll(pixels, i)
    {
        pixels[i] = point(x(p.points[i].x()), y(p.points[i].y()), 0);
    }

    const colourScale& scale = scales_[p.scale];
    scalarList contours(p.nContours);
    forAll(contours, i)
    {
        contours[i] =
            scale.lowest
          + (i + 1)*(scale.highest - scale.lowest)/(p.nContours + 1);
    }

    canvas.draw
    (
        area,
        {
            pixels,
            p.polygons,
            p.values,
            scale.colours,
            scale.lowest,
            scale.highest,
            contours,
            p.outlined
        }
    );

    segments lines(area);

    const tickMarks xTicks
    (
        box_.min().x(), box_.max().x(), max(2, label(area.width/110))
    );
    for (const scalar v : xTicks.values())
    {
        lines.add(x(v), area.y, x(v), area.y - tickLength);
        if (xLabelled)
        {
            canvas.text
            (
                xTicks.label(v), x(v), area.y - 2*tickLength, labelSize,
                pictureCanvas::centre, pictureCanvas::high
            );
        }
    }

    const tickMarks yTicks
    (
        box_.min().y(), box_.max().y(), max(2, label(area.height/70))
    );
    for (const scalar v : yTicks.values())
    {
        lines.add(area.x, y(v), area.x - tickLength, y(v));
        if (yLabelled)
        {
            canvas.text
            (
                yTicks.label(v), area.x - 2*tickLength, y(v), labelSize,
                pictureCanvas::high, pictureCanvas::centre
            );
        }
    }

    canvas.lines(lines, 2);

    if (xLabelled)
    {
        canvas.text
        (
            xLabel_, area.x + area.width/2, area.y - 5*tickLength, labelSize,
            pictureCanvas::centre, pictureCanvas::high
        );
    }
    if (yLabelled)
    {
        canvas.text
        (
            yLabel_, area.x - 10*tickLength, area.y + area.height/2, labelSize,
            pictureCanvas::centre, pictureCanvas::low, false, true
        );
    }

    canvas.text
    (
        p.title, area.x + area.width/2, area.y + area.height + 12,
        panelTitleSize, pictureCanvas::centre, pictureCanvas::low
    );
}


void Foam::SPH::fieldPicture::drawBar
(
    pictureCanvas& canvas,
    const colourScale& scale,
    const pictureCanvas::rectangle& area
) const
{
    const bool upright = area.height > area.width;

    canvas.colourBar(area, scale.colours);

    segments lines(area);

    const tickMarks ticks
    (
        scale.lowest,
        scale.highest,
        max(2, label(upright ? area.height/70 : area.width/100))
    );
    for (const scalar v : ticks.values())
    {
        const scalar s = fraction(v, scale.lowest, scale.highest);
        const std::string label(ticks.label(v));
        if (upright)
        {
            const scalar y = area.y + s*area.height;
            const scalar right = area.x + area.width;
            lines.add(right, y, right + tickLength, y);
            canvas.text
            (
                label, right + 2*tickLength, y, labelSize,
                pictureCanvas::low, pictureCanvas::centre
            );
        }
        else
        {
            const scalar x = area.x + s*area.width;
            lines.add(x, area.y, x, area.y - tickLength);
            canvas.text
            (
                label, x, area.y - 2*tickLength, labelSize,
                pictureCanvas::centre, pictureCanvas::high
            );
        }
    }
    canvas.lines(lines, 1.5);

    if (upright)
    {
        canvas.text
        (
            scale.label, area.x + 0.75*uprightBarSpace,
            area.y + area.height/2, labelSize,
            pictureCanvas::centre, pictureCanvas::low, false, true
        );
    }
    else
    {
        canvas.text
        (
            scale.label, area.x + area.width/2, area.y - 5*tickLength,
            labelSize, pictureCanvas::centre, pictureCanvas::high
        );
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::SPH::fieldPicture::fieldPicture
(
    const std::string& title,
    const boundBox& box,
    const std::string& xLabel,
    const std::string& yLabel,
    const std::vector<colourScale>& scales
)
:
    title_(title),
    box_(box),
    xLabel_(xLabel),
    yLabel_(yLabel),
    scales_(scales),
    panels_()
{
    for (colourScale& scale : scales_)
    {
        // A uniform field has a colour too
        if (scale.highest - scale.lowest <= SMALL*mag(scale.highest))
        {
            const scalar widening = max(1e-3*mag(scale.highest), SMALL);
            scale.lowest -= widening;
            scale.highest += widening;
        }
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::SPH::fieldPicture::add(const panel& p)
{
    panels_.push_back(p);
}


void Foam::SPH::fieldPicture::write(const fileName& file) const
{
    const label n = panels_.size();
    const bool row = sideBySide();

    scalar width = row ? (totalWidth - (n - 1)*gap)/max(n, 2) : totalWidth;
    width = min(width, maxHeight*aspect());
    const scalar height = width/aspect();

    const scalar panelSpace = height + panelTitleSpace;
    const scalar bottom = xAxisSpace + (row ? barSpace : 0) + 0.5*margin;

    pictureCanvas canvas
    (
        row
      ? label(yAxisSpace + n*width + (n - 1)*gap + margin)
      : label(yAxisSpace + width + gap + uprightBarSpace),
        row
      ? label(bottom + panelSpace + titleSpace)
      : label(bottom + n*panelSpace + (n - 1)*0.5*gap + titleSpace)
    );

    const auto area = [&](const label i)
    {
        return pictureCanvas::rectangle
        {
            yAxisSpace + (row ? i*(width + gap) : 0),
            bottom + (row ? 0 : (n - 1 - i)*(panelSpace + 0.5*gap)),
            width,
            height
        };
    };

    for (label i = 0; i < n; ++i)
    {
        drawPanel
        (
            canvas, panels_[i], area(i), row || i == n - 1, !row || i == 0
        );

        // One bar for all following panels of the same scale
        if (i == 0 || panels_[i].scale != panels_[i - 1].scale)
        {
            label last = i;
            while (last + 1 < n && panels_[last + 1].scale == panels_[i].scale)
            {
                ++last;
            }

            const pictureCanvas::rectangle a(area(i));
            const pictureCanvas::rectangle b(area(last));
            const scalar length =
                row ? b.x + b.width - a.x : a.y + a.height - b.y;
            const scalar barLength = last > i && row ? 0.6*length : length;

            if (row)
            {
                drawBar
                (
                    canvas,
                    scales_[panels_[i].scale],
                    {
                        a.x + 0.5*(length - barLength),
                        a.y - xAxisSpace - barThickness,
                        barLength,
                        barThickness
                    }
                );
            }
            else
            {
                drawBar
                (
                    canvas,
                    scales_[panels_[i].scale],
                    {a.x + a.width + gap, b.y, barThickness, barLength}
                );
            }
        }
    }

    canvas.text
    (
        title_,
        area(0).x + 0.5*(area(n - 1).x + area(n - 1).width - area(0).x),
        area(0).y + panelSpace + 0.4*titleSpace,
        titleSize,
        pictureCanvas::centre,
        pictureCanvas::centre,
        true
    );

    canvas.write(file);
}

// ************************************************************************* //
