/* csg_text.c -- the words of a .csg file (csg_text.h). */
#include "csg_text.h"

#include <string.h>

void
sg_csg_open(sg_csg_text *t, const char *text, size_t n,
            const sg_text_limits *most)
{
  *t = (sg_csg_text){.at = text,
                     .end = text + n,
                     .line_now = 1,
                     .column_now = 1,
                     .most = most};
  if (n >= 3 && memcmp(text, "\xef\xbb\xbf", 3) == 0) {
    t->at += 3; /* the mark of UTF-8 */
  }
}

static bool
is_digit(char c)
{
  return c >= '0' && c <= '9';
}

static bool
is_letter(char c)
{
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_' ||
         c == '$';
}

static bool
here(const sg_csg_text *t, const char *what)
{
  size_t n = strlen(what);

  return (size_t)(t->end - t->at) >= n && memcmp(t->at, what, n) == 0;
}

/* Behind one octet. */
static void
pass(sg_csg_text *t)
{
  if (*t->at == '\n') {
    t->line_now++;
    t->column_now = 1;
  } else if (((unsigned char)*t->at & 0xc0) != 0x80) {
    t->column_now++;
  }
  t->at++;
}

/* Behind the next `last`; false if there is none. */
static bool
pass_to(sg_csg_text *t, const char *last)
{
  while (t->at < t->end && !here(t, last)) {
    pass(t);
  }
  if (t->at == t->end) {
    return false;
  }
  for (size_t n = strlen(last); n > 0; n--) {
    pass(t);
  }
  return true;
}

static void
pass_digits(sg_csg_text *t)
{
  while (t->at < t->end && is_digit(*t->at)) {
    pass(t);
  }
}

/* To the beginning of the next word; false within a comment without end. */
static bool
pass_white(sg_csg_text *t)
{
  while (t->at < t->end) {
    if (*t->at == ' ' || (*t->at >= '\t' && *t->at <= '\r')) {
      pass(t);
    } else if (here(t, "//")) {
      pass_to(t, "\n");
    } else if (here(t, "/*")) {
      t->line = t->line_now;
      t->column = t->column_now;
      pass(t);
      pass(t);
      if (!pass_to(t, "*/")) {
        return false;
      }
    } else {
      return true;
    }
  }
  return true;
}

static bool
begins_number(const sg_csg_text *t)
{
  const char *c = t->at;

  c += *c == '-';
  c += c < t->end && *c == '.';
  return c < t->end && is_digit(*c);
}

static sg_csg_word
number(sg_csg_text *t)
{
  const char *mark;

  if (*t->at == '-') {
    pass(t);
  }
  pass_digits(t);
  if (t->end - t->at > 1 && *t->at == '.' && is_digit(t->at[1])) {
    pass(t);
    pass_digits(t);
  }
  mark = t->at + 1;
  if (t->at < t->end && (*t->at == 'e' || *t->at == 'E')) {
    mark += mark < t->end && (*mark == '+' || *mark == '-');
    if (mark < t->end && is_digit(*mark)) {
      while (t->at < mark) {
        pass(t);
      }
      pass_digits(t);
    }
  }
  return SG_CSG_NUMBER;
}

static sg_csg_word
name(sg_csg_text *t)
{
  while (t->at < t->end && (is_letter(*t->at) || is_digit(*t->at))) {
    pass(t);
  }
  return SG_CSG_NAME;
}

static sg_csg_word
string(sg_csg_text *t)
{
  pass(t);
  while (t->at < t->end && *t->at != '"') {
    if (*t->at == '\\') {
      pass(t);
    }
    if (t->at < t->end) {
      pass(t);
    }
  }
  if (t->at == t->end) {
    return SG_CSG_OPEN_STRING;
  }
  pass(t);
  return SG_CSG_STRING;
}

static sg_csg_word
sign(sg_csg_text *t)
{
  char c = *t->at;

  if (!c || !strchr("(){}[],;=*%#!-", c)) {
    return SG_CSG_STRANGE;
  }
  pass(t);
  t->blocks += c == '{';
  t->blocks -= c == '}' && t->blocks > 0;
  t->brackets += c == '(' || c == '[';
  t->brackets -= (c == ')' || c == ']') && t->brackets > 0;
  return SG_CSG_SIGN;
}

/* What of the word just read is above its limit. */
static sg_text_fault
beyond(const sg_csg_text *t)
{
  switch (t->word) {
  case SG_CSG_NAME:
  case SG_CSG_STRING:
    return t->n > t->most->name ? SG_TEXT_NAME : SG_TEXT_GOOD;
  case SG_CSG_NUMBER:
    return t->n > t->most->digits ? SG_TEXT_DIGITS : SG_TEXT_GOOD;
  case SG_CSG_SIGN:
    return t->blocks > t->most->blocks    ? SG_TEXT_BLOCKS
           : t->brackets > t->most->depth ? SG_TEXT_DEPTH
                                          : SG_TEXT_GOOD;
  case SG_CSG_END:
  case SG_CSG_OPEN_STRING:
  case SG_CSG_OPEN_COMMENT:
  case SG_CSG_STRANGE:
  case SG_CSG_BEYOND:
    break;
  }
  return SG_TEXT_GOOD;
}

sg_csg_word
sg_csg_next(sg_csg_text *t)
{
  if (t->word >= SG_CSG_OPEN_STRING) {
    return t->word;
  }
  if (!pass_white(t)) {
    return t->word = SG_CSG_OPEN_COMMENT;
  }
  t->begin = t->at;
  t->line = t->line_now;
  t->column = t->column_now;
  t->word = t->at == t->end     ? SG_CSG_END
            : begins_number(t)  ? number(t)
            : is_letter(*t->at) ? name(t)
            : *t->at == '"'     ? string(t)
                                : sign(t);
  t->n = (size_t)(t->at - t->begin);
  if (t->word == SG_CSG_STRING) {
    t->begin++;
    t->n -= 2;
  }
  t->fault = beyond(t);
  return t->fault ? (t->word = SG_CSG_BEYOND) : t->word;
}
