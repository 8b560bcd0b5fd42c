// SPDX-License-Identifier: BSL-1.0
// What a particle's colour means. A mode puts each particle into a bin, and each bin has a colour.

const isDark = () => document.documentElement.dataset.theme === "dark";
const themeColour = (name) => getComputedStyle(document.documentElement).getPropertyValue(name).trim();

// A colour between those of a list, at t in [0, 1].
function between(colours, t) {
  const at = Math.min(Math.max(t, 0), 1) * (colours.length - 1);
  const k = Math.min(Math.floor(at), colours.length - 2);
  const channel = (hex, n) => parseInt(hex.slice(1 + 2 * n, 3 + 2 * n), 16);
  const mixed = [0, 1, 2].map((n) =>
    Math.round(channel(colours[k], n) + (at - k) * (channel(colours[k + 1], n) - channel(colours[k], n))));
  return `rgb(${mixed.join(",")})`;
}

const palettes = {
  light: {
    rat: ["#e3dfd6", "#efcd7b", "#dc7c30", "#a31c1c"],
    strain: ["#e9e4d8", "#d9c27a", "#c9713f", "#8f2d56", "#3d1a4f"],
    speed: ["#e3dfd6", "#9cc7bb", "#37868b", "#163f5e"],
    turn: ["#1f5f98", "#8bb2d0", "#e6e2da", "#dfa184", "#a83f22"],
    generation: ["#dedad1", "#a9c6d9", "#6e9fc4", "#3f76a8", "#27507f", "#152f52"],
    contacts: ["#e9b44c", "#efe9dd", "#d8dbc9", "#b5c8ac", "#86ad8c", "#578d70", "#2f6b57", "#174a40"],
    family: ["#c8553d", "#d99b48", "#8aa653", "#3f8f6e", "#3b8ea5", "#4a6fa5", "#7d5ba6", "#b5628e", "#9a7048", "#5f7a3c", "#cf7f77", "#5b9fd0"],
    stress: ["#1f4f8f", "#8bb2d0", "#f1eee8", "#e29578", "#a31c1c"],
  },
  dark: {
    rat: ["#4a4c4f", "#9c7b3b", "#e0752f", "#ff4f3d"],
    strain: ["#3c3f43", "#5b4a78", "#b0487a", "#f08a5a", "#fbe6a2"],
    speed: ["#3c3f43", "#2c6f78", "#6fc0b0", "#f1f6cf"],
    turn: ["#62b0f2", "#3f6f96", "#4a4c4f", "#9a5a40", "#ff8a5e"],
    generation: ["#4a4c4f", "#2f5775", "#3f7ba3", "#58a2cf", "#86c5ea", "#c9e8fb"],
    contacts: ["#e9b44c", "#3a3c3f", "#3c4a44", "#3f5f51", "#45795f", "#549a75", "#74bf92", "#aee6bf"],
    family: ["#e0694f", "#e6ad5b", "#9dbb63", "#52a884", "#4fa7bf", "#6a90c9", "#9a78c5", "#cf7aa8", "#b68a5e", "#7d9a54", "#e09a92", "#79b8e6"],
    stress: ["#5aa0ee", "#3f6f96", "#33363a", "#9a5a40", "#ff6a4d"],
  },
};
const palette = () => palettes[isDark() ? "dark" : "light"];

const steps = 28; // of a continuous scale
const scaleColours = (name) => Array.from({ length: steps }, (_, k) => between(palette()[name], k / (steps - 1)));
const step = (t) => Math.min(steps - 1, Math.max(0, Math.floor(t * steps)));

// The value that a share of all particles at some frames of shear does not exceed.
function quantile(share, value) {
  const values = [];
  const from = Math.max(firstOfShear, 0);
  const stride = Math.max(1, Math.floor((frameCount - from) / 12));
  for (let f = from; f < frameCount; f += stride) {
    const state = makeState(f);
    for (let k = 0; k < state.n; ++k) if (arrays.motion[state.ids[k]] === 0) values.push(value(state, k));
  }
  values.sort((p, q) => p - q);
  return values.length ? values[Math.floor(share * (values.length - 1))] : 0;
}
// 1, 2 or 5 times a power of ten, not below the value.
function roundUp(value) {
  if (!(value > 0)) return 1;
  const power = 10 ** Math.floor(Math.log10(value));
  return power * [1, 2, 5, 10].find((n) => n * power >= value * (1 - 1e-9));
}
// Found when first needed.
const once = (find) => { let value; return () => value ??= find(); };

const turnOf = (state, k) => state.angle(k) - angleBefore(state.ids[k], state.f);
const mostTurn = once(() => roundUp(quantile(0.97, (s, k) => Math.abs(turnOf(s, k))) * 180 / Math.PI));
const mostSpeed = once(() => roundUp(quantile(0.99, (s, k) => s.speed(k))));
const mostStrain = once(() => roundUp(quantile(0.98, (s, k) => s.strain(k))));
const mostRat = () => run.ratf && run.ratf <= 1 ? run.ratf : 1;

const colourModes = [
  {
    key: "rat", name: "Rat", title: "Rat: share of failed elements",
    colours: () => scaleColours("rat"),
    bin: (s, k) => step(s.rat(k) / mostRat()),
    legend: () => bar("rat", ["0", digits(mostRat() / 2), digits(mostRat()) + (run.ratf ? ": breaks" : "")]),
  },
  {
    key: "parent", name: "Parent", title: "Pieces of one parent (the intact particle)",
    colours: () => [palette().generation[0], ...palette().family],
    bin: (s, k) => {
      const id = s.ids[k];
      return arrays.generation[id] === 0 ? 0 : 1 + (arrays.root[id] * 7) % palette().family.length;
    },
    legend: () => keys([[palette().generation[0], "whole"], [palette().family[0], "pieces, a colour per parent"]]),
  },
  {
    key: "generation", name: "Generation", title: "Generation: breaks since intact",
    colours: () => palette().generation,
    bin: (s, k) => Math.min(arrays.generation[s.ids[k]], palette().generation.length - 1),
    legend: () => keys(palette().generation.map((c, n, all) => [c, n + 1 === all.length ? `${n}+` : `${n}`])),
  },
  {
    key: "rotation", name: "Rotation", title: "Rotation since the start of shear [°]",
    colours: () => scaleColours("turn"),
    bin: (s, k) => step(0.5 + turnOf(s, k) * 90 / Math.PI / mostTurn()),
    legend: () => bar("turn", [`−${digits(mostTurn())}`, "0", `${digits(mostTurn())} anticlockwise`]),
  },
  {
    key: "strain", name: "Local strain", title: "Local deviatoric strain in shear [%]",
    colours: () => scaleColours("strain"),
    bin: (s, k) => step(s.strain(k) / mostStrain()),
    legend: () => bar("strain", [0, 0.5, 1].map((n) => digits(100 * n * mostStrain()))),
  },
  {
    key: "speed", name: "Speed", title: "Speed [m/s], logarithmic",
    colours: () => scaleColours("speed"),
    bin: (s, k) => step(1 + Math.log10(s.speed(k) / mostSpeed()) / 2),
    legend: () => bar("speed", [0.01, 0.1, 1].map((n) => digits(n * mostSpeed(), 2))),
  },
  {
    key: "contacts", name: "Coordination", title: "Coordination: contacts of a particle",
    colours: () => palette().contacts,
    bin: (s, k) => Math.min(s.neighbours[k], palette().contacts.length - 1),
    legend: () => keys(palette().contacts.map((c, n, all) => [c, n + 1 === all.length ? `${n}+` : `${n}`])),
  },
  {
    key: "rattlers", name: "Rattlers", title: "Rattlers: particles that carry no load",
    colours: () => [palette().generation[0], palette().family[0]],
    bin: (s, k) => s.rattler(k),
    legend: () => keys([[palette().generation[0], "carries load"], [palette().family[0], "rattler"]]),
  },
];

// Where there are several.
if (arrays.material) {
  const count = arrays.material.reduce((most, m) => Math.max(most, m), 0) + 1;
  const colour = (m) => palette().family[(m * 5) % palette().family.length];
  const all = () => Array.from({ length: count }, (_, m) => colour(m));
  colourModes.push({
    key: "material", name: "Material", title: "Material: place in the list of rocks",
    colours: all,
    bin: (s, k) => arrays.material[s.ids[k]],
    legend: () => keys(all().map((c, m) => [c, `${m}`])),
  });
}

// Elements of a legend.
function bar(name, ticks) {
  return `<div class="bar" style="background:linear-gradient(90deg,${palette()[name].join(",")})"></div>` +
    `<div class="ticks">${ticks.map((t) => `<span>${t}</span>`).join("")}</div>`;
}
function keys(entries) {
  return `<div class="keys">${entries.map(([c, t]) => `<span><i style="background:${c}"></i>${t}</span>`).join("")}</div>`;
}
