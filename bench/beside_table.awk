# Medians of the lines file, tool, verdict, CPU s, MB; ratios of each peer to heed, and their geometric mean over the files that take
# the peer 0.5 s or more. Exit code 1 where verdicts differ.
function median(list, n,   i, j, swap, value) {
  for (i = 1; i <= n; ++i) value[i] = list[i] + 0
  for (i = 2; i <= n; ++i) for (j = i; j > 1 && value[j - 1] > value[j]; --j) { swap = value[j]; value[j] = value[j - 1]; value[j - 1] = swap }
  return (value[int((n + 1) / 2)] + value[int(n / 2) + 1]) / 2
}
function note(file, tool, said) {
  if (said == "T") return
  if (file in right && right[file] != said) { wrong[++wrongs] = file ": " tool " says " said ", not " right[file]; return }
  right[file] = said
}
BEGIN {
  FS = "\t"; count = split(tools, tool, " ")
  if (manifest != "") {
    while ((getline line < manifest) > 0) {
      cells = split(line, cell, ",")
      if (!header) { for (i = 1; i <= cells; ++i) column[cell[i]] = i; header = 1; continue }
      name = cell[column["spec"]]; sub(/\.[a-z0-9]*$/, "", name)
      if (cell[column["verdict"]] ~ /^[RU]$/) right[name] = cell[column["verdict"]]
    }
  }
}
{
  if (!($1 in seen)) { seen[$1]; files[++total] = $1 }
  if ($3 == "E") { refused[++refusals] = $2 " refuses " $1; next }
  n = ++runs[$1, $2]; cpu[$1, $2, n] = $4; mb[$1, $2, n] = $5
  if ($3 == "T") late[$1, $2] = 1
  note($1, $2, $3)
}
END {
  printf "| specification | verdict |"; for (t = 1; t <= count; ++t) printf " %s s | MB |", tool[t]
  for (t = 2; t <= count; ++t) printf " %s / heed |", tool[t]
  printf "\n|---|---|"; for (t = 1; t <= 3 * count - 1; ++t) printf "---|"; print ""
  for (f = 1; f <= total; ++f) {
    file = files[f]; printf "| %s | %s |", file, file in right ? right[file] : "?"
    for (t = 1; t <= count; ++t) {
      n = runs[file, tool[t]]; if (!n) { printf " | |"; continue }
      for (i = 1; i <= n; ++i) { times[i] = cpu[file, tool[t], i]; sizes[i] = mb[file, tool[t], i] }
      middle[tool[t]] = median(times, n)
      printf " %s%.3f | %.0f |", (file, tool[t]) in late ? ">" : "", middle[tool[t]], median(sizes, n)
    }
    for (t = 2; t <= count; ++t) {
      if (!runs[file, tool[t]]) { printf " |"; continue }
      ratio = middle[tool[t]] / (middle["heed"] > 0.001 ? middle["heed"] : 0.001)
      printf " %.1f |", ratio
      if (middle[tool[t]] >= 0.5) { logs[tool[t]] += log(ratio); long[tool[t]]++ }
    }
    print ""
  }
  print ""
  for (t = 2; t <= count; ++t)
    if (long[tool[t]]) printf "%s takes 0.5 s or more on %d: geometric mean of the ratios %.1f\n", tool[t], long[tool[t]], exp(logs[tool[t]] / long[tool[t]])
  for (i = 1; i <= refusals; ++i) if (!(refused[i] in told)) { told[refused[i]]; print refused[i] }
  for (i = 1; i <= wrongs; ++i) print "WRONG " wrong[i]
  exit (wrongs > 0)
}
