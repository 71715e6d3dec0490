// Unpacks the scene of a page; derives surfaces, edges and sections from its meshes.

const bytesOf = (text) => {
  const raw = atob(text);
  const bytes = new Uint8Array(raw.length);
  for (let i = 0; i < raw.length; i++) bytes[i] = raw.charCodeAt(i);
  return bytes.buffer;
};

const unpack = (packed) => {
  const steps = new Uint16Array(bytesOf(packed.steps));
  const step = (packed.high - packed.low) / 65535;
  return Float32Array.from(steps, (s) => packed.low + step * s);
};

const indicesOf = (text, wide) =>
  wide ? new Uint32Array(bytesOf(text)) : new Uint16Array(bytesOf(text));

// Faces of a tetrahedron, corners in outward order, and its edges.
const FACES = [[1, 2, 3], [0, 3, 2], [0, 1, 3], [0, 2, 1]];
// Edges of a shape are drawn where its faces meet at more than 25°.
const CREASE = Math.cos((25 * Math.PI) / 180);
// Numbers of a vertex: place, motion, value, part.
const STRIDE = 8;

// A mesh with the surface of each of its parts.
class Shape {
  constructor(packed, mirror) {
    this.points = unpack(packed.points);
    this.tets = indicesOf(packed.tets, packed.wide);
    this.count = packed.nodes;
    this.mirror = mirror;
    this.tetPart = new Uint16Array(this.tets.length / 4);
    this.nodePart = new Uint16Array(this.count);
    this.low = [Infinity, Infinity, Infinity];
    this.high = [-Infinity, -Infinity, -Infinity];
    for (let i = 0; i < this.points.length; i++) {
      this.low[i % 3] = Math.min(this.low[i % 3], this.points[i]);
      this.high[i % 3] = Math.max(this.high[i % 3], this.points[i]);
    }
    this.size = Math.hypot(...[0, 1, 2].map((k) => this.high[k] - this.low[k]));
    // one triangle: tetrahedron and local face
    this.triangles = [];
    this.edges = [];
    this.centres = new Map();
    let start = 0;
    for (const [part, count] of packed.parts) {
      this.tetPart.fill(part, start, start + count);
      this.addPart(part, start, start + count);
      start += count;
    }
  }

  onPlane(node) {
    const reach = 1e-4 * this.size;
    return this.mirror.filter((k) => Math.abs(this.points[3 * node + k]) < reach);
  }

  addPart(part, start, end) {
    const open = new Map();
    const n = this.count;
    for (let e = start; e < end; e++) {
      for (let f = 0; f < 4; f++) {
        const [a, b, c] = FACES[f].map((i) => this.tets[4 * e + i]).sort((x, y) => x - y);
        const key = (a * n + b) * n + c;
        if (!open.delete(key)) open.set(key, 4 * e + f);
      }
    }
    const edges = new Map();
    const low = [Infinity, Infinity, Infinity];
    const high = [-Infinity, -Infinity, -Infinity];
    for (const place of open.values()) {
      const nodes = this.faceNodes(place);
      // a face on a plane of symmetry is inside the whole
      const planes = nodes.map((node) => this.onPlane(node));
      if (planes[0].some((k) => planes[1].includes(k) && planes[2].includes(k))) continue;
      this.triangles.push(place);
      const normal = this.normal(nodes);
      for (let i = 0; i < 3; i++) {
        const [a, b] = [nodes[i], nodes[(i + 1) % 3]];
        const key = Math.min(a, b) * n + Math.max(a, b);
        const other = edges.get(key);
        edges.set(key, other === undefined ? normal : dot(other, normal) < CREASE ? true : false);
      }
      for (const node of nodes) {
        this.nodePart[node] = part;
        for (let k = 0; k < 3; k++) {
          low[k] = Math.min(low[k], this.points[3 * node + k]);
          high[k] = Math.max(high[k], this.points[3 * node + k]);
        }
      }
    }
    for (const [key, kind] of edges) {
      const [a, b] = [Math.floor(key / n), key % n];
      let sharp = kind === true;
      if (Array.isArray(kind)) {
        // the border of the meshed part: sharp unless it goes on behind the plane of symmetry
        const plane = this.onPlane(a).find((k) => this.onPlane(b).includes(k));
        sharp = plane === undefined || 1 - 2 * kind[plane] ** 2 < CREASE;
      }
      if (sharp) this.edges.push(a, b, part);
    }
    // a part on a plane of symmetry stays there when the joint is pulled apart
    const reach = 1e-4 * this.size;
    this.centres.set(part, low.map((l, k) =>
      this.mirror.includes(k) && l < reach && high[k] > -reach ? 0 : 0.5 * (l + high[k])));
  }

  faceNodes(place) {
    const tet = place >> 2;
    return FACES[place & 3].map((i) => this.tets[4 * tet + i]);
  }

  point(node) {
    return [this.points[3 * node], this.points[3 * node + 1], this.points[3 * node + 2]];
  }

  normal(nodes) {
    const [a, b, c] = nodes.map((node) => this.point(node));
    return unit(cross(sub(b, a), sub(c, a)));
  }
}

const sub = (a, b) => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const cross = (a, b) =>
  [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
const unit = (a) => {
  const length = Math.hypot(...a) || 1;
  return a.map((x) => x / length);
};

// A field on a shape.
class View {
  constructor(packed, shape) {
    Object.assign(this, { case: packed.case, title: packed.title, unit: packed.unit });
    this.on = packed.on;
    this.colours = packed.colours;
    this.shape = shape;
    this.motion = packed.motion ? unpack(packed.motion) : null;
    this.values = packed.values ? unpack(packed.values) : null;
    this.faces = packed.faces ? indicesOf(packed.faces, packed.wide) : null;
    this.shown = packed.shown;
    this.reach = 0;
    if (this.motion) {
      const lengths = new Float32Array(shape.count);
      for (let i = 0; i < shape.count; i++) {
        lengths[i] = Math.hypot(...this.motion.subarray(3 * i, 3 * i + 3));
        this.reach = Math.max(this.reach, lengths[i]);
      }
      if (this.on === "motion") {
        this.values = lengths;
        this.shown = [0, this.reach || 1];
      }
    }
  }

  // The value of corner `i` of a tetrahedron.
  at(tet, i) {
    if (!this.values || this.on === "faces") return NaN;
    return this.on === "corners"
      ? this.values[4 * tet + i]
      : this.values[this.shape.tets[4 * tet + i]];
  }
}

// The same view over the yield strength of each part; null where no part has one.
const utilisation = (view, parts) => {
  const fy = (tet) => parts[view.shape.tetPart[tet]].fy;
  if (!parts.some((p) => p.fy)) return null;
  const out = Object.assign(Object.create(View.prototype), view);
  out.values = view.values.map((v, i) => v / (fy(i >> 2) || Infinity));
  return Object.assign(out, { title: "⟦von Mises stress / yield strength⟧", unit: "", shown: [0, 1] });
};

const vertex = (out, at, shape, view, node, value, part) => {
  for (let k = 0; k < 3; k++) {
    out[at + k] = shape.points[3 * node + k];
    out[at + 3 + k] = view && view.motion ? view.motion[3 * node + k] : 0;
  }
  out[at + 6] = value;
  out[at + 7] = part;
};

// Vertices of the surface triangles.
const surfaceOf = (shape, view) => {
  const out = new Float32Array(shape.triangles.length * 3 * STRIDE);
  let at = 0;
  for (const place of shape.triangles) {
    const tet = place >> 2;
    for (const i of FACES[place & 3]) {
      const value = view ? view.at(tet, i) : NaN;
      vertex(out, at, shape, view, shape.tets[4 * tet + i], value, shape.tetPart[tet]);
      at += STRIDE;
    }
  }
  return out;
};

// Vertices of the faces that a field lives on.
const facesOf = (shape, view) => {
  const out = new Float32Array(view.faces.length * STRIDE);
  view.faces.forEach((node, i) =>
    vertex(out, i * STRIDE, shape, view, node, view.values[i], shape.nodePart[node]));
  return out;
};

// Vertices of the edges of the shape.
const edgesOf = (shape, view) => {
  const out = new Float32Array((shape.edges.length / 3) * 2 * STRIDE);
  for (let e = 0; e < shape.edges.length; e += 3) {
    for (let i = 0; i < 2; i++) {
      const at = (2 * (e / 3) + i) * STRIDE;
      vertex(out, at, shape, view, shape.edges[e + i], NaN, shape.edges[e + 2]);
    }
  }
  return out;
};

// Vertices of the section by the plane x[axis] = place.
const sectionOf = (shape, view, axis, place) => {
  const out = [];
  const corner = (tet, i) => {
    const node = shape.tets[4 * tet + i];
    const motion = view && view.motion ? view.motion.subarray(3 * node, 3 * node + 3) : [0, 0, 0];
    return [...shape.point(node), ...motion, view ? view.at(tet, i) : NaN];
  };
  for (let tet = 0; tet < shape.tets.length / 4; tet++) {
    const side = [0, 1, 2, 3].map((i) => shape.points[3 * shape.tets[4 * tet + i] + axis] - place);
    const below = [0, 1, 2, 3].filter((i) => side[i] < 0);
    if (below.length === 0 || below.length === 4) continue;
    const above = [0, 1, 2, 3].filter((i) => side[i] >= 0);
    const corners = [0, 1, 2, 3].map((i) => corner(tet, i));
    const cut = (i, j) => {
      const t = side[i] / (side[i] - side[j]);
      const mixed = corners[i].map((x, k) => x + t * (corners[j][k] - x));
      return [...mixed, shape.tetPart[tet]];
    };
    // three points, or four in the order round the section
    const points = below.length === 2
      ? [cut(below[0], above[0]), cut(below[0], above[1]), cut(below[1], above[1]), cut(below[1], above[0])]
      : below.length === 1
        ? above.map((j) => cut(below[0], j))
        : below.map((i) => cut(i, above[0]));
    for (let i = 2; i < points.length; i++) out.push(points[0], points[i - 1], points[i]);
  }
  return new Float32Array(out.flat());
};
