#ifndef QUADTREE_MESH_2_EXAMPLES_READ_POINTS_H
#define QUADTREE_MESH_2_EXAMPLES_READ_POINTS_H

// Points alone, from Triangle's files or from text; any file may be compressed by gzip.

#include "command_line.h"

#include <CGAL/IO/Triangle_files.h>
#include <CGAL/Pslg_2.h>
#include <CGAL/Quadtree_mesh_2/internal/Line_scanner.h>
#include <CGAL/Quadtree_mesh_2/internal/read_whole_file.h>

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

enum class Points_format { poly, node, text };

/// By the ending, or by that before `.gz`.
inline Points_format points_format(const std::string& file_name) {
  std::filesystem::path path(file_name);
  if (path.extension() == ".gz") path.replace_extension();
  const std::string ending = path.extension().string();
  if (ending == ".poly") return Points_format::poly;
  if (ending == ".node") return Points_format::node;
  if (ending == ".xy" || ending == ".txt" || ending == ".csv") return Points_format::text;
  throw Usage_error("cannot tell the format of input '" + file_name +
                    "': its ending has to be .poly, .node, .xy, .txt or .csv");
}

namespace read_points_internal {

/// Makes a blank of the comma behind the first number of each line: no other can stand there.
inline void drop_commas(std::string& text) {
  const std::string blanks = " \t\r\v\f";
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = (std::min)(text.find('\n', begin), text.size());
    const std::size_t number = text.find_first_not_of(blanks, begin);
    const std::size_t after = (std::min)(text.find_first_of(blanks + ",#\n", number), end);
    const std::size_t comma = (std::min)(text.find_first_not_of(blanks, after), end);
    if (number < after && comma < end && text[comma] == ',') text[comma] = ' ';
    begin = end + 1;
  }
}

/// One `x y` a line, with blanks or a comma between them; what follows a `#`, and empty lines, are skipped.
template <class Point>
std::vector<Point> parse_points(std::string text, const std::string& name) {
  drop_commas(text);
  CGAL::Quadtree_mesh_2::internal::Line_scanner scanner(text, name);
  std::vector<Point> points;
  while (scanner.try_next_line()) {
    const double x = scanner.read<double>({"x"});
    const double y = scanner.read<double>({"y"});
    if (scanner.has_more_columns()) scanner.fail("more than 'x y'");
    points.emplace_back(x, y);
  }
  return points;
}

} // namespace read_points_internal

/// \throws std::runtime_error naming the file, and the line that is to blame.
template <class Point>
std::vector<Point> read_points(const std::string& file_name) {
  CGAL::Pslg_2<Point> pslg;
  switch (points_format(file_name)) {
  case Points_format::poly:
    CGAL::IO::read_triangle_poly(file_name, pslg);
    break;
  case Points_format::node:
    CGAL::IO::read_triangle_node(file_name, pslg);
    break;
  case Points_format::text:
    pslg.vertices = read_points_internal::parse_points<Point>(
        CGAL::Quadtree_mesh_2::internal::read_whole_file(file_name), file_name);
    break;
  }
  if (pslg.number_of_segments() > 0) throw std::runtime_error(file_name + ": has segments: use --mode pslg");
  if (pslg.vertices.empty()) throw std::runtime_error(file_name + ": no points");
  return std::move(pslg.vertices);
}

#endif // QUADTREE_MESH_2_EXAMPLES_READ_POINTS_H
