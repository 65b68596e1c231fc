#!/bin/bash
# embed.sh -- docs/example.c as a user builds and runs it; the header in C++.
. "$(dirname "$0")/../check.sh"
EXAMPLE=$B/docs/example

cat >"$TMP/expected" <<'TEXT'
segment 1, a solid, has 556 edges
segment 2, a solid, has 556 edges
the longest line is open, of 20 pieces, 3.816272 long
vertex 81 at (-0.7071, -0.7071, -0.7071) comes from ll(1-(26,66),2-(36,76))
vertex 82 at (-0.5878, -0.8090, -0.5878) comes from ll(1-(27,67),2-(35,75))
vertex 83 at (-0.8090, -0.5878, -0.8090) comes from ll(1-(25,65),2-(37,77))
TEXT
answers() { "$EXAMPLE" "$1" >"$TMP/answers" && diff "$TMP/expected" "$TMP/answers"; }

check "the example answers"          answers facts/figures/fig13.pl
check "a missing model is input"     complains 3 'no_such.pl' \
                                     "$EXAMPLE" "$TMP/no_such.pl"
check "in the language of LC_MESSAGES" complains 3 '그런 파일이 없습니다' \
  env LC_ALL= LC_MESSAGES=ko_KR.UTF-8 LANG=C "$EXAMPLE" "$TMP/no_such.pl"
echo 'v(1, 1, 0, 0).' >"$TMP/bad.pl"
check "a bad model names its line"   complains 3 'bad.pl:1:' \
                                     "$EXAMPLE" "$TMP/bad.pl"
printf '#include "sanggwan.h"\nint main() { return sanggwan_start(); }\n' \
  >"$TMP/host.cpp"
if command -v c++ >/dev/null; then
  check "the header is C++" \
    c++ -Wall -Wextra -Wpedantic -Werror -fsyntax-only -Iengine "$TMP/host.cpp"
else
  skip "the header is C++" "there is no C++ compiler"
fi
check "the header is strict C99" cc -std=c99 -Wall -Wextra -Wpedantic -Werror \
  -fsyntax-only -x c -Iengine engine/sanggwan.h
check_report
