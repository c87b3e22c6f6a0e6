#ifndef QUADTREE_MESH_2_EXAMPLES_READ_SIZED_POINTS_H
#define QUADTREE_MESH_2_EXAMPLES_READ_SIZED_POINTS_H

// Points with the sizes of triangles there, from a text file.

#include <CGAL/Points_sizing_field_2.h>

#include <cstddef>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

/// Reads one `x y size` a line; what follows a `#`, and empty lines, are skipped.
/// \throws std::runtime_error naming the file, and the line that is to blame.
inline CGAL::Points_sizing_field_2 read_sized_points(const std::string& file_name) {
  std::ifstream in(file_name);
  if (!in) throw std::runtime_error("cannot read '" + file_name + "'");
  std::vector<CGAL::Points_sizing_field_2::Sized_point> points;
  std::string line;
  for (std::size_t number = 1; std::getline(in, line); ++number) {
    std::istringstream text(line.substr(0, line.find('#')));
    if ((text >> std::ws).eof()) continue;
    CGAL::Points_sizing_field_2::Sized_point p{};
    if (!(text >> p.x >> p.y >> p.size) || !(text >> std::ws).eof() || !(p.size > 0))
      throw std::runtime_error(file_name + ":" + std::to_string(number) +
                               ": not 'x y size' with a size above 0");
    points.push_back(p);
  }
  if (points.empty()) throw std::runtime_error(file_name + ": no points");
  return CGAL::Points_sizing_field_2(std::move(points));
}

#endif // QUADTREE_MESH_2_EXAMPLES_READ_SIZED_POINTS_H
