/* arena_test.c -- pieces do not overlap, and what comes and goes needs no more
 * room than the most that there was at once. */
#include "engine/arena.h"
#include "tests/check.h"

#include <stdlib.h>

enum { PIECES = 3000, ROUNDS = 40000, MOST_WORDS = 1200 };

static uint64_t state = 11;

static uint32_t
draw(uint32_t n)
{
  state = state * 6364136223846793005u + 1442695040888963407u;
  return (uint32_t)(state >> 33) % n;
}

typedef struct piece {
  uint32_t *at;
  uint32_t words, mark;
} piece;

static bool
take(sg_arena *arena, piece *p, uint32_t words)
{
  *p = (piece){sg_arena_take(arena, words), words, draw(UINT32_MAX)};
  for (uint32_t i = 0; p->at && i < words; i++) {
    p->at[i] = p->mark + i;
  }
  return p->at != NULL;
}

/* False: somebody wrote into it. */
static bool
give(sg_arena *arena, piece *p)
{
  bool whole = true;

  for (uint32_t i = 0; i < p->words; i++) {
    whole = whole && p->at[i] == p->mark + i;
  }
  sg_arena_give(arena, p->at, p->words);
  p->at = NULL;
  return whole;
}

static void
test_sizes(void)
{
  static piece all[MOST_WORDS];
  sg_arena arena = {0};
  bool good = true, whole = true;

  for (uint32_t words = 1; words < MOST_WORDS; words++) {
    good = good && take(&arena, &all[words], words);
  }
  CHECK("a piece of every size", good && sg_arena_is_valid(&arena));
  for (uint32_t words = 1; words < MOST_WORDS; words += 2) {
    whole = give(&arena, &all[words]) && whole;
  }
  CHECK("valid with holes", sg_arena_is_valid(&arena));
  for (uint32_t words = 2; words < MOST_WORDS; words += 2) {
    whole = give(&arena, &all[words]) && whole;
  }
  CHECK("none reaches into another", whole);
  CHECK("one block of each size is left",
        sg_arena_is_valid(&arena) && !arena.full && !arena.large &&
            arena.bytes <= SG_ARENA_SIZES << 14);
  sg_arena_give(&arena, NULL, 3);
  sg_arena_clear(&arena);
  CHECK("nothing is left", arena.bytes == 0);
}

/* Random pieces come and go, some early ones stay: the arena does not grow once
 * it has seen all sizes. A large piece is exchanged each time, as the record of
 * a node is that names all its leaves. */
static void
test_coming_and_going(void)
{
  static piece all[PIECES];
  sg_arena arena = {0};
  piece large = {0};
  bool good = true;
  size_t early = 0;

  for (unsigned i = 0; i < PIECES; i++) {
    good = good && take(&arena, &all[i], 1 + draw(40));
  }
  for (unsigned round = 0; good && round < ROUNDS; round++) {
    piece *p = &all[draw(PIECES)];
    good = (!large.at || give(&arena, &large)) && give(&arena, p) &&
           take(&arena, p, 1 + draw(40)) &&
           take(&arena, &large, 8000 + draw(4000));
    early = round == ROUNDS / 10 ? arena.bytes : early;
  }
  CHECK("all as it was written", good && sg_arena_is_valid(&arena));
  CHECK("it does not grow", arena.bytes < early + early / 10);
  sg_arena_clear(&arena);
}

int
main(void)
{
  test_sizes();
  test_coming_and_going();
  return check_report();
}
