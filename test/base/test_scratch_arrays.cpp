// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// Arrays in scratch files: that each keeps what is written to it, whatever comes and goes around it, and that memory is
// let go of.

#ifdef __linux__

#include "catch.h"
#include "scratch_folder.h"

#include <CGAL/Quadtree_mesh_2/internal/base/Indexed_vector.h>
#include <CGAL/Quadtree_mesh_2/internal/base/Resident_limit.h>
#include <CGAL/Quadtree_mesh_2/internal/base/Scratch_arrays.h>
#include <CGAL/Scratch_memory.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <map>
#include <new>
#include <random>
#include <stdexcept>
#include <string>
#include <system_error>
#include <thread>
#include <vector>

namespace test_scratch_arrays {

using namespace CGAL::Quadtree_mesh_2::internal;
using CGAL::Scratch_memory;

namespace {

constexpr std::size_t any_memory = std::size_t(1) << 40;

/// Bytes that differ from those of other arrays, and that must still be there when it goes.
struct Marked {
  unsigned char* bytes;
  std::size_t size;
  unsigned char mark;

  Marked(Scratch_file& file, std::size_t n, unsigned char m)
      : bytes(static_cast<unsigned char*>(file.allocate(n))), size(n), mark(m) {
    std::fill_n(bytes, size, mark);
  }
  bool is_kept() const {
    return std::all_of(bytes, bytes + size, [this](unsigned char b) { return b == mark; });
  }
};

} // namespace

TEST_CASE("Arrays of a scratch file come and go without touching each other", "[scratch]") {
  const Scratch_folder folder;
  Scratch_file file(folder.file(""));
  CHECK(folder.number_of_files() == 0); // it has no name
  std::mt19937 random(3);
  std::vector<Marked> arrays;
  for (int step = 0; step < 2000; ++step) {
    if (random() % 2 == 0 || arrays.size() < 4) {
      const std::size_t size = 1 + random() % (random() % 8 == 0 ? 3000000 : 60000);
      arrays.emplace_back(file, size, static_cast<unsigned char>(1 + random() % 255));
      CHECK(file.has(arrays.back().bytes));
    } else {
      const std::size_t i = random() % arrays.size();
      REQUIRE(arrays[i].is_kept());
      file.free(arrays[i].bytes);
      arrays[i] = arrays.back();
      arrays.pop_back();
    }
    if (step % 97 == 0) file.let_go_of_pages();
  }
  for (const Marked& array : arrays) {
    CHECK(array.is_kept());
    file.free(array.bytes);
  }
  CHECK(file.is_empty());
}

TEST_CASE("A scratch file is as long as the arrays that there were at once", "[scratch]") {
  const Scratch_folder folder;
  Scratch_file file(folder.file(""));
  constexpr std::size_t size = 1 << 20;
  void* const first = file.allocate(size);
  for (int i = 0; i < 50; ++i) {
    void* const second = file.allocate(size);
    CHECK(static_cast<char*>(second) - static_cast<char*>(first) == size); // where the one before has been
    file.free(second);
  }
  file.free(first);
  CHECK(file.allocate(size) == first);
  file.free(first);
}

TEST_CASE("Long arrays are in the scratch file, short ones and those made before are not", "[scratch]") {
  const Scratch_folder folder;
  const Uninitialized_vector<std::uint64_t> before(1 << 18);
  Uninitialized_vector<std::uint64_t> longer_lived;
  {
    const Scratch_memory memory(folder.file(""), any_memory);
    CHECK_THROWS_AS(Scratch_memory(folder.file(""), any_memory), std::logic_error);
    const Uninitialized_vector<std::uint64_t> inside(1 << 18), small(10);
    CHECK(Scratch_arrays::has(inside.data()));
    CHECK_FALSE(Scratch_arrays::has(small.data()));
    CHECK_FALSE(Scratch_arrays::has(before.data()));
    longer_lived.assign(1 << 18, 7);
  }
  CHECK_FALSE(Scratch_arrays::is_active());
  CHECK(Scratch_arrays::has(longer_lived.data()));
  CHECK(std::count(longer_lived.begin(), longer_lived.end(), 7u) == 1 << 18);
  const Uninitialized_vector<std::uint64_t> after(1 << 18);
  CHECK_FALSE(Scratch_arrays::has(after.data()));
  const Scratch_memory another(folder.file(""), any_memory); // beside the file of what lives longer
  const Uninitialized_vector<std::uint64_t> inside(1 << 18);
  CHECK(Scratch_arrays::has(inside.data()));
}

TEST_CASE("The memory of arrays in scratch files is limited", "[scratch]") {
  const Scratch_folder folder;
  const Resident_memory resident;
  const std::size_t own = resident.bytes().all - resident.bytes().in_files;
  const std::size_t length = std::size_t(1)
                             << (is_full_run() ? 27 : 25); // of words: a gigabyte, or a quarter of it
  const std::size_t limit = 5 * length;
  const Scratch_memory memory(folder.file(""), own + limit);
  Uninitialized_vector<std::uint64_t> values(length);
  std::size_t most = 0;
  for (std::size_t i = 0; i < length; ++i) {
    values[i] = i;
    if (i % (1 << 20) == 0) most = std::max(most, resident.bytes().all);
  }
  CHECK(most > 0);
  CHECK(most < own + length * sizeof values[0]); // soft: the bound itself depends on how busy the machine is
  std::size_t wrong = 0;
  for (std::size_t i = 0; i < length; ++i) wrong += values[i] != i ? 1 : 0;
  CHECK(wrong == 0);
}

TEST_CASE("Threads may make and drop arrays of a scratch file at once", "[scratch][threads]") {
  const Scratch_folder folder;
  const Scratch_memory memory(folder.file(""), any_memory, 1000);
  const std::size_t longest = is_full_run() ? 400000 : 40000;
  std::vector<std::thread> threads;
  std::vector<int> wrong(4, 0);
  for (std::size_t t = 0; t < wrong.size(); ++t)
    threads.emplace_back([&wrong, t, longest] {
      for (std::size_t i = 0; i < 200; ++i) {
        const std::vector<std::size_t, Uninitialized_allocator<std::size_t>> array(longest / 2 + 100 * i,
                                                                                   t + i);
        wrong[t] += array.front() != t + i || array.back() != t + i ? 1 : 0;
      }
    });
  for (std::thread& thread : threads) thread.join();
  CHECK(wrong == std::vector<int>(4, 0));
}

TEST_CASE("Scratch memories may come and go while threads make arrays", "[scratch][threads]") {
  const Scratch_folder folder;
  std::atomic<bool> is_over{false};
  std::atomic<int> wrong{0};
  std::vector<std::thread> threads;
  for (const unsigned char mark : std::array<unsigned char, 3>{1, 2, 3})
    threads.emplace_back([&, mark] {
      constexpr std::size_t size = 2 << 20;
      while (!is_over) {
        const std::vector<unsigned char, Uninitialized_allocator<unsigned char>> array(size, mark);
        wrong += std::size_t(std::count(array.begin(), array.end(), mark)) != size ? 1 : 0;
      }
    });
  for (int i = 0; i < 300; ++i) const Scratch_memory memory(folder.file(""), any_memory);
  is_over = true;
  for (std::thread& thread : threads) thread.join();
  CHECK(wrong == 0);
}

TEST_CASE("A scratch file that cannot be, or has no room, is an error that names the folder", "[scratch]") {
  const Scratch_folder folder;
  CHECK_THROWS_AS(Scratch_memory(folder.file("nowhere"), any_memory), std::system_error);
  CHECK_FALSE(Scratch_arrays::is_active());
  const Scratch_memory memory(folder.file(""), any_memory);
  try {
    Scratch_arrays::allocate(std::size_t(1) << 42);
    FAIL("more than any disk");
  } catch (const CGAL::Quadtree_mesh_2::Scratch_full& error) {
    CHECK(std::string(error.what()).find(folder.file("")) != std::string::npos);
  }
  const Uninitialized_vector<std::uint64_t> fits(1 << 18);
  CHECK(Scratch_arrays::has(fits.data()));
}

} // namespace test_scratch_arrays

#endif // __linux__
