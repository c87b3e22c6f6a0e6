// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// The cells of segments in squares against the arrangements of the kernel.

#include "catch.h"
#include "random_pslg.h"

#include <CGAL/Quadtree_mesh_2/internal/base/Long_words.h>
#include <CGAL/Quadtree_mesh_2/internal/pieces/Grid_path.h>
#include <CGAL/Quadtree_mesh_2/internal/pieces/leaf_cells.h>

#include <CGAL/Arr_segment_traits_2.h>
#include <CGAL/Arrangement_with_history_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace test_leaf_cells {

using CGAL::Quadtree_mesh_2::Grid_point_2;
using CGAL::Quadtree_mesh_2::internal::Grid_path;
using CGAL::Quadtree_mesh_2::internal::Leaf_cells;
using CGAL::Quadtree_mesh_2::internal::Long_word;

namespace {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Point = Kernel::Point_2;
using Segment = Kernel::Segment_2;
using Arrangement = CGAL::Arrangement_with_history_2<CGAL::Arr_segment_traits_2<Kernel>>;

using Grid_point = Grid_point_2<std::uint64_t>;
using Ends = std::array<Grid_point, 2>;
using Pairs = std::set<std::pair<std::uint32_t, std::uint32_t>>;

struct Square {
  Grid_point low;
  std::uint64_t side;
};

Point exact(const Grid_point& p) { return Point(static_cast<double>(p.x), static_cast<double>(p.y)); }
Segment exact(const Ends& s) { return Segment(exact(s[0]), exact(s[1])); }

/// Whether segments meet in no point but common ends.
bool are_compatible(const Ends& s, const Ends& t) {
  const auto is_end = [](const Ends& of, const Grid_point& p) { return p == of[0] || p == of[1]; };
  const Segment a = exact(s), b = exact(t);
  for (std::size_t i = 0; i < 2; ++i)
    if ((!is_end(t, s[i]) && b.has_on(exact(s[i]))) || (!is_end(s, t[i]) && a.has_on(exact(t[i]))))
      return false;
  if (is_end(t, s[0]) || is_end(t, s[1])) return !(is_end(t, s[0]) && is_end(t, s[1]));
  return !CGAL::do_intersect(a, b);
}

void add_if_compatible(std::vector<Ends>& segments, const Ends& s) {
  for (const Ends& t : segments)
    if (!are_compatible(s, t)) return;
  segments.push_back(s);
}

/// What of a segment is in a closed square.
struct Clipped {
  bool is_segment = false;
  bool reaches_side = false;
  Segment segment;
};

Clipped clipped(const Ends& s, const Square& square) {
  const Grid_point high{square.low.x + square.side, square.low.y + square.side};
  const Kernel::Iso_rectangle_2 box(exact(square.low), exact(high));
  Clipped result;
  if (s[0] == s[1]) return result;
  const auto meeting = CGAL::intersection(box, exact(s));
  if (!meeting) return result;
  using boost::get;
  using std::get_if;
#if CGAL_VERSION_MAJOR >= 6
  const Segment* part = get_if<Segment>(&*meeting);
#else
  const Segment* part = get<Segment>(&*meeting);
#endif
  if (part == nullptr) return result;
  result = {true, box.has_on_boundary(part->source()) || box.has_on_boundary(part->target()), *part};
  return result;
}

/// Pairs of segments that bound a common face of the arrangement in the square.
Pairs expected_pairs(const std::vector<Clipped>& segments, const Square& square) {
  Arrangement arrangement;
  const Grid_point l = square.low, h{l.x + square.side, l.y + square.side};
  const Point corner[4] = {exact(l), exact(Grid_point{h.x, l.y}), exact(h), exact(Grid_point{l.x, h.y})};
  for (int i = 0; i < 4; ++i)
    CGAL::insert(arrangement, Arrangement::Curve_2(Segment(corner[i], corner[(i + 1) % 4])));
  std::map<const void*, std::uint32_t> number;
  for (std::uint32_t i = 0; i < segments.size(); ++i)
    if (segments[i].is_segment)
      number[&*CGAL::insert(arrangement, Arrangement::Curve_2(segments[i].segment))] = i;
  Pairs pairs;
  for (auto f = arrangement.faces_begin(); f != arrangement.faces_end(); ++f) {
    if (f->is_unbounded()) continue;
    std::set<std::uint32_t> cell;
    const auto collect = [&](auto circulator) {
      const auto first = circulator;
      do {
        for (auto c = arrangement.originating_curves_begin(circulator);
             c != arrangement.originating_curves_end(circulator); ++c) {
          const auto found = number.find(&*c);
          if (found != number.end()) cell.insert(found->second);
        }
      } while (++circulator != first);
    };
    for (auto b = f->outer_ccbs_begin(); b != f->outer_ccbs_end(); ++b) collect(*b);
    for (auto b = f->inner_ccbs_begin(); b != f->inner_ccbs_end(); ++b) collect(*b);
    for (const std::uint32_t i : cell)
      for (const std::uint32_t j : cell)
        if (i < j) pairs.insert({i, j});
  }
  return pairs;
}

template <class Word>
Pairs pairs_of(const std::vector<Ends>& segments, const Square& square) {
  const auto converted = [](const Grid_point& p) { return Grid_point_2<Word>{Word(p.x), Word(p.y)}; };
  std::vector<typename Leaf_cells<Word>::Ends> ends;
  for (const Ends& s : segments) ends.push_back({{converted(s[0]), converted(s[1])}});
  Pairs pairs;
  Leaf_cells<Word>().for_each_pair(converted(square.low), Word(square.side), ends,
                                   [&](std::uint32_t i, std::uint32_t j) {
                                     pairs.insert({i, j});
                                   });
  return pairs;
}

/// The segments with a point in the half-open square.
std::vector<Ends> in_square(const std::vector<Ends>& segments, const Square& square) {
  std::vector<Ends> result;
  for (const Ends& s : segments) {
    const Grid_path<std::uint64_t> path(s[0], s[1]);
    if (!path.is_empty(path.inside(path.whole(), square.low, static_cast<std::int64_t>(square.side))))
      result.push_back(s);
  }
  return result;
}

void check_square(const std::vector<Ends>& all, const Square& square) {
  const std::vector<Ends> segments = in_square(all, square);
  std::vector<Clipped> parts;
  for (const Ends& s : segments) parts.push_back(clipped(s, square));
  const Pairs expected = expected_pairs(parts, square), found = pairs_of<std::uint64_t>(segments, square);
  CAPTURE(square.low, square.side, segments.size());
  REQUIRE(std::includes(found.begin(), found.end(), expected.begin(), expected.end()));
  if (std::all_of(parts.begin(), parts.end(), [](const Clipped& c) { return c.reaches_side; }))
    REQUIRE(found == expected);
  REQUIRE(found == pairs_of<Long_word>(segments, square));
}

constexpr int log_size = 10;

void check_squares(const std::vector<Ends>& segments, random_pslg::Random& random, int times) {
  for (; times > 0; --times) {
    const int log_side = std::max(random.integer(3, log_size), random.integer(0, log_size));
    const auto corner = [&] {
      return static_cast<std::uint64_t>(random.integer(0, (1 << (log_size - log_side)) - 1)) << log_side;
    };
    check_square(segments, {{corner(), corner()}, std::uint64_t(1) << log_side});
  }
}

/// Random segments between points whose coordinates are multiples of a unit; some share ends.
std::vector<Ends> random_segments(random_pslg::Random& random, int count, int log_unit) {
  std::vector<Ends> segments;
  const auto point = [&] {
    const int most = (1 << (log_size - log_unit)) - 1;
    return Grid_point{static_cast<std::uint64_t>(random.integer(0, most)) << log_unit,
                      static_cast<std::uint64_t>(random.integer(0, most)) << log_unit};
  };
  for (; count > 0; --count) {
    const bool is_linked = !segments.empty() && random.integer(0, 2) == 0;
    const Grid_point a =
        is_linked ? segments[std::size_t(random.integer(0, static_cast<int>(segments.size()) - 1))][1]
                  : point();
    const Grid_point b = point();
    if (a != b) add_if_compatible(segments, {{a, b}});
  }
  return segments;
}

Pairs pairs_in(const Square& square, const std::vector<Ends>& segments) {
  check_square(segments, square);
  return pairs_of<std::uint64_t>(segments, square);
}

} // namespace

TEST_CASE("cells of random segments are those of the arrangement", "[leaf_cells]") {
  random_pslg::Random random(1);
  for (int i = 0; i < (is_full_run() ? 300 : 100); ++i)
    check_squares(random_segments(random, random.integer(1, 60), random.integer(0, 3) * 2), random, 10);
}

TEST_CASE("cells of random segments: sweep", "[leaf_cells][.slow]") {
  random_pslg::Random random(2);
  for (int i = 0; i < 3000; ++i)
    check_squares(random_segments(random, random.integer(1, 100), random.integer(0, 8)), random, 20);
}

TEST_CASE("cells of fans", "[leaf_cells]") {
  random_pslg::Random random(3);
  for (const Grid_point center : {Grid_point{512, 512}, Grid_point{500, 333}, Grid_point{512, 300}}) {
    std::vector<Ends> segments;
    for (int i = 0; i < 360; i += is_full_run() ? 1 : 2) {
      const auto at = [&](std::uint64_t c, double d) {
        return static_cast<std::uint64_t>(std::llround(static_cast<double>(c) + 250 * d));
      };
      const double angle = i * CGAL_PI / 180;
      add_if_compatible(segments, {{center, {at(center.x, std::cos(angle)), at(center.y, std::sin(angle))}}});
    }
    check_squares(segments, random, is_full_run() ? 10 : 3);
    const Square around{{256, 256}, 256};
    check_square(segments, around);
    const std::vector<Ends> met = in_square(segments, around);
    if (center == Grid_point{500, 333}) // all leave the square: sectors are cells
      REQUIRE(pairs_of<std::uint64_t>(met, around).size() <= 3 * met.size());
  }
}

TEST_CASE("cells of few segments", "[leaf_cells]") {
  const Square square{{8, 8}, 8};
  REQUIRE(pairs_in(square, {}).empty());
  REQUIRE(pairs_in(square, {{{{0, 0}, {30, 30}}}}).empty());
  // Four chords that cut off the corners bound the cell between them; only neighbors follow each other.
  REQUIRE(
      pairs_in(square,
               {{{{8, 11}, {11, 8}}}, {{{13, 8}, {16, 11}}}, {{{16, 13}, {13, 16}}}, {{{11, 16}, {8, 13}}}})
          .size() == 6);
  // Parallel chords are seen by the next ones alone.
  REQUIRE(pairs_in(square, {{{{0, 9}, {20, 9}}}, {{{0, 11}, {20, 11}}}, {{{0, 13}, {20, 13}}}}) ==
          Pairs{{0, 1}, {1, 2}});
  // Along the lower side, and one that ends at it.
  REQUIRE(pairs_in(square, {{{{0, 8}, {20, 8}}}, {{{9, 12}, {20, 30}}}}) == Pairs{{0, 1}});
  // Points: a segment that touches the lower left corner, and one without extent.
  REQUIRE(pairs_in(square, {{{{4, 12}, {12, 4}}}, {{{9, 30}, {9, 12}}}}) == Pairs{{0, 1}});
  REQUIRE(pairs_in(square, {{{{9, 9}, {9, 9}}}, {{{9, 30}, {9, 12}}}}) == Pairs{{0, 1}});
  // An end on the left side with segments to both sides.
  REQUIRE(pairs_in(square, {{{{8, 12}, {4, 12}}}, {{{8, 12}, {12, 13}}}}) == Pairs{{0, 1}});
}

} // namespace test_leaf_cells
