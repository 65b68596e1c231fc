/* term.h -- ground Prolog terms as words: equal bytes if and only if equal
 * terms.
 *
 * Layer: store. No Prolog: world4pl.h turns terms into words and back, C
 * kernels write origins with a builder:
 *
 *   sg_term_builder b;                      lpi(S1-(A-B), S2-T)
 *   sg_term_open(&b);
 *   sg_term_compound(&b, SG_SYMBOL_LPI, 2);
 *   sg_term_compound(&b, SG_SYMBOL_MINUS, 2);
 *   sg_term_int(&b, s1);
 *   sg_term_pair(&b, a, b);
 *   sg_term_pair(&b, s2, t);
 *   term = sg_term_words(&b);               null: no memory
 *   ... use it ...
 *   sg_term_close(&b);
 *
 * A term is word[0], its byte count, then its nodes in prefix order. A node is
 * one header word (tag in the low 4 bits, payload above) and its data.
 */
#ifndef SG_TERM_H
#define SG_TERM_H

#include "symbol.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

typedef enum sg_term_tag {
  SG_TERM_INT,      /* payload: the integer, -2^27 .. 2^27-1 */
  SG_TERM_INT64,    /* two words, low first; only if SG_TERM_INT is too small */
  SG_TERM_BIG,      /* payload: words * 2 + sign; magnitude, low word first */
  SG_TERM_RATIONAL, /* numerator and denominator nodes follow */
  SG_TERM_FLOAT,    /* two words, low first */
  SG_TERM_ATOM,     /* payload: bytes of UTF-8, padded with zeros */
  SG_TERM_STRING,   /* the same */
  SG_TERM_NIL,      /* [] */
  SG_TERM_COMPOUND  /* payload: arity; word: symbol; then the arguments */
} sg_term_tag;

enum { SG_TERM_FEW = 48, SG_TERM_MOST = 1 << 27 };

typedef struct sg_term_builder {
  uint32_t few[SG_TERM_FEW]; /* short terms need no heap */
  uint32_t *word;
  size_t count, room;
  bool failed; /* no memory, or a text or number too long */
  bool no_memory;
} sg_term_builder;

void sg_term_open(sg_term_builder *builder);
void sg_term_close(sg_term_builder *builder);

/* Each writes one node; a compound's arguments come next, in order. */
void sg_term_int(sg_term_builder *builder, int64_t value);
void sg_term_float(sg_term_builder *builder, double value);
void sg_term_atom(sg_term_builder *builder, const char *utf8, size_t bytes);
void sg_term_string(sg_term_builder *builder, const char *utf8, size_t bytes);
void sg_term_nil(sg_term_builder *builder);
void sg_term_compound(sg_term_builder *builder, int32_t symbol, size_t arity);
/* Magnitude as 32-bit words, low first, without leading zeros; only for
 * integers that do not fit 64 bits. */
void sg_term_big(sg_term_builder *builder, bool negative,
                 const uint32_t *magnitude, size_t words);
/* Its numerator and denominator are the next two nodes. */
void sg_term_rational(sg_term_builder *builder);

/* A-B for two integers, and name(A), as origins use them. */
void sg_term_pair(sg_term_builder *builder, int64_t left, int64_t right);
void sg_term_unary(sg_term_builder *builder, int32_t symbol, int64_t a);

/* The finished term, the builder's until it is closed. Null: it failed. */
const uint32_t *sg_term_words(sg_term_builder *builder);

/* N of the term v(N), 1 .. 2^27-1; 0: it is another. */
int32_t sg_term_vertex(const uint32_t *term);

/* Words of a whole term, word[0] among them. */
static inline size_t
sg_term_length(const uint32_t *term)
{
  return 1 + term[0] / sizeof(uint32_t);
}

/* Nodes: term + 1 is the first of a term, and its arguments follow a
 * compound. */

static inline sg_term_tag
sg_node_tag(const uint32_t *node)
{
  return (sg_term_tag)(node[0] & 15);
}

/* Whether it is a compound of this name and arity. */
static inline bool
sg_node_is(const uint32_t *node, int32_t symbol, size_t arity)
{
  return sg_node_tag(node) == SG_TERM_COMPOUND && node[0] >> 4 == arity &&
         node[1] == (uint32_t)symbol;
}

/* Its first argument. */
static inline const uint32_t *
sg_node_arguments(const uint32_t *compound)
{
  return compound + 2;
}

/* What follows a node and all that is in it. */
const uint32_t *sg_node_after(const uint32_t *node);
/* Whether it is an integer of 32 bits. */
bool sg_node_int(const uint32_t *node, int32_t *out);
/* Below 0, 0, above 0: in SWI-Prolog's standard order, but that big integers
 * and rationals come after other numbers, by their words. */
int sg_node_order(const uint32_t *a, const uint32_t *b);
/* Writes a copy of a node and all that is in it. */
void sg_term_node(sg_term_builder *builder, const uint32_t *node);

bool sg_term_equal(const uint32_t *a, const uint32_t *b);
uint64_t sg_term_hash(const uint32_t *term);

#endif
