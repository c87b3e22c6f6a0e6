// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef QUADTREE_MESH_2_EXAMPLES_WHAT_TO_DO_H
#define QUADTREE_MESH_2_EXAMPLES_WHAT_TO_DO_H

// What users of quality_mesh can do about an input that is refused. The meshers say what is wrong; they do not know the
// program's options.

#include "command_line.h"

#include <CGAL/Pslg_error_2.h>
#include <CGAL/Quadtree_mesh_2/Point_error.h>

#include <string>

/// What advice about a graph depends on, beside the command line.
struct Advised_graph {
  bool has_vertices, has_segments, has_holes;
  /// Put behind options that only the program for one machine has.
  std::string of_other_program;

  template <class Pslg>
  static Advised_graph of(const Pslg& graph) {
    return {!graph.vertices.empty(), !graph.segments.empty(), !graph.holes.empty(), ""};
  }
};

namespace what_to_do_internal {

using Options = CGAL::Quality_mesh_options_2;

inline bool is_by_quadtrees(const Command_line& line) {
  return line.options.separate() == Options::Separation::THEOREM_5;
}

/// Adds the arithmetic that has fewer limits, if it is not the one that was used.
inline std::string or_exactly(const std::string& advice, const Command_line& line,
                              const std::string& of_other_program = "") {
  if (line.kernel == Command_line::Kernel::EXACT) return advice;
  return advice + ", or use --kernel exact" + of_other_program;
}

/// Only refinement over exact numbers has no limit.
inline std::string about_distances(const Advised_graph& graph, const Command_line& line) {
  const std::string advice = or_exactly("; merge what is so near", line, graph.of_other_program);
  if (!is_by_quadtrees(line)) return advice;
  const bool is_exact = line.kernel == Command_line::Kernel::EXACT;
  return advice + (is_exact ? ", or use --separation on-demand" : " with --separation on-demand");
}

inline std::string about_domain(const CGAL::Pslg_error_2& error, const Advised_graph& graph,
                                const Command_line& line) {
  if (!graph.has_segments)
    return ", only points: use --mode points, bounded, acute or warped" + graph.of_other_program;
  const bool is_open = !error.parts().vertices.empty();
  const std::string advice = is_open ? "; close the border" : "";
  if (line.options.mesh_domain() == Options::Domain::MARKED)
    return advice + (is_open ? ", " : "; ") + "add points of regions, or use --domain enclosed";
  return graph.has_holes ? advice + (is_open ? ", or " : "; ") + "remove points of holes" : advice;
}

inline std::string about_size(const CGAL::Pslg_error_2& error, const Command_line& line) {
  const bool is_gap = !error.parts().segments.empty(), is_place = !error.parts().vertices.empty();
  const std::string more = "allow more by --max-vertices";
  if (is_gap && is_by_quadtrees(line)) return "; widen or remove what is so narrow, or " + more;
  if (is_gap) return "; widen or remove what is so narrow, pass over it by --min-edge, or " + more;
  if (is_place) return "; " + more;
  return line.options.max_vertices() > 0 ? "; raise these, or " + more : "; raise these";
}

} // namespace what_to_do_internal

/// Goes behind the message of the error; empty where that says it all.
inline std::string what_to_do(const CGAL::Pslg_error_2& error, const Advised_graph& graph,
                              const Command_line& line) {
  using Kind = CGAL::Pslg_error_2::Kind;
  using namespace what_to_do_internal;
  switch (error.kind()) {
  case Kind::OUT_OF_RANGE:
    return or_exactly("; scale or move the input", line, graph.of_other_program);
  case Kind::CROSSING:
    return "; give both a vertex where they cross, or use --repair" + graph.of_other_program;
  case Kind::TOO_NEAR:
    return about_distances(graph, line);
  case Kind::NO_DOMAIN:
    return about_domain(error, graph, line);
  case Kind::TOO_MANY_TRIANGLES:
    return about_size(error, line);
  case Kind::NO_AREA:
    return graph.has_vertices ? "" : " in " + line.input;
  case Kind::UNREADABLE_FILE:
  case Kind::ARRAY_LENGTH:
  case Kind::NO_SUCH_VERTEX:
  case Kind::NOT_FINITE:
  case Kind::ZERO_LENGTH:
  case Kind::AMBIGUOUS_SEED:
  case Kind::INVALID_MESH:
  case Kind::ROUNDING:
    break;
  }
  return "";
}

/// The same for points alone.
inline std::string what_to_do(const CGAL::Quadtree_mesh_2::Point_error& error, const Command_line& line) {
  using Kind = CGAL::Quadtree_mesh_2::Point_error::Kind;
  using namespace what_to_do_internal;
  switch (error.kind()) {
  case Kind::OUT_OF_RANGE:
    return or_exactly("; scale or move the input", line);
  case Kind::INDISTINGUISHABLE:
    return or_exactly("; merge them", line);
  case Kind::TOO_NEAR:
    return line.mode == Command_line::Mode::POINTS
               ? "; merge them"
               : "; merge them, or use --mode points, which leaves small angles between them";
  case Kind::NOT_FINITE:
    break;
  }
  return "";
}

#endif // QUADTREE_MESH_2_EXAMPLES_WHAT_TO_DO_H
