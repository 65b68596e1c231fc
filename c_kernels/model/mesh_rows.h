/* mesh_rows.h -- the rows of a part of a mesh, written in place.
 *
 * Layer: kernel. A page of a sheet at a time. Ids are dense, from 1: vertices
 * as in the part, edges as in the part and real; polygon i has the edges of
 * face i, one after another.
 */
#ifndef SG_MESH_ROWS_H
#define SG_MESH_ROWS_H

#include "mesh_part.h"
#include "sheet.h"

/* v/5, e/5 and p/3 of segment s. The lists of p/3 have room for the lengths
 * that sg_mesh_rows_lengths() gave: [page->n]. */
void sg_mesh_rows_vertices(const sg_mesh *mesh, const sg_mesh_part *part,
                           int32_t s, const sg_sheet_page *page);
void sg_mesh_rows_edges(const sg_mesh_part *part, int32_t s,
                        const sg_sheet_page *page);
void sg_mesh_rows_lengths(const sg_mesh_part *part, const sg_sheet_page *page,
                          int32_t *length);
void sg_mesh_rows_polygons(const sg_mesh_part *part, int32_t s,
                           const sg_sheet_page *page);

#endif
