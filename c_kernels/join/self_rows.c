/* self_rows.c -- where segments go through themselves.
 *
 * Layer: rows.
 */
#include "doors/boolean.h"
#include "rows/census_kept_rows.h"
#include "rows/dense_rows.h"
#include "shell_copy.h"

#include <stdlib.h>

/* A segment, of whose equal polygons only the first are asked about: two, and
 * one more than are listed, so that the first meetings listed are those of all.
 */
typedef struct asking {
  const sg_dense *dense;
  size_t s;
  int64_t most;
  sg_shell_copies copies;
  unsigned char *left_out; /* [polygons] of s; null: none */
} asking;

static int64_t
asked_of(const asking *a)
{
  return a->most < 1 ? 2 : a->most + 1;
}

static bool
is_counted(const asking *a, uint32_t p)
{
  return a->copies.any && (int64_t)a->copies.copies[p] > asked_of(a);
}

/* False: no memory. */
static bool
leave_out(sg_call *call, asking *a)
{
  const sg_dense *d = a->dense;
  size_t n = d->polygon_begin[a->s + 1] - d->polygon_begin[a->s];

  if (!a->copies.any) {
    return true;
  }
  a->left_out = sg_call_alloc(call, n + 1);
  for (size_t p = 0; a->left_out && p < n; p++) {
    a->left_out[p] = (int64_t)a->copies.copy[p] >= asked_of(a);
  }
  return a->left_out != NULL;
}

/* How often there is such a meeting, of whichever of equal polygons. */
static size_t
times(const asking *a, const sg_self_meeting *m)
{
  const sg_shell_copies *c = &a->copies;
  size_t times = 1;
  uint32_t p[2];

  for (int k = 0; k < 2; k++) {
    p[k] =
        (uint32_t)a->dense->polygon_of[m->t[k]] - a->dense->polygon_begin[a->s];
  }
  if (c->any && c->kind[p[0]] == c->kind[p[1]] && is_counted(a, p[0])) {
    size_t n = c->copies[p[0]];

    return c->copy[p[0]] == c->copy[p[1]]       ? (c->copy[p[0]] == 0 ? n : 0)
           : c->copy[p[0]] + c->copy[p[1]] == 1 ? n * (n - 1) / 2
                                                : 0;
  }
  for (int k = 0; k < 2; k++) {
    if (is_counted(a, p[k])) {
      times *= c->copy[p[k]] == 0 ? c->copies[p[k]] : 0;
    }
  }
  return times;
}

/* Counts what was found by kind, and lists of each kind the first `most`. */
static bool
list_meetings(sg_call *call, const asking *a, const sg_self_meetings *found,
              sg_self_segment *out)
{
  size_t count[SG_SELF_KINDS] = {0};
  int64_t listed[SG_SELF_KINDS] = {0};
  bool good = true;

  for (size_t i = 0; i < found->n && good; i++) {
    const sg_self_meeting *m = &found->item[i];

    count[m->kind] += times(a, m);
    good = listed[m->kind]++ >= a->most ||
           sg_self_meeting_fact_list_add(call, &out->meetings, *m);
  }
  for (int k = 0; k < SG_SELF_KINDS && good; k++) {
    const sg_self_count of = {(sg_self_kind)k, count[k]};

    good = of.n == 0 || sg_self_count_list_add(call, &out->counts, of);
  }
  return good;
}

static bool
add_segment(sg_call *call, asking *a, sg_self_segment_list *out)
{
  const sg_dense *dense = a->dense;
  sg_self_segment segment = {.s = dense->segment[a->s]};
  sg_pool *pool = sg_call_pool(call);
  sg_self_meetings found = {0};

  if (!pool ||
      !sg_polygon_copies_find(dense, a->s, &call->cancel, &a->copies) ||
      !leave_out(call, a) ||
      !sg_self_cut_some(dense, a->s, a->left_out,
                        sg_self_tolerance(dense, a->s), pool, &call->cancel,
                        &found)) {
    return sg_call_ended(call);
  }
  sg_self_by_polygon(&found);
  bool good = list_meetings(call, a, &found, &segment) &&
              sg_self_segment_list_add(call, out, segment);

  free(found.item);
  return good;
}

bool
sg_door_self_meetings(sg_call *call, int64_t most,
                      sg_self_segment_list *segments)
{
  sg_dense dense;
  bool good = sg_dense_read(call, NULL, 0, &dense);

  for (size_t s = 0; s < dense.segments && good; s++) {
    asking a = {.dense = &dense, .s = s, .most = most};

    good = add_segment(call, &a, segments);
    sg_shell_copies_clear(&a.copies);
  }
  sg_dense_clear(&dense);
  return good;
}

/* ---- one by one ---- */

static bool
list_found(sg_call *call, sg_kept_defects *kept, sg_found_defect_list *out)
{
  sg_self_segment_list segments = {0};
  bool good = sg_door_self_meetings(call, INT32_MAX, &segments);

  (void)kept;
  for (size_t i = 0; good && i < segments.n; i++) {
    const sg_self_segment *of = &segments.at[i];

    for (size_t k = 0; good && k < of->meetings.n; k++) {
      const sg_self_meeting *m = &of->meetings.at[k];

      good = sg_found_defect_list_add(
          call, out, (sg_found_defect){(int)m->kind, of->s, m->p[0], m->p[1]});
    }
  }
  return good;
}

bool
sg_door_self_meeting(sg_call *call, const sg_self_kind *kind, const int32_t *s,
                     const int32_t *p1, sg_self_meeting_rows *rows)
{
  sg_kept_defects *kept =
      sg_kept_defects_hold(call, SG_DEFECTS_OF_JOIN, list_found);
  int of = kind ? (int)*kind : 0;
  sg_count_list places = {0};
  bool good = kept && sg_kept_defects_ask(call, kept, kind ? &of : NULL, s, p1,
                                          &places);

  for (size_t i = 0; good && i < places.n; i++) {
    const sg_found_defect *d = &kept->found[places.at[i]];

    good = sg_self_meeting_rows_add(
        call, rows,
        (sg_self_meeting_row){(sg_self_kind)d->kind, d->s, d->a, d->b});
  }
  sg_kept_defects_drop(kept);
  return good;
}

bool
sg_door_segment_meetings(sg_call *call, int32_t s, int64_t most,
                         sg_self_segment_list *segments)
{
  sg_dense dense;
  bool good = sg_dense_read(call, &s, 1, &dense);

  if (good && dense.segments == 1) {
    asking a = {.dense = &dense, .s = 0, .most = most};

    good = add_segment(call, &a, segments);
    sg_shell_copies_clear(&a.copies);
  }
  sg_dense_clear(&dense);
  return good;
}
