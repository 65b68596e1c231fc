#!/bin/bash
# bad_rules.sh -- rule files that are not there, are no Prolog, or fail later.
. "$(dirname "$0")/harness.bash"
cd "$here" || exit 2

# rules NAME STATUS TEXT MESSAGE: a rule file that holds TEXT is told MESSAGE.
rules() {
  local name=$1 wanted=$2 text=$3 message=$4
  printf '%s\n' "$text" >"$work/r.pl"
  run draw -q facts/two_cubes.pl --rules "$work/r.pl" -o "$work/a.svg"
  check "$name: exit code" status_is "$wanted"
  check "$name: message" has "$message"
  check "$name: nothing written" absent "$work/a.svg"
}

prolog_is_silent() {
  ! grep -qE 'Singleton|Clauses|Redefined|Goal|directive\)|sg_rules|Test is|_[G0-9]' \
    "$work/err"
}

run draw facts/two_cubes.pl --rules "$work/none.pl" -o "$work/a.svg"
check 'no file: exit code' status_is 3
check 'no file: message' has "$work/none.pl: there is no such file"
run draw facts/two_cubes.pl --rules facts -o "$work/a.svg"
check 'folder: exit code' status_is 3
check 'folder: message' has 'facts: is a folder'

rules 'no full stop' 3 'may_cut(_, _) :- fail' 'r.pl:1:'
rules 'no comma' 3 $'may_cut(A, B) :-\n  A < B\n  B > 3.' \
  'r.pl:3:1: this rule file cannot be loaded: Operator expected'
rules 'no function' 3 $'\nmay_cut(A, _) :- A > big(1).' \
  'r.pl:2: this rule file cannot be loaded'
rules 'misspelt' 3 'may_cat(_, _).' 'r.pl:1: may_cat/2 is no decision'
rules 'wrong arity' 3 'may_cut(_, _, _).' 'r.pl:1: may_cut/3 is no decision'
rules 'singleton' 2 $'\nmay_cut(A, _) :- none(_).' \
  'r.pl:2: warning: a variable stands once only: A'
rules 'throws' 2 'may_cut(_, _) :- throw(my_error).' 'throw(my_error)'
rules 'endless' 4 'may_cut(A, B) :- may_cut(A, B), atom(A).' \
  'may_cut(1,2) calls itself without end'

# What Prolog warns of while a rule file is loaded is said in our words, in both
# languages, with its file and line.
printf '%s\n' 'may_cut(A, B) :- c(X), default(may_cut(A, B)).' 'c(1).' \
  'may_cut(_, _) :- d(_Y, _Y), fail.' 'c(2).' 'd(Z, 1) :- ( Z = 1 ; Y = 2 ).' \
  'd(Z, 2) :- \+ \+ Z == "a", var(b).' ':- fail.' 'lists:append(1, 2, 3).' \
  >"$work/r.pl"
for lang in en ko; do
  run draw -q facts/two_cubes.pl --rules "$work/r.pl" --lang $lang \
    -o "$work/a.svg"
  for line in 1 3 4 5 6 7 8; do
    check "$lang: warned of line $line" has "r.pl:$line: "
  done
  check "$lang: in our words" prolog_is_silent
done
finish
