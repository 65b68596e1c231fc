/* contact.h -- where two triangles touch up to rounding.
 *
 * Layer: kernel. A contact is a pair of features (cut.h) nearer to each other
 * than `reach`, the smallest that are: corner and corner, corner and edge,
 * edge and edge, corner and face. Found in doubles; whether it is a contact
 * without any tolerance is decided exactly.
 */
#ifndef SG_CONTACT_H
#define SG_CONTACT_H

#include "cut.h"

typedef struct sg_contact {
  sg_feature f[2]; /* of the first, of the second triangle */
  double distance; /* between them, at most reach */
  double at[3];    /* for two edges: half way between them */
  bool exact;      /* they touch as they are */
} sg_contact;

enum { SG_CONTACT_MAX = 24 };

/* The contacts of triangles a and b, each pair of features once. Returns how
 * many: none of a triangle with a side shorter than 4 times the reach. If all
 * are exact, nothing has to move: where the triangles lie on each other, the
 * corners of what they have in common are contacts, and three that are exact
 * make the planes one. Requires reach > 0 and finite. */
int sg_contacts(const double a[3][3], const double b[3][3], double reach,
                sg_contact out[SG_CONTACT_MAX]);

/* The same contacts, of which `exact` is decided of two corners only: else it
 * is false. */
int sg_contacts_near(const double a[3][3], const double b[3][3], double reach,
                     sg_contact out[SG_CONTACT_MAX]);

/* The smallest feature of triangle b within reach of a point, of which only
 * f[1], distance and at are set; false: there is none. */
bool sg_contact_point(const double point[3], const double b[3][3], double reach,
                      sg_contact *out);

#endif
