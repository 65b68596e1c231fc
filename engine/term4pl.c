/* term4pl.c -- ground Prolog terms to words (term.h) and back. */
#include "list.h"
#include "world4pl.h"

#include <pthread.h>
#include <stdlib.h>
#include <string.h>

enum { DEEPEST = 1200 }; /* nested first arguments: 240 kB of the C stack */

/* A term under way. */
typedef struct encoding {
  sg_term_builder *out;
  bool deep; /* it is nested deeper than that */
  /* The last name of a compound, 0: none. A list has one again and again. */
  atom_t name;
  int32_t symbol;
} encoding;

/* ---- symbols and atoms ------------------------------------------------- */

static struct {
  pthread_mutex_t lock;
  atom_t *atom; /* [room], 0: not asked for yet */
  size_t room;
} symbols = {.lock = PTHREAD_MUTEX_INITIALIZER};

static atom_t
new_symbol_atom(int32_t symbol)
{
  size_t length;
  const char *text = sg_symbol_text(symbol, &length);
  term_t t = PL_new_term_ref();
  atom_t atom = 0;

  if (t && PL_put_chars(t, PL_ATOM | REP_UTF8, length, text) &&
      PL_get_atom(t, &atom)) {
    PL_register_atom(atom);
  }
  PL_reset_term_refs(t);
  return atom;
}

atom_t
sg_symbol_atom(int32_t symbol)
{
  atom_t atom = 0;
  size_t place = (size_t)symbol;

  pthread_mutex_lock(&symbols.lock);
  bool kept = sg_list_need_zeroed(&symbols.atom, place + 1, &symbols.room,
                                  sizeof(*symbols.atom));

  atom = kept ? symbols.atom[place] : 0;
  if (!atom) {
    atom = new_symbol_atom(symbol);
    if (kept) { /* else no memory: made again next time */
      symbols.atom[place] = atom;
    }
  }
  pthread_mutex_unlock(&symbols.lock);
  return atom;
}

static int32_t
symbol_of(atom_t atom, int32_t (*find)(const char *text, size_t length))
{
  term_t t = PL_new_term_ref();
  char *text;
  size_t length;
  int32_t symbol = -1;

  PL_STRINGS_MARK();
  if (t && PL_put_atom(t, atom) &&
      PL_get_nchars(t, &length, &text, CVT_ATOM | REP_UTF8)) {
    symbol = find(text, length);
  }
  PL_STRINGS_RELEASE();
  PL_reset_term_refs(t);
  return symbol;
}

int32_t
sg_atom_symbol(atom_t atom)
{
  return symbol_of(atom, sg_symbol_find);
}

int32_t
sg_intern_atom(atom_t atom)
{
  return symbol_of(atom, sg_symbol_intern);
}

/* ---- encoding ---------------------------------------------------------- */

static void
encode_mpz(mpz_srcptr z, sg_term_builder *out)
{
  uint32_t few[64];
  size_t words = (mpz_sizeinbase(z, 2) + 31) / 32;
  uint32_t *magnitude = few;

  if (mpz_fits_slong_p(z)) {
    sg_term_int(out, mpz_get_si(z));
    return;
  }
  if (words > 64 && !(magnitude = malloc(words * sizeof(*magnitude)))) {
    out->failed = out->no_memory = true;
    return;
  }
  mpz_export(magnitude, &words, -1, sizeof(*magnitude), 0, 0, z);
  sg_term_big(out, mpz_sgn(z) < 0, magnitude, words);
  if (magnitude != few) {
    free(magnitude);
  }
}

/* Big integers and rationals come as text: PL_get_mpq() of SWI-Prolog 9.0.4
 * crashes on big integers. */
static bool
encode_big(char *text, sg_term_builder *out)
{
  size_t digits = strspn(text, "-0123456789");
  mpq_t q;
  bool done;

  if (text[digits] == 'r' || text[digits] == '/') {
    text[digits] = '/';
  }
  mpq_init(q);
  done = mpq_set_str(q, text, 10) == 0;
  if (done && mpz_cmp_ui(mpq_denref(q), 1) == 0) {
    encode_mpz(mpq_numref(q), out);
  } else if (done) {
    sg_term_rational(out);
    encode_mpz(mpq_numref(q), out);
    encode_mpz(mpq_denref(q), out);
  }
  mpq_clear(q);
  return done;
}

static bool
encode_number(term_t t, sg_term_builder *out)
{
  int64_t i;
  char *text;
  bool done;

  if (PL_get_int64(t, &i)) {
    sg_term_int(out, i);
    return true;
  }
  if (!PL_get_chars(t, &text, CVT_RATIONAL | BUF_MALLOC)) {
    return false;
  }
  done = encode_big(text, out);
  PL_free(text);
  return done;
}

static bool
encode_text(term_t t, bool atom, sg_term_builder *out)
{
  char *text;
  size_t length;
  int is_text; /* no blob */

  PL_STRINGS_MARK();
  is_text = PL_get_nchars(t, &length, &text,
                          (atom ? CVT_ATOM : CVT_STRING) | REP_UTF8);
  if (is_text && atom) {
    sg_term_atom(out, text, length);
  } else if (is_text) {
    sg_term_string(out, text, length);
  }
  PL_STRINGS_RELEASE();
  if (!is_text) {
    return false;
  }
  return true;
}

static int32_t
symbol_of_name(atom_t name, encoding *to)
{
  if (name != to->name) {
    to->name = name;
    to->symbol = sg_intern_atom(name);
  }
  return to->symbol;
}

static bool encode(term_t t, encoding *to, int depth);

/* Most arguments are small integers. */
static bool
encode_argument(term_t t, encoding *to, int depth)
{
  int64_t i;

  if (PL_is_integer(t) && PL_get_int64(t, &i)) {
    sg_term_int(to->out, i);
    return true;
  }
  return encode(t, to, depth);
}

/* A compound: its arguments but the last here, the last by the caller, so
 * that a list needs no deep stack. */
static bool
encode_head(term_t t, size_t *arity, encoding *to, int depth)
{
  term_t arg = PL_new_term_ref();
  atom_t name;
  int32_t symbol;

  if (!PL_get_compound_name_arity(t, &name, arity)) {
    return false;
  }
  if ((symbol = symbol_of_name(name, to)) < 0) {
    to->out->no_memory = true;
    return false;
  }
  sg_term_compound(to->out, symbol, *arity);
  for (size_t i = 1; i < *arity; i++) {
    _PL_get_arg(i, t, arg);
    if (!encode_argument(arg, to, depth + 1)) {
      return false;
    }
  }
  PL_reset_term_refs(arg);
  return true;
}

static bool
encode_atomic(term_t t, sg_term_builder *out)
{
  double f;

  if (PL_get_nil(t)) {
    sg_term_nil(out);
  } else if (PL_is_float(t) && PL_get_float(t, &f)) {
    sg_term_float(out, f);
  } else if (PL_is_rational(t)) {
    return encode_number(t, out);
  } else if (PL_is_atom(t) || PL_is_string(t)) {
    return encode_text(t, PL_is_atom(t), out);
  } else {
    return false; /* a variable or a blob */
  }
  return true;
}

static bool
encode(term_t t0, encoding *to, int depth)
{
  term_t t = PL_copy_term_ref(t0);
  size_t arity = 1;
  bool done = depth < DEEPEST;

  to->deep = to->deep || !done;

  while (done && PL_is_compound(t) && !PL_is_dict(t)) {
    done = encode_head(t, &arity, to, depth);
    if (!done || arity == 0) {
      break;
    }
    _PL_get_arg(arity, t, t);
  }
  done = done && (arity == 0 || encode_atomic(t, to->out)) && !to->out->failed;
  PL_reset_term_refs(t);
  return done;
}

bool
sg_encode_term(term_t t, sg_term_builder *out)
{
  return PL_is_acyclic(t) && encode(t, &(encoding){.out = out}, 0);
}

int
sg_get_term_ex(term_t t, uint32_t **out)
{
  sg_term_builder builder;
  const uint32_t *words = NULL;
  size_t bytes;

  *out = NULL;
  if (!PL_is_ground(t)) {
    return PL_instantiation_error(t);
  }
  sg_term_open(&builder);
  encoding to = {.out = &builder};

  if (!PL_is_acyclic(t) || !encode(t, &to, 0)) {
    sg_term_close(&builder);
    return builder.no_memory ? PL_resource_error("memory")
           : to.deep
               ? PL_resource_error("nesting_of_terms") /* not to be shown */
               : PL_type_error("storable_term", t);
  }
  words = sg_term_words(&builder);
  bytes = sg_term_length(words) * sizeof(*words);
  if ((*out = malloc(bytes))) {
    memcpy(*out, words, bytes);
  }
  sg_term_close(&builder);
  return *out || PL_resource_error("memory");
}

/* ---- decoding ---------------------------------------------------------- */

static uint64_t
get_bits(const uint32_t word[2])
{
  return word[0] | (uint64_t)word[1] << 32;
}

/* The integer node at *at, which moves past it. */
static void
decode_mpz(const uint32_t **at, mpz_ptr z)
{
  uint32_t head = *(*at)++;
  uint32_t payload = head >> 4;

  switch ((sg_term_tag)(head & 15)) {
  case SG_TERM_BIG:
    mpz_import(z, payload / 2, -1, sizeof(uint32_t), 0, 0, *at);
    *at += payload / 2;
    if (payload & 1) {
      mpz_neg(z, z);
    }
    break;
  case SG_TERM_INT64:
    mpz_set_si(z, (long)get_bits(*at));
    *at += 2;
    break;
  case SG_TERM_INT:
    mpz_set_si(z, (int32_t)head >> 4);
    break;
  case SG_TERM_RATIONAL:
  case SG_TERM_FLOAT:
  case SG_TERM_ATOM:
  case SG_TERM_STRING:
  case SG_TERM_NIL:
  case SG_TERM_COMPOUND:
    break; /* never inside a number */
  }
}

static int
unify_mpq_words(term_t t, const uint32_t **at)
{
  mpq_t q;
  int done;

  mpq_init(q);
  (*at)++;
  decode_mpz(at, mpq_numref(q));
  decode_mpz(at, mpq_denref(q));
  done = PL_unify_mpq(t, q);
  mpq_clear(q);
  return done;
}

static int
unify_mpz_words(term_t t, const uint32_t **at)
{
  mpz_t z;
  int done;

  mpz_init(z);
  decode_mpz(at, z);
  done = PL_unify_mpz(t, z);
  mpz_clear(z);
  return done;
}

static int
unify_text(term_t t, int type, uint32_t bytes, const uint32_t **at)
{
  const char *text = (const char *)*at;

  *at += (bytes + 3) / 4;
  return PL_unify_chars(t, type | REP_UTF8, bytes, text);
}

/* A node that is no compound; *at moves past it. */
static int
unify_atomic(term_t t, const uint32_t **at)
{
  uint32_t head = **at;
  uint64_t bits;
  double f;

  switch ((sg_term_tag)(head & 15)) {
  case SG_TERM_INT:
    (*at)++;
    return PL_unify_int64(t, (int32_t)head >> 4);
  case SG_TERM_INT64:
    *at += 3;
    return PL_unify_int64(t, (int64_t)get_bits(*at - 2));
  case SG_TERM_BIG:
    return unify_mpz_words(t, at);
  case SG_TERM_RATIONAL:
    return unify_mpq_words(t, at);
  case SG_TERM_FLOAT:
    *at += 3;
    bits = get_bits(*at - 2);
    memcpy(&f, &bits, sizeof(f));
    return PL_unify_float(t, f);
  case SG_TERM_ATOM:
    (*at)++;
    return unify_text(t, PL_ATOM, head >> 4, at);
  case SG_TERM_STRING:
    (*at)++;
    return unify_text(t, PL_STRING, head >> 4, at);
  case SG_TERM_NIL:
    (*at)++;
    return PL_unify_nil(t);
  case SG_TERM_COMPOUND:
    break;
  }
  return FALSE;
}

static int unify_node(term_t t0, const uint32_t **at);

static int
unify_argument(term_t t, const uint32_t **at)
{
  return (**at & 15) == SG_TERM_COMPOUND ? unify_node(t, at)
                                         : unify_atomic(t, at);
}

static int
unify_node(term_t t0, const uint32_t **at)
{
  term_t t = PL_copy_term_ref(t0);
  term_t arg = PL_new_term_ref();
  int done = TRUE;

  while (done && (**at & 15) == SG_TERM_COMPOUND) {
    size_t arity = **at >> 4;
    int32_t symbol = (int32_t)(*at)[1];
    *at += 2;
    if (symbol == SG_SYMBOL_CONS && arity == 2) { /* of most there are */
      done = PL_unify_list(t, arg, t) && unify_argument(arg, at);
      continue;
    }
    atom_t name = sg_symbol_atom(symbol);
    done = name && PL_unify_compound(t, PL_new_functor(name, arity));
    for (size_t i = 1; done && i < arity; i++) {
      _PL_get_arg(i, t, arg);
      done = unify_argument(arg, at);
    }
    if (!done || arity == 0) {
      PL_reset_term_refs(t);
      return done;
    }
    _PL_get_arg(arity, t, t);
  }
  done = done && unify_atomic(t, at);
  PL_reset_term_refs(t);
  return done;
}

static int
unify_term(term_t t, const uint32_t *term)
{
  const uint32_t *at = term + 1;

  return unify_node(t, &at);
}

int
sg_put_term(term_t t, const uint32_t *term)
{
  return PL_put_variable(t) && unify_term(t, term);
}

/* ---- values ------------------------------------------------------------ */

static int
unify_list(term_t t, const int32_t *list)
{
  term_t tail = PL_copy_term_ref(t);
  term_t head = PL_new_term_ref();
  int done = TRUE;

  for (int32_t i = 1; done && i <= list[0]; i++) {
    done = PL_unify_list(tail, head, tail) && PL_unify_integer(head, list[i]);
  }
  done = done && PL_unify_nil(tail);
  PL_reset_term_refs(tail);
  return done;
}

int
sg_unify_value(term_t t, sg_type type, sg_value value)
{
  switch (type) {
  case SG_INT:
    return PL_unify_integer(t, value.i);
  case SG_FLOAT:
    return PL_unify_float(t, value.f);
  case SG_LIST:
    return unify_list(t, value.list);
  case SG_ATOM:
    return PL_unify_atom(t, sg_symbol_atom(value.i));
  case SG_TERM:
    return unify_term(t, value.term);
  }
  return FALSE;
}
