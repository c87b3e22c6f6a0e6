// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_PAGE_PAGE_RENDERERS_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_PAGE_PAGE_RENDERERS_H

#include <string_view>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// JavaScript of the page, second part: what colors stand for, and what draws.
inline constexpr std::string_view page_renderers = R"js(
// --- colors ---

const rgb = hex => [1, 3, 5].map(i => parseInt(hex.slice(i, i + 2), 16));
const hexOf = color => '#' + color.map(c => Math.round(c).toString(16).padStart(2, '0')).join('');
const packed = ([r, g, b]) => (255 << 24 | Math.round(b) << 16 | Math.round(g) << 8 | Math.round(r)) >>> 0;
const paper = '#fbfcfd', ink = '#12263a', plainColor = '#e8f1f8', unmetColor = '#d6006c', quadtreeColor = '#9c3fb0';
// The colors of the pictures in SVG: of least angles in steps of five degrees, of largest ones from 120 downwards.
const angleColors = ['#67001f', '#b2182b', '#d6604d', '#f4a582', '#fdcc8a', '#fee8a0', '#d9ef8b', '#a6d96a',
  '#7fc97f', '#66c2a5', '#5aaec4', '#4393c3'];
const regionColors = ['#a6cee3', '#fdbf6f', '#b2df8a', '#fb9a99', '#cab2d6', '#ffff99', '#8dd3c7', '#f4cae4',
  '#d9d9d9', '#80b1d3', '#e6d8ad', '#ccebc5'];
const sizeColors = ['#2f5597', '#3f8fb5', '#6fc0b5', '#bfe0b0', '#f7f3c6'].map(rgb); // small to large
const colorOfAngle = angle => angleColors[Math.max(0, Math.min(11, Math.floor(angle / 5)))];
const colorOfRegion = r => r < 0 ? plainColor : regionColors[r % 12];

const sizeRange = [Infinity, -Infinity];
for (const size of sizes)
  if (isFinite(size)) sizeRange[0] = Math.min(sizeRange[0], size), sizeRange[1] = Math.max(sizeRange[1], size);
if (!(sizeRange[0] <= sizeRange[1])) sizeRange[0] = sizeRange[1] = 0;
function colorOfSize(size) {
  const share = (size - sizeRange[0]) / (sizeRange[1] - sizeRange[0] || 1);
  const place = Math.max(0, Math.min(1, share)) * (sizeColors.length - 1) || 0;
  const i = Math.min(sizeColors.length - 2, Math.floor(place)), u = place - i;
  return hexOf(sizeColors[i].map((c, k) => c + u * (sizeColors[i + 1][k] - c)));
}

// What colors may stand for. Those with `values` have a histogram, whose bins have the colors of their values.
const modes = {
  least_angle: {values: leastAngles, from: 0, to: 60, bins: 60, color: colorOfAngle},
  largest_angle: {values: largestAngles, from: 60, to: 180, bins: 60, color: a => colorOfAngle(120 - a)},
  size: {values: sizes, from: sizeRange[0], to: sizeRange[1], bins: 60, color: colorOfSize},
  region: {}, none: {}
};
function binOf(mode, value) {
  const bin = Math.floor((value - mode.from) / (mode.to - mode.from || 1) * mode.bins);
  return Math.max(0, Math.min(mode.bins - 1, bin)) || 0;
}

function colorsOf(name) {
  const colors = new Uint32Array(numberOfTriangles), mode = modes[name];
  if (mode.values) {
    const steps = 1024, table = new Uint32Array(steps);
    const share = steps / (mode.to - mode.from || 1);
    for (let i = 0; i < steps; ++i) table[i] = packed(rgb(mode.color(mode.from + (i + .5) / share)));
    const isStepped = name != 'size', angles = angleColors.map(c => packed(rgb(c)));
    for (let t = 0; t < numberOfTriangles; ++t) {
      const value = mode.values[t];
      if (isStepped) {
        const angle = name == 'least_angle' ? value : 120 - value;
        colors[t] = angles[Math.max(0, Math.min(11, Math.floor(angle / 5)))];
      } else
        colors[t] = table[Math.max(0, Math.min(steps - 1, Math.floor((value - mode.from) * share)))];
    }
  } else if (name == 'region' && regions) {
    const table = regionColors.map(c => packed(rgb(c))), none = packed(rgb(plainColor));
    for (let t = 0; t < numberOfTriangles; ++t) colors[t] = regions[t] < 0 ? none : table[regions[t] % 12];
  } else
    colors.fill(packed(rgb(plainColor)));
  return colors;
}

// --- what is drawn ---

// Edges get fainter where triangles are small on the screen, and vanish where they would be all one sees.
const edges = {opacity: .55, width: .8, from: 3, to: 14};
// How opaque a line is: `opacity[0]`, and 1 more if it is `opacity[1]` pixels long. Long ones are opaque.
const layers = {
  quadtree: {color: quadtreeColor, width: .75, opacity: [-1, 3], make: linesOfQuadtree},
  segments: {color: ink, width: 1.5, opacity: [.5, 6], make: () => linesOf(constrained, outside)},
  unmet: {color: unmetColor, width: 2, opacity: [1, 1], make: linesOfUnmet}
};
const lines = layer => layer.lines || (layer.lines = layer.make());
const ring = {radius: 9, width: 2.2};
const centersOfUnmet = new Float64Array(2 * unmet.length);
unmet.forEach((t, i) => centersOfUnmet.set(centroid(t), 2 * i));

// A renderer draws `view`, which has its middle (x, y), `scale` in pixels per unit, and its width and height in pixels
// of the device, of which there are `density` in one of the page.

// Draws by WebGL, where a graphics card does: without one the page itself draws faster. Its address has a say, too:
// with #webgl in any case, with #canvas never. Floats are relative to an anchor near what is shown, and renewed when
// that is too far away.
class GlRenderer {
  constructor(canvas) {
    const gl = this.gl = location.hash != '#canvas' && canvas.getContext('webgl2', {antialias: true, alpha: false});
    if (!gl || (location.hash != '#webgl' && GlRenderer.isSlow(gl))) throw new Error('no WebGL by a graphics card');
    gl.enable(gl.BLEND);
    gl.blendFunc(gl.SRC_ALPHA, gl.ONE_MINUS_SRC_ALPHA);
    this.areas = this.program(`
      in vec2 p; in vec4 color; uniform vec4 place; out vec3 share; flat out vec3 area;
      void main() {
        int k = gl_VertexID % 3;
        share = vec3(k == 0, k == 1, k == 2); area = color.rgb;
        gl_Position = vec4(p * place.xy + place.zw, 0, 1);
      }`, `
      in vec3 share; flat in vec3 area; uniform vec4 edge; uniform vec3 sizes; out vec4 result;
      float slope(float x) { return max(length(vec2(dFdx(x), dFdy(x))), 1e-12); }
      void main() {
        vec3 slopes = vec3(slope(share.x), slope(share.y), slope(share.z)), d = share / slopes;
        float height = 1. / max(slopes.x, max(slopes.y, slopes.z)), near = min(d.x, min(d.y, d.z));
        float a = edge.a * clamp(sizes.x - near + .5, 0., 1.) * clamp((height - sizes.y) / sizes.z, 0., 1.);
        result = vec4(mix(area, edge.rgb, a), 1);
      }`);
    this.strokes = this.program(`
      in vec4 ends; uniform vec4 place; uniform vec2 half_size; uniform vec3 sizes; out float side;
      flat out float opacity;
      void main() {
        vec2 a = (ends.xy * place.xy + place.zw) * half_size, b = (ends.zw * place.xy + place.zw) * half_size;
        float size = length(b - a), reach = sizes.x + .5, end = float(gl_VertexID & 1);
        vec2 along = size > 0. ? (b - a) / size : vec2(1, 0), across = vec2(-along.y, along.x);
        side = float(gl_VertexID >> 1) * 2. - 1.;
        vec2 p = mix(a, b, end) + across * side * reach;
        side *= reach;
        opacity = clamp(sizes.y + size / sizes.z, 0., 1.);
        gl_Position = opacity > 0. ? vec4(p / half_size, 0, 1) : vec4(2, 2, 2, 1);
      }`, `
      in float side; flat in float opacity; uniform vec4 color; uniform vec3 sizes; out vec4 result;
      void main() { result = vec4(color.rgb, opacity * clamp(sizes.x - abs(side) + .5, 0., 1.)); }`);
    this.rings = this.program(`
      in vec2 p; uniform vec4 place; uniform vec2 half_size; uniform vec2 sizes; out vec2 away;
      void main() {
        away = (vec2(gl_VertexID & 1, gl_VertexID >> 1) * 2. - 1.) * (sizes.x + sizes.y);
        gl_Position = vec4(p * place.xy + place.zw + away / half_size, 0, 1);
      }`, `
      in vec2 away; uniform vec4 color; uniform vec2 sizes; out vec4 result;
      void main() {
        float d = abs(length(away) - sizes.x);
        result = vec4(mix(vec3(1), color.rgb, clamp(sizes.y / 2. - d + .5, 0., 1.)),
                      clamp(sizes.y - d, 0., 1.));
      }`);
    this.buffers = {};
  }
  static isSlow(gl) {
    const names = gl.getExtension('WEBGL_debug_renderer_info');
    const name = gl.getParameter(names ? names.UNMASKED_RENDERER_WEBGL : gl.RENDERER);
    return /swiftshader|llvmpipe|softpipe|software|basic render/i.test(name);
  }
  program(vertex, fragment) {
    const gl = this.gl, program = gl.createProgram();
    for (const [type, text] of [[gl.VERTEX_SHADER, vertex], [gl.FRAGMENT_SHADER, fragment]]) {
      const shader = gl.createShader(type);
      gl.shaderSource(shader, '#version 300 es\nprecision highp float;\n' + text);
      gl.compileShader(shader);
      gl.attachShader(program, shader);
    }
    gl.linkProgram(program);
    if (!gl.getProgramParameter(program, gl.LINK_STATUS) && !gl.isContextLost())
      throw new Error(gl.getProgramInfoLog(program));
    return name => name ? gl.getUniformLocation(program, name) : program;
  }
  fill(name, values) {
    const gl = this.gl, buffer = this.buffers[name] || (this.buffers[name] = gl.createBuffer());
    gl.bindBuffer(gl.ARRAY_BUFFER, buffer);
    gl.bufferData(gl.ARRAY_BUFFER, values, gl.STATIC_DRAW);
  }
  attribute(program, name, buffer, size, type, divisor = 0) {
    const gl = this.gl, at = gl.getAttribLocation(program(), name);
    gl.bindBuffer(gl.ARRAY_BUFFER, this.buffers[buffer]);
    gl.enableVertexAttribArray(at);
    gl.vertexAttribPointer(at, size, type, type == gl.UNSIGNED_BYTE, 0, 0);
    gl.vertexAttribDivisor(at, divisor);
    return () => gl.disableVertexAttribArray(at);
  }
  setColors(colors) {
    const corners = new Uint32Array(3 * colors.length);
    for (let i = 0; i < corners.length; ++i) corners[i] = colors[i / 3 | 0];
    this.fill('colors', new Uint8Array(corners.buffer));
  }
  // Coordinates relative to the anchor, in pixels at its scale.
  relative(n, coordinate) {
    const result = new Float32Array(n), limit = 1e18, {x, y, scale} = this.anchor;
    for (let i = 0; i < n; i += 2) {
      result[i] = Math.max(-limit, Math.min(limit, (coordinate(i) - x) * scale));
      result[i + 1] = Math.max(-limit, Math.min(limit, (coordinate(i + 1) - y) * scale));
    }
    return result;
  }
  drop(view) {
    const a = this.anchor, far = 2 ** 20;
    if (a && Math.max(Math.abs(view.x - a.x), Math.abs(view.y - a.y)) * view.scale < far &&
        view.scale / a.scale < far && a.scale / view.scale < far)
      return;
    this.anchor = {x: view.x, y: view.y, scale: view.scale};
    this.fill('places', this.relative(6 * numberOfTriangles, i => points[2 * triangles[i >> 1] + (i & 1)] * unit));
    this.fill('centers', this.relative(centersOfUnmet.length, i => centersOfUnmet[i]));
    for (const name in layers) layers[name].isPlaced = false;
  }
  draw(view, shown) {
    this.drop(view);
    const gl = this.gl, w = view.width, h = view.height, d = view.density, a = this.anchor;
    const zoom = view.scale / a.scale;
    const place = [zoom * 2 / w, zoom * 2 / h, (a.x - view.x) * view.scale * 2 / w,
      (a.y - view.y) * view.scale * 2 / h];
    gl.viewport(0, 0, w, h);
    gl.clearColor(...rgb(paper).map(c => c / 255), 1);
    gl.clear(gl.COLOR_BUFFER_BIT);
    const use = program => { gl.useProgram(program()); gl.uniform4fv(program('place'), place); };
    const color = hex => [...rgb(hex).map(c => c / 255), 1];
    use(this.areas);
    gl.uniform4fv(this.areas('edge'), [...color(ink).slice(0, 3), shown.edges ? edges.opacity : 0]);
    gl.uniform3f(this.areas('sizes'), edges.width * d / 2, edges.from * d, (edges.to - edges.from) * d);
    const done = [this.attribute(this.areas, 'p', 'places', 2, gl.FLOAT),
      this.attribute(this.areas, 'color', 'colors', 4, gl.UNSIGNED_BYTE)];
    gl.drawArrays(gl.TRIANGLES, 0, 3 * numberOfTriangles);
    done.forEach(f => f());
    for (const name in layers) {
      const layer = layers[name];
      if (!shown[name]) continue;
      const all = lines(layer);
      if (!layer.isPlaced) this.fill(name, this.relative(all.length, i => all[i])), layer.isPlaced = true;
      use(this.strokes);
      gl.uniform2f(this.strokes('half_size'), w / 2, h / 2);
      gl.uniform3f(this.strokes('sizes'), layer.width * d / 2, layer.opacity[0], layer.opacity[1] * d);
      gl.uniform4fv(this.strokes('color'), color(layer.color));
      const end = this.attribute(this.strokes, 'ends', name, 4, gl.FLOAT, 1);
      gl.drawArraysInstanced(gl.TRIANGLE_STRIP, 0, 4, all.length / 4);
      end();
    }
    if (!shown.unmet) return;
    use(this.rings);
    gl.uniform2f(this.rings('half_size'), w / 2, h / 2);
    gl.uniform2f(this.rings('sizes'), ring.radius * d, ring.width * d);
    gl.uniform4fv(this.rings('color'), color(unmetColor));
    const end = this.attribute(this.rings, 'p', 'centers', 2, gl.FLOAT, 1);
    gl.drawArraysInstanced(gl.TRIANGLE_STRIP, 0, 4, unmet.length);
    end();
  }
}

// The piece of a segment within a rectangle around the view, in pixels; null for none.
function clipped(view, u0, v0, u1, v1) {
  const margin = 20, limits = [-margin, view.width + margin, -margin, view.height + margin];
  const a = [(u0 - view.x) * view.scale + view.width / 2, view.height / 2 - (v0 - view.y) * view.scale];
  const b = [(u1 - view.x) * view.scale + view.width / 2, view.height / 2 - (v1 - view.y) * view.scale];
  let first = 0, last = 1;
  for (let k = 0; k < 2; ++k) {
    const size = b[k] - a[k], low = limits[2 * k] - a[k], high = limits[2 * k + 1] - a[k];
    if (size == 0) {
      if (low > 0 || high < 0) return null;
      continue;
    }
    first = Math.max(first, Math.min(low / size, high / size));
    last = Math.min(last, Math.max(low / size, high / size));
  }
  if (!(first <= last)) return null;
  const at = share => [a[0] + share * (b[0] - a[0]), a[1] + share * (b[1] - a[1])];
  return [...at(first), ...at(last)];
}

// Draws without WebGL, by the same rules, pixel by pixel.
class RasterRenderer {
  constructor(canvas) { this.context = canvas.getContext('2d', {alpha: false}); }
  setColors(colors) { this.colors = colors; }
  draw(view, shown) {
    const w = view.width, h = view.height;
    if (!this.image || this.image.width != w || this.image.height != h)
      this.image = this.context.createImageData(w, h);
    const pixels = new Uint32Array(this.image.data.buffer);
    pixels.fill(packed(rgb(paper)));
    this.fillAreas(view, pixels, shown.edges ? edges.opacity : 0);
    for (const name in layers)
      if (shown[name]) this.stroke(view, pixels, layers[name]);
    if (shown.unmet) this.drawRings(view, pixels);
    this.context.putImageData(this.image, 0, 0);
  }
  fillAreas(view, pixels, opacity) {
    const w = view.width, h = view.height, d = view.density, [inkR, inkG, inkB] = rgb(ink), slack = 1e-3;
    const scale = view.scale, left = view.x - w / 2 / scale, top = view.y + h / 2 / scale;
    const reach = edges.width * d / 2 + .5;
    const px = [0, 0, 0], py = [0, 0, 0], A = [0, 0, 0], B = [0, 0, 0], C = [0, 0, 0];
    for (let t = 0; t < numberOfTriangles; ++t) {
      for (let k = 0; k < 3; ++k) {
        const v = triangles[3 * t + k];
        px[k] = (points[2 * v] * unit - left) * scale, py[k] = (top - points[2 * v + 1] * unit) * scale;
      }
      const row0 = Math.max(0, Math.ceil(Math.min(py[0], py[1], py[2]) - .5));
      const row1 = Math.min(h - 1, Math.floor(Math.max(py[0], py[1], py[2]) - .5));
      const column0 = Math.max(0, Math.ceil(Math.min(px[0], px[1], px[2]) - .5));
      const column1 = Math.min(w - 1, Math.floor(Math.max(px[0], px[1], px[2]) - .5));
      if (row0 > row1 || column0 > column1) continue;
      // The distance to side k, positive inside, is A[k] column + B[k] row + C[k] at the middle of a pixel.
      const twice = (px[1] - px[0]) * (py[0] - py[2]) + (py[1] - py[0]) * (px[2] - px[0]);
      let longest = 0;
      for (let k = 0; k < 3; ++k) {
        const i = (k + 1) % 3, j = (k + 2) % 3, u = px[j] - px[i], v = py[j] - py[i], size = Math.hypot(u, v);
        longest = Math.max(longest, size);
        A[k] = v / size, B[k] = -u / size, C[k] = A[k] * (.5 - px[i]) + B[k] * (.5 - py[i]);
      }
      const fade = Math.max(0, Math.min(1, (twice / longest / d - edges.from) / (edges.to - edges.from)));
      const color = this.colors[t], r = color & 255, g = color >> 8 & 255, b = color >> 16 & 255;
      for (let row = row0; row <= row1; ++row) {
        let first = column0, last = column1;
        for (let k = 0; k < 3; ++k) {
          const rest = B[k] * row + C[k] + slack;
          if (A[k] > 0) first = Math.max(first, Math.ceil(-rest / A[k]));
          else if (A[k] < 0) last = Math.min(last, Math.floor(-rest / A[k]));
          else if (rest < 0) last = -1;
        }
        const begin = row * w;
        for (let column = first; column <= last; ++column) {
          const near = Math.min(A[0] * column + B[0] * row + C[0], A[1] * column + B[1] * row + C[1],
            A[2] * column + B[2] * row + C[2]);
          const a = fade > 0 && near < reach ? opacity * fade * Math.min(1, reach - near) : 0;
          pixels[begin + column] = a > 0 ? 255 << 24 | b + a * (inkB - b) << 16 | g + a * (inkG - g) << 8 |
            r + a * (inkR - r) : color;
        }
      }
    }
  }
  stroke(view, pixels, layer) {
    const all = lines(layer), d = view.density, reach = layer.width * d / 2 + .5;
    const w = view.width, h = view.height, [r, g, b] = rgb(layer.color);
    for (let i = 0; i < all.length; i += 4) {
      const size = Math.hypot(all[i + 2] - all[i], all[i + 3] - all[i + 1]) * view.scale;
      const opacity = Math.min(1, layer.opacity[0] + size / layer.opacity[1] / d);
      const piece = opacity > 0 && clipped(view, all[i], all[i + 1], all[i + 2], all[i + 3]);
      if (!piece) continue;
      const [x0, y0, x1, y1] = piece, length = Math.hypot(x1 - x0, y1 - y0);
      const u = length > 0 ? (x1 - x0) / length : 1, v = length > 0 ? (y1 - y0) / length : 0;
      const row0 = Math.max(0, Math.ceil(Math.min(y0, y1) - reach - .5));
      const row1 = Math.min(h - 1, Math.floor(Math.max(y0, y1) + reach - .5));
      for (let row = row0; row <= row1; ++row) {
        let low = Math.min(x0, x1) - reach, high = Math.max(x0, x1) + reach;
        if (Math.abs(v) > 1e-6) {
          const middle = x0 + (row + .5 - y0) * u / v, spread = reach / Math.abs(v);
          low = Math.max(low, middle - spread), high = Math.min(high, middle + spread);
        }
        const last = Math.min(w - 1, Math.floor(high - .5));
        for (let column = Math.max(0, Math.ceil(low - .5)); column <= last; ++column) {
          const px = column + .5 - x0, py = row + .5 - y0, along = px * u + py * v;
          if (along < 0 || along >= length) continue;
          const a = opacity * Math.min(1, reach - Math.abs(px * v - py * u));
          if (a > 0) blend(pixels, row * w + column, r, g, b, a);
        }
      }
    }
  }
  drawRings(view, pixels) {
    const w = view.width, h = view.height, d = view.density, radius = ring.radius * d, width = ring.width * d;
    const [r, g, b] = rgb(unmetColor), most = radius + width;
    for (let i = 0; i < centersOfUnmet.length; i += 2) {
      const x0 = (centersOfUnmet[i] - view.x) * view.scale + w / 2;
      const y0 = h / 2 - (centersOfUnmet[i + 1] - view.y) * view.scale;
      const row1 = Math.min(h - 1, Math.floor(y0 + most)), column1 = Math.min(w - 1, Math.floor(x0 + most));
      for (let row = Math.max(0, Math.ceil(y0 - most)); row <= row1; ++row)
        for (let column = Math.max(0, Math.ceil(x0 - most)); column <= column1; ++column) {
          const away = Math.abs(Math.hypot(column + .5 - x0, row + .5 - y0) - radius);
          const a = Math.min(1, width - away), c = Math.max(0, Math.min(1, width / 2 - away + .5));
          if (a > 0) blend(pixels, row * w + column, 255 + c * (r - 255), 255 + c * (g - 255), 255 + c * (b - 255), a);
        }
    }
  }
}
function blend(pixels, i, r, g, b, a) {
  const p = pixels[i], r0 = p & 255, g0 = p >> 8 & 255, b0 = p >> 16 & 255;
  pixels[i] = 255 << 24 | b0 + a * (b - b0) << 16 | g0 + a * (g - g0) << 8 | r0 + a * (r - r0);
}
)js";

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_PAGE_PAGE_RENDERERS_H
