# asked.bash -- for tests/cli/studio*.sh.

# asked SCRIPT: its tests are counted here.
asked() {
  mkdir "$work/$1"
  PYTHONDONTWRITEBYTECODE=1 timeout 900 python3 tests/studio/"$1" "$sanggwan" \
    "$work/$1" >"$work/asked" 2>&1
  grep -v ' passed, ' "$work/asked"
  local more less
  read -r more _ less _ < <(tail -1 "$work/asked" | grep ' passed, ')
  passed=$((passed + ${more:-0})) failed=$((failed + ${less:-1}))
}

# in_browser SCRIPT...: the same, in a real browser, if there is one.
in_browser() {
  if command -v chromedriver >/dev/null && command -v chromium >/dev/null; then
    for script in "$@"; do
      asked "$script"
    done
  else
    echo 'skipped: the page in a browser: chromium, chromium-driver are not there'
  fi
}
