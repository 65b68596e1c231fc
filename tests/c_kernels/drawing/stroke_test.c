/* stroke_test.c -- parts end to end: chains, corners, rings, what goes on. The
 * order is held against the rule in tests/rules/sheet/stroke.plt. */
#include "tests/check.h"

#include "drawing/stroke.h"

#include <string.h>

enum { HIDDEN, VISIBLE };

static const sg_stroke_look look[] = {
    {.rank = 0, .role = 0, .hidden = true},
    {.rank = 1, .role = 0, .hidden = false},
};

/* Whole edge e. */
static sg_stroke_part
line(uint32_t kind, int32_t e, int32_t x1, int32_t y1, int32_t x2, int32_t y2)
{
  return (sg_stroke_part){kind, 0, 1, e, 0.0, 1.0, {x1, y1}, {x2, y2}};
}

static char
end_letter(uint8_t end)
{
  return end == SG_END_RING ? 'r' : end == SG_END_CUT ? 'c' : 'j';
}

/* Whether the strokes have these edges, below zero backwards, 0 after each,
 * and these ends, two letters each. Sorts the parts. */
static bool
strokes_are(sg_stroke_part *part, size_t n, const int32_t *edges,
            const char *ends)
{
  sg_strokes s;
  bool memory, same = sg_strokes_make(part, n, look, NULL, &s, &memory) &&
                      2 * s.n == strlen(ends);

  for (size_t i = 0; same && i < s.n; i++) {
    const sg_stroke *k = &s.item[i];

    same = end_letter(k->start) == *ends++ && end_letter(k->end) == *ends++;
    for (size_t j = 0; same && j < k->n; j++) {
      int32_t step = s.step[k->first + j];
      int32_t e = s.part[(step < 0 ? -step : step) - 1].e;
      same = (step < 0 ? -e : e) == *edges++;
    }
    same = same && *edges++ == 0;
  }
  sg_strokes_clear(&s);
  return same;
}

#define PARTS(...) ((sg_stroke_part[]){__VA_ARGS__})
#define EDGES(...) ((int32_t[]){__VA_ARGS__})

static bool
stop(void *data)
{
  (void)data;
  return true;
}

/* Many hidden rays to one side of a point, and one visible: no ray has a mate,
 * and each is asked if it goes on. Takes minutes if it is asked of every other.
 */
static bool
star_is_quick(void)
{
  enum { RAYS = 200000 };
  static sg_stroke_part part[2 * RAYS];
  sg_strokes s;
  bool memory, good;

  for (int32_t i = 0; i < 2 * RAYS; i++) {
    part[i] = line(i % 2 ? VISIBLE : HIDDEN, i + 1, 0, 0, 1000000, i);
  }
  good = sg_strokes_make(part, 2 * RAYS, look, NULL, &s, &memory);
  good = good && s.n == RAYS + RAYS / 2;
  sg_strokes_clear(&s);
  return good;
}

/* Looks may have any rank. */
static bool
far_ranks(void)
{
  static const sg_stroke_look far[] = {
      {.rank = INT32_MAX, .role = 0, .hidden = true},
      {.rank = INT32_MIN, .role = 0, .hidden = false},
  };
  sg_stroke_part part[] = {line(0, 1, 0, 0, 5, 0), line(1, 2, 0, 0, 5, 0)};
  sg_strokes s;
  bool memory;
  bool good = sg_strokes_make(part, 2, far, NULL, &s, &memory) && s.n == 1 &&
              s.part[0].e == 1;

  sg_strokes_clear(&s);
  return good;
}

/* So many parts that sorting asks; it is told to stop. */
static bool
stops(void)
{
  enum { N = 200000 };
  static sg_stroke_part part[N];
  const sg_cancel cancel = {stop, NULL};
  sg_strokes s;
  bool memory;

  for (int32_t i = 0; i < N; i++) {
    part[i] = line(VISIBLE, (i * 7919) % N, i, 0, i + 1, 0);
  }
  return !sg_strokes_make(part, N, look, &cancel, &s, &memory) && memory;
}

int
main(void)
{
  CHECK("nothing", strokes_are(NULL, 0, NULL, ""));
  CHECK("a visible line goes round corners",
        strokes_are(
            PARTS(line(VISIBLE, 1, 0, 0, 5, 0), line(VISIBLE, 2, 5, 5, 5, 0)),
            2, EDGES(1, -2, 0), "jj"));
  CHECK("a hidden one ends there",
        strokes_are(
            PARTS(line(HIDDEN, 1, 0, 0, 5, 0), line(HIDDEN, 2, 5, 5, 5, 0)), 2,
            EDGES(1, 0, 2, 0), "jjjj"));
  CHECK("a hidden one goes straight on",
        strokes_are(
            PARTS(line(HIDDEN, 1, 0, 0, 5, 0), line(HIDDEN, 2, 9, 1, 5, 0)), 2,
            EDGES(1, -2, 0), "jj"));
  CHECK("a ring", strokes_are(PARTS(line(VISIBLE, 1, 0, 0, 5, 0),
                                    line(VISIBLE, 2, 5, 5, 5, 0),
                                    line(VISIBLE, 3, 5, 5, 0, 0)),
                              3, EDGES(1, -2, 3, 0), "rr"));
  CHECK("hidden comes first, and goes on as visible",
        strokes_are(
            PARTS(line(VISIBLE, 1, 0, 0, 5, 0), line(HIDDEN, 2, 5, 0, 9, 0)), 2,
            EDGES(2, 0, 1, 0), "cjjc"));
  CHECK("visible before hidden in one place",
        strokes_are(
            PARTS(line(VISIBLE, 1, 0, 0, 5, 0), line(HIDDEN, 2, 5, 0, 0, 0)), 2,
            EDGES(1, 0), "jj"));
  CHECK("no length",
        strokes_are(PARTS(line(VISIBLE, 1, 5, 5, 5, 5)), 1, NULL, ""));
  CHECK("the foremost, however far", far_ranks());
  CHECK("many ends in one place", star_is_quick());
  CHECK("it stops", stops());
  return check_report();
}
