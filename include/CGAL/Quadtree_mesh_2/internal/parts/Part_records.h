// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// What parts of a mesh tell each other in rounds of blocks, record by record. Numbers have 64 bits, as there may be
// more triangles in all parts than 32-bit handles tell apart. A side is a number of a triangle, with its slot and its
// constraint bit. Coordinates are doubles.
//
// Nobody fills these in: Part_ledger.h counts them, by their size.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_PARTS_PART_RECORDS_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_PARTS_PART_RECORDS_H

#include <CGAL/Quadtree_mesh_2/Index.h>

#include <cstdint>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

using Part_id = Index<struct Part_tag>;

/// "Somebody at an acute corner waits."
struct Corner_request {
  std::uint64_t corner;
};

/// "Your triangle is in the zone." The side is that of your triangle from which it was reached, if it was.
struct Zone_mark {
  std::uint64_t side;
};

/// How many triangles of a square a part has.
struct Square_count {
  std::uint64_t key, level, triangles;
};

/// Who works on a square.
struct Square_worker {
  std::uint64_t key, level, part;
};

/// Where the triangle beyond a side of yours will be.
struct Future_owner {
  std::uint64_t side, part;
};

struct Triangle_record {
  std::uint64_t number, vertices[3], sides[3];
};
/// Goes with a triangle where regions have bounds of their own.
struct Region_record {
  std::uint64_t region;
};
/// Goes with a triangle that is sent: who will have the triangle beyond a side, if neither the sender nor the worker.
struct Owner_beyond {
  std::uint64_t side, part;
};

struct Vertex_record {
  std::uint64_t number;
  double x, y;
  std::uint64_t role; ///< whether it is free, or the input's, or its edge; and whether it is dirty
};

/// An acute corner, followed by its legs and sectors.
struct Corner_record {
  std::uint64_t corner, apex;
  double radius, least_angle;
  std::uint32_t legs, sectors;
};
/// A leg with the angle to the next one, followed by its shells.
struct Leg_record {
  std::uint64_t edge, apex, far, ring, apex_vertex;
  double length, angle;
  std::uint32_t before, after, shells, corner;
};
struct Shell_record {
  double radius;
  std::uint64_t vertex;
};
struct Sector_record {
  double angle, exempt_sin2, lock_radius;
  std::uint32_t right, left;
};

/// One half of a seam: which side of yours it is at, which one is beyond it now, and the place of the apex there.
struct Seam_half {
  std::uint64_t side, now;
  double x, y;
};

/// "Beyond your side there is another triangle now."
struct New_link {
  std::uint64_t side, beyond;
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_PARTS_PART_RECORDS_H
