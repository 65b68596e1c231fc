/* csg_text4pl.c -- .csg files as terms.
 *
 * Layer: glue. See rules/model/openscad_text.pl for the terms.
 */
#include <SWI-Stream.h>

#include <SWI-Prolog.h>

#include "glue.h"
#include "model/csg_text.h"
#include "model/text_limits4pl.h"
#include "number/number.h"
#include <stdlib.h>
#include <string.h>

void sg_install_csg_text(void);

enum { ASKED = 4096 };

typedef struct reader {
  sg_csg_text text;
  term_t file;
  const char *wanted; /* what should stand where a fault is */
  size_t words;
} reader;

static functor_t FUNCTOR_expected2, FUNCTOR_fault3, FUNCTOR_location3,
    FUNCTOR_minus2, FUNCTOR_node5, FUNCTOR_nodes1, FUNCTOR_strange1,
    FUNCTOR_string1;

static int nodes(reader *r, term_t out);
static int value(reader *r, term_t out);

static int
next(reader *r)
{
  sg_csg_next(&r->text);
  return ++r->words % ASKED != 0 || PL_handle_signals() >= 0;
}

static int
refused(reader *r, const char *wanted)
{
  r->wanted = wanted;
  return FALSE;
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
static int
wanted(reader *r, const char *sign)
{
  return is_sign(&r->text, sign) ? next(r) : refused(r, sign);
}

/* Words as terms --------------------------------------------------------- */

static int
unify_number(term_t out, const sg_csg_text *t)
{
  bool whole = t->n < 18 && strspn(t->begin, "-0123456789") >= t->n;
  double x;

  if (sg_number_read(t->begin, t->n, &x, NULL) != SG_NUMBER_OK) {
    return PL_unify_atom_chars(out, "inf"); /* too large */
  }
  return whole || x == 0 ? PL_unify_int64(out, (int64_t)x)
                         : PL_unify_float(out, x);
}

static int
unify_string(term_t out, const sg_csg_text *t)
{
  char *plain = malloc(t->n + 1);
  size_t n = 0;
  int good;

  if (!plain) {
    return sg_no_memory();
  }
  for (size_t i = 0; i < t->n; i++) {
    i += t->begin[i] == '\\';
    plain[n++] = t->begin[i];
  }
  good = PL_unify_chars(out, PL_STRING | REP_UTF8, n, plain);
  free(plain);
  return good;
}

static int
unify_word(term_t out, const sg_csg_text *t)
{
  return t->word == SG_CSG_NUMBER   ? unify_number(out, t)
         : t->word == SG_CSG_STRING ? unify_string(out, t)
         : t->word == SG_CSG_END    ? PL_unify_atom_chars(out, "end")
                                    : PL_unify_atom_nchars(out, t->n, t->begin);
}

/* Grammar: each reads what begins at the last word, and the word behind it - */

/* Items, maybe none, with commas between them and maybe behind them. */
static int
items(reader *r, const char *close,
      int (*item)(reader *r, int64_t number, term_t out), term_t out)
{
  term_t tail = PL_copy_term_ref(out), head = PL_new_term_ref();

  for (int64_t i = 1; !is_sign(&r->text, close); i++) {
    if (!PL_unify_list(tail, head, tail) || !item(r, i, head) ||
        (is_sign(&r->text, ",")     ? !next(r)
         : is_sign(&r->text, close) ? false
                                    : !refused(r, close))) {
      return FALSE;
    }
  }
  return next(r) && PL_unify_nil(tail);
}

static int
element(reader *r, int64_t number, term_t out)
{
  (void)number;
  return value(r, out);
}

static int
list(reader *r, term_t out)
{
  fid_t frame = PL_open_foreign_frame();
  int good = frame && next(r) && items(r, "]", element, out);

  if (frame) {
    PL_close_foreign_frame(frame);
  }
  return good;
}

static int
value(reader *r, term_t out)
{
  static const char *const known[] = {"inf", "nan", "true", "false", "undef"};
  sg_csg_text *t = &r->text;
  int names = 5;

  if (t->word == SG_CSG_NUMBER) {
    return unify_number(out, t) && next(r);
  }
  if (t->word == SG_CSG_STRING) {
    return PL_unify_functor(out, FUNCTOR_string1) && PL_get_arg(1, out, out) &&
           unify_string(out, t) && next(r);
  }
  if (is_sign(t, "[")) {
    return list(r, out);
  }
  sg_csg_text word = *t;
  if (is_sign(t, "-")) {
    sg_csg_next(&word);
    names = 2;
  }
  for (int k = 0; k < names; k++) {
    if (is_name(&word, known[k])) {
      *t = word;
      return PL_unify_atom_chars(out, known[k]) && next(r);
    }
  }
  return refused(r, "value");
}

static int
argument(reader *r, int64_t number, term_t out)
{
  term_t part = PL_new_term_ref();
  sg_csg_text behind = r->text;
  bool named = behind.word == SG_CSG_NAME &&
               sg_csg_next(&behind) == SG_CSG_SIGN && *behind.begin == '=';

  return PL_unify_functor(out, FUNCTOR_minus2) && PL_get_arg(1, out, part) &&
         (named ? unify_word(part, &r->text) && next(r) && next(r)
                : PL_unify_int64(part, number)) &&
         PL_get_arg(2, out, part) && value(r, part);
}

static int
modifiers(reader *r, term_t out)
{
  term_t tail = PL_copy_term_ref(out), head = PL_new_term_ref();

  while (is_sign(&r->text, "*%#!")) {
    if (!PL_unify_list(tail, head, tail) || !unify_word(head, &r->text) ||
        !next(r)) {
      return FALSE;
    }
  }
  return PL_unify_nil(tail);
}

static int
body(reader *r, term_t out)
{
  if (is_sign(&r->text, ";")) {
    return next(r) && PL_unify_nil(out);
  }
  return is_sign(&r->text, "{") ? next(r) && nodes(r, out) && wanted(r, "}")
                                : refused(r, "body");
}

static int
node(reader *r, term_t out)
{
  term_t part[5];

  if (!PL_unify_functor(out, FUNCTOR_node5)) {
    return FALSE;
  }
  for (int k = 0; k < 5; k++) {
    part[k] = PL_new_term_ref();
    if (!PL_get_arg(k + 1, out, part[k])) {
      return FALSE;
    }
  }
  if (!modifiers(r, part[0])) {
    return FALSE;
  }
  if (r->text.word != SG_CSG_NAME) {
    return refused(r, "name");
  }
  return unify_word(part[1], &r->text) &&
         PL_unify_term(part[4], PL_FUNCTOR, FUNCTOR_location3, PL_TERM, r->file,
                       PL_INT64, (int64_t)r->text.line, PL_INT64,
                       (int64_t)r->text.column) &&
         next(r) && wanted(r, "(") && items(r, ")", argument, part[2]) &&
         body(r, part[3]);
}

static int
nodes(reader *r, term_t out)
{
  term_t tail = PL_copy_term_ref(out), head = PL_new_term_ref();
  int good = TRUE;

  while (good && (r->text.word == SG_CSG_NAME || is_sign(&r->text, ";*%#!"))) {
    if (is_sign(&r->text, ";")) {
      good = next(r);
      continue;
    }
    fid_t frame = PL_open_foreign_frame();
    good = frame && PL_unify_list(tail, head, tail) && node(r, head);
    if (frame) {
      PL_close_foreign_frame(frame);
    }
  }
  return good && PL_unify_nil(tail);
}

/* Files ------------------------------------------------------------------ */

/* The first pass. */
static int
is_readable(reader *r)
{
  int good = next(r);

  while (good && r->text.word != SG_CSG_END &&
         r->text.word < SG_CSG_OPEN_STRING) {
    good = next(r);
  }
  return good && r->text.word == SG_CSG_END;
}

/* What is wrong with the last word. */
static int
unify_what(term_t out, const reader *r)
{
  const sg_csg_text *t = &r->text;
  term_t found = PL_new_term_ref();

  if (r->wanted) {
    return unify_word(found, t) &&
           PL_unify_term(out, PL_FUNCTOR, FUNCTOR_expected2, PL_CHARS,
                         r->wanted, PL_TERM, found);
  }
  if (t->word == SG_CSG_STRANGE) {
    size_t n = 1;
    while (t->begin + n < t->end &&
           ((unsigned char)t->begin[n] & 0xc0) == 0x80) {
      n++;
    }
    return PL_unify_chars(found, PL_ATOM | REP_UTF8, n, t->begin) &&
           PL_unify_term(out, PL_FUNCTOR, FUNCTOR_strange1, PL_TERM, found);
  }
  return PL_unify_atom_chars(out, t->word == SG_CSG_OPEN_STRING ? "open_string"
                                  : t->word == SG_CSG_OPEN_COMMENT
                                      ? "open_comment"
                                      : sg_text_fault_name(t->fault));
}

static int
unify_fault(term_t out, const reader *r)
{
  term_t what = PL_new_term_ref();

  return unify_what(what, r) &&
         PL_unify_term(out, PL_FUNCTOR, FUNCTOR_fault3, PL_TERM, what, PL_INT64,
                       (int64_t)r->text.line, PL_INT64,
                       (int64_t)r->text.column);
}

/* csg_nodes(+Stream, +File, +Limits, -Result) */
static foreign_t
csg_nodes(term_t stream, term_t file, term_t limits, term_t result)
{
  reader r = {.file = file};
  sg_text_limits most;
  char *text = NULL;
  size_t n = 0;
  int good;
  term_t all = PL_new_term_ref();

  if (!sg_get_text_limits_ex(limits, &most) ||
      !sg_get_bytes_ex(stream, most.file, &text, &n)) {
    free(text);
    return FALSE;
  }
  sg_csg_open(&r.text, text, n, &most);
  if (n > most.file) {
    r.text.word = SG_CSG_BEYOND;
    r.text.fault = SG_TEXT_FILE;
    r.text.line = r.text.column = 1;
    good = FALSE;
  } else if ((good = is_readable(&r))) {
    sg_csg_open(&r.text, text, n, &most);
    good = next(&r) && nodes(&r, all) &&
           (r.text.word == SG_CSG_END || refused(&r, "name"));
  }
  good = good ? PL_unify_term(result, PL_FUNCTOR, FUNCTOR_nodes1, PL_TERM, all)
         : PL_exception(0) ? FALSE
                           : unify_fault(result, &r);
  free(text);
  return good;
}

static const PL_extension predicates[] = {
    {"csg_nodes", 4, csg_nodes, 0},
    {NULL, 0, NULL, 0},
};

void
sg_install_csg_text(void)
{
  FUNCTOR_expected2 = PL_new_functor(PL_new_atom("expected"), 2);
  FUNCTOR_fault3 = PL_new_functor(PL_new_atom("fault"), 3);
  FUNCTOR_location3 = PL_new_functor(PL_new_atom("location"), 3);
  FUNCTOR_minus2 = PL_new_functor(PL_new_atom("-"), 2);
  FUNCTOR_node5 = PL_new_functor(PL_new_atom("node"), 5);
  FUNCTOR_nodes1 = PL_new_functor(PL_new_atom("nodes"), 1);
  FUNCTOR_strange1 = PL_new_functor(PL_new_atom("strange"), 1);
  FUNCTOR_string1 = PL_new_functor(PL_new_atom("string"), 1);
  PL_register_extensions_in_module("sg_kernel_file", predicates);
}
