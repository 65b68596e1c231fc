/* stroke_rows.c -- stroke_looks/2, stroke_chains/3 and stroke_octets/3. */
#include "stroke_rows.h"

#include "engine/symbol.h"

/* ---- looks ---- */

bool
sg_door_stroke_looks(sg_call *call, const sg_looking_part_list *parts,
                     sg_look_name_list *out)
{
  size_t at = 0;

  for (size_t i = 0; i < parts->n; i++) {
    const sg_looking_part *part = &parts->at[i];
    const sg_look_name name = {part->visibility, part->role};

    if (at < out->n && out->at[at].visibility == name.visibility &&
        out->at[at].role == name.role) {
      continue;
    }
    for (at = 0; at < out->n && (out->at[at].visibility != name.visibility ||
                                 out->at[at].role != name.role);) {
      at++;
    }
    if (at == out->n && !sg_look_name_list_add(call, out, name)) {
      return false;
    }
  }
  return true;
}

static bool
is_look(const sg_ranked_look *look, int32_t visibility, int32_t role)
{
  return look->visibility == visibility && look->role == role;
}

size_t
sg_looks_find(const sg_ranked_look_list *looks, int32_t visibility,
              int32_t role, size_t last)
{
  if (last < looks->n && is_look(&looks->at[last], visibility, role)) {
    return last;
  }
  for (size_t i = 0; i < looks->n; i++) {
    if (is_look(&looks->at[i], visibility, role)) {
      return i;
    }
  }
  return looks->n;
}

/* The first look with the role of look n. */
static int
role_number(const sg_ranked_look_list *looks, size_t n)
{
  size_t i = 0;

  while (looks->at[i].role != looks->at[n].role) {
    i++;
  }
  return (int)i;
}

/* The looks as the kernel has them; null: refused. */
static sg_stroke_look *
looks_of(sg_call *call, const sg_ranked_look_list *looks)
{
  sg_stroke_look *out = sg_call_alloc(call, looks->n * sizeof *out);

  for (size_t i = 0; out && i < looks->n; i++) {
    out[i] =
        (sg_stroke_look){.rank = looks->at[i].rank,
                         .role = role_number(looks, i),
                         .hidden = looks->at[i].visibility == SG_SYMBOL_HIDDEN};
  }
  return out;
}

/* ---- parts ---- */

bool
sg_sheet_point_at(sg_call *call, const sg_sheet_point *p, int64_t out[2])
{
  const int64_t far = INT64_C(1) << 52;

  out[0] = p->x;
  out[1] = p->y;
  for (int k = 0; k < 2; k++) {
    if (out[k] <= -far || out[k] >= far) {
      return sg_call_domain_of(call, "sheet_coordinate", out[k]);
    }
  }
  return true;
}

bool
sg_parts_add(sg_call *call, const sg_sheet_part_list *parts, int argument,
             const sg_ranked_look_list *looks, sg_stroke_parts *out)
{
  size_t last = 0;

  for (size_t i = 0; i < parts->n; i++) {
    const sg_sheet_part *from = &parts->at[i];
    sg_stroke_part part = {
        .s = from->s, .e = from->e, .from = from->from, .to = from->to};

    last = sg_looks_find(looks, from->visibility, from->role, last);
    if (last == looks->n) {
      return sg_call_domain(call, "look", argument);
    }
    part.look = (uint32_t)last;
    if (!sg_sheet_point_at(call, &from->a, part.a) ||
        !sg_sheet_point_at(call, &from->b, part.b) ||
        !sg_stroke_parts_add(call, out, part)) {
      return false;
    }
  }
  return true;
}

/* ---- strokes ---- */

/* The part of a step, and the point that the step begins at (`end` false) or
 * ends at. */
static const sg_stroke_part *
part_of(const sg_strokes *strokes, int64_t step)
{
  return &strokes->part[(step < 0 ? -step : step) - 1];
}

static sg_sheet_point
step_point(const sg_strokes *strokes, int64_t step, bool end)
{
  const sg_stroke_part *p = part_of(strokes, step);
  const int64_t *at = (step > 0) == end ? p->b : p->a;

  return (sg_sheet_point){at[0], at[1]};
}

static bool
make_stroke(sg_call *call, const sg_ranked_look_list *looks,
            const sg_strokes *strokes, const sg_stroke *stroke,
            sg_sheet_stroke *out)
{
  const int64_t *step = &strokes->step[stroke->first];
  const sg_stroke_part *first = part_of(strokes, *step);
  size_t n = stroke->n;
  int32_t *edge = sg_call_alloc(call, n * sizeof *edge);
  sg_sheet_point *point = sg_call_alloc(call, (n + 1) * sizeof *point);

  if (!edge || !point) {
    return false;
  }
  point[0] = step_point(strokes, *step, false);
  for (size_t i = 0; i < n; i++) {
    edge[i] = part_of(strokes, step[i])->e;
    point[i + 1] = step_point(strokes, step[i], true);
  }
  *out = (sg_sheet_stroke){.visibility = looks->at[first->look].visibility,
                           .role = looks->at[first->look].role,
                           .s = first->s,
                           .edges = {edge, n, n},
                           .points = {point, n + 1, n + 1},
                           .start = stroke->start,
                           .end = stroke->end};
  return true;
}

bool
sg_strokes_of(sg_call *call, const sg_ranked_look_list *looks,
              sg_stroke_parts *parts, sg_sheet_stroke_list *out)
{
  const sg_stroke_look *look = looks_of(call, looks);
  sg_strokes strokes;
  bool memory, good = true;

  if (!look) {
    return false;
  }
  if (!sg_strokes_make(parts->at, parts->n, look, &call->cancel, &strokes,
                       &memory)) {
    return sg_call_ended(call);
  }
  for (size_t i = 0; i < strokes.n && good; i++) {
    sg_sheet_stroke stroke;

    good = make_stroke(call, looks, &strokes, &strokes.item[i], &stroke) &&
           sg_sheet_stroke_list_add(call, out, stroke);
  }
  sg_strokes_clear(&strokes);
  return good;
}

bool
sg_door_stroke_chains(sg_call *call, const sg_sheet_part_list *parts,
                      const sg_ranked_look_list *looks,
                      sg_sheet_stroke_list *out)
{
  sg_stroke_parts all = {0};

  return sg_parts_add(call, parts, 1, looks, &all) &&
         sg_strokes_of(call, looks, &all, out);
}

/* ---- octets ---- */

/* Words of 32 bits under way, the lowest octet of each first. */
typedef struct words {
  sg_call *call;
  uint8_t *at;
  size_t n, room; /* octets */
} words;

static bool
put_word(words *out, int64_t value)
{
  if (value < INT32_MIN || value > INT32_MAX) {
    return sg_call_cannot_hold(out->call, "sheet_coordinate");
  }
  if (out->n == out->room) {
    size_t room = out->room ? 2 * out->room : 4096;
    uint8_t *at = sg_call_realloc(out->call, out->at, room);

    if (!at) {
      return false;
    }
    out->at = at;
    out->room = room;
  }
  for (int k = 0; k < 4; k++) {
    out->at[out->n++] = (uint8_t)((uint32_t)value >> 8 * k);
  }
  return true;
}

static bool
put_stroke(words *out, size_t look, const sg_sheet_stroke *stroke)
{
  bool good =
      put_word(out, (int64_t)look) && put_word(out, stroke->s) &&
      put_word(out, (int64_t)stroke->start + 4 * (int64_t)stroke->end) &&
      put_word(out, (int64_t)stroke->edges.n) &&
      put_word(out, (int64_t)stroke->points.n);

  for (size_t i = 0; i < stroke->edges.n && good; i++) {
    good = put_word(out, stroke->edges.at[i]);
  }
  for (size_t i = 0; i < stroke->points.n && good; i++) {
    good = put_word(out, stroke->points.at[i].x) &&
           put_word(out, stroke->points.at[i].y);
  }
  return good;
}

bool
sg_door_stroke_octets(sg_call *call, const sg_ranked_look_list *looks,
                      const sg_sheet_stroke_list *strokes, sg_bytes *octets)
{
  words out = {.call = call};
  size_t last = 0;

  for (size_t i = 0; i < strokes->n; i++) {
    const sg_sheet_stroke *stroke = &strokes->at[i];

    last = sg_looks_find(looks, stroke->visibility, stroke->role, last);
    if (last == looks->n) {
      return sg_call_domain(call, "look", 1);
    }
    if (!put_stroke(&out, last, stroke)) {
      return false;
    }
  }
  *octets = (sg_bytes){out.at, out.n};
  return true;
}
