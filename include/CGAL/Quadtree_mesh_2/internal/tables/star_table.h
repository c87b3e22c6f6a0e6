// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// How to move a corner of the grid to a given point so that the eight edges there keep their directions.
//
// Let p be a point, c a nearest corner of its leaf, and d = p - c. So |d_x| and |d_y| are at most half a
// side. Let the 4 x 4 squares around c be leaves of the same size that all have the plain tile, tile(0). The
// edges of these tiles at c go into the eight compass directions. The corner and its eight neighbors, the
// spokes, are translated by d. Each other vertex inside the block goes to base + offset + A d, as in
// warp_table.h. Vertices on the boundary of the block stay.
//
// A tiny octagon around p, with sides across the spokes, can then take the place of the corner
// (collar_table.h).
//
// Bound:    For each such d, all angles in the block are between 18.3 and 87.5 degrees, if vertices are at
//           these places exactly.
// Source:   Bern, Eppstein, Teng, section 5, Theorem 4, treats a cluster of points as a single point of the
//           quadtree around it. The paper leaves the joint between the two to "local rules". This is one of
//           them. The table was found by optimization. test_tile_certificates.cpp proves the bound.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_TABLES_STAR_TABLE_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_TABLES_STAR_TABLE_H

#include <CGAL/Quadtree_mesh_2/internal/tables/warp_table.h>

#include <array>
#include <cstdint>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

struct Warped_star {
  /// All vertices within the block of 4 x 4 squares, the corner in its middle and the spokes among them;
  /// coordinates are relative to that corner, the unit is 1/1024 of the side of a square.
  std::array<Warped_vertex, 97> vertices;
  /// The eight neighbors of the corner, counterclockwise from the east, before they are translated.
  std::array<std::array<std::int16_t, 2>, 8> spokes;
};

namespace star_table {

inline constexpr Warped_star star{
    {{{-1024, -1536, 135, -18, 244, -13, 118, 319},
      {-1024, -1024, 19, 15, 598, 122, 97, 612},
      {-1536, -1024, -2, 131, 348, 113, 3, 223},
      {-1363, -1363, 17, 0, 310, -3, 0, 268},
      {-1709, -1709, -41, -38, 58, -6, -5, 63},
      {-1410, -1662, 31, 37, 264, 15, 54, 235},
      {-1662, -1410, 21, 10, 229, 22, 11, 219},
      {0, -1536, -83, -3, 437, 157, -16, 284},
      {0, -1024, -9, 30, 688, 128, 83, 807},
      {-512, -1024, 40, 27, 628, 157, 237, 699},
      {-339, -1363, 71, -107, 399, 12, 62, 308},
      {-685, -1709, -51, 82, 285, 86, 52, 297},
      {-386, -1662, 79, 32, 356, 15, 51, 305},
      {-638, -1410, -50, -38, 342, 98, 65, 294},
      {1024, -1536, 93, -31, 37, -27, -32, 262},
      {1024, -1024, -34, 34, 471, 66, 57, 486},
      {512, -1024, -70, 52, 691, 4, -128, 783},
      {685, -1363, 76, -76, 319, -37, -112, 302},
      {339, -1709, -53, 88, 381, 2, -94, 312},
      {638, -1662, 87, 57, 309, -36, -109, 297},
      {386, -1410, -80, -64, 417, 6, -116, 302},
      {1536, -1024, 15, -110, 292, -7, -5, 58},
      {1709, -1363, 81, -6, -34, -16, 132, 62},
      {1363, -1709, 66, -110, 34, -46, -32, 44},
      {1662, -1662, 59, -75, 10, -101, -77, 0},
      {1410, -1410, 47, 77, 276, -87, 46, 125},
      {-1024, -512, 60, 41, 680, 235, 136, 669},
      {-1024, 0, 31, 8, 783, 54, 130, 731},
      {-1536, 0, -1, 113, 344, 31, -74, 354},
      {-1363, -339, -77, 39, 328, 83, 21, 338},
      {-1709, -685, 91, -59, 318, 40, 110, 244},
      {-1410, -638, 1, -34, 323, 109, 111, 365},
      {-1662, -386, 50, 58, 317, 50, 20, 317},
      {0, -512, 0, 0, 1024, 0, 0, 1024},
      {0, 0, 0, 0, 1024, 0, 0, 1024},
      {-512, 0, 0, 0, 1024, 0, 0, 1024},
      {-339, -339, 0, 0, 1024, 0, 0, 1024},
      {-685, -685, 30, 30, 757, 187, 169, 807},
      {-386, -638, 38, -10, 960, 69, 102, 856},
      {-638, -386, -4, 37, 832, 135, 46, 969},
      {1024, -512, -54, 69, 789, -140, -28, 679},
      {1024, 0, -10, 27, 790, 81, 50, 670},
      {512, 0, 0, 0, 1024, 0, 0, 1024},
      {685, -339, 65, 13, 788, -89, 12, 787},
      {339, -685, -6, -53, 783, 28, -83, 816},
      {638, -638, 32, -15, 690, -142, -155, 730},
      {386, -386, 0, 0, 1024, 0, 0, 1024},
      {1536, 0, -5, 89, 308, -40, 112, 424},
      {1709, -339, -99, 48, 340, -106, -24, 359},
      {1363, -685, 46, -73, 341, -101, -29, 325},
      {1662, -638, -73, -86, 327, -112, -45, 294},
      {1410, -386, 50, 76, 342, -123, -20, 393},
      {-1024, 512, 65, -70, 766, -127, -2, 737},
      {-1024, 1024, 36, -32, 512, 35, 29, 508},
      {-1536, 1024, -22, 57, 318, -58, 19, 50},
      {-1363, 685, -64, 70, 344, -121, -44, 334},
      {-1709, 339, 103, -64, 339, -66, 39, 362},
      {-1410, 386, -50, -94, 318, -84, 42, 395},
      {-1662, 638, 74, 92, 337, -99, -22, 328},
      {0, 512, 0, 0, 1024, 0, 0, 1024},
      {0, 1024, -9, -43, 733, 137, 56, 794},
      {-512, 1024, 71, -59, 730, -1, -121, 772},
      {-339, 685, 1, 60, 807, 19, -87, 789},
      {-685, 339, -59, 5, 786, -90, 26, 812},
      {-386, 386, 0, 0, 1024, 0, 0, 1024},
      {-638, 638, -22, 29, 691, -163, -157, 695},
      {1024, 512, -40, -17, 668, 152, 91, 667},
      {1024, 1024, -33, 2, 604, 83, 122, 610},
      {512, 1024, -51, -50, 633, 147, 307, 730},
      {685, 685, -51, 0, 765, 137, 185, 796},
      {339, 339, 0, 0, 1024, 0, 0, 1024},
      {638, 386, 1, -32, 899, 95, 21, 910},
      {386, 638, -38, 10, 1016, 90, 153, 825},
      {1536, 1024, 6, -115, 312, 93, -43, 273},
      {1709, 685, -101, 59, 303, 20, 69, 304},
      {1363, 339, 105, -72, 313, 34, -14, 389},
      {1662, 386, -46, -85, 326, 24, 1, 349},
      {1410, 638, 38, 72, 275, 42, 59, 347},
      {-1024, 1536, -47, 25, 56, 18, -54, 326},
      {-1363, 1709, -69, 109, 27, -51, -32, 53},
      {-1709, 1363, -107, 73, 29, -61, -26, 44},
      {-1410, 1410, 22, -13, 156, -147, -143, 160},
      {-1662, 1662, -62, 63, 17, -86, -57, 45},
      {0, 1536, -106, 1, 360, -80, 34, 344},
      {-339, 1709, 66, -102, 365, 40, -63, 337},
      {-685, 1363, -62, 67, 337, -34, -113, 346},
      {-386, 1410, 94, 50, 399, 42, -82, 317},
      {-638, 1662, -86, -70, 321, -19, -88, 332},
      {1024, 1536, -141, 12, 206, 14, 121, 352},
      {685, 1709, 43, -87, 242, 115, 51, 306},
      {339, 1363, -33, 81, 327, 22, 94, 336},
      {638, 1410, 20, 9, 362, 110, 120, 343},
      {386, 1662, -51, -37, 300, 17, 41, 322},
      {1709, 1709, 40, 42, 59, -5, -9, 56},
      {1363, 1363, -13, -8, 247, -19, -14, 341},
      {1662, 1410, -37, -32, 243, 60, 15, 266},
      {1410, 1662, -27, -31, 231, -12, 34, 219}}},
    {{{512, 0}, {339, 339}, {0, 512}, {-386, 386}, {-512, 0}, {-339, -339}, {0, -512}, {386, -386}}}};

} // namespace star_table

inline constexpr const Warped_star& star() { return star_table::star; }

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_TABLES_STAR_TABLE_H
