/* owner_test.c -- groups that are met, against a plain list of them: each is
 * asked once, with its faces in their order, whichever thread met it first, and
 * has the answer that it was given.
 */
#include "shading/owner.h"

#include "tests/check.h"

#include <pthread.h>
#include <stdlib.h>
#include <string.h>

enum { FACES = 4, GROUPS = 600, THREADS = 2 };

/* One that some other one may begin with. */
typedef struct group {
  sg_met_group is;
  sg_met_face face[FACES];
  size_t answer;
  bool answered;
} group;

static uint32_t seed = 23;

static size_t
below(int n)
{
  return (size_t)check_below(&seed, n);
}

static group
some_group(void)
{
  group g = {.is = {.root = 1 + (int32_t)check_below(&seed, 2),
                    .begins = check_below(&seed, 2) == 0,
                    .n = 2 + below(FACES - 1)}};
  int32_t leaf = 0;

  for (size_t i = 0; i < g.is.n; i++) {
    leaf += 1 + (int32_t)check_below(&seed, 3);
    g.face[i] = (sg_met_face){.leaf = leaf,
                              .face = 1 + (int32_t)check_below(&seed, 2),
                              .slice = below(100)};
  }
  return g;
}

static bool
same_group(const group *a, const sg_met_group *b)
{
  bool same =
      a->is.root == b->root && a->is.begins == b->begins && a->is.n == b->n;

  for (size_t i = 0; same && i < b->n; i++) {
    same = sg_met_compare(&a->face[i], &b->face[i]) == 0;
  }
  return same;
}

static size_t
place_of(const group *all, size_t n, const sg_met_group *of)
{
  size_t i = 0;

  while (i < n && !same_group(&all[i], of)) {
    i++;
  }
  return i;
}

typedef struct meeting {
  sg_owners *owners;
  group *all;
  bool good;
} meeting;

static void *
meet_all(void *data)
{
  meeting *m = data;

  for (size_t i = 0; i < GROUPS; i++) {
    size_t owner = 0;
    sg_met_group g = m->all[i].is;
    g.face = m->all[i].face;
    m->good = m->good && sg_owner_of(m->owners, &g, &owner) &&
              owner == (m->all[i].answered ? m->all[i].answer : 0);
  }
  return NULL;
}

static void
meet(sg_owners *owners, group *all)
{
  pthread_t thread[THREADS];
  meeting m[THREADS];

  for (int i = 0; i < THREADS; i++) {
    m[i] = (meeting){owners, all, true};
    CHECK("a thread", pthread_create(&thread[i], NULL, meet_all, &m[i]) == 0);
  }
  for (int i = 0; i < THREADS; i++) {
    pthread_join(thread[i], NULL);
    CHECK("all have their answers", m[i].good);
  }
}

/* Answers the first n of those that are asked: some face of each. */
static void
answer(sg_owners *owners, group *all, size_t n)
{
  size_t room = 0, *answers = calloc(n + 1, sizeof *answers);
  sg_met_face *face = NULL;

  for (size_t i = 0; i < n; i++) {
    sg_met_group g;
    CHECK("a group", sg_owners_group(owners, i, &face, &room, &g));
    size_t at = place_of(all, GROUPS, &g);
    CHECK("it was met and not answered", at < GROUPS && !all[at].answered);
    answers[i] = below((int)g.n);
    for (; at < GROUPS; at++) { /* and those that are the same */
      if (same_group(&all[at], &g)) {
        all[at].answered = true;
        all[at].answer = answers[i];
      }
    }
  }
  CHECK("answers", sg_owners_answer(owners, answers, n));
  free(answers);
  free(face);
}

int
main(void)
{
  sg_owners *owners = sg_owners_open();
  group *all = calloc(GROUPS, sizeof *all);
  size_t distinct = 0, wrong[1] = {FACES};

  for (size_t i = 0; i < GROUPS; i++) {
    all[i] = some_group();
    sg_met_group g = all[i].is;
    g.face = all[i].face;
    distinct += place_of(all, i, &g) == i;
  }
  CHECK("some come twice", distinct > 100 && distinct < GROUPS);
  meet(owners, all);
  CHECK("each is asked once", sg_owners_asked(owners) == distinct);
  CHECK("no such face", !sg_owners_answer(owners, wrong, 1));
  answer(owners, all, distinct / 3);
  CHECK("the others are asked",
        sg_owners_asked(owners) == distinct - distinct / 3);
  meet(owners, all);
  answer(owners, all, sg_owners_asked(owners));
  CHECK("none is asked", sg_owners_asked(owners) == 0);
  meet(owners, all);
  CHECK("none is asked again", sg_owners_asked(owners) == 0);
  wrong[0] = 0;
  CHECK("no such group", !sg_owners_answer(owners, wrong, 1));
  sg_owners_close(owners);
  free(all);
  return check_report();
}
