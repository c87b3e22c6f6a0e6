// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_PAGE_PAGE_WRITER_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_PAGE_PAGE_WRITER_H

#include <CGAL/Indexed_mesh_2.h>
#include <CGAL/Pslg_2.h>
#include <CGAL/Quadtree_mesh_2/html_options.h>
#include <CGAL/Quadtree_mesh_2/internal/geometry/triangle_angles.h>
#include <CGAL/Quadtree_mesh_2/internal/io/Vtk_grid.h>
#include <CGAL/Quadtree_mesh_2/internal/io/number_text.h>
#include <CGAL/Quadtree_mesh_2/internal/page/base64.h>
#include <CGAL/Quadtree_mesh_2/internal/page/page_model.h>
#include <CGAL/Quadtree_mesh_2/internal/page/page_renderers.h>
#include <CGAL/Quadtree_mesh_2/internal/page/page_style.h>
#include <CGAL/Quadtree_mesh_2/internal/page/page_view.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// Writes a mesh as a page for browsers. See `IO::write_HTML()`.
///
/// The page has the numbers that it cannot compute: a small JSON `head`, and arrays, each an element with its name as
/// `id` and the type of its numbers.
template <class Point>
class Page_writer {
public:
  using Mesh = Indexed_mesh_2<Point>;
  using Pslg = Pslg_2<Point>;
  using Options = IO::Html_options_2;

  /// Keeps references.
  /// \throws std::invalid_argument if the options name a triangle that the mesh has not, or have coordinates, but not
  /// for each vertex
  Page_writer(const Mesh& mesh, const Pslg& pslg, const Options& options)
      : mesh_(mesh), pslg_(pslg), options_(options) {
    for (const Triangle_index t : options.unmet_triangles())
      if (!(std::size_t(t) < mesh.triangles.size()))
        throw std::invalid_argument("the options name the triangle " + std::to_string(std::size_t(t)) +
                                    " of a mesh of " + std::to_string(mesh.triangles.size()) + " triangles");
    if (!options.coordinates().empty() && options.coordinates().size() != mesh.points.size())
      throw std::invalid_argument("the options have coordinates for " +
                                  std::to_string(options.coordinates().size()) + " of " +
                                  std::to_string(mesh.points.size()) + " vertices");
  }

  /// A quadtree that the page shows on request: a bit for each square, children after their parent, whether it is
  /// split.
  template <class Quadtree>
  void add_quadtree(const Quadtree& tree) {
    const auto corners = tree.corners(tree.root());
    const double x = as_double(corners[0].x()), y = as_double(corners[0].y());
    root_ = ",\"quadtree\":{\"x\":" + number(x) + ",\"y\":" + number(y) +
            ",\"side\":" + number(as_double(corners[2].x()) - x) + '}';
    std::vector<typename Quadtree::Node_index> open{tree.root()};
    for (std::size_t n = 0; !open.empty(); ++n) {
      const auto v = open.back();
      open.pop_back();
      if (n % 8 == 0) squares_.push_back(0);
      if (tree.is_leaf(v)) continue;
      squares_.back() = static_cast<std::uint8_t>(squares_.back() | 1U << n % 8);
      for (int q = 4; q-- > 0;) open.push_back(tree.child(v, q));
    }
  }

  std::string text() const {
    std::string text;
    text.reserve(60000 + mesh_.points.size() * 22 + mesh_.triangles.size() * 18);
    add_beginning(text);
    add_head(text);
    add_arrays(text);
    text.append("<script>").append(page_model).append(page_renderers).append(page_view);
    return text += "</script>\n</body>\n</html>\n";
  }

private:
  /// The page asks for nothing from anywhere, and its browser makes sure.
  void add_beginning(std::string& text) const {
    const std::string title = escaped(options_.title());
    text += "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
            "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; script-src "
            "'unsafe-inline'; "
            "style-src 'unsafe-inline'; img-src data:\">\n"
            "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
            "<meta name=\"generator\" content=\"Quadtree_mesh_2\">\n<link rel=\"icon\" "
            "href=\"data:,\">\n<title>" +
            title + "</title>\n<style>";
    text.append(page_style).append("</style>\n</head>\n<body>\n<header id=\"head-line\">\n<h1>");
    text.append(title).append("</h1>").append(page_body);
  }

  void add_head(std::string& text) const {
    constexpr const char* colors[] = {"least_angle", "largest_angle", "size", "region", "none"};
    text += "<script type=\"application/json\" id=\"head\">{\"first\":";
    append_number(text, pslg_.first_number);
    text.append(",\"color\":\"").append(colors[static_cast<std::size_t>(options_.color_by())]);
    text += "\",\"attributes\":[";
    for (std::size_t r = 0; r < pslg_.regions.size(); ++r)
      text.append(r > 0 ? "," : "").append(number(pslg_.regions[r].attribute));
    text.append("]").append(root_).append("}</script>\n");
  }

  void add_arrays(std::string& text) const {
    const auto& points = mesh_.points;
    add_array<double>(text, "points", 2 * points.size(), [&points](std::size_t i) {
      return as_double(i % 2 == 0 ? points[i / 2].x() : points[i / 2].y());
    });
    const auto& shown = options_.coordinates();
    if (!shown.empty())
      add_array<double>(text, "coordinates", 2 * shown.size(),
                        [&shown](std::size_t i) { return shown[i / 2][i % 2]; });
    add_vertices(text, "triangles", 3 * mesh_.triangles.size(),
                 [this](std::size_t i) { return mesh_.triangles[i / 3][i % 3].value(); });
    add_vertices(text, "edges", 2 * mesh_.constrained_edges.size(),
                 [this](std::size_t i) { return mesh_.constrained_edges[i / 2].vertices[i % 2].value(); });
    const std::vector<Outside_segment> outside = outside_segments(mesh_, pslg_);
    add_vertices(text, "outside", 2 * outside.size(),
                 [&outside](std::size_t i) { return outside[i / 2].ends[i % 2].value(); });
    const auto& unmet = options_.unmet_triangles();
    add_array<std::uint32_t>(text, "unmet", unmet.size(),
                             [&unmet](std::size_t i) { return unmet[i].value(); });
    add_regions(text);
    if (!root_.empty())
      add_array<std::uint8_t>(text, "quadtree", squares_.size(),
                              [this](std::size_t i) { return squares_[i]; });
  }

  /// Indices of vertices, by words of 16 bits if these are long enough.
  template <class Value_at>
  void add_vertices(std::string& text, const char* name, std::size_t n, const Value_at& value_at) const {
    if (mesh_.points.size() <= 0x10000)
      add_array<std::uint16_t>(text, name, n, value_at);
    else
      add_array<std::uint32_t>(text, name, n, value_at);
  }

  void add_regions(std::string& text) const {
    const std::vector<int>& regions = mesh_.region_of_triangle;
    if (regions.empty()) return;
    const int last = *std::max_element(regions.begin(), regions.end());
    const auto region = [&regions](std::size_t t) { return regions[t]; };
    if (last <= std::numeric_limits<std::int8_t>::max())
      add_array<std::int8_t>(text, "regions", regions.size(), region);
    else if (last <= std::numeric_limits<std::int16_t>::max())
      add_array<std::int16_t>(text, "regions", regions.size(), region);
    else
      add_array<std::int32_t>(text, "regions", regions.size(), region);
  }

  template <class Number, class Value_at>
  static void add_array(std::string& text, const char* name, std::size_t n, const Value_at& value_at) {
    text.append("<script type=\"text/plain\" id=\"").append(name).append("\" data-type=\"");
    text += std::is_floating_point_v<Number> ? "Float" : std::is_signed_v<Number> ? "Int" : "Uint";
    append_number(text, 8 * sizeof(Number));
    text += "\">";
    append_base64<Number>(text, n, value_at);
    text += "</script>\n";
  }

  /// A number of JSON, which has no others than finite ones.
  static std::string number(double value) {
    std::string digits;
    if (std::isfinite(value)) append_number(digits, value);
    return digits.empty() ? "null" : digits;
  }

  static std::string escaped(const std::string& words) {
    std::string result;
    for (const char c : words) {
      const auto special = std::string_view("&<>").find(c);
      constexpr const char* entities[] = {"&amp;", "&lt;", "&gt;"};
      if (special == std::string_view::npos)
        result += c;
      else
        result += entities[special];
    }
    return result;
  }

  const Mesh& mesh_;
  const Pslg& pslg_;
  const Options& options_;
  std::string root_;                  // the root of the quadtree, for the head; empty without one
  std::vector<std::uint8_t> squares_; // eight in each
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_PAGE_PAGE_WRITER_H
