/* canvas.c -- see canvas.h.
 *
 * Each piece of a line covers dots in a strip along it. The cover of the whole
 * line, the largest of its pieces', is collected beside the picture, then laid
 * on it and wiped off again, over the box that the line has touched.
 */
#include "canvas.h"

#include <math.h>
#include <stdlib.h>

/* Dots looked at between two cancellations; a piece counts as some. */
enum { ASK_EVERY = 1 << 16, A_PIECE = 256 };

/* Rows and columns from low up to, not with, high. */
typedef struct box {
  int32_t x0, y0, x1, y1;
} box;

/* A piece from a to b: its unit direction and length; whether the line ends at
 * either without a round end. */
typedef struct piece {
  double ax, ay, dx, dy, length;
  bool flat_a, flat_b;
} piece;

bool
sg_canvas_open(sg_canvas *out, int32_t width, int32_t height,
               const sg_colour paper)
{
  size_t n = (size_t)width * (size_t)height;

  *out = (sg_canvas){width, height, malloc(n * sizeof *out->dot), calloc(n, 1)};
  if (!out->dot || !out->cover) {
    sg_canvas_clear(out);
    return false;
  }
  for (size_t i = 0; i < 3 * n; i++) {
    out->dot[i / 3][i % 3] = paper[i % 3];
  }
  return true;
}

void
sg_canvas_clear(sg_canvas *canvas)
{
  free(canvas->dot);
  free(canvas->cover);
  canvas->dot = NULL;
  canvas->cover = NULL;
}

/* How much of the interval of breadth 1 round `at` is within -half .. half. */
static double
overlap(double at, double half)
{
  double low = fmax(at - 0.5, -half), high = fmin(at + 0.5, half);

  return fmax(0, high - low);
}

/* How much of the dot whose middle is x, y the piece covers. */
static double
piece_cover(const piece *p, double half, double x, double y)
{
  double along = (x - p->ax) * p->dx + (y - p->ay) * p->dy;
  double across = (y - p->ay) * p->dx - (x - p->ax) * p->dy;
  double beyond = fmax(-along, along - p->length);
  double away = fabs(across), share = 1;

  if (beyond > 0) { /* round the nearer end */
    away = sqrt(across * across + beyond * beyond);
  }
  if (along < p->length / 2 ? p->flat_a : p->flat_b) {
    share = fmin(1, fmax(0, 0.5 - beyond));
    away = fabs(across);
  }
  return share * overlap(away, half);
}

static int32_t
clamped(double x, int32_t most)
{
  return x <= 0 ? 0 : x >= most ? most : (int32_t)x;
}

static void
grow(box *touched, box more)
{
  touched->x0 = more.x0 < touched->x0 ? more.x0 : touched->x0;
  touched->y0 = more.y0 < touched->y0 ? more.y0 : touched->y0;
  touched->x1 = more.x1 > touched->x1 ? more.x1 : touched->x1;
  touched->y1 = more.y1 > touched->y1 ? more.y1 : touched->y1;
}

/* The columns of row y that are within `reach` of the piece: those of its part
 * that is within `reach` of the row, and `reach` to both sides. */
static box
row_box(const sg_canvas *canvas, const piece *p, double reach, int32_t y)
{
  double from = 0, to = p->length;

  if (fabs(p->dy) > 1e-9) {
    double one = (y + 0.5 - reach - p->ay) / p->dy;
    double two = (y + 0.5 + reach - p->ay) / p->dy;

    from = fmin(to, fmax(from, fmin(one, two)));
    to = fmax(from, fmin(to, fmax(one, two)));
  }

  double xa = p->ax + from * p->dx, xb = p->ax + to * p->dx;

  return (box){clamped(floor(fmin(xa, xb) - reach), canvas->width), y,
               clamped(ceil(fmax(xa, xb) + reach) + 1, canvas->width), y + 1};
}

/* True when so many dots more have been looked at and the cancellation says
 * stop. */
static bool
stop_after(size_t dots, size_t *looked_at, const sg_cancel *cancel)
{
  *looked_at += dots;
  if (*looked_at < ASK_EVERY) {
    return false;
  }
  *looked_at = 0;
  return sg_cancelled(cancel);
}

/* False: stopped. */
static bool
cover_piece(sg_canvas *canvas, const piece *p, double half, box *touched,
            size_t *looked_at, const sg_cancel *cancel)
{
  double reach = half + 1;
  double yb = p->ay + p->length * p->dy;
  int32_t y0 = clamped(floor(fmin(p->ay, yb) - reach), canvas->height);
  int32_t y1 = clamped(ceil(fmax(p->ay, yb) + reach) + 1, canvas->height);

  for (int32_t y = y0; y < y1; y++) {
    box row = row_box(canvas, p, reach, y);
    uint8_t *cover = canvas->cover + (size_t)y * (size_t)canvas->width;

    for (int32_t x = row.x0; x < row.x1; x++) {
      double part = piece_cover(p, half, x + 0.5, y + 0.5);
      uint8_t level = (uint8_t)(255 * fmin(1, part) + 0.5);

      if (level > cover[x]) {
        cover[x] = level;
      }
    }
    grow(touched, row);
    if (stop_after(row.x1 > row.x0 ? (size_t)(row.x1 - row.x0) : 0, looked_at,
                   cancel)) {
      return false;
    }
  }
  return !stop_after(A_PIECE, looked_at, cancel);
}

/* Lays what is covered on the picture, and wipes the cover off. False:
 * stopped. */
static bool
lay(sg_canvas *canvas, const sg_colour colour, box where,
    const sg_cancel *cancel)
{
  size_t looked_at = 0;

  for (int32_t y = where.y0; y < where.y1 && where.x0 < where.x1; y++) {
    if (stop_after((size_t)(where.x1 - where.x0), &looked_at, cancel)) {
      return false;
    }
    size_t row = (size_t)y * (size_t)canvas->width;

    for (int32_t x = where.x0; x < where.x1; x++) {
      uint8_t *dot = canvas->dot[row + (size_t)x];
      int level = canvas->cover[row + (size_t)x];

      for (int i = 0; i < 3 && level; i++) {
        dot[i] =
            (uint8_t)((dot[i] * (255 - level) + colour[i] * level + 127) / 255);
      }
      canvas->cover[row + (size_t)x] = 0;
    }
  }
  return true;
}

static piece
piece_between(const double a[2], const double b[2])
{
  double x = b[0] - a[0], y = b[1] - a[1];
  double length = sqrt(x * x + y * y);
  bool none = !(length > 0);

  return (piece){.ax = a[0],
                 .ay = a[1],
                 .dx = none ? 1 : x / length,
                 .dy = none ? 0 : y / length,
                 .length = length};
}

bool
sg_canvas_line(sg_canvas *canvas, const sg_brush *brush, size_t n,
               const double (*point)[2], const sg_cancel *cancel)
{
  box touched = {canvas->width, canvas->height, 0, 0};
  size_t pieces = n > 1 ? n - 1 : 1, looked_at = 0;

  if (sg_cancelled(cancel)) {
    return false;
  }
  for (size_t i = 0; i < pieces; i++) {
    piece p = piece_between(point[i], point[n > 1 ? i + 1 : i]);

    p.flat_a = !brush->round && i == 0;
    p.flat_b = !brush->round && i == pieces - 1;
    if (!cover_piece(canvas, &p, brush->width / 2, &touched, &looked_at,
                     cancel)) {
      return false;
    }
  }
  return lay(canvas, brush->colour, touched, cancel);
}
