/* seam4pl.c -- cut sets: putting the cuts into polygons, and what comes out.
 *
 * Layer: glue. The doors are documented in rules/kernel/penetration.pl.
 */
#include "cut4pl.h"

#include "glue.h"

#include "engine/install.h"

#include <stdlib.h>

/* ---- names ---- */

int32_t
sg_cut_name_ex(sg_cut_handle *handle, uint32_t point, int32_t s)
{
  int32_t name = sg_cut_points_name(&handle->set.points, point, s);
  uint32_t key = (uint32_t)s;

  if (name != 0) {
    return name;
  }
  uint32_t *next = sg_key_table_put(&handle->next_name, &key);

  if (!next || *next == SG_NO_KEY ||
      !sg_cut_points_set_name(&handle->set.points, point, s, (int32_t)*next)) {
    sg_no_memory();
    return 0;
  }
  return (int32_t)(*next)++;
}

typedef struct in_polygon {
  sg_cut_handle *handle;
  int32_t s, p;
} in_polygon;

/* Whether vertex v is one of polygon p. */
static bool
is_in_polygon(const void *data, int32_t v)
{
  const in_polygon *in = data;
  const sg_version *version = in->handle->version;
  sg_row row = sg_cut_row_of(in->handle, SG_P, in->s, in->p);
  const int32_t *list =
      row == SG_NO_ROW ? NULL : sg_version_value(version, SG_P, row, 2).list;

  for (int32_t i = 1; list && i <= list[0]; i++) {
    sg_row at = sg_cut_row_of(in->handle, SG_E, in->s, list[i]);

    if (at != SG_NO_ROW && (sg_version_value(version, SG_E, at, 2).i == v ||
                            sg_version_value(version, SG_E, at, 3).i == v)) {
      return true;
    }
  }
  return false;
}

int32_t
sg_cut_name_in(sg_cut_handle *handle, uint32_t point, int32_t s, int32_t p)
{
  const in_polygon in = {handle, s, p};

  return sg_cut_points_good_name(&handle->set.points, point, s, is_in_polygon,
                                 &in);
}

static bool
is_joint(const sg_cut_set *set, uint32_t point)
{
  uint32_t k, l;

  return sg_cut_set_joint(set, point, &k, &l);
}

/* Names all ends of pieces, all points on edges and all contacts. Those that
 * will likely be joined away come last, so that the others are numbered without
 * gaps. */
static int
name_all_ex(sg_cut_handle *handle)
{
  const sg_cut_set *set = &handle->set;

  for (int pass = 0; pass < 2; pass++) {
    for (size_t i = 0; i < set->pieces; i++) {
      const sg_cut_piece *piece = &set->piece[i];

      for (int k = 0; piece->live && k < 4; k++) {
        uint32_t end = k < 2 ? piece->a : piece->b;
        if (is_joint(set, end) == (pass == 1) &&
            !sg_cut_name_ex(handle, end, piece->s[k % 2])) {
          return FALSE;
        }
      }
    }
  }
  for (size_t i = 0; i < set->edges; i++) {
    for (size_t k = 0; k < set->edge[i].n; k++) {
      if (!sg_cut_name_ex(handle, set->edge[i].point[k], set->edge[i].s)) {
        return FALSE;
      }
    }
  }
  for (size_t i = 0; i < set->contacts; i++) {
    const sg_cut_contact *contact = &set->contact[i];

    if (!sg_cut_name_ex(handle, contact->point, contact->s[0]) ||
        !sg_cut_name_ex(handle, contact->point, contact->s[1])) {
      return FALSE;
    }
  }
  return TRUE;
}

/* ---- sealing ---- */

static foreign_t
cut_seal(term_t t)
{
  sg_cut_handle *handle;

  return sg_get_cut_set_ex(t, &handle) &&
         ((sg_cut_set_seal(&handle->set) && sg_cut_set_link(&handle->set)) ||
          sg_no_memory());
}

/* ---- the polygons ---- */

/* Lists the polygons and names the points, once. */
static int
group_ex(sg_cut_handle *handle)
{
  sg_cut_set *set = &handle->set;

  if (handle->grouped) {
    return TRUE;
  }
  if (!sg_cut_add_beside(handle, false)) {
    return sg_no_memory();
  }
  handle->grouped = true;
  return (sg_cut_set_group(set) || sg_no_memory()) && name_all_ex(handle);
}

static foreign_t
cut_polygons(term_t t, term_t list)
{
  sg_cut_handle *handle;
  term_t tail = PL_copy_term_ref(list), head = PL_new_term_ref();

  if (!sg_get_cut_set_ex(t, &handle) || !group_ex(handle)) {
    return FALSE;
  }
  for (size_t i = 0; i < handle->set.polygons; i++) {
    const sg_cut_polygon *polygon = &handle->set.polygon[i];

    if (!PL_unify_list(tail, head, tail) ||
        !PL_unify_term(head, PL_FUNCTOR_CHARS, "-", 2, PL_INT, polygon->s,
                       PL_INT, polygon->p)) {
      return FALSE;
    }
  }
  return PL_unify_nil(tail);
}

static bool
is_among(const int32_t *s, size_t n, int32_t one)
{
  for (size_t i = 0; i < n; i++) {
    if (s[i] == one) {
      return true;
    }
  }
  return false;
}

/* The polygons that carry a piece of one of n segments. */
static bool
note_carriers(const sg_cut_set *set, const int32_t *s, size_t n,
              sg_key_table *out)
{
  for (size_t i = 0; i < set->pieces; i++) {
    const sg_cut_piece *piece = &set->piece[i];

    if (!piece->live ||
        !(is_among(s, n, piece->s[0]) || is_among(s, n, piece->s[1]))) {
      continue;
    }
    for (int k = 0; k < 2; k++) {
      uint32_t key[2] = {(uint32_t)piece->s[k], (uint32_t)piece->p[k]};
      uint32_t *known = sg_key_table_put(out, key);

      if (!known) {
        return false;
      }
      *known = 1;
    }
  }
  return true;
}

/* cut_polygons_of(+Set, +Segments, -Polygons) is det. */
static foreign_t
cut_polygons_of(term_t t, term_t segments, term_t list)
{
  sg_cut_handle *handle;
  int32_t *s;
  size_t n;
  term_t tail = PL_copy_term_ref(list), head = PL_new_term_ref();

  if (!sg_get_cut_set_ex(t, &handle) || !group_ex(handle) ||
      !sg_get_ids_ex(segments, &s, &n)) {
    return FALSE;
  }
  sg_key_table carrier;

  sg_key_table_init(&carrier, 2);
  int good = note_carriers(&handle->set, s, n, &carrier) || sg_no_memory();

  for (size_t i = 0; i < handle->set.polygons && good; i++) {
    const sg_cut_polygon *polygon = &handle->set.polygon[i];
    uint32_t key[2] = {(uint32_t)polygon->s, (uint32_t)polygon->p};

    if (is_among(s, n, polygon->s) ||
        sg_key_table_get(&carrier, key) != SG_NO_KEY) {
      good = PL_unify_list(tail, head, tail) &&
             PL_unify_term(head, PL_FUNCTOR_CHARS, "-", 2, PL_INT, polygon->s,
                           PL_INT, polygon->p);
    }
  }
  sg_key_table_clear(&carrier);
  free(s);
  return good && PL_unify_nil(tail);
}

/* The pieces that enter polygon p: piece(K, V1, V2), V1-V2 in its segment. */
static foreign_t
cut_entering(term_t t, term_t s, term_t p, term_t list)
{
  sg_cut_handle *handle;
  int32_t key[2];
  term_t tail = PL_copy_term_ref(list), head = PL_new_term_ref();

  if (!sg_get_cut_set_ex(t, &handle) || !sg_get_id_ex(s, &key[0]) ||
      !sg_get_id_ex(p, &key[1])) {
    return FALSE;
  }
  const sg_cut_set *set = &handle->set;
  const sg_cut_polygon *polygon = sg_cut_set_polygon(set, key[0], key[1]);

  for (size_t i = 0; polygon && i < polygon->n; i++) {
    uint32_t k = set->entering[polygon->first + i];
    const sg_cut_piece *piece = &set->piece[k];

    if (!PL_unify_list(tail, head, tail) ||
        !PL_unify_term(head, PL_FUNCTOR_CHARS, "piece", 3, PL_INT, (int)k,
                       PL_INT, sg_cut_name_in(handle, piece->a, key[0], key[1]),
                       PL_INT,
                       sg_cut_name_in(handle, piece->b, key[0], key[1]))) {
      return FALSE;
    }
  }
  return PL_unify_nil(tail);
}

/* ---- what was found while entering ---- */

static foreign_t
cut_agree(term_t t)
{
  sg_cut_handle *handle;

  if (!sg_get_cut_set_ex(t, &handle)) {
    return FALSE;
  }
  return ((sg_cut_set_agree(&handle->set) && sg_cut_set_link(&handle->set)) ||
          sg_no_memory()) &&
         name_all_ex(handle);
}

static foreign_t
cut_was_divided(term_t t)
{
  sg_cut_handle *handle;

  return sg_get_cut_set_ex(t, &handle) && handle->set.late.n > 0;
}

/* The polygons, S-P, with edges that were divided while others were entered. */
static foreign_t
cut_late_polygons(term_t t, term_t list)
{
  sg_cut_handle *handle;
  term_t tail = PL_copy_term_ref(list), head = PL_new_term_ref();

  if (!sg_get_cut_set_ex(t, &handle)) {
    return FALSE;
  }
  sg_cut_set *set = &handle->set;

  if (set->late.n == 0) { /* mostly nothing was divided anywhere */
    return PL_unify_nil(tail);
  }
  size_t listed = set->polygons;
  int good = sg_cut_add_beside(handle, true) || sg_no_memory();

  for (size_t i = listed; good && i < set->polygons; i++) {
    good = PL_unify_list(tail, head, tail) &&
           PL_unify_term(head, PL_FUNCTOR_CHARS, "-", 2, PL_INT,
                         set->polygon[i].s, PL_INT, set->polygon[i].p);
  }
  set->polygons = listed;
  return good && PL_unify_nil(tail);
}

static const PL_extension predicates[] = {
    {"cut_seal", 1, cut_seal, 0},
    {"cut_polygons", 2, cut_polygons, 0},
    {"cut_polygons_of", 3, cut_polygons_of, 0},
    {"cut_entering", 4, cut_entering, 0},
    {"cut_agree", 1, cut_agree, 0},
    {"cut_was_divided", 1, cut_was_divided, 0},
    {"cut_late_polygons", 2, cut_late_polygons, 0},
    {NULL, 0, NULL, 0},
};

void
sg_install_seam(void)
{
  PL_register_extensions_in_module("sg_kernel_penetration", predicates);
}
