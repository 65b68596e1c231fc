#!/bin/bash
# studio_flows.sh -- what people do with the page of the studio, in both languages
# on screens of several sizes, and when the browser is killed.
. "$(dirname "$0")/harness.bash"
cd "$here" || exit 2
. tests/studio/asked.bash

in_browser kill_browser_test.py matrix_test.py models_test.py
finish
