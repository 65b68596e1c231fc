/* ids.h -- the last id used, and the stamp of the last change, by segment.
 *
 * Layer: store, private. What one version knows of one relation. Entries stand
 * by segment on leaves of a few, which a directory lists; both are counted by
 * their holders and copied when written while somebody else holds them. So a
 * change of one segment costs the directory and one leaf, however many segments
 * there are, also for an undo step that keeps what was before.
 */
#ifndef SG_IDS_H
#define SG_IDS_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

typedef struct sg_ids_entry {
  int32_t s, last; /* 0: none */
  uint64_t stamp;  /* 0: none */
} sg_ids_entry;

typedef struct sg_ids sg_ids; /* null: no entry */

sg_ids *sg_ids_hold(sg_ids *ids);
void sg_ids_drop(sg_ids *ids);
/* The entry of s, null: none. */
const sg_ids_entry *sg_ids_find(const sg_ids *ids, int32_t s);
/* The same for writing, made if it is new; *ids becomes its holder's own. Null:
 * no memory, *ids says what it did. */
sg_ids_entry *sg_ids_reach(sg_ids **ids, int32_t s);
/* The entries of n segments (ascending) and no more. False: no memory. */
bool sg_ids_narrow(const sg_ids *ids, const int32_t *s, size_t n, sg_ids **out);
/* All entries get this stamp. False: no memory. */
bool sg_ids_stamp_all(sg_ids **ids, uint64_t stamp);
uint64_t sg_ids_last_stamp(const sg_ids *ids); /* the newest, 0: none */
/* The bytes of one of its holders, where all share the cost: over all holders
 * the shares are the whole. */
double sg_ids_share(const sg_ids *ids);
/* Entries ascend, leaves have at least one. */
bool sg_ids_is_valid(const sg_ids *ids);

#endif
