/* index_hash.h -- what an index is asked by: hashes of values.
 *
 * Layer: store, private. The high bits are mixed; the low SG_NEAR_BITS are
 * those of the last id, so that ids next to one another share a cache line of
 * heads.
 */
#ifndef SG_INDEX_HASH_H
#define SG_INDEX_HASH_H

#include "index.h"

enum { SG_NEAR_BITS = 4 }; /* 2^4 heads fill a cache line */

/* Of the values in the columns of the mask; row[c] is that of column c. */
uint64_t sg_index_hash(const sg_relation_info *info, uint16_t mask,
                       const sg_value *row);
/* The same, of a row that is written, for an index that is none of members. */
uint64_t sg_index_hash_row(const sg_index *index, const struct sg_table *table,
                           sg_row row);
/* Of a member of a row of segment s. */
uint64_t sg_index_hash_member(int32_t s, int32_t member);

#endif
