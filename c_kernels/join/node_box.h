/* node_box.h -- boxes along their own axes round what is below the nodes of a
 * tree.
 *
 * Layer: kernel. Triangles that run several ways askew (of shells or rings in
 * each other) overlap in boxes along x, y and z wherever they are. Those below
 * one node are near each other, and mostly run one way: boxes along it show
 * nodes to be apart.
 */
#ifndef SG_NODE_BOX_H
#define SG_NODE_BOX_H

#include "bvh.h"
#include "fan.h"

typedef struct sg_node_boxes sg_node_boxes;

/* *out is null if boxes of the tree overlap so few others that it is not worth
 * it; what is near and no farther apart than `reach` along each axis counts as
 * met. False: no memory, or the cancellation said stop. Owner:
 * sg_node_boxes_close() in any case. Cost: n log n. */
bool sg_node_boxes_open(const sg_bvh *tree, double reach, sg_fan_read *read,
                        const void *data, const sg_cancel *cancel,
                        sg_node_boxes **out);
void sg_node_boxes_close(sg_node_boxes *boxes);

/* An sg_bvh_apart: whether all triangles below box a of a level are apart from
 * all below box b. */
bool sg_node_boxes_apart(const void *boxes, unsigned level, size_t a, size_t b);

#endif
