/* scene.c -- see scene.h */
#include "scene.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

static void
complain(const char *text)
{
  fprintf(stderr, "picture_checker: not a scene: %s\n", text);
  exit(2);
}

/* Room for one more at the end of an array that doubles. */
static void *
grown(void *array, size_t n, size_t size)
{
  if ((n & (n - 1)) == 0) {
    array = realloc(array, (n ? 2 * n : 1) * size);
  }
  if (!array) {
    abort();
  }
  return array;
}

static void
read_word(char **text, char word[], size_t room)
{
  size_t n;

  *text += strspn(*text, " \n");
  n = strcspn(*text, " \n");
  if (n == 0 || n >= room) {
    complain(*text);
  }
  memcpy(word, *text, n);
  word[n] = '\0';
  *text += n;
}

static void
read_number(char **text, mpq_t out)
{
  size_t n;
  char end;

  *text += strspn(*text, " \n");
  n = strcspn(*text, " \n");
  end = (*text)[n];
  (*text)[n] = '\0';
  if (n == 0 || mpq_set_str(out, *text, 10) != 0) {
    complain(*text);
  }
  mpq_canonicalize(out);
  (*text)[n] = end;
  *text += n;
}

static void
read_place(char **text, place *p)
{
  for (int k = 0; k < 3; k++) {
    mpq_init(p->at[k]);
    read_number(text, p->at[k]);
  }
}

static void
read_view(scene *s, char **text, bool central)
{
  s->central = central;
  for (int i = 0; i < 9; i++) {
    read_number(text, s->row[i / 3][i % 3]);
  }
  if (central) {
    read_number(text, s->rho);
  }
}

static void
read_triangle(scene *s, char **text)
{
  s->triangle = grown(s->triangle, s->triangles, sizeof *s->triangle);
  for (int k = 0; k < 3; k++) {
    read_place(text, &s->triangle[s->triangles].corner[k]);
  }
  s->triangles++;
}

static void
read_ids(char **text, int *s, int *e)
{
  char word[20];

  read_word(text, word, sizeof word);
  *s = atoi(word);
  read_word(text, word, sizeof word);
  *e = atoi(word);
}

static void
read_line(scene *s, char **text)
{
  line *l;

  s->line = grown(s->line, s->lines, sizeof *s->line);
  l = &s->line[s->lines++];
  *l = (line){0};
  read_ids(text, &l->s, &l->e);
  read_place(text, &l->end[0]);
  read_place(text, &l->end[1]);
}

static void
read_part(scene *s, char **text)
{
  int id[2];
  char word[20];
  part *p;

  s->part = grown(s->part, s->parts, sizeof *s->part);
  p = &s->part[s->parts++];
  mpq_inits(p->from, p->to, NULL);
  read_ids(text, &id[0], &id[1]);
  read_number(text, p->from);
  read_number(text, p->to);
  read_word(text, word, sizeof word);
  p->hidden = strcmp(word, "hidden") == 0;
  p->line = 0;
  while (p->line < s->lines &&
         (s->line[p->line].s != id[0] || s->line[p->line].e != id[1])) {
    p->line++;
  }
  if (p->line == s->lines) {
    complain("a part of no line");
  }
}

/* ---------------------------------------------------------- the picture */

/* row . p */
static void
along(mpq_t row[3], const place *p, mpq_t out)
{
  mpq_t product;

  mpq_init(product);
  mpq_set_ui(out, 0, 1);
  for (int k = 0; k < 3; k++) {
    mpq_mul(product, row[k], p->at[k]);
    mpq_add(out, out, product);
  }
  mpq_clear(product);
}

/* From the model to the picture; *nearest: the smallest distance so far. */
static void
project(scene *s, place *p, double *nearest)
{
  mpq_t eye[3];

  for (int k = 0; k < 3; k++) {
    mpq_init(eye[k]);
    along(s->row[k], p, eye[k]);
  }
  if (s->central) { /* x/z, y/z, -1/z: lines and planes stay what they are */
    mpq_add(eye[2], eye[2], s->rho);
    *nearest = fmin(*nearest, mpq_get_d(eye[2]));
    mpq_div(eye[0], eye[0], eye[2]);
    mpq_div(eye[1], eye[1], eye[2]);
    mpq_inv(eye[2], eye[2]);
    mpq_neg(eye[2], eye[2]);
  }
  for (int k = 0; k < 3; k++) {
    mpq_swap(p->at[k], eye[k]);
    p->near[k] = mpq_get_d(p->at[k]);
    s->size = fmax(s->size, fabs(p->near[k]));
    mpq_clear(eye[k]);
  }
}

static double
row_length(const scene *s, int i)
{
  double sum = 0;

  for (int k = 0; k < 3; k++) {
    double x = mpq_get_d(s->row[i][k]);
    sum += x * x;
  }
  return sqrt(sum);
}

static void
project_all(scene *s)
{
  double nearest = DBL_MAX;

  for (size_t i = 0; i < s->triangles; i++) {
    for (int k = 0; k < 3; k++) {
      project(s, &s->triangle[i].corner[k], &nearest);
    }
  }
  for (size_t i = 0; i < s->lines; i++) {
    project(s, &s->line[i].end[0], &nearest);
    project(s, &s->line[i].end[1], &nearest);
  }
  for (int k = 0; k < 2; k++) {
    s->scale[k] = s->central ? nearest : 1.0 / row_length(s, k);
  }
  for (size_t i = 0; i < s->lines; i++) {
    const double *a = s->line[i].end[0].near, *b = s->line[i].end[1].near;
    s->line[i].length =
        hypot((b[0] - a[0]) * s->scale[0], (b[1] - a[1]) * s->scale[1]);
  }
}

bool
scene_read(scene *s, FILE *in)
{
  char *text = NULL;
  size_t room = 0;
  bool end = false;

  *s = (scene){0};
  mpq_init(s->rho);
  for (int i = 0; i < 9; i++) {
    mpq_init(s->row[i / 3][i % 3]);
  }
  while (!end && getline(&text, &room, in) > 0) {
    char word[20], *rest = text;
    read_word(&rest, word, sizeof word);
    if (strcmp(word, "parallel") == 0 || strcmp(word, "central") == 0) {
      read_view(s, &rest, word[0] == 'c');
    } else if (strcmp(word, "t") == 0) {
      read_triangle(s, &rest);
    } else if (strcmp(word, "l") == 0) {
      read_line(s, &rest);
    } else if (strcmp(word, "d") == 0) {
      read_part(s, &rest);
    } else if (strcmp(word, "end") == 0) {
      read_word(&rest, s->name, sizeof s->name);
      end = true;
    } else {
      complain(text);
    }
  }
  free(text);
  if (end) {
    project_all(s);
  } else {
    scene_clear(s);
  }
  return end;
}

static void
place_clear(place *p)
{
  mpq_clears(p->at[0], p->at[1], p->at[2], NULL);
}

void
scene_clear(scene *s)
{
  for (size_t i = 0; i < s->triangles; i++) {
    for (int k = 0; k < 3; k++) {
      place_clear(&s->triangle[i].corner[k]);
    }
  }
  for (size_t i = 0; i < s->lines; i++) {
    place_clear(&s->line[i].end[0]);
    place_clear(&s->line[i].end[1]);
    intervals_clear(&s->line[i].hidden);
    intervals_clear(&s->line[i].shown);
  }
  for (size_t i = 0; i < s->parts; i++) {
    mpq_clears(s->part[i].from, s->part[i].to, NULL);
  }
  for (int i = 0; i < 9; i++) {
    mpq_clear(s->row[i / 3][i % 3]);
  }
  mpq_clear(s->rho);
  free(s->triangle);
  free(s->line);
  free(s->part);
  *s = (scene){0};
}
