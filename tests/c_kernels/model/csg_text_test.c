/* The words of .csg files, and where they end too soon (csg_text.h). */
#include "model/csg_text.h"
#include "tests/check.h"
#include <stdlib.h>
#include <string.h>

static const sg_text_limits most = {2, 3, 10, 12, 60, 60};
static sg_csg_text text;

/* The words of a text, each with a letter of its kind before it. The text ends
 * where its memory does. */
static const char *
words(const char *from)
{
  static char out[400];
  size_t n = strlen(from);
  char *copy = malloc(n ? n : 1);

  if (!copy) {
    return "";
  }
  memcpy(copy, from, n);
  out[0] = '\0';
  sg_csg_open(&text, copy, n, &most);
  while (sg_csg_next(&text) != SG_CSG_END && text.word < SG_CSG_OPEN_STRING) {
    size_t m = strlen(out);
    out[m] = " nis"[text.word];
    if (text.word == SG_CSG_SIGN) {
      out[m] = ' ';
    }
    memcpy(out + m + 1, text.begin, text.n);
    out[m + 1 + text.n] = '\0';
  }
  free(copy);
  return out;
}

static bool
are(const char *from, const char *expected)
{
  return strcmp(words(from), expected) == 0 && text.word == SG_CSG_END;
}

static bool
ends(const char *from, sg_csg_word word, uint64_t line, uint64_t column)
{
  words(from);
  return text.word == word && text.line == line && text.column == column;
}

static bool
breaks(const char *from, sg_text_fault fault)
{
  words(from);
  return text.word == SG_CSG_BEYOND && text.fault == fault;
}

static uint64_t state;

static size_t
below(size_t n)
{
  state = state * 6364136223846793005u + 1442695040888963407u;
  return (size_t)(state >> 33) % n;
}

/* A text of pieces, some octets of which are changed; to its memory's end. */
static char *
random_text(size_t *n)
{
  static const char *const piece[] = {"cube", "(",  "size=[1,2,3]", ");",
                                      "{",    "}",  "\"a\\\"",      "/*",
                                      "*/",   "//", "\n",           "-",
                                      "1.5e", "+3", "$fn",          "\xed\x95",
                                      "#",    "[[", "]]]",          ".",
                                      "\"",   "\\", "\xef\xbb\xbf", " "};
  char all[400] = "";

  *n = 0;
  for (size_t k = below(40); k > 0; k--) {
    const char *one = piece[below(sizeof piece / sizeof *piece)];
    memcpy(all + *n, one, strlen(one));
    *n += strlen(one);
  }
  for (size_t k = below(3); *n > 0 && k > 0; k--) {
    all[below(*n)] = (char)below(256);
  }
  char *exact = malloc(*n ? *n : 1);
  if (exact) {
    memcpy(exact, all, *n);
  }
  return exact;
}

/* Whatever is in a text, its words lie in it one behind the other, their places
 * go on, and what ends it stays. */
static bool
reads(uint64_t seed)
{
  static const sg_text_limits wide = {9, 9, 99, 99, 999, 999};
  size_t n;

  state = seed;
  char *from = random_text(&n);
  const char *last = from;
  sg_csg_open(&text, from, n, seed % 2 ? &most : &wide);
  bool good = from != NULL;
  uint64_t line = 1, column = 0;
  for (size_t k = 0; good && k <= n; k++) {
    sg_csg_word word = sg_csg_next(&text);
    if (word == SG_CSG_END || word >= SG_CSG_OPEN_STRING) {
      good = sg_csg_next(&text) == word;
      break;
    }
    good = k < n && text.begin >= last && text.begin + text.n <= from + n &&
           (text.line > line || (text.line == line && text.column > column));
    last = text.begin + text.n;
    line = text.line;
    column = text.column;
  }
  free(from);
  return good;
}

int
main(void)
{
  unsigned bad = 0;

  for (uint64_t seed = 1; seed <= 30000; seed++) {
    bad += !reads(seed);
  }
  CHECK("random texts", bad == 0);
  CHECK("nothing", are("", "") && are(" \t\r\n// a", "") && are("/**/", ""));
  CHECK("names", are("$fn a_1 B", "n$fnna_1nB"));
  CHECK("numbers", are("1 -2 .5 -.5 1.5e-3 2E5", "i1i-2i.5i-.5i1.5e-3i2E5"));
  CHECK("no numbers", words("1.")[0] == 'i' && text.word == SG_CSG_STRANGE);
  CHECK("half an exponent",
        are("1e 2e;", "i1nei2ne ;") && !are("2e+", "") && text.column == 3);
  CHECK("an exponent of letters", are("1ex", "i1nex"));
  CHECK("a minus alone", are("- inf -", " -ninf -"));
  CHECK("signs", are("()[]{},;=*%#!", " ( ) [ ] { } , ; = * % # !"));
  CHECK("strings", are("\"a b\"\"\"", "sa bs") && are("\"\\\"\"", "s\\\""));
  CHECK("comments are white", are("a/*b\n//*/c//d\ne", "nancne"));
  CHECK("no end of a string", ends("a\n  \"b", SG_CSG_OPEN_STRING, 2, 3));
  CHECK("nor behind a backslash", ends("\"b\\", SG_CSG_OPEN_STRING, 1, 1));
  CHECK("no end of a comment", ends("a\n /*/", SG_CSG_OPEN_COMMENT, 2, 2));
  CHECK("strange", ends("\"\xed\x95\x9c\" \xed\x95\x9c", SG_CSG_STRANGE, 1, 5));
  CHECK("a slash alone", ends("a / b", SG_CSG_STRANGE, 1, 3));
  sg_csg_open(&text, "a\0b", 3, &most);
  CHECK("nul", sg_csg_next(&text) == SG_CSG_NAME &&
                   sg_csg_next(&text) == SG_CSG_STRANGE);
  CHECK("the mark of UTF-8", are("\xef\xbb\xbf"
                                 "a",
                                 "na") &&
                                 text.column == 2);
  CHECK("blocks", are("{{{}}}{{{}}}", " { { { } } } { { { } } }"));
  CHECK("too many blocks", breaks("{{{{", SG_TEXT_BLOCKS));
  CHECK("no block closes twice", breaks("}}}}{{{{", SG_TEXT_BLOCKS));
  CHECK("blocks in text", are("\"{{{{{\"//{{{{{\n/*{{{{{*/", "s{{{{{"));
  CHECK("brackets", are("([])", " ( [ ] )"));
  CHECK("too many brackets", breaks("[[[", SG_TEXT_DEPTH));
  CHECK("digits", are("123456.890", "i123456.890"));
  CHECK("too many digits", breaks("123456.8901", SG_TEXT_DIGITS));
  CHECK("name", are("abcdefghijkl", "nabcdefghijkl"));
  CHECK("too long a name", breaks("abcdefghijklm", SG_TEXT_NAME));
  CHECK("too long a text", breaks("\"abcdefghijklm\"", SG_TEXT_NAME));
  return check_report();
}
