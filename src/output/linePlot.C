/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "linePlot.H"
#include "tickMarks.H"

#include <sstream>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

// User units of the picture
const double width = 720;
const double height = 400;
const double left = 96;
const double right = 24;
const double top = 48;
const double bottom = 64;

std::string text
(
    const double x,
    const double y,
    const char* attributes,
    const std::string& content
)
{
    std::ostringstream os;
    os  << "<text x=\"" << x << "\" y=\"" << y << "\" " << attributes << ">"
        << Foam::SPH::linePlot::escaped(content) << "</text>\n";
    return os.str();
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::SPH::linePlot::linePlot
(
    const std::string& title,
    const std::string& xLabel,
    const std::string& yLabel,
    const scalar maxStep
)
:
    title_(title),
    xLabel_(xLabel),
    yLabel_(yLabel),
    maxStep_(maxStep),
    curves_()
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::SPH::linePlot::add(const curve& c)
{
    curves_.append(c);
}


std::string Foam::SPH::linePlot::escaped(const std::string& text)
{
    std::string result;
    for (const char c : text)
    {
        switch (c)
        {
            case '<': result += "&lt;"; break;
            case '>': result += "&gt;"; break;
            case '&': result += "&amp;"; break;
            case '"': result += "&quot;"; break;
            default: result += c;
        }
    }
    return result;
}


std::string Foam::SPH::linePlot::svg() const
{
    scalar xMin = GREAT, xMax = -GREAT, yMin = GREAT, yMax = -GREAT;
    for (const curve& c : curves_)
    {
        if (c.x.size())
        {
            xMin = min(xMin, min(c.x));
            xMax = max(xMax, max(c.x));
            yMin = min(yMin, min(c.y));
            yMax = max(yMax, max(c.y));
        }
    }

    // Uniform curves run through the middle
    const scalar margin =
        max(0.06*(yMax - yMin), max(1e-3*mag(yMax), VSMALL));
    yMin -= margin;
    yMax += margin;
    if (xMax - xMin < VSMALL)
    {
        xMin -= 1;
        xMax += 1;
    }

    const double w = width - left - right;
    const double h = height - top - bottom;
    const auto px = [&](const scalar x)
    {
        return left + w*(x - xMin)/(xMax - xMin);
    };
    const auto py = [&](const scalar y)
    {
        return top + h*(yMax - y)/(yMax - yMin);
    };

    std::ostringstream os;
    os.precision(6);
    os  << "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 " << width
        << " " << height << "\" font-family=\"Helvetica, Arial, sans-serif\""
        << " font-size=\"14\" fill=\"#222\">\n"
        << "<rect width=\"" << width << "\" height=\"" << height
        << "\" fill=\"white\"/>\n";

    const tickMarks xTicks(xMin, xMax, 8);
    const tickMarks yTicks(yMin, yMax, 6);

    os  << "<g stroke=\"#ddd\">\n";
    for (const scalar x : xTicks.values())
    {
        os  << "<path d=\"M" << px(x) << " " << top << "v" << h << "\"/>\n";
    }
    for (const scalar y : yTicks.values())
    {
        os  << "<path d=\"M" << left << " " << py(y) << "h" << w << "\"/>\n";
    }
    os  << "</g>\n";

    for (const scalar x : xTicks.values())
    {
        os  << text
            (
                px(x), height - bottom + 20, "text-anchor=\"middle\"",
                xTicks.label(x)
            );
    }
    for (const scalar y : yTicks.values())
    {
        os  << text
            (
                left - 8, py(y) + 5, "text-anchor=\"end\"", yTicks.label(y)
            );
    }

    double legend = left + 16;
    for (const curve& c : curves_)
    {
        os  << "<path fill=\"none\" " << c.style << " d=\"";
        forAll(c.x, i)
        {
            const bool broken = i == 0 || mag(c.x[i] - c.x[i - 1]) > maxStep_;
            os  << (broken ? "M" : "L") << px(c.x[i]) << " " << py(c.y[i]);
        }
        os  << "M" << legend << " " << top - 13 << "h24\"/>\n";
        os  << text(legend + 32, top - 8, "", c.name);
        legend += 60 + 8.5*c.name.size();
    }

    os  << "<rect x=\"" << left << "\" y=\"" << top << "\" width=\"" << w
        << "\" height=\"" << h << "\" fill=\"none\" stroke=\"#222\"/>\n"
        << text
           (
               width - right, top - 8,
               "text-anchor=\"end\" font-weight=\"bold\"", title_
           )
        << text
           (
               left + w/2, height - 16, "text-anchor=\"middle\"", xLabel_
           )
        << "<g transform=\"translate(22 " << top + h/2 << ") rotate(-90)\">"
        << text(0, 0, "text-anchor=\"middle\"", yLabel_) << "</g>\n"
        << "</svg>\n";

    return os.str();
}

// ************************************************************************* //
