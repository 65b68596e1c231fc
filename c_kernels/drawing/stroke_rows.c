/* stroke_rows.c -- stroke_looks/2, stroke_chains/3, chain_strokes/4 and
 * stroke_octets/3. */
#include "stroke_rows.h"

#include "engine/symbol.h"

#include <stdlib.h>
#include <string.h>

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
sg_sheet_point_at(sg_call *call, const sg_sheet_point *p, int32_t out[2])
{
  const int64_t at[] = {p->x, p->y};

  for (int k = 0; k < 2; k++) {
    if (at[k] <= INT32_MIN || at[k] > INT32_MAX) {
      return sg_call_domain_of(call, "sheet_coordinate", at[k]);
    }
    out[k] = (int32_t)at[k];
  }
  return true;
}

bool
sg_part_add(sg_call *call, sg_stroke_parts *parts, sg_stroke_part part)
{
  return SG_PUSH(*parts, part) || sg_call_no_memory(call);
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
        !sg_part_add(call, out, part)) {
      return false;
    }
  }
  return true;
}

/* ---- strokes ---- */

void
sg_chains_close(sg_chains *chains)
{
  if (chains) {
    sg_strokes_clear(&chains->strokes);
    free(chains->part);
    free(chains->look);
    free(chains);
  }
}

/* With the looks, which parts say by place; null: no memory, part is freed. */
static sg_chains *
chains_open(const sg_ranked_look_list *looks, sg_stroke_part *part)
{
  sg_chains *chains = calloc(1, sizeof *chains);
  sg_ranked_look *look = malloc((looks->n + 1) * sizeof *look);

  if (!chains || !look) {
    free(chains);
    free(look);
    free(part);
    return NULL;
  }
  for (size_t i = 0; i < looks->n; i++) {
    look[i] = looks->at[i];
  }
  chains->look = look;
  chains->part = part;
  return chains;
}

sg_chains *
sg_chains_of(sg_call *call, bool good, const sg_ranked_look_list *looks,
             sg_stroke_parts *parts)
{
  const sg_stroke_look *look = good ? looks_of(call, looks) : NULL;
  sg_chains *chains;
  bool memory;

  if (!look) {
    free(parts->item);
    return NULL;
  }
  chains = chains_open(looks, parts->item);
  if (!chains) {
    sg_call_no_memory(call);
  } else if (!sg_strokes_make(parts->item, parts->n, look, &call->cancel,
                              &chains->strokes, &memory)) {
    sg_call_ended(call);
    sg_chains_close(chains);
    chains = NULL;
  }
  return chains;
}

/* The part of a step, and the point that the step begins at (`end` false) or
 * ends at. */
static const sg_stroke_part *
part_of(const sg_strokes *strokes, int32_t step)
{
  return &strokes->part[(step < 0 ? -step : step) - 1];
}

static const int32_t *
step_point(const sg_strokes *strokes, int32_t step, bool end)
{
  const sg_stroke_part *p = part_of(strokes, step);

  return (step > 0) == end ? p->b : p->a;
}

const int32_t *
sg_chain_end(const sg_chains *chains, size_t k, bool end)
{
  const sg_stroke *stroke = &chains->strokes.item[k - 1];
  size_t step = stroke->first + (end ? stroke->n - 1 : 0);

  return step_point(&chains->strokes, chains->strokes.step[step], end);
}

bool
sg_chains_have(sg_call *call, const sg_chains *chains, size_t from, size_t to,
               int argument)
{
  return (from > 0 && from <= to && to <= chains->strokes.n) ||
         sg_call_domain(call, "chain", argument);
}

static bool
make_stroke(sg_call *call, const sg_chains *chains, const sg_stroke *stroke,
            sg_sheet_stroke *out)
{
  const sg_strokes *strokes = &chains->strokes;
  const int32_t *step = &strokes->step[stroke->first], *at;
  const sg_stroke_part *first = part_of(strokes, *step);
  size_t n = stroke->n;
  int32_t *edge = sg_call_alloc(call, n * sizeof *edge);
  sg_sheet_point *point = sg_call_alloc(call, (n + 1) * sizeof *point);

  if (!edge || !point) {
    return false;
  }
  at = step_point(strokes, *step, false);
  point[0] = (sg_sheet_point){at[0], at[1]};
  for (size_t i = 0; i < n; i++) {
    edge[i] = part_of(strokes, step[i])->e;
    at = step_point(strokes, step[i], true);
    point[i + 1] = (sg_sheet_point){at[0], at[1]};
  }
  *out = (sg_sheet_stroke){.visibility = chains->look[first->look].visibility,
                           .role = chains->look[first->look].role,
                           .s = first->s,
                           .edges = {edge, n, n},
                           .points = {point, n + 1, n + 1},
                           .start = (sg_stroke_end)stroke->start,
                           .end = (sg_stroke_end)stroke->end};
  return true;
}

bool
sg_door_chain_strokes(sg_call *call, sg_chains *chains, size_t from, size_t to,
                      sg_sheet_stroke_list *out)
{
  bool good = from > to || sg_chains_have(call, chains, from, to, 2);

  for (size_t k = from; k <= to && good; k++) {
    sg_sheet_stroke stroke;

    good = make_stroke(call, chains, &chains->strokes.item[k - 1], &stroke) &&
           sg_sheet_stroke_list_add(call, out, stroke);
  }
  return good;
}

bool
sg_door_stroke_chains(sg_call *call, const sg_sheet_part_list *parts,
                      const sg_ranked_look_list *looks,
                      sg_sheet_stroke_list *out)
{
  sg_stroke_parts all = {0};
  sg_chains *chains = sg_chains_of(
      call, sg_parts_add(call, parts, 1, looks, &all), looks, &all);
  bool good =
      chains && sg_door_chain_strokes(call, chains, 1, chains->strokes.n, out);

  sg_chains_close(chains);
  return good;
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
