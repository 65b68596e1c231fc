/* list_test.c -- the growing array. */
#include "engine/list.h"

#include "tests/check.h"

#include <stdint.h>
#include <stdlib.h>

static void
pushes(void)
{
  SG_LIST_OF(int32_t) all = {0};
  bool good = true, kept = true;

  for (int32_t i = 0; i < 1000; i++) {
    good = good && SG_PUSH(all, i);
  }
  for (int32_t i = 0; i < 1000; i++) {
    kept = kept && all.item[i] == i;
  }
  CHECK("push", good && all.n == 1000 && all.room >= 1000);
  CHECK("what was there stays", kept);
  CHECK("room is doubled", all.room < 4000);
  free(all.item);
}

static void
needs(void)
{
  int64_t(*pair)[2] = NULL;
  size_t room = 0;

  CHECK("need", sg_list_need(&pair, 100, &room, sizeof *pair));
  CHECK("all of it", room >= 100);
  pair[99][1] = 7;
  CHECK("less", sg_list_need(&pair, 50, &room, sizeof *pair) && room >= 100);
  CHECK("one more", sg_list_grow(&pair, room, &room, sizeof *pair));
  CHECK("stays", pair[99][1] == 7);

  size_t before = room;

  CHECK("too much", !sg_list_need(&pair, SIZE_MAX / 2, &room, sizeof *pair));
  CHECK("changes nothing", room == before && pair[99][1] == 7);
  free(pair);
}

static void
zeroes(void)
{
  int32_t *bit = NULL;
  size_t room = 0;
  bool good = true;

  for (size_t n = 1; good && n < 1000; n += 7) {
    size_t before = room;

    good = sg_list_need_zeroed(&bit, n, &room, sizeof *bit) && room >= n;
    for (size_t i = before; i < room; i++) {
      good = good && bit[i] == 0;
      bit[i] = 1;
    }
    for (size_t i = 0; i < before; i++) {
      good = good && bit[i] == 1;
    }
  }
  CHECK("what is new is zeros, what was there stays", good);

  size_t before = room;

  CHECK("too much of zeros",
        !sg_list_need_zeroed(&bit, SIZE_MAX / 2, &room, sizeof *bit));
  CHECK("changes nothing", room == before && bit[room - 1] == 1);
  sg_list_trim(&bit, 10, &room, sizeof *bit);
  CHECK("trimmed", room == 10 && bit[9] == 1);
  sg_list_trim(&bit, 20, &room, sizeof *bit);
  CHECK("trimming makes no room", room == 10);
  sg_list_trim(&bit, 0, &room, sizeof *bit);
  CHECK("nothing is left", room == 0 && bit);
  free(bit);
}

static void
rooms(void)
{
  enum { MUCH = 1 << 20 };
  int64_t *much = sg_list_room(MUCH, sizeof *much);
  char *none = sg_list_room(0, 1);

  if (much && none) {
    much[0] = much[MUCH] = 7;
    none[0] = 7;
  }
  CHECK("room for one more", much && none);
  CHECK("no room",
        !sg_list_room(SIZE_MAX / 8, 8) && !sg_list_room(SIZE_MAX, 1));
  free(much);
  free(none);
}

int
main(void)
{
  rooms();
  pushes();
  needs();
  zeroes();
  return check_report();
}
