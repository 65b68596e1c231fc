# libraries.sh -- rules import every library predicate that they call:
# SWI-Prolog 9.0.4 that is interrupted while it loads a library by itself may
# lose it.
. "$(dirname "$0")/../check.sh"

here=$PWD
cat >"$TMP/undefined.pl" <<'PROLOG'
:- use_module(library(apply_macros), []).
:- use_module(library(lists), [member/2]).
:- use_module(library(prolog_codewalk), [prolog_walk_code/1]).
:- initialization(main, main).

% What apply_macros would expand, as some releases do in every module, must be
% imported too. The first walk is for the libraries that walking loads by itself.
main :-
    forall(( member(Head, [goal_expansion(_, _), goal_expansion(_, _, _, _)]),
             nth_clause(system:Head, _, Clause),
             clause(system:Head, apply_macros:_, Clause) ),
           erase(Clause)),
    current_prolog_flag(argv, [File]),
    prolog_walk_code([undefined(trace), on_trace(ignored),
                      module_class([library])]),
    set_prolog_flag(encoding, utf8),
    load_files(rules:File, [silent(true)]),
    set_prolog_flag(autoload, false),
    prolog_walk_code([undefined(trace), on_trace(told), source(false),
                      module_class([user])]).

ignored(_, _, _).

told(Module:Goal, Caller, _) :-
    functor(Goal, Name, Arity),
    functor_of(Caller, By),
    print_message(error, format("~q is not imported (~q)",
                                [Module:Name/Arity, By])).

functor_of(Module:Head, Module:Name/Arity) :-
    !,
    functor(Head, Name, Arity).
functor_of(Caller, Caller).
PROLOG
undefined() { # undefined RULES: what they call that is nowhere
  swipl -f none -p foreign="$B" --on-error=status \
    --on-warning=status "$TMP/undefined.pl" -- "$1/command/cli.pl"
}
check "nothing is undefined without autoloading" undefined "$here/rules"
check "no rule asks for autoloading" \
  eval '! grep -n "^:- *autoload" rules/*.pl rules/*/*.pl'

mkdir "$TMP/tree"
cp -r rules "$TMP/tree"
echo 'planted(L) :- permutation(L, _), maplist(atom, L, L, L, L).' \
  >>"$TMP/tree/rules/command/check.pl"
check "what is not imported is found" complains 1 'sg_check:permutation/2' \
  undefined "$TMP/tree/rules"
check "what could be expanded, too" complains 1 'sg_check:maplist/5' \
  undefined "$TMP/tree/rules"

# In the program, nor do the libraries load others later; but for the one that
# saved its state.
cat >"$TMP/later.pl" <<'PROLOG'
later(Files) :-
    findall(File,
            ( current_predicate(Module:'$autoload'/3),
              \+ memberchk(Module, [qsave,zip]),
              Module:'$autoload'(File, _, _) ),
            Files).
PROLOG
check "the program loads no library later" output '^\[\]$' \
  "$SANGGWAN" query -q --format csv facts/cube.pl \
  "consult('$TMP/later.pl'), later(Files)"
check_report
