#!/usr/bin/env bash
# `heed drive` as a user meets it, with SUMO or without.
. "$(dirname "$0")/lib.sh"
scenario=examples/stop-sign/stop-sign.toml

sed '$a [drive]\nroads = 0' "$scenario" | sed "s|\"traffic-signs.owl\"|\"$PWD/examples/stop-sign/traffic-signs.owl\"|; s|\"car.fts\"|\"$PWD/examples/stop-sign/car.fts\"|" >"$work/bad.toml"
check 'a bad value' exits 2 "$heed" drive "$work/bad.toml" -o "$work/bad"
check 'is told with its place' warns "bad.toml:$(wc -l <"$work/bad.toml"):9: error: 'roads' is 0"
check 'nothing half written' test ! -e "$work/bad"

if "$heed" drive "$scenario" --roads 1 --profile P2 -o "$work/probe" >"$work/out" 2>"$work/err"; then
  check 'drive' exits 0 "$heed" drive "$scenario" --roads 40 -o "$work/drive"
  check 'drive prints the metres' says 'halts at m'
  for file in drive.csv drive-summary.csv drive.json drive-speed.svg drive-braking.svg drive-metres.svg; do
    check "drive writes $file" test -s "$work/drive/$file"
  done
  check 'a line for each road' test "$(wc -l <"$work/drive/drive.csv")" -eq $((1 + 40 * 4 * 3))
  check 'drive --json' exits 0 "$heed" drive "$scenario" --roads 40 -o "$work/again" --json
  check 'drive --json is JSON' is_json
  check 'and what is written' cmp -s "$work/out" "$work/again/drive.json"
  check 'the same roads' cmp -s "$work/drive/drive.csv" "$work/again/drive.csv"
  check 'drive --controller --profile --thing' exits 0 "$heed" drive "$scenario" --roads 20 --controller awareness --profile P2 --thing none -o "$work/none"
  check 'nothing there, nobody halts' test "$(grep -c ',infeasible,,0,' "$work/none/drive.csv")" -eq 20
  check 'run --drive' exits 0 "$heed" run "$scenario" --drive --traces 100 -o "$work/run"
  check 'the report drives' grep -q 'id="driving"' "$work/run/report.html"
  check 'with the figures of heed drive' grep -q '"halted_at_line"' "$work/run/report.json"
  check 'an unknown profile' exits 2 "$heed" drive "$scenario" --profile P7 -o "$work/p7"
  check 'the nearest one is named' warns "'P1'"
  check 'an unknown thing' exits 2 "$heed" drive "$scenario" --thing Stopsing -o "$work/thing"
  check 'no time' exits 3 "$heed" drive "$scenario" --roads 40 -o "$work/late" --timeout 0.000001
  check 'nothing half written' test ! -e "$work/late"
else
  check 'without SUMO it says so' exits 2 "$heed" drive "$scenario"
  check 'and how to get it' warns 'scripts/setup extras'
  check 'in JSON as well' exits 2 "$heed" drive "$scenario" --json
  check 'is JSON' is_json
  echo 'skipped: driving, no SUMO (Debian: sumo, sumo-tools)'
fi
finish
