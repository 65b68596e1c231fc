/* plain_facts_rows.h -- facts of a model file that are plain, many at once.
 *
 * Layer: rows. A fact is plain if it is of a relation whose columns are ids,
 * numbers, lists of ids and words, and each argument is written as one: decimal
 * digits, a lower case word, a list of them; no formula, no sign but `-`.
 * Layout and comments to the end of the line may stand anywhere between. Rows
 * are kept by relation, in the order of the text, and checked by who adds them.
 * What is not plain is left to rules/model/model_text.pl, which reads the same
 * of what is.
 */
#ifndef SG_PLAIN_FACTS_ROWS_H
#define SG_PLAIN_FACTS_ROWS_H

#include "call.h"

/* Column c of n rows; of a list its ids are word[at[i] + 1] .., word[at[i]] of
 * them. */
typedef struct sg_plain_column {
  int32_t *i;
  double *f;
  size_t *at;
  size_t room;
} sg_plain_column;

typedef struct sg_plain_rows {
  size_t n;
  sg_plain_column column[SG_MAX_COLUMNS];
} sg_plain_rows;

typedef struct sg_plain_facts {
  char *text; /* [size], of the whole file */
  size_t size;
  int32_t *word; /* [words] */
  size_t words, word_room;
  sg_plain_rows of[SG_RELATIONS];
} sg_plain_facts;

/* Where a reader is, counted as Prolog counts: characters, and columns, from 0,
 * lines from 1, octets. */
typedef struct sg_text_place {
  int64_t character, line, column, octet;
} sg_text_place;

/* Takes plain facts from `place` on, `most` at most, and leaves `place` at what
 * comes next. `shift` is added to numbers of segments. False: no memory. */
bool sg_plain_facts_take(sg_plain_facts *facts, int32_t shift, size_t most,
                         sg_text_place *place);

void sg_plain_facts_free(sg_plain_facts *facts);

/* Adds the rows of a relation, lists of which are list[i], checked. False: one
 * is wrong, or no memory; some may be there. */
bool sg_plain_rows_add(sg_world *world, const sg_plain_facts *facts,
                       sg_relation relation, const int32_t *const *list);

/* Makes list[i] the edges of polygon i: of a segment without edges it is a list
 * of vertices, the edges of which are made. False: a polygon is wrong, or see
 * call.h. */
bool sg_plain_polygons_ready(sg_call *call, sg_world *world,
                             const sg_plain_facts *facts, const int32_t **list);

#endif
