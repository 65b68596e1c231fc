/* mesh_fuzz_test.c -- no bytes, however bad, may break the mesh readers.
 *
 * As a libFuzzer target (without the *4pl.c files):
 *   clang -g -fsanitize=fuzzer,address,undefined -D_GNU_SOURCE -DSG_LIBFUZZER \
 *     -I. -Ic_kernels tests/c_kernels/model/mesh_fuzz_test.c \
 *     c_kernels/model/mesh*[a-z].c c_kernels/rows/edge_pairs.c \
 *     c_kernels/number/number.c
 * Without libFuzzer a main() that changes seeds in a fixed pseudo-random way;
 * an argument is the number of rounds. The first byte picks the format.
 */
#include "mesh_valid.h"
#include "tests/check.h"

#include "model/mesh_part.h"

#include <stdlib.h>
#include <string.h>

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t n);

/* What went wrong in the last input, for the report of main(). */
static const char *broken;

static bool
nowhere(void *data, const char *bytes, size_t n)
{
  (void)data, (void)bytes, (void)n;
  return true;
}

/* What is read can be parted and written. */
static void
use(const sg_mesh *mesh)
{
  static const sg_mesh_format formats[] = {SG_MESH_OFF, SG_MESH_OBJ,
                                           SG_MESH_PLY, SG_MESH_PLY_BINARY,
                                           SG_MESH_STL, SG_MESH_STL_BINARY};
  sg_mesh_sink sink = {nowhere, NULL};
  sg_mesh_error error;
  sg_mesh_parts *parts = sg_mesh_parts_open(mesh);
  sg_mesh_part part;
  bool stopped;

  for (size_t s = 0; parts && s < mesh->segments && s < 50; s++) {
    if (!sg_mesh_parts_get(parts, s, NULL, &part, &stopped)) {
      broken = "a part";
    }
  }
  sg_mesh_parts_close(parts);
  for (size_t i = 0; i < sizeof formats / sizeof *formats; i++) {
    if (!sg_mesh_write(formats[i], mesh, &sink, NULL, &error) &&
        error.code != SG_MESH_UNSUPPORTED) {
      broken = "written";
    }
  }
}

int
LLVMFuzzerTestOneInput(const uint8_t *data, size_t n)
{
  static const sg_mesh_format formats[] = {
      SG_MESH_UNKNOWN, SG_MESH_STL, SG_MESH_OFF, SG_MESH_OBJ, SG_MESH_PLY};
  sg_mesh_options options = {SG_WELD_AUTO, false, NULL};
  sg_mesh_error error;
  sg_mesh mesh;

  broken = NULL;
  if (n == 0) {
    return 0;
  }
  options.weld = (sg_mesh_weld)(data[0] / 8 % 3);
  if (sg_mesh_read(formats[data[0] % 5], (const char *)data + 1, n - 1,
                   &options, &mesh, &error)) {
    if (!mesh_is_valid(&mesh)) {
      broken = "valid";
    } else {
      use(&mesh);
    }
    sg_mesh_clear(&mesh);
  } else if (error.code == SG_MESH_FINE || error.code >= SG_MESH_CODES ||
             !memchr(error.text, '\0', sizeof error.text) || mesh.vertex) {
    broken = "an error";
  }
  return 0;
}

#ifndef SG_LIBFUZZER

static const char *const seeds[] = {
    "\1solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\n"
    "vertex 0 1 0\nendloop\nendfacet\nendsolid a\n",
    "\2COFF\n4 2 0 # c\n0 0 0 1 1 1 1\n1 0 0 1 1 1 1\n1 1 0 1 1 1 1\n"
    "0 1 0 1 1 1 1\n3 0 1 2\n4 0 1 2 3 9\n",
    "\3o a\nv 0 0 0\nv 1 0 0\nv 1 1 0 \\\n\ng b c\nf 1/1/1 2//1 -1\nl 1 2 3\n",
    "\4ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\n"
    "property double y\nproperty int z\nelement face 1\n"
    "property list uchar int vertex_indices\nelement edge 1\n"
    "property int vertex1\nproperty int vertex2\nend_header\n0 0 0\n1 0 0\n"
    "0 1 0\n3 0 1 2\n0 2\n",
    "\4ply\nformat binary_little_endian 1.0\nelement vertex 3\n"
    "property char x\nproperty char y\nproperty char z\nelement face 2\n"
    "property list uchar char vertex_indices\nend_header\n"
    "\1\1\1\2\1\1\1\2\1\3\1\2\1\3\2\1\1"};

static const char *const words[] = {
    "99999999999", "-1",   "1e999", "nan",  "0x1",    "\r\n", "\t",   "#",
    "4294967295",  "\\\n", "solid", "list", "BINARY", "0",    "1/2/", "\xff"};

static unsigned long long state = 20261121;

static unsigned
draw(unsigned n)
{
  state ^= state << 13;
  state ^= state >> 7;
  state ^= state << 17;
  return (unsigned)(state >> 33) % n;
}

/* One change: a byte, a cut, a piece doubled, a word put in. */
static size_t
change(char *text, size_t n, size_t room)
{
  size_t at = draw((unsigned)n + 1);
  const char *word = words[draw(sizeof words / sizeof *words)];
  size_t length = strlen(word);

  switch (draw(4)) {
  case 0:
    if (at < n) {
      text[at] = (char)draw(256);
    }
    return n;
  case 1:
    return at > 0 ? at : n;
  case 2:
    length = draw((unsigned)(n - at) + 1);
    word = text + at;
    break;
  default:
    break;
  }
  if (n + length > room) {
    return n;
  }
  memmove(text + at + length, text + at, n - at);
  memmove(text + at, word, length);
  return n + length;
}

static bool
survives(const char *text, size_t n)
{
  uint8_t *exact = malloc(n ? n : 1);

  memcpy(exact, text, n);
  LLVMFuzzerTestOneInput(exact, n);
  free(exact);
  return broken == NULL;
}

int
main(int argc, char **argv)
{
  long rounds = argc > 1 ? atol(argv[1]) : 20000;
  char text[4096];
  bool good = true;

  for (long i = 0; i < rounds && good; i++) {
    const char *seed = seeds[draw(sizeof seeds / sizeof *seeds)];
    size_t n = strlen(seed);
    memcpy(text, seed, n);
    for (unsigned k = draw(6); k > 0; k--) {
      n = change(text, n, sizeof text);
    }
    good = survives(text, n);
    if (!good) {
      fprintf(stderr, "round %ld: %s\n", i, broken);
    }
  }
  CHECK("no bytes break the readers", good);
  return check_report();
}

#endif
