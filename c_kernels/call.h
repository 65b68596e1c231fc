/* call.h -- what a door hands to its function: how to stop, where rows are,
 * what was refused, and memory for as long as the call lasts.
 *
 * Layer: rows. A function sg_door_NAME() stands behind each predicate of
 * rules/kernel/ that has types; doors/TOPIC.h, made from those modules and from
 * doors.def, has their prototypes. They know the store, not Prolog:
 *
 *   bool sg_door_NAME(sg_call *call, IN in, ..., OUT *out, ...);
 *
 * True: the answer is yes, and all of `out` is filled. False: the answer is no,
 * or `call` says what was refused, or its cancel said stop; what was allocated
 * is freed with the call. A test makes a sg_call of its own, with a world.
 */
#ifndef SG_CALL_H
#define SG_CALL_H

#include "engine/cancel.h"
#include "thread_pool.h"

#include "engine/store.h"
#include "engine/term.h"

#include <stdint.h>

/* The standard errors of Prolog, by the name of their terms. */
typedef enum sg_refused {
  SG_REFUSED_NOTHING,
  SG_REFUSED_MEMORY,         /* resource_error(memory) */
  SG_REFUSED_RESOURCE,       /* resource_error(what) */
  SG_REFUSED_DOMAIN,         /* domain_error(what, culprit) */
  SG_REFUSED_EXISTENCE,      /* existence_error(what, culprit) */
  SG_REFUSED_PERMISSION,     /* permission_error(action, what, culprit) */
  SG_REFUSED_REPRESENTATION, /* representation_error(what) */
  SG_REFUSED_GEOMETRY,       /* geometry_error(what(number, ...)) */
  SG_REFUSED_ROW             /* what sg_status says of a row */
} sg_refused;

typedef struct sg_refusal {
  sg_refused how;
  const char *action, *what; /* of static life */
  int argument;              /* the culprit: argument 1.., or 0: this: */
  size_t item;               /* of that, if it is a list, this item, 1.., */
  int field;                 /* or, not 0, an argument of the item */
  bool pair;                 /* the culprit: that argument - the next */
  int64_t number;
  int32_t of[4]; /* [numbers]: of SG_REFUSED_GEOMETRY */
  size_t numbers;
  sg_status status; /* of SG_REFUSED_ROW */
  sg_relation relation;
  sg_fault fault;
} sg_refusal;

typedef struct sg_call {
  sg_cancel cancel;              /* remembers that it said stop */
  const sg_cancel *host;         /* what it asks */
  bool stopped;                  /* it said stop */
  sg_world *(*find_world)(void); /* a world that is whole; null: refused */
  sg_world *world;               /* borrowed; null: not asked for yet */
  const sg_version *version;     /* held; null: the same */
  sg_pool *pool;                 /* the same */
  sg_refusal refusal;
  struct sg_call_block *blocks; /* private */
  uint32_t *word;               /* room for so many words of terms: private */
  size_t words;
} sg_call;

/* A call of nothing yet; `find_world` may be null if call->world is set. */
void sg_call_open(sg_call *call, const sg_cancel *host,
                  sg_world *(*find_world)(void));
/* Lets the version and the thread pool go: the memory is still good. */
void sg_call_rest(sg_call *call);
/* The same, and frees what it has. */
void sg_call_close(sg_call *call);

/* The current world, whole; null: there is none, and the caller knows why. */
sg_world *sg_call_world(sg_call *call);
/* Its version when this was asked first, and threads to work with; both until
 * the call rests or is closed. Null: refused. */
const sg_version *sg_call_version(sg_call *call);
sg_pool *sg_call_pool(sg_call *call);
/* The world, claimed for writing: sg_world_release() it. Null: also a stop. */
sg_world *sg_call_claim(sg_call *call);

/* All of these return false. The first that is refused counts. */
bool sg_call_no_memory(sg_call *call);
/* After a kernel that was stopped or, if not, had no memory. */
bool sg_call_ended(sg_call *call);
bool sg_call_domain(sg_call *call, const char *what, int argument);
/* The same of argument - the next one. */
bool sg_call_domain_pair(sg_call *call, const char *what, int argument);
bool sg_call_missing(sg_call *call, const char *what, int argument);
bool sg_call_forbidden(sg_call *call, const char *action, const char *what,
                       int argument);
/* After one of these: not the argument, a list, but its item, from 1, or, if
 * field is not 0, that argument of the item. */
bool sg_call_at(sg_call *call, size_t item, int field);
/* The same of numbers that are no argument. */
bool sg_call_domain_of(sg_call *call, const char *what, int64_t number);
bool sg_call_missing_id(sg_call *call, const char *what, int64_t id);
bool sg_call_forbidden_id(sg_call *call, const char *action, const char *what,
                          int64_t id);
/* geometry_error(what(number, ...)), of 4 numbers at most. */
bool sg_call_geometry(sg_call *call, const char *what, const int32_t *number,
                      size_t numbers);
bool sg_call_cannot_hold(sg_call *call, const char *what);
/* SG_OK: true. */
bool sg_call_status(sg_call *call, sg_status status, sg_relation relation,
                    const sg_fault *fault);

/* sg_world_fresh(); 0: refused. */
int32_t sg_call_fresh(sg_call *call, sg_world *world, sg_relation relation,
                      int32_t s);
bool sg_call_add_row(sg_call *call, sg_world *world, sg_relation relation,
                     const sg_value *row);
/* sg_world_add_many_or_stop(). */
bool sg_call_add_rows(sg_call *call, sg_world *world, sg_relation relation,
                      size_t n, const void *const *column);

/* Memory until the call is closed, null: refused. The second also moves what
 * the first or it gave; `at` may be null. */
void *sg_call_alloc(sg_call *call, size_t bytes);
void *sg_call_realloc(sg_call *call, void *at, size_t bytes);

/* Frees what malloc() gave when the call is closed; false: refused, and freed
 * at once. */
bool sg_call_adopt(sg_call *call, void *memory);
/* The same of any object. */
bool sg_call_hold(sg_call *call, void *object, void (*release)(void *object));

/* What a builder has, until the call is closed; null: refused. Closes the
 * builder. */
const uint32_t *sg_call_term(sg_call *call, sg_term_builder *builder);

/* A stream that the host reads: up to n octets, 0 at the end, SIZE_MAX: it
 * failed, and the host knows why. */
typedef struct sg_input {
  size_t (*read)(void *data, char *to, size_t n);
  void *data;
} sg_input;

/* One that it writes; false: it failed, and the host knows why. */
typedef struct sg_output {
  bool (*write)(void *data, const char *bytes, size_t n);
  void *data;
} sg_output;

/* What was read; 0: the end, or the call has stopped. */
size_t sg_call_read(sg_call *call, const sg_input *in, char *to, size_t n);
/* All that comes, or the first part of it, which is more than `most` octets.
 * False: *out is null. Owner: the caller, free(). */
bool sg_call_read_all(sg_call *call, const sg_input *in, size_t most,
                      char **out, size_t *n);

typedef struct sg_bytes {
  const uint8_t *at;
  size_t n;
} sg_bytes;

/* A number with an exact value: `text`, as N or N/D, or if that is null,
 * `number`. */
typedef struct sg_exact {
  const char *text;
  double number;
} sg_exact;

/* Lists of arguments and of answers: NAME has `n` of T `at`. An empty one is
 * zeros. NAME_add() adds one; an answer may also be put at what outlives the
 * call, with room 0. */
#define SG_CALL_LIST(NAME, T)                                                  \
  typedef struct NAME {                                                        \
    T *at;                                                                     \
    size_t n, room;                                                            \
  } NAME;                                                                      \
  static inline bool NAME##_add(sg_call *call, NAME *list, T x)                \
  {                                                                            \
    if (list->n == list->room) {                                               \
      size_t room = list->room ? 2 * list->room : 8;                           \
      T *at = sg_call_realloc(call, list->at, room * sizeof *at);              \
      if (!at) {                                                               \
        return false;                                                          \
      }                                                                        \
      list->at = at;                                                           \
      list->room = room;                                                       \
    }                                                                          \
    list->at[list->n++] = x;                                                   \
    return true;                                                               \
  }                                                                            \
  typedef struct NAME NAME

/* point(X, Y, Z), and vector(X, Y, Z). */
typedef struct sg_xyz {
  double at[3];
} sg_xyz;

SG_CALL_LIST(sg_int_list, int32_t);
SG_CALL_LIST(sg_count_list, size_t);
SG_CALL_LIST(sg_integer_list, int64_t);
SG_CALL_LIST(sg_number_list, double);

#endif
