#!/bin/bash
# studio.sh -- the studio: its front is asked as pages ask it, its guard is
# attacked, and it is killed. What a page does in a browser: studio_page.sh,
# studio_handles.sh, studio_flows.sh, studio_matrix.sh. What pupils may send, and the
# book of a class, at random: CLASS_REQUESTS, CLASS_BOOKS, CLASS_SEED.
# covers: front, guard, visitor, visitor_path, visitor_upload, page_file, model_tree
# covers: answer_name, studio_words, visitor_answer, ask_problem
. "$(dirname "$0")/harness.bash"
cd "$here" || exit 2

asked tests/studio/front_test.py
asked tests/studio/class_test.py
asked tests/studio/class_fuzz.py
asked tests/studio/limit_test.py
asked tests/studio/kill_test.py
asked tests/studio/socket_test.py
finish
