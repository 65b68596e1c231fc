/* scene_read4pl.c -- see scene4pl.h */
#include "scene4pl.h"

#include "keys.h"
#include "sort.h"

#include "../engine/symbol.h"

#include <stdlib.h>

bool
sg_is_chosen(const sg_chosen *chosen, int32_t s)
{
  size_t low = 0, high = chosen->n;

  if (chosen->all) {
    return true;
  }
  while (low < high) {
    size_t middle = low + (high - low) / 2;
    if (chosen->s[middle] < s) {
      low = middle + 1;
    } else {
      high = middle;
    }
  }
  return low < chosen->n && chosen->s[low] == s;
}

/* One live row of a view. */
typedef struct row {
  const sg_view *view;
  size_t page;
  unsigned at;
} row;

static int32_t
integer(const row *r, unsigned column)
{
  return r->view->column[column].page[r->page].i[r->at];
}

static double
number(const row *r, unsigned column)
{
  return r->view->column[column].page[r->page].f[r->at];
}

static const int32_t *
list(const row *r, unsigned column)
{
  return r->view->column[column].page[r->page].list[r->at];
}

/* Where the rows of each relation go. */
typedef struct reading {
  sg_scene_input *in;
  const sg_chosen *chosen;
  const sg_poll *poll;
  sg_keys vertices;
  bool memory;
} reading;

typedef void read_row(reading *reader, const row *r);

/* False: stopped, or no memory (then reader->memory is false). */
static bool
each_row(reading *reader, const sg_version *version, sg_relation relation,
         read_row *read)
{
  sg_view view;
  bool stopped = false;

  reader->memory = sg_version_view(version, relation, &view);
  if (!reader->memory) {
    return false;
  }
  for (size_t page = 0; page < view.pages && !stopped; page++) {
    for (unsigned i = sg_live_next(view.live[page], 0); i < SG_PAGE_ROWS;
         i = sg_live_next(view.live[page], i + 1)) {
      row r = {&view, page, i};
      read(reader, &r);
    }
    stopped = sg_poll_stop(reader->poll);
  }
  sg_view_clear(&view);
  return !stopped;
}

static void
read_segment(reading *reader, const row *r)
{
  if (sg_is_chosen(reader->chosen, integer(r, 0))) {
    reader->in->segment[reader->in->segments++] = (sg_scene_segment){
        .s = integer(r, 0), .solid = integer(r, 1) == SG_SYMBOL_SOLID};
  }
}

static void
read_screen(reading *reader, const row *r)
{
  if (sg_is_chosen(reader->chosen, integer(r, 0))) {
    reader->in->vertex[reader->in->vertices++] =
        (sg_scene_vertex){.s = integer(r, 0),
                          .v = integer(r, 1),
                          .screen = {number(r, 2), number(r, 3), number(r, 4)}};
  }
}

/* The model's coordinates of a vertex that is on the screen. */
static void
read_model(reading *reader, const row *r)
{
  size_t at = sg_keys_find(&reader->vertices, integer(r, 0), integer(r, 1));

  for (unsigned k = 0; k < 3 && at != SG_NOWHERE; k++) {
    reader->in->vertex[at].model[k] = number(r, k + 2);
  }
}

static bool
read_vertices(reading *reader, const sg_version *version)
{
  sg_scene_input *in = reader->in;
  sg_sort_end end;

  if (!each_row(reader, version, SG_SCREEN, read_screen)) {
    return false;
  }
  reader->vertices = (sg_keys){in->vertex, sizeof *in->vertex, in->vertices, 0};
  end = sg_sort(in->vertex, in->vertices, sizeof *in->vertex, sg_key_compare,
                reader->poll);
  reader->memory = end != SG_SORT_NO_MEMORY;
  return end == SG_SORTED && each_row(reader, version, SG_V, read_model);
}

static void
read_triangle(reading *reader, const row *r)
{
  if (sg_is_chosen(reader->chosen, integer(r, 0))) {
    reader->in->triangle[reader->in->triangles++] =
        (sg_scene_triangle){.s = integer(r, 0),
                            .p = integer(r, 1),
                            .t = integer(r, 2),
                            .v = {integer(r, 3), integer(r, 4), integer(r, 5)}};
  }
}

static void
read_edge(reading *reader, const row *r)
{
  if (sg_is_chosen(reader->chosen, integer(r, 0))) {
    reader->in->edge[reader->in->edges++] =
        (sg_scene_edge){.s = integer(r, 0),
                        .e = integer(r, 1),
                        .v1 = integer(r, 2),
                        .v2 = integer(r, 3),
                        .real = integer(r, 4) == 1};
  }
}

static void
count_uses(reading *reader, const row *r)
{
  if (sg_is_chosen(reader->chosen, integer(r, 0))) {
    reader->in->uses += (size_t)list(r, 2)[0];
  }
}

static void
read_uses(reading *reader, const row *r)
{
  const int32_t *edges = list(r, 2);

  if (!sg_is_chosen(reader->chosen, integer(r, 0))) {
    return;
  }
  for (int32_t i = 1; i <= edges[0]; i++) {
    reader->in->use[reader->in->uses++] =
        (sg_scene_use){.s = integer(r, 0), .e = edges[i], .p = integer(r, 1)};
  }
}

/* A line is a cut in both its segments, a copy in the second. */
static void
read_cut(reading *reader, const row *r)
{
  int32_t s1 = integer(r, 1), s2 = integer(r, 5);
  bool first = sg_is_chosen(reader->chosen, s1);
  sg_scene_cut *cut = &reader->in->cut[reader->in->cuts];

  if (first) {
    *cut++ = (sg_scene_cut){.s = s1, .a = integer(r, 3), .b = integer(r, 4)};
  }
  if (sg_is_chosen(reader->chosen, s2)) {
    *cut++ = (sg_scene_cut){.s = s2,
                            .a = integer(r, 7),
                            .b = integer(r, 8),
                            .s2 = first ? s1 : 0,
                            .a2 = integer(r, 3),
                            .b2 = integer(r, 4)};
  }
  reader->in->cuts = (size_t)(cut - reader->in->cut);
}

static bool
make_room(sg_scene_input *in, const sg_version *version)
{
  size_t n[] = {
      sg_version_count(version, SG_SEGMENT),
      sg_version_count(version, SG_SCREEN), sg_version_count(version, SG_T),
      sg_version_count(version, SG_E), sg_version_count(version, SG_LINE)};

  in->segment = malloc((n[0] + 1) * sizeof *in->segment);
  in->vertex = malloc((n[1] + 1) * sizeof *in->vertex);
  in->triangle = malloc((n[2] + 1) * sizeof *in->triangle);
  in->edge = malloc((n[3] + 1) * sizeof *in->edge);
  in->cut = malloc((2 * n[4] + 2) * sizeof *in->cut);
  in->use = malloc((in->uses + 1) * sizeof *in->use);
  in->uses = 0;
  return in->segment && in->vertex && in->triangle && in->edge && in->cut &&
         in->use;
}

static bool
read_all(reading *r, const sg_version *version)
{
  if (!each_row(r, version, SG_P, count_uses)) {
    return false;
  }
  r->memory = make_room(r->in, version);
  return r->memory && each_row(r, version, SG_SEGMENT, read_segment) &&
         read_vertices(r, version) &&
         each_row(r, version, SG_T, read_triangle) &&
         each_row(r, version, SG_E, read_edge) &&
         each_row(r, version, SG_P, read_uses) &&
         each_row(r, version, SG_LINE, read_cut);
}

bool
sg_scene_input_read(sg_scene_input *in, const sg_version *version,
                    const sg_chosen *chosen, const sg_poll *poll, bool *memory)
{
  reading r = {.in = in, .chosen = chosen, .poll = poll, .memory = true};
  bool done;

  *in = (sg_scene_input){0};
  done = read_all(&r, version);
  *memory = r.memory;
  return done;
}

void
sg_scene_input_clear(sg_scene_input *in)
{
  free(in->segment);
  free(in->vertex);
  free(in->triangle);
  free(in->edge);
  free(in->use);
  free(in->cut);
  *in = (sg_scene_input){0};
}
