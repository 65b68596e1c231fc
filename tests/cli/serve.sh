#!/bin/bash
# serve.sh -- sessions: serve.py asks one all there is, and what goes wrong;
# serve_studio.py asks what a studio would;
# serve_document.py has its document, killed SERVE_KILLS times; serve_same.py has
# verbs in random order, for SERVE_SECONDS more. serve_fuzz.py
# sends SERVE_FRAMES random frames, journal_fuzz.py damages SERVE_JOURNALS journals,
# rules_fuzz.py tries SERVE_RULES rule files. SERVE_SEED is of all.
# covers: ask, document, job, journal, message_object, port, process_state, session
# covers: request, document_verb, laid_out, process_limit
. "$(dirname "$0")/harness.bash"
cd "$here" || exit 2

run serve --stdio facts/cube.pl
check 'with a file' status_is 2
check 'with a file: said' has 'takes no files'
run serve --stdio --rules docs/glass_rules.pl
check 'no other options' status_is 2
run serve --stdio
check 'no request' status_is 0
check 'no request: silent' silent out
cp facts/cube.pl "$work/cube.txt"
for model in "$work/cube.txt" "$work" "$work/none.pl"; do
  run serve --no-open "$model"
  check "no model: ${model##*/}" status_is 3
done
run serve --no-open "$work/cube.txt"
check 'no model: said' has 'models of the format .txt are not known'

# asked SCRIPT ARGUMENT...: its tests are counted here.
asked() {
  PYTHONDONTWRITEBYTECODE=1 timeout 600 python3 tests/cli/"$1" "$sanggwan" \
    "${@:2}" >"$work/asked" 2>&1
  grep -v ' passed, ' "$work/asked"
  local more less
  read -r more _ less _ < <(tail -1 "$work/asked" | grep ' passed, ')
  passed=$((passed + ${more:-0})) failed=$((failed + ${less:-1}))
}

mkdir "$work/one" "$work/document" "$work/studio" "$work/same" "$work/fuzz" \
  "$work/journals" "$work/rules"
asked serve.py "$work/one"
asked serve_document.py "$work/document"
asked serve_studio.py "$work/studio"
asked serve_same.py "$work/same" "${SERVE_SECONDS:-0}" "${SERVE_SEED:-1}"
asked journal_fuzz.py "$work/journals" "${SERVE_JOURNALS:-60}" \
  "${SERVE_SEED:-1}"
asked rules_fuzz.py "$work/rules" "${SERVE_RULES:-40}" "${SERVE_SEED:-1}"
asked serve_fuzz.py "$work/fuzz" "${SERVE_FRAMES:-1500}" "${SERVE_SEED:-1}"
finish
