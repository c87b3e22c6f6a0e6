// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// Shewchuk's Triangle as the benchmark of meshers sees it: a program that the user has, which is not part of
// Debian's free software.

#ifndef QUADTREE_MESH_2_BENCHMARK_PSLG_TRIANGLE_H
#define QUADTREE_MESH_2_BENCHMARK_PSLG_TRIANGLE_H

#include "in_child.h"
#include "pslg_run.h"

#include <CGAL/IO/Triangle_files.h>

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <optional>
#include <string>
#include <system_error>

namespace pslg_triangle {

/// A folder that is empty at first and gone at the end.
class Temporary_folder {
public:
  Temporary_folder() {
    std::string name = (std::filesystem::temp_directory_path() / "pslg_triangle_XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr) throw std::system_error(errno, std::generic_category(), name);
    path_ = name;
  }
  Temporary_folder(const Temporary_folder&) = delete;
  Temporary_folder& operator=(const Temporary_folder&) = delete;
  ~Temporary_folder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }

  std::string file(const std::string& name) const { return (path_ / name).string(); }

private:
  std::filesystem::path path_;
};

/// What Triangle says about its time; files are not part of it.
struct Times {
  double delaunay = 0, segments = 0, holes = 0, quality = 0; ///< seconds

  double sum() const { return delaunay + segments + holes + quality; }
};

/// Seconds in the line "TITLE milliseconds:  NUMBER".
inline std::optional<double> seconds_of(const std::string& text, const std::string& title) {
  const std::string key = title + " milliseconds:";
  const std::size_t at = text.find(key);
  if (at == std::string::npos) return std::nullopt;
  const char* const begin = text.c_str() + at + key.size();
  char* end = nullptr;
  const double milliseconds = std::strtod(begin, &end);
  if (end == begin) return std::nullopt;
  return milliseconds / 1000;
}

/// What Triangle printed; nothing if it did not come to the end. Without holes or quality it has no such
/// line.
inline std::optional<Times> parse_times(const std::string& text) {
  const auto delaunay = seconds_of(text, "Delaunay");
  if (!delaunay || !seconds_of(text, "Total running")) return std::nullopt;
  return Times{*delaunay, seconds_of(text, "Segment").value_or(0), seconds_of(text, "Hole").value_or(0),
               seconds_of(text, "Quality").value_or(0)};
}

/// Triangle knows numbers without exponents only.
inline std::string switches(double min_angle, double max_area) {
  std::array<char, 80> text;
  std::snprintf(text.data(), text.size(), "-pq%.6f", min_angle);
  std::string result = text.data();
  if (max_area > 0) {
    std::snprintf(text.data(), text.size(), "a%.20f", max_area);
    result += text.data();
  }
  return result;
}

/// How a program ended that was started.
struct Program_end {
  bool is_good = false;
  double peak_memory_mb = 0;
};

/// Runs `program argument file` with its output in a file.
inline Program_end run_program(const std::string& program, const std::string& argument,
                               const std::string& file, const std::string& output, unsigned limit_seconds) {
  std::fflush(nullptr);
  const pid_t child = fork();
  if (child < 0) throw std::system_error(errno, std::generic_category(), "fork");
  if (child == 0) {
    alarm(limit_seconds); // goes on in the program
    const int out = open(output.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
    if (out < 0 || dup2(out, STDOUT_FILENO) < 0) _exit(126);
    execl(program.c_str(), program.c_str(), argument.c_str(), file.c_str(), static_cast<char*>(nullptr));
    _exit(127);
  }
  int status = 0;
  rusage usage{};
  if (wait4(child, &status, 0, &usage) != child)
    throw std::system_error(errno, std::generic_category(), "wait4");
  return {WIFEXITED(status) && WEXITSTATUS(status) == 0, peak_memory_mb(usage)};
}

/// Counts and looks at the mesh `stem.node`, `stem.ele`.
inline Pslg_run read_and_check(const std::string& stem, const Pslg_task& task, Check check) {
  Pslg_run run;
  Indexed_mesh mesh;
  CGAL::IO::read_triangle_files(stem, mesh);
  mesh.number_of_input_vertices = task.pslg.number_of_vertices();
  run.vertices = mesh.number_of_vertices();
  run.triangles = mesh.number_of_triangles();
  if (check == Check::YES)
    check_mesh(mesh, task, CGAL::Mesh_quality_options_2::Arrays::POINTS_AND_TRIANGLES, run);
  return run;
}

/// Triangle's times are of the clock on the wall, in milliseconds; it runs on one core, so they stand for
/// processor seconds, too.
inline std::optional<Pslg_run> mesh(const std::string& program, const Pslg_task& task, Check check) {
  const Temporary_folder folder;
  const std::string input = folder.file("in.poly"), output = folder.file("out");
  CGAL::IO::write_triangle_poly(input, task.pslg);
  const Program_end end =
      run_program(program, switches(task.min_angle, task.max_area), input, output, task.limit_seconds);
  std::ifstream stream(output, std::ios::binary);
  const auto times = parse_times(std::string(std::istreambuf_iterator<char>(stream), {}));
  if (!end.is_good || !times) return std::nullopt;

  constexpr unsigned seconds_to_check = 3600;
  auto run =
      in_child([&] { return read_and_check(folder.file("in.1"), task, check); }, seconds_to_check).result;
  if (!run) return std::nullopt;
  run->mesh = {times->sum(), times->sum()};
  run->phases = {times->delaunay, times->segments, times->holes, times->quality};
  run->peak_memory_mb = end.peak_memory_mb;
  return run;
}

/// \param program the file name of the user's Triangle.
inline Pslg_method method(const std::string& program) {
  return {"Triangle",
          0,
          {"Delaunay", "segments", "holes", "quality"},
          [program](const Pslg_task& task, Check check) { return mesh(program, task, check); }};
}

} // namespace pslg_triangle

#endif // QUADTREE_MESH_2_BENCHMARK_PSLG_TRIANGLE_H
