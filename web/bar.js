// The bar: menus, what has become of the document, and a stop for what takes long.

import { $, h } from "./dom.js";
import { w } from "./words.js";

const MENUS = ["file", "menu", "solid", "unfolding", "sheets", "rules"];
const SIGNS = { undo: "↶", redo: "↷", language: null, find: "⌕", help: "?" };

export class Bar {
  constructor(studio) {
    this.studio = studio;
    this.stop = h("button", { id: "stop", hidden: true, onclick: () => studio.wire.stop() });
    $("state").after(this.stop);
    setInterval(() => this.long(), 300);
    this.element = $("menus");
    const live = (words) => words.filter((word) => !studio.record || !["file", "undo", "redo"].includes(word));
    const button = (word, sign, act, keys) => h("button", { role: "menuitem", tabindex: -1, [sign ? "data-label" : "data-word"]: word, onclick: act, ...keys }, sign || "");
    this.element.append(...live(MENUS).map((word) => {
      const key = button(word, null, () => this.open(list.hidden && key), { id: "menu_" + word, "aria-haspopup": "menu", "aria-expanded": "false" });
      const list = h("div", { class: "menu", role: "menu", tabindex: -1, "aria-labelledby": "menu_" + word, hidden: true });
      return h("span", { class: "menubox", role: "none" }, key, list);
    }), h("span", { class: "gap", role: "none" }), ...live(Object.keys(SIGNS)).map((word) => button(word, SIGNS[word], () => this.act(word))));
    this.keys = [...this.element.querySelectorAll("button")];
    this.keys[0].tabIndex = 0;
    this.file = h("input", { type: "file", hidden: true, onchange: () => {
      studio.upload(this.file.files[0]);
      this.file.value = "";              // so that the same one may be chosen again
    } });
    this.element.after(this.file);
    const inside = ({ relatedTarget }) => this.element.contains(relatedTarget);
    this.element.addEventListener("keydown", async (event) => {
      if (event.ctrlKey || event.altKey || event.metaKey || !/^(Arrow\w+|Home|End|Escape|\S)$/u.test(event.key)) return;
      event.preventDefault();
      event.stopPropagation();
      (this.made || await this.menus()).keyed(event.key);
    });
    // Tab comes to the key that was there last; the arrow keys go to the others.
    this.element.addEventListener("focusin", (event) => {
      if (!inside(event)) this.from = event.relatedTarget;
      this.menus();
      if (this.keys.includes(event.target)) for (const key of this.keys) key.tabIndex = key === event.target ? 0 : -1;
    });
    this.element.addEventListener("focusout", (event) => { if (!inside(event)) this.made?.open(null); });
  }

  // They come when one is wanted.
  async menus() {
    const { Menus } = await import("./menus.js");
    this.made ??= new Menus(this);
    return this.made;
  }

  async open(key) {
    (await this.menus()).open(key);
  }

  async act(word) {
    (await this.menus()).act(word);
  }

  // What takes long says how far it is, and can be stopped.
  long() {
    const now = Date.now();
    const [first] = this.studio.wire.waiting.values();
    const was = this.stop.hidden;
    this.stop.hidden = !first || now - first.since < 600;
    if (this.stop.hidden !== was) this.state();
    if (this.stop.hidden) return;
    const { done, total, since } = first;
    this.stop.textContent = `${w("stop")} · ${total ? Math.floor(100 * done / total) + " %" : Math.floor((now - since) / 1000) + " s"}`;
  }

  state() {
    const { studio } = this;
    $("state").textContent = !this.stop.hidden ? w("working")
      : studio.ready && !studio.gone ? w(studio.saved ? "saved" : "changed") : w("connecting");
    $("state").className = !studio.saved || studio.gone ? "changed" : "";
  }
}
