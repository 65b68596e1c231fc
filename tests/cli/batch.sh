#!/bin/bash
# batch.sh -- what is done once stays done: batches that are killed at any
# moment, that run twice at once or in shards, whose jobs loop, eat memory or
# crash, and whose disk is full, make the same bytes in the end as one that
# nothing disturbs. TEST_ALL=1: killed at 50 moments; a sample otherwise.
# covers: batch_html, batch_junit, batch_merge, batch_report, batch_store
# covers: job_key, job_name, job_names, job_words, manifest, runner
# covers: job_result, job_workers, run_state, verbs_batch, worker, files_read
. "$(dirname "$0")/harness.bash"
cd "$work" || exit 2
times=4
[ -n "${TEST_ALL:-}" ] && times=50
cp "$here"/facts/cube.pl "$here"/facts/two_cubes.pl "$here"/facts/figures/fig13.pl .

cat >many.pl <<'END'
defaults([time_limit(60), output('%.svg')]).
job(a(N), draw, ['two_cubes.pl'], [view(N, 30)]) @ N in 1..24.
job(b(N), draw, ['fig13.pl'], [view(N, 30), output('%.svg'), output('x/%.json')])
    @ N in 1..6.
job(both, union, ['two_cubes.pl'], [output('%.stl'), output('%.off')]).
job(counts, check, ['two_cubes.pl'], [json]).
END

# What is in the folder of results $1: each file and each link.
tree() {
  (cd "$1" && find . -type f -exec sha256sum {} + && find . -type l \
    -printf '%p -> %l\n' && find . -type d) | sort
}
same_tree() { [ "$(tree "$1")" = "$(tree "$2")" ]; }
outcomes() { # how many of each, as "done 3 failed 1"
  sed -n 's/.*"outcome":"\([a-z]*\)".*/\1/p' "$1" | sort | uniq -c |
    awk '{ printf "%s%s %s", n++ ? " " : "", $2, $1 }'
}
report_is() { is "$(outcomes r.jsonl)" "$1"; }
json() { # each line of a file is an object of JSON
  python3 -c 'import json, sys
for line in open(sys.argv[1]): assert type(json.loads(line)) is dict' "$1"
}
batch() { run batch "$@" --report r.jsonl; }

# Undisturbed, and again.
batch many.pl -o good -j 2
check 'batch' status_is 0
check 'batch: all done' report_is 'done 32'
check 'batch: said' has '32 done'
check 'batch: JSON lines' json r.jsonl
check 'batch: nothing temporary' absent good/store/.tmp
tree good >tree1
batch many.pl -o good -j 2
check 'again' report_is 'cached 32'
check 'again: the same files' is "$(tree good)" "$(cat tree1)"
run draw fig13.pl --view 3,30 -o one.svg -q
check 'the bytes of draw' cmp -s one.svg good/b-3.svg
run check two_cubes.pl --json
check 'what a verb prints' cmp -s out good/counts.stdout.json
(cd / && "$sanggwan" batch "$work/many.pl" -o "$work/far" -j 2 -q) >far.jsonl
check 'from another folder' same_tree far good
batch many.pl -o copied --copy -j 3
check 'copies' cmp -s copied/b-3.svg good/b-3.svg
check 'copies: no links' is "$(find copied -type l)" ''

# A result that was changed, or lost: made again.
echo more >>"$(readlink -f good/a-1.svg)"
rm good/a-2.svg "$(dirname "$(readlink -f good/a-3.svg)")/job.json"
batch many.pl -o good -j 2
check 'spoiled' report_is 'cached 30 done 2'
check 'spoiled: mended' is "$(tree good)" "$(cat tree1)"

# An input that changed.
sed 's/^%.*//' cube.pl >turned.pl
echo "job(t, draw, ['turned.pl'], [output('%.svg')])." >turned_batch.pl
batch turned_batch.pl -o turned
echo '% more' >>turned.pl
batch turned_batch.pl -o turned
check 'changed input' report_is 'done 1'

# A job of any verb; every file that it writes is its own, and stays with it.
echo 'look(1, colour(red)).' >look.pl
cat >verbs.pl <<'END'
job(glued, glue, ['two_cubes.pl'], [output('%.pl')]).
job(cells, cells, ['two_cubes.pl'], [json, output('%.csv')]).
job(seen, render, ['two_cubes.pl'],
    [ size('80x60'), look('look.pl'), output('%.png'), spans('%-spans.csv'),
      buffer(depth='%.pfm'), buffer(id='of/%.csv'), scan_line(30='%.svg') ]).
END
batch verbs.pl -o verbs -j 2
check 'verbs' report_is 'done 3'
check 'verbs: their files' is "$(cd verbs && find . -type l | sort | xargs)" \
  './cells.csv ./cells.stdout.json ./glued.pl ./glued.stdout.txt ./of/seen.csv'\
' ./seen-spans.csv ./seen.pfm ./seen.png ./seen.svg'
run render two_cubes.pl --size 80x60 --look look.pl -o one.png \
  --buffer depth=one.pfm -q
check 'verbs: the bytes of render' \
  is "$(cat one.png one.pfm | sha256sum)" \
  "$(cat verbs/seen.png verbs/seen.pfm | sha256sum)"
echo "job(back, unglue, ['verbs/glued.pl'], [output('%.pl')])." >back.pl
batch back.pl -o back
check 'verbs: unglue' report_is 'done 1'
echo 'look(1, colour(blue)).' >look.pl
batch verbs.pl -o verbs
check 'verbs: another look' report_is 'cached 2 done 1'
for option in "buffer(depth='d.pfm')" "buffer(depth='../%.pfm')" \
  "spans('%.txt')" "look('none.pl')"; do
  echo "job(a, render, ['cube.pl'], [output('%.png'), $option])." >bad.pl
  batch bad.pl -o bad
  check "verbs: $option" status_is 3
done
echo "job(a, render, ['cube.pl'], [])." >bad.pl
batch bad.pl -o bad
check 'verbs: no output' has 'a job of render writes files, and this one says none'

# Shards: together they are the whole, and each job is in one.
for i in 1 2 3; do
  batch many.pl -o shards --shard $i/3 -j 1
  check "shard $i" status_is 0
  mv r.jsonl shard$i.jsonl
done
check 'shards: the whole' same_tree shards good
check 'shards: each once' is \
  "$(cat shard?.jsonl | grep -c '"outcome":"done"')" 32
run batch --merge shard?.jsonl -o all.json -o all.xml -o shards/index.html
check 'merged' status_is 0
check 'merged: JSON' python3 -c 'import json
d = json.load(open("all.json"))
assert d["jobs"] == 32 == d["outcomes"]["done"]
assert [r["number"] for r in d["results"]] == list(range(1, 33))'
check 'merged: JUnit' python3 -c 'import xml.etree.ElementTree as E
r = E.parse("all.xml").getroot()
assert r.get("tests") == "32" and r.get("errors") == "0" == r.get("failures")
assert len(r.findall("testsuite/testcase")) == 32'
check 'merged: pictures that are there' python3 -c 'import os, re
t = open("shards/index.html").read()
p = re.findall(r"<img src=\"([^\"]*)\"", t)
assert len(p) == 30 and all(os.path.exists("shards/" + q) for q in p)'
rm shards/index.html

# A report that has no place.
run batch many.pl -o good --report nowhere/r.jsonl
check 'no folder for the report' status_is 2
check 'no folder for the report: said' has 'there is no folder nowhere'
run batch many.pl -o good --report good
check 'the report is a folder' has 'good is a folder; the result is a file'

# Two batches of one manifest at once.
"$sanggwan" batch many.pl -o twice -j 2 -q >t1.jsonl 2>t1.err &
"$sanggwan" batch many.pl -o twice -j 2 -q >t2.jsonl 2>t2.err
first=$?
wait $!
check 'twice at once' is "$first $?" '0 0'
check 'twice at once: the same' same_tree twice good
check 'twice at once: each has all' is \
  "$(grep -c '"status":0' t1.jsonl) $(grep -c '"status":0' t2.jsonl)" '32 32'

# Killed at any moment, and gone on with. A worker ends by itself.
for ((k = 1; k <= times; k++)); do
  rm -rf killed
  "$sanggwan" batch many.pl -o killed -j 2 -q >k.jsonl 2>k.err &
  pid=$!
  sleep "0.$((RANDOM % 10))$((RANDOM % 10))"
  kill -9 $pid 2>/dev/null
  wait $pid 2>/dev/null
  batch many.pl -o killed -j 2
  check "killed $k" status_is 0
  check "killed $k: the same bytes" same_tree killed good
done

# Ctrl-C: the jobs that run end, no other begins; what was done is there. A
# second one ends them.
cat >slow.pl <<'END'
job(s(N), query, ['cube.pl', 'sleep(1)'], [limit(N), json]) @ N in 1..9.
END
begun() { # a batch in the background; waits until a job is done
  rm -f s.jsonl
  set -m # else a background job ignores SIGINT
  "$sanggwan" batch "$@" --report s.jsonl >"$work/out" 2>"$work/err" &
  pid=$!
  set +m
  until grep -q '"job"' s.jsonl 2>/dev/null || ! kill -0 $pid; do sleep 0.05; done
}
begun slow.pl -o slow -j 2
kill -INT $pid
wait $pid
status=$?
check 'Ctrl-C' status_is 130
check 'Ctrl-C: the last line' has '"interrupted":true' s.jsonl
check 'Ctrl-C: no other began' test "$(grep -c '"job"' s.jsonl)" -le 4
check 'Ctrl-C: what ran is done' is "$(outcomes s.jsonl | cut -d' ' -f1)" done
check 'Ctrl-C: nothing temporary' absent slow/store/.tmp
echo "job(sleeper, query, ['cube.pl', 'sleep(100)'], []).
job(first, query, ['cube.pl', 'true'], [json])." >sleeper.pl
begun sleeper.pl -o twice_stopped -j 2
kill -INT $pid
sleep 0.5
check 'Ctrl-C: one waits' kill -0 $pid
kill -INT $pid
wait $pid
status=$?
check 'Ctrl-C twice' status_is 130
check 'Ctrl-C twice: nothing temporary' absent twice_stopped/store/.tmp

# SIGTERM: at once, with its number, and nothing is left that runs.
echo "job(sleeper, query, ['cube.pl', 'sleep(100)'], [])." >sleeper.pl
"$sanggwan" batch sleeper.pl -o sleeper -q >k.jsonl 2>k.err &
pid=$!
sleep 0.7
worker=$(pgrep -P $pid | head -1)
kill -TERM $pid
wait $pid
status=$?
check 'SIGTERM' status_is 143
check 'SIGTERM: no worker' absent "/proc/${worker:-none}"
check 'SIGTERM: nothing temporary' absent sleeper/store/.tmp

# Jobs that loop, eat memory, crash; the others are done.
cat >bad.pl <<'END'
job(loop, query, ['cube.pl', 'repeat, fail'], [time_limit(1)]).
job(memory, query, ['cube.pl', 'numlist(1, 20000000, L), L = []'], [memory(200)]).
job(crash, query, ['cube.pl', 'current_prolog_flag(pid, P), process_kill(P, 11)'], []).
job(no, query, ['cube.pl', 'fail'], []).
job(odd, draw, ['cube.pl'], [set(r, 1), output('%.svg')]).
job(good(N), draw, ['cube.pl'], [view(N, 30), output('%.svg')]) @ N in 1..5.
END
batch bad.pl -o bad -j 2 --keep-going
check 'bad' status_is 5
of() { sed -n "s/.*\"job\":\"$1\".*\"status\":\([a-z0-9]*\),\"outcome\":\"\([a-z]*\)\".*/\2 \1/p" r.jsonl; }
check 'bad: loops' is "$(of loop)" 'timeout null'
check 'bad: no memory' is "$(of memory)" 'failed 4'
check 'bad: crashed' is "$(of crash)" 'killed null'
check 'bad: crashed: said' has 'signal 11' r.jsonl
check 'bad: no' is "$(of no)" 'failed 1'
check 'bad: wrong option' is "$(of odd)" 'failed 2'
check 'bad: the others' is "$(grep -c '"job":"good.*done' r.jsonl)" 5
check 'bad: JSON lines' json r.jsonl
batch bad.pl -o bad -j 2 --keep-going --resume
check 'bad, --resume' report_is 'cached 5 failed 3 killed 1 timeout 1'
batch bad.pl -o bad -j 1
check 'bad: ends at the first' status_is 5
check 'bad: ends at the first: no other' is "$(grep -c '"job"' r.jsonl)" 1

# A limit is that of one job: one after it, in the same process, has none; and
# what one before it left there does not count.
cat >limits.pl <<'END'
job(little, check, ['cube.pl'], [memory(90), cpu(30)]).
job(much, query, ['cube.pl', 'numlist(1, 2000000, L), length(L, _)'], []).
job(again, check, ['cube.pl'], [json, memory(90)]).
END
batch limits.pl -o limits -j 1 --keep-going
check 'limits end with their job' report_is 'done 3'

# A disk that takes no more: files of 8 kB at most, then as many as wanted.
(
  set -o pipefail
  (ulimit -f 8 && exec "$sanggwan" batch many.pl -o full -j 2 --keep-going -q) \
    2>full.err | cat >full.out
)
check 'full' is "$?" 5
check 'full: some are done' test "$(grep -c '"outcome":"done"' full.out)" -gt 0
check 'full: said why' has cannot_write full.out
batch many.pl -o full -j 2
check 'full: then room' status_is 0
check 'full: the same' same_tree full good
if mkdir small && mount -t tmpfs -o size=96k none small 2>/dev/null; then
  batch many.pl -o small/out -j 2 --keep-going
  check 'full disk' status_is 5
  check 'full disk: said' has 'disk is full'
  mount -o remount,size=20m small
  batch many.pl -o small/out -j 2
  check 'full disk: then room' status_is 0
  check 'full disk: the same' same_tree small/out good
  umount small
else
  skip 'a full disk: no tmpfs can be mounted here'
fi

# A family of one model with parameters.
cat >pipe.pl <<'END'
param(d, 114.3).
segment(1, solid, cylinder(radius(param(d)/2), height(100))).
END
printf 'outside,wall\n114.3,4\n60.3,2.9\n' >pipes.csv
echo "job(pipe(D), union, ['pipe.pl'], [set(d, D), output('%.stl')])
    @ [D] in rows('pipes.csv', [outside])." >pipes.pl
batch pipes.pl -o pipes
run union pipe.pl --set d=60.3 -o pipe.stl -q
check 'parameters' cmp -s pipe.stl pipes/pipe-60.3.stl

# GNU parallel, as docs/batch.md says.
if command -v parallel >/dev/null && parallel --version 2>/dev/null |
  grep -q GNU; then
  seq 4 | parallel --will-cite "$sanggwan" batch many.pl -o parallel \
    --shard '{}/4' -q --report 'p{}.jsonl' 2>"$work/err"
  check 'GNU parallel' is "$?" 0
  check 'GNU parallel: the same' same_tree parallel good
else
  skip 'GNU parallel is not installed (apt-get install parallel)'
fi

# A quote without its end is a fault, not the end of the table.
printf 'a,b\n1,2\n3,"4\n5,6\n' >quote.csv
echo "job(j(A), check, ['cube.pl'], []) @ [A] in rows('quote.csv', [a])." \
  >quote.pl
batch quote.pl -o quote
check 'a quote without its end' status_is 3
check 'a quote without its end: where' has 'quote.csv:3'

# A default of one verb is none of another that has its name for --each.
cat >each.pl <<'END'
defaults([json, output('%.svg')]).
job(a, check, ['cube.pl'], []).
job(b, draw, ['cube.pl'], []).
END
batch each.pl -o each
check 'json is an option of check' report_is 'done 2'

# Whoever gave it too many jobs sees it, and one Ctrl-C ends it.
echo "job(a(N), draw, ['cube.pl'], [view(N, 30), output('%.svg')]) @ N in 1..10000000." >huge.pl
timeout --preserve-status -s INT -k 60 6 "$sanggwan" batch huge.pl -o huge \
  2>"$work/err"
status=$?
check 'a manifest that is looked through is interrupted' status_is 130
check 'how far the check is' has 'jobs looked at'

# To look through ten thousand jobs needs no more memory than one.
echo "job(a(1), draw, ['cube.pl'], [view(1, 30), output('%.svg')])." >cubes.pl
echo "job(a(N), draw, ['cube.pl'], [view(N, 30), output('%.svg')]) @ N in 1..10000." >big.pl
peak() { # kilobytes
  python3 -c 'import resource, subprocess, sys
subprocess.run(sys.argv[1:], stdout=subprocess.DEVNULL)
print(resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss)' "$@"
}
few=$(peak "$sanggwan" batch cubes.pl -o good -q)
much=$(peak "$sanggwan" batch big.pl -o big -q --shard 1/100000)
check "memory is flat ($few kB, $much kB)" test "$much" -lt $((few + 8000))
finish
