/* symbol_test.c -- texts and symbols, each the other's, also of very many, and
 * where there is no memory.
 */
#include "engine/symbol.h"

#include "tests/check.h"
#include "tests/memory/refuse.h"

#include <stdio.h>
#include <string.h>

enum { MANY = 70000 };

static const struct {
  int32_t symbol;
  const char *text;
} known[] = {
#define KNOWN(ID, text) {SG_SYMBOL_##ID, text},
    SG_SYMBOLS(KNOWN)
#undef KNOWN
};

static bool
is_text(int32_t symbol, const char *text, size_t length)
{
  size_t n = length + 1;
  const char *at = sg_symbol_text(symbol, &n);

  return n == length && memcmp(at, text, length) == 0 && at[length] == '\0' &&
         sg_symbol_text(symbol, NULL) == at;
}

/* Those that C code writes. */
static bool
are_known(void)
{
  bool good = true;

  for (size_t i = 0; i < sizeof known / sizeof *known; i++) {
    const char *text = known[i].text;
    size_t n = strlen(text);

    good = good && known[i].symbol == (int32_t)i &&
           sg_symbol_find(text, n) == known[i].symbol &&
           sg_symbol_intern(text, n) == known[i].symbol &&
           is_text(known[i].symbol, text, n);
  }
  return good;
}

static size_t
name(int i, char *out)
{
  return (size_t)sprintf(out, "%s%d", i % 2 ? "a" : "", i);
}

/* A name, while there may be no memory. */
static bool
is_made(const char *text)
{
  int32_t symbol = sg_symbol_intern(text, strlen(text));

  return symbol == sg_symbol_find(text, strlen(text));
}

static void
many(void)
{
  static int32_t symbol[MANY];
  char text[32];
  size_t bad = 0;

  for (int i = 0; i < MANY; i++) {
    size_t n = name(i, text);

    bad += sg_symbol_find(text, n) != -1;
    symbol[i] = sg_symbol_intern(text, n);
    bad += symbol[i] != SG_KNOWN_SYMBOLS + i;
  }
  for (int i = 0; i < MANY; i++) {
    size_t n = name(i, text);

    bad += sg_symbol_find(text, n) != symbol[i] ||
           sg_symbol_intern(text, n) != symbol[i] ||
           !is_text(symbol[i], text, n);
  }
  CHECK("each has its own, from the first free one on", bad == 0);
  CHECK("known ones stay", are_known());
}

int
main(void)
{
  char text[32];

  CHECK("known ones are there at first", are_known());
  many();
  CHECK("a part is another text",
        sg_symbol_find("solid", 4) == -1 && sg_symbol_find("solids", 6) == -1);
  int32_t part = sg_symbol_intern("solid", 4);
  CHECK("of which there is one",
        sg_symbol_find("soli", 4) == part && is_text(part, "soli", 4));
  int32_t nothing = sg_symbol_intern("", 0);
  CHECK("nothing is a text", nothing >= 0 && is_text(nothing, "", 0) &&
                                 sg_symbol_find("x", 0) == nothing);
  int32_t zero = sg_symbol_intern("a\0b", 3);
  CHECK("so is what has a zero", is_text(zero, "a\0b", 3) &&
                                     sg_symbol_intern("a\0c", 3) != zero &&
                                     sg_symbol_find("a\0b", 3) == zero);
  for (int i = 0; i < MANY; i++) { /* the table has to grow somewhere */
    sprintf(text, "more%d", i);
    refuse_after(i % 3);
    bool made = is_made(text), refused = refuse_no_more();
    if (!made || (!refused && sg_symbol_find(text, strlen(text)) < 0)) {
      CHECK("made, or not", false);
    }
    if (!is_made(text) || sg_symbol_find(text, strlen(text)) < 0) {
      CHECK("made later", false);
    }
  }
  CHECK("known ones stay without memory", are_known());
  return check_report();
}
