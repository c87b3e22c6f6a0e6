// The modes of the command-line program for points alone.

#include "point_set_program.h"

#include "Point_set_run.h"
#include "Progress_line.h"
#include "mesh_files.h"
#include "mesh_points.h"
#include "rounding_loss.h"
#include "what_to_do.h"

#include "by_mesh_2.h"
#include "in_child.h"
#include "resources.h"
#include "room_in_doubles.h"
#include "thread_limit.h"

#include <CGAL/Pslg_2.h>
#include <CGAL/Quadtree_mesh_2/Point_error.h>
#include <CGAL/Quadtree_mesh_2/internal/frame/points_in_box.h>
#include <CGAL/Quadtree_mesh_2/internal/pslg/part_names.h>
#include <CGAL/mesh_quality_2.h>
#include <CGAL/point_set_lengths_2.h>
#include <CGAL/renumber_mesh_2.h>
#include <CGAL/tags.h>

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace {

using Mode = Command_line::Mode;

const char* domain_of(const Command_line& line) {
  if (line.mode == Mode::POINTS) return "box";
  const bool is_row = line.mode == Mode::BOUNDED &&
                      line.point_set_options.mesh_domain() == CGAL::Point_set_mesh_options_2::Domain::ROW;
  return is_row ? "row" : "square";
}

/// An error of points as the user wrote them: the arithmetic may have scaled them.
std::runtime_error with_coordinates(const CGAL::Quadtree_mesh_2::Point_error& error,
                                    const CGAL::Pslg_2<Point_set_run::Point_2>& input,
                                    const Command_line& line) {
  const auto name = [&input](std::size_t p) {
    return CGAL::Quadtree_mesh_2::internal::numbered_place(input, p, input.vertices[p]);
  };
  const std::string advice = what_to_do(error, line);
  const std::size_t p(error.point());
  if (!error.other().is_valid())
    return std::runtime_error("point " + name(p) + ' ' + error.reason() + advice);
  const auto [a, b] = std::minmax({p, std::size_t(error.other())});
  return std::runtime_error("points " + name(a) + " and " + name(b) + ' ' + error.reason() + advice);
}

void mesh(Point_set_run& run, const Command_line& line) try {
  Progress_line progress;
  CGAL::Point_set_mesh_options_2 options = line.point_set_options;
  if (!line.is_quiet && Progress_line::is_possible())
    options.progress([&progress](double share) { return progress.show(share), true; });
  switch (line.kernel) {
  case Command_line::Kernel::FILTERED:
    run.mesh = mesh_points::with_doubles(run.input.vertices, options, run.report);
    return;
  case Command_line::Kernel::FIXED:
    run.mesh = mesh_points::in_words(run.input.vertices, options, run.report);
    return;
  case Command_line::Kernel::EXACT:
    run.mesh = mesh_points::exactly(run.input.vertices, options, run.report);
    return;
  }
} catch (const CGAL::Quadtree_mesh_2::Point_error& error) {
  throw with_coordinates(error, run.input, line);
}

void check(Point_set_run& run) {
  using Options = CGAL::Mesh_quality_options_2;
  run.quality = CGAL::mesh_quality_2<CGAL::Parallel_tag>(run.mesh, run.input,
                                                         Options().check_domain(Options::Domain::ANY));
  check_valid(run.quality); // before angles are measured, which need places
  run.ours.vertices = run.quality.vertices;
  count_angles(run);
}

/// The mesh that is written, once it is checked.
void renumber(Point_set_run& run) {
  const auto numbers = CGAL::renumber_by_place<CGAL::Parallel_tag>(run.mesh);
  numbers.renumber(run.report);
  for (auto& unmet : run.unmet_triangles) unmet.triangle = std::size_t(numbers.new_triangle[unmet.triangle]);
}

mesh_files::Picture picture_of(const Point_set_run& run, const Command_line& line) {
  std::vector<CGAL::Quadtree_mesh_2::Triangle_index> unmet;
  for (const auto& triangle : run.unmet_triangles) unmet.emplace_back(triangle.triangle);
  return {line.colors,      line.is_quadtree_shown,
          line.page_colors, std::filesystem::path(line.input).filename().string(),
          std::move(unmet), nullptr};
}

void compare(Point_set_run& run) {
  const auto peer = [&] {
    return figures_by_Mesh_2(CGAL::Quadtree_mesh_2::internal::points_in_box(run.input.vertices),
                             run.promise.least, 0);
  };
  run.is_peer_asked = true;
  run.peer = in_child(peer, peer_limit_seconds).result;
}

} // namespace

Exit_status execute_point_set(const Command_line& line) {
  Point_set_run run;
  run.mode = line.mode;
  run.domain = domain_of(line);
  run.promise = angle_promise(line.mode, line.point_set_options);
  run.threads = line.threads.value_or(Thread_limit::greatest());
  const Thread_limit limit(run.threads);
  timed(run.read_seconds, [&] { run.input = mesh_files::read_points(line.input, {{}, line.layer}); });
  timed(run.ours.seconds, [&] {
    if (line.kernel != Command_line::Kernel::FILTERED &&
        (line.mode == Mode::BOUNDED || line.mode == Mode::ACUTE))
      check_room_in_doubles(run.input);
    mesh(run, line);
  });
  check(run);
  if (line.kernel != Command_line::Kernel::FILTERED && run.report.is_met() && !run.unmet_triangles.empty())
    refuse_what_rounding_broke(run.input, run.unmet_triangles,
                               line.kernel == Command_line::Kernel::EXACT ? "exact numbers"
                                                                          : "words of 64 bits");
  if (line.are_lengths_wanted) run.lengths = CGAL::point_set_lengths_2(run.input.vertices);
  if (line.is_comparison_wanted) compare(run);
  if (line.is_renumbering_wanted) timed(run.write_seconds, [&] { renumber(run); });
  const auto add_mesh = [&](mesh_files::Files& files, const std::string& output) {
    timed(run.write_seconds, [&] {
      const mesh_files::Details details{line.pieces, line.msh_version, line.element_order, line.cells};
      mesh_files::add(files, output, run.mesh, run.input, picture_of(run, line), details);
    });
    run.peak_memory_mb = peak_memory_mb();
  };
  run.peak_memory_mb = peak_memory_mb();
  write_all(
      line, add_mesh, [&] { return run_json(run); }, [&] { print_run(run); });
  return is_bound_met(run) ? Exit_status::DONE : Exit_status::BOUND_UNMET;
}
