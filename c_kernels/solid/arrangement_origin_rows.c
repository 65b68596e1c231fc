/* arrangement_origin_rows.c -- what made the vertices of pieces, kept with
 * them: see arrangement_rows.h. Every selection needs them, so they are made
 * when the pieces are.
 */
#include "arrangement_rows.h"
#include "engine/list.h"

#include <stdlib.h>
#include <string.h>

/* Terms one after another. */
typedef struct terms {
  uint32_t *word;
  size_t n, room;
} terms;

static bool
add_term(terms *all, const uint32_t *term)
{
  size_t n = term ? sg_term_length(term) : 0;

  if (!sg_list_need(&all->word, all->n + n, &all->room, sizeof *all->word)) {
    return false;
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

bool
sg_arrangement_make_origins(sg_call *call, sg_arrangement_handle *h)
{
  size_t points = h->set->set.points.n;
  terms all = {0};

  h->origin_at = malloc((points + 1) * sizeof *h->origin_at);
  if (!h->origin_at) {
    return sg_call_no_memory(call);
  }
  memset(h->origin_at, 0xff, points * sizeof *h->origin_at);
  for (size_t leaf = 0; leaf < h->n; leaf++) {
    size_t n;
    const sg_made_vertex *made = sg_arrangement_made(h->arrangement, leaf, &n);

    for (size_t i = 0; i < n; i++) {
      if (!add_origin(h, &all, made[i].point)) {
        free(all.word);
        return sg_call_no_memory(call);
      }
    }
  }
  sg_list_trim(&all.word, all.n, &all.room, sizeof *all.word); /* kept long */
  h->origin = all.word;
  return true;
}

/* What made a vertex. */
static const uint32_t *
words_of(const sg_pieces *p, const sg_made_by *by)
{
  const sg_arrangement_handle *from = p->from[by->chosen];

  return from->origin + from->origin_at[by->point];
}

bool
sg_arrangement_give_origins(sg_call *call, const sg_pieces *p, sg_solid *solid,
                            const sg_made_by *made_by)
{
  size_t made = solid->vertices - solid->plain, n = 0;

  for (size_t i = 0; i < made; i++) {
    n += sg_term_length(words_of(p, &made_by[i]));
  }
  solid->origin = malloc((made + 1) * sizeof *solid->origin);
  solid->origin_words = malloc((n + 1) * sizeof *solid->origin_words);
  if (!solid->origin || !solid->origin_words) {
    return sg_call_no_memory(call);
  }
  uint32_t *to = solid->origin_words;

  for (size_t i = 0; i < made; i++) {
    const uint32_t *words = words_of(p, &made_by[i]);
    size_t length = sg_term_length(words);

    if (sg_cancel_every(&call->cancel, i)) {
      return false;
    }
    memcpy(to, words, length * sizeof *to);
    solid->origin[i] = to;
    to += length;
  }
  return true;
}
