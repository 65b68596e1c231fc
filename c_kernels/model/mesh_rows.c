/* mesh_rows.c -- meshes into the current world.
 *
 * Layer: rows. A file is read to its end before the first row is added, so a
 * bad file changes nothing; the caller's transaction takes care of the rest.
 * Ids are dense, from 1: vertices as in the part, edges as in the part and
 * real; polygon i has the edges of face i, one after another.
 */
#include "mesh_rows.h"

#include "mesh_part.h"
#include "rows/append_rows.h"

#include <stdlib.h>
#include <string.h>

/* ---- rows, a page at a time ---- */

/* The segment, and ids that go on from the page's first row. */
static void
number_rows(int32_t s, const sg_sheet_page *page)
{
  for (size_t i = 0; i < page->n; i++) {
    page->column[0].i[i] = s;
    page->column[1].i[i] = (int32_t)(page->from + i) + 1;
  }
}

static void
write_vertices(const sg_mesh *mesh, const sg_mesh_part *part, int32_t s,
               const sg_sheet_page *page)
{
  number_rows(s, page);
  for (size_t i = 0; i < page->n; i++) {
    const double *p = mesh->vertex[part->vertex[page->from + i]];
    for (int k = 0; k < 3; k++) {
      page->column[2 + k].f[i] = p[k] + 0.0; /* no -0.0 */
    }
  }
}

static void
write_edges(const sg_mesh_part *part, int32_t s, const sg_sheet_page *page)
{
  number_rows(s, page);
  for (size_t i = 0; i < page->n; i++) {
    page->column[2].i[i] = part->from[page->from + i] + 1;
    page->column[3].i[i] = part->to[page->from + i] + 1;
    page->column[4].i[i] = 1;
  }
}

static void
write_lengths(const sg_mesh_part *part, const sg_sheet_page *page,
              int32_t *length)
{
  const uint32_t *start = part->start + page->from;

  for (size_t i = 0; i < page->n; i++) {
    length[i] = (int32_t)(start[i + 1] - start[i]);
  }
}

static void
write_polygons(const sg_mesh_part *part, int32_t s, const sg_sheet_page *page)
{
  number_rows(s, page);
  for (size_t i = 0; i < page->n; i++) {
    const uint32_t *start = part->start + page->from + i;
    int32_t *list = page->column[2].list[i];
    list[0] = (int32_t)(start[1] - start[0]);
    for (int32_t k = 1; k <= list[0]; k++) {
      list[k] = (int32_t)start[0] + k;
    }
  }
}

/* ---- parts ---- */

/* What a relation gets from a part, in place. */
typedef struct filling {
  const sg_mesh *mesh;
  const sg_mesh_part *part;
  int32_t s;
} filling;

static bool
fill_page(sg_append *a, size_t k, const filling *from)
{
  const sg_sheet_page *page = &a->sheet.page[k];
  int32_t length[SG_PAGE_ROWS];

  if (a->relation == SG_V) {
    write_vertices(from->mesh, from->part, from->s, page);
  } else if (a->relation == SG_E) {
    write_edges(from->part, from->s, page);
  } else {
    write_lengths(from->part, page, length);
    if (!sg_append_lists(a, k, 2, length)) {
      return false;
    }
    write_polygons(from->part, from->s, page);
  }
  return true;
}

static bool
add_rows(sg_call *call, sg_world *world, sg_relation relation, size_t n,
         const filling *from)
{
  sg_append a;
  bool good = true;

  if (!sg_append_open(&a, world, relation, n)) {
    return sg_call_no_memory(call);
  }
  for (size_t k = 0; k < a.sheet.pages && good; k++) {
    good = fill_page(&a, k, from) &&
           (k % 32 != 31 || !sg_cancelled(&call->cancel));
  }
  good = good && sg_append_commit(&a);
  sg_append_close(&a);
  return good || sg_call_ended(call);
}

bool
sg_mesh_add_part(sg_call *call, sg_world *world, const sg_mesh *mesh,
                 const sg_mesh_part *part, int32_t s)
{
  const filling from = {mesh, part, s};

  return sg_segment_is_empty(call, world, s) &&
         add_rows(call, world, SG_V, part->vertices, &from) &&
         add_rows(call, world, SG_E, part->edges, &from) &&
         add_rows(call, world, SG_P, part->faces, &from);
}

/* ---- what was added ---- */

static bool
is_utf8(const char *text)
{
  const unsigned char *p = (const unsigned char *)text;

  while (*p) {
    int more = *p < 0x80                 ? 0
               : *p >= 0xc2 && *p < 0xe0 ? 1
               : *p >= 0xe0 && *p < 0xf0 ? 2
               : *p >= 0xf0 && *p < 0xf5 ? 3
                                         : -1;
    if (more < 0) {
      return false;
    }
    for (p++; more > 0; more--, p++) {
      if ((*p & 0xc0) != 0x80) {
        return false;
      }
    }
  }
  return true;
}

/* The name in UTF-8; what is none is taken for Latin-1. "": there is none. */
static const char *
name_of(sg_call *call, const sg_mesh_part *part)
{
  const char *name = part->name ? part->name : "";
  bool latin = !is_utf8(name);
  char *out = sg_call_alloc(call, 2 * strlen(name) + 1), *end = out;

  for (; out && *name; name++) {
    unsigned char c = (unsigned char)*name;

    if (latin && c >= 0x80) {
      *end++ = (char)(0xc0 | c >> 6);
      c = 0x80 | (c & 0x3f);
    }
    *end++ = (char)c;
  }
  if (out) {
    *end = 0;
  }
  return out;
}

static bool
add_parts(sg_call *call, sg_world *world, const sg_mesh *mesh, int32_t first,
          sg_mesh_part_fact_list *out)
{
  sg_mesh_parts *parts = sg_mesh_parts_open(mesh);
  bool good = parts || sg_call_no_memory(call), stopped;

  for (size_t i = 0; good && i < mesh->segments; i++) {
    sg_mesh_part part;

    if (!sg_mesh_parts_get(parts, i, &call->cancel, &part, &stopped)) {
      good = sg_call_ended(call);
      break;
    }
    sg_mesh_part_fact fact = {.s = first + (int32_t)i,
                              .kind = part.closed  ? SG_MESH_KIND_SOLID
                                      : part.faces ? SG_MESH_KIND_SURFACE
                                                   : SG_MESH_KIND_CURVE,
                              .name = name_of(call, &part)};

    good = fact.name && sg_mesh_add_part(call, world, mesh, &part, fact.s) &&
           sg_mesh_part_fact_list_add(call, out, fact);
  }
  sg_mesh_parts_close(parts);
  return good;
}

bool
sg_mesh_add_rows(sg_call *call, const sg_mesh *mesh, int32_t first,
                 sg_mesh_part_fact_list *parts)
{
  sg_world *world = sg_call_claim(call);
  bool good = world && add_parts(call, world, mesh, first, parts);

  if (world) {
    sg_world_release(world);
  }
  return good;
}

bool
sg_mesh_refused(sg_call *call, const sg_mesh_error *error)
{
  return error->code == SG_MESH_STOPPED || error->code == SG_MESH_WRITE_FAILED
             ? false
         : error->code == SG_MESH_NO_MEMORY ? sg_call_no_memory(call)
                                            : true;
}

bool
sg_door_mesh_add(sg_call *call, const sg_input *stream, sg_mesh_format format,
                 sg_mesh_weld weld, bool one, int32_t s, sg_mesh_added *result)
{
  const sg_mesh_options options = {weld, one, &call->cancel};
  sg_mesh mesh;
  char *data = NULL;
  size_t n = 0;

  if (!sg_call_read_all(call, stream, SIZE_MAX, &data, &n)) {
    return false;
  }
  bool good = sg_mesh_read(format, data, n, &options, &mesh, &result->fault);

  free(data);
  if (!good) {
    result->is = SG_MESH_ADDED_FAULT;
    return sg_mesh_refused(call, &result->fault);
  }
  *result = (sg_mesh_added){.is = SG_MESH_ADDED_LOADED};
  result->loaded.grain = mesh.grain;
  result->loaded.passed_over = mesh;
  good = sg_mesh_add_rows(call, &mesh, s, &result->loaded.parts);
  sg_mesh_clear(&mesh);
  return good;
}
