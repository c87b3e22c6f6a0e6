#ifndef QUADTREE_MESH_2_EXAMPLES_WORD_MAP_H
#define QUADTREE_MESH_2_EXAMPLES_WORD_MAP_H

// Between doubles and the 64-bit words of integer arithmetic.

#include <CGAL/Bbox_2.h>
#include <CGAL/Fixed_point_quadtree_traits_2.h>
#include <CGAL/Indexed_mesh_2.h>
#include <CGAL/Quadtree_mesh_2/Index.h>
#include <CGAL/Quadtree_mesh_2/Point_error.h>
#include <CGAL/centroid.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <string>
#include <vector>

namespace mesh_in_words_internal {

using Word_traits = CGAL::Fixed_point_quadtree_traits_2<std::uint64_t>;
using Word_point = Word_traits::Point_2;
using Scale = CGAL::Fixed_point_scale_2<std::uint64_t>;

/// How much of the root of quadtrees the input may fill.
enum class Room {
  HALF,      ///< all that quadtrees of the input need
  EIGHTEENTH ///< for domains that reach further, in any direction
};

/// Between the doubles of one input and words. Its points lie in the middle of the root of quadtrees.
template <class Point>
class Word_map {
public:
  explicit Word_map(const std::vector<Point>& points, Room room = Room::HALF)
      : box_(bounding_box(points, room)), margin_(extent(box_) / 4), scale_(box_) {}

  double unit() const { return scale_.unit(); }
  Word_point to_word(const Point& p) const { return scale_.to_fixed(p.x(), p.y()); }
  /// Whether `to_word_inside_root(p)` is p itself.
  bool is_exact(const Point& p) const { return to_double(to_word_inside_root(p)) == p; }
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
  static double extent(const CGAL::Bbox_2& box) {
    return (std::max)(box.xmax() - box.xmin(), box.ymax() - box.ymin());
  }

  /// The box of the points, or, where they shall have room, nine times as large. That of no points is the origin.
  static CGAL::Bbox_2 bounding_box(const std::vector<Point>& points, Room room) {
    CGAL::Bbox_2 box = points.empty() ? CGAL::Bbox_2(0, 0, 0, 0) : CGAL::Bbox_2();
    for (const Point& p : points) box += p.bbox();
    if (room == Room::EIGHTEENTH) {
      const double more = 4 * extent(box);
      box = CGAL::Bbox_2(box.xmin() - more, box.ymin() - more, box.xmax() + more, box.ymax() + more);
    }
    const double largest = (std::max)({-box.xmin(), box.xmax(), -box.ymin(), box.ymax()});
    if (!(largest < std::ldexp(1.0, 999))) refuse_largest(points, room);
    return box;
  }

  /// \throws CGAL::Quadtree_mesh_2::Point_error for the point with the coordinate of the largest magnitude
  [[noreturn]] static void refuse_largest(const std::vector<Point>& points, Room room) {
    const auto magnitude = [](const Point& p) { return (std::max)(std::fabs(p.x()), std::fabs(p.y())); };
    const auto worst = std::max_element(points.begin(), points.end(), [&](const Point& p, const Point& q) {
      return magnitude(p) < magnitude(q);
    });
    const CGAL::Quadtree_mesh_2::Point_index p(static_cast<std::size_t>(worst - points.begin()));
    const std::string limit = "below 2^999 in magnitude for 64-bit words";
    throw CGAL::Quadtree_mesh_2::Point_error(
        p, room == Room::HALF ? limit : limit + ", with four times the extent of the points added");
  }

  double clamped(double v, double low, double high) const {
    return (std::clamp)(v, low - margin_, high + margin_);
  }

  CGAL::Bbox_2 box_;
  double margin_;
  Scale scale_;
};

/// Words cannot tell points that are closer than their unit; merging them in silence would change the input.
/// \throws CGAL::Quadtree_mesh_2::Point_error for two of them
template <class Point>
void check_told_apart(const std::vector<Point>& points, const std::vector<Word_point>& words) {
  using namespace CGAL::Quadtree_mesh_2;
  std::vector<std::size_t> order(words.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return words[a] < words[b]; });
  for (std::size_t i = 1; i < order.size(); ++i) {
    const auto [a, b] = std::minmax(order[i - 1], order[i]);
    if (words[a] == words[b] && points[a] != points[b])
      throw Point_error(Point_error::Kind::INDISTINGUISHABLE, Point_index(a), Point_index(b));
  }
}

/// The places in a report, which words would make useless to the reader.
template <class Report, class Point>
void to_doubles(Report& report, const CGAL::Indexed_mesh_2<Point>& mesh) {
  for (auto& unmet : report.unmet_triangles) {
    const auto& t = mesh.triangles[std::size_t(unmet.triangle)];
    const Point c = CGAL::centroid(mesh.point(t[0]), mesh.point(t[1]), mesh.point(t[2]));
    unmet.centroid = {c.x(), c.y()};
  }
}

} // namespace mesh_in_words_internal

#endif // QUADTREE_MESH_2_EXAMPLES_WORD_MAP_H
