#!/usr/bin/env bash
# Wrong usage and bad input: one message, the documented exit code, nothing on standard output.
. "$(dirname "$0")/lib.sh"
scenario=examples/stop-sign/stop-sign.toml

check 'no command' exits 2 "$heed"
check 'unknown command' exits 2 "$heed" rum
check 'the nearest one is named' warns "did you mean 'run'"
check 'unknown option' exits 2 "$heed" run "$scenario" --outptu x
check 'the nearest option is named' warns "did you mean '--output'"
check 'missing operand' exits 2 "$heed" verify one.json
check 'too many operands' exits 2 "$heed" kb a b
check 'a bad number' exits 2 "$heed" run "$scenario" --seed minus
check 'a missing file' exits 2 "$heed" run none.toml
check 'nothing on standard output' silent
check 'a missing file in JSON' exits 2 "$heed" run none.toml --json
check 'is JSON as well' is_json
check 'a folder' exits 2 "$heed" kb examples
check 'a file that is too large' exits 2 "$heed" kb examples/stop-sign/traffic-signs.owl --max-input 1K
check 'no time' exits 3 "$heed" run "$scenario" -o "$work/late" --timeout 0.000001
check 'nothing half written' test ! -e "$work/late"
check 'no memory' exits 3 "$heed" run "$scenario" -o "$work/small" --memory 1M
check 'nothing half written' test ! -e "$work/small"
check 'an unknown word' exits 2 "$heed" export "$scenario" --to java
printf '[input]\na : boolean\n[output]\nb : boolean\n[sys safety]\nb <-> a'"'"'\n' >"$work/no.gr1"
sed -i 's/^b <-> a.*/b <-> X a/' "$work/no.gr1"
check 'an unrealizable specification' exits 1 "$heed" synth "$work/no.gr1" --realizability
check 'says so first' test "$(head -n 1 "$work/out")" = UNREALIZABLE
check 'in the style of SYNTCOMP' exits 20 "$heed" synth "$work/no.gr1" --realizability --exit-code syntcomp
finish
