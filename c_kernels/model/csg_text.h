/* csg_text.h -- the words of a .csg file, as OpenSCAD writes it.
 *
 * Layer: kernel. A file is walked twice, with the same steps: first for what is
 * too deep or too long, so that nothing is built of it, then to be read.
 */
#ifndef SG_CSG_TEXT_H
#define SG_CSG_TEXT_H

#include "text_limits.h"

typedef enum sg_csg_word {
  SG_CSG_END,
  SG_CSG_NAME,   /* letters of ASCII, digits, _ and $ */
  SG_CSG_NUMBER, /* maybe with the minus before it */
  SG_CSG_STRING, /* without its quotes, but with its backslashes */
  SG_CSG_SIGN,   /* one of ( ) { } [ ] , ; = * % # ! - */
  /* What ends a file before its end: */
  SG_CSG_OPEN_STRING,
  SG_CSG_OPEN_COMMENT,
  SG_CSG_STRANGE, /* a character that begins nothing */
  SG_CSG_BEYOND   /* a limit is broken: text->fault */
} sg_csg_word;

/* A file being read; what stands above `at` is of the word read last. Places
 * count characters of UTF-8, from 1. */
typedef struct sg_csg_text {
  sg_csg_word word;
  const char *begin;
  size_t n;
  uint64_t line, column;
  const char *at, *end;
  uint64_t line_now, column_now;
  uint64_t blocks, brackets; /* that are open */
  const sg_text_limits *most;
  sg_text_fault fault;
} sg_csg_text;

void sg_csg_open(sg_csg_text *t, const char *text, size_t n,
                 const sg_text_limits *most);
/* Reads the next word. The end, and what ends a file before it, stay. */
sg_csg_word sg_csg_next(sg_csg_text *t);

#endif
