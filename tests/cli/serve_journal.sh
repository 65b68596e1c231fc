#!/bin/bash
# serve_journal.sh -- the journal of a document, killed SERVE_KILLS times, and a long
# session. SERVE_SEED is of all.
# covers: journal, document
. "$(dirname "$0")/harness.bash"
cd "$here" || exit 2

asked tests/cli/serve_journal.py
asked tests/cli/serve_long.py
finish
