#!/usr/bin/env bash
# A controller in a pipe, and as a C++ header in a program.
. "$(dirname "$0")/lib.sh"

"$heed" run examples/stop-sign/stop-sign.toml -o "$work/run" >/dev/null 2>&1
controller=$work/run/awareness.controller.json
printf '%s\n' '{}' '{"sign": true}' '{"sign": true, "red": true}' 'nonsense' '{"rde": true}' '{"reset": true}' >"$work/in"
check 'exec answers' exits 0 "$heed" exec "$controller" <"$work/in"
check 'one answer a line' test "$(wc -l <"$work/out")" -eq 6
check 'two features halt' test "$(sed -n 3p "$work/out" | grep -c '"prescribed_halt"')" -eq 1
check 'nonsense is answered' test "$(sed -n 4p "$work/out" | grep -c '"error"')" -eq 1
check 'a slip is corrected' test "$(sed -n 5p "$work/out" | grep -c "did you mean 'red'")" -eq 1
check 'export as C++' exits 0 "$heed" export "$controller" --to cpp -o "$work/awareness.hpp"
check 'it compiles alone' g++ -std=c++17 -Wall -Wextra -Werror -fno-exceptions -fsyntax-only -x c++ "$work/awareness.hpp"
finish
