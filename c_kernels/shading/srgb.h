/* srgb.h -- bytes of a picture as light, and light as bytes.
 *
 * Layer: kernel. Light is linear, 0 to 65535; a byte is what IEC 61966-2-1
 * (sRGB) has for it. Tables of whole numbers: the same on every machine.
 */
#ifndef SG_SRGB_H
#define SG_SRGB_H

#include <stdint.h>

#define SG_LIGHT_MOST 65535

/* The light of a byte. */
uint16_t sg_srgb_light(uint8_t byte);

/* The byte of a light, 0 .. SG_LIGHT_MOST: the nearest. */
uint8_t sg_srgb_byte(uint32_t light);

/* Fills the byte of each light: the nearest. */
void sg_srgb_bytes(uint8_t byte[SG_LIGHT_MOST + 1]);

#endif
