#------------------------------------------------------------------------------
# eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
#------------------------------------------------------------------------------
# License
#     This file is part of eulerianSPH, distributed under the GNU General Public
#     License v3.0 or later; see the file LICENSE.
#
# File
#     etc/plotCurves.awk
#
# Description
#     Draws a column of tables of comma-separated values over their first column
#     as an SVG, one curve for each file, named after it. The ordinate is
#     logarithmic; values that are not positive are left out. With -v logX=1 the
#     abscissa is logarithmic too, points are marked, and a curve's name is
#     followed by its slope, of least squares.
#
#         awk -v title='Residual' -v xLabel=iteration -v yLabel=residual \
#             -v column=3 -f etc/plotCurves.awk a.csv b.csv > residual.svg
#------------------------------------------------------------------------------

BEGIN {
    FS = ","
    width = 720; height = 460
    left = 80; right = 20; top = 44; bottom = 60
    split("#1f77b4 #d62728 #2ca02c #9467bd #ff7f0e #8c564b", colours, " ")
    xMin = 0
    xMax = 0
    nCurves = 0
}

FNR == 1 {
    ++nCurves
    name = FILENAME
    sub(/.*\//, "", name)
    sub(/(\.curve)?\.csv$/, "", name)
    names[nCurves] = name
    count[nCurves] = 0
    next
}

$column > 0 && (!logX || $1 > 0) {
    x = logX ? log($1)/log(10) : $1
    y = log($column)/log(10)
    k = ++count[nCurves]
    xs[nCurves, k] = x
    ys[nCurves, k] = y
    if (x > xMax || logX && !started) xMax = x
    if (logX && (!started || x < xMin)) xMin = x
    if (!started || y < yMin) yMin = y
    if (!started || y > yMax) yMax = y
    started = 1
}

function floor(v)
{
    return v < int(v) ? int(v) - 1 : int(v)
}

function toX(x)
{
    return left + (width - left - right) \
       *(xMax > xMin ? (x - xMin)/(xMax - xMin) : 0)
}

function toY(y)
{
    return height - bottom - (height - top - bottom)*(y - yMin)/(yMax - yMin)
}

function decade(v)
{
    return v >= -1 && v <= 4 ? 10^v "" : "1e" v
}

# Slope of the curve c
function slope(c,    k, n, x, y, xx, xy)
{
    n = count[c]
    for (k = 1; k <= n; ++k)
    {
        x += xs[c, k]
        y += ys[c, k]
        xx += xs[c, k]^2
        xy += xs[c, k]*ys[c, k]
    }
    return n*xx > x*x ? sprintf("%.2f", (n*xy - x*y)/(n*xx - x*x)) : "-"
}

function text(x, y, anchor, s)
{
    printf "<text x=\"%.1f\" y=\"%.1f\" text-anchor=\"%s\">%s</text>\n",
        x, y, anchor, s
}

END {
    if (!started)
    {
        yMin = 0
        yMax = 1
    }
    yMin = floor(yMin)
    yMax = floor(yMax) + 1

    printf "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"%d\" " \
        "height=\"%d\" font-family=\"sans-serif\" font-size=\"13\">\n",
        width, height
    print "<rect width=\"100%\" height=\"100%\" fill=\"white\"/>"
    text(0.5*width, 24, "middle", title)
    text(0.5*(left + width - right), height - 14, "middle", xLabel)
    printf "<text transform=\"translate(18 %.1f) rotate(-90)\" " \
        "text-anchor=\"middle\">%s</text>\n",
        0.5*(top + height - bottom), yLabel

    # Decades, not more than about ten of them
    step = floor((yMax - yMin - 1)/10) + 1
    for (y = yMin; y <= yMax; y += step)
    {
        printf "<path d=\"M%.1f %.1fH%.1f\" stroke=\"#ddd\"/>\n",
            left, toY(y), width - right
        text(left - 6, toY(y) + 4, "end", "1e" y)
    }
    if (logX)
    {
        xMin = floor(xMin)
        xMax = floor(xMax) + 1
    }
    step = logX ? 1 : xMax/5
    for (i = 0; xMin + i*step < xMax + 0.5*step; ++i)
    {
        x = xMin + i*step
        printf "<path d=\"M%.1f %.1fV%.1f\" stroke=\"#ddd\"/>\n",
            toX(x), top, height - bottom
        text(toX(x), height - bottom + 18, "middle",
            logX ? decade(x) : sprintf("%.4g", x))
    }

    for (c = 1; c <= nCurves; ++c)
    {
        printf "<polyline fill=\"none\" stroke=\"%s\" stroke-width=\"1.5\" " \
            "points=\"", colours[(c - 1) % 6 + 1]
        for (k = 1; k <= count[c]; ++k)
        {
            printf "%.1f,%.1f ", toX(xs[c, k]), toY(ys[c, k])
        }
        print "\"/>"
        for (k = 1; logX && k <= count[c]; ++k)
        {
            printf "<circle cx=\"%.1f\" cy=\"%.1f\" r=\"4\" " \
                "fill=\"%s\"/>\n",
                toX(xs[c, k]), toY(ys[c, k]), colours[(c - 1) % 6 + 1]
        }
        printf "<path d=\"M%d %dh24\" stroke=\"%s\" stroke-width=\"3\"/>\n",
            width - 230, top + 18*c - 4, colours[(c - 1) % 6 + 1]
        text(width - 200, top + 18*c, "start",
            names[c] (logX ? ", slope " slope(c) : ""))
    }
    print "</svg>"
}
