// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#include "File_case.h"

#include "families.h"
#include "mutate_text.h"
#include "scratch_folder.h"
#include "shape_tools.h"

#include "resources.h"

#include <CGAL/IO/read_triangle_files.h>
#include <CGAL/mesh_quality_2.h>

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <system_error>
#include <vector>

namespace soak {

namespace {

// --- Making ---

std::string place(const Point& p, const char* between) {
  char text[64];
  std::snprintf(text, sizeof text, "%.17g%s%.17g", p.x(), between, p.y());
  return text;
}

std::string poly_text(const Pslg& graph) {
  std::ostringstream out;
  out << graph.vertices.size() << " 2 0 0\n";
  for (std::size_t v = 0; v < graph.vertices.size(); ++v)
    out << v << ' ' << place(graph.vertices[v], " ") << '\n';
  out << graph.segments.size() << " 0\n";
  for (std::size_t s = 0; s < graph.segments.size(); ++s)
    out << s << ' ' << graph.segments[s][0].value() << ' ' << graph.segments[s][1].value() << '\n';
  out << graph.holes.size() << '\n';
  for (std::size_t h = 0; h < graph.holes.size(); ++h) out << h << ' ' << place(graph.holes[h], " ") << '\n';
  return out.str();
}

std::string wkt_text(const Pslg& graph) {
  std::ostringstream out;
  for (const auto& s : graph.segments)
    out << "LINESTRING(" << place(graph.point(s[0]), " ") << ", " << place(graph.point(s[1]), " ") << ")\n";
  return out.str();
}

std::string geojson_text(const Pslg& graph) {
  std::ostringstream out;
  out << "{\"type\": \"MultiLineString\", \"coordinates\": [\n";
  for (std::size_t s = 0; s < graph.segments.size(); ++s)
    out << (s == 0 ? "" : ",\n") << "[[" << place(graph.point(graph.segments[s][0]), ", ") << "], ["
        << place(graph.point(graph.segments[s][1]), ", ") << "]]";
  out << "\n]}\n";
  return out.str();
}

std::string table_text(const Pslg& graph, const char* between) {
  std::string text;
  for (const Point& p : graph.vertices) text += place(p, between) + '\n';
  return text;
}

using Words = std::vector<std::string>;

/// Options with values of which about half are in range.
const std::vector<std::pair<std::string, Words>>& options() {
  static const std::vector<std::pair<std::string, Words>> all{
      {"--min-angle", {"20.7", "25", "0", "5", "34", "34.1", "-1", "nan", "inf", "x", "1e999"}},
      {"--max-area", {"1e300", "1e9", "0", "-1", "nan", "-inf", "x"}},
      {"--max-edge", {"1e300", "1e9", "0", "-1", "nan", "1e999"}},
      {"--min-edge", {"1e-9", "1e-3", "1e300", "0", "-1", "nan"}},
      {"--kernel", {"filtered", "fixed", "exact", "", "Filtered"}},
      {"--separation", {"on-demand", "theorem-5", "theorem 5"}},
      {"--mode", {"pslg", "points", "bounded", "acute", "warped", "none"}},
      {"--threads", {"1", "2", "0", "-1", "5000", "99999999999", "two"}},
      {"--smooth", {"0", "1", "-1", "x"}},
      {"--thin", {"0", "1", "-1", "1.5"}},
      {"--domain", {"enclosed", "marked", "parity", "all"}},
      {"--effort", {"0", "1", "2", "3", "4", "-1"}},
      {"--budget", {"1", "100", "0", "-1"}},
      {"--color", {"none", "angle", "region", "red"}},
      {"--neighbors", {"trapezoidal", "quadtree", "none"}},
      {"--subdivision", {"walking", "centroid-tree", "none"}},
      {"--region-property", {"depth", ""}},
      {"--size-points", {"FOLDER/input.xy", "FOLDER/none.xy", "FOLDER"}},
      {"--size-grid", {"FOLDER/input.xy", "FOLDER/none.asc", "FOLDER"}},
      {"--gradation", {"0.2", "1e300", "0", "-1", "nan"}},
      {"--report", {"FOLDER/report.json", "FOLDER/out.ele", "FOLDER/none/report.json", "FOLDER"}},
      {"-o",
       {"FOLDER/out.vtu", "FOLDER/out.svg", "FOLDER/out.msh", "FOLDER/out.none", "FOLDER/none/out.off",
        "FOLDER"}},
      {"--square", {}},
      {"--no-coarsening", {}},
      {"--lengths", {}},
      {"--show-quadtree", {}},
      {"--quiet", {}},
      {"--nonsense", {}}};
  return all;
}

} // namespace

File_case make_file_case(std::uint64_t seed) {
  Random random(seed ^ 0x2545f491u);
  File_case c;
  c.seed = seed;
  const auto& families = all_families();
  const Family& family =
      families[static_cast<std::size_t>(random.integer(0, static_cast<int>(families.size()) - 1))];
  const Pslg graph = family.make(seed);
  const bool is_table = random.integer(0, 4) == 0;
  const int format = random.integer(0, 2);
  if (is_table) {
    c.ending = format == 0 ? ".csv" : format == 1 ? ".xy" : ".txt";
    c.text = table_text(graph, format == 0 ? "," : " ");
    constexpr const char* modes[] = {"points", "bounded", "acute", "warped"};
    c.arguments = {"--mode", modes[random.integer(0, 3)]};
  } else {
    c.ending = format == 0 ? ".poly" : format == 1 ? ".wkt" : ".geojson";
    c.text = format == 0 ? poly_text(graph) : format == 1 ? wkt_text(graph) : geojson_text(graph);
    if (format == 2) c.arguments = {"--project", "none"}; // coordinates of a plane
  }
  if (random.integer(0, 3) > 0) c.text = Text_mutator(seed)(c.text);
  for (int k = random.integer(0, 3); k > 0; --k) {
    const auto& [name, values] =
        options()[static_cast<std::size_t>(random.integer(0, static_cast<int>(options().size()) - 1))];
    c.arguments.push_back(name);
    if (!values.empty())
      c.arguments.push_back(
          values[static_cast<std::size_t>(random.integer(0, static_cast<int>(values.size()) - 1))]);
  }
  return c;
}

// --- Running and judging ---

namespace {

struct Run_of_program {
  int status; ///< as of wait()
  std::string error;
};

std::vector<std::string> words_of_call(const File_case& c, const std::string& folder) {
  std::vector<std::string> words{QUADTREE_MESH_PROGRAM, folder + "/input" + c.ending, "-o",
                                 folder + "/out.ele"};
  for (std::string word : c.arguments) {
    const std::size_t at = word.find("FOLDER");
    if (at != std::string::npos) word.replace(at, 6, folder);
    words.push_back(word);
  }
  return words;
}

Run_of_program run_program(const File_case& c, const Scratch_folder& folder, const std::string& error_file,
                           double cpu_seconds) {
  std::vector<std::string> words = words_of_call(c, folder.file(""));
  const pid_t child = fork();
  if (child < 0) throw std::system_error(errno, std::generic_category(), "fork");
  if (child == 0) {
    const auto seconds = static_cast<rlim_t>(cpu_seconds);
    const rlimit cpu{seconds, seconds + 1}, no_core{0, 0};
    setrlimit(RLIMIT_CPU, &cpu);
    setrlimit(RLIMIT_CORE, &no_core);
    alarm(static_cast<unsigned>(15 * cpu_seconds));
    const int error = open(error_file.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600),
              null = open("/dev/null", O_RDWR);
    dup2(null, 0), dup2(null, 1), dup2(error, 2);
    std::vector<char*> arguments;
    for (std::string& word : words) arguments.push_back(word.data());
    arguments.push_back(nullptr);
    execv(arguments[0], arguments.data());
    _exit(127);
  }
  int status = 0;
  waitpid(child, &status, 0);
  return {status, content(error_file)};
}

/// Whether two segments with a common end are so near to each other in direction that rounding puts vertices of one on
/// the other. Files do not say which of the two such a vertex belongs to.
bool has_legs_within_rounding(const Pslg& graph) {
  constexpr long double least_sine = 0x1p-46L;
  using Vector = std::array<long double, 2>;
  std::map<std::size_t, std::vector<Vector>> legs;
  for (const auto& segment : graph.segments)
    for (const std::size_t end : {0u, 1u}) {
      const auto &p = graph.point(segment[end]), &q = graph.point(segment[1 - end]);
      const long double x = static_cast<long double>(q.x()) - p.x(),
                        y = static_cast<long double>(q.y()) - p.y(), length = std::hypot(x, y);
      if (length > 0) legs[std::size_t(segment[end])].push_back({x / length, y / length});
    }
  for (const auto& [apex, directions] : legs)
    for (std::size_t i = 0; i < directions.size(); ++i)
      for (std::size_t j = i + 1; j < directions.size(); ++j) {
        const Vector &u = directions[i], &v = directions[j];
        if (u[0] * v[0] + u[1] * v[1] > 0 && std::fabs(u[0] * v[1] - u[1] * v[0]) < least_sine) return true;
      }
  return false;
}

/// Whether what was written is a mesh, and one that the exit status tells the truth about.
Verdict judge_files(const File_case& c, const Scratch_folder& folder, bool is_met) {
  Mesh mesh;
  CGAL::IO::read_triangle_files(folder.file("out"), mesh);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto& [p, q, r] = mesh.triangles[t];
    if (CGAL::orientation(mesh.point(p), mesh.point(q), mesh.point(r)) != CGAL::LEFT_TURN)
      return failure("program: clockwise triangle", std::to_string(t));
  }
  if (c.ending != ".poly" || !is_met) return {is_met ? Outcome::MET : Outcome::UNMET, "", ""};
  const auto is_given = [&](const char* option) {
    return std::find(c.arguments.begin(), c.arguments.end(), option) != c.arguments.end();
  };
  if (is_given("--mode") || is_given("--min-angle") || is_given("--domain")) return {};
  Pslg graph;
  CGAL::IO::read_triangle_poly(folder.file("input.poly"), graph);
  if (has_legs_within_rounding(graph)) return {};
  using Options = CGAL::Mesh_quality_options_2;
  const auto quality = CGAL::mesh_quality_2(
      mesh, graph, Options().min_angle(20.7).check_arrays(Options::Arrays::POINTS_AND_TRIANGLES));
  if (!quality.is_valid()) return failure("program: invalid with exit status 0", quality.errors.front());
  if (!quality.is_met()) return failure("program: unmet with exit status 0", "");
  return {};
}

} // namespace

Verdict judge(const File_case& c, double cpu_seconds) {
  const Scratch_folder folder, outside;
  folder.write("input" + c.ending, c.text);
  const Run_of_program run = run_program(c, folder, outside.file("err"), cpu_seconds);
  if (WIFSIGNALED(run.status)) {
    const int signal = WTERMSIG(run.status);
    const bool is_time = signal == SIGXCPU || signal == SIGALRM || signal == SIGKILL;
    return failure(is_time ? "program: time" : "program: crash", strsignal(signal));
  }
  if (content(folder.file("input" + c.ending)) != c.text)
    return failure("program: input overwritten", run.error);
  for (const auto& file : std::filesystem::directory_iterator(folder.file("")))
    if (file.path().extension() == ".part")
      return failure("program: .part file left", file.path().filename());
  switch (WEXITSTATUS(run.status)) {
  case 0:
  case 1:
    return judge_files(c, folder, WEXITSTATUS(run.status) == 0);
  case 2:
    if (folder.number_of_files() > 1) return failure("program: files with exit status 2", run.error);
    if (run.error.rfind("quality_mesh: error: ", 0) != 0 || run.error.size() < 25)
      return failure("program: no message", run.error);
    if (run.error.find("not enough memory") != std::string::npos)
      return failure("program: memory", run.error);
    return {Outcome::REFUSED, "program", run.error};
  default:
    return failure("program: exit status " + std::to_string(WEXITSTATUS(run.status)), run.error);
  }
}

File_case minimized(File_case c, const std::string& kind, double cpu_seconds, double seconds) {
  const double end = wall_seconds() + seconds;
  const auto take = [&](const File_case& smaller) {
    const Verdict verdict = judge(smaller, cpu_seconds);
    if (verdict.outcome != Outcome::FAILED || verdict.kind != kind) return false;
    c = smaller;
    return true;
  };
  for (std::size_t length = std::max<std::size_t>(1, c.text.size() / 2); length > 0; length /= 2)
    for (std::size_t at = 0; at < c.text.size() && wall_seconds() < end;) {
      File_case smaller = c;
      smaller.text.erase(at, length);
      if (!take(smaller)) at += length;
    }
  return c;
}

std::string write_case(const std::string& stem, const File_case& c, const Verdict& verdict) {
  std::ofstream(stem + c.ending, std::ios::binary) << c.text;
  std::ofstream call(stem + ".sh");
  call << "# " << verdict.kind << ": " << verdict.detail << "\n# FOLDER is a new folder with input"
       << c.ending << '\n';
  for (const std::string& word : words_of_call(c, "FOLDER")) call << "'" << word << "' ";
  call << '\n';
  return stem + c.ending;
}

} // namespace soak
