// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// Traits of arrangements of pieces of segments, each a few indices.
//
// This is a model of ArrangementTraits_2 that hands all predicates on to Piece_geometry.h. So it knows no
// coordinates, and exchanging x and y does not change the type. Input curves are pieces, which may be single
// points: isolated ones. Pieces may cross but not overlap.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_NEIGHBORS_PIECE_TRAITS_2_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_NEIGHBORS_PIECE_TRAITS_2_H

#include <CGAL/Arr_enums.h>
#include <CGAL/Arr_tags.h>
#include <CGAL/Quadtree_mesh_2/internal/base/compat.h>
#include <CGAL/Quadtree_mesh_2/internal/neighbors/Piece_geometry.h>
#include <CGAL/enum.h>
#include <CGAL/tags.h>

#include <cstddef>
#include <utility>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

template <class Point>
class Piece_traits_2 {
public:
  using Geometry = Piece_geometry<Point>;
  using Left_side_category = Arr_oblivious_side_tag;
  using Bottom_side_category = Arr_oblivious_side_tag;
  using Top_side_category = Arr_oblivious_side_tag;
  using Right_side_category = Arr_oblivious_side_tag;
  using Has_left_category = Tag_true;
  using Has_merge_category = Tag_false;
  using Has_do_intersect_category = Tag_false;
  using Multiplicity = std::size_t;

  struct Point_2 {
    Place place;
  };
  struct X_monotone_curve_2 : Segment_piece {
    X_monotone_curve_2() = default;
    X_monotone_curve_2(const Segment_piece& piece) : Segment_piece(piece) {}
  };
  /// A piece; a point if its ends are equal.
  struct Curve_2 : Segment_piece {
    explicit Curve_2(const Segment_piece& piece) : Segment_piece(piece) {}
  };

private:
  template <int (Geometry::*compare)(Place, Place) const>
  class Point_comparison {
  public:
    explicit Point_comparison(const Geometry& g) : g_(g) {}
    Comparison_result operator()(const Point_2& p, const Point_2& q) const {
      return static_cast<Comparison_result>((g_.*compare)(p.place, q.place));
    }

  private:
    const Geometry& g_;
  };

  template <int (Geometry::*compare)(const Segment_piece&, const Segment_piece&) const>
  class Piece_comparison {
  public:
    explicit Piece_comparison(const Geometry& g) : g_(g) {}
    Comparison_result operator()(const X_monotone_curve_2& c, const X_monotone_curve_2& d,
                                 const Point_2&) const {
      return static_cast<Comparison_result>((g_.*compare)(c, d));
    }

  private:
    const Geometry& g_;
  };

public:
  Piece_traits_2() = default;
  explicit Piece_traits_2(Geometry& geometry) : geometry_(&geometry) {}

  using Compare_x_2 = Point_comparison<&Geometry::compare_lines>;
  Compare_x_2 compare_x_2_object() const { return Compare_x_2(*geometry_); }

  using Compare_xy_2 = Point_comparison<&Geometry::compare>;
  Compare_xy_2 compare_xy_2_object() const { return Compare_xy_2(*geometry_); }

  struct Construct_min_vertex_2 {
    Point_2 operator()(const X_monotone_curve_2& c) const { return {c.left}; }
  };
  Construct_min_vertex_2 construct_min_vertex_2_object() const { return {}; }

  struct Construct_max_vertex_2 {
    Point_2 operator()(const X_monotone_curve_2& c) const { return {c.right}; }
  };
  Construct_max_vertex_2 construct_max_vertex_2_object() const { return {}; }

  struct Is_vertical_2 {
    bool operator()(const X_monotone_curve_2&) const { return false; }
  };
  Is_vertical_2 is_vertical_2_object() const { return {}; }

  class Compare_y_at_x_2 {
  public:
    explicit Compare_y_at_x_2(const Geometry& g) : g_(g) {}
    Comparison_result operator()(const Point_2& p, const X_monotone_curve_2& c) const {
      return static_cast<Comparison_result>(g_.side(p.place, c));
    }

  private:
    const Geometry& g_;
  };
  Compare_y_at_x_2 compare_y_at_x_2_object() const { return Compare_y_at_x_2(*geometry_); }

  using Compare_y_at_x_right_2 = Piece_comparison<&Geometry::compare_right>;
  Compare_y_at_x_right_2 compare_y_at_x_right_2_object() const { return Compare_y_at_x_right_2(*geometry_); }

  using Compare_y_at_x_left_2 = Piece_comparison<&Geometry::compare_left>;
  Compare_y_at_x_left_2 compare_y_at_x_left_2_object() const { return Compare_y_at_x_left_2(*geometry_); }

  class Equal_2 {
  public:
    explicit Equal_2(const Geometry& g) : g_(g) {}
    bool operator()(const Point_2& p, const Point_2& q) const { return g_.compare(p.place, q.place) == 0; }
    bool operator()(const X_monotone_curve_2& c, const X_monotone_curve_2& d) const {
      return g_.compare(c.left, d.left) == 0 && g_.compare(c.right, d.right) == 0 &&
             g_.compare_right(c, d) == 0;
    }

  private:
    const Geometry& g_;
  };
  Equal_2 equal_2_object() const { return Equal_2(*geometry_); }

  struct Make_x_monotone_2 {
    template <class Output_iterator>
    Output_iterator operator()(const Curve_2& c, Output_iterator out) const {
      using Result = Cgal_variant<Point_2, X_monotone_curve_2>;
      *out++ = c.left == c.right ? Result(Point_2{c.left}) : Result(X_monotone_curve_2(c));
      return out;
    }
  };
  Make_x_monotone_2 make_x_monotone_2_object() const { return {}; }

  struct Split_2 {
    void operator()(const X_monotone_curve_2& c, const Point_2& p, X_monotone_curve_2& left,
                    X_monotone_curve_2& right) const {
      left = right = c;
      left.right = right.left = p.place;
    }
  };
  Split_2 split_2_object() const { return {}; }

  class Intersect_2 {
  public:
    explicit Intersect_2(Geometry& g) : g_(g) {}
    template <class Output_iterator>
    Output_iterator operator()(const X_monotone_curve_2& c, const X_monotone_curve_2& d,
                               Output_iterator out) const {
      const Place p = g_.meeting(c, d);
      // Not as a variant of these types: CGAL 6 collects points of its own, made of these.
      if (p.is_valid()) *out++ = std::make_pair(Point_2{p}, Multiplicity(1));
      return out;
    }

  private:
    Geometry& g_;
  };
  Intersect_2 intersect_2_object() const { return Intersect_2(*geometry_); }

private:
  Geometry* geometry_ = nullptr;
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_NEIGHBORS_PIECE_TRAITS_2_H
