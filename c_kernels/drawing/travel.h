/* travel.h -- lines in an order that a lifted pen likes: the rule of
 * rules/drawing/travel.pl fused.
 *
 * Layer: kernel. From where a line ends the pen goes to the nearest end of
 * those not yet drawn; of equally near ones to the line that comes first, and
 * to its start. About log n for each line.
 */
#ifndef SG_TRAVEL_H
#define SG_TRAVEL_H

#include "engine/cancel.h"

#include <stddef.h>
#include <stdint.h>

/* Where a line starts and ends on the sheet: x, y. */
typedef struct sg_travel_line {
  int32_t at[2][2];
} sg_travel_line;

/* In the order that is given, or in a short one. */
typedef enum sg_travel_how { SG_TRAVEL_KEPT, SG_TRAVEL_SHORT } sg_travel_how;

/* The order of n lines, fewer than 2^30, for a pen that begins at `from`:
 * order[n] are their numbers, from 1; below zero: from end to start. False:
 * stopped by the cancellation, or no memory (then *memory is false). */
bool sg_travel_order(const sg_travel_line *line, size_t n,
                     const int32_t from[2], int32_t *order,
                     const sg_cancel *cancel, bool *memory);

/* How far the lifted pen goes that draws n lines in this order; null: as they
 * are. */
double sg_travel_length(const sg_travel_line *line, size_t n,
                        const int32_t from[2], const int32_t *order);

#endif
