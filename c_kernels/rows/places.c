#include "places.h"

#include "key_table.h"

#include <stdlib.h>
#include <string.h>

enum { WORDS = 6 /* three doubles */, ASK_EVERY = 1 << 15 };

uint32_t *
sg_places_of(const double (*at)[3], size_t n, const sg_cancel *cancel)
{
  uint32_t *place = malloc((n + 1) * sizeof *place);
  sg_key_table table;
  bool done = place != NULL;

  sg_key_table_init(&table, WORDS);
  for (size_t i = 0; i < n && done; i++) {
    double p[3] = {at[i][0] + 0.0, at[i][1] + 0.0, at[i][2] + 0.0};
    uint32_t key[WORDS], *first;

    memcpy(key, p, sizeof key);
    first = sg_key_table_put(&table, key);
    done = first && (i % ASK_EVERY != 0 || !sg_cancelled(cancel));
    if (done) {
      *first = *first == SG_NO_KEY ? (uint32_t)i : *first;
      place[i] = *first;
    }
  }
  sg_key_table_clear(&table);
  if (!done) {
    free(place);
    place = NULL;
  }
  return place;
}
