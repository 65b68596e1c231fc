// boolean_files.mjs -- manifold-3d from STL to STL, for bench/boolean_files:
//
//   node boolean_files.mjs A.stl B.stl OUT.stl
//
// The package is looked for in $NODE_MODULES.
import { readFileSync, writeFileSync } from 'node:fs';
import { pathToFileURL } from 'node:url';

const [, , fileA, fileB, fileOut] = process.argv;
const library = process.env.NODE_MODULES + '/manifold-3d/manifold.js';
const wasm = await (await import(pathToFileURL(library))).default();
wasm.setup();
const { Manifold, Mesh } = wasm;

// Points in one place are one, as the library wants them.
function read(file) {
  const bytes = readFileSync(file);
  const n = bytes.readUInt32LE(80);
  const corners = new Uint32Array(3 * n);
  const points = new Float32Array(9 * n);
  const size = 2 ** Math.ceil(Math.log2(6 * n + 2));
  const table = new Int32Array(size).fill(-1);
  const words = new Uint32Array(points.buffer);
  let count = 0;
  for (let i = 0; i < 3 * n; i++) {
    const at = 84 + 50 * Math.floor(i / 3) + 12 + 12 * (i % 3);
    for (let k = 0; k < 3; k++) {
      points[3 * count + k] = bytes.readFloatLE(at + 4 * k) + 0;
    }
    let slot = (Math.imul(words[3 * count], 0x9e3779b1) ^
                Math.imul(words[3 * count + 1], 0x85ebca6b) ^
                Math.imul(words[3 * count + 2], 0xc2b2ae35)) >>> 0;
    slot = (slot ^ (slot >>> 15)) & (size - 1);
    for (; table[slot] >= 0; slot = (slot + 1) & (size - 1)) {
      const p = 3 * table[slot];
      if (points[p] === points[3 * count] &&
          points[p + 1] === points[3 * count + 1] &&
          points[p + 2] === points[3 * count + 2]) break;
    }
    if (table[slot] < 0) table[slot] = count++;
    corners[i] = table[slot];
  }
  return new Manifold(new Mesh({
    numProp: 3, vertProperties: points.slice(0, 3 * count), triVerts: corners
  }));
}

function write(file, mesh) {
  const { vertProperties: points, triVerts: corners, numProp } = mesh;
  const n = corners.length / 3;
  const bytes = Buffer.alloc(84 + 50 * n);
  bytes.writeUInt32LE(n, 80);
  for (let i = 0; i < 3 * n; i++) {
    const at = 84 + 50 * Math.floor(i / 3) + 12 + 12 * (i % 3);
    for (let k = 0; k < 3; k++) {
      bytes.writeFloatLE(points[numProp * corners[i] + k], at + 4 * k);
    }
  }
  writeFileSync(file, bytes);
}

write(fileOut, read(fileA).add(read(fileB)).getMesh());
process.exit(0);
