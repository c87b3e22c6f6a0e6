// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef QUADTREE_MESH_2_BENCHMARK_MARKDOWN_TABLE_H
#define QUADTREE_MESH_2_BENCHMARK_MARKDOWN_TABLE_H

#include <array>
#include <cstddef>
#include <cstdio>
#include <string>
#include <utility>
#include <vector>

/// A table that people read as it is and Markdown sets.
class Markdown_table {
public:
  using Row = std::vector<std::string>;

  explicit Markdown_table(Row header) : header_(std::move(header)) {}

  void add_row(Row row) { rows_.push_back(std::move(row)); }

  void print() const {
    print_row(header_);
    print_row(Row(header_.size(), "---"));
    for (const Row& row : rows_) print_row(row);
    std::printf("\n");
    std::fflush(stdout);
  }

private:
  static void print_row(const Row& row) {
    for (const std::string& cell : row) std::printf("| %s ", cell.c_str());
    std::printf("|\n");
  }

  Row header_;
  std::vector<Row> rows_;
};

/// A number with so many digits behind the point.
inline std::string fixed(double value, int digits) {
  std::array<char, 64> text;
  std::snprintf(text.data(), text.size(), "%.*f", digits, value);
  return text.data();
}

/// A number with three digits that count, of which none is left out before the point.
inline std::string three_digits(double value) {
  if (!(value > 0)) return fixed(value, 0);
  int digits = 2;
  for (double v = value; v >= 10 && digits > 0; v /= 10) --digits;
  for (double v = value; v < 1 && digits < 9; v *= 10) ++digits;
  return fixed(value, digits);
}

#endif // QUADTREE_MESH_2_BENCHMARK_MARKDOWN_TABLE_H
