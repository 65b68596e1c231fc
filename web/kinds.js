// What a port may show, and what it asks for it. Of each kind:
//   turns   it can be turned
//   slow    it waits until nothing else is wanted
//   live    it asks for what a page that is a file has not
//   tools   elements beside the choice of the port
//   ask     asks for the picture: a promise of { head, body }

import { h } from "./dom.js";
import { w } from "./words.js";
import { Lost } from "./wire.js";
import { PICTORIAL } from "./sight.js";

const MM = 25.4 / 96;

// A choice among words, and a slider; both keep what they say in the port.
function choice(port, key, label, values, named = (value) => value) {
  const select = h("select", { onchange: () => { port.set(key, select.value); } },
    ...values.map((value) => h("option", { value }, named(value))));
  select.value = port.settings[key];
  select.dataset.label = label;
  return select;
}

function slider(port, label, get, moved, limits) {
  const range = h("input", { type: "range", step: "any", ...limits, value: get(),
    oninput: () => moved(Number(range.value)) });
  range.dataset.label = label;
  return range;
}

// The keys of a view of the document; strokes in thousandths of a millimetre.
function viewKeys(port, width, height) {
  const keys = {
    port: port.name, format: "strokes", ...port.studio.looks,
    view: port.turns ? port.angles : port.kind,
    size: [width * MM * port.room, height * MM * port.room].map((mm) => Math.round(mm * 100) / 100),
    margin: Math.min(width, height) * MM * 0.07,
  };
  if (port.scale) keys.scale = port.scale;
  return keys;
}

// Which axis points up, if it is another one.
export const upWords = ({ looks: { up } }) => (up ? ["--up", up] : []);

export const eyeWords = (port) => ["--view", port.angles.map((angle) => angle.toFixed(4)).join(",")];

// What `render` is told, so that its picture is what a view of the model shows in a
// box of its sheet.
export function shadedAs({ head: { place: [scale, x, y, left, top], central } }, looks, angles, [from, high, width, height]) {
  const across = (n) => x + (n - left) / scale, up = (n) => y - (n - top) / scale;
  return ["--view", [...angles, ...(central ? [central[0]] : [])].join(), ...upWords({ looks }),
    "--projection", central ? "central" : "parallel",
    "--window=" + [across(from), up(high + height), across(from + width), up(high), ...(central ? [central[0] + central[1]] : [])]];
}

// `before`: by the rules that the model follows, while others are tried.
const view = {
  ask: (port, width, height) => port.studio.wire.ask("view", viewKeys(port, width, height)),
  before: (port, width, height) => port.studio.wire.ask("view",
    { ...viewKeys(port, width, height), port: port.name + " before", before: true }),
};

// Cut open: the plane is pulled along one axis of the model.
const section = {
  turns: true,
  live: true,
  tools: (port) => {
    port.settings.axis = port.settings.axis || "y";
    port.plane = slider(port, "plane", () => port.at ?? 0, (at) => { port.at = at; port.refresh(); },
      { min: -1, max: 1 });
    const axis = choice(port, "axis", "axis", ["x", "y", "z"]);
    axis.addEventListener("change", () => { port.at = null; });
    return [axis, port.plane];
  },
  ask: async (port, width, height) => {
    const { axis } = port.settings;
    const keys = viewKeys(port, width, height);
    delete keys.projection;
    const reply = await port.studio.wire.ask("view", { hidden: "removed", ...keys,
      section: port.at === null || port.at === undefined ? axis : `${axis}=${port.at}` });
    const { at, low, high } = reply.head.section;
    Object.assign(port.plane, { min: low, max: high });
    if (port.at === null || port.at === undefined) {
      port.at = at;
      port.plane.value = at;
    }
    port.said = w("plane_at", axis, Number(port.at.toPrecision(4)));
    return reply;
  },
};

// The cells of what is glued, moved apart.
const apart = {
  turns: true,
  live: true,
  tools: (port) => {
    port.factor = port.factor ?? 0.4;
    return [slider(port, "apart_by", () => port.factor, (factor) => { port.factor = factor; port.refresh(); },
      { min: 0, max: 2 })];
  },
  ask: (port, width, height) => {
    const keys = viewKeys(port, width, height);
    return port.studio.wire.ask("view", { hidden: "removed", ...keys, explode: port.factor });
  },
};

export const shadeCalled = (value) => w("shade_" + value.split("=")[0]);
export const SHADES = ["lambert", "gooch", "cel=4", "zebra=8", "flat"];

const shaded = {
  turns: true,
  tools: (port) => {
    port.settings.shade = port.settings.shade || "lambert";
    return [choice(port, "shade", "shade", SHADES, shadeCalled)];
  },
  // Coarse as long as it is being turned. Its lines are there to be lit. A page that
  // is a file has one.
  ask: async (port, width, height) => {
    const { wire, record, looks } = port.studio, { extra } = wire;
    wire.extra = {};
    if (record) port.angles = [...PICTORIAL];
    const reply = await view.ask(port, width, height);
    if (reply.head.replaced || port.kind !== "shaded") return reply;
    port.showStrokes(reply);
    const box = record ? [0, 0, ...reply.head.sheet] : port.picture.inSight();
    if (!box) throw new Lost("hidden");
    const fine = port.drag ? 0.5 : Math.min(2, window.devicePixelRatio || 1);
    port.dots = [width, height].map((n) => Math.max(1, Math.round(n * fine)));
    port.words = [...shadedAs(reply, looks, port.angles, box), "--size", port.dots.join("x")];
    port.coarse = Boolean(port.drag);
    return { ...await wire.ask("shaded", { ...extra, options: [...port.words, "--shade", port.settings.shade,
      "--smooth", port.drag ? "1" : "4", "--background", "none"] }), box };
  },
};

// What a sheet may have; of what is said with each, what is usual comes first.
export const SHEET = {
  paper: ["A3", "A4", "A4-landscape", "A3-portrait", "A2", "A1", "A0"],
  views: ["front", "top", "right", "left", "back", "bottom", "isometric"],
  cuts: ["x", "y", "z"],
  scale: ["auto", "1:1", "1:2", "1:5", "1:10", "2:1", "5:1"],
  unit: ["mm", "cm", "m", "inch"],
  angle: ["third", "first"],
};
export const SHEET_SHOWS = { views: ["front", "top", "right", "isometric"], cuts: [] };

// The sheet of a port, as options of `draw`.
export function sheetWords({ settings, studio }) {
  const said = ["scale", "unit", "angle"].filter((key) => (settings[key] ?? SHEET[key][0]) !== SHEET[key][0]);
  const views = settings.views.join() || SHEET_SHOWS.views.join();
  return ["--sheet", settings.paper, ...(views === SHEET_SHOWS.views.join() ? [] : ["--views", views]),
    ...settings.cuts.flatMap((axis) => ["--section", axis]), ...said.flatMap((key) => ["--" + key, settings[key]]),
    "--language", document.documentElement.lang, ...upWords(studio)];
}

function penTools(port) {
  port.along = port.along ?? 1;
  const wanted = h("input", { type: "checkbox", checked: Boolean(port.settings.pens),
    onchange: () => { port.set("pens", wanted.checked); } });
  const label = h("label", { class: "tick" }, wanted, h("span", { "data-word": "pens" }));
  const range = slider(port, "pen_way", () => port.along, (along) => { port.along = along; port.after?.(); },
    { min: 0, max: 1 });
  range.hidden = !port.settings.pens;
  return [label, range];
}

const sheet = {
  slow: true,
  fits: "frame",
  tools: (port) => {
    port.settings.paper = port.settings.paper || "A3";
    return [choice(port, "paper", "paper", SHEET.paper), ...penTools(port)];
  },
  ask: async (port) => {
    const options = sheetWords(port);
    if (!port.settings.pens) {
      port.after = null;
      return port.studio.wire.ask("sheet", { options });
    }
    const asked = port.studio.wire.ask("sheet", { options, pens: true });
    const { penShown } = await import("./pens.js");
    const reply = await asked;
    port.after = () => penShown(port, reply);
    return reply;
  },
};

// Which segment a pattern is of.
function segmentTool(port) {
  const { settings, studio: { record, tree } } = port;
  port.listed = tree.unfoldable();
  if (!port.listed.includes(Number(settings.segment))) settings.segment = "";
  const segment = choice(port, "segment", "segment_of", ["", ...port.listed],
    (one) => (one ? `${one} ${tree.called(one)}` : w("all_segments")));
  segment.hidden = Boolean(record) || port.listed.length < 2;
  return segment;
}

// Asks for the pattern; the choice follows the model.
function patternAsked(port, request) {
  if (String(port.listed) !== String(port.studio.tree.unfoldable())) port.retooled();
  const { segment } = port.settings;
  return port.studio.wire.ask(request, segment ? { segment: Number(segment) } : {});
}

const unfold = { slow: true, fits: "bar", tools: (port) => [segmentTool(port)],
  ask: (port) => patternAsked(port, "unfold") };

const folded = {
  slow: true,
  turns: true,
  own: true,
  tools: (port) => {
    port.part ??= 0.35;
    const folded = (part) => {
      port.part = part;
      port.folding?.fold(part);
    };
    return [segmentTool(port), slider(port, "fold_by", () => port.part, folded, { min: 0, max: 1 })];
  },
  ask: async (port) => {
    port.folding ??= new (await import("./fold.js")).Folding(port);
    return patternAsked(port, "fold");
  },
};

// What the teacher shows to all.
const taught = {
  alone: true,
  fits: "frame",
  ask: async (port) => {
    const reply = await port.studio.wire.ask("shown");
    if (!reply.head.kind) throw new Lost("none");
    port.said = w("taught");
    return reply;
  },
};

const problem = { alone: true, fits: "frame", ask: async (port) => (await import("./problems.js")).posed(port) };

const KIND = { iso: { ...view, turns: true }, front: view, top: view, right: view, left: view, back: view,
  bottom: view, unfold, folded, section, shaded, sheet, apart, taught, problem };

// `problem` is chosen with a problem, `taught` by the teacher, not in the port.
export const KINDS = Object.keys(KIND).filter((name) => !KIND[name].alone);
export const kindsOf = ({ record }) => KINDS.filter((name) => !(record && KIND[name].live));
export const kindOf = (name) => KIND[name] || KIND.iso;
