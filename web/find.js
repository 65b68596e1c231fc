// Ctrl-K: any command, name or predicate, by a part of what it is called.

import { h, calm } from "./dom.js";
import { w, tongue, otherTongue } from "./words.js";
import { kindsOf } from "./kinds.js";
import { LOOKS, lookCalled } from "./link.js";
import { Lost } from "./wire.js";

const MOST = 30;

// Pairs of what is found and what it does.
function commands(studio) {
  const named = (...words) => words.join(": ");
  const { change, looks, ports } = studio;
  const look = (key, values) => values.map((value) => [named(w(key), lookCalled(value)), () => {
    looks[key] = value;
    studio.looked();
  }]);
  return [
    ...["undo", "redo"].map((word) => [w(word), () => change.call(studio, word)]), [w("save"), () => studio.save()],
    ...["tree", "text", "rules"].map((pane) => [w(pane), () => { studio.paneTo("left"); studio.leftTo(pane); }]),
    [w("clear"), () => studio.asking.clear()], [w("larger"), () => ports.enlarge(ports.focused())],
    ...kindsOf(studio).map((kind) => [named(w("menu"), w(kind)), () => ports.focused().turnTo(kind)]),
    ...["hidden", "lines", "up"].flatMap((key) => look(key, LOOKS[key])),
    [w("central"), () => {
      looks.projection = looks.projection === "central" ? "parallel" : "central";
      studio.looked();
    }],
    ...studio.models.map((name) => [named(w("open"), name), () => studio.opened(name)]),
    ...studio.formats.flatMap(([what, formats]) => formats.map((format) =>
      [named(w("export"), w(what + "_of"), format), () => studio.export(what, format)])),
    ...studio.asking.questions.map(({ name, goal }) => [named(w("ask"), name), () => studio.asking.pose(goal), goal]),
    ["한국어 / English", otherTongue],
    ...studio.segments.map(({ segment, name }) => [`s${segment} ${name}`, () => {
      studio.leftTo("tree");
      studio.tree.choose(segment, "/" + segment, 0);
    }]),
    ...studio.tree.unfoldable().map((one) => [named(w("unfold"), `${one} ${studio.tree.called(one)}`), () => {
      const port = ports.focused();
      port.settings.segment = one;
      port.turnTo("unfold");
    }]),
  ];
}

export function find(studio) {
  const from = studio.ports.focused().element.contains(document.activeElement) ? document.activeElement : null;
  const box = h("input", { type: "text", role: "combobox", "aria-expanded": "true", "aria-controls": "found",
    spellcheck: "false", autocomplete: "off", placeholder: w("find"), "aria-label": w("find"), oninput: () => show() });
  const list = h("ul", { id: "found", role: "listbox", "aria-label": w("find") });
  const dialog = h("dialog", { class: "find", onclose: () => { dialog.remove(); from?.focus(); },
    onkeydown: (event) => keyed(event) }, box, list);
  const all = commands(studio);
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
    items = [...name, ...all.filter(([word]) => parts.every((part) => word.toLowerCase().includes(part))),
      ...predicates].slice(0, MOST);
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
