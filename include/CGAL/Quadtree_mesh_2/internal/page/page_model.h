// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_PAGE_PAGE_MODEL_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_PAGE_PAGE_MODEL_H

#include <string_view>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// JavaScript of the page, first part: arrays out of the file, what is measured of triangles, and which is where.
inline constexpr std::string_view page_model = R"js(
'use strict';
const byId = id => document.getElementById(id);
const head = JSON.parse(byId('head').textContent);

// --- what is in the file ---

// Arrays are little-endian there, as browsers' machines are.
function array(id) {
  const element = byId(id);
  if (!element) return null;
  const text = element.textContent, types = {
    Int8: Int8Array, Int16: Int16Array, Int32: Int32Array, Uint8: Uint8Array, Uint16: Uint16Array,
    Uint32: Uint32Array, Float64: Float64Array};
  let bytes;
  if (Uint8Array.fromBase64)
    bytes = Uint8Array.fromBase64(text);
  else {
    const raw = atob(text);
    bytes = new Uint8Array(raw.length);
    for (let i = 0; i < raw.length; ++i) bytes[i] = raw.charCodeAt(i);
  }
  const type = element.dataset.type;
  element.remove();
  return new types[type](bytes.buffer);
}

const points = array('points'), triangles = array('triangles'), regions = array('regions');
const constrained = array('edges'), outside = array('outside'), unmet = array('unmet');
const coordinates = array('coordinates'); // to be shown, if points are not what the user knows
const numberOfTriangles = triangles.length / 3;

// All work is on points times a power of two, so that differences and products of any doubles are finite.
let unit = 1;
{
  let most = 0;
  for (let i = 0; i < points.length; ++i) most = Math.max(most, Math.abs(points[i]));
  if (most > 0) unit = 2 ** -Math.min(1022, Math.max(-1000, Math.floor(Math.log2(most))));
}
const x = v => points[2 * v] * unit, y = v => points[2 * v + 1] * unit;

const box = {x0: Infinity, y0: Infinity, x1: -Infinity, y1: -Infinity};
for (const list of [triangles, constrained, outside])
  for (let i = 0; i < list.length; ++i) {
    const px = x(list[i]), py = y(list[i]);
    if (px < box.x0) box.x0 = px;
    if (px > box.x1) box.x1 = px;
    if (py < box.y0) box.y0 = py;
    if (py > box.y1) box.y1 = py;
  }
if (!(box.x0 <= box.x1)) box.x0 = box.x1 = box.y0 = box.y1 = 0;

const isUnmet = new Uint8Array(numberOfTriangles);
for (const t of unmet) isUnmet[t] = 1;

// --- triangles measured ---

// Puts the least and largest angle in degrees, the longest edge and the area (of work) into `measured`.
// Sides are scaled by their extent, so that any triangle of doubles is measured to the last digits.
const measured = {least: 0, largest: 0, longest: 0, area: 0};
const sidesX = new Float64Array(3), sidesY = new Float64Array(3), squares = new Float64Array(3);
function measure(t) {
  const a = triangles[3 * t], b = triangles[3 * t + 1], c = triangles[3 * t + 2];
  const ax = x(a), ay = y(a), bx = x(b), by = y(b), cx = x(c), cy = y(c);
  sidesX[0] = cx - bx, sidesY[0] = cy - by; // opposite corner 0
  sidesX[1] = ax - cx, sidesY[1] = ay - cy;
  sidesX[2] = bx - ax, sidesY[2] = by - ay;
  let extent = 0, shortest = 0, longest = 0;
  for (let k = 0; k < 3; ++k) extent = Math.max(extent, Math.abs(sidesX[k]), Math.abs(sidesY[k]));
  if (!(extent > 0)) extent = 1;
  for (let k = 0; k < 3; ++k) {
    const u = sidesX[k] /= extent, v = sidesY[k] /= extent;
    squares[k] = u * u + v * v;
    if (squares[k] < squares[shortest]) shortest = k;
    if (squares[k] > squares[longest]) longest = k;
  }
  measured.least = angleAt(shortest);
  measured.largest = angleAt(longest);
  measured.longest = Math.sqrt(squares[longest]) * extent;
  measured.area = Math.abs(sidesX[0] * sidesY[1] - sidesY[0] * sidesX[1]) / 2 * extent * extent;
}
function angleAt(k) {
  const i = (k + 1) % 3, j = (k + 2) % 3;
  const sine = sidesX[i] * sidesY[j] - sidesY[i] * sidesX[j];
  const cosine = -sidesX[i] * sidesX[j] - sidesY[i] * sidesY[j];
  return Math.atan2(Math.abs(sine), cosine) * 180 / Math.PI;
}

// Per triangle, for colors and histograms. Sizes are longest edges, as decimal logarithms in the user's unit.
const leastAngles = new Float32Array(numberOfTriangles), largestAngles = new Float32Array(numberOfTriangles);
const sizes = new Float32Array(numberOfTriangles);
const extremes = {least: 0, largest: 0}; // the triangles with the least and the largest angle of all
{
  let least = Infinity, largest = -Infinity;
  const logarithmOfUnit = Math.log10(unit);
  for (let t = 0; t < numberOfTriangles; ++t) {
    measure(t);
    leastAngles[t] = measured.least;
    largestAngles[t] = measured.largest;
    sizes[t] = Math.log10(measured.longest) - logarithmOfUnit;
    if (measured.least < least) least = measured.least, extremes.least = t;
    if (measured.largest > largest) largest = measured.largest, extremes.largest = t;
  }
}

// --- which triangle is at a place ---

// Cells of a uniform grid list the triangles whose boxes meet them. Triangles that meet very many are kept apart.
const grid = (() => {
  const width = box.x1 - box.x0, height = box.y1 - box.y0, wanted = Math.max(1, numberOfTriangles / 2);
  const side = Math.max(Math.sqrt(width * height / wanted), Math.max(width, height) / wanted) || 1;
  const columns = Math.min(Math.floor(width / side) + 1, 1 << 14);
  const rows = Math.min(Math.floor(height / side) + 1, 1 << 14), most = 256;
  const column = u => Math.min(columns - 1, Math.max(0, Math.floor((u - box.x0) / side)));
  const row = v => Math.min(rows - 1, Math.max(0, Math.floor((v - box.y0) / side)));
  const begins = new Uint32Array(columns * rows + 1), large = [];
  const forCells = (t, visit) => {
    const a = triangles[3 * t], b = triangles[3 * t + 1], c = triangles[3 * t + 2];
    const i0 = column(Math.min(x(a), x(b), x(c))), i1 = column(Math.max(x(a), x(b), x(c)));
    const j0 = row(Math.min(y(a), y(b), y(c))), j1 = row(Math.max(y(a), y(b), y(c)));
    if ((i1 - i0 + 1) * (j1 - j0 + 1) > most) return false;
    for (let j = j0; j <= j1; ++j)
      for (let i = i0; i <= i1; ++i) visit(j * columns + i);
    return true;
  };
  for (let t = 0; t < numberOfTriangles; ++t)
    if (!forCells(t, cell => ++begins[cell + 1])) large.push(t);
  for (let i = 0; i < columns * rows; ++i) begins[i + 1] += begins[i];
  const listed = new Uint32Array(begins[columns * rows]), ends = begins.slice(0, -1);
  for (let t = 0; t < numberOfTriangles; ++t) forCells(t, cell => listed[ends[cell]++] = t);
  return {
    large,
    at: (u, v) => {
      const cell = row(v) * columns + column(u);
      return listed.subarray(begins[cell], begins[cell + 1]);
    }
  };
})();

function isInTriangle(t, u, v) {
  for (let k = 0; k < 3; ++k) {
    const a = triangles[3 * t + k], b = triangles[3 * t + (k + 1) % 3], ax = x(a), ay = y(a);
    if ((x(b) - ax) * (v - ay) - (y(b) - ay) * (u - ax) < 0) return false;
  }
  return true;
}

// The triangle at a place, -1 for none.
function triangleAt(u, v) {
  for (const list of [grid.at(u, v), grid.large])
    for (const t of list)
      if (isInTriangle(t, u, v)) return t;
  return -1;
}

function centroid(t) {
  let u = 0, v = 0;
  for (let k = 0; k < 3; ++k) u += x(triangles[3 * t + k]) / 3, v += y(triangles[3 * t + k]) / 3;
  return [u, v];
}

// --- lines: four numbers for each, the coordinates of its ends ---

function linesOf(...lists) {
  const lines = new Float64Array(2 * lists.reduce((sum, list) => sum + list.length, 0));
  let n = 0;
  for (const list of lists)
    for (let i = 0; i < list.length; ++i) lines[n++] = x(list[i]), lines[n++] = y(list[i]);
  return lines;
}

function linesOfUnmet() {
  const ends = [];
  for (const t of unmet)
    for (let k = 0; k < 3; ++k) ends.push(triangles[3 * t + k], triangles[3 * t + (k + 1) % 3]);
  return linesOf(ends);
}

// A bit for each square, children after their parent (southwest, northwest, southeast, northeast): whether it is
// split. Each edge between leaves is the left or lower one of exactly one leaf.
function linesOfQuadtree() {
  const bits = array('quadtree'), root = head.quadtree, open = [root.x * unit, root.y * unit, root.side * unit];
  let splits = 0, next = 0, n = 0;
  for (const byte of bits)
    for (let rest = byte; rest; rest &= rest - 1) ++splits;
  const lines = new Float64Array(8 * (3 * splits + 1) + 8);
  const add = (x0, y0, x1, y1) => { lines[n++] = x0, lines[n++] = y0, lines[n++] = x1, lines[n++] = y1; };
  const right = open[0] + open[2], top = open[1] + open[2];
  add(right, open[1], right, top);
  add(open[0], top, right, top);
  while (open.length) {
    const side = open.pop(), v = open.pop(), u = open.pop(), half = side / 2;
    const isSplit = bits[next >> 3] >> (next & 7) & 1;
    ++next;
    if (isSplit)
      open.push(u + half, v + half, half, u + half, v, half, u, v + half, half, u, v, half);
    else
      add(u, v, u + side, v), add(u, v, u, v + side);
  }
  return lines;
}
)js";

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_PAGE_PAGE_MODEL_H
