// The program of a page that was kept as a file: it answers what was recorded.

import { Lost } from "./wire.js";

const octets = (text) => Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0)).buffer;
const turnOf = (a, b) => Math.abs(((a - b + 540) % 360) - 180);

export class Kept extends EventTarget {
  constructor(record) {
    super();
    this.record = record;
    this.number = 0;
    this.waiting = new Map();
  }

  // As Wire has it.
  begin() {
    setTimeout(() => this.dispatchEvent(new CustomEvent("hello", { detail: this.record.hello })));
  }

  get open() {
    return true;
  }

  // As Wire has it.
  async ask(request, keys = {}) {
    this.number += 1;
    const found = this.found(request, keys);
    if (!found) throw Object.assign(new Error(request), { head: { error: this.record.refused } });
    return { head: structuredClone(found.head), body: octets(found.body || "") };
  }

  found(request, keys) {
    const { views, replies, names, reasons, asks } = this.record;
    if (request === "view") {
      if (keys.section !== undefined || keys.explode !== undefined) return null;
      if (typeof keys.view === "string") return views.find(({ view }) => view === keys.view);
      const far = ({ view: [theta, phi] }) => turnOf(theta, keys.view[0]) + Math.abs(phi - keys.view[1]);
      return views.filter(({ view }) => Array.isArray(view)).sort((a, b) => far(a) - far(b))[0];
    }
    if (request === "select") {
      return { head: { selected: keys.names.filter((name) => names[name]).map((name) => names[name]), gone: [] } };
    }
    if (request === "explain") return reasons[keys.item];
    if (request === "ask") return asks[keys.goal];
    if (request === "sheet" && keys.pens) return replies.pens;
    if (request === "complete") throw new Lost("kept");
    return replies[request];
  }
}
