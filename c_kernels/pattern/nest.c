/* nest.c -- see nest.h */
#include "nest.h"
#include "engine/list.h"
#include "nest_mask.h"

#include <math.h>
#include <stdlib.h>

enum { MOST_SQUARES_A_SIDE = 32000, MOST_SQUARES = 1 << 27 };

/* A page that refused so many pieces of one kind is not asked for that kind
 * again, so a piece of many takes no longer than one of few. With twice as many
 * refusals sheets are used about as well, and it takes nearly twice as long. */
enum { PATIENCE = 8, KINDS = 64 * 64 };

/* So many bytes of masks are kept. */
enum { MASKS = 1 << 26 };

/* A sheet, with a border of `gap` squares all round. */
typedef struct page {
  uint16_t *next;   /* [h][w + 1]: the first taken square from here on, or w */
  uint16_t *open;   /* [h]: the longest free run of each row */
  size_t left;      /* squares that are not taken */
  uint8_t *refused; /* [KINDS]: so many pieces of each, up to PATIENCE */
} page;

typedef struct nesting {
  const sg_nest_paper *paper;
  unsigned w, h; /* of a page */
  page *page;
  size_t pages, room;
  size_t first[KINDS]; /* pages before this one refuse all of the kind */
  uint64_t work;
  sg_nest_masks *masks;
  const sg_cancel *cancel;
  bool *memory;
} nesting;

static unsigned
squares(double length, double square)
{
  return (unsigned)floor(length / square + 1e-9);
}

bool
sg_nest_paper_is_valid(const sg_nest_paper *paper)
{
  double w = paper->width / paper->square + 2.0 * paper->gap;
  double h = paper->height / paper->square + 2.0 * paper->gap;

  return paper->square > 0.0 && w >= 1.0 && h >= 1.0 &&
         w <= MOST_SQUARES_A_SIDE && h <= MOST_SQUARES_A_SIDE &&
         w * h <= MOST_SQUARES;
}

/* ---- a page ---- */

static bool
add_page(nesting *n)
{
  size_t wide = (size_t)n->w + 1;

  if (!sg_list_grow(&n->page, n->pages, &n->room, sizeof *n->page)) {
    return false;
  }
  page *p = &n->page[n->pages];

  n->work += wide * n->h;
  p->next = malloc(wide * n->h * sizeof *p->next);
  p->open = malloc(n->h * sizeof *p->open);
  p->refused = calloc(KINDS, 1);
  p->left = (size_t)n->w * n->h;
  n->pages++;
  if (!p->next || !p->open || !p->refused) {
    return false;
  }
  for (unsigned y = 0; y < n->h; y++) {
    p->open[y] = (uint16_t)n->w;
  }
  for (size_t i = 0; i < wide * n->h; i++) {
    p->next[i] = (uint16_t)n->w;
  }
  return true;
}

/* How far right the runs have to go, at least, to be free in column x, row y:
 * 0, if they are. The sg_nest_run *first, which was in the way before, is asked
 * first, and becomes the one that is now. */
static unsigned
hindrance(nesting *n, const page *p, const sg_nest_runs *r, unsigned x,
          unsigned y, size_t *first)
{
  size_t wide = (size_t)n->w + 1, i = *first;

  for (size_t left = r->n; left > 0; left--) {
    const sg_nest_run *one = &r->at[i];
    unsigned taken = p->next[(y + one->row) * wide + x + one->from];

    n->work++;
    if (taken <= x + one->to && taken < n->w) {
      *first = i;
      return taken - one->from + 1 - x;
    }
    i = i + 1 < r->n ? i + 1 : 0;
  }
  return 0;
}

/* The lowest, then leftmost, place where the runs are free and reach up less
 * than `top` rows. False also when stopped: *n->memory is true then. */
static bool
find_place(nesting *n, const page *p, const sg_nest_mask *m, unsigned top,
           unsigned *x_out, unsigned *y_out)
{
  const sg_nest_runs *r = &m->needed;
  size_t first = 0;

  for (unsigned y = 0; y + m->h <= n->h && y + m->h < top; y++) {
    if (sg_cancelled(n->cancel)) {
      *n->memory = true;
      return false;
    }
    if (p->open[y + r->row] < r->widest) {
      continue;
    }
    for (unsigned x = 0; x + m->w <= n->w;) {
      unsigned step = hindrance(n, p, r, x, y, &first);

      if (step == 0) {
        *x_out = x;
        *y_out = y;
        return true;
      }
      x += step;
    }
  }
  return false;
}

static void
measure_open(const nesting *n, page *p, unsigned y)
{
  const uint16_t *next = p->next + (size_t)y * (n->w + 1u);
  unsigned longest = 0;

  for (unsigned x = 0; x < n->w; x = next[x] + 1u) {
    unsigned free_run = next[x] - x;

    longest = free_run > longest ? free_run : longest;
  }
  p->open[y] = (uint16_t)longest;
}

static void
take_squares(nesting *n, page *p, const sg_nest_runs *r, unsigned x, unsigned y)
{
  size_t wide = (size_t)n->w + 1;

  for (size_t i = 0; i < r->n; i++) {
    uint16_t *next = p->next + (size_t)(y + r->at[i].row) * wide;
    unsigned from = x + r->at[i].from, to = x + r->at[i].to;

    for (unsigned k = from; k <= to; k++) {
      p->left -= next[k] != k;
      next[k] = (uint16_t)k;
    }
    for (unsigned k = from; k > 0 && next[k - 1] > from; k--) {
      next[k - 1] = (uint16_t)from;
    }
  }
  for (size_t i = 0; i < r->n; i++) {
    if (i == 0 || r->at[i].row != r->at[i - 1].row) {
      measure_open(n, p, y + r->at[i].row);
    }
  }
}

/* ---- pieces one by one ---- */

/* Where a piece goes on a page: at which angle, and how high it reaches. */
typedef struct choice {
  size_t angle;
  unsigned x, y, top;
} choice;

/* The highest bit of a number that is not 0, and `more` of those below it. */
static unsigned
magnitude(size_t number, unsigned more)
{
  unsigned bit = 0;

  while (number >> bit > 1) {
    bit++;
  }
  return (bit << more) +
         (unsigned)((number << more >> bit) & ((1u << more) - 1));
}

/* Pieces of one kind are about as long, and about as large: to a fifth of
 * their length, and two fifths of their area. Less than KINDS. */
static size_t
kind_of(const sg_nest_mask *const *m, size_t angles)
{
  while (angles > 1 && !*m) {
    m++;
    angles--;
  }
  return 64 * magnitude((*m)->w > (*m)->h ? (*m)->w : (*m)->h, 2) +
         magnitude((*m)->squares, 1);
}

static bool
has_refused(const nesting *n, size_t at, size_t kind)
{
  return !n->paper->one && n->page[at].refused[kind] >= PATIENCE;
}

static void
note_refusal(nesting *n, size_t at, size_t kind)
{
  uint8_t *refused = &n->page[at].refused[kind];

  *refused = (uint8_t)(*refused + (*refused < PATIENCE));
  while (n->first[kind] < n->pages && has_refused(n, n->first[kind], kind)) {
    n->first[kind]++;
  }
}

static bool
best_choice(nesting *n, const page *p, const sg_nest_mask *const *m,
            size_t angles, choice *best)
{
  unsigned x, y;

  best->top = UINT32_MAX;
  for (size_t i = 0; i < angles; i++) {
    if (m[i] && m[i]->squares <= p->left &&
        find_place(n, p, m[i], best->top, &x, &y)) {
      *best = (choice){i, x, y, y + m[i]->h};
    }
  }
  return best->top < UINT32_MAX;
}

static void
settle(nesting *n, page *p, const sg_nest_piece *piece,
       const sg_nest_mask *const *m, const choice *best, sg_nest_place *place)
{
  const sg_nest_mask *at = m[best->angle];
  double square = n->paper->square;

  take_squares(n, p, &at->covered, best->x, best->y);
  place->sheet = (uint32_t)(p - n->page) + 1;
  place->degrees = piece->degrees[best->angle];
  place->by[0] = best->x * square - at->low[0];
  place->by[1] = best->y * square - at->low[1];
}

static bool
place_masks(nesting *n, const sg_nest_piece *piece, const sg_nest_mask **m,
            sg_nest_place *place)
{
  bool fits = false;
  choice best;

  for (size_t i = 0; i < piece->angles; i++) {
    if (!sg_nest_masks_at(n->masks, n->paper, n->w, n->h, piece,
                          piece->degrees[i], &m[i])) {
      return false;
    }
    n->work += m[i] ? (uint64_t)m[i]->w * m[i]->h : 0;
    fits = fits || m[i];
  }
  size_t kind = fits ? kind_of(m, piece->angles) : 0;

  for (size_t i = n->first[kind]; fits; i++) {
    if (sg_cancelled(n->cancel)) {
      *n->memory = true;
      return false;
    }
    if (i == n->pages && ((n->paper->one && i > 0) || !add_page(n))) {
      return n->paper->one && i > 0;
    }
    if (has_refused(n, i, kind)) {
      continue;
    }
    bool found = best_choice(n, &n->page[i], m, piece->angles, &best);
    if (*n->memory) {
      return false;
    }
    if (found) {
      settle(n, &n->page[i], piece, m, &best, place);
      return true;
    }
    note_refusal(n, i, kind);
  }
  return true;
}

/* `kept`: masks are, as long as they are not too many. */
static bool
place_piece(nesting *n, const sg_nest_piece *piece, bool kept,
            sg_nest_place *place)
{
  const sg_nest_mask **m = calloc(piece->angles + 1, sizeof *m);
  bool ok = m != NULL;

  *place = (sg_nest_place){0, 0.0, {0.0, 0.0}};
  ok = ok && place_masks(n, piece, m, place);
  free(m);
  sg_nest_masks_clear(n->masks, kept ? MASKS : 0);
  return ok;
}

static bool
place_pieces(nesting *n, const sg_nest_piece *piece, size_t count,
             sg_nest_masks *masks, sg_nest_place *place)
{
  n->masks = masks ? masks : sg_nest_masks_open(1);
  bool ok = n->masks != NULL;

  for (size_t i = 0; i < count && ok; i++) {
    sg_nest_piece one = piece[i];

    one.number = masks ? one.number : 0;
    ok = place_piece(n, &one, masks != NULL, &place[i]);
  }
  if (!masks) {
    sg_nest_masks_close(n->masks);
  }
  return ok;
}

bool
sg_nest(const sg_nest_paper *paper, const sg_nest_piece *piece, size_t n,
        sg_nest_masks *masks, sg_nest_place *place, uint64_t *work,
        const sg_cancel *cancel, bool *memory)
{
  nesting all = {.paper = paper, .cancel = cancel, .memory = memory};

  *memory = false;
  all.w = squares(paper->width, paper->square) + 2 * paper->gap;
  all.h = squares(paper->height, paper->square) + 2 * paper->gap;
  bool ok = place_pieces(&all, piece, n, masks, place);

  for (size_t i = 0; i < all.pages; i++) {
    free(all.page[i].next);
    free(all.page[i].open);
    free(all.page[i].refused);
  }
  free(all.page);
  if (work) {
    *work += all.work;
  }
  *memory = ok || *memory;
  return ok;
}
