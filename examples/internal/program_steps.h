#ifndef QUADTREE_MESH_2_EXAMPLES_PROGRAM_STEPS_H
#define QUADTREE_MESH_2_EXAMPLES_PROGRAM_STEPS_H

// What quality_mesh does with graphs and with points alike.

#include "Deferred_signals.h"
#include "command_line.h"

#include "measurement.h"

#include <CGAL/Quadtree_mesh_2/internal/io/Replaced_files.h>
#include <CGAL/mesh_quality_2.h>

#include <cerrno>
#include <cstdio>
#include <stdexcept>
#include <string>
#include <system_error>

/// As the user manual has it, where what each means is said.
enum class Exit_status { DONE = 0, BOUND_UNMET = 1, REFUSED = 2 };

/// How long Mesh_2, which has inputs on which it does not end, may try.
constexpr unsigned peer_limit_seconds = 600;

/// Calls `work` and adds the time it took to `seconds`.
template <class F>
void timed(Seconds& seconds, F work) {
  const Stopwatch watch;
  work();
  seconds += watch.seconds();
}

/// A mesh with errors would be our mistake and none of the user's, who had better not get it.
/// \throws std::runtime_error with the errors
inline void check_valid(const CGAL::Mesh_quality_2& quality) {
  if (quality.is_valid()) return;
  std::string message = "the mesh came out wrong, so nothing is written (numbers count from 0)";
  for (const std::string& error : quality.errors) message += "; " + error;
  throw std::runtime_error(message);
}

/// Puts all that is wanted in place at once, or nothing: the meshes, the report, and the figures on the screen.
/// \param add_mesh called with the files and the name of each output
/// \param json makes the report
/// \param print prints the figures
/// \throws std::exception if something cannot be written
template <class Add_mesh, class Make_json, class Print>
void write_all(const Command_line& line, const Add_mesh& add_mesh, const Make_json& json,
               const Print& print) {
  const Deferred_signals signals; // acts when the temporary files are gone
  CGAL::Quadtree_mesh_2::internal::Replaced_files files;
  for (const std::string& output : line.outputs) {
    if (is_standard_stream(output)) files.direct(output, line.standard_output->file(), "standard output");
    add_mesh(files, output);
    signals.check();
  }
  if (!line.report_file.empty()) files.add(line.report_file, json().dump(2) + '\n');
  if (!line.is_quiet) {
    print();
    if (std::fflush(stdout) != 0)
      throw std::system_error(errno, std::generic_category(), "the figures cannot be printed");
  }
  signals.check();
  files.commit();
}

#endif // QUADTREE_MESH_2_EXAMPLES_PROGRAM_STEPS_H
