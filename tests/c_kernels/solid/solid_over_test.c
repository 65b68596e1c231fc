/* solid_over_test.c -- a solid over its own rows, as they are and changed.
 *
 * The solid is a bar of six unit cubes along x, a face for each square; those
 * of cube i come from leaf i, 1 to 6. So leaves that are next to each other
 * have four vertices in common.
 */
#include "solid_world.h"
#include "tests/check.h"

/* ---- the bar ------------------------------------------------------------ */

static int32_t
leaf_of(const sg_solid *solid, const sg_solid_face *face)
{
  double x = 0; /* six times that of the middle of the face */

  for (uint32_t t = face->first; t < face->first + face->n; t++) {
    for (int k = 0; k < 3; k++) {
      x += solid->vertex[solid->triangle[t][k]].at[0];
    }
  }
  return 1 + (int32_t)fmin(x / 6, LENGTH - 1);
}

static sg_solid
bar(void)
{
  cube_lump lump = {0};

  fill_box(&lump, 0, 0, 0, LENGTH, 1, 1);
  sg_solid solid = lump_solid(&lump, EACH_SQUARE);
  for (size_t f = 0; f < solid.faces; f++) {
    solid.face[f].s = leaf_of(&solid, &solid.face[f]);
  }
  return solid;
}

/* Another vertex than it was, somewhere else. */
static void
move(sg_solid *solid, uint32_t v, double x, double y, double z)
{
  solid->vertex[v] = (sg_solid_vertex){{x, y, z}, 3, 1000 + (int32_t)v};
}

/* Those where cubes 3 and 4 meet, along x. */
static void
move_middle(sg_solid *solid, double x)
{
  for (size_t v = 0; v < solid->vertices; v++) {
    const double *at = solid->vertex[v].at;
    if (at[0] == 3) {
      move(solid, (uint32_t)v, x, at[1], at[2]);
    }
  }
}

/* A triangle of its own for each of a face's, round a new vertex. */
static void
divide(sg_solid *solid, size_t f)
{
  uint32_t v = add_vertex(solid, 2.5, 0.5 + (double)f, 9);
  uint32_t t = solid->face[f].first, old[3];

  memcpy(old, solid->triangle[t], sizeof old);
  solid->triangle[t][2] = v;
  for (int k = 1; k < 3; k++) {
    add_face(solid, 3, 100);
    add_triangle(solid, old[k], old[(k + 1) % 3], v);
  }
}

/* ---- what stays --------------------------------------------------------- */

/* New faces over the rows of the bar. */
typedef struct change {
  world *w;
  sg_solid_old old;
  sg_solid_rows rows;
  sg_solid_over over;
} change;

static void
open_change(change *c, world *w, const sg_solid *solid)
{
  c->w = w;
  CHECK("opened", read_old(w, NULL, &c->old) == SG_OLD_READ &&
                      sg_solid_rows_make(solid, NULL, NULL, &c->rows) &&
                      sg_solid_over_match(&c->rows, &c->old, NULL, &c->over));
}

static void
close_change(change *c)
{
  sg_solid_over_clear(&c->over);
  sg_solid_rows_clear(&c->rows);
  sg_solid_old_clear(&c->old);
}

static size_t
count_gone(const change *c, int relation)
{
  size_t n = 0;

  for (size_t i = 0; i < sg_old_count(&c->old, relation); i++) {
    n += c->over.gone[relation][i];
  }
  return n;
}

/* Of 26 faces, 28 vertices. */
static void
test_stays(void)
{
  static world w;
  sg_solid solid = bar();
  change c;

  write_world(&solid, &w);
  open_change(&c, &w, &solid);
  CHECK("the same faces stay",
        c.over.faces_stay == 26 && count_gone(&c, SG_OLD_P) == 0 &&
            count_gone(&c, SG_OLD_V) == 0 && count_gone(&c, SG_OLD_T) == 0);
  close_change(&c);
  move_middle(&solid, 3.25);
  open_change(&c, &w, &solid);
  CHECK("faces at vertices that moved go",
        c.over.faces_stay == 18 && count_gone(&c, SG_OLD_P) == 8 &&
            count_gone(&c, SG_OLD_PLANE) == 8 &&
            count_gone(&c, SG_OLD_FROM_P) == 8 &&
            count_gone(&c, SG_OLD_T) == 16 && count_gone(&c, SG_OLD_E) == 32);
  CHECK("and these, with their names",
        count_gone(&c, SG_OLD_V) == 4 && count_gone(&c, SG_OLD_FROM_V) == 4);
  close_change(&c);
  sg_solid_clear(&solid);
}

/* Every row of v and of e is named by another row. */
static void
test_missing(void)
{
  static world w;
  sg_solid solid = bar();
  sg_solid_old old;

  for (int relation = SG_OLD_V; relation <= SG_OLD_E; relation++) {
    bool unfit = true;
    write_world(&solid, &w);
    size_t n = w.of[relation].n;
    for (size_t i = 0; i < n; i++) {
      write_world(&solid, &w);
      drop_row(&w, relation, i);
      unfit = read_old(&w, NULL, &old) == SG_OLD_UNFIT && unfit;
      sg_solid_old_clear(&old);
    }
    CHECK("something is missing", unfit && n > 20);
  }
  sg_solid_clear(&solid);
}

/* ---- ids ---------------------------------------------------------------- */

/* The column that names rows. */
static int
id_column(int relation)
{
  return relation == SG_OLD_T ? 2 : 1;
}

/* What stays and what is new have different ids. */
static bool
ids_differ(change *c, int relation)
{
  static bool taken[4 * SG_PAGE_ROWS];
  table *t = &c->w->of[relation];
  const int32_t *id = ints(t, id_column(relation));
  const sg_over_rows *fresh = &c->over.fresh[relation];
  const int32_t *fresh_id = fresh->column[id_column(relation)];
  bool differ = fresh->n > 0;

  memset(taken, 0, sizeof taken);
  for (size_t i = 0; i < t->n; i++) {
    taken[id[i]] = true;
  }
  for (uint32_t i = 0; i < sg_old_count(&c->old, relation); i++) {
    if (c->over.gone[relation][i]) {
      taken[sg_old_int(&c->old, relation, (unsigned)id_column(relation), i)] =
          false;
    }
  }
  for (size_t i = 0; i < fresh->n; i++) {
    differ = differ && fresh_id[i] > 0 && !taken[fresh_id[i]];
    taken[fresh_id[i]] = true;
  }
  return differ;
}

/* More rows than there were. */
static void
test_ids(void)
{
  static const int relation[] = {SG_OLD_V, SG_OLD_E, SG_OLD_P, SG_OLD_T};
  static world w;
  sg_solid solid = bar();
  change c;

  write_world(&solid, &w);
  move_middle(&solid, 3.25);
  for (size_t f = 0; f < 8; f++) {
    divide(&solid, f);
  }
  open_change(&c, &w, &solid);
  CHECK("written",
        sg_solid_over_write(&c.rows, &c.old, S, NULL, NULL, &c.over));
  CHECK("new vertices", c.over.fresh[SG_OLD_V].n == 4 + 8);
  for (size_t k = 0; k < sizeof relation / sizeof *relation; k++) {
    CHECK("an id is of one row", ids_differ(&c, relation[k]));
  }
  close_change(&c);
  sg_solid_clear(&solid);
}

static bool
stop(void *asked)
{
  ++*(int *)asked;
  return true;
}

static void
test_stopped(void)
{
  static world w;
  sg_solid solid = bar();
  int asked = 0;
  sg_cancel cancel = {stop, &asked};
  sg_solid_old old;

  write_world(&solid, &w);
  CHECK("stopped", read_old(&w, &cancel, &old) == SG_OLD_FAILED && asked > 0);
  sg_solid_old_clear(&old);
  sg_solid_clear(&solid);
}

int
main(void)
{
  test_stays();
  test_missing();
  test_ids();
  test_stopped();
  return check_report();
}
