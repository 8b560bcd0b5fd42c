// SPDX-License-Identifier: BSL-1.0
// Curves beside the sample, and the ribbon of stages above the slider.

const charts = [
  { name: "sin φ", colour: "--curve-0", value: sinPhi, format: (v) => fixed(v, 2), floor: 0 },
  { name: "volumetric strain [%]", colour: "--curve-1", value: (f) => 100 * f.volumetric, format: (v) => fixed(v, 1) },
  { name: "breakages", colour: "--curve-2", value: (f) => f.breaks, format: (v) => digits(v, 4), floor: 0 },
].map((chart, n) => ({ ...chart, canvas: document.getElementById(`chart-${n}`) }));

const margin = { left: 44, right: 20, top: 20, bottom: 20 };
let allStages = firstOfShear < 0 || firstOfShear === frameCount - 1;

// The frames that the charts show, and where frame f stands on their horizontal axis.
const firstShown = () => allStages ? 0 : firstOfShear;
const axisValue = (f) => allStages ? f : 100 * run.frames[f].strain;

// Round numbers between two others.
function ticksBetween(low, high, wanted) {
  const span = high - low;
  if (!(span > 0)) return [low];
  const width = roundUp(span / wanted);
  const ticks = [];
  for (let k = Math.ceil(low / width - 1e-9); k * width <= high + 1e-9 * span; ++k) ticks.push(k * width);
  return ticks;
}

// Where the numbers of a chart are on its canvas.
function scalesOf(chart, box) {
  const first = firstShown(), values = [];
  for (let f = first; f < frameCount; ++f) {
    const v = chart.value(run.frames[f]);
    if (Number.isFinite(v)) values.push(v);
  }
  let low = Math.min(...values, chart.floor ?? Infinity), high = Math.max(...values);
  if (!values.length) [low, high] = [0, 1];
  if (!(high > low)) high = low + 1;
  const pad = 0.06 * (high - low);
  high += pad;
  if (chart.floor === undefined || low < chart.floor) low -= pad;
  const left = axisValue(first), right = Math.max(axisValue(frameCount - 1), left + 1e-9);
  const width = box.width - margin.left - margin.right, height = box.height - margin.top - margin.bottom;
  return {
    low, high, left, right,
    x: (v) => margin.left + (v - left) / (right - left) * width,
    y: (v) => margin.top + (high - v) / (high - low) * height,
    bottom: margin.top + height,
  };
}

function drawAxes(ctx, chart, scales, box) {
  ctx.font = "11px system-ui, 'DejaVu Sans', sans-serif";
  ctx.lineWidth = 1;
  ctx.textBaseline = "middle";
  ctx.textAlign = "right";
  for (const v of ticksBetween(scales.low, scales.high, 4)) {
    const y = Math.round(scales.y(v)) + 0.5;
    ctx.strokeStyle = themeColour("--line");
    ctx.beginPath();
    ctx.moveTo(margin.left, y);
    ctx.lineTo(box.width - margin.right, y);
    ctx.stroke();
    ctx.fillStyle = themeColour("--soft");
    ctx.fillText(chart.format(v), margin.left - 6, y);
  }
  ctx.textAlign = "center";
  ctx.textBaseline = "top";
  const ticks = ticksBetween(scales.left, scales.right, 5);
  for (const v of ticks) ctx.fillText(digits(v, 4) + (allStages ? "" : " %"), scales.x(v), scales.bottom + 4);
  ctx.textAlign = "left";
  ctx.fillStyle = themeColour(chart.colour);
  ctx.font = "600 12px system-ui, 'DejaVu Sans', sans-serif";
  ctx.fillText(chart.name, margin.left, 3);
}

// Where stages begin, as vertical lines.
function drawStages(ctx, scales) {
  if (!allStages) return;
  ctx.strokeStyle = themeColour("--soft");
  ctx.setLineDash([3, 3]);
  for (let f = 1; f < frameCount; ++f) {
    if (run.frames[f].stage === run.frames[f - 1].stage) continue;
    ctx.beginPath();
    ctx.moveTo(scales.x(f), margin.top);
    ctx.lineTo(scales.x(f), scales.bottom);
    ctx.stroke();
  }
  ctx.setLineDash([]);
}

function drawCurve(ctx, chart, scales) {
  ctx.strokeStyle = themeColour(chart.colour);
  ctx.lineWidth = 1.6;
  ctx.lineJoin = "round";
  ctx.beginPath();
  let pen = false;
  for (let f = firstShown(); f < frameCount; ++f) {
    const v = chart.value(run.frames[f]);
    // A gap where there is no number, and between stages, whose strains start anew.
    const gap = !Number.isFinite(v) || (f > 0 && run.frames[f].stage !== run.frames[f - 1].stage);
    if (Number.isFinite(v)) {
      if (pen && !gap) ctx.lineTo(scales.x(axisValue(f)), scales.y(v));
      else ctx.moveTo(scales.x(axisValue(f)), scales.y(v));
    }
    pen = Number.isFinite(v);
  }
  ctx.stroke();
}

function drawMarker(ctx, chart, scales, f) {
  const x = scales.x(axisValue(Math.max(f, firstShown())));
  ctx.strokeStyle = themeColour("--accent");
  ctx.lineWidth = 1.5;
  ctx.beginPath();
  ctx.moveTo(x, margin.top - 2);
  ctx.lineTo(x, scales.bottom);
  ctx.stroke();
  const v = chart.value(run.frames[f]);
  if (!Number.isFinite(v) || f < firstShown()) return;
  ctx.fillStyle = themeColour("--accent");
  ctx.beginPath();
  ctx.arc(x, scales.y(v), 4, 0, 2 * Math.PI);
  ctx.fill();
  ctx.font = "600 12px system-ui, 'DejaVu Sans', sans-serif";
  ctx.textAlign = "right";
  ctx.textBaseline = "top";
  ctx.fillText(chart.format(v), chart.canvas.clientWidth - margin.right, 3);
}

// All but the marker stays the same from frame to frame: it is drawn once for a size and a theme.
function drawChart(chart, f) {
  const box = sizeCanvas(chart.canvas);
  if (!box) return;
  const ctx = chart.canvas.getContext("2d");
  const key = [chart.canvas.width, chart.canvas.height, allStages, isDark()].join();
  if (chart.key !== key) {
    chart.key = key;
    chart.scales = scalesOf(chart, box);
    chart.still = document.createElement("canvas");
    chart.still.width = chart.canvas.width;
    chart.still.height = chart.canvas.height;
    const still = chart.still.getContext("2d");
    still.setTransform(ctx.getTransform());
    drawAxes(still, chart, chart.scales, box);
    drawStages(still, chart.scales);
    drawCurve(still, chart, chart.scales);
  }
  ctx.clearRect(0, 0, box.width, box.height);
  ctx.drawImage(chart.still, 0, 0, box.width, box.height);
  drawMarker(ctx, chart, chart.scales, f);
}

// The frame that is nearest to a horizontal place on a chart.
function frameAtChart(chart, sx) {
  const box = chart.canvas.getBoundingClientRect();
  const scales = scalesOf(chart, box);
  let best = firstShown();
  for (let f = best; f < frameCount; ++f)
    if (Math.abs(scales.x(axisValue(f)) - sx) < Math.abs(scales.x(axisValue(best)) - sx)) best = f;
  return best;
}

// Stages by name, and how many particles break between frames.
function drawRibbon() {
  const canvas = document.getElementById("ribbon");
  const box = sizeCanvas(canvas);
  if (!box) return;
  const ctx = canvas.getContext("2d");
  ctx.clearRect(0, 0, box.width, box.height);
  const inset = 8; // half of the slider's thumb
  const x = (f) => inset + f / Math.max(1, frameCount - 1) * (box.width - 2 * inset);
  const counts = new Map();
  for (const b of run.breaks) counts.set(b.frame, (counts.get(b.frame) ?? 0) + 1);
  const most = Math.max(1, ...counts.values());
  ctx.fillStyle = themeColour("--curve-2");
  ctx.globalAlpha = 0.75;
  for (const [f, n] of counts) {
    const height = 2 + 18 * Math.sqrt(n / most);
    ctx.fillRect(x(f), box.height - height, Math.max(1, (box.width - 2 * inset) / frameCount - 0.5), height);
  }
  ctx.globalAlpha = 1;
  ctx.font = "11px system-ui, 'DejaVu Sans', sans-serif";
  ctx.textBaseline = "top";
  ctx.fillStyle = themeColour("--soft");
  ctx.strokeStyle = themeColour("--line");
  for (let f = 0; f < frameCount;) {
    let end = f;
    while (end + 1 < frameCount && run.frames[end + 1].stage === run.frames[f].stage) ++end;
    const name = run.stages[run.frames[f].stage];
    if (f > 0) ctx.fillRect(Math.round(x(f)), 2, 1, box.height - 2);
    if (ctx.measureText(name).width + 8 < x(end) - x(f)) ctx.fillText(name, x(f) + 5, 2);
    f = end + 1;
  }
}
