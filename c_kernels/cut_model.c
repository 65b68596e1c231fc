#include "cut_model.h"

#include <stdlib.h>
#include <string.h>

void
sg_cut_model_init(sg_cut_model *model)
{
  memset(model, 0, sizeof *model);
  sg_key_table_init(&model->vertex_number, 2);
  sg_key_table_init(&model->segment_number, 1);
}

void
sg_cut_model_clear(sg_cut_model *model)
{
  for (size_t i = 0; i < model->segments; i++) {
    free(model->segment[i].item);
    sg_bvh_close(model->segment[i].tree);
  }
  free(model->vertex);
  free(model->triangle);
  free(model->edge);
  free(model->segment);
  sg_key_table_clear(&model->vertex_number);
  sg_key_table_clear(&model->segment_number);
  sg_cut_model_init(model);
}

/* Room for one more of `size` bytes in a growing array. */
static void *
room_for_one(void *array, size_t n, size_t *room, size_t size)
{
  if (n < *room) {
    return array;
  }
  size_t more = *room ? 2 * *room : 64;
  void *grown = realloc(array, more * size);

  if (grown) {
    *room = more;
  }
  return grown;
}

bool
sg_cut_model_vertex(sg_cut_model *model, int32_t s, int32_t v,
                    const double at[3])
{
  uint32_t key[2] = {(uint32_t)s, (uint32_t)v};
  void *grown = room_for_one(model->vertex, model->vertices,
                             &model->vertex_room, sizeof *model->vertex);

  if (!grown) {
    return false;
  }
  model->vertex = grown;
  uint32_t *number = sg_key_table_put(&model->vertex_number, key);

  if (!number) {
    return false;
  }
  if (*number == SG_NO_KEY) {
    *number = (uint32_t)model->vertices++;
  }
  model->vertex[*number] = (sg_leaf_vertex){s, v, {at[0], at[1], at[2]}};
  return true;
}

uint32_t
sg_cut_model_find(const sg_cut_model *model, int32_t s, int32_t v)
{
  uint32_t key[2] = {(uint32_t)s, (uint32_t)v};

  return sg_key_table_get(&model->vertex_number, key);
}

/* The segment of this number, made if it is new; null: no memory. */
static sg_leaf_segment *
segment_of(sg_cut_model *model, int32_t s)
{
  uint32_t key = (uint32_t)s;
  void *grown = room_for_one(model->segment, model->segments,
                             &model->segment_room, sizeof *model->segment);

  if (!grown) {
    return NULL;
  }
  model->segment = grown;
  uint32_t *number = sg_key_table_put(&model->segment_number, &key);

  if (!number) {
    return NULL;
  }
  if (*number == SG_NO_KEY) {
    *number = (uint32_t)model->segments;
    model->segment[model->segments++] =
        (sg_leaf_segment){s, false, 0, 0, NULL, NULL};
  }
  return &model->segment[*number];
}

static bool
add_item(sg_cut_model *model, int32_t s, bool curve, size_t item)
{
  sg_leaf_segment *segment = segment_of(model, s);

  if (!segment) {
    return false;
  }
  void *grown = room_for_one(segment->item, segment->n, &segment->room,
                             sizeof *segment->item);

  if (!grown) {
    return false;
  }
  segment->item = grown;
  segment->item[segment->n++] = (uint32_t)item;
  segment->curve = curve;
  return true;
}

static bool
find_all(const sg_cut_model *model, int32_t s, const int32_t *v, int n,
         uint32_t *out)
{
  for (int i = 0; i < n; i++) {
    out[i] = sg_cut_model_find(model, s, v[i]);
    if (out[i] == SG_NO_KEY) {
      return false;
    }
  }
  return true;
}

bool
sg_cut_model_triangle(sg_cut_model *model, int32_t s, int32_t p, int32_t t,
                      const int32_t v[3], bool *known)
{
  sg_leaf_triangle triangle = {s, p, t, {0, 0, 0}};

  *known = find_all(model, s, v, 3, triangle.v);
  if (!*known) {
    return true;
  }
  void *grown = room_for_one(model->triangle, model->triangles,
                             &model->triangle_room, sizeof *model->triangle);

  if (!grown) {
    return false;
  }
  model->triangle = grown;
  model->triangle[model->triangles] = triangle;
  return add_item(model, s, false, model->triangles++);
}

bool
sg_cut_model_edge(sg_cut_model *model, int32_t s, int32_t e, const int32_t v[2],
                  bool *known)
{
  sg_leaf_edge edge = {s, e, {0, 0}};

  *known = find_all(model, s, v, 2, edge.v);
  if (!*known) {
    return true;
  }
  void *grown = room_for_one(model->edge, model->edges, &model->edge_room,
                             sizeof *model->edge);

  if (!grown) {
    return false;
  }
  model->edge = grown;
  model->edge[model->edges] = edge;
  return add_item(model, s, true, model->edges++);
}

static sg_box
box_of(const sg_cut_model *model, const uint32_t *v, int n)
{
  sg_box box = sg_box_none();

  for (int i = 0; i < n; i++) {
    sg_box_add(&box, model->vertex[v[i]].at);
  }
  return box;
}

static bool
plant(const sg_cut_model *model, sg_leaf_segment *segment, const sg_poll *poll)
{
  sg_box *box = malloc((segment->n + 1) * sizeof *box);

  if (!box) {
    return false;
  }
  for (size_t i = 0; i < segment->n; i++) {
    uint32_t item = segment->item[i];

    box[i] = segment->curve ? box_of(model, model->edge[item].v, 2)
                            : box_of(model, model->triangle[item].v, 3);
  }
  sg_bvh_close(segment->tree);
  segment->tree = sg_bvh_open(box, segment->n, poll);
  free(box);
  return segment->tree != NULL;
}

bool
sg_cut_model_plant(sg_cut_model *model, const sg_poll *poll)
{
  for (size_t i = 0; i < model->segments; i++) {
    if (!plant(model, &model->segment[i], poll)) {
      return false;
    }
  }
  return true;
}

const sg_leaf_segment *
sg_cut_model_segment(const sg_cut_model *model, int32_t s)
{
  uint32_t key = (uint32_t)s;
  uint32_t number = sg_key_table_get(&model->segment_number, &key);

  return number == SG_NO_KEY ? NULL : &model->segment[number];
}

void
sg_cut_model_corners(const sg_cut_model *model, uint32_t triangle,
                     double out[3][3])
{
  for (int i = 0; i < 3; i++) {
    memcpy(out[i], model->vertex[model->triangle[triangle].v[i]].at,
           sizeof out[i]);
  }
}

void
sg_candidate_pairs_init(sg_candidate_pairs *walk, const sg_leaf_segment *a,
                        const sg_leaf_segment *b)
{
  walk->a = a;
  walk->b = b;
  sg_bvh_pairs_init(&walk->pairs, a->tree, b->tree);
}

bool
sg_candidate_pairs_next(sg_candidate_pairs *walk, uint32_t *a, uint32_t *b)
{
  size_t i, j;

  if (!sg_bvh_pairs_next(&walk->pairs, &i, &j)) {
    return false;
  }
  *a = walk->a->item[i];
  *b = walk->b->item[j];
  return true;
}
