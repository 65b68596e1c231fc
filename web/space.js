// Where points of the model are in a picture.

const VIEWS = { front: [270, 90], right: [0, 90], top: [270, 0], left: [180, 90], back: [90, 90], bottom: [270, 180] };
const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];

// Where the eye is, and where right and up are, of a view in degrees.
export function axes([theta, phi]) {
  const [t, p] = [theta, phi].map((angle) => angle * Math.PI / 180);
  return { eye: [Math.sin(p) * Math.cos(t), Math.sin(p) * Math.sin(t), Math.cos(p)],
    right: [-Math.sin(t), Math.cos(t), 0],
    up: [-Math.cos(p) * Math.cos(t), -Math.cos(p) * Math.sin(t), Math.sin(p)] };
}

// Of a port with a picture that has this place: which way on its sheet one goes, and
// where one comes to. Null, if the rays are not parallel, or nothing is known of them.
export function spaceOf(port, place) {
  const angles = ["iso", "section"].includes(port.kind) ? port.angles : VIEWS[port.kind];
  const { projection, up: top } = port.studio.looks;
  if (!angles || !place || (projection ?? "parallel") !== "parallel" || (top ?? "z") !== "z") return null;
  const { right, up } = axes(angles);
  const [scale, x, y, left, high] = place;
  const seen = (v) => [dot(right, v) * scale, -dot(up, v) * scale];
  const where = (v) => seen(v).map((n, k) => n + (k ? high + y * scale : left - x * scale));
  return { scale, seen, where };
}
