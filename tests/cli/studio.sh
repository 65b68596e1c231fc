#!/bin/bash
# studio.sh -- the studio: tests/studio/front_test.py asks its front as pages do,
# and attacks its guard; tests/studio/browser_test.py uses the page in a real
# browser, if there is one.
# covers: front, guard, visitor, visitor_path, visitor_upload, page_file, model_tree
# covers: answer_name, studio_words, visitor_answer, ask_problem
. "$(dirname "$0")/harness.bash"
cd "$here" || exit 2

# asked SCRIPT: its tests are counted here.
asked() {
  mkdir "$work/$1"
  PYTHONDONTWRITEBYTECODE=1 timeout 400 python3 tests/studio/"$1" "$sanggwan" \
    "$work/$1" >"$work/asked" 2>&1
  grep -v ' passed, ' "$work/asked"
  local more less
  read -r more _ less _ < <(tail -1 "$work/asked" | grep ' passed, ')
  passed=$((passed + ${more:-0})) failed=$((failed + ${less:-1}))
}

asked front_test.py
asked class_test.py
asked limit_test.py
asked kill_test.py
asked socket_test.py
if command -v chromedriver >/dev/null && command -v chromium >/dev/null; then
  asked browser_test.py
  asked turning_test.py
  asked handles_test.py
  asked kill_browser_test.py
  asked matrix_test.py
else
  echo 'skipped: the page in a browser: chromium, chromium-driver are not there'
fi
finish
