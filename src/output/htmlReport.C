/*---------------------------------------------------------------------------*\
    eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
-------------------------------------------------------------------------------
License
    This file is part of eulerianSPH, distributed under the GNU General Public
    License v3.0 or later; see the file LICENSE.

\*---------------------------------------------------------------------------*/

#include "htmlReport.H"
#include "base64Layer.H"
#include "error.H"
#include "linePlot.H"
#include "OSspecific.H"

#include <fstream>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

std::string escaped(const std::string& text)
{
    return Foam::SPH::linePlot::escaped(text);
}

const char* const style = R"(
body { font-family: Helvetica, Arial, sans-serif; color: #222; margin: 2em auto;
    max-width: 1180px; padding: 0 1em; line-height: 1.45; }
h1 { font-size: 1.6em; margin-bottom: 0.2em; }
h2 { font-size: 1.2em; margin-top: 2em; border-bottom: 1px solid #ccc; }
table { border-collapse: collapse; margin: 1em 0; font-size: 0.92em; }
th, td { padding: 0.25em 0.9em; text-align: left; }
th { border-bottom: 2px solid #222; }
td { border-bottom: 1px solid #e4e4e4; }
td.number, th.number { text-align: right;
    font-variant-numeric: tabular-nums; }
img { max-width: 100%; display: block; margin: 1em auto; }
div.drawings { display: flex; flex-wrap: wrap; gap: 1em; }
div.drawings svg { flex: 1 1 480px; max-width: 720px; }
)";

} // End anonymous namespace


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::SPH::htmlReport::htmlReport(const std::string& title)
:
    title_(title),
    body_()
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::SPH::htmlReport::heading(const std::string& text)
{
    body_<< "<h2>" << escaped(text) << "</h2>\n";
}


void Foam::SPH::htmlReport::paragraph(const std::string& text)
{
    body_<< "<p>" << escaped(text) << "</p>\n";
}


void Foam::SPH::htmlReport::table
(
    const row& header,
    const std::vector<row>& rows,
    const std::size_t nWordColumns
)
{
    const auto addRow = [&](const row& cells, const std::string& tag)
    {
        body_<< "<tr>";
        for (std::size_t i = 0; i < cells.size(); ++i)
        {
            body_<< '<' << tag
                << (i < nWordColumns ? ">" : " class=\"number\">")
                << escaped(cells[i]) << "</" << tag << '>';
        }
        body_<< "</tr>\n";
    };

    body_<< "<table>\n";
    addRow(header, "th");
    for (const row& cells : rows)
    {
        addRow(cells, "td");
    }
    body_<< "</table>\n";
}


void Foam::SPH::htmlReport::picture
(
    const fileName& file,
    const std::string& description
)
{
    std::ifstream is(file, std::ios::binary);
    std::ostringstream bytes;
    bytes << is.rdbuf();
    const std::string content(bytes.str());

    body_<< "<img alt=\"" << escaped(description)
        << "\" src=\"data:image/png;base64,";
    base64Layer encoder(body_);
    encoder.write(content.data(), content.size());
    encoder.close();
    body_<< "\"/>\n";
}


void Foam::SPH::htmlReport::drawings(const std::vector<std::string>& svg)
{
    body_<< "<div class=\"drawings\">\n";
    for (const std::string& drawing : svg)
    {
        body_<< drawing;
    }
    body_<< "</div>\n";
}


void Foam::SPH::htmlReport::write(const fileName& file) const
{
    mkDir(file.path());
    std::ofstream os(file);

    os  << "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n"
        << "<meta charset=\"utf-8\"/>\n<title>" << escaped(title_)
        << "</title>\n<style>" << style << "</style>\n</head>\n<body>\n<h1>"
        << escaped(title_) << "</h1>\n" << body_.str()
        << "</body>\n</html>\n";

    os.close();
    if (!os)
    {
        FatalErrorInFunction
            << "Cannot write " << file << exit(FatalError);
    }
}

// ************************************************************************* //
