# Shared by the scripts beside it: a folder of one's own, and checks that say what they expected.
set -u
heed=$1
source_dir=$2
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$source_dir" || exit 2
failed=0
passed=0

# check DESCRIPTION COMMAND...: the command must succeed.
check() {
  local what=$1
  shift
  if "$@"; then passed=$((passed + 1)); else
    failed=$((failed + 1))
    printf 'FAILED: %s\n' "$what" >&2
  fi
}

# exits CODE COMMAND...: runs it, output to $work/out and $work/err.
exits() {
  local code=$1
  shift
  "$@" >"$work/out" 2>"$work/err"
  local got=$?
  [ "$got" -eq "$code" ] || { printf 'exit %s instead of %s: %s\n' "$got" "$code" "$*" >&2; head -5 "$work/err" >&2; return 1; }
}

says() { grep -qF -- "$1" "$work/out" || { printf 'not on standard output: %s\n' "$1" >&2; return 1; }; }
warns() { grep -qF -- "$1" "$work/err" || { printf 'not on standard error: %s\n' "$1" >&2; return 1; }; }
silent() { [ ! -s "$work/out" ] || { echo 'unexpected standard output' >&2; return 1; }; }
is_json() { node -e 'JSON.parse(require("fs").readFileSync(process.argv[1], "utf8"))' "$work/out"; }

finish() {
  printf '%s passed, %s failed\n' "$passed" "$failed"
  [ "$failed" -eq 0 ]
}
