// From where a port looks, and how close.

import { calm } from "./dom.js";

export const PICTORIAL = [315, 54.735610317245346];
const USUAL = { projection: "parallel", up: "z", lines: "feature" };
const TOO_SMALL = "usage_error.sheet";
const SLOW = 20;          // ms: exact pictures that take longer do not turn well

export class Sight {
  turn(theta, phi) {
    if (!this.turns) return;
    this.angles = [(this.angles[0] + theta + 720) % 360,
      Math.max(0, Math.min(180, this.angles[1] + phi))];
    this.studio.linked();
    if (this.kind === "folded") {
      this.redraw();
      return;
    }
    this.keepScale();
    if (this.turnedByCard()) return;
    this.refresh();
    this.settled();
  }

  // A port fills itself until it is turned, or looked at closer.
  keepScale() {
    const { shown } = this.picture;
    if (!this.scale && shown?.place && this.kind !== "section") this.scale = shown.place[0] / 1000;
  }

  // What was looked at closer stays where it is when the model is another one.
  stays() {
    const [was, now] = [this.before?.place, this.picture.shown.place];
    const seen = [this.kind, ...this.angles].join();
    const same = seen === this.seen;
    this.seen = seen;
    if (!same || !was || !now || Math.abs(was[0] - now[0]) > 1e-6 * now[0]) return;
    const origin = ([scale, x, y, left, top]) => [left - x * scale, top + y * scale];
    const [from, to] = [origin(was), origin(now)];
    this.zoomed[0] += to[0] - from[0];
    this.zoomed[1] += to[1] - from[1];
  }

  // Large models are turned by the graphics card, if it can.
  turnedByCard() {
    const { record, looks } = this.studio;
    if (this.kind !== "iso" || this.took < SLOW || record
      || Object.entries(USUAL).some(([key, word]) => (looks[key] ?? word) !== word)) return false;
    if (!this.loading) {
      this.loading = import("./turning.js").then(({ Turning }) => { this.turning = new Turning(this); });
    }
    return Boolean(this.turning?.turned());
  }

  // The picture that the page turned itself is drawn exactly.
  rests = calm(120, () => {
    this.refresh();
    this.settled();
  });

  unscaled() {
    this.scale = null;
    this.zoomed = null;
    this.room = 1;
  }

  fit() {
    this.unscaled();
    this.refresh();
  }

  // At the scale that is kept the model needs more room than the port: what is
  // looked at closer has it, beyond its edges; else the picture fits again.
  wider(error) {
    if (!this.scale || error.message !== TOO_SMALL) return false;
    if (this.zoomed && this.room < 64) this.room *= 2;
    else this.unscaled();
    return true;
  }

  // At rest the picture fills the port again, if it does not fit.
  settled = calm(180, () => {
    if (this.drag || !this.picture.shown) return;
    const [width, height] = this.picture.shown.sheet;
    const over = this.picture.shown.strokes.some(({ points }) =>
      points.some((n, i) => n < 0 || n > (i % 2 ? height : width)));
    if (over) this.fit();
  });

  pan(dx, dy) {
    const { a } = this.picture.svg.getScreenCTM() || {};
    if (!this.picture.shown || !a) return;
    const [x, y, width, height] = this.picture.box;
    this.zoom(x - dx / a, y - dy / a, width, height);
  }

  zoom(...box) {
    if (!this.zoomed) this.seen = [this.kind, ...this.angles].join();
    this.keepScale();
    this.zoomed = box;
    this.picture.look(...box);
    if (this.kind === "shaded") this.rests();
  }

  closer(factor, clientX, clientY) {
    const p = this.picture.shown && this.picture.at(clientX, clientY);
    if (!p) return;
    const [x, y, width, height] = this.picture.box;
    const full = this.picture.shown.sheet[0];
    if (width * factor > full * 4 || width * factor < full / 200) return;
    this.zoom(p.x - (p.x - x) * factor, p.y - (p.y - y) * factor, width * factor, height * factor);
  }
}
