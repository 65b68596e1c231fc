// Ctrl-K: any command, name or predicate, by a part of what it is called; and the help.

import { h, calm } from "./dom.js";
import { w, tongue } from "./words.js";
import { commands, fullName, run } from "./commands.js";
import { Lost } from "./wire.js";

const MOST = 30;

export function find(studio) {
  const from = studio.ports.focused().element.contains(document.activeElement) ? document.activeElement : null;
  const box = h("input", { type: "text", role: "combobox", "aria-expanded": "true", "aria-controls": "found",
    spellcheck: "false", autocomplete: "off", placeholder: w("find"), "aria-label": w("find"), oninput: () => show() });
  const list = h("ul", { id: "found", role: "listbox", "aria-label": w("find") });
  const dialog = h("dialog", { class: "find", onclose: () => { dialog.remove(); from?.focus(); },
    onkeydown: (event) => keyed(event) }, box, list);
  const all = commands(studio).filter(({ off }) => !off).map((row) => [fullName(row), () => run(studio, row), row.doc, row.called]);
  let items = [], at = 0, predicates = [];

  const act = (i) => {
    dialog.close();
    if (items[i]) items[i][1]();
  };
  const mark = (i) => {
    at = Math.max(0, Math.min(items.length - 1, i));
    [...list.children].forEach((item, k) => item.setAttribute("aria-selected", String(k === at)));
    list.children[at]?.scrollIntoView({ block: "nearest" });
    box.setAttribute("aria-activedescendant", "found" + at);
  };
  const show = () => {
    const text = box.value.trim(), parts = text.toLowerCase().split(/\s+/);
    const name = /^(s\d+([epvj]-?\d+)?|l\d+)$/.test(text) ? [[text, () => studio.chosen([text])]] : [];
    // What is called so itself comes before what stands in a menu called so.
    const within = (word) => parts.every((part) => word.toLowerCase().includes(part));
    const named = all.filter(([word]) => within(word)).sort(([, , , a], [, , , b]) => within(b) - within(a));
    items = [...name, ...named.slice(0, predicates.length ? MOST / 2 : MOST), ...predicates].slice(0, MOST);
    list.replaceChildren(...items.map(([word, , doc], i) => h("li", { role: "option", id: "found" + i,
      onclick: () => act(i) }, h("b", {}, word), doc ? h("span", {}, doc) : null)));
    mark(0);
    if (text !== asked) complete(text);
  };
  let asked = "";
  const complete = calm(150, async (text) => {
    asked = text;
    predicates = [];
    if (/^[a-z]\w+$/.test(text)) {
      try {
        const { head } = await studio.wire.ask("complete", { text });
        predicates = head.words.filter(({ kind }) => kind !== "request")
          .map(({ word, doc, ko }) => [word, () => studio.asking.set(word.split("/")[0] + "("), tongue() === "ko" ? ko : doc]);
      } catch (error) {
        if (!(error instanceof Lost)) throw error;
      }
    }
    if (dialog.open) show();
  });
  const keyed = (event) => {
    const step = { ArrowDown: 1, ArrowUp: -1, PageDown: 8, PageUp: -8 }[event.key];
    if (step) mark(at + step);
    else if (event.key === "Enter") act(at);
    else return;
    event.preventDefault();
  };
  document.body.append(dialog);
  dialog.showModal();
  show();
}

// What a pointer does, and the keys of the table.
export function help(studio) {
  const keys = commands(studio).filter(({ keys }) => keys).map(({ keys, called }) => h("tr", {},
    h("th", { scope: "row" }, ...keys.flatMap((key) => [" ", h("kbd", {}, key)])), h("td", {}, called)));
  const dialog = h("dialog", { class: "find help", "aria-label": w("help"), onclose: () => dialog.remove() },
    h("p", {}, w("pointing")), h("p", {}, w("turn")), h("table", {}, ...keys), h("button", { onclick: () => dialog.close() }, w("close")));
  document.body.append(dialog);
  dialog.showModal();
}
