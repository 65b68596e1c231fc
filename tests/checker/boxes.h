/* boxes.h -- which boxes touch each other, for the checker of results. */
#ifndef SG_CHECKER_BOXES_H
#define SG_CHECKER_BOXES_H

#include <stddef.h>

typedef struct box {
  double low[3], high[3];
  int item;
} box;

typedef void box_visit(void *data, int item1, int item2);

/* Calls visit once for every two boxes that have a point in common. The boxes
 * change their order. */
void boxes_meeting(box *boxes, size_t n, box_visit *visit, void *data);

#endif
