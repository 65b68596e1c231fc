/* plain_read_rows.c -- the text of plain facts: see plain_facts_rows.h. */
#include "plain_facts_rows.h"

#include "engine/list.h"
#include "engine/symbol.h"
#include "number/number.h"

#include <stdlib.h>
#include <string.h>

typedef enum outcome { TAKEN, NOT_PLAIN, NO_MEMORY } outcome;

typedef struct reader {
  sg_plain_facts *facts;
  const char *at, *end; /* of the text; it does not end in a fact */
  int32_t shift;
  size_t words; /* before this fact */
} reader;

/* ---- characters --------------------------------------------------------- */

static bool
is_digit(char c)
{
  return c >= '0' && c <= '9';
}

static bool
is_word(char c)
{
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || is_digit(c) ||
         c == '_';
}

static bool
is_blank(char c)
{
  return c == ' ' || c == '\t' || c == '\n' || c == '\r';
}

/* The end of a comment that begins at p; null: none does. */
static const char *
comment_end(const char *p, const char *end)
{
  const char *last;

  if (*p == '%') {
    last = memchr(p, '\n', (size_t)(end - p));
    return last ? last : end;
  }
  if (*p != '/' || end - p < 2 || p[1] != '*') {
    return NULL;
  }
  last = memmem(p + 2, (size_t)(end - p) - 2, "*/", 2);
  return last ? last + 2 : NULL;
}

/* Over layout and comments. */
static void
skip(reader *r)
{
  const char *next = r->at;

  while (next) {
    r->at = next;
    next = r->at == r->end    ? NULL
           : is_blank(*r->at) ? r->at + 1
                              : comment_end(r->at, r->end);
  }
}

static bool
take(reader *r, char c)
{
  skip(r);
  if (r->at == r->end || *r->at != c) {
    return false;
  }
  r->at++;
  return true;
}

/* ---- values ------------------------------------------------------------- */

/* Digits, with a point among them, and a power of ten after that. */
static bool
find_number_end(const char **at, const char *end, bool *whole)
{
  const char *p = *at;

  *whole = true;
  p += p < end && *p == '-';
  if (p == end || !is_digit(*p)) {
    return false;
  }
  while (p < end && is_digit(*p)) {
    p++;
  }
  if (end - p > 1 && *p == '.' && is_digit(p[1])) {
    *whole = false;
    while (++p < end && is_digit(*p)) {
    }
    if (p < end && (*p == 'e' || *p == 'E')) {
      p++;
      p += p < end && (*p == '-' || *p == '+');
      if (p == end || !is_digit(*p)) {
        return false;
      }
      while (p < end && is_digit(*p)) {
        p++;
      }
    }
  }
  *at = p;
  return p < end && (is_blank(*p) || (*p && strchr(",)]%", *p)));
}

static bool
read_int(reader *r, int32_t *out)
{
  const char *from = r->at, *p = from;
  bool whole;
  int64_t value = 0;

  if (!find_number_end(&r->at, r->end, &whole) || !whole || r->at - from > 11) {
    return false;
  }
  for (p += *from == '-'; p < r->at; p++) {
    value = 10 * value + (*p - '0');
  }
  *out = (int32_t)(*from == '-' ? -value : value);
  return value <= INT32_MAX;
}

static bool
read_float(reader *r, double *out)
{
  const char *from = r->at;
  bool whole;

  return find_number_end(&r->at, r->end, &whole) &&
         sg_number_read(from, (size_t)(r->at - from), out, NULL) ==
             SG_NUMBER_OK;
}

/* A word; -1: it is none, -2: no memory. */
static int32_t
read_word(reader *r)
{
  const char *from = r->at;

  while (r->at < r->end && is_word(*r->at)) {
    r->at++;
  }
  if (r->at == from || *from < 'a' || *from > 'z' || r->at == r->end ||
      (!is_blank(*r->at) && *r->at != ',' && *r->at != ')')) {
    return -1;
  }
  int32_t symbol = sg_symbol_intern(from, (size_t)(r->at - from));

  return symbol < 0 ? -2 : symbol;
}

static outcome
read_list(reader *r)
{
  sg_plain_facts *facts = r->facts;
  size_t start = facts->words;

  do {
    int32_t id = 0;

    skip(r);
    if (facts->words > start && !read_int(r, &id)) {
      return NOT_PLAIN;
    }
    if (!sg_list_grow(&facts->word, facts->words, &facts->word_room,
                      sizeof *facts->word)) {
      return NO_MEMORY;
    }
    facts->word[facts->words++] = id;
  } while (facts->words == start + 1 || take(r, ','));
  facts->word[start] = (int32_t)(facts->words - start - 1);
  return take(r, ']') ? TAKEN : NOT_PLAIN;
}

/* ---- facts -------------------------------------------------------------- */

/* Columns that can be plain. */
static bool
has_plain_columns(sg_relation relation)
{
  const sg_relation_info *info = &sg_relation_table[relation];

  for (unsigned c = 0; c < info->arity; c++) {
    if (info->column[c].type == SG_TERM) {
      return false;
    }
  }
  return true;
}

/* Those that files have, but settings, of which there is one, and lines, which
 * have numbers of their own. */
static const sg_relation TAKEN_RELATIONS[] = {
    SG_V,      SG_E,      SG_P,      SG_T,      SG_PLANE,  SG_SIDES,
    SG_FROM_V, SG_FROM_P, SG_FROM_R, SG_REGION, SG_LEAF_V, SG_LEAF_E,
    SG_LEAF_P, SG_LEAF_T, SG_PIECE,  SG_JOINT};

static bool
find_relation(const char *name, size_t n, sg_relation *out)
{
  for (size_t i = 0; i < sizeof TAKEN_RELATIONS / sizeof *TAKEN_RELATIONS;
       i++) {
    const char *is = sg_relation_table[TAKEN_RELATIONS[i]].name;

    if (strlen(is) == n && memcmp(is, name, n) == 0) {
      *out = TAKEN_RELATIONS[i];
      return has_plain_columns(*out);
    }
  }
  return false;
}

static bool
make_room(sg_plain_rows *rows, const sg_relation_info *info)
{
  for (unsigned c = 0; c < info->arity; c++) {
    sg_plain_column *to = &rows->column[c];
    sg_type type = info->column[c].type;

    if (!(type == SG_FLOAT
              ? sg_list_grow(&to->f, rows->n, &to->room, sizeof *to->f)
          : type == SG_LIST
              ? sg_list_grow(&to->at, rows->n, &to->room, sizeof *to->at)
              : sg_list_grow(&to->i, rows->n, &to->room, sizeof *to->i))) {
      return false;
    }
  }
  return true;
}

/* S, S0 and so on. */
static bool
names_segment(const char *column)
{
  return column[0] == 'S' && (column[1] == '\0' || is_digit(column[1]));
}

static outcome
read_value(reader *r, const sg_column_info *info, sg_plain_column *to,
           size_t row)
{
  int32_t value;
  int64_t moved;

  switch (info->type) {
  case SG_FLOAT:
    return read_float(r, &to->f[row]) ? TAKEN : NOT_PLAIN;
  case SG_LIST:
    to->at[row] = r->facts->words;
    return take(r, '[') ? read_list(r) : NOT_PLAIN;
  case SG_ATOM:
    value = read_word(r);
    to->i[row] = value;
    return value >= 0 ? TAKEN : value == -1 ? NOT_PLAIN : NO_MEMORY;
  case SG_INT:
  case SG_TERM:
    break;
  }
  if (!read_int(r, &value)) {
    return NOT_PLAIN;
  }
  moved = (int64_t)value + (names_segment(info->name) ? r->shift : 0);
  if (names_segment(info->name) &&
      (value <= 0 || moved <= 0 || moved > INT32_MAX)) {
    return NOT_PLAIN;
  }
  to->i[row] = (int32_t)moved;
  return TAKEN;
}

/* The end of a fact, and what makes it one. */
static bool
take_end(reader *r)
{
  return take(r, ')') && take(r, '.') && r->at < r->end &&
         (is_blank(*r->at) || *r->at == '%');
}

/* Whether text is one of `words`, which spaces part; null: any will do. */
static bool
is_among(const char *words, const char *from, const char *to)
{
  size_t n = (size_t)(to - from);

  while (words && *words) {
    size_t length = strcspn(words, " ");

    if (length == n && memcmp(words, from, n) == 0) {
      return true;
    }
    words += length + strspn(words + length, " ");
  }
  return !words;
}

/* Column c of the row that is being read. */
static outcome
read_column(reader *r, const sg_relation_info *info, sg_plain_rows *rows,
            unsigned c)
{
  if (c > 0 && !take(r, ',')) {
    return NOT_PLAIN;
  }
  skip(r);
  const char *from = r->at;
  outcome is = read_value(r, &info->column[c], &rows->column[c], rows->n);

  return is == TAKEN && !is_among(info->domain[c], from, r->at) ? NOT_PLAIN
                                                                : is;
}

static outcome
read_fact(reader *r)
{
  const char *name = r->at;
  sg_relation relation;

  while (r->at < r->end && is_word(*r->at)) {
    r->at++;
  }
  if (r->at == r->end || *r->at != '(' ||
      !find_relation(name, (size_t)(r->at - name), &relation)) {
    return NOT_PLAIN;
  }
  const sg_relation_info *info = &sg_relation_table[relation];
  sg_plain_rows *rows = &r->facts->of[relation];

  r->at++;
  if (!make_room(rows, info)) {
    return NO_MEMORY;
  }
  for (unsigned c = 0; c < info->arity; c++) {
    outcome is = read_column(r, info, rows, c);

    if (is != TAKEN) {
      return is;
    }
  }
  if (!take_end(r)) {
    return NOT_PLAIN;
  }
  rows->n++;
  return TAKEN;
}

/* ---- places ------------------------------------------------------------- */

/* Moves a place over text, as Prolog counts. */
static void
move(sg_text_place *place, const char *from, const char *to)
{
  for (const char *p = from; p < to; p++) {
    bool more = ((unsigned char)*p & 0xc0) == 0x80; /* of one character */

    place->character += !more;
    switch (*p) {
    case '\n':
      place->line++;
      place->column = 0;
      break;
    case '\r':
      place->column = 0;
      break;
    case '\b':
      place->column -= place->column > 0;
      break;
    case '\t':
      place->column = (place->column | 7) + 1;
      break;
    default:
      place->column += !more;
    }
  }
  place->octet += to - from;
}

bool
sg_plain_facts_take(sg_plain_facts *facts, int32_t shift, size_t most,
                    sg_text_place *place)
{
  const char *start = facts->text + place->octet;
  reader r = {.facts = facts,
              .at = start,
              .end = facts->text + facts->size,
              .shift = shift};
  const char *done = start;
  outcome is = TAKEN;

  for (size_t i = 0; i < most && is == TAKEN; i++) {
    size_t words = facts->words;

    skip(&r);
    done = r.at;
    is = read_fact(&r);
    if (is == TAKEN) {
      done = r.at;
    } else {
      facts->words = words;
    }
  }
  move(place, start, done);
  return is != NO_MEMORY;
}

void
sg_plain_facts_free(sg_plain_facts *facts)
{
  for (size_t r = 0; facts && r < SG_RELATIONS; r++) {
    for (unsigned c = 0; c < SG_MAX_COLUMNS; c++) {
      free(facts->of[r].column[c].i);
      free(facts->of[r].column[c].f);
      free(facts->of[r].column[c].at);
    }
  }
  if (facts) {
    free(facts->word);
    free(facts->text);
    free(facts);
  }
}
