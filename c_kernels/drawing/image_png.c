/* image_png.c -- see image_png.h.
 *
 * Each block ends on a byte (Z_SYNC_FLUSH), and knows nothing of the one before
 * it, so what they are packed to is one stream of deflate. Its check sum is
 * that of the blocks together (adler32_combine).
 */
#include "image_png.h"

#include "png_chunk.h"

#include <stdatomic.h>
#include <stdlib.h>
#include <string.h>
#include <zlib.h>

enum {
  ROWS = 64,             /* of a block */
  BLOCK_BYTES = 1 << 23, /* if they are no more */
  FILTERS = 3,           /* none, the dot to the left, the one above */
  LEVEL = 6
};

typedef struct block {
  uint8_t *byte; /* packed, with room before and behind it for the chunk */
  size_t n;
  uLong check, raw; /* of what was packed */
} block;

typedef struct packing {
  const sg_image *image;
  const uint8_t *above; /* the row before the first one; null: there is none */
  bool first, last;     /* part of the file */
  int32_t rows;         /* of a block */
  block *block;
  size_t blocks;
  atomic_bool no_memory;
} packing;

static size_t
row_bytes(const sg_image *image)
{
  return (size_t)image->width * image->bytes;
}

int32_t
sg_image_png_block(size_t row)
{
  size_t rows = BLOCK_BYTES / (row > 0 ? row : 1);

  return rows < 1 ? 1 : rows > ROWS ? ROWS : (int32_t)rows;
}

/* ---- filters ---- */

/* How many bits it may take: the sum of all bytes, as numbers from -128. */
static uint64_t
weight(const uint8_t *byte, size_t n)
{
  uint64_t sum = 0;

  for (size_t i = 0; i < n; i++) {
    sum += byte[i] < 128 ? byte[i] : 256U - byte[i];
  }
  return sum;
}

/* The row without what a filter foretells; `above` may be null. */
static void
filter_row(unsigned filter, const uint8_t *row, const uint8_t *above, size_t n,
           size_t dot, uint8_t *out)
{
  const uint8_t *before = filter == 2 ? above : row;
  size_t from = filter == 1 ? dot : 0;

  *out++ = (uint8_t)filter;
  if (filter == 0 || !before) {
    memcpy(out, row, n);
    return;
  }
  memcpy(out, row, from);
  for (size_t i = from; i < n; i++) {
    out[i] = (uint8_t)(row[i] - before[i - from]);
  }
}

/* The row y by the filter that leaves least, to `out`; `other` is room. */
static void
best_row(const packing *all, int32_t y, uint8_t *out, uint8_t *other)
{
  const sg_image *image = all->image;
  size_t n = row_bytes(image);
  const uint8_t *row = image->dot + (size_t)y * n;
  const uint8_t *above = y > 0 ? row - n : all->above;
  uint64_t least = UINT64_MAX;

  for (unsigned filter = 0; filter < FILTERS; filter++) {
    filter_row(filter, row, above, n, image->bytes, other);
    uint64_t own = weight(other + 1, n);
    if (own < least) {
      least = own;
      memcpy(out, other, n + 1);
    }
  }
}

/* ---- blocks ---- */

static bool
deflate_block(block *out, uint8_t *raw, size_t n, size_t before, bool last)
{
  z_stream zip = {0};

  if (deflateInit2(&zip, LEVEL, Z_DEFLATED, -MAX_WBITS, MAX_MEM_LEVEL,
                   Z_DEFAULT_STRATEGY) != Z_OK) {
    return false;
  }
  size_t room = deflateBound(&zip, (uLong)n) + 16;
  int status = Z_MEM_ERROR;

  out->byte = malloc(before + room + SG_PNG_CHUNK);
  if (out->byte) {
    zip.next_in = raw;
    zip.avail_in = (uInt)n;
    zip.next_out = out->byte + before;
    zip.avail_out = (uInt)room;
    status = deflate(&zip, last ? Z_FINISH : Z_SYNC_FLUSH);
    out->n = zip.total_out;
  }
  (void)deflateEnd(&zip);
  out->raw = (uLong)n;
  out->check = adler32(adler32(0, NULL, 0), raw, (uInt)n);
  return status == (last ? Z_STREAM_END : Z_OK);
}

static bool
pack_block(packing *all, size_t k, uint8_t *raw)
{
  static const uint8_t start[2] = {0x78, 0x9c}; /* 32 KB, level 6 */
  const sg_image *image = all->image;
  int32_t rows = all->rows, from = (int32_t)k * rows, to = from + rows;
  size_t row = row_bytes(image) + 1;
  size_t more = k == 0 && all->first ? sizeof start : 0;
  block *out = &all->block[k];

  to = to < image->height ? to : image->height;
  for (int32_t y = from; y < to; y++) {
    best_row(all, y, raw + (size_t)(y - from) * row, raw + (size_t)rows * row);
  }
  if (!deflate_block(out, raw, (size_t)(to - from) * row, 8 + more,
                     k == all->blocks - 1 && all->last)) {
    return false;
  }
  memcpy(out->byte + 8, start, more);
  sg_png_file chunk = {out->byte, 0};
  sg_png_chunk(&chunk, "IDAT", NULL, out->n + more);
  out->n = chunk.n;
  return true;
}

static void
do_block(void *data, size_t k)
{
  packing *all = data;
  uint8_t *raw = malloc(((size_t)all->rows + 1) * (row_bytes(all->image) + 1));

  if (!raw || !pack_block(all, k, raw)) {
    atomic_store(&all->no_memory, true);
  }
  free(raw);
}

/* ---- the file ---- */

static void
put_check(sg_png_file *out, unsigned long check)
{
  uint8_t byte[4];

  for (int i = 0; i < 4; i++) {
    byte[i] = (uint8_t)(check >> (24 - 8 * i));
  }
  sg_png_chunk(out, "IDAT", byte, sizeof byte);
}

static void
put_head(sg_png_file *out, const sg_image *image, int32_t height,
         uint32_t per_metre)
{
  sg_png_start(out, image->width, height, 8,
               image->bytes == 4 ? SG_PNG_WITH_ALPHA : SG_PNG_TRUECOLOUR);
  sg_png_srgb(out);
  if (per_metre > 0) {
    sg_png_physical(out, per_metre);
  }
}

static bool
put_part(const packing *all, sg_png_parts *parts, uint32_t per_metre,
         sg_png_file *out)
{
  size_t room = SG_PNG_HEAD;

  for (size_t k = 0; k < all->blocks; k++) {
    room += all->block[k].n;
  }
  *out = (sg_png_file){malloc(room), 0};
  if (!out->byte) {
    return false;
  }
  if (all->first) {
    put_head(out, all->image, parts->height, per_metre);
    parts->check = adler32(0, NULL, 0);
  }
  for (size_t k = 0; k < all->blocks; k++) {
    const block *own = &all->block[k];
    memcpy(out->byte + out->n, own->byte, own->n);
    out->n += own->n;
    parts->check = adler32_combine(parts->check, own->check, (z_off_t)own->raw);
  }
  if (all->last) {
    put_check(out, parts->check);
    sg_png_chunk(out, "IEND", (const uint8_t *)"", 0);
  }
  return true;
}

void
sg_png_parts_clear(sg_png_parts *parts)
{
  free(parts->above);
  parts->above = NULL;
}

/* Its last row is the one above the next part. */
static bool
keep_row(sg_png_parts *parts, const sg_image *part)
{
  size_t n = row_bytes(part);

  parts->done += part->height;
  parts->above = parts->above ? parts->above : malloc(n);
  if (parts->above) {
    memcpy(parts->above, part->dot + ((size_t)part->height - 1) * n, n);
  }
  return parts->above != NULL;
}

sg_png_status
sg_image_png_part(sg_png_parts *parts, const sg_image *part, uint32_t per_metre,
                  sg_pool *pool, const sg_cancel *cancel, uint8_t **bytes,
                  size_t *n)
{
  int32_t rows = sg_image_png_block(row_bytes(part));
  size_t blocks = ((size_t)part->height + (size_t)rows - 1) / (size_t)rows;
  packing all = {.image = part,
                 .above = parts->above,
                 .first = parts->done == 0,
                 .last = parts->done + part->height >= parts->height,
                 .rows = rows,
                 .block = calloc(blocks, sizeof(block)),
                 .blocks = blocks};
  sg_png_file out = {NULL, 0};
  sg_png_status status = SG_PNG_NO_MEMORY;

  atomic_init(&all.no_memory, false);
  if (all.block) {
    status = !sg_pool_run(pool, blocks, do_block, &all, cancel) ? SG_PNG_STOPPED
             : !atomic_load(&all.no_memory) &&
                     put_part(&all, parts, per_metre, &out) &&
                     (all.last || keep_row(parts, part))
                 ? SG_PNG_OK
                 : SG_PNG_NO_MEMORY;
  }
  for (size_t k = 0; all.block && k < blocks; k++) {
    free(all.block[k].byte);
  }
  free(all.block);
  if (status != SG_PNG_OK) {
    free(out.byte);
    out = (sg_png_file){NULL, 0};
  }
  *bytes = out.byte;
  *n = out.n;
  return status;
}
