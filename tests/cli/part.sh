# part.sh -- the program loads the rules that a verb calls, no others; what looks
# at rules has all of them.
. "$(dirname "$0")/../check.sh"

figure=facts/figures/fig13.pl
"$SANGGWAN" convert facts/cube.pl -o "$TMP/a.stl" &&
  "$SANGGWAN" convert "$TMP/a.stl" -o "$TMP/b.off"

# loaded VERB...: the folders of rules/ of which the command loads any.
loaded() {
  "$SANGGWAN" "$@" --stats 2>&1 >/dev/null |
    grep -o '"rules": *{[^}]*}' | grep -o '"[a-z]*":' | tr -d '":' | tail -n +2
}

# What models, solids and any command are made of.
common='command csg kernel message model penetration picture polygon primitive
  rules solid'

# only FOLDERS VERB...: no folder is loaded but common ones and FOLDERS, and each
# of these.
only() {
  local own=$1 folder got
  shift
  got=$(loaded "$@")
  [ -n "$got" ] || return 1
  for folder in $own; do
    grep -qx "$folder" <<<"$got" || { echo "not loaded: $folder"; return 1; }
  done
  got=$(grep -vxF "$(printf '%s\n' $common $own)" <<<"$got")
  [ -z "$got" ] || { echo "loaded as well: $got"; return 1; }
}

check check only '' check $figure
check convert only '' convert facts/cube.pl -o "$TMP/c.off"
check penetrate only '' penetrate $figure -o "$TMP/c.pl"
check union only '' union "$TMP/a.stl" "$TMP/b.off" -o "$TMP/c.stl"
check split only '' split facts/cube.pl --plane 0,0,1,0.5 -o "$TMP/c.pl"
check draw only 'drawing sheet' draw $figure -o "$TMP/c.svg"
check render only shading render $figure -o "$TMP/c.png"
check unfold only 'development drawing pattern sheet unfolding unrolling' \
  unfold facts/cube.pl -o "$TMP/c.svg"
check cells only gluing cells "$TMP/a.stl"
check glue only gluing glue "$TMP/a.stl" "$TMP/b.off" -o "$TMP/c.pl"
check query only studio query $figure 'segment(S, K, N)'
check explain only 'explanation studio' explain $figure 'line(1)'

# all VERB...: every folder of rules/ is loaded.
all() {
  local want
  want=$(printf '%s\n' rules $(cd rules && ls -d */ | tr -d /) | sort)
  diff <(loaded "$@" | sort) - <<<"$want"
}

printf 'smooth_segment(_) :- fail.\n' >"$TMP/rules.pl"
check "a rule file sees all rules" all draw $figure --rules "$TMP/rules.pl" \
  -o "$TMP/c.svg"
printf 'asked(A) :- aggregate_all(count, v(_,_,_,_,_), A).\n' >"$TMP/goal.pl"
check "so does a file that a goal loads" all query $figure \
  "consult('$TMP/goal.pl'), asked(A)"

check "so does a goal that looks at them" all query $figure \
  'clause(volume(_, _), _), !, X = yes'
check "what was not called is there" output '^ *yes$' "$SANGGWAN" query \
  $figure 'current_predicate(draw/1), X = yes'
check "what a library has, a goal finds" output '^ *2$' "$SANGGWAN" query \
  $figure 'aggregate_all(count, member(_, [a,b]), N)'
check "what is nowhere is told" complains 2 'there is no predicate nowhere/1' \
  "$SANGGWAN" query $figure 'nowhere(X)'
check_report
