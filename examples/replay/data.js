// SPDX-License-Identifier: BSL-1.0
// The run: numbers by name in `run`, arrays of all frames one behind the other in `arrays`, and the
// state of one frame in SI units from `frameState`. Numbers are packed as pack.cpp has them.

const run = JSON.parse(document.getElementById("head").textContent);

const arrays = (() => {
  const text = atob(document.getElementById("arrays").textContent.trim());
  const bytes = new Uint8Array(text.length);
  for (let k = 0; k < text.length; ++k) bytes[k] = text.charCodeAt(k);
  const types = { Float32Array, Int32Array, Uint32Array, Int16Array, Uint16Array, Uint8Array };
  const named = {};
  for (const [name, a] of Object.entries(run.arrays))
    named[name] = new types[a.type](bytes.buffer, a.offset, a.count);
  document.getElementById("arrays").remove(); // the text is no longer needed
  return named;
})();

const frameCount = run.frames.length;
const particleCount = arrays.root.length;
const shearStage = run.stages.indexOf("shear");

// Where the numbers of a frame begin in the arrays.
{
  let particles = 0, contacts = 0;
  for (const frame of run.frames) {
    frame.particleStart = particles;
    frame.contactStart = contacts;
    particles += frame.particles;
    contacts += frame.contacts;
  }
}
const firstOfShear = run.frames.findIndex((f) => f.stage === shearStage);

// Breaks in the order of time, and by particle: the one that it broke in.
const breakOf = new Map(run.breaks.map((b) => [b.id, b]));
run.breaks.forEach((b, k) => { b.number = k; });

const isPresent = (id, f) => arrays.first[id] <= f && f <= arrays.last[id];

// The ids of the particles of frame f, in their order.
function idsOf(f) {
  const ids = new Uint32Array(run.frames[f].particles);
  for (let id = 0, n = 0; id < particleCount; ++id) if (isPresent(id, f)) ids[n++] = id;
  return ids;
}

const [boxLeft, boxBottom, boxRight, boxTop] = run.box;
const unpackX = (n) => boxLeft + n * (boxRight - boxLeft) / 65535;
const unpackY = (n) => boxBottom + n * (boxTop - boxBottom) / 65535;

// Numbers of a frame, by the place k of a particle in it or the place c of a contact.
function makeState(f) {
  const frame = run.frames[f];
  const p = frame.particleStart, c = frame.contactStart, n = frame.particles;
  const state = {
    f, frame, n, ids: idsOf(f), contacts: frame.contacts,
    x: new Float32Array(n), y: new Float32Array(n), cos: new Float32Array(n), sin: new Float32Array(n),
    neighbours: new Uint16Array(n),
    angle: (k) => arrays.angle[p + k] * run.mostTurn / 32767,
    vx: (k) => arrays.vx[p + k] * frame.speed / 32767,
    vy: (k) => arrays.vy[p + k] * frame.speed / 32767,
    spin: (k) => arrays.spin[p + k] * frame.spin / 32767,
    speed: (k) => Math.hypot(arrays.vx[p + k], arrays.vy[p + k]) * frame.speed / 32767,
    rat: (k) => arrays.rat[p + k] / 65535,
    strain: (k) => arrays.strain[p + k] * frame.deviatoric / 65535,
    rattler: (k) => arrays.rattler[p + k],
    a: (i) => arrays.contactA[c + i],
    b: (i) => arrays.contactB[c + i],
    px: (i) => unpackX(arrays.contactX[c + i]),
    py: (i) => unpackY(arrays.contactY[c + i]),
    normal: (i) => arrays.normal[c + i] * frame.force / 65535,
    tangential: (i) => arrays.tangential[c + i] * frame.force / 32767,
    place: (id) => placeOf(state.ids, id),
  };
  for (let k = 0; k < n; ++k) {
    state.x[k] = unpackX(arrays.x[p + k]);
    state.y[k] = unpackY(arrays.y[p + k]);
    const angle = state.angle(k);
    state.cos[k] = Math.cos(angle);
    state.sin[k] = Math.sin(angle);
  }
  for (let i = 0; i < frame.contacts; ++i) {
    ++state.neighbours[state.a(i)];
    ++state.neighbours[state.b(i)];
  }
  return state;
}

// Place of a particle in the sorted ids of a frame; -1 if it is not there.
function placeOf(ids, id) {
  let low = 0, high = ids.length;
  while (low < high) {
    const middle = (low + high) >> 1;
    if (ids[middle] < id) low = middle + 1; else high = middle;
  }
  return ids[low] === id ? low : -1;
}

// The last frame that was asked for is kept.
let keptState = null;
function frameState(f) {
  if (keptState === null || keptState.f !== f) keptState = makeState(f);
  return keptState;
}

// The angle of a particle at the start of shear; 0 for a piece that came later, whose angle begins
// with it. Before shear rotations are since the start.
let anglesAtShear = null;
function angleBefore(id, f) {
  if (firstOfShear < 0 || f < firstOfShear) return 0;
  if (anglesAtShear === null) {
    const start = run.frames[firstOfShear].particleStart;
    anglesAtShear = new Float32Array(particleCount);
    idsOf(firstOfShear).forEach((particle, k) => {
      anglesAtShear[particle] = arrays.angle[start + k] * run.mostTurn / 32767;
    });
  }
  return anglesAtShear[id];
}

// (sigma_22 - sigma_11) / (sigma_22 + sigma_11); nothing where there is hardly any stress.
function sinPhi(frame) {
  const [s11, s22] = frame.stress;
  return s11 + s22 > 0.02 * run.pressure ? (s22 - s11) / (s22 + s11) : NaN;
}

// The vertices of particle id in its own frame, and the distance of the farthest one.
const radius = new Float32Array(particleCount);
for (let id = 0; id < particleCount; ++id)
  for (let v = arrays.vertexStart[id]; v < arrays.vertexStart[id + 1]; ++v)
    radius[id] = Math.max(radius[id], Math.hypot(arrays.vertices[2 * v], arrays.vertices[2 * v + 1]));

// Is `id` a piece of `ancestor`, at any remove?
function comesFrom(id, ancestor) {
  for (let p = arrays.parent[id]; p >= 0; p = arrays.parent[p]) if (p === ancestor) return true;
  return false;
}

// Numbers as people write them.
const digits = (value, n = 3) => {
  if (!Number.isFinite(value)) return "–";
  if (value === 0) return "0";
  const size = Math.abs(value);
  if (size >= 1e5 || size < 1e-3) return value.toExponential(n - 1).replace("e", "·10^").replace("+", "");
  return Number(value.toPrecision(n)).toString().replace("-", "−");
};
// With n decimals; not "-0.00".
const fixed = (value, n) => (Math.abs(value) < 0.5 * 10 ** -n ? 0 : value).toFixed(n).replace("-", "−");
const percent = (value, n = 2) => fixed(100 * value, n) + " %";
// With the prefix of a unit: 1234 N is 1.23 kN.
function withUnit(value, unit) {
  const size = Math.abs(value);
  const [factor, prefix] = size >= 1e9 ? [1e9, "G"] : size >= 1e6 ? [1e6, "M"] : size >= 1e3 ? [1e3, "k"]
    : size >= 1 || size === 0 ? [1, ""] : size >= 1e-3 ? [1e-3, "m"] : [1e-6, "µ"];
  return `${digits(value / factor)} ${prefix}${unit}`;
}
