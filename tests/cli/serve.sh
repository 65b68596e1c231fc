#!/bin/bash
# serve.sh -- sessions: serve.py asks one all there is, and what goes wrong.
. "$(dirname "$0")/harness.bash"
cd "$here" || exit 2

run serve
check 'without --stdio' status_is 2
check 'without --stdio: said' has 'needs --stdio'
run serve --stdio facts/cube.pl
check 'with a file' status_is 2
check 'with a file: said' has 'takes no files'
run serve --stdio --rules docs/glass_rules.pl
check 'no other options' status_is 2
run serve --stdio
check 'no request' status_is 0
check 'no request: silent' silent out

PYTHONDONTWRITEBYTECODE=1 timeout 300 python3 tests/cli/serve.py \
  "$sanggwan" "$work" >"$work/asked" 2>&1
grep -v ' passed, ' "$work/asked"
read -r more _ less _ < <(tail -1 "$work/asked")
passed=$((passed + ${more:-0})) failed=$((failed + ${less:-1}))
finish
