// The way of a plotter's pens: its order, its length, and how long it takes.

import { s } from "./dom.js";
import { w } from "./words.js";

// Millimetres a second, drawing and lifted; seconds to lift and lower a pen once.
const SPEED = 200;
const LIFTED = 400;
const LIFT = 0.1;

const length = (points) => {
  let sum = 0;
  for (let i = 2; i < points.length; i += 2) sum += Math.hypot(points[i] - points[i - 2], points[i + 1] - points[i - 1]);
  return sum / 1000;
};

// What each pen does: { pen, colour, strokes, drawn, lifted, lifts, seconds }.
export function penSums(pens, strokes, high) {
  let at = [0, high], i = 0;
  return pens.map(({ pen, colour, strokes: many }) => {
    const sums = { pen, colour, strokes: many, drawn: 0, lifted: 0, lifts: 0 };
    at = [0, high];
    for (const last = i + many; i < last; i++) {
      const { points } = strokes[i];
      const lifted = Math.hypot(points[0] - at[0], points[1] - at[1]) / 1000;
      if (lifted) sums.lifts += 1;
      sums.lifted += lifted;
      sums.drawn += length(points);
      at = points.slice(-2);
    }
    sums.seconds = sums.drawn / SPEED + sums.lifted / LIFTED + sums.lifts * LIFT;
    return sums;
  });
}

const minutes = (seconds) => `${Math.floor(seconds / 60)}:${String(Math.round(seconds % 60)).padStart(2, "0")}`;

// Shows what is drawn up to port.along of the way, and the lifted way there.
export function penShown(port, { head }) {
  if (!head.pens || !port.picture.shown) return;
  const { strokes, sheet } = port.picture.shown;
  const sums = penSums(head.pens, strokes, sheet[1]);
  const whole = sums.reduce((sum, { drawn, lifted }) => sum + drawn + lifted, 0);
  let left = whole * port.along, i = 0, air = "", at;
  const paths = sums.map(() => "");
  sums.forEach(({ strokes: many }, pen) => {
    at = [0, sheet[1]];
    for (const last = i + many; i < last; i++) {
      const { points } = strokes[i];
      if (left <= 0) continue;
      left -= Math.hypot(points[0] - at[0], points[1] - at[1]) / 1000 + length(points);
      if (port.along < 1) air += `M${at.join(" ")}L${points[0]} ${points[1]}`;
      paths[pen] += `M${points[0]} ${points[1]}L` + points.slice(2).join(" ");
      at = points.slice(-2);
    }
  });
  port.picture.lines.replaceChildren(s("path", { class: "lifted", d: air }),
    ...paths.map((d, pen) => s("path", { class: `pen pen${pen % 4}`, d })),
    s("path", { class: "edge", d: `M0 0H${sheet[0]}V${sheet[1]}H0Z` }));
  const all = (key) => sums.reduce((sum, one) => sum + one[key], 0);
  port.told = w("pen_sums", sums.length, all("strokes"), (all("drawn") / 1000).toFixed(2),
    (all("lifted") / 1000).toFixed(2), minutes(all("seconds")));
  const each = sums.map(({ pen, strokes: many, drawn, lifted, seconds }) =>
    w("pen_sum", pen, many, (drawn / 1000).toFixed(2), (lifted / 1000).toFixed(2), minutes(seconds))).join("\n");
  port.remarks(port.told, port.told + "\n" + each, "ⓘ");
  port.canvas.setAttribute("aria-label", port.told + ". " + each);
}
