/* hide.c -- see hide.h */
#include "hide.h"

#include "bounds.h"

#include <math.h>
#include <stdlib.h>

/* ---------------------------------------------------------- one triangle */

/* How far p is to the left of side a-b. */
static double
left_of(const double a[3], const double b[3], const double p[3])
{
  double x = b[0] - a[0], y = b[1] - a[1];

  return (x * (p[1] - a[1]) - y * (p[0] - a[0])) / sqrt(x * x + y * y);
}

static double
snap(double x, double tolerance)
{
  return fabs(x) <= tolerance ? 0.0 : x;
}

/* Keeps the part from t[0] to t[1] where a value that runs linearly from f0 at
 * 0 to f1 at 1 is not negative. False: nothing, or a point only. */
static bool
keep(double f0, double f1, double t[2])
{
  if ((f0 < 0.0 && f1 <= 0.0) || (f0 <= 0.0 && f1 < 0.0)) {
    return false;
  }
  if (f0 < 0.0) {
    t[0] = sg_larger(t[0], f0 / (f0 - f1));
  }
  if (f1 < 0.0) {
    t[1] = sg_smaller(t[1], f0 / (f0 - f1));
  }
  return t[0] < t[1];
}

/* How far behind the mask's plane the line's point at t is. */
static double
behind(const sg_scene *scene, const sg_scene_mask *mask, const double a[3],
       const double b[3], double t)
{
  const double *corner = scene->at[mask->v[0]];
  double sum = 0.0;

  for (int k = 0; k < 3; k++) {
    sum += mask->normal[k] * (a[k] + t * (b[k] - a[k]) - corner[k]);
  }
  return sum;
}

/* The paper's four cases at once: the overlap P-Q, then the depths there. */
static bool
depth_test(double tolerance, double at_p, double at_q, double t[2])
{
  if (at_p <= tolerance && at_q <= tolerance) {
    return false; /* in front, or equal at both */
  }
  if (at_p < -tolerance) {
    t[0] += (t[1] - t[0]) * (at_p / (at_p - at_q));
  } else if (at_q < -tolerance) {
    t[1] = t[0] + (t[1] - t[0]) * (at_p / (at_p - at_q));
  }
  return t[0] < t[1];
}

static bool
has_corner(const sg_scene_mask *mask, uint32_t v)
{
  return mask->v[0] == v || mask->v[1] == v || mask->v[2] == v;
}

/* Whether the line lies on the triangle, as the model has it: as its side, as
 * an edge of its polygon, or as an added line that says so. */
static bool
lies_on(const sg_scene *scene, const sg_scene_line *line,
        const sg_scene_mask *mask)
{
  size_t k = (size_t)(line - scene->line);

  if (has_corner(mask, line->a) && has_corner(mask, line->b)) {
    return true;
  }
  if (line->number != UINT32_MAX) {
    return sg_scene_lies_on(scene->model, line->number,
                            scene->model->dense.polygon_of[mask->triangle]);
  }
  for (uint32_t i = scene->lies_begin[k]; i < scene->lies_begin[k + 1]; i++) {
    if (scene->lies_on[i] == mask->triangle) {
      return true;
    }
  }
  return false;
}

static bool
apart(const sg_scene *scene, const sg_scene_mask *mask, const double a[3],
      const double b[3])
{
  double e = scene->close;

  return sg_larger(a[2], b[2]) <= mask->low[2] ||
         sg_larger(a[0], b[0]) < mask->low[0] - e ||
         sg_smaller(a[0], b[0]) > mask->high[0] + e ||
         sg_larger(a[1], b[1]) < mask->low[1] - e ||
         sg_smaller(a[1], b[1]) > mask->high[1] + e;
}

/* The part of line a-b that the mask's three sides keep. */
static bool
covered(const sg_scene *scene, const sg_scene_mask *mask, const double a[3],
        const double b[3], double t[2])
{
  double(*at)[3] = scene->at;
  double e = scene->close;

  t[0] = 0.0;
  t[1] = 1.0;
  for (int k = 0; k < 3; k++) {
    const double *p = at[mask->v[k]], *q = at[mask->v[(k + 1) % 3]];
    if (!keep(snap(left_of(p, q, a), e), snap(left_of(p, q, b), e), t)) {
      return false;
    }
  }
  return true;
}

bool
sg_mask_hides(const sg_scene *scene, const sg_scene_mask *mask,
              const sg_scene_line *line, sg_hidden *out)
{
  const double *a = scene->at[line->a], *b = scene->at[line->b];
  double t[2];

  if (apart(scene, mask, a, b) || lies_on(scene, line, mask) ||
      !covered(scene, mask, a, b, t) ||
      !depth_test(scene->tolerance, behind(scene, mask, a, b, t[0]),
                  behind(scene, mask, a, b, t[1]), t)) {
    return false;
  }
  out->from = t[0];
  out->to = t[1];
  return true;
}

bool
sg_mask_covers(const sg_scene *scene, const sg_scene_mask *mask,
               const sg_scene_line *line, sg_cover *out)
{
  const double *a = scene->at[line->a], *b = scene->at[line->b];
  double t[2];

  if (!covered(scene, mask, a, b, t)) {
    return false;
  }
  *out = (sg_cover){.from = t[0], .to = t[1]};
  for (int k = 0; k < 2; k++) {
    out->behind[k] = behind(scene, mask, a, b, t[k]) / mask->normal[2];
  }
  return true;
}

/* ------------------------------------------------------------- two lines */

double
sg_line_length(const sg_scene *scene, const sg_scene_line *line)
{
  const double *a = scene->at[line->a], *b = scene->at[line->b];
  double x = b[0] - a[0], y = b[1] - a[1];

  return sqrt(x * x + y * y);
}

static double
between(double x, double y, double t)
{
  return x + t * (y - x);
}

bool
sg_lines_overlap(const sg_scene *scene, const sg_scene_line *a,
                 const sg_scene_line *b, sg_overlap *out)
{
  const double *p = scene->at[a->a], *q = scene->at[a->b];
  const double *r = scene->at[b->a], *s = scene->at[b->b];
  double x = q[0] - p[0], y = q[1] - p[1];
  double square = x * x + y * y, size = sqrt(square);
  double off_r = x * (r[1] - p[1]) - y * (r[0] - p[0]);
  double off_s = x * (s[1] - p[1]) - y * (s[0] - p[0]);
  double far = scene->close * size; /* off: distance times size */
  double at_r, at_s;

  if ((off_r > far && off_s > far) || (off_r < -far && off_s < -far) ||
      size <= scene->close) {
    return false;
  }
  at_r = (x * (r[0] - p[0]) + y * (r[1] - p[1])) / square;
  at_s = (x * (s[0] - p[0]) + y * (s[1] - p[1])) / square;
  out->from = sg_larger(0.0, sg_smaller(at_r, at_s));
  out->to = sg_smaller(1.0, sg_larger(at_r, at_s));
  if ((out->to - out->from) * size <= scene->close) {
    return false;
  }
  out->from2 = (out->from - at_r) / (at_s - at_r);
  out->to2 = (out->to - at_r) / (at_s - at_r);
  return fabs(between(off_r, off_s, out->from2)) <= far &&
         fabs(between(off_r, off_s, out->to2)) <= far;
}

/* ------------------------------------------------------------- searching */

static void
line_shape(const sg_scene *scene, const sg_scene_line *line, sg_grid_shape *out)
{
  const double *a = scene->at[line->a], *b = scene->at[line->b];

  *out = (sg_grid_shape){2, {{a[0], a[1]}, {b[0], b[1]}}};
}

static void
shape_of_line(const void *data, size_t i, sg_grid_shape *out)
{
  const sg_scene *scene = data;

  line_shape(scene, &scene->line[i], out);
}

static void
shape_of_mask(const void *data, size_t i, sg_grid_shape *out)
{
  const sg_scene *scene = data;

  out->corners = 3;
  for (int k = 0; k < 3; k++) {
    const double *at = scene->at[scene->mask[i].v[k]];
    out->at[k][0] = at[0];
    out->at[k][1] = at[1];
  }
}

bool
sg_hide_init(sg_hide *hide, const sg_scene *scene, const sg_poll *poll,
             bool *memory)
{
  *hide = (sg_hide){.scene = scene};
  hide->mask_seen = calloc(scene->masks + 1, sizeof *hide->mask_seen);
  hide->line_seen = calloc(scene->lines + 1, sizeof *hide->line_seen);
  *memory = hide->mask_seen && hide->line_seen;
  if (*memory &&
      sg_grid_init(&hide->masks, scene->masks, shape_of_mask, scene, poll,
                   memory) &&
      sg_grid_init(&hide->lines, scene->lines, shape_of_line, scene, poll,
                   memory)) {
    return true;
  }
  sg_hide_clear(hide);
  return false;
}

void
sg_hide_clear(sg_hide *hide)
{
  sg_grid_clear(&hide->masks);
  sg_grid_clear(&hide->lines);
  free(hide->mask_seen);
  free(hide->line_seen);
  *hide = (sg_hide){0};
}

/* Room for one more in a growing array; false: no memory. */
static bool
room(void **array, size_t *room_for, size_t n, size_t size)
{
  void *wider;
  size_t more = *room_for ? 2 * *room_for : 32;

  if (n < *room_for) {
    return true;
  }
  wider = realloc(*array, more * size);
  if (wider) {
    *array = wider;
    *room_for = more;
  }
  return wider != NULL;
}

static bool
add_hidden(sg_hiddens *out, const sg_hidden *part)
{
  void *array = out->part;
  bool ok = room(&array, &out->room, out->n, sizeof *part);

  out->part = array;
  if (ok) {
    out->part[out->n++] = *part;
  }
  return ok;
}

static bool
add_overlap(sg_overlaps *out, const sg_overlap *part)
{
  void *array = out->part;
  bool ok = room(&array, &out->room, out->n, sizeof *part);

  out->part = array;
  if (ok) {
    out->part[out->n++] = *part;
  }
  return ok;
}

static int
hidden_compare(const void *a, const void *b)
{
  const sg_hidden *x = a, *y = b;

  if (x->from != y->from) {
    return x->from < y->from ? -1 : 1;
  }
  if (x->to != y->to) {
    return x->to < y->to ? -1 : 1;
  }
  return (x->mask > y->mask) - (x->mask < y->mask);
}

static int
overlap_compare(const void *a, const void *b)
{
  const sg_overlap *x = a, *y = b;

  return (x->line > y->line) - (x->line < y->line);
}

bool
sg_hide_sees_through(const sg_hide *hide, int32_t s, int32_t s2)
{
  size_t low = 0, high = hide->throughs;

  while (low < high) {
    size_t middle = low + (high - low) / 2;
    const sg_hide_through *k = &hide->through[middle];
    if (k->s < s || (k->s == s && k->s2 < s2)) {
      low = middle + 1;
    } else {
      high = middle;
    }
  }
  return low < hide->throughs && hide->through[low].s == s &&
         hide->through[low].s2 == s2;
}

/* The masks of one cell, nearest first, up to the line's far end. */
static bool
cell_masks(sg_hide *hide, const sg_scene_line *line, size_t cell,
           sg_hiddens *out, bool *whole)
{
  const sg_scene *scene = hide->scene;
  const sg_grid *grid = &hide->masks;
  double far = sg_larger(scene->at[line->a][2], scene->at[line->b][2]);
  sg_hidden part;

  for (uint32_t i = grid->start[cell]; i < grid->start[cell + 1]; i++) {
    uint32_t m = grid->item[i];
    if (scene->mask[m].low[2] >= far) {
      return true;
    }
    if (hide->mask_seen[m] == hide->question) {
      continue;
    }
    hide->mask_seen[m] = hide->question;
    if (sg_mask_hides(scene, &scene->mask[m], line, &part) &&
        !sg_hide_sees_through(hide, line->s, scene->mask[m].s)) {
      part.mask = m;
      *whole |= part.from == 0.0 && part.to == 1.0;
      if (!add_hidden(out, &part)) {
        return false;
      }
    }
  }
  return true;
}

bool
sg_hide_masks(sg_hide *hide, size_t at, bool enough, sg_hiddens *out)
{
  const sg_scene_line *line = &hide->scene->line[at];
  sg_grid_shape shape;
  sg_grid_rows rows;
  bool whole = false;

  out->n = 0;
  hide->question++;
  line_shape(hide->scene, line, &shape);
  rows = sg_grid_rows_of(&hide->masks, &shape);
  for (unsigned y = rows.y0; y < rows.y1 && !(whole && enough); y++) {
    sg_grid_columns columns = sg_grid_row(&hide->masks, &shape, rows, y);
    for (unsigned x = columns.x0; x < columns.x1 && !(whole && enough); x++) {
      size_t cell = (size_t)y * hide->masks.nx + x;
      if (!cell_masks(hide, line, cell, out, &whole)) {
        return false;
      }
    }
  }
  if (out->n > 1) {
    qsort(out->part, out->n, sizeof *out->part, hidden_compare);
  }
  return true;
}

static bool
cell_overlaps(sg_hide *hide, size_t at, size_t cell, sg_overlaps *out)
{
  const sg_scene *scene = hide->scene;
  const sg_grid *grid = &hide->lines;
  sg_overlap part;

  for (uint32_t i = grid->start[cell]; i < grid->start[cell + 1]; i++) {
    uint32_t other = grid->item[i];
    if (other == at || hide->line_seen[other] == hide->question) {
      continue;
    }
    hide->line_seen[other] = hide->question;
    if (sg_lines_overlap(scene, &scene->line[at], &scene->line[other], &part)) {
      part.line = other;
      if (!add_overlap(out, &part)) {
        return false;
      }
    }
  }
  return true;
}

bool
sg_hide_overlaps(sg_hide *hide, size_t at, sg_overlaps *out)
{
  sg_grid_shape shape;
  sg_grid_rows rows;

  out->n = 0;
  hide->question++;
  shape_of_line(hide->scene, at, &shape);
  rows = sg_grid_rows_of(&hide->lines, &shape);
  for (unsigned y = rows.y0; y < rows.y1; y++) {
    sg_grid_columns columns = sg_grid_row(&hide->lines, &shape, rows, y);
    for (unsigned x = columns.x0; x < columns.x1; x++) {
      if (!cell_overlaps(hide, at, (size_t)y * hide->lines.nx + x, out)) {
        return false;
      }
    }
  }
  if (out->n > 1) {
    qsort(out->part, out->n, sizeof *out->part, overlap_compare);
  }
  return true;
}
