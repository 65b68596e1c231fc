/* points_text_rows.c -- points_text/2. */
#include "doors/drawing.h"

enum { LONGEST = 2 * 22 + 2 }; /* octets of a point, and what is around it */

/* The digits of n, at least one; where they end. */
static uint8_t *
put_whole(uint8_t *to, uint64_t n)
{
  uint8_t digit[20];
  int digits = 0;

  do {
    digit[digits++] = (uint8_t)('0' + n % 10);
    n /= 10;
  } while (n > 0);
  while (digits > 0) {
    *to++ = digit[--digits];
  }
  return to;
}

/* n thousandths without zeros at the end; where they end. */
static uint8_t *
put_thousandths(uint8_t *to, int64_t n)
{
  uint64_t size = n < 0 ? 0 - (uint64_t)n : (uint64_t)n;

  if (n < 0) {
    *to++ = '-';
  }
  to = put_whole(to, size / 1000);
  size %= 1000;
  if (size > 0) {
    *to++ = '.';
  }
  for (; size > 0; size = size % 100 * 10) {
    *to++ = (uint8_t)('0' + size / 100);
  }
  return to;
}

bool
sg_door_points_text(sg_call *call, const sg_sheet_point_list *points,
                    sg_bytes *text)
{
  uint8_t *begin = sg_call_alloc(call, points->n * LONGEST), *end = begin;

  if (!begin) {
    return false;
  }
  for (size_t i = 0; i < points->n; i++) {
    if (i > 0) {
      *end++ = ' ';
    }
    end = put_thousandths(end, points->at[i].x);
    *end++ = ',';
    end = put_thousandths(end, points->at[i].y);
  }
  *text = (sg_bytes){begin, (size_t)(end - begin)};
  return true;
}
