// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// Files with the state of long work: what is written is read, and nothing else is taken for it.

#include "catch.h"
#include "scratch_folder.h"

#include <CGAL/Quadtree_mesh_2/internal/Mesh_checkpoints.h>
#include <CGAL/Quadtree_mesh_2/internal/base/Checkpoint_file.h>
#include <CGAL/Quadtree_mesh_2/internal/base/Indexed_vector.h>

#include <cstddef>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <system_error>
#include <vector>

namespace test_checkpoint_file {

using namespace CGAL::Quadtree_mesh_2::internal;

namespace {

struct Inner {
  int number = 0;
  std::vector<double> values;

  template <class Archive>
  void transfer(Archive& archive) {
    archive(number, values);
  }
  friend bool operator==(const Inner& a, const Inner& b) {
    return a.number == b.number && a.values == b.values;
  }
};

struct Work {
  std::vector<Inner> parts;
  Uninitialized_vector<std::uint32_t> long_array;
  double share = 0;

  template <class Archive>
  void transfer(Archive& archive) {
    archive(parts, long_array, share);
  }
  friend bool operator==(const Work& a, const Work& b) {
    return a.parts == b.parts && a.long_array == b.long_array && a.share == b.share;
  }
};

Work some_work() {
  Work work;
  work.parts = {{1, {1, 2, 3}}, {2, {}}, {-7, {0.1}}};
  work.long_array.assign(100000, 5);
  work.share = 0.25;
  return work;
}

void save(const std::string& file, Work work) {
  Checkpoint_writer out(file);
  out(work);
  out.commit();
}

Work load(const std::string& file) {
  Work work;
  Checkpoint_reader in(file);
  in(work);
  in.check();
  return work;
}

} // namespace

TEST_CASE("A checkpoint is read as it was written", "[checkpoint]") {
  const Scratch_folder folder;
  const std::string file = folder.file("state");
  save(file, Work());
  CHECK(load(file) == Work());
  save(file, some_work());
  CHECK(load(file) == some_work());
  CHECK(folder.number_of_files() == 1);
}

TEST_CASE("A checkpoint that is not completed leaves the one before", "[checkpoint]") {
  const Scratch_folder folder;
  const std::string file = folder.file("state");
  save(file, some_work());
  {
    Checkpoint_writer out(file);
    Work other;
    out(other);
  }
  CHECK(load(file) == some_work());
  CHECK(folder.number_of_files() == 1);
  CHECK_THROWS_AS(save(folder.file("nowhere/state"), Work()), std::system_error);
}

TEST_CASE("Of a damaged checkpoint nothing is taken", "[checkpoint]") {
  const Scratch_folder folder;
  const std::string file = folder.file("state");
  save(file, some_work());
  const std::string good = content(file);
  for (const std::size_t length :
       {std::size_t(0), std::size_t(3), std::size_t(20), good.size() / 2, good.size() - 1}) {
    folder.write("state", good.substr(0, length));
    CHECK_THROWS_AS(load(file), std::runtime_error);
  }
  folder.write("state", good + "x");
  CHECK_THROWS_AS(load(file), std::runtime_error);
  for (std::size_t i = 0; i < good.size(); i += 1 + i / 8) {
    std::string bad = good;
    bad[i] = static_cast<char>(bad[i] ^ 4);
    folder.write("state", bad);
    CHECK_THROWS_AS(load(file), std::runtime_error);
  }
  CHECK_THROWS_AS(load(folder.file("none")), std::runtime_error);
}

TEST_CASE("Checkpoints belong to one input", "[checkpoint]") {
  const Scratch_folder folder;
  Digest mine, other;
  mine.add(1), other.add(2);
  Mesh_checkpoints checkpoints(folder.file("made/if/need/be"), 1);
  CHECK(checkpoints.are_wanted());
  CHECK_FALSE(checkpoints.has_state());
  checkpoints.set_origin(mine);
  Work work = some_work();
  checkpoints.save_if_due([&](auto& archive) { archive(work); });
  REQUIRE(checkpoints.has_state());
  Work read;
  checkpoints.load([&](auto& archive) { archive(read); });
  CHECK(read == work);
  checkpoints.set_origin(other);
  CHECK_THROWS_AS(checkpoints.load([&](auto& archive) { archive(read); }), std::runtime_error);
  CHECK_FALSE(Mesh_checkpoints("", 1).are_wanted());
}

} // namespace test_checkpoint_file
