#include "chain.h"

#include "rows/key_table.h"

#include <stdlib.h>
#include <string.h>

/* A vertex in one group. */
typedef struct node {
  uint32_t lines;   /* how many are there */
  uint32_t line[2]; /* the first two, ascending */
} node;

typedef struct graph {
  const sg_chain_line *line;
  sg_key_table number; /* (group, names) -> node */
  node *node;          /* [at most 2 lines] */
  uint32_t (*end)[2];  /* [lines]: the nodes of a and b */
  bool *walked;        /* [lines] */
} graph;

void
sg_chains_clear(sg_chains *chains)
{
  free(chains->item);
  free(chains->step);
  *chains = (sg_chains){NULL, NULL, 0};
}

static void
graph_clear(graph *g)
{
  sg_key_table_clear(&g->number);
  free(g->node);
  free(g->end);
  free(g->walked);
}

/* Notes that line i ends in the vertex; its node, SG_NO_KEY: no memory. */
static uint32_t
note_end(graph *g, uint32_t *nodes, uint32_t i, const sg_chain_vertex *v)
{
  uint32_t key[3] = {g->line[i].group, v->name[0], v->name[1]};
  uint32_t *number = sg_key_table_put(&g->number, key);

  if (!number) {
    return SG_NO_KEY;
  }
  if (*number == SG_NO_KEY) {
    *number = (*nodes)++;
    g->node[*number] = (node){0, {0, 0}};
  }
  node *at = &g->node[*number];

  if (at->lines < 2) {
    at->line[at->lines] = i;
  }
  at->lines++;
  return *number;
}

static bool
graph_init(graph *g, const sg_chain_line *line, size_t lines)
{
  uint32_t nodes = 0;

  *g = (graph){.line = line};
  sg_key_table_init(&g->number, 3);
  g->node = malloc((2 * lines + 1) * sizeof *g->node);
  g->end = malloc((lines + 1) * sizeof *g->end);
  g->walked = calloc(lines + 1, sizeof *g->walked);
  if (!g->node || !g->end || !g->walked) {
    return false;
  }
  for (uint32_t i = 0; i < lines; i++) {
    g->end[i][0] = note_end(g, &nodes, i, &line[i].a);
    g->end[i][1] = memcmp(&line[i].a, &line[i].b, sizeof line[i].a) == 0
                       ? g->end[i][0]
                       : note_end(g, &nodes, i, &line[i].b);
    if (g->end[i][0] == SG_NO_KEY || g->end[i][1] == SG_NO_KEY) {
      return false;
    }
  }
  return true;
}

static bool
is_end(const graph *g, uint32_t n)
{
  return g->node[n].lines != 2;
}

/* The node in which a step ends. */
static uint32_t
step_end(const graph *g, int32_t step)
{
  return step > 0 ? g->end[step - 1][1] : g->end[-step - 1][0];
}

/* The step that goes on from `step`; 0: there is none. */
static int32_t
next_step(const graph *g, int32_t step)
{
  uint32_t n = step_end(g, step);
  const node *at = &g->node[n];

  for (int k = 0; k < 2 && at->lines == 2; k++) {
    uint32_t i = at->line[k];
    if (!g->walked[i]) {
      return g->end[i][0] == n ? (int32_t)i + 1 : -(int32_t)i - 1;
    }
  }
  return 0;
}

/* Walks the chain that begins with `step`, unless it was walked before. */
static void
walk(graph *g, sg_chains *out, size_t *steps, int32_t step)
{
  size_t first = *steps;
  uint32_t i = (uint32_t)(step > 0 ? step : -step) - 1;

  if (g->walked[i]) {
    return;
  }
  for (int32_t next = step; next; next = next_step(g, next)) {
    out->step[(*steps)++] = next;
    g->walked[(next > 0 ? next : -next) - 1] = true;
  }
  uint32_t start = step_end(g, -step);
  bool closed = start == step_end(g, out->step[*steps - 1]);
  bool point = start == step_end(g, step);

  out->item[out->n++] =
      (sg_chain){g->line[i].group, closed, point, first, *steps - first};
}

/* The chains of the group of lines from .. to - 1. */
static void
walk_group(graph *g, sg_chains *out, size_t *steps, uint32_t from, uint32_t to)
{
  for (uint32_t i = from; i < to; i++) {
    if (is_end(g, g->end[i][0])) {
      walk(g, out, steps, (int32_t)i + 1);
    } else if (is_end(g, g->end[i][1])) {
      walk(g, out, steps, -(int32_t)i - 1);
    }
  }
  for (uint32_t i = from; i < to; i++) {
    walk(g, out, steps, (int32_t)i + 1);
  }
}

bool
sg_chains_make(const sg_chain_line *line, size_t lines, sg_chains *out)
{
  graph g;
  size_t steps = 0;

  *out = (sg_chains){malloc((lines + 1) * sizeof *out->item),
                     malloc((lines + 1) * sizeof *out->step), 0};
  if (!graph_init(&g, line, lines) || !out->item || !out->step) {
    graph_clear(&g);
    sg_chains_clear(out);
    return false;
  }
  for (uint32_t from = 0, to; from < lines; from = to) {
    for (to = from; to < lines && line[to].group == line[from].group;) {
      to++;
    }
    walk_group(&g, out, &steps, from, to);
  }
  graph_clear(&g);
  return true;
}
