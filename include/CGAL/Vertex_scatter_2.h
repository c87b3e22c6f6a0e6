// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef CGAL_VERTEX_SCATTER_2_H
#define CGAL_VERTEX_SCATTER_2_H

/// \file
/// Values at vertices of a distributed mesh, sent between their owners and the ranks that use them. A program links
/// MPI.

#include <CGAL/Distributed_mesh_2.h>
#include <CGAL/Quadtree_mesh_2/internal/distributed/Mpi_exchange.h>
#include <CGAL/Quadtree_mesh_2/internal/distributed/Parcel.h>
#include <CGAL/Quadtree_mesh_2/internal/distributed/Part_completer.h>

#include <mpi.h>

#include <cstddef>
#include <stdexcept>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {

/// \ingroup PkgQuadtreeMesh2Distributed
/// Sends values at vertices of a `Distributed_mesh_2` from their owners to all ranks that know the vertices, and back.
///
/// Values are in vectors with a place for each vertex that a rank knows, as `points` has: own ones, then foreign ones.
/// To assemble, each rank adds what its own triangles contribute at any vertex, and `add_backward()` gives the sums to
/// the owners. `forward()` tells them to all.
///
/// All ranks call constructor, functions and destructor, in the same order, and the last before `MPI_Finalize()`. What
/// one of them throws, all throw. A rank sends a message to each rank with which it has vertices in common, and needs
/// memory for what it sends and receives. It cannot be copied.
class Vertex_scatter_2 {
public:
  /// Asks the owners of the foreign vertices. O(log P) for each of them, with P ranks. Keeps nothing of `mesh`.
  template <class Point>
  Vertex_scatter_2(MPI_Comm comm, const Distributed_mesh_2<Point>& mesh)
      : exchange_(comm), number_of_own_(mesh.number_of_own_vertices()),
        number_of_foreign_(mesh.foreign_vertices.size()) {
    auto asked = Quadtree_mesh_2::internal::vertices_by_owner(mesh, mesh.foreign_vertices);
    for (const auto& [rank, vertices] : asked) owners_.push_back({rank, vertices.size()});
    for (const auto& [rank, vertices] : exchange_records(exchange_, std::move(asked))) {
      users_.push_back({rank, {}});
      for (const auto v : vertices) users_.back().vertices.push_back(mesh.index_of_vertex(v));
    }
  }

  /// Gives each foreign vertex the value that its owner has.
  /// \tparam Value trivially copyable, with a default constructor, and not `bool`
  /// \param values with a place for each vertex of this rank
  /// \throws std::invalid_argument if there are more or fewer at any rank
  template <class Value>
  void forward(std::vector<Value>& values) {
    check(values);
    Quadtree_mesh_2::internal::Records_of_parts<Value> outbox;
    for (const User& user : users_)
      for (const std::size_t v : user.vertices) outbox[user.rank].push_back(values[v]);
    std::size_t next = number_of_own_;
    for (const auto& of_owner : exchange_records(exchange_, std::move(outbox)))
      for (const Value& value : of_owner.second) values[next++] = value;
  }

  /// Adds the values at foreign vertices to those of their owners, in the order of ranks. Foreign vertices keep theirs.
  /// \tparam Value the same, with `+=`
  /// \param values with a place for each vertex of this rank
  /// \throws std::invalid_argument if there are more or fewer at any rank
  template <class Value>
  void add_backward(std::vector<Value>& values) {
    check(values);
    Quadtree_mesh_2::internal::Records_of_parts<Value> outbox;
    std::size_t next = number_of_own_;
    for (const Owner& owner : owners_)
      for (std::size_t i = 0; i < owner.number_of_vertices; ++i) outbox[owner.rank].push_back(values[next++]);
    auto user = users_.begin();
    for (const auto& of_user : exchange_records(exchange_, std::move(outbox))) {
      for (std::size_t i = 0; i < of_user.second.size(); ++i) values[user->vertices[i]] += of_user.second[i];
      ++user;
    }
  }

private:
  struct Owner {
    int rank;
    std::size_t number_of_vertices; ///< foreign here, which follow on those of owners before
  };
  struct User {
    int rank;
    std::vector<std::size_t> vertices; ///< own ones that it knows, by their places here
  };

  template <class Value>
  void check(const std::vector<Value>& values) {
    static_assert(std::is_trivially_copyable_v<Value> && std::is_default_constructible_v<Value> &&
                      !std::is_same_v<Value, bool>,
                  "values are sent as the bytes that they are");
    if (exchange_.min(values.size() == number_of_own_ + number_of_foreign_ ? 1 : 0) == 0)
      throw std::invalid_argument("there is not one value for each vertex of a rank");
  }

  Quadtree_mesh_2::internal::Mpi_exchange exchange_;
  std::size_t number_of_own_, number_of_foreign_;
  std::vector<Owner> owners_; // in the order of ranks, as users are
  std::vector<User> users_;
};

} // namespace CGAL

#endif // CGAL_VERTEX_SCATTER_2_H
