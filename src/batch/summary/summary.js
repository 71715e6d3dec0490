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
        link.textContent = "report";
        cell.append(link);
      } else cell.textContent = cell.title = shown(key, r[key]);
      if (numbers.has(key)) cell.className = "number";
      if (["outcome", "verdict", "by_code", "by_analysis"].includes(key)) cell.className = r[key] ?? "";
    }
  }
  table.replaceChildren(head, body);
  const cut = chosen.length > 2000 ? ", the first 2000 shown" : "";
  document.getElementById("shown").textContent = `${chosen.length} of ${rows.length} rows${cut}`;
}

function chart() {
  const points = rows.filter(r => typeof r.mass_kg === "number"
    && [r.lambda_low, r.lambda_up, r.component_factor].some(x => typeof x === "number"));
  const place = document.getElementById("chart");
  if (!points.length) {
    place.textContent = "No case has a mass and a load factor.";
    return;
  }
  const ns = "http://www.w3.org/2000/svg";
  const make = (name, attributes, text) => {
    const e = document.createElementNS(ns, name);
    for (const [k, v] of Object.entries(attributes)) e.setAttribute(k, v);
    if (text !== undefined) e.textContent = text;
    return e;
  };
  const [w, h, left, bottom] = [760, 380, 60, 45];
  const factors = points.flatMap(r => [r.lambda_low, r.lambda_up, r.component_factor]).filter(x => typeof x === "number");
  const most = factors.reduce((a, f) => Math.max(a, Math.min(f, 1e6)), 1.2);
  const masses = points.map(r => r.mass_kg);
  const m0 = 0.95 * masses.reduce((a, b) => Math.min(a, b));
  const m1 = 1.05 * masses.reduce((a, b) => Math.max(a, b));
  const x = m => left + (w - left - 15) * (m - m0) / (m1 - m0 || 1);
  const y = f => h - bottom - (h - bottom - 15) * Math.min(f, most) / most;
  const svg = make("svg", { viewBox: `0 0 ${w} ${h}`, width: w, role: "img", "aria-label": "mass against load factor" });
  const colour = { ok: "#0b6b2e", not_ok: "#b3261e", undecided: "#b07400" };
  for (let i = 0; i <= 4; i++) {
    const [m, f] = [m0 + (m1 - m0) * i / 4, most * i / 4];
    svg.append(make("text", { x: x(m), y: h - bottom + 18, "font-size": 12, "text-anchor": "middle", fill: "currentColor" }, m.toFixed(1)));
    svg.append(make("text", { x: left - 8, y: y(f) + 4, "font-size": 12, "text-anchor": "end", fill: "currentColor" }, f.toFixed(2)));
    svg.append(make("line", { x1: left, x2: w - 15, y1: y(f), y2: y(f), stroke: "currentColor", "stroke-opacity": 0.12 }));
  }
  svg.append(make("text", { x: (w + left) / 2, y: h - 6, "font-size": 13, "text-anchor": "middle", fill: "currentColor" }, "mass of plates and bolts, kg"));
  svg.append(make("text", { x: 14, y: h / 2, "font-size": 13, "text-anchor": "middle", fill: "currentColor", transform: `rotate(-90 14 ${h / 2})` }, "load factor"));
  svg.append(make("line", { x1: left, x2: w - 15, y1: y(1), y2: y(1), stroke: "currentColor", "stroke-dasharray": "6 4" }));
  for (const r of points) {
    const group = make("g", { stroke: colour[r.outcome] ?? "#7a1fa2", fill: colour[r.outcome] ?? "#7a1fa2" });
    if (typeof r.lambda_low === "number") {
      const top = typeof r.lambda_up === "number" ? r.lambda_up : most;
      group.append(make("line", { x1: x(r.mass_kg), x2: x(r.mass_kg), y1: y(r.lambda_low), y2: y(top), "stroke-width": 3 }));
    }
    if (typeof r.component_factor === "number") {
      group.append(make("line", { x1: x(r.mass_kg) - 5, x2: x(r.mass_kg) + 5, y1: y(r.component_factor), y2: y(r.component_factor), "stroke-width": 2, "stroke-opacity": 0.6 }));
    }
    group.append(make("title", {}, `${r.case}: ${r.outcome}`));
    svg.append(group);
  }
  place.append(svg);
}

document.getElementById("filter").addEventListener("input", draw);
draw();
chart();
