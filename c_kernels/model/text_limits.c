/* text_limits.c -- what of a text is too deep or too long (text_limits.h). */
#include "model/text_limits.h"
#include "engine/list.h"
#include <stdlib.h>
#include <string.h>

enum { PROGRAM_WORDS = 8 };

const char *
sg_text_fault_name(sg_text_fault fault)
{
  static const char *const name[] = {
      [SG_TEXT_GOOD] = "none",     [SG_TEXT_DEPTH] = "depth",
      [SG_TEXT_BLOCKS] = "blocks", [SG_TEXT_DIGITS] = "digits",
      [SG_TEXT_NAME] = "name",     [SG_TEXT_FACT] = "fact",
      [SG_TEXT_FILE] = "file",     [SG_TEXT_NO_MEMORY] = "memory",
  };

  return name[fault];
}

void
sg_text_scan_open(sg_text_scan *s, sg_text_kind kind,
                  const sg_text_limits *most)
{
  *s = (sg_text_scan){.kind = kind, .most = *most, .line = 1, .column = 1};
}

void
sg_text_scan_close(sg_text_scan *s)
{
  free(s->level);
  s->level = NULL;
}

static void
faulty(sg_text_scan *s, sg_text_fault fault)
{
  if (!s->fault) {
    s->fault = fault;
  }
}

static bool
is_json(const sg_text_scan *s)
{
  return s->kind == SG_TEXT_JSON || s->kind == SG_TEXT_LINES;
}

/* Characters ------------------------------------------------------------- */

static bool
is_digit(uint32_t c)
{
  return c >= '0' && c <= '9';
}

static bool
is_word(uint32_t c)
{
  return is_digit(c) || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') ||
         c == '_' || c >= 0x80;
}

static bool
is_sign(uint32_t c)
{
  return c < 0x80 && c && strchr("#$&*+-./:<=>?@\\^~", (int)c);
}

static bool
is_white(uint32_t c)
{
  return c <= ' ' || c == 0x7f;
}

/* Not of ASCII, and maybe no letter: a word by itself. */
static bool
is_alone(uint32_t c)
{
  return (c >= 0x80 && c < 0xc0) || c == 0xd7 || c == 0xf7 || c == 0x1680 ||
         (c >= 0x2000 && c < 0x2c00) || (c >= 0x3000 && c < 0x3040) ||
         c >= 0xe000;
}

static int
digit_value(uint32_t c)
{
  return is_digit(c)            ? (int)(c - '0')
         : c >= 'a' && c <= 'f' ? (int)(c - 'a' + 10)
         : c >= 'A' && c <= 'F' ? (int)(c - 'A' + 10)
                                : 99;
}

/* Words and brackets ----------------------------------------------------- */

static void
count_word(sg_text_scan *s)
{
  uint64_t most =
      (s->kind == SG_TEXT_PROGRAM ? PROGRAM_WORDS : 1) * s->most.depth;

  if (is_json(s)) {
    return;
  }
  *(s->n ? &s->level[s->n - 1].words : &s->top) += 1;
  if (++s->depth > most) {
    faulty(s, SG_TEXT_DEPTH);
  }
}

static void
begin_word(sg_text_scan *s, sg_text_state state)
{
  s->state = state;
  s->word = 0;
  count_word(s);
}

static void
open_bracket(sg_text_scan *s, char bracket)
{
  if (bracket != '(') {
    count_word(s);
  }
  if (!sg_list_grow(&s->level, s->n, &s->room, sizeof *s->level)) {
    faulty(s, SG_TEXT_NO_MEMORY);
    return;
  }
  s->level[s->n++] = (sg_text_level){bracket, 0};
  if (s->n > s->most.depth) {
    faulty(s, SG_TEXT_DEPTH);
  }
}

static void
close_bracket(sg_text_scan *s)
{
  if (s->n > 0) {
    s->depth -= s->level[--s->n].words;
  }
  if (s->n == 0 && s->kind == SG_TEXT_LINES) {
    s->fact = 0;
    s->in_fact = false;
  }
}

static void
comma(sg_text_scan *s)
{
  if (s->n > 0 && (s->level[s->n - 1].bracket == '(' ||
                   s->level[s->n - 1].bracket == '[')) {
    s->depth -= s->level[s->n - 1].words;
    s->level[s->n - 1].words = 0;
  } else {
    count_word(s);
  }
}

static void
end_fact(sg_text_scan *s)
{
  if (is_json(s)) {
    return;
  }
  s->depth = s->top = s->fact = 0;
  s->n = 0;
  s->in_fact = false;
}

/* One character ---------------------------------------------------------- */

/* c begins something, or is white; s->glued: nothing was between it and the
 * name before it. */
static void
begin(sg_text_scan *s, uint32_t c)
{
  bool glued = s->glued;

  s->glued = false;
  s->state = SG_TEXT_WHITE;
  if (is_white(c)) {
    return;
  }
  s->in_fact = s->in_fact || (c != '%' && c != '/');
  if (c == '"' || ((c == '\'' || c == '`') && !is_json(s))) {
    begin_word(s, SG_TEXT_QUOTED);
    s->quote = c;
    if (c == '`') {
      count_word(s); /* a list */
    }
  } else if (c == '%' && !is_json(s)) {
    s->state = SG_TEXT_LINE;
  } else if (c == '/') {
    s->state = SG_TEXT_SLASH;
  } else if (c == '(') {
    open_bracket(s, glued ? '(' : 'o');
  } else if (c == '[' || c == '{') {
    open_bracket(s, (char)c);
  } else if (c == ')' || c == ']' || c == '}') {
    close_bracket(s);
  } else if (c == ',') {
    comma(s);
  } else if (is_digit(c)) {
    begin_word(s, SG_TEXT_NUMBER);
    s->only_zero = c == '0';
    s->only_digits = true;
    s->word = 1;
  } else if (is_alone(c)) {
    begin_word(s, SG_TEXT_ALONE);
  } else if (is_word(c)) {
    begin_word(s, SG_TEXT_WORD);
    s->word = 1;
  } else if (is_sign(c)) {
    begin_word(s, SG_TEXT_SIGN);
    s->word = 1;
  } else { /* ! ; | */
    count_word(s);
    s->glued = true;
  }
}

static void
longer(sg_text_scan *s, uint64_t most, sg_text_fault fault)
{
  if (++s->word > most) {
    faulty(s, fault);
  }
}

static void
in_word(sg_text_scan *s, uint32_t c)
{
  if (is_word(c) && !is_alone(c)) {
    longer(s, s->most.name, SG_TEXT_NAME);
  } else {
    s->glued = true;
    begin(s, c);
  }
}

static void
in_number(sg_text_scan *s, uint32_t c)
{
  if (is_word(c) && !is_alone(c)) {
    longer(s, s->most.digits, SG_TEXT_DIGITS);
    s->only_zero = false;
    s->only_digits = s->only_digits && is_digit(c);
  } else if (c == '.') {
    s->state = SG_TEXT_POINT;
  } else if (c == '\'' && s->only_zero) {
    s->state = SG_TEXT_CHARACTER;
  } else if (c == '\'' && s->word <= 2) {
    longer(s, s->most.digits, SG_TEXT_DIGITS); /* 16'FF */
    s->only_zero = s->only_digits = false;
  } else {
    s->glued = true;
    begin(s, c);
  }
}

static void
in_point(sg_text_scan *s, uint32_t c)
{
  if (is_digit(c) && s->only_digits) {
    s->state = SG_TEXT_NUMBER;
    s->word++;
    s->only_zero = s->only_digits = false;
    longer(s, s->most.digits, SG_TEXT_DIGITS);
  } else if (is_digit(c)) {
    count_word(s); /* 0x1.5 are three */
    begin(s, c);
  } else if (is_white(c) || c == '%') {
    end_fact(s);
    begin(s, c);
  } else {
    begin_word(s, SG_TEXT_SIGN);
    s->last = '.';
    s->word = 1;
    if (is_sign(c)) {
      s->word++;
    } else {
      s->glued = true;
      begin(s, c);
    }
  }
}

static void
in_sign(sg_text_scan *s, uint32_t c)
{
  bool stop = s->last == '.' && s->word == 1;

  if (stop && (is_white(c) || c == '%')) {
    end_fact(s);
    begin(s, c);
  } else if (is_sign(c)) {
    longer(s, s->most.name, SG_TEXT_NAME);
  } else {
    s->glued = true;
    begin(s, c);
  }
}

static void
in_slash(sg_text_scan *s, uint32_t c)
{
  if (c == '*') {
    s->state = SG_TEXT_COMMENT;
    s->star = false;
  } else if (c == '/' && is_json(s)) {
    s->state = SG_TEXT_LINE;
  } else {
    s->in_fact = true;
    begin_word(s, SG_TEXT_SIGN);
    s->word = 1;
    s->last = '/';
    in_sign(s, c);
  }
}

/* Behind what may be a sign: what follows may go on with it, and nobody knows
 * here if a comment does. */
static void
in_alone(sg_text_scan *s, uint32_t c)
{
  if (c == '/') {
    faulty(s, SG_TEXT_DEPTH);
  } else if (is_sign(c)) {
    begin_word(s, SG_TEXT_SIGN);
    s->word = 2;
  } else {
    s->glued = true;
    begin(s, c);
  }
}

static void
in_quoted(sg_text_scan *s, uint32_t c)
{
  if (c == '\\') {
    s->state = SG_TEXT_ESCAPE;
    s->before_escape = SG_TEXT_QUOTED;
  } else if (c == s->quote) {
    s->state = SG_TEXT_QUOTED_END;
    return;
  }
  longer(s, s->most.name, SG_TEXT_NAME);
}

static void
after_quote(sg_text_scan *s, uint32_t c)
{
  if (c == s->quote) {
    s->state = SG_TEXT_QUOTED;
    longer(s, s->most.name, SG_TEXT_NAME);
  } else {
    s->glued = true;
    begin(s, c);
  }
}

/* Behind \ in quotes: \x and \1 have digits and perhaps one character more. */
static void
in_escape(sg_text_scan *s, uint32_t c)
{
  longer(s, s->most.name, SG_TEXT_NAME);
  s->state = SG_TEXT_QUOTED;
  if (c == 'x' || digit_value(c) < 8) {
    s->base = c == 'x' ? 16 : 8;
    s->state = SG_TEXT_CODE;
  }
}

static void
in_code(sg_text_scan *s, uint32_t c)
{
  bool inside = s->before_escape == SG_TEXT_QUOTED;

  if (digit_value(c) < s->base) {
    longer(s, s->most.name, SG_TEXT_NAME);
  } else if (c == '\\') {
    s->state = inside ? SG_TEXT_QUOTED : SG_TEXT_WHITE;
  } else if (inside) {
    s->state = SG_TEXT_QUOTED;
    in_quoted(s, c);
  } else {
    begin(s, c);
  }
}

/* Behind 0' */
static void
in_character(sg_text_scan *s, uint32_t c)
{
  s->state = c == '\\'   ? SG_TEXT_CHARACTER_ESCAPE
             : c == '\'' ? SG_TEXT_CHARACTER_QUOTE
                         : SG_TEXT_WHITE;
}

static void
in_character_escape(sg_text_scan *s, uint32_t c)
{
  s->state = SG_TEXT_WHITE;
  if (c == 'x' || digit_value(c) < 8) {
    s->base = c == 'x' ? 16 : 8;
    s->word = 0;
    s->before_escape = SG_TEXT_CHARACTER;
    s->state = SG_TEXT_CODE;
  }
}

static void
in_comment(sg_text_scan *s, uint32_t c)
{
  if (c == '/' && s->star) {
    s->state = SG_TEXT_WHITE;
    s->glued = false;
  }
  s->star = c == '*';
}

static void
step(sg_text_scan *s, uint32_t c)
{
  static void (*const in[])(sg_text_scan *, uint32_t) = {
      [SG_TEXT_WHITE] = begin,
      [SG_TEXT_WORD] = in_word,
      [SG_TEXT_NUMBER] = in_number,
      [SG_TEXT_POINT] = in_point,
      [SG_TEXT_SIGN] = in_sign,
      [SG_TEXT_ALONE] = in_alone,
      [SG_TEXT_QUOTED] = in_quoted,
      [SG_TEXT_QUOTED_END] = after_quote,
      [SG_TEXT_ESCAPE] = in_escape,
      [SG_TEXT_CODE] = in_code,
      [SG_TEXT_CHARACTER] = in_character,
      [SG_TEXT_CHARACTER_ESCAPE] = in_character_escape,
      [SG_TEXT_COMMENT] = in_comment,
      [SG_TEXT_SLASH] = in_slash,
  };

  if (s->state == SG_TEXT_LINE) {
    s->state = c == '\n' ? SG_TEXT_WHITE : SG_TEXT_LINE;
  } else if (s->state == SG_TEXT_CHARACTER_QUOTE) {
    s->state = SG_TEXT_WHITE; /* 0''' is a quote; else it was 0' and a quote */
    if (c != '\'') {
      begin(s, c);
    }
  } else {
    in[s->state](s, c);
  }
  s->last = c;
}

/* Bytes ------------------------------------------------------------------ */

static void
character(sg_text_scan *s, uint32_t c)
{
  step(s, c);
  if (s->fault) {
    return;
  }
  if (s->in_fact && ++s->fact > s->most.fact && s->kind != SG_TEXT_JSON) {
    faulty(s, SG_TEXT_FACT);
  } else if (c == '\n') {
    s->line++;
    s->column = 1;
  } else {
    s->column++;
  }
}

bool
sg_text_scan_feed(sg_text_scan *s, const char *bytes, size_t n)
{
  if (s->kind == SG_TEXT_OCTETS) {
    return true;
  }
  for (size_t i = 0; i < n && !s->fault; i++) {
    uint32_t c = (unsigned char)bytes[i];
    if (s->left > 0 && (c < 0x80 || c >= 0xc0)) {
      s->left = 0;
      character(s, 0xfffd); /* no UTF-8 */
    }
    if (c < 0x80) {
      character(s, c);
    } else if (c >= 0xc0) {
      s->left = c < 0xe0 ? 1 : c < 0xf0 ? 2 : 3;
      s->code = c & (0x3fU >> s->left);
    } else if (s->left > 0) {
      s->code = s->code << 6 | (c & 0x3f);
      if (--s->left == 0) {
        character(s, s->code);
      }
    } else {
      character(s, c);
    }
  }
  return !s->fault;
}
