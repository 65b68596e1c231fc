/* arrangement_origin4pl.c -- what made the vertices of pieces, kept with them:
 * see arrangement4pl.h.
 *
 * Layer: glue; no predicates of its own. Every selection needs them, so they
 * are made when the pieces are.
 */
#include "arrangement4pl.h"

#include "glue.h"

#include <stdlib.h>
#include <string.h>

enum { ASKED = 1 << 10 }; /* origins between questions */

/* Terms one after another. */
typedef struct terms {
  uint32_t *word;
  size_t n, room;
} terms;

static bool
add_term(terms *all, const uint32_t *term)
{
  size_t n = term ? sg_term_length(term) : 0;

  if (all->n + n > all->room) {
    size_t room = 2 * all->room + n + 1024;
    uint32_t *more = realloc(all->word, room * sizeof *more);

    if (!more) {
      return false;
    }
    all->word = more;
    all->room = room;
  }
  if (n > 0) {
    memcpy(all->word + all->n, term, n * sizeof *term);
  }
  all->n += n;
  return n > 0;
}

/* The origin of a point, once. */
static bool
add_origin(sg_arrangement_handle *h, terms *all, uint32_t point)
{
  sg_term_builder b;

  if (point == SG_NO_KEY || h->origin_at[point] != SG_NO_KEY) {
    return true;
  }
  sg_term_open(&b);
  sg_cut_build_origin(&b, &h->set->set.points, point);
  h->origin_at[point] = (uint32_t)all->n;
  bool good = add_term(all, sg_term_words(&b));

  sg_term_close(&b);
  return good;
}

int
sg_make_origins_ex(sg_arrangement_handle *h)
{
  size_t points = h->set->set.points.n;
  terms all = {0};

  h->origin_at = malloc((points + 1) * sizeof *h->origin_at);
  if (!h->origin_at) {
    return sg_no_memory();
  }
  memset(h->origin_at, 0xff, points * sizeof *h->origin_at);
  for (size_t leaf = 0; leaf < h->n; leaf++) {
    size_t n;
    const sg_made_vertex *made = sg_arrangement_made(h->arrangement, leaf, &n);

    for (size_t i = 0; i < n; i++) {
      if (!add_origin(h, &all, made[i].point)) {
        free(all.word);
        return sg_no_memory();
      }
    }
  }
  h->origin = all.word;
  return TRUE;
}

int
sg_give_origins_ex(const sg_pieces *p, sg_solid *solid,
                   const sg_made_by *made_by)
{
  size_t made = solid->vertices - solid->plain;

  solid->origin = calloc(made + 1, sizeof *solid->origin);
  if (!solid->origin) {
    return sg_no_memory();
  }
  for (size_t i = 0; i < made; i++) {
    const sg_arrangement_handle *from = p->from[made_by[i].chosen];
    const uint32_t *words = from->origin + from->origin_at[made_by[i].point];
    size_t size = sg_term_length(words) * sizeof *words;

    if (i % ASKED == ASKED - 1 && PL_handle_signals() < 0) {
      return FALSE;
    }
    solid->origin[i] = malloc(size);
    if (!solid->origin[i]) {
      return sg_no_memory();
    }
    memcpy(solid->origin[i], words, size);
  }
  return TRUE;
}
