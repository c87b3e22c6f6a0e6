// The command-line program: meshes a planar straight-line graph, or points alone, or refines a mesh, and writes the
// mesh.

#include "internal/Large_run.h"
#include "internal/Meshing_run.h"
#include "internal/Progress_line.h"
#include "internal/by_mesh_2.h"
#include "internal/command_line.h"
#include "internal/help.h"
#include "internal/mesh_files.h"
#include "internal/mesh_graph.h"
#include "internal/point_set_program.h"
#include "internal/program_steps.h"
#include "internal/projected_graph.h"
#include "internal/refined_mesh.h"
#include "internal/repaired_graph.h"
#include "internal/rounding_loss.h"
#include "internal/what_to_do.h"

#include "in_child.h"
#include "resources.h"
#include "thread_limit.h"

#include <CGAL/Pslg_error_2.h>
#include <CGAL/Quadtree_mesh_2/new_in_scratch_memory.h> // of this program's own long vectors and strings
#include <CGAL/Segments_sizing_field_2.h>
#include <CGAL/add_convex_hull_2.h>
#include <CGAL/mesh_in_projection_2.h>
#include <CGAL/mesh_quality_2.h>
#include <CGAL/renumber_mesh_2.h>
#include <CGAL/tags.h>

#ifdef CGAL_LINKED_WITH_HDF5
#include <hdf5.h>
#endif

#include <algorithm>
#include <cmath>
#include <csignal>
#include <cstddef>
#include <exception>
#include <filesystem>
#include <iostream>
#include <new>
#include <optional>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>

namespace {

using Size_field = CGAL::Quality_mesh_options_2::Size_field;

/// The smaller of both; an empty field is no bound.
Size_field least(Size_field a, Size_field b) {
  if (!a || !b) return a ? a : b;
  return [a = std::move(a), b = std::move(b)](double x, double y) { return std::min(a(x, y), b(x, y)); };
}

/// By how much sizes grow over a unit of length.
/// \param own what they would grow by without a limit
double limited_gradation(double own, const Command_line& line) {
  return line.gradation > 0 ? std::min(own, line.gradation) : own;
}

/// The least of the sizes from files; empty if there are none.
/// \param projection in whose plane they are asked for; null: none
Size_field size_field(const Command_line& line, const CGAL::Conformal_projection_2* projection) {
  Size_field points, grid;
  if (!line.size_points_file.empty())
    points = mesh_files::read_sized_points(line.size_points_file, projection, limited_gradation(0.5, line));
  if (!line.size_grid_file.empty()) grid = mesh_files::read_size_grid(line.size_grid_file, line.gradation);
  if (grid && projection != nullptr)
    grid = [of_degrees = grid, p = *projection](double x, double y) {
      const auto place = p.inverse(x, y);
      return of_degrees(place[0], place[1]) * p.scale(place[1]);
    };
  return least(points, grid);
}

/// Sizes by the distance from the graph, in its own plane; empty if nobody wants them.
Size_field size_from_features(const mesh_graph::Pslg& pslg, const Command_line& line) {
  if (!line.feature_sizes || pslg.vertices.empty()) return nullptr;
  const auto [size, gradation] = *line.feature_sizes;
  return CGAL::Segments_sizing_field_2(pslg, size, limited_gradation(gradation, line));
}

mesh_graph::Mesh mesh_in_plane(const mesh_graph::Pslg& pslg, CGAL::Quality_mesh_options_2 options,
                               const Command_line& line, CGAL::Quality_mesh_report_2& report) try {
  options.size(least(options.size(), size_from_features(pslg, line)));
  switch (line.kernel) {
  case Command_line::Kernel::FILTERED:
    break;
  case Command_line::Kernel::FIXED:
    return mesh_graph::in_words(pslg, options, line.neighbors, report);
  case Command_line::Kernel::EXACT:
    return mesh_graph::exactly(pslg, options, line.neighbors, report);
  }
  return mesh_graph::with_doubles(pslg, options, line.neighbors, report);
} catch (const CGAL::Pslg_error_2& error) {
  throw std::runtime_error(error.what() + what_to_do(error, Advised_graph::of(pslg), line));
}

/// Meshes a graph in degrees, whose reports then have places in degrees.
void mesh_projected(Meshing_run& run, const CGAL::Quality_mesh_options_2& options,
                    const Command_line& line) try {
  const auto options_in_plane = CGAL::options_in_projection_2(options);
  const auto mesher = [&](const mesh_graph::Pslg& meters) {
    try {
      return mesh_in_plane(meters, options_in_plane, line, run.report);
    } catch (const std::runtime_error& error) {
      throw std::runtime_error("in meters of the projection, which --project none leaves out: " +
                               std::string(error.what()));
    }
  };
  run.mesh = projected_graph::mesh(run.pslg, mesher, options, *run.projected);
  for (auto& unmet : run.report.unmet_triangles)
    unmet.centroid = run.projected->projection.inverse(unmet.centroid[0], unmet.centroid[1]);
} catch (const CGAL::Pslg_error_2& error) {
  throw std::runtime_error(error.what() + what_to_do(error, Advised_graph::of(run.pslg), line));
}

/// The same for a mesh that is given.
void refine(Meshing_run& run, const CGAL::Quality_mesh_options_2& options, const Command_line& line) try {
  run.mesh = refined_mesh(*run.given, run.pslg, run.areas, options, run.report, run.kept_vertices);
} catch (const CGAL::Pslg_error_2& error) {
  throw std::runtime_error(error.what() + what_to_do(error, Advised_graph::of(run.pslg), line));
}

void mesh(Meshing_run& run, const Command_line& line) {
  Progress_line progress;
  CGAL::Quality_mesh_options_2 options = line.options;
  options.size(size_field(line, run.projected ? &run.projected->projection : nullptr));
  if (!line.is_quiet && Progress_line::is_possible())
    options.progress([&progress](double share) { return progress.show(share), true; });
  if (run.given) return refine(run, options, line);
  if (run.projected) return mesh_projected(run, options, line);
  run.mesh = mesh_in_plane(run.pslg, options, line, run.report);
}

CGAL::Mesh_quality_options_2::Domain rule_to_check(CGAL::Quality_mesh_options_2::Domain domain) {
  using Rule = CGAL::Mesh_quality_options_2::Domain;
  switch (domain) {
  case CGAL::Quality_mesh_options_2::Domain::ENCLOSED:
    return Rule::ENCLOSED_BY_SEGMENTS;
  case CGAL::Quality_mesh_options_2::Domain::MARKED:
    return Rule::MARKED_BY_REGIONS;
  case CGAL::Quality_mesh_options_2::Domain::NESTING_PARITY:
    return Rule::NESTING_PARITY;
  }
  return Rule::ENCLOSED_BY_SEGMENTS;
}

/// Of a mesh whose input vertices may be anywhere.
CGAL::Mesh_quality_2 quality(const mesh_graph::Mesh& mesh, const mesh_graph::Pslg& pslg,
                             const CGAL::Mesh_quality_options_2& wanted) {
  if (mesh.input_index.empty()) return CGAL::mesh_quality_2<CGAL::Parallel_tag>(mesh, pslg, wanted);
  mesh_graph::Mesh by_input = mesh;
  CGAL::renumber_by_input(by_input);
  return CGAL::mesh_quality_2<CGAL::Parallel_tag>(by_input, pslg, wanted);
}

/// Bounds are kept in the plane of projection; all else has to be right in degrees, too.
void check_in_degrees(Meshing_run& run, const CGAL::Quality_mesh_options_2& options) {
  for (auto& unmet : run.quality.unmet_triangles)
    unmet.centroid = run.projected->projection.inverse(unmet.centroid[0], unmet.centroid[1]);
  const auto wanted =
      CGAL::Mesh_quality_options_2().min_angle(0).check_domain(rule_to_check(options.mesh_domain()));
  const auto in_degrees = CGAL::mesh_quality_2<CGAL::Parallel_tag>(run.mesh, run.pslg, wanted);
  run.quality.number_of_errors += in_degrees.number_of_errors;
  for (const std::string& error : in_degrees.errors) run.quality.errors.push_back("in degrees, " + error);
}

void check(Meshing_run& run, const Command_line& line) {
  const CGAL::Quality_mesh_options_2& options = line.options;
  auto wanted = CGAL::Mesh_quality_options_2()
                    .min_angle(options.min_angle())
                    .max_angle(options.max_angle())
                    .max_edge(options.max_edge())
                    .max_area(options.max_area())
                    .check_domain(rule_to_check(options.mesh_domain()));
  const auto& pslg = run.projected ? run.projected->graph : run.pslg;
  const auto& mesh = run.projected ? run.projected->mesh : run.mesh;
  if (line.kernel == Command_line::Kernel::FIXED) wanted.coordinate_unit(mesh_graph::unit_of_words(pslg));
  run.quality = quality(mesh, pslg, wanted);
  if (run.projected) check_in_degrees(run, options);
  run.ours.vertices = run.quality.vertices;
  Mesh_figures_builder(run.ours, options.min_angle(), options.max_angle())
      .add_triangles_of(run.projected ? run.projected->images : run.mesh);
}

/// Reports bounds that the mesher met but that rounding the mesh to doubles broke: the coordinates are the reason.
void note_what_rounding_broke(Meshing_run& run) {
  using Report = CGAL::Quality_mesh_report_2;
  std::set<std::size_t> known;
  for (const auto& unmet : run.report.unmet_triangles) known.insert(std::size_t(unmet.triangle));
  for (const auto& unmet : run.quality.unmet_triangles)
    if (known.insert(std::size_t(unmet.triangle)).second)
      run.report.unmet_triangles.push_back(
          {unmet.triangle, unmet.centroid, unmet.least_angle, Report::Reason::COORDINATES});
}

/// In files, the input of a refined mesh is the mesh that was read. The graph found in it may have left vertices out.
void name_vertices_as_read(Meshing_run& run) {
  run.mesh.input_index.clear();
  run.mesh.number_of_input_vertices = run.kept_vertices;
}

/// Our other separation, with the same bounds.
void mesh_the_other_way(Meshing_run& run, const Command_line& line) try {
  using Separation = CGAL::Quality_mesh_options_2::Separation;
  CGAL::Quality_mesh_options_2 options = line.options;
  options.separate(meshing_run_internal::other_way(options.separate())).size(size_field(line, nullptr));
  options.checkpoints(""); // a state is of one way only
  if (options.separate() == Separation::THEOREM_5 && options.min_edge() > 0)
    throw std::runtime_error("--min-edge has no meaning with --separation theorem-5");
  if (options.separate() == Separation::THEOREM_5 &&
      options.keep_borders() != CGAL::Quality_mesh_options_2::Keep_borders::NONE)
    throw std::runtime_error("--separation theorem-5 cuts all segments, also those of --keep-borders");
  CGAL::Quality_mesh_report_2 report;
  mesh_graph::Mesh mesh;
  Mesh_figures figures;
  timed(figures.seconds, [&] { mesh = mesh_in_plane(run.pslg, options, line, report); });
  figures.vertices = mesh.points.size();
  Mesh_figures_builder(figures, options.min_angle(), options.max_angle()).add_triangles_of(mesh);
  run.other = figures;
} catch (const std::runtime_error& error) {
  run.why_no_other = error.what();
}

void compare(Meshing_run& run, const Command_line& line) {
  const auto& options = line.options;
  const auto peer = [&] { return figures_by_Mesh_2(run.pslg, options.min_angle(), options.max_edge()); };
  run.is_peer_asked = true;
  mesh_the_other_way(run, line);
  run.peer = in_child(peer, peer_limit_seconds).result;
}

/// The mesh that is written, once it is checked.
void renumber(Meshing_run& run) {
  const auto numbers = CGAL::renumber_by_place<CGAL::Parallel_tag>(run.mesh);
  numbers.renumber(run.report);
  for (auto& unmet : run.quality.unmet_triangles)
    unmet.triangle = numbers.new_triangle[std::size_t(unmet.triangle)];
}

mesh_files::Picture picture_of(const Meshing_run& run, const Command_line& line) {
  std::set<CGAL::Quadtree_mesh_2::Triangle_index> unmet;
  for (const auto& triangle : run.report.unmet_triangles) unmet.insert(triangle.triangle);
  for (const auto& triangle : run.quality.unmet_triangles) unmet.insert(triangle.triangle);
  return {line.colors,
          line.is_quadtree_shown,
          line.page_colors,
          std::filesystem::path(line.input).filename().string(),
          {unmet.begin(), unmet.end()},
          run.projected ? &run.projected->projection : nullptr};
}

void read(Meshing_run& run, const Command_line& line) {
  using mesh_files::Points_alone;
  mesh_files::Input input =
      mesh_files::read_graph(line.input, {line.properties, line.layer},
                             line.is_hull_wanted ? Points_alone::ALLOWED : Points_alone::REFUSED);
  if (!line.area_file.empty()) run.areas = mesh_files::read_areas(line.area_file, input);
  run.pslg = std::move(input.graph);
  run.given = std::move(input.mesh);
  if (line.is_hull_wanted) CGAL::add_convex_hull_2(run.pslg);
  if (line.is_repair_wanted) run.pslg = repaired_graph(run.pslg, run.repair.emplace());
  run.projected = projected_graph::projection(run.pslg, input.coordinates, line);
  if (run.projected && command_line_internal::has_output_of(line, {Output_format::TRIANGLE_VORONOI}))
    throw std::runtime_error("the files .v.node and .v.edge have no meaning for a mesh in degrees: write "
                             ".cells.geojson, or use --project none");
  run.may_be_in_degrees = !run.projected && !line.is_projection_said &&
                          input.coordinates != CGAL::Coordinate_system_2::PLANE &&
                          projected_graph::may_be_in_degrees(run.pslg);
}

Exit_status execute(const Command_line& line, const Large_run& large) {
  Meshing_run run;
  run.threads = line.threads.value_or(Thread_limit::greatest());
  const Thread_limit limit(run.threads);
  timed(run.read_seconds, [&] { read(run, line); });
  large.begin(run.pslg.number_of_vertices(), line.is_quiet);
  timed(run.ours.seconds, [&] { mesh(run, line); });
  check(run, line);
  check_valid(run.quality);
  if (run.given) name_vertices_as_read(run);
  if (line.kernel == Command_line::Kernel::EXACT && !run.projected && run.report.is_met() &&
      !run.quality.is_met())
    refuse_what_rounding_broke(run.pslg, run.quality.unmet_triangles, "exact numbers");
  if (line.kernel != Command_line::Kernel::FILTERED || run.projected) note_what_rounding_broke(run);
  run.peak_memory_mb = peak_memory_mb();
  if (line.is_comparison_wanted) compare(run, line);
  if (line.is_renumbering_wanted) timed(run.write_seconds, [&] { renumber(run); });
  const auto add_mesh = [&](mesh_files::Files& files, const std::string& output) {
    timed(run.write_seconds, [&] {
      const mesh_files::Details details{line.pieces, line.msh_version, line.element_order, line.cells,
                                        run.projected ? &run.projected->projection : nullptr};
      mesh_files::add(files, output, run.mesh, run.pslg, picture_of(run, line), details);
    });
    if (!line.is_comparison_wanted) run.peak_memory_mb = peak_memory_mb(); // else it is that of both meshes
  };
  write_all(
      line, add_mesh, [&] { return run_json(run); }, [&] { print_run(run, line.options); });
  large.clean_up();
  return is_bound_met(run) ? Exit_status::DONE : Exit_status::BOUND_UNMET;
}

Exit_status execute_in_scratch(Command_line line) {
  std::optional<Standard_output> output; // before anything is printed
  if (std::any_of(line.outputs.begin(), line.outputs.end(), is_standard_stream))
    line.standard_output = &output.emplace();
  const Large_run large(line);
  if (line.mode == Command_line::Mode::PSLG) return execute(line, large);
  return execute_point_set(line);
}

Exit_status run(const Command_line& line) {
  switch (line.task) {
  case Command_line::Task::PRINT_HELP:
    print_help(std::cout);
    break;
  case Command_line::Task::PRINT_ALL_OPTIONS:
    print_all_options(std::cout);
    break;
  case Command_line::Task::PRINT_VERSION:
    print_version(std::cout);
    break;
  case Command_line::Task::MESH:
    return execute_in_scratch(line);
  }
  return std::cout.flush() ? Exit_status::DONE : Exit_status::REFUSED;
}

int fail(const std::string& message) {
  std::cerr << "quality_mesh: error: " << message << '\n';
  return static_cast<int>(Exit_status::REFUSED);
}

} // namespace

int main(int argc, char** argv) try {
  std::signal(SIGXFSZ, SIG_IGN); // a file that may not get longer is an error like a full disk
#ifdef CGAL_LINKED_WITH_HDF5
  H5dont_atexit(); // or it would try again to write what it could not, and complain
#endif
  return static_cast<int>(run(parse_command_line(argc, argv)));
} catch (const Usage_error& error) {
  return fail(std::string(error.what()) + " (see quality_mesh --help-all)");
} catch (const CGAL::Quadtree_mesh_2::Scratch_full& error) {
  return fail(std::string(error.what()) + ": make room, or name another folder by --scratch");
} catch (const std::bad_alloc&) {
  return fail("not enough memory");
} catch (const std::exception& error) {
  return fail(error.what());
}
