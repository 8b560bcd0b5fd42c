// SPDX-License-Identifier: BSL-1.0
// The state of the page, what changes it (clock, pointer, keys, buttons), and the first picture.

const $ = (id) => document.getElementById(id);
const show = {
  frame: 0, playing: false, speed: 20, // frames per second
  mode: 0, chains: false, strong: false, selected: -1, currentBreak: -1,
};
const speeds = [1, 2, 5, 10, 20, 30, 60, 120];

// What has to be drawn anew at the next refresh of the screen.
const stale = { view: true, charts: true, panel: true };
let refreshAsked = false;
function refresh(...parts) {
  for (const part of parts) stale[part] = true;
  if (!refreshAsked) requestAnimationFrame(draw);
  refreshAsked = true;
}

function draw() {
  refreshAsked = false;
  if (stale.view && show.chains) document.documentElement.style.setProperty("--unit-width", `${Math.max(0.5, widthOf(unitForce)).toFixed(1)}px`);
  const state = frameState(show.frame);
  if (stale.view) drawView(state, colourModes[show.mode], show.chains, show.strong, show.selected);
  if (stale.charts) for (const chart of charts) drawChart(chart, show.frame);
  if (stale.panel) showParticle($("particle"), state, show.selected);
  else if (show.selected >= 0 && $("now")) $("now").innerHTML = particleNow(state, show.selected);
  stale.view = stale.charts = stale.panel = false;
}

function setFrame(f) {
  show.frame = Math.min(Math.max(Math.round(f), 0), frameCount - 1);
  const frame = run.frames[show.frame];
  $("slider").value = show.frame;
  const stage = run.stages[frame.stage];
  $("slider").setAttribute("aria-valuetext", `frame ${show.frame + 1} of ${frameCount}, ${stage}, axial strain ${percent(frame.strain)}`);
  $("frame-number").textContent = `${show.frame + 1} / ${frameCount}`;
  $("clock").innerHTML = `<strong>${percent(frame.strain)}</strong> ${stage === "shear" ? "axial strain" : stage} &middot; ` +
    `${frame.particles} particles &middot; ${frame.breaks} breaks`;
  markPassed($("breaks"), show.frame);
  refresh("view", "charts");
}

// Playing: as many frames as time has passed for, however fast the screen is.
let lastTime = 0, due = 0;
function play(on) {
  if (on && show.frame === frameCount - 1) setFrame(0);
  show.playing = on;
  $("play").innerHTML = on ? "&#10074;&#10074;" : "&#9654;";
  $("play").setAttribute("aria-label", on ? "Pause" : "Play");
  lastTime = performance.now();
  due = 0;
  if (on) requestAnimationFrame(advance);
}
function advance(now) {
  if (!show.playing) return;
  due += Math.min(now - lastTime, 250) * show.speed / 1000;
  lastTime = now;
  const whole = Math.floor(due);
  due -= whole;
  if (whole > 0) setFrame(show.frame + whole);
  if (show.frame === frameCount - 1) play(false); else requestAnimationFrame(advance);
}

function setSpeed(value) {
  show.speed = value;
  $("speed").value = value;
}
const nextSpeed = (by) => setSpeed(speeds[Math.min(Math.max(speeds.indexOf(show.speed) + by, 0), speeds.length - 1)]);

function setMode(n) {
  show.mode = (n + colourModes.length) % colourModes.length;
  $("colour").value = show.mode;
  showLegend();
  refresh("view");
}
function setChains(on) {
  show.chains = on;
  $("chains").checked = on;
  showLegend();
  refresh("view");
}
// The strong network alone; without force chains there is nothing to leave out, so they come on.
function setStrong(on) {
  show.strong = on;
  $("strong").checked = on;
  setChains(on || show.chains);
}
function showLegend() {
  const mode = colourModes[show.mode];
  const ring = arrays.motion.some((m) => m > 0)
    ? `<div><i style="background:var(--ring)"></i> boundary</div>` : "";
  const chains = show.chains ? `<div><i class="stroke"></i> normal force: ${withUnit(unitForce, "N")} is this wide</div>` +
    (show.strong ? "<div>only forces above the mean</div>" : "") : "";
  $("legend").innerHTML = `<div class="name">${mode.title}</div>${mode.legend()}` +
    (ring || chains ? `<div class="extra">${ring}${chains}</div>` : "");
}
function setTheme(name) {
  document.documentElement.dataset.theme = name;
  showLegend();
  drawRibbon();
  refresh("view", "charts", "panel");
}

function showTab(name) {
  for (const tab of ["particle", "breaks"]) {
    $(tab).hidden = tab !== name;
    $(`tab-${tab}`).setAttribute("aria-selected", tab === name);
  }
  if (name === "particle") refresh("panel");
  else $("breaks").querySelectorAll("tbody tr")[breakRange(show.frame).first]?.scrollIntoView({ block: "center" });
}
function select(id) {
  show.selected = id;
  if (id >= 0) showTab("particle");
  refresh("view", "panel");
}
// A particle that is not there at this frame is shown when it is.
function selectAndFind(id) {
  if (!isPresent(id, show.frame) && arrays.first[id] >= 0) {
    play(false);
    setFrame(show.frame < arrays.first[id] ? arrays.first[id] : arrays.last[id]);
  }
  select(id);
  const state = frameState(show.frame), k = state.place(id);
  if (k >= 0) centre(state.x[k], state.y[k], id);
}
function centre(x, y, id) {
  view.camera.x = x;
  view.camera.y = y;
  view.camera.scale = Math.max(view.camera.scale, 0.09 * Math.min(view.width, view.height) / radius[id]);
  refresh("view");
}
// The last frame before a break: the particle is whole, and its line is drawn.
function goToBreak(number) {
  const b = run.breaks[number];
  if (!b) return;
  play(false);
  setFrame(b.frame);
  select(b.id);
  centre(b.pose[0], b.pose[1], b.id);
  show.currentBreak = number;
  for (const row of $("breaks").querySelectorAll('[aria-current="true"]')) row.removeAttribute("aria-current");
  const row = $("breaks").querySelector(`tr[data-break="${number}"]`);
  row?.setAttribute("aria-current", "true");
  row?.scrollIntoView({ block: "nearest" });
}
function nextBreak(by) {
  const { first, last } = breakRange(show.frame);
  const current = show.currentBreak;
  // Go on from the break that is shown, unless the frame has moved away from it.
  const here = current >= first && current < last;
  goToBreak(Math.min(Math.max(here ? current + by : by > 0 ? first : first - 1, 0), run.breaks.length - 1));
}

const keysOf = {
  " ": () => play(!show.playing),
  ArrowRight: (e) => { play(false); setFrame(show.frame + (e.shiftKey ? 10 : 1)); },
  ArrowLeft: (e) => { play(false); setFrame(show.frame - (e.shiftKey ? 10 : 1)); },
  ArrowUp: () => nextSpeed(1),
  ArrowDown: () => nextSpeed(-1),
  Home: () => { play(false); setFrame(0); },
  End: () => { play(false); setFrame(frameCount - 1); },
  "+": () => { zoomAt(1.25, view.width / 2, view.height / 2); refresh("view"); },
  "=": () => keysOf["+"](),
  "-": () => { zoomAt(0.8, view.width / 2, view.height / 2); refresh("view"); },
  f: () => { fitView(frameState(show.frame)); refresh("view"); },
  c: () => setMode(show.mode + 1),
  C: () => setMode(show.mode - 1),
  g: () => setChains(!show.chains),
  s: () => setStrong(!show.strong),
  n: () => nextBreak(1),
  p: () => nextBreak(-1),
  t: () => setTheme(isDark() ? "light" : "dark"),
  Escape: () => select(-1),
  "?": () => $("help").showModal(),
};
document.addEventListener("keydown", (event) => {
  const action = Object.hasOwn(keysOf, event.key) && keysOf[event.key];
  if (!action || $("help").open || event.ctrlKey || event.metaKey || event.altKey) return;
  // What scrolls, and lists and buttons, keep their own keys; the slider has the page's.
  const isOwn = (of, keys) => event.target.closest(of) && keys.includes(event.key);
  if (event.target.closest("select") || isOwn("button, input[type=checkbox]", [" "]) ||
      isOwn("[role=tabpanel]", [" ", "ArrowUp", "ArrowDown", "Home", "End"])) return;
  event.preventDefault();
  action(event);
});

// Pointers on the sample: one drags, two zoom, a click without a drag selects.
const pointers = new Map();
let dragged = 0;
function movePointer(event) {
  const before = pointers.get(event.pointerId);
  if (!before) return;
  const box = view.canvas.getBoundingClientRect();
  const now = { x: event.clientX - box.left, y: event.clientY - box.top };
  const others = [...pointers.entries()].filter(([id]) => id !== event.pointerId).map(([, p]) => p);
  if (others.length === 0) {
    view.camera.x -= (now.x - before.x) / view.camera.scale;
    view.camera.y += (now.y - before.y) / view.camera.scale;
  } else {
    const [fixed] = others;
    const was = Math.hypot(before.x - fixed.x, before.y - fixed.y);
    if (was > 0) zoomAt(Math.hypot(now.x - fixed.x, now.y - fixed.y) / was, fixed.x, fixed.y);
  }
  dragged += Math.hypot(now.x - before.x, now.y - before.y);
  pointers.set(event.pointerId, now);
  if (dragged > 4) view.canvas.classList.add("dragged");
  refresh("view");
}
function watchPointers() {
  view.canvas.addEventListener("pointerdown", (event) => {
    const box = view.canvas.getBoundingClientRect();
    if (pointers.size === 0) dragged = 0;
    pointers.set(event.pointerId, { x: event.clientX - box.left, y: event.clientY - box.top });
    view.canvas.setPointerCapture(event.pointerId);
  });
  view.canvas.addEventListener("pointermove", movePointer);
  view.canvas.addEventListener("pointerup", (event) => {
    const at = pointers.get(event.pointerId);
    if (at && pointers.size === 1 && dragged <= 4) select(particleAt(frameState(show.frame), at.x, at.y));
  });
  for (const end of ["pointerup", "pointercancel"])
    view.canvas.addEventListener(end, (event) => {
      pointers.delete(event.pointerId);
      view.canvas.classList.remove("dragged");
    });
  view.canvas.addEventListener("wheel", (event) => {
    event.preventDefault();
    const box = view.canvas.getBoundingClientRect();
    const lines = event.deltaMode === 1 ? 20 : 1;
    zoomAt(Math.exp(-event.deltaY * lines * 0.0015), event.clientX - box.left, event.clientY - box.top);
    refresh("view");
  }, { passive: false });
}
function watchCharts() {
  for (const chart of charts) {
    const go = (event) => {
      if (event.buttons === 0) return;
      play(false);
      setFrame(frameAtChart(chart, event.clientX - chart.canvas.getBoundingClientRect().left));
    };
    chart.canvas.addEventListener("pointerdown", (event) => {
      chart.canvas.setPointerCapture(event.pointerId);
      go(event);
    });
    chart.canvas.addEventListener("pointermove", go);
  }
}
function setAxis(all) {
  allStages = all;
  $("axis-all").setAttribute("aria-pressed", all);
  $("axis-shear").setAttribute("aria-pressed", !all);
  refresh("charts");
}

function watchControls() {
  $("play").onclick = () => play(!show.playing);
  $("slider").oninput = () => { play(false); setFrame(Number($("slider").value)); };
  $("speed").onchange = () => setSpeed(Number($("speed").value));
  $("colour").onchange = () => setMode(Number($("colour").value));
  $("chains").onchange = () => setChains($("chains").checked);
  $("strong").onchange = () => setStrong($("strong").checked);
  $("fit").onclick = () => keysOf.f();
  $("theme").onclick = () => keysOf.t();
  $("help-button").onclick = () => keysOf["?"]();
  $("axis-shear").onclick = () => setAxis(false);
  $("axis-all").onclick = () => setAxis(true);
  $("axis-shear").disabled = firstOfShear < 0;
  $("tab-particle").onclick = () => showTab("particle");
  $("tab-breaks").onclick = () => showTab("breaks");
  document.querySelector("aside").addEventListener("click", (event) => {
    const target = event.target.closest("[data-break], [data-particle]");
    if (target?.dataset.particle) selectAndFind(Number(target.dataset.particle));
    else if (target) goToBreak(Number(target.dataset.break));
  });
  $("particle").addEventListener("change", (event) => {
    const card = event.target.closest(".card"), parent = arrays.parent[show.selected];
    drawBreak(card, breakOf.get(card.id === "broken" ? show.selected : parent));
  });
  new ResizeObserver(() => { drawRibbon(); refresh("view", "charts"); }).observe(document.body);
  new ResizeObserver(() => refresh("view")).observe(view.canvas);
}

function begin() {
  $("title").textContent = run.title;
  const last = run.frames[frameCount - 1];
  $("facts").textContent = `${run.frames[0].particles} particles, ${withUnit(run.pressure, "Pa")} confining pressure, ` +
    `${percent(last.strain, 1)} axial strain, ${run.breaks.length} breaks · riprap ${run.riprap}`;
  $("slider").max = frameCount - 1;
  $("colour").innerHTML = colourModes.map((m, n) => `<option value="${n}">${m.name}</option>`).join("");
  $("speed").innerHTML = speeds.map((s) => `<option value="${s}">${s} / s</option>`).join("");
  document.documentElement.dataset.theme = matchMedia("(prefers-color-scheme: dark)").matches ? "dark" : "light";
  setSpeed(show.speed);
  setAxis(allStages);
  listBreaks($("breaks"));
  watchPointers();
  watchCharts();
  watchControls();
  // The address may say what to show first: #frame=120&colour=parent&chains=1&strong=1&particle=7&theme=dark
  const wanted = new URLSearchParams(location.hash.slice(1));
  setFrame(Number(wanted.get("frame") ?? Math.max(firstOfShear, 0)));
  setMode(Math.max(0, colourModes.findIndex((m) => m.key === wanted.get("colour"))));
  setChains(wanted.get("chains") === "1");
  if (wanted.get("strong") === "1") setStrong(true);
  if (wanted.has("theme")) setTheme(wanted.get("theme"));
  const box = sizeCanvas(view.canvas);
  [view.width, view.height] = [box?.width ?? 600, box?.height ?? 600];
  fitView(frameState(show.frame));
  if (wanted.has("particle")) select(Number(wanted.get("particle")));
  if (wanted.has("break")) goToBreak(Number(wanted.get("break")));
  drawRibbon();
  refresh("view", "charts", "panel");
}
begin();
