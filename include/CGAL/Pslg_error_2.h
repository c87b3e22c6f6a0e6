// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef CGAL_PSLG_ERROR_2_H
#define CGAL_PSLG_ERROR_2_H

#include <CGAL/Quadtree_mesh_2/Index.h>

#include <array>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

// What is thrown for graphs that cannot be read, checked, repaired or meshed.

namespace CGAL {

/// \ingroup PkgQuadtreeMesh2Meshers
/// Parts of a graph, by their indices.
struct Pslg_parts_2 {
  std::vector<Quadtree_mesh_2::Vertex_index> vertices;  ///< indices in `Pslg_2::vertices`
  std::vector<Quadtree_mesh_2::Segment_index> segments; ///< indices in `Pslg_2::segments`
  std::vector<std::size_t> holes;                       ///< indices in `Pslg_2::holes`
  std::vector<std::size_t> regions;                     ///< indices in `Pslg_2::regions`
  /// indices in `Indexed_mesh_2::triangles`, of a mesh that is given
  std::vector<Quadtree_mesh_2::Triangle_index> triangles;
  std::vector<std::size_t> seeds; ///< places in the range of seeds that goes with a CGAL triangulation

  /// \name Setters
  /// @{

  /// Adds a vertex, and returns the object, so that calls can be chained.
  Pslg_parts_2& vertex(Quadtree_mesh_2::Vertex_index v) { return vertices.push_back(v), *this; }
  /// Adds a segment.
  Pslg_parts_2& segment(Quadtree_mesh_2::Segment_index s) { return segments.push_back(s), *this; }
  /// Adds a hole.
  Pslg_parts_2& hole(std::size_t h) { return holes.push_back(h), *this; }
  /// Adds a region.
  Pslg_parts_2& region(std::size_t r) { return regions.push_back(r), *this; }
  /// Adds a triangle.
  Pslg_parts_2& triangle(Quadtree_mesh_2::Triangle_index t) { return triangles.push_back(t), *this; }
  /// Adds a seed.
  Pslg_parts_2& seed(std::size_t s) { return seeds.push_back(s), *this; }
  /// @}
};

/// \ingroup PkgQuadtreeMesh2Meshers
/// A graph cannot be read or meshed. `what()` names the vertex, segment or line at fault.
class Pslg_error_2 : public std::runtime_error {
public:
  /// What is wrong, which parts of the graph `parts()` has, and what to do about it.
  enum class Kind {
    /// A file cannot be opened or read, or breaks the rules of its format. No parts: `what()` begins with the
    /// name of the file and, where it is known, the line. Correct the file.
    UNREADABLE_FILE,
    /// Arrays of the graph have lengths that do not fit together, or matrices a wrong number of columns, or
    /// there is more than 32-bit indices can name. No parts. Correct the program that fills the graph.
    ARRAY_LENGTH,
    /// An end of a segment is not the index of a vertex. The segment. Correct the index.
    NO_SUCH_VERTEX,
    /// A coordinate is not a finite number, or neither is an attribute or area bound of a region. The vertex,
    /// hole or region. Correct the number.
    NOT_FINITE,
    /// A coordinate is beyond the limits of the arithmetic, or next to 0 in a way that doubles cannot scale.
    /// The vertex, hole or region; two vertices if these are too far apart. Scale or move the input, or use
    /// exact numbers.
    OUT_OF_RANGE,
    /// No three vertices span a triangle. Two vertices whose line has all others; one if all are at one place;
    /// none if there are none. There is nothing to mesh.
    NO_AREA,
    /// A segment has both ends at one place. The segment and its ends. Only `validate_pslg_2()` minds.
    ZERO_LENGTH,
    /// Two segments cross without a common vertex. Both segments, or the one that is known. Split them, by
    /// `repair_pslg_2()` for example.
    CROSSING,
    /// Features are nearer to each other than the arithmetic can tell, or hold apart. Two or three vertices,
    /// or what else is too near: segments, a hole or a region. Merge them, or use exact numbers.
    TOO_NEAR,
    /// The point of a hole or region does not tell its component: it is on the border of several. The hole,
    /// region or seed, and the vertex or segment that it is on, except for seeds. Move the point.
    AMBIGUOUS_SEED,
    /// Nothing is left to mesh: segments enclose nothing, or holes and the rule of the domain leave nothing.
    /// The first vertex at which a single segment ends, and the nearest other one of these, if there are any.
    /// Close the border there, or choose another `Quality_mesh_options_2::Domain`.
    NO_DOMAIN,
    /// The mesh would surely have more vertices than the budget or the memory allows. The two segments that
    /// ask for most of its triangles; none if bounds of size do. Remove the gap between them, pass over it by
    /// `min_edge()`, or raise the bounds.
    TOO_MANY_TRIANGLES,
    /// What is given as a mesh, to be refined or adapted, is none: triangles name vertices that do not exist, are
    /// clockwise or flat, overlap, or share an edge on one side; or the mesh is not one of its graph. One or two
    /// triangles, or the vertices at fault. Correct what makes the mesh.
    INVALID_MESH,
    /// Coordinates have no room for the result: rounding would put vertices of the mesh, or crossings, on each
    /// other or beyond edges. The vertices of the graph at such a place, where it is known; the two segments if
    /// it is their crossing. Merge what is only a few units in the last place apart, or move the input nearer to
    /// the origin.
    ROUNDING
  };

  /// An error of a kind.
  /// \param kind the kind of error
  /// \param text the text of `what()`
  /// \param parts those that the text names, in its order
  Pslg_error_2(Kind kind, const std::string& text, Pslg_parts_2 parts = {})
      : std::runtime_error(text), kind_(kind), parts_(std::move(parts)) {}

  /// What is wrong.
  Kind kind() const { return kind_; }
  /// The parts of the graph that are at fault, counted from 0, in the order in which `what()` names them.
  const Pslg_parts_2& parts() const { return parts_; }

private:
  Kind kind_;
  Pslg_parts_2 parts_;
};

/// \ingroup PkgQuadtreeMesh2Meshers
/// Two segments cross. Callers that know the vertices by other coordinates than the mesher can name them by
/// index.
class Pslg_crossing_error_2 : public Pslg_error_2 {
public:
  /// The error of two segments that cross.
  /// \param text the text of `what()`
  /// \param crossing the crossing segments
  Pslg_crossing_error_2(const std::string& text, std::array<Quadtree_mesh_2::Segment_index, 2> crossing)
      : Pslg_error_2(Kind::CROSSING, text, Pslg_parts_2().segment(crossing[0]).segment(crossing[1])),
        segments(crossing) {}

  std::array<Quadtree_mesh_2::Segment_index, 2> segments; ///< their indices in the graph
};

/// \ingroup PkgQuadtreeMesh2Meshers
/// Two segments face each other across a gap so narrow that the mesh would be too large. Callers can name the
/// segments by index.
class Pslg_gap_error_2 : public Pslg_error_2 {
public:
  /// The texts make up `what()`: first `of_mesh`, then `of_segments`.
  Pslg_gap_error_2(const std::string& of_mesh, const std::string& of_segments,
                   std::array<Quadtree_mesh_2::Segment_index, 2> facing, double width)
      : Pslg_error_2(Kind::TOO_MANY_TRIANGLES, of_mesh + ' ' + of_segments,
                     Pslg_parts_2().segment(facing[0]).segment(facing[1])),
        demand(of_mesh), segments(facing), distance(width) {}

  std::string demand;                                     ///< the text about the size of the mesh
  std::array<Quadtree_mesh_2::Segment_index, 2> segments; ///< their indices in the graph
  double distance;                                        ///< the distance between them
};

/// \ingroup PkgQuadtreeMesh2Meshers
/// The point of a hole or region lies on a segment, or on a vertex with segments, between several components
/// of the plane. It does not tell which one is meant.
class Pslg_seed_error_2 : public Pslg_error_2 {
public:
  /// What the point marks.
  enum class Mark {
    HOLE,  ///< a component that is not meshed
    REGION ///< a component with an attribute and a bound of area
  };

  /// The error of a point between components.
  /// \param text the text of `what()`; the other parameters become the members.
  Pslg_seed_error_2(const std::string& text, Mark of, std::size_t number, Quadtree_mesh_2::Vertex_index at,
                    Quadtree_mesh_2::Segment_index on)
      : Pslg_error_2(Kind::AMBIGUOUS_SEED, text, parts_of(of, number, at, on)), mark(of), seed(number),
        vertex(at), segment(on) {}

  Mark mark;                              ///< what the point marks
  std::size_t seed;                       ///< its index in `Pslg_2::holes` or `Pslg_2::regions`
  Quadtree_mesh_2::Vertex_index vertex;   ///< the vertex that it is on; invalid inside a segment
  Quadtree_mesh_2::Segment_index segment; ///< the segment that it is on; invalid on a vertex

private:
  static Pslg_parts_2 parts_of(Mark of, std::size_t number, Quadtree_mesh_2::Vertex_index at,
                               Quadtree_mesh_2::Segment_index on) {
    Pslg_parts_2 parts;
    of == Mark::HOLE ? parts.hole(number) : parts.region(number);
    return at.is_valid() ? parts.vertex(at) : parts.segment(on);
  }
};

} // namespace CGAL

#endif // CGAL_PSLG_ERROR_2_H
