#!/bin/bash
# serve_fuzz.sh -- sessions at random: serve_same.py has verbs in random order, for
# SERVE_SECONDS more; journal_fuzz.py damages SERVE_JOURNALS journals, rules_fuzz.py
# tries SERVE_RULES rule files, and serve_fuzz.py sends SERVE_FRAMES random frames.
# SERVE_SEED is of all.
# covers: journal, port
. "$(dirname "$0")/harness.bash"
cd "$here" || exit 2

seed=${SERVE_SEED:-1}
asked tests/cli/serve_same.py "${SERVE_SECONDS:-0}" "$seed"
asked tests/cli/journal_fuzz.py "${SERVE_JOURNALS:-60}" "$seed"
asked tests/cli/rules_fuzz.py "${SERVE_RULES:-40}" "$seed"
asked tests/cli/serve_fuzz.py "${SERVE_FRAMES:-1500}" "$seed"
finish
