#!/usr/bin/env bash
# One, two and four processes under mpirun write what one process alone writes, and end together.
. "$(dirname "$0")/lib.sh"
module=$3
if ! command -v mpirun >/dev/null || [ ! -f "$module" ]; then
  echo 'skipped: no mpirun, or a program without MPI (scripts/setup extras installs it; Debian: libopenmpi-dev, openmpi-bin)'
  exit 77
fi
# One machine with fewer processors than ranks, and perhaps as root in a container, which has no other user.
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 OMPI_MCA_plm_rsh_agent=true OMPI_MCA_btl_vader_single_copy_mechanism=none
ranks() {
  local count=$1
  shift
  mpirun --oversubscribe --quiet -n "$count" "$@"
}
scenario=examples/stop-sign/stop-sign.toml
check 'controllers' exits 0 "$heed" run "$scenario" -o "$work/run" --traces 0 --json
controllers=("$work/run/base.controller.json" "$work/run/awareness.controller.json")

# alike NAME OPTIONS...: standard output and files of one process alone, then of 1, 2 and 4 ranks.
alike() {
  local name=$1
  shift
  exits 0 "$heed" simulate "$scenario" "${controllers[@]}" "$@" --output "$work/alone" || return 1
  mv "$work/out" "$work/$name"
  local count
  for count in 1 2 4; do
    exits 0 ranks "$count" "$heed" simulate "$scenario" "${controllers[@]}" "$@" --output "$work/ranks$count" || return 1
    cmp "$work/$name" "$work/out" || return 1
    [ ! -s "$work/err" ] || { cat "$work/err" >&2; return 1; }
    if [ -d "$work/alone" ]; then diff -r "$work/alone" "$work/ranks$count" || return 1; fi
  done
}
check 'as many traces as divide by no count of ranks' alike traces --traces 10007 --seed 7
check 'fewer traces than ranks' alike few --traces 3
check 'JSON' alike json --json --traces 20001
check 'threads beside ranks' alike threads --traces 50001 --threads 2
check 'until an interval is narrow' alike width --width 0.02
check 'splitting' alike rare --profile P3 --rare 'stop in 4' --particles 500
check 'chains' alike chains --chain prism --traces 0
check 'there are chains' test "$(find "$work/ranks4" -name '*.prism' | wc -l)" -eq 6

# The ranks do share the work: another seed gives other counts, so that equal bytes are no accident.
check 'another seed' exits 0 ranks 2 "$heed" simulate "$scenario" "${controllers[@]}" --traces 10007 --seed 8
check 'counts otherwise' test "$(cmp -s "$work/out" "$work/traces"; echo $?)" -eq 1

# ends CODE COMMAND...: all ranks end with the code, and one message.
ends() {
  exits "$@" || return 1
  [ "$(grep -c 'error: ' "$work/err")" -eq 1 ] || { echo 'not one message:' >&2; cat "$work/err" >&2; return 1; }
}
check 'what all refuse is said once' ends 2 ranks 4 "$heed" simulate "$scenario" "$work/none.json"
check 'bad usage is said once' ends 2 ranks 2 "$heed" simulate "$scenario" "${controllers[@]}" --traces many
for one in 0 2; do
  cat >"$work/one" <<SCRIPT
#!/bin/bash
if [ "\$OMPI_COMM_WORLD_RANK" -eq $one ]; then exec "$heed" simulate "$scenario" "$work/none.json"; fi
exec "$heed" simulate "$scenario" "${controllers[0]}" --traces 100000
SCRIPT
  chmod +x "$work/one"
  check "what rank $one alone refuses ends all" ends 2 ranks 4 "$work/one"
done
# A limit that only one of them reaches, while the others draw.
cat >"$work/slow" <<SCRIPT
#!/bin/bash
limit=none
if [ "\$OMPI_COMM_WORLD_RANK" -eq 3 ]; then limit=0.3; fi
if [ \$limit = none ]; then exec "$heed" simulate "$scenario" "${controllers[0]}" --traces 20000000 --json; fi
exec "$heed" simulate "$scenario" "${controllers[0]}" --traces 2000000000 --json --timeout \$limit
SCRIPT
chmod +x "$work/slow"
check 'a limit that one rank reaches ends all' exits 3 ranks 4 "$work/slow"
check 'and is one document' is_json
check 'which says so' says '"exit_code": 3'
finish
