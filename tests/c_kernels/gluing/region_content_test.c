/* region_content_test.c -- two cubes side by side: what each region is inside,
 * and how many faces say otherwise.
 */
#include "gluing/region_content.h"

#include "tests/check.h"
#include "tests/memory/refuse.h"

enum { LEFT, RIGHT, OUTSIDE, REGIONS };

/* The left one, what both have, the right one. */
static uint32_t side[] = {LEFT, OUTSIDE, LEFT, RIGHT, RIGHT, OUTSIDE};

/* How many faces are wrong, of what they are parts of. */
static size_t
wrong_of(const uint32_t *begin, const int32_t *solid, sg_region_content *out)
{
  const sg_content_faces faces = {3, side, begin, solid};
  sg_cancel cancel = {0};
  size_t wrong = SIZE_MAX;

  CHECK("made",
        sg_region_content_make(&faces, REGIONS, OUTSIDE, &cancel, out, &wrong));
  return wrong;
}

static void
two_cubes(void)
{
  sg_region_content content;

  CHECK("right", wrong_of((uint32_t[]){0, 1, 3, 4}, (int32_t[]){7, 7, 8, 8},
                          &content) == 0);
  CHECK("each its own", content.begin[LEFT + 1] == 1 &&
                            content.begin[RIGHT + 1] == 2 &&
                            content.solid[0] == 7 && content.solid[1] == 8);
  sg_region_content_clear(&content);
  CHECK("what both have is a part of one",
        wrong_of((uint32_t[]){0, 1, 2, 3}, (int32_t[]){7, 7, 8}, &content) ==
            1);
  sg_region_content_clear(&content);
  side[1] = LEFT;
  CHECK("the left one is open",
        wrong_of((uint32_t[]){0, 1, 3, 4}, (int32_t[]){7, 7, 8, 8}, &content) ==
            1);
  sg_region_content_clear(&content);
  side[1] = OUTSIDE;
}

/* ---- random regions, each inside random solids, as bits ---- */

enum { MOST_REGIONS = 12, MOST_FACES = 40, SOLIDS = 9 };

static struct {
  size_t regions, faces, parts;
  unsigned in[MOST_REGIONS];
  unsigned part[MOST_FACES]; /* of which each face says that it is */
  bool reached[MOST_REGIONS];
  uint32_t side[2 * MOST_FACES], begin[MOST_FACES + 1];
  int32_t solid[2 * SOLIDS * MOST_FACES];
} plan;

static uint32_t seed;

/* Ascending; some solids twice, which says nothing. */
static void
write_parts(size_t face, unsigned parts)
{
  unsigned both = (unsigned)check_below(&seed, 1 << SOLIDS) &
                  (unsigned)check_below(&seed, 1 << SOLIDS) & ~parts;

  plan.part[face] = parts;
  plan.begin[face] = (uint32_t)plan.parts;
  for (int32_t k = 0; k < SOLIDS; k++) {
    for (unsigned n = parts >> k & 1 ? 1 : 2 * (both >> k & 1); n > 0; n--) {
      plan.solid[plan.parts++] = 10 * k + 3;
    }
  }
  plan.begin[face + 1] = (uint32_t)plan.parts;
}

/* Region 0 is outside. Faces that are wrong say anything. */
static void
draw_plan(bool wrong)
{
  plan.regions = 2 + (size_t)check_below(&seed, MOST_REGIONS - 1);
  plan.faces = (size_t)check_below(&seed, MOST_FACES + 1);
  plan.parts = plan.begin[0] = 0;
  for (size_t r = 0; r < plan.regions; r++) {
    plan.in[r] = r == 0 ? 0 : (unsigned)check_below(&seed, 1 << SOLIDS);
    plan.reached[r] = r == 0;
  }
  for (size_t f = 0; f < plan.faces; f++) {
    uint32_t a = (uint32_t)check_below(&seed, (int)plan.regions);
    uint32_t b = (uint32_t)check_below(&seed, (int)plan.regions);
    bool is_wrong = wrong && check_below(&seed, 4) == 0;

    plan.side[2 * f] = a;
    plan.side[2 * f + 1] = b;
    write_parts(f, is_wrong ? (unsigned)check_below(&seed, 1 << SOLIDS)
                            : plan.in[a] ^ plan.in[b]);
  }
  for (size_t turn = 0; turn < plan.regions; turn++) {
    for (size_t f = 0; f < plan.faces; f++) {
      const uint32_t *s = plan.side + 2 * f;

      plan.reached[s[0]] = plan.reached[s[0]] || plan.reached[s[1]];
      plan.reached[s[1]] = plan.reached[s[1]] || plan.reached[s[0]];
    }
  }
}

/* What a region is said to be inside; UINT_MAX: not in order. */
static unsigned
said_of(const sg_region_content *content, size_t r)
{
  unsigned in = 0;

  for (size_t i = content->begin[r]; i < content->begin[r + 1]; i++) {
    if (i > content->begin[r] && content->solid[i] <= content->solid[i - 1]) {
      return UINT32_MAX;
    }
    in |= 1u << content->solid[i] / 10;
  }
  return in;
}

/* Each region is inside what it is, or if faces are wrong, inside what leads
 * there on some way; and so many faces say otherwise. */
static bool
is_right(const sg_region_content *content, size_t wrong, bool any_wrong)
{
  size_t otherwise = 0;
  bool good = said_of(content, 0) == 0;

  for (size_t r = 0; r < plan.regions; r++) {
    unsigned in = plan.reached[r] ? plan.in[r] : 0;
    good = good && said_of(content, r) != UINT32_MAX &&
           (any_wrong ? plan.reached[r] || said_of(content, r) == 0
                      : said_of(content, r) == in);
  }
  for (size_t f = 0; f < plan.faces; f++) {
    const uint32_t *s = plan.side + 2 * f;

    otherwise += plan.reached[s[0]] && (said_of(content, s[0]) ^
                                        said_of(content, s[1])) != plan.part[f];
  }
  return good && wrong == otherwise && (any_wrong || wrong == 0);
}

/* True: right, or there was no memory. */
static bool
makes_plan(bool any_wrong, bool *made)
{
  const sg_content_faces faces = {plan.faces, plan.side, plan.begin,
                                  plan.solid};
  sg_region_content content;
  size_t wrong = SIZE_MAX;

  *made =
      sg_region_content_make(&faces, plan.regions, 0, NULL, &content, &wrong);
  bool good = !*made || is_right(&content, wrong, any_wrong);

  sg_region_content_clear(&content);
  return good;
}

static void
random_plans(void)
{
  size_t bad = 0;
  bool made;

  for (uint32_t round = 0; round < 4000; round++) {
    seed = round;
    draw_plan(round % 2);
    bad += !makes_plan(round % 2, &made) || !made;
  }
  CHECK("as planned", bad == 0);
  for (uint32_t round = 0; round < 20; round++) {
    seed = round;
    draw_plan(round % 2);
    CHECK_REFUSED("a plan", makes_plan(round % 2, &made));
    CHECK("with memory", made);
  }
}

int
main(void)
{
  two_cubes();
  random_plans();
  return check_report();
}
