/* shading_scene.c -- see shading_scene.h: making a scene. */
#include "number/vector.h"
#include "shading_private.h"

#include <math.h>
#include <stdatomic.h>
#include <stdlib.h>
#include <string.h>

/* ---- places ---- */

bool
sg_shading_seen(const sg_shading *s, const double p[3], double out[3])
{
  double h[4];

  for (int i = 0; i < 4; i++) {
    const double *m = s->frame.matrix[i];
    h[i] = m[0] * p[0] + m[1] * p[1] + m[2] * p[2] + m[3];
  }
  if (!(h[3] > 0)) {
    return false;
  }
  for (int k = 0; k < 3; k++) {
    out[k] = h[k] / h[3];
  }
  return isfinite(out[0]) && isfinite(out[1]) && isfinite(out[2]);
}

void
sg_shading_reach(sg_shading *s, const double at[3], double off)
{
  for (int k = 0; k < 3; k++) {
    s->low[k] = at[k] - off < s->low[k] ? at[k] - off : s->low[k];
    s->high[k] = at[k] + off > s->high[k] ? at[k] + off : s->high[k];
  }
}

/* ---- opening ---- */

/* Without an inverse, of a picture that is flat, nothing is seen anywhere. */
static void
fill_back(sg_shading *s)
{
  double a[4][8] = {{0}};

  for (int i = 0; i < 4; i++) {
    memcpy(a[i], s->frame.matrix[i], sizeof s->frame.matrix[i]);
    a[i][4 + i] = 1.0;
  }
  if (sg_shading_invert(a)) {
    for (int i = 0; i < 4; i++) {
      memcpy(s->back[i], &a[i][4], sizeof s->back[i]);
    }
  }
}

sg_shading *
sg_shading_open(const sg_shading_frame *frame)
{
  static atomic_uint_fast64_t serials;
  sg_shading *s = calloc(1, sizeof *s);

  if (!s) {
    return NULL;
  }
  s->serial = atomic_fetch_add(&serials, 1) + 1;
  s->frame = *frame;
  fill_back(s);
  for (int k = 0; k < 3; k++) {
    s->low[k] = INFINITY;
    s->high[k] = -INFINITY;
  }
  s->middle[0] = frame->width / 2.0;
  s->middle[1] = frame->height / 2.0;
  if (sg_expression_add(&s->expression, 0, SG_UNION, 0) == SIZE_MAX) {
    sg_shading_close(s);
    return NULL;
  }
  return s;
}

void
sg_shading_close(sg_shading *s)
{
  if (s) {
    free(s->leaf.item);
    free(s->surface.item);
    free(s->quadric.item);
    free(s->torus.item);
    free(s->polygon.item);
    free(s->corner.item);
    free(s->exact.item);
    free(s->corner_of.item);
    free(s->body.item);
    free(s->root.item);
    free(s->known.item);
    sg_expression_clear(&s->expression);
    sg_owners_close(s->owners);
    free(s->through);
    free(s->band_first);
    free(s->item);
    free(s);
  }
}

bool
sg_shading_box(const sg_shading *s, double low[3], double high[3])
{
  memcpy(low, s->low, sizeof s->low);
  memcpy(high, s->high, sizeof s->high);
  return s->low[0] <= s->high[0];
}

bool
sg_shading_ask_owners(sg_shading *s)
{
  s->owners = s->owners ? s->owners : sg_owners_open();
  return s->owners;
}

bool
sg_shading_let_through(sg_shading *s, int32_t front, int32_t behind)
{
  size_t n = s->root.n;

  s->through = s->through ? s->through : calloc(n * n + 1, sizeof *s->through);
  for (size_t i = 0; s->through && i < n && front != behind; i++) {
    for (size_t k = 0; k < n && s->root.item[i].segment == front; k++) {
      s->through[i * n + k] =
          s->through[i * n + k] || s->root.item[k].segment == behind;
    }
  }
  return s->through;
}

sg_owners *
sg_shading_owners(const sg_shading *s)
{
  return s->owners;
}

const sg_shading_frame *
sg_shading_frame_of(const sg_shading *s)
{
  return &s->frame;
}

uint32_t
sg_shading_add_leaf(sg_shading *s, int32_t number)
{
  sg_shading_leaf leaf = {
      .number = number, .root = -1, .sign = 1, .node = UINT32_MAX};

  return SG_PUSH(s->leaf, leaf) ? (uint32_t)(s->leaf.n - 1) : UINT32_MAX;
}

/* ---- planes ---- */

uint32_t
sg_shading_add_plane(sg_shading *s, const double q[4])
{
  sg_shading_surface plane = {.of = s->known_now};
  double d = q[3] - sg_dot(q, s->middle), n[3];

  memcpy(plane.q, q, sizeof plane.q);
  for (int k = 0; k < 3; k++) { /* q looks away */
    n[k] = -d * s->frame.matrix[3][k];
    for (int j = 0; j < 3; j++) {
      n[k] -= q[j] * s->frame.matrix[j][k];
    }
  }
  double length = sg_any_length(n);
  for (int k = 0; k < 3; k++) {
    plane.normal[k] = length > 0 ? n[k] / length : 0.0;
  }
  return SG_PUSH(s->surface, plane) ? (uint32_t)(s->surface.n - 1) : UINT32_MAX;
}

/* A plane with this normal, of any length, through `at`, in the picture: its
 * place, UINT32_MAX: no memory. *turned: stored with the opposite normal. */
static uint32_t
add_plane(sg_shading *s, const double normal[3], const double at[3],
          bool *turned)
{
  double length = sg_any_length(normal), from[3], q[4];
  const double *n = normal;

  *turned = n[2] < 0 || (n[2] == 0 && (n[0] < 0 || (n[0] == 0 && n[1] < 0)));
  for (int k = 0; k < 3; k++) {
    q[k] = length > 0 ? n[k] / length * (*turned ? -1 : 1) : 0.0;
  }
  sg_minus(s->middle, at, from);
  q[3] = sg_dot(q, from);
  return sg_shading_add_plane(s, q);
}

/* ---- polygons ---- */

sg_shading_end
sg_shading_add_corner(sg_shading *s, const double p[3], uint32_t *corner)
{
  sg_shading_corner exact = {{0.0, 0.0, 0.0}};

  if (!sg_shading_seen(s, p, exact.at)) {
    return SG_SHADING_BEHIND_EYE;
  }
  sg_shading_reach(s, exact.at, 0);
  const double *at = exact.at;
  sg_shading_corner snapped = {{sg_snapped(at[0]), sg_snapped(at[1]), at[2]}};
  *corner = (uint32_t)s->corner.n;
  return SG_PUSH(s->corner, snapped) && SG_PUSH(s->exact, exact)
             ? SG_SHADING_GOOD
             : SG_SHADING_NO_MEMORY;
}

/* A loop, which adds to the normal (Newell). */
static bool
add_loop(sg_shading *s, const uint32_t *corner, size_t n, double normal[3],
         sg_shading_polygon *polygon)
{
  const double *first = s->exact.item[corner[0]].at, *before = first;
  bool good = true;

  for (size_t i = 0; i < n && good; i++) {
    const double *p = s->exact.item[corner[i]].at;
    double u[3], v[3], area[3], y = s->corner.item[corner[i]].at[1];

    polygon->y1 = y < polygon->y1 ? y : polygon->y1;
    polygon->y2 = y > polygon->y2 ? y : polygon->y2;
    if (i > 1) {
      sg_minus(before, first, u);
      sg_minus(p, first, v);
      sg_cross(u, v, area);
      for (int k = 0; k < 3; k++) {
        normal[k] += area[k];
      }
    }
    before = p;
    good = SG_PUSH(s->corner_of, corner[i]);
  }
  return good && SG_PUSH(s->corner_of, corner[0]);
}

sg_shading_end
sg_shading_add_polygon(sg_shading *s, int32_t face, const uint32_t *corner,
                       const size_t *count, size_t loops)
{
  sg_shading_polygon polygon = {.leaf = (uint32_t)(s->leaf.n - 1),
                                .face = face,
                                .corner = (uint32_t)s->corner_of.n,
                                .y1 = INFINITY,
                                .y2 = -INFINITY};
  const double *origin = NULL;
  double normal[3] = {0, 0, 0};
  bool good = true, turned;

  for (size_t i = 0; i < loops && good; corner += count[i++]) {
    if (count[i] > 0) {
      good = !origin || SG_PUSH(s->corner_of, SG_NO_CORNER);
      origin = origin ? origin : s->exact.item[corner[0]].at;
      good = good && add_loop(s, corner, count[i], normal, &polygon);
    }
  }
  if (good && !(polygon.y1 < polygon.y2)) { /* no line meets it */
    s->corner_of.n = polygon.corner;
    return SG_SHADING_GOOD;
  }
  polygon.corners = (uint32_t)s->corner_of.n - polygon.corner;
  polygon.surface = good ? add_plane(s, normal, origin, &turned) : UINT32_MAX;
  if (polygon.surface == UINT32_MAX) {
    return SG_SHADING_NO_MEMORY;
  }
  polygon.sense = s->surface.item[polygon.surface].q[2] < SG_EDGE_ON ? 0
                  : turned                                           ? 1
                                                                     : -1;
  return SG_PUSH(s->polygon, polygon) ? SG_SHADING_GOOD : SG_SHADING_NO_MEMORY;
}

/* ---- known surfaces ---- */

uint32_t
sg_shading_add_known(sg_shading *s, sg_known_surface_kind kind,
                     const double frame[][3], double a, double b)
{
  sg_known_surface known;

  sg_known_surface_init(&known, kind, frame, a, b);
  return SG_PUSH(s->known, known) ? (uint32_t)s->known.n : 0;
}

void
sg_shading_stand_for(sg_shading *s, uint32_t known)
{
  s->known_now = known;
}

/* ---- roots ---- */

bool
sg_shading_add_root(sg_shading *s, int32_t segment)
{
  s->root_node = s->expression.n;
  return SG_PUSH(s->root, (sg_shading_root){segment, (uint32_t)s->root_node});
}

size_t
sg_shading_add_node(sg_shading *s, size_t parent, sg_operation operation,
                    uint32_t leaf)
{
  bool first = s->expression.n == s->root_node;
  size_t at =
      sg_expression_add(&s->expression, first ? 0 : s->root_node + parent,
                        operation, operation == SG_LEAF ? (int32_t)leaf : 0);

  if (at == SIZE_MAX) {
    return SIZE_MAX;
  }
  if (operation == SG_LEAF) {
    s->leaf.item[leaf].root = (int32_t)s->root.n - 1;
    s->leaf.item[leaf].node = (uint32_t)at;
  }
  return at - s->root_node;
}

/* Under how many right-hand sides of differences a leaf is: odd or even; and
 * whether it is under nothing but unions. */
static void
sign_leaves(sg_shading *s)
{
  const sg_expression_node *node = s->expression.node;

  for (size_t i = 0; i < s->leaf.n; i++) {
    uint32_t at = s->leaf.item[i].node;

    s->leaf.item[i].united = at != UINT32_MAX;
    for (; at != UINT32_MAX && at != 0; at = node[at].parent) {
      s->leaf.item[i].united =
          s->leaf.item[i].united && node[node[at].parent].operation == SG_UNION;
      if (node[node[at].parent].operation == SG_DIFFERENCE && !node[at].first) {
        s->leaf.item[i].sign = -s->leaf.item[i].sign;
      }
    }
  }
}

/* ---- bands ---- */

typedef struct rows {
  uint32_t first, last; /* bands; last < first: none */
} rows;

static rows
bands_of(const sg_shading *s, double y1, double y2)
{
  double most = s->frame.height;

  if (!(y1 < most && y2 > 0 && y1 < y2)) {
    return (rows){1, 0};
  }
  return (rows){(uint32_t)(y1 > 0 ? y1 : 0) / s->band,
                (uint32_t)(y2 < most - 0.5 ? y2 : most - 0.5) / s->band};
}

/* Counts (item null) or writes what lies in each band. How often it did. */
static size_t
fill_band(sg_shading *s, rows r, sg_shading_item item)
{
  for (uint32_t b = r.first; b <= r.last && r.first <= r.last; b++) {
    if (s->item) {
      s->item[s->band_first[b]++] = item;
    } else {
      s->band_first[b + 1]++;
    }
  }
  return r.first <= r.last ? r.last - r.first + 1 : 0;
}

static size_t
fill_bands(sg_shading *s)
{
  size_t times = 0;

  for (uint32_t i = 0; i < s->polygon.n; i++) {
    const sg_shading_polygon *p = &s->polygon.item[i];
    if (s->leaf.item[p->leaf].root >= 0) {
      times +=
          fill_band(s, bands_of(s, p->y1, p->y2), (sg_shading_item){i, false});
    }
  }
  for (uint32_t i = 0; i < s->body.n; i++) {
    double y1 = s->body.item[i].y1, y2 = s->body.item[i].y2;
    uint32_t from = i;

    for (; s->body.item[i].more; i++) {
      y1 = fmin(y1, s->body.item[i + 1].y1);
      y2 = fmax(y2, s->body.item[i + 1].y2);
    }
    if (s->leaf.item[s->body.item[from].leaf].root >= 0) {
      times += fill_band(s, bands_of(s, y1, y2), (sg_shading_item){from, true});
    }
  }
  return times;
}

/* As many rows to a band as keep lists short. False: no memory. */
static bool
size_bands(sg_shading *s)
{
  size_t most = SG_BAND_LISTS * (s->polygon.n + s->body.n), times;

  s->band = 1;
  do {
    s->band *= s->band_first ? 2 : 1;
    s->bands = ((uint32_t)s->frame.height + s->band - 1) / s->band;
    free(s->band_first);
    s->band_first = calloc((size_t)s->bands + 2, sizeof *s->band_first);
    times = s->band_first ? fill_bands(s) : 0;
  } while (times > most && s->band < SG_BAND_MOST);
  return s->band_first;
}

static sg_shading_end
make_bands(sg_shading *s)
{
  if (!size_bands(s)) {
    return SG_SHADING_NO_MEMORY;
  }
  for (uint32_t b = 0; b < s->bands; b++) {
    s->band_first[b + 1] += s->band_first[b];
  }
  s->item = malloc((s->band_first[s->bands] + 1) * sizeof *s->item);
  if (!s->item) {
    return SG_SHADING_NO_MEMORY;
  }
  (void)fill_bands(s);
  for (uint32_t b = s->bands; b > 0; b--) {
    s->band_first[b] = s->band_first[b - 1];
  }
  s->band_first[0] = 0;
  return SG_SHADING_GOOD;
}

/* ---- sealing ---- */

sg_shading_end
sg_shading_seal(sg_shading *s, const sg_cancel *cancel)
{
  sg_shading_end end = sg_shading_merge(s, cancel);

  if (end != SG_SHADING_GOOD) {
    return end;
  }
  if (sg_cancelled(cancel)) {
    return SG_SHADING_STOPPED;
  }
  free(s->exact.item);
  s->exact.item = NULL;
  sign_leaves(s);
  if (!sg_expression_seal(&s->expression)) {
    return SG_SHADING_NO_MEMORY;
  }
  return make_bands(s);
}
