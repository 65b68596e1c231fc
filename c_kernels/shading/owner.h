/* owner.h -- which one of faces that lie in one another is seen, where a rule
 * says so.
 *
 * Layer: kernel. A walk meets groups of faces of one root. Who makes pictures
 * asks the rule of each group once: groups that were met and have no answer yet
 * are listed, answers are put in, and what was walked is walked again. Until
 * then the first face of a group is seen. Several threads may use them at
 * once.
 */
#ifndef SG_OWNER_H
#define SG_OWNER_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

typedef struct sg_owners sg_owners;

/* A face of a group. */
typedef struct sg_met_face {
  int32_t leaf; /* its number */
  int32_t face;
  size_t slice; /* the caller's own */
} sg_met_face;

/* Faces that lie in one another where a root begins, or ends: two or more, each
 * once, in the order of sg_met_compare(). Borrowed. */
typedef struct sg_met_group {
  int32_t root; /* its segment */
  bool begins;
  const sg_met_face *face; /* [n] */
  size_t n;
} sg_met_group;

/* By leaf, then by face. */
int sg_met_compare(const sg_met_face *a, const sg_met_face *b);

/* Null: no memory. */
sg_owners *sg_owners_open(void);
void sg_owners_close(sg_owners *owners);

/* In *owner which face of a group is seen; a group that is met for the first
 * time is noted. False: no memory. */
bool sg_owner_of(sg_owners *owners, const sg_met_group *group, size_t *owner);

/* The groups that have no answer yet, numbered from 0 in no order: how many. */
size_t sg_owners_asked(sg_owners *owners);

/* Group `i` of these; its faces are written to *face, an array of the caller's
 * that grows (engine/list.h). False: no memory. */
bool sg_owners_group(sg_owners *owners, size_t i, sg_met_face **face,
                     size_t *room, sg_met_group *out);

/* Answers of the first n groups: answer[i] is the face of group i that is seen.
 * Those that follow are numbered from 0 then. False, and nothing has changed:
 * there is no such group or face. */
bool sg_owners_answer(sg_owners *owners, const size_t *answer, size_t n);

#endif
