# boolean_same.sh -- the same input gives the same bytes: for any number of
# threads, and for any order of the operands of a union or an intersection.
cd "$(dirname "$0")/../.." || exit 2
. tests/check.sh

solid() { # solid NAME TERM: a model of one primitive
  echo "segment(1, solid, $2)." >"$TMP/$1.pl"
}
turn='rotate(axis(1,2,3),40)'
solid ball "at([translate(0.3,0.2,0.1)],
  sphere(radius(1), facets(48), bands(24)))"
solid ring "torus(radius(1), tube(0.4), facets(48), sides(24))"
solid box "at([$turn], box(size(2,2,2)))"
solid lid "at([translate(0.5,0.25,2),$turn], box(size(1,1,1)))"
solid roof "at([translate(0,0,2),$turn], pyramid(base(2,2), height(1)))"

# made OUT VERB NAME...: the operation on models, to $TMP/OUT.
made() {
  local out=$1 verb=$2
  shift 2
  "$SANGGWAN" "$verb" -q "${@/%/.pl}" -o "$out"
}

# same_threads VERB ENDING NAME...: on one processor and on all.
same_threads() {
  local verb=$1 ending=$2
  shift 2
  (cd "$TMP" && made "one.$ending" "$verb" "$@" ) &&
    (cd "$TMP" && taskset -c 0 "$SANGGWAN" "$verb" -q "${@/%/.pl}" \
      -o "all.$ending") && cmp "$TMP/one.$ending" "$TMP/all.$ending"
}

# same_order VERB ENDING NAME...: backwards too.
same_order() {
  local verb=$1 ending=$2 name back=()
  shift 2
  for name; do back=("$name" "${back[@]}"); done
  (cd "$TMP" && made "forth.$ending" "$verb" "$@" &&
    made "back.$ending" "$verb" "${back[@]}" &&
    cmp "forth.$ending" "back.$ending")
}

case $SANGGWAN in /*) ;; *) SANGGWAN=$PWD/$SANGGWAN ;; esac
checker=$B/tests/solid_checker
if command -v taskset >/dev/null; then
  for verb in union intersection difference; do
    check "$verb: any number of threads" same_threads "$verb" off ball ring box
    check "$verb: the result is a solid" "$checker" "$TMP/all.off"
  done
  check "touching: any number of threads" same_threads union pl box lid roof
else
  skip "any number of threads" "no taskset"
fi
for ending in off stl obj ply; do
  check "union: any order, .$ending" same_order union "$ending" ball ring box
done
check "intersection: any order" same_order intersection off ball ring box
check "touching: any order" same_order union stl box lid roof
check "touching: the result is a solid" "$checker" "$TMP/back.stl"
check_report
