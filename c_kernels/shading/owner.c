/* owner.c -- see owner.h. A group is a way through a tree of faces: from its
 * root on by one face after the other. */
#include "owner.h"

#include "engine/list.h"
#include "rows/key_table.h"

#include <pthread.h>
#include <stdlib.h>

enum { KEY_WORDS = 3 };
#define NO_PLACE UINT32_MAX

/* A place of the tree: a root where it begins or ends, without a parent, or one
 * more face. */
typedef struct place {
  uint32_t parent;  /* NO_PLACE: none */
  sg_met_face face; /* of a root: leaf is its segment, face 1: it begins */
  uint32_t owner;   /* of the group that ends here, if it was met */
} place;

struct sg_owners {
  pthread_mutex_t lock;
  sg_key_table at; /* parent, leaf, face: the place */
  SG_LIST_OF(place) place;
  SG_LIST_OF(uint32_t) asked; /* places */
};

int
sg_met_compare(const sg_met_face *a, const sg_met_face *b)
{
  return a->leaf != b->leaf ? (a->leaf > b->leaf) - (a->leaf < b->leaf)
                            : (a->face > b->face) - (a->face < b->face);
}

sg_owners *
sg_owners_open(void)
{
  sg_owners *o = calloc(1, sizeof *o);

  if (o && pthread_mutex_init(&o->lock, NULL) != 0) {
    free(o);
    o = NULL;
  }
  if (o) {
    sg_key_table_init(&o->at, KEY_WORDS);
  }
  return o;
}

void
sg_owners_close(sg_owners *o)
{
  if (o) {
    sg_key_table_clear(&o->at);
    free(o->place.item);
    free(o->asked.item);
    pthread_mutex_destroy(&o->lock);
    free(o);
  }
}

/* One more step; NO_PLACE: no memory. */
static uint32_t
step(sg_owners *o, uint32_t parent, const sg_met_face *face)
{
  const uint32_t key[KEY_WORDS] = {parent, (uint32_t)face->leaf,
                                   (uint32_t)face->face};
  uint32_t *at = sg_key_table_put(&o->at, key);

  if (at && *at == SG_NO_KEY) {
    *at = (uint32_t)o->place.n;
    if (!SG_PUSH(o->place, ((place){parent, *face, NO_PLACE}))) {
      return NO_PLACE;
    }
  }
  return at ? *at : NO_PLACE;
}

static bool
find_owner(sg_owners *o, const sg_met_group *group, size_t *owner)
{
  const sg_met_face root = {.leaf = group->root, .face = group->begins};
  uint32_t at = step(o, NO_PLACE, &root);

  for (size_t i = 0; at != NO_PLACE && i < group->n; i++) {
    at = step(o, at, &group->face[i]);
  }
  if (at == NO_PLACE) {
    return false;
  }
  if (o->place.item[at].owner == NO_PLACE) {
    if (!SG_PUSH(o->asked, at)) {
      return false;
    }
    o->place.item[at].owner = 0;
  }
  *owner = o->place.item[at].owner;
  return true;
}

bool
sg_owner_of(sg_owners *o, const sg_met_group *group, size_t *owner)
{
  pthread_mutex_lock(&o->lock);
  bool good = find_owner(o, group, owner);
  pthread_mutex_unlock(&o->lock);
  return good;
}

size_t
sg_owners_asked(sg_owners *o)
{
  pthread_mutex_lock(&o->lock);
  size_t n = o->asked.n;
  pthread_mutex_unlock(&o->lock);
  return n;
}

/* How many faces the group of a place has. */
static size_t
count_faces(const sg_owners *o, uint32_t at)
{
  size_t n = 0;

  for (; o->place.item[at].parent != NO_PLACE; n++) {
    at = o->place.item[at].parent;
  }
  return n;
}

bool
sg_owners_group(sg_owners *o, size_t i, sg_met_face **face, size_t *room,
                sg_met_group *out)
{
  pthread_mutex_lock(&o->lock);
  uint32_t at = o->asked.item[i];
  size_t n = count_faces(o, at);
  bool good = sg_list_need(face, n, room, sizeof **face);

  if (good) {
    for (size_t k = n; k > 0; at = o->place.item[at].parent) {
      (*face)[--k] = o->place.item[at].face;
    }
    *out = (sg_met_group){.root = o->place.item[at].face.leaf,
                          .begins = o->place.item[at].face.face == 1,
                          .face = *face,
                          .n = n};
  }
  pthread_mutex_unlock(&o->lock);
  return good;
}

static bool
are_faces(const sg_owners *o, const size_t *answer, size_t n)
{
  bool good = n <= o->asked.n;

  for (size_t i = 0; i < n && good; i++) {
    good = answer[i] < count_faces(o, o->asked.item[i]);
  }
  return good;
}

bool
sg_owners_answer(sg_owners *o, const size_t *answer, size_t n)
{
  pthread_mutex_lock(&o->lock);
  bool good = are_faces(o, answer, n);

  for (size_t i = 0; i < n && good; i++) {
    o->place.item[o->asked.item[i]].owner = (uint32_t)answer[i];
  }
  for (size_t i = n; i < o->asked.n && good; i++) {
    o->asked.item[i - n] = o->asked.item[i];
  }
  o->asked.n -= good ? n : 0;
  pthread_mutex_unlock(&o->lock);
  return good;
}
