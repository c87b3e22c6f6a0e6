#ifndef QUADTREE_MESH_2_EXAMPLES_COMMAND_LINE_H
#define QUADTREE_MESH_2_EXAMPLES_COMMAND_LINE_H

// The options of quality_mesh: what they are and what they may be.

#include "command_line_types.h"
#include "file_formats.h"
#include "option_descriptions.h"
#include "option_uses.h"
#include "option_values.h"
#include "output_options.h"
#include "program_files.h"
#include "standard_streams.h"
#include "stream_options.h"
#include "thread_limit.h"

#include "mesh_graph.h"

#include <CGAL/Feature_properties_2.h>
#include <CGAL/Point_set_mesh_options_2.h>
#include <CGAL/Quadtree_mesh_2/internal/Mesh_checkpoints.h>
#include <CGAL/Quality_mesh_options_2.h>
#include <CGAL/version.h>

#include <boost/program_options.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <iostream>
#include <iterator>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

namespace command_line_internal {

/// \throws Usage_error if no edge can keep to it and to the longest one, too
inline double least_edge(const po::variables_map& given) {
  const double least = bound(given, "min-edge"), most = bound(given, "max-edge");
  if (most > 0 && least >= most) throw Usage_error("--min-edge has to be below --max-edge");
  return least;
}

/// By how much edges, and sizes from files and features, may grow over a unit of length; 0: no limit.
inline double gradation(const po::variables_map& given) {
  const double g = bound(given, "gradation");
  if (g > CGAL::Quality_mesh_options_2::steepest_gradation)
    throw Usage_error("--gradation has to be at most 1, as fast as edges grow without it");
  return g;
}

/// By which factor edges with a common end may differ; 0: no limit.
inline double max_edge_ratio(const po::variables_map& given) {
  const double ratio = bound(given, "max-edge-ratio");
  if (ratio > 0 && ratio < CGAL::Quality_mesh_options_2::least_max_edge_ratio)
    throw Usage_error("--max-edge-ratio has to be at least 3: below that refinement is not known to end");
  return ratio;
}

/// The greatest angle wanted, in degrees; 0: no bound.
inline double max_angle(const po::variables_map& given) {
  const double angle = bound(given, "max-angle");
  if (angle > 0 && !(angle >= CGAL::Quality_mesh_options_2::least_max_angle && angle < 180))
    throw Usage_error("--max-angle has to be at least 105 and below 180 degrees");
  return angle;
}

inline std::optional<Command_line::Feature_sizes> feature_sizes(const po::variables_map& given) {
  if (given.count("size-from-features") == 0) return std::nullopt;
  const auto& numbers = given["size-from-features"].as<std::vector<double>>();
  if (numbers.size() != 2) throw Usage_error("--size-from-features is given more than once");
  if (!(numbers[0] > 0) || !std::isfinite(numbers[0]) || !(numbers[1] >= 0) || !std::isfinite(numbers[1]))
    throw Usage_error("--size-from-features has to be a size above 0, and a growth of at least 0");
  return Command_line::Feature_sizes{numbers[0], numbers[1]};
}

inline double min_angle(const po::variables_map& given) {
  const double value = given["min-angle"].as<double>();
  if (!(value >= 0 && value <= CGAL::Quality_mesh_options_2::greatest_min_angle))
    throw Usage_error("--min-angle has to be from 0 to 34 degrees");
  return value;
}

inline CGAL::Quality_mesh_options_2::Domain domain(const po::variables_map& given) {
  using Domain = CGAL::Quality_mesh_options_2::Domain;
  constexpr Domain rules[] = {Domain::ENCLOSED, Domain::MARKED, Domain::NESTING_PARITY};
  return rules[choice(given, "domain", {"enclosed", "marked", "parity"})];
}

/// The number of threads wanted.
inline std::optional<unsigned> threads(const po::variables_map& given) {
  if (given.count("threads") == 0) return std::nullopt;
  const int most = std::max(256, static_cast<int>(std::thread::hardware_concurrency()));
  const int n = whole_number(given, "threads", {1, most});
  if (n > 1 && !Thread_limit::has_threads)
    throw Usage_error("--threads " + std::to_string(n) +
                      " is not available: this program was built without TBB");
  return static_cast<unsigned>(n);
}

/// A number of rounds.
inline int rounds(const po::variables_map& given, const std::string& option) {
  return whole_number(given, option, {0, 1000});
}

/// \throws Usage_error if thinning is wanted and removal is not.
inline int thinning_rounds(const po::variables_map& given) {
  const int n = rounds(given, "thin");
  if (n > 0 && given.count("no-coarsening") > 0)
    throw Usage_error("--thin has no meaning with --no-coarsening");
  return n;
}

inline CGAL::Quality_mesh_options_2::Separation separation(const po::variables_map& given) {
  using Separation = CGAL::Quality_mesh_options_2::Separation;
  constexpr Separation ways[] = {Separation::ON_DEMAND, Separation::THEOREM_5};
  const Separation way = ways[choice(given, "separation", {"on-demand", "theorem-5"})];
  check_uses_with(given, way);
  return way;
}

inline CGAL::Tree_separation_options_2 tree_options(const po::variables_map& given) {
  using Options = CGAL::Tree_separation_options_2;
  constexpr Options::Subdivision subdivisions[] = {Options::Subdivision::WALKING,
                                                   Options::Subdivision::CENTROID_TREE};
  constexpr Options::Placement placements[] = {Options::Placement::CHOSEN, Options::Placement::BY_RULE};
  const Options::Placement placement = placements[choice(given, "placement", {"chosen", "by-rule"})];
  const int most_rounds = rounds(given, "tree-rounds");
  const bool is_cured = most_rounds > 0 && placement == Options::Placement::CHOSEN; // by refinement
  return (is_cured ? Options().rounds(std::size_t(most_rounds)) : Options::of_theorem())
      .subdivide(subdivisions[choice(given, "subdivision", {"walking", "centroid-tree"})])
      .place(placement);
}

inline mesh_graph::Neighbors neighbors(const po::variables_map& given) {
  using Neighbors = mesh_graph::Neighbors;
  constexpr Neighbors models[] = {Neighbors::QUADTREE, Neighbors::TRAPEZOIDAL};
  return models[choice(given, "neighbors", {"quadtree", "trapezoidal"})];
}

/// \throws Usage_error if a file of HDF5, which is not written from its begin to its end, would go into a pipe
inline void check_is_no_pipe(const std::string& output, const std::filesystem::path& file) {
  const Output_format format = output_format(output);
  if ((format == Output_format::VTKHDF || format == Output_format::XDMF) && std::filesystem::exists(file) &&
      !std::filesystem::is_directory(file) && !std::filesystem::is_regular_file(file))
    throw Usage_error("cannot write '" + file.string() + "': HDF5 needs a regular file");
}

/// \throws Usage_error if a file would be destroyed or cannot be written
inline void check_files(const Command_line& line) {
  Named_files inputs, outputs;
  if (!is_standard_stream(line.input)) inputs.push_back({"the input '" + line.input + "'", line.input});
  if (!line.size_points_file.empty())
    inputs.push_back({"the file of --size-points, '" + line.size_points_file + "'", line.size_points_file});
  if (!line.area_file.empty())
    inputs.push_back({"the file of --area-file, '" + line.area_file + "'", line.area_file});
  if (!line.size_grid_file.empty())
    inputs.push_back({"the file of --size-grid, '" + line.size_grid_file + "'", line.size_grid_file});
  for (const std::string& output : line.outputs)
    if (!is_standard_stream(output))
      for (const std::filesystem::path& file : files_of_output(output)) {
        check_is_no_pipe(output, file);
        outputs.push_back(
            {(file == output ? "" : "'" + file.string() + "' of ") + ("output '" + output + "'"), file});
      }
  if (!line.report_file.empty())
    outputs.push_back({"the file of --report, '" + line.report_file + "',", line.report_file});
  if (std::filesystem::is_directory(line.scratch_folder)) { // else there is nothing in it
    const CGAL::Quadtree_mesh_2::internal::Mesh_checkpoints checkpoints(line.scratch_folder, 0);
    for (const char* ending : {"", ".part"})
      outputs.push_back({"the state in the scratch folder, '" + checkpoints.file_name() + ending + "',",
                         checkpoints.file_name() + ending});
  }
  add_node_file(line.input, outputs, inputs);
  add_files_of_mesh(line.input, inputs);
  std::vector<Pieced_output> pieced;
  for (const std::string& output : line.outputs) {
    const std::string ending = ending_of_pieces(output, line.pieces);
    if (!ending.empty()) pieced.push_back({output, ending});
  }
  check_pieces(inputs, pieced), check_pieces(outputs, pieced);
  ::check_files(inputs, outputs);
}

/// \throws Usage_error if borders are to be kept by the construction by quadtrees
inline CGAL::Quality_mesh_options_2::Keep_borders kept_borders(const po::variables_map& given) {
  using Keep = CGAL::Quality_mesh_options_2::Keep_borders;
  constexpr Keep all[] = {Keep::NONE, Keep::BOUNDARY, Keep::MARKED, Keep::ALL};
  if (given.count("keep-borders") == 0) return Keep::NONE;
  const Keep kept = all[choice(given, "keep-borders", {"none", "boundary", "marked", "all"})];
  if (kept != Keep::NONE && separation(given) == CGAL::Quality_mesh_options_2::Separation::THEOREM_5)
    throw Usage_error("--keep-borders has no meaning with --separation theorem-5, which cuts all segments");
  return kept;
}

inline CGAL::Quality_mesh_options_2 quality_mesh_options(const po::variables_map& given) {
  CGAL::Quality_mesh_options_2 options;
  options.min_angle(min_angle(given))
      .max_edge(bound(given, "max-edge"))
      .max_area(bound(given, "max-area"))
      .min_edge(least_edge(given))
      .gradation(gradation(given))
      .max_edge_ratio(max_edge_ratio(given))
      .max_angle(max_angle(given))
      .mesh_domain(domain(given))
      .smooth(rounds(given, "smooth"))
      .thin(thinning_rounds(given))
      .max_vertices(limit(given, "max-vertices"))
      .separate(tree_options(given))
      .separate(separation(given))
      .keep_borders(kept_borders(given));
  if (given.count("max-steiner") > 0) options.max_steiner_vertices(number_from_0(given, "max-steiner"));
  if (given.count("conforming") > 0) options.conform(CGAL::Quality_mesh_options_2::Conforming::DELAUNAY);
  if (given.count("no-coarsening") > 0) options.coarsen(CGAL::Quality_mesh_options_2::Coarsening::NONE);
  return options;
}

inline CGAL::Point_set_mesh_options_2 bounded_angles(const po::variables_map& given) {
  CGAL::Point_set_mesh_options_2 options;
  if (given.count("square") > 0) options.mesh_domain(CGAL::Point_set_mesh_options_2::Domain::SQUARE);
  if (given.count("angles") == 0) return options.bounded_angles();
  const auto& angles = given["angles"].as<std::vector<double>>();
  if (angles.size() != 2) throw Usage_error("--angles is given more than once");
  if (!(angles[0] >= 0 && angles[0] <= 37.5))
    throw Usage_error("--angles: the least angle has to be from 0 to 37.5 degrees");
  if (!(angles[1] >= 78.6 && angles[1] <= 89.5))
    throw Usage_error("--angles: the largest angle has to be from 78.6 to 89.5 degrees");
  return options.bounded_angles(angles[0], angles[1]);
}

inline CGAL::Point_set_mesh_options_2 point_set_mesh_options(const po::variables_map& given,
                                                             Command_line::Mode mode) {
  CGAL::Point_set_mesh_options_2 options;
  switch (mode) {
  case Command_line::Mode::PSLG:
    return options;
  case Command_line::Mode::POINTS:
    options.least_angle();
    break;
  case Command_line::Mode::BOUNDED:
    options = bounded_angles(given);
    break;
  case Command_line::Mode::ACUTE:
    options.acute();
    break;
  case Command_line::Mode::WARPED:
    options.warped_squares();
    break;
  }
  options.effort(whole_number(given, "effort", {0, 3}));
  if (given.count("budget") > 0) options.max_removals(limit(given, "budget"));
  return options;
}

/// The scratch folder, empty if nothing is kept in one.
/// \throws Usage_error if nobody says where it is, or what for
inline std::string scratch_folder(const po::variables_map& given, const Command_line& line) {
  const std::string folder = text(given, "scratch");
  if (line.memory == 0 && !line.is_resumed) {
    if (!folder.empty()) throw Usage_error("--scratch has a meaning with --memory or --resume only");
    return folder;
  }
  const bool is_on_demand = line.options.separate() == CGAL::Quality_mesh_options_2::Separation::ON_DEMAND;
  if (line.is_resumed &&
      (line.mode != Command_line::Mode::PSLG || line.kernel == Command_line::Kernel::EXACT || !is_on_demand))
    throw Usage_error(
        "--resume has a meaning with --mode pslg, --kernel filtered or fixed, and --separation on-demand "
        "only");
  if (std::find(line.outputs.begin(), line.outputs.end(), folder) != line.outputs.end())
    throw Usage_error("--scratch names a folder, not the output '" + folder + "'");
  if (!folder.empty()) return folder;
  if (line.outputs.empty() || is_standard_stream(line.outputs.front()))
    throw Usage_error("--" + std::string(line.memory > 0 ? "memory" : "resume") +
                      " needs a scratch folder (--scratch FOLDER) or an output (-o FILE)");
  return line.outputs.front() + ".scratch";
}

/// If nothing is said, the format tells, unless something else is asked for that does not go with a projection.
/// \throws Usage_error naming an option that does not go with the projection wanted
inline Command_line::Project project(const po::variables_map& given, const Command_line& line) {
  using Project = Command_line::Project;
  constexpr Project all[] = {Project::NONE, Project::AUTO, Project::MERCATOR, Project::LAMBERT};
  const bool is_said = given.count("project") > 0;
  const Project wanted =
      is_said ? all[choice(given, "project", {"none", "auto", "mercator", "lambert"})] : Project::BY_FORMAT;
  if (wanted == Project::NONE) return wanted;
  const auto refuse = [](const std::string& what) {
    throw Usage_error(what + " has no meaning with --project, unless it is none");
  };
  const bool is_grid_limited = given.count("gradation") > 0 && given.count("size-grid") > 0;
  for (const char* const option : {"memory", "resume", "compare", "gradation", "conforming", "keep-borders"})
    if (given.count(option) > 0 && (is_grid_limited || std::string(option) != "gradation")) {
      if (is_said) refuse(std::string("--") + option);
      return Project::NONE;
    }
  if (line.options.min_angle() < 1) {
    if (is_said) refuse("--min-angle below 1 degree");
    return Project::NONE;
  }
  return wanted;
}

/// \throws Usage_error if a property is wanted of an input that has none
inline CGAL::Feature_properties_2 properties(const po::variables_map& given, const std::string& input) {
  for (const char* const option : {"region-property", "marker-property"})
    if (given.count(option) > 0 && input_format(input) != Input_format::GEOJSON &&
        input_format(input) != Input_format::OGR)
      throw Usage_error("--" + std::string(option) + " has a meaning for GeoJSON and what GDAL reads only");
  return {text(given, "region-property"), text(given, "marker-property")};
}

inline std::string layer(const po::variables_map& given, const std::string& input) {
  if (given.count("layer") > 0 && input_format(input) != Input_format::OGR)
    throw Usage_error("--layer has a meaning for what GDAL reads only, such as .gpkg");
  return text(given, "layer");
}

inline po::variables_map parse(int argc, const char* const* argv) {
  po::options_description all = visible_options();
  all.add_options()("input", po::value<std::vector<std::string>>());
  po::positional_options_description positional;
  positional.add("input", -1);
  // No guessing: an abbreviation that works today would be ambiguous after the next option.
  const int style = po::command_line_style::default_style & ~po::command_line_style::allow_guessing;
  po::variables_map given;
  po::store(po::command_line_parser(argc, argv).options(all).positional(positional).style(style).run(),
            given);
  return given;
}

} // namespace command_line_internal

inline void print_version(std::ostream& out, const char* program = "quality_mesh") {
  out << program << ' ' << QUADTREE_MESH_VERSION << " (CGAL " << CGAL_VERSION_STR << ")\n";
}

/// \throws Usage_error naming the option that is to blame.
inline Command_line parse_command_line(int argc, const char* const* argv) try {
  using namespace command_line_internal;
  const po::variables_map given = parse(argc, argv);
  Command_line line;
  if (given.count("help-all") > 0) return line.task = Command_line::Task::PRINT_ALL_OPTIONS, line;
  if (given.count("help") > 0) return line.task = Command_line::Task::PRINT_HELP, line;
  if (given.count("version") > 0) return line.task = Command_line::Task::PRINT_VERSION, line;

  if (given.count("input") == 0) throw Usage_error("no input given; see --help");
  const auto& inputs = given["input"].as<std::vector<std::string>>();
  if (inputs.size() > 1)
    throw Usage_error("one input at a time, not '" + inputs[0] + "' and '" + inputs[1] + "'");
  line.input = name_of_input(given, inputs.front());
  line.outputs = names_of_outputs(given);
  line.report_file = text(given, "report");

  const std::vector<std::string> modes(std::begin(mode_names), std::end(mode_names));
  line.mode = static_cast<Command_line::Mode>(choice(given, "mode", modes));
  check_option_uses(given, line.mode);
  check_uses_with(given, input_format(line.input));
  line.options = quality_mesh_options(given);
  line.neighbors = neighbors(given);
  line.point_set_options = point_set_mesh_options(given, line.mode);
  line.area_file = text(given, "area-file");
  line.size_points_file = text(given, "size-points");
  line.size_grid_file = text(given, "size-grid");
  line.gradation = gradation(given);
  line.feature_sizes = feature_sizes(given);
  constexpr Command_line::Kernel kernels[] = {Command_line::Kernel::FILTERED, Command_line::Kernel::FIXED,
                                              Command_line::Kernel::EXACT};
  line.kernel = kernels[choice(given, "kernel", {"filtered", "fixed", "exact"})];
  line.threads = threads(given);
  line.is_comparison_wanted = given.count("compare") > 0;
  line.are_lengths_wanted = given.count("lengths") > 0;
  // Points are colored unless it is forbidden: their angles are what the modes differ in.
  line.colors = colors(given, line.mode,
                       line.mode == Command_line::Mode::PSLG ? Picture_colors::NONE : Picture_colors::ANGLE);
  line.page_colors = colors(given, line.mode, Picture_colors::ANGLE);
  line.is_quadtree_shown = given.count("show-quadtree") > 0;
  check_picture_options(given, line.outputs);
  line.is_renumbering_wanted = given.count("renumber") > 0;
  line.pieces = pieces(given, line.outputs);
  check_stream_has_no_pieces(line.outputs, line.pieces);
  line.msh_version = msh_version(given, line);
  line.properties = properties(given, line.input);
  line.layer = layer(given, line.input);
  line.element_order = element_order(given, line);
  line.cells = cells(given, line);
  line.is_hull_wanted = given.count("hull") > 0;
  line.is_repair_wanted = given.count("repair") > 0;
  line.project = project(given, line);
  line.is_projection_said = given.count("project") > 0;
  line.is_quiet = given.count("quiet") > 0;
  line.memory = memory_size(given, "memory");
  line.is_resumed = given.count("resume") > 0;
  line.scratch_folder = scratch_folder(given, line);
  line.is_scratch_folder_ours = given.count("scratch") == 0;
  check_files(line);
  return line;
} catch (const boost::program_options::unknown_option& error) {
  throw Usage_error("unrecognized option '" + error.get_option_name() + "'");
} catch (const boost::program_options::invalid_option_value& error) {
  throw Usage_error(std::string(error.what()) + ": it has to be a number, such as 20, 0.5 or 1e6");
} catch (const boost::program_options::error& error) {
  throw Usage_error(error.what());
}

#endif // QUADTREE_MESH_2_EXAMPLES_COMMAND_LINE_H
