// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// Vectors that are looked up by handles of one kind, as `VertexData<T>` of geometry-central is. The handle is a type of
// its own (`Index` with a tag), so a triangle's number cannot be taken for a vertex's, and no lookup needs a cast.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_BASE_INDEXED_VECTOR_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_BASE_INDEXED_VECTOR_H

#include <CGAL/Quadtree_mesh_2/internal/base/Uninitialized_vector.h>

#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// Consecutive handles, for loops: `for (const Vertex_id v : points.ids())`.
template <class Id>
class Id_range {
public:
  class iterator {
  public:
    explicit iterator(Id id) : id_(id) {}
    Id operator*() const { return id_; }
    iterator& operator++() {
      ++id_;
      return *this;
    }
    friend bool operator!=(iterator a, iterator b) { return a.id_ != b.id_; }

  private:
    Id id_;
  };

  Id_range(Id begin, Id end) : begin_(begin), end_(end) {}
  /// Those with the numbers in `[begin, end)`.
  Id_range(std::size_t begin, std::size_t end) : Id_range(static_cast<Id>(begin), static_cast<Id>(end)) {}

  iterator begin() const { return iterator(begin_); }
  iterator end() const { return iterator(end_); }

private:
  Id begin_, end_;
};

/// A `std::vector` whose values have handles instead of positions.
template <class Id, class T, class Allocator = std::allocator<T>>
class Indexed_vector : private std::vector<T, Allocator> {
public:
  using Vector = std::vector<T, Allocator>;
  using typename Vector::const_iterator, typename Vector::iterator, typename Vector::value_type;

  using Vector::Vector;
  Indexed_vector() = default;
  Indexed_vector(Vector values) : Vector(std::move(values)) {}

  T& operator[](Id i) { return Vector::operator[](static_cast<std::size_t>(i)); }
  const T& operator[](Id i) const { return Vector::operator[](static_cast<std::size_t>(i)); }
  /// Whether there is a value with the handle.
  bool has(Id i) const { return static_cast<std::size_t>(i) < size(); }

  /// Appends a value. \returns its handle
  Id add(T value) {
    push_back(std::move(value));
    return last_id();
  }

  /// Appends copies of a value until there is one with the handle, and some more.
  void make_room_for(Id i, const T& value) {
    const std::size_t n = static_cast<std::size_t>(i);
    if (n >= size()) resize(n + n / 2 + 64, value);
  }
  /// Drops the values from a handle on.
  void truncate(Id first_dropped) {
    Vector::erase(begin() + static_cast<std::ptrdiff_t>(static_cast<std::size_t>(first_dropped)), end());
  }

  /// The handle of `back()`.
  Id last_id() const { return static_cast<Id>(size() - 1); }
  /// The handle that the next value gets.
  Id end_id() const { return static_cast<Id>(size()); }
  /// The handles of all values that there are when the loop begins.
  Id_range<Id> ids() const { return {std::size_t(0), size()}; }

  using Vector::assign, Vector::clear, Vector::emplace_back, Vector::pop_back, Vector::push_back,
      Vector::reserve, Vector::resize;
  using Vector::back, Vector::begin, Vector::capacity, Vector::data, Vector::empty, Vector::end,
      Vector::front, Vector::size;

  /// The values in order, for what does not know handles.
  const Vector& values() const { return *this; }
  Vector& values() { return *this; }

  friend bool operator==(const Indexed_vector& a, const Indexed_vector& b) {
    return a.values() == b.values();
  }
};

/// One whose `resize()` does not write.
template <class Id, class T>
using Uninitialized_indexed_vector = Indexed_vector<Id, T, Uninitialized_allocator<T>>;

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_BASE_INDEXED_VECTOR_H
