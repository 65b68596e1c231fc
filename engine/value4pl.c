/* value4pl.c -- arguments of relations as values of columns. */
#include "value4pl.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* ---- asking ------------------------------------------------------------ */

static sg_bound
bound_list(term_t t, const int32_t **out, void **owned)
{
  term_t tail = PL_copy_term_ref(t);
  term_t head = PL_new_term_ref();
  size_t length;
  int32_t *list;
  sg_bound result = SG_BOUND;

  if (!PL_is_ground(t)) {
    return PL_is_variable(t) ? SG_OPEN : SG_PARTIAL;
  }
  if (PL_skip_list(t, 0, &length) != PL_LIST || length > INT32_MAX) {
    return SG_NOWHERE;
  }
  if (!(list = malloc((length + 1) * sizeof(*list)))) {
    return SG_PARTIAL; /* slower, the same answers */
  }
  list[0] = (int32_t)length;
  for (size_t i = 1; i <= length; i++) {
    int id;
    if (!PL_get_list(tail, head, tail) || !PL_is_integer(head) ||
        !PL_get_integer(head, &id)) {
      result = SG_NOWHERE;
      break;
    }
    list[i] = id;
  }
  *owned = list;
  *out = list;
  return result;
}

static sg_bound
bound_term(term_t t, const uint32_t **out, void **owned)
{
  sg_term_builder builder;
  sg_bound result = SG_NOWHERE;

  if (!PL_is_ground(t)) {
    return PL_is_variable(t) ? SG_OPEN : SG_PARTIAL;
  }
  sg_term_open(&builder);
  if (sg_encode_term(t, &builder)) {
    const uint32_t *words = sg_term_words(&builder);
    size_t bytes = sg_term_length(words) * sizeof(*words);
    if ((*owned = malloc(bytes))) {
      memcpy(*owned, words, bytes);
      *out = *owned;
      result = SG_BOUND;
    } else {
      result = SG_PARTIAL;
    }
  } else if (builder.no_memory) {
    result = SG_PARTIAL; /* each row is looked at */
  }
  sg_term_close(&builder);
  return result;
}

static sg_bound
bound_float(term_t t, double *out)
{
  int type = PL_term_type(t);

  if (type == PL_VARIABLE) {
    return SG_OPEN;
  }
  if (type != PL_FLOAT || !PL_get_float(t, out) ||
      (*out == 0 && signbit(*out))) {
    return SG_NOWHERE; /* no stored float is -0.0 */
  }
  return SG_BOUND;
}

static sg_bound
bound_int(term_t t, int32_t *out)
{
  int type = PL_term_type(t), i;

  if (type == PL_VARIABLE) {
    return SG_OPEN;
  }
  if (type != PL_INTEGER || !PL_get_integer(t, &i)) {
    return SG_NOWHERE;
  }
  *out = i;
  return SG_BOUND;
}

static sg_bound
bound_atom(term_t t, int32_t *out)
{
  atom_t atom;

  if (PL_is_variable(t)) {
    return SG_OPEN;
  }
  if (!PL_get_atom(t, &atom) || (*out = sg_atom_symbol(atom)) < 0) {
    return SG_NOWHERE;
  }
  return SG_BOUND;
}

sg_bound
sg_bound_value(term_t t, sg_type type, sg_value *out, void **owned)
{
  switch (type) {
  case SG_INT:
    return bound_int(t, &out->i);
  case SG_FLOAT:
    return bound_float(t, &out->f);
  case SG_ATOM:
    return bound_atom(t, &out->i);
  case SG_LIST:
    return bound_list(t, &out->list, owned);
  case SG_TERM:
    return bound_term(t, &out->term, owned);
  }
  return SG_NOWHERE;
}

/* ---- adding ------------------------------------------------------------ */

/* The next word of a domain; false: no more. */
static bool
next_word(const char **words, const char **word, size_t *length)
{
  *word = *words + strspn(*words, " ");
  *length = strcspn(*word, " ");
  *words = *word + *length;
  return *length > 0;
}

/* domain_error(oneof(Words), Culprit) */
static int
raise_domain_words(const char *words, term_t culprit)
{
  term_t list = PL_new_term_ref();
  term_t tail = PL_copy_term_ref(list);
  term_t head = PL_new_term_ref();
  term_t value = PL_new_term_ref();
  term_t ex = PL_new_term_ref();
  const char *word;
  size_t length;

  while (next_word(&words, &word, &length)) {
    char text[32];
    memcpy(text, word, length < 31 ? length : 31);
    text[length < 31 ? length : 31] = '\0';
    if (!PL_chars_to_term(text, value) || !PL_unify_list(tail, head, tail) ||
        !PL_unify(head, value)) {
      return FALSE;
    }
  }
  return PL_unify_nil(tail) &&
         PL_unify_term(ex, PL_FUNCTOR_CHARS, "error", 2, PL_FUNCTOR_CHARS,
                       "domain_error", 2, PL_FUNCTOR_CHARS, "oneof", 1, PL_TERM,
                       list, PL_TERM, culprit, PL_VARIABLE) &&
         PL_raise_exception(ex);
}

static int
check_domain_ex(const char *words, term_t t)
{
  const char *rest = words;
  const char *word;
  char *text;
  size_t length;
  size_t n;

  bool is_text, found = false;

  PL_STRINGS_MARK();
  is_text = PL_get_nchars(t, &n, &text, CVT_ATOM | CVT_INTEGER | REP_UTF8);
  while (is_text && !found && next_word(&rest, &word, &length)) {
    found = length == n && memcmp(word, text, n) == 0;
  }
  PL_STRINGS_RELEASE();
  return found     ? TRUE
         : is_text ? raise_domain_words(words, t)
                   : PL_type_error("atom", t);
}

static int
get_int_ex(term_t t, int32_t *out)
{
  int64_t i;

  if (!PL_is_integer(t)) {
    return PL_is_variable(t) ? PL_instantiation_error(t)
                             : PL_type_error("integer", t);
  }
  if (!PL_get_int64(t, &i) || i > INT32_MAX || i < -INT32_MAX) {
    return PL_representation_error("int32");
  }
  *out = (int32_t)i;
  return TRUE;
}

static int
get_positive_id_ex(term_t t, int32_t *out)
{
  return get_int_ex(t, out) && (*out >= 0 || PL_type_error("nonneg", t)) &&
         (*out > 0 || PL_domain_error("positive_integer", t));
}

/* An id other than 0. */
static int
get_signed_id_ex(term_t t, int32_t *out)
{
  return get_int_ex(t, out) && (*out != 0 || PL_domain_error("not_zero", t));
}

static int
get_finite_ex(term_t t, double *out)
{
  if (PL_is_variable(t)) {
    return PL_instantiation_error(t);
  }
  if (!PL_is_number(t) || !PL_get_float(t, out)) {
    return PL_type_error("float", t);
  }
  *out += 0.0;
  return isfinite(*out) || PL_domain_error("finite_float", t);
}

static int
get_ids_ex(term_t t, const int32_t **out, void **owned)
{
  term_t tail = PL_copy_term_ref(t);
  term_t head = PL_new_term_ref();
  size_t length;
  int32_t *list;
  int kind = PL_skip_list(t, 0, &length);

  if (kind == PL_PARTIAL_LIST) {
    return PL_instantiation_error(t);
  }
  if (kind != PL_LIST || length > INT32_MAX) {
    return PL_type_error("list", t);
  }
  if (!(list = malloc((length + 1) * sizeof(*list)))) {
    return PL_resource_error("memory");
  }
  *owned = list;
  *out = list;
  list[0] = (int32_t)length;
  for (size_t i = 1; i <= length; i++) {
    if (!PL_get_list_ex(tail, head, tail) ||
        !get_positive_id_ex(head, &list[i])) {
      return FALSE;
    }
  }
  return TRUE;
}

static int
get_symbol_ex(term_t t, int32_t *out)
{
  char *text;
  size_t length;

  if (PL_is_variable(t)) {
    return PL_instantiation_error(t);
  }
  int is_text;

  PL_STRINGS_MARK();
  is_text = PL_get_nchars(t, &length, &text, CVT_ATOM | REP_UTF8);
  *out = is_text ? sg_symbol_intern(text, length) : -1;
  PL_STRINGS_RELEASE();
  return !is_text ? PL_type_error("atom", t)
                  : *out >= 0 || PL_resource_error("memory");
}

/* A coordinate may be so far out, and no farther (0: any). */
static int
check_most_ex(double most, sg_value value, term_t t)
{
  return most == 0 || fabs(value.f) <= most || PL_domain_error("coordinate", t);
}

int
sg_get_value_ex(term_t t, const sg_relation_info *info, unsigned c,
                sg_value *out, void **owned)
{
  const char *domain = info->domain[c];

  switch (info->column[c].type) {
  case SG_INT:
    return domain ? get_int_ex(t, &out->i) && check_domain_ex(domain, t)
           : info->with_sign[c] ? get_signed_id_ex(t, &out->i)
                                : get_positive_id_ex(t, &out->i);
  case SG_FLOAT:
    return get_finite_ex(t, &out->f) && check_most_ex(info->most[c], *out, t);
  case SG_LIST:
    return get_ids_ex(t, &out->list, owned);
  case SG_ATOM:
    return (!domain || PL_is_variable(t) || check_domain_ex(domain, t)) &&
           get_symbol_ex(t, &out->i);
  case SG_TERM:
    return sg_get_term_ex(t, (uint32_t **)owned) && (out->term = *owned, TRUE);
  }
  return FALSE;
}

/* ---- facts ------------------------------------------------------------- */

static int
unknown_relation_ex(atom_t name, size_t arity)
{
  term_t t = PL_new_term_ref();

  return t &&
         PL_unify_term(t, PL_FUNCTOR_CHARS, "/", 2, PL_ATOM, name, PL_INT64,
                       (int64_t)arity) &&
         PL_existence_error("relation", t);
}

int
sg_get_fact_ex(term_t t, term_t last, sg_relation *relation, term_t *args)
{
  term_t fact = PL_new_term_ref();
  module_t module = NULL;
  atom_t name;
  size_t arity;

  if (!PL_strip_module(t, &module, fact)) {
    return FALSE;
  }
  if (!PL_get_name_arity(fact, &name, &arity)) {
    return PL_is_variable(fact) ? PL_instantiation_error(fact)
                                : PL_type_error("callable", fact);
  }
  *relation = sg_relation_named(name, arity);
  if (*relation == SG_NONE) {
    return unknown_relation_ex(name, arity);
  }
  *args = PL_new_term_refs((int)arity + 1);
  if (!*args || (last && !PL_put_term(*args + (term_t)arity, last))) {
    return FALSE;
  }
  for (size_t i = 0; i < arity; i++) {
    _PL_get_arg(i + 1, fact, *args + i);
  }
  return TRUE;
}
