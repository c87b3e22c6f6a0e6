// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#include "Soak_case.h"

#include <CGAL/IO/read_triangle_files.h>

#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <fstream>
#include <functional>
#include <sstream>
#include <stdexcept>
#include <utility>

namespace soak {

namespace {

constexpr const char* comment = "# soak: ";

std::size_t index_in(const std::vector<std::string>& names, const std::string& name) {
  const auto at = std::find(names.begin(), names.end(), name);
  if (at == names.end()) throw std::invalid_argument("soak: no such choice as '" + name + "'");
  return static_cast<std::size_t>(at - names.begin());
}

const std::vector<std::string>& domain_names() {
  static const std::vector<std::string> names{"enclosed", "marked", "parity"};
  return names;
}

std::string text_of(double number) {
  char text[32];
  std::snprintf(text, sizeof text, "%.17g", number);
  return text;
}

/// One option of the command line: how it is read and written.
struct Argument {
  const char* name;
  std::function<void(Soak_case&, const std::string&)> read;
  std::function<std::string(const Soak_case&)> write;
};

template <class Enum>
Argument choice(const char* name, const std::vector<std::string>& names,
                std::function<Enum&(Soak_case&)> member) {
  return {name,
          [=](Soak_case& c, const std::string& s) { member(c) = static_cast<Enum>(index_in(names, s)); },
          [=](const Soak_case& c) {
            Soak_case copy = c;
            return names[static_cast<std::size_t>(member(copy))];
          }};
}
template <class Number>
Argument number(const char* name, Number Wishes::*member) {
  return {name,
          [=](Soak_case& c, const std::string& s) { c.wishes.*member = static_cast<Number>(std::stod(s)); },
          [=](const Soak_case& c) { return text_of(static_cast<double>(c.wishes.*member)); }};
}

const std::vector<Argument>& arguments() {
  static const std::vector<Argument> all{
      choice<Kernel>("kernel", kernel_names(), [](Soak_case& c) -> Kernel& { return c.kernel; }),
      choice<Separation>("separation", separation_names(),
                         [](Soak_case& c) -> Separation& { return c.separation; }),
      choice<Mode>("mode", mode_names(), [](Soak_case& c) -> Mode& { return c.mode; }),
      {"threads",
       [](Soak_case& c, const std::string& s) { c.threads = static_cast<unsigned>(std::stoul(s)); },
       [](const Soak_case& c) { return std::to_string(c.threads); }},
      number("min-angle", &Wishes::min_angle),
      number("max-area", &Wishes::max_area),
      number("max-edge", &Wishes::max_edge),
      number("min-edge", &Wishes::min_edge),
      number("size", &Wishes::size),
      number("smooth", &Wishes::smooth),
      number("thin", &Wishes::thin),
      number("coarsen", &Wishes::is_coarsened),
      choice<CGAL::Quality_mesh_options_2::Domain>(
          "domain", domain_names(),
          [](Soak_case& c) -> CGAL::Quality_mesh_options_2::Domain& { return c.wishes.domain; }),
      number("patience", &Wishes::patience),
      number("centroid-trees", &Wishes::has_centroid_trees),
      number("trapezoids", &Wishes::has_trapezoids),
      number("effort", &Wishes::effort),
      number("square", &Wishes::is_square),
      number("tightest", &Wishes::is_tightest)};
  return all;
}

} // namespace

double extent_of(const std::vector<Point>& points) {
  double low[2] = {0, 0}, high[2] = {0, 0};
  for (std::size_t i = 0; i < points.size(); ++i)
    for (const int k : {0, 1}) {
      const double v = k == 0 ? points[i].x() : points[i].y();
      low[k] = i == 0 ? v : std::min(low[k], v);
      high[k] = i == 0 ? v : std::max(high[k], v);
    }
  return std::max(high[0] - low[0], high[1] - low[1]);
}

std::string arguments_of(const Soak_case& c) {
  const Soak_case usual;
  std::string text;
  for (const Argument& a : arguments()) {
    const std::string value = a.write(c);
    if (value != a.write(usual)) text += (text.empty() ? "--" : " --") + std::string(a.name) + ' ' + value;
  }
  return text;
}

void read_arguments(const std::string& text, Soak_case& c) {
  std::istringstream in(text);
  for (std::string name, value; in >> name;) {
    const auto has_name = [&](const Argument& a) { return name == "--" + std::string(a.name); };
    const auto at = std::find_if(arguments().begin(), arguments().end(), has_name);
    if (at == arguments().end() || !(in >> value))
      throw std::invalid_argument("soak: no such option as " + name);
    at->read(c, value);
  }
}

void write_case(const std::string& file_name, const Soak_case& c, const std::vector<std::string>& lines) {
  std::ofstream out(file_name);
  out << comment << arguments_of(c) << '\n';
  for (const std::string& line : lines) out << "# " << line << '\n';
  out << c.graph.vertices.size() << " 2 0 0\n";
  for (std::size_t v = 0; v < c.graph.vertices.size(); ++v)
    out << v << ' ' << text_of(c.graph.vertices[v].x()) << ' ' << text_of(c.graph.vertices[v].y()) << '\n';
  out << c.graph.segments.size() << " 0\n";
  for (std::size_t s = 0; s < c.graph.segments.size(); ++s)
    out << s << ' ' << c.graph.segments[s][0].value() << ' ' << c.graph.segments[s][1].value() << '\n';
  out << c.graph.holes.size() << '\n';
  for (std::size_t h = 0; h < c.graph.holes.size(); ++h)
    out << h << ' ' << text_of(c.graph.holes[h].x()) << ' ' << text_of(c.graph.holes[h].y()) << '\n';
  if (c.graph.regions.empty()) return;
  out << c.graph.regions.size() << '\n';
  for (std::size_t r = 0; r < c.graph.regions.size(); ++r) {
    const auto& region = c.graph.regions[r];
    out << r << ' ' << text_of(region.point.x()) << ' ' << text_of(region.point.y()) << ' '
        << text_of(region.attribute) << ' ' << text_of(region.max_area) << '\n';
  }
}

Soak_case read_case(const std::string& file_name) {
  Soak_case c;
  std::ifstream in(file_name);
  std::string line;
  if (std::getline(in, line) && line.rfind(comment, 0) == 0)
    read_arguments(line.substr(std::string(comment).size()), c);
  CGAL::IO::read_triangle_poly(file_name, c.graph);
  c.family = "file";
  return c;
}

} // namespace soak
