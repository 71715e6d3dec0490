"use strict";
const rows = JSON.parse(document.getElementById("data").textContent);
const table = document.getElementById("cases");
// columns that are empty everywhere are left out
const keys = rows.length ? Object.keys(rows[0]).filter(k => rows.some(r => r[k] !== null && r[k] !== "")) : [];
const numeric = k => rows.every(r => r[k] === null || typeof r[k] === "number" || r[k] === "" || isFinite(r[k]));
const numbers = new Set(keys.filter(numeric));
// failed and undecided first
const rank = { failed: 0, bad_input: 1, timed_out: 2, open: 3, undecided: 4, not_ok: 5, ok: 6 };
let sorted = { key: "outcome", up: true };

function shown(key, value) {
  if (value === null) return "";
  if (typeof value === "number" && !Number.isInteger(value)) {
    // bounds are rounded outwards
    const ends = { lambda_low: Math.floor, utilisation_low: Math.floor, lambda_up: Math.ceil, utilisation_up: Math.ceil };
    const unit = 10 ** (Math.floor(Math.log10(Math.abs(value))) - 3);
    return String(Number(((ends[key] ?? Math.round)(value / unit) * unit).toPrecision(12)));
  }
  return String(value).replaceAll("_", key === "case" || key === "result" ? "_" : " ");
}

function compare(a, b) {
  const key = sorted.key;
  let [x, y] = [a[key], b[key]];
  // within an outcome the most used first
  const used = r => Math.max(Number(r.governing_utilisation ?? -Infinity), Number(r.utilisation_up ?? -Infinity));
  if (key === "outcome" && x === y) return used(b) - used(a) || 0;
  if (key === "outcome") [x, y] = [rank[x], rank[y]];
  else if (numbers.has(key)) [x, y] = [x === null ? -Infinity : Number(x), y === null ? -Infinity : Number(y)];
  else return String(x ?? "").localeCompare(String(y ?? ""), "en", { numeric: true }) * (sorted.up ? 1 : -1);
  return (x - y) * (sorted.up ? 1 : -1);
}

function draw() {
  const words = document.getElementById("filter").value.toLowerCase().split(/\s+/).filter(w => w);
  const text = r => keys.map(k => shown(k, r[k])).join(" ").toLowerCase();
  const chosen = rows.filter(r => words.every(w => text(r).includes(w))).sort(compare);
  const head = document.createElement("thead");
  const line = head.insertRow();
  for (const key of keys) {
    const cell = document.createElement("th");
    cell.textContent = key.replaceAll("_", " ");
    cell.tabIndex = 0;
    if (key === sorted.key) cell.setAttribute("aria-sort", sorted.up ? "ascending" : "descending");
    const sort = () => {
      sorted = { key, up: key === sorted.key ? !sorted.up : true };
      draw();
    };
    cell.addEventListener("click", sort);
    cell.addEventListener("keydown", e => e.key === "Enter" && sort());
    line.append(cell);
  }
  const body = document.createElement("tbody");
  for (const r of chosen.slice(0, 2000)) {
    const line = body.insertRow();
    for (const key of keys) {
      const cell = line.insertCell();
      if (key === "result" && r[key]) {
        const link = document.createElement("a");
        link.href = r[key] + "/report.html";
        link.textContent = "⟦report⟧";
        cell.append(link);
      } else cell.textContent = cell.title = shown(key, r[key]);
      if (numbers.has(key)) cell.className = "number";
      if (["outcome", "verdict", "by_code", "by_analysis"].includes(key)) cell.className = r[key] ?? "";
    }
  }
  table.replaceChildren(head, body);
  const cut = chosen.length > 2000 ? ", ⟦the first 2000 shown⟧" : "";
  document.getElementById("shown").textContent = `${chosen.length} ⟦of⟧ ${rows.length} ⟦rows⟧${cut}`;
}

const colour = { ok: "#0b6b2e", not_ok: "#b3261e", undecided: "#b07400" };

function make(name, attributes, text) {
  const e = document.createElementNS("http://www.w3.org/2000/svg", name);
  for (const [k, v] of Object.entries(attributes)) e.setAttribute(k, v);
  if (text !== undefined) e.textContent = text;
  return e;
}

// an empty chart with its axes: x and y are {label, from, to, digits}; returns the drawing and both scales
function axes(label, x, y) {
  const [w, h, left, bottom] = [760, 380, 60, 45];
  const scale = (from, to, a, b) => v => a + (b - a) * (v - from) / (to - from || 1);
  const [sx, sy] = [scale(x.from, x.to, left, w - 15), scale(y.from, y.to, h - bottom, 15)];
  const svg = make("svg", { viewBox: `0 0 ${w} ${h}`, width: w, role: "img", "aria-label": label });
  const text = { "font-size": 12, fill: "currentColor" };
  for (let i = 0; i <= 4; i++) {
    const [vx, vy] = [x, y].map(a => a.from + (a.to - a.from) * i / 4);
    svg.append(make("text", { ...text, x: sx(vx), y: h - bottom + 18, "text-anchor": "middle" }, vx.toFixed(x.digits)));
    svg.append(make("text", { ...text, x: left - 8, y: sy(vy) + 4, "text-anchor": "end" }, vy.toFixed(y.digits)));
    svg.append(make("line", { x1: left, x2: w - 15, y1: sy(vy), y2: sy(vy), stroke: "currentColor", "stroke-opacity": 0.12 }));
  }
  svg.append(make("text", { ...text, x: (w + left) / 2, y: h - 6, "text-anchor": "middle" }, x.label));
  svg.append(make("text", { ...text, x: 14, y: h / 2, "text-anchor": "middle", transform: `rotate(-90 14 ${h / 2})` }, y.label));
  return [svg, sx, sy];
}

const greatest = (values, least) => values.reduce((a, v) => Math.max(a, v), least);

function chart() {
  const points = rows.filter(r => typeof r.mass_kg === "number"
    && [r.lambda_low, r.lambda_up, r.component_factor].some(x => typeof x === "number"));
  const place = document.getElementById("chart");
  if (!points.length) {
    place.textContent = "⟦No case has a mass and a load factor⟧.";
    return;
  }
  const factors = points.flatMap(r => [r.lambda_low, r.lambda_up, r.component_factor]).filter(x => typeof x === "number");
  const most = greatest(factors.map(f => Math.min(f, 1e6)), 1.2);
  const masses = points.map(r => r.mass_kg);
  const [svg, x, y] = axes(
    "⟦Mass against load factor⟧",
    { label: "⟦mass of plates and bolts⟧, kg", from: 0.95 * masses.reduce((a, b) => Math.min(a, b)), to: 1.05 * greatest(masses, 0), digits: 1 },
    { label: "⟦load factor⟧", from: 0, to: most, digits: 2 },
  );
  const bar = { x1: 60, x2: 745, y1: y(1), y2: y(1), stroke: "currentColor", "stroke-dasharray": "6 4" };
  svg.append(make("line", bar));
  for (const r of points) {
    const group = make("g", { stroke: colour[r.outcome] ?? "#7a1fa2", fill: colour[r.outcome] ?? "#7a1fa2" });
    const at = x(r.mass_kg);
    if (typeof r.lambda_low === "number") {
      const top = typeof r.lambda_up === "number" ? Math.min(r.lambda_up, most) : most;
      group.append(make("line", { x1: at, x2: at, y1: y(r.lambda_low), y2: y(top), "stroke-width": 3 }));
    }
    if (typeof r.component_factor === "number") {
      const level = y(Math.min(r.component_factor, most));
      group.append(make("line", { x1: at - 5, x2: at + 5, y1: level, y2: level, "stroke-width": 2, "stroke-opacity": 0.6 }));
    }
    group.append(make("title", {}, `${r.case}: ${r.outcome}`));
    svg.append(group);
  }
  place.append(svg);
}

// speed against error: the gap of each bracket over the time of its case
function effort() {
  const place = document.getElementById("effort");
  const points = rows.filter(r => [r.seconds, r.lambda_low, r.lambda_up].every(x => typeof x === "number") && r.lambda_low > 0)
    .map(r => ({ ...r, gap: 100 * (r.lambda_up / r.lambda_low - 1) }));
  if (!points.length) {
    place.textContent = "⟦No case has a bracket⟧.";
    return;
  }
  const [svg, x, y] = axes(
    "⟦Gap against time⟧",
    { label: "⟦wall time of the case⟧, s", from: 0, to: 1.05 * greatest(points.map(p => p.seconds), 1), digits: 0 },
    { label: "⟦gap⟧, %", from: 0, to: 1.05 * greatest(points.map(p => p.gap), 1), digits: 1 },
  );
  for (const p of points) {
    const dot = make("circle", { cx: x(p.seconds), cy: y(p.gap), r: 4, fill: colour[p.outcome] ?? "#7a1fa2" });
    dot.append(make("title", {}, `${p.case}: ${p.gap.toFixed(1)} % in ${p.seconds.toFixed(0)} s`));
    svg.append(dot);
  }
  place.append(svg);
}

document.getElementById("filter").addEventListener("input", draw);
draw();
chart();
effort();
