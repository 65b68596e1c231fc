#!/bin/bash
# each.sh -- lists of files: with --each the bytes of each result are those of a
# command of its own, whatever becomes of the others; what became of each is said
# in words, in JSON and by the exit code.
# covers: each
. "$(dirname "$0")/harness.bash"
cd "$work" || exit 2
cp "$here"/facts/cube.pl "$here"/facts/two_cubes.pl "$here"/facts/pipe_tee.pl .
echo 'segment(1, solid, box(size(1,1,1)).' >syntax.pl
echo 'v(1,1,0,0,0). v(1,2,1,0,0). e(1,1,1,9,1). segment(1, curve, c).' >fault.pl
five='cube.pl syntax.pl two_cubes.pl fault.pl pipe_tee.pl'
good='cube two_cubes pipe_tee'

# same VERB ENDING OPTION...: each result as of a command of its own, alone
# and in the list; what is bad has none, and nothing else is there.
same() {
  local verb=$1 ending=$2 name
  shift 2
  mkdir -p each one
  run "$verb" --each $five "$@" -o "each/%.$ending"
  local all=$status said=$err
  for name in $good; do
    "$sanggwan" "$verb" "$name.pl" "$@" -o "one/$name.$ending" -q >>one.out
    cmp -s "one/$name.$ending" "each/$name.$ending" || return 1
  done
  [ "$all" = 5 ] && [ "$(ls -A each)" = "$(ls -A one)" ] &&
    [ "$(ls -A each | wc -l)" = 3 ] && echo "$said" | grep -q 'syntax.pl:1:35: ' &&
    echo "$said" | grep -q 'fault.pl:1:[0-9]*: segment 1 has no vertex 9' &&
    echo "$said" | grep -q '2 of 5 files failed: syntax.pl, fault.pl'
  local result=$?
  rm -r each one
  return $result
}
check 'draw' same draw svg
check 'draw: a sheet' same draw pdf --sheet A4 --up y
check 'convert: off' same convert off
check 'convert: pl' same convert pl
check 'unfold' same unfold svg

# What check prints stands below the name of the file.
run check --each $five
check 'check' status_is 5
cp out all
for name in $good; do
  echo "$name.pl:"
  "$sanggwan" check $name.pl
done >alone
check 'check: the same report' cmp -s all alone
run check --each cube.pl two_cubes.pl cube.pl
check 'check: all good' status_is 0
check 'check: nothing said' silent err

# JSON: a line for each file.
cat >lines.py <<'PY'
import json, subprocess, sys
lines = [json.loads(line) for line in open(sys.argv[1], encoding="utf-8")]
assert [one["file"] for one in lines] == sys.argv[3].split()
assert [one["status"] for one in lines] == [0, 3, 0, 3, 0]
for one in lines:
    assert sorted(one) == ["error", "file", "files", "messages", "report", "status"]
    error = one["error"]
    if one["status"]:
        assert sorted(error) == ["code", "column", "file", "kind", "line", "words"]
        assert error["kind"] == "error" and error["file"] == one["file"]
        assert error["line"] == 1 and error["column"] > 1
        assert error["words"]["en"] and error["words"]["ko"] != error["words"]["en"]
        assert error == one["messages"][-1]
        assert one["report"] is None and one["files"] == []
    else:
        assert error is None
        if sys.argv[2] == "check":
            alone = subprocess.run([sys.argv[4], "check", "--json", one["file"]],
                                   stdout=subprocess.PIPE, check=True)
            assert one["report"] == json.loads(alone.stdout)
        if sys.argv[2] == "draw":
            assert one["files"] == [one["file"][:-3] + ".svg"]
            assert one["messages"][0]["code"] == "wrote"
codes = [one["error"]["code"] for one in lines if one["error"]]
assert codes == ["model_error.syntax", "model_error.missing"], codes
PY
for verb in check draw unfold; do
  more=()
  [ $verb = check ] || more=(-o '%.svg')
  run $verb --each --json $five "${more[@]}"
  check "JSON: $verb" status_is 5
  check "JSON: $verb: the lines" python3 lines.py out $verb "$five" "$sanggwan"
  cp out en
  run $verb --each --json $five "${more[@]}" --lang ko
  check "JSON: $verb: the same in Korean" cmp -s out en
done
rm -f ./*.svg
cp cube.pl null.pl
mv null.pl null
run check --each --json --from pl null
check 'JSON: a file of the name null' has '"file":"null"' out
rm null

# A fault of a model, and warnings with --strict, are failures too.
printf 'OFF\n4 3 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n' \
  >open.off
run check --each cube.pl open.off --json
one=$status
"$sanggwan" check open.off >open.out 2>&1
check 'the answer no' is "$one $?" '0 0'
run check --each cube.pl open.off --strict --json
check '--strict' status_is 5
check '--strict: the status of the file' has '"file":"open.off", "status":1' out
check '--strict: not of the other' has '"file":"cube.pl", "status":0' out

# What is wrong with the list is found before anything is done.
mkdir other
cp cube.pl other
usage() { # $1 must be said
  local text=$1
  shift
  run "$@"
  [ "$status" = 2 ] && has "$text" && [ -z "$(find . -name '*.svg')" ]
}
check 'one name of two' usage 'would hold the result of both' \
  draw --each cube.pl other/cube.pl -o '%.svg'
check 'twice' usage 'is named twice' draw --each cube.pl cube.pl -o '%.svg'
check 'no place' usage 'needs a %' draw --each cube.pl -o a.svg
check 'standard output' usage 'needs a %' draw --each cube.pl -o '%.svg' -o -
check 'a table' usage 'needs a %' unfold --each cube.pl -o '%.svg' --table t.csv
check 'standard input' usage 'it has no name' draw --each cube.pl - -o '%.svg'
check 'no file' usage 'MODEL is missing' draw --each -o '%.svg'
check 'json alone' usage '--json needs --each' draw cube.pl --json -o cube.svg
before=$(cat two_cubes.pl)
check 'a model of the list' usage 'one of the files' \
  convert --each cube.pl two_cubes.pl -o 'two_%s.pl'
check 'a model of the list: as it was' is "$(cat two_cubes.pl)" "$before"

check 'an option' usage '2 of 2 files failed' \
  draw --each cube.pl two_cubes.pl --view nowhere -o '%.svg'
run draw --each cube.pl two_cubes.pl --segment 2 -o '%.svg'
check 'an option that is wrong for one' status_is 5
check 'an option that is wrong for one: the other' is "$(ls ./*.svg)" \
  ./two_cubes.svg
rm two_cubes.svg

# Names with numbers are known late: the file that would take the place of
# another one's result fails, the others go on.
cp two_cubes.pl part.pl
cp cube.pl part-1.pl
mkdir numbers
pages=(--page A4 --unit cm --scale 4:1 -o 'numbers/%.svg')
run unfold --each part.pl part-1.pl cube.pl "${pages[@]}"
check 'numbers' status_is 5
check 'numbers: said' has 'numbers/part-1.svg would hold the result of both'
check 'numbers: the first fails' has '1 of 3 files failed: part.pl'
check 'numbers: the others' holds numbers part-1.svg cube.svg
rm numbers/*
run unfold --each part.pl cube.pl "${pages[@]}"
check 'numbers: without it' status_is 0
check 'numbers: all pages' holds numbers part-1.svg part-2.svg part-3.svg \
  cube.svg
rm -r numbers

# Rules are those of each file; what they leave behind ends it.
cp "$here"/docs/pieces_rules.pl pieces.pl
run draw --each cube.pl two_cubes.pl --rules pieces.pl -o '%.svg'
check 'rules' status_is 0
"$sanggwan" draw two_cubes.pl --rules pieces.pl -o alone.svg -q
check 'rules: the same bytes' cmp -s two_cubes.svg alone.svg
"$sanggwan" draw two_cubes.pl -o plain.svg -q
check 'rules: they matter' eval '! cmp -s plain.svg alone.svg'
rm ./*.svg
(cat pieces.pl && echo ':- thread_create(thread_get_message(never), _).') >thread.pl
run draw --each cube.pl two_cubes.pl --rules thread.pl -o '%.svg'
check 'rules that remain' status_is 2
check 'rules that remain: said' has 'what cannot be taken back'
check 'rules that remain: what was done' cmp -s cube.svg <(
  "$sanggwan" draw cube.pl --rules pieces.pl -o cube_alone.svg -q
  cat cube_alone.svg)
check 'rules that remain: no more' absent two_cubes.svg
rm ./*.svg

# In a session it is a verb as any other; a batch has a job for each file.
echo "job(all, check, ['cube.pl', 'two_cubes.pl'], [each, json])." >jobs.pl
run batch jobs.pl -o batched
check 'a batch has jobs for that' status_is 3
check 'a batch: the place' eval '[[ $err == "jobs.pl:1:46: unknown option --each"* ]]'

cat >asked.py <<'PY'
import sys
sys.path.insert(0, sys.argv[2])
from session import Session
session = Session(sys.argv[1])
head, _ = session.ask("run", argv=["draw", "--each", *sys.argv[3].split(),
                                   "-o", "%.svg"])
codes = [one["code"] for one in head["messages"]]
assert head["status"] == 5 and head["error"]["code"] == "each_failed", head
assert head["files"] == ["cube.svg", "two_cubes.svg", "pipe_tee.svg"], head
assert codes == ["wrote", "model_error.syntax", "wrote", "model_error.missing",
                 "wrote", "each_failed"], codes
head, _ = session.ask("run", argv=["check", "cube.pl"])
assert head["messages"] == [] and head["files"] == [], head
PY
check 'a session' python3 asked.py "$sanggwan" "$here/tests/cli" "$five"
rm -f ./*.svg

# Ctrl-C ends all: what is done stays, nothing else comes.
cp "$here"/facts/figures/fig13.pl slow.pl
mkdir ended
list=()
for i in $(seq 200); do
  cp slow.pl "slow$i.pl"
  list+=("slow$i.pl")
done
(trap - INT; exec "$sanggwan" draw --each "${list[@]}" -o 'ended/%.svg') \
  >out 2>err &
pid=$!
for _ in $(seq 400); do
  [ -e ended/slow2.svg ] && break
  sleep 0.05
done
kill -INT $pid
wait $pid
status=$? err=$(cat err)
check 'Ctrl-C' status_is 130
check 'Ctrl-C: said once' is "$(grep -c interrupted err)" 1
count=$(ls ended | wc -l)
check 'Ctrl-C: not all' [ "$count" -lt 200 ]
check 'Ctrl-C: nothing temporary' is "$(ls -A ended | grep -v '^slow[0-9]*.svg$')" ''
"$sanggwan" draw slow.pl -o slow.svg -q
check 'Ctrl-C: what is there is whole' \
  is "$(cat ended/*.svg | wc -c)" "$(($(wc -c <slow.svg) * count))"
finish
