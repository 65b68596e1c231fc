# harness.bash -- a few lines to test the program as a user runs it.
#
#   run ARGUMENT...             sets $status, $out, $err (files $work/out, err)
#   check NAME CONDITION...     counts one test: a command that must be true
#   asked SCRIPT ARGUMENT...    counts the tests of a script in Python
#   has TEXT FILE / hasnt ...   conditions on text
#
# Source it, test, and end with `finish`.
set -u
here=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
B=$(cd "$here" && realpath "${B:-build}")
sanggwan=${SANGGWAN:-$B/sanggwan}
data=$here/../shared/data
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
passed=0 failed=0
unset LC_ALL LC_MESSAGES
export LANG=C

run() {
  "$sanggwan" "$@" >"$work/out" 2>"$work/err" </dev/null
  status=$?
  out=$(tr -d '\0' <"$work/out") err=$(cat "$work/err")
}

check() {
  local name=$1
  shift
  if "$@"; then
    passed=$((passed + 1))
  else
    failed=$((failed + 1))
    printf 'FAILED: %s\n  condition: %s\n  status %s\n  err: %s\n' \
      "$name" "$*" "${status:-}" "${err:-}"
  fi
}

has() { grep -qF -- "$1" "${2:-$work/err}"; }
hasnt() { ! has "$@"; }
is() { [ "$1" = "$2" ]; }
status_is() { [ "$status" = "$1" ]; }
silent() { [ ! -s "$work/${1:-out}" ]; }
absent() { [ ! -e "$1" ]; }
# Nothing but the named files is in a folder, hidden files included.
holds() {
  local folder=$1
  shift
  [ "$(ls -A "$folder" | sort | tr '\n' ' ')" = "$(printf '%s\n' "$@" |
    sed '/^$/d' | sort | tr '\n' ' ')" ]
}

# asked SCRIPT ARGUMENT...: a script in Python is given the program, a folder of
# its own and the arguments; its tests are counted here.
asked() {
  local folder more less
  folder=$work/$(basename "$1")
  mkdir "$folder"
  PYTHONDONTWRITEBYTECODE=1 timeout 900 python3 "$1" "$sanggwan" "$folder" \
    "${@:2}" >"$work/asked" 2>&1
  grep -v ' passed, ' "$work/asked"
  read -r more _ less _ < <(tail -1 "$work/asked" | grep ' passed, ')
  passed=$((passed + ${more:-0})) failed=$((failed + ${less:-1}))
}

skip() { printf 'skipped: %s\n' "$1"; }

finish() {
  printf '%d passed, %d failed\n' "$passed" "$failed"
  [ "$failed" = 0 ]
  exit
}
