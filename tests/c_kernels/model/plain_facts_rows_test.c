/* plain_facts_rows_test.c -- plain facts of texts, whole and damaged, become
 * rows, through the functions of the doors.
 *
 * covers: plain_facts_rows, plain_polygons_rows, plain_read_rows
 *
 * An argument is the number of damaged texts.
 */
#include "doors/file.h"
#include "tests/c_kernels/door_call.h"
#include "tests/check.h"
#include "tests/memory/refuse.h"

#include <stdlib.h>

enum { ROUNDS = 3000, MOST = 4096 };

/* A text in memory, of which `chunk` octets come at once; SIZE_MAX: an error.
 */
typedef struct text {
  const char *at;
  size_t n, done, chunk;
} text;

static size_t
read_text(void *data, char *to, size_t n)
{
  text *t = data;
  size_t left = t->n - t->done;

  if (t->chunk == SIZE_MAX) {
    return SIZE_MAX;
  }
  n = n < left ? n : left;
  n = n < t->chunk ? n : t->chunk;
  memcpy(to, t->at + t->done, n);
  t->done += n;
  return n;
}

static const sg_text_place START = {0, 1, 0, 0};

/* The facts of a text; *end: where what is not plain begins. */
static sg_plain_facts *
facts_of(const char *at, size_t n, int32_t shift, sg_text_place *end)
{
  text t = {at, n, 0, 11};
  sg_plain_facts *facts = NULL;
  bool good =
      sg_door_plain_facts_open(&call, &(sg_input){read_text, &t}, &facts) &&
      sg_door_plain_facts_take(&call, facts, shift, &START, end);

  CHECK("a text", good);
  return facts;
}

static bool
adds(sg_plain_facts *facts, const char *relation)
{
  bool good = sg_door_plain_facts_add(&call, facts, relation);

  call.refusal = (sg_refusal){.how = SG_REFUSED_NOTHING};
  return good;
}

static const char SQUARE[] =
    "v(1,1,0,0,0). v(1,2,1.5,0,0).\nv(1,3,1,1.0e1,0). % 셋\n"
    "v(1,4,0,1,-0.5).\np(1, 1, [1,2,3,\t4]).\nregion(1,1,outside). "
    "/* */ foo(1).\n";

static void
test_square(void)
{
  sg_int_list ss = {0};
  sg_text_place end, again;
  sg_plain_facts *facts = facts_of(SQUARE, sizeof SQUARE - 1, 6, &end);

  CHECK("what is not plain", !strncmp(SQUARE + end.octet, "foo(1)", 6) &&
                                 end.line == 5 && end.column == 27 &&
                                 end.character == end.octet - 2);
  CHECK_DOOR("nothing more",
             sg_door_plain_facts_take(&call, facts, 6, &end, &again) &&
                 again.octet == end.octet);
  CHECK_DOOR("one segment, shifted",
             sg_door_plain_facts_segments(&call, facts, &ss) && ss.n == 1 &&
                 ss.at[0] == 7);
  again.octet = (int64_t)sizeof SQUARE;
  CHECK("no place", !sg_door_plain_facts_take(&call, facts, 0, &again, &end) &&
                        is_domain("place", 3));
  CHECK("no relation", !sg_door_plain_facts_add(&call, facts, "foo") &&
                           is_domain("relation", 2));
  CHECK("rows", adds(facts, "v") && adds(facts, "e") && adds(facts, "p") &&
                    adds(facts, "region") && rows_of(SG_V) == 4 &&
                    rows_of(SG_E) == 4 && rows_of(SG_P) == 1);
  sg_plain_facts_free(facts);
}

/* Where the first fact of "v(2,1,0,0,0). " ends, of a segment that is shifted
 * so far. */
static size_t
taken(int32_t shift)
{
  static const char vertex[] = "v(2,1,0,0,0). ";
  sg_text_place end;
  sg_plain_facts *facts = facts_of(vertex, sizeof vertex - 1, shift, &end);

  sg_plain_facts_free(facts);
  return (size_t)end.octet;
}

/* Numbers of segments are from 1 to the greatest, wherever they are shifted. */
static void
test_shift(void)
{
  CHECK("to the greatest", taken(INT32_MAX - 2) == 14);
  CHECK("past it", taken(INT32_MAX - 1) == 0);
  CHECK("down to 1", taken(-1) == 14);
  CHECK("to 0", taken(-2) == 0);
  CHECK("below", taken(INT32_MIN) == 0);
}

static void
test_no_text(void)
{
  text t = {"", 0, 0, SIZE_MAX};
  sg_plain_facts *facts = NULL;

  CHECK("not read",
        !sg_door_plain_facts_open(&call, &(sg_input){read_text, &t}, &facts) &&
            !facts && call.stopped);
  call.stopped = false;
}

/* Polygons that are not sound, in a world that has the vertices. */
static void
test_wrong(void)
{
  static const char *const wrong[] = {
      "p(1,1,[1,2]). ",       "p(1,1,[-1,2,3]). ",
      "p(1,1,[1,-2]). ",      "p(1,1,[1,2,0,3]). ",
      "p(1,1,[1,2,2,3]). ",   "p(1,1,[1,2,3,1,2]). ",
      "p(1,1,[1,-2,-3,1]). ", "p(1,1,[1,2,2147483647]). "};

  for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++) {
    sg_world *old = call.world;
    sg_text_place end;
    sg_plain_facts *facts = facts_of(wrong[i], strlen(wrong[i]), 0, &end);

    call.world = sg_world_open();
    CHECK(wrong[i], (size_t)end.octet == strlen(wrong[i]) &&
                        !adds(facts, "p") && rows_of(SG_P) == 0);
    sg_plain_facts_free(facts);
    sg_call_rest(&call);
    sg_world_drop(call.world);
    call.world = old;
  }
}

/* ---- damaged texts ------------------------------------------------------ */

static const char WHOLE[] =
    "\xef\xbb\xbf% a cube\r\nv(1,1,0,0,0). v(1,2,1,0,0). v(1,3,1,1,0).\n"
    "v(1,4,-1.25e-3,1,0.30000000000000004). e(2,1,1,2,1).\n"
    "p(1,1,[1,2,3,4,1,-2,3,1,2]). p(1,2,[4,3,2,1]). p(2,1,[1,2,3]).\n"
    "plane(1,1,0,0,1,0). sides(1,1,1,2). t(1,1,1,1,2,3). from_p(1,1,7,3,-1).\n"
    "region(1,1,outside). region(1,2,cell). leaf_v(1,1,0,0,0). /* or */\n"
    "leaf_e(1,1,1,2,1). leaf_p(1,1,[1,2,3]). piece(1,1,1).\n"
    "joint(1,1,1,2,fold,90.0). from_v(1,1,7,2). from_r(1,1,2,3).";

static const char *const SPLINTERS[] = {
    ".",           ",",
    "(",           ")",
    "[",           "]",
    "-",           "/*",
    "*/",          "%",
    "\n",          "\r",
    "\t",          "0",
    "\b",          "-0",
    "-2147483648", "e",
    "E+",          "1e999",
    "1.0e999",     "2147483647",
    "1.",          "99999999999",
    "'a'",         "\xff",
    "형",          "[[",
    "2147483648",  " . ",
    "0x1",         "Inf",
    "p(1,1,[",     "_",
    "v(",          "-2147483647",
    "]). ",        "v(2147483647,1,0,0,0). "};

/* A part of the whole text, changed; its size. */
static size_t
damaged(uint32_t *seed, char *out)
{
  size_t from = check_below(seed, 3) ? 3 : 0, n = sizeof WHOLE - 1 - from;

  memcpy(out, WHOLE + from, n);
  for (int times = check_below(seed, 5); times >= 0 && n > 0; times--) {
    size_t at = (size_t)check_below(seed, (int)n), more, left = n - at;
    const char *splinter =
        SPLINTERS[check_below(seed, sizeof SPLINTERS / sizeof *SPLINTERS)];

    switch (check_below(seed, 8)) {
    case 0:
      n = at + (size_t)check_below(seed, (int)left);
      break;
    case 1:
      out[at] = (char)check_below(seed, 256);
      break;
    case 2:
      more = (size_t)check_below(seed, left < 40 ? (int)left : 40);
      memmove(out + at, out + at + more, left - more);
      n -= more;
      break;
    default:
      more = strlen(splinter);
      memmove(out + at + more, out + at, left);
      memcpy(out + at, splinter, more);
      n += more;
    }
  }
  return n;
}

static bool
same_column(const sg_plain_column *x, const sg_plain_column *y, size_t n)
{
  return (!x->i || !memcmp(x->i, y->i, n * sizeof *x->i)) &&
         (!x->f || !memcmp(x->f, y->f, n * sizeof *x->f)) &&
         (!x->at || !memcmp(x->at, y->at, n * sizeof *x->at));
}

static bool
same_facts(const sg_plain_facts *x, const sg_plain_facts *y)
{
  bool same =
      x->words == y->words &&
      (x->words == 0 || !memcmp(x->word, y->word, x->words * sizeof *x->word));

  for (int r = 0; r < SG_RELATIONS; r++) {
    size_t n = x->of[r].n;

    same = same && n == y->of[r].n;
    for (unsigned c = 0; same && n > 0 && c < SG_MAX_COLUMNS; c++) {
      same = same_column(&x->of[r].column[c], &y->of[r].column[c], n);
    }
  }
  return same;
}

/* The same facts, taken one by one from a text that ends where its memory
 * does. */
static bool
same_by_one(const sg_plain_facts *all, const char *at, size_t n,
            const sg_text_place *end)
{
  sg_plain_facts *one = calloc(1, sizeof *one);
  sg_text_place place = START;
  int64_t before;

  one->text = malloc(n + (n == 0));
  one->size = n;
  memcpy(one->text, at, n);
  do {
    before = place.octet;
    sg_plain_facts_take(one, 1, 1, &place);
  } while (place.octet > before);
  bool same = place.octet == end->octet && place.line == end->line &&
              place.column == end->column &&
              place.character == end->character && same_facts(all, one);

  sg_plain_facts_free(one);
  return same;
}

/* All that was read goes into a new world, or is refused. */
static void
add_all(sg_plain_facts *facts)
{
  sg_world *old = call.world;
  sg_int_list ss = {0};
  bool ordered = true;

  call.world = sg_world_open();
  for (int r = 0; r < SG_RELATIONS; r++) {
    adds(facts, sg_relation_table[r].name);
  }
  CHECK("segments", sg_door_plain_facts_segments(&call, facts, &ss));
  for (size_t i = 1; i < ss.n; i++) {
    ordered = ordered && ss.at[i - 1] < ss.at[i];
  }
  CHECK("in order", ordered && (ss.n == 0 || ss.at[0] > 1));
  sg_call_close(&call);
  sg_world_drop(call.world);
  sg_call_open(&call, NULL, NULL);
  call.world = old;
}

static void
test_damaged(size_t rounds)
{
  char at[MOST];
  uint32_t seed = 7;
  size_t taken = 0;

  for (size_t i = 0; i < rounds; i++) {
    size_t n = damaged(&seed, at);
    sg_text_place end;
    sg_plain_facts *facts = facts_of(at, n, 1, &end);

    if (!CHECK("the same by one", same_by_one(facts, at, n, &end))) {
      fprintf(stderr, "%.*s\n", (int)n, at);
    }
    taken += end.octet > 0;
    add_all(facts);
    sg_plain_facts_free(facts);
  }
  CHECK("of some texts something is plain", taken > rounds / 3);
}

int
main(int argc, char **argv)
{
  sg_call_open(&call, NULL, NULL);
  call.world = sg_world_open();
  test_square();
  test_shift();
  test_no_text();
  test_wrong();
  sg_world *world = call.world;

  test_damaged(argc > 1 ? strtoul(argv[1], NULL, 10) : ROUNDS);
  sg_call_close(&call);
  sg_world_drop(world);
  return check_report();
}
