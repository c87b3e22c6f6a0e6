#ifndef QUADTREE_MESH_2_EXAMPLES_MESH_IN_WORDS_H
#define QUADTREE_MESH_2_EXAMPLES_MESH_IN_WORDS_H

// A graph over doubles meshed in integer arithmetic: scaled to 64-bit words, meshed there, mapped back.

#include "mesh_with_doubles.h"

#include <CGAL/Bbox_2.h>
#include <CGAL/Fixed_point_quadtree_traits_2.h>
#include <CGAL/Indexed_mesh_2.h>
#include <CGAL/Pslg_2.h>
#include <CGAL/Quality_mesh_options_2.h>
#include <CGAL/Quality_mesh_report_2.h>
#include <CGAL/Quality_mesher_2.h>
#include <CGAL/centroid.h>
#include <CGAL/tags.h>
#include <CGAL/validate_pslg_2.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

namespace mesh_in_words_internal {

using Traits = CGAL::Fixed_point_quadtree_traits_2<std::uint64_t>;
using Word_point = Traits::Point_2;
using Scale = CGAL::Fixed_point_scale_2<std::uint64_t>;

/// Between the doubles of one graph and words.
template <class Point>
class Word_map {
public:
  explicit Word_map(const CGAL::Pslg_2<Point>& pslg)
      : box_(bounding_box(pslg)),
        margin_((std::max)(box_.xmax() - box_.xmin(), box_.ymax() - box_.ymin()) / 4), scale_(box_) {}

  double unit() const { return scale_.unit(); }
  Word_point to_word(const Point& p) const { return scale_.to_fixed(p.x(), p.y()); }
  /// The same for any point: one far away, which words could not tell, becomes one that is as surely outside.
  Word_point to_word_inside_root(const Point& p) const {
    return scale_.to_fixed(clamped(p.x(), box_.xmin(), box_.xmax()),
                           clamped(p.y(), box_.ymin(), box_.ymax()));
  }
  Point to_double(const Word_point& p) const {
    const auto [x, y] = scale_.to_double(p);
    return Point(x, y);
  }

private:
  static CGAL::Bbox_2 bounding_box(const CGAL::Pslg_2<Point>& pslg) {
    CGAL::Bbox_2 box;
    for (const Point& p : pslg.vertices) box += p.bbox();
    const double largest = (std::max)({-box.xmin(), box.xmax(), -box.ymin(), box.ymax()});
    if (!(largest < std::ldexp(1.0, 999)))
      throw CGAL::Pslg_error_2("coordinates are too large for fixed-point words");
    return box;
  }

  double clamped(double v, double low, double high) const {
    return (std::clamp)(v, low - margin_, high + margin_);
  }

  CGAL::Bbox_2 box_;
  double margin_;
  Scale scale_;
};

/// Words cannot tell points that are closer than their unit; merging them in silence would change the input.
template <class Point>
void check_told_apart(const std::vector<Point>& points, const std::vector<Word_point>& words) {
  std::vector<std::size_t> order(words.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return words[a] < words[b]; });
  for (std::size_t i = 1; i < order.size(); ++i) {
    const std::size_t a = order[i - 1], b = order[i];
    if (words[a] == words[b] && points[a] != points[b])
      throw CGAL::Pslg_error_2("vertices " + std::to_string((std::min)(a, b)) + " and " +
                               std::to_string((std::max)(a, b)) +
                               " are closer than fixed-point words can tell");
  }
}

template <class Point>
CGAL::Pslg_2<Word_point> to_words(const CGAL::Pslg_2<Point>& pslg, const Word_map<Point>& map) {
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

template <class Point>
CGAL::Quality_mesh_options_2 to_words(CGAL::Quality_mesh_options_2 options, const Word_map<Point>& map) {
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

/// The places in a report, which words would make useless to the reader.
template <class Point>
void to_doubles(CGAL::Quality_mesh_report_2& report, const CGAL::Indexed_mesh_2<Point>& mesh) {
  for (auto& unmet : report.unmet_triangles) {
    const auto& t = mesh.triangles[std::size_t(unmet.triangle)];
    const Point c = CGAL::centroid(mesh.point(t[0]), mesh.point(t[1]), mesh.point(t[2]));
    unmet.centroid = {c.x(), c.y()};
  }
}

} // namespace mesh_in_words_internal

/// \throws CGAL::Pslg_error_2 as the mesher does, and where words cannot hold the input.
template <class Point>
CGAL::Indexed_mesh_2<Point> mesh_in_words(const CGAL::Pslg_2<Point>& pslg,
                                          const CGAL::Quality_mesh_options_2& options,
                                          CGAL::Quality_mesh_report_2& report) {
  using namespace mesh_in_words_internal;
  CGAL::check_pslg_structure(pslg); // the scale wants finite coordinates
  const Word_map<Point> map(pslg);
  CGAL::Quality_mesher_2<Traits, CGAL::Parallel_tag> mesher(to_words(options, map));
  auto words = mesher(to_words(pslg, map));
  report = mesher.report();
  auto mesh =
      mesh_with_doubles(std::move(words), pslg, [&map](const Word_point& p) { return map.to_double(p); });
  to_doubles(report, mesh);
  return mesh;
}

#endif // QUADTREE_MESH_2_EXAMPLES_MESH_IN_WORDS_H
