// The bar: menus, what has become of the document, and a stop for what takes long.

import { $, h, arrows } from "./dom.js";
import { w, otherTongue } from "./words.js";
import { LOOKS, lookCalled } from "./link.js";

export const FORMATS = {
  drawing: ["pdf", "svg", "dxf", "hpgl", "png", "eps", "json"],
  shaded: ["png"],
  pattern: ["pdf", "svg", "dxf", "fold"],
  model: ["stl", "obj", "off", "ply", "pl"],
  page: ["html"],
};

export class Bar {
  constructor(studio) {
    this.studio = studio;
    const button = (word, act, sign) => (sign ? h("button", { onclick: act, "data-label": word }, sign)
      : h("button", { onclick: act, "data-word": word }));
    this.stop = h("button", { id: "stop", hidden: true, onclick: () => studio.wire.stop() });
    $("state").after(this.stop);
    setInterval(() => this.long(), 300);
    $("menus").append(
      this.menu("open", () => this.openMenu()), button("save", () => studio.save()), this.menu("export", () => this.exportMenu()),
      this.menu("menu", () => this.viewMenu()), button("undo", () => studio.change("undo"), "↶"),
      button("redo", () => studio.change("redo"), "↷"), button("language", () => otherTongue()),
      this.menu("help", () => ["pointing", "keys"].map((word) => h("p", {}, w(word))), "?"));
  }

  menu(word, made, sign) {
    const list = h("div", { class: "menu", hidden: true });
    const key = h("button", { "aria-haspopup": "true", "aria-expanded": "false",
      [sign ? "data-label" : "data-word"]: word,
      onclick: () => {
        opened(list.hidden);
        if (list.hidden) return;
        list.replaceChildren(...made());
        list.querySelector("button, select, input")?.focus();
      } }, sign || "");
    const opened = (on) => {
      list.hidden = !on;
      key.setAttribute("aria-expanded", String(on));
    };
    list.addEventListener("done", () => opened(false));
    const box = h("span", { class: "menubox",
      onkeydown: (event) => {
        if (event.key === "Escape") { opened(false); key.focus(); event.stopPropagation(); }
        arrows(list, event);
      },
      onfocusout: (event) => { if (!box.contains(event.relatedTarget)) opened(false); } }, key, list);
    return box;
  }

  openMenu() {
    const { studio } = this;
    const choice = (name, keys) => h("button", { class: "code", onclick: (event) => {
      event.target.closest(".menu")?.dispatchEvent(new Event("done"));
      studio.opened(name, null, keys);
    } }, name);
    const file = h("input", { type: "file", class: "unseen",
      onchange: () => studio.upload(file.files[0]) });
    return [...studio.models.map((name) => choice(name)), ...studio.uploads.map((name) => choice(name, { upload: true })),
      h("label", { class: "file" }, w("upload"), file)];
  }

  exportMenu() {
    const { studio } = this;
    return studio.formats.map(([what, formats]) => h("p", { class: "formats" },
      h("span", {}, w(what + "_of")),
      ...formats.map((format) => h("button", { class: "code", onclick: (event) => {
        event.target.closest(".menu").dispatchEvent(new Event("done"));
        studio.export(what, format);
      } }, format))));
  }

  viewMenu() {
    const { studio } = this;
    const choice = (key) => {
      const select = h("select", { onchange: () => { studio.looks[key] = select.value; studio.looked(); } },
        ...LOOKS[key].map((value) => h("option", { value }, lookCalled(value))));
      select.value = studio.looks[key] || LOOKS[key][0];
      return h("label", {}, w(key), select);
    };
    const central = h("input", { type: "checkbox", checked: studio.looks.projection === "central",
      onchange: () => { studio.looks.projection = central.checked ? "central" : "parallel"; studio.looked(); } });
    const count = h("select", { onchange: () => studio.ports.many(Number(count.value)) },
      ...[1, 2, 3, 4, 5, 6].map((value) => h("option", { value }, String(value))));
    count.value = studio.ports.ports.length;
    return [choice("hidden"), choice("lines"), choice("up"),
      h("label", {}, w("central"), central), h("label", {}, w("ports"), count),
      ...(studio.record ? [] : [h("button", { onclick: () => studio.halved() }, w("two_windows"))])];
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
