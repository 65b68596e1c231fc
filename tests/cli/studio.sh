#!/bin/bash
# studio.sh -- the studio: its front is asked as pages ask it, its guard is
# attacked, and it is killed. What a page does in a browser: studio_page.sh,
# studio_handles.sh, studio_flows.sh, studio_matrix.sh. What pupils may send, and the
# book of a class, at random: CLASS_REQUESTS, CLASS_BOOKS, CLASS_SEED.
# covers: front, guard, visitor, visitor_path, visitor_upload, page_file, model_tree
# covers: answer_name, studio_words, visitor_answer, ask_problem
. "$(dirname "$0")/harness.bash"
cd "$here" || exit 2
. tests/studio/asked.bash

asked front_test.py
asked class_test.py
asked class_fuzz.py
asked limit_test.py
asked kill_test.py
asked socket_test.py
finish
