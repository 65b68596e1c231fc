#include "soup.h"

#include "sign.h"

#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { MOST_CORNERS = 100000, MANY_CORNERS = 400 };

static void *
room(size_t n, size_t size)
{
  void *memory = calloc(n ? n : 1, size);

  if (!memory) {
    fputs("no memory\n", stderr);
    exit(2);
  }
  return memory;
}

void
soup_clear(soup *s)
{
  free(s->point);
  free(s->corner);
  *s = (soup){0};
}

/* - - - polygons as triangles - - - */

/* The coordinate along which the polygon is seen largest, and +1 or -1 where it
 * runs counter-clockwise from there; 0: it has no area. */
static int
axis_of(const soup *s, const int *loop, int n, int *axis)
{
  double normal[3] = {0, 0, 0};

  for (int i = 0; i < n; i++) {
    const double *o = s->point[loop[0]];
    const double *a = s->point[loop[i]], *b = s->point[loop[(i + 1) % n]];

    for (int k = 0; k < 3; k++) {
      int x = (k + 1) % 3, y = (k + 2) % 3;

      normal[k] +=
          (a[x] - o[x]) * (b[y] - o[y]) - (a[y] - o[y]) * (b[x] - o[x]);
    }
  }
  *axis = fabs(normal[0]) >= fabs(normal[1]) ? 0 : 1;
  *axis = fabs(normal[2]) > fabs(normal[*axis]) ? 2 : *axis;
  return normal[*axis] > 0 ? 1 : normal[*axis] < 0 ? -1 : 0;
}

/* True if corner i may be cut off: it turns left and no other corner is in the
 * triangle. */
static bool
is_ear(const soup *s, const int *loop, int n, int i, int axis, int turn)
{
  int x = (axis + 1) % 3, y = (axis + 2) % 3;
  const double *a = s->point[loop[(i + n - 1) % n]];
  const double *b = s->point[loop[i]], *c = s->point[loop[(i + 1) % n]];

  if (turn * sign_of_area(a, b, c, x, y) <= 0) {
    return false;
  }
  for (int k = 0; k < n; k++) {
    const double *p = s->point[loop[k]];

    if (memcmp(p, a, sizeof(double[3])) != 0 &&
        memcmp(p, b, sizeof(double[3])) != 0 &&
        memcmp(p, c, sizeof(double[3])) != 0 &&
        turn * sign_of_area(a, b, p, x, y) >= 0 &&
        turn * sign_of_area(b, c, p, x, y) >= 0 &&
        turn * sign_of_area(c, a, p, x, y) >= 0) {
      return false;
    }
  }
  return true;
}

/* The distance of p from the segment from a to c. */
static double
distance(const double *p, const double *a, const double *c)
{
  double along = 0, length = 0, square = 0;

  for (int k = 0; k < 3; k++) {
    along += (p[k] - a[k]) * (c[k] - a[k]);
    length += (c[k] - a[k]) * (c[k] - a[k]);
  }
  along = length > 0 ? along / length : 0;
  along = along < 0 ? 0 : along > 1 ? 1 : along;
  for (int k = 0; k < 3; k++) {
    double d = p[k] - a[k] - along * (c[k] - a[k]);

    square += d * d;
  }
  return sqrt(square);
}

/* How near the other corners come to the edge that cutting off corner i leaves:
 * one that goes through a corner up to rounding would fold the polygon. */
static double
clearance(const soup *s, const int *loop, int n, int i)
{
  const double *a = s->point[loop[(i + n - 1) % n]];
  const double *c = s->point[loop[(i + 1) % n]];
  double least = INFINITY;

  for (int k = 0; k < n; k++) {
    const double *p = s->point[loop[k]];

    if (memcmp(p, a, sizeof(double[3])) != 0 &&
        memcmp(p, c, sizeof(double[3])) != 0) {
      least = fmin(least, distance(p, a, c));
    }
  }
  return least;
}

/* The ear with most clearance, or -1; of large polygons any ear. */
static int
best_ear(const soup *s, const int *loop, int n, int axis, int turn)
{
  double most = -1;
  int best = -1;

  for (int i = 0; i < n && (n <= MANY_CORNERS || best < 0); i++) {
    double room_left = clearance(s, loop, n, i);

    if (room_left > most && is_ear(s, loop, n, i, axis, turn)) {
      most = room_left;
      best = i;
    }
  }
  return best;
}

static void
add_triangle(soup *s, int a, int b, int c)
{
  int *corner = s->corner[s->triangles++];

  corner[0] = a;
  corner[1] = b;
  corner[2] = c;
}

/* Ears of the polygon until a triangle is left; the loop is used up. */
static void
add_polygon(soup *s, int *loop, int n)
{
  int axis = 0, turn = n > 3 ? axis_of(s, loop, n, &axis) : 0;

  while (n > 3) {
    int i = best_ear(s, loop, n, axis, turn);

    if (i < 0) {
      s->unclear++;
      break;
    }
    add_triangle(s, loop[(i + n - 1) % n], loop[i], loop[(i + 1) % n]);
    memmove(loop + i, loop + i + 1, (size_t)(n - i - 1) * sizeof *loop);
    n--;
  }
  for (int i = 2; i < n; i++) {
    add_triangle(s, loop[0], loop[i - 1], loop[i]);
  }
}

/* - - - files - - - */

/* The whole file, with a zero after it. */
static char *
bytes_of(const char *name, size_t *size)
{
  FILE *file = fopen(name, "rb");
  char *bytes = NULL;
  long end;

  if (!file) {
    return NULL;
  }
  if (fseek(file, 0, SEEK_END) == 0 && (end = ftell(file)) >= 0) {
    rewind(file);
    bytes = room((size_t)end + 1, 1);
    *size = fread(bytes, 1, (size_t)end, file);
  }
  fclose(file);
  return bytes;
}

/* The next number of an OFF file; comments go to the end of their line. */
static bool
next_number(char **at, double *out)
{
  char *end;

  for (;;) {
    *at += strspn(*at, " \t\r\n");
    if (**at != '#') {
      break;
    }
    *at += strcspn(*at, "\n");
  }
  *out = strtod(*at, &end);
  if (end == *at || !isfinite(*out)) {
    return false;
  }
  *out += 0.0;
  *at = end;
  return true;
}

/* A whole number from low to high. */
static bool
next_count(char **at, double low, double high, int *out)
{
  double value;

  if (!next_number(at, &value) || value < low || value > high ||
      value != floor(value)) {
    return false;
  }
  *out = (int)value;
  return true;
}

static bool
read_faces(soup *s, char *at, int faces)
{
  int *loop = room(MOST_CORNERS, sizeof *loop);
  size_t space = 0;
  bool good = true;

  for (int f = 0; good && f < faces; f++) {
    int n;

    good = next_count(&at, 3, MOST_CORNERS, &n);
    for (int i = 0; good && i < n; i++) {
      good = next_count(&at, 0, (double)s->points - 1, &loop[i]);
    }
    if (good && s->triangles + (size_t)n > space) {
      space = 2 * space + (size_t)n + (size_t)faces;
      s->corner = realloc(s->corner, space * sizeof *s->corner);
      good = s->corner != NULL;
    }
    if (good) {
      add_polygon(s, loop, n);
    }
    at += strcspn(at, "\n"); /* past a colour */
  }
  free(loop);
  s->faces = (size_t)faces;
  return good;
}

static bool
read_off(soup *s, char *at)
{
  int points, faces, edges;

  at += 3;
  if (!next_count(&at, 0, 1e9, &points) || !next_count(&at, 0, 1e9, &faces) ||
      !next_count(&at, -1, 1e9, &edges)) {
    return false;
  }
  s->point = room((size_t)points, sizeof *s->point);
  for (int i = 0; i < 3 * points; i++) {
    if (!next_number(&at, &s->point[i / 3][i % 3])) {
      return false;
    }
  }
  s->points = (size_t)points;
  return read_faces(s, at, faces);
}

/* Three times `vertex X Y Z` after another are a triangle. */
static bool
read_stl_text(soup *s, char *at)
{
  size_t space = 0;

  while ((at = strstr(at, "vertex"))) {
    at += strlen("vertex");
    if (s->points == space) {
      space = 2 * space + 3072;
      s->point = realloc(s->point, space * sizeof *s->point);
    }
    for (int k = 0; k < 3; k++) {
      double value;

      if (!s->point || !next_number(&at, &value)) {
        return false;
      }
      s->point[s->points][k] = value;
    }
    s->points++;
  }
  s->triangles = s->faces = s->points / 3;
  s->corner = room(s->triangles, sizeof *s->corner);
  for (size_t i = 0; i < 3 * s->triangles; i++) {
    s->corner[i / 3][i % 3] = (int)i;
  }
  return s->points % 3 == 0;
}

static bool
read_stl(soup *s, const char *bytes, size_t size)
{
  uint32_t n;

  memcpy(&n, bytes + 80, sizeof n);
  if (size < 84 + 50 * (size_t)n) {
    return false;
  }
  s->point = room(3 * (size_t)n, sizeof *s->point);
  s->corner = room(n, sizeof *s->corner);
  s->points = 3 * (size_t)n;
  s->triangles = s->faces = n;
  for (size_t i = 0; i < s->points; i++) {
    float at[3];

    memcpy(at, bytes + 84 + 50 * (i / 3) + 12 + 12 * (i % 3), sizeof at);
    for (int k = 0; k < 3; k++) {
      if (!isfinite(at[k])) {
        return false;
      }
      s->point[i][k] = (double)at[k] + 0.0;
    }
    s->corner[i / 3][i % 3] = (int)i;
  }
  return true;
}

/* What says `facet` after `solid` is text. */
static bool
read_bytes(soup *s, char *bytes, size_t size)
{
  if (strncmp(bytes, "OFF", 3) == 0) {
    return read_off(s, bytes);
  }
  if (strncmp(bytes, "solid", 5) == 0 && strstr(bytes, "facet")) {
    return read_stl_text(s, bytes);
  }
  return size >= 84 && read_stl(s, bytes, size);
}

bool
soup_read(soup *s, const char *file, const char **problem)
{
  size_t size = 0;
  char *bytes = bytes_of(file, &size);
  bool good;

  *s = (soup){0};
  *problem = bytes ? "neither OFF nor STL" : "cannot be opened";
  good = bytes && read_bytes(s, bytes, size);
  free(bytes);
  return good;
}

/* - - - points in one place - - - */

typedef struct place {
  double at[3];
  int point;
} place;

static int
by_place(const void *a, const void *b)
{
  const place *p = a, *q = b;

  for (int k = 0; k < 3; k++) {
    if (p->at[k] != q->at[k]) {
      return p->at[k] < q->at[k] ? -1 : 1;
    }
  }
  return p->point < q->point ? -1 : p->point > q->point;
}

void
soup_merge(soup *s)
{
  place *places = room(s->points, sizeof *places);
  int *first = room(s->points, sizeof *first);

  for (size_t i = 0; i < s->points; i++) {
    memcpy(places[i].at, s->point[i], sizeof places[i].at);
    places[i].point = (int)i;
  }
  qsort(places, s->points, sizeof *places, by_place);
  for (size_t i = 0; i < s->points; i++) {
    bool same = i > 0 && memcmp(places[i].at, places[i - 1].at,
                                sizeof places[i].at) == 0;

    first[places[i].point] =
        same ? first[places[i - 1].point] : places[i].point;
  }
  for (size_t i = 0; i < 3 * s->triangles; i++) {
    s->corner[i / 3][i % 3] = first[s->corner[i / 3][i % 3]];
  }
  free(places);
  free(first);
}
