#ifndef QUADTREE_MESH_2_EXAMPLES_PROGRAM_STEPS_H
#define QUADTREE_MESH_2_EXAMPLES_PROGRAM_STEPS_H

// What quality_mesh does with graphs and with points alike.

#include "resources.h"

#include <CGAL/mesh_quality_2.h>

#include <nlohmann/json.hpp>

#include <fstream>
#include <iostream>
#include <stdexcept>
#include <string>

enum Exit_status { DONE = 0, BOUND_UNMET = 1, BAD_USAGE_OR_INPUT = 2 };

/// How long Mesh_2, which has inputs on which it does not end, may try.
constexpr unsigned peer_limit_seconds = 600;

/// Calls `work` and adds the processor seconds it took to `seconds`.
template <class F>
void timed(double& seconds, F work) {
  const double start = cpu_seconds();
  work();
  seconds += cpu_seconds() - start;
}

/// A mesh with errors is our mistake and none of the user's, who gets it all the same, with a warning.
inline void warn_of_errors(const CGAL::Mesh_quality_2& quality) {
  for (const std::string& error : quality.errors)
    std::cerr << "quality_mesh: the mesh is invalid: " << error << '\n';
}

inline void write_report(const std::string& file_name, const nlohmann::ordered_json& json) {
  std::ofstream out(file_name);
  out << json.dump(2) << '\n';
  if (!out.flush()) throw std::runtime_error("cannot write '" + file_name + "'");
}

#endif // QUADTREE_MESH_2_EXAMPLES_PROGRAM_STEPS_H
