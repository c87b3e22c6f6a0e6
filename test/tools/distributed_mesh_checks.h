// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef QUADTREE_MESH_2_TEST_DISTRIBUTED_MESH_CHECKS_H
#define QUADTREE_MESH_2_TEST_DISTRIBUTED_MESH_CHECKS_H

// Meshes to be distributed, and what has to hold of what ranks get and write. All ranks run these checks; what is wrong
// is told as a text, so that none ends before the others.

#include <CGAL/Distributed_mesh_2.h>
#ifdef CGAL_LINKED_WITH_HDF5
#include <CGAL/IO/HDF5.h>
#include <CGAL/Quadtree_mesh_2/internal/distributed/hdf5_part_files.h>
#endif
#include <CGAL/IO/MSH.h>
#include <CGAL/IO/Triangle_files.h>
#include <CGAL/IO/VTU.h>
#include <CGAL/Quadtree_mesh_2/internal/distributed/Mesh_defects.h>
#include <CGAL/Quadtree_mesh_2/internal/distributed/distribute_mesh.h>
#include <CGAL/Quadtree_mesh_2/internal/distributed/mesh_part_files.h>
#include <CGAL/Quality_mesher_2.h>
#include <CGAL/mesh_quality_2.h>
#include <CGAL/renumber_mesh_2.h>

#include <cmath>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <initializer_list>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace distributed_mesh_checks {

using namespace CGAL::Quadtree_mesh_2::internal;
using CGAL::Quadtree_mesh_2::Segment_index;
using CGAL::Quadtree_mesh_2::Vertex_index;
using Mesher = CGAL::Quality_mesher_2<>;
using Mesh = Mesher::Mesh;
using Pslg = Mesher::Pslg;
using Point = Mesh::Point_2;
using Part = CGAL::Distributed_mesh_2<Point>;

struct Input {
  std::string name;
  Pslg pslg;
  Mesh mesh;
};

/// By the mesher, checked, in the order of places.
inline Input meshed(std::string name, Pslg pslg) {
  Mesher mesher;
  Input input{std::move(name), std::move(pslg), {}};
  input.mesh = mesher(input.pslg);
  const auto quality = CGAL::mesh_quality_2(input.mesh, input.pslg);
  if (!quality.is_valid()) throw std::logic_error("a mesh to be distributed is not valid");
  CGAL::renumber_by_place(input.mesh);
  return input;
}
inline Input map(const std::string& name) {
  Pslg pslg;
  CGAL::IO::read_triangle_poly(QUADTREE_MESH_TEST_DATA_DIR "/" + name, pslg);
  return meshed(name.substr(0, name.find('.')), pslg);
}

inline void add_square(Pslg& pslg, double x, double y, double radius) {
  const std::size_t first = pslg.vertices.size();
  for (const auto& [dx, dy] : {std::pair(-1, -1), {1, -1}, {1, 1}, {-1, 1}})
    pslg.add_vertex(Point(x + dx * radius, y + dy * radius));
  for (std::size_t i = 0; i < 4; ++i)
    pslg.add_segment(Vertex_index(first + i), Vertex_index(first + (i + 1) % 4));
}
/// A square with a hole, in which there are a vertex and a segment; beside it one with another region inside.
inline Input with_all() {
  Pslg pslg;
  add_square(pslg, 0, 0, 2), add_square(pslg, 0, 0, 1);
  add_square(pslg, 5.1, 0, 1.1), add_square(pslg, 5.1, 0, 0.1);
  pslg.holes.push_back(Point(0.5, 0.5));
  for (const Point& p : {Point(0.1, 0.1), Point(-0.2, 0.3), Point(-0.7, -0.7)}) pslg.add_vertex(p);
  pslg.add_segment(Vertex_index(16), Vertex_index(17));
  pslg.regions = {{Point(5.1, 0), 2, 0}, {Point(1.5, 1.5), -7, 0.05}};
  pslg.region_names = {"water", "island"}, pslg.marker_names = {"", "", "wall"};
  for (std::size_t s = 0; s < pslg.segments.size(); ++s) pslg.segment_markers.push_back(int(s % 4) * 3 - 3);
  for (std::size_t v = 0; v < pslg.vertices.size(); ++v) pslg.vertex_markers.push_back(int(v % 5) - 2);
  return meshed("all", pslg);
}

/// Triangles around one vertex, so that each rank has ghosts of all others.
inline Input fan(std::size_t n) {
  Input input{"fan_" + std::to_string(n), {}, {}};
  input.mesh.points.push_back(Point(0, 0));
  for (std::size_t i = 0; i < n; ++i)
    input.mesh.points.push_back(Point(std::cos(0.8 * double(i)), std::sin(0.8 * double(i))));
  for (std::size_t i = 1; i + 1 < input.mesh.points.size(); ++i)
    input.mesh.triangles.push_back({Vertex_index(0), Vertex_index(i), Vertex_index(i + 1)});
  return input;
}

/// Vertices, one edge, and one segment outside of what is no mesh.
inline Input without_triangles() {
  Input input{"bare", {}, {}};
  for (const Point& p : {Point(0, 0), Point(1, 0), Point(2, 1), Point(3, 1)}) input.pslg.add_vertex(p);
  input.pslg.add_segment(Vertex_index(0), Vertex_index(1));
  input.pslg.add_segment(Vertex_index(2), Vertex_index(3));
  input.mesh.points = input.pslg.vertices;
  input.mesh.number_of_input_vertices = 4;
  input.mesh.constrained_edges.push_back({input.pslg.segments[0], Segment_index(0), 7});
  return input;
}

inline std::vector<Input> small_inputs() {
  return {{"empty", {}, {}}, without_triangles(), fan(2), fan(3), fan(7), with_all()};
}

inline bool is_same(const Mesh& a, const Mesh& b) {
  const auto is_same_edge = [](const auto& e, const auto& f) {
    return e.vertices == f.vertices && e.segment == f.segment && e.marker == f.marker &&
           e.outer_vertex == f.outer_vertex;
  };
  return a.number_of_input_vertices == b.number_of_input_vertices && a.points == b.points &&
         a.triangles == b.triangles && a.neighbors == b.neighbors &&
         a.region_of_triangle == b.region_of_triangle && a.segment_of_vertex == b.segment_of_vertex &&
         a.vertex_markers == b.vertex_markers && a.input_index == b.input_index &&
         std::equal(a.constrained_edges.begin(), a.constrained_edges.end(), b.constrained_edges.begin(),
                    b.constrained_edges.end(), is_same_edge);
}

/// A number for each triangle, by its number in the whole mesh.
inline CGAL::IO::Triangle_fields_2 fields_from(std::size_t first, std::size_t n) {
  CGAL::IO::Triangle_fields_2 fields{{"sine & <more>", {}}, {"number", {}}};
  for (std::size_t t = first; t < first + n; ++t) {
    fields[0].values.push_back(std::sin(double(t)));
    fields[1].values.push_back(-double(t));
  }
  return fields;
}
inline CGAL::IO::Triangle_fields_2 fields_of(const Part& part) {
  return fields_from(std::size_t(part.first_triangle[std::size_t(part.rank)]),
                     part.number_of_own_triangles());
}

inline std::string bytes_of_file(const std::filesystem::path& file) {
  std::ostringstream bytes;
  bytes << std::ifstream(file, std::ios::binary).rdbuf();
  return bytes.str();
}
/// What is different in two folders, whose files of the given ending should be the same.
inline std::string difference(const std::filesystem::path& a, const std::filesystem::path& b,
                              const std::string& ending) {
  using std::filesystem::directory_iterator;
  std::string wrong;
  std::size_t n = 0;
  for (const auto& entry : directory_iterator(a)) {
    if (entry.path().extension() != ending) continue;
    ++n;
    if (bytes_of_file(entry.path()) != bytes_of_file(b / entry.path().filename()))
      wrong += entry.path().filename().string() + " is another one; ";
  }
  for (const auto& entry : directory_iterator(b)) n -= entry.path().extension() == ending ? 1 : 0;
  return n == 0 ? wrong : wrong + "there are other files " + ending + "; ";
}

/// Distributes a mesh from the last rank, checks it there, and puts it together again.
/// \returns what is wrong
template <class Exchange>
std::string check_distribution(Exchange& exchange, const Input& input, Part& part, std::size_t batch) {
  const int root = exchange.size() - 1;
  const bool is_root = exchange.rank() == root;
  part = distribute_mesh(exchange, is_root ? input.mesh : Mesh(), is_root ? input.pslg : Pslg(), root, batch);
  std::string wrong = Mesh_defects<Exchange, Point>(exchange, part).find();
  const Triangle_runs runs(std::size_t(part.number_of_triangles()), std::size_t(exchange.size()));
  const auto rank = std::size_t(exchange.rank());
  const std::size_t own = rank < runs.size() ? runs.begin(rank + 1) - runs.begin(rank) : 0;
  if (part.number_of_own_triangles() != own) wrong += "the cut is not that of files; ";
  if (part.number_of_parts() != int(runs.size())) wrong += "the parts are not those of files; ";
  const Mesh mesh = gather_mesh(exchange, part, root);
  if (!is_same(mesh, is_root ? input.mesh : Mesh())) wrong += "the mesh is another one; ";
  return wrong;
}

/// Writes a mesh by all ranks into one folder, and by the last one alone into another.
/// \returns what is different
template <class Exchange>
std::string check_files(Exchange& exchange, const Input& input, const Part& part,
                        const std::filesystem::path& together, const std::filesystem::path& alone) {
  const auto file = [&](const std::filesystem::path& folder, const char* ending) {
    return (folder / (input.name + ending)).string();
  };
  write_pvtu_together(exchange, file(together, ".pvtu"), part, fields_of(part), CGAL::IO::BINARY);
  write_pvtu_together(exchange, file(together, "_text.pvtu"), part, {}, CGAL::IO::ASCII);
  write_msh_together(exchange, file(together, ".msh"), part);
#ifdef CGAL_LINKED_WITH_HDF5
  write_vtkhdf_together(exchange, file(together, ".vtkhdf"), part, fields_of(part));
  write_xdmf_together(exchange, file(together, ".xdmf"), part, fields_of(part));
#endif
  if (exchange.rank() != exchange.size() - 1) return std::string();
  const auto parts = std::size_t(exchange.size());
  const auto fields = fields_from(0, input.mesh.triangles.size());
  CGAL::IO::write_PVTU(file(alone, ".pvtu"), input.mesh, input.pslg, parts, fields);
  CGAL::IO::write_PVTU(file(alone, "_text.pvtu"), input.mesh, input.pslg, parts, {}, CGAL::IO::ASCII);
  CGAL::IO::write_MSH_parts(file(alone, ".msh"), input.mesh, input.pslg, parts);
#ifdef CGAL_LINKED_WITH_HDF5
  CGAL::IO::write_VTKHDF(file(alone, ".vtkhdf"), input.mesh, input.pslg, fields);
  CGAL::IO::write_XDMF(file(alone, ".xdmf"), input.mesh, input.pslg, fields);
#endif
  std::string wrong;
  for (const char* ending : {".pvtu", ".vtu", ".msh", ".vtkhdf", ".h5", ".xdmf"})
    wrong += difference(together, alone, ending);
  return wrong;
}

} // namespace distributed_mesh_checks

#endif // QUADTREE_MESH_2_TEST_DISTRIBUTED_MESH_CHECKS_H
