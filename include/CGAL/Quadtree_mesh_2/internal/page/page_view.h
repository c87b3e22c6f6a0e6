// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_PAGE_PAGE_VIEW_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_PAGE_PAGE_VIEW_H

#include <string_view>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// JavaScript of the page, third part: the view, the panel, and what pointers and keys do.
inline constexpr std::string_view page_view = R"js(
// --- words ---

const grouped = n => String(n).replace(/\B(?=(\d{3})+$)/g, '\u202f');
const short = (value, digits = 6) => String(Number(value.toPrecision(digits)));
const degrees = angle => angle.toFixed(4) + '\u00b0';
function element(tag, parent, text = '', className = '') {
  const result = document.createElement(tag);
  result.textContent = text;
  if (className) result.className = className;
  parent.append(result);
  return result;
}
const nameOfRegion = r => r < 0 ? 'none' : r + (r < head.attributes.length ? ' (' + head.attributes[r] + ')' : '');

// --- the view ---

let canvas = byId('mesh'), renderer, isDrawWanted = false, isFitted = true;
const overlay = byId('overlay'), panel = byId('panel'), tip = byId('tip');
const view = {x: 0, y: 0, scale: 1, width: 1, height: 1, density: 1};
const shown = {edges: true, segments: true, quadtree: false, unmet: unmet.length > 0};
let marked = -1; // the triangle with the outline

const toPlane = (px, py) => [view.x + (px * view.density - view.width / 2) / view.scale,
  view.y - (py * view.density - view.height / 2) / view.scale];
const toPage = (u, v) => [((u - view.x) * view.scale + view.width / 2) / view.density,
  (view.height / 2 - (v - view.y) * view.scale) / view.density];

// The part of the page that nothing lies on, in pixels of the page.
function freeArea() {
  const width = overlay.clientWidth, height = overlay.clientHeight;
  const right = panel.open && width > 640 ? panel.offsetWidth + 24 : 12;
  const top = byId('head-line').offsetHeight + 24;
  return {left: 20, top, width: Math.max(40, width - 20 - right - 8), height: Math.max(40, height - top - 52)};
}

// At a place, such that a pixel is 64 steps of the coordinates.
const greatestScale = (u, v) => 2 ** 46 / Math.max(Math.abs(u), Math.abs(v), 2 ** -900);

function lookAt(u, v, scale) {
  const area = freeArea(), d = view.density;
  view.scale = Math.min(greatestScale(u, v), scale);
  view.x = u - ((area.left + area.width / 2) * d - view.width / 2) / view.scale;
  view.y = v + ((area.top + area.height / 2) * d - view.height / 2) / view.scale;
  changed();
}

const scaleToFit = () => {
  const area = freeArea(), extent = Math.max((box.x1 - box.x0) / area.width, (box.y1 - box.y0) / area.height);
  return view.density / (extent || 1);
};
function fit() {
  lookAt((box.x0 + box.x1) / 2, (box.y0 + box.y1) / 2, scaleToFit());
  isFitted = true;
}

function zoom(factor, px = overlay.clientWidth / 2, py = overlay.clientHeight / 2) {
  const [u, v] = toPlane(px, py), least = scaleToFit() / 4;
  const scale = Math.max(Math.min(view.scale * factor, Math.max(view.scale, greatestScale(u, v))),
    Math.min(view.scale, least));
  view.x = u - (px * view.density - view.width / 2) / scale;
  view.y = v + (py * view.density - view.height / 2) / scale;
  view.scale = scale;
  isFitted = false;
  changed();
}

function pan(dx, dy) {
  view.x -= dx * view.density / view.scale;
  view.y += dy * view.density / view.scale;
  isFitted = false;
  changed();
}

// Shows one triangle with its surroundings, and its numbers.
function show(t) {
  measure(t);
  const area = freeArea();
  const scale = Math.min(area.width, area.height) / 6 * view.density / (measured.longest || 1);
  lookAt(...centroid(t), Math.max(scale, scaleToFit()));
  isFitted = false;
  const right = Math.max(...[0, 1, 2].map(k => x(triangles[3 * t + k])));
  showTip(t, ...toPage(right, centroid(t)[1]));
}

function resize() {
  view.density = window.devicePixelRatio || 1;
  const [width, height] = [overlay.clientWidth, overlay.clientHeight].map(size => Math.round(size * view.density));
  if (width == view.width && height == view.height) return;
  view.width = Math.max(1, width), view.height = Math.max(1, height);
  for (const one of [canvas, overlay]) one.width = view.width, one.height = view.height;
  if (isFitted) fit(); else changed();
}

function changed() {
  if (isDrawWanted) return;
  isDrawWanted = true;
  requestAnimationFrame(() => {
    isDrawWanted = false;
    renderer.draw(view, shown);
    drawMark();
    drawScaleBar();
    document.documentElement.dataset.ready = 'yes';
  });
}

function drawMark() {
  const context = overlay.getContext('2d');
  context.clearRect(0, 0, view.width, view.height);
  if (marked < 0) return;
  const d = view.density, corners = [0, 1, 2].map(k => triangles[3 * marked + k]);
  for (const [width, color] of [[5, '#ffffff'], [2.5, isUnmet[marked] ? unmetColor : '#0b1724']]) {
    context.beginPath();
    for (let k = 0; k < 3; ++k) {
      const a = corners[k], b = corners[(k + 1) % 3], piece = clipped(view, x(a), y(a), x(b), y(b));
      if (piece) context.moveTo(piece[0], piece[1]), context.lineTo(piece[2], piece[3]);
    }
    context.lineWidth = width * d;
    context.lineCap = context.lineJoin = 'round';
    context.strokeStyle = color;
    context.stroke();
  }
}

// A length of 1, 2 or 5 times a power of ten, up to 120 pixels.
function drawScaleBar() {
  const most = 120 * view.density / view.scale / unit, power = 10 ** Math.floor(Math.log10(most));
  const length = [5, 2, 1].find(f => f * power <= most) * power;
  const isKnown = isFinite(length) && length > 0;
  byId('scale').hidden = !isKnown;
  if (!isKnown) return;
  byId('scale').style.width = length * unit * view.scale / view.density + 'px';
  byId('scale').textContent = length < 1e6 ? grouped(short(length, 1)) : short(length, 1);
}

// --- numbers of the triangle under the pointer ---

function showTip(t, px, py) {
  if (marked != t) {
    marked = t;
    drawMark();
  }
  tip.hidden = t < 0;
  if (t < 0) return;
  if (tip.dataset.triangle != t) fillTip(t);
  const width = tip.offsetWidth, height = tip.offsetHeight, gap = 18;
  const left = px + gap + width > overlay.clientWidth ? px - gap - width : px + gap;
  const top = Math.min(py + gap, overlay.clientHeight - height - 8);
  tip.style.transform = `translate(${Math.max(8, left)}px, ${Math.max(8, top)}px)`;
}

function fillTip(t) {
  measure(t);
  tip.textContent = '';
  tip.dataset.triangle = t;
  const title = element('h2', tip, 'triangle ' + grouped(t + head.first));
  if (isUnmet[t]) element('span', title, 'unmet', 'badge');
  const list = element('dl', tip);
  const row = (name, value, of) => {
    element('dt', list, name);
    element('dd', list, value).dataset.of = of;
  };
  row('least angle', degrees(measured.least), 'least');
  row('largest angle', degrees(measured.largest), 'largest');
  row('longest edge', short(measured.longest / unit), 'longest');
  row('area', short(measured.area / unit / unit), 'area');
  if (regions) row('region', nameOfRegion(regions[t]), 'region');
  const vertices = element('table', tip), names = element('tr', vertices);
  for (const name of ['vertex', 'x', 'y']) element('th', names, name);
  for (let k = 0; k < 3; ++k) {
    const v = triangles[3 * t + k], line = element('tr', vertices), places = coordinates || points;
    for (const text of [grouped(v + head.first), places[2 * v], places[2 * v + 1]]) element('td', line, text);
  }
}

// What the user calls a place; nothing between vertices whose coordinates are others and that no triangle joins.
function nameOfPlace(u, v, t) {
  const digits = (value, step) =>
    short(value, Math.max(1, Math.min(17, Math.ceil(Math.log10(Math.abs(value) / step || 1)) + 1)));
  if (!coordinates) return [u, v].map(c => digits(c / unit, view.density / view.scale / unit));
  if (t < 0) return null;
  const corners = [0, 1, 2].map(k => triangles[3 * t + k]);
  const shares = corners.map((_, k) => {
    const b = corners[(k + 1) % 3], c = corners[(k + 2) % 3];
    return (x(b) - u) * (y(c) - v) - (y(b) - v) * (x(c) - u);
  });
  const sum = shares[0] + shares[1] + shares[2];
  const value = i => corners.reduce((total, v, k) => total + shares[k] / sum * coordinates[2 * v + i], 0);
  return [short(value(0), 8), short(value(1), 8)];
}

function hover(px, py) {
  const [u, v] = toPlane(px, py), t = triangleAt(u, v), place = nameOfPlace(u, v, t);
  byId('place').textContent = place ? place.join('  ') : '';
  showTip(t, px, py);
}
function leave() {
  byId('place').textContent = '';
  showTip(-1);
}

// --- the panel ---

function fillCounts() {
  const counts = byId('counts'), isUsed = new Uint8Array(points.length / 2);
  for (let i = 0; i < triangles.length; ++i) isUsed[triangles[i]] = 1;
  const vertices = isUsed.reduce((sum, used) => sum + used, 0);
  element('span', counts, grouped(numberOfTriangles) + (numberOfTriangles == 1 ? ' triangle' : ' triangles'));
  element('span', counts, grouped(vertices) + ' vertices');
  if (numberOfTriangles == 0) return;
  for (const [word, of] of [['least', 'least'], ['largest', 'largest']]) {
    measure(extremes[of]);
    const button = element('button', counts, word + ' angle ' + measured[of].toFixed(2) + '\u00b0');
    button.title = 'show the triangle with the ' + word + ' angle';
    button.onclick = () => show(extremes[of]);
  }
  if (unmet.length) element('span', counts, grouped(unmet.length) + ' unmet', 'badge');
}

function fillLegend(name) {
  const legend = byId('legend'), mode = modes[name];
  legend.textContent = '';
  if (mode.values) drawHistogram(legend, name, mode);
  if (name == 'region') listRegions(legend);
}

function drawHistogram(legend, name, mode) {
  const counts = new Array(mode.bins).fill(0), width = 240, height = 72, bar = width / mode.bins;
  for (const value of mode.values) ++counts[binOf(mode, value)];
  const most = Math.max(1, ...counts), isSize = name == 'size';
  const valueAt = i => mode.from + (mode.to - mode.from) * i / mode.bins;
  const text = value => isSize ? short(10 ** value, 3) : Math.round(value) + '\u00b0';
  let shapes = '';
  counts.forEach((n, i) => {
    const color = mode.color(valueAt(i + .5)), size = n > 0 ? Math.max(1.5, (height - 2) * n / most) : 0;
    const label = `${text(valueAt(i))} to ${text(valueAt(i + 1))}: ${grouped(n)}`;
    shapes += `<rect x="${i * bar}" y="${height - size}" width="${bar}" height="${size}" fill="${color}"/>` +
      `<rect x="${i * bar}" y="${height + 2}" width="${bar + .2}" height="7" fill="${color}"/>` +
      `<rect class="over" x="${i * bar}" y="0" width="${bar}" height="${height + 9}"><title>${label}</title></rect>`;
  });
  const ticks = isSize ? [0, mode.bins / 2, mode.bins] : [0, 1, 2, 3, 4, 5, 6].map(i => i * mode.bins / 6);
  ticks.forEach((tick, i) => {
    const anchor = !isSize ? 'middle' : i == 0 ? 'start' : i == ticks.length - 1 ? 'end' : 'middle';
    shapes += `<text x="${tick * bar}" y="${height + 22}" text-anchor="${anchor}">${text(valueAt(tick))}</text>`;
  });
  legend.innerHTML = `<svg viewBox="0 0 ${width} ${height + 26}" role="img" aria-label="histogram">${shapes}</svg>`;
  legend.dataset.counts = counts.join(' ');
}

function listRegions(legend) {
  const counts = new Map();
  for (const r of regions) counts.set(r, (counts.get(r) || 0) + 1);
  const list = element('ul', legend), most = 40;
  const all = [...counts.keys()].sort((a, b) => a < 0 ? 1 : b < 0 ? -1 : a - b);
  for (const r of all.slice(0, most)) {
    const line = element('li', list);
    element('i', line).style.background = colorOfRegion(r);
    element('span', line, nameOfRegion(r));
    element('span', line, grouped(counts.get(r)));
  }
  if (all.length > most) element('li', list, `and ${grouped(all.length - most)} more`);
}

function setMode(name) {
  byId('color').value = name;
  renderer.setColors(colorsOf(name));
  fillLegend(name);
  changed();
}
function setShown(name, isShown) {
  shown[name] = byId('show-' + name).checked = isShown;
  changed();
}

let nextUnmet = 0;
function fillPanel() {
  if (!regions) byId('color').querySelector('[value=region]').disabled = true;
  byId('color').onchange = event => setMode(event.target.value);
  byId('row-quadtree').hidden = !head.quadtree;
  byId('row-unmet').hidden = unmet.length == 0;
  byId('number-unmet').textContent = grouped(unmet.length);
  byId('next').onclick = () => show(unmet[nextUnmet++ % unmet.length]);
  byId('note').hidden = !coordinates;
  shown.quadtree = !!head.quadtree;
  for (const name in shown) {
    byId('show-' + name).checked = shown[name];
    byId('show-' + name).onchange = event => setShown(name, event.target.checked);
  }
  for (const [id, f] of [['zoom-in', () => zoom(1.5)], ['zoom-out', () => zoom(1 / 1.5)], ['fit', fit]])
    byId(id).onclick = f;
  panel.open = window.innerWidth > 640;
}

// --- pointers and keys ---

const pointers = new Map(); // where fingers and pressed buttons are
overlay.onpointerdown = event => {
  overlay.setPointerCapture(event.pointerId);
  pointers.set(event.pointerId, [event.clientX, event.clientY]);
  if (event.pointerType != 'mouse') hover(event.clientX, event.clientY);
};
overlay.onpointermove = event => {
  const before = pointers.get(event.pointerId), now = [event.clientX, event.clientY];
  if (!before) return hover(...now);
  const other = [...pointers].find(([id]) => id != event.pointerId);
  if (other) {
    const [ox, oy] = other[1], distance = p => Math.max(8, Math.hypot(p[0] - ox, p[1] - oy));
    zoom(distance(now) / distance(before), ox, oy);
  } else
    pan(now[0] - before[0], now[1] - before[1]);
  pointers.set(event.pointerId, now);
  if (pointers.size > 1) leave(); else hover(...now);
};
overlay.onpointerup = overlay.onpointercancel = event => pointers.delete(event.pointerId);
overlay.onpointerleave = event => { if (event.pointerType == 'mouse') leave(); };
overlay.ondblclick = event => zoom(2, event.clientX, event.clientY);
overlay.addEventListener('wheel', event => {
  event.preventDefault();
  const pixels = event.deltaY * (event.deltaMode == 1 ? 16 : event.deltaMode == 2 ? 400 : 1);
  zoom(Math.exp(-pixels * (event.ctrlKey ? .01 : .0015)), event.clientX, event.clientY);
  hover(event.clientX, event.clientY);
}, {passive: false});

const keys = {
  '+': () => zoom(1.5), '=': () => zoom(1.5), '-': () => zoom(1 / 1.5), '0': fit,
  ArrowLeft: () => pan(80, 0), ArrowRight: () => pan(-80, 0), ArrowUp: () => pan(0, 80), ArrowDown: () => pan(0, -80),
  c: () => {
    const options = [...byId('color').options].filter(option => !option.disabled).map(option => option.value);
    setMode(options[(options.indexOf(byId('color').value) + 1) % options.length]);
  },
  e: () => setShown('edges', !shown.edges), s: () => setShown('segments', !shown.segments),
  q: () => head.quadtree && setShown('quadtree', !shown.quadtree),
  u: () => unmet.length && setShown('unmet', !shown.unmet), n: () => unmet.length && byId('next').click()
};
window.onkeydown = event => {
  if (event.ctrlKey || event.metaKey || event.altKey || event.target.tagName == 'SELECT' || !keys[event.key]) return;
  event.preventDefault();
  leave();
  keys[event.key]();
};

// --- begin ---

function chooseRenderer() {
  try {
    renderer = new GlRenderer(canvas);
    canvas.addEventListener('webglcontextlost', () => useRaster(), {once: true});
  } catch (error) {
    return useRaster();
  }
  document.documentElement.dataset.renderer = 'webgl';
}
// A canvas that was asked for WebGL may have no other context.
function useRaster() {
  const fresh = canvas.cloneNode();
  canvas.replaceWith(fresh);
  canvas = fresh;
  renderer = new RasterRenderer(canvas);
  document.documentElement.dataset.renderer = 'canvas';
  setMode(byId('color').value);
}

fillPanel();
fillCounts();
byId('color').value = head.color == 'region' && !regions ? 'least_angle' : head.color;
chooseRenderer();
setMode(byId('color').value);
new ResizeObserver(resize).observe(overlay);
resize();
)js";

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_PAGE_PAGE_VIEW_H
