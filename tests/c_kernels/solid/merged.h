/* merged.h -- merging the faces of a solid, for tests.
 */
#ifndef SG_TEST_MERGED_H
#define SG_TEST_MERGED_H

#include "solid/face_merge.h"
#include "solid_shape.h"

#include <stdio.h>

static const double TOLERANCE = 1e-10;

static inline sg_merge_end
merge(sg_solid *solid, double tolerance)
{
  sg_merge_options options = {.tolerance = tolerance};

  return sg_face_merge(solid, &options, NULL);
}

static inline bool
has(const sg_solid *solid, size_t faces, size_t vertices, size_t edges)
{
  size_t loose;
  feature_counts counts = solid_counts(solid, &loose);
  bool right = counts.faces == faces && counts.vertices == vertices &&
               counts.edges == edges && loose == 0 && is_closed(solid);

  if (!right) {
    fprintf(
        stderr, "%zu faces, %zu vertices, %zu edges, %zu loose, closed %d\n",
        counts.faces, counts.vertices, counts.edges, loose, is_closed(solid));
  }
  return right;
}

static inline bool
is_near(double a, double b, double most)
{
  return fabs(a - b) <= most;
}

/* Merges; true if it has what it should have, and no other volume and area. */
static inline bool
merged_is(sg_solid *solid, double tolerance, size_t faces, size_t vertices,
          size_t edges)
{
  double volume[2], area[2];

  measure(solid, &volume[0], &area[0]);
  if (merge(solid, tolerance) != SG_MERGE_DONE) {
    return false;
  }
  measure(solid, &volume[1], &area[1]);
  return has(solid, faces, vertices, edges) &&
         is_near(volume[0], volume[1], 1e-13 + 4 * area[0] * tolerance) &&
         is_near(area[0], area[1], 1e-13 + 40 * area[0] * tolerance);
}

#endif
