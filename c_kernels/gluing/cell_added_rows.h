/* cell_added_rows.h -- a glue and one more solid, between reading and
 * writing.
 *
 * Layer: rows.
 */
#ifndef SG_CELL_ADDED_ROWS_H
#define SG_CELL_ADDED_ROWS_H

#include "call.h"
#include "rows/by_segment.h"
#include "solid/solid.h"

/* A relation as it is, and the rows of the glue. */
typedef struct sg_cells_part {
  sg_view view;
  sg_segment_rows rows;
  size_t n;
} sg_cells_part;

typedef struct sg_cell_joiner {
  sg_call *call;
  const sg_version *version;
  int32_t s, of; /* the glue, the solid */
  const sg_solid *solid;
  double reach;
  sg_cells_part v, p, t, sides, region;
  sg_id_rows place;         /* of vertices */
  double low[3], high[3];   /* box of the solid, with the reach */
  uint8_t *out;             /* [place.places] the sides of that it is beyond */
  double least[3], most[3]; /* box of the glue */
  int32_t last_v, last_e, last_p, last_t;
  size_t known, near; /* vertices and faces of the glue in `both` */
  sg_solid both;
  uint8_t *border;  /* [triangles] of both */
  int32_t *id;      /* [vertices] of both: of the glue */
  int32_t *polygon; /* [faces] of both: of the glue */
  bool rest_only;   /* what is shared is known to be made of it too */
  /* Then: [was_n] a polygon of the solid, ascending, and the number that its
   * polygon of the glue gets. */
  const struct sg_id_pair *was;
  size_t was_n;
  const sg_int_list *made; /* vertices that a cut made, ascending */
  int32_t inside;          /* the region that the solid becomes */
  int32_t before, outside; /* of the outside, until now and from now on */
} sg_cell_joiner;

/* The rows of segment s. False: no memory, or stopped. Clear it in any case. */
bool sg_cells_part_read(sg_call *call, const sg_version *version,
                        sg_relation relation, int32_t s, sg_cells_part *out);
void sg_cells_part_clear(sg_cells_part *part);

/* All of these: false: refused, or stopped (call.h). */

/* Reads the glue, and fills `both` with what of it is near, then the solid. */
bool sg_cell_read(sg_cell_joiner *joiner);
void sg_cell_clear(sg_cell_joiner *joiner);

/* Writes the vertices and faces of the solid that are not shared, and what all
 * of its polygons became. */
bool sg_cell_write(sg_cell_joiner *joiner, sg_world *world);

/* Columns of rows that are to be written. */
enum { SG_CELL_COLUMNS = 6 };

typedef struct sg_cell_table {
  size_t n;
  const void *column[SG_CELL_COLUMNS];
  int32_t *i[SG_CELL_COLUMNS];
  double *f[SG_CELL_COLUMNS];
} sg_cell_table;

/* Of n rows at most; bit k of `floats`: column k is of floats. */
bool sg_cell_table_open(sg_cell_joiner *joiner, size_t n, int columns,
                        unsigned floats, sg_cell_table *out);
/* A row of n integers. */
void sg_cell_table_add(sg_cell_table *to, int n, const int32_t *value);
/* For the rows `gone`. */
bool sg_cell_table_write(sg_cell_joiner *joiner, sg_world *world,
                         sg_relation relation, const sg_row *gone, size_t gones,
                         const sg_cell_table *from);

#endif
