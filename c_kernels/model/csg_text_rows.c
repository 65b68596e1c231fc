/* csg_text_rows.c -- .csg files as terms. See rules/model/openscad_text.pl for
 * these.
 *
 * Layer: rows.
 */
#include "doors/file.h"
#include "model/csg_text.h"
#include "number/number.h"

#include "engine/term.h"

#include <stdlib.h>
#include <string.h>

/* What is written often. */
typedef enum often { NODE, LOCATION, STRING, OFTEN } often;

typedef struct reader {
  sg_csg_text text;
  int32_t symbol[OFTEN];
  sg_term_builder out;
  const sg_cancel *cancel;
  const char *file;
  const char *wanted; /* what should stand where a fault is */
  size_t words;
} reader;

static bool nodes(reader *r);
static bool value(reader *r);

static bool
next(reader *r)
{
  sg_csg_next(&r->text);
  return !sg_cancel_every(r->cancel, ++r->words) && !r->out.no_memory;
}

static bool
refused(reader *r, const char *wanted)
{
  r->wanted = wanted;
  return false;
}

static bool
is_sign(const sg_csg_text *t, const char *among)
{
  return t->word == SG_CSG_SIGN && strchr(among, *t->begin);
}

static bool
is_name(const sg_csg_text *t, const char *name)
{
  return t->word == SG_CSG_NAME && t->n == strlen(name) &&
         memcmp(t->begin, name, t->n) == 0;
}

/* The sign, and the word behind it. */
static bool
wanted(reader *r, const char *sign)
{
  return is_sign(&r->text, sign) ? next(r) : refused(r, sign);
}

/* Words as terms --------------------------------------------------------- */

static void
put_atom(reader *r, const char *name)
{
  sg_term_atom(&r->out, name, strlen(name));
}

static int32_t
symbol_of(const char *name)
{
  return sg_symbol_intern(name, strlen(name));
}

static void
put_functor(reader *r, const char *name, size_t arity)
{
  sg_term_compound(&r->out, symbol_of(name), arity);
}

static void
put_number(reader *r, const sg_csg_text *t)
{
  bool whole = t->n < 18 && strspn(t->begin, "-0123456789") >= t->n;
  double x;

  if (sg_number_read(t->begin, t->n, &x, NULL) != SG_NUMBER_OK) {
    put_atom(r, "inf"); /* too large */
  } else if (whole || x == 0) {
    sg_term_int(&r->out, (int64_t)x);
  } else {
    sg_term_float(&r->out, x);
  }
}

static bool
put_string(reader *r, const sg_csg_text *t)
{
  char *plain = malloc(t->n + 1);
  size_t n = 0;

  if (!plain) {
    r->out.no_memory = true;
    return false;
  }
  for (size_t i = 0; i < t->n; i++) {
    i += t->begin[i] == '\\';
    plain[n++] = t->begin[i];
  }
  sg_term_string(&r->out, plain, n);
  free(plain);
  return true;
}

static bool
put_word(reader *r, const sg_csg_text *t)
{
  if (t->word == SG_CSG_NUMBER) {
    put_number(r, t);
  } else if (t->word == SG_CSG_STRING) {
    return put_string(r, t);
  } else if (t->word == SG_CSG_END) {
    put_atom(r, "end");
  } else {
    sg_term_atom(&r->out, t->begin, t->n);
  }
  return true;
}

/* Another element of a list comes. */
static void
put_more(reader *r)
{
  sg_term_compound(&r->out, SG_SYMBOL_CONS, 2);
}

static bool
put_end(reader *r)
{
  sg_term_nil(&r->out);
  return true;
}

/* Grammar: each reads what begins at the last word, and the word behind it - */

/* Items, maybe none, with commas between them and maybe behind them. */
static bool
items(reader *r, const char *close, bool (*item)(reader *r, int64_t number))
{
  for (int64_t i = 1; !is_sign(&r->text, close); i++) {
    put_more(r);
    if (!item(r, i) || (is_sign(&r->text, ",")     ? !next(r)
                        : is_sign(&r->text, close) ? false
                                                   : !refused(r, close))) {
      return false;
    }
  }
  return next(r) && put_end(r);
}

static bool
element(reader *r, int64_t number)
{
  (void)number;
  return value(r);
}

static bool
value(reader *r)
{
  static const char *const known[] = {"inf", "nan", "true", "false", "undef"};
  sg_csg_text *t = &r->text;
  int names = 5;

  if (t->word == SG_CSG_NUMBER) {
    put_number(r, t);
    return next(r);
  }
  if (t->word == SG_CSG_STRING) {
    sg_term_compound(&r->out, r->symbol[STRING], 1);
    return put_string(r, t) && next(r);
  }
  if (is_sign(t, "[")) {
    return next(r) && items(r, "]", element);
  }
  sg_csg_text word = *t;
  if (is_sign(t, "-")) {
    sg_csg_next(&word);
    names = 2;
  }
  for (int k = 0; k < names; k++) {
    if (is_name(&word, known[k])) {
      *t = word;
      put_atom(r, known[k]);
      return next(r);
    }
  }
  return refused(r, "value");
}

static bool
argument(reader *r, int64_t number)
{
  sg_csg_text behind = r->text;
  bool named = behind.word == SG_CSG_NAME &&
               sg_csg_next(&behind) == SG_CSG_SIGN && *behind.begin == '=';

  sg_term_compound(&r->out, SG_SYMBOL_MINUS, 2);
  if (!named) {
    sg_term_int(&r->out, number);
    return value(r);
  }
  return put_word(r, &r->text) && next(r) && next(r) && value(r);
}

static bool
modifiers(reader *r)
{
  while (is_sign(&r->text, "*%#!")) {
    put_more(r);
    if (!put_word(r, &r->text) || !next(r)) {
      return false;
    }
  }
  return put_end(r);
}

static bool
body(reader *r)
{
  if (is_sign(&r->text, ";")) {
    return next(r) && put_end(r);
  }
  return is_sign(&r->text, "{") ? next(r) && nodes(r) && wanted(r, "}")
                                : refused(r, "body");
}

static bool
node(reader *r)
{
  sg_term_compound(&r->out, r->symbol[NODE], 5);
  if (!modifiers(r)) {
    return false;
  }
  if (r->text.word != SG_CSG_NAME) {
    return refused(r, "name");
  }
  uint64_t line = r->text.line, column = r->text.column;

  if (!put_word(r, &r->text) || !next(r) || !wanted(r, "(") ||
      !items(r, ")", argument) || !body(r)) {
    return false;
  }
  sg_term_compound(&r->out, r->symbol[LOCATION], 3);
  put_atom(r, r->file);
  sg_term_int(&r->out, (int64_t)line);
  sg_term_int(&r->out, (int64_t)column);
  return true;
}

static bool
nodes(reader *r)
{
  bool good = true;

  while (good && (r->text.word == SG_CSG_NAME || is_sign(&r->text, ";*%#!"))) {
    if (is_sign(&r->text, ";")) {
      good = next(r);
    } else {
      put_more(r);
      good = node(r);
    }
  }
  return good && put_end(r);
}

/* Files ------------------------------------------------------------------ */

/* The first pass. */
static bool
is_readable(reader *r)
{
  bool good = next(r);

  while (good && r->text.word != SG_CSG_END &&
         r->text.word < SG_CSG_OPEN_STRING) {
    good = next(r);
  }
  return good && r->text.word == SG_CSG_END;
}

/* What is wrong with the last word. */
static void
put_what(reader *r)
{
  const sg_csg_text *t = &r->text;

  if (r->wanted) {
    put_functor(r, "expected", 2);
    put_atom(r, r->wanted);
    put_word(r, t);
  } else if (t->word == SG_CSG_STRANGE) {
    size_t n = 1;
    while (t->begin + n < t->end &&
           ((unsigned char)t->begin[n] & 0xc0) == 0x80) {
      n++;
    }
    put_functor(r, "strange", 1);
    sg_term_atom(&r->out, t->begin, n);
  } else {
    put_atom(r, t->word == SG_CSG_OPEN_STRING ? "open_string"
                : t->word == SG_CSG_OPEN_COMMENT
                    ? "open_comment"
                    : sg_text_fault_name(t->fault));
  }
}

static void
put_fault(reader *r)
{
  sg_term_close(&r->out);
  sg_term_open(&r->out);
  put_functor(r, "fault", 3);
  put_what(r);
  sg_term_int(&r->out, (int64_t)r->text.line);
  sg_term_int(&r->out, (int64_t)r->text.column);
}

/* The whole text, with a first pass for its faults. */
static bool
read_text(reader *r, const char *text, size_t n, const sg_text_limits *most)
{
  sg_csg_open(&r->text, text, n, most);
  if (n > most->file) {
    r->text.word = SG_CSG_BEYOND;
    r->text.fault = SG_TEXT_FILE;
    r->text.line = r->text.column = 1;
    return false;
  }
  if (!is_readable(r)) {
    return false;
  }
  sg_csg_open(&r->text, text, n, most);
  put_functor(r, "nodes", 1);
  return next(r) && nodes(r) &&
         (r->text.word == SG_CSG_END || refused(r, "name"));
}

bool
sg_door_csg_nodes(sg_call *call, const sg_input *stream, const char *file,
                  const sg_text_limits *limits, const uint32_t **result)
{
  reader r = {
      .symbol = {symbol_of("node"), symbol_of("location"), symbol_of("string")},
      .cancel = &call->cancel,
      .file = file};
  char *text = NULL;
  size_t n = 0;

  if (!sg_call_read_all(call, stream, limits->file, &text, &n)) {
    return false;
  }
  sg_term_open(&r.out);
  bool good = read_text(&r, text, n, limits);

  if (!good && !call->stopped && !r.out.no_memory) {
    put_fault(&r);
    good = true;
  }
  free(text);
  *result = sg_call_term(call, &r.out);
  return good && *result;
}
