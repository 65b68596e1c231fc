// The problems of a class: a pupil answers them, a teacher sees who did.

import { $, h, calm, say } from "./dom.js";
import { w, tongue, reworded } from "./words.js";
import { Lost } from "./wire.js";

const all = (right) => right.length > 0 && right.every(Boolean);

export class Problems {
  constructor(studio) {
    this.studio = studio;
    this.list = h("ul", { class: "problems" });
    this.task = h("form", { class: "task", onsubmit: (event) => { event.preventDefault(); this.check(); } });
    this.book = h("div", { class: "book", tabindex: 0, role: "region" });
    this.book.dataset.label = "pupils";
    this.who = h("form", { class: "line who", onsubmit: (event) => { event.preventDefault(); this.join(); } });
    this.element = h("div", { class: "panel" }, h("h2", { "data-word": "problems" }),
      this.who, this.list, this.task, this.book);
    this.done = new Map();
    this.typed = new Map();
  }

  // What the program says of the class when the page opens.
  async greeted(told) {
    this.teacher = told.teacher;
    this.name = told.name;
    for (const one of told.done || []) this.done.set(one.problem, one);
    await this.refresh();
    if ((this.name || this.teacher) && !this.at) this.begin();
  }

  // The first one that is not right.
  begin() {
    const open = ({ problem }) => !this.done.has(problem) || !all(this.done.get(problem).right);
    const first = (this.problems || []).find(open) || (this.problems || [])[0];
    if (first && document.body.classList.contains("bare")) this.pose(first.problem);
  }

  async refresh() {
    try {
      const { head } = await this.studio.wire.ask("problems");
      this.problems = head.problems;
      this.pupils = head.pupils;
      this.draw();
      this.box?.focus();
      if (this.teacher) await this.table();
    } catch (error) {
      this.failed(error);
    }
  }

  failed(error) {
    if (!(error instanceof Lost)) this.studio.failed(error);
  }

  draw() {
    this.drawWho();
    const may = this.teacher || this.name;
    this.list.replaceChildren(...this.problems.map(({ problem }) => {
      const done = this.done.get(problem);
      const state = !done ? "" : all(done.right) ? "✓" : done.shown ? "◦" : "✗";
      return h("li", {}, h("button", { disabled: !may, "aria-current": problem === this.at && "true",
        onclick: () => this.pose(problem) }, problem, h("span", { class: "mark" }, state)));
    }));
    reworded(this.element);
  }

  drawWho() {
    if (this.teacher || this.name) {
      this.who.replaceChildren(...(this.name ? [h("strong", {}, this.name)] : []));
      return;
    }
    const names = h("datalist", { id: "pupils" }, ...this.pupils.map((value) => h("option", { value })));
    this.box = h("input", { type: "text", list: "pupils", maxlength: 60, required: true, autocomplete: "off" });
    this.box.dataset.label = "pupil_name";
    this.who.replaceChildren(h("label", {}, h("span", { "data-word": "pupil_name" }), this.box), names,
      h("button", { class: "main", "data-word": "begin" }));
  }

  async join() {
    try {
      const { head } = await this.studio.wire.ask("join", { name: this.box.value });
      this.name = head.name;
      this.draw();
      this.begin();
    } catch (error) {
      this.failed(error);
    }
  }

  // A problem is shown alone, on its sheet.
  async pose(problem, keys = {}) {
    const { studio } = this;
    try {
      const reply = await studio.wire.ask("problem", { problem, lang: tongue(), ...this.variant(problem), ...keys });
      this.at = problem;
      this.reply = reply;
      const { head } = reply;
      if (head.checked && !this.teacher) this.noted(head);
      this.draw();
      this.drawTask(head);
      const [port] = studio.ports.ports;
      if (port.kind === "problem") port.refresh();
      else port.turnTo("problem");
      studio.ports.only(port);
      if (head.checked) say(head.checked.map(({ said: verdict }) => w("said_" + verdict)).join(", "));
      else this.task.querySelector("input, button")?.focus();
    } catch (error) {
      this.failed(error);
    }
  }

  // A teacher sees the variant that he chose.
  variant(problem) {
    return this.teacher && this.number && this.at === problem ? { number: this.number } : {};
  }

  noted({ problem, checked, shows }) {
    const before = this.done.get(problem);
    if (before && all(before.right)) return;
    const right = checked.map((one) => one.right);
    this.done.set(problem, { right, shown: (before && before.shown) || (shows === "answer" && !all(right)) });
  }

  check(show = false) {
    const answers = [...this.task.querySelectorAll("input")].map(({ value }) => value);
    this.typed.set(this.reply.head.called, answers);
    if (show) this.studio.paneTo("ports");        // on a phone the sheet is there
    return this.pose(this.at, show ? { answers, show } : { answers });
  }

  drawTask(head) {
    const typed = this.typed.get(head.called) || [];
    const fields = head.fields.map(({ words, unit, tolerance }, i) => {
      const checked = head.checked && head.checked[i];
      const box = h("input", { type: "text", inputmode: "decimal", autocomplete: "off", value: typed[i] || "",
        "aria-describedby": "said" + i, "aria-invalid": checked && !checked.right && "true" });
      return h("div", { class: "field" }, h("label", {}, words[tongue()],
        h("span", { class: "line" }, box, unit ? `${unit} (±${tolerance})` : "")),
      h("p", { id: "said" + i, class: checked ? (checked.right ? "good" : "bad") : "" }, checked ? this.verdict(checked) : ""));
    });
    const variants = this.problems.find(({ problem }) => problem === head.problem).variants;
    const choice = this.teacher && variants > 1 && h("select", { onchange: () => {
      this.number = Number(choice.value);
      this.pose(head.problem);
    } }, ...Array.from({ length: variants }, (_, i) => h("option", { value: i + 1 }, `${head.problem}-${i + 1}`)));
    if (choice) {
      choice.value = head.number;
      choice.dataset.label = "variant";
    }
    const shown = head.shows === "answer";
    this.task.replaceChildren(h("h3", {}, choice || head.called), ...fields,
      h("p", { class: "quiet", "data-word": shown ? "compare" : "draw_rest" }),
      h("p", { class: "wishes" },
        fields.length ? h("button", { class: "main", "data-word": "check" }) : null,
        shown ? null : h("button", { type: "button", "data-word": "show_answer", onclick: (event) => this.shown(event) })));
    reworded(this.task);
  }

  verdict({ said: word, value, why }) {
    const known = value === null ? "" : ` ${value}.`;
    return `${w("said_" + word)}${word === "right" ? known : value === null ? "" : ` ${w("it_is", value)}`} ${why ? why[tongue()] : ""}`.trim();
  }

  // Who asks to be shown is asked whether he means it: the teacher sees it.
  shown(event) {
    const button = event.currentTarget;
    if (this.teacher || button.dataset.word === "show_noted") {
      this.check(true);
      return;
    }
    button.dataset.word = "show_noted";
    reworded(button.parentElement);
  }

  changed = calm(300, () => { if (this.teacher) this.table().catch((error) => this.failed(error)); });

  async table() {
    const { head } = await this.studio.wire.ask("class");
    const cell = (done) => {
      if (!done) return h("td", {}, "–");
      const [mark, word] = all(done.right) ? ["✓", "said_right"] : done.shown ? ["◦", "was_shown"] : ["✗", "not_yet"];
      const text = w("tries", done.tries);
      return h("td", { title: `${w(word)}, ${text}: ${done.answers.join("; ")}` },
        h("span", { "aria-label": w(word) }, mark), ` ${done.tries}`);
    };
    const names = this.problems.map(({ problem }) => problem);
    const solved = names.map((name) => head.pupils.filter(({ done }) =>
      done.some(({ problem, right }) => problem === name && all(right))).length);
    this.book.replaceChildren(h("h2", { "data-word": "pupils" }), h("table", {},
      h("thead", {}, h("tr", {}, h("th", { scope: "col" }, w("pupil_name")), ...names.map((name) => h("th", { scope: "col" }, name)))),
      h("tbody", {}, ...head.pupils.map(({ name, done }) => h("tr", {}, h("th", { scope: "row" }, name),
        ...names.map((problem) => cell(done.find((one) => one.problem === problem)))))),
      h("tfoot", {}, h("tr", {}, h("th", { scope: "row" }, `✓ / ${head.pupils.length}`),
        ...solved.map((count) => h("td", {}, String(count)))))));
    reworded(this.book);
  }

  // In the other language.
  reworded() {
    if (!this.problems) return;
    this.draw();
    if (this.reply && this.reply.head.shows === "question" && !this.reply.head.checked) this.pose(this.at);
    else if (this.reply) this.drawTask(this.reply.head);
    this.changed();
  }
}

// What the port shows.
export const posed = (port) => {
  const { reply } = port.studio.problems;
  return reply ? Promise.resolve(reply) : Promise.reject(new Lost("none"));
};

// The page is that of a class; `told` says of whom in it.
export function joined(studio, told) {
  const { body } = document;
  if (!studio.problems) {
    studio.problems = new Problems(studio);
    studio.tab("problems");
    studio.tabbed("problems", studio.problems);
    reworded($("left"));
  }
  body.classList.toggle("bare", !studio.file);
  body.classList.toggle("teacher", told.teacher);
  $("panes").querySelector("[data-to=left]").dataset.word = "problems";
  reworded($("panes"));
  studio.leftTo("problems");
  if (!told.teacher) studio.paneTo("left");
  studio.problems.greeted(told);
}
