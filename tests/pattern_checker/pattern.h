/* pattern.h -- a solid and its flat pattern, as text, for the checker.
 *
 * A pattern in the file is these lines, ids positive, in this order except for
 * lines of one kind; `end` ends it:
 *
 *     v V X Y Z           a vertex of the solid
 *     e E V1 V2           a directed edge of it
 *     p P E...            a polygon, its edges in any order
 *     t P V1 V2 V3        a triangle of polygon P
 *     removed P           polygon P is not in the pattern, as was asked
 *     V W X Y V0          a vertex of the pattern, which was V0
 *     E E W1 W2 E0        an edge of it: edge E0, or a part of it; 0: of none
 *     P P P0 K E...       a polygon of it, of P0, in piece K
 *     J E1 E2 KIND ANGLE  a joint: fold, seam or line; degrees, bent back > 0
 *     T E X Y X Y X Y...  a tab at edge E of the pattern
 *     reported SEAM N     the seam's length and the pieces as they were told
 *     end NAME
 */
#ifndef SG_PATTERN_CHECKER_PATTERN_H
#define SG_PATTERN_CHECKER_PATTERN_H

#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

/* Everything is named by its place in an array; NONE is no place. */
enum { NONE = -1 };
enum { NAME_SIZE = 128 };

typedef enum joint_kind { FOLD, SEAM, LINE } joint_kind;

typedef struct edge {
  int from, to; /* points */
  int face;     /* of the solid whose border it is in, or NONE */
} edge;

/* A polygon of the solid: list[first .. first + count) are its edges. */
typedef struct face {
  size_t first, count;
  bool removed;
} face;

typedef struct spot {
  double at[2];
  int point; /* that it was */
} spot;

typedef struct side {
  int from, to; /* spots */
  int edge;     /* of the solid, or NONE */
  int flat;     /* whose border it is in, or NONE */
  int joint;    /* or NONE */
} side;

/* A polygon of the pattern: list[first .. first + count) are its sides. */
typedef struct flat {
  size_t first, count;
  int face; /* of the solid that it was, or was a part of */
  int piece;
} flat;

typedef struct joint {
  int side[2];
  joint_kind kind;
  double angle; /* degrees */
} joint;

/* Corners corner[first .. first + count) of the tab at a side. */
typedef struct tab {
  size_t first, count;
  int side;
} tab;

typedef struct pattern {
  char name[NAME_SIZE];
  double (*point)[3];
  edge *edge;
  face *face;
  int (*triangle)[4]; /* its face, its corners */
  spot *spot;
  side *side;
  flat *flat;
  joint *joint;
  tab *tab;
  double (*corner)[2];
  int *list;
  size_t points, edges, faces, triangles, spots, sides, flats, joints, tabs,
      corners, listed;
  size_t twice; /* edges in two lists, or in two joints */
  double seam;  /* as reported */
  int pieces;   /* as reported; largest number of one otherwise */
} pattern;

/* Reads the next pattern. False: there is none. A line that is wrong ends the
 * program, with a message and status 2. Owner: pattern_clear(). */
bool pattern_read(pattern *p, FILE *in);

void pattern_clear(pattern *p);

/* Room for one more item behind the n there are; ends the program with status
 * 2 if there is no memory. */
void *room(void *items, size_t n, size_t size);

#endif
