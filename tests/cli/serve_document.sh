#!/bin/bash
# serve_document.sh -- the document of a session.
# covers: ask, document, session
. "$(dirname "$0")/harness.bash"
cd "$here" || exit 2

asked tests/cli/serve_document.py
finish
