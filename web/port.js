// A view port: it shows one picture of the document, and fills itself.

import { h, calm } from "./dom.js";
import { w, said, reworded } from "./words.js";
import { Picture, strokesOf, laidOf } from "./picture.js";
import { KINDS, SHEET_SHOWS, kindOf, kindsOf } from "./kinds.js";
import { spaceOf } from "./space.js";
import { Lost, textOf } from "./wire.js";
import { Pointing } from "./pointing.js";
import { PICTORIAL } from "./sight.js";

export class Port extends Pointing {
  // `said` is what link() made, or a kind alone.
  constructor(studio, said, place) {
    super();
    const [kind, angles] = said.split("@");
    this.studio = studio;
    this.name = "p" + place;
    this.picture = new Picture();
    this.under = null;
    this.pointed = "";
    this.settings = { ...SHEET_SHOWS };
    this.tools = h("span", { class: "tools" });
    this.choice = h("select", { onchange: () => this.turnTo(this.choice.value) },
      ...kindsOf(studio).map((key) => h("option", { value: key, "data-word": key })));
    this.choice.dataset.label = "view";
    this.remark = h("span", { class: "remark" });
    this.note = h("p", { class: "note", role: "status", hidden: true });
    this.more = h("button", { class: "large", hidden: true, "aria-expanded": "false", "data-label": "details",
      onclick: () => this.tell(this.note.hidden ? this.whole : "") });
    this.canvas = h("div", { class: "canvas", tabindex: 0, role: "img" }, this.picture.svg);
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
    // The size that it was drawn in last is told too, when it begins.
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
    if (!(this.studio.ready || this.alone) || clientWidth < 24 || clientHeight < 24) {
      this.size = null;
      return;
    }
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
    this.canvas.classList.remove("empty");
    this.element.classList.toggle("flat", ["unfold", "sheet", "problem"].includes(this.kind));
    this.element.dataset.rev = head.rev;
    this.rev = head.rev;
    this.under = null;
    if (this.pointed) this.studio.hovered(null, []);        // what was pointed at was of the picture before
    this.pointed = "";
    this.remark.title = "";
    this.more.hidden = true;
    this.tell("");
    if (head.kind === "png") this.showImage(reply);
    else {
      this.picture.paint();
      if (head.kind === "fold") this.showFolding(reply);
      else this.showStrokes(reply);
    }
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
    this.before = this.picture.shown;
    this.picture.show(strokes, spaceOf(this, strokes));
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
    this.picture.layers.gone.setAttribute("d", "");
    if (this.studio.ports.went.size && kindOf(this.kind).before) this.haunted();
  }

  haunted = calm(60, async () => {
    const { shown } = this.picture;
    const { before } = kindOf(this.kind);
    if (!shown || !before || !this.size) return;
    try {
      const [reply, { ghost }] = [await before(this, ...this.size), await import("./ghost.js")];
      if (shown === this.picture.shown && !reply.head.replaced) ghost(this.picture, strokesOf(reply), this.studio.ports.went, !this.zoomed);
    } catch (error) {
      if (error.message === "interrupted") this.haunted();
    }
  });

  describe(text) {
    this.canvas.setAttribute("aria-label", text + (this.turns ? ". " + w("turn") : ""));
  }

  // `box`: where it lies among lines that were shown before, if there are any.
  showImage({ head, body, box }) {
    if (!box) {
      this.picture.clear();
      this.picture.look(0, 0, ...this.size);
    }
    this.picture.paint(body, box);
    this.remark.textContent = w("ms", Math.round(head.ms));
    this.describe(w("shaded_picture", this.studio.file));
    if (this.coarse && !this.drag) this.refresh();
  }

  showFolding(reply) {
    this.picture.clear();
    const { laid, rest } = laidOf(reply);
    this.folding.read(textOf(new Uint8Array(reply.body, rest)), laid);
    this.remark.textContent = this.folding.folds ? "" : w("no_folds");
    this.describe(w("folded_of", this.folding.faces.length));
  }

  // A picture that the page makes itself.
  redraw() {
    const { clientWidth, clientHeight } = this.canvas;
    if (this.kind !== "folded" || !this.folding?.faces) return;
    this.folding.draw(this.picture, this.angles, clientWidth, clientHeight, this.picture.lit);
  }

  // Its names are those of the model, and not those of one before.
  get names() {
    return this.alone || this.studio.record || this.rev === this.studio.rev;
  }

  near(event, within = 9) {
    if (!this.names) return null;
    if (this.kind !== "folded") return this.picture.near(event.clientX, event.clientY, within);
    const box = this.canvas.getBoundingClientRect();
    return this.folding?.near([event.clientX - box.x, event.clientY - box.y], within);
  }

  // Nothing of what was shown can be pointed at any more.
  emptied() {
    this.canvas.classList.add("empty");
    this.picture.clear();
    this.folding = null;
    this.more.hidden = true;
    this.remark.textContent = "";
    this.tell("");
  }

  // No picture is better than that of before.
  failed(error) {
    this.emptied();
    this.tell(this.studio.wrong(error));
  }
}
