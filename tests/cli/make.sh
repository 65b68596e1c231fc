# make.sh -- each goal of the Makefile looks for the packages that it needs,
# whatever was made before it.
. "$(dirname "$0")/../check.sh"

unset MAKEFLAGS MFLAGS MAKELEVEL B

# A tree in which tools/deps only writes down what it is asked for.
tree=$TMP/tree
mkdir -p "$tree/tools" "$tree/rules/command" "$tree/c_kernels"
cp Makefile "$tree"
cp tools/doors*.pl "$tree/tools"
cp c_kernels/doors.def "$tree/c_kernels"
cp rules/command/cli.pl "$tree/rules/command"
printf '#!/bin/sh\necho "$*" >>asked\n' >"$tree/tools/deps"
chmod +x "$tree/tools/deps"

# asks WORDS GOAL...: a dry run of the goals asks for the packages of WORDS, and
# for no others beside the build's.
asks() {
  local words=$1
  shift
  rm -f "$tree/asked"
  make -n -C "$tree" "$@" >"$TMP/log" 2>&1
  touch "$tree/asked"
  [ "$(sort -u "$tree/asked" | sed '/^$/d')" = "$words" ] ||
    { echo "asked: $(cat "$tree/asked")"; cat "$TMP/log"; return 1; }
}

check "a build asks for its own" asks '' clean
check "the first time" asks '' all
check "it has looked" grep -q PL_LIBS "$tree/build/deps.mk"
check "then no more" asks '' all
for goal in test check check-san bench; do
  check "$goal after a build" asks 'tests --install' $goal
done
for goal in lint check-vg; do
  check "$goal after a build" asks 'lint --install' $goal
done
check "demo after a build" asks --install demo
check "both" asks 'tests lint --install' test lint
rm -rf "$tree/build"
check "test first of all" asks 'tests --install' test
check "a build elsewhere" asks '' B="$TMP/elsewhere" so
check "is all there" grep -q -- " -o $TMP/elsewhere/" "$TMP/log"
check "nowhere else" eval '! grep -q -- " -o build/" "$TMP/log"'
check "a space is refused" complains 2 'no spaces' make -C "$tree" B="a b"
check "clean looks for nothing" asks '' clean

# T picks tests in check-san too.
san() { make -n check-san T="$1" >"$TMP/log" 2>&1; }
check "check-san of one" san work_list
check "without what needs no sanitizer" eval '! grep -q stress_test "$TMP/log"'
check "without texts" eval '! grep -q text_fuzz "$TMP/log"'
check "without meshes" eval '! grep -q mesh_fuzz "$TMP/log"'
check_report
