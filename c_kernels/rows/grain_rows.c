/* grain_rows.c -- how fine the source of a segment was: see grain_rows.h. */
#include "grain_rows.h"

#include "engine/column.h"

#include <math.h>
#include <string.h>

/* Grain of the term source(Grain); 0: it is another. */
static double
grain_in(const uint32_t *term)
{
  enum { SIZE, COMPOUND, SYMBOL, FLOAT, LOW, HIGH, WORDS };
  double grain = 0;

  if (sg_term_length(term) == WORDS &&
      term[COMPOUND] == (SG_TERM_COMPOUND | 1u << 4) &&
      term[SYMBOL] == SG_SYMBOL_SOURCE && (term[FLOAT] & 15) == SG_TERM_FLOAT) {
    uint64_t bits = (uint64_t)term[HIGH] << 32 | term[LOW];
    memcpy(&grain, &bits, sizeof grain);
  }
  return grain > 0 && isfinite(grain) ? grain : 0;
}

double
sg_grain_of(const sg_version *version, int32_t s)
{
  sg_term_builder b;

  sg_term_open(&b);
  sg_term_unary(&b, SG_SYMBOL_S, s); /* short: cannot fail */
  sg_value key[SG_MAX_COLUMNS] = {{.i = s}, {.term = sg_term_words(&b)}};
  sg_row row = sg_version_find(version, SG_ORIGIN, key);

  sg_term_close(&b);
  return row == SG_NO_ROW
             ? 0
             : grain_in(sg_version_value(version, SG_ORIGIN, row, 2).term);
}

bool
sg_grain_of_all(const sg_version *version, double *out)
{
  sg_view view;
  bool good = sg_version_view(version, SG_SEGMENT, &view);

  *out = 0;
  for (size_t i = 0; good && i < view.pages; i++) {
    for (unsigned r = sg_live_next(view.live[i], 0); r < SG_PAGE_ROWS;
         r = sg_live_next(view.live[i], r + 1)) {
      *out = fmax(*out, sg_grain_of(version, view.column[0].page[i].i[r]));
    }
  }
  sg_view_clear(&view);
  return good;
}
