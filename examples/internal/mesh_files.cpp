#include "mesh_files.h"

#include "gdal_module.h"
#include "standard_streams.h"

#include <CGAL/Balanced_quadtree.h>
#include <CGAL/Filtered_quadtree_traits_2.h>
#include <CGAL/IO/ADCIRC.h>
#ifdef CGAL_LINKED_WITH_HDF5
#include <CGAL/IO/HDF5.h>
#endif
#include <CGAL/IO/HTML.h>
#include <CGAL/IO/MEDIT.h>
#include <CGAL/IO/MSH.h>
#include <CGAL/IO/Mesh_cells.h>
#include <CGAL/IO/OFF_and_OBJ.h>
#include <CGAL/IO/SMS_2DM.h>
#include <CGAL/IO/SVG.h>
#include <CGAL/IO/Triangle_files.h>
#include <CGAL/IO/VTU.h>
#include <CGAL/IO/read_ESRI_grid.h>
#include <CGAL/IO/read_GeoJSON.h>
#include <CGAL/IO/read_WKT.h>
#include <CGAL/IO/read_XY.h>
#include <CGAL/IO/read_triangle_mesh.h>
#include <CGAL/dual_of_mesh_2.h>
#include <CGAL/tags.h>

#include <array>
#include <cstddef>
#include <filesystem>
#include <iostream>
#include <ostream>
#include <sstream>
#include <stdexcept>
#include <utility>
#include <vector>

namespace {

using namespace mesh_files;

/// \tparam Source the name of a file, or a stream
/// \param name the name of the stream
template <class Source, class... Name>
Pslg read_from(Source& source, Input_format format, const CGAL::Feature_properties_2& properties,
               const Name&... name) {
  Pslg pslg;
  switch (format) {
  case Input_format::POLY:
    CGAL::IO::read_triangle_poly(source, pslg, name...);
    break;
  case Input_format::GEOJSON:
    CGAL::IO::read_GeoJSON(source, pslg, properties, name...);
    break;
  case Input_format::WKT:
    CGAL::IO::read_WKT(source, pslg, name...);
    break;
  case Input_format::HDF5: // not from a stream
  case Input_format::OGR:
  case Input_format::ELE:
    break;
  case Input_format::NODE:
    CGAL::IO::read_triangle_node(source, pslg, name...);
    break;
  case Input_format::TABLE:
    CGAL::IO::read_XY(source, pslg.vertices, name...);
    break;
  }
  return pslg;
}

CGAL::Grid_sizing_field_2 grid_by_gdal(const std::string& file_name) {
#ifdef QUADTREE_MESH_GDAL_MODULE
  gdal_module::Grid_request request{file_name};
  reinterpret_cast<gdal_module::Read_grid>(gdal_module::function(gdal_module::read_grid_name))(request);
  return *request.sizes;
#else
  check_has_gdal(file_name);
  throw std::logic_error("no GDAL"); // not reached
#endif
}

Input read(const std::string& file_name, const Selection& selection) {
  const Input_format format = input_format(file_name);
  Input input;
  if (is_standard_stream(file_name))
    input.graph = read_from(std::cin, format, selection.properties, std::string("standard input"));
#ifdef CGAL_LINKED_WITH_HDF5
  else if (format == Input_format::HDF5)
    CGAL::IO::read_HDF5(file_name, input.graph);
#endif
#ifdef QUADTREE_MESH_GDAL_MODULE
  else if (format == Input_format::OGR) {
    gdal_module::Graph_request request{file_name, selection.layer, selection.properties, &input.graph};
    reinterpret_cast<gdal_module::Read_graph>(gdal_module::function(gdal_module::read_graph_name))(request);
    input.coordinates = request.coordinates;
  }
#endif
  else if (format == Input_format::ELE)
    CGAL::IO::read_triangle_mesh(file_name, input.mesh.emplace(), input.graph, input.given_triangle);
  else
    input.graph = read_from(file_name, format, selection.properties);
  return input;
}

CGAL::IO::Svg_options_2 svg_options(const Picture& picture) {
  using Options = CGAL::IO::Svg_options_2;
  Options options;
  switch (picture.colors) {
  case Picture_colors::NONE:
  case Picture_colors::SIZE: // of pages alone
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

CGAL::IO::Html_options_2::Color page_color(Picture_colors colors) {
  using Color = CGAL::IO::Html_options_2::Color;
  switch (colors) {
  case Picture_colors::NONE:
    return Color::NONE;
  case Picture_colors::ANGLE:
    break;
  case Picture_colors::LARGEST_ANGLE:
    return Color::LARGEST_ANGLE;
  case Picture_colors::REGION:
    return Color::REGION;
  case Picture_colors::SIZE:
    return Color::SIZE;
  }
  return Color::LEAST_ANGLE;
}

void project(std::vector<Point>& points, const CGAL::Conformal_projection_2& projection) {
  for (Point& p : points) {
    const auto place = projection.forward(p.x(), p.y());
    p = Point(place[0], place[1]);
  }
}

/// A mesh in degrees is shown where its angles are those on the ground, but its coordinates are called what they are.
void write_page(std::ostream& out, const Mesh& mesh, const Pslg& pslg, const Picture& picture) {
  CGAL::IO::Html_options_2 options;
  options.title(picture.title).color_by(page_color(picture.page_colors)).unmet_triangles(picture.unmet);
  const auto write_in_plane = [&](const Mesh& drawn, const std::vector<Point>& vertices) {
    if (picture.is_quadtree_shown)
      CGAL::IO::write_HTML(out, drawn, pslg, Quadtree(vertices), options);
    else
      CGAL::IO::write_HTML(out, drawn, pslg, options);
  };
  if (picture.projection == nullptr) return write_in_plane(mesh, pslg.vertices);
  std::vector<std::array<double, 2>> degrees;
  for (const Point& p : mesh.points) degrees.push_back({p.x(), p.y()});
  options.coordinates(std::move(degrees));
  Mesh drawn = mesh;
  std::vector<Point> vertices = pslg.vertices;
  project(drawn.points, *picture.projection);
  project(vertices, *picture.projection);
  write_in_plane(drawn, vertices);
}

CGAL::IO::Triangle_fields_2 fields_of(const Mesh& mesh, const Pslg& pslg, const Picture& picture) {
  CGAL::IO::Triangle_fields_2 fields;
  if (picture.is_quadtree_shown)
    fields.push_back(CGAL::IO::quadtree_level_field(mesh, Quadtree(pslg.vertices)));
  return fields;
}

/// The cells of a mesh; of one in degrees they are made in the plane of the projection, and have areas on the ground.
CGAL::Mesh_dual_2 cells_of(const Mesh& mesh, const Details& details) {
  const CGAL::Conformal_projection_2* const projection = details.projection;
  if (projection == nullptr) return CGAL::dual_of_mesh_2<CGAL::Parallel_tag>(mesh, details.cells);
  Mesh in_plane = mesh;
  for (Point& p : in_plane.points) {
    const auto place = projection->forward(p.x(), p.y());
    p = Point(place[0], place[1]);
  }
  CGAL::Mesh_dual_2 dual = CGAL::dual_of_mesh_2<CGAL::Parallel_tag>(in_plane, details.cells);
  for (auto& place : dual.points) place = projection->inverse(place[0], place[1]);
  for (const CGAL::Mesh_edge_2& e : dual.edges)
    if (e.is_on_border()) // where vertices are corners, which are known in degrees
      for (const auto v : e.vertices)
        dual.for_each_polygon(v, [&](const auto* begin, const auto*) {
          dual.points[*begin] = {mesh.point(v).x(), mesh.point(v).y()};
        });
  for (std::size_t v = 0; v < dual.areas.size(); ++v) {
    const double scale = projection->scale(mesh.points[v].y());
    dual.areas[v] /= scale * scale;
  }
  return dual;
}

/// In a format that is one text.
void write(std::ostream& out, Output_format format, const Mesh& mesh, const Pslg& pslg,
           const Picture& picture, const Details& details) {
  switch (format) {
  case Output_format::TRIANGLE:
  case Output_format::TRIANGLE_EDGE:
  case Output_format::TRIANGLE_NEIGH:
  case Output_format::TRIANGLE_VORONOI:
  case Output_format::PVTU:
  case Output_format::VTKHDF:
  case Output_format::XDMF:
    return;
  case Output_format::VTU:
    return CGAL::IO::write_VTU(out, mesh, pslg, fields_of(mesh, pslg, picture), CGAL::IO::BINARY,
                               details.order);
  case Output_format::SVG:
    return write_picture(out, mesh, pslg, picture);
  case Output_format::HTML:
    return write_page(out, mesh, pslg, picture);
  case Output_format::OFF:
    return CGAL::IO::write_OFF(out, mesh);
  case Output_format::OBJ:
    return CGAL::IO::write_OBJ(out, mesh);
  case Output_format::MSH:
    return CGAL::IO::write_MSH(out, mesh, pslg, details.msh_version, details.order);
  case Output_format::MEDIT:
    return CGAL::IO::write_MEDIT(out, mesh);
  case Output_format::SMS_2DM:
    return CGAL::IO::write_SMS_2DM(out, mesh);
  case Output_format::GR3:
    return CGAL::IO::write_GR3(out, mesh);
  case Output_format::ADCIRC:
    return CGAL::IO::write_ADCIRC(out, mesh);
  case Output_format::CELLS_GEOJSON:
    return CGAL::IO::write_cells_GeoJSON(out, cells_of(mesh, details), mesh, pslg.first_number);
  case Output_format::CELLS_WKT:
    return CGAL::IO::write_cells_WKT(out, cells_of(mesh, details));
  }
}

} // namespace

namespace mesh_files {

Input read_graph(const std::string& file_name, const Selection& selection, Points_alone points_alone) {
  const Input_format format = input_format(file_name);
  if (points_alone == Points_alone::REFUSED &&
      (format == Input_format::NODE || format == Input_format::TABLE))
    throw Usage_error("'" + file_name +
                      "' is a file of points alone: use --mode points, bounded, acute or warped, or --hull");
  return read(file_name, selection);
}

Pslg read_points(const std::string& file_name, const Selection& selection) {
  Pslg pslg = read(file_name, selection).graph;
  if (pslg.number_of_segments() > 0) throw std::runtime_error(file_name + ": has segments: use --mode pslg");
  if (pslg.vertices.empty()) throw std::runtime_error(file_name + ": no points");
  return pslg;
}

std::vector<double> read_areas(const std::string& file_name, const Input& input) {
  return CGAL::IO::read_triangle_area(file_name, input.given_triangle, input.graph.first_number);
}

CGAL::Points_sizing_field_2 read_sized_points(const std::string& file_name,
                                              const CGAL::Conformal_projection_2* projection,
                                              double gradation) {
  std::vector<Point> points;
  std::vector<double> sizes;
  CGAL::IO::read_XY(file_name, points, sizes);
  if (points.empty()) throw std::runtime_error(file_name + ": no points");
  std::vector<CGAL::Points_sizing_field_2::Sized_point> sized;
  sized.reserve(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double x = points[i].x(), y = points[i].y();
    if (projection != nullptr) {
      if (!(std::abs(y) < 90))
        throw std::runtime_error(file_name + ": point " + std::to_string(i) + " is at a pole or beyond");
      const auto place = projection->forward(x, y);
      sized.push_back({place[0], place[1], sizes[i] * projection->scale(y)});
    } else
      sized.push_back({x, y, sizes[i]});
  }
  return CGAL::Points_sizing_field_2(std::move(sized), gradation);
}

CGAL::Grid_sizing_field_2 read_size_grid(const std::string& file_name, double gradation) {
  CGAL::Grid_sizing_field_2 grid = grid_format(file_name) == Grid_format::GDAL
                                       ? grid_by_gdal(file_name)
                                       : CGAL::IO::read_ESRI_grid(file_name);
  if (gradation > 0) grid.limit_gradient(gradation);
  return grid;
}

void add(Files& files, const std::string& file_name, const Mesh& mesh, const Pslg& pslg,
         const Picture& picture, const Details& details) {
  namespace internal = CGAL::Quadtree_mesh_2::internal;
  const Output_format format = output_format(file_name);
  const auto fields = [&] { return fields_of(mesh, pslg, picture); };
  const std::string stem = std::filesystem::path(file_name).replace_extension().string();
  const std::size_t pieces = details.pieces;
  if (format == Output_format::TRIANGLE)
    return internal::add_triangle_files(files, mesh, pslg, stem, details.order);
  if (format == Output_format::TRIANGLE_EDGE)
    return files.add(file_name, internal::triangle_edge_text(mesh, pslg.first_number));
  if (format == Output_format::TRIANGLE_NEIGH)
    return files.add(file_name, internal::triangle_neigh_text(mesh, pslg.first_number));
  if (format == Output_format::TRIANGLE_VORONOI)
    return internal::add_triangle_voronoi_files(
        files, mesh, std::filesystem::path(stem).replace_extension().string(), pslg.first_number);
  if (format == Output_format::PVTU)
    return internal::add_pvtu_files(files, file_name, mesh, pslg, fields(), pieces, CGAL::IO::BINARY);
  if (format == Output_format::MSH && pieces > 0)
    return internal::Msh_parts_writer<Point>(mesh, pslg, pieces).add_to(files, file_name);
#ifdef CGAL_LINKED_WITH_HDF5
  if (format == Output_format::VTKHDF)
    return internal::add_vtkhdf_file(files, file_name, mesh, pslg, fields());
  if (format == Output_format::XDMF) return internal::add_xdmf_files(files, stem, mesh, pslg, fields());
#endif
  std::ostringstream out;
  write(out, format, mesh, pslg, picture, details);
  files.add(file_name, out.str());
}

} // namespace mesh_files
