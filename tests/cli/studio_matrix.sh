#!/bin/bash
# studio_matrix.sh -- what people do with the page of the studio, in both languages
# on screens of several sizes.
. "$(dirname "$0")/harness.bash"
cd "$here" || exit 2
. tests/studio/in_browser.bash

in_browser matrix_test.py
finish
