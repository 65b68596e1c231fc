/* symbol.h -- interned text: words of the schema and names of functors.
 *
 * Layer: store. One table for the process, safe in every thread; a symbol
 * lives as long as the process, so texts that users make up without end
 * (names of segments) are not symbols but terms (term.h).
 */
#ifndef SG_SYMBOL_H
#define SG_SYMBOL_H

#include <stddef.h>
#include <stdint.h>

/* Symbols that C code writes, known without a search. */
#define SG_SYMBOLS(SYMBOL)                                                     \
  SYMBOL(MINUS, "-")                                                           \
  SYMBOL(CONS, "[|]")                                                          \
  SYMBOL(V, "v")                                                               \
  SYMBOL(E, "e")                                                               \
  SYMBOL(P, "p")                                                               \
  SYMBOL(T, "t")                                                               \
  SYMBOL(LPI, "lpi")                                                           \
  SYMBOL(TPI, "tpi")                                                           \
  SYMBOL(LL, "ll")                                                             \
  SYMBOL(LINE, "line")                                                         \
  SYMBOL(SOLID, "solid")                                                       \
  SYMBOL(SURFACE, "surface")                                                   \
  SYMBOL(CURVE, "curve")                                                       \
  SYMBOL(CELLS, "cells")                                                       \
  SYMBOL(PATTERN, "pattern")                                                   \
  SYMBOL(PARALLEL, "parallel")                                                 \
  SYMBOL(CENTRAL, "central")                                                   \
  SYMBOL(VISIBLE, "visible")                                                   \
  SYMBOL(HIDDEN, "hidden")                                                     \
  SYMBOL(SUBSTITUTE, "substitute")                                             \
  SYMBOL(OUTLINE, "outline")                                                   \
  SYMBOL(CREASE, "crease")                                                     \
  SYMBOL(SMOOTH, "smooth")                                                     \
  SYMBOL(PENETRATION, "penetration")                                           \
  SYMBOL(BORDER, "border")                                                     \
  SYMBOL(SECTION, "section")                                                   \
  SYMBOL(MESH, "mesh")                                                         \
  SYMBOL(NEAR, "near")                                                         \
  SYMBOL(LEAF, "leaf")                                                         \
  SYMBOL(MADE, "made")                                                         \
  SYMBOL(PRIMITIVE, "primitive")                                               \
  SYMBOL(NODE, "node")                                                         \
  SYMBOL(FOLD, "fold")                                                         \
  SYMBOL(SEAM, "seam")                                                         \
  SYMBOL(OUTSIDE, "outside")                                                   \
  SYMBOL(CELL, "cell")                                                         \
  SYMBOL(VOID, "void")                                                         \
  SYMBOL(SLIT, "slit")                                                         \
  SYMBOL(COMMA, ",")                                                           \
  SYMBOL(S, "s")                                                               \
  SYMBOL(SOURCE, "source")                                                     \
  SYMBOL(ON, "on")

enum {
#define SG_SYMBOL_ID(ID, text) SG_SYMBOL_##ID,
  SG_SYMBOLS(SG_SYMBOL_ID)
#undef SG_SYMBOL_ID
      SG_KNOWN_SYMBOLS
};

/* The symbol of `text` (UTF-8, `length` bytes); made when there is none.
 * -1: no memory. */
int32_t sg_symbol_intern(const char *text, size_t length);

/* The same, -1 when there is none yet. */
int32_t sg_symbol_find(const char *text, size_t length);

/* The text of a symbol, zero-terminated; its length when `length` is given. */
const char *sg_symbol_text(int32_t symbol, size_t *length);

#endif
