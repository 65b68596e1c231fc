/* door.h -- what the doors made by tools/doors.pl are put together from.
 *
 * Layer: glue. get_TYPE() reads an argument, put_TYPE() makes a term; both
 * return FALSE with an exception pending, or with a refusal in the call.
 */
#ifndef SG_DOOR_H
#define SG_DOOR_H

#include "call.h"

#include "engine/world4pl.h"

#include <SWI-Prolog.h>
#include <stdatomic.h>

/* ---- a call ---- */

void sg_door_open(sg_call *call);
/* Raises what was refused, frees what the call has; returns `done`. t0: the
 * first argument. */
foreign_t sg_door_close(sg_call *call, term_t t0, int done);

/* A nondeterministic door. At the first call `ask` fills *rows, a list of
 * call.h, with all answers; `answer` unifies the arguments with
 * the i-th. The last one that fits leaves no choice point. `outputs`: bit k,
 * t0 + k may be unbound. */
foreign_t sg_door_answer(term_t t0, unsigned outputs, control_t control,
                         int (*ask)(sg_call *call, term_t t0, void *rows,
                                    size_t *n),
                         int (*answer)(term_t t0, const void *rows, size_t i));

/* ---- handles ---- */

typedef struct sg_handle_type {
  PL_blob_t blob; /* the first */
  void (*free)(void *object);
} sg_handle_type;

/* Behind the blob. The object is freed when it is closed, or forgotten, and no
 * call looks at it. */
typedef struct sg_handle {
  void *object;
  sg_handle_type *type;
  atomic_uint users; /* calls, and Prolog until it is closed */
  atomic_bool closed;
} sg_handle;

int sg_handle_release(atom_t atom);
int sg_handle_write(IOSTREAM *out, atom_t atom, int flags);

#define SG_HANDLE_TYPE(NAME, FREE)                                             \
  {                                                                            \
    .blob = {.magic = PL_BLOB_MAGIC,                                           \
             .flags = PL_BLOB_UNIQUE | PL_BLOB_NOCOPY,                         \
             .name = NAME,                                                     \
             .release = sg_handle_release,                                     \
             .write = sg_handle_write},                                        \
    .free = FREE                                                               \
  }

/* The open handle that t is, in use until sg_handle_done() (null: nothing):
 * type_error(Type, t), existence_error(Type, t). */
int sg_handle_get(term_t t, sg_handle_type *type, sg_handle **out);
void sg_handle_done(sg_handle *handle);
/* The same, in use until the call is closed. */
int sg_handle_hold(sg_call *call, term_t t, sg_handle_type *type,
                   void **object);
/* Unifies t with a handle of the object, and owns it also after a failure. */
int sg_handle_unify(term_t t, sg_handle_type *type, void *object);
int sg_handle_close(term_t t, sg_handle_type *type);

/* ---- simple types ---- */

/* type_error(integer), type_error(not_less_than_one),
 * representation_error(int32). */
int get_id(sg_call *call, term_t t, int32_t *out);
int get_int(sg_call *call, term_t t, int32_t *out);
int get_integer(sg_call *call, term_t t, int64_t *out);
/* type_error(not_less_than_zero). */
int get_count(sg_call *call, term_t t, size_t *out);
/* Never -0.0: type_error(number), domain_error(finite). */
int get_number(sg_call *call, term_t t, double *out);
int get_bool(sg_call *call, term_t t, bool *out);

/* An atom as a symbol of the store (engine/symbol.h), made when there is none:
 * for words of which there are few. */
int get_symbol(sg_call *call, term_t t, int32_t *out);
int put_symbol(term_t t, int32_t symbol);

/* 1, or -1: reversed. */
int get_sense(sg_call *call, term_t t, bool *reversed);

/* A string of codes 0 to 255; good as long as the term is. */
int get_bytes(sg_call *call, term_t t, sg_bytes *out);

/* The text of an atom or a string; of another term, what writeq/1 writes. It is
 * put as an atom. Zero-terminated UTF-8. */
int get_name(sg_call *call, term_t t, const char **out);
#define put_name(t, x) PL_put_chars(t, PL_ATOM | REP_UTF8, (size_t)-1, x)

/* Streams; a text is a string, or what the file of a stream has from its
 * beginning, wherever that is. What is written to a text output is UTF-8, and
 * the stream encodes it. Whether it is one is seen when it is used. */
int get_input(sg_call *call, term_t t, sg_input *out);
int get_output(sg_call *call, term_t t, sg_output *out);
int get_text_output(sg_call *call, term_t t, sg_output *out);
int get_text(sg_call *call, term_t t, sg_input *out);

/* A number of any sort, exactly. */
int get_exact(sg_call *call, term_t t, sg_exact *out);

int get_set_id(sg_call *call, term_t t, sg_int_list *out);

#define put_id(t, x)      PL_put_int64(t, (int64_t)(x))
#define put_int(t, x)     PL_put_int64(t, (int64_t)(x))
#define put_count(t, x)   PL_put_int64(t, (int64_t)(x))
#define put_integer(t, x) PL_put_int64(t, x)
#define put_number(t, x)  PL_put_float(t, (x) + 0.0)
#define put_bool(t, x)    PL_put_bool(t, (x))
#define put_sense(t, x)   PL_put_integer(t, (x) ? -1 : 1)
#define put_term(t, x)    sg_put_term(t, x)

int put_bytes(term_t t, const sg_bytes *x);

/* ---- words, terms, lists ---- */

/* Which of n words t is, -1: an exception. */
int sg_door_word(term_t t, const atom_t *word, int n, const char *type);
/* The length of a proper list: instantiation_error, type_error(list). */
int sg_door_list_length(term_t list, size_t *n);
/* t is such a term: instantiation_error, type_error(type, t). */
int sg_door_functor(term_t t, functor_t functor, const char *type);
/* Among many steps: false if Prolog wants to stop. */
static inline int
sg_door_goes_on(size_t i)
{
  return i % 4096 != 4095 || PL_handle_signals() >= 0;
}

/* get_list_TYPE() and put_list_TYPE(): GET(call, t, &x), PUT(t, x). */
#define SG_DOOR_GET_LIST(TYPE, LIST, GET)                                      \
  static int get_list_##TYPE(sg_call *call, term_t t, LIST *out)               \
  {                                                                            \
    term_t tail = PL_copy_term_ref(t), head = PL_new_term_ref();               \
    term_t rest = PL_new_term_ref();                                           \
    size_t n;                                                                  \
                                                                               \
    *out = (LIST){0};                                                          \
    if (!sg_door_list_length(t, &n) ||                                         \
        (n > 0 && !(out->at = sg_call_alloc(call, n * sizeof *out->at)))) {    \
      return FALSE;                                                            \
    }                                                                          \
    for (out->room = n; out->n < n; out->n++) {                                \
      if (!sg_door_goes_on(out->n) || !PL_get_list(tail, head, tail) ||        \
          !GET(call, head, &out->at[out->n])) {                                \
        return FALSE;                                                          \
      }                                                                        \
      PL_reset_term_refs(rest);                                                \
      rest = PL_new_term_ref();                                                \
    }                                                                          \
    return TRUE;                                                               \
  }

#define SG_DOOR_PUT_LIST(TYPE, LIST, PUT)                                      \
  static int put_list_##TYPE(term_t t, const LIST *x)                          \
  {                                                                            \
    term_t head = PL_new_term_ref(), rest;                                     \
                                                                               \
    PL_put_nil(t);                                                             \
    for (size_t i = x->n; i > 0; i--) {                                        \
      rest = PL_new_term_ref();                                                \
      if (!sg_door_goes_on(i) || !PUT(head, x->at[i - 1]) ||                   \
          !PL_cons_list(t, head, t)) {                                         \
        return FALSE;                                                          \
      }                                                                        \
      PL_reset_term_refs(rest);                                                \
    }                                                                          \
    return TRUE;                                                               \
  }

/* put_list_TYPE() of objects; owns all of them, also after a failure. */
#define SG_DOOR_PUT_HANDLES(TYPE, LIST)                                        \
  static int put_list_##TYPE(term_t t, const LIST *x)                          \
  {                                                                            \
    term_t head = PL_new_term_ref(), rest;                                     \
    int good = TRUE;                                                           \
                                                                               \
    PL_put_nil(t);                                                             \
    for (size_t i = x->n; i > 0; i--) {                                        \
      rest = PL_new_term_ref();                                                \
      if (!(good = good && sg_door_goes_on(i))) {                              \
        sg_handle_type_##TYPE.free(x->at[i - 1]);                              \
      } else {                                                                 \
        PL_put_variable(head);                                                 \
        good = sg_handle_unify(head, &sg_handle_type_##TYPE, x->at[i - 1]) &&  \
               PL_cons_list(t, head, t);                                       \
      }                                                                        \
      PL_reset_term_refs(rest);                                                \
    }                                                                          \
    return good;                                                               \
  }

#endif
