/* mesh4pl.c -- mesh files into the current world (documented in
 * kernel/file.pl).
 *
 * Layer: glue. The file is read to its end and parsed before the first row is
 * added, so a bad file changes nothing; the caller's transaction takes care of
 * the rest.
 */
#include "rows/append4pl.h"

#include "mesh4pl.h"

#include "glue.h"
#include "mesh_part.h"
#include "mesh_rows.h"

#include "engine/install.h"
#include "engine/world4pl.h"

#include <SWI-Stream.h>

#include <stdlib.h>
#include <string.h>

static atom_t ATOM_auto, ATOM_all, ATOM_none, ATOM_curve, ATOM_solid,
    ATOM_surface;

/* Arguments -------------------------------------------------------------- */

static const struct {
  const char *name;
  sg_mesh_format format;
} formats[] = {{"any", SG_MESH_UNKNOWN},
               {"stl", SG_MESH_STL},
               {"off", SG_MESH_OFF},
               {"obj", SG_MESH_OBJ},
               {"ply", SG_MESH_PLY},
               {"stl_binary", SG_MESH_STL_BINARY},
               {"ply_binary", SG_MESH_PLY_BINARY}};

int
sg_get_mesh_format_ex(term_t t, sg_mesh_format *out)
{
  char *name;

  if (!PL_get_chars(t, &name, CVT_ATOM | CVT_EXCEPTION)) {
    return FALSE;
  }
  for (size_t i = 0; i < sizeof formats / sizeof *formats; i++) {
    if (!strcmp(name, formats[i].name)) {
      *out = formats[i].format;
      return TRUE;
    }
  }
  return PL_domain_error("mesh_format", t);
}

static int
get_weld_ex(term_t t, sg_mesh_weld *out)
{
  atom_t name;

  if (!PL_get_atom_ex(t, &name)) {
    return FALSE;
  }
  *out = name == ATOM_auto  ? SG_WELD_AUTO
         : name == ATOM_all ? SG_WELD_ALL
                            : SG_WELD_NONE;
  return name == ATOM_auto || name == ATOM_all || name == ATOM_none ||
         PL_domain_error("mesh_weld", t);
}

/* Rows ------------------------------------------------------------------- */

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
    sg_mesh_rows_vertices(from->mesh, from->part, from->s, page);
  } else if (a->relation == SG_E) {
    sg_mesh_rows_edges(from->part, from->s, page);
  } else {
    sg_mesh_rows_lengths(from->part, page, length);
    if (!sg_append_lists(a, k, 2, length)) {
      return false;
    }
    sg_mesh_rows_polygons(from->part, from->s, page);
  }
  return true;
}

static int
add_rows_ex(sg_world *world, sg_relation relation, size_t n,
            const filling *from)
{
  sg_append a;
  int good = TRUE;

  if (!sg_append_open(&a, world, relation, n)) {
    return sg_no_memory();
  }
  for (size_t k = 0; k < a.sheet.pages && good; k++) {
    good = fill_page(&a, k, from) || sg_no_memory();
    good = good && (k % 32 != 31 || PL_handle_signals() >= 0);
  }
  good = good && (sg_append_commit(&a) || sg_no_memory());
  sg_append_close(&a);
  return good;
}

static int
add_part_ex(sg_world *world, const filling *from)
{
  return sg_segment_is_empty_ex(world, from->s) &&
         add_rows_ex(world, SG_V, from->part->vertices, from) &&
         add_rows_ex(world, SG_E, from->part->edges, from) &&
         add_rows_ex(world, SG_P, from->part->faces, from);
}

/* Answers ---------------------------------------------------------------- */

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

/* part(S, Kind, Name), Name '' if the file has none. */
static int
put_part_ex(term_t t, const sg_mesh_part *part, int32_t s)
{
  const char *name = part->name ? part->name : "";
  atom_t kind = part->closed  ? ATOM_solid
                : part->faces ? ATOM_surface
                              : ATOM_curve;
  term_t text = PL_new_term_ref();

  return PL_put_chars(text,
                      PL_ATOM | (is_utf8(name) ? REP_UTF8 : REP_ISO_LATIN_1),
                      (size_t)-1, name) &&
         PL_unify_term(t, PL_FUNCTOR_CHARS, "part", 3, PL_INT, (int)s, PL_ATOM,
                       kind, PL_TERM, text);
}

static int
unify_loaded_ex(term_t result, const sg_mesh *mesh, term_t parts)
{
  return PL_unify_term(
      result, PL_FUNCTOR_CHARS, "loaded", 3, PL_TERM, parts, PL_FLOAT,
      mesh->grain, PL_FUNCTOR_CHARS, "passed_over", 6, PL_INT64,
      (int64_t)mesh->degenerate, PL_INT64, (int64_t)mesh->repeated, PL_INT64,
      (int64_t)mesh->welded, PL_INT64, (int64_t)mesh->ignored, PL_INT64,
      (int64_t)mesh->ignored_line, PL_INT64, (int64_t)mesh->trailing);
}

int
sg_unify_mesh_fault_ex(term_t result, const sg_mesh_error *error)
{
  if (error->code == SG_MESH_STOPPED) {
    return FALSE;
  }
  if (error->code == SG_MESH_NO_MEMORY) {
    return sg_no_memory();
  }
  return PL_unify_term(result, PL_FUNCTOR_CHARS, "fault", 8, PL_CHARS,
                       sg_mesh_code_name[error->code], PL_INT64,
                       (int64_t)error->line, PL_INT64, (int64_t)error->column,
                       PL_INT64, (int64_t)error->byte, PL_CHARS, error->text,
                       PL_CHARS, error->wanted, PL_INT64, error->got, PL_INT64,
                       error->limit);
}

static int
add_parts_ex(sg_world *world, const sg_mesh *mesh, int32_t first, term_t list)
{
  sg_mesh_parts *parts = sg_mesh_parts_open(mesh);
  term_t tail = PL_copy_term_ref(list), head = PL_new_term_ref();
  int done = parts ? TRUE : sg_no_memory();
  bool stopped = false;

  for (size_t i = 0; done && i < mesh->segments; i++) {
    int32_t s = first + (int32_t)i;
    sg_mesh_part part;
    if (!sg_mesh_parts_get(parts, i, &sg_prolog_poll, &part, &stopped)) {
      done = stopped ? FALSE : sg_no_memory();
      break;
    }
    done = add_part_ex(world, &(filling){mesh, &part, s}) &&
           PL_unify_list(tail, head, tail) && put_part_ex(head, &part, s);
  }
  sg_mesh_parts_close(parts);
  return done && PL_unify_nil(tail);
}

int
sg_add_mesh_ex(const sg_mesh *mesh, int32_t first, term_t list)
{
  sg_world *world = sg_current_world_ex();

  if (!world || !sg_claim_ex(world)) {
    return FALSE;
  }
  int done = add_parts_ex(world, mesh, first, list);
  sg_world_release(world);
  return done;
}

/* mesh_add(+Stream, +Format, +Weld, +One, +S, -Result) is det. */
static foreign_t
mesh_add(term_t a0, int arity, void *context)
{
  sg_mesh_options options = {.poll = &sg_prolog_poll};
  sg_mesh_format format;
  sg_mesh_error error;
  sg_mesh mesh;
  char *data = NULL;
  size_t n = 0;
  int32_t first;
  int one;

  (void)arity, (void)context;
  if (!sg_get_mesh_format_ex(a0 + 1, &format) ||
      !get_weld_ex(a0 + 2, &options.weld) || !PL_get_bool_ex(a0 + 3, &one) ||
      !sg_get_id_ex(a0 + 4, &first)) {
    return FALSE;
  }
  options.one_segment = one;
  int done = sg_get_bytes_ex(a0, SIZE_MAX, &data, &n);
  bool good = done && sg_mesh_read(format, data, n, &options, &mesh, &error);
  free(data);
  if (!good) {
    return done && sg_unify_mesh_fault_ex(a0 + 5, &error);
  }
  term_t parts = PL_new_term_ref();
  done = sg_add_mesh_ex(&mesh, first, parts) &&
         unify_loaded_ex(a0 + 5, &mesh, parts);
  sg_mesh_clear(&mesh);
  return done;
}

static const PL_extension predicates[] = {
    {"mesh_add", 6, mesh_add, PL_FA_VARARGS},
    {NULL, 0, NULL, 0},
};

void
sg_install_mesh(void)
{
  ATOM_auto = PL_new_atom("auto");
  ATOM_all = PL_new_atom("all");
  ATOM_none = PL_new_atom("none");
  ATOM_curve = PL_new_atom("curve");
  ATOM_solid = PL_new_atom("solid");
  ATOM_surface = PL_new_atom("surface");
  PL_register_extensions_in_module("sg_kernel_file", predicates);
}
