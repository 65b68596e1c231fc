// What is done in a port by a pointer, fingers and keys.

import { say } from "./dom.js";
import { w } from "./words.js";
import { nameIn } from "./picture.js";
import { named } from "./nearest.js";
import { Sight } from "./sight.js";

export class Pointing extends Sight {
  // `piece` are the edges of what is cut out there, if no line is.
  pointAt(found, piece = []) {
    const under = found ? found.name : piece.join();
    if (under === this.pointed) return;
    this.pointed = under;
    this.under = found;
    if (this.kind === "folded") this.picture.lit.hover = new Set(found ? [found.name] : []);
    else this.picture.hover(found);
    this.redraw();
    this.canvas.classList.toggle("pointing", Boolean(found));
    // In a pattern both sides of a seam are lit.
    const both = this.kind === "unfold" && !found?.stroke.whole;
    this.studio.hovered(both ? null : this, found ? [found.name] : piece);
  }

  pressed(event) {
    this.canvas.focus({ preventScroll: true });
    this.canvas.setPointerCapture(event.pointerId);
    this.fingers.set(event.pointerId, [event.clientX, event.clientY]);
    this.drag = { x: event.clientX, y: event.clientY, moved: false,
      pans: !this.turns || event.shiftKey || event.button === 1 };
    clearTimeout(this.held);
    if (event.pointerType === "touch") this.held = setTimeout(() => this.pressedLong(event), 600);
  }

  // A finger that stays asks, as a double click does.
  pressedLong(event) {
    const found = !this.drag?.moved && this.fingers.size === 1 && this.kind !== "taught" && this.near(event, 22);
    if (!found) return;
    this.drag = null;
    this.asked = true;
    this.studio.askAbout(found.name);
  }

  // Else the keyboard came back here with the mouse that a finger stands for.
  lifted(event) {
    if (this.asked) event.preventDefault();
    this.asked = false;
  }

  moved(event) {
    if (!this.drag) {
      const found = this.near(event);
      this.pointAt(found, found || this.kind !== "unfold" || !this.names ? [] : this.picture.pieceAt(event.clientX, event.clientY));
      return;
    }
    if (this.fingers.size === 2) {
      this.pinched(event);
      return;
    }
    const dx = event.clientX - this.drag.x;
    const dy = event.clientY - this.drag.y;
    if (!this.drag.moved && Math.hypot(dx, dy) < 4) return;
    Object.assign(this.drag, { x: event.clientX, y: event.clientY, moved: true });
    if (this.drag.pans) this.pan(dx, dy);
    else this.turn(-dx * 0.45, -dy * 0.45);
  }

  released(event) {
    clearTimeout(this.held);
    this.fingers.delete(event.pointerId);
    const { drag } = this;
    this.drag = null;
    if (!drag) return;
    if (drag.moved) {
      this.studio.keep();
      if (this.kind === "shaded") this.refresh();
      return;
    }
    if (this.kind === "shaded") {
      this.pixel(event);
      return;
    }
    if (this.kind === "taught") return;
    const found = this.near(event, event.pointerType === "touch" ? 22 : 9);
    this.choose(found, event);
  }

  // With Ctrl one more is chosen, or one less.
  choose(found, { ctrlKey, metaKey }) {
    const { names } = this.studio, name = found?.name;
    if (!ctrlKey && !metaKey) this.studio.chosen(found ? [name] : [], this, found?.role);
    else if (found) this.studio.chosen(names.includes(name) ? names.filter((one) => one !== name) : [...names, name], this, found.role);
  }

  // Why a dot of a shaded picture has its colour.
  pixel(event) {
    const box = this.canvas.getBoundingClientRect();
    const [x, y] = [event.clientX - box.x, event.clientY - box.y].map((n, i) =>
      Math.max(0, Math.min(this.dots[i] - 1, Math.floor(n * this.dots[i] / [box.width, box.height][i]))));
    this.studio.why.item(`pixel(${x}, ${y})`, this.words);
  }

  doubled(event) {
    const found = this.kind !== "taught" && this.near(event);
    if (found) this.studio.askAbout(found.name);
    else this.fit();
  }

  wheeled(event) {
    event.preventDefault();
    this.closer(Math.exp(Math.max(-60, Math.min(60, event.deltaY)) / 300), event.clientX, event.clientY);
  }

  pinched(event) {
    const before = [...this.fingers.values()];
    this.fingers.set(event.pointerId, [event.clientX, event.clientY]);
    const after = [...this.fingers.values()];
    const wide = ([[ax, ay], [bx, by]]) => Math.hypot(ax - bx, ay - by);
    this.drag.moved = true;
    this.closer(wide(before) / Math.max(1, wide(after)),
      (after[0][0] + after[1][0]) / 2, (after[0][1] + after[1][1]) / 2);
  }

  // --- keys: turning, and going from line to line ---

  keyed(event) {
    const arrow = { ArrowLeft: [5, 0], ArrowRight: [-5, 0], ArrowUp: [0, 5], ArrowDown: [0, -5] }[event.key];
    if (event.altKey || ((event.ctrlKey || event.metaKey) && event.key !== "Enter")) return;
    const under = this.walking && this.under;         // none, if another picture came meanwhile
    if (event.key === "Enter" && !under) this.walk(0);
    else if (event.key === "Enter") this.choose(under, event);
    else if (event.key === "Escape" && this.walking) this.unwalk();
    else if (arrow && this.walking) this.walk(arrow[0] < 0 || arrow[1] < 0 ? 1 : -1);
    else if (arrow) this.turn(...arrow);
    else if (event.key === "0") this.fit();
    else if ("+-".includes(event.key)) {
      const box = this.canvas.getBoundingClientRect();
      this.closer(event.key === "+" ? 0.8 : 1.25, box.x + box.width / 2, box.y + box.height / 2);
    } else return;
    event.preventDefault();
    event.stopPropagation();
  }

  walk(step) {
    if (!this.picture.shown || !this.names) return;
    const strokes = named(this.picture.shown);
    if (!strokes.length) return;
    this.at = step ? (this.at + step + strokes.length) % strokes.length : 0;
    this.walking = true;
    const stroke = strokes[this.at];
    const edge = stroke.edges[0];
    const name = nameIn(stroke, edge);
    this.pointAt({ stroke, edge, segment: stroke.segment, name });
    say(`${w("line", name)}, ${this.picture.shown.looks[stroke.look].join(", ")}`);
  }

  unwalk() {
    this.walking = false;
    this.pointAt(null);
  }
}
