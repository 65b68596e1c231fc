/* image_lzw.c -- see image_lzw.h. */
#include "image_lzw.h"

#include "engine/list.h"

#include <stdlib.h>
#include <string.h>

enum {
  CLEAR = 256,
  END,
  FIRST, /* of the codes of longer strings */
  LAST = 4094,
  LEAST_BITS = 9
};

typedef struct packing {
  uint16_t (*longer)[256]; /* of a code and a byte: the code of both, 0: none */
  unsigned last, bits;     /* the last code that is there; how wide they are */
  uint32_t rest;           /* bits not written yet */
  unsigned resting;
  SG_LIST_OF(uint8_t) out;
} packing;

static bool
put(packing *p, unsigned code)
{
  p->rest = p->rest << p->bits | code;
  for (p->resting += p->bits; p->resting >= 8; p->resting -= 8) {
    if (!SG_PUSH(p->out, (uint8_t)(p->rest >> (p->resting - 8)))) {
      return false;
    }
  }
  return true;
}

static bool
put_clear(packing *p)
{
  bool good = put(p, CLEAR);

  memset(p->longer, 0, FIRST * sizeof *p->longer);
  p->last = FIRST - 1;
  p->bits = LEAST_BITS;
  return good;
}

/* A code for that of `before` and the byte behind it. */
static bool
add_code(packing *p, unsigned before, uint8_t byte)
{
  p->longer[before][byte] = (uint16_t)++p->last;
  memset(p->longer[p->last], 0, sizeof *p->longer);
  p->bits += p->last == (1U << p->bits) - 1;
  return p->last < LAST || put_clear(p);
}

static bool
pack(packing *p, const uint8_t *byte, size_t n)
{
  unsigned code = n > 0 ? byte[0] : END;
  bool good = put_clear(p);

  for (size_t i = 1; good && i < n; i++) {
    unsigned longer = p->longer[code][byte[i]];
    if (longer == 0) {
      good = put(p, code) && add_code(p, code, byte[i]);
      longer = byte[i];
    }
    code = longer;
  }
  if (n > 0 && good) { /* whoever reads this has a code more then */
    good = put(p, code);
    p->bits += p->last + 1 == (1U << p->bits) - 1;
  }
  good = good && put(p, END);
  p->bits = 8 - p->resting % 8;
  return good && put(p, 0);
}

bool
sg_image_lzw(const uint8_t *byte, size_t n, uint8_t **out, size_t *packed)
{
  packing p = {.longer = malloc((LAST + 1) * sizeof *p.longer),
               .bits = LEAST_BITS};
  bool good = p.longer && pack(&p, byte, n);

  free(p.longer);
  if (!good) {
    free(p.out.item);
    p.out.item = NULL;
    p.out.n = 0;
  }
  *out = p.out.item;
  *packed = p.out.n;
  return good;
}
