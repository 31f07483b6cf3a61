#------------------------------------------------------------------------------
# eulerianSPH: body-fitted Eulerian SPH beside the finite-volume method
#------------------------------------------------------------------------------
# License
#     This file is part of eulerianSPH, distributed under the GNU General Public
#     License v3.0 or later; see the file LICENSE.
#
# File
#     tests/benchmark/runTimeError/ratios.awk
#
# Description
#     A line of the table of ratios from the results of one scene: user seconds
#     of one method over another at the least error that both reach, but not
#     below the uncertainty of the reference, with generation and, in brackets,
#     without. An error counts as reached if no finer run has a larger one.
#     Seconds are linear between measured points, both logarithmic. If
#     one of the two is more accurate at its coarsest than the other ever was,
#     they have no error in common, and the ratio of their cheapest and dearest
#     run is only a bound: < or >.
#
#         awk -F, -v uncertainty=1e-3 -f ratios.awk results.csv
#
#     With -v header=1, the head of the table instead.
#------------------------------------------------------------------------------

BEGIN {
    nColumns = split("cellsSchemes/cells particles/cells " \
        "particles/cellsSchemes native/cells native/cellsSchemes " \
        "hybrid/cells papers/particles papers/native", columns, " ")
    if (header)
    {
        line = "| scene |"
        rule = "|---|"
        for (c = 1; c <= nColumns; ++c)
        {
            line = line " " columns[c] " |"
            rule = rule "---|"
        }
        print line
        print rule
        exit
    }
}

$8 + 0 > 0 {
    scene = $1
    k = ++count[$2]
    error[$2, k] = $8
    seconds[$2, k, 0] = $7
    seconds[$2, k, 1] = $6 + $7
    least[$2] = $8
    for (--k; k > 0 && error[$2, k] < $8; --k) error[$2, k] = $8
}

# Seconds in which a method reaches the error e
function secondsTo(method, e, generation,    k, a, b)
{
    for (k = 1; error[method, k] > e; ++k);
    b = seconds[method, k, generation]
    if (k == 1) return b
    a = seconds[method, k - 1, generation]
    return a*(b/a)^(log(error[method, k - 1]/e) \
        /log(error[method, k - 1]/error[method, k]))
}

function ratio(x, y, generation,    e)
{
    e = least[x] > least[y] ? least[x] : least[y]
    if (e < uncertainty) e = uncertainty
    if (error[x, 1] < e && error[y, 1] < e) return "-"
    if (error[x, 1] < e)
    {
        return "< " sprintf("%.2g", \
            seconds[x, 1, generation]/seconds[y, count[y], generation])
    }
    if (error[y, 1] < e)
    {
        return "> " sprintf("%.2g", \
            seconds[x, count[x], generation]/seconds[y, 1, generation])
    }
    return sprintf("%.2g", \
        secondsTo(x, e, generation)/secondsTo(y, e, generation))
}

END {
    if (header) exit
    line = "| " scene " |"
    for (c = 1; c <= nColumns; ++c)
    {
        split(columns[c], pair, "/")
        line = line " " (count[pair[1]] && count[pair[2]] \
            ? ratio(pair[1], pair[2], 1) " (" ratio(pair[1], pair[2], 0) ")" \
            : "") " |"
    }
    print line
}
