# installed.sh -- the installed copy: from the shell, from plain swipl, from C;
# with the tree that it was made from, and the folder of the build outside of it,
# taken away.
. "$(dirname "$0")/../check.sh"

unset DESTDIR PREFIX MAKEFLAGS MFLAGS MAKELEVEL
tree=$TMP/tree built=$TMP/built prefix=$TMP/prefix models=$TMP/prefix/share/doc/sanggwan/facts

# A copy of this tree and of what was built from it. Its rules are newer, so that
# the program with the rules inside is built there and knows this tree no more.
copy_tree() {
  mkdir "$tree" "$built" &&
    cp -a Makefile LICENSE ./*.md tools rules engine c_kernels facts docs \
      "$tree" &&
    cp -a "$B"/{engine,c_kernels} "$B"/*.* "$built" &&
    touch "$tree"/rules/*.pl
}
in_tree() { (cd "$tree" && nice make --no-print-directory B="$built" "$@" \
  </dev/null); }

# there FOLDER FILE...: these files are in FOLDER.
there() {
  local folder=$1 file
  shift
  for file; do
    [ -s "$folder/$file" ] || { echo "no $folder/$file"; return 1; }
  done
}

# no_files FOLDER: no file is left in FOLDER.
no_files() { [ -z "$(find "$1" -type f | tee /dev/stderr)" ]; }

arch=$(swipl -g 'current_prolog_flag(arch, A), write(A)' -t halt)
files="bin/sanggwan lib/libsanggwan.a lib/pkgconfig/sanggwan.pc
  include/sanggwan.h share/man/man1/sanggwan.1
  share/swi-prolog/pack/sanggwan/pack.pl
  share/swi-prolog/pack/sanggwan/prolog/sanggwan.pl
  share/swi-prolog/pack/sanggwan/lib/$arch/sanggwan.so
  share/doc/sanggwan/LICENSE share/doc/sanggwan/docs/command_line.md"

check "copy of the tree" copy_tree
check "make install" in_tree install PREFIX="$prefix"
# shellcheck disable=SC2086
check "everything is there" there "$prefix" $files
check "make install DESTDIR" in_tree install DESTDIR="$TMP/stage" PREFIX=/opt/s
# shellcheck disable=SC2086
check "staged" there "$TMP/stage/opt/s" $files
check "pkg-config names PREFIX alone" grep -qx 'prefix=/opt/s' \
  "$TMP/stage/opt/s/lib/pkgconfig/sanggwan.pc"
check "make uninstall" in_tree uninstall DESTDIR="$TMP/stage" PREFIX=/opt/s
check "nothing is left" no_files "$TMP/stage"

# The version stands in one file; all that is installed has it.
version=$("$prefix/bin/sanggwan" --version | cut -d ' ' -f 2)
check "a version" grep -qx '[0-9]*[.][0-9]*[.][0-9]*' <<<"$version"
check "pkg-config has it" grep -qx "Version: $version" \
  "$prefix/lib/pkgconfig/sanggwan.pc"
check "the man page has it" grep -qF "$version" "$prefix/share/man/man1/sanggwan.1"
check "the pack has it" grep -qF "version('$version')" \
  "$prefix/share/swi-prolog/pack/sanggwan/pack.pl"

# From here on only the prefix is left, and an empty folder to stand in.
check "the tree has no build of its own" eval '[ ! -e "$tree/build" ]'
rm -rf "$tree" "$built"
mkdir "$TMP/empty"
cd "$TMP/empty" || exit 1
unset SANGGWAN
export HOME=$TMP/empty PATH=$prefix/bin:$PATH XDG_DATA_DIRS=$prefix/share
export PKG_CONFIG_PATH=$prefix/lib/pkgconfig

### The program

check "version" output '^sanggwan [0-9.]+' sanggwan --version
check "help" output 'penetrate' sanggwan --help
check "draw" sanggwan draw "$models/two_cubes.pl" -o a.svg
check "draws visible and hidden lines" grep -Eq 'class="hidden' a.svg
check "check" output 'closed|volume' sanggwan check "$models/cube.pl"
check "query" output '^8$' sanggwan query -q --format csv "$models/cube.pl" \
  'aggregate_all(count, v(_, _, _, _, _), N)'
check "repl has help" output 'penetration line' \
  eval 'echo "help(line/9)." | sanggwan repl'

### The man page

page=$prefix/share/man/man1/sanggwan.1

# explains_all: every option that --help shows stands in the page.
explains_all() {
  local verb option
  for verb in $(sanggwan --help | sed -n 's/^  \([a-z]\+\)  .*/\1/p'); do
    grep -q "^\.SS \"$verb " "$page" || { echo "no $verb"; return 1; }
    for option in $(sanggwan "$verb" --help |
      sed -nE 's/^  (-., |    )(--[a-z-]+).*/\2/p'); do
      grep -Fq "\\-\\-${option#--}\\fR" "$page" ||
        { echo "no $verb $option"; return 1; }
    done
  done
}
check "man page: all verbs and options" explains_all
if command -v groff >/dev/null; then
  check "man page: well-formed" \
    eval '[ -z "$(groff -man -Tutf8 -ww -z "$page" 2>&1)" ]'
else
  skip "man page: well-formed" "groff is not installed"
fi

### Plain swipl

cat >ask.pl <<'PROLOG'
:- use_module(library(sanggwan)).
:- use_module(library(sanggwan/rows)).
:- use_module(library(sanggwan/spans)).
:- use_module(library(sanggwan/topology)).
:- initialization(main, main).

main :-
    current_prolog_flag(argv, [Model]),
    new_world(World),
    in_world(World, asked(Model)).

asked(Model) :-
    load_model(Model),
    penetrate,
    aggregate_all(count, line(_, _, _, _, _, _, _, _, _), Count),
    once(half_edge(_)),
    predicate_property(line_spans(_, _, _), defined),
    predicate_property(leaf_v(_, _, _, _, _), defined),
    format("~d pieces~n", [Count]),
    forall(( module_property(Module, file(File)),
             sub_atom(Module, 0, _, _, sg_) ),
           sub_atom(File, _, _, _, '/pack/sanggwan/')).
PROLOG
check "use_module(library(sanggwan))" output '^6 pieces$' \
  swipl --on-error=status --on-warning=status ask.pl -- "$models/two_cubes.pl"
cat >attach.pl <<'PROLOG'
:- initialization(main, main).

main :-
    current_prolog_flag(argv, [Packs, Model]),
    attach_packs(Packs),
    use_module(library(sanggwan)),
    load_model(Model),
    sanggwan:v(1, _, _, _, _),
    !.
PROLOG
check "attach_packs" env -u XDG_DATA_DIRS swipl --on-error=status attach.pl \
  -- "$prefix/share/swi-prolog/pack" "$models/cube.pl"
hidden_libraries() { # none of ours stands before one of SWI-Prolog
  local rule
  for rule in "$prefix"/share/swi-prolog/pack/sanggwan/prolog/*.pl; do
    [ "${rule##*/}" = sanggwan.pl ] || { echo "$rule"; return 1; }
  done
}
check "no library of SWI-Prolog is hidden" hidden_libraries

### C

cat >count.c <<'C'
#include <sanggwan.h>
#include <stdio.h>

int
main(int argc, char **argv)
{
  sanggwan_world *world;
  int pieces = 0;

  if (argc != 2 || sanggwan_start() != SANGGWAN_DONE ||
      !(world = sanggwan_open()) ||
      sanggwan_load(world, argv[1]) != SANGGWAN_DONE ||
      sanggwan_run(world, "penetrate") != SANGGWAN_DONE) {
    return 1;
  }
  sanggwan_query *query = sanggwan_ask(world, "line(L,_,_,_,_,_,_,_,_)");
  while (sanggwan_next(query) == SANGGWAN_DONE) {
    pieces++;
  }
  sanggwan_query_close(query);
  sanggwan_close(world);
  printf("%d pieces\n", pieces);
  return 0;
}
C
compile() { # compile FILE.c: FILE, as its user would
  # shellcheck disable=SC2046
  cc -std=c11 -Wall -Wextra -Wpedantic -Werror "$1" -o "$(basename "$1" .c)" \
    $(pkg-config --cflags --libs sanggwan)
}
check "C: compiles" compile count.c
check "C: asks" output '^6 pieces$' ./count "$models/two_cubes.pl"
check "C: a missing model is an error" status 1 ./count no.pl
check "docs/example.c compiles" \
  compile "$prefix/share/doc/sanggwan/docs/example.c"
check "docs/example.c runs" ./example "$models/two_cubes.pl"

check_report
