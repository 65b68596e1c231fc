/* call.c -- see call.h. */
#include "call.h"
#include "engine/list.h"

#include <stdlib.h>
#include <string.h>

/* Allocated for a call: the header of a block. */
typedef struct sg_call_block {
  struct sg_call_block *next, *previous;
  void *held; /* released with it, or null */
  void (*release)(void *held);
  max_align_t bytes[];
} block;

enum { TERM_WORDS = 16 * SG_TERM_FEW };

static bool
ask_host(void *data)
{
  sg_call *call = data;

  call->stopped = call->stopped || sg_cancelled(call->host);
  return call->stopped;
}

void
sg_call_open(sg_call *call, const sg_cancel *host,
             sg_world *(*find_world)(void))
{
  *call = (sg_call){
      .cancel = {ask_host, call}, .host = host, .find_world = find_world};
}

sg_world *
sg_call_world(sg_call *call)
{
  if (!call->world && call->find_world) {
    call->world = call->find_world();
  }
  return call->world;
}

sg_world *
sg_call_claim(sg_call *call)
{
  sg_world *world = sg_call_world(call);

  return world && sg_world_claim(world, &call->cancel) ? world : NULL;
}

const sg_version *
sg_call_version(sg_call *call)
{
  sg_world *world = sg_call_world(call);

  if (world && !call->version && !(call->version = sg_world_version(world))) {
    sg_call_no_memory(call);
  }
  return call->version;
}

sg_pool *
sg_call_pool(sg_call *call)
{
  if (!call->pool && !(call->pool = sg_pool_open(0))) {
    sg_call_no_memory(call);
  }
  return call->pool;
}

/* ---- refusals ---- */

static bool
refuse(sg_call *call, sg_refusal refusal)
{
  if (call->refusal.how == SG_REFUSED_NOTHING) {
    call->refusal = refusal;
  }
  return false;
}

bool
sg_call_no_memory(sg_call *call)
{
  return refuse(call, (sg_refusal){.how = SG_REFUSED_MEMORY});
}

bool
sg_call_ended(sg_call *call)
{
  return call->stopped ? false : sg_call_no_memory(call);
}

bool
sg_call_domain(sg_call *call, const char *what, int argument)
{
  return refuse(call, (sg_refusal){.how = SG_REFUSED_DOMAIN,
                                   .what = what,
                                   .argument = argument});
}

bool
sg_call_domain_pair(sg_call *call, const char *what, int argument)
{
  return refuse(call, (sg_refusal){.how = SG_REFUSED_DOMAIN,
                                   .what = what,
                                   .argument = argument,
                                   .pair = true});
}

bool
sg_call_domain_of(sg_call *call, const char *what, int64_t number)
{
  return refuse(
      call,
      (sg_refusal){.how = SG_REFUSED_DOMAIN, .what = what, .number = number});
}

bool
sg_call_at(sg_call *call, size_t item, int field)
{
  call->refusal.item = item;
  call->refusal.field = field;
  return false;
}

bool
sg_call_geometry(sg_call *call, const char *what, const int32_t *number,
                 size_t numbers)
{
  sg_refusal refusal = {
      .how = SG_REFUSED_GEOMETRY, .what = what, .numbers = numbers};

  memcpy(refusal.of, number, numbers * sizeof *number);
  return refuse(call, refusal);
}

bool
sg_call_missing(sg_call *call, const char *what, int argument)
{
  return refuse(call, (sg_refusal){.how = SG_REFUSED_EXISTENCE,
                                   .what = what,
                                   .argument = argument});
}

bool
sg_call_missing_id(sg_call *call, const char *what, int64_t id)
{
  return refuse(
      call,
      (sg_refusal){.how = SG_REFUSED_EXISTENCE, .what = what, .number = id});
}

bool
sg_call_forbidden(sg_call *call, const char *action, const char *what,
                  int argument)
{
  return refuse(call, (sg_refusal){.how = SG_REFUSED_PERMISSION,
                                   .action = action,
                                   .what = what,
                                   .argument = argument});
}

bool
sg_call_forbidden_id(sg_call *call, const char *action, const char *what,
                     int64_t id)
{
  return refuse(call, (sg_refusal){.how = SG_REFUSED_PERMISSION,
                                   .action = action,
                                   .what = what,
                                   .number = id});
}

bool
sg_call_cannot_hold(sg_call *call, const char *what)
{
  return refuse(call,
                (sg_refusal){.how = SG_REFUSED_REPRESENTATION, .what = what});
}

bool
sg_call_status(sg_call *call, sg_status status, sg_relation relation,
               const sg_fault *fault)
{
  return status == SG_OK ||
         refuse(call, (sg_refusal){.how = SG_REFUSED_ROW,
                                   .status = status,
                                   .relation = relation,
                                   .fault = fault ? *fault : (sg_fault){0}});
}

/* ---- rows ---- */

int32_t
sg_call_fresh(sg_call *call, sg_world *world, sg_relation relation, int32_t s)
{
  int32_t id = sg_world_fresh(world, relation, s);

  if (id == 0) {
    refuse(call, (sg_refusal){.how = SG_REFUSED_RESOURCE, .what = "fresh_ids"});
  } else if (id < 0) {
    sg_call_no_memory(call);
  }
  return id > 0 ? id : 0;
}

bool
sg_call_add_row(sg_call *call, sg_world *world, sg_relation relation,
                const sg_value *row)
{
  sg_fault fault = {0};
  sg_row out;

  return sg_call_status(call, sg_world_add(world, relation, row, &out, &fault),
                        relation, &fault);
}

bool
sg_call_add_rows(sg_call *call, sg_world *world, sg_relation relation, size_t n,
                 const void *const *column)
{
  sg_fault fault = {0};
  sg_status status = sg_world_add_many_or_stop(world, relation, n, column,
                                               &call->cancel, &fault);

  return status != SG_HALTED && sg_call_status(call, status, relation, &fault);
}

/* ---- memory ---- */

void *
sg_call_alloc(sg_call *call, size_t bytes)
{
  return sg_call_realloc(call, NULL, bytes);
}

void *
sg_call_realloc(sg_call *call, void *at, size_t bytes)
{
  block *old = at ? (block *)((char *)at - offsetof(block, bytes)) : NULL;
  block *b = bytes < SIZE_MAX / 2 ? realloc(old, sizeof *b + bytes) : NULL;

  if (!b) {
    sg_call_no_memory(call);
    return NULL;
  }
  if (!old) {
    b->previous = NULL;
    b->next = call->blocks;
    b->held = NULL;
  }
  if (b->next) {
    b->next->previous = b;
  }
  *(b->previous ? &b->previous->next : &call->blocks) = b;
  return b->bytes;
}

bool
sg_call_hold(sg_call *call, void *object, void (*release)(void *object))
{
  if (!sg_call_alloc(call, 0)) {
    release(object);
    return false;
  }
  call->blocks->held = object;
  call->blocks->release = release;
  return true;
}

bool
sg_call_adopt(sg_call *call, void *memory)
{
  return sg_call_hold(call, memory, free);
}

/* A copy of a term of few words: many of these are in one block. */
static uint32_t *
keep_few(sg_call *call, const uint32_t *words)
{
  size_t n = sg_term_length(words);

  if (call->words < n) {
    call->word = sg_call_alloc(call, TERM_WORDS * sizeof *call->word);
    call->words = call->word ? TERM_WORDS : 0;
  }
  if (!call->word) {
    return NULL;
  }
  uint32_t *kept = memcpy(call->word, words, n * sizeof *words);

  call->word += n;
  call->words -= n;
  return kept;
}

const uint32_t *
sg_call_term(sg_call *call, sg_term_builder *builder)
{
  const uint32_t *words = sg_term_words(builder);
  uint32_t *kept = NULL;

  if (!words) {
    sg_call_no_memory(call);
  } else if (words == builder->few) {
    kept = keep_few(call, words);
  } else if (sg_call_adopt(call, builder->word)) {
    kept = builder->word;
    sg_term_open(builder);
  } else {
    sg_term_open(builder); /* it is freed */
  }
  sg_term_close(builder);
  return kept;
}

/* ---- streams ---- */

size_t
sg_call_read(sg_call *call, const sg_input *in, char *to, size_t n)
{
  size_t got = sg_cancelled(&call->cancel) ? 0 : in->read(in->data, to, n);

  call->stopped = call->stopped || got == SIZE_MAX;
  return call->stopped ? 0 : got;
}

bool
sg_call_read_all(sg_call *call, const sg_input *in, size_t most, char **out,
                 size_t *n)
{
  enum { CHUNK = 1 << 18 }; /* between cancellations */
  size_t room = 0, got = 0;

  *out = NULL;
  *n = 0;
  do {
    *n += got;
    if (!sg_list_need(out, *n + CHUNK, &room, 1)) {
      sg_call_no_memory(call);
      break;
    }
    got = sg_call_read(call, in, *out + *n, CHUNK);
  } while (got > 0 && *n <= most);
  if (call->stopped || call->refusal.how != SG_REFUSED_NOTHING) {
    free(*out);
    *out = NULL;
  }
  return *out != NULL;
}

void
sg_call_rest(sg_call *call)
{
  sg_version_drop(call->version);
  sg_pool_close(call->pool);
  call->version = NULL;
  call->pool = NULL;
}

void
sg_call_close(sg_call *call)
{
  sg_call_rest(call);
  while (call->blocks) {
    block *b = call->blocks;

    call->blocks = b->next;
    if (b->held) {
      b->release(b->held);
    }
    free(b);
  }
}
