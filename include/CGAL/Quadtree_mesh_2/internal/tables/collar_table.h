// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// The collar: the mesh between an octagon and a window of 5 x 5 equal squares. It is the outermost ring of a
// cluster of points.
//
// A cluster has a quadtree of its own. Its mesh is that of a window of 5 x 5 squares of equal size, its inner
// cells. The border of this mesh has the pattern LL of tile_tables.h: a vertex at the middle of each cell's
// outer side. The collar joins this border to an octagon. The octagon takes the place of a vertex in the mesh
// outside (star_table.h).
//
// The octagon. Its center is the origin, and its sides have normals in the eight compass directions. With t =
// 13/32, its vertices are
//   (R, -tR), (R, tR), (tR, R), (-tR, R), (-R, tR), (-R, -tR), (-tR, -R), (tR, -R).
// Here R is 10.8125 sides of an inner cell. In the mesh outside, it is rho sides of a leaf. Let i and i + 1,
// modulo 8, be vertices of the octagon. Then (i, spoke i, i + 1) and (i + 1, spoke i, spoke i + 1) are
// triangles. All 16 are acute for 0 < rho <= 1/5. So the leaf outside must have at least 5 R = 54.0625 times
// the side of an inner cell.
//
// The border. It is LL if every square that is split for another reason than balance across corners lies in
// the middle cell. Proof: squares that are split for the sake of balance touch a split square of half their
// side. By induction, and because squares are aligned, split squares of side 2 s reach at most 2 s beyond the
// middle cell. So do all squares of side s < 1 cell. Hence the 16 cells at the border are leaves, and nothing
// smaller touches the border.
//
// Bound:    All angles of the collar are between 17.3 and 81.4 degrees. It has 176 triangles.
// Source:   Bern, Eppstein, Teng, section 5, Theorem 4. The collar was found by optimization. A square would
//           not do instead of the octagon: a convex polygon without vertices inside its sides has an acute
//           triangulation only if it has five sides or more.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_TABLES_COLLAR_TABLE_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_TABLES_COLLAR_TABLE_H

#include <array>
#include <cstdint>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// Coordinates are in units of 1/1024 of the side of an inner cell, from the middle of the window.
struct Collar {
  static constexpr int units = 1024, cells_per_side = 5;
  static constexpr int number_of_vertices = 112, number_of_octagon_vertices = 8,
                       number_of_window_vertices = 40;
  static constexpr int number_of_triangles = 176;

  /// Distance of the octagon's sides from the origin, and half the length of the four sides parallel to the axes.
  static constexpr int octagon_radius = 11072, octagon_half_side = 4498;

  /// The octagon's, counterclockwise from the lower end of the side in the east; then those of the window,
  /// counterclockwise from its lower left corner; then those between.
  std::array<std::array<std::int16_t, 2>, number_of_vertices> vertices;
  std::array<std::array<std::uint8_t, 3>, number_of_triangles> triangles; ///< counterclockwise
};

namespace collar_table {

inline constexpr Collar collar{
    {{{11072, -4498},  {11072, 4498},  {4498, 11072},  {-4498, 11072}, {-11072, 4498}, {-11072, -4498},
      {-4498, -11072}, {4498, -11072}, {-2560, -2560}, {-2048, -2560}, {-1536, -2560}, {-1024, -2560},
      {-512, -2560},   {0, -2560},     {512, -2560},   {1024, -2560},  {1536, -2560},  {2048, -2560},
      {2560, -2560},   {2560, -2048},  {2560, -1536},  {2560, -1024},  {2560, -512},   {2560, 0},
      {2560, 512},     {2560, 1024},   {2560, 1536},   {2560, 2048},   {2560, 2560},   {2048, 2560},
      {1536, 2560},    {1024, 2560},   {512, 2560},    {0, 2560},      {-512, 2560},   {-1024, 2560},
      {-1536, 2560},   {-2048, 2560},  {-2560, 2560},  {-2560, 2048},  {-2560, 1536},  {-2560, 1024},
      {-2560, 512},    {-2560, 0},     {-2560, -512},  {-2560, -1024}, {-2560, -1536}, {-2560, -2048},
      {-1414, 2821},   {1414, 2821},   {-1414, -2821}, {1414, -2821},  {2821, -1414},  {-2821, 1414},
      {-2821, -1414},  {2821, 1414},   {-2961, 887},   {2961, 887},    {-2961, -887},  {2961, -887},
      {887, -2961},    {-887, 2961},   {-887, -2961},  {887, 2961},    {-1276, -3845}, {1276, -3845},
      {-1276, 3845},   {1276, 3845},   {-3845, -1276}, {3845, 1276},   {3845, -1276},  {-3845, 1276},
      {-1722, 2911},   {1722, 2911},   {-1722, -2911}, {1722, -2911},  {2911, -1722},  {-2911, 1722},
      {-2911, -1722},  {2911, 1722},   {3211, -2164},  {-3211, -2164}, {3211, 2164},   {-3211, 2164},
      {-2164, 3211},   {2164, -3211},  {2164, 3211},   {-2164, -3211}, {3337, -336},   {-3337, -336},
      {3337, 336},     {-3337, 336},   {-336, 3337},   {336, -3337},   {336, 3337},    {-336, -3337},
      {-1859, -4443},  {1859, -4443},  {-1859, 4443},  {1859, 4443},   {-4443, -1859}, {4443, 1859},
      {4443, -1859},   {-4443, 1859},  {5534, 0},      {-5534, 0},     {0, 5534},      {0, -5534},
      {3958, 3958},    {-3958, 3958},  {3958, -3958},  {-3958, -3958}}},
    {{{28, 27, 82},   {28, 82, 108},  {108, 82, 101}, {108, 101, 1},  {108, 1, 2},   {1, 101, 104},
      {1, 104, 0},    {104, 101, 69}, {104, 69, 90},  {104, 90, 88},  {88, 90, 23},  {23, 90, 24},
      {24, 90, 57},   {24, 57, 25},   {25, 57, 55},   {25, 55, 26},   {26, 55, 79},  {26, 79, 27},
      {27, 79, 82},   {82, 79, 69},   {82, 69, 101},  {69, 79, 55},   {69, 55, 57},  {69, 57, 90},
      {38, 83, 39},   {38, 109, 83},  {109, 103, 83}, {109, 4, 103},  {109, 3, 4},   {4, 105, 103},
      {4, 5, 105},    {105, 71, 103}, {105, 91, 71},  {105, 89, 91},  {89, 43, 91},  {43, 42, 91},
      {42, 56, 91},   {42, 41, 56},   {41, 53, 56},   {41, 40, 53},   {40, 77, 53},  {40, 39, 77},
      {39, 83, 77},   {83, 71, 77},   {83, 103, 71},  {71, 53, 77},   {71, 56, 53},  {71, 91, 56},
      {18, 80, 19},   {18, 110, 80},  {110, 102, 80}, {110, 0, 102},  {110, 7, 0},   {0, 104, 102},
      {104, 70, 102}, {104, 88, 70},  {23, 22, 88},   {22, 59, 88},   {22, 21, 59},  {21, 52, 59},
      {21, 20, 52},   {20, 76, 52},   {20, 19, 76},   {19, 80, 76},   {80, 70, 76},  {80, 102, 70},
      {70, 52, 76},   {70, 59, 52},   {70, 88, 59},   {8, 47, 81},    {8, 81, 111},  {111, 81, 100},
      {111, 100, 5},  {111, 5, 6},    {5, 100, 105},  {105, 100, 68}, {105, 68, 89}, {43, 89, 44},
      {44, 89, 58},   {44, 58, 45},   {45, 58, 54},   {45, 54, 46},   {46, 54, 78},  {46, 78, 47},
      {47, 78, 81},   {81, 78, 68},   {81, 68, 100},  {68, 78, 54},   {68, 54, 58},  {68, 58, 89},
      {28, 86, 29},   {28, 108, 86},  {108, 99, 86},  {108, 2, 99},   {2, 106, 99},  {2, 3, 106},
      {106, 67, 99},  {106, 94, 67},  {106, 92, 94},  {92, 33, 94},   {33, 32, 94},  {32, 63, 94},
      {32, 31, 63},   {31, 49, 63},   {31, 30, 49},   {30, 73, 49},   {30, 29, 73},  {29, 86, 73},
      {86, 67, 73},   {86, 99, 67},   {67, 49, 73},   {67, 63, 49},   {67, 94, 63},  {8, 87, 9},
      {8, 111, 87},   {111, 96, 87},  {111, 6, 96},   {6, 107, 96},   {6, 7, 107},   {107, 64, 96},
      {107, 95, 64},  {107, 93, 95},  {93, 13, 95},   {13, 12, 95},   {12, 62, 95},  {12, 11, 62},
      {11, 50, 62},   {11, 10, 50},   {10, 74, 50},   {10, 9, 74},    {9, 87, 74},   {87, 64, 74},
      {87, 96, 64},   {64, 50, 74},   {64, 62, 50},   {64, 95, 62},   {38, 37, 84},  {38, 84, 109},
      {109, 84, 98},  {109, 98, 3},   {3, 98, 106},   {106, 98, 66},  {106, 66, 92}, {33, 92, 34},
      {34, 92, 61},   {34, 61, 35},   {35, 61, 48},   {35, 48, 36},   {36, 48, 72},  {36, 72, 37},
      {37, 72, 84},   {84, 72, 66},   {84, 66, 98},   {66, 72, 48},   {66, 48, 61},  {66, 61, 92},
      {18, 17, 85},   {18, 85, 110},  {110, 85, 97},  {110, 97, 7},   {7, 97, 107},  {107, 97, 65},
      {107, 65, 93},  {13, 93, 14},   {14, 93, 60},   {14, 60, 15},   {15, 60, 51},  {15, 51, 16},
      {16, 51, 75},   {16, 75, 17},   {17, 75, 85},   {85, 75, 65},   {85, 65, 97},  {65, 75, 51},
      {65, 51, 60},   {65, 60, 93}}}};

} // namespace collar_table

inline constexpr const Collar& collar() { return collar_table::collar; }

/// The octagon: t = 13/32, and R in sides of an inner cell.
struct Octagon {
  static constexpr int number_of_vertices = 8;
  static constexpr double t = 13. / 32, radius_in_cells = 173. / 16;
  /// The largest R in sides of the leaf outside.
  static constexpr double max_radius_in_leaf_sides = 1. / 5;
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_TABLES_COLLAR_TABLE_H
