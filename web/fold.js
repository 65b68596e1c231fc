// A pattern that is folded up: each face turns with the fold between it and the
// one before it, and each piece goes to where it is in the model.

import { s } from "./dom.js";
import { edgeIn, nameOf } from "./picture.js";

// Rigid motions: [a, b, c, x, d, e, f, y, g, h, i, z], rows of three and a shift.
const STILL = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0];

const moved = (m, [x, y, z]) => [m[0] * x + m[1] * y + m[2] * z + m[3],
  m[4] * x + m[5] * y + m[6] * z + m[7], m[8] * x + m[9] * y + m[10] * z + m[11]];

function after(m, n) {
  const out = [];
  for (let i = 0; i < 12; i += 4) {
    for (let j = 0; j < 4; j++) {
      out.push(m[i] * n[j] + m[i + 1] * n[4 + j] + m[i + 2] * n[8 + j] + (j === 3 ? m[i + 3] : 0));
    }
  }
  return out;
}

// By an angle about a line in the plane z = 0, from a to b.
function about(a, b, angle) {
  const length = Math.hypot(b[0] - a[0], b[1] - a[1]);
  const [x, y] = [(b[0] - a[0]) / length, (b[1] - a[1]) / length];
  const c = Math.cos(angle), sn = Math.sin(angle), t = 1 - c;
  const m = [t * x * x + c, t * x * y, sn * y, 0, t * x * y, t * y * y + c, -sn * x, 0, -sn * y, sn * x, c, 0];
  const [p, q] = [a[0], a[1]];
  m[3] = p - (m[0] * p + m[1] * q);
  m[7] = q - (m[4] * p + m[5] * q);
  m[11] = -(m[8] * p + m[9] * q);
  return m;
}

const minus = (a, b) => a.map((n, i) => n - b[i]);
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
const unit = (a) => { const n = Math.hypot(...a) || 1; return a.map((c) => c / n); };

// Right-handed axes at p, the first towards q, the third away from the plane p q r.
function frame(p, q, r) {
  const x = unit(minus(q, p));
  const z = unit(cross(x, minus(r, p)));
  const y = cross(z, x);
  return { p, x, y, z };
}

// The quaternion of the motion from one frame to another, and the shift of p.
function turnBetween(from, to) {
  const m = [0, 1, 2].map((i) => [0, 1, 2].map((j) =>
    to.x[i] * from.x[j] + to.y[i] * from.y[j] + to.z[i] * from.z[j]));
  const t = [1 + m[0][0] + m[1][1] + m[2][2], 1 + m[0][0] - m[1][1] - m[2][2],
    1 - m[0][0] + m[1][1] - m[2][2], 1 - m[0][0] - m[1][1] + m[2][2]];
  const at = t.indexOf(Math.max(...t));
  const f = 0.5 / Math.sqrt(t[at]);
  const a = m[2][1] - m[1][2], b = m[0][2] - m[2][0], c = m[1][0] - m[0][1];
  const d = m[0][1] + m[1][0], e = m[0][2] + m[2][0], g = m[1][2] + m[2][1];
  const q = [[t[0], a, b, c], [a, t[1], d, e], [b, d, t[2], g], [c, e, g, t[3]]][at].map((n) => n * f);
  return q[0] < 0 ? q.map((n) => -n) : q;
}

// Part of the way: the turn of q about p, then p goes towards `to`.
function partOf([qw, ...axis], p, to, part) {
  const half = Math.acos(Math.max(-1, Math.min(1, qw))) * part;
  const u = unit(axis);
  const w = Math.cos(half), [x, y, z] = u.map((n) => n * Math.sin(half));
  const m = [1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w), 0,
    2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w), 0,
    2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y), 0];
  const stands = moved(m, p);
  for (let i = 0; i < 3; i++) m[4 * i + 3] = p[i] + (to[i] - p[i]) * part - stands[i];
  return m;
}

export class Folding {
  constructor(port) {
    this.port = port;
    this.part = port.part;
  }

  read(text, patterns) {
    const file = JSON.parse(text);
    this.flat = file.vertices_coords.map(([x, y]) => [x, y, 0]);
    // Without a place in the model a piece is folded where it lies.
    this.space = file.file_frames[0]?.vertices_coords ?? this.flat;
    this.folds = file.edges_foldAngle.some(Boolean);
    this.faces = file.faces_vertices;
    this.segments = file["sanggwan:faces_segment"].map((segment) => patterns.get(segment) ?? { segment, edges: true });
    this.edges = new Map();
    file.edges_vertices.forEach(([a, b], i) => {
      this.edges.set(a < b ? a + " " + b : b + " " + a,
        { edge: file["sanggwan:edges_edge"][i], kind: file.edges_assignment[i],
          angle: file.edges_foldAngle[i] * Math.PI / 180 });
    });
    this.tree();
    this.fold(this.part);
  }

  edgeOf(a, b) {
    return this.edges.get(a < b ? a + " " + b : b + " " + a);
  }

  // Each face after the one it hangs on; roots hang on none.
  tree() {
    const beside = new Map();
    this.faces.forEach((face, f) => face.forEach((a, i) => {
      beside.set(a + " " + face[(i + 1) % face.length], f);
    }));
    this.order = [];
    const seen = new Set();
    for (let root = 0; root < this.faces.length; root++) {
      if (seen.has(root)) continue;
      seen.add(root);
      const piece = [{ face: root, on: -1, motion: this.home(root) }];
      for (const { face } of piece) {
        const corners = this.faces[face];
        corners.forEach((a, i) => {
          const b = corners[(i + 1) % corners.length];
          const next = beside.get(b + " " + a);
          if (next === undefined || seen.has(next)) return;
          seen.add(next);
          piece.push({ face: next, on: face, a: this.flat[a], b: this.flat[b], angle: this.edgeOf(a, b).angle });
        });
      }
      this.order.push(...piece);
    }
  }

  // Where a root is in the model.
  home(face) {
    const [a, b] = this.faces[face];
    let c = this.faces[face][2], most = 0;
    for (const d of this.faces[face].slice(2)) {
      const area = Math.hypot(...cross(minus(this.flat[b], this.flat[a]), minus(this.flat[d], this.flat[a])));
      if (area > most) [c, most] = [d, area];
    }
    const from = frame(this.flat[a], this.flat[b], this.flat[c]);
    const to = frame(this.space[a], this.space[b], this.space[c]);
    return { turn: turnBetween(from, to), from: from.p, to: to.p };
  }

  // The corners of all faces, folded up so far: 0 flat, 1 as in the model.
  corners(part) {
    const motions = [];
    const out = [];
    for (const { face, on, a, b, angle, motion } of this.order) {
      motions[face] = on < 0 ? partOf(motion.turn, motion.from, motion.to, part)
        : after(motions[on], about(a, b, -angle * part));
      out[face] = this.faces[face].map((v) => moved(motions[face], this.flat[v]));
    }
    return out;
  }

  fold(part) {
    this.part = part;
    if (this.faces) this.port.redraw();
  }

  // Paints the faces, the farthest first.
  draw({ svg, mine }, [theta, phi], width, height, lit) {
    const [ct, st, cp, sp] = [Math.cos(theta * Math.PI / 180), Math.sin(theta * Math.PI / 180),
      Math.cos(phi * Math.PI / 180), Math.sin(phi * Math.PI / 180)];
    const eye = ([x, y, z]) => [-st * x + ct * y, -(-ct * cp * x - st * cp * y + sp * z), ct * sp * x + st * sp * y + cp * z];
    const box = (faces) => {
      const all = faces.flat();
      const low = [0, 1].map((i) => all.reduce((n, p) => Math.min(n, p[i]), Infinity));
      const high = [0, 1].map((i) => all.reduce((n, p) => Math.max(n, p[i]), -Infinity));
      return { middle: low.map((n, i) => (n + high[i]) / 2), size: high.map((n, i) => n - low[i]) };
    };
    const faces = this.corners(this.part).map((face) => face.map(eye));
    const now = box(faces);
    const scale = Math.min(width * 0.86 / now.size[0], height * 0.86 / now.size[1]);
    const place = ([x, y]) => [(x - now.middle[0]) * scale + width / 2, (y - now.middle[1]) * scale + height / 2];
    const order = faces.map((face, f) => [f, face.reduce((sum, p) => sum + p[2], 0) / face.length])
      .sort((a, b) => a[1] - b[1]);
    const at = (p) => p.map((n) => n.toFixed(1)).join(" ");
    this.lines = [];
    const paths = order.map(([f]) => {
      const points = faces[f].map(place);
      const area = points.reduce((sum, [x, y], i) => {
        const [x1, y1] = points[(i + 1) % points.length];
        return sum + x * y1 - x1 * y;
      }, 0);
      const corners = this.faces[f];
      let sides = "", folds = "";
      corners.forEach((a, i) => {
        const found = this.edgeOf(a, corners[(i + 1) % corners.length]);
        if (found && found.kind !== "J") {
          const side = `M${at(points[i])}L${at(points[(i + 1) % points.length])}`;
          if ("MVF".includes(found.kind)) folds += side;
          else sides += side;
          const { segment, edges } = this.segments[f], edge = edgeIn(this.segments[f], found.edge);
          this.lines.push({ name: nameOf(segment, edges ? edge : undefined), edge, segment,
            folds: "MVF".includes(found.kind), from: points[i], to: points[(i + 1) % points.length] });
        }
      });
      return [s("path", { class: area > 0 ? "face inside" : "face", d: "M" + points.map(at).join("L") + "Z" }),
        s("path", { class: "sides folds", d: folds }), s("path", { class: "sides", d: sides })];
    }).flat();
    const marks = ["lit", "chosen", "hover"].map((layer) => s("path", { class: layer, d: this.lines
      .filter(({ name, segment, folds }) => lit[layer]?.has(name) || (!folds && lit[layer]?.has("s" + segment)))
      .map(({ from, to }) => `M${from.join(" ")}L${to.join(" ")}`).join("") }));
    svg.setAttribute("viewBox", `0 0 ${width} ${height}`);
    mine.replaceChildren(...paths, ...marks);
  }

  // The side of a face near a point of the drawing.
  near([x, y], within) {
    let best = null, least = within * within;
    for (const line of this.lines || []) {
      const { from, to } = line;
      const dx = to[0] - from[0], dy = to[1] - from[1];
      const along = dx * dx + dy * dy;
      const t = along ? Math.max(0, Math.min(1, ((x - from[0]) * dx + (y - from[1]) * dy) / along)) : 0;
      const far = (from[0] + t * dx - x) ** 2 + (from[1] + t * dy - y) ** 2;
      if (far <= least) [best, least] = [line, far];
    }
    return best;
  }
}
