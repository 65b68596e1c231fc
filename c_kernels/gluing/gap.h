/* gap.h -- how far two triangles, or edges, are apart. Rounded.
 *
 * Layer: kernel. The rule is tests/oracle/gap.pl.
 */
#ifndef SG_GAP_H
#define SG_GAP_H

/* A triangle, or an edge, which has two corners. */
typedef struct sg_gap_piece {
  int corners; /* 3, or 2 */
  double at[3][3];
} sg_gap_piece;

typedef struct sg_gap {
  double apart;
  double end[2][3]; /* where they are as near as that, of each one */
} sg_gap;

/* The least distance of a corner from a triangle that is square below it, or of
 * two sides: of triangles that go through each other not 0. Infinite: they
 * have no length. */
sg_gap sg_gap_between(const sg_gap_piece *a, const sg_gap_piece *b);

#endif
