// The eye: a parallel projection that turns round a point, z up.

const VIEWS = {
  front: [-90, 0],
  side: [0, 0],
  top: [-90, 89.9],
  isometric: [-55, 28],
};

class Camera {
  constructor(low, high) {
    this.home = [0, 1, 2].map((k) => 0.5 * (low[k] + high[k]));
    this.reach = [0, 1, 2].map((k) => 0.5 * (high[k] - low[k]));
    this.radius = 0.5 * Math.hypot(...[0, 1, 2].map((k) => high[k] - low[k])) || 1;
    this.look("isometric");
  }

  look(name) {
    [this.turn, this.tilt] = VIEWS[name];
    this.target = [...this.home];
    // the whole shape fits into a picture somewhat wider than high
    const { right, up } = this.axes();
    const along = (axis) => axis.reduce((sum, x, k) => sum + Math.abs(x) * this.reach[k], 0);
    this.half = 1.06 * Math.max(along(up), along(right) / 1.3) || 1;
  }

  // Directions to the right, up and to the eye.
  axes() {
    const [t, s] = [this.turn, this.tilt].map((a) => (a * Math.PI) / 180);
    const eye = [Math.cos(t) * Math.cos(s), Math.sin(t) * Math.cos(s), Math.sin(s)];
    const right = [-Math.sin(t), Math.cos(t), 0];
    return { right, up: cross(eye, right), eye };
  }

  rotate(dx, dy) {
    this.turn -= dx;
    this.tilt = Math.max(-89.9, Math.min(89.9, this.tilt + dy));
  }

  // Moves by parts of the height of the picture.
  pan(dx, dy) {
    const { right, up } = this.axes();
    const step = 2 * this.half;
    this.target = this.target.map((x, k) => x - step * (dx * right[k] + dy * up[k]));
  }

  zoom(factor) {
    this.half = Math.max(0.01 * this.radius, Math.min(8 * this.radius, this.half * factor));
  }

  // The matrix from places to the picture, column by column.
  matrix(aspect) {
    const { right, up, eye } = this.axes();
    const rows = [
      [right, 1 / (this.half * Math.max(aspect, 1))],
      [up, Math.min(aspect, 1) / this.half],
      [eye, -1 / (20 * this.radius)],
    ].map(([axis, scale]) => [...axis.map((x) => x * scale), -scale * dot(axis, this.target)]);
    rows.push([0, 0, 0, 1]);
    return new Float32Array([0, 1, 2, 3].flatMap((c) => rows.map((row) => row[c])));
  }
}
