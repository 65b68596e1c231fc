# in_browser.bash -- for tests/cli/studio_*.sh.

# in_browser SCRIPT...: each is asked, in a real browser, if there is one.
in_browser() {
  if command -v chromedriver >/dev/null && command -v chromium >/dev/null; then
    for script in "$@"; do
      asked tests/studio/"$script"
    done
  else
    echo 'skipped: the page in a browser: chromium, chromium-driver are not there'
  fi
}
