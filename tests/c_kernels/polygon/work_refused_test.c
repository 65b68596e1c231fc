/* work_refused_test.c -- without memory the scratch relation says so: what it
 * answers all the same is what it answers with memory.
 *
 * covers: work, work_grid, work_tree, work_meeting, work_candidates,
 *         work_change, work_simple, work_near, triangulate, delaunay
 */
#include "tests/memory/refuse.h"
#include "work_scene.h"

#include "polygon/work_private.h"

/* What was answered, in an order, and what edges are left; `said`: that there
 * is no memory. Where edges cross nobody need have looked, or gone on. */
typedef struct answers {
  uint64_t sum, left;
  bool said, crossed;
} answers;

static void
note_in(uint64_t *sum, int64_t x)
{
  *sum = (*sum ^ (uint64_t)x) * 0x100000001b3u + 0x9e3779b9u;
}

static void
note(answers *a, int64_t x)
{
  note_in(&a->sum, x);
}

typedef struct drawn {
  int vertices, edges;
  place at[MOST];
  int end[MOST * 4][2];
} drawn;

static void
draw(drawn *d, int vertices, int grid, int edges)
{
  d->vertices = vertices;
  d->edges = 0;
  for (int i = 0; i < vertices; i++) {
    d->at[i] = (place){pick(grid), pick(grid)};
  }
  for (int i = 0; i < edges; i++) {
    int a = pick(vertices), b = pick(vertices);

    if (!same(d->at[a], d->at[b])) {
      d->end[d->edges][0] = a;
      d->end[d->edges++][1] = b;
    }
  }
}

/* A closed walk round all vertices, ascending round the middle: a star. */
static void
draw_star(drawn *d, int vertices)
{
  d->vertices = d->edges = vertices;
  for (int i = 0; i < vertices; i++) {
    long size = 1000 + pick(9000), half = vertices / 2;
    long along = i < half ? i : vertices - i;

    d->at[i] = (place){(half - 2 * along) * size / half,
                       (i < half ? 1 : -1) * (half - labs(half - 2 * along)) *
                           size / half};
    d->end[i][0] = i;
    d->end[i][1] = (i + 1) % vertices;
  }
}

static sg_work *
open_drawn(const drawn *d, answers *a)
{
  static const double up[3] = {0, 0, 1};
  sg_work *work = sg_work_open(up);

  a->said = !work;
  for (int i = 0; i < d->vertices && !a->said; i++) {
    double p[3] = {(double)d->at[i].x, (double)d->at[i].y, 0};
    sg_point point;

    sg_point_set(&point, p);
    a->said = sg_work_vertex(work, 100 + i, &point) != i;
  }
  for (int i = 0; i < d->edges && !a->said; i++) {
    int32_t e = sg_work_add(work, d->end[i][0], d->end[i][1], 1, i + 1);

    a->said = e == 0;
    note(a, e);
  }
  return work;
}

static void
note_edges(const sg_work *work, answers *a)
{
  for (int32_t e = 0; (e = sg_work_next(work, e)) != 0;) {
    const sg_work_edge *edge = sg_work_get(work, e);

    note_in(&a->left, edge->start);
    note_in(&a->left, edge->end);
    note_in(&a->left, edge->label);
  }
}

/* What meets what, the third vertices of edges, and what crosses, resolved. */
static answers
ask(const drawn *d, double reach)
{
  answers a = {.said = false};
  sg_work *work = open_drawn(d, &a);
  sg_meetings met = {0};

  for (int i = 0; i < 8 && !a.said; i++) {
    int v1 = i * 7 % d->vertices, v2 = (i * 13 + 1) % d->vertices;

    a.said = v1 != v2 && !sg_work_meeting(work, v1, v2, &met);
    for (size_t k = 0; k < met.n && !a.said; k++) {
      note(&a, met.item[k].edge);
      note(&a, met.item[k].how);
      note(&a, met.item[k].inside);
    }
    int any = a.said || v1 == v2 ? 0 : sg_work_meeting_but(work, v1, v2, v1);
    a.said = a.said || any < 0;
    note(&a, any);
  }
  for (int i = 0; i < 4 && i < d->edges && !a.said; i++) {
    sg_candidates walk;
    int32_t v3;

    sg_candidates_open(&walk, work, d->end[i][0], d->end[i][1]);
    while ((v3 = sg_candidates_next(&walk)) >= 0) {
      note(&a, v3);
    }
    a.said = walk.no_memory;
    sg_candidates_close(&walk);
  }
  a.said = a.said || !sg_work_resolve(work, reach);
  if (!a.said) {
    a.crossed = sg_work_crossed(work) != 0;
    note_edges(work, &a);
  }
  sg_meetings_clear(&met);
  if (work) {
    sg_work_close(work);
  }
  return a;
}

static answers
triangulated(const drawn *d, double reach)
{
  answers a = {.said = false};
  sg_work *work = open_drawn(d, &a);
  sg_triangles found = {0};
  int32_t stuck = 0;

  (void)reach;
  sg_outcome outcome =
      a.said ? SG_NO_SPACE : sg_work_triangulate(work, &found, &stuck, NULL);

  a.said = outcome == SG_NO_SPACE;
  note(&a, outcome);
  for (size_t i = 0; i < found.n && !a.said; i++) {
    for (int k = 0; k < 3; k++) {
      note(&a, found.item[i].v[k]);
    }
  }
  free(found.item);
  if (work) {
    sg_work_close(work);
  }
  return a;
}

static bool
is_same(answers a, answers with)
{
  return a.said || (a.sum == with.sum && (with.crossed || a.left == with.left));
}

static void
refused(const drawn *d, answers (*asked)(const drawn *d, double reach),
        double reach)
{
  answers with = asked(d, reach);

  CHECK("there is memory", !with.said);
  CHECK_REFUSED("the same", is_same(asked(d, reach), with));
}

int
main(void)
{
  static drawn d;

  for (int i = 0; i < 10; i++) {
    draw(&d, 10 + 18 * i, 20 << i % 4, 12 + 36 * i);
    refused(&d, ask, 0);
    refused(&d, ask, 1e-9);
  }
  for (int i = 0; i < 6; i++) {
    draw_star(&d, 6 + 38 * i);
    refused(&d, triangulated, 0);
    refused(&d, ask, 0);
    d.at[1] = d.at[d.vertices / 2]; /* two in one place */
    refused(&d, ask, 1e-9);
  }
  return check_report();
}
