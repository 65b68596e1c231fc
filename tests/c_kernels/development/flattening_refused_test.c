/* flattening_refused_test.c -- without memory an unfolding says so, or comes to
 * lie where it does with memory.
 *
 * covers: lay, flat_face, flat_index, flattening, joint, joint_order, measure,
 *         seam_bound, seam_exchange, seam_moats
 */
#include "flat_model.h"

#include "development/seam_exchange.h"
#include "tests/memory/refuse.h"

/* Where everything comes to lie, as one number; 0: there is no memory. With
 * folds exchanged if `exchange`. */
static uint64_t
laid_sum(const model *m, bool exchange)
{
  unfolded u = {.layout = {0}};
  uint32_t *order = NULL;
  uint64_t sum = 1;
  bool stopped = false, good;
  sg_exchange_end end;
  sg_measures measures;
  sg_seam_bound least;

  good =
      sg_flat_faces_make(&m->dense, NULL, 1e-9, NULL, &u.faces, &stopped) &&
      sg_joints_make(&u.faces, &m->dense, 1e-9, NULL, &u.joints, &stopped) &&
      sg_flattening_make(&m->dense, &u.faces, &u.joints, NULL, &u.flattening,
                         &stopped) &&
      (order =
           sg_joint_order(&u.flattening, SG_ORDER_LONGEST, NULL, &stopped)) &&
      sg_flattening_join_all(&u.flattening, order, u.joints.n, NULL, &stopped);
  if (good && exchange) {
    const sg_exchange_input in = {&u.flattening, order, NULL, false, SIZE_MAX};
    good = sg_seam_exchange(&in, NULL, &end, &stopped);
  }
  if (good) {
    const sg_lay_input in = {&u.flattening, 1e-9, SG_NO_FACE};
    good = sg_lay(&in, NULL, &u.layout, &stopped) &&
           sg_measure(&u.flattening, &u.layout, NULL, &measures, &stopped) &&
           sg_seam_bound_find(&u.flattening, NULL, &least, &stopped);
  }
  for (size_t v = 0; good && v < u.layout.vertices; v++) {
    uint64_t bits[2];
    memcpy(bits, u.layout.at[v], sizeof bits);
    sum = (sum * 31 + bits[0]) * 31 + bits[1];
  }
  if (good) {
    uint64_t bits;
    memcpy(&bits, &least.bound, sizeof bits);
    sum = sum * 31 + bits;
    memcpy(&bits, &measures.seam, sizeof bits);
    sum = sum * 31 + bits;
  }
  free(order);
  sg_layout_clear(&u.layout);
  sg_flattening_clear(&u.flattening);
  sg_joints_clear(&u.joints);
  sg_flat_faces_clear(&u.faces);
  return good ? sum | 1 : 0;
}

static bool
is_laid(const model *m, bool exchange, uint64_t with)
{
  uint64_t sum = laid_sum(m, exchange);

  return sum == 0 || sum == with;
}

static void
check_without_memory(void)
{
  for (int k = 0; k < 4; k++) {
    model *m = new_model();

    if (k < 2) {
      add_torus(m, 16, 0.4);
    } else {
      add_box(m, (double[3]){0, 0, 0}, (double[3]){1, 1, 1});
      add_box(m, (double[3]){3, 0, 0}, (double[3]){4, 2, 7});
    }
    uint64_t with = laid_sum(m, k % 2);
    CHECK("laid", with != 0);
    CHECK_REFUSED("laid the same", is_laid(m, k % 2, with));
    free(m);
  }
}

int
main(void)
{
  check_without_memory();
  return check_report();
}
