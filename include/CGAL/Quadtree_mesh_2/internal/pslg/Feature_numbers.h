// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// The values of a property of features as numbers: their own, or those of names.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_PSLG_FEATURE_NUMBERS_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_PSLG_FEATURE_NUMBERS_H

#include <CGAL/Quadtree_mesh_2/internal/io/printable.h>

#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// One property. It has numbers in all features, or names in all.
class Feature_numbers {
public:
  /// Any number, or one that a marker can be.
  enum class Kind { ANY, MARKER };

  /// \param property its name; empty: none is wanted
  Feature_numbers(std::string property, Kind kind) : property_(std::move(property)), kind_(kind) {}

  const std::string& property() const { return property_; }
  bool is_wanted() const { return !property_.empty(); }
  /// Whether a feature had a value, or no property is wanted.
  bool is_content() const { return !is_wanted() || has_numbers_ || !names_.empty(); }
  /// Those of the numbers 1, 2, ...; empty if the values are numbers.
  const std::vector<std::string>& names() const { return names_; }

  /// What follows is thrown by this, without the place.
  [[noreturn]] void fail(const std::string& what) const {
    throw std::invalid_argument("the property " + in_quotes(property_) + ' ' + what);
  }

  double of_number(double value) {
    if (!names_.empty()) fail("is a number, and was a name before");
    has_numbers_ = true;
    if (!std::isfinite(value)) fail("is not a finite number");
    constexpr double most = std::numeric_limits<int>::max();
    if (kind_ == Kind::MARKER && !(std::trunc(value) == value && std::abs(value) <= most))
      fail("is no whole number of up to 31 bits, as markers are");
    return value;
  }

  double of_name(const std::string& value) {
    if (has_numbers_) fail("is a name, and was a number before");
    const auto [place, is_new] = numbers_.try_emplace(value, names_.size() + 1);
    if (is_new) names_.push_back(value);
    return static_cast<double>(place->second);
  }

private:
  std::string property_;
  Kind kind_;
  bool has_numbers_ = false;
  std::vector<std::string> names_;
  std::map<std::string, std::size_t> numbers_;
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_PSLG_FEATURE_NUMBERS_H
