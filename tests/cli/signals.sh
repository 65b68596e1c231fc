#!/bin/bash
# signals.sh -- a signal at any moment of a long run ends the program soon, with
# its number, and leaves every folder as it was. SIGNAL_TIMES=N: at more moments.
. "$(dirname "$0")/harness.bash"
cd "$here" || exit 2
times=${SIGNAL_TIMES:-3}
to=$work/to
export TMPDIR=$work/tmp
mkdir "$to" "$TMPDIR"
echo old >"$to/a.off"

# Two balls of 4 N (N - 1) triangles.
awk -v n=80 'function at(i, j) {
  return i == 0 ? 1 : i == n ? (n - 1) * 2 * n + 2 : (i - 1) * 2*n + j % (2*n) + 2
}
BEGIN { pi = 3.14159265358979
  for (x = 0; x < 2; x++) {
    file = "'"$work"'/ball" x ".obj"
    for (i = 0; i <= n; i++) for (j = 0; j < (i % n ? 2 * n : 1); j++)
      printf "v %.15f %.15f %.15f\n", 0.7 * x + sin(pi*i/n) * cos(pi*j/n), \
        sin(pi*i/n) * sin(pi*j/n), cos(pi*i/n) > file
    for (i = 0; i < n; i++) for (j = 0; j < 2 * n; j++) {
      if (i < n - 1) print "f", at(i, j), at(i+1, j), at(i+1, j+1) > file
      if (i > 0) print "f", at(i, j), at(i+1, j+1), at(i, j+1) > file
    }
  }
}'

set -m # else a background job ignores SIGINT
now() { date +%s%N; }

# A run that was at its end already when the signal came: its files are there.
at_its_end() {
  [ "$status" = 0 ] || { [ "$status" = 143 ] && grep -q wrote "$work/err"; }
}

# ended NAME SIGNAL MILLISECONDS ARGUMENT...: SIGNAL after so long; $status and
# $took, ms. Nothing may be left behind.
ended() {
  local name=$1 signal=$2 after=$3 begin
  shift 3
  timeout -s KILL 60 "$sanggwan" "$@" >"$work/out" 2>"$work/err" </dev/null &
  local watch=$!
  sleep "$(printf '%d.%03d' $((after / 1000)) $((after % 1000)))"
  local pid
  { pid=$(<"/proc/$watch/task/$watch/children"); } 2>/dev/null # pgrep is slow
  pid=${pid%% *}
  begin=$(now)
  [ -n "$pid" ] && kill -"$signal" "$pid" 2>/dev/null
  wait $watch
  status=$?
  took=$((($(now) - begin) / 1000000))
  at_its_end && return
  [ "$took" -gt "$worst" ] && worst=$took
  check "$name: only what was there" holds "$to" a.off
  check "$name: nothing temporary" holds "$TMPDIR"
}

# Every signal, while a goal runs and while it waits.
worst=0
number() { kill -l "$1"; }
for signal in HUP INT QUIT TERM USR1 ALRM XCPU; do
  for goal in 'repeat, fail' 'sleep(30)'; do
    ended "$signal, $goal" $signal 800 query facts/cube.pl "$goal"
    check "$signal, $goal: its number" status_is $((128 + $(number $signal)))
    check "$signal, $goal: said" has interrupted
    check "$signal, $goal: soon" test "$took" -lt 1000
  done
done
for signal in INT TERM; do
  ended "$signal that a goal catches" $signal 800 query facts/cube.pl \
    'catch((repeat, fail), _, (repeat, fail))'
  check "$signal that a goal catches: its number" \
    status_is $((128 + $(number $signal)))
  check "$signal that a goal catches: said" has interrupted
  check "$signal that a goal catches: soon" test "$took" -lt 1000
done

# A batch ends with its workers, whatever they do.
printf "job(a(N), query, ['%s', 'repeat, fail'], []) @ N in 1..4.\n" \
  "$here/facts/cube.pl" >"$work/m.pl"
ended 'batch' TERM 1500 batch -q "$work/m.pl" -o "$work/b" -j 2
check 'batch: its number' status_is 143
check 'batch: soon' test "$took" -lt 1000
for ((i = 0; i < 20; i++)); do
  pgrep -f "$work/(b|m.pl)" >/dev/null || break
  sleep 0.1
done
check 'batch: its workers' test "$i" -lt 20

# The verb decides, not another word of the command.
cd "$work" || exit 2
for word in repl batch; do
  echo 'may_cut(_, _).' >$word
  ended "a file $word" INT 800 -q query --rules $word "$here/facts/cube.pl" \
    'catch((repeat, fail), _, (repeat, fail))'
  check "a file $word: its number" status_is 130
  check "a file $word: soon" test "$took" -lt 1000
done
cd "$here" || exit 2

# In the top level SIGINT stops a goal, and the next one is read.
mkfifo "$work/goals"
"$sanggwan" repl facts/cube.pl <"$work/goals" >"$work/out" 2>"$work/err" &
exec 8>"$work/goals"
echo 'write(user_error, begun), repeat, fail.' >&8
for ((i = 0; i < 300; i++)); do
  grep -q begun "$work/err" && break
  sleep 0.1
done
kill -INT $!
sleep 0.5
echo 'X = after.' >&8
exec 8>&-
wait $!
status=$?
check 'top level' status_is 0
check 'top level: the goal' has interrupted
check 'top level: the next one' has after "$work/out"

# When the work is done, the status is that of the work, or of the signal.
others=
for ((i = 0; i < 30; i++)); do
  rm -f "$to"/a-*
  "$sanggwan" split -q facts/cube.pl --plane 0,0,1,-0.5 -o "$to/a.stl" \
    2>"$work/err" &
  until [ -e "$to/a-above.stl" ] || ! kill -0 $! 2>/dev/null; do :; done
  for ((k = i * 40; k > 0; k--)); do :; done
  kill -TERM $! 2>/dev/null
  wait $! 2>/dev/null
  status=$?
  case $status in 0 | 143) ;; *) others="$others $status" ;; esac
done
check 'a signal at the end' is "$others" ''
check 'a signal at the end: done' holds "$to" a-above.stl a-below.stl a.off
rm -f "$to"/a-*

# Those that were ignored stay so: nohup.
trap '' HUP
"$sanggwan" query facts/cube.pl 'sleep(1), X = 1' >"$work/out" 2>"$work/err" &
trap - HUP
sleep 0.6
kill -HUP $!
wait $!
status=$?
check 'nohup' status_is 0
check 'nohup: the answer' has 1 "$work/out"

# A long run: how long it takes, then moments of it. A run that was quicker than
# the moment is tried again with an earlier one.
moments() {
  local name=$1 begin whole after i
  shift
  begin=$(now)
  run "$@"
  whole=$((($(now) - begin) / 1000000))
  check "$name: runs" status_is 0
  find "$to" -type f -delete
  echo old >"$to/a.off"
  for ((i = 1; i <= times; i++)); do
    after=$((whole * i / (times + 1)))
    while ended "$name, $i" TERM "$after" "$@"
          at_its_end && [ "$after" -gt 10 ]; do
      after=$((after / 2))
      find "$to" -type f -delete
      echo old >"$to/a.off"
    done
    check "$name, $i: its number" status_is 143
    check "$name, $i: as it was" is "$(cat "$to/a.off")" old
    check "$name, $i: soon" test "$took" -lt 1000
  done
}
moments union union "$work/ball0.obj" "$work/ball1.obj" -o "$to/a.off"
moments draw draw "$work/ball0.obj" "$work/ball1.obj" -o "$to/a.svg" \
  -o "$to/a.pdf"
all=$times
times=${SIGNAL_TIMES:-1}
moments glue glue "$work/ball0.obj" "$work/ball1.obj" -o "$to/a.pl"

# SIGKILL leaves no time to tidy up: the file is as it was all the same, also
# while another one is written, which has no name yet and goes; and the next run
# makes it.
killed() { # NAME, WHEN: a command that waits, ARGUMENT...
  local name=$1 when=$2 pid
  shift 2
  echo old >"$to/a.pl"
  "$sanggwan" "$@" >"$work/out" 2>"$work/err" </dev/null &
  pid=$!
  $when $pid
  kill -KILL $pid 2>/dev/null
  wait $pid 2>/dev/null
  status=$?
  check "$name: its number" status_is 137
  check "$name: as it was" is "$(cat "$to/a.pl")" old
  check "$name: nothing else is there" is "$(ls -A "$to")" "$(printf \
    '%s\n' a.off a.pl)"
}
for_half_a_second() { sleep 0.5; }
until_it_writes() { # PID
  while kill -0 "$1" 2>/dev/null &&
        [ -z "$(find "/proc/$1/fd" -lname "$to/#*" 2>/dev/null)" ]; do
    sleep 0.01
  done
}
killed 'glue, killed' for_half_a_second \
  glue "$work/ball0.obj" "$work/ball1.obj" -o "$to/a.pl"
killed 'glue, killed while it writes' until_it_writes \
  glue "$work/ball0.obj" "$work/ball1.obj" -o "$to/a.pl"
run glue -q "$work/ball0.obj" "$work/ball1.obj" -o "$to/a.pl"
check 'glue, after that: done' status_is 0
check 'glue, after that: whole' has 'segment(3, cells, glue([1, 2])).' \
  "$to/a.pl"
find "$to" -type f ! -name a.off -delete

moments unfold unfold "$work/ball0.obj" -o "$to/a.svg"
moments convert convert "$work/ball0.obj" -o "$to/a.pl"
moments penetrate penetrate "$work/ball0.obj" "$work/ball1.obj" -o "$to/a.csv"
moments split split "$work/ball0.obj" --plane 0,0,1,-0.1 -o "$to/a.stl"
moments query query "$work/ball0.obj" \
  'aggregate_all(count, (t(1,_,_,A,B,_), e(1,_,B,A,_)), N)'
printf 'counted: the slowest of %d ends took %d ms\n' \
  "$((17 + 2 * all + 5 * times))" "$worst"
finish
