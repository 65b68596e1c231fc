/* scene.c -- see scene.h. What the eye changes: places, the side of each
 * polygon that is seen, how lines look, and the triangles that hide.
 */
#include "scene.h"

#include "crease.h"
#include "engine/list.h"
#include "line_cells.h"
#include "number/bounds.h"
#include "picture_points.h"
#include "rows/keys.h"
#include "rows/sort.h"
#include "scene_divided.h"
#include "scene_facing.h"
#include "scene_private.h"
#include "scene_standard.h"
#include "smooth.h"

#include <float.h>
#include <stdlib.h>
#include <string.h>

/* With fewer masks to a line it takes longer to find those that are near one
 * than to take them all. */
enum { MASKS_A_LINE = 8 };

/* The square of no side of a triangle is so large: x and y are from -1 to 1. */
#define LONGEST 16.0

typedef struct viewing {
  const sg_scene_input *in;
  const sg_scene_model *model;
  const sg_cancel *cancel;
  sg_scene *scene;
  sg_facing_index facings;
  sg_divided divided;
  int8_t *facing; /* [polygons] 1 towards the eye, -1 away, 0 edge-on */
  uint64_t *key;  /* [masks] of what hides: order, then the place of a triangle,
                     or behind all these that of a part */
  bool stopped;
} viewing;

static bool
stop(viewing *w, size_t i)
{
  return i % SG_SCENE_ASK == 0 && (w->stopped |= sg_cancelled(w->cancel));
}

/* 1: the triangle is seen from outside, -1: from inside, 0: edge-on, no wider
 * in the picture than one place. n: its normal, twice its size. */
static int
facing_of(const viewing *w, const int32_t v[3], const double n[3])
{
  double longest = 0.0, close = w->scene->close;

  if (n[2] * n[2] > close * close * LONGEST) {
    return n[2] > 0.0 ? 1 : -1;
  }
  for (int k = 0; k < 3; k++) {
    const double *p = w->scene->at[v[k]], *q = w->scene->at[v[(k + 1) % 3]];
    double x = q[0] - p[0], y = q[1] - p[1];
    longest = sg_larger(longest, x * x + y * y);
  }
  return n[2] * n[2] <= close * close * longest ? 0 : n[2] > 0.0 ? 1 : -1;
}

static bool
is_shown(const viewing *w, uint32_t vertex)
{
  return !w->in->shown || w->in->shown[vertex];
}

/* Whether all corners of a triangle have a place. */
static bool
is_whole(const viewing *w, const int32_t v[3])
{
  return !w->in->shown ||
         (w->in->shown[v[0]] && w->in->shown[v[1]] && w->in->shown[v[2]]);
}

/* ------------------------------------------------------------- places */

static void
place(const viewing *w, const double at[3], const double centre[3],
      double out[3])
{
  for (int k = 0; k < 3; k++) {
    out[k] =
        (at[k] * (k == 2 ? w->in->depth : 1.0) - centre[k]) / w->scene->scale;
  }
}

/* Vertices that are one point are where the first of them is that has a
 * place. */
static void
join_places(viewing *w)
{
  const uint32_t *same = w->model->same;
  size_t vertices = w->model->dense.vertices;
  double(*at)[3] = w->scene->at;

  for (size_t i = vertices; i-- > 0;) {
    if (is_shown(w, (uint32_t)i) && !is_shown(w, same[i])) {
      memcpy(at[same[i]], at[i], sizeof at[i]);
    }
  }
  for (size_t i = 0; i < vertices; i++) {
    if (same[i] != i) {
      memcpy(at[i], at[same[i]], sizeof at[i]);
    }
  }
}

static bool
make_places(viewing *w)
{
  const sg_scene_input *in = w->in;
  sg_scene *scene = w->scene;
  size_t vertices = w->model->dense.vertices;
  sg_scene_standard to = sg_scene_standard_of(in);

  scene->scale = to.scale;
  scene->tolerance =
      sg_larger(in->tolerance, 8 * DBL_EPSILON * to.largest / to.scale);
  scene->close = sg_larger(SG_ONE_PLACE * to.side / to.scale, scene->tolerance);
  scene->near = SG_NEAR * to.side / to.scale;
  scene->vertices = vertices + 2 * in->addeds;
  scene->at = calloc(scene->vertices + 1, sizeof *scene->at);
  for (size_t i = 0; scene->at && i < scene->vertices && !stop(w, i); i++) {
    size_t added = i - vertices; /* or meaningless */
    if (i >= vertices) {
      place(w, in->added[added / 2].screen[added % 2], to.centre, scene->at[i]);
    } else if (is_shown(w, (uint32_t)i)) {
      place(w, in->screen[i], to.centre, scene->at[i]);
    }
  }
  if (scene->at) {
    join_places(w);
  }
  return scene->at != NULL;
}

/* ------------------------------------------------- faces and triangles */

/* Keys that have the order of floats as integers. */
static uint32_t
order_of(double x)
{
  float rounded = (float)x;
  uint32_t bits;

  memcpy(&bits, &rounded, sizeof bits);
  bits = bits >> 31 ? ~bits : bits | UINT32_C(1) << 31;
  return (double)rounded > x ? bits - 1 : bits; /* down */
}

/* Steps 1 and 2 of PL-13: triangles seen edge-on hide nothing, nor do backs of
 * solids. place: what its key says. */
static void
look_at_triangle(viewing *w, size_t place, const int32_t v[3], bool solid,
                 int facing)
{
  double(*at)[3] = w->scene->at;

  if (facing > 0 || (facing < 0 && !solid)) {
    double near = sg_smaller(at[v[0]][2], sg_smaller(at[v[1]][2], at[v[2]][2]));
    w->key[w->scene->masks++] =
        (uint64_t)order_of(near) << 32 | (uint32_t)place;
  }
}

/* The same of the parts of triangles that outlines divide. */
static void
look_at_parts(viewing *w)
{
  const sg_dense *d = &w->model->dense;
  double(*at)[3] = w->scene->at;

  for (size_t i = 0; i < w->divided.n; i++) {
    const sg_divided_part *part = &w->divided.part[i];
    const int32_t *v = part->v;
    size_t s = sg_dense_segment_of(d, d->triangle_begin, part->of);
    bool solid = w->model->solid[s];
    double n[3];
    sg_cross_at(at[v[0]], at[v[1]], at[v[2]], n);
    look_at_triangle(w, d->triangles + i, v, solid, facing_of(w, v, n));
  }
}

/* Which polygons are seen from outside, and which triangles hide. A polygon is
 * seen edge-on when all its triangles are. */
static bool
look_at_faces(viewing *w)
{
  const sg_dense *d = &w->model->dense;
  double(*at)[3] = w->scene->at;
  double *area = calloc(d->polygons + 1, sizeof *area);
  size_t s = 0;
  bool done;

  w->facing = calloc(d->polygons + 1, 1);
  w->key = sg_list_room(d->triangles + w->divided.n, sizeof *w->key);
  for (size_t i = 0; area && w->facing && w->key && i < d->triangles; i++) {
    const int32_t *v = d->corner[i];
    int32_t p = d->polygon_of[i];
    double n[3];

    while (i >= d->triangle_begin[s + 1]) {
      s++;
    }
    if (stop(w, i)) {
      break;
    }
    if (is_whole(w, v)) {
      sg_cross_at(at[v[0]], at[v[1]], at[v[2]], n);
      int facing = facing_of(w, v, n);
      area[p] += n[2];
      w->facing[p] |= facing != 0;
      if (!sg_divided_has(&w->divided, i)) {
        look_at_triangle(w, i, v, w->model->solid[s], facing);
      }
    }
  }
  for (size_t p = 0; area && w->facing && p < d->polygons; p++) {
    w->facing[p] = (int8_t)(area[p] < 0.0 ? -w->facing[p] : w->facing[p]);
  }
  done = area && w->facing && w->key;
  if (done) {
    look_at_parts(w);
  }
  free(area);
  return done;
}

/* -------------------------------------------------------------- masks */

/* The corners of what hides, of those that are one point the first. Gives the
 * triangle that it is, or is a part of. */
static uint32_t
corners_of(const viewing *w, uint32_t place, uint32_t v[3])
{
  const sg_dense *d = &w->model->dense;
  bool whole = place < d->triangles;
  const sg_divided_part *part =
      whole ? NULL : &w->divided.part[place - d->triangles];
  const int32_t *c = whole ? d->corner[place] : part->v;

  for (int k = 0; k < 3; k++) {
    v[k] = whole ? w->model->same[c[k]] : (uint32_t)c[k];
  }
  return whole ? place : part->of;
}

/* What hides as a mask; the back of a surface is turned over. */
static sg_scene_mask
mask_of(const viewing *w, uint32_t place)
{
  const sg_dense *d = &w->model->dense;
  double(*at)[3] = w->scene->at;
  uint32_t v[3], triangle = corners_of(w, place, v);
  sg_scene_mask mask = {
      .s = d->segment[sg_dense_segment_of(d, d->triangle_begin, triangle)],
      .t = d->triangle_id[triangle],
      .triangle = (int32_t)triangle};
  double n[3], size;
  bool front;

  sg_cross_at(at[v[0]], at[v[1]], at[v[2]], n);
  front = n[2] > 0.0;
  size = front ? sg_length(n) : -sg_length(n);
  mask.v[0] = v[0];
  mask.v[1] = v[front ? 1 : 2];
  mask.v[2] = v[front ? 2 : 1];
  for (int k = 0; k < 3; k++) {
    double x = at[v[0]][k], y = at[v[1]][k], z = at[v[2]][k];
    mask.normal[k] = n[k] / size;
    mask.low[k] = sg_smaller(x, sg_smaller(y, z));
    mask.high[k] = sg_larger(x, sg_larger(y, z));
  }
  return mask;
}

/* The triangles are anywhere in memory: those that come soon are fetched. */
static void
fetch_soon(const viewing *w, size_t i)
{
  enum { CORNERS = 16, PLACES = 8 };
  const sg_dense *d = &w->model->dense;

  if (i + CORNERS < w->scene->masks) {
    uint32_t place = (uint32_t)w->key[i + CORNERS];
    __builtin_prefetch(&d->corner[place < d->triangles ? place : 0]);
    place = (uint32_t)w->key[i + PLACES];
    for (int k = 0; k < 3 && place < d->triangles; k++) {
      __builtin_prefetch(w->scene->at[d->corner[place][k]]);
    }
  }
}

/* Whether what hides comes near a line in the picture. */
static bool
is_near_line(const viewing *w, const sg_line_cells *cells, uint32_t place)
{
  sg_grid_box box;
  uint32_t v[3];

  corners_of(w, place, v);
  const double *a = w->scene->at[v[0]], *b = w->scene->at[v[1]],
               *c = w->scene->at[v[2]];

  for (int k = 0; k < 2; k++) {
    box.low[k] = sg_smaller(a[k], sg_smaller(b[k], c[k]));
    box.high[k] = sg_larger(a[k], sg_larger(b[k], c[k]));
  }
  return sg_line_cells_near(cells, &box);
}

/* Of few lines, only what comes near one is kept. */
static void
leave_out_far(viewing *w)
{
  sg_scene *scene = w->scene;
  sg_line_cells cells;
  size_t kept = 0;

  if (!w->in->only || scene->lines > scene->masks / MASKS_A_LINE) {
    return;
  }
  sg_line_cells_init(&cells, scene);
  for (size_t i = 0; i < scene->masks && !stop(w, i); i++) {
    w->key[kept] = w->key[i];
    kept += is_near_line(w, &cells, (uint32_t)w->key[i]);
  }
  scene->masks = kept;
}

static bool
make_masks(viewing *w)
{
  sg_scene *scene = w->scene;

  leave_out_far(w);

  scene->mask = sg_list_room(scene->masks, sizeof *scene->mask);
  if (!scene->mask || !sg_sort_upper(w->key, scene->masks)) {
    return false;
  }
  for (size_t i = 0; i < scene->masks && !stop(w, i); i++) {
    fetch_soon(w, i);
    scene->mask[i] = mask_of(w, (uint32_t)w->key[i]);
  }
  return true;
}

/* -------------------------------------------------------------- lines */

/* How the u-th use of a line lies to the eye: as its polygon; if that is not
 * flat, as the triangle that has the line. */
static int
facing_of_use(const viewing *w, uint32_t u)
{
  const sg_scene_model *m = w->model;
  int32_t i = m->use_triangle ? m->use_triangle[u] : -1;
  double(*at)[3] = w->scene->at;
  double n[3];

  if (i < 0) {
    return w->facing[m->use[u].polygon];
  }
  const int32_t *v = m->dense.corner[i];
  if (!is_whole(w, v)) {
    return 0;
  }
  sg_cross_at(at[v[0]], at[v[1]], at[v[2]], n);
  return facing_of(w, v, n);
}

/* The same, or, of a solid with a facing there, as its surface: turned to the
 * eye if it shows some of the line. */
static int
facing_at_line(const viewing *w, uint32_t u, const sg_facings *facings)
{
  const sg_dense *d = &w->model->dense;
  int32_t polygon = w->model->use[u].polygon;

  for (size_t i = 0; i < facings->n; i++) {
    const sg_scene_facing *facing = facings->item[i].facing;
    size_t s =
        sg_dense_segment_of(d, d->triangle_begin, (uint32_t)facing->triangle);
    if (d->polygon_of[facing->triangle] == polygon && w->model->solid[s]) {
      return facing->from > 0.0 || facing->to < 1.0 ? 1 : -1;
    }
  }
  return facing_of_use(w, u);
}

static void
look_at_line(const viewing *w, size_t k, const sg_facings *facings,
             sg_look *look)
{
  const sg_scene_model *m = w->model;

  for (uint32_t u = m->use_begin[k]; u < m->use_begin[k + 1]; u++) {
    int facing = facing_at_line(w, u, facings);
    int side = facing * m->use[u].along;
    look->towards += facing > 0;
    look->away += facing < 0;
    look->left += side > 0;
    look->right += side < 0;
  }
}

/* Whether line k lies inside a curved sheet. */
static bool
is_inside(const viewing *w, size_t k, const sg_look *look)
{
  const sg_scene_model *m = w->model;
  const sg_scene_use *use = m->use + m->use_begin[k];

  return w->in->curved && m->use_begin[k + 1] - m->use_begin[k] == 2 &&
         use[0].along != use[1].along && w->in->curved[use[0].polygon] &&
         w->in->curved[use[1].polygon] && !look->edge &&
         look->bend <= w->in->crease + SG_SMOOTH_OVER;
}

static int
compare_added(const void *a, const void *b)
{
  return sg_key_compare(*(const sg_scene_added *const *)a,
                        *(const sg_scene_added *const *)b);
}

/* What the line that is entered next lies on. */
static void
enter_lies(sg_scene *scene, const int32_t *triangle, size_t n)
{
  uint32_t *end = &scene->lies_begin[scene->lines + 1];

  for (size_t i = 0; i < n; i++) {
    scene->lies_on[(*end)++] = triangle[i];
  }
}

static void
enter_fold(sg_scene *scene, sg_scene_fold fold)
{
  if (fold.from < fold.to) {
    scene->fold[scene->fold_begin[scene->lines + 1]++] = fold;
  }
}

/* What the next line lies on, and its folds, come after those of the others. */
static void
begin_line(sg_scene *scene)
{
  size_t k = scene->lines;

  if (scene->lies_begin) {
    scene->lies_begin[k + 1] = scene->lies_begin[k];
    scene->fold_begin[k + 1] = scene->fold_begin[k];
  }
}

static bool
is_wanted(const viewing *w, const sg_look *look)
{
  const sg_lines_drawn *only = w->in->only;

  return !only || sg_role_drawn(sg_look_role(look, only->crease), only->which);
}

static void
enter_added(const viewing *w, const sg_scene_added *added)
{
  sg_scene *scene = w->scene;
  uint32_t a =
      (uint32_t)(w->model->dense.vertices + 2 * (size_t)(added - w->in->added));

  if (!is_wanted(w, &added->look)) {
    return;
  }
  begin_line(scene);
  enter_lies(scene, added->lies_on, added->triangles);
  enter_fold(scene, (sg_scene_fold){added->s, 1.0 - added->folded, 1.0});
  scene->line[scene->lines++] = (sg_scene_line){.s = added->s,
                                                .e = added->e,
                                                .a = a,
                                                .b = a + 1,
                                                .number = UINT32_MAX,
                                                .look = added->look};
}

/* How line k of the model looks: made in its place, as a copy of what has just
 * been written by parts waits for all of them. */
static void
look_of(const viewing *w, size_t k, const sg_facings *facings, sg_look *look)
{
  const sg_model_line *line = &w->model->line[k];

  memset(look, 0, sizeof *look);
  look->faces = line->faces;
  look->bend = sg_scene_bend(w->model, w->in->faceted, k);
  look->edge = line->edge;
  look->solid = line->solid;
  look->cut = line->cut;
  look_at_line(w, k, facings, look);
  if (w->in->creases) {
    look->edge |= w->in->creases[k] == SG_CREASE_ON;
    look->speck = w->in->creases[k] == SG_CREASE_SPECK;
  }
  look->inside = is_inside(w, k, look);
}

static void
enter_line(const viewing *w, size_t k)
{
  sg_scene *scene = w->scene;
  const sg_model_line *line = &w->model->line[k];
  sg_facings facings = sg_facing_index_find(&w->facings, line->a, line->b);
  sg_look look;

  look_of(w, k, &facings, &look);
  if (!is_wanted(w, &look)) {
    return;
  }
  begin_line(scene);
  for (size_t i = 0; i < facings.n; i++) {
    const sg_scene_facing *facing = facings.item[i].facing;
    enter_lies(scene, facing->lies_on, facing->triangles);
    enter_fold(scene, sg_facing_fold(&w->facings, facing, line->a));
  }
  scene->line[scene->lines++] = (sg_scene_line){.s = line->s,
                                                .e = line->e,
                                                .a = w->model->same[line->a],
                                                .b = w->model->same[line->b],
                                                .number = (uint32_t)k,
                                                .look = look};
}

/* Lines of the model and added ones, merged by segment and id. */
static void
merge_lines(viewing *w, const sg_scene_added **added)
{
  const sg_scene_model *m = w->model;
  size_t i = 0;

  for (size_t k = 0; k <= m->lines && !stop(w, k); k++) {
    for (; i < w->in->addeds &&
           (k == m->lines || sg_key_compare(added[i], &m->line[k]) < 0);
         i++) {
      enter_added(w, added[i]);
    }
    if (k < m->lines && is_shown(w, m->line[k].a) &&
        is_shown(w, m->line[k].b)) {
      enter_line(w, k);
    }
  }
}

/* How much is said of the lines: what they lie on, and folds. */
static void
count_said(const viewing *w, size_t *lies, size_t *folds)
{
  const sg_scene_model *m = w->model;

  *lies = 0;
  *folds = w->in->addeds;
  for (size_t i = 0; i < w->in->addeds; i++) {
    *lies += w->in->added[i].triangles;
  }
  for (size_t k = 0; w->facings.n > 0 && k < m->lines; k++) {
    sg_facings facings =
        sg_facing_index_find(&w->facings, m->line[k].a, m->line[k].b);
    *lies += sg_facings_lies(&facings);
    *folds += facings.n;
  }
}

/* Room for all lines, and for what is said of them. */
static bool
line_room(viewing *w)
{
  size_t most = w->model->lines + w->in->addeds, lies, folds;
  sg_scene *scene = w->scene;

  scene->line = sg_list_room(most, sizeof *scene->line);
  if (w->in->addeds == 0 && w->facings.n == 0) {
    return scene->line != NULL;
  }
  count_said(w, &lies, &folds);
  scene->lies_begin = calloc(most + 1, sizeof *scene->lies_begin);
  scene->lies_on = malloc((lies + 1) * sizeof *scene->lies_on);
  scene->fold_begin = calloc(most + 1, sizeof *scene->fold_begin);
  scene->fold = malloc((folds + 1) * sizeof *scene->fold);
  return scene->line && scene->lies_begin && scene->lies_on &&
         scene->fold_begin && scene->fold;
}

static bool
make_lines(viewing *w)
{
  size_t n = w->in->addeds;
  const sg_scene_added **added = malloc((n + 1) * sizeof(sg_scene_added *));
  bool good = added && sg_facing_index_init(&w->facings, w->in) && line_room(w);

  for (size_t i = 0; good && i < n; i++) {
    added[i] = &w->in->added[i];
  }
  if (good) {
    qsort(added, n, sizeof *added, compare_added);
    merge_lines(w, added);
  }
  free(added);
  sg_facing_index_clear(&w->facings);
  return good;
}

/* -------------------------------------------------------------- scene */

sg_scene *
sg_scene_open(const sg_scene_input *input, const sg_cancel *cancel,
              bool *memory)
{
  viewing w = {.in = input,
               .model = input->model,
               .cancel = cancel,
               .scene = calloc(1, sizeof(sg_scene))};

  *memory = w.scene && sg_divided_init(&w.divided, input) && make_places(&w) &&
            look_at_faces(&w) && make_lines(&w) && make_masks(&w);
  sg_divided_clear(&w.divided);
  free(w.facing);
  free(w.key);
  if (w.scene) {
    w.scene->model = input->model;
  }
  if (!*memory || w.stopped) {
    sg_scene_close(w.scene);
    return NULL;
  }
  return w.scene;
}

void
sg_scene_close(sg_scene *scene)
{
  if (scene) {
    free(scene->at);
    free(scene->line);
    free(scene->lies_begin);
    free(scene->lies_on);
    free(scene->fold_begin);
    free(scene->fold);
    free(scene->mask);
    free(scene);
  }
}

size_t
sg_scene_find(const sg_scene *scene, int32_t s, int32_t e)
{
  sg_keys keys = {scene->line, sizeof *scene->line, scene->lines, 0};

  return sg_keys_find(&keys, s, e);
}

bool
sg_look_is_back(const sg_look *look)
{
  return look->solid && look->away > 0 && look->towards == 0;
}
