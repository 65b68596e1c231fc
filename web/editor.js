// The text of the model, and of its rules.

import { h, calm } from "./dom.js";
import { w, tongue } from "./words.js";
import { Lost, textOf } from "./wire.js";

const MOST_COLOURED = 60000;
// A comment, what is quoted, a variable, a number.
const PARTS = /(%.*|\/\*[^]*?(?:\*\/|$))|("(?:\\[^]|[^"\\\n])*"?|'(?:\\[^]|''|[^'\\\n])*'?)|\b([A-Z_]\w*)|\b(\d+(?:\.\d+)?(?:[eE][+-]?\d+)?)\b/g;
const KINDS = ["comment", "quoted", "variable", "figure"];

// The parts of a text of Prolog, in their colours; the last line has an end too.
function coloured(text) {
  const out = [];
  let at = 0;
  for (const found of text.matchAll(PARTS)) {
    out.push(text.slice(at, found.index), h("span", { class: KINDS[found.slice(1).findIndex(Boolean)] }, found[0]));
    at = found.index + found[0].length;
  }
  return [...out, text.slice(at) + "\n"];
}

// The text of the model, or of its rules: what is typed is done 400 ms later.
class Editor {
  constructor(studio, word) {
    this.studio = studio;
    this.field = h("textarea", { spellcheck: "false", wrap: "off", oninput: () => this.typed(), onscroll: () => this.scrolled() });
    this.field.dataset.label = word;
    this.colours = h("pre", { "aria-hidden": "true" });
    this.paper = h("div", { class: "paper" }, this.colours, this.field);
    this.wrong = h("p", { class: "bad", role: "alert", hidden: true });
  }

  typed() {
    this.dirty = true;
    this.later();
    this.paint();
  }

  // The field has the text, and its colours stand behind it.
  paint() {
    const { value } = this.field;
    const plain = value.length > MOST_COLOURED;
    this.paper.classList.toggle("plain", plain);
    this.colours.replaceChildren(...(plain ? [] : coloured(value)));
    this.scrolled();
  }

  scrolled() {
    this.colours.scrollTo(this.field.scrollLeft, this.field.scrollTop);
  }

  later = calm(400, () => this.done());

  said(error) {
    const message = error && error.head && error.head.error;
    this.wrong.hidden = !error;
    this.wrong.textContent = error ? (message && message.line ? message.line + ": " : "") + this.studio.wrong(error) : "";
    this.field.setAttribute("aria-invalid", String(Boolean(error)));
  }
}

export class Text extends Editor {
  constructor(studio) {
    super(studio, "text");
    this.element = h("div", { class: "panel editor" }, this.paper, this.wrong);
  }

  async refresh() {
    if (this.dirty || !(this.studio.isText || this.studio.record)) return;
    const { body } = await this.studio.wire.ask("text");
    if (this.dirty) return;
    const text = textOf(body);
    this.field.readOnly = Boolean(this.studio.record);
    if (text === this.field.value) return;
    const { selectionStart, scrollTop } = this.field;
    this.field.value = text;
    this.paint();
    this.field.setSelectionRange(selectionStart, selectionStart);
    this.field.scrollTop = scrollTop;
    this.said(null);
  }

  // What `pattern` finds, its group, is chosen; where it finds nothing, `text` is put at the end before.
  within(pattern, text) {
    const { field } = this;
    if (!pattern.test(field.value)) {
      field.value += (/[^\n]$/.test(field.value) ? "\n" : "") + text;
      this.typed();
    }
    const [whole, part] = pattern.exec(field.value);
    const to = field.value.search(pattern) + whole.length;
    field.focus();
    field.setSelectionRange(to - part.length, to);
  }

  async done() {
    const text = this.field.value;
    try {
      const { head } = await this.studio.wire.ask("text", { body: text });
      if (this.field.value === text) this.dirty = false;
      this.studio.segments = head.segments;
      this.said(null);
      this.studio.edited(head);
    } catch (error) {
      if (!(error instanceof Lost)) this.said(error);
    }
  }
}

export class Rules extends Editor {
  constructor(studio) {
    super(studio, "rules");
    this.field.placeholder = "may_cut(S1, S2) :-\n    S1 =\\= 1,\n    default(may_cut(S1, S2)).";
    this.counts = h("p", { class: "remark counts", role: "status" });
    this.tried = null;
    this.decisions = h("ul", { class: "decisions" });
    this.element = h("div", { class: "panel editor" }, this.paper, this.wrong, this.counts,
      h("p", { class: "wishes" },
        h("button", { class: "main", "data-word": "keep_rules", onclick: () => this.end(true) }),
        h("button", { "data-word": "discard", onclick: () => this.end(false) })),
      h("h2", { "data-word": "decisions" }), this.decisions);
  }

  async refresh() {
    if (this.dirty) return;
    const { head, body } = await this.studio.wire.ask("rules");
    if (!this.dirty) {
      this.field.value = textOf(body);
      this.paint();
      this.tried = head.tried ? this.field.value : null;
    }
    this.field.readOnly = !this.studio.owner || !this.studio.isText;
    this.decisions.replaceChildren(...head.decisions.map(({ decision, words, by }) =>
      h("li", { class: by, title: words[tongue()] }, h("code", {}, decision), " ", words[tongue()])));
  }

  async done() {
    const { studio } = this;
    const text = this.field.value;
    try {
      const { head } = await studio.wire.ask("rules", { try: true, body: text, ...studio.looks });
      this.tried = text;
      this.said(null);
      const { came, went, changed } = head.count;
      this.counts.replaceChildren(h("span", { class: "came" }, w("came", came)), h("span", { class: "gone" }, w("went", went)),
        h("span", { class: "changed" }, w("changed_role", changed)));
      await studio.revised(head);
      studio.tried(head);
    } catch (error) {
      if (error instanceof Lost) return;
      this.said(error);
      this.counts.textContent = "";
    }
  }

  // What is kept is what stands here: tried before, and without a mistake.
  async end(keep) {
    if (keep && this.field.value !== this.tried) {
      if (this.dirty) await this.done();
      if (this.field.value !== this.tried) return;
    }
    try {
      const { head } = await this.studio.wire.ask("rules", keep || this.tried !== null ? { keep } : {});
      this.tried = null;
      this.dirty = false;
      this.counts.textContent = "";
      this.said(null);
      this.studio.tried();
      await this.studio.revised(head);
      this.refresh();
    } catch (error) {
      this.studio.failed(error);
    }
  }
}
