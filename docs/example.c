/* example.c -- a program that uses Sanggwan: loads a model, lets its segments
 * cut each other, asks three questions and prints the answers.
 *
 *   cc example.c $(pkg-config --cflags --libs sanggwan) -o example
 *   ./example facts/figures/fig13.pl
 *
 * engine/sanggwan.h describes every function.
 */
#include "sanggwan.h"

#include <inttypes.h>
#include <stdio.h>

/* What went wrong, in the words of the library. */
static void
report(const char *what, const sanggwan_world *world)
{
  fprintf(stderr, "%s: %s\n", what, sanggwan_message(world));
}

/* Question 1: how many edges has each segment? Columns by name. */
static sanggwan_status
print_edge_counts(sanggwan_world *world)
{
  sanggwan_query *q = sanggwan_ask(
      world, "segment(S, Kind, _), aggregate_all(count, e(S,_,_,_,_), Edges)");
  sanggwan_status status;
  int segment = sanggwan_column(q, "S");
  int kind = sanggwan_column(q, "Kind");
  int edges = sanggwan_column(q, "Edges");

  while ((status = sanggwan_next(q)) == SANGGWAN_DONE) {
    int64_t s, n;
    if (sanggwan_int(q, segment, &s) && sanggwan_int(q, edges, &n)) {
      printf("segment %" PRId64 ", a %s, has %" PRId64 " edges\n", s,
             sanggwan_text(q, kind), n);
    }
  }
  sanggwan_query_close(q);
  return status;
}

/* Question 2: which is the longest penetration line? The first answer is
 * enough. Variables that begin with _ are no columns. */
static sanggwan_status
print_longest_line(sanggwan_world *world)
{
  sanggwan_query *q =
      sanggwan_ask(world, "order_by([desc(Length), asc(Pieces)],"
                          "         ( chain(_, _, _, Kind, _Lines),"
                          "           chain_length(_Lines, Length),"
                          "           length(_Lines, Pieces) ))");
  sanggwan_status status = sanggwan_next(q);
  double length;
  int64_t pieces;

  if (status == SANGGWAN_DONE &&
      sanggwan_double(q, sanggwan_column(q, "Length"), &length) &&
      sanggwan_int(q, sanggwan_column(q, "Pieces"), &pieces)) {
    printf("the longest line is %s, of %" PRId64 " pieces, %.6f long\n",
           sanggwan_text(q, sanggwan_column(q, "Kind")), pieces, length);
  }
  sanggwan_query_close(q);
  return status;
}

/* Question 3: which vertices of segment 1 did the cut make, and from what? The
 * first three; columns by number, as the variables come in the text. */
static sanggwan_status
print_origins(sanggwan_world *world)
{
  enum { V, ORIGIN, X, Y, Z };
  enum { FIRST = 3 };
  sanggwan_query *q =
      sanggwan_ask(world, "origin(1, v(V), Origin), v(1, V, X, Y, Z)");
  sanggwan_status status = SANGGWAN_DONE;

  for (int i = 0; i < FIRST && status == SANGGWAN_DONE; i++) {
    status = sanggwan_next(q);
    if (status == SANGGWAN_DONE) {
      double x, y, z;
      sanggwan_double(q, X, &x);
      sanggwan_double(q, Y, &y);
      sanggwan_double(q, Z, &z);
      printf("vertex %s at (%.4f, %.4f, %.4f) comes from %s\n",
             sanggwan_text(q, V), x, y, z, sanggwan_text(q, ORIGIN));
    }
  }
  sanggwan_query_close(q);
  return status;
}

/* SANGGWAN_NO ends the answers; anything above it is an error. */
static sanggwan_status
run(sanggwan_world *world, const char *file)
{
  sanggwan_status status = sanggwan_load(world, file);

  if (status == SANGGWAN_DONE) {
    status = sanggwan_run(world, "penetrate");
  }
  if (status == SANGGWAN_DONE) {
    status = print_edge_counts(world);
  }
  if (status <= SANGGWAN_NO) {
    status = print_longest_line(world);
  }
  if (status <= SANGGWAN_NO) {
    status = print_origins(world);
  }
  return status;
}

int
main(int argc, char **argv)
{
  const char *file = argc > 1 ? argv[1] : "facts/figures/fig13.pl";
  sanggwan_status status = sanggwan_start();
  sanggwan_world *world = status == SANGGWAN_DONE ? sanggwan_open() : NULL;

  if (!world) {
    report("cannot start", NULL);
    return SANGGWAN_IMPOSSIBLE;
  }
  status = run(world, file);
  if (status > SANGGWAN_NO) {
    report(file, world);
  }
  sanggwan_close(world);
  return status > SANGGWAN_NO ? (int)status : 0;
}
