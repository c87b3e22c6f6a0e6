// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_PAGE_PAGE_STYLE_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_PAGE_PAGE_STYLE_H

#include <string_view>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// What the page consists of besides scripts and numbers: its style and its elements.
inline constexpr std::string_view page_style = R"css(
* { box-sizing: border-box; margin: 0; }
html, body { height: 100%; overflow: hidden; background: #fbfcfd; }
body {
  font: 13px/1.5 system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, sans-serif;
  color: #12263a; font-variant-numeric: tabular-nums;
}
canvas { position: fixed; inset: 0; width: 100%; height: 100%; }
#overlay { cursor: crosshair; touch-action: none; outline: none; }
#overlay:active { cursor: grabbing; }
#head-line, #panel, #buttons, #status { z-index: 1; }
#tip { z-index: 2; }
[hidden] { display: none !important; }
#head-line {
  position: fixed; left: 16px; top: 14px; max-width: calc(100% - 300px); padding: 2px 8px; pointer-events: none;
  background: #fbfcfdd9; border-radius: 6px;
}
h1 { font-size: 17px; font-weight: 600; letter-spacing: -.01em; overflow-wrap: anywhere; }
#counts { color: #51667a; }
#counts > *:not(:last-child)::after { content: "\b7"; margin: 0 .5em; color: #9fb0bf; display: inline-block; }
button { font: inherit; color: inherit; background: none; border: 0; padding: 0; cursor: pointer; }
#counts button { pointer-events: auto; }
#counts button:hover, #next:hover { color: #1f6fb2; text-decoration: underline; }
.badge { color: #d6006c; font-weight: 600; }
#panel, #tip, #buttons {
  position: fixed; background: #fffffffa; border: 1px solid #d9e2ea; border-radius: 10px;
  box-shadow: 0 1px 2px #12263a14, 0 6px 20px #12263a14;
}
#panel { right: 14px; top: 14px; width: 272px; max-height: calc(100% - 28px); padding: 10px 15px; overflow: auto; }
#panel:not([open]) { width: auto; }
summary { cursor: pointer; font-weight: 600; color: #51667a; list-style: none; text-align: right; line-height: 1; }
summary::-webkit-details-marker { display: none; }
summary::after { content: "\2013"; padding: 0 3px; }
#panel:not([open]) summary::after { content: "\2261"; font-size: 18px; }
#panel[open] summary { height: 0; position: relative; z-index: 1; }
.row { display: flex; align-items: center; gap: 8px; min-height: 26px; }
.row > :last-child:not(:first-child) { margin-left: auto; }
select {
  font: inherit; color: inherit; background: #fff; border: 1px solid #c9d5df; border-radius: 6px; padding: 2px 6px;
}
#head-of-panel { justify-content: flex-start; padding-right: 20px; }
#head-of-panel select { margin-left: 0; }
input { accent-color: #2a6f9e; margin: 0; width: 14px; height: 14px; }
.row label { display: flex; align-items: center; gap: 8px; cursor: pointer; }
kbd { font: 11px/1 ui-monospace, Menlo, Consolas, monospace; color: #7c8ea0; border: 1px solid #dde5ec;
  border-radius: 4px; padding: 2px 5px; }
#legend { margin: 10px 0 6px; }
#legend svg { display: block; width: 100%; overflow: visible; }
#legend text { font-size: 10.5px; fill: #51667a; }
#legend .over { fill: transparent; }
#legend .over:hover { fill: #12263a1a; }
#legend ul { list-style: none; padding: 0; max-height: 220px; overflow: auto; }
#legend li { display: flex; align-items: center; gap: 8px; }
#legend i { width: 13px; height: 13px; border-radius: 3px; border: 1px solid #12263a33; }
#legend li > span:last-child { margin-left: auto; color: #51667a; padding-right: 4px; }
#hints { margin-top: 8px; padding-top: 8px; border-top: 1px solid #e6edf2; color: #7c8ea0; font-size: 11.5px; }
#note { margin-top: 6px; color: #51667a; font-size: 11.5px; }
#next { margin-left: auto; color: #51667a; }
#tip { left: 0; top: 0; padding: 9px 13px 10px; pointer-events: none; max-width: calc(100% - 16px); }
#tip h2 { font-size: 13px; font-weight: 600; }
#tip .badge { margin-left: 8px; }
#tip dl { display: grid; grid-template-columns: auto 1fr; gap: 0 14px; margin: 4px 0; }
dt { color: #51667a; }
dd { text-align: right; }
#tip table { border-top: 1px solid #e6edf2; border-spacing: 0; width: 100%; }
#tip table::before { content: ""; display: block; height: 4px; }
#tip td { padding: 0 0 0 14px; text-align: right; font-size: 12px; }
#tip th { font-weight: 400; color: #51667a; text-align: right; font-size: 12px; padding: 0; }
#tip th:first-child { text-align: left; }
#tip td:first-child { padding: 0; color: #51667a; text-align: left; }
#status {
  position: fixed; left: 20px; bottom: 16px; display: flex; align-items: flex-end; gap: 18px; pointer-events: none;
  color: #33485c; white-space: pre;
}
#scale { border: 1.5px solid #33485c; border-top: 0; text-align: center; font-size: 11px; line-height: 1.35; }
#place, #scale { text-shadow: 0 0 3px #fff, 0 0 3px #fff, 0 0 5px #fff; }
#buttons { right: 14px; bottom: 14px; display: flex; flex-direction: column; overflow: hidden; }
#buttons button { width: 34px; height: 32px; font-size: 17px; line-height: 1; color: #33485c; }
#buttons button + button { border-top: 1px solid #e6edf2; }
#buttons svg { width: 13px; fill: none; stroke: currentColor; stroke-width: 1.5; vertical-align: middle; }
#buttons button:hover { background: #eef4f8; }
@media (max-width: 640px) {
  #head-line { max-width: calc(100% - 76px); }
  #hints { display: none; }
}
)css";

inline constexpr std::string_view page_body = R"html(
<div id="counts"></div>
</header>
<canvas id="mesh"></canvas>
<canvas id="overlay" tabindex="0" role="img" aria-label="the mesh"></canvas>
<details id="panel" open>
<summary title="controls" aria-label="controls"></summary>
<div class="row" id="head-of-panel"><label for="color">color by</label>
<select id="color">
<option value="least_angle">least angle</option>
<option value="largest_angle">largest angle</option>
<option value="size">longest edge</option>
<option value="region">region</option>
<option value="none">nothing</option>
</select></div>
<div id="legend"></div>
<div class="row"><label><input type="checkbox" id="show-edges">edges</label><kbd>e</kbd></div>
<div class="row"><label><input type="checkbox" id="show-segments">segments</label><kbd>s</kbd></div>
<div class="row" id="row-quadtree"><label><input type="checkbox" id="show-quadtree">quadtree</label><kbd>q</kbd></div>
<div class="row" id="row-unmet"><label><input type="checkbox" id="show-unmet">unmet
<span id="number-unmet" class="badge"></span></label><button id="next">show next</button><kbd>u</kbd></div>
<p id="note">Coordinates are those of the input. Angles, lengths and areas are those of the plane drawn.</p>
<p id="hints">drag to move, wheel to zoom; <kbd>+</kbd> <kbd>&minus;</kbd> <kbd>0</kbd> zoom and fit,
<kbd>c</kbd> next color</p>
</details>
<div id="buttons">
<button id="zoom-in" title="zoom in (+)" aria-label="zoom in">+</button>
<button id="zoom-out" title="zoom out (-)" aria-label="zoom out">&minus;</button>
<button id="fit" title="fit (0)" aria-label="fit"><svg viewBox="0 0 14 14">
<path d="M1 5V1h4M9 1h4v4M13 9v4H9M5 13H1V9"/></svg></button>
</div>
<footer id="status"><div id="scale" hidden></div><div id="place"></div></footer>
<div id="tip" hidden></div>
)html";

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_PAGE_PAGE_STYLE_H
