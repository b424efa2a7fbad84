#!/usr/bin/env bash
# Every table of docs/driving.md is what its command prints: each line between "…" and "…", or up to the end of the block.
. "$(dirname "$0")/lib.sh"
page=docs/driving.md

if ! "$heed" drive examples/stop-sign/stop-sign.toml --roads 1 --profile P2 -o "$work/probe" --json >"$work/out" 2>/dev/null; then
  echo 'skipped: no SUMO (Debian: sumo, sumo-tools)'
  exit 77
fi
if ! grep -q '"simulator": "SUMO 1.15.0"' "$work/out"; then
  echo 'skipped: the page was written with SUMO 1.15.0'
  exit 77
fi
for name in stop-sign speed-levels; do
  check "drive $name" exits 0 "$heed" drive "examples/stop-sign/$name.toml" -o "$work/$name"
  cat "$work/out" >>"$work/printed"
done
lines=0
while IFS= read -r line; do
  lines=$((lines + 1))
  check "is printed: $line" grep -qxF -- "$line" "$work/printed"
done < <(awk '/^```/ { inside = /console/; next } inside && !/^[$…]/ && NF' "$page")
check 'the page has its tables' test "$lines" -ge 40
finish
