/* shading_private.h -- inside a shaded scene: shading_scene.h.
 *
 * Layer: kernel, private.
 */
#ifndef SG_SHADING_PRIVATE_H
#define SG_SHADING_PRIVATE_H

#include "engine/list.h"
#include "owner.h"
#include "quartic.h"
#include "shading_scene.h"

/* Rows of dots of which there is one list of what lies in them: the fewest, a
 * power of 2, with which a thing is in few lists. */
#define SG_BAND_MOST  16
#define SG_BAND_LISTS 3

/* Most lights that have shadows. */
#define SG_SHADOWS 9

/* Places of corners are whole multiples of it: what is computed twice of one
 * corner, and lies on a scan line, is on the same side of it. */
#define SG_SNAP 1048576.0

/* A plane whose normal has less along the line of sight is seen edge-on. */
#define SG_EDGE_ON 1e-6

/* q0 xx + q1 yy + q2 zz + q3 xy + q4 xz + q5 yz + q6 x + q7 y + q8 z + q9 = 0
 * round `at`, in the picture. */
typedef struct sg_shading_quadric {
  double at[3], q[10];
} sg_shading_quadric;

/* A torus: where A^2 = 4 B W, inside of it less, A, B and W as the quadrics
 * above, of places from `at` in parts of `size`. W is 1 at its centre, `at`. */
typedef struct sg_shading_torus {
  double at[3], size; /* it ends nearer to `at` than `size` */
  double form[3][10];
  double circle[3]
               [3]; /* the middle of its tube: where c circle[0] + s circle[1]
                       + circle[2] is seen, (x, y, w) from `at`; c and s the
                       cosine and sine of an angle */
} sg_shading_torus;

/* A torus on a line: A, B and W, each f0 tt + f1 tz + f2 zz + f3 t + f4 z + f5,
 * of t and z from x and z in parts of `size`. */
typedef struct sg_ring_line {
  double x, z, size, form[3][6];
} sg_ring_line;

typedef enum sg_surface_kind {
  SG_IS_PLANE,
  SG_IS_QUADRIC,
  SG_IS_RING
} sg_surface_kind;

/* A plane q0 x + q1 y + q2 z + q3 = 0 round the middle of the scene, (q0, q1,
 * q2) a unit vector; or another one. */
typedef struct sg_shading_surface {
  sg_surface_kind kind;
  uint32_t of; /* its place in scene->quadric or scene->torus; a plane stands
                  for this one of scene->known, from 1; 0: for none */
  double q[4];
  double normal[3];   /* of a plane: in the model, to the eye */
} sg_shading_surface; /* 64 bytes: as it is with polygons */

/* Between loops of a polygon. */
#define SG_NO_CORNER UINT32_MAX

/* A corner in the picture. */
typedef struct sg_shading_corner {
  double at[3];
} sg_shading_corner; /* its X and Y snapped; before the scene is sealed there
                        is a list of those that are not, too */

/* A polygon of a leaf: corners loop after loop, each loop closed by the corner
 * with which it begins, SG_NO_CORNER between two. */
typedef struct sg_shading_polygon {
  uint32_t leaf, surface;
  int32_t face;
  int8_t sense; /* of its front: 1 entered, -1 left, 0 edge-on */
  uint32_t corner, corners;
  double y1, y2;
} sg_shading_polygon; /* as small as it is: a mesh has a million */

/* A plane that bounds a piece: what is inside has sense * plane >= 0. */
typedef struct sg_shading_bound {
  uint32_t surface;
  int32_t face; /* 0: none */
  double sense;
} sg_shading_bound;

typedef struct sg_shading_body {
  uint32_t leaf, surface;
  int32_t face;
  uint32_t bounds; /* 0 .. 2 */
  sg_shading_bound bound[2];
  double y1, y2;
  double low[3], high[3]; /* in the picture */
  bool more;              /* the next piece is of the same leaf */
} sg_shading_body;

typedef struct sg_shading_leaf {
  int32_t number;
  int32_t root;  /* by place, -1: in none */
  int32_t sign;  /* -1: under an odd number of right-hand sides */
  uint32_t node; /* of the expression, SIZE: none */
  bool united;   /* no node above it is anything but a union */
  bool round;
} sg_shading_leaf;

typedef struct sg_shading_root {
  int32_t segment;
  uint32_t node;
} sg_shading_root;

/* Something of a band: a polygon, or the pieces of a leaf from this one on. */
typedef struct sg_shading_item {
  uint32_t at;
  bool round;
} sg_shading_item;

struct sg_shading {
  uint64_t serial; /* no two of a process have one */
  sg_shading_frame frame;
  double middle[3];       /* round which planes are */
  double low[3], high[3]; /* of all faces, in the picture */
  SG_LIST_OF(sg_shading_leaf) leaf;
  SG_LIST_OF(sg_shading_surface) surface;
  SG_LIST_OF(sg_shading_quadric) quadric;
  SG_LIST_OF(sg_shading_torus) torus;
  SG_LIST_OF(sg_shading_polygon) polygon;
  SG_LIST_OF(sg_shading_corner) corner, exact;
  SG_LIST_OF(uint32_t) corner_of; /* polygons */
  SG_LIST_OF(sg_shading_body) body;
  SG_LIST_OF(sg_shading_root) root;
  SG_LIST_OF(sg_known_surface) known;
  uint32_t known_now; /* what polygons that are added stand for, or 0 */
  double back[4][4];  /* from the picture to the model, but for a factor */
  sg_expression expression; /* the union of all roots */
  sg_owners *owners;        /* null: the first face of a group is seen */
  bool *through;            /* null, or [roots][roots]: the first one does not
                               hide the second one */
  size_t root_node;         /* of the last root */
  uint32_t band, bands;     /* rows of one; how many */
  uint32_t *band_first;     /* [bands + 1] */
  sg_shading_item *item;    /* [band_first[bands]] */
};

/* What a face of a leaf and the plane of a scan line have in common: with
 * t = x - x0 (dots) it is seen at depth z = a + b t, of an arc
 * a + b t + arc sqrt(e t^2 + f t + g), where what is below 0 counts as 0; of a
 * torus at a root of the quartic of `line`, which is there from e to f. */
typedef struct sg_slice {
  int32_t x1, x2;
  uint32_t leaf, surface;
  int32_t face;
  int8_t sense;  /* 1 enters, -1 leaves */
  int8_t arc;    /* 0: straight; 1, -1: the sign of the root; more: which
                    root, sg_quartic_root */
  uint8_t sheet; /* of a torus: of a span */
  bool round;    /* of a round leaf: its slices do not cross */
  union {
    double x0;
    const sg_ring_line *line; /* borrowed of the work */
  };
  double a, b, e, f, g;
} sg_slice;

/* A slice where it is looked at between two places. */
typedef struct sg_active {
  const sg_slice *slice;
  double left, middle, right; /* depths */
} sg_active;

/* What is seen in one place: the slice of this place in the order of depth has
 * so much of the light. */
typedef struct sg_layer {
  size_t slice;
  uint32_t part;
} sg_layer;

/* Where a line meets an edge of a polygon. */
typedef struct sg_slice_corner {
  double x, z;
} sg_slice_corner;

struct sg_shading_work {
  const sg_shading *scene;
  const sg_opacities *opacities; /* null: all is opaque */
  bool *held;                    /* [roots]: it was there before a group */
  bool *noted;                   /* [nodes]: what it was: walk.c */
  SG_LIST_OF(sg_layer) layer;
  SG_LIST_OF(size_t) open; /* of a layer the last span */
  SG_LIST_OF(sg_slice) slice;
  SG_LIST_OF(sg_slice) over;  /* a point: shadow.c */
  SG_LIST_OF(uint64_t) start; /* x1, then the place of the slice */
  SG_LIST_OF(sg_active) active;
  SG_LIST_OF(sg_slice_corner) crossing;
  SG_LIST_OF(sg_met_face) met; /* of a group */
  sg_ring_line *line;          /* [tori]: where the last line cut them */
  double between[2];        /* dots: what is round and lies here is left out */
  sg_expression expression; /* a copy with counters of its own */
  size_t looked;            /* how often slices of the line were looked at */
  size_t searched;          /* and in search of hidden ones */
  bool failed;              /* no memory */
  sg_shading_work *light[SG_SHADOWS]; /* null: not yet */
};

/* ring_slice.c: a torus on the line y; its quartic in z at t, which are from
 * its place in parts of its size; and from one place (x, z) of the picture
 * straight to another one the numbers by powers of u, the place there being
 * (from + u to) / (1 + u). */
sg_ring_line sg_ring_line_of(const sg_shading_torus *torus, double y);
void sg_ring_quartic(const sg_ring_line *line, double t, double c[5]);
void sg_ring_along(const sg_ring_line *line, const double from[2],
                   const double to[2], double c[5]);
double sg_ring_depth(const sg_slice *s, double x);
bool sg_ring_slices(sg_shading_work *work, const sg_shading_body *body,
                    double y);

/* ring_sheet.c: which root on a line is of which sheet. */
typedef struct sg_ring_sheets {
  int count; /* of roots */
  uint8_t of[4], last;
} sg_ring_sheets;

/* Beyond a place where c is the quartic there are so many roots. */
void sg_ring_sheets_change(sg_ring_sheets *sheets, const double c[5],
                           int count);

/* Root i of so many. */
static inline sg_quartic_root
sg_ring_root(int i, int count)
{
  return (sg_quartic_root)(i + (count == 4 ? SG_ROOT_NEAR_IN : SG_ROOT_FIRST));
}

/* The same at one place of it alone: straight slices there. */
bool sg_ring_over(sg_shading_work *work, const sg_shading_body *body, double x,
                  double y);

/* ring_sheet.c: how far behind one another, in dots of depth, two sheets of one
 * torus are where one is seen at p and the other at q, near to p, roots that
 * both enter it or both leave it; 0: they are one sheet. */
double sg_ring_gap(const sg_shading *s, uint32_t surface, int32_t root_p,
                   const double p[2], int32_t root_q, const double q[2]);

static inline bool
sg_slice_is_ring(const sg_slice *s)
{
  return s->arc > 1;
}

static inline double
sg_slice_depth(const sg_slice *s, double x)
{
  if (sg_slice_is_ring(s)) {
    return sg_ring_depth(s, x);
  }
  double t = x - s->x0;
  double depth = s->a + s->b * t;

  if (s->arc != 0) {
    double square = (s->e * t + s->f) * t + s->g;
    depth += s->arc * (square > 0 ? __builtin_sqrt(square) : 0.0);
  }
  return depth;
}

/* A place of a corner, snapped. */
static inline double
sg_snapped(double x)
{
  /* added to it, a place has multiples of 1 / SG_SNAP and no others */
  const double coarse = 1.5 * 4503599627370496.0 / SG_SNAP;

  return x < coarse / 4 && x > -coarse / 4
             ? (x + coarse) - coarse
             : __builtin_nearbyint(x * SG_SNAP) / SG_SNAP;
}

/* shading_scene.c: a model point in the picture. False: not in front of the
 * eye. */
bool sg_shading_seen(const sg_shading *s, const double p[3], double out[3]);

/* The box of all faces reaches as far as `off` dots from a point. */
void sg_shading_reach(sg_shading *s, const double at[3], double off);

/* shading_scene.c: a plane, as sg_shading_surface has it; its place,
 * UINT32_MAX: no memory. */
uint32_t sg_shading_add_plane(sg_shading *s, const double q[4]);

/* slice.c: an end of a slice in 1/256 dot, of one in dots. */
int32_t sg_slice_end(const sg_shading_work *work, double x);

/* slice.c: the slices of the line y, unordered; those of one thing of a band
 * come behind what is there. */
bool sg_slices_of_line(sg_shading_work *work, double y);
bool sg_slices_of_item(sg_shading_work *work, const sg_shading_item *item,
                       double y);

/* By so much more than what is one group a slice is behind another one for
 * certain. */
#define SG_SLICE_MARGIN(tolerance) (4.0 * (tolerance) + 1e-8)

/* hidden_slice.c: work->slice without what is hidden behind other slices, if
 * all is opaque. What is seen stays the same. False: no memory. */
bool sg_drop_hidden_slices(sg_shading_work *work);

/* crossing.c: whether s, no torus, is more than t behind `front`, which is none
 * either, all the way from x1 to x2, in dots. What is not certain is false. */
bool sg_slice_is_behind(const sg_slice *front, const sg_slice *s, double x1,
                        double x2, double t);

/* crossing.c: the first place strictly between x1 and x2, in 1/256 dot, where
 * two slices, of which p is the nearer one in the middle or in one place with
 * q, may stop being so; x1: there is none. */
int32_t sg_slices_cross(const sg_active *p, const sg_active *q, int32_t x1,
                        int32_t x2, double tolerance);

/* walk.c: work->layer becomes what is seen of slices in order of depth in the
 * middle. In *last the place of the last slice of the last group that matters;
 * n: all do. False: no memory. */
bool sg_walk_slices(sg_shading_work *work, const sg_active *active, size_t n,
                    size_t *last);

/* A linear form of the place in the picture, from `at`. */
typedef struct sg_linear_form {
  double c[4];
} sg_linear_form;

/* Of a frame: what (x, y, h, 1) in it is in the picture, from `at`, in columns;
 * and its inverse, in rows. */
typedef struct sg_seen_frame {
  double at[3];
  double column[4][4];
  sg_linear_form row[4];
} sg_seen_frame;

/* shading_body.c: false: the centre is not in front of the eye, or the frame
 * is flat. */
bool sg_shading_see_frame(const sg_shading *s, const double frame[4][3],
                          sg_seen_frame *out);

/* shading_body.c: q += part (form)^2 */
void sg_add_square(double q[10], const sg_linear_form *form, double part);

/* shading_body.c: the right half becomes the inverse of the left one. False:
 * there is none. */
bool sg_shading_invert(double a[4][8]);

/* flush.c: planes and quadrics that lie in one another become one surface. */
sg_shading_end sg_shading_merge(sg_shading *scene, const sg_cancel *cancel);

#endif
