/* call_test.c -- what a door hands to its function. */
#include "call.h"

#include "tests/check.h"

#include <stdlib.h>
#include <string.h>

static int asked;

static bool
say_stop(void *data)
{
  asked++;
  return *(bool *)data;
}

static void
a_stop_is_remembered(void)
{
  bool stop = false;
  sg_cancel host = {say_stop, &stop};
  sg_call call;

  sg_call_open(&call, &host, NULL);
  CHECK("a stop is remembered", !sg_cancelled(&call.cancel) && !call.stopped);
  stop = true;
  CHECK("a stop is remembered", sg_cancelled(&call.cancel) && call.stopped);
  stop = false;
  asked = 0;
  CHECK("a stop is remembered", sg_cancelled(&call.cancel) && asked == 0);
  CHECK("a stop is remembered",
        !sg_call_ended(&call) && call.refusal.how == SG_REFUSED_NOTHING);
  sg_call_close(&call);
  sg_call_open(&call, NULL, NULL);
  CHECK("a stop is remembered", !sg_cancelled(&call.cancel));
  CHECK("a stop is remembered",
        !sg_call_ended(&call) && call.refusal.how == SG_REFUSED_MEMORY);
  sg_call_close(&call);
}

static void
the_first_refusal_counts(void)
{
  sg_call call;

  sg_call_open(&call, NULL, NULL);
  CHECK("the first refusal counts", !sg_call_missing(&call, "joint", 2));
  CHECK("the first refusal counts", !sg_call_domain(&call, "sense", 1));
  CHECK("the first refusal counts",
        !sg_call_forbidden_id(&call, "write", "segment", 7));
  CHECK("the first refusal counts", call.refusal.how == SG_REFUSED_EXISTENCE);
  CHECK("the first refusal counts",
        call.refusal.argument == 2 && !strcmp(call.refusal.what, "joint"));
  CHECK("the first refusal counts", sg_call_status(&call, SG_OK, SG_V, NULL));
  sg_call_close(&call);
}

/* Blocks that grow and move keep what is in them, and their neighbours. */
static void
lists_grow(void)
{
  enum { LISTS = 50, MOST = 1000 };
  sg_int_list list[LISTS] = {{NULL, 0, 0}};
  sg_call call;
  bool good = true;

  sg_call_open(&call, NULL, NULL);
  for (int i = 0; i < MOST; i++) {
    for (int k = 0; k < LISTS; k++) {
      good = good && (i > k * 20 || sg_int_list_add(&call, &list[k], i * k));
    }
  }
  for (int k = 0; k < LISTS; k++) {
    for (size_t i = 0; i < list[k].n; i++) {
      good = good && list[k].at[i] == (int32_t)i * k;
    }
    good = good && list[k].n == (size_t)k * 20 + 1;
  }
  CHECK("lists grow", good);
  for (size_t less = 0; less < 64; less++) { /* nor what wraps round */
    CHECK("lists grow", sg_call_alloc(&call, SIZE_MAX - less) == NULL);
  }
  CHECK("lists grow", call.refusal.how == SG_REFUSED_MEMORY);
  sg_call_close(&call);
  CHECK("lists grow", call.blocks == NULL);
}

static void
without_a_world_there_is_none(void)
{
  sg_call call;

  sg_call_open(&call, NULL, NULL);
  CHECK("no world",
        sg_call_world(&call) == NULL && sg_call_claim(&call) == NULL);
  sg_call_close(&call);
}

/* A stream of 10 octets, three at a time, that fails if it is told so. */
static size_t
give(void *data, char *to, size_t n)
{
  int *left = data;
  size_t got = *left < 3 ? (size_t)*left : 3;

  if (*left < 0) {
    return SIZE_MAX;
  }
  memset(to, 'x', got < n ? got : n);
  *left -= (int)got;
  return got;
}

static void
streams_are_read(void)
{
  int left = 10;
  sg_input in = {give, &left};
  sg_call call;
  char *text, *more;
  size_t n;

  sg_call_open(&call, NULL, NULL);
  CHECK("all of it", sg_call_read_all(&call, &in, SIZE_MAX, &text, &n));
  CHECK("all of it", n == 10 && !memcmp(text, "xxxxxxxxxx", n));
  free(text);
  left = 10;
  CHECK("too much", sg_call_read_all(&call, &in, 4, &more, &n) && n > 4);
  free(more);
  left = -1;
  CHECK("a failure", !sg_call_read_all(&call, &in, 4, &text, &n) && !text);
  CHECK("the host knows",
        call.stopped && call.refusal.how == SG_REFUSED_NOTHING);
  sg_call_close(&call);
}

/* Short and long terms last as long as the call. */
static void
terms_are_kept(void)
{
  const uint32_t *kept[2];
  sg_term_builder b;
  sg_call call;

  sg_call_open(&call, NULL, NULL);
  for (int k = 0; k < 2; k++) {
    sg_term_open(&b);
    for (int i = 0; i < (k ? 1000 : 2); i++) {
      sg_term_compound(&b, SG_SYMBOL_CONS, 2);
      sg_term_int(&b, i);
    }
    sg_term_nil(&b);
    kept[k] = sg_call_term(&call, &b);
  }
  CHECK("kept", kept[0] && kept[1] &&
                    sg_term_length(kept[0]) == 1 + 2 * 3 + 1 &&
                    sg_term_length(kept[1]) == 1 + 1000 * 3 + 1);
  sg_term_open(&b);
  b.failed = true;
  CHECK("a term that failed", !sg_call_term(&call, &b));
  CHECK("is refused", call.refusal.how == SG_REFUSED_MEMORY);
  sg_call_close(&call);
}

/* The version is that of the first question until the call rests. */
static void
a_call_has_a_version(void)
{
  sg_world *world = sg_world_open();
  const sg_value row[5] = {{.i = 1}, {.i = 1}};
  sg_call call;

  sg_call_open(&call, NULL, NULL);
  call.world = world;
  const sg_version *version = sg_call_version(&call);
  CHECK("a row", sg_world_add(world, SG_V, row, NULL, NULL) == SG_OK);
  CHECK("one version", sg_call_version(&call) == version &&
                           sg_version_count(version, SG_V) == 0);
  CHECK("threads", sg_call_pool(&call) == sg_call_pool(&call));
  sg_call_rest(&call);
  CHECK("another", sg_version_count(sg_call_version(&call), SG_V) == 1);
  sg_call_close(&call);
  sg_world_drop(world);
}

int
main(void)
{
  streams_are_read();
  terms_are_kept();
  a_call_has_a_version();
  a_stop_is_remembered();
  the_first_refusal_counts();
  lists_grow();
  without_a_world_there_is_none();
  return check_report();
}
