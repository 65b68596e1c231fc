// A picture: strokes as numbers, what is lit, and which line is near a point.

import { s } from "./dom.js";
import { Nearest } from "./nearest.js";

// Which segment is meant by another one, and whether it has its edges: parts of
// what is taken apart have, and patterns of facets. These have both halves of an
// edge, with which the body begins; pictures have one, by whose number it goes.
// `rest` is where the body goes on.
export function laidOf({ head, body }) {
  const laid = new Map((head.parts || []).map(([part, segment]) => [part, { segment, edges: true }]));
  let rest = 0;
  for (const { pattern, segment, edges, halves } of head.patterns || []) {
    const n = new Int32Array(body, rest, 2 * halves), other = new Map();
    for (let i = 0; i < n.length; i += 2) other.set(n[i], n[i + 1]);
    laid.set(pattern, { segment, edges, halves: other });
    rest += n.byteLength;
  }
  return { laid, rest };
}

export const edgeIn = ({ halves }, edge) => halves?.get(edge) ?? edge;

// The strokes of a reply (docs/protocol.md).
export function strokesOf({ head, body }) {
  const { laid, rest } = laidOf({ head, body });
  const n = new Int32Array(body, rest);
  const strokes = [];
  for (let i = 0; i < n.length;) {
    const [look, segment, ends, e, p] = n.subarray(i, i + 5);
    const edges = n.subarray(i + 5, i + 5 + e);
    const points = n.subarray(i + 5 + e, i + 5 + e + 2 * p);
    const of = laid.get(segment) || { segment, edges: true };
    // A line in the plane of a section lies in a polygon of the model.
    const letter = head.section && head.looks[look][1] === "section" ? "p" : "e";
    strokes.push({ look, segment: of.segment, letter, closed: ends >> 2 === 2, edges: of.edges ? edges.map((edge) => edgeIn(of, edge)) : [], points,
      whole: !of.edges && e > 0 });
    i += 5 + e + 2 * p;
  }
  return { strokes, looks: head.looks, sheet: head.sheet, place: head.place, central: head.central, texts: head.texts || [] };
}

export const nameIn = ({ segment, letter }, edge) => nameOf(segment, edge, letter);

const pair = (points, i) => `${points[2 * i]} ${points[2 * i + 1]}`;

function wholePath(stroke) {
  const { points } = stroke;
  let d = `M${points[0]} ${points[1]}L`;
  for (let i = 2; i < points.length; i++) d += points[i] + " ";
  return stroke.closed ? d + "Z" : d;
}

// The part of a stroke that shows the edges for which `of` holds.
export function partPath(stroke, of) {
  const { edges, points } = stroke;
  const pieces = points.length / 2 - 1;
  if (edges.length < pieces) {
    return [...edges].some(of) ? wholePath(stroke) : "";
  }
  let d = "";
  for (let i = 0; i < edges.length; i++) {
    if (of(edges[i])) d += `M${pair(points, i)}L${pair(points, (i + 1) % (pieces + 1))}`;
  }
  return d;
}

const FILLING = new Set(["hatching", "fold_up", "fold_down", "number", "face_name"]);

// An edge whose number is 0 has no name of its own.
export const nameOf = (segment, edge, letter = "e") => (edge ? `s${segment}${letter}${edge}` : `s${segment}`);

// Of each segment, with the letter of such names, which numbers; a whole segment
// has no letter.
class Numbers extends Map {
  constructor(names) {
    super();
    for (const name of names) {
      const [, segment, letter = "", number] = /^s(\d+)(?:([ep])(-?\d+))?$/.exec(name) || [];
      if (segment) this.add(segment + letter, Number(number));
    }
  }

  add(key, number) {
    if (!this.has(key)) this.set(key, new Set());
    this.get(key).add(number);
  }
}

export class Picture {
  constructor(layers = ["gone", "came", "changed", "lit", "hover", "chosen"]) {
    this.lines = s("g", { class: "lines" });
    this.letters = s("g", { class: "letters" });
    this.layers = {};
    this.mine = s("g", { class: "mine" });
    for (const layer of layers) this.layers[layer] = s("path", { class: layer });
    this.image = s("image", { preserveAspectRatio: "xMidYMid meet" });
    this.svg = s("svg", { preserveAspectRatio: "xMidYMid meet" }, this.image, this.mine, this.lines, this.letters,
      ...Object.values(this.layers));
    this.shown = null;
    this.lit = {};
    this.ends = {};
  }

  // Nothing of a drawing is left.
  clear() {
    this.shown = null;
    this.paint();
    for (const group of [this.lines, this.letters, this.mine]) group.replaceChildren();
    for (const layer of Object.values(this.layers)) layer.setAttribute("d", "");
  }

  // An image below the lines, in a box, or none. It comes when it is decoded.
  async paint(body, box = this.box) {
    this.painted = body;
    const address = body && URL.createObjectURL(new Blob([body], { type: "image/png" }));
    if (body) await Object.assign(new Image(), { src: address }).decode().catch(() => {});
    if (this.painted !== body) {
      if (address) URL.revokeObjectURL(address);
      return;
    }
    URL.revokeObjectURL(this.image.getAttribute("href"));
    for (const [i, name] of ["x", "y", "width", "height"].entries()) this.image.setAttribute(name, box?.[i] ?? 0);
    if (body) this.image.setAttribute("href", address);
    else this.image.removeAttribute("href");
  }

  // `space` says where a point of the model is in it, if that can be told.
  show(picture, space = null) {
    this.mine.replaceChildren();
    this.shown = picture;
    this.space = space;
    this.drawn = null;
    this.nearest = null;
    const paths = picture.looks.map(() => "");
    for (const stroke of picture.strokes) paths[stroke.look] += wholePath(stroke);
    this.lines.replaceChildren(...picture.looks.map(([visibility, role], i) =>
      s("path", { class: `${visibility} ${role}`, d: paths[i] })));
    this.letters.replaceChildren(...picture.texts.map(([x, y, high, anchor, text]) => {
      const element = s("text", { x, y, "font-size": high * 1.4,
        "text-anchor": anchor });
      element.textContent = text;
      return element;
    }));
    this.look(0, 0, ...picture.sheet);
    for (const layer of Object.keys(this.lit)) this.light(layer, this.lit[layer], this.ends[layer]);
    this.layers.hover.setAttribute("d", "");
  }

  look(x, y, width, height) {
    this.box = [x, y, width, height];
    this.svg.setAttribute("viewBox", this.box.join(" "));
  }

  // The point of the sheet at one of the screen; null: it is not on the screen.
  at(clientX, clientY) {
    const matrix = this.svg.getScreenCTM();
    return matrix && new DOMPoint(clientX, clientY).matrixTransform(matrix.inverse());
  }

  // Which part of the sheet the screen has room for; null: none.
  inSight() {
    if (!this.svg.getScreenCTM()) return null;
    const { x, y, right, bottom } = this.svg.getBoundingClientRect();
    const [from, to] = [this.at(x, y), this.at(right, bottom)];
    return [from.x, from.y, to.x - from.x, to.y - from.y];
  }

  // left, top, right, bottom of strokes.
  around(strokes) {
    const box = [Infinity, Infinity, -Infinity, -Infinity];
    for (const { points } of strokes) {
      for (let i = 0; i < points.length; i++) {
        box[i % 2] = Math.min(box[i % 2], points[i]);
        box[i % 2 + 2] = Math.max(box[i % 2 + 2], points[i]);
      }
    }
    return box;
  }

  // Looks at all; the lines of one role are left out where they are wider than the rest.
  fit(but) {
    const { strokes, looks } = this.shown;
    const rest = strokes.filter(({ look }) => looks[look][1] !== but);
    const wide = ([left, , right]) => right - left;
    const bare = rest.length < strokes.length && wide(this.around(strokes)) > 1.1 * wide(this.around(rest));
    this.svg.classList.toggle("bare", bare);
    const [left, top, right, bottom] = this.around(bare ? rest : strokes);
    if (right < left) return;
    const edge = 0.06 * Math.max(right - left, bottom - top);
    this.look(left - edge, top - edge, right - left + 2 * edge, bottom - top + 2 * edge);
  }

  // Whether a line shows the edge of that name.
  draws(name) {
    if (!this.drawn) {
      this.drawn = new Numbers([]);
      for (const { segment, letter, edges } of this.shown.strokes) for (const edge of edges) this.drawn.add(segment + letter, edge);
    }
    const [[key, numbers]] = new Numbers([name]);
    return [...numbers].every((number) => this.drawn.get(key)?.has(number));
  }

  // Lights the lines of these names, a Set of s2, s2e7; of a whole segment what
  // is seen of it, if anything is, and not what fills its faces. Edges that no line
  // shows, such as those within a smooth surface, are lit where their `ends` are.
  light(layer, names, ends) {
    this.lit[layer] = names;
    this.ends[layer] = ends;
    if (!this.shown) return;
    const { strokes, looks } = this.shown;
    const hidden = ({ look }) => looks[look][0] === "hidden";
    const lit = new Numbers(names);
    const seen = new Set(strokes.filter((stroke) => lit.has(String(stroke.segment)) && !hidden(stroke)).map(({ segment }) => segment));
    const whole = (stroke) => lit.has(String(stroke.segment)) && !FILLING.has(looks[stroke.look][1])
      && !(hidden(stroke) && seen.has(stroke.segment));
    const part = (stroke) => {
      const edges = lit.get(stroke.segment + stroke.letter);
      return edges ? partPath(stroke, (edge) => edges.has(edge)) : "";
    };
    const d = names.size ? strokes.map((stroke) => (whole(stroke) ? wholePath(stroke) : part(stroke))).join("") : "";
    const unseen = !ends || !this.space ? [] : Object.entries(ends).filter(([name]) => names.has(name) && !this.draws(name));
    this.layers[layer].setAttribute("d", d + unseen.map(([, at]) => this.space.remains(at).map((v, i) => "ML"[i] + this.space.where(v).join(" ")).join("")).join(""));
  }

  hover(found) {
    if (!this.shown) return;
    this.layers.hover.setAttribute("d", found
      ? found.stroke.whole || !found.edge ? wholePath(found.stroke) : partPath(found.stroke, (edge) => edge === found.edge) : "");
  }

  // The line nearest to a point of the screen, if one is within some pixels.
  near(clientX, clientY, within = 9) {
    const { a } = this.svg.getScreenCTM() || {};
    if (!this.shown || !a) return null;
    const { x, y } = this.at(clientX, clientY);
    this.nearest ??= new Nearest(this.shown);
    const found = this.nearest.at(x, y, within / a);
    return found && { ...found, name: nameIn(found.stroke, found.edge) };
  }

  // The edges of the piece of a pattern, or of the hole in one, that a point of
  // the screen is in: the innermost cut around it.
  pieceAt(clientX, clientY) {
    const at = this.shown && this.at(clientX, clientY);
    if (!at) return [];
    const { x, y } = at;
    let best = [], least = Infinity;
    for (const { segment, edges, points, look, closed } of this.shown.strokes) {
      if (!closed || this.shown.looks[look][1] !== "cut") continue;
      let within = false, area = 0;
      for (let i = 0, j = points.length - 2; i < points.length; j = i, i += 2) {
        const [ax, ay, bx, by] = [points[i], points[i + 1], points[j], points[j + 1]];
        if (ay > y !== by > y && x < (bx - ax) * (y - ay) / (by - ay) + ax) within = !within;
        area += bx * ay - ax * by;
      }
      if (within && Math.abs(area) < least) [best, least] = [Array.from(edges, (edge) => nameOf(segment, edge)), Math.abs(area)];
    }
    return best;
  }

  // How many strokes there are, and how many of them are hidden.
  counts() {
    const { strokes, looks } = this.shown;
    return [strokes.length, strokes.filter(({ look }) => looks[look][0] === "hidden").length];
  }
}
