// Meshes a graph on all ranks of MPI, with the options of quality_mesh:
//
//   mpirun -n 4 quality_mesh_mpi INPUT.poly -o mesh.vtkhdf
//   mpirun -n 4 quality_mesh_mpi INPUT.poly -o mesh.vtkhdf --memory 2G --scratch /local/disk
//   mpirun -n 4 --map-by slot:PE=8 quality_mesh_mpi INPUT.poly -o mesh.vtkhdf --threads 8
//
// INPUT is .poly or .h5, of which each rank reads a slice. Outputs are .pvtu with a piece for each rank, .msh with a
// part for each rank, .vtkhdf, and .xdmf with .h5. All ranks write them. They have the bytes that
// `quality_mesh --renumber` writes, with `--pieces` as many as ranks.
//
// The first rank has the triangles of the domain before they are refined; with --memory most of them are in a file on
// its own disk. doc/distributed.md says when it has the whole mesh.

#include "internal/Figures_table.h"
#include "internal/Scratch_folder.h"
#include "internal/command_line.h"
#include "internal/degrees.h"
#include "internal/measurement.h"
#include "internal/mesh_figures.h"
#include "internal/program_steps.h"
#include "internal/report_json.h"
#include "internal/report_words.h"
#include "internal/thread_limit.h"
#include "internal/what_to_do.h"

#include <CGAL/Distributed_quality_mesher_2.h>
#include <CGAL/IO/Distributed_mesh_files.h>
#include <CGAL/IO/read_slices.h>
#include <CGAL/Pslg_error_2.h>
#include <CGAL/Pslg_slice_2.h>
#include <CGAL/Quadtree_mesh_2/internal/distributed/Mpi_exchange.h>
#include <CGAL/Quadtree_mesh_2/internal/distributed/Parcel.h>
#include <CGAL/Quadtree_mesh_2/internal/distributed/agree_on_error.h>
#include <CGAL/Quadtree_mesh_2/internal/io/Replaced_files.h>
#include <CGAL/Quadtree_mesh_2/new_in_scratch_memory.h> // of this program's own long vectors
#include <CGAL/Quality_mesh_report_2.h>
#include <CGAL/Scratch_memory.h>
#include <CGAL/Trapezoidal_vertex_edge_neighbors_2.h>
#include <CGAL/tags.h>

#include <mpi.h>
#include <nlohmann/json.hpp>

#ifdef __GLIBC__
#include <malloc.h>
#endif

#include <algorithm>
#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <exception>
#include <iostream>
#include <new>
#include <optional>
#include <stdexcept>
#include <string>
#include <system_error>
#include <utility>

namespace {

using Traits = CGAL::Filtered_quadtree_traits_2<>;
using Part = CGAL::Distributed_mesh_2<Traits::Point_2>;
using CGAL::Quadtree_mesh_2::internal::agree_on_work;
using CGAL::Quadtree_mesh_2::internal::Bytes;
using CGAL::Quadtree_mesh_2::internal::Mpi_exchange;
const MPI_Comm all_ranks = MPI_COMM_WORLD;

/// \throws Usage_error naming what only quality_mesh does
void check_use(const Command_line& line) {
  const std::pair<bool, const char*> for_one_rank[] = {
      {line.mode != Command_line::Mode::PSLG, "--mode"},
      {line.kernel != Command_line::Kernel::FILTERED, "--kernel"},
      {line.is_comparison_wanted, "--compare"},
      {line.is_resumed, "--resume"},
      {!line.area_file.empty(), "--area-file"},
      {!line.size_points_file.empty(), "--size-points"},
      {!line.size_grid_file.empty(), "--size-grid"},
      {line.feature_sizes.has_value(), "--size-from-features"},
      {line.is_hull_wanted, "--hull"},
      {line.is_repair_wanted, "--repair"},
      {line.is_quadtree_shown, "--show-quadtree"},
      {line.pieces > 0, "--pieces"},
      {line.is_projection_said && line.project != Command_line::Project::NONE,
       "--project, unless it is none,"},
      {line.msh_version != CGAL::IO::Msh_version::V4_1, "--msh-version 2.2"},
      {line.element_order != CGAL::IO::Element_order::FIRST, "--second-order"}};
  for (const auto& [is_given, option] : for_one_rank)
    if (is_given) throw Usage_error(std::string(option) + " is an option of quality_mesh alone");
  const Input_format format = input_format(line.input);
  if (is_standard_stream(line.input) || (format != Input_format::POLY && format != Input_format::HDF5))
    throw Usage_error("ranks read .poly, .poly.gz or .h5, not '" + line.input + "'");
  for (const std::string& output : line.outputs) {
    const bool is_standard = is_standard_stream(output);
    const Output_format kind = is_standard ? Output_format::SVG : output_format(output);
    if (kind != Output_format::PVTU && kind != Output_format::MSH && kind != Output_format::VTKHDF &&
        kind != Output_format::XDMF)
      throw Usage_error("ranks write .pvtu, .msh, .vtkhdf, or .xdmf with .h5, not '" + output + "'");
    if (kind == Output_format::MSH && !line.report_file.empty()) // always in parts here
      check_pieces({{"the file of --report, '" + line.report_file + "',", line.report_file}},
                   {{output, ".msh"}});
  }
}

/// The arrays of a rank, if the command line says how much memory it may use.
class Scratch_of_rank {
public:
  /// All ranks make one. What keeps one of them from it, all throw.
  explicit Scratch_of_rank(const Command_line& line) {
    if (line.memory == 0) return;
    Mpi_exchange exchange(all_ranks);
    agree_on_work(exchange, [&] {
      folder_.emplace(line);
      memory_.emplace(folder_->name(), line.memory);
    });
  }

private:
  std::optional<Scratch_folder> folder_; // goes last
  std::optional<CGAL::Scratch_memory> memory_;
};

/// What the first rank tells beside the mesher's report.
struct Seen {
  bool may_be_in_degrees = false; ///< the coordinates may be longitudes and latitudes far from the equator
  std::size_t first_number = 0;   ///< from where the file counts
  std::size_t holes = 0;          ///< points of them
  Mesh_figures figures;           ///< of all triangles
  Seconds read, mesh, write;      ///< of the first rank
};

/// All ranks call it.
bool may_be_in_degrees(const CGAL::Pslg_slice_2<Traits::Point_2>& slice) {
  int is_possible = 1, is_far = 0;
  for (const auto& p : slice.vertices) {
    if (!degrees::is_in_range(p)) is_possible = 0;
    if (degrees::is_far_from_equator(p)) is_far = 1;
  }
  Mpi_exchange exchange(all_ranks);
  return exchange.min(is_possible) == 1 && exchange.max(is_far) == 1;
}

/// The angles of all triangles. All ranks call it.
void find_angles(const Part& part, const CGAL::Quality_mesh_options_2& options, Mesh_figures& figures) {
  Mesh_figures_builder builder(figures, options.min_angle(), options.max_angle());
  const auto point = [&part](Part::Number v) { return part.points[part.index_of_vertex(v)]; };
  for (std::size_t t = 0; t < part.number_of_own_triangles(); ++t) {
    const auto& [a, b, c] = part.triangles[t];
    builder.add_triangle(point(a), point(b), point(c));
  }
  const auto reduce = [](double& angle, MPI_Op operation) {
    MPI_Allreduce(MPI_IN_PLACE, &angle, 1, MPI_DOUBLE, operation, all_ranks);
  };
  reduce(figures.min_angle, MPI_MIN), reduce(figures.min_angle_of_others, MPI_MIN);
  reduce(figures.max_angle, MPI_MAX);
  Mpi_exchange exchange(all_ranks);
  for (std::size_t* const number : {&figures.below_bound, &figures.above_bound})
    *number = static_cast<std::size_t>(exchange.sum(static_cast<std::int64_t>(*number)));
}

/// All ranks call it.
Advised_graph advised_graph(const CGAL::Pslg_slice_2<Traits::Point_2>& slice) {
  Mpi_exchange exchange(all_ranks);
  const auto is_at_any = [&](bool here) { return exchange.max(here ? 1 : 0) == 1; };
  return {slice.number_of_vertices > 0, slice.number_of_segments > 0, is_at_any(!slice.holes.empty()),
          " of quality_mesh"};
}

/// \tparam ConcurrencyTag of each rank
template <class ConcurrencyTag>
Part mesh_by(const Command_line& line, CGAL::Quality_mesh_report_2& report, Seen& seen) {
  CGAL::Distributed_quality_mesher_2<Traits, ConcurrencyTag> mesher(all_ranks, line.options);
  if (line.neighbors == Command_line::Neighbors::TRAPEZOIDAL)
    mesher.template find_neighbors_by<CGAL::Trapezoidal_vertex_edge_neighbors_2<Traits, ConcurrencyTag>>();
  CGAL::Pslg_slice_2<Traits::Point_2> slice;
  timed(seen.read, [&] {
    if (input_format(line.input) == Input_format::HDF5)
      CGAL::IO::read_HDF5_slice(all_ranks, line.input, slice);
    else
      CGAL::IO::read_triangle_poly_slice(all_ranks, line.input, slice);
  });
  seen.first_number = slice.first_number;
  const Advised_graph graph = advised_graph(slice);
  seen.holes =
      static_cast<std::size_t>(Mpi_exchange(all_ranks).sum(static_cast<std::int64_t>(slice.holes.size())));
  seen.may_be_in_degrees = !line.is_projection_said && may_be_in_degrees(slice);
  try {
    Part part;
    timed(seen.mesh, [&] { part = mesher(std::move(slice)); });
    report = mesher.report();
    if (!line.is_quiet || !line.report_file.empty()) find_angles(part, line.options, seen.figures);
    return part;
  } catch (const CGAL::Pslg_error_2& error) {
    throw std::runtime_error(error.what() + what_to_do(error, graph, line));
  }
}

/// Ranks share the cores of a machine, so each has one thread if nothing is said.
Part mesh(const Command_line& line, CGAL::Quality_mesh_report_2& report, Seen& seen) {
  const Thread_limit limit(line.threads.value_or(0));
#ifdef CGAL_LINKED_WITH_TBB
  if (line.threads.value_or(1) > 1) return mesh_by<CGAL::Parallel_tag>(line, report, seen);
#endif
  return mesh_by<CGAL::Sequential_tag>(line, report, seen);
}

void write(const Part& part, const std::string& output) {
  switch (output_format(output)) {
  case Output_format::PVTU:
    return CGAL::IO::write_PVTU(all_ranks, output, part);
  case Output_format::MSH:
    return CGAL::IO::write_MSH_parts(all_ranks, output, part);
  case Output_format::VTKHDF:
    return CGAL::IO::write_VTKHDF(all_ranks, output, part);
  default:
    return CGAL::IO::write_XDMF(all_ranks, output, part);
  }
}

void print(const Command_line& line, const CGAL::Quality_mesh_report_2& report, const Part& part,
           const Seen& seen) {
  std::printf("input: %zu vertices, %zu segments, holes: %zu; bound: %g degrees\n", report.input_vertices,
              report.input_segments, seen.holes, line.options.min_angle());
  if (seen.may_be_in_degrees) degrees::print_warning(" of quality_mesh");
  Mesh_figures figures = seen.figures;
  figures.vertices = report.vertices, figures.triangles = report.triangles, figures.seconds = seen.mesh;
  const Figures_table table({{"", figures}});
  table.print_count("vertices", &Mesh_figures::vertices);
  table.print_count("triangles", &Mesh_figures::triangles);
  table.print_angle("least angle", &Mesh_figures::min_angle);
  table.print_angle("largest angle", &Mesh_figures::max_angle);
  table.print_count("triangles below the bound", &Mesh_figures::below_bound);
  if (line.options.max_angle() > 0)
    table.print_count("triangles above the bound", &Mesh_figures::above_bound);
  table.print("  in acute input corners",
              [&](const Mesh_figures&) { return std::to_string(report.exempt_triangles.size()); });
  table.print_angle("least angle above the bound", &Mesh_figures::min_angle_of_others);
  table.print_seconds("processor seconds, rank 0", &Seconds::cpu);
  table.print_seconds("seconds by the clock", &Seconds::wall);
  table.print("ranks with triangles", [&](const Mesh_figures&) {
    return std::to_string(part.number_of_parts()) + " of " + std::to_string(part.number_of_ranks());
  });
  report_words::print_places(report.unmet_triangles, [](const auto&) { return ""; });
  report_words::print_reasons(report, line.options);
}

/// \param peak_memory_mb of the rank that has had most
nlohmann::ordered_json report_json(const Command_line& line, const CGAL::Quality_mesh_report_2& report,
                                   const Part& part, const Seen& seen, double peak_memory_mb) {
  nlohmann::ordered_json json = {
      {"input_vertices", report.input_vertices},
      {"input_segments", report.input_segments},
      {"merged_vertices", report.merged_vertices},
      {"vertices_on_segments", report.vertices_on_segments},
      {"vertices", report.vertices},
      {"triangles", report.triangles},
      {"min_angle", seen.figures.min_angle},
      {"max_angle", seen.figures.max_angle},
      {"exempt_triangles", report.exempt_triangles.size()},
      {"unmet_triangles", report.unmet_triangles.size()},
      {"encroached_edges", report.encroached_edges},
      {"estimated_triangles", report.estimated_triangles},
      {"least_angle_histogram", report.least_angle_histogram},
      {"largest_angle_histogram", report.largest_angle_histogram},
      {"rounds", report.rounds},
      {"may_be_in_degrees", seen.may_be_in_degrees},
      {"trees", trees_json(report.trees)},
      {"ranks", part.number_of_ranks()},
      {"threads", line.threads.value_or(1)},
      {"seconds", seconds_json(seen.read.cpu, report.seconds, seen.mesh.cpu, seen.write.cpu)},
      {"wall_seconds", seconds_json(seen.read.wall, report.wall_seconds, seen.mesh.wall, seen.write.wall)},
      {"peak_memory_mb", peak_memory_mb}};
  add_left(json, report, seen.first_number);
  return json;
}

/// Writes the file of --report at the first rank. All ranks call it.
void write_report(const Command_line& line, const CGAL::Quality_mesh_report_2& report, const Part& part,
                  const Seen& seen) {
  double most = peak_memory_mb();
  MPI_Allreduce(MPI_IN_PLACE, &most, 1, MPI_DOUBLE, MPI_MAX, all_ranks);
  Mpi_exchange exchange(all_ranks);
  agree_on_work(exchange, [&] {
    if (exchange.rank() == 0)
      CGAL::Quadtree_mesh_2::internal::replace_file(
          line.report_file, report_json(line, report, part, seen, most).dump(2) + '\n');
  });
}

void print_own_help() {
  std::cout << R"(usage: mpirun -n P quality_mesh_mpi INPUT [-o OUTPUT]... [option]...

Meshes a graph on P ranks, with one thread each or --threads: the mesh of quality_mesh
--renumber, whatever the number of ranks and threads.
INPUT is .poly, .poly.gz or .h5; OUTPUT is .pvtu, .msh (in parts), .vtkhdf, or .xdmf with
.h5. Without one, the program only tells what the mesh has.
Options are those of quality_mesh --help-all for graphs. Refused are --hull, --repair,
--resume, --kernel, --compare, --pieces, --second-order, --msh-version 2.2, --show-quadtree,
--area-file, --size-points, --size-grid, --size-from-features, --project but none, and those
of formats that ranks do not read or write. --threads is of each rank, to which MPI has to
give as many cores. --memory is what each rank may use; the scratch folder is made where
there is none, and may be on a disk of each machine. --report has seconds of the first rank,
and memory of the one that used most.
  mpirun -n 4 quality_mesh_mpi coast.poly -o mesh.vtkhdf --max-area 100
  mpirun -q -n 4 quality_mesh_mpi coast.h5 -o mesh.pvtu --memory 2G --scratch /local

Exit status: as quality_mesh. Outputs are written one after the other, and those before one
that cannot be written stay.
)";
}

/// What ranks do together follows from it, and from the options of the mesher, which it compares itself.
std::string common_part(const Command_line& line) {
  std::string text;
  for (const int n : {static_cast<int>(line.task), line.is_quiet ? 1 : 0, line.memory > 0 ? 1 : 0,
                      line.is_projection_said ? 1 : 0})
    text += std::to_string(n) + ' ';
  text += line.input + '\0' + line.report_file;
  for (const std::string& output : line.outputs) text += '\0' + output;
  return text;
}

/// Ranks may see different files. What keeps one of them from its work, all throw.
Command_line checked_command_line(int argc, char** argv) {
  Command_line line;
  Mpi_exchange exchange(all_ranks);
  agree_on_work(exchange, [&] {
    try {
      line = parse_command_line(argc, argv);
    } catch (const Unknown_ending& unknown) {
      throw Usage_error(
          "ranks read .poly, .poly.gz or .h5, and write .pvtu, .msh, .vtkhdf, or .xdmf with .h5, not '" +
          unknown.file_name + "'");
    }
    if (line.task == Command_line::Task::MESH) check_use(line);
  });
  const std::string own = common_part(line);
  Bytes first(own.begin(), own.end());
  exchange.broadcast(first, 0);
  agree_on_work(exchange, [&] {
    if (!std::equal(own.begin(), own.end(), first.begin(), first.end()))
      throw Usage_error(
          "ranks have different arguments: only those of --threads, --scratch and --memory may differ, "
          "if all have --memory");
  });
  return line;
}

/// \throws std::runtime_error at all ranks if the first one cannot
template <class Print>
void print_at_first(const Print& print) {
  Mpi_exchange exchange(all_ranks);
  agree_on_work(exchange, [&] {
    if (exchange.rank() != 0) return;
    errno = 0;
    print();
    if (!std::cout.flush() || std::fflush(stdout) != 0 || std::ferror(stdout) != 0)
      throw std::system_error(errno != 0 ? errno : EIO, std::generic_category(),
                              "the output cannot be printed");
  });
}

Exit_status run(int argc, char** argv) {
  const Command_line line = checked_command_line(argc, argv);
  if (line.task != Command_line::Task::MESH) {
    print_at_first([&] {
      line.task == Command_line::Task::PRINT_VERSION ? print_version(std::cout, "quality_mesh_mpi")
                                                     : print_own_help();
    });
    return Exit_status::DONE;
  }
  const Scratch_of_rank scratch(line);
  CGAL::Quality_mesh_report_2 report;
  Seen seen;
  const Part part = mesh(line, report, seen);
  timed(seen.write, [&] {
    for (const std::string& output : line.outputs) write(part, output);
  });
  if (!line.report_file.empty()) write_report(line, report, part, seen);
  if (!line.is_quiet) print_at_first([&] { print(line, report, part, seen); });
  return report.is_met() ? Exit_status::DONE : Exit_status::BOUND_UNMET;
}

/// Ranks of one machine share its memory. By itself glibc raises, with each large array that is freed, the size
/// from which arrays get pages of their own, and keeps what is below. With a size of our own it raises nothing, and
/// arrays go back to the system when they are freed.
void give_freed_arrays_back() {
#ifdef __GLIBC__
  constexpr int bytes = 1 << 18;
  mallopt(M_MMAP_THRESHOLD, bytes);
#endif
}

} // namespace

int main(int argc, char** argv) {
  give_freed_arrays_back();
  int level = MPI_THREAD_SINGLE; // only the thread that begins here calls MPI
  MPI_Init_thread(&argc, &argv, MPI_THREAD_FUNNELED, &level);
  int rank = 0;
  MPI_Comm_rank(all_ranks, &rank);
  Exit_status status = Exit_status::REFUSED;
  try {
    status = run(argc, argv);
  } catch (const std::bad_alloc& error) { // maybe at this rank alone, for which others wait
    std::cerr << "quality_mesh_mpi: error: not enough memory at rank " << rank << ": " << error.what()
              << '\n';
    MPI_Abort(all_ranks, static_cast<int>(Exit_status::REFUSED));
  } catch (const std::exception& error) { // the same at all ranks
    if (rank == 0) std::cerr << "quality_mesh_mpi: error: " << error.what() << '\n';
  }
  MPI_Finalize();
  return static_cast<int>(status);
}
