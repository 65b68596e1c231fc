/* sphere_stl.c -- writes a binary STL of a wavy sphere with about N triangles
 * to standard output: sphere_stl N [X [Y [Z]]] > FILE. Its radius is about 10,
 * its centre X, Y, Z. Closed; the same bytes every time.
 */
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

static unsigned rows, columns;
static double centre[3];

/* The corner at this row (0: north pole, `rows`: south pole) and column. */
static void
corner(unsigned row, unsigned column, float out[3])
{
  double phi = M_PI * row / rows;
  double theta = 2 * M_PI * (column % columns) / columns;
  double r = 10 * (1 + 0.05 * cos(7 * phi) * (row % rows ? sin(5 * theta) : 0));

  out[0] = (float)(row % rows ? r * sin(phi) * cos(theta) : 0);
  out[1] = (float)(row % rows ? r * sin(phi) * sin(theta) : 0);
  out[2] = (float)(row % rows ? r * cos(phi) : row ? -10.0 : 10.0);
}

static void
put_triangle(const unsigned at[3][2])
{
  unsigned char record[50] = {0};

  for (int c = 0; c < 3; c++) {
    float p[3];
    corner(at[c][0], at[c][1], p);
    for (int k = 0; k < 3; k++) {
      p[k] = (float)(p[k] + centre[k]);
    }
    for (int k = 0; k < 3; k++) {
      union {
        float f;
        uint32_t bits;
      } x = {p[k]};
      for (int b = 0; b < 4; b++) {
        record[12 + 12 * c + 4 * k + b] = x.bits >> 8 * b & 0xff;
      }
    }
  }
  fwrite(record, sizeof record, 1, stdout);
}

int
main(int argc, char **argv)
{
  double wanted = argc > 1 ? atof(argv[1]) : 1000;

  for (int k = 0; k < 3 && k + 2 < argc; k++) {
    centre[k] = atof(argv[k + 2]);
  }

  rows = (unsigned)fmax(2, round(sqrt(wanted / 4) + 0.5));
  columns = 2 * rows;
  uint32_t count = 2 * columns * (rows - 1);
  char header[84] = "solid wavy sphere (a binary file all the same)";
  for (int b = 0; b < 4; b++) {
    header[80 + b] = (char)(count >> 8 * b & 0xff);
  }
  fwrite(header, sizeof header, 1, stdout);
  for (unsigned i = 0; i < rows; i++) {
    for (unsigned j = 0; j < columns; j++) {
      unsigned upper[3][2] = {{i, j}, {i + 1, j}, {i, j + 1}};
      unsigned lower[3][2] = {{i, j + 1}, {i + 1, j}, {i + 1, j + 1}};
      if (i > 0) {
        put_triangle(upper);
      }
      if (i + 1 < rows) {
        put_triangle(lower);
      }
    }
  }
  return fflush(stdout) != 0;
}
