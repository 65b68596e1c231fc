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

/* ---- nodes -------------------------------------------------------------- */

/* The words of a node without what is in it. */
static size_t
node_words(const uint32_t *node)
{
  size_t payload = node[0] >> TAG_BITS;

  switch (sg_node_tag(node)) {
  case SG_TERM_INT64:
  case SG_TERM_FLOAT:
    return 3;
  case SG_TERM_BIG:
    return 1 + payload / 2;
  case SG_TERM_ATOM:
  case SG_TERM_STRING:
    return 1 + (payload + sizeof(*node) - 1) / sizeof(*node);
  case SG_TERM_COMPOUND:
    return 2;
  case SG_TERM_INT:
  case SG_TERM_RATIONAL:
  case SG_TERM_NIL:
    break;
  }
  return 1;
}

const uint32_t *
sg_node_after(const uint32_t *node)
{
  for (size_t left = 1; left > 0; left--) {
    sg_term_tag tag = sg_node_tag(node);

    left += tag == SG_TERM_COMPOUND   ? node[0] >> TAG_BITS
            : tag == SG_TERM_RATIONAL ? 2
                                      : 0;
    node += node_words(node);
  }
  return node;
}

static int64_t
node_bits(const uint32_t *node)
{
  return (int64_t)(node[1] | (uint64_t)node[2] << 32);
}

/* Of one that is SG_TERM_INT or SG_TERM_INT64. */
static int64_t
node_integer(const uint32_t *node)
{
  uint32_t payload = node[0] >> TAG_BITS, sign = UINT32_C(1) << 27;

  return sg_node_tag(node) == SG_TERM_INT64
             ? node_bits(node)
             : (int64_t)(payload ^ sign) - (int64_t)sign;
}

bool
sg_node_int(const uint32_t *node, int32_t *out)
{
  sg_term_tag tag = sg_node_tag(node);
  int64_t n =
      tag == SG_TERM_INT || tag == SG_TERM_INT64 ? node_integer(node) : 0;

  *out = (int32_t)n;
  return (tag == SG_TERM_INT || tag == SG_TERM_INT64) && *out == n;
}

/* As SWI-Prolog has them. */
enum { NUMBER, LONG_NUMBER, STRING, NIL, ATOM, COMPOUND };

static int
node_rank(const uint32_t *node)
{
  switch (sg_node_tag(node)) {
  case SG_TERM_INT:
  case SG_TERM_INT64:
  case SG_TERM_FLOAT:
    return NUMBER;
  case SG_TERM_BIG:
  case SG_TERM_RATIONAL:
    return LONG_NUMBER;
  case SG_TERM_STRING:
    return STRING;
  case SG_TERM_NIL:
    return NIL;
  case SG_TERM_ATOM:
    return ATOM;
  case SG_TERM_COMPOUND:
    break;
  }
  return COMPOUND;
}

static int
sign_of(bool below, bool above)
{
  return (int)above - (int)below;
}

/* By value; a float before the integer that it is. */
static int
number_order(const uint32_t *a, const uint32_t *b)
{
  double x[2] = {0, 0};
  int64_t n[2] = {0, 0};
  bool is_float[2];

  for (int k = 0; k < 2; k++) {
    const uint32_t *node = k == 0 ? a : b;

    is_float[k] = sg_node_tag(node) == SG_TERM_FLOAT;
    if (is_float[k]) {
      int64_t bits = node_bits(node);
      memcpy(&x[k], &bits, sizeof(bits));
    } else {
      n[k] = node_integer(node);
      x[k] = (double)n[k];
    }
  }
  if (!is_float[0] && !is_float[1]) {
    return sign_of(n[0]<n[1], n[0]> n[1]);
  }
  int by_value = sign_of(x[0]<x[1], x[0]> x[1]);

  return by_value ? by_value : (int)is_float[1] - (int)is_float[0];
}

static int
text_order(const char *a, size_t a_bytes, const char *b, size_t b_bytes)
{
  int by = memcmp(a, b, a_bytes < b_bytes ? a_bytes : b_bytes);

  return by ? by : sign_of(a_bytes<b_bytes, a_bytes> b_bytes);
}

/* By arity, name and, later, arguments. */
static int
compound_order(const uint32_t *a, const uint32_t *b)
{
  uint32_t arity[2] = {a[0] >> TAG_BITS, b[0] >> TAG_BITS};
  size_t length[2];

  if (arity[0] != arity[1]) {
    return sign_of(arity[0]<arity[1], arity[0]> arity[1]);
  }
  if (a[1] == b[1]) {
    return 0;
  }
  const char *x = sg_symbol_text((int32_t)a[1], &length[0]);
  const char *y = sg_symbol_text((int32_t)b[1], &length[1]);

  return text_order(x, length[0], y, length[1]);
}

/* By themselves, of one rank, without what is in them. */
static int
same_rank_order(int rank, const uint32_t *a, const uint32_t *b)
{
  switch (rank) {
  case NUMBER:
    return number_order(a, b);
  case LONG_NUMBER:
    return text_order((const char *)a, node_words(a) * sizeof(*a),
                      (const char *)b, node_words(b) * sizeof(*b));
  case NIL:
    return 0;
  case COMPOUND:
    return compound_order(a, b);
  default: /* characters, as UTF-8 has them */
    return text_order((const char *)(a + 1), a[0] >> TAG_BITS,
                      (const char *)(b + 1), b[0] >> TAG_BITS);
  }
}

int
sg_node_order(const uint32_t *a, const uint32_t *b)
{
  const uint32_t *end = sg_node_after(a);
  int by = 0;

  while (a < end && by == 0) {
    int rank = node_rank(a);

    by = rank - node_rank(b);
    by = by ? by : same_rank_order(rank, a, b);
    a += node_words(a);
    b += node_words(b);
  }
  return by;
}

void
sg_term_node(sg_term_builder *b, const uint32_t *node)
{
  size_t words = (size_t)(sg_node_after(node) - node);
  uint32_t *word = extend(b, words);

  if (word) {
    memcpy(word, node, words * sizeof(*word));
  }
}
