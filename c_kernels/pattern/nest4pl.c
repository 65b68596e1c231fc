/* nest4pl.c -- nest/7 and the shapes_*() doors (documented in
 * kernel/pattern.pl).
 *
 * Layer: glue: converts, checks, raises; computes nothing.
 */
#include "flat_shapes.h"
#include "glue.h"
#include "nest.h"

#include "engine/install.h"
#include "engine/world4pl.h"

#include <SWI-Stream.h>
#include <stdlib.h>
#include <string.h>

static functor_t FUNCTOR_minus2, FUNCTOR_piece2, FUNCTOR_place4;

/* X-Y; arg: a reference to use. */
static int
get_point_ex(term_t t, term_t arg, double out[2])
{
  if (!PL_is_functor(t, FUNCTOR_minus2)) {
    return PL_type_error("pair", t);
  }
  return PL_get_arg(1, t, arg) && sg_get_finite_ex(arg, &out[0]) &&
         PL_get_arg(2, t, arg) && sg_get_finite_ex(arg, &out[1]);
}

/* ---- shapes ---- */

static int
release_shapes(atom_t atom)
{
  sg_flat_shapes *shapes = PL_blob_data(atom, NULL, NULL);

  sg_flat_shapes_clear(shapes);
  free(shapes);
  return TRUE;
}

static int
write_shapes(IOSTREAM *out, atom_t atom, int flags)
{
  const sg_flat_shapes *shapes = PL_blob_data(atom, NULL, NULL);

  (void)flags;
  Sfprintf(out, "<sg_flat_shapes>(%zu)", shapes->n);
  return TRUE;
}

static PL_blob_t shapes_blob = {.magic = PL_BLOB_MAGIC,
                                .flags = PL_BLOB_UNIQUE | PL_BLOB_NOCOPY,
                                .name = "sg_flat_shapes",
                                .release = release_shapes,
                                .write = write_shapes};

static int
get_shapes_ex(term_t t, sg_flat_shapes **out)
{
  PL_blob_t *type;
  void *data;

  if (!PL_get_blob(t, &data, NULL, &type) || type != &shapes_blob) {
    return PL_is_variable(t) ? PL_instantiation_error(t)
                             : PL_type_error("shapes", t);
  }
  *out = data;
  return TRUE;
}

static int
get_shape_ex(term_t list, double size, sg_flat_shape *out)
{
  term_t tail = PL_copy_term_ref(list), head = PL_new_term_ref();
  term_t arg = PL_new_term_ref();

  out->corners = 0;
  while (PL_get_list_ex(tail, head, tail)) {
    if (out->corners == SG_FLAT_SHAPE_CORNERS) {
      return PL_domain_error("convex_shape", list);
    }
    if (!get_point_ex(head, arg, out->at[out->corners++])) {
      return FALSE;
    }
  }
  return PL_get_nil_ex(tail) && (sg_flat_shape_is_valid(out, size) ||
                                 PL_domain_error("convex_shape", list));
}

/* shapes_open(+Size, -Shapes) is det. */
static foreign_t
shapes_open(term_t size, term_t t)
{
  sg_flat_shapes *shapes;
  double of;

  if (!sg_get_finite_ex(size, &of)) {
    return FALSE;
  }
  if (!(of > 0.0)) {
    return PL_domain_error("size", size);
  }
  shapes = malloc(sizeof *shapes);
  if (!shapes) {
    return sg_no_memory();
  }
  sg_flat_shapes_init(shapes, of);
  return PL_unify_blob(t, shapes, sizeof *shapes, &shapes_blob);
}

/* shapes_add(+Shapes, +Shape) is det. */
static foreign_t
shapes_add(term_t t, term_t list)
{
  sg_flat_shapes *shapes;
  sg_flat_shape shape;

  if (!get_shapes_ex(t, &shapes) || !get_shape_ex(list, shapes->size, &shape)) {
    return FALSE;
  }
  return sg_flat_shapes_add(shapes, &shape) || sg_no_memory();
}

/* shapes_free(+Shapes, +Shape, +Tolerance) is semidet. */
static foreign_t
shapes_free(term_t t, term_t list, term_t tolerance)
{
  sg_flat_shapes *shapes;
  sg_flat_shape shape;
  double tol;

  if (!get_shapes_ex(t, &shapes) || !get_shape_ex(list, shapes->size, &shape) ||
      !sg_get_finite_ex(tolerance, &tol)) {
    return FALSE;
  }
  if (tol < 0) {
    return PL_domain_error("not_less_than_zero", tolerance);
  }
  return sg_flat_shapes_free(shapes, &shape, tol);
}

/* ---- nesting ---- */

typedef struct reading {
  double (*at)[2];
  size_t *loop_end;
  size_t points, point_room, loops, loop_room;
} reading;

static int
room_ex(void **array, size_t n, size_t *room, size_t size)
{
  if (n < *room) {
    return TRUE;
  }
  size_t more = *room ? 2 * *room : 64;
  void *grown = realloc(*array, more * size);

  if (!grown) {
    return sg_no_memory();
  }
  *array = grown;
  *room = more;
  return TRUE;
}

static int
read_loop_ex(term_t list, reading *r)
{
  term_t tail = PL_copy_term_ref(list), head = PL_new_term_ref();
  term_t arg = PL_new_term_ref();

  while (PL_get_list_ex(tail, head, tail)) {
    if (!room_ex((void **)&r->at, r->points, &r->point_room, sizeof *r->at) ||
        !get_point_ex(head, arg, r->at[r->points])) {
      return FALSE;
    }
    r->points++;
  }
  return PL_get_nil_ex(tail);
}

static int
read_loops_ex(term_t list, reading *r)
{
  term_t tail = PL_copy_term_ref(list), head = PL_new_term_ref();

  while (PL_get_list_ex(tail, head, tail)) {
    if (!room_ex((void **)&r->loop_end, r->loops, &r->loop_room,
                 sizeof *r->loop_end) ||
        !read_loop_ex(head, r)) {
      return FALSE;
    }
    r->loop_end[r->loops++] = r->points;
  }
  return PL_get_nil_ex(tail) &&
         (r->points > 0 || PL_domain_error("outline", list));
}

/* The arrays of *out are to be freed in any case: clear_piece(). */
static int
get_piece_ex(term_t t, sg_nest_piece *out)
{
  term_t arg = PL_new_term_ref();
  reading r = {0};
  double *degrees = NULL;
  int ok = PL_is_functor(t, FUNCTOR_piece2) || PL_type_error("piece", t);

  ok = ok && PL_get_arg(1, t, arg) &&
       sg_get_doubles_ex(arg, &degrees, &out->angles) &&
       PL_get_arg(2, t, arg) && read_loops_ex(arg, &r);
  out->degrees = degrees;
  out->at = (const double(*)[2])r.at;
  out->points = r.points;
  out->loop_end = r.loop_end;
  out->loops = r.loops;
  return ok;
}

static void
clear_pieces(sg_nest_piece *piece, size_t n)
{
  for (size_t i = 0; i < n; i++) {
    free((void *)piece[i].degrees);
    free((void *)piece[i].at);
    free((void *)piece[i].loop_end);
  }
  free(piece);
}

static int
get_pieces_ex(term_t list, sg_nest_piece *piece)
{
  term_t tail = PL_copy_term_ref(list), head = PL_new_term_ref();

  for (size_t i = 0; PL_get_list(tail, head, tail); i++) {
    fid_t frame = PL_open_foreign_frame();
    int ok = frame && get_piece_ex(head, &piece[i]);

    if (frame) {
      PL_close_foreign_frame(frame);
    }
    if (!ok) {
      return FALSE;
    }
  }
  return TRUE;
}

static int
unify_places(term_t list, const sg_nest_place *place, size_t n)
{
  term_t tail = PL_copy_term_ref(list), head = PL_new_term_ref();

  for (size_t i = 0; i < n; i++) {
    if (!PL_unify_list(tail, head, tail) ||
        !PL_unify_term(head, PL_FUNCTOR, FUNCTOR_place4, PL_INT64,
                       (int64_t)place[i].sheet, PL_FLOAT,
                       place[i].degrees + 0.0, PL_FLOAT, place[i].by[0] + 0.0,
                       PL_FLOAT, place[i].by[1] + 0.0)) {
      return FALSE;
    }
  }
  return PL_unify_nil(tail);
}

static int
nest_pieces(const sg_nest_paper *paper, term_t pieces, size_t n, term_t places,
            term_t work)
{
  uint64_t looked = 0;
  sg_nest_piece *piece = calloc(n + 1, sizeof *piece);
  sg_nest_place *place = calloc(n + 1, sizeof *place);
  int ok = (piece && place) || sg_no_memory();
  bool memory;

  ok = ok && get_pieces_ex(pieces, piece);
  if (ok &&
      !sg_nest(paper, piece, n, place, &looked, &sg_prolog_poll, &memory)) {
    ok = memory ? FALSE : sg_no_memory();
  }
  ok = ok && unify_places(places, place, n) && PL_unify_uint64(work, looked);
  if (piece) {
    clear_pieces(piece, n);
  }
  free(place);
  return ok;
}

/* nest(+Size, +Square, +Gap, +One, +Pieces, -Places, -Work) is det. */
static foreign_t
nest(term_t size, term_t square, term_t gap, term_t one, term_t pieces,
     term_t places, term_t work)
{
  sg_nest_paper paper;
  double at[2];
  int32_t squares;
  int single;
  size_t n;

  if (!get_point_ex(size, PL_new_term_ref(), at) ||
      !sg_get_finite_ex(square, &paper.square) ||
      !sg_get_int32_ex(gap, &squares) || !PL_get_bool_ex(one, &single)) {
    return FALSE;
  }
  if (squares < 0 || squares > 100) {
    return PL_domain_error("gap", gap);
  }
  paper.width = at[0];
  paper.height = at[1];
  paper.gap = (unsigned)squares;
  paper.one = single != 0;
  if (!sg_nest_paper_is_valid(&paper)) {
    return PL_domain_error("paper", size);
  }
  if (PL_skip_list(pieces, 0, &n) != PL_LIST) {
    return PL_type_error("list", pieces);
  }
  return nest_pieces(&paper, pieces, n, places, work);
}

void
sg_install_nest(void)
{
  static const PL_extension doors[] = {
      {"shapes_open", 2, (pl_function_t)shapes_open, 0},
      {"shapes_add", 2, (pl_function_t)shapes_add, 0},
      {"shapes_free", 3, (pl_function_t)shapes_free, 0},
      {"nest", 7, (pl_function_t)nest, 0},
      {NULL, 0, NULL, 0}};

  FUNCTOR_minus2 = PL_new_functor(PL_new_atom("-"), 2);
  FUNCTOR_piece2 = PL_new_functor(PL_new_atom("piece"), 2);
  FUNCTOR_place4 = PL_new_functor(PL_new_atom("place"), 4);
  PL_register_extensions_in_module("sg_kernel_pattern", doors);
}
