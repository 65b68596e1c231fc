/* region_content_test.c -- two cubes side by side: what each region is inside,
 * and how many faces say otherwise.
 */
#include "gluing/region_content.h"

#include "tests/check.h"

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

int
main(void)
{
  two_cubes();
  return check_report();
}
