#!/bin/bash
# serve.sh -- sessions: serve.py asks one all there is, and what goes wrong. More
# are in serve_document.sh, serve_journal.sh, serve_studio.sh and serve_fuzz.sh.
# covers: ask, document, job, message_object, port, process_state, session
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

asked tests/cli/serve.py
finish
