/* term.c -- the builder of coded terms. */
#include "term.h"
#include "list.h"

#include <stdlib.h>
#include <string.h>

enum { TAG_BITS = 4 };

void
sg_term_open(sg_term_builder *b)
{
  b->word = b->few;
  b->room = SG_TERM_FEW;
  b->count = 1; /* word[0]: the byte count, when it is known */
  b->failed = b->no_memory = false;
}

void
sg_term_close(sg_term_builder *b)
{
  if (b->word != b->few) {
    free(b->word);
  }
  b->word = b->few;
}

/* Room for `words` more; null: failed. */
static uint32_t *
extend(sg_term_builder *b, size_t words)
{
  size_t need = b->count + words;

  if (b->failed || need > SG_TERM_MOST) {
    b->failed = true;
    return NULL;
  }
  if (need > b->room) {
    bool few = b->word == b->few;
    uint32_t *word = few ? NULL : b->word;
    if (!sg_list_widen(&word, need, &b->room, sizeof(*word))) {
      b->failed = b->no_memory = true;
      return NULL;
    }
    if (few) {
      memcpy(word, b->few, b->count * sizeof(*word));
    }
    b->word = word;
  }
  b->count = need;
  return b->word + need - words;
}

static uint32_t
header(sg_term_tag tag, size_t payload)
{
  return (uint32_t)tag | (uint32_t)payload << TAG_BITS;
}

static void
put_bits(uint32_t word[2], uint64_t bits)
{
  word[0] = (uint32_t)bits;
  word[1] = (uint32_t)(bits >> 32);
}

void
sg_term_int(sg_term_builder *b, int64_t value)
{
  const int64_t most = INT64_C(1) << 27;
  bool small = -most <= value && value < most;
  uint32_t *word = extend(b, small ? 1 : 3);

  if (!word) {
    return;
  }
  if (small) {
    word[0] = header(SG_TERM_INT, (size_t)(uint32_t)value);
  } else {
    word[0] = header(SG_TERM_INT64, 0);
    put_bits(word + 1, (uint64_t)value);
  }
}

void
sg_term_float(sg_term_builder *b, double value)
{
  uint32_t *word = extend(b, 3);
  uint64_t bits;

  if (word) {
    memcpy(&bits, &value, sizeof(bits));
    word[0] = header(SG_TERM_FLOAT, 0);
    put_bits(word + 1, bits);
  }
}

static void
put_text(sg_term_builder *b, sg_term_tag tag, const char *utf8, size_t bytes)
{
  size_t words = (bytes + sizeof(uint32_t) - 1) / sizeof(uint32_t);
  uint32_t *word = extend(b, 1 + words);

  if (word) {
    word[0] = header(tag, bytes);
    if (words > 0) {
      word[words] = 0;
      memcpy(word + 1, utf8, bytes);
    }
  }
}

void
sg_term_atom(sg_term_builder *b, const char *utf8, size_t bytes)
{
  put_text(b, SG_TERM_ATOM, utf8, bytes);
}

void
sg_term_string(sg_term_builder *b, const char *utf8, size_t bytes)
{
  put_text(b, SG_TERM_STRING, utf8, bytes);
}

void
sg_term_nil(sg_term_builder *b)
{
  uint32_t *word = extend(b, 1);

  if (word) {
    word[0] = header(SG_TERM_NIL, 0);
  }
}

void
sg_term_compound(sg_term_builder *b, int32_t symbol, size_t arity)
{
  uint32_t *word;

  if (symbol < 0 || arity >= SG_TERM_MOST) {
    b->failed = true;
  } else if ((word = extend(b, 2))) {
    word[0] = header(SG_TERM_COMPOUND, arity);
    word[1] = (uint32_t)symbol;
  }
}

void
sg_term_big(sg_term_builder *b, bool negative, const uint32_t *magnitude,
            size_t words)
{
  uint32_t *word = extend(b, 1 + words);

  if (word) {
    word[0] = header(SG_TERM_BIG, 2 * words + (negative ? 1 : 0));
    memcpy(word + 1, magnitude, words * sizeof(*word));
  }
}

void
sg_term_rational(sg_term_builder *b)
{
  uint32_t *word = extend(b, 1);

  if (word) {
    word[0] = header(SG_TERM_RATIONAL, 0);
  }
}

void
sg_term_pair(sg_term_builder *b, int64_t left, int64_t right)
{
  sg_term_compound(b, SG_SYMBOL_MINUS, 2);
  sg_term_int(b, left);
  sg_term_int(b, right);
}

void
sg_term_unary(sg_term_builder *b, int32_t symbol, int64_t a)
{
  sg_term_compound(b, symbol, 1);
  sg_term_int(b, a);
}

const uint32_t *
sg_term_words(sg_term_builder *b)
{
  if (b->failed) {
    return NULL;
  }
  b->word[0] = (uint32_t)((b->count - 1) * sizeof(uint32_t));
  return b->word;
}

bool
sg_term_equal(const uint32_t *a, const uint32_t *b)
{
  return a[0] == b[0] && memcmp(a + 1, b + 1, a[0]) == 0;
}

uint64_t
sg_term_hash(const uint32_t *term)
{
  uint64_t h = term[0];

  for (size_t i = 1; i < sg_term_length(term); i++) {
    h = (h ^ term[i]) * 0x9e3779b97f4a7c15u;
    h ^= h >> 29;
  }
  return h;
}

int32_t
sg_term_vertex(const uint32_t *term)
{
  bool is = term[0] == 3 * sizeof(*term) &&
            term[1] == header(SG_TERM_COMPOUND, 1) && term[2] == SG_SYMBOL_V &&
            (term[3] & ((1 << TAG_BITS) - 1)) == SG_TERM_INT &&
            term[3] >> 31 == 0; /* not negative */

  return is ? (int32_t)(term[3] >> TAG_BITS) : 0;
}
