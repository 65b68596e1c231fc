// What can be done, in one table: the menus, Ctrl-K, the keys and the help are made of it.

import { $ } from "./dom.js";
import { w, otherTongue } from "./words.js";
import { KINDS, SHADES, SHEET, shadeCalled, kindsOf } from "./kinds.js";
import { LOOKS, lookCalled } from "./link.js";

export const FORMATS = {
  drawing: ["pdf", "svg", "dxf", "hpgl", "png", "eps", "json"],
  shaded: ["png"],
  pattern: ["pdf", "svg", "dxf", "fold"],
  model: ["stl", "obj", "off", "ply", "pl"],
  page: ["html"],
};

const MENU_OF = { unfold: "unfolding", folded: "unfolding", apart: "solid", sheet: "sheets" };
const WHILE_TYPING = /^(Ctrl\+[KS]|F6)$/;

// Rows, each with its `menu`, its `group` in that, a list of words, what it is
// `called`, what it does, `act`, on which half of two windows, `side`, and
//   one   whether it is the one of its group
//   tick  whether it is so
//   off   whether it cannot be done now
//   keys  of the keyboard
export function commands(studio) {
  const { looks, ports, tree, asking, record, isText, names } = studio;
  const port = ports.focused(), { settings } = port;
  const kind = (name) => [w(name), () => port.turnTo(name), { one: port.kind === name, keys: KINDS.indexOf(name) < 7 && [String(KINDS.indexOf(name) + 1)] }];
  // What is set in a port, which then shows that.
  const set = (of, key, values, called = (value) => value) => values.map((value) => [called(value), () => {
    settings[key] = value;
    port.at = null;
    port.turnTo(of);
  }, { one: port.kind === of && (settings[key] ?? values[0]) === value }]);
  const many = (key, values) => values.map((value) => {
    const on = settings[key].includes(value);
    return [value.length > 1 ? w(value) : value, () => {
      settings[key] = values.filter((one) => (one === value ? !on : settings[key].includes(one)));
      port.turnTo("sheet");
    }, { tick: on }];
  });
  const look = (key) => ["menu", [key], LOOKS[key].map((value) => [lookCalled(value), () => {
    looks[key] = value;
    studio.looked();
  }, { one: (looks[key] || LOOKS[key][0]) === value }]), "ports"];
  const pane = (name, keys) => [w(name), () => { studio.paneTo("left"); studio.leftTo(name); }, { keys }];
  const edge = names.length === 1 && isText && /^s(\d+)e(\d+)$/.exec(names[0]);
  const wish = (word, keep) => [w(word), () => studio.change("cut", { segment: Number(edge[1]), edge: Number(edge[2]), keep }), { off: !edge }];
  const tried = (word, keep) => [w(word), () => studio.rules.end(keep), { off: (studio.rules?.tried ?? null) === null }];
  const live = (...sections) => (record ? [] : sections);
  const segment = (one) => `s${one} ${tree.called(Number(one))}`;
  return [
    ...live(["file", ["open"], [...studio.models.map((name) => [name, () => studio.opened(name)]),
      ...studio.uploads.map((name) => [name, () => studio.opened(name, null, { upload: true })]), [w("upload"), () => studio.bar.file.click()]]],
    ...live(["file", [], [[w("save"), () => studio.save(), { keys: ["Ctrl+S"] }]]],
    ...Object.entries(FORMATS).map(([what, formats]) => ["file", ["export", what + "_of"], formats.map((format) =>
      [format, () => studio.export(what, format)]), "ports"]))),
    ...kindsOf(studio).filter((name) => !["section", "shaded"].includes(name)).map((name) => [MENU_OF[name] || "menu", [], [kind(name)], "ports"]),
    ...["hidden", "lines", "up"].map(look),
    ["menu", [], [[w("central"), () => {
      looks.projection = looks.projection === "central" ? "parallel" : "central";
      studio.looked();
    }, { tick: looks.projection === "central" }], [w("fit"), () => port.fit(), { keys: ["0"] }],
    [w("larger"), () => ports.enlarge(port), { tick: Boolean(ports.one) }], [w("next_port"), () => ports.next(), { keys: ["F6"] }]], "ports"],
    ["menu", ["ports"], [1, 2, 3, 4, 5, 6].map((count) => [String(count), () => ports.many(count), { one: ports.ports.length === count }]), "ports"],
    ...live(["menu", ["two_windows"], ["ports", "left"].map((half) => [w("half_" + half), () => studio.halved(half), { off: Boolean(document.body.dataset.half) }])],
      ["solid", ["section"], set("section", "axis", ["y", "x", "z"]), "ports"]),
    ["solid", ["shaded"], set("shaded", "shade", SHADES, shadeCalled), "ports"],
    ["solid", [], [pane("tree", ["T"]), pane("text", ["X"])], "left"],
    ["solid", ["tree"], studio.segments.map(({ segment: one, name }) => [segment(one), () => {
      studio.leftTo("tree");
      tree.choose(one, "/" + one, 0);
    }, { one: tree.segment === one, doc: name }]), "left"],
    ...live(["unfolding", ["segment_of"], set("unfold", "segment", ["", ...tree.unfoldable().map(String)], (one) => (one ? segment(one) : w("all_segments"))), "ports"],
      ["unfolding", [], [wish("cut", false), wish("join", true), wish("either", null)], "left"],
      ...Object.entries(SHEET).map(([key, values]) => ["sheets", [key], Array.isArray(settings[key]) ? many(key, values) : set("sheet", key, values, (value) => (/\d|^.?m$/.test(value) ? value : w(value))), "ports"]),
      ["sheets", [], [[w("pens"), () => { settings.pens = !settings.pens; port.turnTo("sheet"); }, { tick: Boolean(settings.pens) }]], "ports"],
      ["sheets", [], [[w("title_block"), () => studio.titleBlock(), { off: !isText }]], "left"]),
    ["rules", [], [pane("rules"), ...(record ? [] : [tried("keep_rules", true), tried("discard", false)])], "left"],
    ["rules", ["ask"], [[w("question"), () => { studio.paneTo("asking"); $("goal").focus(); }, { keys: ["/"] }],
      ...(isText ? [[w("save_question"), () => { studio.paneTo("asking"); asking.naming(); }]] : []),
      [w("clear"), () => { asking.clear(); studio.chosen([]); studio.tried(); }, { keys: ["Esc"] }],
      ...asking.questions.map(({ name, goal }) => [name, () => asking.pose(goal), { doc: goal }])], "left"],
    [null, [], [...(record ? [] : [[w("undo"), () => studio.change("undo"), { word: "undo", keys: ["Ctrl+Z"] }],
      [w("redo"), () => studio.change("redo"), { word: "redo", keys: ["Ctrl+Y", "Ctrl+Shift+Z"] }]]),
    ["한국어 / English", otherTongue, { word: "language" }],
    [w("find"), () => studio.find(), { word: "find", keys: ["Ctrl+K"] }],
    [w("help"), () => studio.find("help"), { word: "help", keys: ["?"] }]]],
  ].flatMap(([menu, group, rows, side]) => rows.map(([called, act, more]) => ({ menu, group, side, called, act, ...more })));
}

export const fullName = ({ menu, group, called }) => [...(menu ? [menu, ...group] : []).map((word) => w(word)), called].join(": ");

// Does a row, in the window that it is of.
export function run(studio, row) {
  const { half } = document.body.dataset;
  if (row.off) return;
  if (row.side && half && half !== row.side) studio.other.postMessage({ run: fullName(row) });
  else row.act();
}

// Whether a key of the keyboard is one of the table: then that is done.
export function keyed(studio, event) {
  const { key, code, altKey, shiftKey, target } = event;
  const control = event.ctrlKey || event.metaKey;
  const plain = key === "Escape" ? "Esc" : key.length > 1 ? key : (/[!-~]/.test(key) ? key : code.replace(/^Key/, "")).toUpperCase();
  const name = (control ? "Ctrl+" + (shiftKey ? "Shift+" : "") : "") + plain;
  if (altKey || (/^(input|textarea|select)$/i.test(target.tagName) && !WHILE_TYPING.test(name))) return;
  const row = commands(studio).find(({ keys }) => keys && keys.includes(name));
  if (!row) return;
  event.preventDefault();
  run(studio, row);
}
