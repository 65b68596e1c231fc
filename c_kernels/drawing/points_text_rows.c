/* points_text_rows.c -- points of a sheet as text. */
#include "doors/drawing.h"

#include <string.h>

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

static size_t
most_octets(const sg_sheet_point_list *points)
{
  return points->n * LONGEST;
}

/* At most most_octets(); where they end. */
static uint8_t *
put_points(uint8_t *to, const sg_sheet_point_list *points)
{
  for (size_t i = 0; i < points->n; i++) {
    if (i > 0) {
      *to++ = ' ';
    }
    to = put_thousandths(to, points->at[i].x);
    *to++ = ',';
    to = put_thousandths(to, points->at[i].y);
  }
  return to;
}

bool
sg_door_points_text(sg_call *call, const sg_sheet_point_list *points,
                    sg_bytes *text)
{
  uint8_t *begin = sg_call_alloc(call, most_octets(points));

  if (!begin) {
    return false;
  }
  *text = (sg_bytes){begin, (size_t)(put_points(begin, points) - begin)};
  return true;
}

bool
sg_door_thousandths_text(sg_call *call, const sg_integer_list *numbers,
                         sg_bytes *text)
{
  uint8_t *begin = sg_call_alloc(call, numbers->n * LONGEST), *end = begin;

  for (size_t i = 0; begin && i < numbers->n; i++) {
    if (i > 0) {
      *end++ = ' ';
    }
    end = put_thousandths(end, numbers->at[i]);
  }
  *text = (sg_bytes){begin, (size_t)(end - begin)};
  return begin != NULL;
}

bool
sg_door_points_written(sg_call *call, const sg_output *stream,
                       const char *before, const sg_sheet_point_list *points,
                       const char *after)
{
  size_t first = strlen(before), last = strlen(after);
  char *begin = sg_call_alloc(call, first + most_octets(points) + last);
  char *end;

  if (!begin) {
    return false;
  }
  memcpy(begin, before, first);
  end = (char *)put_points((uint8_t *)begin + first, points);
  memcpy(end, after, last);
  return stream->write(stream->data, begin, (size_t)(end - begin) + last);
}
