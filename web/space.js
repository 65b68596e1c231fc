// Where points of the model are in a picture, and how a picture says so.

const VIEWS = { front: [270, 90], right: [0, 90], top: [270, 0], left: [180, 90], back: [90, 90], bottom: [270, 180] };
// What comes to be x, y and z when another axis points up.
const UP = { z: (v) => v, y: ([x, y, z]) => [x, -z, y], x: ([x, y, z]) => [-z, y, x] };
const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];

// Where the eye is, and where right and up are, of a view in degrees.
export function axes([theta, phi]) {
  const [t, p] = [theta, phi].map((angle) => angle * Math.PI / 180);
  return { eye: [Math.sin(p) * Math.cos(t), Math.sin(p) * Math.sin(t), Math.cos(p)],
    right: [-Math.sin(t), Math.cos(t), 0],
    up: [-Math.cos(p) * Math.cos(t), -Math.cos(p) * Math.sin(t), Math.sin(p)] };
}

// Of a port with a picture: where a point of the model comes to on its sheet, and
// which way from there another one goes, for one unit more. Null, if nothing is
// known of its rays.
export function spaceOf(port, picture) {
  const angles = ["iso", "section", "shaded"].includes(port.kind) ? port.angles : VIEWS[port.kind];
  const { place, central } = picture || {};
  if (!angles || !place) return null;
  const { eye, right, up } = axes(angles);
  const turned = UP[port.studio.looks.up || "z"];
  const [scale, x, y, left, high] = place;
  // Of one unit at that depth how much is seen.
  const nearer = (v) => (central ? (central[0] + central[1]) / (central[0] - dot(eye, v)) : 1) * scale;
  const where = (at) => {
    const v = turned(at), by = nearer(v);
    return [left + dot(right, v) * by - x * scale, high - dot(up, v) * by + y * scale];
  };
  const seen = (way, at) => {
    const step = 1e-6 / (Math.hypot(...way) || 1) * (central ? central[0] : 1);
    const [from, to] = [where(at), where(at.map((n, k) => n + way[k] * step))];
    return to.map((n, k) => (n - from[k]) / step);
  };
  // What a section leaves of a line, if anything.
  const remains = (ends) => {
    if (port.kind !== "section") return ends;
    const k = "xyz".indexOf(port.settings.axis);
    const over = ends.map((v) => (k === 1 ? 1 : -1) * (turned(v)[k] - port.at));
    if (Math.max(...over) < 0) return [];
    return ends.map((v, i) => (over[i] < 0 ? v.map((n, j) => n + (ends[1 - i][j] - n) * over[i] / (over[i] - over[1 - i])) : v));
  };
  return { scale, seen, where, remains };
}
