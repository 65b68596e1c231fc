/* image_lzw.h -- the dots of a picture, packed for the filter LZWDecode.
 *
 * Layer: kernel. Red, green and blue in turn, by rows. Codes of 9 to 12 bits,
 * the highest bit first, wider one code early. Source: Adobe, PostScript
 * Language Reference, third edition, 3.13.3.
 */
#ifndef SG_IMAGE_LZW_H
#define SG_IMAGE_LZW_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* Owner: free(*out). False: no memory. */
bool sg_image_lzw(const uint8_t *byte, size_t n, uint8_t **out, size_t *packed);

#endif
