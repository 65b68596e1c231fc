#!/bin/bash
# serve_studio.sh -- what a studio asks of a session.
# covers: ask, document, port, session
. "$(dirname "$0")/harness.bash"
cd "$here" || exit 2

asked tests/cli/serve_studio.py
finish
