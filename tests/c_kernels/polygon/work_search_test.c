/* work_search_test.c -- the forest finds an edge in the way exactly if there is
 * one, also where most edges hang on a few vertices, and come and go.
 */
#include "polygon/work_private.h"
#include "work_scene.h"

typedef struct asked {
  const scene *s;
  place corner[3];
} asked;

/* Goes on beyond the corners of the triangle. */
static bool
is_in(const asked *a, int32_t e)
{
  const sg_work_edge *edge = sg_work_get(a->s->work, e);

  return meets_beyond_corners(a->s->at[edge->start], a->s->at[edge->end],
                              a->corner);
}

static bool
in_way(void *data, int32_t e)
{
  return is_in(data, e);
}

static bool
any_in_way(const asked *a)
{
  bool any = false;

  for (int32_t e = 0; !any && (e = sg_work_next(a->s->work, e)) != 0;) {
    any = is_in(a, e);
  }
  return any;
}

/* A triangle, counter-clockwise, that has a hub for a corner more often than
 * not. */
static void
pick_triangle(const scene *s, int hubs, int32_t corner[3])
{
  do {
    corner[0] = pick(3) ? pick(hubs) : pick(s->n);
    corner[1] = pick(s->n);
    corner[2] = pick(s->n);
  } while (turn(s->at[corner[0]], s->at[corner[1]], s->at[corner[2]]) <= 0);
}

static void
change(scene *s, int hubs)
{
  for (int i = pick(60); i > 0; i--) {
    int a = pick(4) ? pick(hubs) : pick(s->n), b = pick(s->n);

    sg_work_add(s->work, pick(2) ? a : b, pick(2) ? b : a, 0, 0);
  }
  for (int i = pick(60); i > 0 && sg_work_edges(s->work) > 20; i--) {
    int32_t e = 1 + pick(sg_work_newest(s->work));

    if (sg_work_get(s->work, e)) {
      sg_work_delete(s->work, e);
    }
  }
}

/* How often the forest is wrong; *many counts triangles in whose way nothing
 * was. */
static unsigned
wrong(int vertices, int grid, int hubs, unsigned *many)
{
  unsigned bad = 0;
  scene s;

  open_scene(&s, vertices, grid, 0);
  for (int round = 0; round < 12; round++) {
    change(&s, hubs);
    for (int k = 0; k < 40; k++) {
      int32_t corner[3], found;
      asked a = {.s = &s};

      pick_triangle(&s, hubs, corner);
      for (int i = 0; i < 3; i++) {
        a.corner[i] = s.at[corner[i]];
      }
      if (!sg_work_forest_find(s.work, corner, in_way, &a, &found)) {
        abort();
      }
      bad += (found != 0) != any_in_way(&a) || (found && !is_in(&a, found));
      *many += found == 0;
    }
  }
  sg_work_close(s.work);
  return bad;
}

int
main(void)
{
  unsigned many = 0;

  for (int hubs = 1; hubs <= 4; hubs++) {
    for (int i = 0; i < 40; i++) {
      CHECK("found if there",
            wrong(20 + 40 * (i % 5), 20 << i % 4, hubs, &many) == 0);
    }
  }
  CHECK("often nothing is in the way", many > 1000);
  return check_report();
}
