// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#include "Tally.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdio>
#include <fstream>
#include <map>
#include <ostream>
#include <stdexcept>
#include <string>
#include <vector>

namespace soak {

namespace {

struct Row {
  std::array<std::size_t, 4> of_outcome{};
  double worst_seconds = 0, worst_megabytes = 0;

  std::size_t inputs() const { return of_outcome[0] + of_outcome[1] + of_outcome[2] + of_outcome[3]; }
  void add(const nlohmann::json& line) {
    std::size_t i = 0;
    for (const char* const outcome : {"met", "unmet", "refused", "failed"})
      of_outcome[i++] += line.at(outcome).get<std::size_t>();
    worst_seconds = std::max(worst_seconds, line.at("worst_seconds").get<double>());
    worst_megabytes = std::max(worst_megabytes, line.at("worst_megabytes").get<double>());
  }
  void write(std::ostream& out) const {
    out << "| " << inputs();
    for (const std::size_t n : of_outcome) out << " | " << n;
    char text[64];
    std::snprintf(text, sizeof text, " | %.1f | %.0f |", worst_seconds, worst_megabytes);
    out << text << '\n';
  }
};

constexpr const char* columns =
    "inputs | met | unmet | refused | failed | longest run, s | most memory, MB |\n";

using Words = std::vector<std::string>;

/// A table with a row for each key; `titles` are those of the cells of a key.
void write_table(std::ostream& out, const Words& titles, const std::map<Words, Row>& rows) {
  const auto write_cells = [&](const Words& cells) {
    for (const std::string& cell : cells) out << "| " << cell << ' ';
  };
  write_cells(titles);
  out << "| " << columns << '|';
  for (std::size_t i = 0; i < titles.size() + 7; ++i) out << "---|";
  out << '\n';
  for (const auto& [key, row] : rows) {
    write_cells(key);
    row.write(out);
  }
}

} // namespace

void write_page(std::ostream& out, const std::vector<std::string>& logs) {
  std::map<Words, Row> of_commit, of_kernel, of_family;
  for (const std::string& log : logs) {
    std::ifstream in(log);
    if (!in) throw std::runtime_error(log + ": cannot be opened");
    for (std::string text; std::getline(in, text);) {
      const auto line = nlohmann::json::parse(text);
      const auto word = [&](const char* key) { return line.at(key).get<std::string>(); };
      of_kernel[{word("kernel"), word("separation"), word("mode")}].add(line);
      of_family[{word("family")}].add(line);
      of_commit[{word("commit")}].add(line);
    }
  }
  out << "# Soak\n\n"
         "How many generated inputs ran, and how they ended. Written by `test/soak.sh --docs LOG...`; do\n"
         "not edit. All is judged by exact predicates (`test/soak`). The first table has a row for each\n"
         "commit, the others add them up. So failures of old commits count, even those mended since.\n\n"
         "- *Met*: a valid mesh with all bounds\n"
         "- *Unmet*: a valid mesh that misses a bound where coordinates have no room, or of an input that\n"
         "  asks for more than is promised\n"
         "- *Refused*: no mesh, but a message that is true\n"
         "- *Failed*: all others, also runs cut off at the limits of time and memory\n\n";
  write_table(out, {"commit"}, of_commit);
  out << "\n## By kernel, separation and mode\n\n";
  write_table(out, {"kernel", "separation", "mode"}, of_kernel);
  out << "\n## By family, over all of these\n\n";
  write_table(out, {"family"}, of_family);
}

} // namespace soak
