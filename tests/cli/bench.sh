# bench.sh -- programs of bench/ run, on little: what they print is not looked at
# as a measure here.
. "$(dirname "$0")/../check.sh"

export B
check "facts" output '^e/5 by start vertex' bench/facts 2000
check "penetration" output '^[0-9]+ lines in [0-9]+ polygons' \
  bench/penetration 60
check "triangulation" output '^polygon +vertices' bench/triangulation 50
check_report
