# A cactus plot of the lines file, tool, verdict, CPU s, MB: how many files each tool decides within a time, by its best run.
function y(time) { return 360 - 320 * log((time < 0.001 ? 0.001 : time) / 0.001) / log(limit / 0.001) }
BEGIN { FS = "\t"; count = split(tools, tool, " "); split("#0072b2 #d55e00 #009e73 #cc79a7", colour, " ") }
{
  if (!($1 in seen)) { seen[$1]; ++total }
  if ($3 ~ /^[RU]$/ && (!(($2, $1) in best) || $4 < best[$2, $1])) best[$2, $1] = $4
}
END {
  print "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 640 420\" font-family=\"sans-serif\" font-size=\"12\">"
  print "<title>Specifications decided within a CPU time</title><rect width=\"640\" height=\"420\" fill=\"white\"/>"
  for (time = 0.001; time <= limit; time *= 10)
    printf "<line x1=\"60\" x2=\"620\" y1=\"%.1f\" y2=\"%.1f\" stroke=\"#ddd\"/><text x=\"54\" y=\"%.1f\" text-anchor=\"end\">%g s</text>\n", y(time), y(time), y(time) + 4, time
  for (part = 0; part <= 4; ++part)
    printf "<text x=\"%.1f\" y=\"380\" text-anchor=\"middle\">%d</text>\n", 60 + 140 * part, total * part / 4
  print "<text x=\"340\" y=\"404\" text-anchor=\"middle\">specifications decided</text>"
  for (t = 1; t <= count; ++t) {
    n = 0; delete sorted
    for (key in best) {
      split(key, part_of, SUBSEP); if (part_of[1] != tool[t]) continue
      for (i = ++n; i > 1 && sorted[i - 1] > best[key]; --i) sorted[i] = sorted[i - 1]
      sorted[i] = best[key]
    }
    printf "<polyline fill=\"none\" stroke-width=\"2\" stroke=\"%s\" points=\"", colour[t]
    for (i = 1; i <= n; ++i) printf "%.1f,%.1f ", 60 + 560 * i / total, y(sorted[i])
    printf "\"/>\n<text x=\"70\" y=\"%d\" fill=\"%s\">%s: %d of %d</text>\n", 50 + 16 * t, colour[t], tool[t], n, total
  }
  print "</svg>"
}
