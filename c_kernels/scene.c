/* scene.c -- see scene.h */
#include "bounds.h"
#include "scene_private.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>

/* A face is edge-on when its normal leans less than this towards the eye. */
#define EDGE_ON 1e-9

static void
cross_at(const double a[3], const double b[3], const double c[3], double out[3])
{
  double u[3] = {b[0] - a[0], b[1] - a[1], b[2] - a[2]};
  double w[3] = {c[0] - a[0], c[1] - a[1], c[2] - a[2]};

  out[0] = u[1] * w[2] - u[2] * w[1];
  out[1] = u[2] * w[0] - u[0] * w[2];
  out[2] = u[0] * w[1] - u[1] * w[0];
}

static double
dot(const double a[3], const double b[3])
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static double
length(const double a[3])
{
  return sqrt(dot(a, a));
}

static int
facing_of(const double normal[3])
{
  double edge = EDGE_ON * length(normal);

  return (normal[2] > edge) - (normal[2] < -edge);
}

/* ------------------------------------------------------------- places */

/* Centre and scale of the picture: PL-5, by a power of two. */
static double
standard_of(const sg_scene_input *in, double centre[3], double *largest)
{
  double low[3] = {DBL_MAX, DBL_MAX, DBL_MAX};
  double high[3] = {-DBL_MAX, -DBL_MAX, -DBL_MAX};
  double half = 0;
  int power;

  *largest = 0;
  for (size_t i = 0; i < in->vertices; i++) {
    for (int k = 0; k < 3; k++) {
      double x = in->vertex[i].screen[k] * (k == 2 ? in->depth : 1.0);
      low[k] = sg_smaller(low[k], x);
      high[k] = sg_larger(high[k], x);
      *largest = sg_larger(*largest, fabs(x));
    }
  }
  for (int k = 0; k < 3; k++) {
    centre[k] = in->vertices ? low[k] + (high[k] - low[k]) / 2 : 0.0;
    half = in->vertices ? sg_larger(half, (high[k] - low[k]) / 2) : 0.0;
  }
  frexp(half, &power);
  return half > 0 ? ldexp(1.0, power) : 1.0;
}

static bool
make_places(sg_scene_builder *b)
{
  const sg_scene_input *in = b->in;
  sg_scene *scene = b->scene;
  double centre[3], largest;
  double scale = standard_of(in, centre, &largest);

  scene->scale = scale;
  scene->tolerance =
      sg_larger(in->tolerance, 8 * DBL_EPSILON * largest / scale);
  scene->vertices = in->vertices;
  scene->at = malloc((in->vertices + 1) * sizeof *scene->at);
  if (!scene->at) {
    return false;
  }
  for (size_t i = 0; i < in->vertices && !sg_scene_stop(b, i); i++) {
    for (int k = 0; k < 3; k++) {
      double x = in->vertex[i].screen[k] * (k == 2 ? in->depth : 1.0);
      scene->at[i][k] = (x - centre[k]) / scale;
    }
  }
  return true;
}

/* -------------------------------------------------------------- faces */

static int
triangle_compare(const void *a, const void *b)
{
  const sg_scene_triangle *x = a, *y = b;
  int order = sg_key_compare(a, b);

  return order ? order : (x->t > y->t) - (x->t < y->t);
}

/* False: a corner is not among the vertices. */
static bool
corners(sg_scene_builder *b, const sg_scene_triangle *t, uint32_t out[3])
{
  for (int k = 0; k < 3; k++) {
    size_t place = sg_keys_find(&b->vertices, t->s, t->v[k]);
    if (place == SG_NOWHERE) {
      return false;
    }
    out[k] = (uint32_t)place;
  }
  return true;
}

static void
face_add(sg_scene_builder *b, sg_scene_face *f, const uint32_t v[3])
{
  const sg_scene_vertex *vertex = b->in->vertex;
  double(*at)[3] = b->scene->at;
  double n[3];

  cross_at(vertex[v[0]].model, vertex[v[1]].model, vertex[v[2]].model, n);
  for (int k = 0; k < 3; k++) {
    f->model[k] += n[k];
  }
  cross_at(at[v[0]], at[v[1]], at[v[2]], n);
  for (int k = 0; k < 3; k++) {
    f->screen[k] += n[k];
  }
}

static bool
make_faces(sg_scene_builder *b)
{
  const sg_scene_input *in = b->in;
  size_t n = 0;

  b->face = malloc((in->triangles + 1) * sizeof *b->face);
  if (!b->face) {
    return false;
  }
  for (size_t i = 0; i < in->triangles && !sg_scene_stop(b, i); i++) {
    const sg_scene_triangle *t = &in->triangle[i];
    uint32_t v[3];
    if (n == 0 || b->face[n - 1].s != t->s || b->face[n - 1].p != t->p) {
      b->face[n++] = (sg_scene_face){.s = t->s, .p = t->p};
    }
    if (corners(b, t, v)) {
      face_add(b, &b->face[n - 1], v);
    }
  }
  for (size_t i = 0; i < n; i++) {
    b->face[i].facing = facing_of(b->face[i].screen);
  }
  b->faces = (sg_keys){b->face, sizeof *b->face, n, 0};
  return true;
}

/* -------------------------------------------------------------- solids */

static sg_scene_segment *
segment_of(sg_scene_builder *b, int32_t s)
{
  size_t place = sg_keys_find(&b->segments, s, 0);

  return place == SG_NOWHERE ? NULL : &b->in->segment[place];
}

static bool
is_solid(sg_scene_builder *b, int32_t s)
{
  const sg_scene_segment *segment = segment_of(b, s);

  return segment && segment->solid;
}

/* Six times the volume below a triangle, seen from `from`. */
static double
volume_below(const double from[3], const double a[3], const double c[3],
             const double d[3])
{
  double n[3], u[3] = {a[0] - from[0], a[1] - from[1], a[2] - from[2]};

  cross_at(a, c, d, n);
  return dot(u, n);
}

/* A segment of kind solid that is inside out is none. */
static void
check_volumes(sg_scene_builder *b)
{
  const sg_scene_input *in = b->in;
  const double *from = NULL;
  double volume = 0.0;
  uint32_t v[3];

  for (size_t i = 0; i < in->triangles && !sg_scene_stop(b, i); i++) {
    const sg_scene_triangle *t = &in->triangle[i];
    if (!corners(b, t, v)) {
      continue;
    }
    if (!from) {
      from = in->vertex[v[0]].model;
    }
    volume += volume_below(from, in->vertex[v[0]].model, in->vertex[v[1]].model,
                           in->vertex[v[2]].model);
    if (i + 1 == in->triangles || in->triangle[i + 1].s != t->s) {
      sg_scene_segment *segment = segment_of(b, t->s);
      if (segment && volume <= 0.0) {
        segment->solid = false;
      }
      from = NULL;
      volume = 0.0;
    }
  }
}

/* Nor is one that has a border. */
static void
check_solids(sg_scene_builder *b)
{
  sg_scene *scene = b->scene;

  check_volumes(b);
  for (size_t k = 0; k < scene->lines; k++) {
    sg_scene_segment *segment = segment_of(b, scene->line[k].s);
    if (segment && scene->line[k].look.faces == 1) {
      segment->solid = false;
    }
  }
  for (size_t k = 0; k < scene->lines; k++) {
    scene->line[k].look.solid = is_solid(b, scene->line[k].s);
  }
}

/* -------------------------------------------------------------- masks */

static int
mask_compare(const void *a, const void *b)
{
  const sg_scene_mask *x = a, *y = b;

  if (x->low[2] != y->low[2]) {
    return x->low[2] < y->low[2] ? -1 : 1;
  }
  if (x->s != y->s) {
    return x->s < y->s ? -1 : 1;
  }
  return (x->t > y->t) - (x->t < y->t);
}

/* Steps 1 and 2: false for a triangle seen edge-on and for the back of a
 * solid; the back of a surface is turned over. */
static bool
mask_of(sg_scene_builder *b, const sg_scene_triangle *t, sg_scene_mask *out)
{
  double(*at)[3] = b->scene->at;
  double n[3], size;
  uint32_t v[3];
  int facing;

  if (!corners(b, t, v)) {
    return false;
  }
  cross_at(at[v[0]], at[v[1]], at[v[2]], n);
  facing = facing_of(n);
  if (facing == 0 || (facing < 0 && is_solid(b, t->s))) {
    return false;
  }
  size = length(n) * facing;
  *out = (sg_scene_mask){
      .s = t->s,
      .t = t->t,
      .v = {v[0], v[facing > 0 ? 1 : 2], v[facing > 0 ? 2 : 1]}};
  for (int k = 0; k < 3; k++) {
    out->normal[k] = n[k] / size;
    out->low[k] = sg_smaller(at[v[0]][k], sg_smaller(at[v[1]][k], at[v[2]][k]));
    out->high[k] = sg_larger(at[v[0]][k], sg_larger(at[v[1]][k], at[v[2]][k]));
  }
  return true;
}

static bool
make_masks(sg_scene_builder *b)
{
  const sg_scene_input *in = b->in;
  sg_scene *scene = b->scene;

  check_solids(b);
  scene->mask = malloc((in->triangles + 1) * sizeof *scene->mask);
  if (!scene->mask) {
    return false;
  }
  for (size_t i = 0; i < in->triangles && !sg_scene_stop(b, i); i++) {
    scene->masks += mask_of(b, &in->triangle[i], &scene->mask[scene->masks]);
  }
  return sg_scene_sort(b, scene->mask, scene->masks, sizeof *scene->mask,
                       mask_compare);
}

/* -------------------------------------------------------------- scene */

static bool
sort_input(sg_scene_builder *b)
{
  sg_scene_input *in = b->in;

  b->segments = (sg_keys){in->segment, sizeof *in->segment, in->segments, 0};
  b->vertices = (sg_keys){in->vertex, sizeof *in->vertex, in->vertices, 0};
  b->edges = (sg_keys){in->edge, sizeof *in->edge, in->edges, 0};
  return sg_scene_sort(b, in->segment, in->segments, sizeof *in->segment,
                       sg_key_compare) &&
         sg_scene_sort(b, in->vertex, in->vertices, sizeof *in->vertex,
                       sg_key_compare) &&
         sg_scene_sort(b, in->edge, in->edges, sizeof *in->edge,
                       sg_key_compare) &&
         sg_scene_sort(b, in->triangle, in->triangles, sizeof *in->triangle,
                       triangle_compare);
}

sg_scene *
sg_scene_open(sg_scene_input *input, const sg_poll *poll, bool *memory)
{
  sg_scene_builder b = {
      .in = input, .poll = poll, .scene = calloc(1, sizeof(sg_scene))};

  *memory = b.scene != NULL;
  if (!b.scene) {
    return NULL;
  }
  *memory = sort_input(&b) && make_places(&b) && make_faces(&b) &&
            sg_scene_make_lines(&b) && sg_scene_make_looks(&b) &&
            make_masks(&b);
  free(b.face);
  free(b.pair);
  free(b.line_of);
  free(b.use_at);
  free(b.user);
  if (!*memory || b.stopped) {
    sg_scene_close(b.scene);
    return NULL;
  }
  return b.scene;
}

void
sg_scene_close(sg_scene *scene)
{
  if (scene) {
    free(scene->at);
    free(scene->line);
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
