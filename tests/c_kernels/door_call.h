/* door_call.h -- what tests of the row layer ask of the call in hand.
 */
#ifndef SG_TEST_DOOR_CALL_H
#define SG_TEST_DOOR_CALL_H

#include "call.h"
#include "engine/store.h"

#include <stdbool.h>
#include <string.h>

static sg_call call;

/* Whether it was refused for the domain of this argument. What it said is
 * forgotten then; so below. */
static inline bool
is_domain(const char *what, int argument)
{
  const sg_refusal *r = &call.refusal;
  bool is = r->how == SG_REFUSED_DOMAIN && !strcmp(r->what, what) &&
            r->argument == argument;

  call.refusal = (sg_refusal){.how = SG_REFUSED_NOTHING};
  return is;
}

static inline bool
was_refused(sg_refused how)
{
  bool was = call.refusal.how == how;

  call.refusal = (sg_refusal){.how = SG_REFUSED_NOTHING};
  return was;
}

/* The rows of a relation in the world of the call. */
static inline size_t
rows_of(sg_relation relation)
{
  const sg_version *version = sg_world_version(call.world);
  size_t n = sg_version_count(version, relation);

  sg_version_drop(version);
  return n;
}

/* segment(s, solid, s). */
static inline bool
add_segment(int32_t s)
{
  sg_term_builder b;

  sg_term_open(&b);
  sg_term_int(&b, s);
  sg_status status = sg_world_add(call.world, SG_SEGMENT,
                                  (sg_value[]){{.i = s},
                                               {.i = SG_SYMBOL_SOLID},
                                               {.term = sg_term_words(&b)}},
                                  NULL, NULL);

  sg_term_close(&b);
  return status == SG_OK;
}

#endif
