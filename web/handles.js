// The segment that was chosen in the tree, in space: dots of a picture that pull a
// size, or a placement, of it.

import { s } from "./dom.js";
import { spaceOf } from "./space.js";

const UNIT = [[1, 0, 0], [0, 1, 0], [0, 0, 1]];
// Along which axis of a primitive the number of a size is.
const SIZES = { radius: [0], height: [2], size: [0, 1, 2] };
const ARROW = 46;               // dots of the screen

// A matrix is where the axes and the origin come to.
const NOWHERE = [...UNIT, [0, 0, 0]];
const along = (m, v) => UNIT.map((_, k) => m[0][k] * v[0] + m[1][k] * v[1] + m[2][k] * v[2]);
const placed = (m, p) => along(m, p).map((n, k) => n + m[3][k]);
const times = (m, n) => [...n.slice(0, 3).map((axis) => along(m, axis)), placed(m, n[3])];

// What a step of at/2 does; null: something else than is pulled here.
function stepMatrix({ name, args }) {
  if (!args.every((arg, i) => typeof arg === "number" || (name === "rotate" && i === 0))) return null;
  if (name === "translate" && args.length === 3) return [...UNIT, args];
  if (name === "scale" && args.length === 3) return [...UNIT.map((axis, k) => axis.map((n) => n * args[k])), [0, 0, 0]];
  const axis = "xyz".indexOf(args[0]);
  if (name !== "rotate" || args.length !== 2 || axis < 0) return null;
  const [c, w] = [Math.cos, Math.sin].map((f) => f(args[1] * Math.PI / 180));
  const [i, j] = [(axis + 1) % 3, (axis + 2) % 3];
  const out = NOWHERE.map((one) => [...one]);
  [out[i][i], out[i][j], out[j][i], out[j][j]] = [c, w, -w, c];
  return out;
}

const stepsMatrix = (steps) => steps.reduce((m, step) => {
  const next = m && stepMatrix(step);
  return next && times(next, m);
}, NOWHERE);

// Where the first use of a segment in the tree puts it; null: nowhere to be told.
function placeOf(tree, segment) {
  const found = (term, m, above) => {
    if (term === segment) return m;
    if (typeof term === "number") {
      const one = tree.byNumber.get(term);
      return one && !above.includes(term) ? found(one.term, m, [...above, term]) : null;
    }
    if (!term || !term.args || !m) return null;
    const { name, args } = term;
    if (name === "named") return found(args[1], m, above);
    if (name === "at") {
      const own = stepsMatrix(args[0]);
      return own && found(args[1], times(m, own), above);
    }
    for (const operand of Array.isArray(args[0]) ? args[0] : []) {
      const place = found(operand, m, above);
      if (place) return place;
    }
    return null;
  };
  for (const root of tree.roots) {
    const place = found(root, NOWHERE, []);
    if (place) return place;
  }
  return null;
}

// The numbers of a term that can be pulled: each with its path, the axis that it
// goes along, and whether that is an arrow from the middle.
function pulled(forms, term, path, after, out) {
  const { name, args } = term || {};
  if (name === "named") pulled(forms, args[1], [...path, 2], after, out);
  else if (name === "at") {
    let own = after;
    for (let i = args[0].length - 1; i >= 0 && own; i--) {
      const step = args[0][i];
      const from = own;
      if (step.name === "translate") {
        step.args.forEach((value, k) => typeof value === "number" && out.push({ value, path: [...path, 1, i + 1, k + 1],
          axis: along(from, UNIT[k]), name: "translate " + "xyz"[k], arrow: true }));
      }
      const next = stepMatrix(step);
      own = next && times(own, next);
    }
    if (own) pulled(forms, args[1], [...path, 2], own, out);
  } else if (forms[name]) {
    args.forEach((arg, i) => (SIZES[arg && arg.name] || []).forEach((axis, k) => {
      const value = arg.args[k];
      if (typeof value === "number") out.push({ value, path: [...path, i + 1, k + 1], axis: along(after, UNIT[axis]),
        name: arg.args.length > 1 ? `${arg.name} ${"xyz"[axis]}` : arg.name });
    }));
  }
  return out;
}

export class Handles {
  constructor(studio) {
    this.studio = studio;
    this.list = [];
  }

  // Those of a segment; none where it cannot be told where it is.
  async choose(segment) {
    const { tree, wire, record, isText } = this.studio;
    const one = tree.byNumber?.get(segment);
    const place = one && !record && isText && placeOf(tree, segment);
    this.wanted = (this.wanted || 0) + 1;
    const { wanted } = this;
    let list = place ? pulled(tree.model.forms, one.term, [], NOWHERE, []) : [];
    try {
      if (list.length) {
        const goal = `aggregate_all(b(min(X),min(Y),min(Z),max(X),max(Y),max(Z)), v(${segment},_,X,Y,Z), B)`;
        const { head } = await wire.ask("ask", { goal });
        const n = String(head.answers[0]?.[0]).match(/-?\d[\d.]*(e[-+]?\d+)?/gi)?.map(Number) || [];
        const [low, high] = [n.slice(0, 3), n.slice(3, 6)];
        const middle = low.map((x, k) => (x + high[k]) / 2);
        list = n.length < 6 ? [] : list.map((one) => {
          const far = Math.hypot(...one.axis);
          const reach = one.arrow ? 0 : one.axis.reduce((sum, x, k) => sum + Math.abs(x) * (high[k] - low[k]) / 2, 0) / far / far;
          return { ...one, at: placed(place, middle.map((x, k) => x + one.axis[k] * reach)), middle: placed(place, middle),
            axis: along(place, one.axis), target: { segment, path: one.path },
            get value() { return tree.valueOf(this.target); } };
        });
      }
    } catch (error) {
      list = [];
    }
    if (wanted !== this.wanted) return;
    this.list = list;
    for (const port of this.studio.ports.ports) this.draw(port);
  }

  draw(port) {
    const { picture } = port;
    port.knobs ??= picture.svg.appendChild(s("g", { class: "handles" }));
    const held = port.knobs.contains(document.activeElement) ? document.activeElement.dataset.name : null;
    const space = port.kind === "section" ? null : spaceOf(port, picture.shown);
    if (!space) {
      port.knobs.replaceChildren();
      return;
    }
    const { scale, seen, where } = space;
    const size = picture.svg.getScreenCTM()?.a || 1;
    port.knobs.replaceChildren(...this.list.flatMap((one) => {
      const way = seen(one.axis, one.middle);
      const far = Math.hypot(...way);
      if (far < 0.15 * scale * Math.hypot(...one.axis)) return [];    // it goes to the eye
      const from = where(one.middle);
      const to = one.arrow ? from.map((n, k) => n + way[k] / far * ARROW / size) : where(one.at);
      const knob = s("path", { d: `M${to.join(" ")}h0`, class: one.arrow ? "knob place" : "knob", tabindex: 0, role: "slider", "data-name": one.name,
        "aria-label": this.studio.tree.heard(one.name), "aria-valuenow": one.value,
        onpointerdown: (event) => this.pull(event, one, way.map((n) => n * size)),
        onkeydown: (event) => this.keyed(event, one) });
      knob.append(s("title", {}));
      knob.firstChild.textContent = `${this.studio.tree.heard(one.name)} ${one.value}`;
      return [s("path", { class: "stalk", d: `M${from.join(" ")}L${to.join(" ")}` }), knob];
    }));
    if (held) [...port.knobs.children].find(({ dataset }) => dataset.name === held)?.focus();
  }

  // `way`: dots of the screen for one unit more.
  pull(event, one, way) {
    event.stopPropagation();
    event.preventDefault();
    const { tree } = this.studio;
    const [x, y] = [event.clientX, event.clientY];
    const square = way[0] ** 2 + way[1] ** 2;
    tree.drag = (tree.drag || 0) + 1;
    const from = one.value;
    const moved = (next) => this.put(one, from + ((next.clientX - x) * way[0] + (next.clientY - y) * way[1]) / square,
      1 / Math.sqrt(square));
    const up = () => {
      window.removeEventListener("pointermove", moved);
      window.removeEventListener("pointerup", up);
    };
    window.addEventListener("pointermove", moved);
    window.addEventListener("pointerup", up);
  }

  keyed(event, one) {
    const way = { ArrowUp: 1, ArrowRight: 1, ArrowDown: -1, ArrowLeft: -1 }[event.key];
    if (!way) return;
    event.stopPropagation();
    event.preventDefault();
    const { tree } = this.studio;
    const step = 10 ** (Math.floor(Math.log10(Math.abs(one.value) || 1)) - 1);
    tree.drag = (tree.drag || 0) + 1;
    this.put(one, one.value + way * step, step);
  }

  // A size is more than nothing; no more digits than a dot can tell.
  put(one, value, step) {
    const unit = 10 ** Math.floor(Math.log10(step));
    const number = Number((Math.round(value / unit) * unit).toPrecision(12));
    if (one.arrow || number > 0) this.studio.tree.set(one.target, number);
  }
}
