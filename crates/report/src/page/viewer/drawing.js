// Draws shapes by WebGL2: parts or fields in bands of colour, edges, a section.

const VERTEX = `#version 300 es
layout(location = 0) in vec3 place;
layout(location = 1) in vec3 motion;
layout(location = 2) in vec2 data;
uniform mat4 camera;
uniform vec3 copied;
uniform float scale;
uniform float explode;
uniform float nearer;
uniform sampler2D parts;
out vec3 rest;
out vec3 world;
out float value;
flat out int part;
void main() {
  part = int(data.y + 0.5);
  value = data.x;
  vec3 apart = texelFetch(parts, ivec2(part, 1), 0).xyz;
  rest = place * copied;
  world = (place + scale * motion + explode * apart) * copied;
  gl_Position = camera * vec4(world, 1.0);
  gl_Position.z -= nearer;
  if (texelFetch(parts, ivec2(part, 0), 0).a == 0.0) gl_Position = vec4(2.0, 2.0, 2.0, 1.0);
}`;

const FRAGMENT = `#version 300 es
precision highp float;
in vec3 rest;
in vec3 world;
in float value;
flat in int part;
uniform sampler2D parts;
uniform vec3 eye;
uniform vec3 stops[7];
uniform vec2 shown;
uniform int mode;
uniform vec3 ink;
uniform int axis;
uniform float cut;
uniform float side;
uniform int sheer;
out vec4 colour;
const float BANDS = 12.0;
void main() {
  if (axis >= 0 && (rest[axis] - cut) * side > 0.0) discard;
  vec4 look = texelFetch(parts, ivec2(part, 0), 0);
  ivec2 at = ivec2(gl_FragCoord.xy);
  if ((sheer == 2 || (sheer == 1 && look.a < 1.0)) && (at.x + 2 * at.y) % 4 != 0) discard;
  if (mode == 2) { colour = vec4(ink, 1.0); return; }
  vec3 base = look.rgb;
  if (mode == 1) {
    float t = clamp((value - shown.x) / (shown.y - shown.x), 0.0, 1.0);
    float band = min(floor(t * BANDS), BANDS - 1.0) / (BANDS - 1.0) * 6.0;
    int low = min(int(band), 5);
    base = mix(stops[low], stops[low + 1], band - float(low));
  }
  vec3 normal = normalize(cross(dFdx(world), dFdy(world)));
  colour = vec4(base * (0.62 + 0.38 * abs(dot(normal, eye))), 1.0);
}`;

// Number of bands of colour; the shader has the same.
const BANDS = 12;

class Drawing {
  constructor(canvas, scene) {
    const gl = canvas.getContext("webgl2", { antialias: true, preserveDrawingBuffer: true });
    if (!gl) throw new Error("no WebGL2");
    this.gl = gl;
    this.canvas = canvas;
    this.scene = scene;
    const program = gl.createProgram();
    for (const [kind, text] of [[gl.VERTEX_SHADER, VERTEX], [gl.FRAGMENT_SHADER, FRAGMENT]]) {
      const shader = gl.createShader(kind);
      gl.shaderSource(shader, text);
      gl.compileShader(shader);
      gl.attachShader(program, shader);
    }
    gl.linkProgram(program);
    if (!gl.getProgramParameter(program, gl.LINK_STATUS)) {
      throw new Error(`shader: ${gl.getProgramInfoLog(program)}`);
    }
    gl.useProgram(program);
    this.program = program;
    this.places = new Map();
    this.texture = gl.createTexture();
    gl.bindTexture(gl.TEXTURE_2D, this.texture);
    for (const [name, value] of [["MIN_FILTER", "NEAREST"], ["MAG_FILTER", "NEAREST"]]) {
      gl.texParameteri(gl.TEXTURE_2D, gl[`TEXTURE_${name}`], gl[value]);
    }
    gl.enable(gl.DEPTH_TEST);
    this.buffers = {};
  }

  uniform(name) {
    if (!this.places.has(name)) this.places.set(name, this.gl.getUniformLocation(this.program, name));
    return this.places.get(name);
  }

  load(name, numbers) {
    const { gl } = this;
    const held = this.buffers[name] || { buffer: gl.createBuffer(), array: gl.createVertexArray() };
    this.buffers[name] = held;
    held.count = numbers.length / STRIDE;
    gl.bindVertexArray(held.array);
    gl.bindBuffer(gl.ARRAY_BUFFER, held.buffer);
    gl.bufferData(gl.ARRAY_BUFFER, numbers, gl.DYNAMIC_DRAW);
    [3, 3, 2].forEach((size, i) => {
      gl.enableVertexAttribArray(i);
      gl.vertexAttribPointer(i, size, gl.FLOAT, false, 4 * STRIDE, 12 * i);
    });
  }

  // Colour, visibility and offset of each part.
  loadParts(looks, offsets) {
    const { gl } = this;
    const numbers = new Float32Array([...looks.flat(), ...offsets.flatMap((o) => [...o, 0])]);
    gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA32F, looks.length, 2, 0, gl.RGBA, gl.FLOAT, numbers);
  }

  // `state`: camera, view, scale, explode, cut {axis, at, side}, lines, sheer, ink, ground.
  draw(state) {
    const { gl, canvas } = this;
    const ratio = window.devicePixelRatio || 1;
    const [width, height] = [canvas.clientWidth, canvas.clientHeight].map((x) => Math.max(1, Math.round(x * ratio)));
    if (canvas.width !== width || canvas.height !== height) Object.assign(canvas, { width, height });
    gl.viewport(0, 0, width, height);
    gl.clearColor(...state.ground, 1);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    gl.uniformMatrix4fv(this.uniform("camera"), false, state.camera.matrix(width / height));
    gl.uniform3fv(this.uniform("eye"), state.camera.axes().eye);
    gl.uniform1f(this.uniform("scale"), state.scale);
    gl.uniform1f(this.uniform("explode"), state.explode);
    gl.uniform3fv(this.uniform("ink"), state.ink);
    const { view, cut } = state;
    if (view) {
      const { stops } = this.scene.scales.find((s) => s.name === view.colours);
      gl.uniform3fv(this.uniform("stops[0]"), new Float32Array(stops.flat().map((c) => c / 255)));
      gl.uniform2fv(this.uniform("shown"), view.shown);
    }
    const ofFaces = view && view.on === "faces";
    const mode = view && !ofFaces ? 1 : 0;
    gl.uniform1f(this.uniform("cut"), cut.at);
    gl.uniform1f(this.uniform("side"), cut.side);
    for (const copied of copies(this.scene.mirror)) {
      gl.uniform3fv(this.uniform("copied"), copied);
      const pass = (name, kind, with_) => {
        const held = this.buffers[name];
        if (!held || !held.count) return;
        gl.uniform1i(this.uniform("mode"), with_.mode);
        gl.uniform1i(this.uniform("axis"), with_.whole ? -1 : cut.axis);
        gl.uniform1i(this.uniform("sheer"), with_.sheer || 0);
        gl.uniform1f(this.uniform("nearer"), with_.nearer || 0);
        gl.bindVertexArray(held.array);
        gl.drawArrays(kind, 0, held.count);
      };
      // faces between parts are seen through the parts
      const sheer = ofFaces ? 2 : state.sheer ? 1 : 0;
      pass("surface", gl.TRIANGLES, { mode, sheer });
      if (ofFaces) pass("faces", gl.TRIANGLES, { mode: 1, nearer: 2e-4 });
      if (cut.axis >= 0) {
        const name = copied[cut.axis] < 0 ? "section-" : "section+";
        pass(name, gl.TRIANGLES, { mode, whole: true, nearer: 1e-5, sheer });
      }
      if (state.lines) pass("edges", gl.LINES, { mode: 2, nearer: 3e-4 });
    }
  }
}

// Signs of the coordinates of the copies that complete a shape.
const copies = (mirror) =>
  mirror.reduce(
    (all, k) => all.concat(all.map((s) => s.map((x, i) => (i === k ? -x : x)))),
    [[1, 1, 1]],
  );
