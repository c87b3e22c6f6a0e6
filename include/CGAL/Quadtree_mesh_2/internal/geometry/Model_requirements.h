// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// What a user's model of MeshingGeometry_2 has to have, part by part, so that the compiler can name what is missing
// rather than a line of the mesher that misses it.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_GEOMETRY_MODEL_REQUIREMENTS_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_GEOMETRY_MODEL_REQUIREMENTS_H

#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

// The types of the parts; there is none where the model lacks the part.
template <class Model>
using Point_in = typename Model::Point;
template <class Model>
using Some_point = const typename Model::Point&;
template <class Model>
using Coordinate_in = typename Model::Coordinate;
template <class Model>
using Vector_in =
    decltype(double(typename Model::Vector{0.0, 0.0}.x) + double(typename Model::Vector{0.0, 0.0}.y));
template <class Model>
using Coordinates_in = std::enable_if_t<
    std::is_same_v<std::decay_t<decltype(std::declval<Some_point<Model>>().x)>, Coordinate_in<Model>> &&
    std::is_same_v<std::decay_t<decltype(std::declval<Some_point<Model>>().y)>, Coordinate_in<Model>>>;
template <class Model>
using Some_coordinate = const Coordinate_in<Model>&;
template <class Model>
using Order_in =
    decltype(bool(std::declval<Some_coordinate<Model>>() < std::declval<Some_coordinate<Model>>()) &&
             bool(std::declval<Some_coordinate<Model>>() == std::declval<Some_coordinate<Model>>()));
template <class Model>
using Equality_in = decltype(bool(std::declval<Some_point<Model>>() == std::declval<Some_point<Model>>()));
template <class Model>
using Least_length_in = std::integral_constant<bool, (Model::least_length >= 0)>;
template <class Model>
using Orientation_in =
    decltype(int(Model::orientation(std::declval<Some_point<Model>>(), std::declval<Some_point<Model>>(),
                                    std::declval<Some_point<Model>>())));
template <class Model>
using Side_of_circle_in = decltype(int(
    Model::side_of_circle(std::declval<Some_point<Model>>(), std::declval<Some_point<Model>>(),
                          std::declval<Some_point<Model>>(), std::declval<Some_point<Model>>())));
template <class Model>
using Difference_in =
    decltype(double(
                 Model::difference(std::declval<Some_point<Model>>(), std::declval<Some_point<Model>>()).x) +
             double(
                 Model::difference(std::declval<Some_point<Model>>(), std::declval<Some_point<Model>>()).y));
template <class Model>
using Doubled_area_in =
    decltype(double(Model::doubled_area(std::declval<Some_point<Model>>(), std::declval<Some_point<Model>>(),
                                        std::declval<Some_point<Model>>())));
template <class Model>
using Translate_in = decltype(Point_in<Model>(
    Model::translate(std::declval<Some_point<Model>>(), typename Model::Vector{0.0, 0.0})));
template <class Model>
using Nearest_corner_in =
    decltype(Point_in<Model>(Model::nearest_corner(std::declval<Some_point<Model>>(), 1.0)));
template <class Model>
using Spacing_in = decltype(double(Model::spacing(std::declval<Some_coordinate<Model>>())));

/// Whether a model has a part.
template <template <class> class Part, class Model, class = void>
constexpr bool has_part = false;
template <template <class> class Part, class Model>
constexpr bool has_part<Part, Model, std::void_t<Part<Model>>> = true;

/// Whether a model has a map from these points to its own and back.
template <class Model, class Point_2, class = void>
constexpr bool has_map = false;
template <class Model, class Point_2>
constexpr bool
    has_map<Model, Point_2,
            std::void_t<decltype(typename Model::Coordinate_map(std::declval<const std::vector<Point_2>&>())),
                        decltype(Point_in<Model>(std::declval<const typename Model::Coordinate_map&>()
                                                     .to_mesher(std::declval<const Point_2&>()))),
                        decltype(Point_2(std::declval<const typename Model::Coordinate_map&>().from_mesher(
                            std::declval<Some_point<Model>>()))),
                        decltype(double(std::declval<const typename Model::Coordinate_map&>().scale()))>> =
        true;

/// Compiles if the model has all parts but its map.
template <class Model>
struct Model_requirements {
  static_assert(has_part<Point_in, Model>, "MeshingGeometry_2: there is no type `Point`");
  static_assert(has_part<Coordinate_in, Model>, "MeshingGeometry_2: there is no type `Coordinate`");
  static_assert(has_part<Coordinates_in, Model>,
                "MeshingGeometry_2: `Point` has no members `x` and `y` that are a `Coordinate`");
  static_assert(has_part<Order_in, Model>,
                "MeshingGeometry_2: there is no `<` or no `==` for a `Coordinate`");
  static_assert(has_part<Equality_in, Model>, "MeshingGeometry_2: there is no `==` for a `Point`");
  static_assert(
      has_part<Vector_in, Model>,
      "MeshingGeometry_2: there is no type `Vector`, made by `Vector{x, y}` of two doubles, its members");
  static_assert(has_part<Least_length_in, Model>,
                "MeshingGeometry_2: there is no `static constexpr double least_length`, 0 or more");
  static_assert(has_part<Orientation_in, Model>,
                "MeshingGeometry_2: there is no `static int orientation(Point, Point, Point)`");
  static_assert(has_part<Side_of_circle_in, Model>,
                "MeshingGeometry_2: there is no `static int side_of_circle(Point, Point, Point, Point)`");
  static_assert(has_part<Difference_in, Model>,
                "MeshingGeometry_2: there is no `static Vector difference(Point, Point)`");
  static_assert(has_part<Doubled_area_in, Model>,
                "MeshingGeometry_2: there is no `static double doubled_area(Point, Point, Point)`");
  static_assert(has_part<Translate_in, Model>,
                "MeshingGeometry_2: there is no `static Point translate(Point, Vector)`");
  static_assert(has_part<Nearest_corner_in, Model>,
                "MeshingGeometry_2: there is no `static Point nearest_corner(Point, double)`");
  static_assert(has_part<Spacing_in, Model>,
                "MeshingGeometry_2: there is no `static double spacing(Coordinate)`");
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_GEOMETRY_MODEL_REQUIREMENTS_H
