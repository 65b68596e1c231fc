/* solid_old.h -- the rows that a solid became in a segment, by what they say.
 *
 * Layer: kernel. Reads views of one version. Rows of one relation are known by
 * their PLACE, the how manieth of the segment's rows they are.
 */
#ifndef SG_SOLID_OLD_H
#define SG_SOLID_OLD_H

#include "engine/cancel.h"
#include "join/bvh.h"
#include "rows/by_segment.h"

/* The relations that a solid is written to (solid_out.h), and origin/3. */
enum {
  SG_OLD_V,
  SG_OLD_E,
  SG_OLD_P,
  SG_OLD_PLANE,
  SG_OLD_T,
  SG_OLD_FROM_V,
  SG_OLD_FROM_P,
  SG_OLD_ORIGIN,
  SG_OLD_RELATIONS
};

#define SG_NO_PLACE UINT32_MAX

/* The place of the row with an id; SG_NO_PLACE: none has it. */
typedef struct sg_old_ids {
  int32_t most;    /* the largest id */
  uint32_t *place; /* [most + 1] */
  uint8_t *held;   /* [most + 1], or null: of a region: 1: a row outside of it
                      has this id, or, of a vertex, uses it */
} sg_old_ids;

/* Places, grouped: those of group g are place[begin[g]] .. place[begin[g + 1]
 * - 1]. */
typedef struct sg_old_groups {
  uint32_t *begin, *place;
} sg_old_groups;

/* The region of some leaves: the faces that come from them, and what belongs to
 * these. */
typedef struct sg_old_region {
  int32_t *leaf; /* [leaves]: ascending. Each face comes from some of these
                    alone, or from none of them */
  size_t leaves;
  uint32_t *row; /* [rows]: of v, not of the region */
  size_t rows;
  sg_box box;   /* round the vertices of the other faces */
  sg_box whole; /* round all vertices */
} sg_old_region;

typedef struct sg_solid_old {
  const sg_view *view[SG_OLD_RELATIONS];  /* borrowed */
  sg_segment_rows rows[SG_OLD_RELATIONS]; /* of the segment */
  sg_old_ids vertex, edge, polygon, triangle;
  uint32_t *from;          /* [vertices]: the place in from_v, SG_NO_PLACE */
  uint32_t *origin;        /* [vertices]: in origin */
  uint32_t *plane;         /* [polygons]: in plane */
  sg_old_groups triangles; /* by polygon, in the order of their ids */
  sg_old_groups sources;   /* rows of from_p, by polygon */
  sg_old_region region;    /* or no leaves: these are all rows */
} sg_solid_old;

typedef enum sg_old_end {
  SG_OLD_READ,
  SG_OLD_UNFIT, /* they are no solid's: something belongs to nothing, or ids
                   are far apart */
  SG_OLD_FAILED /* no memory, or stopped */
} sg_old_end;

/* Reads the rows of segment s. item_vertex(item) is the id of a vertex that the
 * item of an origin is, 0 if it is something else: such rows are left alone.
 * Owner: sg_solid_old_clear() in any case. */
sg_old_end sg_solid_old_read(const sg_view *const view[SG_OLD_RELATIONS],
                             int32_t s,
                             int32_t (*item_vertex)(const uint32_t *item),
                             const sg_cancel *cancel, sg_solid_old *out);
/* The same of the region of n leaves, ascending, and of those that faces come
 * from which also come from them. */
sg_old_end sg_solid_old_read_region(const sg_view *const view[SG_OLD_RELATIONS],
                                    int32_t s, const int32_t *leaf, size_t n,
                                    int32_t (*item_vertex)(const uint32_t *),
                                    const sg_cancel *cancel, sg_solid_old *out);
void sg_solid_old_clear(sg_solid_old *old);

/* [n + 1] places, all none (every bit set). Owner: the caller, free(). NULL:
 * no memory. */
uint32_t *sg_old_new_places(size_t n);

static inline size_t
sg_old_count(const sg_solid_old *old, int relation)
{
  return old->rows[relation].begin[1];
}

/* The cell of the row in this place. */
static inline int32_t
sg_old_int(const sg_solid_old *old, int relation, unsigned column,
           uint32_t place)
{
  return sg_view_int(old->view[relation], column,
                     old->rows[relation].row[place]);
}

static inline double
sg_old_float(const sg_solid_old *old, int relation, unsigned column,
             uint32_t place)
{
  return sg_view_float(old->view[relation], column,
                       old->rows[relation].row[place]);
}

static inline const int32_t *
sg_old_list(const sg_solid_old *old, int relation, unsigned column,
            uint32_t place)
{
  return sg_view_list(old->view[relation], column,
                      old->rows[relation].row[place]);
}

/* A row that is not of the region has this id, or uses this vertex. */
static inline bool
sg_old_is_held(const sg_old_ids *ids, int32_t id)
{
  return ids->held && id <= ids->most && ids->held[id];
}

/* The place of an id. */
static inline uint32_t
sg_old_place(const sg_old_ids *ids, int32_t id)
{
  return id <= ids->most ? ids->place[id] : SG_NO_PLACE;
}

#endif
