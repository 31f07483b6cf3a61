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
#     logarithmic; values that are not positive are left out.
#
#         awk -v title='Residual' -v xLabel=iteration -v yLabel=residual \
#             -v column=3 -f etc/plotCurves.awk a.csv b.csv > residual.svg
#------------------------------------------------------------------------------

BEGIN {
    FS = ","
    width = 720; height = 460
    left = 80; right = 20; top = 44; bottom = 60
    split("#1f77b4 #d62728 #2ca02c #9467bd #ff7f0e #8c564b", colours, " ")
    xMax = 0
    nCurves = 0
}

FNR == 1 {
    ++nCurves
    name = FILENAME
    sub(/.*\//, "", name)
    sub(/\.csv$/, "", name)
    names[nCurves] = name
    count[nCurves] = 0
    next
}

$column > 0 {
    y = log($column)/log(10)
    k = ++count[nCurves]
    xs[nCurves, k] = $1
    ys[nCurves, k] = y
    if ($1 > xMax) xMax = $1
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
    return left + (width - left - right)*(xMax > 0 ? x/xMax : 0)
}

function toY(y)
{
    return height - bottom - (height - top - bottom)*(y - yMin)/(yMax - yMin)
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
        "text-anchor=\"middle\">%s</text>\n", 0.5*(top + height - bottom), yLabel

    # Decades, not more than about ten of them
    step = floor((yMax - yMin - 1)/10) + 1
    for (y = yMin; y <= yMax; y += step)
    {
        printf "<path d=\"M%.1f %.1fH%.1f\" stroke=\"#ddd\"/>\n",
            left, toY(y), width - right
        text(left - 6, toY(y) + 4, "end", "1e" y)
    }
    for (i = 0; i <= 5; ++i)
    {
        printf "<path d=\"M%.1f %.1fV%.1f\" stroke=\"#ddd\"/>\n",
            toX(xMax*i/5), top, height - bottom
        text(toX(xMax*i/5), height - bottom + 18, "middle",
            sprintf("%.4g", xMax*i/5))
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
        printf "<path d=\"M%d %dh24\" stroke=\"%s\" stroke-width=\"3\"/>\n",
            width - 200, top + 18*c - 4, colours[(c - 1) % 6 + 1]
        text(width - 170, top + 18*c, "start", names[c])
    }
    print "</svg>"
}
