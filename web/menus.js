// The menus of the bar, made of the table of commands, and their keys.

import { h } from "./dom.js";
import { w } from "./words.js";
import { commands, run } from "./commands.js";

const MOST = 24;               // rows of a group: Ctrl-K finds the others
const INITIALS = "ㄱㄲㄴㄷㄸㄹㅁㅂㅃㅅㅆㅇㅈㅉㅊㅋㅌㅍㅎ";

// A syllable of Korean begins with its consonant, too.
function begins({ textContent }, letter) {
  const first = textContent.trim().slice(0, 1).toLowerCase();
  return first === letter.toLowerCase() || INITIALS[Math.floor((first.charCodeAt(0) - 0xac00) / 588)] === letter;
}

export class Menus {
  constructor(bar) {
    Object.assign(this, { studio: bar.studio, element: bar.element, keys: bar.keys, bar });
  }

  // The menu of a key alone is open, or none; the keyboard is at its first row, or its last.
  open(key, last = false) {
    for (const list of this.element.querySelectorAll(".menu")) {
      const one = list.previousSibling, on = one === key;
      one.setAttribute("aria-expanded", String(on));
      list.hidden = !on;
      if (!on) continue;
      list.replaceChildren(...this.groups(one.dataset.word));
      list.style.translate = "";
      const { right, x } = list.getBoundingClientRect();
      list.style.translate = `${Math.min(0, Math.max(4 - x, innerWidth - 4 - right))}px`;
      const items = list.querySelectorAll("button");
      items[last ? items.length - 1 : 0]?.focus();
    }
  }

  // A key of the bar that is no menu.
  act(word) {
    run(this.studio, commands(this.studio).find((row) => row.word === word));
  }

  // What may be opened, as buttons.
  openers() {
    return commands(this.studio).filter(({ group }) => group[0] === "open").map(({ called, act }) => h("button", { onclick: act }, called));
  }

  // A row of a menu for each group of the table.
  groups(menu) {
    const { studio } = this, out = [];
    let head = null, rows = [];
    const rowsOf = commands(studio).filter((row) => row.menu === menu && (studio.ready || row.group[0] === "open"));
    rowsOf.forEach((row, i) => {
      const { group } = row, next = rowsOf[i + 1];
      rows.push(row);
      if (next && String(next.group) === String(group)) return;
      if (group.length > 1 && group[0] !== head) out.push(h("p", {}, w(group[0])));
      [head] = group;
      const items = rows.slice(0, MOST).map((one) => this.item(one));
      if (rows.length > MOST) items.push(this.item({ called: `… ${w("more", rows.length - MOST)}`, act: () => studio.find() }));
      out.push(h("div", { role: "group", class: group.length ? "named" : null, "aria-label": group.map((word) => w(word)).join(": ") || null },
        group.length ? h("span", { "aria-hidden": "true" }, w(group.at(-1))) : null, h("div", { class: "items", role: "none" }, ...items)));
      rows = [];
    });
    return out;
  }

  item(row) {
    const { one, tick, off, keys, called } = row, on = one ?? tick;
    return h("button", { role: one !== undefined ? "menuitemradio" : tick !== undefined ? "menuitemcheckbox" : "menuitem", tabindex: -1,
      "aria-checked": on === undefined ? null : String(on), "aria-disabled": off && "true",
      "aria-keyshortcuts": keys && keys.join(" ").replaceAll("Ctrl", "Control"),
      onclick: () => { this.leave(); run(this.studio, row); } }, h("span", {}, called), keys ? h("kbd", {}, keys[0]) : null);
  }

  // Menus are closed, and the keyboard is where it was before it came here.
  leave() {
    const { from } = this.bar;
    this.open(null);
    if (from?.isConnected) from.focus();
    else document.activeElement?.blur();
  }

  keyed(pressed) {
    const target = document.activeElement;
    const list = target.closest(".menu");
    const key = list ? list.previousSibling : target;
    const items = list ? [...list.querySelectorAll("button")] : this.keys.filter((one) => one.offsetParent);
    const at = items.indexOf(target), { length } = items;
    const step = { ArrowRight: 1, ArrowLeft: -1 }[pressed], along = { ArrowDown: 1, ArrowUp: -1 }[pressed];
    if (step) {
      const keys = this.keys.filter((one) => one.offsetParent);
      const next = keys[(keys.indexOf(key) + step + keys.length) % keys.length];
      next.focus();
      if (list) this.open(next);
    } else if (along && list) items[(at + along + length) % length].focus();
    else if (along) this.open(key, along < 0);
    else if (pressed === "Home") items[0].focus();
    else if (pressed === "End") items[length - 1].focus();
    else if (pressed === "Escape") {
      this.open(null);
      key.focus();
    } else {
      [...items.slice(at + 1), ...items.slice(0, at)].find((one) => begins(one, pressed))?.focus();
    }
  }
}
