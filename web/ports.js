// View ports: each shows one picture of the document, and fills itself.

import { h, calm, say } from "./dom.js";
import { w, said, reworded } from "./words.js";
import { Picture, strokesOf, laidOf, named, nameOf } from "./picture.js";
import { KINDS, kindOf, kindsOf } from "./kinds.js";
import { spaceOf } from "./space.js";
import { Lost, textOf } from "./wire.js";

const PICTORIAL = [315, 54.735610317245346];
const USUAL = { projection: "parallel", up: "z", lines: "feature" };
const TOO_SMALL = "usage_error.sheet";
// Where there is room for one port at a time.
const PHONE = "(max-width: 520px), (max-height: 480px)";
const SLOW = 40;          // ms: exact pictures that take longer do not turn well

class Port {
  // `said` is what link() made, or a kind alone.
  constructor(studio, said, place) {
    const [kind, angles] = said.split("@");
    this.studio = studio;
    this.name = "p" + place;
    this.picture = new Picture();
    this.under = null;
    this.pointed = "";
    this.settings = {};
    this.tools = h("span", { class: "tools" });
    this.image = h("img", { alt: "", hidden: true, draggable: "false" });
    this.choice = h("select", { onchange: () => this.turnTo(this.choice.value) },
      ...kindsOf(studio).map((key) => h("option", { value: key, "data-word": key })));
    this.choice.dataset.label = "view";
    this.remark = h("span", { class: "remark" });
    this.note = h("p", { class: "note", role: "status", hidden: true });
    this.more = h("button", { class: "large", hidden: true, "aria-expanded": "false", "data-label": "details",
      onclick: () => this.tell(this.note.hidden ? this.whole : "") });
    this.canvas = h("div", { class: "canvas", tabindex: 0, role: "img" }, this.image, this.picture.svg);
    this.showing = h("button", { class: "large", "aria-pressed": "false", "data-word": "show_all",
      onclick: () => studio.ports.showAll(this) });
    this.large = h("button", { class: "large", "aria-pressed": "false", "data-label": "larger",
      onclick: () => studio.ports.enlarge(this) }, "⤢");
    this.count = h("span", { class: "remark" });
    const step = (word, by, sign) => h("button", { class: "large", "data-label": word, onclick: () => studio.ports.next(by) }, sign);
    const steps = h("span", { class: "steps" }, step("previous_port", -1, "‹"), this.count, step("next_port", 1, "›"));
    this.element = h("figure", { class: "port" },
      h("figcaption", {}, this.choice, this.tools, this.more, this.remark, this.showing, steps, this.large), this.canvas, this.note);
    this.kind = KINDS.includes(kind) ? kind : "iso";
    this.choice.value = this.kind;
    this.tooled();
    this.angles = angles?.split(",").map(Number) || [];
    if (this.angles.length !== 2 || !this.angles.every(Number.isFinite)) this.angles = [...PICTORIAL];
    this.unscaled();
    this.turning = null;
    this.took = 0;
    this.listen();
  }

  listen() {
    const { canvas } = this;
    canvas.addEventListener("pointerdown", (event) => this.pressed(event));
    canvas.addEventListener("pointermove", (event) => this.moved(event));
    canvas.addEventListener("pointerup", (event) => this.released(event));
    canvas.addEventListener("pointercancel", () => { clearTimeout(this.held); this.fingers.clear(); this.drag = null; });
    canvas.addEventListener("touchend", (event) => this.lifted(event));
    canvas.addEventListener("pointerleave", () => this.pointAt(null));
    canvas.addEventListener("wheel", (event) => this.wheeled(event), { passive: false });
    canvas.addEventListener("dblclick", (event) => this.doubled(event));
    canvas.addEventListener("keydown", (event) => this.keyed(event));
    this.fingers = new Map();
    // The size that it was drawn in last is said too, when it begins.
    const sized = calm(60, () => { if (String(this.size) !== String([canvas.clientWidth, canvas.clientHeight])) this.refresh(); });
    new ResizeObserver(() => sized()).observe(canvas);
  }

  get turns() {
    return Boolean(kindOf(this.kind).turns);
  }

  get alone() {
    return Boolean(kindOf(this.kind).alone);
  }

  get slow() {
    return Boolean(kindOf(this.kind).slow);
  }

  link() {
    return this.turns && String(this.angles) !== String(PICTORIAL)
      ? `${this.kind}@${this.angles.map((angle) => Number(angle.toFixed(2)))}` : this.kind;
  }

  turnTo(kind) {
    this.kind = kind;
    this.choice.value = kind;
    this.unscaled();
    this.after = null;
    this.said = "";
    this.told = "";
    this.angles = [...PICTORIAL];
    this.tooled();
    this.refresh();
    this.studio.keep();
  }

  // What stands beside the choice.
  tooled() {
    this.retooled();
    this.element.dataset.kind = this.kind;
    this.choice.hidden = this.alone;
    this.showing.hidden = !this.studio.teaches || this.alone || this.kind === "folded";
    if (this.showing.hidden && this.studio.ports?.shown === this) this.studio.ports.showAll(this);
    this.canvas.classList.add("empty");
    this.canvas.setAttribute("aria-label", w(this.kind));
  }

  // The same anew; the keyboard stays where it is.
  retooled() {
    const { tools } = kindOf(this.kind);
    const items = () => [...this.tools.querySelectorAll("input, select")];
    const at = items().indexOf(document.activeElement);
    this.tools.replaceChildren(...(tools ? tools(this) : []));
    reworded(this.tools);
    items()[at]?.focus();
  }

  set(key, value) {
    this.settings[key] = value;
    this.tooled();
    this.refresh();
  }

  // One request is under way; what is asked meanwhile waits, and the newest wins.
  refresh() {
    if (this.slow) this.whenQuiet();
    else this.draw();
  }

  // Patterns may take seconds: they come when nothing else is wanted, and whoever
  // asks for something meanwhile stops them.
  whenQuiet = calm(400, () => {
    if (!this.slow) return;
    const { ports, recording } = this.studio;
    if (recording || ports.ports.some((port) => port !== this && port.busy)) this.whenQuiet();
    else this.draw();
  });

  async draw() {
    const { clientWidth, clientHeight } = this.canvas;
    if (!(this.studio.ready || this.alone) || clientWidth < 24 || clientHeight < 24) return;
    if (this.busy) {
      this.again = true;
      return;
    }
    this.busy = true;
    this.size = [clientWidth, clientHeight];
    this.element.classList.toggle("late", this.slow);
    const { kind } = this;
    const turns = this.turning?.turns;
    const { wire, ports } = this.studio;
    try {
      wire.extra = ports.shown === this ? { shown: true } : {};
      const asked = kindOf(kind).ask(this, clientWidth, clientHeight);
      wire.extra = {};
      const reply = await asked;
      if (kind !== this.kind) this.again = true;
      else if (!reply.head.replaced) this.show(reply);
      if (turns === this.turning?.turns) this.turning?.leave();
    } catch (error) {
      if (error.message === "interrupted" || this.wider(error)) this.again = true;
      else if (!(error instanceof Lost || error.message === "request_error.session_ended")) this.failed(error);
    }
    this.busy = false;
    this.element.classList.remove("late");
    if (this.again) {
      this.again = false;
      this.refresh();
    }
  }

  show(reply) {
    const { head } = reply;
    this.before = this.picture.shown;
    this.canvas.classList.remove("empty");
    this.element.classList.toggle("flat", ["unfold", "sheet", "problem"].includes(this.kind));
    this.element.dataset.rev = head.rev;
    this.under = null;
    this.pointed = "";
    this.remark.title = "";
    this.more.hidden = true;
    this.tell("");
    this.image.hidden = head.kind !== "png";
    if (head.kind === "png") this.showImage(reply);
    else if (head.kind === "fold") this.showFolding(reply);
    else this.showStrokes(reply);
    const warnings = (head.messages || []).filter(({ kind }) => kind === "warning").map(said);
    if (warnings.length) this.remarks(warnings[0].split("\n")[0], warnings.join("\n"), "⚠");
  }

  // A remark, and what more there is to say of it: by a key of its own, since the
  // remark may be cut short.
  remarks(text, whole, sign) {
    this.remark.textContent = text;
    this.remark.title = whole;
    this.whole = whole;
    this.more.textContent = sign;
    this.more.hidden = false;
  }

  // A text over the picture; none: "".
  tell(text) {
    this.note.textContent = text;
    this.note.hidden = !text;
    this.more.setAttribute("aria-expanded", String(Boolean(text)));
  }

  showStrokes(reply) {
    const { head } = reply;
    const strokes = strokesOf(reply);
    this.picture.show(strokes, spaceOf(this, strokes.place)?.where);
    this.took = head.ms ?? 0;
    const { fits } = kindOf(this.kind);
    if (fits && !this.zoomed) this.picture.fit(fits === "bar" ? fits : null);
    if (this.zoomed) {
      this.stays();
      this.picture.look(...this.zoomed);
    }
    const [lines, hidden] = this.picture.counts();
    this.describe(w("drawing", w(this.kind), lines, hidden));
    this.remark.textContent = this.said || head.called || (head.ms === undefined ? "" : w("ms", head.ms < 10 ? head.ms.toFixed(1) : Math.round(head.ms)));
    if (this.after) this.after();
    this.haunt();
    this.studio.handles?.draw(this);
  }

  // Lines that the rules that are tried took away, where they were before.
  haunt() {
    this.picture.ghost(null);
    if (this.studio.ports.went.size && kindOf(this.kind).before) this.haunted();
  }

  haunted = calm(60, async () => {
    const { shown } = this.picture;
    const { before } = kindOf(this.kind);
    if (!shown || !before) return;
    try {
      const reply = await before(this, ...this.size);
      if (shown === this.picture.shown && !reply.head.replaced) this.picture.ghost(strokesOf(reply), this.studio.ports.went);
    } catch (error) {
      if (error.message !== "interrupted") this.picture.ghost(null);
      else this.haunted();
    }
  });

  describe(text) {
    this.canvas.setAttribute("aria-label", text + (this.turns ? ". " + w("turn") : ""));
  }

  showImage({ head, body }) {
    this.picture.clear();
    URL.revokeObjectURL(this.image.src);
    this.image.src = URL.createObjectURL(new Blob([body], { type: "image/png" }));
    this.remark.textContent = w("ms", Math.round(head.ms));
    this.describe(w("shaded_picture", this.studio.file));
    if (this.coarse && !this.drag) this.refresh();
  }

  showFolding({ head, body }) {
    this.picture.clear();
    this.folding.read(textOf(body), laidOf(head));
    this.remark.textContent = this.folding.folds ? "" : w("no_folds");
    this.describe(w("folded_of", this.folding.faces.length));
  }

  // A picture that the page makes itself.
  redraw() {
    const { clientWidth, clientHeight } = this.canvas;
    if (this.kind !== "folded" || !this.folding?.faces) return;
    this.folding.draw(this.picture.own(), this.angles, clientWidth, clientHeight, this.picture.lit);
  }

  near(event, within = 9) {
    if (this.kind !== "folded") return this.picture.near(event.clientX, event.clientY, within);
    const box = this.canvas.getBoundingClientRect();
    return this.folding?.near([event.clientX - box.x, event.clientY - box.y], within);
  }

  // No picture is better than that of before.
  failed(error) {
    this.canvas.classList.add("empty");
    this.picture.clear();
    this.image.hidden = true;
    this.more.hidden = true;
    this.remark.textContent = "";
    this.tell(error.head ? said(error.head.error) : String(error));
  }

  // --- pointing ---

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
      this.pointAt(found, found || this.kind !== "unfold" ? [] : this.picture.pieceAt(event.clientX, event.clientY));
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
    this.studio.chosen(found ? [found.name] : [], this, found && found.role);
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
    if (!this.picture.shown) return;
    const { a } = this.picture.svg.getScreenCTM();
    const [x, y, width, height] = this.picture.box;
    this.zoom(x - dx / a, y - dy / a, width, height);
  }

  zoom(...box) {
    if (!this.zoomed) this.seen = [this.kind, ...this.angles].join();
    this.keepScale();
    this.zoomed = box;
    this.picture.look(...box);
  }

  closer(factor, clientX, clientY) {
    if (!this.picture.shown) return;
    const p = new DOMPoint(clientX, clientY).matrixTransform(this.picture.svg.getScreenCTM().inverse());
    const [x, y, width, height] = this.picture.box;
    const full = this.picture.shown.sheet[0];
    if (width * factor > full * 4 || width * factor < full / 200) return;
    this.zoom(p.x - (p.x - x) * factor, p.y - (p.y - y) * factor, width * factor, height * factor);
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
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    if (event.key === "Enter" && !this.walking) this.walk(0);
    else if (event.key === "Enter") this.studio.chosen([this.under.name], this);
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
    if (!this.picture.shown) return;
    const strokes = named(this.picture.shown);
    if (!strokes.length) return;
    this.at = step ? (this.at + step + strokes.length) % strokes.length : 0;
    this.walking = true;
    const stroke = strokes[this.at];
    const edge = stroke.edges[0];
    const name = nameOf(stroke.segment, edge);
    this.pointAt({ stroke, edge, segment: stroke.segment, name });
    say(`${w("line", name)}, ${this.picture.shown.looks[stroke.look].join(", ")}`);
  }

  unwalk() {
    this.walking = false;
    this.pointAt(null);
  }
}

// The colour monitor: all ports.
export class Ports {
  constructor(studio, element) {
    this.studio = studio;
    this.element = element;
    this.went = new Set();
    this.make(studio.link.get("ports")?.split(";").slice(0, 6) || JSON.parse(localStorage.getItem("ports") || "null")
      || ["iso", "unfold", "top", "front", "right"]);
  }

  make(kinds) {
    this.ports = kinds.map((kind, i) => new Port(this.studio, kind, i));
    this.element.replaceChildren(...this.ports.map((port) => port.element));
    this.element.dataset.count = this.ports.length;
    for (const [i, port] of this.ports.entries()) port.count.textContent = `${i + 1}/${kinds.length}`;
    this.only(null);
    reworded(this.element);
  }

  // As many ports: the first of those that are there, then kinds that are not.
  many(count) {
    const kinds = [...new Set([...this.ports.map((port) => port.kind), ...KINDS])];
    if (this.shown) this.showAll(this.shown);
    this.make(kinds.slice(0, count));
    this.fitted();
    this.kept();
    this.refresh();
  }

  refresh() {
    for (const port of this.ports) port.refresh();
  }

  // Not in the port `but`, which shows it itself.
  light(layer, names, ends, but) {
    const set = new Set(names);
    for (const port of this.ports) {
      if (port === but) continue;
      port.picture.light(layer, set, ends);
      port.redraw();
    }
  }

  // Whether each of these edges has a line wherever that would be.
  draws(names) {
    return this.ports.every(({ picture }) => !picture.shown || !picture.where || names.every((name) => picture.draws(name)));
  }

  // One port alone, as large as all; none: all of them.
  only(port) {
    this.one = port;
    this.element.classList.toggle("one", Boolean(port));
    for (const other of this.ports) {
      other.element.classList.toggle("alone", other === port);
      other.large.setAttribute("aria-pressed", String(other === port));
    }
  }

  enlarge(port) {
    this.only(port === this.one ? null : port);
    localStorage.setItem("shows", this.one ? "one" : "all");
    port.canvas.focus();
  }

  // A phone shows one port, unless its reader wanted all.
  fitted() {
    if (!this.one && matchMedia(PHONE).matches && localStorage.getItem("shows") !== "all") this.only(this.ports[0]);
  }

  // A port that all others see, until it is chosen again.
  showAll(port) {
    this.shown = port === this.shown ? null : port;
    for (const one of this.ports) one.showing.setAttribute("aria-pressed", String(one === this.shown));
    if (this.shown) this.shown.refresh();
    else this.studio.wire.ask("show").catch((error) => this.studio.failed(error));
  }

  // Lines that went, where they were.
  ghost(names) {
    this.went = new Set(names);
    for (const port of this.ports) if (port.picture.shown) port.haunt();
  }

  next(by = 1) {
    const { length } = this.ports;
    const at = this.ports.findIndex((port) => port === this.one || port.element.contains(document.activeElement));
    const port = this.ports[(at + by + length) % length];
    if (this.one) this.only(port);
    port.canvas.focus();
  }

  focused() {
    return this.ports.find((port) => port.element.contains(document.activeElement)) || this.one || this.ports[0];
  }

  kept() {
    localStorage.setItem("ports", JSON.stringify(this.ports.map((port) => port.kind)));
  }
}
