/* work_grid.h -- a uniform grid over segments of a plane, each with a number.
 *
 * Layer: kernel; the index of the scratch relation (work.h). It finds a
 * superset of what meets a point, segment or triangle; who asks decides
 * exactly. The grid lies along the segments' main direction and its cells have
 * the shape that suits them, so that combs and long strips are no worst case.
 * What lies outside its box is kept in the border cells.
 */
#ifndef SG_WORK_GRID_H
#define SG_WORK_GRID_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

typedef struct sg_work_grid_segment {
  double from[2], to[2];
} sg_work_grid_segment;

typedef struct sg_work_grid_entry {
  int32_t number, next; /* entry + 1, 0 none */
} sg_work_grid_entry;

typedef struct sg_work_grid {
  bool open;
  double origin[2], along[2]; /* frame: along is a unit vector */
  double per[2];              /* cells per unit */
  double margin;              /* in cells: more than any rounding */
  int32_t cells[2];
  int32_t *first; /* [cells[0] * cells[1]]: entry + 1, 0 none */
  sg_work_grid_entry *entry;
  int32_t entries;
  size_t room;
  int32_t filled;  /* entries after the first filling: sg_work_grid_filled() */
  size_t held;     /* segments put in since it was opened */
  size_t expected; /* segments that shaped it */
} sg_work_grid;

/* The main direction of each step-th of n segments, a unit vector: the sum of
 * their doubled angles, weighed by length, halved. */
void sg_work_main_direction(const sg_work_grid_segment *segment, size_t n,
                            size_t step, double out[2]);

/* What will be put in: the segments themselves, or their ends as points. */
typedef enum sg_work_grid_of {
  SG_GRID_OF_SEGMENTS,
  SG_GRID_OF_ENDS
} sg_grid_of;

/* The n segments shape the grid; they are not put in. False: no memory.
 * `error` bounds the rounding error of the coordinates. */
bool sg_work_grid_open(sg_work_grid *grid, sg_grid_of of,
                       const sg_work_grid_segment *segment, size_t n,
                       double error);
void sg_work_grid_close(sg_work_grid *grid);

/* False: no memory. A point comes into one cell alone. */
bool sg_work_grid_add(sg_work_grid *grid, int32_t number, const double from[2],
                      const double to[2]);
bool sg_work_grid_add_point(sg_work_grid *grid, int32_t number,
                            const double at[2]);

/* Says that all segments are in: what comes later may be as much again, then
 * it is time for a new grid. */
void sg_work_grid_filled(sg_work_grid *grid);
bool sg_work_grid_is_stale(const sg_work_grid *grid);

/* The numbers in the cells that a convex piece with 1, 2 or 3 corners covers;
 * a number may come more than once. Do not add while walking, nor copy a walk.
 */
typedef struct sg_work_grid_walk {
  sg_work_grid *grid;
  double corner[3][2]; /* in cells */
  int corners;
  int32_t row, last_row, cell, last_cell;
  int32_t *link, *taken; /* to the next entry, to the one given last */
  int32_t none;
} sg_work_grid_walk;

void sg_work_grid_walk_open(sg_work_grid_walk *walk, sg_work_grid *grid,
                            const double corner[][2], int corners);
int32_t sg_work_grid_walk_next(sg_work_grid_walk *walk); /* 0: no more */
/* Takes the entry given last out of its cell: its segment is gone. */
void sg_work_grid_walk_drop(sg_work_grid_walk *walk);

/* The cell of a point, as column and row. */
void sg_work_grid_cell(const sg_work_grid *grid, const double point[2],
                       int32_t out[2]);

#endif
