// What stands beside the pictures: questions, reasons, text, rules.

import { h, calm, say } from "./dom.js";
import { w, tongue, reworded } from "./words.js";
import { Lost, textOf } from "./wire.js";

const QUICK = 1000;       // ms: what is asked again by itself

export class Asking {
  constructor(studio) {
    this.studio = studio;
    this.box = h("input", { id: "goal", type: "text", spellcheck: "false", autocomplete: "off",
      placeholder: "line(L, S1, P1, A1, B1, S2, P2, A2, B2)", list: "words",
      oninput: () => this.complete() });
    this.box.dataset.label = "question";
    this.words = h("datalist", { id: "words" });
    this.count = h("span", { class: "remark", role: "status" });
    this.table = h("div", { class: "answers", tabindex: 0, role: "region" });
    this.table.dataset.label = "answers_here";
    this.element = h("form", { class: "panel ask", onsubmit: (event) => { event.preventDefault(); this.ask(); } },
      h("h2", { "data-word": "ask" }),
      h("div", { class: "line" }, h("span", { class: "prompt", "aria-hidden": "true" }, "?-"), this.box, this.words,
        h("button", { class: "main", "data-word": "ask" }),
        this.keep = h("button", { type: "button", "data-word": "save_question", onclick: () => this.naming() }),
        h("button", { type: "button", "data-word": "clear", onclick: () => this.clear() }), this.count),
      this.kept = h("div", { class: "line saved", role: "group", hidden: true }), this.table);
    this.kept.dataset.label = "saved_questions";
    this.questions = [];
  }

  // The questions that are kept with the model.
  list(questions) {
    const { studio } = this;
    this.questions = questions;
    this.keep.hidden = !studio.isText;
    this.kept.hidden = !questions.length;
    this.kept.replaceChildren(...questions.flatMap(({ name, goal }) => [
      h("button", { type: "button", class: "name", title: goal, onclick: () => this.pose(goal) }, name),
      studio.isText ? h("button", { type: "button", class: "name", "aria-label": w("remove_question", name),
        title: w("remove_question", name), onclick: () => studio.change("question", { name, goal: null }) }, "×") : null])
      .filter(Boolean));
  }

  pose(goal) {
    this.studio.paneTo("asking");
    this.box.value = goal;
    return this.ask();
  }

  // What is in the box is kept, under a name that is asked for where they stand.
  naming() {
    const goal = this.box.value.trim();
    if (!goal) return;
    const names = this.questions.map(({ name }) => name);
    const word = /[a-z]\w*/.exec(goal)?.[0] || "goal";
    let free = word;
    for (let i = 2; names.includes(free); i++) free = `${word} ${i}`;
    const box = h("input", { type: "text", value: this.questions.find((one) => one.goal === goal)?.name || free,
      onkeydown: (event) => {
        if (!["Enter", "Escape"].includes(event.key) || event.isComposing) return;
        event.preventDefault();
        event.stopPropagation();
        const name = box.value.trim();
        if (event.key === "Enter" && name) this.studio.change("question", { name, goal });
        this.list(this.questions);
        this.keep.focus();
      } });
    this.kept.prepend(h("label", { class: "line remark" }, w("question_name"), box));
    this.kept.hidden = false;
    box.select();
  }

  complete = calm(200, async () => {
    const word = /[a-z]\w{1,}$/.exec(this.box.value);
    if (!word) return;
    try {
      const { head } = await this.studio.wire.ask("complete", { text: word[0] });
      const before = this.box.value.slice(0, word.index);
      this.words.replaceChildren(...head.words.slice(0, 12).map(({ word: name, doc, ko }) =>
        h("option", { value: before + name.split("/")[0] }, tongue() === "ko" ? ko : doc)));
    } catch (error) {
      if (!(error instanceof Lost)) throw error;
    }
  });

  set(goal) {
    this.box.value = goal;
    this.box.focus();
  }

  clear() {
    this.goal = "";
    this.table.replaceChildren();
    this.count.textContent = "";
    this.studio.light("lit", []);
  }

  // The answers of now, if they do not take long; else it says of when they are.
  again() {
    if (!this.goal) return;
    if (this.took < QUICK) this.ask(this.goal);
    else {
      this.count.textContent = w("earlier");
      this.rest?.remove();
    }
  }

  async ask(goal = this.box.value.trim()) {
    if (!goal) return;
    const since = Date.now();
    if (goal !== this.goal || !(this.took < QUICK)) this.count.textContent = w("working");
    this.goal = goal;
    try {
      const asked = this.studio.wire.ask("ask", { goal, ...this.studio.seen() });
      this.number = this.studio.wire.number;
      const { head, body } = await asked;
      if (goal !== this.goal) return;
      this.took = Date.now() - since;
      this.answered = { goal, head };
      this.shows = [];
      this.printed = textOf(body);
      this.rows = h("tbody");
      this.show(head, true);
    } catch (error) {
      if (goal !== this.goal) return;
      this.count.textContent = "";
      if (error instanceof Lost) return;
      this.goal = "";
      this.table.replaceChildren(h("p", { class: "bad", role: "alert" }, this.studio.wrong(error)));
    }
  }

  show(head, first) {
    if (first) {
      this.table.replaceChildren(
        ...(this.printed ? [h("pre", {}, this.printed)] : []),
        head.answers.length === 0 && head.names.length ? h("p", { class: "quiet" }, w("none_hold")) : h("table", {}, h("thead", {}, h("tr", {}, ...head.names.map((name) => h("th", { scope: "col" }, name)))), this.rows));
      this.total = head.answers.length + head.left;
    }
    head.answers.forEach((answer, i) => {
      const names = head.shows[i];
      this.rows.append(h("tr", { tabindex: names.length ? 0 : undefined,
        onclick: () => this.studio.chosen(names),
        onkeydown: (event) => { if (event.key === "Enter") this.studio.chosen(names); },
        onpointerenter: () => this.studio.hovered(null, names) },
        ...answer.map((value) => h("td", {}, typeof value === "string" ? value : JSON.stringify(value)))));
      this.shows.push(...names);
    });
    if (this.rest) this.rest.remove();
    this.rest = null;
    if (head.left) {
      this.rest = h("button", { type: "button", onclick: () => this.next() }, w("more", head.left));
      this.table.append(this.rest);
    }
    this.count.textContent = this.total === 0 ? w(head.names.length ? "no_answers" : "no")
      : head.names.length === 0 ? w("yes") : this.total === 1 ? w("one_answer")
        : w(head.cut ? "answers_cut" : "answers", this.total);
    if (this.count.textContent !== this.spoken) say(this.count.textContent);
    this.spoken = this.count.textContent;
    this.studio.lightAll("lit", this.shows).catch((error) => this.studio.failed(error));
  }

  async next() {
    try {
      const { head } = await this.studio.wire.ask("next", { of: this.number });
      this.show(head, false);
    } catch (error) {
      this.studio.failed(error);
    }
  }
}

export class Why {
  constructor(studio) {
    this.studio = studio;
    this.inner = h("div", { class: "inner", tabindex: 0, role: "region", "aria-live": "polite" });
    this.inner.dataset.label = "why";
    this.element = h("div", { class: "panel why" }, h("h2", { "data-word": "why" }), this.inner);
    this.clear();
  }

  clear() {
    this.shown = null;
    this.inner.replaceChildren(h("p", { class: "quiet", "data-word": "no_why" }));
    reworded(this.inner);
  }

  // The same, of the model of now.
  again() {
    this.shown?.();
  }

  // What `items` resolves to is shown, unless something else is to be told meanwhile.
  async tell(again, items) {
    const same = this.shown === again;
    this.shown = again;
    let parts;
    try {
      parts = await items();
    } catch (error) {
      if (error instanceof Lost) return;
      parts = [h("p", { class: "bad" }, this.studio.wrong(error))];
    }
    if (this.shown !== again) return;
    const { scrollTop } = this.inner;
    this.inner.replaceChildren(...parts);
    reworded(this.inner);
    this.inner.scrollTop = same ? scrollTop : 0;
  }

  async show(names, port, role) {
    const { studio } = this;
    if (!names.length) {
      this.clear();
      return;
    }
    const again = () => this.tell(again, async () => {
      const { head } = await studio.wire.ask("select", { names: names.slice(0, 20) });
      const items = [];
      const { reasons } = await import("./why.js");
      for (const one of head.selected) items.push(...await reasons(studio, one, port, role));
      if (this.shown === again) {
        studio.light("chosen", [...names, ...head.selected.flatMap(({ shows }) =>
          shows.filter((name) => /^s\d+e/.test(name)))], head.ends);
      }
      return items;
    });
    await again();
  }

  // What explains an item of a picture that has no names.
  async item(item, options) {
    this.studio.names = [];
    this.studio.light("chosen", []);
    this.studio.news(item);
    const again = () => this.tell(again, async () => (await import("./why.js")).reason(this.studio, item, options));
    await again();
  }
}
