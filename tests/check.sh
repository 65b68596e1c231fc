# check.sh -- the harness of the shell tests; source it first:
#
#   . "$(dirname "$0")/../check.sh"
#   check "cube is closed"      status 0 $SANGGWAN check facts/cube.pl
#   check "and says so"         output 'closed' $SANGGWAN check facts/cube.pl
#   check "bad option is usage" status 2 $SANGGWAN draw --nonsense
#   check_report
#
# Tests run in the project's root. $B is the folder of the build, $SANGGWAN the
# program under test, $TMP a folder that goes away at the end. The locale is C, as on a bare machine.
export LANG=C LC_ALL=C
B=$(realpath "${B:-build}")
: "${SANGGWAN:=$B/sanggwan}"
TMP=$(mktemp -d)
trap 'rm -rf "$TMP"' EXIT
check_passed=0 check_failed=0 check_skipped=0

# check NAME COMMAND...: the command must succeed.
check() {
  local name=$1
  shift
  if "$@" >"$TMP/check.log" 2>&1; then
    check_passed=$((check_passed + 1))
  else
    check_failed=$((check_failed + 1))
    printf '%s: failed: %s\n' "$name" "$*"
    sed 's/^/  | /' "$TMP/check.log"
  fi
}

# skip NAME REASON: says that something cannot be tried here.
skip() {
  check_skipped=$((check_skipped + 1))
  printf 'skipped: %s: %s\n' "$1" "$2"
}

# status N COMMAND...: exits with N.
status() {
  local want=$1 got
  shift
  "$@"
  got=$?
  [ "$got" = "$want" ] || { echo "exit status $got, wanted $want"; return 1; }
}

# output REGEX COMMAND...: succeeds, and a line of stdout matches.
output() {
  local regex=$1
  shift
  "$@" >"$TMP/output" || { echo "exit status $?"; cat "$TMP/output"; return 1; }
  grep -Eq -- "$regex" "$TMP/output" ||
    { cat "$TMP/output"; echo "no line matches: $regex"; return 1; }
}

# complains N REGEX COMMAND...: exits with N, and a line of stderr matches.
complains() {
  local want=$1 regex=$2 got
  shift 2
  "$@" >"$TMP/output" 2>"$TMP/errors"
  got=$?
  cat "$TMP/errors"
  [ "$got" = "$want" ] || { echo "exit status $got, wanted $want"; return 1; }
  grep -Eq -- "$regex" "$TMP/errors" ||
    { echo "no line of stderr matches: $regex"; return 1; }
}

check_report() {
  echo "$check_passed passed, $check_failed failed"
  [ "$check_failed" = 0 ]
}
