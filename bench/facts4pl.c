/* facts4pl.c -- rows in bulk for bench/facts.pl; part of the benchmark only. */
#include "engine/world4pl.h"

#include <stdlib.h>
#include <time.h>

static double
now(void)
{
  struct timespec t;

  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
  return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

static int
load(sg_relation relation, size_t n, const void *const *column, term_t seconds)
{
  sg_world *world = sg_current_world_ex();
  double start = now();
  sg_fault fault;
  sg_status status;

  if (!world) {
    return FALSE;
  }
  status = sg_world_add_many(world, relation, n, column, &fault);
  return sg_raise_status(status, relation, &fault) &&
         PL_unify_float(seconds, now() - start);
}

/* bench_vertices(+N, -Seconds): v(1, I, I*0.5, I*0.25, I*0.125), I = 1..N. */
static foreign_t
bench_vertices(term_t count, term_t seconds)
{
  size_t n;
  int32_t *id;
  double *x;
  foreign_t done;

  if (!PL_get_size_ex(count, &n)) {
    return FALSE;
  }
  id = malloc(2 * n * sizeof(*id));
  x = malloc(3 * n * sizeof(*x));
  for (size_t i = 0; i < n; i++) {
    id[i] = 1;
    id[n + i] = (int32_t)i + 1;
    x[i] = (double)(i + 1) * 0.5;
    x[n + i] = (double)(i + 1) * 0.25;
    x[2 * n + i] = (double)(i + 1) * 0.125;
  }
  done = (foreign_t)load(
      SG_V, n, (const void *[]){id, id + n, x, x + n, x + 2 * n}, seconds);
  free(id);
  free(x);
  return done;
}

/* bench_edges(+N, -Seconds): three edges leave each of N/3 vertices. */
static foreign_t
bench_edges(term_t count, term_t seconds)
{
  size_t n;
  int32_t *id;
  foreign_t done;

  if (!PL_get_size_ex(count, &n)) {
    return FALSE;
  }
  id = malloc(5 * n * sizeof(*id));
  for (size_t i = 0; i < n; i++) {
    id[i] = 1;
    id[n + i] = (int32_t)i + 1;
    id[2 * n + i] = (int32_t)(i / 3) + 1;
    id[3 * n + i] = (int32_t)((i * 7919) % n) + 1;
    id[4 * n + i] = 1;
  }
  done = (foreign_t)load(
      SG_E, n, (const void *[]){id, id + n, id + 2 * n, id + 3 * n, id + 4 * n},
      seconds);
  free(id);
  return done;
}

install_t install_facts(void);

install_t
install_facts(void)
{
  PL_register_foreign("bench_vertices", 2, bench_vertices, 0);
  PL_register_foreign("bench_edges", 2, bench_edges, 0);
}
