/* call_test.c -- what a door hands to its function. */
#include "call.h"

#include "tests/check.h"

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
  sg_poll host = {say_stop, &stop};
  sg_call call;

  sg_call_open(&call, &host, NULL);
  CHECK("a stop is remembered", !sg_poll_stop(&call.poll) && !call.stopped);
  stop = true;
  CHECK("a stop is remembered", sg_poll_stop(&call.poll) && call.stopped);
  stop = false;
  asked = 0;
  CHECK("a stop is remembered", sg_poll_stop(&call.poll) && asked == 0);
  CHECK("a stop is remembered",
        !sg_call_ended(&call) && call.refusal.how == SG_REFUSED_NOTHING);
  sg_call_close(&call);
  sg_call_open(&call, NULL, NULL);
  CHECK("a stop is remembered", !sg_poll_stop(&call.poll));
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
  CHECK("lists grow", sg_call_alloc(&call, SIZE_MAX) == NULL);
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

int
main(void)
{
  a_stop_is_remembered();
  the_first_refusal_counts();
  lists_grow();
  without_a_world_there_is_none();
  return check_report();
}
