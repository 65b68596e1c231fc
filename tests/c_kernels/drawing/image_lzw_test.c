/* image_lzw_test.c -- what is packed is what a decoder makes of it. */
#include "drawing/image_lzw.h"

#include "tests/check.h"

#include <stdlib.h>
#include <string.h>

typedef struct reading {
  const uint8_t *in;
  size_t n, bit;
} reading;

static unsigned
next_code(reading *r, unsigned bits)
{
  unsigned code = 0;

  for (unsigned i = 0; i < bits; i++, r->bit++) {
    unsigned byte = r->bit / 8 < r->n ? r->in[r->bit / 8] : 0;
    code = code << 1 | (byte >> (7 - r->bit % 8) & 1);
  }
  return code;
}

/* A string is a place in what was read, and its length. */
typedef struct string {
  size_t at, n;
} string;

static size_t
unpacked(const uint8_t *in, size_t n, uint8_t *out, size_t room)
{
  string table[4097] = {{0}};
  reading r = {in, n, 0};
  size_t made = 0, codes = 258;
  bool first = true;

  for (;;) {
    unsigned bits = codes < 511    ? 9
                    : codes < 1023 ? 10
                    : codes < 2047 ? 11
                                   : 12;
    unsigned code = next_code(&r, bits);
    if (code == 257 || r.bit > 8 * n) {
      return code == 257 ? made : SIZE_MAX;
    }
    if (code == 256) {
      codes = 258;
      first = true;
      continue;
    }
    if (!first) { /* the string before, and a byte of this one */
      table[codes].n++;
      codes++;
    }
    string s = code < 256 ? (string){made, 1} : table[code];
    if (codes > 4096 || made + s.n > room || (code >= 258 && code >= codes)) {
      return SIZE_MAX;
    }
    for (size_t i = 0; i < s.n; i++) {
      out[made + i] = code < 256 ? (uint8_t)code : out[s.at + i];
    }
    table[codes] = (string){made, s.n};
    made += s.n;
    first = false;
  }
}

static void
check_same(const char *name, const uint8_t *byte, size_t n)
{
  uint8_t *packed = NULL, *back = malloc(n + 1);
  size_t packed_n = 0;

  CHECK(name, sg_image_lzw(byte, n, &packed, &packed_n));
  CHECK(name,
        unpacked(packed, packed_n, back, n) == n && memcmp(back, byte, n) == 0);
  free(packed);
  free(back);
}

int
main(void)
{
  enum { MANY = 300000 };
  uint8_t *byte = malloc(MANY);
  uint32_t seed = 5;

  memset(byte, 7, MANY);
  check_same("nothing", byte, 0);
  check_same("one", byte, 1);
  check_same("all alike", byte, MANY);
  for (size_t i = 0; i < MANY; i++) {
    byte[i] = (uint8_t)check_below(&seed, 256);
  }
  check_same("any", byte, MANY);
  for (size_t n = 200; n < 4600; n += 1) { /* ends where codes grow */
    check_same("any, so many", byte, n);
  }
  for (size_t i = 0; i < MANY; i++) {
    byte[i] = (uint8_t)(i / 300 % 7 * 30 + (size_t)check_below(&seed, 2));
  }
  check_same("like a picture", byte, MANY);
  free(byte);
  return check_report();
}
