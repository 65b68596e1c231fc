/* mesh_text.c -- words, lines and errors of mesh files (mesh_private.h). */
#include "mesh_private.h"
#include "number/number.h"

#include <math.h>
#include <string.h>
#include <strings.h>

static bool
is_blank(char c)
{
  return c == ' ' || c == '\t' || c == '\v' || c == '\f';
}

static bool
at_newline(const sg_mesh_reader *r)
{
  return *r->at == '\n' || *r->at == '\r';
}

/* The length of the line end at p: CR, LF or CRLF. */
static size_t
newline_length(const char *p, const char *end)
{
  return p[0] == '\r' && p + 1 < end && p[1] == '\n' ? 2 : 1;
}

static void
take_newline(sg_mesh_reader *r)
{
  r->at += newline_length(r->at, r->end);
  r->line++;
  r->line_start = r->at;
}

static void
skip_to_newline(sg_mesh_reader *r)
{
  while (r->at < r->end && !at_newline(r)) {
    r->at++;
  }
}

static bool
take_continuation(sg_mesh_reader *r)
{
  if (r->backslash && *r->at == '\\' && r->at + 1 < r->end &&
      (r->at[1] == '\n' || r->at[1] == '\r')) {
    r->at++;
    take_newline(r);
    return true;
  }
  return false;
}

void
sg_mesh_precision(sg_mesh_reader *r, const char *text, const char *end)
{
  static const char says[] = " precision ";
  size_t n = sizeof says - 1;
  double unit;

  if ((size_t)(end - text) > n && !memcmp(text, says, n) &&
      sg_number_read(text + n, (size_t)(end - text) - n, &unit, NULL) ==
          SG_NUMBER_OK &&
      unit >= 0 && unit <= SG_MESH_FARTHEST) {
    r->stated = fmax(r->stated, unit);
  }
}

/* To the next word of this line, or to its end. */
static void
skip_blanks(sg_mesh_reader *r)
{
  while (r->at < r->end) {
    if (is_blank(*r->at)) {
      r->at++;
    } else if (r->hash && *r->at == '#') {
      const char *comment = r->at + 1;
      skip_to_newline(r);
      sg_mesh_precision(r, comment, r->at);
    } else if (!take_continuation(r)) {
      return;
    }
  }
}

bool
sg_word_here(sg_mesh_reader *r, sg_word *out)
{
  skip_blanks(r);
  *out = (sg_word){r->at, 0, r->line};
  while (r->at < r->end && !is_blank(*r->at) && !at_newline(r) &&
         !(r->hash && *r->at == '#')) {
    if (r->backslash && *r->at == '\\' && r->at > out->text &&
        r->at + 1 < r->end && (r->at[1] == '\n' || r->at[1] == '\r')) {
      break;
    }
    r->at++;
  }
  out->n = (size_t)(r->at - out->text);
  return out->n > 0;
}

bool
sg_word_next(sg_mesh_reader *r, sg_word *out)
{
  while (!sg_word_here(r, out)) {
    if (r->at == r->end) {
      return false;
    }
    take_newline(r);
  }
  return true;
}

void
sg_word_skip_line(sg_mesh_reader *r)
{
  sg_word w;

  if (!r->backslash) {
    skip_to_newline(r);
  }
  while (sg_word_here(r, &w)) {
  }
  if (r->at < r->end) {
    take_newline(r);
  }
}

sg_word
sg_word_rest(sg_mesh_reader *r)
{
  while (r->at < r->end && is_blank(*r->at)) {
    r->at++;
  }
  sg_word w = {r->at, 0, r->line};
  skip_to_newline(r);
  w.n = (size_t)(r->at - w.text);
  while (w.n && is_blank(w.text[w.n - 1])) {
    w.n--;
  }
  return w;
}

bool
sg_word_is(const sg_word *w, const char *text)
{
  return strlen(text) == w->n && !strncasecmp(w->text, text, w->n);
}

bool
sg_word_integer(const sg_word *w, int64_t *out)
{
  size_t i = w->n && (w->text[0] == '-' || w->text[0] == '+');
  int64_t value = 0;

  if (i == w->n || w->n - i > 18) {
    return false;
  }
  for (; i < w->n; i++) {
    if (w->text[i] < '0' || w->text[i] > '9') {
      return false;
    }
    value = 10 * value + (w->text[i] - '0');
  }
  *out = w->text[0] == '-' ? -value : value;
  return true;
}

/* Errors ----------------------------------------------------------------- */

/* Printable ASCII only, so that the message never harms a terminal. */
static void
put_text(const sg_word *w, char out[SG_MESH_TEXT])
{
  size_t n = 0;

  for (; n < w->n && n < SG_MESH_TEXT - 4; n++) {
    char c = w->text[n];
    out[n] = c < ' ' || c > '~' ? '?' : c;
  }
  if (n < w->n) {
    memcpy(out + n, "...", 3);
    n += 3;
  }
  out[n] = '\0';
}

/* The column of `p`, which stands in this line or in one that a backslash
 * joined to it. */
static size_t
column_of(const sg_mesh_reader *r, const char *p)
{
  const char *q = p;

  while (q > r->start && q[-1] != '\n' && q[-1] != '\r') {
    q--;
  }
  return (size_t)(p - q) + 1;
}

bool
sg_mesh_fail_numbers(sg_mesh_reader *r, sg_mesh_code code, const sg_word *at,
                     const char *wanted, int64_t got, int64_t limit)
{
  sg_word here = {r->at, 0, r->line};
  const sg_word *w = at ? at : &here;

  *r->error = (sg_mesh_error){.code = code,
                              .line = w->line,
                              .column = column_of(r, w->text),
                              .byte = (size_t)(w->text - r->start),
                              .got = got,
                              .limit = limit,
                              .wanted = wanted ? wanted : ""};
  put_text(w, r->error->text);
  return false;
}

bool
sg_mesh_fail(sg_mesh_reader *r, sg_mesh_code code, const sg_word *at,
             const char *wanted)
{
  return sg_mesh_fail_numbers(r, code, at, wanted, 0, 0);
}

bool
sg_mesh_fail_byte(sg_mesh_reader *r, sg_mesh_code code, size_t byte,
                  const char *wanted, int64_t got, int64_t limit)
{
  *r->error = (sg_mesh_error){.code = code,
                              .byte = byte,
                              .got = got,
                              .limit = limit,
                              .wanted = wanted ? wanted : ""};
  return false;
}

bool
sg_mesh_tick(sg_mesh_reader *r)
{
  if (++r->ticks % 4096 == 0 && sg_cancelled(r->cancel)) {
    return sg_mesh_fail_byte(r, SG_MESH_STOPPED, 0, NULL, 0, 0);
  }
  return true;
}

/* Items ------------------------------------------------------------------ */

bool
sg_mesh_coordinate(sg_mesh_reader *r, const sg_word *w, double *out)
{
  int digits = 0;

  switch (sg_number_read(w->text, w->n, out, &digits)) {
  case SG_NUMBER_OK:
    break;
  case SG_NUMBER_BAD:
    return sg_mesh_fail(r, SG_MESH_BAD_NUMBER, w, NULL);
  case SG_NUMBER_NOT_FINITE:
    return sg_mesh_fail(r, SG_MESH_NOT_FINITE, w, NULL);
  }
  if (fabs(*out) > SG_MESH_FARTHEST) {
    return sg_mesh_fail(r, SG_MESH_TOO_FAR, w, NULL);
  }
  if (digits > r->digits) {
    r->digits = digits;
    r->widest = 0;
  }
  if (digits == r->digits) {
    r->widest = fmax(r->widest, fabs(*out));
  }
  return true;
}

bool
sg_mesh_index(sg_mesh_reader *r, const sg_word *w, size_t limit, int32_t *out)
{
  int64_t i;

  if (!sg_word_integer(w, &i)) {
    return sg_mesh_fail(r, SG_MESH_EXPECTED, w, "a vertex number");
  }
  if (i < 0 || (uint64_t)i >= limit) {
    return sg_mesh_fail_numbers(r, SG_MESH_BAD_INDEX, w, "0", i,
                                (int64_t)limit - 1);
  }
  *out = (int32_t)i;
  return true;
}

/* The builders say only "no": memory or size. */
static bool
built(sg_mesh_reader *r, bool done, size_t count)
{
  return done || sg_mesh_fail(r,
                              count >= INT32_MAX ? SG_MESH_TOO_LARGE
                                                 : SG_MESH_NO_MEMORY,
                              NULL, NULL);
}

bool
sg_mesh_vertex(sg_mesh_reader *r, const double xyz[3])
{
  return sg_mesh_tick(r) &&
         built(r, sg_mesh_add_vertex(r->mesh, xyz), r->mesh->vertices);
}

bool
sg_mesh_corner(sg_mesh_reader *r, sg_mesh_lists *lists, int32_t vertex)
{
  return built(r, sg_mesh_add_corner(lists, vertex), lists->corners);
}

bool
sg_mesh_end(sg_mesh_reader *r, sg_mesh_lists *lists, int32_t segment)
{
  return sg_mesh_tick(r) &&
         built(r, sg_mesh_end_list(lists, r->one_segment ? 0 : segment),
               lists->count);
}

int32_t
sg_mesh_segment(sg_mesh_reader *r, const sg_word *name)
{
  if (r->one_segment && r->mesh->segments) {
    return 0;
  }
  int32_t s = sg_mesh_add_segment(r->mesh, name ? name->text : NULL,
                                  name ? name->n : 0);
  if (s < 0) {
    sg_mesh_fail(r, SG_MESH_NO_MEMORY, NULL, NULL);
  }
  return s;
}

void
sg_mesh_ignore(sg_mesh_reader *r, size_t line)
{
  if (!r->mesh->ignored++) {
    r->mesh->ignored_line = line;
  }
}
