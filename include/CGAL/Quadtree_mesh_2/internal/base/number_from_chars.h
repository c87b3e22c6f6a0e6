// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// Numbers from text, as std::from_chars() has it; of doubles also with standard libraries that read only integers so,
// such as LLVM's before version 20.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_BASE_NUMBER_FROM_CHARS_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_BASE_NUMBER_FROM_CHARS_H

#include <algorithm>
#include <charconv>
#include <clocale>
#include <cmath>
#include <cstdlib>
#include <string>
#include <system_error>
#include <type_traits>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// Reads the nearest double by std::strtod(), whatever the program's locale is. What is no decimal number becomes none:
/// infinities are no numbers here.
inline std::from_chars_result decimal_from_chars(const char* begin, const char* end, double& value) {
  const auto digits_from = [end](const char* p) {
    return std::find_if(p, end, [](char c) { return c < '0' || c > '9'; });
  };
  const char* const first = begin != end && *begin == '-' ? begin + 1 : begin;
  const char* const point = digits_from(first);
  const char* mantissa_end = point != end && *point == '.' ? digits_from(point + 1) : point;
  if (mantissa_end - first <= (mantissa_end == point ? 0 : 1)) return {begin, std::errc::invalid_argument};
  const char* number_end = mantissa_end;
  if (mantissa_end != end && (*mantissa_end == 'e' || *mantissa_end == 'E')) {
    const char* exponent = mantissa_end + 1;
    if (exponent != end && (*exponent == '-' || *exponent == '+')) ++exponent;
    if (digits_from(exponent) != exponent) number_end = digits_from(exponent);
  }

  std::string text(begin, point);
  if (mantissa_end != point)
    text += std::localeconv()->decimal_point + std::string(point + 1, number_end);
  else
    text.append(point, number_end);
  const double nearest = std::strtod(text.c_str(), nullptr);
  const bool is_zero = std::all_of(first, mantissa_end, [](char c) { return c == '0' || c == '.'; });
  if (!std::isfinite(nearest) || (nearest == 0 && !is_zero))
    return {number_end, std::errc::result_out_of_range};
  value = nearest;
  return {number_end, std::errc()};
}

/// As `std::from_chars()`.
template <class Number>
std::from_chars_result number_from_chars(const char* begin, const char* end, Number& value) {
#ifdef __cpp_lib_to_chars
  return std::from_chars(begin, end, value);
#else
  if constexpr (std::is_integral_v<Number>)
    return std::from_chars(begin, end, value);
  else
    return decimal_from_chars(begin, end, value);
#endif
}

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_BASE_NUMBER_FROM_CHARS_H
