#!/bin/bash
# usage.sh -- help, options, exit codes, where text goes.
# covers: version
. "$(dirname "$0")/harness.bash"
cd "$here" || exit 2

run --version
check version status_is 0
check version-text has 'sanggwan ' "$work/out"
check version-quiet silent err
run --help
check help status_is 0
check help-verbs has 'penetrate' "$work/out"
check help-codes has '130 interrupted' "$work/out"
for verb in check convert penetrate draw query repl; do
  run $verb --help
  check "help $verb" status_is 0
  check "help $verb has an example" has "  sanggwan $verb " "$work/out"
  run help $verb
  check "help verb $verb" has "  sanggwan $verb " "$work/out"
done
run draw -h
check short-help status_is 0
run --lang ko --help
check korean-help has '사용법' "$work/out"
run draw --help --lang=ko
check korean-verb-help has '숨은선' "$work/out"
LANG=ko_KR.UTF-8 run draw
check korean-message has '주어지지 않았습니다'
LANG=ko_KR.UTF-8 run query facts/cube.pl 'foo(1)'
check korean-unknown-procedure has 'foo/1: 없는 술어입니다'
LANG=ko_KR.UTF-8 run check facts/cube.pl
check korean-report has '꼭짓점 8개' "$work/out"

# Any letters in words and names, whatever the locale.
mkdir "$work/한글 폴더"
cp facts/cube.pl "$work/한글 폴더/정육면체 1.pl"
for locale in C C.UTF-8; do
  LC_CTYPE=$locale run convert "$work/한글 폴더/정육면체 1.pl" \
    -o "$work/한글 폴더/나.off"
  check "korean names $locale" status_is 0
  check "korean names $locale: read again" has '나.off'
  LC_CTYPE=$locale run check "$work/한글 폴더/나.off"
  check "korean names $locale: the name" has 'solid 나' "$work/out"
  rm -f "$work/한글 폴더/나.off"
done
rm -r "$work/한글 폴더"
run check $'\xff.pl'
check bytes status_is 2
check bytes-message has 'no text in UTF-8'

run
check no-verb status_is 2
check no-verb-message has 'what should be done'
check no-verb-stdout silent out
run fly
check unknown-verb status_is 2
check unknown-verb-message has 'there is no verb fly'
run unfld facts/cube.pl
check meant-verb has 'Did you mean unfold?'
LC_ALL=ko_KR.UTF-8 run unfld facts/cube.pl
check meant-verb-ko has '비슷한 것: unfold'
run query facts/cube.pl
check no-goal status_is 2
check no-goal-message has 'GOAL is missing'
run query facts/cube.pl 'foo(X)'
check unknown-goal has 'sanggwan: there is no predicate foo/1'
run query facts/cube.pl 'retract_fact(v(1, 1, _, _, _))'
check torn-world status_is 3
check torn-world-message has 'sanggwan: v(1,1,0.0,0.0,0.0) is not retracted'
run convert facts/wire_and_roof.pl -o "$work/a.stl"
check lost-curve has '1 left out'
rm -f "$work/a.stl"
run penetrate facts/figures/fig08.pl
check points-alone status_is 0
check points-alone-message has 'in points alone (2)'
run draw
check no-model status_is 2
check no-model-message has 'MODEL is missing'
run draw facts/cube.pl
check no-output status_is 2
check no-output-message has '-o FILE'
run draw facts/cube.pl --colour
check unknown-option status_is 2
check unknown-option-message has 'unknown option --colour'
run unfold facts/cube.pl --tab 5
check meant-option has 'Did you mean --tabs?'
run --lang ko unfold facts/cube.pl --thicknes 5
check meant-option-ko has '비슷한 것: --thickness'
run draw facts/cube.pl -x
check unknown-letter has 'unknown option -x'
run draw facts/cube.pl -o
check needs-value has 'option -o needs a value'
run draw facts/cube.pl --size
check needs-value-long has 'option --size needs a value'
run draw facts/cube.pl --timings=yes -o "$work/a.svg"
check no-value has 'option --timings takes no value'
run draw facts/cube.pl --size 1x1 --size 2x2 -o "$work/a.svg"
check option-twice has 'option --size is given twice'
run draw facts/cube.pl --hidden dotted -o "$work/a.svg"
check one-of status_is 2
check one-of-message has 'dashed, removed, shown'
run draw facts/cube.pl --size big -o "$work/a.svg"
check bad-size has '--size: big should look like WxH'
run draw facts/cube.pl --size 0x10 -o "$work/a.svg"
check zero-size status_is 2
check zero-size-message has '0x10 is no size'
run draw facts/cube.pl --view above -o "$work/a.svg"
check bad-view has '--view above: there is no such view'
check bad-view-names has 'dimetric'
run draw facts/cube.pl --segment one -o "$work/a.svg"
check bad-segment status_is 2
run draw facts/cube.pl --segment 7 -o "$work/a.svg"
check no-such-segment has 'there is no segment 7, only 1'
run draw facts/cube.pl -o "$work/a.doc"
check ending status_is 2
check ending-message has 'a.doc: the ending decides the format'
run query facts/cube.pl --limit 0 'v(_,_,_,_,_)'
check limit status_is 2
run query facts/cube.pl 'v(1,'
check bad-goal status_is 2
check bad-goal-message has 'this is no goal'
check nothing-written holds "$work" out err

run draw facts/cube.pl -o"$work/a.svg" -q
check attached-value status_is 0
check quiet silent err
run draw --view=30,60 -qo "$work/b.svg" -- facts/cube.pl
check letters-together test -s "$work/b.svg"
run draw --view=-30,60 -q -o "$work/b.svg" facts/cube.pl
check negative-angle status_is 0
run draw facts/cube.pl -o "$work/a.svg" -o "$work/a.png" -o "$work/a.json"
check three-outputs test -s "$work/a.png" -a -s "$work/a.json"
check said-so has "wrote $work/a.png"

run query facts/cube.pl 'v(1, V, X, 0.0, 0.0)'
check query status_is 0
check table is "$out" 'V    X
1  0.0
2  1.0'
run query facts/cube.pl --format csv 'v(1, V, X, 0.0, 0.0)'
check csv is "$out" 'V,X
1,0.0
2,1.0'
run query facts/cube.pl --json 'v(1, V, _X, 0.0, 0.0)' --limit=1
check json is "$out" '[
   {"V":1}
]'
run query facts/cube.pl --format prolog 'p(1, 3, Es)'
check prolog is "$out" 'p(1, 3, [9, 10, 11, 12]).'
run query facts/cube.pl 'v(2, _, _, _, _)'
check no-answer status_is 1
check no-answer-stdout silent out
run query facts/cube.pl 'v(1, _, _, _, _)'
check ground-answer is "$out" yes
run query facts/cube.pl 'no_such_thing(1)'
check unknown-predicate status_is 2
check unknown-predicate-message has 'no_such_thing/1'

run query facts/cube.pl 'v(1,1,_,_,_)' --timings
check timings-json is "$(sed 's/[0-9.]\{1,\}/0/g' "$work/err")" \
  '{"load":0, "tree":0, "complete":0, "operands":0, "self":0, "resolve":0, '\
'"join":0, "chain":0, "rules":0, "enter":0, "pieces":0, "faces":0, "regions":0, '\
'"develop":0, "shade":0, "write":0, "other":0, "total":0}'
check timings-add-up python3 -c 'import json, sys
t = json.load(open(sys.argv[1]))
total = t.pop("total")
sys.exit(not abs(sum(t.values()) - total) < 1e-4)' "$work/err"
run query facts/cube.pl 'v(1,1,_,_,_)' --stats
check stats has '"rows":8'
check stats has '"exact": {"along":'

# The report.
run check facts/hollow_block.pl
check check-ok status_is 0
check check-text has 'genus 1' "$work/out"
run check --json facts/cube.pl
check check-json has '"faults":0' "$work/out"
cat >"$work/open.pl" <<'END'
segment(1, solid, open).
v(1,1,0,0,0). v(1,2,1,0,0). v(1,3,0,1,0). p(1,1,[1,2,3]).
END
run check "$work/open.pl"
check check-fault status_is 1
check check-fault-text has 'open_edge: 3' "$work/out"
run check facts/wire_and_roof.pl
check check-surface status_is 0
run check --strict facts/wire_and_roof.pl
check check-strict status_is 1

# Penetration lines; segments that do not meet; warnings.
run penetrate facts/figures/fig13.pl --json
check penetrate-json has '"pieces":80' "$work/out"
run penetrate facts/figures/fig13.pl --format csv
check penetrate-csv has 'chain,kind' "$work/out"
sed 's/1.1, 0.7, 0.6/9, 9, 9/' facts/two_cubes.pl >"$work/apart.pl"
run penetrate "$work/apart.pl"
check apart status_is 0
check apart-empty silent out
check apart-message has 'do not meet'
run penetrate "$work/apart.pl" -o "$work/apart.csv"
check apart-file test -e "$work/apart.csv"
rm -f "$work"/apart.*
cat >"$work/warped.pl" <<'END'
v(1,1,0,0,0). v(1,2,1,0,0). v(1,3,1,1,0.3). v(1,4,0,1,0). p(1,1,[1,2,3,4]).
END
run convert "$work/warped.pl" -o "$work/w.stl"
check warning status_is 0
check warning-message has 'warning: '
run convert --strict "$work/warped.pl" -o "$work/w.stl"
check strict status_is 1

printf 'v(1, V, 0.0, 0.0, Z).\nno_such(1).\nv(7, V, _, _, _).\nX = 1.' |
  "$sanggwan" repl facts/cube.pl >"$work/out" 2>"$work/err"
check repl is $? 2
check repl-answers is "$(cat "$work/out")" 'V    Z
1  0.0
5  1.0
X
1'
check repl-error has 'line 2: there is no predicate no_such/1'
printf '%% two goals\nX = 1, %% one\n  Y = 2.\n\n/* a\n b */ fail.\n  nope.\n' |
  "$sanggwan" repl --lang ko >"$work/out" 2>"$work/err"
check repl-lines is $? 2
check repl-no has 'sanggwan: 6행: '
check repl-line has 'sanggwan: 7행: '
run query facts/cube.pl 'X = 1. fail.'
check one-goal status_is 2
check one-goal-said has 'more after the first full stop'

# help/1 answers at once, whatever is asked, and starts no pager in a pipe.
printf 'help(no_such).\nhelp(append/3).\nhelp(penetrat).\nhelp("v/5").' |
  timeout -s KILL 60 "$sanggwan" repl >"$work/out" 2>"$work/err"
check help-ends is $? 0
check help-unknown has 'there is no help on no_such'
check help-prolog has "append/3 is Prolog's own"
check help-near has 'Like it are: penetrate'
check help-relation has 'v(S, V, X, Y, Z): ' "$work/out"

"$sanggwan" query - 'v(1, V, _, _, _)' --format csv --limit 1 \
  <facts/cube.pl >"$work/out" 2>"$work/err"
check stdin is "$(cat "$work/out")" 'V
1'
"$sanggwan" convert - -o - <facts/cube.pl >"$work/out" 2>"$work/err"
check stdout has 'p(1, 6, [4, 1, 5, 8]).' "$work/out"
"$sanggwan" query facts/cube.pl 'repeat' --format prolog 2>"$work/err" |
  head -n 1 >"$work/out"
check closed-pipe is "${PIPESTATUS[0]}" 141
check closed-pipe-quiet silent err
# A segment that goes through itself.
cat >"$work/self.obj" <<'END'
v 0 0 0
v 3 0 0
v 0 3 0
v 1 1 -1
v 1 1 1
v 5 5 0
f 1 2 3
f 4 5 6
END
run check "$work/self.obj"
check self-status status_is 1
check self-text has 'self_penetration: polygons 1 and 2 at ' "$work/out"
run check "$work/self.obj" --json
check self-json has '"kind":"self_penetration"' "$work/out"

finish
