// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef QUADTREE_MESH_2_BENCHMARK_MESH_DIGEST_H
#define QUADTREE_MESH_2_BENCHMARK_MESH_DIGEST_H

#include <cstddef>
#include <cstdint>
#include <cstring>

/// By the method of Fowler, Noll and Vo, on words instead of bytes.
class Digest {
public:
  template <class Value>
  void add(const Value& value) {
    static_assert(sizeof(Value) <= sizeof(std::uint64_t));
    std::uint64_t word = 0;
    std::memcpy(&word, &value, sizeof value);
    state_ = (state_ ^ word) * 0x100000001b3u;
    state_ ^= state_ >> 29;
  }
  std::uint64_t value() const { return state_; }

private:
  std::uint64_t state_ = 0xcbf29ce484222325u;
};

/// Of all bits of a mesh with doubles as coordinates.
template <class Mesh>
std::uint64_t mesh_digest(const Mesh& mesh) {
  Digest digest;
  for (const auto& p : mesh.points) {
    digest.add(p.x());
    digest.add(p.y());
  }
  for (const auto& triangle : mesh.triangles)
    for (const auto v : triangle) digest.add(std::size_t(v));
  for (const auto& edge : mesh.constrained_edges) digest.add(std::size_t(edge.segment));
  return digest.value();
}

#endif // QUADTREE_MESH_2_BENCHMARK_MESH_DIGEST_H
