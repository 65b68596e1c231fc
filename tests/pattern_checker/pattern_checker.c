/* pattern_checker -- is a pattern the solid laid flat? Independent of the
 * engine.
 *
 *     pattern_checker [-v] PATTERNS
 *
 * One line for each pattern of the file (pattern.h): NAME: then words
 * KEY=VALUE. Lengths are next to the solid's size, the longest side of its box,
 * but those of `sheet`, `seam`, `reported` and `tree`.
 *
 *     faces pieces folds seams lines borders    how many there are
 *     sheet       the side of a square as large as all polygons
 *     seam        the length of all seams; `reported`, as it was told
 *     tree        of the shortest tree along the solid's edges
 *     fold        folded back, the most that a corner is off its place
 *     shape       the most a corner is off the shape of its polygon
 *     bend        the most a corner of the solid is off its polygon's plane
 *     angle       the most that the angle of a joint moves a polygon
 *     area total  the most an area is off; the whole area, next to itself
 *     overlap     how deep polygons lie on each other, next to the sheet
 *     tabs        how deep tabs lie on polygons or on each other, the same
 *
 * Counts of faults: turned polygons (seen from the inside), missing polygons,
 * lost edges of the solid, unpaired sides, mismatched joints, cut pieces and
 * loose sides (edges.h), deep pairs of polygons and of tabs, more than a
 * thousand-millionth of the sheet. exact=yes if no count is above zero and
 * nothing told is wrong. Exit status: 0, or 2 if the file cannot be read.
 */
#include "edges.h"
#include "folding.h"
#include "overlap.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Of the sheet: what may lie on each other. */
static const real DEEP = 1e-9L;

/* Of itself: how exactly the seam is told. */
static const real TOLD = 1e-9L;

static bool
is_exact(const pattern *p, const shape_faults *s, const edge_faults *e,
         const overlap_faults *o)
{
  size_t counts = s->turned + s->missing + e->lost + e->unpaired + e->mismatch +
                  e->cut + e->loose + o->faces + o->tabs;

  return counts == 0 && fabsl(p->seam - e->seam) <= TOLD * e->seam;
}

static void
judge(const pattern *p, FILE *tell)
{
  shape_faults s = {0};
  edge_faults e = {0};
  overlap_faults o = {0};
  real sheet = sheet_of(p), fold;

  check_shapes(p, &s);
  check_edges(p, &e);
  check_overlaps(p, DEEP * sheet, tell, &o);
  fold = fold_back(p);
  printf("%s: exact=%s faces=%zu pieces=%d folds=%zu seams=%zu lines=%zu "
         "borders=%zu sheet=%.17Lg seam=%.17Lg reported=%.17g tree=%.17Lg "
         "fold=%.3Lg shape=%.3Lg bend=%.3Lg angle=%.3Lg area=%.3Lg "
         "total=%.3Lg overlap=%.12Lg tabs=%.12Lg turned=%zu missing=%zu "
         "lost=%zu unpaired=%zu mismatch=%zu cut=%zu loose=%zu deep=%zu "
         "deep_tabs=%zu\n",
         p->name, is_exact(p, &s, &e, &o) ? "yes" : "no", p->flats, p->pieces,
         e.folds, e.seams, e.lines, e.borders, sheet, e.seam, p->seam, e.tree,
         fold, s.shape, s.bend, e.angle, s.area, s.total, o.face / sheet,
         o.tab / sheet, s.turned, s.missing, e.lost, e.unpaired, e.mismatch,
         e.cut, e.loose, o.faces, o.tabs);
}

int
main(int argc, char **argv)
{
  FILE *tell = argc > 2 && strcmp(argv[1], "-v") == 0 ? stdout : NULL;
  FILE *in = argc > 1 ? fopen(argv[argc - 1], "r") : NULL;
  pattern p;

  if (!in) {
    fputs("usage: pattern_checker [-v] PATTERNS\n", stderr);
    return 2;
  }
  while (pattern_read(&p, in)) {
    judge(&p, tell);
    pattern_clear(&p);
  }
  pattern_clear(&p);
  fclose(in);
  return 0;
}
