/* text_limits.h -- what of a text is too deep or too long, before it is read.
 *
 * Layer: kernel. A reader of terms goes down its own stack with every bracket
 * and makes every number and name at once, so what a file may cost is decided
 * here, over its bytes, in one pass with no memory but a stack of brackets.
 *
 * The depth at a place is the sum, over the brackets that are open there, of
 * the words (names, numbers, texts, signs) since the last comma of each: what
 * is written in n words is no deeper than n, whatever operators are in it. A
 * name and its bracket are one word. So f(g(a)) is 3 deep, and so is - - a;
 * [a,b,c] is 2. A comma that is an operator (outside brackets, in (a,b) and
 * {a,b}) divides nothing.
 *
 * A scan may think that a text is deeper than a reader does, where words stand
 * side by side that no operator joins, but never less deep.
 */
#ifndef SG_TEXT_LIMITS_H
#define SG_TEXT_LIMITS_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

typedef enum sg_text_kind {
  SG_TEXT_FACTS,   /* Prolog terms, data */
  SG_TEXT_PROGRAM, /* goals and clauses: a conjunction of many goals is no
                      deep term, so words may be eight times as many */
  SG_TEXT_JSON,    /* one value: of depth only the brackets count. After what
                      is no JSON anything may be thought: nobody reads on */
  SG_TEXT_LINES,   /* values of JSON: each is no longer than a fact */
  SG_TEXT_OCTETS   /* anything: nothing is looked at */
} sg_text_kind;

typedef enum sg_text_fault {
  SG_TEXT_GOOD,
  SG_TEXT_DEPTH,
  SG_TEXT_BLOCKS,
  SG_TEXT_DIGITS,
  SG_TEXT_NAME,
  SG_TEXT_FACT,
  SG_TEXT_FILE,
  SG_TEXT_NO_MEMORY
} sg_text_fault;

/* No more than these, all above zero. */
typedef struct sg_text_limits {
  uint64_t depth;  /* see above */
  uint64_t blocks; /* { } in one another, of a .csg file (csg_text.h) */
  uint64_t digits; /* of a number, with its letters and its point */
  uint64_t name;   /* characters of a name or a text, as written */
  uint64_t fact;   /* characters from the first of a fact to its full stop */
  uint64_t file;   /* octets of a file that is read as a whole */
} sg_text_limits;

typedef enum sg_text_state {
  SG_TEXT_WHITE,
  SG_TEXT_WORD,
  SG_TEXT_NUMBER,
  SG_TEXT_POINT, /* a full stop behind a number */
  SG_TEXT_SIGN,
  SG_TEXT_ALONE, /* behind a character that may be a sign */
  SG_TEXT_QUOTED,
  SG_TEXT_QUOTED_END, /* behind what may be the last quote */
  SG_TEXT_ESCAPE,
  SG_TEXT_CODE,      /* the digits of \x41\ */
  SG_TEXT_CHARACTER, /* behind 0' */
  SG_TEXT_CHARACTER_QUOTE,
  SG_TEXT_CHARACTER_ESCAPE,
  SG_TEXT_LINE,    /* a comment to the end of its line */
  SG_TEXT_COMMENT, /* one with two ends */
  SG_TEXT_SLASH    /* a slash that may begin one */
} sg_text_state;

typedef struct sg_text_level {
  char bracket;   /* ( of arguments, o of operators, [ or { */
  uint64_t words; /* since its last comma */
} sg_text_level;

/* A scan under way. line and column, from 1, are of the fault in the end. */
typedef struct sg_text_scan {
  sg_text_kind kind;
  sg_text_limits most;
  sg_text_fault fault;
  uint64_t line, column;
  sg_text_state state;
  sg_text_state before_escape; /* QUOTED or CHARACTER */
  uint32_t quote, last, left;  /* left: octets of a character to come */
  uint32_t code;               /* what of it is there */
  int base;                    /* of SG_TEXT_CODE */
  bool glued, only_zero, only_digits, star;
  bool in_fact;
  uint64_t word, fact; /* lengths so far */
  uint64_t depth;
  uint64_t top; /* words outside brackets */
  sg_text_level *level;
  size_t n, room;
} sg_text_scan;

const char *sg_text_fault_name(sg_text_fault fault);

void sg_text_scan_open(sg_text_scan *s, sg_text_kind kind,
                       const sg_text_limits *most);
void sg_text_scan_close(sg_text_scan *s);
/* False if the text has a fault, which stays. */
bool sg_text_scan_feed(sg_text_scan *s, const char *bytes, size_t n);

#endif
