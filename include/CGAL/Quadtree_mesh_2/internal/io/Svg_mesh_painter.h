// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_IO_SVG_MESH_PAINTER_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_IO_SVG_MESH_PAINTER_H

#include <CGAL/Indexed_mesh_2.h>
#include <CGAL/Pslg_2.h>
#include <CGAL/Quadtree_mesh_2/internal/geometry/triangle_angles.h>
#include <CGAL/Quadtree_mesh_2/internal/io/Svg_path.h>
#include <CGAL/Quadtree_mesh_2/internal/io/number_text.h>
#include <CGAL/Quadtree_mesh_2/svg_options.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <limits>
#include <ostream>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// Draws a mesh: areas, then squares if there are any, then edges, then the input's segments.
template <class Point>
class Svg_mesh_painter {
public:
  using Mesh = Indexed_mesh_2<Point>;
  using Pslg = Pslg_2<Point>;
  using Options = IO::Svg_options_2;

  Svg_mesh_painter(const Mesh& mesh, const Pslg& pslg, const Options& options)
      : mesh_(mesh), pslg_(pslg), options_(options) {
    set_window();
    is_shown_.reserve(mesh.triangles.size());
    for (const auto& t : mesh.triangles)
      is_shown_.push_back(is_in_window({mesh.point(t[0]), mesh.point(t[1]), mesh.point(t[2])}));
  }

  /// Squares that are drawn under the edges: lower left and upper right corners.
  void add_square(const Point& lower_left, const Point& upper_right) {
    if (!is_in_picture(lower_left, upper_right)) return;
    const Svg_point a = to_picture(lower_left), b = to_picture(upper_right);
    squares_.move_to(a);
    for (const Svg_point p : {Svg_point{b.x, a.y}, b, Svg_point{a.x, b.y}}) squares_.line_to(p);
    squares_.close(a);
  }

  void paint(std::ostream& out) const {
    const bool has_legend =
        options_.legend() == Options::Legend::BELOW && options_.fill_by() != Options::Fill::PLAIN;
    const int full_height = height_ + (has_legend ? legend_height : 0);
    out << "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" << options_.width() << "\" height=\""
        << (full_height + 9) / 10 << "\" viewBox=\"0 0 " << width_ << ' ' << full_height << "\">\n";
    if (options_.background_color() != "none")
      out << "<rect width=\"" << width_ << "\" height=\"" << full_height << "\" fill=\""
          << options_.background_color() << "\"/>\n";
    if (options_.fill_by() == Options::Fill::REGION)
      paint_areas_by_region(out);
    else if (options_.fill_by() != Options::Fill::PLAIN)
      paint_areas_by_angle(out);
    else if (options_.fill_color() != "none")
      paint_areas(out);
    out << "<g fill=\"none\" stroke-linejoin=\"round\" stroke-linecap=\"round\">\n";
    paint_squares(out);
    paint_lines(out, mesh_edges(), mesh_.points, options_.edge_color(), options_.edge_width());
    paint_lines(out, constrained_edges(), mesh_.points, options_.segment_color(), options_.segment_width());
    paint_lines(out, outside_segments(), pslg_.vertices, options_.segment_color(), options_.segment_width());
    out << "</g>\n";
    if (has_legend)
      options_.fill_by() == Options::Fill::REGION ? paint_legend_of_regions(out) : paint_legend(out);
    out << "</svg>\n";
  }

private:
  using Edge = std::array<std::uint32_t, 2>;

  void set_window() {
    double x0 = std::numeric_limits<double>::infinity(), x1 = -x0, y0 = x0, y1 = -x0;
    const auto extend = [&](const Point& p) {
      x0 = std::min(x0, as_double(p.x()));
      x1 = std::max(x1, as_double(p.x()));
      y0 = std::min(y0, as_double(p.y()));
      y1 = std::max(y1, as_double(p.y()));
    };
    if (options_.clip_to()) {
      x0 = options_.clip_to()->xmin(), x1 = options_.clip_to()->xmax(), y0 = options_.clip_to()->ymin(),
      y1 = options_.clip_to()->ymax();
    } else {
      for (const auto& t : mesh_.triangles)
        for (Vertex_index v : t) extend(mesh_.point(v));
      for (const auto& s : pslg_.segments)
        for (Vertex_index v : s) extend(pslg_.point(v));
    }
    if (!(x0 <= x1)) x0 = x1 = y0 = y1 = 0; // nothing to show
    const double pixels = std::max(1., options_.width() - 2 * options_.margin());
    const double extent =
        std::max(x1 - x0, (y1 - y0) / 4); // a tall picture gets narrower rather than endless
    scale_ = extent > 0 ? 10 * pixels / extent : 1;
    width_ = 10 * std::max(1, options_.width());
    height_ = std::max(1, static_cast<int>(std::ceil((y1 - y0) * scale_ + 20 * options_.margin())));
    window_ = Bbox_2(x0, y0, x1, y1);
    left_ = (x0 + x1) / 2 - width_ / (2 * scale_);
    top_ = (y0 + y1) / 2 + height_ / (2 * scale_);
  }

  Svg_point to_picture(const Point& p) const {
    const auto round = [](double x) {
      return static_cast<std::int32_t>(std::lround(std::clamp(x, -1e8, 1e8)));
    };
    return {round((as_double(p.x()) - left_) * scale_), round((top_ - as_double(p.y())) * scale_)};
  }

  /// Whether the bounding box of the points meets the window and its margin. Without a clip window all does.
  bool is_in_window(std::initializer_list<Point> points) const {
    if (!options_.clip_to()) return true;
    Bbox_2 box;
    for (const Point& p : points)
      box += Bbox_2(as_double(p.x()), as_double(p.y()), as_double(p.x()), as_double(p.y()));
    return do_overlap(box, window_);
  }

  /// Quadtrees reach beyond the mesh.
  bool is_in_picture(const Point& lower_left, const Point& upper_right) const {
    const Svg_point a = to_picture(lower_left), b = to_picture(upper_right);
    return b.x >= 0 && a.x <= width_ && a.y >= 0 && b.y <= height_;
  }

  void paint_squares(std::ostream& out) const {
    if (squares_.is_empty() || options_.quadtree_color() == "none") return;
    // An inner picture cuts off what goes beyond it, which would run into a legend.
    out << "<svg width=\"" << width_ << "\" height=\"" << height_ << "\"><path stroke=\""
        << options_.quadtree_color() << "\" stroke-width=\"" << 10 * options_.quadtree_width() << "\" d=\""
        << squares_.text() << "\"/></svg>\n";
  }

  // --- areas ---

  void add_triangle(Svg_path& path, std::size_t t) const {
    const Svg_point p = to_picture(corner(t, 0)), q = to_picture(corner(t, 1)), r = to_picture(corner(t, 2));
    if (p == q || q == r || r == p) return;
    path.move_to(p);
    path.line_to(q);
    path.line_to(r);
    path.close(p);
  }
  const Point& corner(std::size_t t, std::size_t k) const { return mesh_.point(mesh_.triangles[t][k]); }

  /// A stroke in the color of the area closes the hairlines that renderers leave between neighbors.
  static void paint_area(std::ostream& out, const Svg_path& path, const std::string& color) {
    if (path.is_empty()) return;
    out << "<path fill=\"" << color << "\" stroke=\"" << color
        << "\" stroke-width=\"4\" stroke-linejoin=\"round\" d=\"" << path.text() << "\"/>\n";
  }

  /// One area bounded by the edges of one triangle only: much smaller than all triangles.
  void paint_areas(std::ostream& out) const {
    const std::vector<Edge> edges = directed_edges();
    std::vector<Edge> unpaired;
    for (const Edge& e : edges)
      if (!std::binary_search(edges.begin(), edges.end(), Edge{e[1], e[0]})) unpaired.push_back(e);
    Svg_path path;
    std::vector<char> is_done(unpaired.size(), 0);
    for (std::size_t first = 0; first < unpaired.size(); ++first) {
      if (is_done[first] != 0) continue;
      const Svg_point start = to_picture(mesh_.points[unpaired[first][0]]);
      path.move_to(start);
      Svg_point pen = start;
      for (std::size_t e = first; e < unpaired.size() && is_done[e] == 0;) {
        is_done[e] = 1;
        const std::uint32_t v = unpaired[e][1];
        const Svg_point next = to_picture(mesh_.points[v]);
        if (!(next == pen)) path.line_to(next);
        pen = next;
        const auto after = std::lower_bound(unpaired.begin(), unpaired.end(), Edge{v, 0});
        e = static_cast<std::size_t>(after - unpaired.begin());
        while (e < unpaired.size() && unpaired[e][0] == v && is_done[e] != 0)
          ++e; // borders can touch in a vertex
        if (e < unpaired.size() && unpaired[e][0] != v) break;
      }
      path.close(start);
    }
    if (!path.is_empty())
      out << "<path fill=\"" << options_.fill_color() << "\" fill-rule=\"evenodd\" d=\"" << path.text()
          << "\"/>\n";
  }

  std::vector<Edge> directed_edges() const {
    std::vector<Edge> edges;
    for (std::size_t t = 0; t < mesh_.triangles.size(); ++t)
      for (std::size_t k = 0; k < 3 && is_shown_[t] != 0; ++k)
        edges.push_back({mesh_.triangles[t][k].value(), mesh_.triangles[t][(k + 1) % 3].value()});
    std::sort(edges.begin(), edges.end());
    return edges;
  }

  // Colors stand for five degrees each: of least angles from 0 on, of largest ones from 120 downwards.
  static constexpr std::array<const char*, 12> colors_{"#67001f", "#b2182b", "#d6604d", "#f4a582",
                                                       "#fdcc8a", "#fee8a0", "#d9ef8b", "#a6d96a",
                                                       "#7fc97f", "#66c2a5", "#5aaec4", "#4393c3"};
  static constexpr int degrees_per_color = 5, largest_colored_angle = 120;
  static constexpr int legend_height = 260; // tenths of pixels

  bool is_by_largest_angle() const { return options_.fill_by() == Options::Fill::LARGEST_ANGLE; }

  std::size_t color_of(std::size_t t) const {
    const Scaled_triangle triangle(corner(t, 0), corner(t, 1), corner(t, 2));
    const double degrees = is_by_largest_angle()
                               ? std::max(0., largest_colored_angle - triangle.largest_angle())
                               : triangle.least_angle();
    return std::min(colors_.size() - 1, static_cast<std::size_t>(degrees / degrees_per_color));
  }

  void paint_areas_by_angle(std::ostream& out) const {
    std::array<Svg_path, colors_.size()> paths;
    for (std::size_t t = 0; t < mesh_.triangles.size(); ++t)
      if (is_shown_[t] != 0) add_triangle(paths[color_of(t)], t);
    for (std::size_t i = 0; i < colors_.size(); ++i) paint_area(out, paths[i], colors_[i]);
  }

  // Neighbors in number differ in hue; light, as edges are drawn on them.
  static constexpr std::array<const char*, 12> region_colors_{"#a6cee3", "#fdbf6f", "#b2df8a", "#fb9a99",
                                                              "#cab2d6", "#ffff99", "#8dd3c7", "#f4cae4",
                                                              "#d9d9d9", "#80b1d3", "#e6d8ad", "#ccebc5"};

  int region(std::size_t t) const {
    return mesh_.region_of_triangle.empty() ? -1 : mesh_.region_of_triangle[t];
  }

  void paint_areas_by_region(std::ostream& out) const {
    std::array<Svg_path, region_colors_.size() + 1> paths; // the last one for no region
    for (std::size_t t = 0; t < mesh_.triangles.size(); ++t)
      if (is_shown_[t] != 0)
        add_triangle(
            paths[region(t) < 0 ? region_colors_.size() : std::size_t(region(t)) % region_colors_.size()], t);
    for (std::size_t i = 0; i < region_colors_.size(); ++i) paint_area(out, paths[i], region_colors_[i]);
    if (options_.fill_color() != "none") paint_area(out, paths.back(), options_.fill_color());
  }

  /// As many boxes as there are regions, twelve at most: number, and attribute if the graph has it.
  void paint_legend_of_regions(std::ostream& out) const {
    int regions = 0;
    for (const int r : mesh_.region_of_triangle) regions = std::max(regions, r + 1);
    const int n = std::min(regions, static_cast<int>(region_colors_.size()));
    if (n == 0) return;
    const int box = std::min(400, width_ * 3 / 4 / n), font = std::min(120, box * 3 / 10);
    const int left = (width_ - box * n) / 2, base = height_ + 110 + font;
    out << "<g font-family=\"sans-serif\" font-size=\"" << font << "\" fill=\"#12263a\">\n"
        << "<text text-anchor=\"end\" x=\"" << left - font << "\" y=\"" << base << "\">region</text>\n";
    for (int r = 0; r < n; ++r) {
      std::string name = std::to_string(r);
      if (static_cast<std::size_t>(r) < pslg_.regions.size()) {
        name += ": ";
        append_number(name, pslg_.regions[static_cast<std::size_t>(r)].attribute);
      }
      out << "<rect x=\"" << left + r * box << "\" y=\"" << height_ + 20 << "\" width=\"" << box
          << "\" height=\"80\" fill=\"" << region_colors_[static_cast<std::size_t>(r)] << "\"/>\n"
          << "<text x=\"" << left + r * box << "\" y=\"" << base << "\">" << name << "</text>\n";
    }
    out << "</g>\n";
  }

  /// A strip of all colors, each with the angle at which it begins, below the picture and as wide as that allows.
  void paint_legend(std::ostream& out) const {
    constexpr int n = static_cast<int>(colors_.size());
    const int box = std::min(400, width_ * 3 / 4 / n), font = box * 3 / 10;
    const int left = (width_ - box * n) / 2, base = height_ + 110 + font;
    out << "<g font-family=\"sans-serif\" font-size=\"" << font << "\" fill=\"#12263a\">\n"
        << "<text text-anchor=\"end\" x=\"" << left - font << "\" y=\"" << base << "\">"
        << (is_by_largest_angle() ? "largest" : "least") << " angle</text>\n";
    for (int i = 0; i < n; ++i) {
      const int place = is_by_largest_angle() ? n - 1 - i : i;
      const int first = is_by_largest_angle() ? largest_colored_angle - degrees_per_color * n : 0;
      out << "<rect x=\"" << left + place * box << "\" y=\"" << height_ + 20 << "\" width=\"" << box
          << "\" height=\"80\" fill=\"" << colors_[static_cast<std::size_t>(i)] << "\"/>\n"
          << "<text x=\"" << left + place * box << "\" y=\"" << base << "\">"
          << first + degrees_per_color * place << "</text>\n";
    }
    out << "</g>\n";
  }

  // --- lines ---

  std::vector<Edge> mesh_edges() const {
    std::vector<Edge> edges = directed_edges();
    for (Edge& e : edges) e = {std::min(e[0], e[1]), std::max(e[0], e[1])};
    std::sort(edges.begin(), edges.end());
    edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
    return edges;
  }

  std::vector<Edge> constrained_edges() const {
    std::vector<Edge> edges;
    for (const auto& e : mesh_.constrained_edges)
      if (is_in_window({mesh_.point(e.vertices[0]), mesh_.point(e.vertices[1])}))
        edges.push_back({e.vertices[0].value(), e.vertices[1].value()});
    return edges;
  }

  /// Segments of which no piece is in the mesh.
  std::vector<Edge> outside_segments() const {
    std::vector<char> is_in_mesh(pslg_.segments.size(), 0);
    for (const auto& e : mesh_.constrained_edges)
      if (std::size_t(e.segment) < is_in_mesh.size()) is_in_mesh[e.segment] = 1;
    std::vector<Edge> edges;
    for (std::size_t s = 0; s < pslg_.segments.size(); ++s) {
      const auto& ends = pslg_.segments[s];
      if (is_in_mesh[s] == 0 && is_in_window({pslg_.point(ends[0]), pslg_.point(ends[1])}))
        edges.push_back({ends[0].value(), ends[1].value()});
    }
    return edges;
  }

  /// Draws the edges as lines that are as long as they come: from each vertex on while there is an edge left.
  void paint_lines(std::ostream& out, const std::vector<Edge>& edges, const std::vector<Point>& points,
                   const std::string& color, double width) const {
    if (edges.empty() || color == "none") return;
    std::vector<std::uint32_t> next(points.size() + 1, 0), incident(2 * edges.size());
    for (const Edge& e : edges)
      for (std::uint32_t v : e) ++next[v + 1];
    for (std::size_t v = 0; v < points.size(); ++v) next[v + 1] += next[v];
    std::vector<std::uint32_t> fill(next.begin(), next.end() - 1);
    for (std::uint32_t e = 0; e < edges.size(); ++e)
      for (std::uint32_t v : edges[e]) incident[fill[v]++] = e;
    std::vector<char> is_drawn(edges.size(), 0);
    const auto take_edge = [&](std::uint32_t v, std::uint32_t& e) { // `fill[v]` is the end of v's range
      while (next[v] < fill[v] && is_drawn[incident[next[v]]] != 0) ++next[v];
      if (next[v] == fill[v]) return false;
      e = incident[next[v]];
      is_drawn[e] = 1;
      return true;
    };
    Svg_path path;
    for (std::uint32_t start = 0; start < points.size(); ++start) {
      std::uint32_t e = 0;
      while (take_edge(start, e)) {
        Svg_point pen = to_picture(points[start]);
        path.move_to(pen);
        std::uint32_t v = start;
        do {
          v = edges[e][0] == v ? edges[e][1] : edges[e][0];
          const Svg_point p = to_picture(points[v]);
          if (!(p == pen)) path.line_to(p);
          pen = p;
        } while (take_edge(v, e));
      }
    }
    out << "<path stroke=\"" << color << "\" stroke-width=\"" << 10 * width << "\" d=\"" << path.text()
        << "\"/>\n";
  }

  const Mesh& mesh_;
  const Pslg& pslg_;
  const Options& options_;
  Bbox_2 window_;
  double scale_ = 1, left_ = 0, top_ = 0; // the picture's top left corner in the plane
  int width_ = 1, height_ = 1;            // tenths of pixels
  std::vector<char> is_shown_;            // triangles
  Svg_path squares_;
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_IO_SVG_MESH_PAINTER_H
