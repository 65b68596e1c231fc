// Which line of a picture is near a point: the pieces of its lines in a grid of
// squares, so that of many lines those few are looked at that pass by.

// The strokes that have a name.
export const named = ({ strokes }) => strokes.filter(({ edges, whole }) => edges.length || whole);

const within = (n, most) => Math.max(0, Math.min(most - 1, n));

export class Nearest {
  constructor(picture) {
    this.strokes = named(picture);
    this.looks = picture.looks;
    const count = this.strokes.reduce((sum, { points, closed }) => sum + points.length / 2 - (closed ? 0 : 1), 0);
    this.ends = new Int32Array(4 * count);            // of each piece
    this.of = new Uint32Array(count);                 // its stroke
    this.place = new Uint32Array(count);              // which piece of it
    let k = 0;
    for (let of = 0; of < this.strokes.length; of++) {
      const { points, closed } = this.strokes[of];
      const most = points.length - (closed ? 0 : 2);
      for (let i = 0; i < most; i += 2, k++) {
        const j = i + 2 < points.length ? i + 2 : 0;
        this.ends[4 * k] = points[i];
        this.ends[4 * k + 1] = points[i + 1];
        this.ends[4 * k + 2] = points[j];
        this.ends[4 * k + 3] = points[j + 1];
        this.of[k] = of;
        this.place[k] = i / 2;
      }
    }
    this.divide();
  }

  // About as many squares as pieces, so large that a piece is in a few of them.
  divide() {
    const { ends, of: { length: count } } = this;
    let left = Infinity, top = Infinity, right = -Infinity, bottom = -Infinity, length = 0;
    for (let i = 0; i < ends.length; i += 4) {
      const ax = ends[i], ay = ends[i + 1], bx = ends[i + 2], by = ends[i + 3];
      left = Math.min(left, ax, bx);
      right = Math.max(right, ax, bx);
      top = Math.min(top, ay, by);
      bottom = Math.max(bottom, ay, by);
      length += Math.abs(bx - ax) + Math.abs(by - ay);
    }
    this.left = left;
    this.top = top;
    this.side = Math.max(1, Math.sqrt((right - left) * (bottom - top) / count) || 1, length / count || 1,
      (right - left) / count || 1, (bottom - top) / count || 1);
    this.wide = Math.floor((right - left) / this.side) + 1 || 1;
    this.high = Math.floor((bottom - top) / this.side) + 1 || 1;
    // How many are in each square, then where those of each begin, then which they are.
    this.first = new Uint32Array(this.wide * this.high + 1);
    for (let k = 0; k < count; k++) this.crossed(k, 1, null);
    for (let i = 1; i < this.first.length; i++) this.first[i] += this.first[i - 1];
    this.pieces = new Uint32Array(this.first[this.first.length - 1]);
    for (let k = count - 1; k >= 0; k--) this.crossed(k, 0, this.pieces);
  }

  column(x) {
    return within(Math.floor((x - this.left) / this.side), this.wide);
  }

  row(y) {
    return within(Math.floor((y - this.top) / this.side), this.high);
  }

  // Counts the squares of a piece, or puts it into them: of each row those between
  // where it comes in and where it goes out.
  crossed(k, counts, pieces) {
    const { ends, first, side, wide } = this;
    const turned = ends[4 * k + 1] > ends[4 * k + 3] ? 2 : 0;
    const ax = ends[4 * k + turned], ay = ends[4 * k + 1 + turned];
    const bx = ends[4 * k + 2 - turned], by = ends[4 * k + 3 - turned];
    const run = (bx - ax) / (by - ay || 1);
    const last = this.row(by);
    for (let row = this.row(ay); row <= last; row++) {
      const top = this.top + row * side;
      const from = ay >= top ? ax : ax + (top - ay) * run;
      const to = by <= top + side ? bx : ax + (top + side - ay) * run;
      const right = row * wide + this.column(Math.max(from, to));
      for (let square = row * wide + this.column(Math.min(from, to)); square <= right; square++) {
        if (counts) first[square] += 1;
        else pieces[--first[square]] = k;
      }
    }
  }

  // The line nearest to a point, if one is so near; a visible one before a hidden
  // one that is not half as far, and of several the one that is drawn first.
  at(x, y, near) {
    const { ends, strokes, looks } = this;
    let best = -1, least = near * near;
    const right = this.column(x + near), bottom = this.row(y + near);
    for (let row = this.row(y - near); row <= bottom; row++) {
      for (let column = this.column(x - near); column <= right; column++) {
        const square = row * this.wide + column;
        for (let i = this.first[square]; i < this.first[square + 1]; i++) {
          const k = this.pieces[i];
          const ax = ends[4 * k], ay = ends[4 * k + 1];
          const dx = ends[4 * k + 2] - ax, dy = ends[4 * k + 3] - ay;
          const along = dx * dx + dy * dy;
          const t = along ? Math.max(0, Math.min(1, ((x - ax) * dx + (y - ay) * dy) / along)) : 0;
          let far = (ax + t * dx - x) ** 2 + (ay + t * dy - y) ** 2;
          if (far > least) continue;
          if (looks[strokes[this.of[k]].look][0] === "hidden") far *= 4;
          if (far < least || (far === least && k < best)) [best, least] = [k, far];
        }
      }
    }
    if (best < 0) return null;
    const stroke = strokes[this.of[best]];
    const edge = stroke.edges.length >= stroke.points.length / 2 - 1 ? stroke.edges[this.place[best]] : stroke.edges[0];
    return { stroke, edge, segment: stroke.segment, role: looks[stroke.look][1] };
  }
}
