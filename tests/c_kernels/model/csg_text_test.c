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

int
main(void)
{
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
