// Lines that the rules that are tried took away, where they were before.

import { nameIn, partPath } from "./picture.js";

// Those of `names` that another picture of the same view has, where they are in this
// one, which is looked at with them if it is `whole`.
export function ghost(picture, other, names, whole) {
  if (!picture.shown?.place || !other.place) return;
  const [[s0, x0, y0, l0, t0], [s1, x1, y1, l1, t1]] = [other.place, picture.shown.place];
  const moved = (n, i) => (i % 2 ? t1 + (y1 - y0) * s1 + (n - t0) * s1 / s0 : l1 + (x0 - x1) * s1 + (n - l0) * s1 / s0);
  let d = "", [left, top] = [0, 0], [right, bottom] = picture.shown.sheet;
  for (const { points, ...stroke } of other.strokes) {
    const went = (edge) => names.has(nameIn(stroke, edge));
    if (!stroke.edges.some(went)) continue;
    const there = { ...stroke, points: Array.from(points, moved) };
    d += partPath(there, went);
    const box = picture.around([there]);
    [left, top, right, bottom] = [Math.min(left, box[0]), Math.min(top, box[1]), Math.max(right, box[2]), Math.max(bottom, box[3])];
  }
  picture.layers.gone.setAttribute("d", d);
  if (whole) picture.look(left, top, right - left, bottom - top);
}
