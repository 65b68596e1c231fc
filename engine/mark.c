/* mark.c -- what edits of a version may have broken, to be looked at later.
 *
 * A version that is known to be whole has no marks. Its marks are a list that
 * grows at the front, so versions share what they have in common, and an undone
 * edit takes its marks with it. Very many of them become one for each relation.
 */
#include "world.h"

#include <stdlib.h>

enum { MOST_MARKS = 1 << 15 };

struct sg_mark {
  size_t holders, count; /* of the list from here on */
  sg_mark *next;
  sg_mark_kind kind;
  sg_relation relation;
  int32_t s, id;
  sg_row row;
};

sg_mark *
sg_marks_hold(sg_mark *mark)
{
  if (mark) {
    mark->holders++;
  }
  return mark;
}

void
sg_marks_drop(sg_mark *mark)
{
  while (mark && --mark->holders == 0) {
    sg_mark *next = mark->next;
    free(mark);
    mark = next;
  }
}

bool
sg_marks_each(const sg_mark *mark, sg_use_mark *use, void *data)
{
  for (; mark; mark = mark->next) {
    if (!use(data, mark->kind, mark->relation, mark->s, mark->id, mark->row)) {
      return false;
    }
  }
  return true;
}

/* Puts a mark before those of an owned version. */
static bool
push(sg_version *version, const sg_mark *what)
{
  sg_mark *mark = malloc(sizeof *mark);

  if (!mark) {
    return false;
  }
  *mark = *what;
  mark->holders = 1;
  mark->next = version->marks;
  mark->count = mark->next ? mark->next->count + 1 : 1;
  version->marks = mark;
  return true;
}

static const sg_mark_kind coarse[] = {
    [SG_MARK_GONE] = SG_MARK_GONE_ALL,     [SG_MARK_GONE_OF] = SG_MARK_GONE_ALL,
    [SG_MARK_GONE_ALL] = SG_MARK_GONE_ALL, [SG_MARK_MADE] = SG_MARK_MADE_ALL,
    [SG_MARK_MADE_ALL] = SG_MARK_MADE_ALL, [SG_MARK_ROW] = SG_MARK_ROWS,
    [SG_MARK_ROWS] = SG_MARK_ROWS};

/* One mark for all of a relation instead of many. */
static bool
make_coarse(sg_version *version)
{
  sg_mark *old = version->marks;
  bool has[SG_RELATIONS][SG_MARK_ROWS + 1] = {0}, good = true;

  version->marks = NULL;
  for (const sg_mark *m = old; m && good; m = m->next) {
    sg_mark one = {.kind = coarse[m->kind], .relation = m->relation};
    good = has[one.relation][one.kind] || push(version, &one);
    has[one.relation][one.kind] = true;
  }
  if (!good) {
    sg_marks_drop(version->marks);
    version->marks = old;
    return false;
  }
  sg_marks_drop(old);
  return true;
}

static bool
is_the_same(const sg_mark *a, const sg_mark *b)
{
  return a && a->kind == b->kind && a->relation == b->relation &&
         a->s == b->s && a->id == b->id && a->row == b->row;
}

static bool
mark_version(sg_world *world, const sg_mark *mark)
{
  sg_version *version = sg_world_own(world);

  if (!version) {
    return false;
  }
  if (version->marks && version->marks->count >= MOST_MARKS &&
      !make_coarse(version)) {
    return false;
  }
  return is_the_same(version->marks, mark) || push(version, mark);
}

/* True if there are rows that may refer to rows of this relation; `derived`: of
 * derived relations. */
static bool
is_referred(const sg_world *world, sg_relation relation, bool derived)
{
  for (uint64_t left = world->referring[relation]; left; left &= left - 1) {
    int q = __builtin_ctzll(left);
    const sg_map *map = world->current->map[q];
    if (map && map->rows > 0 && (!derived || sg_relation_table[q].derived)) {
      return true;
    }
  }
  return false;
}

bool
sg_world_mark_gone(sg_world *world, sg_relation relation, sg_mark_kind kind,
                   bool derived, int32_t s, int32_t id)
{
  return !is_referred(world, relation, derived) ||
         mark_version(
             world,
             &(sg_mark){.kind = kind, .relation = relation, .s = s, .id = id});
}

bool
sg_world_mark_row(sg_world *world, sg_relation relation, sg_row row)
{
  return mark_version(
      world, &(sg_mark){.kind = SG_MARK_ROW, .relation = relation, .row = row});
}
