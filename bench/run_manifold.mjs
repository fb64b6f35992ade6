// Runs the npm package manifold-3d on a workload's folder; see bench/peer.h.
// usage: node run_manifold.mjs MODULES FOLDER THREADS, MODULES being the folder that holds node_modules.
import {existsSync, readFileSync} from 'node:fs';
import {join, resolve} from 'node:path';
import {pathToFileURL} from 'node:url';

const [modules, folder] = process.argv.slice(2);
const {default: load} = await import(pathToFileURL(join(resolve(modules), 'node_modules/manifold-3d/manifold.js')));
const wasm = await load();
wasm.setup();
const {Manifold, Mesh} = wasm;

function read(path) {
  const words = readFileSync(path, 'latin1').split(/\s+/);
  const vertices = Number(words[1]), faces = Number(words[2]);
  const points = new Float32Array(3 * vertices), triangles = new Uint32Array(3 * faces);
  let at = 4;
  for (let i = 0; i < 3 * vertices; ++i) points[i] = Number(words[at++]);
  for (let i = 0; i < faces; ++i) {
    ++at;
    for (let k = 0; k < 3; ++k) triangles[3 * i + k] = Number(words[at++]);
  }
  return {points, triangles};
}

const operation = readFileSync(join(folder, 'operation'), 'latin1').trim();
const operands = [];
for (let i = 0; existsSync(join(folder, `${i}.off`)); ++i) operands.push(read(join(folder, `${i}.off`)));

const seconds = () => process.cpuUsage().user / 1e6 + process.cpuUsage().system / 1e6;
const wall = performance.now(), t0 = seconds();
const solids = operands.map(o => new Manifold(new Mesh({numProp: 3, vertProperties: o.points, triVerts: o.triangles})));
const t1 = seconds();
let result;
if (operation === 'union') result = Manifold.union(solids);
else if (operation === 'intersection') result = Manifold.intersection(solids);
else if (operation === 'difference') result = Manifold.difference(solids);
else if (operation === 'parts') {
  const parts = [];
  for (let i = 0; i + 1 < solids.length; i += 2) parts.push(solids[i].subtract(solids[i + 1]));
  result = Manifold.union(parts);
} else if (operation === 'nested') {
  result = solids.reduceRight((nested, solid) => solid.subtract(nested));
} else if (operation === 'remainders') {
  result = Manifold.union(solids.slice(1).map(solid => solids[0].subtract(solid)));
} else {
  const unites = operation === 'unions' || operation === 'leaning', alternates = operation === 'alternating';
  result = solids[0];
  for (const [i, next] of solids.slice(1).entries()) {
    result = unites || (alternates && i % 2 === 0) ? result.add(next) : result.subtract(next);
    result.numTri();
  }
}
result.numTri();
const t2 = seconds();
const mesh = result.getMesh();
const t3 = seconds();
console.log(JSON.stringify({
  import: t1 - t0, boolean: t2 - t1, export: t3 - t2, total: t3 - t0, wall: (performance.now() - wall) / 1000,
  extra_bytes: 0, vertices: mesh.numVert, triangles: mesh.numTri, volume: result.volume()}));
