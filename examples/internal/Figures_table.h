// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef QUADTREE_MESH_2_EXAMPLES_FIGURES_TABLE_H
#define QUADTREE_MESH_2_EXAMPLES_FIGURES_TABLE_H

// Meshes of one input side by side, on the screen.

#include "mesh_figures.h"

#include <cstddef>
#include <cstdio>
#include <optional>
#include <string>
#include <utility>
#include <vector>

/// Prints a row for each figure. The first column is the mesh that is written.
class Figures_table {
public:
  struct Column {
    std::string name;
    std::optional<Mesh_figures> figures; ///< nothing if there is no mesh
  };

  explicit Figures_table(std::vector<Column> columns) : columns_(std::move(columns)) {}

  /// A table of one column has no names.
  void print_names() const {
    if (columns_.size() < 2) return;
    std::printf("%-28s", "");
    for (const Column& column : columns_) std::printf("%14s", column.name.c_str());
    std::printf("\n");
  }

  /// \param text of the figures of a mesh
  template <class Text>
  void print(const char* name, const Text& text) const {
    std::printf("%-28s", name);
    for (const Column& column : columns_)
      std::printf("%14s", column.figures ? text(*column.figures).c_str() : "-");
    std::printf("\n");
  }
  void print_count(const char* name, std::size_t Mesh_figures::*count) const {
    print(name, [=](const Mesh_figures& figures) { return std::to_string(figures.*count); });
  }
  /// In degrees; 180 as the least one stands for no triangle.
  void print_angle(const char* name, double Mesh_figures::*angle) const {
    print(name, [=](const Mesh_figures& figures) {
      return angle == &Mesh_figures::min_angle_of_others && !(figures.*angle < 180)
                 ? std::string("-")
                 : decimal("%.2f", figures.*angle);
    });
  }
  void print_seconds(const char* name, double Seconds::*kind) const {
    print(name, [=](const Mesh_figures& figures) { return decimal("%.3f", figures.seconds.*kind); });
  }

private:
  static std::string decimal(const char* format, double number) {
    char digits[64];
    std::snprintf(digits, sizeof digits, format, number);
    return digits;
  }

  std::vector<Column> columns_;
};

#endif // QUADTREE_MESH_2_EXAMPLES_FIGURES_TABLE_H
