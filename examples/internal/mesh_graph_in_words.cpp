#include "Word_map.h"
#include "mesh_graph_with.h"
#include "mesh_with_doubles.h"

#include <CGAL/validate_pslg_2.h>

#include <cstddef>
#include <cstdint>
#include <utility>

namespace {

using namespace mesh_in_words_internal;

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
  words.segment_markers = pslg.segment_markers;
  for (const Point& p : pslg.holes) words.holes.push_back(map.to_word_inside_root(p));
  for (const auto& region : pslg.regions)
    words.regions.push_back(
        {map.to_word_inside_root(region.point), region.attribute, region.max_area / map.unit() / map.unit()});
  return words;
}

mesh_graph::Options to_words(mesh_graph::Options options, const Word_map<Point>& map) {
  const double unit = map.unit();
  if (options.size_field)
    options.size([map, field = options.size_field](double x, double y) {
      using Word = std::uint64_t;
      const Point p = map.to_double(Word_point{static_cast<Word>(x), static_cast<Word>(y)});
      return field(p.x(), p.y()) / map.unit();
    });
  return options.max_edge(options.max_edge_length / unit)
      .max_area(options.max_triangle_area / unit / unit)
      .min_edge(options.min_edge_length / unit);
}

} // namespace

double mesh_graph::unit_of_words(const Pslg& pslg) { return Word_map<Point>(pslg.vertices).unit(); }

mesh_graph::Mesh mesh_graph::in_words(const Pslg& pslg, const Options& options, Neighbors neighbors,
                                      Report& report) {
  CGAL::check_pslg_structure(pslg); // the scale wants finite coordinates
  const Word_map<Point> map(pslg.vertices);
  try {
    auto words = mesh_graph_with<Traits>(to_words(pslg, map), to_words(options, map), neighbors, report);
    Mesh mesh = mesh_with_doubles(std::move(words), pslg.vertices,
                                  [&map](const Word_point& p) { return map.to_double(p); });
    to_doubles(report, mesh);
    return mesh;
  } catch (const CGAL::Pslg_seed_error_2& e) { // in words; the user knows the doubles
    throw CGAL::Quadtree_mesh_2::internal::make_seed_error(pslg, e.kind, e.seed, e.vertex, e.segment);
  }
}
