/* solid4pl.c -- a solid under way behind a Prolog handle: taking, counting.
 *
 * Layer: glue. The doors are documented in rules/kernel/boolean.pl.
 */
#include "solid4pl.h"

#include "glue.h"
#include "solid_move.h"
#include "solid_take.h"

#include "engine/install.h"

#include <SWI-Stream.h>
#include <stdlib.h>

enum { MANY = 1 << 15 }; /* triangles, for which threads are worth it */

/* ---- the handle ---- */

typedef struct handle {
  sg_solid solid;
  bool closed;
} handle;

static int
release_handle(atom_t atom)
{
  handle *h = PL_blob_data(atom, NULL, NULL);

  sg_solid_clear(&h->solid);
  free(h);
  return TRUE;
}

static int
write_handle(IOSTREAM *out, atom_t atom, int flags)
{
  const handle *h = PL_blob_data(atom, NULL, NULL);

  (void)flags;
  if (h->closed) {
    Sfprintf(out, "<sg_solid>(closed)");
  } else {
    Sfprintf(out, "<sg_solid>(%zu)", h->solid.faces);
  }
  return TRUE;
}

static PL_blob_t solid_blob = {.magic = PL_BLOB_MAGIC,
                               .flags = PL_BLOB_UNIQUE | PL_BLOB_NOCOPY,
                               .name = "sg_solid",
                               .release = release_handle,
                               .write = write_handle};

int
sg_unify_solid(term_t t, sg_solid *moved_in)
{
  handle *h = calloc(1, sizeof *h);

  if (!h) {
    sg_solid_clear(moved_in);
    return sg_no_memory();
  }
  h->solid = *moved_in;
  *moved_in = (sg_solid){0};
  return PL_unify_blob(t, h, sizeof *h, &solid_blob);
}

static int
get_handle_ex(term_t t, handle **out)
{
  PL_blob_t *type;
  void *data;

  if (!PL_get_blob(t, &data, NULL, &type) || type != &solid_blob) {
    return PL_is_variable(t) ? PL_instantiation_error(t)
                             : PL_type_error("solid", t);
  }
  *out = data;
  return !(*out)->closed || PL_existence_error("solid", t);
}

int
sg_get_solid_ex(term_t t, sg_solid **out)
{
  handle *h;

  if (!get_handle_ex(t, &h)) {
    return FALSE;
  }
  *out = &h->solid;
  return TRUE;
}

/* solid_close(+Solid) is det. */
static foreign_t
solid_close(term_t solid)
{
  handle *h;

  if (!get_handle_ex(solid, &h)) {
    return FALSE;
  }
  sg_solid_clear(&h->solid);
  h->closed = true;
  return TRUE;
}

/* solid_is_closed(+Solid) is semidet. */
static foreign_t
solid_is_closed(term_t solid)
{
  sg_solid *s;

  if (!sg_get_solid_ex(solid, &s)) {
    return FALSE;
  }
  sg_crew *crew = s->triangles < MANY ? NULL : sg_crew_open(0);
  bool closed = sg_solid_is_closed(s, crew);

  sg_crew_close(crew);
  return closed;
}

/* ---- taking ---- */

static int
take_ex(const sg_version *version, const int32_t *segment, size_t n,
        sg_solid *out)
{
  static const sg_relation read[3] = {SG_V, SG_E, SG_T};
  sg_view view[3] = {{0}};
  int good = TRUE;

  *out = (sg_solid){0};
  for (int i = 0; i < 3 && good; i++) {
    good = sg_version_view(version, read[i], &view[i]);
  }
  good = good && sg_solid_take(&(sg_solid_input){&view[0], &view[1], &view[2]},
                               segment, n, &sg_prolog_poll, out);
  for (int i = 0; i < 3; i++) {
    sg_view_clear(&view[i]);
  }
  return good || (PL_exception(0) ? FALSE : sg_no_memory());
}

/* solid_take(+Segments, -Solid) is det. */
static foreign_t
solid_take(term_t segments, term_t solid)
{
  sg_world *world = sg_current_world_ex();
  int32_t *segment;
  sg_solid taken;
  size_t n;

  if (!world || !sg_get_id_set_ex(segments, &segment, &n)) {
    return FALSE;
  }
  const sg_version *version = sg_world_version(world);
  int good = take_ex(version, segment, n, &taken);

  sg_version_drop(version);
  free(segment);
  if (!good) {
    sg_solid_clear(&taken);
    return FALSE;
  }
  return sg_unify_solid(solid, &taken);
}

/* ---- moving ---- */

static int
get_rows_ex(term_t matrix, double row[3][4])
{
  term_t tail = PL_copy_term_ref(matrix), head = PL_new_term_ref();
  double *numbers;
  size_t n;

  for (int k = 0; k < 3; k++) {
    if (!PL_get_list_ex(tail, head, tail) ||
        !sg_get_doubles_ex(head, &numbers, &n)) {
      return FALSE;
    }
    for (size_t i = 0; i < 4 && n == 4; i++) {
      row[k][i] = numbers[i];
    }
    free(numbers);
    if (n != 4) {
      return PL_type_error("matrix", matrix);
    }
  }
  return PL_get_nil_ex(tail);
}

/* The numbers, from 1, of the faces that are marked. */
static int
unify_marked(term_t list, const bool *marked, size_t n)
{
  term_t tail = PL_copy_term_ref(list), head = PL_new_term_ref();

  for (size_t i = 0; i < n; i++) {
    if (marked[i] &&
        (!PL_unify_list(tail, head, tail) || !PL_unify_uint64(head, i + 1))) {
      return FALSE;
    }
  }
  return PL_unify_nil(tail);
}

/* solid_move(+Solid, +Matrix, -Again) is semidet: fails if it goes too far. */
static foreign_t
solid_move(term_t t, term_t matrix, term_t list)
{
  sg_solid *solid;
  double row[3][4];
  bool *again;
  int done = FALSE;

  if (!sg_get_solid_ex(t, &solid) || !get_rows_ex(matrix, row)) {
    return FALSE;
  }
  if (!(again = malloc(solid->faces + 1))) {
    return sg_no_memory();
  }
  if (sg_solid_move(solid, (const double(*)[4])row, &sg_prolog_poll, again) ==
      SG_MOVED) {
    done = unify_marked(list, again, solid->faces);
  }
  free(again);
  return done;
}

/* solid_counts(+Solid, -Vertices, -Faces, -Triangles) is det. */
static foreign_t
solid_counts(term_t t, term_t vertices, term_t faces, term_t triangles)
{
  sg_solid *solid;

  return sg_get_solid_ex(t, &solid) &&
         PL_unify_uint64(vertices, solid->vertices) &&
         PL_unify_uint64(faces, solid->faces) &&
         PL_unify_uint64(triangles, solid->triangles);
}

static const PL_extension predicates[] = {
    {"solid_close", 1, solid_close, 0},
    {"solid_is_closed", 1, solid_is_closed, 0},
    {"solid_take", 2, solid_take, 0},
    {"solid_move", 3, solid_move, 0},
    {"solid_counts", 4, solid_counts, 0},
    {NULL, 0, NULL, 0},
};

void
sg_install_solid(void)
{
  PL_register_extensions_in_module("sg_kernel_boolean", predicates);
}
