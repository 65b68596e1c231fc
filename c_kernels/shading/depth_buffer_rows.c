/* depth_buffer_rows.c -- depths and normals of a scene as PFM files. */
#include "depth_buffer.h"
#include "doors/shading.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

typedef struct writing {
  const sg_shading *scene;
  sg_shading_work *work;
  const double *plane; /* null: normals */
  sg_spans spans;
  float *row;
} writing;

/* Numbers with the lowest byte first, whatever the machine. */
static void
put_row(const float *row, size_t n, char *out)
{
  for (size_t i = 0; i < n; i++) {
    uint32_t bits;

    memcpy(&bits, &row[i], sizeof bits);
    for (int k = 0; k < 4; k++) {
      *out++ = (char)(bits >> (8 * k) & 0xff);
    }
  }
}

/* Rows from below, as PFM has them. */
static bool
write_rows(sg_call *call, writing *w, const sg_output *stream)
{
  const sg_shading_frame *frame = sg_shading_frame_of(w->scene);
  size_t n = (size_t)frame->width * (w->plane ? 1 : 3);
  char head[64], *bytes = sg_call_alloc(call, 4 * n);

  w->row = sg_call_alloc(call, n * sizeof *w->row);
  if (!bytes || !w->row) {
    return false;
  }
  int length =
      snprintf(head, sizeof head, "%s\n%d %d\n-1.0\n", w->plane ? "Pf" : "PF",
               (int)frame->width, (int)frame->height);
  bool good = stream->write(stream->data, head, (size_t)length);
  for (int32_t y = frame->height - 1; good && y >= 0; y--) {
    bool made = w->plane ? sg_depth_row(w->scene, w->work, w->plane, y,
                                        &w->spans, w->row)
                         : sg_normal_row(w->scene, w->work, y, &w->spans,
                                         (float(*)[3])(void *)w->row);
    if (!made) {
      return sg_call_no_memory(call);
    }
    if (sg_cancelled(&call->cancel)) {
      return sg_call_ended(call);
    }
    put_row(w->row, n, bytes);
    good = stream->write(stream->data, bytes, 4 * n);
  }
  return good;
}

static bool
write_pfm(sg_call *call, const sg_shading *scene, const double *plane,
          const sg_output *stream)
{
  writing w = {.scene = scene,
               .work = sg_shading_work_open(scene, NULL),
               .plane = plane};

  if (!w.work) {
    return sg_call_no_memory(call);
  }
  bool good = write_rows(call, &w, stream);

  free(w.spans.span);
  sg_shading_work_close(w.work);
  return good;
}

bool
sg_door_shading_depth_pfm(sg_call *call, sg_shading *scene,
                          const sg_number_list *plane, const sg_output *stream)
{
  return plane->n == 4 ? write_pfm(call, scene, plane->at, stream)
                       : sg_call_domain(call, "plane", 2);
}

bool
sg_door_shading_normal_pfm(sg_call *call, sg_shading *scene,
                           const sg_output *stream)
{
  return write_pfm(call, scene, NULL, stream);
}
