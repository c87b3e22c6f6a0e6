// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// Repairs a graph bin by bin: `world RAW.poly REPAIRED.poly`, for world.sh. The marker of a segment is its bin, 0 for
// none; segments of different bins can meet at their ends only, so that a graph of any size is repaired in the
// memory that one bin takes. Coordinates of 16 bits make coasts that cross themselves here and there: crossings
// become vertices.

#include "resources.h"

#include <CGAL/Bbox_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/IO/read_triangle_files.h>
#include <CGAL/IO/write_triangle_files.h>
#include <CGAL/Pslg_2.h>
#include <CGAL/repair_pslg_2.h>

#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <exception>
#include <numeric>
#include <unordered_map>
#include <utility>
#include <vector>

namespace {

using Point = CGAL::Exact_predicates_inexact_constructions_kernel::Point_2;
using Pslg = CGAL::Pslg_2<Point>;
using Vertex_index = Pslg::Vertex_index;

class Bin_repairer {
public:
  explicit Bin_repairer(const Pslg& raw) : raw_(raw) { result_.vertices = raw.vertices; }

  Pslg run() {
    const auto& bins = raw_.segment_markers;
    std::vector<std::size_t> order(raw_.segments.size());
    std::iota(order.begin(), order.end(), std::size_t(0));
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t s, std::size_t t) { return bins[s] < bins[t]; });
    for (std::size_t i = 0; i < order.size();) {
      const std::size_t begin = i;
      while (i < order.size() && bins[order[i]] == bins[order[begin]]) ++i;
      repair(order.data() + begin, order.data() + i);
    }
    return std::move(result_);
  }

  std::size_t crossings() const { return crossings_; }
  std::size_t split_segments() const { return split_segments_; }
  std::size_t overlapping_segments() const { return overlapping_segments_; }

private:
  const Pslg& raw_;
  Pslg result_;
  std::size_t crossings_ = 0, split_segments_ = 0, overlapping_segments_ = 0;

  /// The corners of a box around the segments, without segments of their own: a graph whose vertices are all on a line
  /// counts as a mistake.
  Pslg frame_of(const std::size_t* begin, const std::size_t* end) const {
    CGAL::Bbox_2 box;
    for (const std::size_t* s = begin; s != end; ++s)
      for (const Vertex_index v : raw_.segments[*s]) box += raw_.point(v).bbox();
    Pslg frame;
    for (const double y : {box.ymin() - 1, box.ymax() + 1})
      for (const double x : {box.xmin() - 1, box.xmax() + 1}) frame.add_vertex(Point(x, y));
    return frame;
  }

  void repair(const std::size_t* begin, const std::size_t* end) {
    Pslg bin = frame_of(begin, end);
    std::vector<Vertex_index> global(
        bin.number_of_vertices()); // per vertex of the bin; of the frame's they are not used
    std::unordered_map<std::size_t, Vertex_index> local;
    const auto local_vertex = [&](Vertex_index v) {
      const auto [place, is_new] = local.emplace(std::size_t(v), Vertex_index(global.size()));
      if (is_new) {
        bin.add_vertex(raw_.point(v));
        global.push_back(v);
      }
      return place->second;
    };
    for (const std::size_t* s = begin; s != end; ++s) {
      const auto& [a, b] = raw_.segments[*s];
      const Vertex_index from = local_vertex(a), to = local_vertex(b);
      bin.add_segment(from, to);
    }
    CGAL::Pslg_repair_options_2 options;
    options.crossings(CGAL::Pslg_crossing_rule_2::SPLIT);
    CGAL::Pslg_repair_report_2 report;
    const Pslg repaired = CGAL::repair_pslg_2(bin, options, report);
    for (std::size_t v = global.size(); v < repaired.vertices.size(); ++v)
      global.push_back(result_.add_vertex(repaired.vertices[v]));
    for (const auto& [a, b] : repaired.segments)
      result_.add_segment(global[std::size_t(a)], global[std::size_t(b)]);
    crossings_ += report.crossings;
    split_segments_ += report.split_segments;
    overlapping_segments_ += report.overlapping_segments;
  }
};

} // namespace

int main(int argc, char** argv) {
  if (argc != 3) {
    std::fprintf(stderr, "usage: world RAW.poly REPAIRED.poly\n");
    return 2;
  }
  try {
    Pslg raw;
    CGAL::IO::read_triangle_poly(argv[1], raw);
    Bin_repairer repairer(raw);
    const Pslg repaired = repairer.run();
    CGAL::IO::write_triangle_poly(argv[2], repaired);
    std::printf("%zu vertices, %zu segments; %zu crossings became vertices, %zu segments were cut, %zu were "
                "covered by "
                "others; %.1f processor seconds, %.0f MB\n",
                repaired.number_of_vertices(), repaired.number_of_segments(), repairer.crossings(),
                repairer.split_segments(), repairer.overlapping_segments(), cpu_seconds(), peak_memory_mb());
  } catch (const std::exception& e) {
    std::fprintf(stderr, "error: %s\n", e.what());
    return 2;
  }
}
