/* contour_rows.c -- outlines of smooth surfaces. */
#include "contour.h"
#include "scene_rows.h"

/* ---- rows ---- */

/* The pieces as rows. */
typedef struct rows {
  const sg_contours *contours;
  const sg_dense *dense;
  int32_t s, k; /* of the row written last */
} rows;

/* A relation whose rows are made of the outlines; its last column is what lies
 * beside them. */
typedef struct row_kind {
  sg_relation relation;
  unsigned last;
  const sg_contour *(*piece)(const sg_contours *contours, size_t i);
  void (*write)(rows *r, const sg_sheet_page *page, size_t i);
} row_kind;

static const sg_contour *
piece_at(const sg_contours *contours, size_t i)
{
  return &contours->piece[i];
}

static const sg_contour *
seen_at(const sg_contours *contours, size_t i)
{
  return &contours->facing[i].seen;
}

static bool
make_lists(const rows *r, const row_kind *of, sg_append *a)
{
  int32_t length[SG_PAGE_ROWS];

  for (size_t k = 0; k < a->sheet.pages; k++) {
    const sg_sheet_page *page = &a->sheet.page[k];
    for (size_t i = 0; i < page->n; i++) {
      length[i] = (int32_t)of->piece(r->contours, page->from + i)->adjacents;
    }
    if (!sg_append_lists(a, k, of->last, length)) {
      return false;
    }
  }
  return true;
}

/* The triangles adjacent to a piece, after their number. */
static void
write_adjacent(const rows *r, const sg_contour *piece, int32_t *list)
{
  list[0] = (int32_t)piece->adjacents;
  for (size_t j = 0; j < piece->adjacents; j++) {
    uint32_t t = r->contours->adjacent[piece->adjacent + j];
    list[j + 1] = r->dense->triangle_id[t];
  }
}

static void
write_row(rows *r, const sg_sheet_page *page, size_t i)
{
  static const int32_t symbol[] = {[SG_CONTOUR_HIDDEN] = SG_SYMBOL_HIDDEN,
                                   [SG_CONTOUR_VISIBLE] = SG_SYMBOL_VISIBLE,
                                   [SG_CONTOUR_SUBSTITUTE] =
                                       SG_SYMBOL_SUBSTITUTE};
  const sg_contour *piece = &r->contours->piece[page->from + i];
  const sg_dense *d = r->dense;
  const sg_blank *c = page->column;
  int32_t s = d->segment[sg_dense_segment_of(d, d->triangle_begin, piece->t)];

  r->k = s == r->s ? r->k + 1 : 1;
  r->s = s;
  c[0].i[i] = s;
  c[1].i[i] = r->k;
  c[2].i[i] = d->triangle_id[piece->t];
  c[3].i[i] = piece->side[0] + 1;
  c[4].f[i] = piece->at[0] + 0.0;
  c[5].i[i] = piece->side[1] + 1;
  c[6].f[i] = piece->at[1] + 0.0;
  c[7].i[i] = symbol[piece->visibility];
  for (size_t k = 0; k < 4; k++) {
    c[9 + k].f[i] = piece->rise[k / 2][k % 2] + 0.0;
  }
  write_adjacent(r, piece, c[8].list[i]);
}

static void
write_facing(rows *r, const sg_sheet_page *page, size_t i)
{
  const sg_facing *facing = &r->contours->facing[page->from + i];
  const sg_dense *d = r->dense;
  const sg_blank *c = page->column;
  uint32_t t = facing->seen.t;

  c[0].i[i] = d->segment[sg_dense_segment_of(d, d->triangle_begin, t)];
  c[1].i[i] = d->triangle_id[t];
  c[2].i[i] = facing->seen.side[0] + 1;
  c[3].f[i] = facing->from + 0.0;
  c[4].f[i] = facing->to + 0.0;
  write_adjacent(r, &facing->seen, c[5].list[i]);
}

static bool
replace_relation(sg_call *call, rows *r, const row_kind *of, size_t n)
{
  sg_world *world = sg_call_world(call);
  sg_append a;
  bool good;

  if (!sg_world_retract_all(world, of->relation) ||
      !sg_append_open(&a, world, of->relation, n)) {
    return sg_call_no_memory(call);
  }
  good = make_lists(r, of, &a);
  for (size_t k = 0; good && k < a.sheet.pages; k++) {
    for (size_t i = 0; i < a.sheet.page[k].n; i++) {
      of->write(r, &a.sheet.page[k], i);
    }
  }
  good = good && sg_append_commit(&a);
  sg_append_close(&a);
  return good || sg_call_no_memory(call);
}

static bool
replace_rows(sg_call *call, rows *r)
{
  static const row_kind pieces = {SG_CONTOUR, 8, piece_at, write_row};
  static const row_kind facings = {SG_SURFACE_FACING, 5, seen_at, write_facing};

  return replace_relation(call, r, &pieces, r->contours->n) &&
         replace_relation(call, r, &facings, r->contours->facings);
}

/* ---- finding ---- */

/* The outlines of a model, as screen/5 shows it; none: a vertex has no place.
 */
static bool
find_contours(sg_call *call, sg_contour_input *in, const sg_scene_model *model,
              sg_contours *out)
{
  sg_scene_screen screen = {0};
  bool memory;

  if (!sg_scene_screen_read(call, model, &screen)) {
    return false;
  }
  in->dense = &model->dense;
  in->solid = model->solid;
  in->screen = (const double(*)[3])screen.at;
  return screen.shown || sg_contours_find(in, &call->cancel, out, &memory) ||
         sg_call_ended(call);
}

static bool
fill_model(sg_call *call, sg_kept_model *kept, const sg_smoothness *as,
           sg_contour_input *in)
{
  sg_kept_smooth *smooth = sg_kept_smooth_hold(call, kept, as);
  sg_contours contours = {0};
  rows r = {.contours = &contours, .dense = &kept->model->dense};
  bool good = false;

  if (smooth) {
    in->smooth = &smooth->smooth;
    good = find_contours(call, in, kept->model, &contours) &&
           replace_rows(call, &r);
  }
  sg_contours_clear(&contours);
  sg_kept_smooth_drop(smooth);
  return good;
}

bool
sg_door_fill_contour(sg_call *call, const sg_chosen_segments *segments,
                     double theta, double phi, double rho, int kind,
                     const sg_smoothness *smooth, const sg_known_model *known)
{
  sg_contour_input in = {.central = kind == SG_PROJECTION_CENTRAL};
  sg_kept_model *kept = sg_kept_model_hold(call, segments, known);
  bool good;

  sg_eye_init(&in.eye, theta, phi, rho);
  good = kept && fill_model(call, kept, smooth, &in);
  sg_kept_model_drop(kept);
  return good;
}
