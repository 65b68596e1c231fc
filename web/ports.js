// The view ports, each with one picture of the document.

import { reworded } from "./words.js";
import { KINDS } from "./kinds.js";
import { Port } from "./port.js";

// Where there is room for one port at a time.
const PHONE = "(max-width: 520px), (max-height: 480px)";

// The colour monitor: all ports.
export class Ports {
  constructor(studio, element) {
    this.studio = studio;
    this.element = element;
    element.addEventListener("focusin", ({ target }) => {
      this.used = this.ports.find((port) => port.element.contains(target));
      for (const port of this.ports) port.element.classList.toggle("used", port === this.used);
    });
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
    return this.ports.every(({ picture }) => !picture.shown || !picture.space || names.every((name) => picture.draws(name)));
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

  // The port that was used last.
  focused() {
    return this.one || (this.ports.includes(this.used) ? this.used : this.ports[0]);
  }

  kept() {
    localStorage.setItem("ports", JSON.stringify(this.ports.map((port) => port.kind)));
  }
}
