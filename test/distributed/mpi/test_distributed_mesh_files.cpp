// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// Meshes distributed to ranks of MPI: what ranks hold fits together and is the mesh; files are those that one machine
// writes; where one rank cannot write, all say so, and no file is there.
//
// If the variable QUADTREE_MESH_DISTRIBUTED_FILES names a folder, files stay there to be read back by others.

#include "catch.h"
#include "distributed_mesh_checks.h"

#include <CGAL/IO/Distributed_mesh_files.h>
#include <CGAL/IO/HDF5.h>
#include <CGAL/IO/MSH.h>
#include <CGAL/IO/VTU.h>
#include <CGAL/distribute_mesh_2.h>

#include <mpi.h>
#include <sys/resource.h>

#include <csignal>
#include <cstddef>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <iterator>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace test_distributed_mesh_files {

using namespace distributed_mesh_checks;
namespace fs = std::filesystem;

std::string of_first(Mpi_exchange& exchange, const std::string& text) {
  Bytes bytes(text.begin(), text.end());
  exchange.broadcast(bytes, 0);
  return std::string(bytes.begin(), bytes.end());
}

/// A folder that all ranks know; empty at first, gone at the end.
class Shared_folder {
public:
  explicit Shared_folder(Mpi_exchange& exchange) : exchange_(exchange) {
    std::string name = (fs::temp_directory_path() / "quadtree_mesh_2_XXXXXX").string();
    if (exchange.rank() == 0 && mkdtemp(name.data()) == nullptr) throw std::runtime_error("no folder");
    path_ = of_first(exchange, name);
  }
  Shared_folder(const Shared_folder&) = delete;
  Shared_folder& operator=(const Shared_folder&) = delete;
  ~Shared_folder() {
    exchange_.sum(0);
    std::error_code ignored;
    if (exchange_.rank() == 0) fs::remove_all(path_, ignored);
  }
  const fs::path& path() const { return path_; }
  std::size_t number_of_files() const {
    return std::size_t(std::distance(fs::directory_iterator(path_), fs::directory_iterator()));
  }

private:
  Mpi_exchange& exchange_;
  fs::path path_;
};

/// A mesh at the last rank alone.
Input at_last(Mpi_exchange& exchange, const std::function<Input()>& make) {
  return exchange.rank() + 1 == exchange.size() ? make() : Input();
}

TEST_CASE("what ranks hold fits together, is the mesh, and makes its files", "[distributed]") {
  Mpi_exchange exchange(MPI_COMM_WORLD);
  const Shared_folder folder(exchange);
  const fs::path together = folder.path() / "together", alone = folder.path() / "alone";
  if (exchange.rank() == 0) fs::create_directory(together), fs::create_directory(alone);
  const std::vector<Input> inputs = small_inputs();
  for (const Input& input : inputs) {
    CAPTURE(input.name);
    Part part;
    CHECK(check_distribution(exchange, input, part, std::size_t(1) << 28) == "");
    CHECK(check_files(exchange, input, part, together, alone) == "");
  }
}

TEST_CASE("public functions distribute and gather a map", "[distributed]") {
  Mpi_exchange exchange(MPI_COMM_WORLD);
  const int last = exchange.size() - 1;
  const Input input = at_last(exchange, [] { return map("us_states_10m.poly.gz"); });
  Part part = CGAL::distribute_mesh_2(MPI_COMM_WORLD, input.mesh, input.pslg, last);
  CHECK(CGAL::defect_of_distributed_mesh_2(MPI_COMM_WORLD, part) == "");
  CHECK(is_same(CGAL::gather_mesh_2(MPI_COMM_WORLD, part, last), input.mesh));
  if (exchange.rank() == 0 && part.number_of_own_triangles() > 0) std::swap(part.points[0], part.points[1]);
  const std::string defect = CGAL::defect_of_distributed_mesh_2(MPI_COMM_WORLD, part);
  CHECK(defect == of_first(exchange, defect));
}

/// Written by all ranks and by the last one alone, for others to compare.
void write_for_others(Mpi_exchange& exchange, const Input& input, const fs::path& folder) {
  const int last = exchange.size() - 1;
  const std::string name = of_first(exchange, input.name), stem = (folder / name).string();
  const Part part = CGAL::distribute_mesh_2(MPI_COMM_WORLD, input.mesh, input.pslg, last);
  const auto fields = fields_of(part);
  CGAL::IO::write_VTKHDF(MPI_COMM_WORLD, stem + ".vtkhdf", part, fields);
  CGAL::IO::write_XDMF(MPI_COMM_WORLD, stem + ".xdmf", part, fields);
  CGAL::IO::write_MSH_parts(MPI_COMM_WORLD, stem + ".msh", part);
  // meshio cannot do with the bytes of tiny arrays.
  CGAL::IO::write_PVTU(MPI_COMM_WORLD, stem + ".pvtu", part, fields, CGAL::IO::ASCII);
  CHECK(fs::file_size(stem + ".vtkhdf") > 0);
  if (exchange.rank() != last) return;
  const auto all_fields = fields_from(0, input.mesh.triangles.size());
  const std::string whole = (folder / "whole" / name).string();
  CGAL::IO::write_VTKHDF(whole + ".vtkhdf", input.mesh, input.pslg, all_fields);
  CGAL::IO::write_XDMF(whole + ".xdmf", input.mesh, input.pslg, all_fields);
  CGAL::IO::write_MSH(whole + ".msh", input.mesh, input.pslg);
  CGAL::IO::write_PVTU(whole + ".pvtu", input.mesh, input.pslg, 1, all_fields, CGAL::IO::ASCII);
  for (const char* ending : {".vtkhdf", ".h5", ".xdmf"})
    CHECK(bytes_of_file(stem + ending) == bytes_of_file(whole + ending));
}

TEST_CASE("files of ranks are those of one machine", "[distributed]") {
  Mpi_exchange exchange(MPI_COMM_WORLD);
  const Shared_folder scratch(exchange);
  const char* const kept = std::getenv("QUADTREE_MESH_DISTRIBUTED_FILES");
  const fs::path folder = kept == nullptr ? scratch.path() : fs::path(kept);
  if (exchange.rank() == 0) fs::create_directories(folder / "whole");
  exchange.sum(0);
  for (const Input& input : small_inputs()) write_for_others(exchange, input, folder);
  // Readers in Python take seconds for the larger one.
  const char* const file = is_full_run() ? "us_states_10m.poly.gz" : "syn_holes_400.poly.gz";
  Input large = at_last(exchange, [file] { return map(file); });
  large.name = "map";
  write_for_others(exchange, large, folder);
}

/// Each way to write files, by name.
std::vector<std::pair<std::string, std::function<void(const std::string&, const Part&)>>> writers() {
  return {
      {"a.pvtu", [](const std::string& name,
                    const Part& part) { CGAL::IO::write_PVTU(MPI_COMM_WORLD, name, part, fields_of(part)); }},
      {"a.msh", [](const std::string& name,
                   const Part& part) { CGAL::IO::write_MSH_parts(MPI_COMM_WORLD, name, part); }},
      {"a.vtkhdf",
       [](const std::string& name, const Part& part) {
         CGAL::IO::write_VTKHDF(MPI_COMM_WORLD, name, part, fields_of(part));
       }},
      {"a.xdmf", [](const std::string& name, const Part& part) {
         CGAL::IO::write_XDMF(MPI_COMM_WORLD, name, part, fields_of(part));
       }}};
}

/// \returns the error, empty if there is none
std::string error_of(const std::function<void()>& work) {
  try {
    work();
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return std::string();
}

TEST_CASE("all ranks tell that there is no folder", "[distributed]") {
  Mpi_exchange exchange(MPI_COMM_WORLD);
  const Shared_folder folder(exchange);
  const Input input = with_all();
  const Part part = CGAL::distribute_mesh_2(MPI_COMM_WORLD, input.mesh, input.pslg);
  for (const auto& [name, write] : writers()) {
    CAPTURE(name);
    const std::string path = (folder.path() / "missing" / name).string();
    const std::string error = error_of([&, &write = write] { write(path, part); });
    CHECK(error.find("missing/a") != std::string::npos);
    CHECK(error.find("No such file") != std::string::npos);
    CHECK(error == of_first(exchange, error));
  }
  exchange.sum(0);
  CHECK(folder.number_of_files() == 0);
}

TEST_CASE("if one rank cannot write, all tell so and older files stay", "[distributed]") {
  Mpi_exchange exchange(MPI_COMM_WORLD);
  const Shared_folder folder(exchange);
  const Input input = with_all();
  const Part part = CGAL::distribute_mesh_2(MPI_COMM_WORLD, input.mesh, input.pslg);
  const std::string last = std::to_string(exchange.size());
  // The file of the last rank is in the way, as a folder.
  for (const std::string ending : {".vtu", ".msh"})
    if (exchange.rank() == 0) fs::create_directory(folder.path() / ("a_" + last + ending));
  for (const std::string name : {"a_1.vtu", "a.pvtu", "a_1.msh"})
    if (exchange.rank() == 0 && !fs::exists(folder.path() / name))
      std::ofstream(folder.path() / name) << "old";
  exchange.sum(0);
  const std::size_t files = folder.number_of_files();
  for (std::size_t i = 0; i < 2; ++i) {
    const auto [name, write] = writers()[i];
    CAPTURE(name);
    const std::string path = (folder.path() / name).string();
    const std::string error = error_of([&, &write = write] { write(path, part); });
    CHECK(error.find("a_" + last) != std::string::npos);
    CHECK(error.find("Is a directory") != std::string::npos);
    CHECK(error == of_first(exchange, error));
  }
  exchange.sum(0);
  CHECK(folder.number_of_files() == files);
  CHECK(bytes_of_file(folder.path() / "a.pvtu") == "old");
  if (exchange.size() > 1) CHECK(bytes_of_file(folder.path() / "a_1.vtu") == "old");
}

/// While it lives, files of this process end after some bytes, as on a full disk.
class Small_disk {
public:
  explicit Small_disk(rlim_t bytes) {
    handler_ = std::signal(SIGXFSZ, SIG_IGN);
    getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit small{bytes, before_.rlim_max};
    setrlimit(RLIMIT_FSIZE, &small);
  }
  Small_disk(const Small_disk&) = delete;
  Small_disk& operator=(const Small_disk&) = delete;
  ~Small_disk() {
    setrlimit(RLIMIT_FSIZE, &before_);
    std::signal(SIGXFSZ, handler_);
  }

private:
  rlimit before_{};
  void (*handler_)(int) = nullptr;
};

TEST_CASE("a full disk leaves no file, and all ranks tell so", "[distributed]") {
  Mpi_exchange exchange(MPI_COMM_WORLD);
  const Shared_folder folder(exchange);
  const Input input = map("syn_holes_400.poly.gz");
  const Part part = CGAL::distribute_mesh_2(MPI_COMM_WORLD, input.mesh, input.pslg);
  const auto [name, write] = writers()[GENERATE(range(std::size_t(0), std::size_t(4)))];
  const bool is_small_for_all = GENERATE(false, true);
  CAPTURE(name, is_small_for_all);
  const std::string path = (folder.path() / name).string();
  std::string error;
  if (is_small_for_all || exchange.rank() + 1 == exchange.size()) {
    const Small_disk disk(5000);
    error = error_of([&, &write = write] { write(path, part); });
  } else {
    error = error_of([&, &write = write] { write(path, part); });
  }
  CHECK(error == of_first(exchange, error));
  CHECK(error.find("cannot be written: File too large") != std::string::npos);
  exchange.sum(0);
  CHECK(folder.number_of_files() == 0);
  exchange.sum(0);
  CHECK(error_of([&, &write = write] { write(path, part); }) == "");
}

} // namespace test_distributed_mesh_files
