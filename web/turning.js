// Turning by the graphics card: while a large model is being turned, the page draws
// it itself; at rest the exact picture of the program lies in the same place.

import { axes } from "./space.js";

const LINE = 12;                 // numbers of a line: two ends, two normals
const WIDTH = 1.3, DASH = 5, GAP = 3.5;

const FACES = `#version 300 es
in vec3 at;
uniform mat4 view;
void main() { gl_Position = view * vec4(at, 1.); }`;

// A line is a rectangle: two corners at each end. One that is drawn only as an
// outline is nowhere, unless its two faces look to both sides.
const LINES = `#version 300 es
in vec3 a, b, left, right;
uniform mat4 view;
uniform vec3 eye;
uniform vec2 dots;
uniform float width;
out float along;
void main() {
  vec4 p = view * vec4(a, 1.), q = view * vec4(b, 1.);
  vec2 way = (q.xy - p.xy) * dots;
  float far = length(way);
  vec2 aside = far > 0. ? vec2(-way.y, way.x) / far : vec2(0.);
  bool end = gl_VertexID > 1;
  along = end ? far * .5 : 0.;
  gl_Position = end ? q : p;
  gl_Position.xy += aside * width * float((gl_VertexID & 1) * 2 - 1) / dots;
  if (left != right && dot(left, eye) * dot(right, eye) > 0.) gl_Position = vec4(2., 2., 2., 1.);
}`;

const PLAIN = `#version 300 es
precision mediump float;
in float along;
uniform vec4 colour;
uniform vec2 dash;
out vec4 dot_;
void main() {
  if (mod(along, dash.x + dash.y) > dash.x) discard;
  dot_ = colour;
}`;

const NOTHING = `#version 300 es
precision mediump float;
out vec4 dot_;
void main() { dot_ = vec4(0.); }`;

const context = (canvas) => canvas.getContext("webgl2", { antialias: true });

let able;

// Is there a card that draws faster than the program? What software makes up is
// none, unless the page is told so.
function isAble() {
  const told = localStorage.getItem("gpu");
  if (able === undefined) {
    const gl = told === "none" ? null : context(document.createElement("canvas"));
    const more = gl?.getExtension("WEBGL_debug_renderer_info");
    const name = gl ? gl.getParameter(more ? more.UNMASKED_RENDERER_WEBGL : gl.RENDERER) : "";
    able = Boolean(gl) && (told === "any" || !/swiftshader|llvmpipe|software|basic render/i.test(name));
    gl?.getExtension("WEBGL_lose_context")?.loseContext();
  }
  return able;
}

function program(gl, vertex, fragment) {
  const out = gl.createProgram();
  for (const [type, text] of [[gl.VERTEX_SHADER, vertex], [gl.FRAGMENT_SHADER, fragment]]) {
    const shader = gl.createShader(type);
    gl.shaderSource(shader, text);
    gl.compileShader(shader);
    gl.attachShader(out, shader);
  }
  gl.linkProgram(out);
  return out;
}

// The lines of a mesh, LINE numbers each. The normals of one that is always drawn
// are the same.
export function linesOf(at, corners, ends, sharp) {
  const out = new Float32Array(ends.length / 2 * LINE);
  const places = new Map();
  const key = (a, b) => Math.min(a, b) * (at.length / 3) + Math.max(a, b);
  for (let i = 0; i < ends.length / 2; i++) {
    const [a, b] = [ends[2 * i], ends[2 * i + 1]];
    out.set(at.subarray(3 * a, 3 * a + 3), LINE * i);
    out.set(at.subarray(3 * b, 3 * b + 3), LINE * i + 3);
    if (i >= sharp) places.set(key(a, b), [i, 0]);
  }
  for (let t = 0; t < corners.length; t += 3) {
    const of = [0, 1, 2].map((k) => 3 * corners[t + k]);
    let normal = null;
    for (let k = 0; k < 3; k++) {
      const place = places.get(key(corners[t + k], corners[t + (k + 1) % 3]));
      if (!place || place[1] > 1) continue;
      const [u, v] = [of[1], of[2]].map((p) => [0, 1, 2].map((n) => at[p + n] - at[of[0] + n]));
      normal = normal || [0, 1, 2].map((n) => u[(n + 1) % 3] * v[(n + 2) % 3] - u[(n + 2) % 3] * v[(n + 1) % 3]);
      out.set(normal, LINE * place[0] + 6 + 3 * place[1]);
      place[1] += 1;
    }
  }
  return out;
}

export class Turning {
  constructor(port) {
    this.port = port;
    this.rev = null;             // of the mesh that is there, or on its way
    this.turns = 0;
  }

  // One more view; false: the program draws it.
  turned() {
    if (this.lost || !isAble()) return false;
    const { rev } = this.port.studio;
    this.turns += 1;
    if (this.rev !== rev) this.fetch(rev);
    if (!this.mesh || !this.port.picture.shown) return false;
    if (!this.waiting) this.waiting = requestAnimationFrame(() => { this.waiting = 0; this.draw(); });
    this.port.rests();
    return true;
  }

  async fetch(rev) {
    this.rev = rev;
    this.mesh = null;
    try {
      const { studio, name } = this.port;
      const { head, body } = await studio.wire.ask("view",
        { ...studio.looks, port: name + " mesh", format: "mesh" });
      if (this.rev === rev && head.rev === rev && !head.replaced) this.read(head, body);
      else this.rev = null;
    } catch (error) {
      this.rev = null;
    }
  }

  read(head, body) {
    const at = new Float32Array(body, 0, 3 * head.vertices);
    const corners = new Uint32Array(body, at.byteLength, 3 * head.triangles);
    const ends = new Uint32Array(body, at.byteLength + corners.byteLength);
    if (!this.gl) this.begin();
    if (!this.gl) return;
    const { gl } = this;
    const lines = linesOf(at, corners, ends, head.sharp);
    for (const [buffer, kind, data] of [[this.places, gl.ARRAY_BUFFER, at], [this.ends, gl.ARRAY_BUFFER, lines],
      [this.corners, gl.ELEMENT_ARRAY_BUFFER, corners]]) {
      gl.bindBuffer(kind, buffer);
      gl.bufferData(kind, data, gl.STATIC_DRAW);
    }
    let reach = 0;
    for (let i = 0; i < at.length; i += 3) reach = Math.max(reach, Math.hypot(at[i], at[i + 1], at[i + 2]));
    this.mesh = { at, corners: corners.length, lines: lines.length / LINE, reach: reach || 1 };
  }

  begin() {
    this.canvas = document.createElement("canvas");
    this.canvas.className = "turning";
    this.canvas.hidden = true;
    const gl = context(this.canvas);
    if (!gl) {
      this.lost = true;
      return;
    }
    this.canvas.addEventListener("webglcontextlost", () => {
      this.lost = true;
      this.leave();
      this.port.refresh();
    });
    this.port.canvas.prepend(this.canvas);
    this.faces = program(gl, FACES, NOTHING);
    this.strokes = program(gl, LINES, PLAIN);
    [this.places, this.ends, this.corners] = [0, 1, 2].map(() => gl.createBuffer());
    this.gl = gl;
  }

  // Where the exact picture would have everything: the middle of the picture is
  // that of the sheet.
  matrix(width, height) {
    const { picture, angles, scale } = this.port;
    const { place } = picture.shown;
    const [x, y, wide, high] = picture.box;
    const { eye, right, up } = axes(angles);
    const dots = Math.min(width / wide, height / high);
    const size = scale * 1000 * dots;
    const middle = (axis) => {
      const { at } = this.mesh;
      let [low, most] = [Infinity, -Infinity];
      for (let i = 0; i < at.length; i += 3) {
        const n = axis[0] * at[i] + axis[1] * at[i + 1] + axis[2] * at[i + 2];
        if (n < low) low = n;
        if (n > most) most = n;
      }
      return (low + most) / 2;
    };
    const [mx, my] = [2 * size / width, 2 * size / height];
    const left = ((place[3] - x - wide / 2) * dots) / (width / 2) - mx * middle(right);
    const low = -((place[4] - y - high / 2) * dots) / (height / 2) - my * middle(up);
    const deep = -1 / (1.01 * this.mesh.reach);
    return { eye, view: new Float32Array([0, 1, 2].flatMap((k) =>
      [mx * right[k], my * up[k], deep * eye[k], 0]).concat([left, low, 0, 1])) };
  }

  draw() {
    const { gl, mesh, canvas } = this;
    const { clientWidth, clientHeight, classList } = this.port.canvas;
    if (!mesh || !this.port.picture.shown || !clientWidth) return;
    const fine = Math.min(2, window.devicePixelRatio || 1);
    [canvas.width, canvas.height] = [clientWidth, clientHeight].map((n) => Math.round(n * fine));
    canvas.hidden = false;
    classList.add("turns");
    const { eye, view } = this.matrix(clientWidth, clientHeight);
    gl.viewport(0, 0, canvas.width, canvas.height);
    gl.enable(gl.DEPTH_TEST);
    gl.depthMask(true);
    gl.clearColor(0, 0, 0, 0);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    this.drawFaces(view);
    gl.depthMask(false);
    const style = getComputedStyle(this.port.canvas);
    const { hidden } = this.port.studio.looks;
    const passes = hidden === "removed" ? [] : [[gl.GREATER, hidden === "shown" ? "--ink" : "--grey", GAP]];
    for (const [test, name, gap] of [...passes, [gl.LEQUAL, "--ink", 0]]) {
      gl.depthFunc(test);
      this.drawLines(view, eye, fine, colourOf(style.getPropertyValue(name)), hidden === "shown" ? 0 : gap);
    }
    gl.depthMask(true);
  }

  drawFaces(view) {
    const { gl, faces } = this;
    gl.useProgram(faces);
    gl.depthFunc(gl.LESS);
    gl.colorMask(false, false, false, false);
    gl.enable(gl.POLYGON_OFFSET_FILL);
    gl.polygonOffset(1, 2);
    gl.uniformMatrix4fv(gl.getUniformLocation(faces, "view"), false, view);
    this.given(faces, this.places, { at: 0 }, 3, 0);
    gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, this.corners);
    gl.drawElements(gl.TRIANGLES, this.mesh.corners, gl.UNSIGNED_INT, 0);
    gl.disable(gl.POLYGON_OFFSET_FILL);
    gl.colorMask(true, true, true, true);
  }

  drawLines(view, eye, fine, colour, gap) {
    const { gl, strokes, canvas } = this;
    const uniform = (name) => gl.getUniformLocation(strokes, name);
    gl.useProgram(strokes);
    gl.uniformMatrix4fv(uniform("view"), false, view);
    gl.uniform3fv(uniform("eye"), eye);
    gl.uniform2f(uniform("dots"), canvas.width, canvas.height);
    gl.uniform1f(uniform("width"), WIDTH * fine);
    gl.uniform4fv(uniform("colour"), colour);
    gl.uniform2f(uniform("dash"), DASH * fine, gap * fine);
    this.given(strokes, this.ends, { a: 0, b: 3, left: 6, right: 9 }, LINE, 1);
    gl.drawArraysInstanced(gl.TRIANGLE_STRIP, 0, 4, this.mesh.lines);
  }

  // The attributes of a program, three numbers each, from one buffer.
  given(of, buffer, attributes, numbers, each) {
    const { gl } = this;
    gl.bindBuffer(gl.ARRAY_BUFFER, buffer);
    for (let i = 0; i < 4; i++) gl.disableVertexAttribArray(i);
    for (const [name, from] of Object.entries(attributes)) {
      const place = gl.getAttribLocation(of, name);
      gl.enableVertexAttribArray(place);
      gl.vertexAttribPointer(place, 3, gl.FLOAT, false, 4 * numbers, 4 * from);
      gl.vertexAttribDivisor(place, each);
    }
  }

  // The exact picture is there.
  leave() {
    if (this.waiting) cancelAnimationFrame(this.waiting);
    this.waiting = 0;
    if (this.canvas) this.canvas.hidden = true;
    this.port.canvas.classList.remove("turns");
  }
}

// Of a colour as the style has it, for the card.
function colourOf(text) {
  const one = document.createElement("canvas").getContext("2d");
  one.fillStyle = text.trim();
  one.fillRect(0, 0, 1, 1);
  return [...one.getImageData(0, 0, 1, 1).data].map((n) => n / 255);
}
