# covers: environment
# Files that ask for too much, in every reader: refused at once, by the name of
# the limit, with little memory; and nothing of them moves a cursor.
. "$(dirname "$0")/harness.bash"
cd "$here" || exit 1
mkdir "$work/h"
python3 tests/cli/hostile.py "$work/h" || exit 1
SECONDS_EACH=${HOSTILE_SECONDS:-30} # of a busy machine's clock

# bounded ARGUMENT...: run within six seconds of a slow processor, which are two of
# a quick one, and 1.5 GB.
bounded() {
  (
    ulimit -v 1500000
    ulimit -t 6
    timeout -s KILL "$SECONDS_EACH" "$sanggwan" "$@"
  ) >"$work/out" 2>"$work/err" </dev/null
  status=$?
  err=$(head -c 2000 "$work/err")
}

short() { [ "$(wc -c <"$work/err")" -lt 4000 ]; }
no_control() {
  ! python3 - "$@" <<'P'
import re, sys
for name in sys.argv[1:]:
    text = open(name, encoding='utf8', errors='replace').read()
    if re.search('[\x00-\x08\x0b-\x1f\x7f-\x9f\u061c\u200b\u200e\u200f'
                 '\u2028-\u202e\u2060-\u206f\ufeff\ufff9-\ufffb]', text):
        sys.exit(0)
sys.exit(1)
P
}
no_prolog() {
  ! grep -qE 'Unknown procedure|[Ss]tack limit|I/O error|Domain error|Type error|unexpectedly|_[G]?[0-9]{3,}|sg_[a-z]+:' "$work/err"
}

refused() { # NAME LIMIT ARGUMENT...
  local name=$1 limit=$2
  shift 2
  bounded "$@"
  check "$name.status" status_is 3
  check "$name.names-the-limit" has "--limits $limit=N"
  check "$name.short" short
  check "$name.plain" no_control "$work/err"
  check "$name.own-words" no_prolog
}

# A file of nothing, as large as no model (it has no blocks on the disk).
truncate -s 600M "$work/h/text.pl"

# Models, with the verb that makes what they ask for.
for file in "$work"/h/*.*; do
  name=${file##*/}
  limit=${name%%.*}
  case $limit in
    depth | blocks | digits | name | file | text | facets | nodes)
      refused "model.$name" "$limit" eval "$file" ;;
  esac
done

# Polygons that cannot be divided, or not in time: they are named and left out,
# and a signal is heard meanwhile.
for name in crosses few line round; do
  bounded check "$work/h/tangled.$name.off"
  check "tangled.$name" has 'left out'
  check "tangled.$name.status" status_is 1
  check "tangled.$name.words" no_prolog
done
check tangled.limit has '--limits contacts=N'
"$sanggwan" check "$work/h/tangled.round.off" --limits contacts=1000000000 \
  >"$work/out" 2>"$work/err" &
sleep 1.5
begin=$(date +%s%N)
kill -TERM $!
wait $!
check tangled.signal test $((($(date +%s%N) - begin) / 1000000)) -lt 1000

# Faults far behind the beginning of their facts, and long values of jobs.
bounded check "$work/h/far.pl"
check far.place has 'far.pl:400001:7: X of v is a'
bounded check "$work/h/far.list.pl"
check far.list has 'far.list.pl:1:1: X of v is [1,1'

# Facts of 14 MB, each of whose elements is looked at for several reasons; and a
# signal is heard meanwhile.
for name in polygon curve union terms; do
  bounded check "$work/h/huge.$name.pl"
  check "huge.$name" status_is 3
  check "huge.$name.words" no_prolog
  check "huge.$name.short" short
done
check huge.place has 'huge.terms.pl:1:1: segment 1 would be made of 1,400,000'
for after in 0.4 0.8 1.2; do
  "$sanggwan" check "$work/h/huge.terms.pl" >"$work/out" 2>"$work/err" &
  sleep $after
  begin=$(date +%s%N)
  kill -TERM $!
  wait $!
  check "huge.signal.$after" test $((($(date +%s%N) - begin) / 1000000)) -lt 1000
done
cp facts/cube.pl "$work/h/"
for name in long.job long.verb long.set dict; do
  bounded batch "$work/h/$name.pl" --list -o "$work/b"
  check "manifest.$name" status_is 3
  check "manifest.$name.words" no_prolog
  check "manifest.$name.short" short
done
check manifest.dict has 'V in _{a:1}'
bounded batch "$work/h/long.set.pl" --list -o "$work/b"
check manifest.limit has '--limits name=N'

# Manifests of JSON: many lines, none of them deep, long or in halves.
python3 - "$work" <<'P'
import sys
line = '{"job":%s,"verb":"check","files":["h/cube.pl"]%s}\n'
def write(name, text):
    open('%s/%s' % (sys.argv[1], name), 'w').write(text)
write('many.jsonl', ''.join(line % ('"a%d"' % n, '') for n in range(3000)))
write('depth.jsonl', line % ('[' * 300 + ']' * 300, ''))
write('fact.jsonl', line % (' ' * 17000000 + '1', ''))
write('name.jsonl', line % ('"' + 'a' * 70000 + '"', ''))
write('half.jsonl', line.replace('check', '\\ud800') % ('"a"', ''))
write('both.jsonl', line % ('"\\ud83d\\ude00x"', ''))
write('dict.jsonl', line % ('{"b":1}', ''))
P
bounded batch "$work/many.jsonl" --list
check json.many status_is 0
check json.all is "$(wc -l <"$work/out")" 3000
for limit in depth fact name; do
  refused "json.$limit" "$limit" batch "$work/$limit.jsonl" --list
done
bounded batch "$work/both.jsonl" --list
check json.both is "$(cat "$work/out")" "$(printf '\360\237\230\200x')"
printf '%s\n' '{"job":"a\u001b[2J\u202eb","verb":"check","files":["h/cube.pl"]}' \
  >"$work/control.jsonl"
bounded batch "$work/control.jsonl" --list
check json.control status_is 0
check json.control.plain no_control "$work/out"
for name in half dict; do
  bounded batch "$work/$name.jsonl" --list
  check "json.$name" status_is 3
  check "json.$name.words" no_prolog
done

# Problems of too many variants.
for values in 1..2000000 '1..200), variant(a, s, 1..200' \
  "[$(seq -s, 12000)]"; do
  printf "problem(a, 'h/cube.pl', []).\nsheet('A4', [a], []).\n%s\n" \
    "variant(a, r, ${values//), variant/).
variant})." >"$work/problems.pl"
  bounded problems "$work/problems.pl" -o "$work/problems"
  check "problem.${values:0:9}" status_is 3
  check "problem.${values:0:9}.limit" has '--limits variants=N'
  check "problem.${values:0:9}.short" short
done

# Reports of batches that no batch has written.
deep=$(printf '[%.0s' $(seq 300))
for rest in '"seconds":1,"files":[],"said":{}' \
  '"seconds":[],"files":[],"said":[]' \
  '"seconds":1,"files":[7],"said":[]' "\"seconds\":$deep"; do
  printf '%s%s}\n' '{"job":"a","number":1,"outcome":"done",' "$rest" \
    >"$work/report.jsonl"
  bounded batch --merge "$work/report.jsonl" -o "$work/merged.xml"
  check "merge.${rest:0:40}" status_is 3
  check "merge.${rest:0:40}.words" no_prolog
done
printf '%s\n' '{"job":"a","number":1,"outcome":"done","seconds":1,"files":[],"said":[]}' \
  >"$work/report.jsonl"
printf '{"job":"b\342\200\256","number":2,"outcome":"done","seconds":1,"files":[],"said":[]}\n' \
  >>"$work/report.jsonl"
bounded batch --merge "$work/report.jsonl" -o "$work/merged.json"
check merge.control status_is 0
check merge.control.plain no_control "$work/merged.json"
printf '%s\n' '{"job":"a","number":1,"outcome":"done","broken":"\u00' \
  >"$work/report.jsonl"
bounded batch --merge "$work/report.jsonl" -o "$work/merged.json"
check merge.unparsed hasnt broken "$work/merged.json"
bounded batch --merge /dev/null -o "$work/merged.json"
check merge.device status_is 3

# What is no text in the environment counts as nothing.
for name in LC_ALL LANG XDG_STATE_HOME SLURM_ARRAY_TASK_ID; do
  env "$name"=$'\xed\xa0\x80' "$sanggwan" batch facts/batch.pl --list \
    >"$work/out" 2>"$work/err" </dev/null
  status=$?
  check "environment.$name" status_is 0
  check "environment.$name.silent" silent err
done

# Numbers that are read but are no places.
printf 'cube(size=[1e308,1e308,1e308],center=true);\n' >"$work/far.csg"
printf 'segment(1,solid,box(size(1.0e300,1,1))).\n' >"$work/far.pl"
for file in far.csg far.pl; do
  bounded eval "$work/$file"
  check "$file" status_is 3
  check "$file.words" no_prolog
done

# The same from a pipe, which can be read once only.
for name in depth.small.pl name.pl; do
  status=$(
    (ulimit -v 1500000 -t 2
     cat "$work/h/$name" | "$sanggwan" check - >"$work/out" 2>"$work/err"
     echo $?)
  )
  check "stdin.$name" status_is 3
  check "stdin.$name.limit" has "--limits ${name%%.*}=N"
  mkfifo "$work/pipe.pl" 2>/dev/null
  cat "$work/h/$name" >"$work/pipe.pl" 2>/dev/null &
  bounded check "$work/pipe.pl"
  wait
  check "fifo.$name" status_is 3
  check "fifo.$name.limit" has "--limits ${name%%.*}=N"
done

# Input that never ends.
status=$(
  (ulimit -v 1500000 -t 2
   yes 'v(1, 1, 0, 0, 0).' | "$sanggwan" check - --limits text=1000000 \
     >"$work/out" 2>"$work/err"
   echo "${PIPESTATUS[1]}")
)
check endless status_is 3
check endless.limit has '--limits text=N'

status=$(
  (ulimit -v 1500000 -t 2
   yes | "$sanggwan" check - --from stl --limits text=1000000 \
     >"$work/out" 2>"$work/err"
   echo "${PIPESTATUS[1]}")
)
check endless.mesh status_is 3
check endless.mesh.limit has '--limits text=N'

# Input that never ends and is no model: nothing much of it is copied.
for line in y 'hello world.' 'hello.' '[['; do
  status=$(
    (ulimit -t 2 -f 40000
     yes "$line" | "$sanggwan" check - >"$work/out" 2>"$work/err"
     echo "${PIPESTATUS[1]}")
  )
  check "endless.$line" status_is 3
  check "endless.$line.words" no_prolog
done
check endless.place has '<stdin>:65:1: more than 128 levels'

# Devices without an end, in every reader: at once.
for ending in pl csg json stl off obj ply; do
  ln -s /dev/zero "$work/zero.$ending"
  bounded check "$work/zero.$ending"
  check "device.$ending" status_is 3
  check "device.$ending.said" has 'is a device'
done
for option in --style --title-block; do
  bounded draw facts/cube.pl --sheet A4 $option /dev/urandom -o "$work/a.svg"
  check "device.$option" has 'is a device'
done
bounded check facts/cube.pl --rules /dev/zero
check device.rules has 'is a device'
for from in pl stl; do
  "$sanggwan" check - --from $from </dev/zero >"$work/out" 2>"$work/err"
  status=$?
  check "device.stdin.$from" status_is 3
  check "device.stdin.$from.said" has 'is a device'
done

# A rule file is read to its first error.
yes 'a(1). b(1.' | head -1000000 >"$work/errors.pl"
cat "$work/errors.pl" >"$work/pipe.pl" 2>/dev/null &
for name in errors pipe; do
  bounded check facts/cube.pl --rules "$work/$name.pl"
  check "$name.status" status_is 3
  check "$name.place" has "$name.pl:1:9:"
done
wait

# Other readers: styles, title blocks, rules, goals.
for name in depth.small.pl depth.prefix.pl digits.pl name.quoted.pl; do
  limit=${name%%.*}
  refused "style.$name" "$limit" draw facts/cube.pl \
    --style "$work/h/$name" -o "$work/a.svg"
  refused "title.$name" "$limit" draw facts/cube.pl --sheet A4 \
    --title-block "$work/h/$name" -o "$work/a.svg"
done
for name in depth.small.pl depth.list.pl depth.brace.pl depth.prefix.pl \
  depth.infix.pl depth.comma.pl depth.not.pl depth.body.pl digits.pl \
  name.quoted.pl; do
  refused "rules.$name" "${name%%.*}" check facts/cube.pl \
    --rules "$work/h/$name"
done
mkfifo "$work/rules.pl"
cat "$work/h/depth.list.pl" >"$work/rules.pl" 2>/dev/null &
refused rules.fifo depth check facts/cube.pl --rules "$work/rules.pl"
wait
deep=$(printf '[%.0s' $(seq 30000))
for goal in "X = $deep" "X = 0$(printf '9%.0s' $(seq 30000))" \
  "X = a$(printf 'a%.0s' $(seq 70000))"; do
  bounded query facts/cube.pl "$goal"
  check "goal.status" status_is 2
  check "goal.limit" has '--limits '
  check "goal.short" short
done
"$sanggwan" repl <<<"X = $deep.
X = after." >"$work/out" 2>"$work/err"
check repl-goal has '--limits depth='
check repl-goes-on has after "$work/out"
bounded explain facts/cube.pl "line($deep"
check explain-goal status_is 2
check explain-goal-short short

# Values of options: each is looked through too, and what a message repeats of
# one is short.
brief() { [ "$(wc -c <"$work/err")" -lt 2500 ]; }
for piece in '(' '- ' '1,' '1+' '1 ' '[' 'f(' '5.' 9 a; do
  bounded check facts/cube.pl --set "a=$(printf "%.0s$piece" $(seq 20000))"
  check "set.$piece" status_is 2
  check "set.$piece.brief" brief
done
long=$(printf 'a%.0s' $(seq 50000))
for option in "--$long" --set="$long" --set="$long"=3 --set=a="$long" \
  --limits="$long" --lang="$long" --tolerance="$long" --strict="$long" \
  --model="$long"; do
  bounded check facts/cube.pl "$option"
  check "long.${option:0:9}" status_is 2
  check "long.${option:0:9}.brief" brief
done
for path in "$long.pl" "$(printf 'a/%.0s' $(seq 3000))b.pl"; do
  bounded check "$path"
  check path.said has 'too long for a file'
  check path.brief brief
done
bounded "$long"
check verb.brief brief
printf '%s\n' "$(for n in $(seq 500); do echo "a(1). b(1)."; done)" \
  >"$work/apart.pl"
bounded check facts/cube.pl --rules "$work/apart.pl"
check warnings.status status_is 3
check warnings.counted has 'warning: 898 more, not shown'
bounded check facts/cube.pl --rules "$work/h/apart.pl"
check warnings.many has 'warning: 99,898 more, not shown'
refused clauses clauses check facts/cube.pl --rules "$work/h/clauses.pl"
bounded check facts/cube.pl --rules "$work/h/chain.rules.pl"
check chain-of-rules status_is 0

# What is large but allowed, or allowed by an option, takes no long time.
bounded eval "$work/h/chain.pl"
check chain-of-2000 status_is 0
bounded eval "$work/h/nest.csg"
check nested-500 status_is 0
bounded eval "$work/h/large.csg"
check large-csg status_is 0
bounded check "$work/h/depth.small.pl" --limits depth=1000,name=9
check another-limit status_is 3
printf "segment(1, solid, '%s').\n%s" "$(printf 'n%.0s' $(seq 20))" \
  "$(sed -n '/^v(/,$p' facts/cube.pl)" >"$work/n.pl"
bounded check "$work/n.pl" --limits name=19
check lowered has '--limits name=N'
bounded check "$work/n.pl" --limits name=20
check enough status_is 0
for wrong in depth depth=0 depth=x depth=1.5 nothing=3 ,; do
  bounded check facts/cube.pl --limits "$wrong"
  check "limits.$wrong" status_is 2
done

# Names that would move the cursor, in messages, reports and answers.
for file in cursor.pl cursor_fault.pl cursor.csg; do
  for lang in en ko; do
    bounded check "$work/h/$file" --lang $lang
    check "$file.$lang" no_control "$work/err" "$work/out"
  done
done
bounded query "$work/h/cursor.pl" 'segment(S, K, N)'
check query-table no_control "$work/out"
bounded check "$work/h/cursor.pl" -q --json
check json-escapes has '\u001b' "$work/out"

# Such a name as a word of its own and inside a term, in every verb and format
# (.csv is data as it is): seen, or escaped.
python3 - "$work/h/cursor.pl" "$work/title.pl" <<'P'
import sys
name = 'a\\x1b\\[2J\\u202e\\u2066b\\x0\\c\\nd\\x85\\e\\u200f\\U000E0041'
text = open(sys.argv[1], encoding='utf8').read()
with open(sys.argv[1], 'w') as out:
    out.write("segment(1,solid,'%s').\n" % name + text[text.index('v(1'):])
    out.write("segment(2,solid,named('x%s',at([translate(0.5,0.5,0.5)],"
              "box(size(1,1,1))))).\n" % name)
with open(sys.argv[2], 'w') as out:
    out.write('title_block(name, "%s").\n' % name)
P
names=0
clean() { # NAME STATUS ARGUMENT...: nothing of it in what was written
  local name=$1 wanted=$2
  shift 2
  bounded "$@"
  check "$name.status" status_is "$wanted"
  for file in "$work/out" "$work/err" "$work"/named.*; do
    [ ! -e "$file" ] || check "$name.${file##*/}" no_control "$file"
  done
  rm -f "$work"/named.*
  names=$((names + 1))
}
for ending in svg eps ps dxf hpgl json pl; do
  clean "draw.$ending" 0 draw "$work/h/cursor.pl" --sheet A4 \
    --title-block "$work/title.pl" -o "$work/named.$ending"
done
for ending in obj off pl; do
  clean "convert.$ending" 0 convert "$work/h/cursor.pl" -o "$work/named.$ending"
  clean "union.$ending" 0 union "$work/h/cursor.pl" -o "$work/named.$ending"
  clean "unfold.$ending" 0 unfold "$work/h/cursor.pl" -o "$work/named.$ending"
done
bounded convert "$work/h/cursor.pl" -o "$work/named.obj"
check 'OBJ: said' has 'invisible characters'
check 'OBJ: nothing cut' has 'b␀c d' "$work/named.obj"
clean convert.stl 0 convert "$work/h/cursor.pl" -o "$work/named.stl"
clean strict 1 convert "$work/h/cursor.pl" --strict -o "$work/named.stl"
for ending in pl obj dxf svg txt; do
  clean "penetrate.$ending" 0 penetrate "$work/h/cursor.pl" \
    -o "$work/named.$ending"
done
clean unfold.svg 0 unfold "$work/h/cursor.pl" --names words -o "$work/named.svg"
for json in '' --json; do
  clean "check$json" 0 check "$work/h/cursor.pl" $json
  clean "eval$json" 0 eval "$work/h/cursor.pl" $json
  clean "unfold$json" 0 unfold "$work/h/cursor.pl" $json
  clean "explain$json" 0 explain "$work/h/cursor.pl" 'line(1)' $json
  [ -z "$json" ] ||
    check 'JSON that is read' python3 -m json.tool "$work/out" "$work/json"
done
for format in table json prolog; do
  clean "query.$format" 0 query "$work/h/cursor.pl" --format $format \
    'segment(S, K, N)'
done
printf 'counted: %d commands with such names\n' "$names"

# Such a part, or job, is asked for by its name as it is printed.
cat >"$work/named.pl" <<'P'
segment(1,solid,named('a\x1b\[2J\u202eb',box(size(1,1,1)))).
segment(2,solid,named(plain,at([translate(3,0,0)],box(size(1,1,1))))).
P
shown=$(printf 'a\342\220\233[2J\357\277\275b')
for name in "$shown" 'a\x1b\[2J\u202eb'; do
  bounded unfold "$work/named.pl" --only "'$name'"
  check "only.$name" status_is 0
  check "only.$name.first" has 'segment 1: ' "$work/out"
done
bounded unfold "$work/named.pl" --only nobody
check only.unknown has "$shown"
printf '%s\n' \
  '{"job":"a\u001b[2J\u202eb","verb":"check","files":["h/cube.pl"]}' \
  '{"job":"c","verb":"check","files":["h/cube.pl"]}' >"$work/two.jsonl"
bounded batch "$work/two.jsonl" --list --only "$shown"
check only.job is "$(cat "$work/out")" "$shown"
bounded batch "$work/two.jsonl" --list --only d
check only.no-job status_is 2

# A NUL in a name parts no sentence and no cell.
printf '%s\n' "segment(1, solid, named('a\\x0\\b', box(size(1, 1, 1))))." \
  'segment(2, solid, at([translate(0.5, 0.5, 0.5)], box(size(1, 1, 1)))).' \
  >"$work/nul.pl"
bounded explain "$work/nul.pl" 'line(1)'
check nul-explained status_is 0
bounded query facts/cube.pl --format csv "X = 'a\\x0\\b', Y = 'c\"d'"
check nul-cell is "$(tr '\0' @ <"$work/out" | tail -1)" 'a@b,"c""d"'

# Answers stream, in every format; a reader who has seen enough is no error.
for format in table csv json prolog; do
  (
    ulimit -v 1000000
    "$sanggwan" query facts/cube.pl --format $format \
      'between(1, 640000, X)' 2>"$work/err"
    echo $? >"$work/status"
  ) | head -2 >"$work/out"
  status=$(cat "$work/status")
  check "head.$format" status_is 141
  check "head.$format.silent" silent err
done
(
  ulimit -v 1000000
  "$sanggwan" query facts/cube.pl 'between(1, 640000, X)' >"$work/out"
)
check all-answers is "$(wc -l <"$work/out")" 640001

# Answers deeper than what writes them can go: said, in every format.
for format in table csv json prolog; do
  for goal in 'numlist(1, 30000, L), foldl([_,T,f(T)]>>true, L, x, X)' \
    'numlist(1, 30000, L), foldl([_,T,T+1]>>true, L, x, X)' \
    'X = f(X)' 'X = [a|X]' 'X = [a,f(b,X)]'; do
    bounded query facts/cube.pl --format $format "$goal"
    check "deep.$format.$goal" status_is 3
    check "deep.$format.$goal.said" has '--limits depth=N'
  done
  bounded query facts/cube.pl --format $format \
    'numlist(1, 30000, L), foldl([_,T,f(T)]>>true, [1,2,3], x, X)'
  check "long.$format" status_is 0
  bounded query facts/cube.pl --format $format 'X = [1,f(_)|_], Y = [_|X]'
  check "open.$format" status_is 0
done

# Errors of Prolog in our words.
while IFS='|' read -r goal wanted; do
  for lang in en ko; do
    bounded query facts/cube.pl "$goal" --lang $lang
    check "words.$goal.$lang" status_is "$wanted"
    check "words.$goal.$lang.own" no_prolog
    check "words.$goal.$lang.short" short
  done
done <<'GOALS'
nobody(1)|2
atom_length(X, Y)|2
atom_length(f(x), Y)|2
X is foo + 1|2
set_prolog_flag(stack_limit, 50000000), numlist(1, 30000000, L)|4
throw(error(io_error(close, s), context(system:close/1, 'No space')))|2
assert_fact(v(1, 99, 1.0e300, 0, 0))|2
GOALS
finish
