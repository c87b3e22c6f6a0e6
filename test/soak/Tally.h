// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef QUADTREE_MESH_2_TEST_SOAK_TALLY_H
#define QUADTREE_MESH_2_TEST_SOAK_TALLY_H

// How many inputs of which kind ended how: written as lines of JSON, and as the table of doc/soak.md.

#include "Batch_runner.h"
#include "Soak_case.h"

#include <array>
#include <cstddef>
#include <iosfwd>
#include <map>
#include <string>
#include <vector>

namespace soak {

class Tally {
public:
  void add(const Soak_case& c, const Result& result);
  void add(const Tally& other);
  std::size_t number_of_inputs() const;
  std::size_t number_of(Outcome outcome) const;
  /// One line for each family, kernel, separation and mode.
  void write(std::ostream& out, const std::string& commit, std::uint64_t seed) const;

private:
  using Key = std::array<std::string, 4>; ///< family, kernel, separation, mode
  struct Counts {
    std::array<std::size_t, 4> of_outcome{};
    double seconds = 0, worst_seconds = 0, worst_megabytes = 0;
    void add(const Counts& other);
  };
  std::map<Key, Counts> counts_;
};

/// Writes the page that says what the logs say.
void write_page(std::ostream& out, const std::vector<std::string>& logs);

} // namespace soak

#endif // QUADTREE_MESH_2_TEST_SOAK_TALLY_H
