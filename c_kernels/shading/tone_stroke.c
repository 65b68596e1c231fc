/* tone_stroke.c -- see tone_stroke.h. */
#include "tone_stroke.h"

#include <math.h>
#include <stdlib.h>

enum { HALVINGS = 16 };

typedef struct walk {
  const sg_shading *scene;
  const sg_looks *looks;
  uint32_t tone;
  double y, step;
  sg_tone_strokes *out;
  bool failed;
} walk;

static bool
is_dark(const walk *w, const sg_span *span, double x)
{
  uint32_t number = sg_face_number(&w->looks->numbers, span->leaf, span->face);
  double depth, normal[3];

  sg_shading_point(w->scene, span, x, w->y, &depth, normal);
  return sg_tone(&w->looks->look[number].tones, normal, NULL) < w->tone;
}

/* What begins where the last one ends goes on. */
static void
add_dark(walk *w, double x1, double x2)
{
  sg_tone_stroke *last = w->out->n > 0 ? &w->out->item[w->out->n - 1] : NULL;

  if (last && last->y == w->y && last->x2 == x1) {
    last->x2 = x2;
  } else if (!SG_PUSH(*w->out, ((sg_tone_stroke){w->y, x1, x2}))) {
    w->failed = true;
  }
}

/* Between x1 and x2 it is dark at one end alone. */
static double
border(const walk *w, const sg_span *span, double x1, double x2, bool dark1)
{
  for (int i = 0; i < HALVINGS; i++) {
    double middle = (x1 + x2) / 2;
    if (is_dark(w, span, middle) == dark1) {
      x1 = middle;
    } else {
      x2 = middle;
    }
  }
  return (x1 + x2) / 2;
}

static void
walk_span(walk *w, const sg_span *span)
{
  double from = span->x1 / 256.0, end = span->x2 / 256.0;

  if (sg_shading_is_flat(w->scene, span)) {
    if (is_dark(w, span, from)) {
      add_dark(w, from, end);
    }
    return;
  }
  double parts = ceil((end - from) / w->step), x1 = from;
  bool dark1 = is_dark(w, span, from);

  for (double i = 1; i <= parts && !w->failed; i++) {
    double x2 = i < parts ? from + (end - from) * i / parts : end;
    bool dark2 = is_dark(w, span, x2);
    double at = dark1 == dark2 ? x2 : border(w, span, x1, x2, dark1);

    if (dark1) {
      add_dark(w, x1, at);
    }
    if (dark2 && at < x2) {
      add_dark(w, at, x2);
    }
    x1 = x2;
    dark1 = dark2;
  }
}

sg_shading_end
sg_tone_strokes_of(const sg_shading *scene, const sg_looks *looks,
                   double spacing, uint32_t tone, double step,
                   const sg_cancel *cancel, sg_tone_strokes *out)
{
  walk w = {
      .scene = scene, .looks = looks, .tone = tone, .step = step, .out = out};
  double height = sg_shading_frame_of(scene)->height;
  sg_spans spans = {0};
  sg_shading_work *work = sg_shading_work_open(scene, NULL);
  bool stopped = false;

  w.failed = !work;
  for (double k = 0.5; !w.failed && !stopped && k * spacing < height; k++) {
    w.y = k * spacing;
    w.failed = !sg_shading_line(scene, work, w.y, &spans);
    for (size_t i = 0; !w.failed && i < spans.n; i++) {
      walk_span(&w, &spans.span[i]);
    }
    stopped = sg_cancelled(cancel);
  }
  free(spans.span);
  if (work) {
    sg_shading_work_close(work);
  }
  return w.failed  ? SG_SHADING_NO_MEMORY
         : stopped ? SG_SHADING_STOPPED
                   : SG_SHADING_GOOD;
}
