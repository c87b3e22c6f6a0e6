// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// What a rank holds of a mesh as bytes, and back. Linear time.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_DISTRIBUTED_MESH_ARCHIVE_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_DISTRIBUTED_MESH_ARCHIVE_H

#include <CGAL/Distributed_mesh_2.h>
#include <CGAL/Pslg_2.h>
#include <CGAL/Quadtree_mesh_2/internal/distributed/Parcel.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// The coordinates of a point, which are sent instead of it.
template <class Point>
using Sent_coordinates = std::array<std::decay_t<decltype(std::declval<const Point&>().x())>, 2>;

template <class Point>
Sent_coordinates<Point> coordinates_to_send(const Point& p) {
  static_assert(std::is_arithmetic_v<typename Sent_coordinates<Point>::value_type>,
                "points of distributed meshes have numbers of the machine as coordinates");
  return {p.x(), p.y()};
}

/// Appends values to bytes.
class Archive_writer {
public:
  Archive_writer() = default;
  /// \param size so many bytes will be appended; a hint
  explicit Archive_writer(std::size_t size) { bytes.reserve(size); }

  template <class T>
  void operator()(const T& value) {
    static_assert(std::is_trivially_copyable_v<T>);
    append(&value, sizeof value);
  }
  template <class T>
  void operator()(const std::vector<T>& values) {
    (*this)(static_cast<std::uint64_t>(values.size()));
    append(values.data(), values.size() * sizeof(T));
  }
  void operator()(const std::vector<std::string>& texts) {
    (*this)(static_cast<std::uint64_t>(texts.size()));
    for (const std::string& text : texts) (*this)(std::vector<char>(text.begin(), text.end()));
  }
  template <class Point>
  void points(const std::vector<Point>& points) {
    (*this)(static_cast<std::uint64_t>(points.size()));
    for (const Point& p : points) (*this)(coordinates_to_send(p));
  }

  Bytes bytes;

private:
  void append(const void* begin, std::size_t size) { append_bytes(bytes, begin, size); }
};

/// Takes the values out again.
class Archive_reader {
public:
  explicit Archive_reader(const Bytes& bytes) : bytes_(bytes) {}

  bool is_at_end() const { return next_ == bytes_.size(); }

  template <class T>
  void operator()(T& value) {
    take(&value, sizeof value);
  }
  template <class T>
  void operator()(std::vector<T>& values) {
    values.resize(size());
    take(values.data(), values.size() * sizeof(T));
  }
  void operator()(std::vector<std::string>& texts) {
    texts.resize(size());
    for (std::string& text : texts) {
      std::vector<char> characters;
      (*this)(characters);
      text.assign(characters.begin(), characters.end());
    }
  }
  template <class Point>
  void points(std::vector<Point>& points) {
    const std::size_t n = size();
    points.clear();
    points.reserve(n);
    for (std::size_t i = 0; i < n; ++i) {
      Sent_coordinates<Point> p;
      (*this)(p);
      points.push_back(Point(p[0], p[1]));
    }
  }

private:
  std::size_t size() {
    std::uint64_t n = 0;
    (*this)(n);
    return static_cast<std::size_t>(n);
  }
  void take(void* to, std::size_t size) {
    if (size == 0) return;
    std::memcpy(to, bytes_.data() + next_, size);
    next_ += size;
  }

  const Bytes& bytes_;
  std::size_t next_ = 0;
};

/// All of a mesh, in one order for both directions.
template <class Archive, class Mesh>
void archive_mesh(Archive& archive, Mesh& mesh) {
  archive(mesh.first_vertex), archive(mesh.first_triangle);
  archive(mesh.number_of_constrained_edges), archive(mesh.number_of_outside_segments);
  archive(mesh.number_of_input_vertices);
  archive(mesh.has_regions), archive(mesh.has_vertex_markers), archive(mesh.has_input_index);
  archive(mesh.has_neighbors), archive(mesh.has_segment_of_vertex);
  archive(mesh.rank);
  archive(mesh.foreign_vertices), archive(mesh.ghost_triangles);
  archive.points(mesh.points);
  archive(mesh.vertex_markers), archive(mesh.input_index), archive(mesh.segment_of_vertex);
  archive(mesh.triangles), archive(mesh.region_of_triangle), archive(mesh.neighbors);
  archive(mesh.constrained_edges), archive(mesh.outside_segments);
}

/// The regions and names of a graph.
template <class Point>
void write_legend(Archive_writer& archive, const Pslg_2<Point>& legend) {
  std::vector<Point> places;
  std::vector<std::array<double, 2>> values;
  for (const auto& r : legend.regions) places.push_back(r.point), values.push_back({r.attribute, r.max_area});
  archive.points(places);
  archive(values), archive(legend.region_names), archive(legend.marker_names);
}
template <class Point>
void read_legend(Archive_reader& archive, Pslg_2<Point>& legend) {
  std::vector<Point> places;
  std::vector<std::array<double, 2>> values;
  archive.points(places);
  archive(values), archive(legend.region_names), archive(legend.marker_names);
  legend.regions.clear();
  for (std::size_t i = 0; i < values.size(); ++i)
    legend.regions.push_back({places[i], values[i][0], values[i][1]});
}

/// How many bytes a mesh takes, but for some that do not grow with it.
template <class Point>
std::size_t size_as_bytes(const Distributed_mesh_2<Point>& mesh) {
  const auto size = [](const auto&... lists) { return (... + (lists.size() * sizeof *lists.data())); };
  return size(mesh.first_vertex, mesh.first_triangle, mesh.foreign_vertices, mesh.ghost_triangles) +
         mesh.points.size() * sizeof(Sent_coordinates<Point>) +
         size(mesh.vertex_markers, mesh.input_index, mesh.segment_of_vertex, mesh.triangles,
              mesh.region_of_triangle, mesh.neighbors, mesh.constrained_edges, mesh.outside_segments);
}

template <class Point>
Bytes bytes_of_mesh(const Distributed_mesh_2<Point>& mesh) {
  constexpr std::size_t rest = 4096;
  Archive_writer archive(size_as_bytes(mesh) + rest);
  archive_mesh(archive, mesh);
  write_legend(archive, mesh.legend);
  return std::move(archive.bytes);
}
template <class Point>
Distributed_mesh_2<Point> mesh_of_bytes(const Bytes& bytes) {
  Distributed_mesh_2<Point> mesh;
  Archive_reader archive(bytes);
  archive_mesh(archive, mesh);
  read_legend(archive, mesh.legend);
  return mesh;
}

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_DISTRIBUTED_MESH_ARCHIVE_H
