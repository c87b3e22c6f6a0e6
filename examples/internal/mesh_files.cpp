#include "mesh_files.h"

#include <CGAL/Balanced_quadtree.h>
#include <CGAL/Filtered_quadtree_traits_2.h>
#include <CGAL/IO/MEDIT.h>
#include <CGAL/IO/MSH.h>
#include <CGAL/IO/OFF_and_OBJ.h>
#include <CGAL/IO/SVG.h>
#include <CGAL/IO/Triangle_files.h>
#include <CGAL/IO/VTU.h>
#include <CGAL/IO/read_GeoJSON.h>
#include <CGAL/IO/read_WKT.h>
#include <CGAL/IO/read_XY.h>

#include <cstddef>
#include <filesystem>
#include <ostream>
#include <sstream>
#include <stdexcept>
#include <utility>

namespace {

using namespace mesh_files;

Pslg read(const std::string& file_name, const std::string& region_property) {
  Pslg pslg;
  switch (input_format(file_name)) {
  case Input_format::POLY:
    CGAL::IO::read_triangle_poly(file_name, pslg);
    break;
  case Input_format::GEOJSON:
    CGAL::IO::read_GeoJSON(file_name, pslg, region_property);
    break;
  case Input_format::WKT:
    CGAL::IO::read_WKT(file_name, pslg);
    break;
  case Input_format::NODE:
    CGAL::IO::read_triangle_node(file_name, pslg);
    break;
  case Input_format::TABLE:
    CGAL::IO::read_XY(file_name, pslg.vertices);
    break;
  }
  return pslg;
}

CGAL::IO::Svg_options_2 svg_options(const Picture& picture) {
  using Options = CGAL::IO::Svg_options_2;
  Options options;
  switch (picture.colors) {
  case Picture_colors::NONE:
    return options;
  case Picture_colors::ANGLE:
    options.fill_by(Options::Fill::LEAST_ANGLE);
    break;
  case Picture_colors::LARGEST_ANGLE:
    options.fill_by(Options::Fill::LARGEST_ANGLE);
    break;
  case Picture_colors::REGION:
    options.fill_by(Options::Fill::REGION);
    break;
  }
  return options.legend(Options::Legend::BELOW);
}

using Quadtree = CGAL::Balanced_quadtree<CGAL::Filtered_quadtree_traits_2<>>;

void write_picture(std::ostream& out, const Mesh& mesh, const Pslg& pslg, const Picture& picture) {
  if (picture.is_quadtree_shown)
    CGAL::IO::write_SVG(out, mesh, pslg, Quadtree(pslg.vertices), svg_options(picture));
  else
    CGAL::IO::write_SVG(out, mesh, pslg, svg_options(picture));
}

void write_grid(std::ostream& out, const Mesh& mesh, const Pslg& pslg, const Picture& picture) {
  CGAL::IO::Triangle_fields_2 fields;
  if (picture.is_quadtree_shown)
    fields.push_back(CGAL::IO::quadtree_level_field(mesh, Quadtree(pslg.vertices)));
  CGAL::IO::write_VTU(out, mesh, pslg, fields);
}

/// In a format that is one file.
void write(std::ostream& out, Output_format format, const Mesh& mesh, const Pslg& pslg,
           const Picture& picture) {
  switch (format) {
  case Output_format::TRIANGLE:
    return;
  case Output_format::VTU:
    return write_grid(out, mesh, pslg, picture);
  case Output_format::SVG:
    return write_picture(out, mesh, pslg, picture);
  case Output_format::OFF:
    return CGAL::IO::write_OFF(out, mesh);
  case Output_format::OBJ:
    return CGAL::IO::write_OBJ(out, mesh);
  case Output_format::MSH:
    return CGAL::IO::write_MSH(out, mesh, pslg);
  case Output_format::MEDIT:
    return CGAL::IO::write_MEDIT(out, mesh);
  }
}

} // namespace

namespace mesh_files {

Pslg read_graph(const std::string& file_name, const std::string& region_property) {
  const Input_format format = input_format(file_name);
  if (format == Input_format::NODE || format == Input_format::TABLE)
    throw Usage_error("'" + file_name +
                      "' is a file of points alone: use --mode points, bounded, acute or warped");
  return read(file_name, region_property);
}

Pslg read_points(const std::string& file_name) {
  Pslg pslg = read(file_name, "");
  if (pslg.number_of_segments() > 0) throw std::runtime_error(file_name + ": has segments: use --mode pslg");
  if (pslg.vertices.empty()) throw std::runtime_error(file_name + ": no points");
  return pslg;
}

CGAL::Points_sizing_field_2 read_sized_points(const std::string& file_name) {
  std::vector<Point> points;
  std::vector<double> sizes;
  CGAL::IO::read_XY(file_name, points, sizes);
  if (points.empty()) throw std::runtime_error(file_name + ": no points");
  std::vector<CGAL::Points_sizing_field_2::Sized_point> sized;
  sized.reserve(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) sized.push_back({points[i].x(), points[i].y(), sizes[i]});
  return CGAL::Points_sizing_field_2(std::move(sized));
}

void add(Files& files, const std::string& file_name, const Mesh& mesh, const Pslg& pslg,
         const Picture& picture) {
  const Output_format format = output_format(file_name);
  if (format == Output_format::TRIANGLE) {
    const std::string stem = std::filesystem::path(file_name).replace_extension().string();
    return CGAL::Quadtree_mesh_2::internal::add_triangle_files(files, mesh, pslg, stem);
  }
  std::ostringstream out;
  write(out, format, mesh, pslg, picture);
  files.add(file_name, out.str());
}

} // namespace mesh_files
