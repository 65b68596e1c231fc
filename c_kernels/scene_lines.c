/* scene_lines.c -- one line for the directed edges between two vertices, and
 * how its faces lie to the eye (scene.h).
 */
#include "bounds.h"
#include "scene_private.h"

#include <math.h>
#include <stdlib.h>

/* Of more faces at an edge not all pairs are compared. */
enum { MOST_FACES = 64 };

static double
dot(const double a[3], const double b[3])
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/* -------------------------------------------------------------- lines */

static int
pair_compare(const void *a, const void *b)
{
  const sg_scene_pair *x = a, *y = b;

  if (x->low != y->low) {
    return x->low < y->low ? -1 : 1;
  }
  if (x->high != y->high) {
    return x->high < y->high ? -1 : 1;
  }
  return (x->edge > y->edge) - (x->edge < y->edge);
}

/* The pairs of all edges; false: no memory. */
static bool
make_pairs(sg_scene_builder *b)
{
  const sg_scene_input *in = b->in;

  b->pair = malloc((in->edges + 1) * sizeof *b->pair);
  b->line_of = malloc((in->edges + 1) * sizeof *b->line_of);
  if (!b->pair || !b->line_of) {
    return false;
  }
  for (size_t i = 0; i < in->edges && !sg_scene_stop(b, i); i++) {
    const sg_scene_edge *e = &in->edge[i];
    size_t x = sg_keys_find(&b->vertices, e->s, e->v1);
    size_t y = sg_keys_find(&b->vertices, e->s, e->v2);
    b->line_of[i] = UINT32_MAX;
    if (x != SG_NOWHERE && y != SG_NOWHERE && x != y) {
      b->pair[b->pairs++] = (sg_scene_pair){
          (uint32_t)(x < y ? x : y), (uint32_t)(x < y ? y : x), (uint32_t)i};
    }
  }
  return sg_scene_sort(b, b->pair, b->pairs, sizeof *b->pair, pair_compare);
}

static bool
same_ends(const sg_scene_pair *a, const sg_scene_pair *b)
{
  return a->low == b->low && a->high == b->high;
}

/* The first pair with these ends, or SG_NOWHERE. */
static size_t
find_pair(sg_scene_builder *b, int32_t s, int32_t v1, int32_t v2)
{
  size_t x = sg_keys_find(&b->vertices, s, v1);
  size_t y = sg_keys_find(&b->vertices, s, v2);
  size_t low = 0, high = b->pairs;
  sg_scene_pair want = {(uint32_t)(x < y ? x : y), (uint32_t)(x < y ? y : x),
                        0};

  if (x == SG_NOWHERE || y == SG_NOWHERE) {
    return SG_NOWHERE;
  }
  while (low < high) {
    size_t middle = low + (high - low) / 2;
    if (pair_compare(&b->pair[middle], &want) < 0) {
      low = middle + 1;
    } else {
      high = middle;
    }
  }
  return low < b->pairs && same_ends(&b->pair[low], &want) ? low : SG_NOWHERE;
}

/* What the cuts say of each group of pairs, kept at its first pair. */
enum { CUT = 1, COPY = 2 };

static bool
is_real(const sg_scene_builder *b, size_t i)
{
  const sg_scene_pair *first = &b->pair[i];

  for (; i < b->pairs && same_ends(&b->pair[i], first); i++) {
    if (b->in->edge[b->pair[i].edge].real) {
      return true;
    }
  }
  return false;
}

static void
mark_cuts(sg_scene_builder *b, uint8_t *mark)
{
  for (size_t i = 0; i < b->in->cuts && !sg_scene_stop(b, i); i++) {
    const sg_scene_cut *c = &b->in->cut[i];
    size_t own = find_pair(b, c->s, c->a, c->b);
    size_t other = c->s2 ? find_pair(b, c->s2, c->a2, c->b2) : SG_NOWHERE;
    if (own != SG_NOWHERE) {
      mark[own] |= CUT;
      if (other != SG_NOWHERE && other != own && is_real(b, other)) {
        mark[own] |= COPY;
      }
    }
  }
}

/* One line for a group of pairs, by its first real edge; *next: its end. */
static bool
group_line(const sg_scene_builder *b, size_t first, sg_scene_line *out,
           size_t *next)
{
  const sg_scene_pair *group = &b->pair[first];
  bool real = false;
  size_t i = first;

  for (; i < b->pairs && same_ends(&b->pair[i], group); i++) {
    const sg_scene_edge *e = &b->in->edge[b->pair[i].edge];
    if (e->real && !real) {
      bool up = b->in->vertex[group->low].v == e->v1;
      real = true;
      *out = (sg_scene_line){.s = e->s,
                             .e = e->e,
                             .a = up ? group->low : group->high,
                             .b = up ? group->high : group->low};
    }
  }
  *next = i;
  return real;
}

/* line_of for the edges of each line: its pairs are found by its ends. */
static void
number_lines(sg_scene_builder *b)
{
  const sg_scene *scene = b->scene;
  const sg_scene_vertex *vertex = b->in->vertex;

  for (size_t k = 0; k < scene->lines && !sg_scene_stop(b, k); k++) {
    const sg_scene_line *line = &scene->line[k];
    size_t i = find_pair(b, line->s, vertex[line->a].v, vertex[line->b].v);
    for (size_t j = i; j < b->pairs && same_ends(&b->pair[j], &b->pair[i]);
         j++) {
      b->line_of[b->pair[j].edge] = (uint32_t)k;
    }
  }
}

bool
sg_scene_make_lines(sg_scene_builder *b)
{
  sg_scene *scene = b->scene;
  size_t next;
  uint8_t *mark;

  if (!make_pairs(b) || !(mark = calloc(b->pairs + 1, 1))) {
    return false;
  }
  mark_cuts(b, mark);
  scene->line = malloc((b->pairs + 1) * sizeof *scene->line);
  for (size_t i = 0; scene->line && i < b->pairs; i = next) {
    sg_scene_line *line = &scene->line[scene->lines];
    if (group_line(b, i, line, &next) && !(mark[i] & COPY)) {
      line->look.cut = mark[i] & CUT;
      scene->lines++;
    }
  }
  free(mark);
  if (!scene->line) {
    return false;
  }
  if (!sg_scene_sort(b, scene->line, scene->lines, sizeof *scene->line,
                     sg_key_compare)) {
    return false;
  }
  number_lines(b);
  return true;
}

/* -------------------------------------------------------------- looks */

/* The line whose edge this use is, or UINT32_MAX. */
static uint32_t
line_of_use(sg_scene_builder *b, const sg_scene_use *use)
{
  size_t edge = sg_keys_find(&b->edges, use->s, use->e);

  return edge == SG_NOWHERE ? UINT32_MAX : b->line_of[edge];
}

/* The uses, sorted by line (counting sort). */
static bool
sort_uses(sg_scene_builder *b)
{
  const sg_scene_input *in = b->in;
  size_t lines = b->scene->lines;

  b->use_at = calloc(lines + 2, sizeof *b->use_at);
  b->user = malloc((in->uses + 1) * sizeof *b->user);
  if (!b->use_at || !b->user) {
    return false;
  }
  for (size_t i = 0; i < in->uses && !sg_scene_stop(b, i); i++) {
    uint32_t line = line_of_use(b, &in->use[i]);
    if (line != UINT32_MAX) {
      b->use_at[line + 2]++;
    }
  }
  for (size_t i = 2; i < lines + 2; i++) {
    b->use_at[i] += b->use_at[i - 1];
  }
  for (size_t i = 0; i < in->uses && !sg_scene_stop(b, i); i++) {
    uint32_t line = line_of_use(b, &in->use[i]);
    if (line != UINT32_MAX) {
      b->user[b->use_at[line + 1]++] = (uint32_t)i;
    }
  }
  return true;
}

/* The face of a use, and whether it runs along the line or against it. */
static const sg_scene_face *
face_of_use(sg_scene_builder *b, const sg_scene_line *line, uint32_t user,
            int *along)
{
  const sg_scene_use *use = &b->in->use[user];
  size_t edge = sg_keys_find(&b->edges, use->s, use->e);
  size_t place = sg_keys_find(&b->faces, use->s, use->p);

  *along = b->in->edge[edge].v1 == b->in->vertex[line->a].v ? 1 : -1;
  return place == SG_NOWHERE ? NULL : &b->face[place];
}

/* Degrees between two faces that use a line in directions i and j: 0 when
 * they lie flat side by side. */
static double
bend_between(const double m[3], int i, const double n[3], int j)
{
  double c[3] = {m[1] * n[2] - m[2] * n[1], m[2] * n[0] - m[0] * n[2],
                 m[0] * n[1] - m[1] * n[0]};

  return atan2(sqrt(dot(c, c)), -dot(m, n) * i * j) * (180.0 / acos(-1.0)) +
         0.0;
}

static void
look_at_face(sg_look *look, const sg_scene_face *f, int along)
{
  int side = f->facing * along;

  look->towards += f->facing > 0;
  look->away += f->facing < 0;
  look->left += side > 0;
  look->right += side < 0;
}

static void
look_at(sg_scene_builder *b, size_t k)
{
  sg_scene_line *line = &b->scene->line[k];
  sg_look *look = &line->look;
  int i, j;

  for (uint32_t u = b->use_at[k]; u < b->use_at[k + 1]; u++) {
    const sg_scene_face *f = face_of_use(b, line, b->user[u], &i);
    look->faces++;
    if (!f) {
      continue;
    }
    look_at_face(look, f, i);
    for (uint32_t w = b->use_at[k]; w < u && w < b->use_at[k] + MOST_FACES;
         w++) {
      const sg_scene_face *g = face_of_use(b, line, b->user[w], &j);
      if (g) {
        look->bend =
            sg_larger(look->bend, bend_between(f->model, i, g->model, j));
      }
    }
  }
}

bool
sg_scene_make_looks(sg_scene_builder *b)
{
  if (!sort_uses(b)) {
    return false;
  }
  for (size_t k = 0; k < b->scene->lines && !sg_scene_stop(b, k); k++) {
    look_at(b, k);
  }
  return true;
}
