// The tree of segments, and the form of one: what the text says, with a slider
// for each number.

import { h } from "./dom.js";
import { reworded, tongue } from "./words.js";
import { Lost } from "./wire.js";

const SIGNS = { union: "∪", intersection: "∩", difference: "−", xor: "⊕", glue: "⊔" };

// named(tee, at(Steps, union([8, 9]))) -> what a row of the tree says.
function summary(term, path = []) {
  if (term && term.name === "named") {
    return { ...summary(term.args[1], [...path, 2]), own: term.args[0] };
  }
  if (term && term.name === "at") {
    return { ...summary(term.args[1], [...path, 2]), placed: term.args[0] };
  }
  return { term, path };
}

// The goal that asks for the numbers of the operands of a segment.
export const childrenOf = (segment) => `node(${segment}, _, Operands, _)`;

const isOperand = (term) => typeof term === "number" || (term && (term.name in SIGNS
  || term.name === "at" || term.name === "named"));

// What a row of the tree opens to: operands, or the segment that is placed.
function operandsOf(term) {
  const { term: inner } = summary(term);
  if (typeof inner === "number" && inner !== term) return [inner];
  return inner && inner.name in SIGNS ? inner.args[0] : [];
}

function label(term) {
  const { term: inner, own } = summary(term);
  if (typeof inner === "number") return own || "→ " + inner;
  return own || (inner && inner.name) || String(inner);
}

export class Tree {
  constructor(studio) {
    this.studio = studio;
    this.list = h("ul", { role: "tree", class: "tree", onkeydown: (event) => this.keyed(event) });
    this.list.dataset.label = "tree";
    this.form = h("div", { class: "form" });
    this.element = h("div", { class: "panel" },
      h("h2", { "data-word": "tree" }), this.list,
      h("h2", { "data-word": "form" }), this.form);
    this.open = new Set();
    this.model = { segments: [], params: [], forms: {} };
    this.sets = [];
  }

  async refresh() {
    try {
      const { head } = await this.studio.wire.ask("tree");
      this.model = head;
      this.studio.saved = head.saved;
      this.sets = this.sets.filter(({ rev }) => !(rev <= head.rev));
      for (const { target, value } of this.sets) this.put(target, value);
    } catch (error) {
      if (error instanceof Lost) return;
      const { segments } = this.studio;
      this.studio.saved = true;
      this.model = { params: [], forms: {}, segments: segments.map(({ segment, kind, name }) =>
        ({ segment, kind, term: name })) };
    }
    this.studio.asking.list(this.model.questions || []);
    this.draw();
  }

  draw() {
    const { segments } = this.model;
    const byNumber = new Map(segments.map((one) => [one.segment, one]));
    const used = new Set();
    const inside = (term) => {
      const { term: inner } = summary(term);
      if (typeof inner === "number" && inner !== term) used.add(inner);
      for (const operand of operandsOf(term)) {
        if (typeof operand === "number") used.add(operand);
        else inside(operand);
      }
    };
    for (const { term } of segments) inside(term);
    this.byNumber = byNumber;
    const roots = segments.filter(({ segment }) => !used.has(segment));
    this.roots = roots.map(({ segment }) => segment);
    if (!this.drawn) for (const { segment } of roots) this.open.add("/" + segment);
    this.drawn = true;
    const held = this.list.contains(document.activeElement) && document.activeElement.dataset.key;
    this.list.replaceChildren(...roots.map(({ segment }) => this.row(segment, "", 1)));
    if (held) this.focus(held);
    this.drawForm();
    reworded(this.element);
    this.studio.pulls(this.segment).catch((error) => this.studio.failed(error));
  }

  // Another model is opened: nothing is chosen there.
  forget() {
    this.segment = undefined;
    this.key = undefined;
    this.open.clear();
    this.drawn = false;
  }

  unfoldable() {
    return this.studio.segments.filter(({ unfolds }) => unfolds).map(({ segment }) => segment);
  }

  called(segment) {
    return label(this.byNumber?.get(segment)?.term ?? "");
  }

  // What a word of a term is called.
  own(text) {
    const [word, ...axis] = text.split(" ");
    const own = tongue() === "ko" && this.model.words?.[word];
    return own && [own, ...axis].join(" ");
  }

  heard(text) {
    const own = this.own(text);
    return own ? `${own} (${text})` : text;
  }

  worded(text) {
    const own = this.own(text);
    return own ? [own + " ", h("small", {}, text)] : [text];
  }

  labelled(term) {
    return summary(term).own ? [label(term)] : this.worded(label(term));
  }

  // An operand that stands in the term of another segment, the owner, has that one's
  // sizes; `path` leads to it from there.
  row(operand, above, level, owner, path) {
    const number = typeof operand === "number" ? operand
      : typeof summary(operand).term === "number" ? summary(operand).term : null;
    const one = number === null ? null : this.byNumber.get(number);
    const term = one ? one.term : operand;
    const { term: inner } = summary(term);
    const sign = inner && SIGNS[inner.name];
    const parts = operandsOf(term);
    const key = above + "/" + (number ?? label(operand) + path.at(-1));
    const open = this.open.has(key);
    const chosen = this.key ? this.key === key : this.segment === number && number !== null;
    const item = h("li", { role: "treeitem", "aria-level": level, "aria-selected": String(chosen),
      "aria-expanded": parts.length ? String(open) : undefined, tabindex: chosen || (level === 1 && this.segment === undefined) ? 0 : -1,
      onclick: (event) => { event.stopPropagation(); this.choose(number ?? owner, key, parts.length, number === null ? path : []); } },
      h("span", { class: "row" },
        h("span", { class: "twist" }, parts.length ? (open ? "▾" : "▸") : ""),
        h("b", {}, number === null ? "" : String(number)),
        h("span", { class: "what" }, ...this.labelled(term)),
        h("i", {}, sign || (inner && inner.name && summary(term).own ? this.own(inner.name) || inner.name : ""))));
    item.dataset.key = key;
    if (open && parts.length) {
      item.append(h("ul", { role: "group" }, ...parts.map((part, i) =>
        this.row(part, key, level + 1, number ?? owner, number === null ? [...path, i] : [i]))));
    }
    return item;
  }

  choose(number, key, parts, path = []) {
    const own = path.length ? key : undefined;
    if (parts && ((this.segment === number && this.key === own) || !this.open.has(key))) {
      if (this.open.has(key)) this.open.delete(key);
      else this.open.add(key);
    }
    if (number !== null) {
      this.segment = number;
      this.key = own;
      this.studio.lightSegment(number, path);
    }
    this.draw();
    this.focus(key);
  }

  focus(key) {
    this.list.querySelector(`[data-key="${CSS.escape(key)}"]`)?.focus();
  }

  keyed(event) {
    const items = [...this.list.querySelectorAll("[role=treeitem]")];
    const at = items.indexOf(document.activeElement);
    if (at < 0) return;
    const item = items[at];
    if (event.key === "ArrowDown") items[Math.min(at + 1, items.length - 1)].focus();
    else if (event.key === "ArrowUp") items[Math.max(at - 1, 0)].focus();
    else if (event.key === "Enter" || event.key === " ") item.click();
    else if (event.key === "ArrowRight" && item.getAttribute("aria-expanded") === "false") item.click();
    else if (event.key === "ArrowLeft" && item.getAttribute("aria-expanded") === "true") item.click();
    else return;
    event.preventDefault();
    event.stopPropagation();
  }

  // --- the form ---

  drawForm() {
    const rows = [];
    for (const { param, value, about } of this.model.params) {
      if (typeof value === "number") rows.push(this.number(param, value, [], { param }, about));
    }
    if (rows.length) rows.unshift(h("h3", { "data-word": "parameters" }));
    const one = this.byNumber && this.byNumber.get(this.segment);
    if (one && typeof one.term === "object") {
      const found = [];
      this.numbers(one.term, [], null, found);
      rows.push(h("h3", {}, `${one.segment} `, ...this.labelled(one.term)));
      rows.push(...found.map(({ name, value, types, path }) =>
        this.number(name, value, types, { segment: one.segment, path })));
      if (!found.length) rows.push(h("p", { class: "quiet", "data-word": "no_numbers" }));
    } else {
      rows.push(h("p", { class: "quiet", "data-word": "no_sizes" }));
    }
    // Whoever is at a field stays there, also in the middle of a number.
    const [was, now] = [[...this.form.querySelectorAll("input")], rows.flatMap((row) => [...row.querySelectorAll("input")])];
    const held = document.activeElement;
    if (!was.includes(held) || JSON.stringify(was.map((one) => one.dataset.of)) !== JSON.stringify(now.map((one) => one.dataset.of))) {
      this.form.replaceChildren(...rows);
      return;
    }
    was.forEach((one, i) => {
      if (one !== held || !(this.dragging || one.dataset.typed)) one.value = now[i].value;
    });
  }

  // The numbers of a term, each with its path (docs/protocol.md, edit).
  numbers(term, path, within, found) {
    if (typeof term === "number") {
      const axis = ["translate", "scale", "shift", "size"].includes(within.name) ? "xyz"[within.at - 1] : within.at;
      found.push({ name: within.name + (within.many > 1 ? " " + axis : ""), value: term,
        types: within.types || [], path, at: within.at });
    } else if (Array.isArray(term)) {
      term.forEach((inner, i) => {
        if (typeof inner !== "number") this.numbers(inner, [...path, i + 1], within, found);
        else if (within && within.list) {
          this.numbers(inner, [...path, i + 1], { ...within, at: i + 1, many: term.length }, found);
        }
      });
    } else if (term && typeof term === "object") {
      const primitive = this.model.forms[term.name];
      // A size, or a number of a placement, may be a formula: it is the text's.
      if (within?.sizes && !primitive && !isOperand(term)) return;
      const operation = term.name in SIGNS;
      term.args.forEach((inner, i) => {
        if (operation && typeof inner === "number") return;
        if ((term.name === "named" || term.name === "at") && typeof inner === "number") return;
        const within1 = primitive ? { types: [] }
          : { name: term.name, types: within && within.form ? within.form[term.name] : null,
            at: i + 1, many: term.args.filter((one) => typeof one === "number").length, list: !operation && !isOperand(term), sizes: within?.form || within?.name === "at" };
        if (primitive) within1.form = primitive;
        else if (within && within.form) within1.types = within.form[term.name] || [];
        this.numbers(inner, [...path, i + 1], within1, found);
      });
    }
  }

  number(name, value, types, target, about = {}) {
    const { param } = target;
    const whole = ["facets", "count"].includes((types || [])[0]);
    const positive = ["length", "radius", "factor", "turn"].includes((types || [])[0]) || whole;
    const size = Math.abs(value) || 1;
    const step = about.step ?? (whole ? 1 : 10 ** (Math.floor(Math.log10(size)) - 2));
    const least = about.min ?? (whole ? Math.min(3, value) : positive ? step : -2 * size - step);
    const most = about.max ?? (whole ? Math.max(64, 2 * value) : 2 * size + step);
    const text = about[tongue()];
    const sent = (text) => {
      const number = whole ? Math.round(Number(text)) : Number(Number(text).toPrecision(12));
      if (text !== "" && Number.isFinite(number)) this.set(target, number);
      else this.drawForm();
    };
    const begun = () => { this.drag = (this.drag || 0) + 1; };
    const field = h("input", { type: "number", value, step: "any", readonly: Boolean(this.studio.record),
      oninput: () => { field.dataset.typed = true; },
      onchange: () => { delete field.dataset.typed; begun(); sent(field.value); } });
    const slider = h("input", { type: "range", min: least, max: most, step, value,
      oninput: () => {
        this.dragging = true;
        field.value = Number(Number(slider.value).toPrecision(12));
        sent(slider.value);
      },
      onchange: () => { this.dragging = false; } });
    for (const one of [slider, field]) {
      one.setAttribute("aria-label", param ? name : this.heard(name));
      one.dataset.of = JSON.stringify(target);
    }
    slider.addEventListener("pointerdown", begun);
    slider.addEventListener("keydown", begun);
    return h("label", { class: "number", title: text }, h("span", {}, ...(param ? [name] : this.worded(name))), slider, field);
  }

  // What the page holds of a number of the text: also what is not answered yet.
  valueOf({ param, segment, path }) {
    return param ? this.model.params.find((one) => one.param === param)?.value
      : path.reduce((term, step) => (term?.args || term)?.[step - 1], this.byNumber.get(segment)?.term);
  }

  put({ param, segment, path }, value) {
    const one = param ? this.model.params.find((one) => one.param === param)
      : this.model.segments.find((one) => one.segment === segment);
    const within = param ? one : path.slice(0, -1).reduce((term, step) => (term?.args || term)?.[step - 1], one?.term);
    if (within) (within.args || within)[param ? "value" : path.at(-1) - 1] = value;
  }

  // Of one number the last value wins; of several each comes. All edits of one
  // drag are one step of undo: each takes back the one before it. Until the tree
  // that has it is there, a value stands in what the page holds: the next key
  // goes on from it.
  set(target, value) {
    const last = this.sets.at(-1);
    const same = last && !last.begun && last.line === this.studio.line && JSON.stringify(last.target) === JSON.stringify(target);
    const one = same ? last : { target };
    Object.assign(one, { value, drag: this.drag });
    this.put(target, value);
    if (same) return;
    this.sets.push(one);
    one.line = this.studio.inLine(() => this.sent(one));
  }

  async sent(one) {
    one.begun = true;
    const { wire } = this.studio;
    try {
      if (one.drag === this.done) await wire.ask("undo");
      this.done = null;
      const { head } = await wire.ask("edit", { set: { ...one.target, value: one.value } });
      this.done = one.drag;
      one.rev = head.rev;
      this.studio.segments = head.segments;
      this.studio.edited(head);
    } catch (error) {
      if (error instanceof Lost) {
        await this.studio.there();
        return this.sent(one);
      }
      this.sets = this.sets.filter((other) => other !== one);
      this.studio.failed(error);
      if (!this.sets.length) this.refresh();
    }
    return null;
  }
}
