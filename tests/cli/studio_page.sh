#!/bin/bash
# studio_page.sh -- the page of the studio in a real browser.
. "$(dirname "$0")/harness.bash"
cd "$here" || exit 2
. tests/studio/in_browser.bash

in_browser browser_test.py lines_test.py turning_test.py
finish
