// SPDX-License-Identifier: BSL-1.0
// The sample: particles, force chains, cracks, what is selected. Lengths in metres, y upwards; the
// camera says which point is in the middle and how many pixels a metre has.

const view = {
  canvas: document.getElementById("view"),
  camera: { x: 0, y: 0, scale: 1000 },
  width: 0, height: 0, // in CSS pixels
};
const context = view.canvas.getContext("2d");

// Fits the canvas to its place on the page; false if it has none.
function sizeCanvas(canvas) {
  const box = canvas.getBoundingClientRect();
  const ratio = Math.min(window.devicePixelRatio || 1, 2);
  const width = Math.round(box.width * ratio), height = Math.round(box.height * ratio);
  if (canvas.width !== width || canvas.height !== height) {
    canvas.width = width;
    canvas.height = height;
  }
  canvas.getContext("2d").setTransform(ratio, 0, 0, ratio, 0, 0);
  return box.width > 0 && box.height > 0 ? box : null;
}

const toScreen = (x, y) => [
  (x - view.camera.x) * view.camera.scale + view.width / 2,
  view.height / 2 - (y - view.camera.y) * view.camera.scale,
];
const toWorld = (sx, sy) => [
  (sx - view.width / 2) / view.camera.scale + view.camera.x,
  (view.height / 2 - sy) / view.camera.scale + view.camera.y,
];

// The whole sample of a frame, without platens: they reach far beyond it.
function fitView(state) {
  let left = Infinity, right = -Infinity, bottom = Infinity, top = -Infinity;
  for (let k = 0; k < state.n; ++k) {
    const id = state.ids[k], r = arrays.motion[id] === 3 ? 0 : radius[id];
    left = Math.min(left, state.x[k] - r);
    right = Math.max(right, state.x[k] + r);
    bottom = Math.min(bottom, state.y[k] - r);
    top = Math.max(top, state.y[k] + r);
  }
  view.camera.x = (left + right) / 2;
  view.camera.y = (bottom + top) / 2;
  view.camera.scale = 0.94 * Math.min(view.width / (right - left), view.height / (top - bottom)) || 1000;
}

// Zooms about a point of the screen.
function zoomAt(factor, sx, sy) {
  const [x, y] = toWorld(sx, sy);
  const scale = Math.min(Math.max(view.camera.scale * factor, 20), 400000);
  view.camera.x = x - (sx - view.width / 2) / scale;
  view.camera.y = y - (view.height / 2 - sy) / scale;
  view.camera.scale = scale;
}

// Adds the outline of a particle to the path of a context.
function traceParticle(ctx, state, k) {
  const { x: cx, y: cy, scale } = view.camera;
  const first = arrays.vertexStart[state.ids[k]], last = arrays.vertexStart[state.ids[k] + 1];
  const x = (state.x[k] - cx) * scale + view.width / 2, y = view.height / 2 - (state.y[k] - cy) * scale;
  const c = state.cos[k] * scale, s = state.sin[k] * scale;
  for (let v = first; v < last; ++v) {
    const u = arrays.vertices[2 * v], w = arrays.vertices[2 * v + 1];
    const px = x + c * u - s * w, py = y - s * u - c * w;
    if (v === first) ctx.moveTo(px, py); else ctx.lineTo(px, py);
  }
  ctx.closePath();
}

// The particles that are in sight, as places sorted by the bin of their colour.
const ringBin = 255;
function visibleByBin(state, mode) {
  const groups = new Map();
  const [left, top] = toWorld(0, 0), [right, bottom] = toWorld(view.width, view.height);
  for (let k = 0; k < state.n; ++k) {
    const id = state.ids[k], r = radius[id];
    if (state.x[k] + r < left || state.x[k] - r > right || state.y[k] + r < bottom || state.y[k] - r > top) continue;
    const bin = arrays.motion[id] === 0 ? mode.bin(state, k) : ringBin;
    if (!groups.has(bin)) groups.set(bin, []);
    groups.get(bin).push(k);
  }
  return groups;
}

function drawParticles(state, mode, faded) {
  const colours = mode.colours();
  const groups = visibleByBin(state, mode);
  context.globalAlpha = faded ? 0.55 : 1;
  context.strokeStyle = themeColour("--edge");
  const size = run.diameter * view.camera.scale;
  context.lineWidth = Math.min(1.4, Math.max(0.35, size / 45));
  context.lineJoin = "round";
  for (const [bin, places] of groups) {
    context.fillStyle = bin === ringBin ? themeColour("--ring") : colours[bin];
    // One path each: a path of many particles takes a processor twice as long.
    for (const k of places) {
      context.beginPath();
      traceParticle(context, state, k);
      context.fill();
      if (size > 5) context.stroke(); // else too small for an outline
    }
  }
  context.globalAlpha = 1;
}

// Lines are as wide as the force is large, but for the largest. The force p d t, which a particle of
// diameter d carries on average, has a few pixels, also where particles are drawn large.
const unitForce = run.pressure * run.diameter * run.thickness;
const unitWidth = () => Math.min(0.06 * run.diameter * view.camera.scale, 3.5);
const widthOf = (force) => Math.min(force / unitForce, 10) * unitWidth();

// The copy of a coordinate that is nearest to another, in a periodic cell.
const nearest = (value, to, period) => value - period * Math.round((value - to) / period);

// From centroid to contact point to centroid. A platen's centroid is no part of a chain.
function traceContact(state, i) {
  const px = state.px(i), py = state.py(i);
  const cell = state.frame.cell;
  const ends = [state.a(i), state.b(i)].filter((k) => arrays.motion[state.ids[k]] !== 3).map((k) =>
    cell ? [nearest(state.x[k], px, cell[2]), nearest(state.y[k], py, cell[3])] : [state.x[k], state.y[k]]);
  const point = toScreen(px, py);
  ends.forEach(([x, y], n) => {
    if (n === 0) context.moveTo(...toScreen(x, y)); else context.lineTo(...toScreen(x, y));
    if (n === 0) context.lineTo(...point);
  });
}

// All contacts, or those above the mean normal force: the strong network.
function drawChains(state, strongOnly) {
  context.strokeStyle = themeColour("--chain");
  context.lineCap = "round";
  context.lineJoin = "round";
  for (let i = 0; i < state.contacts; ++i) {
    if (strongOnly && state.normal(i) <= state.frame.meanForce) continue;
    const width = widthOf(state.normal(i));
    if (width < 0.15) continue; // too weak to be seen
    context.lineWidth = Math.max(0.4, width);
    context.beginPath();
    traceContact(state, i);
    context.stroke();
  }
  context.lineCap = "butt";
}

// The part of the line of a break that lies in the particle, in laboratory coordinates.
function crackOf(b) {
  const [px, py, dx, dy] = b.line;
  const [x, y, angle] = b.pose;
  const c = Math.cos(angle), s = Math.sin(angle);
  const first = arrays.vertexStart[b.id], count = arrays.vertexStart[b.id + 1] - first;
  const corner = (n) => {
    const v = first + n % count;
    const u = arrays.vertices[2 * v], w = arrays.vertices[2 * v + 1];
    return [x + c * u - s * w, y + s * u + c * w];
  };
  const ends = [];
  for (let n = 0; n < count; ++n) {
    const p = corner(n), q = corner(n + 1);
    const left = (r) => dx * (r[1] - py) - dy * (r[0] - px);
    const l = left(p), m = left(q);
    if (l > 0 !== m > 0) ends.push([p[0] + (q[0] - p[0]) * l / (l - m), p[1] + (q[1] - p[1]) * l / (l - m)]);
  }
  return ends;
}

// The lines of the breaks that come next.
function drawCracks(state, selected) {
  for (const b of breaksAfter(state.f)) {
    const ends = crackOf(b);
    if (ends.length !== 2) continue;
    context.beginPath();
    context.moveTo(...toScreen(...ends[0]));
    context.lineTo(...toScreen(...ends[1]));
    // With a rim, to be seen on all colours.
    for (const [colour, width] of [["--sheet", 5], ["--select", b.id === selected ? 3 : 2]]) {
      context.strokeStyle = themeColour(colour);
      context.lineWidth = width;
      context.stroke();
    }
  }
}

// Breaks between frame f and the next.
function breaksAfter(f) {
  const { first, last } = breakRange(f);
  return run.breaks.slice(first, last);
}
function breakRange(f) {
  const find = (frame) => {
    let low = 0, high = run.breaks.length;
    while (low < high) {
      const middle = (low + high) >> 1;
      if (run.breaks[middle].frame < frame) low = middle + 1; else high = middle;
    }
    return low;
  };
  return { first: find(f), last: find(f + 1) };
}

// The outline of the selected particle, or of what it has become.
function drawSelection(state, selected) {
  if (selected < 0) return;
  context.beginPath();
  let pieces = false;
  const whole = state.place(selected);
  if (whole >= 0) traceParticle(context, state, whole);
  else
    for (let k = 0; k < state.n; ++k)
      if (comesFrom(state.ids[k], selected)) {
        traceParticle(context, state, k);
        pieces = true;
      }
  context.strokeStyle = themeColour("--select");
  context.lineWidth = 2.5;
  context.setLineDash(pieces ? [5, 3] : []);
  context.stroke();
  context.setLineDash([]);
}

function drawCell(state) {
  if (!state.frame.cell) return;
  const [x, y, width, height] = state.frame.cell;
  const [left, top] = toScreen(x - width / 2, y + height / 2);
  context.strokeStyle = themeColour("--soft");
  context.setLineDash([6, 4]);
  context.lineWidth = 1;
  context.strokeRect(left, top, width * view.camera.scale, height * view.camera.scale);
  context.setLineDash([]);
}

function drawView(state, mode, chains, strongOnly, selected) {
  const box = sizeCanvas(view.canvas);
  if (!box) return;
  view.width = box.width;
  view.height = box.height;
  context.fillStyle = themeColour("--page");
  context.fillRect(0, 0, view.width + 1, view.height + 1); // the last pixels as a whole
  drawParticles(state, mode, chains);
  if (chains) drawChains(state, strongOnly);
  drawCell(state);
  drawCracks(state, selected);
  drawSelection(state, selected);
}

// The particle at a point of the screen; -1 if there is none.
function particleAt(state, sx, sy) {
  const [x, y] = toWorld(sx, sy);
  for (let k = state.n - 1; k >= 0; --k) {
    const id = state.ids[k], dx = x - state.x[k], dy = y - state.y[k];
    if (Math.hypot(dx, dy) > radius[id]) continue;
    const u = state.cos[k] * dx + state.sin[k] * dy, w = state.cos[k] * dy - state.sin[k] * dx;
    const first = arrays.vertexStart[id], last = arrays.vertexStart[id + 1], p = arrays.vertices;
    let inside = true;
    for (let v = first, before = last - 1; v < last && inside; before = v++)
      inside = (p[2 * v] - p[2 * before]) * (w - p[2 * before + 1]) >= (p[2 * v + 1] - p[2 * before + 1]) * (u - p[2 * before]);
    if (inside) return id;
  }
  return -1;
}
