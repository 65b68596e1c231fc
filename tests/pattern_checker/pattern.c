#include "pattern.h"

#include <limits.h>
#include <stdlib.h>
#include <string.h>

/* From the ids of one kind to places. */
typedef struct ids {
  int *place; /* [limit], 0: none, else the place + 1 */
  int limit;
} ids;

typedef struct reader {
  pattern *p;
  ids point, edge, face, spot, side;
  char *rest; /* of the line, not read yet */
  long line;
} reader;

static void
stop(const reader *r, const char *why)
{
  fprintf(stderr, "pattern_checker: line %ld: %s\n", r->line, why);
  exit(2);
}

void *
room(void *items, size_t n, size_t size)
{
  if ((n & (n - 1)) == 0) { /* full: make it twice as large */
    items = realloc(items, (n ? 2 * n : 1) * size);
    if (!items) {
      fputs("pattern_checker: no memory\n", stderr);
      exit(2);
    }
  }
  return items;
}

static void
name_id(reader *r, ids *table, int id, size_t place)
{
  if (id >= table->limit) {
    int limit = id < INT_MAX / 2 ? 2 * id + 1 : INT_MAX;

    table->place = realloc(table->place, (size_t)limit * sizeof(int));
    if (!table->place) {
      stop(r, "no memory");
    }
    memset(table->place + table->limit, 0,
           (size_t)(limit - table->limit) * sizeof(int));
    table->limit = limit;
  }
  if (table->place[id]) {
    stop(r, "this id is there already");
  }
  table->place[id] = (int)place + 1;
}

/* ------------------------------------------------------ words of a line */

static bool
more(reader *r)
{
  r->rest += strspn(r->rest, " \n");
  return *r->rest != '\0';
}

static double
next_number(reader *r)
{
  char *end;
  double x = strtod(r->rest, &end);

  if (end == r->rest) {
    stop(r, "a number is missing");
  }
  r->rest = end;
  return x;
}

static int
next_id(reader *r)
{
  double x = next_number(r);

  if (x < 0 || x >= INT_MAX || x != (int)x) {
    stop(r, "this is no id");
  }
  return (int)x;
}

/* The place of the id that comes next. */
static int
next_place(reader *r, const ids *table)
{
  int id = next_id(r);

  if (id >= table->limit || !table->place[id]) {
    stop(r, "there is no such id");
  }
  return table->place[id] - 1;
}

static void
next_word(reader *r, char *word, size_t size)
{
  size_t n;

  if (!more(r)) {
    stop(r, "a word is missing");
  }
  n = strcspn(r->rest, " \n");
  if (n >= size) {
    stop(r, "this word is too long");
  }
  memcpy(word, r->rest, n);
  word[n] = '\0';
  r->rest += n;
}

/* ---------------------------------------------------------- the solid */

static void
read_point(reader *r)
{
  pattern *p = r->p;

  p->point = room(p->point, p->points, sizeof *p->point);
  name_id(r, &r->point, next_id(r), p->points);
  for (int k = 0; k < 3; k++) {
    p->point[p->points][k] = next_number(r);
  }
  p->points++;
}

static void
read_edge(reader *r)
{
  pattern *p = r->p;
  edge *e;

  p->edge = room(p->edge, p->edges, sizeof *p->edge);
  e = &p->edge[p->edges];
  name_id(r, &r->edge, next_id(r), p->edges++);
  e->from = next_place(r, &r->point);
  e->to = next_place(r, &r->point);
  e->face = NONE;
}

static void
add_to_list(pattern *p, int item)
{
  p->list = room(p->list, p->listed, sizeof *p->list);
  p->list[p->listed++] = item;
}

static void
read_face(reader *r)
{
  pattern *p = r->p;
  face *f;

  p->face = room(p->face, p->faces, sizeof *p->face);
  f = &p->face[p->faces];
  name_id(r, &r->face, next_id(r), p->faces);
  *f = (face){.first = p->listed};
  while (more(r)) {
    int e = next_place(r, &r->edge);

    p->twice += p->edge[e].face != NONE;
    p->edge[e].face = (int)p->faces;
    add_to_list(p, e);
  }
  f->count = p->listed - f->first;
  p->faces++;
}

static void
read_triangle(reader *r)
{
  pattern *p = r->p;
  int *t;

  p->triangle = room(p->triangle, p->triangles, sizeof *p->triangle);
  t = p->triangle[p->triangles++];
  t[0] = next_place(r, &r->face);
  for (int k = 1; k < 4; k++) {
    t[k] = next_place(r, &r->point);
  }
}

/* ------------------------------------------------------- its pattern */

static void
read_spot(reader *r)
{
  pattern *p = r->p;
  spot *s;

  p->spot = room(p->spot, p->spots, sizeof *p->spot);
  s = &p->spot[p->spots];
  name_id(r, &r->spot, next_id(r), p->spots++);
  s->at[0] = next_number(r);
  s->at[1] = next_number(r);
  s->point = next_place(r, &r->point);
}

static void
read_side(reader *r)
{
  pattern *p = r->p;
  side *s;

  p->side = room(p->side, p->sides, sizeof *p->side);
  s = &p->side[p->sides];
  name_id(r, &r->side, next_id(r), p->sides++);
  s->from = next_place(r, &r->spot);
  s->to = next_place(r, &r->spot);
  more(r);
  s->edge = *r->rest == '0' ? NONE : next_place(r, &r->edge);
  s->flat = s->joint = NONE;
}

static void
read_flat(reader *r)
{
  pattern *p = r->p;
  flat *f;

  p->flat = room(p->flat, p->flats, sizeof *p->flat);
  f = &p->flat[p->flats];
  next_id(r);
  f->face = next_place(r, &r->face);
  f->piece = next_id(r);
  f->first = p->listed;
  p->pieces = f->piece > p->pieces ? f->piece : p->pieces;
  while (more(r)) {
    int s = next_place(r, &r->side);

    p->twice += p->side[s].flat != NONE;
    p->side[s].flat = (int)p->flats;
    add_to_list(p, s);
  }
  f->count = p->listed - f->first;
  p->flats++;
}

static void
read_joint(reader *r)
{
  static const char *const kinds[] = {"fold", "seam", "line"};
  pattern *p = r->p;
  joint *j;
  char word[8];
  int kind = 0;

  p->joint = room(p->joint, p->joints, sizeof *p->joint);
  j = &p->joint[p->joints];
  for (int i = 0; i < 2; i++) {
    j->side[i] = next_place(r, &r->side);
    p->twice += p->side[j->side[i]].joint != NONE;
    p->side[j->side[i]].joint = (int)p->joints;
  }
  next_word(r, word, sizeof word);
  while (kind < 3 && strcmp(word, kinds[kind]) != 0) {
    kind++;
  }
  if (kind == 3) {
    stop(r, "there is no such kind of joint");
  }
  j->kind = (joint_kind)kind;
  j->angle = next_number(r);
  p->joints++;
}

static void
read_tab(reader *r)
{
  pattern *p = r->p;
  tab *t;

  p->tab = room(p->tab, p->tabs, sizeof *p->tab);
  t = &p->tab[p->tabs++];
  t->side = next_place(r, &r->side);
  t->first = p->corners;
  while (more(r)) {
    p->corner = room(p->corner, p->corners, sizeof *p->corner);
    p->corner[p->corners][0] = next_number(r);
    p->corner[p->corners][1] = next_number(r);
    p->corners++;
  }
  t->count = p->corners - t->first;
}

/* ---------------------------------------------------------- the file */

static void
read_item(reader *r, const char *word)
{
  static const struct {
    const char *word;
    void (*read)(reader *r);
  } kinds[] = {{"v", read_point},    {"e", read_edge},  {"p", read_face},
               {"t", read_triangle}, {"V", read_spot},  {"E", read_side},
               {"P", read_flat},     {"J", read_joint}, {"T", read_tab}};

  for (size_t k = 0; k < sizeof kinds / sizeof *kinds; k++) {
    if (strcmp(word, kinds[k].word) == 0) {
      kinds[k].read(r);
      return;
    }
  }
  if (strcmp(word, "removed") == 0) {
    r->p->face[next_place(r, &r->face)].removed = true;
  } else if (strcmp(word, "reported") == 0) {
    r->p->seam = next_number(r);
    r->p->pieces = next_id(r);
  } else {
    stop(r, "there is no such word");
  }
}

static void
clear_ids(reader *r)
{
  ids *tables[] = {&r->point, &r->edge, &r->face, &r->spot, &r->side};

  for (size_t k = 0; k < sizeof tables / sizeof *tables; k++) {
    free(tables[k]->place);
  }
}

bool
pattern_read(pattern *p, FILE *in)
{
  static long lines = 0;
  reader r = {.p = p};
  char *text = NULL, word[16];
  size_t size = 0;
  bool ended = false;

  *p = (pattern){0};
  while (!ended && getline(&text, &size, in) > 0) {
    r.line = ++lines;
    r.rest = text;
    next_word(&r, word, sizeof word);
    if (strcmp(word, "end") == 0) {
      next_word(&r, p->name, sizeof p->name);
      ended = true;
    } else {
      read_item(&r, word);
    }
  }
  free(text);
  clear_ids(&r);
  if (!ended && p->points > 0) {
    stop(&r, "the end is missing");
  }
  return ended;
}

void
pattern_clear(pattern *p)
{
  free(p->point);
  free(p->edge);
  free(p->face);
  free(p->triangle);
  free(p->spot);
  free(p->side);
  free(p->flat);
  free(p->joint);
  free(p->tab);
  free(p->corner);
  free(p->list);
}
