/* nest_test.c -- pieces on sheets: by hand; random triangles, none on another,
 * found by their sides. */
#include "tests/check.h"

#include "pattern/flat_shapes.h"
#include "pattern/nest.h"
#include "pattern/nest_mask.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { MANY = 200 };

static uint64_t seed = 11;

static double
random_below(double most)
{
  seed = seed * UINT64_C(6364136223846793005) + UINT64_C(1442695040888963407);
  return most * (double)(seed >> 33) / 2147483648.0;
}

static const double turns[4] = {0.0, 90.0, 180.0, 37.0};

typedef struct pieces {
  double at[MANY][3][2];
  size_t end[MANY];
  sg_nest_piece piece[MANY];
  sg_nest_place place[MANY];
} pieces;

static void
make_pieces(pieces *p, double size)
{
  for (unsigned i = 0; i < MANY; i++) {
    double triangle[3][2] = {{-3, 7},
                             {-3 + 2 + random_below(size), 7},
                             {-3 + random_below(size), 9 + random_below(size)}};

    memcpy(p->at[i], triangle, sizeof triangle);
    p->end[i] = 3;
    p->piece[i] = (sg_nest_piece){
        (const double(*)[2])p->at[i], 3, &p->end[i], 1, turns, 4, i};
  }
}

static sg_flat_shape
placed(const pieces *p, unsigned i)
{
  const sg_nest_place *to = &p->place[i];
  double angle = to->degrees * acos(-1.0) / 180.0;
  sg_flat_shape shape = {.corners = 3};

  for (unsigned k = 0; k < 3; k++) {
    const double *at = p->at[i][k];

    shape.at[k][0] = at[0] * cos(angle) - at[1] * sin(angle) + to->by[0];
    shape.at[k][1] = at[0] * sin(angle) + at[1] * cos(angle) + to->by[1];
  }
  return shape;
}

static bool
on_paper(const sg_flat_shape *shape, const sg_nest_paper *paper)
{
  for (unsigned k = 0; k < shape->corners; k++) {
    if (shape->at[k][0] < -1e-9 || shape->at[k][0] > paper->width + 1e-9 ||
        shape->at[k][1] < -1e-9 || shape->at[k][1] > paper->height + 1e-9) {
      return false;
    }
  }
  return true;
}

static void
check_random(const sg_nest_paper *paper, double size)
{
  static pieces p, again;
  unsigned overlaps = 0, off = 0, nowhere = 0;
  bool memory;

  make_pieces(&p, size);
  uint64_t work = 0, more = 0;

  CHECK("nested",
        sg_nest(paper, p.piece, MANY, NULL, p.place, &work, NULL, &memory));
  sg_nest_masks *masks = sg_nest_masks_open(MANY);

  for (int times = 0; times < 2; times++) { /* masks made, and kept ones */
    more = 0;
    CHECK("again", sg_nest(paper, p.piece, MANY, masks, again.place, &more,
                           NULL, &memory));
  }
  sg_nest_masks_close(masks);
  CHECK("the same work", work > 0 && work == more);
  CHECK("the same", memcmp(p.place, again.place, sizeof p.place) == 0);
  for (unsigned i = 0; i < MANY; i++) {
    sg_flat_shape a = placed(&p, i);

    nowhere += p.place[i].sheet == 0;
    off += !on_paper(&a, paper);
    for (unsigned k = 0; k < i; k++) {
      sg_flat_shape b = placed(&p, k);

      overlaps += p.place[i].sheet == p.place[k].sheet &&
                  sg_flat_shape_depth(&a, &b) > -0.5 * paper->square;
    }
  }
  CHECK("all have a place", nowhere == 0);
  CHECK("on the paper", off == 0);
  CHECK("none on another", overlaps == 0);
}

static void
check_by_hand(void)
{
  static const double plate[4][2] = {{0, 0}, {60, 0}, {60, 30}, {0, 30}};
  static const size_t end = 4;
  sg_nest_paper paper = {100, 100, 1, 1, false};
  sg_nest_piece piece[3];
  sg_nest_place place[3];
  bool memory;

  for (int i = 0; i < 3; i++) {
    piece[i] = (sg_nest_piece){plate, 4, &end, 1, turns, 1, 0};
  }
  CHECK("three", sg_nest(&paper, piece, 3, NULL, place, NULL, NULL, &memory));
  CHECK("the first in the corner",
        place[0].sheet == 1 && place[0].by[0] == 0 && place[0].by[1] == 0);
  CHECK("the second above it", place[1].sheet == 1 && place[1].by[1] >= 31);
  CHECK("three on it", place[2].sheet == 1);
  paper.height = 70;
  CHECK("lower", sg_nest(&paper, piece, 3, NULL, place, NULL, NULL, &memory));
  CHECK("the third on another", place[2].sheet == 2);
  paper.one = true;
  CHECK("one", sg_nest(&paper, piece, 3, NULL, place, NULL, NULL, &memory));
  CHECK("no place", place[2].sheet == 0);
  paper.width = 59;
  CHECK("too narrow",
        sg_nest(&paper, piece, 1, NULL, place, NULL, NULL, &memory));
  CHECK("no place at all", place[0].sheet == 0);
}

static void
check_hole(void)
{
  static const double ring[8][2] = {{0, 0},   {90, 0},  {90, 90}, {0, 90},
                                    {10, 10}, {10, 80}, {80, 80}, {80, 10}};
  static const size_t ends[2] = {4, 8};
  static const double plate[4][2] = {{0, 0}, {60, 0}, {60, 60}, {0, 60}};
  static const size_t end = 4;
  sg_nest_paper paper = {100, 100, 1, 1, false};
  sg_nest_piece piece[2] = {{ring, 8, ends, 2, turns, 1, 0},
                            {plate, 4, &end, 1, turns, 1, 0}};
  sg_nest_place place[2];
  bool memory;

  CHECK("ring", sg_nest(&paper, piece, 2, NULL, place, NULL, NULL, &memory));
  CHECK("in the hole",
        place[1].sheet == 1 && place[1].by[0] > 10 && place[1].by[0] + 60 < 80);
}

/* The squares that are looked at for n plates, of about one size. */
static uint64_t
work_of_plates(unsigned n, sg_nest_place *place)
{
  enum { MOST = 1600 };
  static double plate[MOST][4][2];
  static sg_nest_piece piece[MOST];
  static const size_t end = 4;
  const sg_nest_paper paper = {100, 70, 1, 1, false};
  uint64_t work = 0;
  bool memory;

  seed = 5;
  for (unsigned i = 0; i < n; i++) {
    double w = 33 + random_below(6), h = 24 + random_below(4);
    double around[4][2] = {{0, 0}, {w, 0}, {w, h}, {0, h}};

    memcpy(plate[i], around, sizeof around);
    piece[i] =
        (sg_nest_piece){(const double(*)[2])plate[i], 4, &end, 1, turns, 2, 0};
  }
  CHECK("plates", sg_nest(&paper, piece, n, NULL, place, &work, NULL, &memory));
  return work;
}

static void
check_growth(void)
{
  static sg_nest_place place[1600];
  uint64_t few = work_of_plates(400, place);
  uint64_t many = work_of_plates(1600, place);

  CHECK("four times the plates, no more than five times the work",
        many < 5 * few);
}

/* Plates of which two fill a sheet, and what fits above any two. */
static void
check_other_kind(double width, double height)
{
  enum { PLATES = 40, ALL = PLATES + 20 };
  static const double plate[4][2] = {{0, 0}, {48, 0}, {48, 30}, {0, 30}};
  const double strip[4][2] = {{0, 0}, {width, 0}, {width, height}, {0, height}};
  static const size_t end = 4;
  const sg_nest_paper paper = {100, 50, 1, 1, false};
  sg_nest_piece piece[ALL];
  sg_nest_place place[ALL];
  unsigned wrong = 0;
  bool memory;

  for (unsigned i = 0; i < ALL; i++) {
    piece[i] =
        (sg_nest_piece){i < PLATES ? plate : strip, 4, &end, 1, turns, 1, 0};
  }
  CHECK("plates and strips",
        sg_nest(&paper, piece, ALL, NULL, place, NULL, NULL, &memory));
  for (unsigned i = 0; i < ALL; i++) {
    wrong += place[i].sheet > PLATES / 2;
  }
  CHECK("sheets that refuse plates take strips", wrong == 0);
}

/* A single sheet is asked for each piece, however many it refused. */
static void
check_one_sheet(void)
{
  enum { ALL = 32 };
  static const double first[4][2] = {{0, 0}, {50, 0}, {50, 69}, {0, 69}};
  static const double wide[4][2] = {{0, 0}, {68, 0}, {68, 46}, {0, 46}};
  static const double high[4][2] = {{0, 0}, {46, 0}, {46, 68}, {0, 68}};
  static const size_t end = 4;
  const sg_nest_paper paper = {100, 70, 1, 1, true};
  sg_nest_piece piece[ALL];
  sg_nest_place place[ALL];
  bool memory;

  for (unsigned i = 0; i < ALL; i++) {
    piece[i] = (sg_nest_piece){wide, 4, &end, 1, turns, 1, 0};
  }
  piece[0].at = first;
  piece[ALL - 1].at = high;
  CHECK("one sheet",
        sg_nest(&paper, piece, ALL, NULL, place, NULL, NULL, &memory));
  CHECK("refused", place[0].sheet == 1 && place[ALL - 2].sheet == 0);
  CHECK("what fits has a place", place[ALL - 1].sheet == 1);
}

static bool
stop(void *data)
{
  return --*(int *)data < 0;
}

/* On one sheet, which has many rows; the cancellation is asked for each. */
static void
check_stopping(void)
{
  static const double plate[4][2] = {{0, 0}, {60, 0}, {60, 30}, {0, 30}};
  static const size_t end = 4;
  const sg_nest_paper paper = {61, 4000, 1, 1, false};
  sg_nest_piece piece[4];
  sg_nest_place place[4];
  int asks = 50;
  bool memory;

  for (int i = 0; i < 4; i++) {
    piece[i] = (sg_nest_piece){plate, 4, &end, 1, turns, 1, 0};
  }
  CHECK("the poll stops it", !sg_nest(&paper, piece, 4, NULL, place, NULL,
                                      &(sg_cancel){stop, &asks}, &memory));
  CHECK("it is not for want of memory", memory);
}

enum { RASTER = 400 };

/* Marks the runs; returns how many squares they have, none twice, in order. */
static size_t
mark_runs(const sg_nest_mask *m, const sg_nest_runs *runs,
          uint8_t square[RASTER][RASTER])
{
  size_t seen = 0;
  unsigned widest = 0;
  bool right = m->w <= RASTER && m->h <= RASTER;

  for (size_t k = 0; right && k < runs->n; k++) {
    const sg_nest_run *run = &runs->at[k];
    unsigned wide = run->to - run->from + 1u;

    right = run->row < m->h && run->to < m->w;
    widest = wide > widest ? wide : widest;
    for (unsigned x = run->from; x <= run->to && right; x++) {
      right = square[run->row][x]++ == 0;
      seen++;
    }
  }
  CHECK("runs of squares, none twice", right);
  CHECK("the widest", widest == runs->widest);
  return seen;
}

static bool
is_near(uint8_t square[RASTER][RASTER], int y, int x, int gap)
{
  for (int i = y - gap; i <= y + gap; i++) {
    for (int k = x - gap; k <= x + gap; k++) {
      if (i >= 0 && k >= 0 && i < RASTER && k < RASTER && square[i][k]) {
        return true;
      }
    }
  }
  return false;
}

/* What a mask needs are the squares that are covered, and those in the gap. */
static void
check_runs(const sg_nest_paper *paper, unsigned i, double degrees)
{
  static pieces p;
  static uint8_t covered[RASTER][RASTER], needed[RASTER][RASTER];
  sg_nest_masks *masks = sg_nest_masks_open(MANY);
  const sg_nest_mask *m = NULL, *again = NULL;
  unsigned wrong = 0;

  memset(covered, 0, sizeof covered);
  memset(needed, 0, sizeof needed);
  make_pieces(&p, 30);
  CHECK("a mask",
        sg_nest_masks_at(masks, paper, 2000, 2000, &p.piece[i], degrees, &m) &&
            m);
  size_t own = mark_runs(m, &m->covered, covered);
  size_t all = mark_runs(m, &m->needed, needed);

  for (unsigned y = 0; y < m->h; y++) {
    for (unsigned x = 0; x < m->w; x++) {
      bool near = is_near(covered, (int)y, (int)x, (int)paper->gap);
      wrong += (needed[y][x] != 0) != near;
    }
  }
  CHECK("the gap is needed, and no more", wrong == 0);
  CHECK("covered ones", m->squares == own);
  CHECK("more than a few", own > 20 && all > own);
  CHECK("kept", sg_nest_masks_at(masks, paper, m->w, m->h, &p.piece[i], degrees,
                                 &again) &&
                    again == m);
  CHECK("too large", sg_nest_masks_at(masks, paper, m->w - 1, m->h, &p.piece[i],
                                      degrees, &again) &&
                         !again);
  sg_nest_masks_close(masks);
}

int
main(void)
{
  sg_nest_paper bad = {1e9, 10, 1e-3, 1, false};

  check_by_hand();
  check_hole();
  check_growth();
  check_other_kind(90, 15); /* as large */
  check_other_kind(48, 15); /* as long */
  check_one_sheet();
  check_stopping();
  check_random(&(sg_nest_paper){190, 277, 0.7, 2, false}, 60);
  check_random(&(sg_nest_paper){300, 4000, 1.5, 1, true}, 60);
  for (unsigned i = 0; i < 20; i++) {
    check_runs(&(sg_nest_paper){190, 277, 0.7, 2, false}, i, 9.0 * i);
  }
  CHECK("too many squares", !sg_nest_paper_is_valid(&bad));
  return check_report();
}
