// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef QUADTREE_MESH_PYTHON_ARRAYS_H
#define QUADTREE_MESH_PYTHON_ARRAYS_H

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

// NumPy arrays from and to vectors. What comes in is copied once, as the meshers want vectors of points. What goes out
// is not copied: arrays show the memory of a C++ object, which lives as long as one of them.

namespace py = pybind11;

namespace quadtree_mesh_python {

using Point = CGAL::Exact_predicates_inexact_constructions_kernel::Point_2;
static_assert(sizeof(Point) == 2 * sizeof(double), "points are pairs of doubles");

/// Row by row; anything else is converted.
template <class T>
using Input_array = py::array_t<T, py::array::c_style | py::array::forcecast>;

/// The number of rows of an array of so many columns; an empty array has none, whatever its shape.
template <class T>
std::size_t rows_of(const Input_array<T>& array, py::ssize_t columns, const char* name) {
  if (array.size() == 0) return 0;
  if (array.ndim() != 2 || array.shape(1) != columns)
    throw std::invalid_argument(std::string(name) + " must be an array with " + std::to_string(columns) +
                                " columns");
  return static_cast<std::size_t>(array.shape(0));
}

inline std::vector<Point> points_from(const Input_array<double>& array, const char* name) {
  const std::size_t n = rows_of(array, 2, name);
  std::vector<Point> points;
  points.reserve(n);
  const double* xy = array.data();
  for (std::size_t i = 0; i < n; ++i) points.emplace_back(xy[2 * i], xy[2 * i + 1]);
  return points;
}

template <class T>
std::vector<T> vector_from(const Input_array<T>& array) {
  return std::vector<T>(array.data(), array.data() + array.size());
}

/// Owns an object for the arrays that show parts of it.
template <class Object>
class Shown_object {
public:
  explicit Shown_object(Object object) : object_(new Object(std::move(object))) {
    owner_ = py::capsule(object_, [](void* p) { delete static_cast<Object*>(p); });
  }
  Object& operator*() const { return *object_; }
  Object* operator->() const { return object_; }

  /// \param first the first number; it may be none of `T` but what has the bits of one
  template <class T, class Element>
  py::array_t<T> show(const Element* first, std::vector<py::ssize_t> shape,
                      std::vector<py::ssize_t> strides) const {
    if (shape[0] == 0) return py::array_t<T>(std::move(shape));
    return py::array_t<T>(std::move(shape), std::move(strides), reinterpret_cast<const T*>(first), owner_);
  }
  /// A row for each element, which consists of so many numbers.
  template <class T, class Element>
  py::array_t<T> show_rows(const std::vector<Element>& elements) const {
    constexpr std::size_t columns = sizeof(Element) / sizeof(T);
    static_assert(columns * sizeof(T) == sizeof(Element), "nothing between the numbers");
    return show<T>(elements.data(), {py::ssize_t(elements.size()), py::ssize_t(columns)},
                   {py::ssize_t(sizeof(Element)), py::ssize_t(sizeof(T))});
  }
  /// A number for each element.
  template <class T, class Element>
  py::array_t<T> show_numbers(const std::vector<Element>& elements) const {
    static_assert(sizeof(T) == sizeof(Element), "each element is one number");
    return show<T>(elements.data(), {py::ssize_t(elements.size())}, {py::ssize_t(sizeof(Element))});
  }

private:
  Object* object_; // the capsule's
  py::capsule owner_;
};

/// An array of a vector's numbers, which it takes over.
template <class T>
py::array_t<T> array_of(std::vector<T> numbers) {
  const Shown_object<std::vector<T>> shown(std::move(numbers));
  return shown.template show_numbers<T>(*shown);
}

/// The same with a row for each element.
template <class T, class Element>
py::array_t<T> array_of_rows(std::vector<Element> rows) {
  const Shown_object<std::vector<Element>> shown(std::move(rows));
  return shown.template show_rows<T>(*shown);
}

} // namespace quadtree_mesh_python

#endif // QUADTREE_MESH_PYTHON_ARRAYS_H
