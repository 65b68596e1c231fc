#!/bin/bash
# studio_handles.sh -- dots that pull sizes, and addresses that say what is seen, in a
# real browser.
. "$(dirname "$0")/harness.bash"
cd "$here" || exit 2
. tests/studio/in_browser.bash

in_browser handles_test.py link_test.py
finish
