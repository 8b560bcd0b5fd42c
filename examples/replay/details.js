// SPDX-License-Identifier: BSL-1.0
// What is known of the selected particle, how it broke, and the list of all breaks.

const modes = ["intact", "tension", "shear"]; // of the first failed element

const linkTo = (id) => `<button class="link" data-particle="${id}">${id}</button>`;
const row = (name, value) => `<dt>${name}</dt><dd>${value}</dd>`;

// Numbers of a particle at the frame shown.
function particleNow(state, id) {
  const k = state.place(id);
  if (k < 0) {
    const b = breakOf.get(id);
    const gone = b && state.f > b.frame;
    return `<p class="hint">${gone ? "It has broken by this frame." : "It is not there at this frame."}</p>`;
  }
  return `<dl class="data">` +
    row("x", withUnit(state.x[k], "m")) + row("y", withUnit(state.y[k], "m")) +
    row("Speed", withUnit(state.speed(k), "m/s")) + row("Spin", withUnit(state.spin(k), "rad/s")) +
    row("Rat", digits(state.rat(k))) + row("Contacts", state.neighbours[k]) +
    row("Rotation", digits(turnOf(state, k) * 180 / Math.PI) + "°") + row("Max. force", withUnit(largestForce(state, k), "N")) +
    row("Strain", percent(state.strain(k))) + row("Carries load", state.rattler(k) ? "no: rattler" : "yes") +
    `</dl>`;
}
function largestForce(state, k) {
  let most = 0;
  for (let i = 0; i < state.contacts; ++i)
    if (state.a(i) === k || state.b(i) === k) most = Math.max(most, state.normal(i));
  return most;
}

const motions = ["", "prescribed", "boundary", "platen"];

function showParticle(panel, state, id) {
  if (id < 0) {
    panel.innerHTML = `<p class="hint">Click a particle to see what it is, what loads it and how it broke.</p>`;
    return;
  }
  const parent = arrays.parent[id], root = arrays.root[id];
  const broke = breakOf.get(id), born = breakOf.get(parent);
  panel.innerHTML = `<h3>Particle ${id}${arrays.motion[id] ? `, ${motions[arrays.motion[id]]}` : ""}</h3>` +
    `<dl class="data">` +
    row("Parent", parent < 0 ? "–" : linkTo(parent)) + row("Root", root === id ? "–" : linkTo(root)) +
    row("Generation", arrays.generation[id]) + row("Area", digits(arrays.area[id] * 1e6) + " mm²") +
    `</dl><div id="now">${particleNow(state, id)}</div>` +
    (broke ? breakCard(broke, "broken", "It broke") : "") +
    (born ? breakCard(born, "born", "It came from the break of " + linkTo(parent)) : "");
  if (broke) drawBreak(panel.querySelector("#broken"), broke);
  if (born) drawBreak(panel.querySelector("#born"), born);
}

function breakCard(b, name, title) {
  const area = b.areas[0] + b.areas[1];
  const pieces = b.pieces.map((id, n) =>
    `${id === null ? "dust" : linkTo(id)} (${Math.round(100 * b.areas[n] / area)} %)`).join(" and ");
  const bySamples = b.samples[1] > 0;
  const why = bySamples
    ? `${countFailed(b)} of ${b.samples[1]} elements failed, Rat ${digits(b.rat)}, the first in ${modes[b.mode]}`
    : `by the contact loads, in ${modes[b.mode]}`;
  const hidden = bySamples ? "" : " hidden";
  return `<article class="card" id="${name}">` +
    `<div class="row"><h3>${title}</h3><button data-break="${b.number}">Go there</button></div>` +
    `<canvas role="img" aria-label="Mesh, failed elements, loads and the line of the break"></canvas>` +
    `<div class="scale"${hidden}><span data-scale="low"></span><span class="bar"></span><span data-scale="high"></span></div>` +
    `<p>In ${run.stages[b.stage]} at a strain of ${percent(b.strain)}: ${why}. Pieces: ${pieces}.</p>` +
    `<label${hidden}>Elements by <select aria-label="Colour of the elements">` +
    `<option value="minor">minor principal stress</option><option value="major">major principal stress</option>` +
    `<option value="shear">largest shear stress</option></select></label></article>`;
}

function countFailed(b) {
  let count = 0;
  for (let k = 0; k < b.samples[1]; ++k) count += arrays.failed[b.samples[0] + k];
  return count;
}

// Principal stresses of each triangle of a break, means over its sampling points [Pa], and whether
// one of these has failed.
function elementsOf(b, measure) {
  const count = b.triangles[1] / 3, perTriangle = b.samples[1] / count;
  return Array.from({ length: count }, (_, e) => {
    let s11 = 0, s22 = 0, s12 = 0, failed = false;
    for (let n = 0; n < perTriangle; ++n) {
      const sample = b.samples[0] + e * perTriangle + n;
      s11 += arrays.elementStress[3 * sample] / perTriangle;
      s22 += arrays.elementStress[3 * sample + 1] / perTriangle;
      s12 += arrays.elementStress[3 * sample + 2] / perTriangle;
      failed ||= arrays.failed[sample] === 1;
    }
    const mean = (s11 + s22) / 2, shear = Math.hypot((s11 - s22) / 2, s12);
    const value = measure === "minor" ? mean - shear : measure === "major" ? mean + shear : shear;
    return { value, failed };
  });
}

// The nodes of the mesh, as the particle lay.
function nodesOf(b) {
  const [x, y, angle] = b.pose;
  const c = Math.cos(angle), s = Math.sin(angle);
  return Array.from({ length: b.nodes[1] / 2 }, (_, n) => {
    const u = arrays.nodes[b.nodes[0] + 2 * n], w = arrays.nodes[b.nodes[0] + 2 * n + 1];
    return [x + c * u - s * w, y + s * u + c * w];
  });
}

// From metres to a canvas, on which points and the arrows around them have room.
function placeIn(box, points) {
  const ends = [0, 1].map((n) => [Math.min(...points.map((p) => p[n])), Math.max(...points.map((p) => p[n]))]);
  const [[left, right], [bottom, top]] = ends;
  const room = 38; // of an arrow
  const scale = Math.min((box.width - 2 * room) / (right - left), (box.height - 2 * room) / (top - bottom));
  return (x, y) => [box.width / 2 + (x - (left + right) / 2) * scale, box.height / 2 - (y - (bottom + top) / 2) * scale];
}

// Colours of a stress, where among them a value is, and what stands at their ends.
function stressScale(measure, most) {
  if (measure === "shear")
    return { colours: palette().rat, place: (v) => v / most, low: "0", high: `${digits(most / 1e6, 2)} MPa` };
  return {
    colours: [...palette().stress].reverse(), place: (v) => 0.5 + 0.5 * v / most,
    low: `${digits(-most / 1e6, 2)} MPa tension`, high: `${digits(most / 1e6, 2)} MPa compression`,
  };
}

// Draws the particle as it lay, before it broke.
function drawBreak(card, b) {
  const measure = card.querySelector("select").value;
  const canvas = card.querySelector("canvas");
  const box = sizeCanvas(canvas);
  if (!box) return;
  const ctx = canvas.getContext("2d");
  ctx.clearRect(0, 0, box.width, box.height);
  const nodes = nodesOf(b);
  const place = placeIn(box, nodes);
  const corners = (e) => [0, 1, 2].map((n) => place(...nodes[arrays.triangles[b.triangles[0] + 3 * e + n]]));
  const elements = elementsOf(b, measure);
  const sizes = elements.map((e) => Math.abs(e.value)).sort((p, q) => p - q);
  const most = sizes[Math.floor(0.97 * (sizes.length - 1))] || 1;
  const scale = stressScale(measure, most);
  if (!elements.length) {
    ctx.beginPath();
    nodes.forEach((x) => ctx.lineTo(...place(...x)));
    ctx.closePath();
    ctx.strokeStyle = themeColour("--line");
    ctx.stroke();
  }
  elements.forEach((element, e) => {
    const [p, q, r] = corners(e);
    ctx.beginPath();
    ctx.moveTo(...p);
    ctx.lineTo(...q);
    ctx.lineTo(...r);
    ctx.closePath();
    ctx.fillStyle = between(scale.colours, scale.place(element.value));
    ctx.fill();
    ctx.strokeStyle = themeColour("--line");
    ctx.lineWidth = 0.6;
    ctx.stroke();
    if (!element.failed) return;
    ctx.beginPath();
    ctx.arc((p[0] + q[0] + r[0]) / 3, (p[1] + q[1] + r[1]) / 3, 2.2, 0, 2 * Math.PI);
    ctx.fillStyle = themeColour("--ink");
    ctx.fill();
  });
  drawLoads(ctx, b, place);
  drawCut(ctx, b, place);
  card.querySelector('[data-scale="low"]').textContent = scale.low;
  card.querySelector('[data-scale="high"]').textContent = scale.high;
  card.querySelector(".bar").style.background = `linear-gradient(90deg,${scale.colours.join(",")})`;
}

// Contact forces, as arrows that end at the contact.
function drawLoads(ctx, b, place) {
  const loads = [];
  for (let k = 0; k < b.loads[1]; k += 4) loads.push(arrays.loads.subarray(b.loads[0] + k, b.loads[0] + k + 4));
  const most = Math.max(...loads.map((l) => Math.hypot(l[2], l[3])));
  ctx.strokeStyle = ctx.fillStyle = themeColour("--accent");
  ctx.lineWidth = 1.8;
  for (const [px, py, fx, fy] of loads) {
    const size = Math.hypot(fx, fy), length = 8 + 30 * size / most;
    const [x, y] = place(px, py), u = fx / size, v = -fy / size;
    ctx.beginPath();
    ctx.moveTo(x - length * u, y - length * v);
    ctx.lineTo(x - 5 * u, y - 5 * v);
    ctx.stroke();
    ctx.beginPath();
    ctx.moveTo(x, y);
    ctx.lineTo(x - 7 * u + 3 * v, y - 7 * v - 3 * u);
    ctx.lineTo(x - 7 * u - 3 * v, y - 7 * v + 3 * u);
    ctx.fill();
  }
}

// The line, somewhat beyond the particle, and the ids of the pieces on its sides.
function drawCut(ctx, b, place) {
  const ends = crackOf(b);
  if (ends.length !== 2) return;
  const [p, q] = ends.map(([x, y]) => place(x, y));
  const length = Math.hypot(q[0] - p[0], q[1] - p[1]), u = (q[0] - p[0]) / length, v = (q[1] - p[1]) / length;
  ctx.strokeStyle = themeColour("--select");
  ctx.lineWidth = 2.2;
  ctx.beginPath();
  ctx.moveTo(p[0] - 9 * u, p[1] - 9 * v);
  ctx.lineTo(q[0] + 9 * u, q[1] + 9 * v);
  ctx.stroke();
  // The left piece is on the left of the line's own direction.
  const [, , dx, dy] = b.line;
  ctx.font = "600 12px system-ui, 'DejaVu Sans', sans-serif";
  ctx.textAlign = "center";
  ctx.textBaseline = "middle";
  ctx.lineWidth = 3;
  ctx.strokeStyle = themeColour("--sheet");
  ctx.fillStyle = themeColour("--select");
  b.pieces.forEach((id, n) => {
    const side = n === 0 ? 20 : -20;
    const x = (p[0] + q[0]) / 2 - dy * side, y = (p[1] + q[1]) / 2 - dx * side;
    const text = id === null ? "dust" : `${id}`;
    ctx.strokeText(text, x, y);
    ctx.fillText(text, x, y);
  });
}

// All breaks in the order of time.
function listBreaks(panel) {
  if (!run.breaks.length) {
    panel.innerHTML = `<p class="hint" style="padding:12px 14px">No particle broke in this run.</p>`;
    return;
  }
  const rows = run.breaks.map((b) =>
    `<tr data-break="${b.number}"><td><button class="link" data-break="${b.number}" ` +
    `aria-label="Go to the break of particle ${b.id}">${run.stages[b.stage] === "shear" ? percent(b.strain) : run.stages[b.stage]}</button></td>` +
    `<td>${b.id}</td><td>${arrays.generation[b.id]}</td><td>${digits((b.areas[0] + b.areas[1]) * 1e6)}</td>` +
    `<td>${digits(b.rat)}</td><td>${modes[b.mode]}</td></tr>`);
  panel.innerHTML = `<table><thead><tr><th scope="col">Strain</th><th scope="col">Particle</th><th scope="col">Gen.</th>` +
    `<th scope="col">mm²</th><th scope="col">Rat</th><th scope="col">First</th></tr></thead><tbody>${rows.join("")}</tbody></table>`;
}

// Shows in the list how far the run has come.
let shownPassed = 0;
function markPassed(panel, f) {
  const { first } = breakRange(f);
  const rows = panel.querySelectorAll("tbody tr");
  for (let k = Math.min(first, shownPassed); k < Math.max(first, shownPassed); ++k) rows[k]?.classList.toggle("passed", k < first);
  shownPassed = first;
}
