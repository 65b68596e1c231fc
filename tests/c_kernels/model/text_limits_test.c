/* What of a text is too deep or too long, and where (text_limits.h). */
#include "model/text_limits.h"
#include "tests/check.h"
#include <string.h>

static sg_text_scan last;

/* The fault of a text that is fed in pieces of n bytes. */
static sg_text_fault
fed(sg_text_kind kind, const char *text, uint64_t depth, size_t n)
{
  sg_text_limits most = {depth, 3, 10, 12, 60, 60};
  size_t length = strlen(text);

  sg_text_scan_open(&last, kind, &most);
  for (size_t i = 0; i < length; i += n) {
    sg_text_scan_feed(&last, text + i, length - i < n ? length - i : n);
  }
  sg_text_scan_close(&last);
  return last.fault;
}

/* How deep a text is; the same whatever pieces it comes in. */
static int
depth(sg_text_kind kind, const char *text)
{
  int d = 1;

  while (d < 50 && fed(kind, text, (uint64_t)d, 1000)) {
    d++;
  }
  return fed(kind, text, (uint64_t)d, 1) == fed(kind, text, (uint64_t)d, 3)
             ? d
             : -1;
}

static int
facts(const char *text)
{
  return depth(SG_TEXT_FACTS, text);
}

static sg_text_fault
fault(const char *text)
{
  return fed(SG_TEXT_FACTS, text, 40, 1000);
}

static void
test_json(void)
{
  const sg_text_kind json = SG_TEXT_JSON;

  CHECK("brackets alone", depth(json, "{\"a\": [1, -2.5e3, {\"b\": 0}]}") == 3);
  CHECK("many members are not deep",
        depth(json, "{\"a\":1,\"b\":2,\"c\":3,\"d\":4,\"e\":5}") == 1);
  CHECK("brackets in texts",
        depth(json, "[\"[[[\", \"\\\"[[\", \"\\\\\", []]") == 2);
  CHECK("comments", depth(json, "[ // \"\n[ /* \" ]] */ [1]]]") == 3);
  CHECK("no other quotes", depth(json, "['[`[%[[[[") > 6);
  CHECK("a point ends nothing", depth(json, "[[1. [") == 3);
  CHECK("one may be long",
        fed(json, "[1,2,3,4,5,6,7,8,9,0,1,2,3,4,5,6,7,8,9,0,1,2,3,4,5,6,7,8,9]",
            9, 7) == SG_TEXT_GOOD);
  CHECK("each of several may be long",
        fed(SG_TEXT_LINES,
            "{\"a\": [1, 2, 3, 4, 5, 6]}\n{\"b\": [1, 2, 3, 4, 5, 6]}\n[]\n"
            "{\"c\": [1, 2, 3, 4, 5, 6]}\n{\"d\": [1, 2, 3, 4, 5, 6]}",
            9, 12) == SG_TEXT_GOOD);
  CHECK("but none too long",
        fed(SG_TEXT_LINES,
            "{\"a\": 1}\n"
            "[1, 2, 3, 4, 5, 6, 1, 2, 3, 4, 5, 6, 1, 2, 3, 4, 5, 6, 1, 2, 3]",
            9, 12) == SG_TEXT_FACT);
  CHECK("several are no deeper", depth(SG_TEXT_LINES, "{}[]{}[[]]{}{}") == 2);
  CHECK("digits", fed(json, "[12345678901]", 9, 5) == SG_TEXT_DIGITS);
  CHECK("a text", fed(json, "[\"abcdefghijklm\"]", 9, 5) == SG_TEXT_NAME);
}

int
main(void)
{
  test_json();
  CHECK("compounds", facts("f(g(h(a))).") == 4);
  CHECK("lists", facts("[[[a]]].") == 4);
  CHECK("a long list is not deep", facts("[a,b,c,d,e,f,g,h].") == 2);
  CHECK("arguments are beside each other", facts("f(g(a),g(b),g(c)).") == 3);
  CHECK("facts are beside each other", facts("f(g(a)).\nf(g(a)).") == 3);
  CHECK("prefix operators", facts("f(- - - a).") == 5);
  CHECK("infix operators", facts("f(a+b+c).") == 6);
  CHECK("names as operators", facts("f(a is b is c).") == 6);
  CHECK("a comma that is an operator", facts("(a,b).") == 4);
  CHECK("the same in braces", facts("{a,b}.") == 4);
  CHECK("a bracket apart from its name", facts("- (a).") == 3);
  CHECK("comment", facts("f(/* ((((( ' */ a). % ((((") == 2);
  CHECK("no end of a comment", facts("f(/*/ (((( */ a).") == 2);
  CHECK("no comment in a sign", facts("f(+/*(((a) */ ).") > 4);
  CHECK("quoted", facts("f('((((''((((', \"((((\").") == 2);
  CHECK("codes are a list", facts("f(`((((`).") == 3);
  CHECK("escapes", facts("f('\\'((((', '\\x28\\((((').") == 2);
  CHECK("a code that a quote ends", facts("f('\\x28', g(a)).") == 3);
  CHECK("characters", facts("f(0'(, 0'', 0''', 0'\\', 0'\\x28\\, a).") == 2);
  CHECK("a radix is no quote", facts("f(16'FF, g(h(a))).") == 4);
  CHECK("two numbers", facts("f(0x1.5).") == 4);
  CHECK("no stop within a sign", facts("f(=. f(a)).") > 3);
  CHECK("no stop within a number", facts("f(1.5, a). f(1. g(a)).") == 2);
  CHECK("goals may be long", depth(SG_TEXT_PROGRAM, "a,b,c,d,e,f,g,h.") == 2);
  CHECK("bodies too",
        depth(SG_TEXT_PROGRAM, "a:-b,c,d,(e,f,g,h,i,j,k,l).") == 3);
  CHECK("but not their brackets", depth(SG_TEXT_PROGRAM, "a:-f(g([b])).") == 3);
  CHECK("nor their operators",
        depth(SG_TEXT_PROGRAM, "a:- - - - - - - - - - - - - - - b.") == 3);
  CHECK("a number in a program",
        fed(SG_TEXT_PROGRAM, "a(12345678901).", 9, 100) == SG_TEXT_DIGITS);
  CHECK("digits", fault("f(12345.7890).") == SG_TEXT_GOOD);
  CHECK("too many digits", fault("f(12345.67890).") == SG_TEXT_DIGITS);
  CHECK("name", fault("f(abcdefghijkl).") == SG_TEXT_GOOD);
  CHECK("too long a name", fault("f(abcdefghijklm).") == SG_TEXT_NAME);
  CHECK("too long a text", fault("f('abcdefghijklm').") == SG_TEXT_NAME);
  CHECK("too long a sign", fault("f(+++++++++++++).") == SG_TEXT_NAME);
  CHECK("too long a fact",
        fault("f([a,b,c,d,e,f,g,h,i,j,k,l,m,n,o,p,q,r,s,t,u,v,w,x,y,z,a,b,c"
              ",d,e,f]).") == SG_TEXT_FACT);
  CHECK("a comment is no fact",
        fault("/* 1234567890 1234567890 1234567890 1234567890 1234567890 "
              "1234567890 */ f(a).") == SG_TEXT_GOOD);
  fed(SG_TEXT_FACTS, "f(a).\n  \xed\x95\x9c(g(b)).", 2, 1);
  CHECK("place", last.line == 2 && last.column == 7);
  CHECK("a bad octet hides no bracket", facts("f(\xed(g(a))).") > 3);
  return check_report();
}
