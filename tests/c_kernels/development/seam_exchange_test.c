/* seam_exchange_test.c -- folds exchanged for others: the seam gets shorter, or
 * the pieces fewer, and nothing overlaps. */
#include "development/seam_exchange.h"

#include "flat_model.h"

/* Folds exchanged, with the folds kept that were there at first or none, as
 * long as `effort` lasts. */
static sg_exchange_end
exchange(unfolded *u, unsigned order, const bool *kept, bool pieces,
         size_t effort)
{
  bool stopped = false;
  uint32_t *js = sg_joint_order(&u->flattening, order, NULL, &stopped);
  const sg_exchange_input in = {&u->flattening, js, kept, pieces, effort};
  sg_exchange_end end;

  CHECK("exchanged", sg_seam_exchange(&in, NULL, &end, &stopped));
  free(js);
  sg_layout_clear(&u->layout);
  const sg_lay_input lay = {&u->flattening, 1e-9, SG_NO_FACE};
  CHECK("laid out again", sg_lay(&lay, NULL, &u->layout, &stopped));
  return end;
}

static void
check_exchange(unsigned order, size_t effort)
{
  model *m = new_model();
  unfolded u;

  add_torus(m, 18, 0.4);
  unfold(m, order, &u);
  double before = measured(&u).seam;
  sg_exchange_end end = exchange(&u, order, NULL, false, effort);
  double after = measured(&u).seam;
  CHECK("what was exchanged is shorter",
        end.exchanges > 0 ? after < before : near(after, before));
  CHECK("something was, with effort enough",
        end.exchanges > 0 || effort < SIZE_MAX);
  CHECK("with effort enough nothing is left to do",
        end.settled || effort < SIZE_MAX);
  CHECK("the seam is known without laying out",
        near(sg_seam_length(&u.flattening), after));
  CHECK("nothing overlaps", overlaps(&u) == 0);
  CHECK("sides are as long as edges", stretch(m, &u) < 1e-13);
  end = exchange(&u, order, NULL, false, SIZE_MAX);
  CHECK("it goes on where it was", measured(&u).seam <= after + 1e-9);
  CHECK("and settles", end.settled);
  forget(&u);
  free(m);
}

static void
check_exchange_keeps(void)
{
  model *m = new_model();
  unfolded u;
  size_t lost = 0;

  add_torus(m, 18, 0.4);
  unfold(m, SG_ORDER_FLATTEST, &u);
  bool *kept = calloc(u.joints.n, sizeof *kept);
  for (size_t j = 0; kept && j < u.joints.n; j++) {
    kept[j] = j % 3 == 0 && u.flattening.state[j] == SG_JOINT_JOINED;
    if (j % 7 == 1 && u.flattening.state[j] != SG_JOINT_JOINED) {
      u.flattening.state[j] = SG_JOINT_FORBIDDEN;
    }
  }
  sg_exchange_end end = exchange(&u, SG_ORDER_LONGEST, kept, false, SIZE_MAX);
  for (size_t j = 0; kept && j < u.joints.n; j++) {
    lost += kept[j] && u.flattening.state[j] != SG_JOINT_JOINED;
  }
  CHECK("something was exchanged", end.exchanges > 0);
  CHECK("folds that are to be kept are", lost == 0);
  CHECK("nothing overlaps", overlaps(&u) == 0);
  free(kept);
  forget(&u);
  free(m);
}

static void
check_exchange_pieces(void)
{
  model *m = new_model();
  unfolded u;

  add_torus(m, 24, 0.7);
  unfold(m, SG_ORDER_STEEPEST, &u);
  size_t before = u.layout.pieces;
  exchange(&u, SG_ORDER_STEEPEST, NULL, true, SIZE_MAX);
  CHECK("there were several pieces", before > 1);
  CHECK("there are fewer", u.layout.pieces < before);
  CHECK("nothing overlaps", overlaps(&u) == 0);
  forget(&u);
  free(m);
}

int
main(void)
{
  check_exchange(SG_ORDER_LONGEST, SIZE_MAX);
  check_exchange(SG_ORDER_STEEPEST, SIZE_MAX);
  check_exchange(SG_ORDER_LONGEST, 200000);
  check_exchange(SG_ORDER_LONGEST, 0);
  check_exchange_keeps();
  check_exchange_pieces();
  return check_report();
}
