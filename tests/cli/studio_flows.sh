#!/bin/bash
# studio_flows.sh -- models that people open in the page of the studio, a browser
# that is killed, and what the page says of what is so.
. "$(dirname "$0")/harness.bash"
cd "$here" || exit 2
. tests/studio/in_browser.bash

in_browser kill_browser_test.py models_test.py states_test.py
finish
