/* cut_contact.c -- the points of a cut set that are no piece's: see cut_set.h.
 */
#include "cut_private.h"

#include "engine/search.h"
#include "rows/sort.h"

#include <stdlib.h>

int
sg_cut_touch(sg_cut_set *set, const uint32_t t[2], const sg_cut_end *end)
{
  const sg_leaf_triangle *leaf = set->model.triangle;
  uint32_t point = sg_cut_end_point(set, t, end);

  if (point == SG_NO_KEY ||
      !sg_list_grow(&set->contact, set->contacts, &set->contact_room,
                    sizeof *set->contact)) {
    return -1;
  }
  int swap = leaf[t[0]].s == leaf[t[1]].s && leaf[t[1]].p < leaf[t[0]].p;
  const sg_leaf_triangle *a = &leaf[t[swap]], *b = &leaf[t[!swap]];

  set->contact[set->contacts++] =
      (sg_cut_contact){{a->s, b->s}, {a->p, b->p}, point};
  return 0;
}

static uint32_t *
at_point(sg_key_table *of_point, const int32_t s[2], uint32_t point)
{
  uint32_t key[3] = {(uint32_t)s[0], (uint32_t)s[1], point};

  return sg_key_table_put(of_point, key);
}

/* Marks the ends of all pieces: with SG_NO_KEY - 1, which is no contact. */
static bool
mark_ends(const sg_cut_set *set, const sg_cancel *cancel,
          sg_key_table *of_point)
{
  for (size_t i = 0; i < set->pieces; i++) {
    const sg_cut_piece *piece = &set->piece[i];
    uint32_t *a = at_point(of_point, piece->s, piece->a);

    if (!a || sg_cancel_every(cancel, i)) {
      return false;
    }
    *a = SG_NO_KEY - 1;
    uint32_t *b = at_point(of_point, piece->s, piece->b);

    if (!b) {
      return false;
    }
    *b = SG_NO_KEY - 1;
  }
  return true;
}

SG_ORDER(compare_contacts, sg_cut_contact,
         SG_BY(s[0]) SG_BY(s[1]) SG_BY(p[0]) SG_BY(p[1]) SG_BY(point));

/* Keeps the contacts that are alone, each once, with the smallest polygons. */
static bool
keep_alone(sg_cut_set *set, const sg_cancel *cancel, sg_key_table *of_point)
{
  size_t kept = 0;

  for (size_t i = 0; i < set->contacts; i++) {
    sg_cut_contact contact = set->contact[i];
    uint32_t *known = at_point(of_point, contact.s, contact.point);

    if (!known || sg_cancel_every(cancel, i)) {
      return false;
    }
    if (*known == SG_NO_KEY) {
      *known = (uint32_t)kept;
      set->contact[kept++] = contact;
    }
    for (int k = 0; *known < kept && k < 2; k++) {
      int32_t *p = &set->contact[*known].p[k];
      *p = contact.p[k] < *p ? contact.p[k] : *p;
    }
  }
  set->contacts = kept;
  return true;
}

bool
sg_cut_settle_contacts(sg_cut_set *set, const sg_cancel *cancel)
{
  sg_key_table of_point;

  if (set->contacts == 0) {
    return true;
  }
  sg_key_table_init(&of_point, 3);
  bool good =
      mark_ends(set, cancel, &of_point) && keep_alone(set, cancel, &of_point);
  sg_key_table_clear(&of_point);
  return good && sg_sort(set->contact, set->contacts, sizeof *set->contact,
                         compare_contacts, cancel) == SG_SORTED;
}
