// The controls of the 3-D view and what a click shows.

const start = () => {
  const text = document.getElementById("scene");
  const root = document.getElementById("view");
  if (!text || !root) return;
  const began = performance.now();
  const find = (name) => root.querySelector(`[data-is="${name}"]`);
  const canvas = find("canvas");
  const scene = JSON.parse(text.textContent);
  let drawing;
  try {
    drawing = new Drawing(canvas, scene);
  } catch (fault) {
    find("fault").hidden = false;
    return;
  }
  find("all").hidden = false;
  const shapes = scene.shapes.map((s) => new Shape(s, scene.mirror));
  const views = scene.views.flatMap((packed) => {
    const view = new View(packed, shapes[packed.shape]);
    const share = packed.on === "corners" ? utilisation(view, scene.parts) : null;
    return share ? [share, view] : [view];
  });
  const whole = [0, 1].map((end) => [0, 1, 2].map((k) => {
    const ends = shapes.map((s) => (end ? s.high[k] : s.low[k]));
    const value = end ? Math.max(...ends) : Math.min(...ends);
    if (!scene.mirror.includes(k)) return value;
    const far = Math.max(...shapes.flatMap((s) => [Math.abs(s.low[k]), Math.abs(s.high[k])]));
    return end ? far : -far;
  }));
  const camera = new Camera(...whole);
  const looks = scene.parts.map((p) => [...p.colour.map((c) => c / 255), 1]);
  const state = {
    camera, view: null, shape: shapes[0], scale: 0, explode: 0, lines: true, sheer: false,
    cut: { axis: -1, at: 0, side: 1 }, ink: [0.15, 0.17, 0.19], ground: [1, 1, 1],
  };

  const dark = window.matchMedia("(prefers-color-scheme: dark)");
  const recolour = () => {
    state.ground = dark.matches ? [0.1, 0.11, 0.13] : [1, 1, 1];
    state.ink = dark.matches ? [0.02, 0.02, 0.02] : [0.15, 0.17, 0.19];
    redraw();
  };
  let asked = false;
  const redraw = () => {
    if (asked) return;
    asked = true;
    requestAnimationFrame(() => {
      asked = false;
      drawing.draw(state);
      if (!canvas.dataset.drawn) canvas.dataset.drawn = Math.round(performance.now() - began);
    });
  };

  // --- shape, field and section ---

  const loadSection = () => {
    const { cut, shape, view } = state;
    if (cut.axis < 0) return;
    const field = view && view.on !== "faces" ? view : null;
    drawing.load("section+", sectionOf(shape, field, cut.axis, cut.at));
    drawing.load("section-", scene.mirror.includes(cut.axis)
      ? sectionOf(shape, field, cut.axis, -cut.at) : new Float32Array());
  };
  const loadShape = () => {
    const { shape, view } = state;
    state.surface = surfaceOf(shape, view && view.on !== "faces" ? view : null);
    drawing.load("surface", state.surface);
    drawing.load("edges", edgesOf(shape, view));
    drawing.load("faces", view && view.faces ? facesOf(shape, view) : new Float32Array());
    const offsets = scene.parts.map((_, part) => {
      const centre = shape.centres.get(part);
      return centre ? sub(centre, camera.home.map((x, k) => (scene.mirror.includes(k) ? 0 : x))) : [0, 0, 0];
    });
    drawing.loadParts(looks, offsets);
    state.offsets = offsets;
    loadSection();
    redraw();
  };
  const loadParts = () => {
    drawing.loadParts(looks, state.offsets);
    redraw();
  };

  // The factor that moves the farthest point by 8 % of the size, at the middle of the slider.
  const largest = () => {
    const { view, shape } = state;
    return view && view.reach > 0 ? (0.08 * shape.size) / view.reach : 0;
  };
  const scaleNow = () => {
    const factor = Number(find("scale").value) * largest();
    const real = state.view && state.view.on === "motion";
    find("scale-value").textContent = real ? `× ${factor.toPrecision(2)}` : "";
    return factor;
  };

  const digits = (x) => (x === 0 ? "0" : Math.abs(x) >= 1000 || Math.abs(x) < 1e-3 ? x.toExponential(2) : x.toPrecision(3));
  const legend = () => {
    const { view } = state;
    const box = find("legend");
    box.hidden = !view;
    if (!view) return;
    const { stops } = scene.scales.find((s) => s.name === view.colours);
    const colour = (band) => {
      const t = (band / (BANDS - 1)) * 6;
      const low = Math.min(Math.floor(t), 5);
      return `rgb(${stops[low].map((c, k) => Math.round(c + (t - low) * (stops[low + 1][k] - c)))})`;
    };
    const bands = Array.from({ length: BANDS }, (_, i) =>
      `${colour(i)} ${(100 * i) / BANDS}% ${(100 * (i + 1)) / BANDS}%`);
    find("bar").style.background = `linear-gradient(to right, ${bands.join(", ")})`;
    const [low, high] = view.shown;
    const above = view.values.some((v) => v > high * (1 + 1e-4));
    find("low").textContent = digits(low);
    find("middle").textContent = digits(0.5 * (low + high));
    find("high").textContent = (above ? "≥ " : "") + digits(high);
    find("unit").textContent = [view.title, view.unit && `[${view.unit}]`].filter(Boolean).join(" ");
  };

  const choose = (index) => {
    state.view = index < 0 ? null : views[index];
    state.shape = state.view ? state.view.shape : shapes[0];
    const moves = largest() > 0;
    for (const name of ["scale", "animate"]) find(name).disabled = !moves;
    if (!moves) play(false);
    state.scale = scaleNow();
    legend();
    loadShape();
  };

  const field = find("field");
  views.forEach((view, i) => field.add(new Option(`${view.case}: ${view.title}`, i)));
  field.addEventListener("change", () => choose(Number(field.value)));

  // --- motion ---

  let playing = 0;
  const play = (on) => {
    cancelAnimationFrame(playing);
    playing = 0;
    find("animate").setAttribute("aria-pressed", on);
    if (!on) return;
    const from = performance.now();
    const step = (now) => {
      state.scale = scaleNow() * 0.5 * (1 - Math.cos((now - from) / 600));
      drawing.draw(state);
      playing = requestAnimationFrame(step);
    };
    playing = requestAnimationFrame(step);
  };
  find("animate").addEventListener("click", () => {
    play(!playing);
    if (!playing) { state.scale = scaleNow(); redraw(); }
  });
  find("scale").addEventListener("input", () => { state.scale = scaleNow(); redraw(); });

  // --- section, explosion, lines ---

  const cutNow = () => {
    const axis = Number(find("axis").value);
    const along = Number(find("cut").value);
    find("cut").disabled = find("turn").disabled = axis < 0;
    state.cut.axis = axis;
    state.cut.side = find("turn").checked ? -1 : 1;
    if (axis >= 0) {
      // a little aside, because faces of the mesh may lie in the middle plane
      const [low, high] = [whole[0][axis], whole[1][axis]];
      state.cut.at = low + (high - low) * (along + 1e-4);
      find("cut-value").textContent = `${"xyz"[axis]} = ${state.cut.at.toFixed(0)} mm`;
    } else {
      find("cut-value").textContent = "";
    }
    loadSection();
    redraw();
  };
  for (const name of ["axis", "cut", "turn"]) find(name).addEventListener("input", cutNow);
  find("explode").addEventListener("input", () => {
    state.explode = Number(find("explode").value);
    redraw();
  });
  find("lines").addEventListener("change", () => { state.lines = find("lines").checked; redraw(); });
  find("sheer").addEventListener("change", () => {
    state.sheer = find("sheer").checked;
    looks.forEach((look, i) => { if (look[3] > 0) look[3] = visible(i); });
    loadParts();
  });

  // --- parts ---

  // bolts stay solid where the other parts are transparent
  const visible = (part) => (state.sheer && scene.parts[part].group !== "BOLT" ? 0.5 : 1);
  const list = find("parts");
  scene.parts.forEach((part, i) => {
    const row = document.createElement("li");
    const label = document.createElement("label");
    const box = Object.assign(document.createElement("input"), { type: "checkbox", checked: true });
    box.addEventListener("change", () => { looks[i][3] = box.checked ? visible(i) : 0; loadParts(); });
    const swatch = document.createElement("span");
    swatch.className = "swatch";
    swatch.style.background = `rgb(${part.colour.map(Math.round)})`;
    label.append(box, swatch, document.createTextNode(part.name));
    const about = Object.assign(document.createElement("button"), { type: "button", textContent: "?" });
    about.setAttribute("aria-label", part.name);
    about.addEventListener("click", () => tell(i, null));
    row.append(label, about);
    list.append(row);
  });
  for (const [name, on] of [["show-all", () => true], ["only-bolts", (p) => p.group === "BOLT"]]) {
    find(name).addEventListener("click", () => {
      list.querySelectorAll("input").forEach((box, i) => {
        box.checked = on(scene.parts[i]);
        looks[i][3] = box.checked ? visible(i) : 0;
      });
      loadParts();
    });
  }

  const tell = (part, value) => {
    const { name, fy, facts } = scene.parts[part];
    const box = find("about");
    const head = Object.assign(document.createElement("strong"), { textContent: name });
    box.replaceChildren(head);
    const rows = [];
    if (fy) rows.push(["", "⟦strength in the model⟧", `${digits(fy)} MPa`]);
    if (value !== null && state.view) {
      rows.push([state.view.case, state.view.title, `${digits(value)} ${state.view.unit}`]);
    }
    const table = document.createElement("table");
    for (const row of rows.concat(facts)) {
      const line = table.insertRow();
      row.forEach((cell) => { line.insertCell().textContent = cell; });
    }
    box.append(table);
  };

  // --- pointer and keys ---

  const pick = (x, y) => {
    const box = canvas.getBoundingClientRect();
    const matrix = camera.matrix(canvas.width / canvas.height);
    const at = [(2 * (x - box.left)) / box.width - 1, 1 - (2 * (y - box.top)) / box.height];
    const numbers = state.surface;
    let best = null;
    for (const copied of copies(scene.mirror)) {
      for (let t = 0; t < numbers.length; t += 3 * STRIDE) {
        const part = numbers[t + 7];
        if (looks[part][3] === 0) continue;
        const corners = [0, 1, 2].map((i) => {
          const from = t + i * STRIDE;
          const place = [0, 1, 2].map((k) => copied[k] * (numbers[from + k]
            + state.scale * numbers[from + 3 + k] + state.explode * state.offsets[part][k]));
          return [0, 1, 2].map((r) =>
            matrix[r] * place[0] + matrix[4 + r] * place[1] + matrix[8 + r] * place[2] + matrix[12 + r]);
        });
        const [a, b, c] = corners;
        const area = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
        if (area === 0) continue;
        const v = ((at[0] - a[0]) * (c[1] - a[1]) - (at[1] - a[1]) * (c[0] - a[0])) / area;
        const w = ((b[0] - a[0]) * (at[1] - a[1]) - (b[1] - a[1]) * (at[0] - a[0])) / area;
        if (v < 0 || w < 0 || v + w > 1) continue;
        const mix = (k) => [0, 1, 2].reduce((sum, i) =>
          sum + [1 - v - w, v, w][i] * numbers[t + i * STRIDE + k], 0);
        const { axis, side, at: place } = state.cut;
        if (axis >= 0 && (copied[axis] * mix(axis) - place) * side > 0) continue;
        const depth = a[2] + v * (b[2] - a[2]) + w * (c[2] - a[2]);
        if (!best || depth < best.depth) best = { depth, part, value: mix(6) };
      }
    }
    return best;
  };

  const pointers = new Map();
  let moved = 0;
  canvas.addEventListener("pointerdown", (event) => {
    canvas.setPointerCapture(event.pointerId);
    pointers.set(event.pointerId, [event.clientX, event.clientY]);
    moved = 0;
  });
  canvas.addEventListener("pointermove", (event) => {
    const before = pointers.get(event.pointerId);
    if (!before) return;
    const [dx, dy] = [event.clientX - before[0], event.clientY - before[1]];
    const height = canvas.clientHeight;
    moved += Math.abs(dx) + Math.abs(dy);
    const other = [...pointers].find(([id]) => id !== event.pointerId);
    if (other) {
      const gap = (p) => Math.hypot(p[0] - other[1][0], p[1] - other[1][1]);
      camera.zoom(gap(before) / Math.max(1, gap([event.clientX, event.clientY])));
      camera.pan(dx / height / 2, -dy / height / 2);
    } else if (event.shiftKey || event.buttons === 4 || event.buttons === 2) {
      camera.pan(dx / height, -dy / height);
    } else {
      camera.rotate(0.4 * dx, 0.4 * dy);
    }
    pointers.set(event.pointerId, [event.clientX, event.clientY]);
    redraw();
  });
  for (const kind of ["pointerup", "pointercancel"]) {
    canvas.addEventListener(kind, (event) => {
      pointers.delete(event.pointerId);
      if (kind === "pointercancel" || moved > 4) return;
      const found = pick(event.clientX, event.clientY);
      if (found) tell(found.part, Number.isNaN(found.value) ? null : found.value);
    });
  }
  canvas.addEventListener("contextmenu", (event) => event.preventDefault());
  canvas.addEventListener("wheel", (event) => {
    event.preventDefault();
    camera.zoom(Math.exp(0.0012 * event.deltaY));
    redraw();
  }, { passive: false });
  canvas.addEventListener("keydown", (event) => {
    const by = event.shiftKey ? 0.04 : 6;
    const go = event.shiftKey ? (x, y) => camera.pan(x * by, y * by) : (x, y) => camera.rotate(-x * by, y * by);
    const keys = {
      ArrowLeft: () => go(-1, 0), ArrowRight: () => go(1, 0),
      ArrowUp: () => go(0, 1), ArrowDown: () => go(0, -1),
      "+": () => camera.zoom(0.9), "-": () => camera.zoom(1 / 0.9),
    };
    if (!keys[event.key]) return;
    event.preventDefault();
    keys[event.key]();
    redraw();
  });
  for (const name of Object.keys(VIEWS)) {
    find(name).addEventListener("click", () => { camera.look(name); redraw(); });
  }

  new ResizeObserver(redraw).observe(canvas);
  dark.addEventListener("change", recolour);
  canvas.addEventListener("webglcontextlost", (event) => {
    event.preventDefault();
    find("fault").hidden = false;
  });
  choose(views.length ? 0 : -1);
  field.value = views.length ? 0 : -1;
  recolour();
};

// Paper shows all sections.
let closed = [];
window.addEventListener("beforeprint", () => {
  closed = [...document.querySelectorAll("details:not([open])")];
  closed.forEach((d) => { d.open = true; });
});
window.addEventListener("afterprint", () => closed.forEach((d) => { d.open = false; }));
start();
