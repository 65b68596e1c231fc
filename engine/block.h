/* block.h -- memory in pieces of the system's pages, apart from the heap.
 *
 * Layer: store. What a world holds comes and goes with it, by the megabyte,
 * while what is small and lives longer is made in between. In one heap each
 * such piece takes a bite from a hole that the next world would just fit into,
 * so a process that makes worlds for hours would grow. Nothing here is touched
 * before somebody writes it. Any thread may call.
 */
#ifndef SG_BLOCK_H
#define SG_BLOCK_H

#include <stddef.h>

enum { SG_BLOCK_BYTES = 1 << 14 };

/* A block begins at a multiple of its size; its content is anything. Null: no
 * memory. */
void *sg_block_take(void);
void sg_block_give(void *block);

/* Its content is anything; null: no memory. Close wants the same number of
 * bytes. A few that were closed last are kept, to be opened again. */
void *sg_span_open(size_t bytes);
void sg_span_close(void *span, size_t bytes);

#endif
