// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef QUADTREE_MESH_2_EXAMPLES_OPTION_VALUES_H
#define QUADTREE_MESH_2_EXAMPLES_OPTION_VALUES_H

// What may be behind an option: one of a few words, a text, a number. All numbers are parsed as doubles, so that whole
// ones may be written as 1e6, too.

#include "file_formats.h"

#include <boost/program_options.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

namespace command_line_internal {

namespace po = boost::program_options;

/// An option with two numbers behind it.
class Two_numbers : public po::typed_value<std::vector<double>> {
public:
  Two_numbers() : po::typed_value<std::vector<double>>(nullptr) {}
  unsigned min_tokens() const override { return 2; }
  unsigned max_tokens() const override { return 2; }
};

/// Which of a few words is given, with hyphens or, as in Python, with underscores.
inline std::size_t choice(const po::variables_map& given, const std::string& option,
                          const std::vector<std::string>& words) {
  const std::string& word = given[option].as<std::string>();
  std::string with_hyphens = word;
  std::replace(with_hyphens.begin(), with_hyphens.end(), '_', '-');
  for (std::size_t i = 0; i < words.size(); ++i)
    if (words[i] == with_hyphens) return i;
  std::string all;
  for (const std::string& w : words) all += (all.empty() ? "" : ", ") + w;
  throw Usage_error("--" + option + " has to be one of " + all + ", not '" + word + "'");
}

/// The text behind an option that has one; empty if the option is not given.
inline std::string text(const po::variables_map& given, const std::string& option) {
  if (given.count(option) == 0) return std::string();
  const std::string& value = given[option].as<std::string>();
  if (value.empty()) throw Usage_error("--" + option + " has nothing behind it");
  return value;
}

/// A number above zero; 0, which means no bound, if the option is not given.
inline double bound(const po::variables_map& given, const std::string& option) {
  if (given.count(option) == 0) return 0;
  const double value = given[option].as<double>();
  if (!(value > 0) || !std::isfinite(value)) throw Usage_error("--" + option + " has to be a number above 0");
  return value;
}

struct Range {
  int least, most;
};

/// A whole number in a range.
inline int whole_number(const po::variables_map& given, const std::string& option, Range range) {
  const double value = given[option].as<double>();
  if (value >= range.least && value <= range.most && std::trunc(value) == value)
    return static_cast<int>(value);
  throw Usage_error("--" + option + " has to be a whole number from " + std::to_string(range.least) + " to " +
                    std::to_string(range.most));
}

constexpr double most_counted = 0x1p53; // more than any memory holds, and still exact

/// How many there may be; perhaps none.
inline std::size_t number_from_0(const po::variables_map& given, const std::string& option) {
  const double value = given[option].as<double>();
  if (value >= 0 && value <= most_counted && std::trunc(value) == value)
    return static_cast<std::size_t>(value);
  throw Usage_error("--" + option + " has to be a whole number from 0 to 2^53");
}

/// How many there may be, at least one; 0, which means no limit, if the option is not given.
inline std::size_t limit(const po::variables_map& given, const std::string& option) {
  if (given.count(option) == 0) return 0;
  const double value = given[option].as<double>();
  if (value >= 1 && value <= most_counted && std::trunc(value) == value)
    return static_cast<std::size_t>(value);
  throw Usage_error("--" + option + " has to be a whole number from 1 to 2^53");
}

/// A number of bytes, with K, M, G or T behind it for 2^10, 2^20, 2^30 or 2^40; 0, which means no limit, if the option
/// is not given.
inline std::size_t memory_size(const po::variables_map& given, const std::string& option) {
  constexpr double least = 0x1p26; // what a program needs for itself
  const std::string value = text(given, option);
  if (value.empty()) return 0;
  std::size_t end = 0;
  double bytes = 0;
  try {
    bytes = std::stod(value, &end);
  } catch (const std::logic_error&) {
    end = 0; // no number, or none that a double can hold
  }
  std::string unit = value.substr(end);
  if (unit.size() == 2 && (unit[1] == 'B' || unit[1] == 'b')) unit.pop_back();
  const std::string units = "KMGTkmgt";
  const std::size_t place = unit.size() == 1 ? units.find(unit) : std::string::npos;
  if (place != std::string::npos) bytes = std::ldexp(bytes, 10 * (1 + static_cast<int>(place % 4)));
  if (end == 0 || (!unit.empty() && place == std::string::npos) || !(bytes >= least) || !(bytes < 0x1p60))
    throw Usage_error("--" + option +
                      " has to be a number of bytes, from 64M to 2^60, such as 2G, 500M or 1e9");
  return static_cast<std::size_t>(bytes);
}

} // namespace command_line_internal

#endif // QUADTREE_MESH_2_EXAMPLES_OPTION_VALUES_H
