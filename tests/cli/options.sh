#!/usr/bin/env bash
# Every option of the table is read by some command, is completed by bash, and stands in the man page.
. "$(dirname "$0")/lib.sh"

"$heed" --bash-completion >"$work/completion"
"$heed" --man >"$work/man"
check 'the completion is valid bash' bash -n "$work/completion"
for command in $("$heed" --help | awk '/^  [a-z]/ { print $1 }'); do
  check "$command has help with an example" exits 0 "$heed" "$command" --help
  check "$command shows an example" says 'example:'
  for option in $(grep -oE -- '--[a-z0-9-]+' "$work/out" | sort -u); do
    [ "$option" = --help ] && continue
    check "$option is completed" grep -qF -- "$option" "$work/completion"
    check "$option is in the man page" grep -qF -- "$(printf '%s' "$option" | sed 's/-/\\-/g')" "$work/man"
  done
done
for option in $(grep -oE '^ *\{*"--[a-z0-9-]+"' src/cli/table.cpp | grep -oE -- '--[a-z0-9-]+' | sort -u); do
  check "$option of the table is used" grep -qrF -- "\"$option\"" src/cli --include=command_*.cpp --include=inputs.cpp --include=arguments.*
done
check 'the man page has a name section' grep -q '^.SH NAME' "$work/man"
finish
