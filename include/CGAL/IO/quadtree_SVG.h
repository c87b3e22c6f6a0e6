// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef CGAL_IO_QUADTREE_SVG_H
#define CGAL_IO_QUADTREE_SVG_H

/// \file
/// Writes pictures of quadtrees. The outlines of all leaves are the root's outline and a cross in each split
/// square, so every edge is drawn once. Squares too small to be seen are not visited. So the cost is that of
/// the picture, whatever the depth of the tree.

#include <CGAL/Balanced_quadtree.h>
#include <CGAL/Bbox_2.h>
#include <CGAL/Quadtree_mesh_2/internal/geometry/triangle_angles.h>
#include <CGAL/Quadtree_mesh_2/internal/io/Replaced_files.h>
#include <CGAL/Quadtree_mesh_2/internal/io/Svg_path.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <ostream>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace IO {

/// \addtogroup PkgQuadtreeMesh2IO
/// @{

/// Options of `write_SVG()` for quadtrees. Each option is set by the function of its name, which returns the
/// options, so that calls can be chained. Without an argument the function returns the value. A color is any
/// color of SVG; "none" omits the item.
class Quadtree_svg_options {
public:
  /// What determines the colors of areas.
  enum class Fill {
    PLAIN, ///< all leaves in `fill_color()`
    LEVEL  ///< from light (large leaves) to dark (small ones)
  };

  /// Width of the picture in pixels, 800 by default; the height follows.
  Quadtree_svg_options& width(int value) { return width_ = value, *this; }
  int width() const { return width_; } ///< the value set

  /// Pixels on all sides, 4 by default.
  Quadtree_svg_options& margin(double value) { return margin_ = value, *this; }
  double margin() const { return margin_; } ///< the value set

  /// Width of edges in pixels, 0.4 by default.
  Quadtree_svg_options& edge_width(double value) { return edge_width_ = value, *this; }
  double edge_width() const { return edge_width_; } ///< the value set

  /// Width of the outlines of the framework's squares in pixels, 1.4 by default.
  Quadtree_svg_options& framework_width(double value) { return framework_width_ = value, *this; }
  double framework_width() const { return framework_width_; } ///< the value set

  /// Diameter of points in pixels, 2.4 by default.
  Quadtree_svg_options& point_diameter(double value) { return point_diameter_ = value, *this; }
  double point_diameter() const { return point_diameter_; } ///< the value set

  /// What determines the colors of areas; PLAIN by default.
  Quadtree_svg_options& fill_by(Fill value) { return fill_by_ = value, *this; }
  Fill fill_by() const { return fill_by_; } ///< the value set

  /// Color of edges, or none.
  Quadtree_svg_options& edge_color(std::string value) { return edge_color_ = std::move(value), *this; }
  const std::string& edge_color() const { return edge_color_; } ///< the value set

  /// Color of the outlines of the framework's squares, or none, the default. More than one child of such a
  /// square holds points.
  Quadtree_svg_options& framework_color(std::string value) {
    return framework_color_ = std::move(value), *this;
  }
  const std::string& framework_color() const { return framework_color_; } ///< the value set

  /// Color of points, or none.
  Quadtree_svg_options& point_color(std::string value) { return point_color_ = std::move(value), *this; }
  const std::string& point_color() const { return point_color_; } ///< the value set

  /// Color of areas, or none, the default.
  Quadtree_svg_options& fill_color(std::string value) { return fill_color_ = std::move(value), *this; }
  const std::string& fill_color() const { return fill_color_; } ///< the value set

  /// Color of the background, or none.
  Quadtree_svg_options& background_color(std::string value) {
    return background_color_ = std::move(value), *this;
  }
  const std::string& background_color() const { return background_color_; } ///< the value set

  /// Shows this part of the plane only. By default it is the root.
  Quadtree_svg_options& clip_to(const Bbox_2& window) { return clip_to_ = window, *this; }
  const std::optional<Bbox_2>& clip_to() const { return clip_to_; } ///< the value set

private:
  int width_ = 800;
  double margin_ = 4;
  double edge_width_ = 0.4;
  double framework_width_ = 1.4;
  double point_diameter_ = 2.4;
  Fill fill_by_ = Fill::PLAIN;
  std::string edge_color_ = "#4a6b8a";
  std::string framework_color_ = "none";
  std::string point_color_ = "#b2182b";
  std::string fill_color_ = "none";
  std::string background_color_ = "#ffffff";
  std::optional<Bbox_2> clip_to_;
};

/// @}

} // namespace IO

namespace Quadtree_mesh_2 {
namespace internal {

/// Draws a quadtree: areas, then outlines of leaves, then squares of the framework, then points.
template <class Quadtree>
class Svg_quadtree_painter {
public:
  using Options = IO::Quadtree_svg_options;

  Svg_quadtree_painter(const Quadtree& tree, const Options& options) : tree_(tree), options_(options) {
    set_window();
    visit_squares();
    list_points();
  }

  void paint(std::ostream& out) const {
    out << "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" << (width_ + 9) / 10 << "\" height=\""
        << (height_ + 9) / 10 << "\" viewBox=\"0 0 " << width_ << ' ' << height_ << "\">\n";
    if (options_.background_color() != "none")
      out << "<rect width=\"" << width_ << "\" height=\"" << height_ << "\" fill=\""
          << options_.background_color() << "\"/>\n";
    for (std::size_t level = 0; level < areas_.size(); ++level) paint_area(out, level);
    out << "<g fill=\"none\" stroke-linecap=\"round\" stroke-linejoin=\"round\">\n";
    paint_lines(out, edges_, options_.edge_color(), options_.edge_width());
    paint_lines(out, framework_, options_.framework_color(), options_.framework_width());
    paint_lines(out, points_, options_.point_color(), options_.point_diameter());
    out << "</g>\n</svg>\n";
  }

private:
  using Point = typename Quadtree::Point_2;

  /// Lower left and upper right corner, in the plane.
  struct Box {
    double x0, y0, x1, y1;
  };
  /// The same in the picture, where y goes down: upper left and lower right corner.
  struct Frame {
    Svg_point first, last;
  };

  Box box(Node_index v) const {
    const std::array<Point, 4> c = tree_.corners(v);
    return {as_double(c[0].x()), as_double(c[0].y()), as_double(c[2].x()), as_double(c[2].y())};
  }

  void set_window() {
    window_ = box(tree_.root());
    if (options_.clip_to())
      window_ = {options_.clip_to()->xmin(), options_.clip_to()->ymin(), options_.clip_to()->xmax(),
                 options_.clip_to()->ymax()};
    const double width = window_.x1 - window_.x0, height = window_.y1 - window_.y0;
    const double pixels = std::max(1., options_.width() - 2 * options_.margin());
    const double extent = std::max(width, height / 4); // a tall picture gets narrower
    scale_ = 10 * pixels / extent;
    if (!(extent > 0) || !std::isfinite(scale_)) scale_ = 1;
    width_ = 10 * std::max(1, options_.width());
    height_ = static_cast<int>(std::ceil(std::clamp(height * scale_, 0., 1e8) + 20 * options_.margin()));
    height_ = std::max(1, height_);
    center_x_ = window_.x0 + width / 2;
    center_y_ = window_.y0 + height / 2;
  }

  Svg_point to_picture(double x, double y) const {
    const auto round = [](double v) {
      return static_cast<std::int32_t>(std::lround(std::clamp(v, -1e8, 1e8)));
    };
    return {round((x - center_x_) * scale_ + width_ / 2.), round((center_y_ - y) * scale_ + height_ / 2.)};
  }
  Frame to_picture(const Box& b) const { return {to_picture(b.x0, b.y1), to_picture(b.x1, b.y0)}; }

  bool is_in_window(const Box& b) const {
    return b.x0 <= window_.x1 && window_.x0 <= b.x1 && b.y0 <= window_.y1 && window_.y0 <= b.y1;
  }

  // --- squares ---

  /// Goes down from the root, without recursion: exact quadtrees can be deeper than the stack.
  void visit_squares() {
    const Box root = box(tree_.root());
    if (is_in_window(root)) add_frame(edges_, to_picture(root));
    std::vector<Node_index> open{tree_.root()};
    while (!open.empty()) {
      const Node_index v = open.back();
      open.pop_back();
      const Box b = box(v);
      if (!is_in_window(b)) continue;
      const Frame frame = to_picture(b);
      // With a side of two units, the cross is distinct from the outline after rounding.
      if (tree_.is_leaf(v) || (b.x1 - b.x0) * scale_ < 2) {
        add_area(frame, static_cast<std::size_t>(tree_.level(v)));
        continue;
      }
      add_cross(b, frame);
      if (options_.framework_color() != "none" && is_in_framework(v)) add_frame(framework_, frame);
      for (int q = 4; q-- > 0;) open.push_back(tree_.child(v, q));
    }
  }

  /// Lemma 2: the squares of the framework are those with two or more nonempty children.
  bool is_in_framework(Node_index v) const {
    int nonempty = 0;
    for (int q = 0; q < 4; ++q) nonempty += tree_.points(tree_.child(v, q)).size() > 0 ? 1 : 0;
    return nonempty >= 2;
  }

  void add_area(const Frame& f, std::size_t level) {
    if (options_.fill_by() == Options::Fill::PLAIN) {
      if (options_.fill_color() == "none") return;
      level = 0;
    }
    if (level >= areas_.size()) areas_.resize(level + 1);
    add_frame(areas_[level], f);
  }

  static void add_frame(Svg_path& path, const Frame& f) {
    path.move_to(f.first);
    path.line_to({f.last.x, f.first.y});
    path.line_to(f.last);
    path.line_to({f.first.x, f.last.y});
    path.close(f.first);
  }

  void add_cross(const Box& b, const Frame& f) {
    const Svg_point middle = to_picture(b.x0 + (b.x1 - b.x0) / 2, b.y0 + (b.y1 - b.y0) / 2);
    edges_.move_to({f.first.x, middle.y});
    edges_.line_to({f.last.x, middle.y});
    edges_.move_to({middle.x, f.first.y});
    edges_.line_to({middle.x, f.last.y});
  }

  /// A color for leaves of a level, between those of the largest and the smallest leaves of the picture.
  std::string color_of_level(std::size_t level) const {
    std::size_t least = 0;
    while (areas_[least].is_empty()) ++least;
    const double range = static_cast<double>(std::max<std::size_t>(1, areas_.size() - 1 - least));
    const double share = static_cast<double>(level - least) / range;
    static constexpr std::array<double, 3> light{248, 246, 227}, dark{49, 122, 153};
    std::string color = "#";
    for (std::size_t i = 0; i < 3; ++i) {
      const auto value = static_cast<unsigned>(std::lround(light[i] + share * (dark[i] - light[i])));
      color += "0123456789abcdef"[value / 16];
      color += "0123456789abcdef"[value % 16];
    }
    return color;
  }

  /// A thin stroke in the color of the area closes the hairlines that renderers leave between neighbors.
  void paint_area(std::ostream& out, std::size_t level) const {
    if (areas_[level].is_empty()) return;
    const std::string color =
        options_.fill_by() == Options::Fill::PLAIN ? options_.fill_color() : color_of_level(level);
    out << "<path fill=\"" << color << "\" stroke=\"" << color << "\" stroke-width=\"2\" d=\""
        << areas_[level].text() << "\"/>\n";
  }

  // --- points ---

  /// A dot is a line of no length with round ends. Indistinguishable points share one.
  void list_points() {
    if (options_.point_color() == "none") return;
    const auto& framework = tree_.framework();
    std::vector<std::pair<std::int32_t, std::int32_t>> dots;
    for (std::size_t r = 0; r < framework.number_of_points(); ++r) {
      const Point p = framework.grid().point(framework.grid_point(Point_rank(r)));
      const double x = as_double(p.x()), y = as_double(p.y());
      if (!is_in_window({x, y, x, y})) continue;
      const Svg_point dot = to_picture(x, y);
      dots.emplace_back(dot.x, dot.y);
    }
    std::sort(dots.begin(), dots.end());
    dots.erase(std::unique(dots.begin(), dots.end()), dots.end());
    for (const auto& [x, y] : dots) {
      points_.move_to({x, y});
      points_.line_to({x, y});
    }
  }

  static void paint_lines(std::ostream& out, const Svg_path& path, const std::string& color, double width) {
    if (path.is_empty() || color == "none") return;
    out << "<path stroke=\"" << color << "\" stroke-width=\"" << 10 * width << "\" d=\"" << path.text()
        << "\"/>\n";
  }

  const Quadtree& tree_;
  const Options& options_;
  Box window_{};
  double scale_ = 1, center_x_ = 0, center_y_ = 0;
  int width_ = 1, height_ = 1;  // tenths of pixels, like everything in the picture
  std::vector<Svg_path> areas_; // by level, or one
  Svg_path edges_, framework_, points_;
};

} // namespace internal
} // namespace Quadtree_mesh_2

namespace IO {

/// \addtogroup PkgQuadtreeMesh2IO
/// @{

/// Writes a picture of the quadtree: leaves as thin outlines, points as dots. Options color the leaves by
/// their level and emphasize the squares of the framework.
///
/// Squares of less than a fifth of a pixel are shown as if they were leaves. Framework squares inside a leaf
/// are not shown; they exist if a leaf may hold more than one point.
/// \tparam Traits `x()` and `y()` of its points are arithmetic or have a `CGAL::to_double()`.
template <class Traits, class ConcurrencyTag>
void write_SVG(std::ostream& out, const Balanced_quadtree<Traits, ConcurrencyTag>& tree,
               const Quadtree_svg_options& options = {}) {
  using Quadtree = Balanced_quadtree<Traits, ConcurrencyTag>;
  Quadtree_mesh_2::internal::Svg_quadtree_painter<Quadtree>(tree, options).paint(out);
}

/// \throws std::system_error (a `std::runtime_error`) naming the file if it cannot be written. An older file of that
/// name is then unchanged.
template <class Traits, class ConcurrencyTag>
void write_SVG(const std::string& file_name, const Balanced_quadtree<Traits, ConcurrencyTag>& tree,
               const Quadtree_svg_options& options = {}) {
  std::ostringstream out;
  write_SVG(out, tree, options);
  Quadtree_mesh_2::internal::replace_file(file_name, out.str());
}

/// @}

} // namespace IO
} // namespace CGAL

#endif // CGAL_IO_QUADTREE_SVG_H
