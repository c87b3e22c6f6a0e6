#include "Word_map.h"
#include "mesh_graph_with.h"

#include <CGAL/Quadtree_mesh_2/Point_error.h>
#include <CGAL/Quadtree_mesh_2/internal/io/number_text.h>
#include <CGAL/Quadtree_mesh_2/internal/pslg/part_names.h>
#include <CGAL/round_mesh_2.h>
#include <CGAL/validate_pslg_2.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace {

using namespace mesh_in_words_internal;

using CGAL::Quadtree_mesh_2::Segment_index;
using CGAL::Quadtree_mesh_2::Vertex_index;
using CGAL::Quadtree_mesh_2::internal::hole_text;
using CGAL::Quadtree_mesh_2::internal::region_text;
using CGAL::Quadtree_mesh_2::internal::segment_text;
using CGAL::Quadtree_mesh_2::internal::vertex_text;
using Kind = CGAL::Pslg_error_2::Kind;
using mesh_graph::Point;

CGAL::Pslg_2<Word_point> to_words(const mesh_graph::Pslg& pslg, const Word_map<Point>& map) {
  CGAL::Pslg_2<Word_point> words;
  words.vertices.reserve(pslg.vertices.size());
  for (const Point& p : pslg.vertices) words.vertices.push_back(map.to_word(p));
  check_told_apart(pslg.vertices, words.vertices);
  words.vertex_markers = pslg.vertex_markers;
  words.number_of_vertex_attributes = pslg.number_of_vertex_attributes;
  words.vertex_attributes = pslg.vertex_attributes;
  words.segments = pslg.segments;
  words.first_number = pslg.first_number;
  words.segment_markers = pslg.segment_markers;
  for (const Point& p : pslg.holes) words.holes.push_back(map.to_word_inside_root(p));
  for (const auto& region : pslg.regions)
    words.regions.push_back(
        {map.to_word_inside_root(region.point), region.attribute, region.max_area / map.unit() / map.unit()});
  return words;
}

mesh_graph::Options to_words(mesh_graph::Options options, const Word_map<Point>& map) {
  const double unit = map.unit();
  if (options.size())
    options.size([map, field = options.size()](double x, double y) {
      using Word = std::uint64_t;
      const Point p = map.to_double(Word_point{static_cast<Word>(x), static_cast<Word>(y)});
      return field(p.x(), p.y()) / map.unit();
    });
  return options.max_edge(options.max_edge() / unit)
      .max_area(options.max_area() / unit / unit)
      .min_edge(options.min_edge() / unit);
}

/// The seeds of holes and regions, and what an error calls them.
struct Seed {
  Point point;
  std::string name;
  CGAL::Pslg_parts_2 part; // itself
};

std::vector<Seed> seeds_of(const mesh_graph::Pslg& pslg) {
  std::vector<Seed> seeds;
  for (std::size_t i = 0; i < pslg.holes.size(); ++i)
    seeds.push_back({pslg.holes[i], "the point of " + hole_text(pslg, i), CGAL::Pslg_parts_2().hole(i)});
  for (std::size_t i = 0; i < pslg.regions.size(); ++i)
    seeds.push_back(
        {pslg.regions[i].point, "the point of " + region_text(pslg, i), CGAL::Pslg_parts_2().region(i)});
  return seeds;
}

/// Whether p is so near to the box of a and b that words may confuse what is on which side.
bool is_near(const Point& p, const Point& a, const Point& b, double distance) {
  const auto [west, east] = std::minmax(a.x(), b.x());
  const auto [south, north] = std::minmax(a.y(), b.y());
  return west - distance <= p.x() && p.x() <= east + distance && south - distance <= p.y() &&
         p.y() <= north + distance;
}

/// Rounding must not put a seed to the other side of a segment.
/// \throws CGAL::Pslg_error_2 naming the two.
void check_sides_of_seeds(const mesh_graph::Pslg& pslg, const Word_map<Point>& map) {
  using Geometry = Word_traits::Meshing_geometry_2;
  const auto signed_words = [&map](const Point& p) {
    const Word_point w = map.to_word_inside_root(p);
    return Geometry::Point{std::int64_t(w.x()), std::int64_t(w.y())};
  };
  for (const Seed& seed : seeds_of(pslg)) {
    if (map.is_exact(seed.point)) continue;
    for (std::size_t s = 0; s < pslg.segments.size(); ++s) {
      const Point &a = pslg.point(pslg.segments[s][0]), &b = pslg.point(pslg.segments[s][1]);
      if (!is_near(seed.point, a, b, 2 * map.unit())) continue;
      const int side = Geometry::orientation(signed_words(a), signed_words(b), signed_words(seed.point));
      if (side == static_cast<int>(CGAL::orientation(a, b, seed.point))) continue;
      CGAL::Pslg_parts_2 parts = seed.part;
      throw CGAL::Pslg_error_2(Kind::TOO_NEAR,
                               "64-bit words cannot tell on which side of " + segment_text(pslg, s) + ' ' +
                                   seed.name + " is",
                               parts.segment(Segment_index(s)));
    }
  }
}

/// Words may put a vertex on a segment that it is next to.
/// \throws CGAL::Pslg_error_2 naming the two.
void check_vertices_on_segments(const mesh_graph::Pslg& pslg, const mesh_graph::Mesh& mesh) {
  for (const auto& edge : mesh.constrained_edges)
    for (const Vertex_index v : edge.vertices) {
      if (std::size_t(v) >= pslg.vertices.size()) continue;
      const auto& ends = pslg.segments[std::size_t(edge.segment)];
      if (CGAL::collinear(pslg.point(ends[0]), pslg.point(ends[1]), pslg.vertices[std::size_t(v)])) continue;
      throw CGAL::Pslg_error_2(Kind::TOO_NEAR,
                               "64-bit words cannot tell " + vertex_text(pslg, std::size_t(v)) + " and " +
                                   segment_text(pslg, std::size_t(edge.segment)) + " apart",
                               CGAL::Pslg_parts_2().vertex(v).segment(edge.segment));
    }
}

/// Whether the ends of segment t are on different sides of segment s.
bool has_ends_on_both_sides(const mesh_graph::Pslg& pslg, std::size_t s, std::size_t t) {
  const auto side = [&](Vertex_index v) {
    return CGAL::orientation(pslg.point(pslg.segments[s][0]), pslg.point(pslg.segments[s][1]), pslg.point(v));
  };
  return side(pslg.segments[t][0]) * side(pslg.segments[t][1]) < 0;
}

/// Segments that cross in words: whether they do so by their doubles decides what is to blame.
[[noreturn]] void refuse(const mesh_graph::Pslg& pslg, const CGAL::Pslg_crossing_error_2& error) {
  const std::size_t s(error.segments[0]), t(error.segments[1]);
  const std::string first = segment_text(pslg, s), second = segment_text(pslg, t);
  if (has_ends_on_both_sides(pslg, s, t) && has_ends_on_both_sides(pslg, t, s))
    throw CGAL::Pslg_crossing_error_2(first + " crosses " + second, error.segments);
  throw CGAL::Pslg_error_2(Kind::TOO_NEAR, "64-bit words cannot tell " + first + " and " + second + " apart",
                           error.parts());
}

/// The same for segments that face each other across too narrow a gap.
[[noreturn]] void refuse(const mesh_graph::Pslg& pslg, const CGAL::Pslg_gap_error_2& error, double unit) {
  std::string text = segment_text(pslg, std::size_t(error.segments[0])) + " and " +
                     segment_text(pslg, std::size_t(error.segments[1])) +
                     " face each other at a distance of ";
  CGAL::Quadtree_mesh_2::internal::append_number(text, error.distance * unit);
  throw CGAL::Pslg_gap_error_2(error.demand, text, error.segments, error.distance * unit);
}

/// Vertices that words cannot hold, or tell apart.
[[noreturn]] void refuse(const mesh_graph::Pslg& pslg, const CGAL::Quadtree_mesh_2::Point_error& error) {
  const std::size_t a(error.point());
  if (!error.other().is_valid())
    throw CGAL::Pslg_error_2(Kind::OUT_OF_RANGE, vertex_text(pslg, a) + ' ' + error.reason(),
                             CGAL::Pslg_parts_2().vertex(Vertex_index(a)));
  const std::size_t b(error.other());
  throw CGAL::Pslg_error_2(Kind::TOO_NEAR,
                           "64-bit words cannot tell " + vertex_text(pslg, a) + " and " +
                               vertex_text(pslg, b) + " apart",
                           CGAL::Pslg_parts_2().vertex(Vertex_index(a)).vertex(Vertex_index(b)));
}

/// What else is wrong: names of vertices and segments have words in them, and the user knows the doubles.
[[noreturn]] void refuse(const mesh_graph::Pslg& pslg, const CGAL::Pslg_2<Word_point>& words,
                         const CGAL::Pslg_error_2& error) {
  std::string text = error.what();
  const auto replace = [&text](const std::string& name, const std::string& by) {
    if (const std::size_t at = text.find(name); at != std::string::npos) text.replace(at, name.size(), by);
  };
  for (const Vertex_index v : error.parts().vertices)
    replace(vertex_text(words, std::size_t(v)), vertex_text(pslg, std::size_t(v)));
  for (const Segment_index s : error.parts().segments)
    replace(segment_text(words, std::size_t(s)), segment_text(pslg, std::size_t(s)));
  throw CGAL::Pslg_error_2(error.kind(), text, error.parts());
}

Word_map<Point> map_of(const mesh_graph::Pslg& pslg) try {
  return Word_map<Point>(pslg.vertices);
} catch (const CGAL::Quadtree_mesh_2::Point_error& error) {
  refuse(pslg, error);
}

} // namespace

double mesh_graph::unit_of_words(const Pslg& pslg) { return map_of(pslg).unit(); }

mesh_graph::Mesh mesh_graph::in_words(const Pslg& pslg, const Options& options, Neighbors neighbors,
                                      Report& report) {
  CGAL::check_pslg_structure(pslg); // the scale wants finite coordinates
  const Word_map<Point> map = map_of(pslg);
  check_sides_of_seeds(pslg, map);
  CGAL::Pslg_2<Word_point> words;
  try {
    words = to_words(pslg, map);
    auto rounded = CGAL::round_mesh_2<Point>(
        mesh_graph_with<Word_traits>(words, to_words(options, map), neighbors, report), pslg.vertices,
        [&map](const Word_point& p) { return map.to_double(p); });
    rounded.renumber(report);
    to_doubles(report, rounded.mesh);
    check_vertices_on_segments(pslg, rounded.mesh);
    return std::move(rounded.mesh);
  } catch (const CGAL::Quadtree_mesh_2::Point_error& error) {
    refuse(pslg, error);
  } catch (const CGAL::Pslg_crossing_error_2& error) {
    refuse(pslg, error);
  } catch (const CGAL::Pslg_gap_error_2& error) {
    refuse(pslg, error, map.unit());
  } catch (const CGAL::Pslg_seed_error_2& e) { // in words; the user knows the doubles
    throw CGAL::Quadtree_mesh_2::internal::make_seed_error(pslg, e.mark, e.seed, e.vertex, e.segment);
  } catch (const CGAL::Pslg_error_2& error) {
    refuse(pslg, words, error);
  }
}
